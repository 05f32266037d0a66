r"""What a controller computes of a robot at each pose, with numbers to test it by: what exported code is written from.

>>> found = controller("delta")
>>> found.coordinates, found.actuators, len(found.tests)
(('x', 'y', 'z'), ('q1', 'q2', 'q3'), 6)
>>> [part.expression for part in found.factors]
['[d1d2d3A1]', 'r2d2A2 /\\ r3d3A3 /\\ r1d1']
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.closed_forms import ClosedForms
from gcrules.poses.compiling.compiled_limbs import STRAIGHT, compiled_limbs
from gcrules.poses.compiling.leg_programs import leg_programs
from gcrules.poses.compiling.loop_tables import LoopTables, loop_tables
from gcrules.poses.limbs.factors import factors
from gcrules.poses.limbs.many import proved_at
from gcrules.poses.methods import Methods, method
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.many import scaled_superbracket
from gcrules.screws.margin import jacobian
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS, pose_of

__all__ = ["Controller", "Factor", "Test", "controller", "controller_of"]

_TESTS = 6
_REACHES = (0.0, 0.2, 0.2, 0.1, 0.1, 0.1, 0.05, 0.05, 0.02, 0.02, 0.01, 0.005)  # in parts of the robot's size, and rad


@dataclass(frozen=True)
class Factor:
    """A value that vanishes in singular poses: of what, what kind of singularity, and when in words."""

    expression: str
    kind: str
    statement: str


@dataclass(frozen=True)
class Test:
    """The numbers at a pose, computed without the programs."""

    pose: tuple[float, ...]
    actuators: tuple[float, ...]
    factors: tuple[float, ...]
    margin: float


@dataclass(frozen=True)
class Controller:
    """A robot's `forms`, all of them known, or else its loops as tables, with the names of what they take and give.

    Poses are given by the `coordinates`, in their order: lengths in the `unit` of the file, angles in rad, all 0 at
    home. `amounts` says what the actuators' numbers are, `mode` of which solutions of the loops they are, and `cables`
    whether there are cables among the actuators, `plane` whether the robot is planar.
    """

    name: str
    title: str
    unit: str
    coordinates: tuple[str, ...]
    actuators: tuple[str, ...]
    amounts: str
    mode: str
    factors: tuple[Factor, ...]
    forms: ClosedForms | LoopTables
    tests: tuple[Test, ...]
    cables: bool = False
    plane: bool = False

    @property
    def angles(self) -> tuple[bool, ...]:
        """Which of the coordinates are angles."""
        return tuple(n in ANGLES for n in self.coordinates)


def controller(
    source: Source, *, coordinates: str | Sequence[str] | None = None, about: str | Sequence[Any] = "centroid"
) -> Controller:
    """What a controller computes of the robot of a source (see `load`), whose poses turn `about` the same centre as in
    `pose`; over these `coordinates` of the platform, or those that are free near home.

    Raises InputError where a robot has no coordinates.
    """
    return controller_of(mechanism(source, about=about), coordinates)


def controller_of(m: Mechanism, coordinates: str | Sequence[str] | None = None) -> Controller:
    """The same of a mechanism."""
    return method(_METHODS, m, "code of the condition")(coordinates)


def _of_legs(m: SixLegs, coordinates: str | Sequence[str] | None) -> Controller:
    names = (*SHIFTS, *TURNS)
    given = coordinates.replace(",", " ").split() if isinstance(coordinates, str) else coordinates
    if given is not None and tuple(given) != names:
        raise InputError("a platform on six legs has all six coordinates", hint=f"leave them out: {', '.join(names)}")
    forms = leg_programs(m)
    legs = m.rig.names
    return Controller(
        m.title or "platform",
        m.title,
        m.unit,
        names,
        legs,
        "lengths of the legs",
        "",
        (
            Factor(
                f"[{', '.join(legs)}]",
                "actuation",
                m.analysis.condition.statement,
            ),
        ),
        forms,
        tuple(_tests_of_legs(m, _drawn([m.rig.size] * 3 + [1.0] * 3)[:_TESTS])),
    )


def _tests_of_legs(m: SixLegs, poses: Floats) -> list[Test]:
    shifts, turns = from_poses([pose_of(dict(zip((*SHIFTS, *TURNS), row, strict=True))) for row in poses.tolist()])
    near = jacobian(m.rig.base, m.rig.ends(shifts, turns))
    values = scaled_superbracket(m.rig, near)
    return [
        Test(tuple(pose), tuple(lengths), (value,), sigma)
        for pose, lengths, value, sigma in zip(
            poses.tolist(), near.lengths.tolist(), values.tolist(), near.sigma.tolist(), strict=True
        )
    ]


def _of_limbs(m: Limbs, coordinates: str | Sequence[str] | None) -> Controller:
    value = compiled_limbs(m, coordinates)
    if value.driven:
        raise InputError("code takes coordinates of the platform", hint="for actuators gc.compiled gives the numbers")
    target = Target(value.coordinates, np.zeros(len(value.coordinates)), False)
    poses = _drawn([m.linkage.size if n in SHIFTS else 1.0 for n in value.coordinates])
    places, there = proved_at(m, target, poses)
    forms: ClosedForms | LoopTables = value.programs
    mode, amounts = value.mode, "amounts of the actuators from home, turns from -pi to pi"
    if not value.programs.complete:
        if not len(there):
            raise InputError(f"the loops of {m.robot.id} are not closed near home", hint="gcrules pose says why")
        forms, mode, amounts = loop_tables(there, value.coordinates), STRAIGHT, "amounts of the actuators from home"
    live = [f for f in factors(m.analysis, m.linkage.home.values) if f.live]
    reached = places[:_TESTS]
    return Controller(
        m.robot.id,
        m.title,
        m.unit,
        value.coordinates,
        tuple(a.name for a in m.linkage.actuators),
        amounts,
        mode,
        tuple(Factor(f.expression, f.kind, f.statement) for f in live),
        forms,
        tuple(
            Test(tuple(pose), tuple(own), tuple(row), sigma)
            for pose, own, row, sigma in zip(
                poses[reached].tolist(),
                there.actuators.tolist(),
                there.factors.tolist(),
                margins(m.linkage, there.here).sigma.tolist(),
                strict=False,
            )
            if all(map(isfinite, (*own, *row, sigma)))
        ),
        any(m.drives.pulls),
        m.robot.family.plane,
    )


def _drawn(units: Sequence[float]) -> Floats:
    """Poses for tests, home first; the same in each process."""
    drawn = np.random.default_rng(1).uniform(-1.0, 1.0, (len(_REACHES), len(units)))
    found: Floats = np.array(_REACHES)[:, None] * drawn * np.array(units)
    return found


_METHODS: Methods[Controller] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
