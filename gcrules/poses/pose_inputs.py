r"""What numbers begin with: the analysis of the robot that a user gives, and the robot as it moves."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike
from typing import Any

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform, load_platform
from gcrules.mechanisms.moving_platform import Rig, rig
from gcrules.mechanisms.platform_analysis import analyze
from gcrules.poses.numbers.pose_arguments import centre_of

__all__ = ["Given", "analysed", "moving_robot"]

Given = Platform | Analysis | str | PathLike[str]
"""A platform with coordinates, its analysis, or the name of its geometry file."""


def analysed(robot: Given) -> Analysis:
    """The analysis of what a user gives. Raises FileError with all faults of a file."""
    if isinstance(robot, Analysis):
        return robot
    return analyze(robot if isinstance(robot, Platform) else load_platform(robot))


def moving_robot(robot: Given, about: str | Sequence[Any]) -> tuple[Analysis, Rig]:
    """The analysis, and the robot whose platform turns `about` the "origin" of its file, the "centroid" of the
    platform's joints, or a point. Raises InputError for legs without coordinates and for degenerate robots.
    """
    analysis = analysed(robot)
    if analysis.platform is None:
        raise InputError("the analysis is of legs without coordinates", hint="analyze a platform (load_platform)")
    return analysis, rig(analysis.structure, analysis.platform, centre_of(about))
