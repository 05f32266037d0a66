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

import hashlib
import json
from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, InputError, LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.core.seeds import drawn
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.platform_analysis import with_platform
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.compiled import compiled
from gcrules.poses.limbs.map_task import limbs_task
from gcrules.poses.limits import parse_limits
from gcrules.poses.maps.axes import GridAxis, read_axes
from gcrules.poses.maps.cells import CROSSED, FREE, MEANINGS, OUTSIDE, UNDECIDED
from gcrules.poses.maps.grid import grid
from gcrules.poses.maps.joining import joined
from gcrules.poses.maps.marching import marched
from gcrules.poses.maps.report import Curve, SingularMap
from gcrules.poses.maps.slices import factors, middle, slice_polynomial, vanishes
from gcrules.poses.maps.store import Folder, Memory, Store
from gcrules.poses.maps.summary import MapSummary, together
from gcrules.poses.maps.task import KINDS, MEASURES, Chunk, MapTask, width_of
from gcrules.poses.maps.tracing import polished, traced
from gcrules.poses.maps.values import LegsTask
from gcrules.poses.methods import Methods, method
from gcrules.screws.threshold import DEFAULT, Threshold, angle_threshold, margin_of

__all__ = ["Plan", "bytes_of", "done", "planned", "singular_map"]

_BAR = 24
MAX_HELD = 8_000_000
"""Poses whose numbers are kept in memory; more need a folder for the work."""


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
) -> SingularMap:
    """The singular poses over two or three coordinates (a `SingularMap`): arrays, curves or a surface, and what is
    proved free of them.

    `source`, `at` (one pose, for the other coordinates) and `about` are those of `pose`. `over` lists coordinates with
    start:stop:number, as for `gcrules map --over`: ["x -2:2:201", "rz -90:90:181 deg"]; for a robot of joints
    coordinates of its pose or actuators, from home. `limits` is text such as "leg lengths 1..3" or "q1 -30..30 deg";
    `threshold` is an angle. `measure` is "margin", for platforms "value" for the superbracket alone, which is quick, or
    "isotropy" or another one of the `INDICES` of the actuators, which comes on top of the margin. `work` names a folder
    for the chunks of a large map: a run that was interrupted goes on from there, unless `restart` throws them away;
    `.store.close()` removes it. Raises InputError for what makes
    no sense and for degenerate robots, LimitReached for maps that are too large.
    """
    plan = planned(mechanism(source, about=about), over, at, limits, threshold, measure)
    return done(plan, work=work, restart=restart)


@dataclass(frozen=True, eq=False)
class Plan:
    """What is to be computed, of which condition, and the threshold."""

    task: MapTask
    sentence: str
    wording: Mapping[str, str | None]
    limit: Threshold


def planned(found: Mechanism, over: Any, at: Any, limits: str | None, threshold: Any, measure: str) -> Plan:
    """What is to be computed, all faults of the input told."""
    limit = angle_threshold(threshold, "in a map")
    if measure not in MEASURES:
        raise InputError(f"{str(measure)[:40]!r} is no measure", hint=f"measures are {', '.join(MEASURES)}")
    plan = method(_PLANNED, found, "a map")(over, at, limits, limit, measure)
    if why := found.drives.missing(measure):
        there = ", ".join(found.drives.indices)
        raise InputError(f"{why}: there is no {measure.replace('_', ' ')}", hint=f"indices of this robot are {there}")
    return plan


def _of_legs(m: SixLegs, over: Any, at: Any, limits: str | None, limit: Threshold, measure: str) -> Plan:
    axes = read_axes(over, m.unit)
    reached = parse_limits(limits, m.actuators, m.unit) if limits is not None else None
    g = grid(m.rig, axes, at)
    known = m.analysis if m.analysis.platform is not None else with_platform(m.analysis, m.platform)
    condition = compiled(known, about=m.about)
    moved = g.rotation_axis is not None
    everywhere = vanishes(g) if moved else not slice_polynomial(g)
    task = LegsTask(g, condition, measure, reached, None if moved else factors(g), everywhere)
    stated = m.analysis.condition
    return Plan(task, stated.sentence, stated.wording(), limit)


def _of_limbs(m: Limbs, over: Any, at: Any, limits: str | None, limit: Threshold, measure: str) -> Plan:
    """By the exact polynomial where the limbs are six legs."""
    try:
        legs = m.six_legs()
    except InputError:
        stated = m.analysis.statement
        task = limbs_task(m, over, at, limits, measure)
        return Plan(task, stated, {"statement": stated, "statement_source": None}, limit)
    return _of_legs(legs, over, at, limits, limit, measure)


_PLANNED: Methods[Plan] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""


def done(plan: Plan, *, work: str | PathLike[str] | None = None, restart: bool = False) -> SingularMap:
    """What was planned, computed; raises as `singular_map`."""
    task = plan.task
    store: Store = Memory()
    if work is not None:
        store = Folder.open(str(work), task.names, _manifest(task), restart=restart)
    elif task.grid.size > MAX_HELD:
        raise LimitReached(
            f"{task.grid.size:,} poses: more than {MAX_HELD:,} are not kept in memory",
            hint='name a folder for them, work="map.part" (the command does so for -o map.nc), or take a coarser grid',
        )
    summary = _computed(task, store, plan.limit)
    parts = (task, plan.sentence, FrozenMap(plan.wording), plan.limit, store, summary)
    found = SingularMap(*parts, notes=task.grid.notes)
    curves = _curves(found) if len(task.grid.axes) == 2 and not task.everywhere else ()
    return SingularMap(*parts, curves, task.grid.notes)


def bytes_of(task: MapTask) -> int:
    """How many bytes the arrays of a map take on disk."""
    each: int = sum(np.dtype(KINDS[n]).itemsize * width_of(task, n) for n in task.names)
    return each * task.grid.size


def _manifest(task: MapTask) -> dict[str, Any]:
    """Of what the chunks of a task are, with a fingerprint of all of it."""
    digest = hashlib.sha256(json.dumps(task.manifest, sort_keys=True).encode()).hexdigest()
    return {**task.manifest, "fingerprint": digest}


def _computed(task: MapTask, store: Store, limit: Threshold) -> MapSummary:
    assert limit.angle is not None
    sigma = margin_of(limit.angle)
    parts: list[MapSummary] = []
    kept: list[int] = []
    poses = 0
    for n in range(task.number):
        checkpoint()
        chunk = store.get(n)
        if chunk is None:
            chunk = task.compute(n)
            store.put(n, chunk)
        else:
            kept.append(n)
        parts.append(_summed(chunk, task, n, sigma))
        poses += parts[-1].poses
        report(_bar(poses, task.grid.size))
    if kept and isinstance(store, Folder):
        _check_kept(task, store, drawn("map", str(store.path), len(kept)).choice(kept))
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


def _check_kept(task: MapTask, store: Folder, n: int) -> None:
    """Compute a chunk again that was found in a folder. Raises FileError where the folder holds something else."""
    there, here = store.get(n), task.compute(n)
    if there is None or not all(_alike(there[name], here[name]) for name in task.names):
        raise FileError(
            f"chunk {n} is not what is computed now; its files were changed",
            filename=str(store.path),
            hint="begin anew with --restart (in Python restart=True), or take another folder",
        )


def _alike(a: Any, b: Any) -> bool:
    """Whether arrays agree but for rounding, which may decide differently on another machine, though seldom."""
    if a.shape != b.shape or not a.size:  # the last chunk may have poses, and no cells
        return bool(a.shape == b.shape)
    if a.dtype.kind == "f":
        return bool(np.isclose(a, b, rtol=1e-4, atol=1e-6, equal_nan=True).mean() > _MOSTLY)
    return bool((a == b).mean() > _MOSTLY)


_MOSTLY = 0.999


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
