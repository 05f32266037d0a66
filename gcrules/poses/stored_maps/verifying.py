"""Whether the tiles of a store are what they should be: all digests, and some tiles, or all, computed again."""

from __future__ import annotations

from os import PathLike, fspath
from typing import Any

from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.seeds import drawn
from gcrules.core.shown import Shown
from gcrules.poses.stored_maps.kinds import task_of
from gcrules.poses.tiles.comparing import alike
from gcrules.poses.tiles.layout import DIGEST
from gcrules.poses.tiles.store import TileStore

__all__ = ["ALL", "BadTile", "MapVerified", "verify_map"]

ALL = "all"
_TILES = 3


@dataclass(frozen=True)
class BadTile:
    """A tile that is not as it should be, and why."""

    tile: int
    why: str

    def to_json(self) -> dict[str, Any]:
        return {"tile": self.tile, "why": self.why}


@dataclass(frozen=True)
class MapVerified(Shown):
    """What was found in a store of this many `tiles`: how many are `done`, all of whose digests were looked at; the
    numbers of those that were computed `again`, and how many of them agree only `within_rounding`, as between machines;
    the `bad` ones.
    """

    path: str
    tiles: int
    done: int
    again: tuple[int, ...]
    within_rounding: int = 0
    bad: tuple[BadTile, ...] = ()

    @property
    def sound(self) -> bool:
        """Whether no tile is bad."""
        return not self.bad

    @property
    def complete(self) -> bool:
        return self.done == self.tiles

    def to_json(self) -> dict[str, Any]:
        return {
            "schema": 1,
            "store": self.path,
            "tiles": self.tiles,
            "done": self.done,
            "sound": self.sound,
            "complete": self.complete,
            "computed_again": list(self.again),
            "within_rounding": self.within_rounding,
            "bad": [b.to_json() for b in self.bad],
        }

    def __repr__(self) -> str:
        return f"<MapVerified {self.done} of {self.tiles} tiles, {len(self.bad)} bad>"


def verify_map(store: str | PathLike[str], tiles: int | str = _TILES) -> MapVerified:
    """Look at the digests of all tiles that are done, and compute some of them again (a `MapVerified`).

    So many `tiles`, or "all", are computed again by the task that the store describes; nobody can foresee which. The
    digests tell damage, the computation tells forgery too. Raises FileError where there is no such store, or its task
    cannot be made anew: by another version, for example.
    """
    if tiles != ALL and (not isinstance(tiles, int) or isinstance(tiles, bool) or tiles < 0):
        raise InputError(f"{str(tiles)[:40]!r} is not a number of tiles", hint='0 or more, or "all"')
    found = TileStore.existing(store)
    task = task_of(found)
    bad: list[BadTile] = []
    done = [t for t in range(found.number) if found.there(t)]
    sound = []
    for tile in done:
        checkpoint()
        if found.get(tile) is None:
            bad.append(BadTile(tile, "it is damaged: its bytes are not those of its digest"))
        else:
            sound.append(tile)
        report(f"{len(sound) + len(bad):,} of {len(done):,} digests")
    number = len(sound) if tiles == ALL else min(int(tiles), len(sound))
    again = tuple(sorted(drawn("tiles", str(found.path), len(sound)).sample(sound, number)))
    rounded = 0
    for k, tile in enumerate(again):
        checkpoint()
        there, here = found.get(tile), task.compute(tile)
        if there is None or not alike(there, here):
            bad.append(BadTile(tile, "it is not what is computed now"))
        elif found.layout.packed(tile, there)[:DIGEST] != found.layout.packed(tile, here)[:DIGEST]:
            rounded += 1
        report(f"{k + 1:,} of {number:,} tiles computed again")
    path = fspath(store)
    return MapVerified(path, found.number, len(done), again, rounded, tuple(sorted(bad, key=lambda b: b.tile)))
