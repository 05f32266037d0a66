"""Poses of the page as paths and maps take them, and back: for each kind of mechanism."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from math import radians
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.apps.studio.moving import amounts_at, displaced, displacement, posed, solved
from gcrules.apps.studio.protocol.motion_views import PlacedPose
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.coordinates import coordinates, wrapped
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import beside, check_target, free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target, actuators_target, written
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.around import actuator_values
from gcrules.poses.limbs.many import numbers_at
from gcrules.poses.limbs.pose_report import target_of
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import ANGLES, HOME, pose_of

__all__ = [
    "SHORT",
    "Reached",
    "all_reached",
    "at_coordinates",
    "at_home",
    "coordinates_at",
    "led",
    "moved_view",
    "near_coordinates",
    "pose_json",
    "poses_of_limbs",
    "reached",
    "solved_at",
]

SHORT = 0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2
"""Parts of the way by which the sliders may stop short of a singular pose: there the actuators themselves come to a
stop, and the closer they are, the worse they tell the pose."""

_NEAR = 1e-6  # radians, and parts of the robot's size
_LOST = 3


def at_home(pose: PoseJson) -> bool:
    """Whether it is home, of a platform or of a robot with limbs."""
    w, x, y, z = pose["quaternion"]
    return not any((*pose["translation"], x, y, z, *pose.get("coordinates", ()))) and bool(w)


def pose_json(pose: Pose) -> PoseJson:
    """The pose of a platform on six legs, for the page."""
    return {"translation": [float(c) for c in pose.translation], "quaternion": list(pose.unit_quaternion)}


def poses_of_limbs(
    limbs: Limbs, start: PoseJson | None, goal: PoseJson, to: str | None, through: Sequence[PoseJson] = ()
) -> list[Any]:
    """Poses for a path, which name the same coordinates: those of the text, else independent ones. Raises InputError
    where the robot does not assemble.
    """
    target = None if to in (None, HOME) else target_of(limbs.linkage, to, None)
    names = free_coordinates(limbs.linkage) if target is None else target.names
    last: Any = to if to is not None else coordinates_at(limbs, goal, names)
    whole = target is not None and target.whole is not None

    def named(pose: PoseJson) -> Any:
        found = coordinates_at(limbs, pose, names)
        return pose_of(found) if whole else found

    return [HOME if start is None else named(start), *map(named, through), last]


def solved_at(limbs: Limbs, pose: PoseJson) -> Configuration:
    """The configuration at a pose of the page. Raises InputError where the robot does not assemble."""
    return solved(limbs.linkage, tuple(amounts_at(limbs, pose))).configuration


def coordinates_at(limbs: Limbs, pose: PoseJson, names: Sequence[str]) -> dict[str, float]:
    """What these coordinates of the platform are there, from home, angles in radians."""
    found = coordinates(names, solved_at(limbs, pose).platform, limbs.linkage.centre)
    return dict(zip(names, found.tolist(), strict=True))


@dataclass(frozen=True)
class Reached:
    """A pose of the page, and where the platform is then, from home, turned about a point."""

    pose: PoseJson
    platform: PoseJson


def reached(
    limbs: Limbs, amounts: Sequence[float], names: Sequence[str], wanted: Any, about: Sequence[float]
) -> Reached | None:
    """The pose of the page with these amounts of the actuators, if from home they lead where the coordinates are as
    wanted; else None: another configuration has the same amounts, or the robot does not assemble on the way.
    """
    m, found = limbs.linkage, posed(limbs, amounts)
    try:
        motion = solved_at(limbs, found).platform
    except InputError:
        return None
    off = coordinates(names, motion, m.centre) - np.asarray(wanted)
    return Reached(found, displacement(m, motion, about)) if _is_near(limbs, names, off) else None


def all_reached(
    limbs: Limbs, amounts: Floats, names: Sequence[str], wanted: Floats, about: Sequence[float]
) -> list[Reached | None]:
    """The poses (N,) that `reached` gives for amounts (N, leading) and values (N, names): where the whole way of the
    actuators is proved many at once, else one after the other. After `_LOST` in a row to which they do not lead these
    are given up: as a rule they do not to the rest either, and trying takes long.
    """
    m = limbs.linkage
    motions, proved = np.zeros((len(wanted), 4, 4)), np.zeros(len(wanted), dtype=bool)
    with suppress(InputError):
        check_target(m, target := actuators_target(m, amounts[-1].tolist()))
        several = numbers_at(limbs, target, amounts, ("motions", "proved"))
        motions, proved = several["motions"], several["proved"]
    near = _is_near(limbs, names, coordinates(names, motions, m.centre) - wanted)
    found: list[Reached | None] = []
    lost = 0
    for k, given in enumerate(amounts):
        checkpoint()
        if proved[k]:
            found.append(Reached(posed(limbs, given), displacement(m, motions[k], about)) if near[k] else None)
        else:
            found.append(reached(limbs, given, names, wanted[k], about) if lost < _LOST else None)
        lost = 0 if found[-1] else lost + 1
    return found


def _is_near(limbs: Limbs, names: Sequence[str], off: Floats) -> NDArray[np.bool_]:
    """Whether coordinates that are `off` (..., names) are the same but for rounding, (...,)."""
    away = np.abs(wrapped(names, off)).max(axis=-1)
    return np.asarray(away <= _NEAR * max(1.0, limbs.linkage.size))


def at_coordinates(limbs: Limbs, names: Sequence[str], values: Any, driven: bool) -> PoseJson:
    """The pose of the page where coordinates, or actuators, are as given. Raises InputError where the sliders do not
    lead there.
    """
    m = limbs.linkage
    if driven:
        solve(m, actuators_target(m, list(values)))
        return posed(limbs, values)
    return led(limbs, solve(m, _target(names, values)).configuration, names, values)


def moved_view(subject: Subject, pose: PoseJson, at: Sequence[float] | None, to: PoseJson | None) -> PlacedPose:
    """The pose near another one where the free coordinates of the platform are as given, lengths and degrees from home,
    or as they are where the platform is displaced so. Raises InputError for platforms on six legs, whose pose says it,
    where the robot does not assemble, and where the sliders of its actuators do not lead there.
    """
    limbs = subject.limbs
    if limbs is None:
        raise InputError("the pose of a platform on six legs says where it is")
    m = limbs.linkage
    names = free_coordinates(m)
    if (at is None) == (to is None):
        raise InputError("either coordinates or a pose of the platform says where it is to be")
    if to is not None:
        values = coordinates(names, displaced(m, to, subject.about), m.centre).tolist()
    elif at is not None and len(at) == len(names):
        values = [radians(v) if n in ANGLES else v for n, v in zip(names, at, strict=True)]
    else:
        raise InputError(f"the platform has {len(names)} freedoms: {', '.join(names)}")
    there = beside(m, _target(names, values), solved_at(limbs, pose))
    return {"pose": led(limbs, there, names, values)}


def _target(names: Sequence[str], values: Any) -> Target:
    wanted = np.asarray(values, dtype=np.float64)
    return Target(tuple(names), wanted, text=written(dict(zip(names, wanted.tolist(), strict=True))))


def led(limbs: Limbs, there: Configuration, names: Sequence[str], values: Any) -> PoseJson:
    """The pose of the page in a configuration. Raises InputError where the sliders do not lead there."""
    m = limbs.linkage
    found = reached(limbs, actuator_values(m, there), names, values, m.centre.tolist())
    if found is None:
        raise InputError(
            "the robot gets to this place, but not by its sliders",
            hint="on the straight way of the actuators from home it meets a singular configuration first",
        )
    return found.pose


def near_coordinates(limbs: Limbs, at: Mapping[str, float]) -> tuple[PoseJson, bool] | None:
    """The pose of the page where the coordinates, from home, are as given; of a singular one, at which actuators may
    come to a stop, one just short of it on the way from home, and whether it is one. None where the sliders do not lead
    there.
    """
    for short in SHORT:
        with suppress(InputError):
            return at_coordinates(limbs, tuple(at), [c * (1 - short) for c in at.values()], driven=False), short > 0
    return None
