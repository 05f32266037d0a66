r"""The operation modes of a robot, as frozen values."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.mechanisms.robot import Robot
from gcrules.poses.operation_modes.limb_constraints import Equation, LimbConstraints

__all__ = ["Assemblies", "OperationMode", "OperationModes", "Transition", "terms_of"]

Pose = tuple[Fraction, ...]


def terms_of(equation: Equation) -> list[tuple[Fraction, tuple[int, ...]]]:
    """Its terms: coefficients, and exponents of x0 … x3, y0 … y3."""
    return [
        (c, (*e, *(int(n == k) for k in range(4))))
        for n, form in enumerate(equation)
        for e, c in sorted(form.items(), reverse=True)
    ]


@dataclass(frozen=True)
class OperationMode:
    """An irreducible set of poses that all limbs allow, their actuators free.

    `equations` hold in it, beside Study's own and those of the limbs: those of degree at most 2, whose degree in y is
    at most 1. They are `enough` if near a random pose of the mode they allow no others. It has `turning` freedoms of
    orientation, and in each orientation `shifting` ones of shifts. `motion` says so in words. `witness` is a pose of it
    in Study parameters, None where no rational one was found; `home` says whether the home configuration is in it,
    None where that is not decided.

    It is `proper` if it is shown that it is in no larger set of allowed poses; where the limbs' equations are not
    whole, in none through home with the joints as they are there. It is `irreducible` if it is shown that it does not
    fall apart over the rationals. So many random assemblies of the limbs were `assembled` in it.
    """

    number: int
    dimension: int
    turning: int
    shifting: int
    motion: str
    equations: tuple[Equation, ...]
    enough: bool
    witness: Pose | None
    home: bool | None
    proper: bool
    irreducible: bool
    assembled: int

    def to_json(self) -> dict[str, Any]:
        return {
            "number": self.number,
            "dimension": self.dimension,
            "turning": self.turning,
            "shifting": self.shifting,
            "motion": self.motion,
            "equations": [
                [{"coefficient": str(c), "exponents": list(e)} for c, e in terms_of(one)] for one in self.equations
            ],
            "enough": self.enough,
            "witness": None if self.witness is None else [str(c) for c in self.witness],
            "home": self.home,
            "proper": self.proper,
            "irreducible": self.irreducible,
            "assembled": self.assembled,
        }


@dataclass(frozen=True)
class Transition:
    """Two modes by their numbers: they `meet` in the `witness`; they do not (False) where no orientation is in both;
    None where no common pose was found.
    """

    modes: tuple[int, int]
    meet: bool | None
    witness: Pose | None

    def to_json(self) -> dict[str, Any]:
        witness = None if self.witness is None else [str(c) for c in self.witness]
        return {"modes": list(self.modes), "meet": self.meet, "witness": witness}


@dataclass(frozen=True)
class Assemblies:
    """Random assemblies of the limbs, closed numerically from their joints: `closed` of `tried` starts; `outside` of
    them are in no mode that is listed.
    """

    tried: int
    closed: int
    outside: int

    def to_json(self) -> dict[str, Any]:
        return {"tried": self.tried, "closed": self.closed, "outside": self.outside}


@dataclass(frozen=True, repr=False)
class OperationModes(Shown):
    """The operation modes of a robot, those of the largest dimension first.

    The equations of the `limbs` are `whole`; else some limbs have none that are linear in y, and only a part of their
    poses, in which two turns about parallel axes are coupled, was taken apart. Every irreducible set of real poses of
    the dimension `least` or more that whole equations allow is in one of these modes. `smaller` sets were left out, as
    they lie in a larger one at random poses.
    """

    robot: Robot
    limbs: tuple[LimbConstraints, ...]
    whole: bool
    least: int
    modes: tuple[OperationMode, ...]
    smaller: int
    transitions: tuple[Transition, ...]
    assemblies: Assemblies

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.robot.id}: {', '.join(str(m.dimension) for m in self.modes)}>"

    @property
    def proved(self) -> bool:
        """Whether each mode is shown to be irreducible, and in no larger one."""
        return all(m.proper and m.irreducible for m in self.modes)

    @property
    def complete(self) -> bool | None:
        """True if no other mode of the dimension `least` or more is left by elimination, and no random assembly is
        outside of those listed; False if one is outside; else None.
        """
        return False if self.assemblies.outside else (True if self.whole else None)

    def to_json(self) -> dict[str, Any]:
        return {
            "schema": 1,
            "robot": self.robot.id,
            "title": self.robot.title,
            "limbs": [
                {"name": c.name, "dimension": c.dimension, "equations": len(c.equations), "enough": c.enough}
                for c in self.limbs
            ],
            "whole": self.whole,
            "least": self.least,
            "modes": [m.to_json() for m in self.modes],
            "smaller": self.smaller,
            "transitions": [t.to_json() for t in self.transitions],
            "assemblies": self.assemblies.to_json(),
            "proved": self.proved,
            "complete": self.complete,
        }
