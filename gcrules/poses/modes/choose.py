r"""A robot or a platform in a mode that is named: the same one with another home.

>>> from gcrules.mechanisms.load import load
>>> in_mode(load("delta"), "+-+").title
'Delta robot with rods, working mode +-+'
>>> in_mode(load("delta"), "assembly 2").title
'Delta robot with rods, assembly mode 2'
>>> in_mode(load("3-rps"), "home").title
'3-RPS robot'
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Loaded
from gcrules.mechanisms.mechanism import mechanism
from gcrules.mechanisms.modes.working_modes import at_places, choices_of, in_working_mode, reached_at
from gcrules.mechanisms.platform_analysis import with_platform
from gcrules.mechanisms.robot import Robot
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.modes.modes import assembly_modes
from gcrules.poses.modes.report import AssemblyMode
from gcrules.poses.operation_modes.operation_modes import operation_modes
from gcrules.screws.study import matrix_of, shift_of

__all__ = ["in_mode"]

_NUMBERED = re.compile(r"(assembly|operation)(?: mode)?\s+(\d{1,6})")


def in_mode(loaded: Loaded, name: str) -> Loaded:
    """What was loaded, with its home in the mode of this name: a working mode, "+-+" or in numbers "1.3.1", of a robot
    of joints; "assembly 3", one of the poses that have the actuators of home, by its number in `assembly_modes`; or
    "operation 2", the pose that witnesses one of a robot's `operation_modes`.

    Raises InputError for a name that is none of its modes, which names some, and for legs without coordinates.
    """
    numbered = _NUMBERED.fullmatch(name.strip().lower())
    if numbered is not None:
        return _KINDS[numbered[1]](loaded, int(numbered[2]))
    if isinstance(loaded, RobotAnalysis):
        return _analysed_anew(loaded, _in_working_mode(loaded.robot, name))
    if not isinstance(loaded, Robot):
        raise InputError(
            "legs between two points have only one way to hold the platform, and so one working mode",
            hint='working modes are those of robots that are described by their joints, such as delta; "assembly 2" is'
            " an assembly mode",
        )
    return _in_working_mode(loaded, name)


def _in_working_mode(robot: Robot, name: str) -> Robot:
    choices = choices_of(robot)
    return in_working_mode(choices, choices.mode(name))


def _analysed_anew(before: RobotAnalysis, robot: Robot) -> RobotAnalysis:
    return before if robot is before.robot else analyze_robot(robot)


def _in_assembly_mode(loaded: Loaded, number: int) -> Loaded:
    found = assembly_modes(loaded)
    mode = next((one for one in found.modes if one.number == number), None)
    if mode is None:
        several = len(found.modes) > 1
        some = f"it has assembly modes 1 to {len(found.modes)}" if several else "that of home is the only one"
        raise InputError(f"there is no assembly mode {number} with the actuators of home: {some}", hint=_LISTS)
    if mode.given:
        return loaded
    m = mechanism(loaded)
    words = f"assembly mode {number}"
    if isinstance(m, Limbs):
        robot = robot_in_mode(m, mode, words)
        return _analysed_anew(loaded, robot) if isinstance(loaded, RobotAnalysis) else robot
    assert isinstance(m, SixLegs)
    platform = _moved_platform(m, mode, words)
    return with_platform(loaded, platform) if isinstance(loaded, Analysis) else platform


def _in_operation_mode(loaded: Loaded, number: int) -> Loaded:
    robot = loaded.robot if isinstance(loaded, RobotAnalysis) else loaded
    if not isinstance(robot, Robot):
        raise InputError("operation modes are those of robots of joints", hint="six legs allow all poses: one mode")
    modes = operation_modes(robot).modes
    mode = next((one for one in modes if one.number == number), None)
    if mode is None:
        raise InputError(
            f"{robot.id} has no operation mode {number}: "
            + (f"its modes are 1 to {len(modes)}" if len(modes) > 1 else "it has one, that of home"),
            hint="`gcrules modes --operation` lists them",
        )
    if mode.home:
        return loaded
    if mode.witness is None:
        raise InputError(f"no pose of operation mode {number} of {robot.id} is known that has short coordinates")
    m = Limbs.of(robot).linkage
    there = reached_at(m, _motion(mode.witness, m))
    moved = at_places(m, there.values, f"operation mode {number}", driven=True)
    return _analysed_anew(loaded, moved) if isinstance(loaded, RobotAnalysis) else moved


def _motion(pose: Sequence[Fraction], m: Linkage) -> Floats:
    """The motion (4, 4) from home of Study parameters in the frame of the file."""
    square = sum((c * c for c in pose[:4]), Fraction(0))
    found: Floats = np.eye(4)
    for k, (row, shift) in enumerate(zip(matrix_of(pose), shift_of(pose), strict=True)):
        away = sum((r * o for r, o in zip(row, m.origin, strict=True)), Fraction(0)) / square - m.origin[k]
        found[k, :3], found[k, 3] = [float(c / square) for c in row], float(shift / square + away)
    return found


_KINDS: Mapping[str, Callable[[Loaded, int], Loaded]] = {
    "assembly": _in_assembly_mode,
    "operation": _in_operation_mode,
}

_LISTS = "`gcrules modes` lists them, with what is proved of each"


def robot_in_mode(m: Limbs, mode: AssemblyMode, words: str) -> Robot:
    """The robot with its home in an assembly mode; `words` name it in the title. Raises InputError where the relations
    of its file do not hold there.
    """
    assert isinstance(mode.report, RobotPose)
    return at_places(m.linkage, {n: np.array(p) for n, p in mode.report.points.items()}, words)


def _moved_platform(m: SixLegs, mode: AssemblyMode, words: str) -> Platform:
    """The platform with its joints where they are in that pose."""
    exact = m.rig.exact(mode.pose)
    points = {n: _finite(exact[n]) if n in exact else p for n, p in m.platform.points.items()}
    return replace(m.platform, points=points, title=f"{m.platform.title or 'platform'}, {words}")


def _finite(place: tuple[Fraction, ...]) -> tuple[Fraction, Fraction, Fraction]:
    x, y, z = place[:3]
    return x, y, z
