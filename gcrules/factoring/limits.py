"""What a search may use: extensors held at a time, expressions tested, seconds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic

from gcrules.errors import LimitReached

__all__ = ["MAX_EXTENSORS", "SECONDS", "Budget"]

MAX_EXTENSORS = 1_000_000
SECONDS = 120.0
PRODUCTS_PER_EXTENSOR = 5_000  # expressions that may be tested for each extensor that may be held


@dataclass
class Budget:
    """What a search may use, and what it used: extensors held at a time, products formed, seconds.

    Raises LimitReached, by `hold` and `multiply`, as soon as one of them is exceeded.
    """

    extensors: int = MAX_EXTENSORS
    seconds: float = SECONDS
    progress: Callable[[str], None] | None = None
    held: int = 0
    products: int = 0
    started: float = field(default_factory=monotonic)

    def renewed(self) -> Budget:
        """The same limits for another search, with what is left of the time."""
        return Budget(self.extensors, self.seconds, self.progress, started=self.started)

    def hold(self, number: int) -> None:
        self.held += number
        if self.held > self.extensors:
            raise LimitReached(
                f"the search would hold {self.held:,} extensors, more than {self.extensors:,}",
                hint="raise the limit with --limit (in Python limit=...); 1,000,000 extensors take up to 1 GB",
            )
        self.clock()

    def multiply(self, number: int) -> None:
        self.products += number
        if self.products > PRODUCTS_PER_EXTENSOR * self.extensors:
            raise LimitReached(
                f"the search would test more than {PRODUCTS_PER_EXTENSOR * self.extensors:,} expressions",
                hint="raise the limit with --limit (in Python limit=...)",
            )
        self.clock()

    def clock(self) -> None:
        """Raises LimitReached when the time is over; tells the progress."""
        seconds = monotonic() - self.started
        if seconds > self.seconds:
            raise LimitReached(
                f"the search takes more than {self.seconds:g} seconds",
                hint="give it more time with --seconds (in Python seconds=...)",
            )
        if self.progress is not None:
            self.progress(f"{self.held:,} extensors, {self.products:,} expressions")
