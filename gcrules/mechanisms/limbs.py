"""A robot that is described by its joints as a mechanism: in each pose its loops are closed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.kinematics.linkage import Linkage, linkage
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import coordinates_target, pose_target, read_pose
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian, wrench_jacobian
from gcrules.mechanisms.robot import Robot
from gcrules.screws.pose import Pose

__all__ = ["Limbs", "feet_of"]


@dataclass(frozen=True)
class Limbs:
    """A `Mechanism`. `analysed` is what is known of it already.

    Raises InputError, once it is moved, where the robot has no joints or no home.
    """

    robot: Robot
    about: str | Sequence[Any] = "centroid"
    analysed: RobotAnalysis | None = None

    @classmethod
    def of(cls, loaded: Robot | RobotAnalysis, about: str | Sequence[Any] = "centroid") -> Limbs:
        if isinstance(loaded, RobotAnalysis):
            return cls(loaded.robot, about, loaded)
        return cls(loaded, about)

    @cached_property
    def analysis(self) -> RobotAnalysis:
        return self.analysed or analyze_robot(self.robot)

    @cached_property
    def linkage(self) -> Linkage:
        """The joints that move it."""
        return linkage(self.robot, self.about)

    @property
    def title(self) -> str:
        return self.robot.title

    @property
    def unit(self) -> str:
        return ""

    @property
    def bodies(self) -> Mapping[str, tuple[str, ...]]:
        return FrozenMap({"base": feet_of(self.robot), "platform": self.robot.platform})

    @property
    def mobility(self) -> int:
        return self.robot.mobility

    @property
    def actuators(self) -> tuple[str, ...]:
        return tuple(a.name for a in self.linkage.actuators)

    @property
    def centre(self) -> tuple[float, ...]:
        return tuple(map(float, self.linkage.centre))

    def wrenches(self, at: Pose | str | Mapping[str, Any] | None = None) -> WrenchJacobian:
        """Actuations and constraints of all limbs, with moments about the moved centre."""
        m = self.linkage
        if at is None:
            here = m.home
        elif isinstance(at, str):
            here = solve(m, read_pose(m, at)).configuration
        else:
            here = solve(m, pose_target(m, at) if isinstance(at, Pose) else coordinates_target(m, at)).configuration
        return wrench_jacobian(m, here, margin(m, here))


def feet_of(robot: Robot) -> tuple[str, ...]:
    """The points that the limbs' first joints name and that are not of the platform."""
    first = (n for limb in robot.limbs for n in limb.joints[0].names if robot.family.sorts.get(n) == "point")
    return tuple(dict.fromkeys(p for p in first if p not in robot.platform))
