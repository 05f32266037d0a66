r"""Which parts of whole ranges of poses are free of singular ones, over one to six coordinates: tile by tile.

>>> found = box_map("3-rpr", ["x -0.5:0.5", "yaw -20:80 deg"], tiles=4, boxes=1023)
>>> found.verdict, found.summary.decided > 0.9, found.status([0, 0])
('singular', True, 'free')
"""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint, report
from gcrules.core.errors import LimitReached
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.report import BoxMap, BoxSummary
from gcrules.poses.boxes.task import SHARES, BoxTask, box_task
from gcrules.poses.boxes.ties import LOWER
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.tiles.how import HERE, Running, running
from gcrules.poses.tiles.keeping import Store, computed_part, store_of, tile_of
from gcrules.poses.tiles.status import MapStatus

__all__ = ["box_map", "box_part", "boxes_done"]

_MOST_HELD = 500_000_000
"""Boxes of all tiles for which there is room in memory; more need a store."""


def box_map(
    source: Source,
    over: Sequence[str | GridAxis],
    at: Any = None,
    *,
    about: str | Sequence[Any] = "centroid",
    limits: str | None = None,
    margin: float = 0.0,
    tiles: int | None = None,
    boxes: int | None = None,
    work: str | PathLike[str] | None = None,
    restart: bool = False,
    workers: int = 0,
    part: str | tuple[int, int] | None = None,
    scheduler: str | None = None,
) -> BoxMap | MapStatus:
    """Which poses over one to six coordinates are proved free of singular ones (a `BoxMap`), in boxes that are halved
    until they are decided.

    `source`, `at` (one pose, for the other coordinates) and `about` are those of `pose`. `over` lists coordinates with
    start:stop, ["x -100:100", "roll -20:20 deg"]: x, y, z, roll, pitch, yaw, of a robot of joints from home, in home's
    working mode. Each range is cut into so many `tiles`, each tile into so many `boxes` at most. `limits` is text such
    as "leg lengths 1..3" or "q1 -30..30 deg", by default that of the file ("none" leaves it out): boxes that are
    reached nowhere within them are outside. With a `margin`
    above 0 the margin of all free poses is at least that. `work`, `restart`, `workers`, `part` and `scheduler` are
    those of `singular_map`.

    Raises InputError for what makes no sense, and where the robot's wrenches have no closed form that is known here.
    """
    how = running(workers, part, scheduler)
    task = box_task(mechanism(source, about=about), over, at, limits, margin, tiles, boxes)
    if how.part is not None:
        return box_part(task, how, work=work, restart=restart)
    return boxes_done(task, how, work=work, restart=restart)


def boxes_done(
    task: BoxTask, how: Running = HERE, *, work: str | PathLike[str] | None = None, restart: bool = False
) -> BoxMap:
    """The map of a task; raises as `box_map`."""
    task.check()
    if work is None and task.number * task.boxes > _MOST_HELD:
        raise LimitReached(
            f"{task.number:,} tiles of {task.boxes:,} boxes are not kept in memory",
            hint='name a store for them, work="range.zarr", or -o range.zarr',
        )
    store = store_of(task, how, work, restart=restart)
    return BoxMap(task, store, _summed(task, store))


def box_part(
    task: BoxTask, how: Running, *, work: str | PathLike[str] | None = None, restart: bool = False
) -> MapStatus:
    """A part of the map, computed and kept, and how much of the whole is there; raises as `box_map`."""
    task.check()
    return computed_part(task, how, work, restart=restart)


def _summed(task: BoxTask, store: Store) -> BoxSummary:
    """The summary of all tiles, which are equally large; those are computed that are not there."""
    shares, boxes = np.zeros(len(SHARES)), 0
    margin, bound = np.inf, np.inf
    place: tuple[float, ...] = ()
    for tile in range(task.number):
        checkpoint()
        found = tile_of(task, store, tile)
        shares += found["share"].ravel()
        boxes += int(np.count_nonzero(found["tree"]))
        bound = min(bound, float(found["bound"].item()))
        if (here := float(found["margin"].item())) < margin * LOWER:
            margin, place = here, tuple(map(float, found["place"].ravel()))
        report(f"{tile + 1:,} of {task.number:,} tiles")
    parts = tuple((shares / task.number).tolist())
    if margin == np.inf:
        return BoxSummary(parts, boxes, None, None, None)
    return BoxSummary(parts, boxes, margin, place, bound if 0 < bound < np.inf else None)
