"""What a search may hold: extensors and terms. Time and memory are those of the budget around it (`core.budget`)."""

from __future__ import annotations

from gcrules.core.budget import MORE_TERMS, Count, checkpoint, report

__all__ = ["MAX_EXTENSORS", "SECONDS", "Effort", "terms_held"]

MAX_EXTENSORS = 4_000_000
SECONDS = 120.0
_EXTENSORS_PER_TERM = 4
_LEAST_TERMS = 200_000


def terms_held(extensors: int) -> int:
    """The terms of an expansion or a normal form that may be held where so many extensors may."""
    return max(extensors // _EXTENSORS_PER_TERM, _LEAST_TERMS)


class Effort:
    """The extensors that a search holds, which are limited, and the products that it formed; the progress is told.

    `hold` and `multiply` raise LimitReached where there are too many, or where the time or the memory is used up.
    """

    def __init__(self, extensors: int = MAX_EXTENSORS) -> None:
        self.extensors = Count(extensors, "the search would hold", "extensors", MORE_TERMS)
        self.products = 0

    def renewed(self) -> Effort:
        """The same limit for another search."""
        return Effort(self.extensors.most)

    def hold(self, number: int) -> None:
        self.extensors.spend(number)
        self._tell()

    def multiply(self, number: int) -> None:
        self.products += number
        checkpoint()
        self._tell()

    def release(self, number: int) -> None:
        self.extensors.done -= number

    def _tell(self) -> None:
        report(f"{self.extensors.done:,} extensors, {self.products:,} expressions")
