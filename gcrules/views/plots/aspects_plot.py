r"""The picture of aspects: all poses that were looked at, over two of their coordinates, with the proved ways.

The two coordinates are those that tell the sets apart best. What crosses in the picture need not meet: the other
coordinates are not seen.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gcrules.core.english import counted, listed
from gcrules.core.errors import InputError
from gcrules.poses.aspects.report import Aspects, AspectSet
from gcrules.poses.modes.report import AssemblyMode
from gcrules.poses.plans.report import Waypoint
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import ANGLES, SHIFTS, VECTOR
from gcrules.views.drawing.axis import Axis
from gcrules.views.drawing.drawing import XY, Circle, Drawing, Run, Shape, Stroke, Text
from gcrules.views.drawing.palette import entity_role
from gcrules.views.plots.plot_parts import keyed, plane
from gcrules.views.results.aspects import account
from gcrules.views.text_tables import wrapped

__all__ = ["picture", "svg"]

Floats = NDArray[np.float64]

_WIDTH, _LEFT, _RIGHT, _TALL, _BELOW = 560.0, 64.0, 22.0, 340.0, 52.0
_ROOM = 0.06  # of a range, beside the poses


def picture(r: Aspects) -> Drawing:
    """Raises InputError where the poses differ in no coordinate."""
    names = list(_coordinates(r.poses[0]))
    places = np.array([[_coordinates(p)[n] for n in names] for p in r.poses])
    first, second = _telling(r, places)
    shapes: list[Shape] = [Text((_LEFT, 20), (Run(r.title),), 14.0)]
    head = wrapped(account(r).verdict)
    shapes += [Text((_LEFT, 37 + 14 * k), (Run(line),), 11.0, "start", "muted") for k, line in enumerate(head)]
    top = 56.0 + 14 * len(head)
    x = _axis(places[:, first], _LEFT, _WIDTH - _RIGHT)
    y = _axis(places[:, second], top + _TALL, top)
    shapes += plane(x, y, _label(r, names[first]), _label(r, names[second]))
    shapes += _ways(r, names, (first, second), x, y)
    for n, one in enumerate(r.sets):
        shapes += [_dot((x(places[k, first]), y(places[k, second])), entity_role(n)) for k in one.poses]
    for n, one in enumerate(r.sets):
        for number, k in _modes(r, one, names, places):
            shapes += _mode((x(places[k, first]), y(places[k, second])), number, entity_role(n))
    shapes, bottom = keyed(shapes, list(_key(r)), _LEFT, top + _TALL + _BELOW)
    return Drawing(_WIDTH, bottom, tuple(shapes), f"{r.title}: {account(r).verdict}")


def svg(r: Aspects) -> str | None:
    """The picture as SVG; nothing where there is none."""
    try:
        return picture(r).svg()
    except InputError:
        return None


def _coordinates(pose: Waypoint) -> Mapping[str, float]:
    """Translation and rotation vector of a pose, or the coordinates that name it; angles in deg."""
    if isinstance(pose, Pose):
        shift = dict(zip(SHIFTS, map(float, pose.translation), strict=True))
        return shift | {n: math.degrees(v) for n, v in zip(VECTOR, pose.rotation_vector, strict=True)}
    return {n: math.degrees(v) if n in ANGLES else float(v) for n, v in pose.items()}


def _telling(r: Aspects, places: Floats) -> tuple[int, int]:
    """The two coordinates in which the sets lie farthest apart for their width; of one set those that differ."""
    total = places.var(axis=0)
    if (total > 0).sum() < 2:
        raise InputError("these poses differ in fewer than two coordinates, so there is no map of them")
    middles = np.array([places[list(one.poses)].mean(axis=0) for one in r.sets])
    weights = np.array([len(one.poses) for one in r.sets], dtype=float)[:, None]
    mean = (middles * weights).sum(axis=0) / weights.sum()
    between = (weights * (middles - mean) ** 2).sum(axis=0) / weights.sum()
    score = np.where(total > 0, between / np.where(total > 0, total, 1.0), -1.0)
    one, other = np.argsort(-score, kind="stable")[:2]
    return int(min(one, other)), int(max(one, other))


def _axis(values: Floats, start: float, end: float) -> Axis:
    low, high = float(values.min()), float(values.max())
    room = _ROOM * (high - low)
    return Axis(low - room, high + room, start, end)


def _label(r: Aspects, name: str) -> str:
    unit = "deg" if name in ANGLES else r.unit
    return f"{name} ({unit})" if unit else name


def _ways(r: Aspects, names: list[str], shown: tuple[int, int], x: Axis, y: Axis) -> Iterator[Shape]:
    """Each proved way through its poses, in the colour of its set."""
    colours = {k: entity_role(n) for n, one in enumerate(r.sets) for k in one.poses}
    first, second = (names[k] for k in shown)
    for join in r.joins:
        line = [(_coordinates(p)[first], _coordinates(p)[second]) for p in join.poses]
        for a, b in pairwise(line):
            if not any(n in ANGLES and abs(p - q) > 180 for n, p, q in zip((first, second), a, b, strict=True)):
                ends = [(_kept(x, u), _kept(y, v)) for u, v in (a, b)]
                yield Stroke(ends[0], ends[1], colours[join.one], 1.0, 0.45)


def _kept(axis: Axis, value: float) -> float:
    """A place on the axis, at its end where the value is beyond."""
    return axis(min(max(value, axis.low), axis.high))


def _modes(r: Aspects, one: AspectSet, names: list[str], places: Floats) -> Iterator[tuple[int, int]]:
    """The assembly modes of a set, each with the number of its pose: the one that is nearest to it."""
    by_number = {m.number: m for m in r.modes.modes} if r.modes else {}
    own = list(one.poses)
    for number in one.modes:
        there = _of_mode(by_number[number], names)
        apart = np.abs(places[own] - there)
        angular = np.array([n in ANGLES for n in names])
        apart = np.where(angular, np.minimum(apart % 360, -apart % 360), apart)
        yield number, own[int(np.argmin((apart**2).sum(axis=1)))]


def _of_mode(m: AssemblyMode, names: list[str]) -> Floats:
    if set(names) <= {*SHIFTS, *VECTOR}:
        return np.array([_coordinates(m.pose)[n] for n in names])
    return np.array([math.degrees(m.coordinates[n]) if n in ANGLES else m.coordinates[n] for n in names])


def _dot(at: XY, colour: str) -> Shape:
    return Circle(at, 3.0, fill=colour, stroke="paper", width=0.8)


def _mode(at: XY, number: int, colour: str) -> Iterator[Shape]:
    yield Circle(at, 8.5, fill="paper", stroke=colour, width=2.0)
    yield Text((at[0], at[1] + 4), (Run(str(number)),), 11.0, "middle", colour)


def _key(r: Aspects) -> Iterator[tuple[Shape, str]]:
    """The sets with their signs and modes, and what else is drawn."""
    for n, one in enumerate(r.sets):
        signs = f", signs {one.pattern}" if one.pattern else ""
        noun = "modes" if len(one.modes) > 1 else "mode"
        modes = f", assembly {noun} {listed(list(map(str, one.modes)))}" if one.modes else ""
        words = f"set {one.name}{signs}: {counted(len(one.poses), 'pose')}{modes}"
        yield _dot((8.0, -4.0), entity_role(n)), words
    words = "ways without a singularity, proved; what crosses here may differ in other coordinates"
    yield Stroke((0.0, -4.0), (16.0, -4.0), "muted", 1.0, 0.8), words
