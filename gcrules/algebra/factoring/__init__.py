"""Factorization: is a bracket polynomial one expression of joins and meets? See docs/factor.md."""
