r"""A robot in a mode that is named: the same robot with another home.

>>> from gcrules.mechanisms.load import load
>>> in_mode(load("delta"), "+-+")
<Robot delta: 3-R*4S, mobility 3>
>>> in_mode(load("delta"), "+-+").title
'Delta robot with rods, working mode +-+'
>>> in_mode(load("3-rps"), "home").title
'3-RPS robot'
"""

from __future__ import annotations

from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.load import Loaded
from gcrules.mechanisms.modes.working_modes import choices_of, in_working_mode
from gcrules.mechanisms.robot import Robot

__all__ = ["in_mode"]


def in_mode(loaded: Loaded, name: str) -> Loaded:
    """What was loaded, with its home in the working mode of this name ("+-+", or "1.3.1" in numbers).

    Raises InputError for a name that is none of its modes, which names some, and for what has no limbs of joints.
    """
    if isinstance(loaded, RobotAnalysis):
        robot = _in_mode(loaded.robot, name)
        return loaded if robot is loaded.robot else analyze_robot(robot)
    if not isinstance(loaded, Robot):
        raise InputError(
            "the mode of a robot without joints: legs between two points have one way to hold the platform",
            hint="working modes are those of robots that are described by their joints, such as delta",
        )
    return _in_mode(loaded, name)


def _in_mode(robot: Robot, name: str) -> Robot:
    choices = choices_of(robot)
    return in_working_mode(choices, choices.mode(name))
