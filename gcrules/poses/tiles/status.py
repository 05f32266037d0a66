"""How far the tiles of a map are, from any terminal: what is there, at what rate it came, and the time left."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath
from time import time
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.poses.tiles.store import TileStore

__all__ = ["MapStatus", "map_status", "rate_of", "status_of"]

_RECENT = 1000
"""Tiles from which the rate is taken, the last ones."""


@dataclass(frozen=True)
class MapStatus(Shown):
    """How many `tiles` of a store are `done`; the `rate` at which the last ones came, in tiles a second, and how many
    seconds ago the last one did (None where there are too few).
    """

    path: str
    tiles: int
    done: int
    rate: float | None = None
    last: float | None = None

    @property
    def complete(self) -> bool:
        return self.done == self.tiles

    @property
    def left(self) -> float | None:
        """The seconds that are left at this rate; None where it is not known."""
        return None if not self.rate else (self.tiles - self.done) / self.rate

    def to_json(self) -> dict[str, Any]:
        return {
            "schema": 1,
            "store": self.path,
            "tiles": self.tiles,
            "done": self.done,
            "complete": self.complete,
            "tiles_per_second": self.rate,
            "seconds_left": self.left,
            "seconds_since_last": self.last,
        }

    def __repr__(self) -> str:
        return f"<MapStatus {self.done} of {self.tiles} tiles>"


def map_status(store: str | PathLike[str]) -> MapStatus:
    """How many tiles of a store are done, and the rate (a `MapStatus`), from the names and times of its files: nothing
    is computed or loaded. Raises FileError where there is no such store.
    """
    return status_of(TileStore.existing(store), fspath(store))


def status_of(store: TileStore, path: str = "") -> MapStatus:
    """The same of a store that is open."""
    times = store.times()
    done = sum(n for _, n in times)
    last = max(0.0, time() - times[-1][0]) if times else None
    return MapStatus(path or str(store.path), store.number, done, rate_of(times), last)


def rate_of(times: Sequence[tuple[float, int]]) -> float | None:
    """Tiles a second, of the last ones: those after the first moment, over the time since it.

    >>> rate_of([(0.0, 1), (10.0, 2), (20.0, 3)]), rate_of([(0.0, 64)])
    (0.25, None)
    """
    recent, count = [], 0
    for moment, n in reversed(times):
        recent.append((moment, n))
        count += n
        if count > _RECENT and len(recent) > 1:
            break
    if len(recent) < 2 or recent[0][0] <= recent[-1][0]:
        return None
    return (count - recent[-1][1]) / (recent[0][0] - recent[-1][0])
