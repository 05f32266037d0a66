r"""The figures of an analysis: the graph of the legs, and the robot with the condition's entities."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr, meet
from gcrules.analysis import Analysis
from gcrules.condition import Entity
from gcrules.numeric.value import XYZ, line_points
from gcrules.render.drawing import Drawing
from gcrules.render.graph import draw_graph
from gcrules.render.sample import sample_coordinates
from gcrules.render.scene import draw_platform
from gcrules.rules.state import extensor

__all__ = ["graph_figure", "robot_figure"]

Coordinates = Mapping[str, tuple[Fraction, Fraction, Fraction]]


def graph_figure(a: Analysis, *, key: bool = True) -> Drawing:
    """The schematic of the legs with the entities marked; `key` adds a legend."""
    s = a.structure
    return draw_graph(s.oriented, s.base, s.platform, [e for part in _entities(a) for e in part], key=key)


def robot_figure(a: Analysis) -> Drawing:
    """The robot in its pose with the entities of the condition; a sample shape if it came without coordinates.

    The lines p and q of a transversal reading are drawn, and the common point of planes that meet in one.
    """
    s = a.structure
    coordinates = a.platform.points if a.platform else None
    points: Mapping[str, tuple[float, float, float]]
    if coordinates is None:
        points = sample_coordinates(s.oriented, s.base, s.platform)
    else:
        points = {n: (float(x), float(y), float(z)) for n, (x, y, z) in coordinates.items()}
    at = {n: (*points[n], 1.0) for n in s.names}
    lines = [(*ends, name or "line") for name, e in a.condition.lines if (ends := _line(e, at, points))]
    marks = _common_point(a, coordinates) if coordinates is not None else []
    entities, _ = _entities(a)
    return draw_platform(s.oriented, points, s.base, s.platform, entities, lines, marks)


def _entities(a: Analysis) -> tuple[list[Entity], list[Entity]]:
    """The entities without, and those with a name of their own (p, where it is a line of joints); the latter come last
    so that both figures have the same colours.
    """
    named = [tuple(map(str, e.children)) for _, e in a.condition.lines]
    parts: tuple[list[Entity], list[Entity]] = ([], [])
    for e in a.entities:
        parts[e.kind == "line" and e.points in named].append(e)
    return parts


def _line(e: Expr, at: Mapping[str, tuple[float, ...]], points: Mapping[str, XYZ]) -> tuple[XYZ, XYZ] | None:
    n = len(points)
    centre = tuple(sum(c[i] for c in points.values()) / n for i in range(3))
    reach = max(abs(c[i] - centre[i]) for c in points.values() for i in range(3))
    return line_points(evaluate(e, at), (centre[0], centre[1], centre[2]), reach)


def _common_point(a: Analysis, coordinates: Coordinates) -> list[tuple[XYZ, str]]:
    """Where four planes, or two planes and a line, meet in this pose; nothing unless they do, in a finite point."""
    at = {n: (*map(Fraction, c), Fraction(1)) for n, c in coordinates.items()}
    if a.condition.kind not in ("four-planes", "tetrahedron-planes-line"):
        return []
    parts = [extensor(e.points) for e in a.entities if e.kind in ("plane", "line")]
    if evaluate(meet(*parts), at) != 0:
        return []
    x, y, z, w = map(Fraction, evaluate(meet(*(parts[:3] if len(parts) == 4 else parts[1:])), at))
    return [((float(x / w), float(y / w), float(z / w)), "meet")] if w else []
