"""What straightening may hold and do before it gives up."""

from __future__ import annotations

from dataclasses import dataclass

from gcrules.core.budget import checkpoint
from gcrules.errors import LimitReached

__all__ = ["WORK_PER_TERM", "Budget"]

WORK_PER_TERM = 25  # replacements that are made for each term that may be held
_WORK_OF_A_SYZYGY = 5  # what one term of a syzygy takes, in replacements

_RAISE = "raise the limit with --limit (in Python limit=...)"


@dataclass
class Budget:
    """At most `limit` terms at a time and `WORK_PER_TERM * limit` replacements; beyond, LimitReached is raised."""

    limit: int
    work: int = 0

    def held(self, terms: int) -> None:
        if terms > self.limit:
            raise LimitReached(f"straightening holds more than {self.limit:,} terms at a time", hint=_RAISE)

    def replacements(self, number: int) -> None:
        checkpoint()
        self.work += number
        if self.work > WORK_PER_TERM * self.limit:
            raise LimitReached(
                f"straightening takes more than {WORK_PER_TERM * self.limit:,} replacements", hint=_RAISE
            )

    def syzygies(self, terms: int) -> None:
        self.replacements(_WORK_OF_A_SYZYGY * terms)
