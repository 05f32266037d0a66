r"""Worked poses that make telling pictures: among small exact poses those in which most is to be seen."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import combinations, islice
from math import log2, sqrt

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Bracket, Meet, Sum
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.example_poses import WorkedPose, regular_poses, singular_poses
from gcrules.conditions.gained_motion import Screw, common_point, factors, free_motions, vanishing
from gcrules.conditions.pose_value import line_points
from gcrules.views.drawing.bsp import XYZ, cross, dot, minus
from gcrules.views.drawing.figures import named_lines, sample_points, shown_entities
from gcrules.views.drawing.solids import center, direction, flat_normal
from gcrules.views.drawing.viewpoint import choose_view

__all__ = ["telling_regular", "telling_singular"]

_FINALISTS = 6


def telling_regular(a: Analysis) -> WorkedPose | None:
    """A pose that is not singular, near the sample shape; None where none is found."""
    found = regular_poses(a.structure, (a.condition.cofactor,), sample_points(a))
    return _best(a, islice(found, 24))


def telling_singular(a: Analysis) -> WorkedPose | None:
    """A singular pose that shows the condition, with one free motion if possible; None where none is found."""
    found = singular_poses(a.structure, (a.condition.cofactor,), sample_points(a))
    return _best(a, found)


def _best(a: Analysis, poses: Iterable[WorkedPose]) -> WorkedPose | None:
    """The pose with the fewest faults; how much hides each other is slow to find, and looked at for finalists only."""
    sample = _in_ball(sample_points(a))
    rated = sorted(((_seen_faults(a, pose, sample), i, pose) for i, pose in enumerate(poses)), key=lambda r: r[:2])
    finalists: list[tuple[float, int, WorkedPose]] = []
    for seen, i, pose in rated:
        if len(finalists) == _FINALISTS and seen > finalists[-1][0]:
            break  # this one and all that follow are worse, whatever their incidences
        finalists.append((round(seen + _incidence_faults(a, pose), 6), i, pose))
        finalists = sorted(finalists, key=lambda r: r[:2])[:_FINALISTS]
    final = [(round(fault + _clutter(a, pose), 6), i, pose) for fault, i, pose in finalists]
    return min(final, key=lambda r: r[:2])[2] if final else None


def _in_ball(points: Mapping[str, XYZ]) -> dict[str, XYZ]:
    """In a unit and from an origin such that all joints just fit into the ball of radius 1."""
    middle = center(list(points.values()))
    radius = max(_length(minus(p, middle)) for p in points.values())
    return {n: _scaled(minus(p, middle), 1 / radius) for n, p in points.items()}


def _cartesian(pose: WorkedPose) -> dict[str, XYZ]:
    return {n: (float(x), float(y), float(z)) for n, (x, y, z, _) in pose.points.items()}


def _seen_faults(a: Analysis, pose: WorkedPose, sample: dict[str, XYZ]) -> float:
    """What speaks against a pose by the places of joints, in units of about one fault that is seen at once."""
    at = _in_ball(_cartesian(pose))
    total = 0.4 * log2(max(pose.height, 5) / 5)
    total += sum(_lack(_length(minus(p, q)), 0.45) for p, q in combinations(at.values(), 2))
    total += 5 * sum(_length(minus(p, sample[n])) for n, p in at.items()) / len(at)
    for e in shown_entities(a.condition):
        corners = [at[n] for n in e.points]
        if e.kind == "plane":
            total += _lack(_length(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))), 0.35)
        if e.kind == "tetrahedron" and (volume := _volume(corners)) > 1e-9:
            total += _lack(volume, 0.12)
    total += sum(6.0 if ends is None else 3 * max(0.0, _from_middle(*ends) - 0.55) for ends in _lines(a, at))
    return round(total, 6)


def _incidence_faults(a: Analysis, pose: WorkedPose) -> float:
    """In a singular pose: one factor vanishes, rather a meet than a bracket, and its common point is in the picture.

    Slow, for it computes exactly.
    """
    at = _in_ball(_cartesian(pose))
    zero = vanishing(a.condition.expression, pose.points)
    if not zero:
        return 0.0
    motions = free_motions(a.structure.legs, pose.points)
    if len(zero) > 1 or len(motions) > 1:
        return 12.0
    if isinstance(zero[0], Bracket):
        corners = [at[str(n)] for n in zero[0].children]
        areas = (_length(cross(minus(q, p), minus(r, p))) for p, q, r in combinations(corners, 3))
        others = [f for f in factors(a.condition.expression) if not isinstance(f, Bracket)]
        return sum(_lack(area, 0.35) for area in areas) + 8.0 * bool(others)
    if not isinstance(zero[0], Meet):
        idle = isinstance(zero[0], Sum) and not all(evaluate(term, pose.points) for term in zero[0].children)
        return 6.0 * idle + _axis_faults(a, motions[0], pose)
    point = common_point(zero[0], pose.points)
    if point is None:
        return 9.0
    if not point[3]:
        return 9.0
    x, y, z = (float(c / point[3]) for c in point[:3])
    given = _cartesian(pose)
    middle = center(list(given.values()))
    radius = max(_length(minus(p, middle)) for p in given.values())
    place = _scaled(minus((x, y, z), middle), 1 / radius)
    total = 3 * max(0.0, _length(place) - 1.1)
    return total + sum(_lack(_length(minus(place, p)), 0.25) for p in at.values())


def _axis_faults(a: Analysis, motion: Screw, pose: WorkedPose) -> float:
    """The axis of the free motion passes near the middle, apart from other lines; the motion is no mere shift."""
    if motion.foot is None:
        return 6.0
    at = _cartesian(pose)
    middle = center(list(at.values()))
    radius = max(_length(minus(p, middle)) for p in at.values())
    foot, axis = ((float(x), float(y), float(z)) for x, y, z in (motion.foot, motion.axis))
    from_middle = _length(cross(minus(foot, middle), axis)) / _length(axis)
    long = max(0.0, abs(float(motion.pitch or 0)) / radius - 0.5)
    total = 3 * max(0.0, from_middle / radius - 0.55) + min(long, 3.0)
    for ends in _lines(a, _in_ball(at)):
        if ends:
            place = _scaled(minus(foot, middle), 1 / radius)
            total += _lack(_between(ends, (place, _plus(place, axis))), 0.5)
    return total


def _lines(a: Analysis, at: Mapping[str, XYZ]) -> list[tuple[XYZ, XYZ] | None]:
    points = {n: (*p, 1.0) for n, p in at.items()}
    return [line_points(evaluate(line, points), (0.0, 0.0, 0.0), 1.0) for _, line in named_lines(a)]


def _clutter(a: Analysis, pose: WorkedPose) -> float:
    at = _in_ball(_cartesian(pose))
    planes = [[at[n] for n in e.points] for e in shown_entities(a.condition) if e.kind == "plane"]
    planes += [
        corners
        for e in shown_entities(a.condition)
        if e.kind == "tetrahedron" and _volume(corners := [at[n] for n in e.points]) <= 1e-9
    ]
    normals = [n for corners in planes if (n := flat_normal(corners))]
    along = [u for ends in _lines(a, at) if ends and (u := direction(*ends))]
    return choose_view(at, a.structure.legs, normals, along)[1]


def _lack(value: float, enough: float) -> float:
    return 3 * max(0.0, 1 - value / enough)


def _volume(corners: list[XYZ]) -> float:
    a, b, c, d = corners
    return abs(dot(minus(b, a), cross(minus(c, a), minus(d, a))))


def _from_middle(a: XYZ, b: XYZ) -> float:
    u = minus(b, a)
    return _length(cross(a, u)) / _length(u)


def _between(a: tuple[XYZ, XYZ], b: tuple[XYZ, XYZ]) -> float:
    """How different two lines are: their distance (for parallel ones that of points) and the sine of their angle."""
    u, v, w = minus(a[1], a[0]), minus(b[1], b[0]), minus(b[0], a[0])
    normal = cross(u, v)
    sine = _length(normal) / (_length(u) * _length(v))
    apart = abs(dot(w, normal)) / _length(normal) if sine > 1e-6 else _length(cross(w, u)) / _length(u)
    return apart + sine


def _plus(a: XYZ, b: XYZ) -> XYZ:
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def _length(v: XYZ) -> float:
    return sqrt(dot(v, v))


def _scaled(v: XYZ, factor: float) -> XYZ:
    return v[0] * factor, v[1] * factor, v[2] * factor
