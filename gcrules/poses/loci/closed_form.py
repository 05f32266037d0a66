r"""A robot's condition in closed form, for any numbers: the same graph is run in floats, in surds and in long decimals.

The graph holds the places of all that the factors of the condition name, from coordinates of the pose (half-tangents
for angles) by sums, products, quotients and roots, of which each is one of the robot's working modes: of two places of
a joint, one. The factors are polynomials in these places. That the places are those of the robot is seen by comparing
them, at home's signs of the roots, with configurations that were solved by Newton's method, at poses drawn anew in each
run: a check by sampling; everything else is exact.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import sqrt
from typing import Any

import numpy as np

from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import ONE, Expr, points_of
from gcrules.algebra.language.text import text
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.seeds import drawn
from gcrules.mechanisms.conditions.factor_causes import ASIDE
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.limb_factors import vectors_of
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.limb_programs import solved_near_home
from gcrules.poses.compiling.roots import NoForm, half_tangent
from gcrules.poses.compiling.scalars import Graph, Ring, Scalar
from gcrules.poses.compiling.tape import BINARY
from gcrules.poses.compiling.vectors import Vector
from gcrules.screws.pose_text import SHIFTS

__all__ = ["ClosedFactor", "ClosedForm", "closed_form", "why_none"]

_EQUAL = 1e-9  # of places, in parts of the robot's size

_INSTEAD = "gcrules map, path and pose --nearest close the loops by numbers instead"


@dataclass(frozen=True, eq=False)
class ClosedFactor:
    """A factor of the condition, what divides it, and both as nodes of the graph; where nothing does, `cofactor` is ""
    and `over` 1.
    """

    expression: str
    cofactor: str
    kind: str
    statement: str
    value: Ring
    over: Ring


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """The factors whose zeros are singularities, by the `coordinates` of the pose; `placed` names what each root, the
    node of a square root, places; the pose turns about `centre`, at home. `compared` is the number of configurations
    with which all places were compared.
    """

    graph: Graph
    coordinates: tuple[str, ...]
    factors: tuple[ClosedFactor, ...]
    placed: Mapping[int, str]
    centre: Vector
    compared: int

    def values(
        self, inputs: Sequence[Any], root: Callable[[int, Any], Any], inverse: Callable[[Any], Any], of: Sequence[Ring]
    ) -> list[Any]:
        """What nodes of the graph are for these inputs; `root` is given the node and the radicand."""
        nodes = self.graph.nodes
        needed: set[int] = set()
        stack = [r.node for r in of if isinstance(r, Scalar)]
        while stack:
            n = stack.pop()
            if n not in needed:
                needed.add(n)
                op, a, b = nodes[n]
                stack += [] if op == "input" else [a, int(b)] if op in BINARY else [a]
        found: dict[int, Any] = {}
        for n in sorted(needed):
            checkpoint()
            op, a, b = nodes[n]
            if op == "input":
                found[n] = inputs[a]
            elif op == "sqrt":
                found[n] = root(n, found[a])
            elif op == "inv":
                found[n] = inverse(found[a])
            elif op in BINARY:
                left, right = found[a], found[int(b)]
                found[n] = left * right if op == "mul" else left + right if op == "add" else left - right
            else:
                found[n] = found[a] + b if op == "shift" else found[a] * b
        return [r.sign * found[r.node] if isinstance(r, Scalar) else r for r in of]


def closed_form(m: Limbs, coordinates: tuple[str, ...]) -> ClosedForm:
    """Its closed form. Raises InputError, with what there is instead, where none is found."""
    reason = why_none(m)
    if reason:
        raise InputError(f"{m.robot.id} has no locus as a polynomial: {reason}", hint=_INSTEAD)
    home = Target(coordinates, np.zeros(len(coordinates)))
    found = solved_near_home(m, home, np.random.default_rng(0))
    seed = drawn("locus", m.robot.id, *coordinates).getrandbits(64)
    check = solved_near_home(m, home, np.random.default_rng(seed))
    if found is None or check is None:
        raise InputError(
            f"{m.robot.id} has no locus as a polynomial over {', '.join(coordinates)}: near home its loops are not"
            " closed in general position",
            hint=_INSTEAD,
        )
    try:
        places = LimbPlaces(coordinates, found[1], half_tangent)
        vectors = vectors_of(m, places, _names(m))
        every = _factors(m, places, vectors)
        form = ClosedForm(places.graph, coordinates, every, places.solved_for, places.centre, len(check[0]))
    except NoForm as fault:
        raise InputError(
            f"{m.robot.id} has no locus as a polynomial over {', '.join(coordinates)}: its loops are not eliminated"
            f" ({str(fault) or 'a point derived from others'})",
            hint=f"other coordinates of the pose may do (--over); {_INSTEAD}",
        ) from None
    if not _agrees(m, form, vectors, places.sorts, *check):
        raise InputError(
            f"{m.robot.id} has no locus as a polynomial: no closed form agrees with its joints", hint=_INSTEAD
        )
    return form


def _names(m: Limbs) -> tuple[str, ...]:
    """All names of the factors and of what divides them."""
    parts = m.analysis.parts
    return tuple(dict.fromkeys(n for part in parts for e in (part.expression, part.over) for n in points_of(e)))


def why_none(m: Limbs) -> str:
    """Why it has no locus as a polynomial, whatever the coordinates; "" where it may have one."""
    if m.analysis.lines is None:
        return "the wrenches of its limbs are not lines through its points, so that it has no condition"
    if m.robot.redundant:
        return "with more actuators than freedoms it takes two conditions at once, not one polynomial"
    if all(part.kind in ASIDE for part in m.analysis.parts):
        return "its condition has no factor that may vanish"
    return ""


def _factors(m: Limbs, places: LimbPlaces, vectors: Mapping[str, Vector]) -> tuple[ClosedFactor, ...]:
    analysis, plane = m.analysis, m.robot.family.plane
    assert analysis.lines is not None
    names = analysis.lines.structure.names
    at: dict[str, tuple[Ring, ...]] = {}
    for n, (x, y, z) in vectors.items():
        weight = int(places.sorts.get(n) == "point")
        at[n] = (x, y, weight) if plane else (x, y, z, weight)
    evaluator = Evaluator(at, rank=3 if plane else 4)

    def value(e: Expr) -> Any:
        return 1 if e == ONE else evaluator.value(e)[0]

    def shown(e: Expr) -> str:
        return "" if e == ONE else text(e, names=names)

    return tuple(
        ClosedFactor(
            text(p.expression, names=names), shown(p.over), p.kind, p.statement, value(p.expression), value(p.over)
        )
        for p in analysis.parts
        if p.kind not in ASIDE
    )


def _agrees(
    m: Limbs, form: ClosedForm, vectors: Mapping[str, Vector], sorts: Mapping[str, str], poses: Floats, there: Any
) -> bool:
    """Whether all places are those of configurations; of directions, up to their length."""
    names = [n for n in vectors if n in there.values]
    wanted = [c for n in names for c in vectors[n]]
    for k, pose in enumerate(poses):
        inputs = [x if n in SHIFTS else np.tan(x / 2) for n, x in zip(form.coordinates, pose, strict=True)]
        try:
            found = form.values(inputs, lambda _, x: sqrt(x), lambda x: 1 / x, wanted)
        except (ValueError, ZeroDivisionError):
            return False
        for n, place in zip(names, np.array(found, dtype=float).reshape(-1, 3), strict=True):
            expected = np.broadcast_to(there.values[n], (len(poses), 3))[k]
            if sorts.get(n) == "point":
                off = np.abs(place - expected).max() / m.linkage.size
            else:
                off = np.abs(place / np.linalg.norm(place) - expected / np.linalg.norm(expected)).max()
            if not off <= _EQUAL:
                return False
    return True
