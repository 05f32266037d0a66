r"""A platform's determinant, margin and lengths of its six legs as programs of the coordinates of its pose."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from gcrules.mechanisms.kinematics.margin import balance
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.closed_forms import ClosedForms
from gcrules.poses.compiling.roads import check_finite, joints_of, roads_of
from gcrules.poses.compiling.roots import inverse, root
from gcrules.poses.compiling.scalars import Graph, Ring
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.tracing import COORDINATES
from gcrules.poses.compiling.turns import back, by_angles
from gcrules.poses.compiling.vectors import Vector, add, cross, dot, exact, scaled, sub, total, turned

__all__ = ["leg_programs"]


def leg_programs(m: SixLegs) -> ClosedForms:
    """Of x, y, z, roll, pitch and yaw: the determinant of the legs' unit forces, moments about the centroid of their
    platform ends in parts of the ends' root-mean-square distance from it, which is the superbracket divided by the
    lengths of the legs and the cube of that distance; the margin; and the lengths. Raises InputError for legs that are
    no lines between finite joints in space.
    """
    check_finite(m.analysis.structure)
    joints, legs = joints_of(m.analysis, m.rig), m.rig.legs
    ends = np.array([[float(c) for c in m.rig.points[b]] for _, b in legs])
    arms = ends - ends.mean(axis=0)
    size = float(np.sqrt((arms**2).sum(axis=1).mean()))

    def bars(graph: Graph) -> list[tuple[Vector, Ring]]:
        """The legs as the platform sees them, and their lengths."""
        x = graph.inputs
        turn, centre = back(by_angles(x[3:])), add((x[0], x[1], x[2]), joints.centre)
        along = [sub(joints.arms[b], turned(turn, sub(joints.fixed[a], centre))) for a, b in legs]
        return [(bar, root(dot(bar, bar))) for bar in along]

    graph = Graph(6)
    every = bars(graph)
    lengths = lower(graph, *(length for _, length in every))
    columns = [exact(c[:3]) + exact(c[3:]) for c in balance((arms / size)[None], (True,) * 6)[0].T]
    rows: list[Ring] = []
    for (bar, length), arm in zip(every, arms / size, strict=True):
        force = scaled(bar, inverse(length))
        wrench = (*force, *cross(exact(arm), force))
        rows += [total(a * b for a, b in zip(wrench, column, strict=True)) for column in columns]

    def determinant(road: int, origin: Vector) -> Program:
        graph = Graph(6)
        value = roads_of(m.analysis)[road][1](joints.places(COORDINATES, graph, origin, None))
        for _, length in bars(graph):
            value = value * inverse(length)
        return lower(graph, value * (1 / Fraction(size) ** 3))

    roads = [determinant(k, origin) for k in range(len(roads_of(m.analysis))) for origin in joints.fixed.values()]
    return ClosedForms(min(roads, key=lambda p: p.operations), lower(graph, *rows), lengths, 6, (False,) * 6)
