r"""Which parts of whole ranges of poses are free of singular ones, over one to six coordinates: tile by tile.

>>> found = box_map("3-rpr", ["x -0.5:0.5", "yaw -20:80 deg"], tiles=4, boxes=1023)
>>> found.verdict, found.summary.decided > 0.9, found.status([0, 0])
('singular', True, 'free')
"""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint, report
from gcrules.core.errors import InputError
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.report import BoxMap, BoxSummary
from gcrules.poses.boxes.task import BoxTask, box_task
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.maps.store import Memory, Store
from gcrules.poses.tiles.how import HERE, Running, running
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.status import MapStatus, status_of
from gcrules.poses.tiles.store import TileStore

__all__ = ["box_map", "box_part", "boxes_done"]


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
    as "leg lengths 1..3" or "q1 -30..30 deg": boxes that are reached nowhere within them are outside. With a `margin`
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
    store: Store = Memory()
    if work is not None:
        store = TileStore.open(work, task, restart=restart)
        run(task, store, how)
    elif how != HERE:
        raise InputError("workers keep their tiles in a store", hint='name one: work="range.zarr", or -o range.zarr')
    parts = []
    for tile in range(task.number):
        checkpoint()
        found = store.get(tile)
        if found is None:
            found = task.compute(tile)
            store.put(tile, found)
            report(f"{tile + 1:,} of {task.number:,} tiles")
        parts.append(found)
    return BoxMap(task, store, _summed(parts))


def box_part(
    task: BoxTask, how: Running, *, work: str | PathLike[str] | None = None, restart: bool = False
) -> MapStatus:
    """A part of the map, computed and kept, and how much of the whole is there; raises as `box_map`."""
    if work is None:
        raise InputError("a part of a job array keeps its tiles in a store", hint='name one: work="range.zarr"')
    if restart:
        raise InputError("a part does not begin anew", hint="the other parts may be at work; remove the store before")
    task.check()
    store = TileStore.open(work, task)
    run(task, store, how)
    return status_of(store, fspath(work))


def _summed(parts: Sequence[Any]) -> BoxSummary:
    """The summary of all tiles, which are equally large."""
    shares = np.mean([p["share"].ravel() for p in parts], axis=0)
    boxes = sum(int(np.count_nonzero(p["tree"])) for p in parts)
    margins = np.array([float(p["margin"].item()) for p in parts])
    k = int(np.argmin(margins))
    bound = min(float(p["bound"].item()) for p in parts)
    if not np.isfinite(margins[k]):
        return BoxSummary(tuple(shares.tolist()), boxes, None, None, None)
    place = tuple(map(float, parts[k]["place"].ravel()))
    return BoxSummary(tuple(shares.tolist()), boxes, float(margins[k]), place, bound if 0 < bound < np.inf else None)
