r"""What was found for a robot: its conditions in the robot's own words, and what they rest on."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.dimensions.facts import Dimensions
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.mechanisms.robot import Robot
from gcrules.rules.condition import Condition
from gcrules.rules.statement import Statement

if TYPE_CHECKING:  # what computes them takes a while to load, and is not needed to hold them
    from gcrules.mechanisms.conditions.common_factor import CommonFactor
    from gcrules.mechanisms.conditions.factor_causes import FactorCause
    from gcrules.mechanisms.conditions.published import Published
    from gcrules.mechanisms.lines.equivalent import Equivalent
    from gcrules.mechanisms.lines.home import HomeWrench
    from gcrules.mechanisms.lines.serial import LimbSingularity

__all__ = ["RobotAnalysis"]


@dataclass(frozen=True)
class RobotAnalysis(Shown):
    """What was found for a robot.

    `lines` is the analysis of the equivalent structure's lines, None where limbs apply wrenches that are no lines of
    the robot's points; `condition` that of its readings that is used, an identity for these lines; `parts` its factors
    told apart, `limbs` the singularities of limbs by themselves. `members` exact random members were checked. `common`
    is what the six-subsets of an over-constrained robot's lines have in common, `wrenches` are those at home of limbs
    that have no lines, `dimensions` what the numbers at home say beyond the relations, if that was asked.
    """

    robot: Robot
    structure: Equivalent
    lines: Analysis | None
    condition: Condition | None
    parts: tuple[FactorCause, ...]
    limbs: tuple[LimbSingularity, ...]
    meaning: Statement
    certificate: str
    cofactors: tuple[Expr, ...] = ()
    members: int = 0
    met: int = 0
    published: Published | None = None
    common: CommonFactor | None = None
    wrenches: tuple[HomeWrench, ...] = ()
    dimensions: Dimensions | None = None

    @property
    def statement(self) -> str:
        """When the robot is singular, in words."""
        return str(self.meaning)

    def to_json(self) -> dict[str, Any]:
        """The object of `gcrules analyze` for the equivalent lines, with what is known of the robot."""
        names = self.lines.structure.names if self.lines else ()
        found: dict[str, Any] = self.lines.to_json() if self.lines else {"schema": 1, "condition": None}
        if self.condition is not None:
            found["condition"] = self.condition.to_json(names)
        return found | {
            "robot": self.robot.id,
            "title": self.robot.title,
            "mobility": self.structure.mobility,
            "overconstraints": self.structure.overconstraints,
            "redundant_actuators": self.structure.redundant,
            "idle": self.structure.idle,
            "limbs": [limb.to_json() for limb in self.structure.limbs],
            "equivalent": self.structure.to_json(),
            "parts": [
                {
                    "expression": text(p.expression, names=names),
                    "kind": p.kind,
                    "types": list(p.types),
                    "statement": p.statement,
                    "members": p.members,
                    "reason": p.reason,
                    "chosen": p.chosen,
                    "of_design": p.of_design,
                    "same": None if p.same is None else text(p.same, names=names),
                }
                for p in self.parts
            ],
            "limb_singularities": [s.to_json() for s in self.limbs],
            "cofactors": [text(e, names=names) for e in self.cofactors],
            "common_factor": None if self.common is None else self.common.to_json(names),
            "home_wrenches": [one.to_json() for one in self.wrenches],
            "statement": self.statement,
            "dimensions": None if self.dimensions is None else self.dimensions.to_json(names),
            "robot_certificate": {"detail": self.certificate, "members": self.members, "singular_members": self.met},
            "published": None if self.published is None else vars(self.published).copy(),
        }

    def __repr__(self) -> str:
        return f"<RobotAnalysis {self.robot.id}: {self.condition.kind if self.condition else 'no lines'}>"
