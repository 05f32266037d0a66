"""The answer to which parts of whole ranges of poses are free of singular ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.arguments import FILE, checked, each
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import HoldsArrays
from gcrules.core.shown import Shown
from gcrules.poses.boxes.certificate import box_certificate
from gcrules.poses.boxes.task import MODES, SHARES, BoxTask, decided_part
from gcrules.poses.boxes.trees import Leaves
from gcrules.poses.certificate_files import write_certificate
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.tiles.keeping import Store

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["BoxMap", "BoxSummary"]

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class BoxSummary:
    """Over all tiles: the `shares` of the volume in the order of `SHARES`, which add up to 1; how many `boxes` were
    looked at; of free ones the least margin in a middle with its `place`, in the units of the coordinates, and what
    the margin is at least in all of them, if a margin was asked for. None where no box is free.
    """

    shares: tuple[float, ...]
    boxes: int
    margin: float | None
    place: tuple[float, ...] | None
    bound: float | None

    @property
    def decided(self) -> float:
        """The share of the volume that is proved to be free, or to be outside."""
        return decided_part(self.shares)


@dataclass(frozen=True, eq=False)
class BoxMap(HoldsArrays, Shown):
    """Poses over one to six coordinates, in boxes that are proved free of singular poses, or reached nowhere within
    the limits, or not decided; `summary` adds them up. Their tiles are in the `store`.
    """

    task: BoxTask
    store: Store
    summary: BoxSummary

    @property
    def axes(self) -> tuple[GridAxis, ...]:
        """The coordinates, whose nodes are the borders of tiles."""
        return self.task.question.axes

    @property
    def verdict(self) -> str:
        """free: no pose of the range that is reached within the limits is singular, proved, nor has a margin below the
        one asked for; outside: none is reached; singular: one certainly is; below: one certainly is, or has a margin
        below the one asked for; else undecided.
        """
        free, other, _, crossed, undecided = self.summary.shares
        if free and other and self.task.question.always_reached:  # between both signs lies a singular pose
            return "singular"
        if crossed:
            return "below" if self.task.margin else "singular"
        return "undecided" if undecided else "free" if free or other else "outside"

    def status(self, place: Sequence[float]) -> str:
        """What is proved of a pose, given by its coordinates in the units of the axes: free, crossed, undecided or
        outside. Raises InputError for a place beyond the ranges.
        """
        at = np.array(place, dtype=np.float64)
        if at.shape != (len(self.axes),) or not np.isfinite(at).all():
            raise InputError(f"a place has {len(self.axes)} numbers: {', '.join(a.name for a in self.axes)}")
        for a, c in zip(self.axes, at.tolist(), strict=True):
            if not float(a.start) <= c <= float(a.stop):
                raise InputError(f"{a.name} = {c:g} is beyond the map", hint=f"it goes from {a.start} to {a.stop}")
        index = [
            min(int((c - float(a.start)) / float(a.step)), a.number - 2) for a, c in zip(self.axes, at, strict=True)
        ]
        leaves = self.leaves(int(np.ravel_multi_index(index, self.task.grid)))
        beyond = np.abs(leaves.boxes.middles - at * self.task.units) - leaves.boxes.halves
        return MEANINGS[int(leaves.status[int(np.argmin((beyond / self.task.question.weights).max(axis=1)))])]

    def boxes(self, status: str | None = None) -> Iterator[tuple[Floats, Floats, Floats]]:
        """The boxes of a status, or all, tile by tile: their lower and upper ends (N, axes), in the units of the axes,
        and the status of each (N,) by its number, free 0, crossed 1, undecided 2, outside 3.
        """
        if status is not None and status not in MEANINGS:
            raise InputError(f"{status!r} is not a status", hint=f"there are {', '.join(MEANINGS)}")
        for tile in range(self.task.number):
            leaves = self.leaves(tile)
            some = slice(None) if status is None else leaves.status == MEANINGS.index(status)
            middles, halves = leaves.boxes.middles[some], leaves.boxes.halves[some]
            units = self.task.units
            yield (middles - halves) / units, (middles + halves) / units, leaves.status[some].astype(np.float64)

    @cached_property
    def shares(self) -> Floats:
        """The shares of each tile, (tiles along each coordinate …, statuses), in the order of `SHARES`."""
        found = np.zeros((self.task.number, len(SHARES)))
        for tile in range(self.task.number):
            found[tile] = self.tile(tile)["share"].ravel()
        return found.reshape(*self.task.grid, len(SHARES))

    def leaves(self, tile: int) -> Leaves:
        """The boxes of a tile that are not cut, in radians and the file's unit."""
        return self.task.leaves(self.tile(tile)["tree"], tile)

    def tile(self, tile: int) -> Any:
        """The arrays of a tile."""
        found = self.store.get(tile)
        if found is None:
            raise InputError(f"tile {tile} is no longer there")
        return found

    def to_json(self) -> dict[str, Any]:
        """One JSON object: what was asked, and the summary; not the boxes."""
        q, s = self.task.question, self.summary
        return {
            "schema": 1,
            "title": self.task.mechanism.title,
            "axes": [
                {"name": a.name, "unit": a.unit, "start": float(a.start), "stop": float(a.stop), "tiles": a.number - 1}
                for a in q.axes
            ],
            "rest": q.others,
            "limits": q.limits.to_json() if q.limits else None,
            "margin_asked": self.task.margin,
            "condition": q.sentence,
            "mode": MODES[q.chosen],
            "verdict": self.verdict,
            "shares": dict(zip(SHARES, s.shares, strict=True)),
            "decided": s.decided,
            "boxes": s.boxes,
            "least_margin": s.margin,
            "place": list(s.place) if s.place else None,
            "margin_bound": s.bound,
        }

    def to_xarray(self) -> Dataset:
        """An xarray Dataset of the tiles: shares, margins, with coordinates, units and metadata. Raises InputError
        where xarray is missing.
        """
        data: Dataset = self._show("xarray")
        return data

    def certificate(self) -> dict[str, Any]:
        """The boxes of all tiles with all that another program needs to prove them again, as JSON: see
        `save_certificate`.

        Raises LimitReached for robots of which no checker knows the geometry, and for too many boxes.
        """
        return box_certificate(self)

    @checked("map.save_certificate", path=FILE)
    def save_certificate(self, path: str) -> None:
        """Write the boxes, .json or .json.gz, for the program check_boxes.py, which proves them again.

        Raises as `certificate`, and FileError.
        """
        write_certificate(self, path)

    @checked("map.save", paths=each(FILE))
    def save(self, *paths: str) -> None:
        """Write files; the suffix says of what kind: .zarr, .svg, .pdf, .png, .json."""
        self._show("save", paths=paths)

    def __repr__(self) -> str:
        over = ", ".join(a.name for a in self.axes)
        return f"<BoxMap over {over}: {100 * self.summary.decided:.4g} % decided, {self.verdict}>"
