r"""On which assembly mode a configuration lies: what is proved of the way to it from home.

Three questions: does the way keep to one branch of solutions (proved step by step, `gcrules.mechanisms.kinematics.
branch`); does the determinant of the wrenches change its sign on it (`determinants`); and is it proved that nothing on
it is singular. A way that crosses no singular configuration stays on home's assembly mode.
"""

from __future__ import annotations

from math import floor
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.solve import Solution
from gcrules.poses.limbs.way import Way
from gcrules.screws.verdict import SOLVED

__all__ = ["WayFromHome", "way_from_home"]

_MOST = 96  # stretches that are looked at for one proof
_END = 0.999


@dataclass(frozen=True)
class WayFromHome:
    """What is known of the way from home, its places in parts of it from 0 to 1.

    The branch of solutions is proved but from `doubt` on. At the `crossings` the determinant of the wrenches changes
    its sign, `unknown` is where its sign cannot be followed. From home to `regular` it is proved that no configuration
    is singular; `ends_singular` tells that the last configuration is. Robots with more actuators than freedoms are not
    `signed`: no determinant changes its sign.
    """

    doubt: float | None = None
    crossings: tuple[float, ...] = ()
    unknown: float | None = None
    regular: float = 1.0
    ends_singular: bool = False
    at_home: bool = False
    signed: bool = True

    @property
    def same(self) -> bool | None:
        """Whether the way stays on home's mode: True where that is proved, False where it crosses a singular
        configuration, None where it is not known.
        """
        if self.doubt is not None:
            return None
        if self.crossings:
            return False
        return True if self.regular >= 1 else None

    @property
    def text(self) -> str:
        """In words."""
        if self.at_home:
            return "that of home"
        if self.doubt is not None:
            return f"not known: its branch is not proved beyond {_at_least(self.doubt)} of the way from home"
        if self.crossings:
            where = listed([_percent(c) for c in self.crossings])
            return (
                "the way from home crosses a singular configuration: the determinant of the wrenches changes its sign"
                f" at {where} of it"
            )
        if self.regular >= 1:
            return "that of home, proved: no configuration on the way from there is singular"
        if self.ends_singular and self.regular >= _END:
            return f"that of home, proved up to {_at_least(self.regular)} of the way from there; its end is singular"
        if self.unknown is not None:
            where = _percent(self.unknown)
            return f"not known: the sign of the determinant of the wrenches is lost at {where} of the way"
        if not self.signed:
            return f"not known: that nothing is singular is proved up to {_at_least(self.regular)} of the way from home"
        return (
            "not known: the determinant of the wrenches has one sign at all steps from home, but that nothing between"
            f" them is singular is not proved at {_at_least(self.regular)} of the way"
        )

    @property
    def branch(self) -> str:
        """Of the branch of solutions, in words."""
        if self.at_home:
            return "home itself"
        if self.doubt is None:
            return "proved: one continuous solution leads here from home, and no other one comes near it"
        return f"not proved beyond {_at_least(self.doubt)} of the way from home: this may be another solution"

    def to_json(self) -> dict[str, Any]:
        return {
            "branch_proved": self.doubt is None,
            "proved_to": 1.0 if self.doubt is None else self.doubt,
            "same_mode": self.same,
            "crossings": list(self.crossings),
            "regular_to": self.regular,
        }


def _percent(part: float) -> str:
    return f"{100 * part:.4g}%"


def _at_least(part: float) -> str:
    return f"{floor(1e4 * part) / 100:g}%"


def way_from_home(m: Linkage, solution: Solution) -> WayFromHome:
    """What is known of the way from home to a solution."""
    if not solution.steps:
        return WayFromHome(at_home=True)
    way = Way(m, solution.target, [(0.0, m.home), *zip(solution.parts, solution.way, strict=True)])
    crossings, unknown = way.signs()
    regular = way.proved_to(_MOST) if solution.doubt is None and not crossings else 0.0
    end = solution.parts[-1]
    return WayFromHome(
        None if solution.doubt is None else float(solution.doubt / end),
        tuple(float((a + b) / (2 * end)) for a, b in crossings),
        None if unknown is None else float(unknown / end),
        float(regular / end),
        margin(m, solution.configuration).sigma <= SOLVED
        if m.robot.redundant
        else not way.frames(solution.configuration).signed[0],
        signed=not m.robot.redundant,
    )
