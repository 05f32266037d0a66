"""Singular poses around a pose of a robot with limbs, for the page."""

from __future__ import annotations

from math import degrees as to_degrees

import numpy as np

from gcrules.apps.studio.moving import amounts_at, configuration, posed
from gcrules.apps.studio.protocol.answer_views import Nearest, SingularPoseView
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.whereabouts import SHORT
from gcrules.core.budget import report
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage, begun_at
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import actuators_target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.around import Heading, SingularAlong, actuator_values, first_along, headings, nearest_around
from gcrules.poses.limbs.pose_report import report_at
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.threshold import DEFAULT, degrees
from gcrules.screws.verdict import SOLVED

__all__ = ["first_around"]

_NO_PROOF = "a search, and no proof that nothing singular lies nearer"


def first_around(limbs: Limbs, pose: PoseJson) -> Nearest:
    """The first singular poses along the coordinates of the platform, the closest one first, with what was searched in
    words. Raises InputError where the robot does not assemble at the pose.
    """
    if configuration(limbs, pose).margin <= SOLVED:
        return {"found": [], "note": "The robot is singular at this pose: move it away to search from there."}
    m = limbs.linkage
    now = amounts_at(limbs, pose) or [0.0] * len(leading(m))
    at = begun_at(m, solve(m, actuators_target(m, now)).configuration if any(now) else m.home)
    one = nearest_around(at)
    met = [one] if one else []
    stops: list[str] = []
    every = tuple(headings(at))
    for way in every:
        report(f"searching along {way}")
        try:
            one = first_along(at, way)
        except InputError:
            stops.append(str(way))
            continue
        met += [one] if one else []
    views: list[SingularPoseView] = []
    lost: list[str] = []
    for one in sorted(met, key=lambda one: one.apart):
        report(f"setting the actuators {_kind(one)}")
        view = _view(limbs, at, one, now, pose)
        if view:
            views.append(view)
        else:
            lost.append(_kind(one))
    return {"found": views, "note": _note(views, every, stops, lost)}


def _view(limbs: Limbs, at: Linkage, one: SingularAlong, now: list[float], pose: PoseJson) -> SingularPoseView | None:
    """What was met, with the actuators that take the robot there; None where they do not."""
    there = report_at(at, limbs.analysis, one.solution, DEFAULT)
    for short in SHORT:
        try:
            target = one.before(short) if short else one.solution.configuration
            amounts = [a + b for a, b in zip(now, actuator_values(at, target), strict=True)]
            goal = posed(limbs, amounts)
            reached = configuration(limbs, goal)
        except InputError:
            continue
        if max(np.abs(np.array(reached.points[n]) - target.values[n]).max() for n in reached.points) < 0.01 * at.size:
            break
    else:
        return None
    angle = one.way is not None and one.way.angle
    unit = "deg" if angle else limbs.unit if one.way else ""
    shown = degrees(one.distance) if angle else f"{one.distance:.4g} {unit}".strip()
    if one.way is None:
        words = f"{_changes(one)}: {shown} in radians and parts of the robot's size; {_NO_PROOF}"
    else:
        words = f"{shown} along {one.way}, the platform's other free coordinates kept; {_NO_PROOF}"
    if short:
        words += f"; the actuators stop just short of it, at σ = {reached.margin:.1g}"
    return {
        "kind": _kind(one),
        "distance": to_degrees(one.distance) if angle else one.distance,
        "unit": unit,
        "certified": False,
        "text": words,
        "pose": goal,
        "causes": list(there.causes),
    }


def _kind(one: SingularAlong) -> str:
    return f"along {one.way}" if one.way else "in any direction"


def _changes(one: SingularAlong) -> str:
    """By how much the free coordinates change on a way."""
    target = one.course.target
    pairs = zip(target.names, target.values.tolist(), strict=True)
    return ", ".join(f"{n} {degrees(v) if n in ANGLES else f'{v:.4g}'}" for n, v in pairs)


def _note(found: list[SingularPoseView], every: tuple[Heading, ...], stops: list[str], lost: list[str]) -> str:
    said = "Found" if found else "No singular pose was found"
    all_ways = listed([str(w) for w in every])
    words = f"{said} by a search along {all_ways}, up to 60° or 0.75 times the robot's size, and in all directions at"
    words += " once: this does not prove that nothing singular lies nearer."
    if stops:
        words += f" Along {listed(stops)} the robot was not followed that far."
    if lost:
        words += f" There is a singular pose {listed(lost)}, to which the sliders do not lead from home."
    return words
