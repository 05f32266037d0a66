r"""The factors of a robot's condition as programs, where all that they name has a closed form.

Each program is compared with `factor_values` at configurations that were solved by Newton's method and proved to lie
on home's branch: at poses drawn anew in each process, which had no part in finding it. Both are analytic functions of
the pose where the robot is not singular, so that programs which differ anywhere would differ at almost all of these.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import ONE, Expr, points_of
from gcrules.core.budget import checkpoint
from gcrules.core.seeds import drawn
from gcrules.mechanisms.conditions.factor_causes import ASIDE
from gcrules.mechanisms.description.relations import Term
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.engines import STEP, runner
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.roots import NoForm, inverse, root
from gcrules.poses.compiling.scalars import Ring
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.vectors import Vector, add, cross, dot, sub
from gcrules.poses.limbs.many import Solved, proved_at
from gcrules.screws.pose_text import SHIFTS

__all__ = ["limb_programs", "run"]

_POSES = 24  # from which closed forms are found, and as many with which they are compared
_REACHES = (0.1, 0.02, 0.005)  # in parts of the robot's size, and rad
_EQUAL = 1e-9  # of values from −1 to 1


def limb_programs(m: Limbs, target: Target) -> tuple[Program, ...]:
    """A program for each factor whose zeros are singularities, of the target's coordinates, angles from −π to π; none
    where a factor has no closed form that is found here, and agrees with the joints elsewhere.
    """
    if m.analysis.lines is None or target.driven or any(part.over != ONE for part in m.analysis.parts):
        return ()
    rng = np.random.default_rng(0)
    found = _solved(m, target, rng)
    if found is None:
        return ()
    try:
        programs = _traced(m, LimbPlaces(target.names, found[1]))
    except NoForm:
        return ()
    seed = drawn("closed form", m.robot.id, *target.names).getrandbits(64)
    check = _solved(m, target, np.random.default_rng(seed))
    if check is None:
        return ()
    poses, there = check
    values = np.stack([run(p, "numpy", poses) for p in programs], axis=1)
    return programs if np.abs(values - there.factors).max(initial=0.0) <= _EQUAL else ()


def run(program: Program, engine: str, inputs: Floats, out: Floats | None = None) -> Floats:
    """The values for inputs (N, k), written to `out` if it is given."""
    values = np.empty(len(inputs)) if out is None else out
    if not program.lines:
        values[:] = float(program.constant)
        return values
    call = runner(program, engine)
    for start in range(0, len(inputs), STEP):
        checkpoint()
        part = inputs[start : start + STEP]
        call(part, np.empty((len(part), 0)), values[start : start + STEP])
    return values


def _solved(m: Limbs, target: Target, rng: np.random.Generator) -> tuple[Floats, Solved] | None:
    """Poses that are proved to be reached, and the configurations there."""
    units = np.array([m.linkage.size if n in SHIFTS else 1.0 for n in target.names])
    for reach in _REACHES:
        poses = rng.uniform(-reach, reach, (_POSES, len(units))) * units
        places, there = proved_at(m, target, poses)
        if len(places) > _POSES // 2:
            return poses[places], there
    return None


def _traced(m: Limbs, places: LimbPlaces) -> tuple[Program, ...]:
    analysis = m.analysis
    used = dict.fromkeys(n for part in analysis.parts for n in points_of(part.expression))
    derived: dict[str, Vector] = {}

    def of(term: Term) -> Vector:
        vector: Vector = (0, 0, 0)
        for c, n in term:
            vector = add(vector, _scaled(derived[n] if n in derived else places.at(n), Fraction(c)))
        return vector

    for d in analysis.structure.derived:
        if d.is_point:
            raise NoForm
        u, v = d.args
        derived[d.name] = cross(of(u), of(v))
    vectors = {n: derived[n] if n in derived else places.at(n) for n in used}
    points = [n for n in used if n not in derived and places.sorts[n] == "point"]
    if len(points) > 1:
        centre: Vector = (0, 0, 0)
        for n in points:
            centre = add(centre, _scaled(vectors[n], Fraction(1, len(points))))
        vectors |= {n: sub(vectors[n], centre) for n in points}
        square: Ring = 0
        for n in points:
            square = square + dot(vectors[n], vectors[n]) * Fraction(1, len(points))
        scale = inverse(root(square))
        vectors |= {n: _scaled(vectors[n], scale) for n in points}
    live = [part.expression for part in analysis.parts if part.kind not in ASIDE]
    return tuple(lower(places.graph, _value(e, vectors, points, analysis.robot.family.plane)) for e in live)


def _value(e: Expr, vectors: Mapping[str, Vector], points: Sequence[str], plane: bool) -> Ring:
    """As `factors` has it: divided by the lengths of the coordinates of what it joins or meets. These have the lengths
    of its directions as factors, which therefore need not be 1 there.
    """
    extensors = bool(e.children) and e.children[0].step > 0
    at: dict[str, tuple[Ring, ...]] = {}
    for n, v in vectors.items():
        x, y, z = v if extensors or n in points else _scaled(v, inverse(root(dot(v, v))))
        at[n] = (x, y, int(n in points)) if plane else (x, y, z, int(n in points))
    evaluator = Evaluator(at, rank=3 if plane else 4)
    value: Any = evaluator.value(e)[0]
    if not extensors:
        return value  # type: ignore[no-any-return]
    sizes: Ring = 1
    for child in e.children:
        square: Ring = 0
        for c in evaluator.value(child):
            square = square + c * c
        sizes = sizes * square
    return value * inverse(root(sizes))  # type: ignore[no-any-return]


def _scaled(v: Vector, by: Ring) -> Vector:
    return v[0] * by, v[1] * by, v[2] * by
