r"""Maps of singular poses over two or three coordinates: what is to be done, done chunk by chunk, and the answer.

>>> from gcrules.mechanisms.description.platform_file import parse_platform
>>> robot = parse_platform('''
... legs: [ab, af, cb, cd, ed, ef]
... points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}
... ''')
>>> found = singular_map(robot, ["x -2:2:9", "z -6:-2:9"])
>>> found
<SingularMap over x, z, 9 x 9 poses, 1 curves>
>>> found.factors[0].text, found.factors[0].multiplicity, found.summary.cells
('z + 4', 3, (48, 16, 0))
"""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint, report
from gcrules.core.errors import LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.maps.cells import CROSSED, FREE, MEANINGS, OUTSIDE, UNDECIDED
from gcrules.poses.maps.joining import joined
from gcrules.poses.maps.marching import marched
from gcrules.poses.maps.planned import Plan, planned
from gcrules.poses.maps.report import Curve, SingularMap
from gcrules.poses.maps.slices import middle
from gcrules.poses.maps.summary import MapSummary, together
from gcrules.poses.maps.task import Chunk, MapTask
from gcrules.poses.maps.tiled import GridTiles
from gcrules.poses.maps.tracing import polished, traced
from gcrules.poses.tiles.how import HERE, Running, running
from gcrules.poses.tiles.keeping import Store, computed_part, store_of, tile_of
from gcrules.poses.tiles.status import MapStatus
from gcrules.screws.threshold import DEFAULT, Threshold, margin_of

__all__ = ["MAX_HELD", "done", "map_part", "singular_map"]

_BAR = 24
MAX_HELD = 8_000_000
"""Poses whose numbers are kept in memory; more need a store."""


def singular_map(
    source: Source,
    over: Sequence[str | GridAxis],
    at: Any = None,
    *,
    about: str | Sequence[Any] = "centroid",
    limits: str | None = None,
    threshold: str | Threshold = DEFAULT.text,
    measure: str = "margin",
    work: str | PathLike[str] | None = None,
    restart: bool = False,
    workers: int = 0,
    part: str | tuple[int, int] | None = None,
    scheduler: str | None = None,
) -> Any:
    """The singular poses over two or three coordinates (a `SingularMap`): arrays, curves or a surface, and what is
    proved free of them.

    `source`, `at` (one pose, for the other coordinates) and `about` are those of `pose`. `over` lists coordinates with
    start:stop:number, as for `gcrules map --over`: ["x -2:2:201", "rz -90:90:181 deg"]; for a robot of joints
    coordinates of its pose or actuators, from home. `limits` is text such as "leg lengths 1..3" or "q1 -30..30 deg", by
    default that of the file; "none" leaves it out. `threshold` is an angle. `measure` is "margin", for platforms
    "value" for the superbracket alone, which is quick, or "isotropy" or another one of the `INDICES` of the actuators,
    which comes on top of the margin. `work` names a Zarr store for the tiles of a large map: a run that was interrupted
    goes on from there, unless `restart` throws them away; `.store.remove()` removes it. With `work` tiles may be
    computed in so many `workers`, processes of this machine, or on a Dask cluster, `scheduler` being its address or
    "local"; with `part`, as "3/100", only this part of a job array's is computed, and the answer is how many tiles
    there are (a `MapStatus`).

    Raises InputError for what makes no sense and for degenerate robots, LimitReached for maps that are too large.
    """
    how = running(workers, part, scheduler)
    plan = planned(mechanism(source, about=about), over, at, limits, threshold, measure)
    if how.part is not None:
        return map_part(plan, how, work=work, restart=restart)
    return done(plan, how, work=work, restart=restart)


def done(
    plan: Plan, how: Running = HERE, *, work: str | PathLike[str] | None = None, restart: bool = False
) -> SingularMap:
    """What was planned, computed; raises as `singular_map`."""
    task = plan.task
    tiles = GridTiles(task, plan.sentence, plan.recipe)
    if work is None and how == HERE and task.grid.size > MAX_HELD:
        raise LimitReached(
            f"{task.grid.size:,} poses: more than {MAX_HELD:,} are not kept in memory",
            hint='name a store for them, work="map.zarr" (the command does so for -o map.nc), or use a coarser grid',
        )
    store = store_of(tiles, how, work, restart=restart)
    summary = _computed(tiles, store, plan.limit)
    parts = (task, plan.sentence, FrozenMap(plan.wording), plan.limit, store, summary)
    found = SingularMap(*parts, notes=task.grid.notes, recipe=plan.recipe)
    curves = _curves(found) if len(task.grid.axes) == 2 and not task.everywhere else ()
    return SingularMap(*parts, curves, task.grid.notes, plan.recipe)


def map_part(plan: Plan, how: Running, *, work: str | PathLike[str] | None = None, restart: bool = False) -> MapStatus:
    """A part of what was planned, computed and kept, and how much of the whole is there; raises as `singular_map`."""
    return computed_part(GridTiles(plan.task, plan.sentence, plan.recipe), how, work, restart=restart)


def _computed(tiles: GridTiles, store: Store, limit: Threshold) -> MapSummary:
    """The summary of all chunks, which are computed where they are not there."""
    assert limit.angle is not None
    task, sigma = tiles.task, margin_of(limit.angle)
    parts: list[MapSummary] = []
    poses = 0
    for n in range(task.number):
        checkpoint()
        chunk = tile_of(tiles, store, n)
        parts.append(_summed(chunk, task, n, sigma))
        poses += parts[-1].poses
        report(_bar(poses, task.grid.size))
    return together(parts)


def _summed(chunk: Chunk, task: MapTask, number: int, sigma: float) -> MapSummary:
    """The summary of one chunk; poses are close below the margin `sigma`."""
    first, _ = task.span(number)
    counts = np.bincount(chunk["cell_status"].ravel(), minlength=len(MEANINGS))
    level = task.level(chunk)
    poses = level.size
    inside = chunk["allowed"].astype(bool) if "allowed" in chunk else np.ones(level.shape, bool)
    cells, outside = (int(counts[FREE]), int(counts[CROSSED]), int(counts[UNDECIDED])), int(counts[OUTSIDE])
    if "margin" not in chunk or not inside.any():
        return MapSummary(cells, poses, int(inside.sum()), 0, outside=outside)

    def place(k: Any) -> tuple[float, ...]:
        at = np.array([[k[0] + first, *k[1:]]], dtype=np.float64)
        return tuple(map(float, task.grid.coordinates(at)[0]))

    values = np.where(inside, chunk["margin"], np.inf)
    k = np.unravel_index(int(values.argmin()), values.shape)
    close = int((values < sigma).sum())
    ends: tuple[tuple[float, tuple[float, ...]], ...] = ()
    if task.measure in chunk and task.measure in INDICES:
        index = np.where(inside, chunk[task.measure], np.nan).astype(np.float64)
        if not np.isnan(index).all():
            ends = tuple(
                (float(index[at]), place(at))
                for at in (np.unravel_index(int(find(index)), index.shape) for find in (np.nanargmin, np.nanargmax))
            )
    return MapSummary(cells, poses, int(inside.sum()), close, float(values[k]), place(k), outside, ends)


def _bar(done: int, number: int) -> str:
    full = done * _BAR // number
    return f"[{'#' * full}{'.' * (_BAR - full)}] {100 * done // number:3d} % of {number:,} poses"


def _curves(m: SingularMap) -> tuple[Curve, ...]:
    g = m.grid
    found: list[tuple[Any, int | None]] = []
    if m.factors is not None:
        for k, f in enumerate(m.factors):
            start = middle(g.shape)
            found += [(polished(f, line, start), k) for line in joined(traced(f, g.shape, start))]
    else:
        found += [(line, None) for line in joined(marched(m.level, m.task.value, m.task.halvings))]
    curves = []
    for places, factor in found:
        points = g.coordinates(places)
        curves.append(Curve(points, factor, m.allows(points)))
    return tuple(sorted(curves, key=lambda c: (c.factor or 0, -len(c.points))))
