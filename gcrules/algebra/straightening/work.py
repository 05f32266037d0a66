"""What straightening may hold and do before it gives up."""

from __future__ import annotations

from gcrules.core.budget import MORE_TERMS, Count

__all__ = ["WORK_PER_TERM", "Work"]

WORK_PER_TERM = 25  # replacements that are made for each term that may be held
_WORK_OF_A_SYZYGY = 5  # what one term of a syzygy takes, in replacements


class Work:
    """At most `limit` terms at a time and `WORK_PER_TERM * limit` replacements; beyond, LimitReached is raised."""

    def __init__(self, limit: int) -> None:
        self.terms = Count(limit, "straightening holds", "terms at a time", MORE_TERMS)
        self.replacements = Count(WORK_PER_TERM * limit, "straightening takes", "replacements", MORE_TERMS)

    def syzygies(self, terms: int) -> None:
        self.replacements.spend(_WORK_OF_A_SYZYGY * terms)
