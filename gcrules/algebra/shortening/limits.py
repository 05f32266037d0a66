"""What a search for a short form may use, unless said otherwise."""

__all__ = ["MAX_MONOMIALS", "SECONDS"]

MAX_MONOMIALS = 20_000
"""Bracket monomials of the multidegree."""

SECONDS = 60.0
