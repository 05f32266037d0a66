r"""Numbers at a pose of any mechanism, and the first singular pose on a way; each by the method for its kind.

>>> here = pose("3-rps", "z=0.2, roll=5deg, pitch=0deg")
>>> here.verdict, round(here.margin, 3), [round(v, 3) for v in here.actuator_values.values()]
('regular', 0.591, [0.18, 0.256, 0.101])
>>> pose("octahedral", "z=0.2, roll=5deg").verdict
'regular'
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method, on_six_legs
from gcrules.poses.numbers.many import PoseNumbers
from gcrules.poses.numbers.pose_arguments import is_many, known_accuracy, known_length, one_pose
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.pose_report import numbers_of_legs, report_of_legs
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import DEFAULT, Threshold, threshold_of

if TYPE_CHECKING:
    from gcrules.poses.limbs.report import RobotPose

__all__ = ["pose", "singular"]

Answer: TypeAlias = "PoseReport | PoseNumbers | RobotPose | tuple[RobotPose, ...]"

report_of_limbs = deferred("gcrules.poses.limbs.pose_report:report_of_limbs")
first_singular_pose = deferred("gcrules.poses.limbs.pose_report:first_singular_pose")
path_of_legs = deferred("gcrules.poses.path_report:path_of_legs")


def pose(
    source: Source,
    at: Any = None,
    *,
    actuators: Any = None,
    quaternion: Any = None,
    rotation_vector: Any = None,
    euler: tuple[str, Any] | None = None,
    degrees: bool = False,
    about: str | Sequence[Any] = "centroid",
    threshold: str | Threshold = DEFAULT.text,
    accuracy: str | float | None = None,
    nearest: bool = True,
    length: str | float | None = None,
    plugins: Folders = (),
) -> PoseReport | PoseNumbers | RobotPose | tuple[RobotPose, ...]:
    """How close a mechanism is to a singularity at one pose, or at N poses.

    `source` is what `load` takes, with coordinates; the answer for a platform is a `PoseReport` or, at N poses,
    `PoseNumbers` (arrays), for a robot of joints a `RobotPose` or a tuple of them. `at` is text as for `gcrules pose
    --at` ("z=5, roll=10deg", "0 0 5; euler zyx 20 0 10 deg"), a mapping from coordinates to numbers, a translation of
    three numbers, or N of these: a list or an array (N, 3). The turn beside it is one of `quaternion` (w, x, y, z),
    `rotation_vector`, `euler` = ("zyx", angles), each one row or N rows. Angles that are numbers are in radians unless
    `degrees`. All are from the pose of the file; the platform turns `about` the "centroid" of its joints, the file's
    "origin", or a point. A platform with fewer than six freedoms takes as many coordinates as it has; or its
    `actuators`: text as "q1=0.1, q2=5deg", a mapping, or all of them in the order of the file.

    `threshold` is an angle or, for platforms, a length ("2 deg", "5 mm"), `accuracy` a length up to which the joints'
    places are known; with it a robot whose limbs are six legs is taken as a platform. The search for the `nearest`
    singular poses takes a second or two; it is left out with False, and at N poses. `length` is the characteristic
    length of the actuators' condition number ("200 mm"), the mechanism's own size if none is given.

    Raises InputError for what is no pose, for degenerate robots, and where the robot does not assemble.
    """
    found = mechanism(source, about=about, plugins=plugins)
    if accuracy is not None:
        found = on_six_legs(found, "the accuracy of the joints")
    turns = {"quaternion": quaternion, "rotation_vector": rotation_vector, "euler": euler}
    chosen = None if length is None else known_length(length, found.unit)
    answer = method(_POSE, found, "a pose")(at, actuators, turns, degrees, threshold, accuracy, nearest)
    return answer if chosen is None else _with_length(answer, chosen)


def _with_length(answer: Answer, length: float) -> Answer:
    """With a characteristic length that was chosen. Raises InputError for arrays of numbers, which have no Jacobian."""
    if isinstance(answer, tuple):
        return tuple(replace(one, jacobian=replace(one.jacobian, chosen_length=length)) for one in answer)
    if isinstance(answer, PoseNumbers):
        raise InputError("a characteristic length, and many poses of a platform", hint="ask for one pose")
    return replace(answer, jacobian=replace(answer.jacobian, chosen_length=length))


def singular(
    source: Source,
    towards: Any = None,
    *,
    actuators: Any = None,
    degrees: bool = False,
    about: str | Sequence[Any] = "centroid",
    threshold: str | Threshold = DEFAULT.text,
    plugins: Folders = (),
) -> PoseReport | RobotPose | None:
    """The first singular pose on the straight way from the pose of the file `towards` another, or None.

    Arguments and errors as for `pose`. For a platform none is missed: the superbracket along the way is an exact
    polynomial. For a robot of joints None means that it is proved that nothing on the way is singular; where that is
    not decided, LimitReached is raised, and a pose that is found says in its notes what is proved of the way before it.
    """
    found = mechanism(source, about=about, plugins=plugins)
    return method(_SINGULAR, found, "the first singular pose")(towards, actuators, degrees, threshold)


# --- platforms on six legs -----------------------------------------------------------------------------------------


def _at_legs(
    m: SixLegs,
    at: Any,
    actuators: Any,
    turns: Mapping[str, Any],
    degrees: bool,
    threshold: str | Threshold,
    accuracy: str | float | None,
    nearest: bool,
) -> PoseReport | PoseNumbers:
    _no_actuators(actuators)
    limit = threshold_of(threshold, m.unit)
    known = known_accuracy(accuracy, m.rig)
    if limit.length is not None and accuracy is not None and known:
        raise InputError(
            f"the threshold {limit.text} is a length: it takes the joints' places as exact, and cannot be combined"
            " with an accuracy",
            hint="give the threshold as an angle, for example 0.5deg, or leave the accuracy out",
        )
    one = one_pose(at, turns, degrees, m.unit)
    if one is None:
        return numbers_of_legs(m, at, turns, degrees, limit, known)
    return report_of_legs(m, one, threshold=limit, accuracy=known, nearest=nearest)


def _first_of_legs(
    m: SixLegs, towards: Any, actuators: Any, degrees: bool, threshold: str | Threshold
) -> PoseReport | None:
    """The first zero of the exact polynomial along the straight way: none is missed."""
    _no_actuators(actuators)
    end = None if towards is None else one_pose(towards, {}, degrees, m.unit)
    if end is None:
        raise InputError("no direction is given in which to look", hint='give the end of the way: "z=1, roll=0deg"')
    limit = threshold_of(threshold, m.unit)
    way = path_of_legs(m, [Pose(), end], samples=1)
    if not way.zeros and not way.stretches:
        return None
    first = Pose() if way.stretches else way.zeros[0].pose  # a stretch is all of the way
    return report_of_legs(m, first, threshold=limit, nearest=False)


def _no_actuators(actuators: Any) -> None:
    if actuators is not None:
        raise InputError("actuators are for robots described by their joints", hint="give a pose")


# --- robots of joints ----------------------------------------------------------------------------------------------


def _of_joints(
    m: Limbs,
    at: Any,
    actuators: Any,
    turns: Mapping[str, Any],
    degrees: bool,
    threshold: str | Threshold,
    accuracy: str | float | None,
    nearest: bool,
) -> RobotPose | tuple[RobotPose, ...]:
    beside = {kind: turn for kind, turn in turns.items() if turn is not None}
    if not is_many(at, beside) or not np.iterable(at):
        asked = one_pose(at, turns, degrees, m.unit) if beside else at
        found: RobotPose = report_of_limbs(m, asked, actuators, degrees=degrees, threshold=threshold, nearest=nearest)
        return found
    if beside:
        raise InputError("many poses, and a turn as well", hint="give poses that contain their turns")
    if actuators is not None:
        raise InputError("many poses and actuators at once", hint="give one of them; the other one follows")
    every = at.tolist() if isinstance(at, np.ndarray) else at
    return tuple(report_of_limbs(m, one, None, degrees=degrees, threshold=threshold) for one in every)


def _first_of_joints(
    m: Limbs, towards: Any, actuators: Any, degrees: bool, threshold: str | Threshold
) -> RobotPose | None:
    found: RobotPose | None = first_singular_pose(m, towards, actuators, degrees=degrees, threshold=threshold)
    return found


_POSE: Methods[Answer] = {SixLegs: _at_legs, Limbs: _of_joints}
_SINGULAR: Methods[PoseReport | RobotPose | None] = {
    SixLegs: _first_of_legs,
    Limbs: _first_of_joints,
}
"""The method for each kind of mechanism."""
