r"""A platform's determinant, margin and lengths of its six legs as programs of the coordinates of its pose."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.margin import balance
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.closed_forms import ClosedForms
from gcrules.poses.compiling.limb_wrenches import BalancedLines
from gcrules.poses.compiling.roads import check_finite, joints_of, roads_of
from gcrules.poses.compiling.roots import cosine_and_sine, inverse, root
from gcrules.poses.compiling.scalars import Graph, Ring
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.tracing import COORDINATES
from gcrules.poses.compiling.turns import TurnedBy, back, by_angles
from gcrules.poses.compiling.vectors import Vector, add, cross, dot, exact, scaled, sub, total, turned

__all__ = ["balanced_leg_lines", "leg_bars", "leg_lengths", "leg_programs", "leg_wrenches", "plain_leg_wrenches"]

Floats = NDArray[np.float64]


def leg_programs(m: SixLegs) -> ClosedForms:
    """Of x, y, z, roll, pitch and yaw: the determinant of the legs' unit forces, moments about the centroid of their
    platform ends in parts of the ends' root-mean-square distance from it, which is the superbracket divided by the
    lengths of the legs and the cube of that distance; the margin; and the lengths. Raises InputError for legs that are
    no lines between finite joints in space.
    """
    check_finite(m.analysis.structure)
    joints, size = joints_of(m.analysis, m.rig), _spread(m)
    graph = Graph(6)

    def determinant(road: int, origin: Vector) -> Program:
        graph = Graph(6)
        value = roads_of(m.analysis)[road][1](joints.places(COORDINATES, graph, origin, None))
        for _, length in leg_bars(m, graph):
            value = value * inverse(length)
        return lower(graph, value * (1 / Fraction(size) ** 3))

    roads = [determinant(k, origin) for k in range(len(roads_of(m.analysis))) for origin in joints.fixed.values()]
    factor = min(roads, key=lambda p: p.operations)
    return ClosedForms(factor, leg_wrenches(m, graph), leg_lengths(m, graph), 6, (False,) * 6)


def leg_lengths(m: SixLegs, graph: Graph, turned_by: TurnedBy = cosine_and_sine) -> Program:
    """The lengths of the legs."""
    return lower(graph, *(length for _, length in leg_bars(m, graph, turned_by)))


def leg_wrenches(m: SixLegs, graph: Graph, turned_by: TurnedBy = cosine_and_sine) -> Program:
    """The entries of the legs' wrenches, row by row: six columns, the least singular value is the margin."""
    units = [scaled(bar, inverse(length)) for bar, length in leg_bars(m, graph, turned_by)]
    return lower(graph, *(c for row in _balanced(m, units) for c in row))


def balanced_leg_lines(m: SixLegs, graph: Graph, turned_by: TurnedBy) -> BalancedLines:
    """The same, in parts of the robot's size as long as the legs are, and the squares of these lengths."""
    forces = [scaled(bar, 1 / Fraction(m.rig.size)) for bar, _ in leg_bars(m, graph, turned_by)]
    rows = lower(graph, *(c for row in _balanced(m, forces) for c in row))
    return BalancedLines(rows, lower(graph, *(dot(f, f) for f in forces)), (1,) * 6)


def _balanced(m: SixLegs, forces: Sequence[Vector]) -> Iterator[tuple[Ring, ...]]:
    """The wrenches of forces along the legs, as the platform sees them, in the balance of margins."""
    arms = _arms(m) / _spread(m)
    columns = [exact(c[:3]) + exact(c[3:]) for c in balance(arms[None], (True,) * 6)[0].T]
    for force, arm in zip(forces, arms, strict=True):
        wrench = (*force, *cross(exact(arm), force))
        yield tuple(total(a * b for a, b in zip(wrench, column, strict=True)) for column in columns)


def plain_leg_wrenches(m: SixLegs, graph: Graph, turned_by: TurnedBy) -> Program:
    """The entries of the same wrenches as they are in the base: of the legs' lengths, about the centroid of their ends
    there.
    """
    joints, x, size = joints_of(m.analysis, m.rig), graph.inputs, _spread(m)
    turn, centre = by_angles(x[3:], turned_by), add((x[0], x[1], x[2]), joints.centre)
    middle = exact(m.rig.base.mean(axis=0))
    rows: list[Ring] = []
    for a, b in m.rig.legs:
        base = joints.fixed[a]
        force = sub(add(turned(turn, joints.arms[b]), centre), base)
        rows += [*force, *cross(scaled(sub(base, middle), 1 / Fraction(size)), force)]
    return lower(graph, *rows)


def _arms(m: SixLegs) -> Floats:
    """From the centroid of the legs' platform ends to each of them, (6, 3)."""
    ends = np.array([[float(c) for c in m.rig.points[b]] for _, b in m.rig.legs])
    return np.asarray(ends - ends.mean(axis=0))


def _spread(m: SixLegs) -> float:
    """The root-mean-square distance of these ends from their centroid."""
    return float(np.sqrt((_arms(m) ** 2).sum(axis=1).mean()))


def leg_bars(m: SixLegs, graph: Graph, turned_by: TurnedBy = cosine_and_sine) -> list[tuple[Vector, Ring]]:
    """The legs as the platform sees them, and their lengths."""
    joints, x = joints_of(m.analysis, m.rig), graph.inputs
    turn, centre = back(by_angles(x[3:], turned_by)), add((x[0], x[1], x[2]), joints.centre)
    along = [sub(joints.arms[b], turned(turn, sub(joints.fixed[a], centre))) for a, b in m.rig.legs]
    return [(bar, root(dot(bar, bar))) for bar in along]
