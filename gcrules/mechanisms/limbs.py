"""A robot that is described by its joints as a mechanism: in each pose its loops are closed."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.limb_file import BASE
from gcrules.mechanisms.description.limits import LengthLimits, limits_of_limbs
from gcrules.mechanisms.platform_analysis import legs_of, with_platform
from gcrules.mechanisms.robot import Robot
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.screws.pose import Pose

if TYPE_CHECKING:
    from gcrules.mechanisms.kinematics.amplification import Drives
    from gcrules.mechanisms.kinematics.linkage import Linkage
    from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian

__all__ = ["Limbs"]

_linkage = deferred("gcrules.mechanisms.kinematics.linkage:linkage")
_drives = deferred("gcrules.mechanisms.kinematics.actuations:drives")
_wrenches_at = deferred("gcrules.mechanisms.kinematics.wrench_jacobian:wrenches_at")


@dataclass(frozen=True)
class Limbs:
    """A `Mechanism`. `analysed` is what is known of it already.

    Raises InputError, once it is moved, where the robot has no joints or no home.
    """

    robot: Robot
    about: str | tuple[Any, ...] = "centroid"
    analysed: RobotAnalysis | None = None

    @classmethod
    def of(cls, loaded: Robot | RobotAnalysis, about: str | tuple[Any, ...] = "centroid") -> Limbs:
        if isinstance(loaded, RobotAnalysis):
            return cls(loaded.robot, about, loaded)
        return cls(loaded, about)

    @cached_property
    def analysis(self) -> RobotAnalysis:
        return self.analysed or analyze_robot(self.robot)

    @cached_property
    def linkage(self) -> Linkage:
        """The joints that move it."""
        found: Linkage = _linkage(self.robot, self.about)
        return found

    @property
    def title(self) -> str:
        return self.robot.title

    @property
    def unit(self) -> str:
        return self.robot.units

    @property
    def bodies(self) -> Mapping[str, tuple[str, ...]]:
        sorts = self.robot.family.sorts
        body = tuple(n for n in self.robot.platform if sorts.get(n) == "point")
        chains = (part for limb in self.robot.limbs for part in limb.parts)
        feet = dict.fromkeys(p for c, own in chains if c.start == BASE for p in own[0].points if p not in body)
        return FrozenMap({"base": tuple(feet), "platform": body})

    @property
    def mobility(self) -> int:
        return self.robot.mobility

    @property
    def actuators(self) -> tuple[str, ...]:
        return tuple(a.name for a in self.linkage.actuators)

    @property
    def limits(self) -> str:
        return self.robot.limits

    def read_limits(self, text: str) -> LengthLimits:
        """Those of amounts from home."""
        return limits_of_limbs(text, self.robot.limbs, self.unit)

    @property
    def drives(self) -> Drives:
        found: Drives = _drives(self.linkage)
        return found

    def wrenches(self, at: Pose | str | Mapping[str, Any] | None = None) -> WrenchJacobian:
        """Actuations and constraints of all limbs, with moments about the moved centre."""
        found: WrenchJacobian = _wrenches_at(self.linkage, at)
        return found

    def six_legs(self) -> SixLegs:
        """Analysed as its lines are, where these are known and are those legs."""
        platform = as_platform(self.robot)
        lines = self.analysed.lines if self.analysed else None
        known = lines is not None and lines.structure == legs_of(platform)
        return SixLegs(platform, self.about, with_platform(lines, platform) if lines and known else None)
