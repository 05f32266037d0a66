r"""Robots of joints at very many poses: a frozen value that is called with arrays of coordinates.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> value = compiled_limbs(mechanism("delta"))
>>> value.coordinates, value.kinds
(('x', 'y', 'z'), ('actuation', 'constraint'))
>>> value([[0, 0, 0], [0.5, 0, -1], [0, 0, -99]]).round(4).tolist()
[[-0.6798, -0.6127], [-0.6315, -0.6169], [nan, nan]]
>>> value.margins([0.5, 0, -1]).round(4).tolist()
[0.2641]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set
from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.arguments import described
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.factor_causes import ASIDE
from gcrules.mechanisms.kinematics.coordinates import wrapped
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Actuator, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import check_target, free_coordinates
from gcrules.mechanisms.kinematics.targets import Target, actuators_target, check_turn, coordinates_target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.closed_forms import ClosedForms, run
from gcrules.poses.compiling.limb_programs import limb_programs
from gcrules.poses.limbs.factors import factors
from gcrules.poses.limbs.many import NUMBERS, WAYS, numbers_at
from gcrules.poses.numbers.arrays import finite_rows
from gcrules.screws.pose_text import SHIFTS

__all__ = ["STRAIGHT", "CompiledLimbs", "compiled_limbs"]

_FAR = 200.0  # sizes of the robot, or rad: farther poses are faults of the input

STRAIGHT = "home's: at each pose the solution to which the straight way from home leads"
"""The branch of solutions where loops are closed step by step, in words."""

_CLOSED = "home's: of two solutions of a limb, or of the platform, the one that is home's, wherever there is one"


@dataclass(frozen=True)
class CompiledLimbs:
    """The numbers of a robot of joints at poses: call it, or one of its methods, with an array of them.

    Poses are given by the `coordinates`, in their order, as arrays (N, coordinates), or one row: lengths in the unit of
    the file, angles in radians, all 0 at home. They are coordinates of the platform, or all actuators. `factors` are
    those of the condition whose zeros are singularities, `kinds` say of what (actuation, constraint …).

    A call computes the factors by their `programs`, run by the `engine`, where they have a closed form; without
    programs and for all other numbers the joints are solved, step by step on the straight way from home. `mode` says
    which of several solutions a call takes.

    Where the robot does not assemble, or where no solution was reached, the numbers are nan; programs see that of the
    platform and of limbs with parts that the factors name, and of no others. All raise InputError for
    arrays of another shape, for numbers that are not finite, and for poses that no robot of this size can reach.
    """

    mechanism: Limbs
    coordinates: tuple[str, ...]
    driven: bool
    factors: tuple[str, ...]
    kinds: tuple[str, ...]
    programs: ClosedForms = field(default_factory=ClosedForms)
    engine: str = "numpy"

    @property
    def mode(self) -> str:
        """The branch of solutions whose factors a call gives, in words."""
        return _CLOSED if self.programs.factors else STRAIGHT

    @property
    def actuators(self) -> tuple[Actuator, ...]:
        """The actuators, in the order of the columns of `actuator_values`."""
        return self.mechanism.linkage.actuators

    def __call__(self, poses: Any) -> Floats:
        """The values of the factors, (N, factors): numbers with a sign that know neither unit nor scale, divided by
        their cofactors, as those of `gc.pose`.
        """
        program = self.programs.factors
        return run(program, self.engine, self._turned(poses)).T if program else self._one("factors", poses)

    def margins(self, poses: Any) -> Floats:
        """The margin σ, (N,): 0 where the wrenches of all limbs do not hold the platform."""
        if self.programs.wrenches is None:
            return self._one("margins", poses)
        return self.programs.margins(self.engine, self._turned(poses))

    def limb_margins(self, poses: Any) -> Floats:
        """For each limb how far it is from being singular by itself, (N, limbs)."""
        return self._one("limb_margins", poses)

    def actuator_values(self, poses: Any) -> Floats:
        """The amounts of the actuators from home, (N, actuators): rad, or the file's unit of length; by a program turns
        from −π to π.
        """
        if self.programs.actuators is None:
            return self._one("actuators", poses)
        return self.programs.amounts(self.engine, self._turned(poses))

    def signs(self, poses: Any) -> NDArray[np.int8]:
        """The sign of the determinant of all wrenches, (N,), 1 at home: it changes where the way crosses a singular
        configuration. 0 where it could not be followed, and everywhere if home is singular.
        """
        return np.asarray(self._one("signs", poses), dtype=np.int8)

    def proved(self, poses: Any) -> NDArray[np.bool_]:
        """Where it is proved, (N,), that the straight way from home follows one branch of solutions, so that these are
        its numbers. False proves nothing.
        """
        return np.asarray(self._one("proved", poses), dtype=bool)

    def numbers(self, poses: Any, asked: str | Iterable[str] = "factors, margins, actuators") -> dict[str, Any]:
        """Several of "factors", "margins", "limb_margins", "actuators", "coordinates" (all nine of the platform),
        "isotropy", "speeds" and "turns" of the actuators, "signs" and "proved" at once, by name: the joints are solved
        once. With "proved" steps are made so short, where that helps, that they can be proved.
        """
        known = (*NUMBERS, *WAYS)
        names: Any = [n.strip() for n in asked.split(",")] if isinstance(asked, str) else asked
        if not isinstance(names, Sequence | Set) or not (names := list(names)):
            raise InputError(f"no numbers are asked for by {described(asked)}", hint=f"there are {listed(known)}")
        unknown = [n for n in names if not isinstance(n, str) or n not in known]
        if unknown:
            raise InputError(f"there are no numbers {described(unknown[0])}", hint=f"there are {listed(known)}")
        m = self.mechanism.linkage
        wanted = self._wanted(poses)
        order = tuple(a.name for a in leading(m)) if self.driven else self.coordinates
        target = Target(order, np.zeros(len(order)), self.driven)
        return numbers_at(self.mechanism, target, wanted[:, [self.coordinates.index(n) for n in order]], names)

    def _turned(self, poses: Any) -> Floats:
        """The wanted values with angles from −π to π, as programs take them."""
        wanted = self._wanted(poses)
        return wrapped(self.coordinates, wanted) if _largest(wanted) > np.pi else wanted

    def _wanted(self, poses: Any) -> Floats:
        """The wanted values (N, coordinates). Raises InputError for what is no array of them."""
        names, m = self.coordinates, self.mechanism.linkage
        found = finite_rows(poses, len(names), f"poses ({', '.join(names)})")
        lengths = {a.name for a in m.actuators if not a.angle} | set(SHIFTS)
        units = np.array([m.size if n in lengths else 1.0 for n in names])
        if _largest(found) <= min(np.pi / 2.1, _FAR * units.min()):  # as a rule; quicker than each column by itself
            return found
        far = (np.abs(found) > _FAR * units).any(axis=1)
        if far.any():
            n = int(np.argmax(far))
            raise InputError(
                f"pose {n} is over {_FAR:g} times the robot's size, or as many radians, from home: {found[n].tolist()}",
                hint="check the unit; angles are in radians",
            )
        turns = [k for k, n in enumerate(names) if n not in lengths]
        wide = (np.abs(found[:, turns]) >= np.pi / 2).any(axis=1)
        for row in found[:0] if self.driven else found[wide]:
            check_turn(dict(zip(names, row.tolist(), strict=True)))
        return found

    def _one(self, name: str, poses: Any) -> Floats:
        return np.asarray(self.numbers(poses, [name])[name])

    def __repr__(self) -> str:
        robot, over = self.mechanism.robot.id, ", ".join(self.coordinates)
        pairs = zip(self.factors, self.kinds, strict=True)
        words = ", ".join(f"{f} ({k})" for f, k in pairs) or "the margin"
        program = self.programs.factors
        way = f"{program.operations} operations a pose, by {self.engine}" if program else "by closing the loops"
        return f"<CompiledLimbs {robot} over {over}: {words}; {way}>"


def compiled_limbs(m: Limbs, coordinates: str | Sequence[str] | None = None, engine: str = "numpy") -> CompiledLimbs:
    """The numbers of a robot over coordinates of its pose, or over its actuators ("q1, q2, q3"); over those that are
    free near home where none are named. Raises InputError where they do not determine the pose.
    """
    k = m.linkage
    names, driven = _read(k, coordinates)
    home = Target(names, np.zeros(len(names)), driven, text="home")
    check_target(k, home)
    live = [p for p in factors(m.analysis, k.home.values) if p.kind not in ASIDE]
    expressions, kinds = tuple(f.expression for f in live), tuple(f.kind for f in live)
    return CompiledLimbs(m, names, driven, expressions, kinds, limb_programs(m, home), engine)


def _read(m: Linkage, coordinates: str | Sequence[str] | None) -> tuple[tuple[str, ...], bool]:
    """The names, and whether they are actuators; of these all, and all coordinates of a platform with six freedoms."""
    if coordinates is None:
        return free_coordinates(m), False
    given = coordinates.split(",") if isinstance(coordinates, str) else list(coordinates)
    names = tuple(n.strip() for n in given)
    twice = [n for n in names if names.count(n) > 1]
    if twice:
        raise InputError(f"the coordinate {twice[0]!r} is named twice", hint="name each once")
    home = dict.fromkeys(names, 0)
    if set(names) & {a.name for a in leading(m)}:
        every = actuators_target(m, home).names
        if len(names) < len(every):
            raise InputError(f"only {listed(names)} of the actuators", hint=f"name all of them: {', '.join(every)}")
        return names, True
    coordinates_target(m, home)
    return names, False


def _largest(values: Floats) -> float:
    """The largest of all numbers, without their signs."""
    return float(max(values.max(initial=0.0), -values.min(initial=0.0)))
