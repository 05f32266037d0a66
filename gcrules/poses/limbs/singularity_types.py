r"""The types of singularity in a configuration of a robot, each with the motion or the relation of rates that shows it.

Which types there are is decided by the ranks of `mechanisms.lines.ranks`, as for exact members of the family, here in
floats. What shows them is taken from the rates of all joints with which the loops stay closed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import accumulate
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import slopes
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import loop_rows, units_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.lines.ranks import TYPES, Ranks, ranks, types_of
from gcrules.poses.numbers.motion import Twist
from gcrules.screws.floats import Floats as FloatField
from gcrules.screws.pose_text import SHIFTS, TURNS

__all__ = ["SingularityType", "singularity_types"]

_RANK = 1e-7  # of unit twists and wrenches: below it they depend on each other
_NOTHING = 1e-6  # of the largest coefficient of a relation

Relation = Mapping[str, float]


@dataclass(frozen=True)
class SingularityType:
    """A type of singularity: its `symbol` (a key of `TYPES`), and what shows it.

    `motions` are those of the platform with the actuators locked (RO). Each of the `relations` holds for the rates of
    the actuators (II), or of the platform's coordinates (IO): by name the coefficients, of rad/s and the file's unit of
    length a second, whose sum with the rates is 0; none where the coordinates do not show it. `names` are the
    actuators that move with the platform at rest (RI), or the limbs whose passive joints do (RPM). `freedoms` are those
    of all joints together, here and elsewhere (IIM).
    """

    symbol: str
    motions: tuple[Twist, ...] = ()
    relations: tuple[Relation, ...] = ()
    names: tuple[str, ...] = ()
    freedoms: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "relations", tuple(FrozenMap(r) for r in self.relations))

    def to_json(self) -> dict[str, Any]:
        return {
            "type": self.symbol,
            "name": TYPES[self.symbol],
            "motions": [motion.to_json() for motion in self.motions],
            "relations": [dict(r) for r in self.relations],
            "names": list(self.names),
            "freedoms": list(self.freedoms),
        }


def singularity_types(m: Linkage, c: Configuration, motions: Sequence[Twist]) -> tuple[SingularityType, ...]:
    """The types in a configuration that is singular, in the order of `TYPES`; `motions` are the gained ones."""
    here = _ranks(m, c)
    rates = _Rates(m, c, here)
    shown: Mapping[str, Any] = {
        "RO": lambda: {"motions": tuple(motions)},
        "II": lambda: {"relations": tuple(rates.of_actuators())},
        "RI": lambda: {"names": tuple(rates.idle_actuators())},
        "IO": lambda: {"relations": tuple(rates.of_coordinates())},
        "RPM": lambda: {"names": tuple(_passive(m, here))},
        "IIM": lambda: {"freedoms": (rates.freedoms, _freedoms(m, m.elsewhere))},
    }
    return tuple(SingularityType(symbol, **shown[symbol]()) for symbol in types_of(here, m.elsewhere))


def _ranks(m: Linkage, c: Configuration) -> Ranks:
    """The ranks in floats, with the origin in the robot."""
    centre = c.platform[:3, :3] @ m.centre + c.platform[:3, 3]
    sorts = m.robot.family.sorts
    values = {}
    for name, v in c.values.items():
        x, y, z = map(float, v - centre if sorts.get(name) == "point" else v)
        values[name] = x, y, z
    return ranks(m.robot.family, m.robot.limbs, values, FloatField(_RANK, m.size))


def _freedoms(m: Linkage, at: Ranks) -> int:
    """The dimension of all rates with which the loops stay closed."""
    full = 3 if m.robot.family.plane else 6
    pairs = zip(m.robot.limbs, at.limbs, strict=True)
    return full - at.constraints + sum(limb.freedoms - own for limb, (own, _) in pairs)


def _coordinates(m: Linkage) -> tuple[str, ...]:
    """As many coordinates as the platform has freedoms elsewhere; fewer where it is singular at home already."""
    every = ("x", "y", "yaw") if m.robot.family.plane else (*SHIFTS, *TURNS)
    return every if len(every) == m.robot.mobility else free_coordinates(m)


def _passive(m: Linkage, here: Ranks) -> Iterator[str]:
    """The limbs whose passive twists depend on each other more than elsewhere."""
    for limb, (_, passive), (_, usual) in zip(m.robot.limbs, here.limbs, m.elsewhere.limbs, strict=True):
        if passive < usual:
            yield limb.name


class _Rates:
    """The rates of all joints (amounts, freedoms) with which the loops stay closed, an orthonormal basis in units."""

    def __init__(self, m: Linkage, c: Configuration, here: Ranks) -> None:
        only = Configurations.of([c])
        self.m, self.c, self.here = m, c, here
        self.twists = [chain.shared_twists for chain in only.chains]
        self.units = units_of(m)
        self.freedoms = _freedoms(m, here)
        rows = loop_rows(self.twists, only.platform, m)[0] * self.units
        self.basis = np.linalg.svd(rows)[2][len(self.units) - self.freedoms :].T

    def of_actuators(self) -> Iterator[Relation]:
        """What the rates of the actuators have to satisfy."""
        actuators = self.m.actuators
        places = [self._starts[a.place] + a.coordinate for a in actuators]
        pairs = zip(self.m.robot.limbs, self.here.limbs, strict=True)
        passive = sum(limb.freedoms - limb.actuators - own for limb, (_, own) in pairs)
        free = self.freedoms - (self._full - self.here.wrenches) - passive
        yield from _relations([a.name for a in actuators], self.basis[places], self.units[places], free)

    def of_coordinates(self) -> Iterator[Relation]:
        """What the rates of coordinates have to satisfy that determine the pose elsewhere."""
        m = self.m
        names = _coordinates(m)
        weights = np.array([m.size if n in SHIFTS else 1.0 for n in names])
        own = self.twists[0].shape[-1]
        moved = slopes(names, self.c.platform[None], m.centre)[0] @ self.twists[0][0, 0] * self.units[:own]
        free = self._full - self.here.constraints
        reached = moved @ self.basis[:own] / weights[:, None]
        if np.linalg.matrix_rank(reached, _RANK) == free:
            yield from _relations(names, reached, weights, free)

    def idle_actuators(self) -> Iterator[str]:
        """The actuators that can move with the platform at rest."""
        for place, (own, _) in enumerate(self.here.limbs):
            start, end = self._starts[place : place + 2]
            columns = np.concatenate(self.twists[place][0]) * self.units[start:end]
            still = np.linalg.svd(columns)[2][own:]
            for a in self.m.actuators:
                if a.place == place and np.abs(still[:, a.coordinate]).max(initial=0.0) > _NOTHING:
                    yield a.name

    @property
    def _full(self) -> int:
        return 3 if self.m.robot.family.plane else 6

    @property
    def _starts(self) -> list[int]:
        """The place of each limb's first freedom among all."""
        return list(accumulate((limb.freedoms for limb in self.m.robot.limbs), initial=0))


def _relations(names: Sequence[str], rows: Floats, units: Floats, rank: int) -> Iterator[Relation]:
    """The relations between rates whose values are rows (names, freedoms) in units, of this rank."""
    for one in np.linalg.svd(rows)[0][:, rank:].T:
        kept = np.flatnonzero(np.abs(one) > _NOTHING * np.abs(one).max()).tolist()
        coefficients = one / units
        largest = abs(coefficients[int(np.argmax(np.abs(one)))]) * np.sign(coefficients[kept[0]])
        yield {names[k]: float(coefficients[k] / largest) for k in kept}
