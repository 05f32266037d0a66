"""What straightening may hold and do before it gives up."""

from __future__ import annotations

from dataclasses import dataclass, field

from gcrules.core.budget import MORE_TERMS, Count
from gcrules.core.errors import LimitReached

__all__ = ["WORK_PER_TERM", "Work"]

WORK_PER_TERM = 25  # replacements that are made for each term that may be held
_WORK_OF_A_SYZYGY = 5  # what one term of a syzygy takes, in replacements


@dataclass
class Work:
    """At most `limit` terms at a time and `WORK_PER_TERM * limit` replacements; beyond, LimitReached is raised.

    It is raised too where a budget around the caller is used up.
    """

    limit: int
    count: Count = field(init=False)

    def __post_init__(self) -> None:
        self.count = Count(WORK_PER_TERM * self.limit, "straightening", "replacements", MORE_TERMS)

    def held(self, terms: int) -> None:
        if terms > self.limit:
            raise LimitReached(f"straightening holds more than {self.limit:,} terms at a time", hint=MORE_TERMS)

    def replacements(self, number: int) -> None:
        self.count.spend(number)

    def syzygies(self, terms: int) -> None:
        self.count.spend(_WORK_OF_A_SYZYGY * terms)
