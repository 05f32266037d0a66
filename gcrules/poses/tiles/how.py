r"""Where the tiles of a map are computed, which of them, and how far they are.

>>> parse_part("3/8"), running(2)
((3, 8), Running(workers=2, part=None, scheduler=None))
>>> parse_part("9/8")
Traceback (most recent call last):
gcrules.core.errors.InputError: 'K/N' is a part and how many there are, K from 1 to N: found '9/8'
"""

from __future__ import annotations

import re
from hashlib import sha256
from time import monotonic

from gcrules.core.budget import report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.poses.tiles.store import TileStore

__all__ = ["HERE", "MAX_WORKERS", "Progress", "Running", "parse_part", "running"]

MAX_WORKERS = 256
_BAR = 24
_SHARDS_EACH = 8  # so many shards for each part are many
_PART = re.compile(r"([1-9]\d{0,8})/([1-9]\d{0,8})", re.ASCII)


@dataclass(frozen=True)
class Running:
    """Where tiles are computed: in so many `workers` (processes of this machine; 0 is here), only the `part` (K, N) of
    them, or by the workers of the Dask `scheduler` at an address, or of a "local" one.

    Raises InputError for what does not go together.
    """

    workers: int = 0
    part: tuple[int, int] | None = None
    scheduler: str | None = None

    def __post_init__(self) -> None:
        if not 0 <= self.workers <= MAX_WORKERS:
            raise InputError(f"{self.workers} workers", hint=f"0 to {MAX_WORKERS}; 0 computes in this process")
        if self.scheduler not in (None, "local") and self.workers:
            raise InputError("the workers of a scheduler are its own", hint="leave workers out")
        if self.scheduler is not None and self.part is not None:
            raise InputError("a part of a job array has no scheduler", hint="leave one of them out")

    def tiles(self, store: TileStore) -> tuple[int, ...]:
        """The tiles of this part, or all. They are dealt as shuffled cards are, the same way in each process: whole
        shards where there are many for each part, so that few parts share one, else single tiles.
        """
        layout = store.layout
        if self.part is None:
            return tuple(range(layout.number))
        k, n = self.part
        if len(store.shards) >= _SHARDS_EACH * n:
            dealt = [t for shard in _shuffled(layout.problem, len(store.shards)) for t in layout.tiles(shard)]
        else:
            dealt = _shuffled(layout.problem, layout.number)
        return tuple(sorted(dealt[(k - 1) * len(dealt) // n : k * len(dealt) // n]))


def _shuffled(problem: str, number: int) -> list[int]:
    """The numbers below `number`, in an order that depends on the problem."""
    return sorted(range(number), key=lambda i: sha256(f"{problem} {i}".encode()).digest())


HERE = Running()


def running(workers: int = 0, part: str | tuple[int, int] | None = None, scheduler: str | None = None) -> Running:
    """Where tiles are computed, as it is given. Raises InputError for what is no part, or does not go together."""
    if part is None:
        return Running(workers, None, scheduler)
    return Running(workers, parse_part(part if isinstance(part, str) else "/".join(map(str, part))), scheduler)


def parse_part(text: str) -> tuple[int, int]:
    """The part that "K/N" names, K from 1 to N. Raises InputError."""
    found = _PART.fullmatch(text.strip())
    if found is None or int(found[1]) > int(found[2]):
        raise InputError(
            f"'K/N' is a part and how many there are, K from 1 to N: found {text[:40]!r}",
            hint="in a job array of 100 jobs the first one is 1/100",
        )
    return int(found[1]), int(found[2])


@dataclass
class Progress:
    """Counts tiles and tells the rate and the time left: `done` of `number`, of which `before` were there before."""

    number: int
    done: int
    began: float = 0.0
    before: int = 0

    def __post_init__(self) -> None:
        self.began, self.before = monotonic(), self.done

    def add(self) -> None:
        self.done += 1
        self.tell()

    def tell(self) -> None:
        full = self.done * _BAR // max(self.number, 1)
        words = f"[{'#' * full}{'.' * (_BAR - full)}] {self.done:,} of {self.number:,} tiles"
        seconds = monotonic() - self.began
        if self.done > self.before and seconds > 0:
            rate = (self.done - self.before) / seconds
            words += f", {rate:.3g} a second, {(self.number - self.done) / rate:,.0f} s left"
        report(words)
