"""What a search may hold: extensors and terms. Time and memory are those of the budget around it (`core.budget`)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached

__all__ = ["MAX_EXTENSORS", "SECONDS", "Budget", "terms_held"]

MAX_EXTENSORS = 4_000_000
SECONDS = 120.0
_EXTENSORS_PER_TERM = 4
_LEAST_TERMS = 200_000


def terms_held(extensors: int) -> int:
    """The terms of an expansion or a normal form that may be held where so many extensors may."""
    return max(extensors // _EXTENSORS_PER_TERM, _LEAST_TERMS)


@dataclass
class Budget:
    """The extensors that a search may hold at a time, those that it holds, and the products that it formed; who is told
    of these.

    `hold` and `multiply` raise LimitReached where there are too many, or where the time or the memory is used up.
    """

    extensors: int = MAX_EXTENSORS
    progress: Callable[[str], None] | None = None
    held: int = 0
    products: int = 0

    def renewed(self) -> Budget:
        """The same limit for another search."""
        return Budget(self.extensors, self.progress)

    def hold(self, number: int) -> None:
        self.held += number
        if self.held > self.extensors:
            raise LimitReached(
                f"the search would hold {self.held:,} extensors, more than {self.extensors:,}",
                hint="raise the limit with --limit (in Python limit=...)",
            )
        self._look()

    def multiply(self, number: int) -> None:
        self.products += number
        self._look()

    def _look(self) -> None:
        checkpoint()
        if self.progress is not None:
            self.progress(f"{self.held:,} extensors, {self.products:,} expressions")
