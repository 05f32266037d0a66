"""A platform on six legs as a mechanism: exact, and quick in many poses."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np

from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.limits import LengthLimits, limits_of_legs
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.kinematics.amplification import Drives
from gcrules.mechanisms.kinematics.leg_amplification import LEGS, amplified_by_legs
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.mechanisms.moving_platform import MovingPlatform, rig
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose, pose_of

__all__ = ["SixLegs"]


@dataclass(frozen=True)
class SixLegs:
    """A `Mechanism`: each leg is driven, and resists with the force along it. `analysed` is what is known already.

    Raises InputError, once it is moved, for degenerate platforms and legs that do not tell base from platform.
    """

    platform: Platform
    about: str | tuple[Any, ...] = "centroid"
    analysed: Analysis | None = None

    @cached_property
    def analysis(self) -> Analysis:
        return self.analysed or analyze_legs(self.platform, facts=False)

    @cached_property
    def rig(self) -> MovingPlatform:
        """The platform as it moves."""
        return rig(self.analysis.structure, self.platform, self.about)

    @property
    def title(self) -> str:
        return self.platform.title

    @property
    def unit(self) -> str:
        return self.platform.units

    @property
    def bodies(self) -> Mapping[str, tuple[str, ...]]:
        structure = self.analysis.structure
        return FrozenMap({"base": structure.base, "platform": structure.platform})

    @property
    def mobility(self) -> int:
        return 6

    @property
    def actuators(self) -> tuple[str, ...]:
        return self.rig.names

    @property
    def limits(self) -> str:
        return self.platform.limits

    def read_limits(self, text: str) -> LengthLimits:
        """Those of the lengths of legs."""
        return limits_of_legs(text, self.rig.structure.legs, self.unit)

    @property
    def drives(self) -> Drives:
        return LEGS

    def pose(self, at: Pose | str | Mapping[str, Any] | None) -> Pose:
        """The pose that is written or given by coordinates."""
        if at is None or isinstance(at, Pose):
            return at or Pose()
        return parse_pose(at, self.unit) if isinstance(at, str) else pose_of(at)

    def wrenches(self, at: Pose | str | Mapping[str, Any] | None = None) -> WrenchJacobian:
        """Unit forces along the legs, from the base on, with moments about the moved centre."""
        moving, pose = self.rig, self.pose(at)
        turn = np.array([[[float(c) for c in row] for row in pose.rotation]])
        shift = np.array([[float(c) for c in pose.translation]])
        ends = moving.ends(shift, turn)[0]
        centre = moving.centre_of_turns + shift[0]
        j = jacobian(moving.base, ends[None])
        forces = j.directions[0]
        rows = np.concatenate([forces, np.cross(ends - centre, forces)], axis=1)
        least, condition = float(j.singular_values[0, 5]), float(j.condition_number[0])
        names = self.actuators
        passing = amplified_by_legs(moving.base, ends[None], centre[None]).passing
        return WrenchJacobian(names, rows, centre, j.radius, least, condition, names, LEGS, passing.one(0))

    def six_legs(self) -> SixLegs:
        return self
