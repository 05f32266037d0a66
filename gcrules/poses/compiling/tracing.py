r"""From a robot to programs: every road to a value is traced, and the one with the fewest operations is taken.

The inputs are the numbers of a pose, or the coordinates of the joints that move; the roads are the Laplace expansion of
the six legs, the shortest bracket form and the conditions without a cofactor, each with every joint of the base as the
origin and, for a platform that moves as a body, with every joint of it as the one from which the others are reached.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType

from gcrules.algebra.claims import digest
from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault
from gcrules.core.seeds import drawn
from gcrules.poses.compiling.scalars import Graph, Ring, Scalar
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.turns import by_angles
from gcrules.poses.compiling.vectors import Places, Turn, Vector, add, sub, turned
from gcrules.screws.rotations import rotation

__all__ = ["COORDINATES", "KINDS", "Joints", "Road", "trace"]

Road = tuple[str, Callable[[Places], Ring]]
"""What a value is computed from, in words, and how."""

KINDS = ("matrices", "quaternions", "joints")
"""What a pose may be given by: translation and matrix, translation and quaternion, or the joints that move."""

COORDINATES = "coordinates"
"""What it may be given by too: translation, and roll, pitch and yaw, whose cosines and sines are rounded."""

ZERO: Vector = (0, 0, 0)


@dataclass(frozen=True)
class Joints:
    """Joints that are `fixed` (exact coordinates) and joints that are `moving`.

    `arms` are the coordinates of those that move about the `centre` of their body, which poses send to R·arm + centre
    + t; without them each joint moves by itself.
    """

    fixed: Mapping[str, Vector]
    moving: tuple[str, ...]
    arms: Mapping[str, Vector]
    centre: Vector = ZERO

    @property
    def kinds(self) -> tuple[str, ...]:
        return KINDS if self.arms else ("joints",)

    def places(self, kind: str, graph: Graph, origin: Vector, anchor: str | None) -> Places:
        """The joints from `origin`, by the inputs of the graph."""
        at = {n: sub(p, origin) for n, p in self.fixed.items()}
        x = graph.inputs
        if kind == "joints":
            for k, n in enumerate(self.moving):
                at[n] = sub((x[3 * k], x[3 * k + 1], x[3 * k + 2]), origin)
            return Places(at, {})
        turn = _TURNS[kind](x[3:])
        shift = add((x[0], x[1], x[2]), sub(self.centre, origin))
        start = ZERO if anchor is None else self.arms[anchor]
        arms = {n: turned(turn, sub(self.arms[n], start)) for n in self.moving}
        first = add(turned(turn, start), shift)
        return Places(at | {n: add(first, arm) for n, arm in arms.items()}, {} if anchor is None else arms)

    def inputs(self, kind: str) -> int:
        """How many numbers a pose has: translation and matrix (rows), or quaternion (w, x, y, z), or all joints."""
        return {"matrices": 12, "quaternions": 7, "joints": 3 * len(self.moving), COORDINATES: 6}[kind]


def _matrix(x: Sequence[Scalar]) -> Turn:
    return (x[0], x[1], x[2]), (x[3], x[4], x[5]), (x[6], x[7], x[8])


def _quaternion(q: Sequence[Scalar]) -> Turn:
    """The matrix of a quaternion of any length but 0; no square root is needed."""
    w, x, y, z = q
    square = w * w + x * x + y * y + z * z
    assert isinstance(square, Scalar)
    half = square.inverse() * 2
    a, b, c = (half * i for i in (x, y, z))
    xx, yy, zz, xy, xz, yz, wx, wy, wz = x * a, y * b, z * c, x * b, x * c, y * c, w * a, w * b, w * c
    return (1 - (yy + zz), xy - wz, xz + wy), (xy + wz, 1 - (xx + zz), yz - wx), (xz - wy, yz + wx, 1 - (xx + yy))


_TURNS = MappingProxyType({"matrices": _matrix, "quaternions": _quaternion, COORDINATES: by_angles})

_LARGE = 1 << 30  # numbers of the exact check are smaller


def trace(joints: Joints, kind: str, roads: Sequence[Road], expression: Expr) -> tuple[str, Program]:
    """The shortest program for `expression` that any of the roads leads to, and the name of that road.

    Raises EngineFault if its exact value at a random pose is not that of the expression, computed apart from it.
    """

    def traced(road: Road, origin: Vector, anchor: str | None) -> Program:
        graph = Graph(joints.inputs(kind))
        return lower(graph, road[1](joints.places(kind, graph, origin, anchor)))

    def operations(found: tuple[Program, str, Vector]) -> int:
        return found[0].operations

    origins = [*joints.fixed.values(), *([ZERO] if kind == "joints" else [])]
    best = [min(((traced(road, o, None), road[0], o) for o in origins), key=operations) for road in roads]
    if kind != "joints":
        for road, (_, name, origin) in zip(roads, tuple(best), strict=True):
            best += [(traced(road, origin, anchor), name, origin) for anchor in joints.moving]
    program, name, _ = min(best, key=operations)
    _check(joints, kind, program, expression)
    return name, program


def _check(joints: Joints, kind: str, program: Program, expression: Expr) -> None:
    """Two roads: the program in exact arithmetic, and the expression at the points of the pose."""
    at: dict[str, Vector]
    rng = drawn("compiled", kind, digest(expression))
    inputs = [Fraction(rng.randrange(-_LARGE, _LARGE)) for _ in range(joints.inputs(kind))]
    if kind == "joints":
        at = {n: (inputs[3 * k], inputs[3 * k + 1], inputs[3 * k + 2]) for k, n in enumerate(joints.moving)}
    else:
        w, x, y, z = (Fraction(rng.randrange(1, _LARGE)) for _ in range(4))
        turn = rotation((w, x, y, z))
        inputs[3:] = (w, x, y, z) if kind == "quaternions" else (c for row in turn for c in row)
        shift = add(joints.centre, (inputs[0], inputs[1], inputs[2]))
        at = {n: add(turned(turn, joints.arms[n]), shift) for n in joints.moving}
    points = {n: (*p, 1) for n, p in {**joints.fixed, **at}.items()}
    if program.exact(inputs) != (evaluate(expression, points),):
        raise EngineFault(f"the compiled {kind} and {str(expression)[:80]} disagree at a pose")
