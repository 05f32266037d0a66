r"""What makes a factor of a robot's condition vanish, as things to be drawn: planes, tetrahedra, common points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Sum, join, meet, points_of
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.conditions.at_infinity import INFINITY
from gcrules.mechanisms.conditions.factor_causes import FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.relations import AXES
from gcrules.poses.limbs.exact_values import Values, lines_at
from gcrules.views.drawing.bsp import XYZ, cross, dot
from gcrules.views.robots.drawn_limb import unit_vector

__all__ = ["DrawnFlat", "common_normal", "entities", "far_directions"]


@dataclass(frozen=True)
class DrawnFlat:
    """A plane or tetrahedron through points, some of which may be directions."""

    kind: str
    points: tuple[str, ...]


_KINDS = {4: "tetrahedron", 3: "plane"}


def entities(a: RobotAnalysis, parts: Sequence[FactorCause]) -> tuple[DrawnFlat, ...]:
    """The planes and tetrahedra of these factors that do not lie at infinity, each once.

    Three planes through one point that have a common line may be written with two of them and a line: then the third
    plane is among them.
    """
    found: dict[tuple[str, frozenset[str]], DrawnFlat] = {}
    for part in parts:
        for names in _apart(tuple(_joined(part.expression)), set(a.structure.ideal)):
            found.setdefault((_KINDS[len(names)], frozenset(names)), DrawnFlat(_KINDS[len(names)], names))
    return tuple(found.values())


def _apart(joined: Sequence[tuple[str, ...]], ideal: set[str]) -> Iterator[tuple[str, ...]]:
    """Those that are to be seen among the finite points: planes of two directions only where they pass through one
    point, since otherwise what matters of them is their line at infinity.
    """
    flat = [set(names) - ideal for names in joined if len(names) == 3 and len(ideal.intersection(names)) == 2]
    together = len(flat) > 1 and all(points == flat[0] for points in flat)
    for names in joined:
        far = len(ideal.intersection(names))
        if far < 2 or (far == 2 and len(names) == 3 and together):
            yield names


def _joined(e: Expr) -> Iterator[tuple[str, ...]]:
    """The points of the joins of three points and brackets of four in an expression."""
    if isinstance(e, Sum):  # what its terms are made of says nothing by itself
        return
    names = tuple(str(c) for c in e.children if isinstance(c, Point))
    if isinstance(e, (Join, Bracket)) and len(names) == len(e.children) and len(names) in _KINDS and e != INFINITY:
        yield names
        return
    if isinstance(e, Meet) and _through_one_point(e):
        planes, (line,) = [c for c in e.children if c.step == 3], [c for c in e.children if c.step == 2]
        (common,) = set(map(str, planes[0].children)) & set(map(str, planes[1].children))
        if all(isinstance(c, Point) for c in line.children):
            yield (*map(str, line.children), common)
    for child in e.children:
        yield from _joined(child)


def _through_one_point(e: Meet) -> bool:
    """Whether it is two planes of points with one of these in common, and a line."""
    planes = [c for c in e.children if c.step == 3]
    if sorted(c.step for c in e.children) != [2, 3, 3] or not all(isinstance(c, Join) for c in planes):
        return False
    names = [{str(p) for p in plane.children if isinstance(p, Point)} for plane in planes]
    return all(len(n) == 3 for n in names) and len(names[0] & names[1]) == 1 and INFINITY not in planes


def far_directions(a: RobotAnalysis, part: FactorCause, values: Values) -> tuple[dict[tuple[str, ...], XYZ], list[XYZ]]:
    """The directions that a factor compares, by name, and the great circle (its normal) that they lie on where it
    vanishes: those of an own bracket of directions, and those of lines that are parallel to one plane.
    """
    points = lines_at(a.robot.family, a.structure, values)
    named: dict[tuple[str, ...], XYZ] = {}
    for e in _compared(a, part.expression):
        p = evaluate(e, points)
        if e.step == 2:  # the direction of a line: where it pierces the plane at infinity
            p = evaluate(meet(e, INFINITY), {**points, **{n: (*v, 0) for n, v in AXES.items()}})
        if any(p[:3]):
            named[_points_in(e)] = unit_vector((float(p[0]), float(p[1]), float(p[2])))
    if len(named) < 3:
        return {}, []
    directions = list(named.values())
    normal = common_normal(directions)
    return named, [normal] if normal else []


def common_normal(vectors: Sequence[XYZ]) -> XYZ | None:
    """The direction perpendicular to all these vectors, two or more, if there is one."""
    normals = [cross(u, v) for i, u in enumerate(vectors) for v in vectors[:i]]
    largest = max(normals, key=lambda n: round(dot(n, n), 9))
    if dot(largest, largest) <= 1e-9:
        return None
    normal = unit_vector(largest)
    return normal if all(abs(dot(normal, unit_vector(v))) < 1e-9 for v in vectors) else None


def _points_in(e: Expr) -> tuple[str, ...]:
    """The name of a point, or those of the points of a join."""
    return (str(e),) if isinstance(e, Point) else tuple(map(str, e.children))


def _compared(a: RobotAnalysis, e: Expr) -> list[Expr]:
    """The directions of a bracket with one finite point, or the lines of a meet with the plane at infinity."""
    names = set(points_of(e))
    if isinstance(e, Bracket):
        far: list[Expr] = [c for c in e.children if isinstance(c, Point) and str(c) in a.structure.ideal]
        return far if len(far) == 3 else []
    if isinstance(e, Meet) and INFINITY in e.children:
        near = names - set(a.structure.ideal) - set(AXES)
        return [join(*map(Point, leg)) for leg in a.structure.legs if near.issuperset(leg)]
    return []
