"""Theorems with their proofs as scripts of proof assistants."""
