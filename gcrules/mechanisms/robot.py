r"""Robots for users: `gc.Robot.load(id or path)`, `.analyze()`, and numbers in a configuration by `.pose()`."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from os import PathLike
from typing import TYPE_CHECKING, Any

from gcrules.core.arguments import (
    ANYTHING,
    DURATION,
    FILE,
    FLAG,
    NUMBER,
    ROW,
    TEXT,
    checked,
    each,
    either,
    instance,
    listed,
    mapping,
    optional,
)
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis, analyze_robot
from gcrules.mechanisms.description.discovery import find_robot
from gcrules.mechanisms.description.robot_file import load_robot, parse_robot
from gcrules.mechanisms.description.robot_spec import RobotText
from gcrules.rules.factorization import SECONDS
from gcrules.screws.pose import Pose, exact_float

if TYPE_CHECKING:
    from gcrules.mechanisms.kinematics.mechanism import Mechanism
    from gcrules.poses.limbs.report import RobotPose

__all__ = ["Robot"]

_NAMED = mapping("", ANYTHING)
_AT = either(
    "a pose: text, a mapping from coordinates to numbers, a Pose or three numbers",
    TEXT,
    instance("", Pose),
    _NAMED,
    ROW,
)
_ACTUATORS = either("amounts of the actuators: text, a mapping or numbers", TEXT, _NAMED, ROW)


@dataclass(frozen=True, repr=False)
class Robot(RobotText):
    """A robot that can be analysed; made by `Robot.load` or `Robot.parse`."""

    @classmethod
    @checked("gc.Robot.load", name=FILE, plugins=listed("names of folders", FILE, alone=True))
    def load(cls, name: str | PathLike[str], *, plugins: Iterable[str | PathLike[str]] = ()) -> Robot:
        """The robot of this id, or of a robot file; `plugins` are further folders of plugins.

        Raises InputError for an unknown id or one that two plugins bring, FileError with all faults of the file.
        """
        found = find_robot(name, plugins)
        return cls._of(load_robot(found.path, found.owner))

    @classmethod
    @checked("gc.Robot.parse", text=TEXT, filename=TEXT)
    def parse(cls, text: str, filename: str = "<input>") -> Robot:
        """The robot that the text of a robot file describes. Raises FileError with all its faults."""
        return cls._of(parse_robot(text, filename))

    @classmethod
    def _of(cls, text: RobotText) -> Robot:
        return cls(**{f.name: getattr(text, f.name) for f in fields(text)})

    @checked("robot.analyze", search=DURATION)
    def analyze(self, *, search: float = SECONDS) -> RobotAnalysis:
        """When and why the robot is singular; `search` as for `gcrules.analyze`."""
        return analyze_robot(self, search=search)

    @checked("robot.pose", at=optional(_AT), actuators=optional(_ACTUATORS))
    def pose(
        self,
        at: Any = None,
        *,
        actuators: str | Mapping[str, float] | Sequence[float] | None = None,
        threshold: Any = "0.5 deg",
    ) -> RobotPose:
        """The numbers in the configuration with this pose or with these amounts of the actuators; at home without both.

        `at` is text as for `gcrules pose` ("x y z; euler zyx a b c deg"), or as many coordinates as the platform has
        freedoms: "z=0.2, roll=5deg, pitch=0deg", or a mapping with angles in radians. `actuators` are text as
        "q1=0.1, q2=5deg", a mapping, or all of them in the order of the file. All are differences from home, in its
        unit of length; the platform turns about the centroid of the limbs' ends on it. Raises InputError for what makes
        no sense, and where the robot does not assemble, with how far it comes.
        """
        from gcrules.poses.limbs.pose_report import posed  # numpy, for numbers only

        return posed(self._mechanism, lambda: self._analysis, at, actuators, threshold=threshold)

    @checked("robot.at", degrees=FLAG, coordinates=each(either("a number", NUMBER, TEXT)))
    def at(self, *, degrees: bool = False, threshold: Any = "0.5 deg", **coordinates: float) -> RobotPose:
        """The numbers in the pose with these coordinates: `.at(z=0.2, roll=5, pitch=0, degrees=True)`; see `pose`."""
        lengths = ("x", "y", "z")
        scale = math.pi / 180 if degrees else 1
        given = {n: v if n in lengths else exact_float(v, n) * scale for n, v in coordinates.items()}
        return self.pose(given, threshold=threshold)

    @checked("robot.poses", ats=listed("a sequence of poses", optional(_AT)))
    def poses(self, ats: Iterable[Any], *, threshold: Any = "0.5 deg") -> tuple[RobotPose, ...]:
        """The numbers in each of these poses, which are as for `pose`."""
        return tuple(self.pose(at, threshold=threshold) for at in ats)

    @checked("robot.singular", towards=optional(_AT), actuators=optional(_ACTUATORS))
    def singular(
        self,
        towards: Any = None,
        *,
        actuators: str | Mapping[str, float] | Sequence[float] | None = None,
        threshold: Any = "0.5 deg",
    ) -> RobotPose | None:
        """The first singular configuration that is found on the straight way in these coordinates from home, or None.

        Arguments and errors as for `pose`. A search at samples: what it does not find may be there all the same.
        """
        from gcrules.poses.limbs.pose_report import first_singular_pose  # numpy, for numbers only

        return first_singular_pose(self._mechanism, lambda: self._analysis, towards, actuators, threshold=threshold)

    def home_remark(self, analysis: RobotAnalysis | None = None) -> str:
        """That home is singular, or nearly so, with cause and motion; nothing of a regular home, of none, or of one
        that cannot be moved. The `analysis` is made where it is not given.
        """
        from gcrules.poses.limbs.pose_report import posed  # numpy, for numbers only
        from gcrules.poses.limbs.remark import remark

        if self.home is None:
            return ""
        try:
            return remark(posed(self._mechanism, lambda: analysis or self._analysis, None, None))
        except InputError:
            return ""

    @cached_property
    def _mechanism(self) -> Mechanism:
        from gcrules.mechanisms.kinematics.mechanism import mechanism

        return mechanism(self)

    @cached_property
    def _analysis(self) -> RobotAnalysis:
        return self.analyze()
