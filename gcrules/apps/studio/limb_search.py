"""Singular poses around a pose of a robot with limbs, for the page."""

from __future__ import annotations

from math import degrees as to_degrees
from math import radians

import numpy as np

from gcrules.apps.studio.moving import configuration
from gcrules.apps.studio.protocol.answer_views import Nearest, SingularPoseView
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.core.budget import report
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import actuators_target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.around import Heading, SingularAlong, actuator_values, begun_at, first_along, headings
from gcrules.poses.limbs.pose_report import report_at
from gcrules.screws.threshold import DEFAULT, degrees
from gcrules.screws.verdict import SOLVED

__all__ = ["first_around"]

_SHORT = 0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2
"""Parts of the way by which the sliders may stop short of a singular pose: there the actuators themselves come to a
stop, and the closer they are, the worse they tell the pose."""

_NO_PROOF = "one coordinate of the platform at a time was searched; this is no proof that nothing singular lies nearer"


def first_around(limbs: Limbs, pose: PoseJson) -> Nearest:
    """The first singular poses along the coordinates of the platform, the closest one first, with what was searched in
    words. Raises InputError where the robot does not assemble at the pose.
    """
    if configuration(limbs, pose).margin <= SOLVED:
        return {"found": [], "note": "The robot is singular at this pose: move it away to search from there."}
    m = limbs.linkage
    given = pose.get("coordinates") or [0.0] * len(m.actuators)
    now = [radians(v) if a.angle else float(v) for a, v in zip(m.actuators, given, strict=True)]
    at = begun_at(m, solve(m, actuators_target(m, now)).configuration if any(now) else m.home)
    met: list[SingularAlong] = []
    stops: list[str] = []
    every = tuple(headings(at))
    for way in every:
        report(f"searching along {way}")
        try:
            one = first_along(at, limbs.analysis, way)
        except InputError:
            stops.append(str(way))
            continue
        met += [one] if one else []
    views: list[SingularPoseView] = []
    lost: list[str] = []
    for one in sorted(met, key=lambda one: one.apart):
        report(f"setting the actuators along {one.way}")
        view = _view(limbs, at, one, now, pose)
        if view:
            views.append(view)
        else:
            lost.append(str(one.way))
    return {"found": views, "note": _note(views, every, stops, lost)}


def _view(limbs: Limbs, at: Linkage, one: SingularAlong, now: list[float], pose: PoseJson) -> SingularPoseView | None:
    """What was met, with the actuators that take the robot there; None where they do not."""
    there = report_at(at, limbs.analysis, one.solution, DEFAULT)
    for short in _SHORT:
        try:
            target = one.before(short) if short else one.solution.configuration
            amounts = [a + b for a, b in zip(now, actuator_values(at, target), strict=True)]
            given = [to_degrees(v) if a.angle else v for a, v in zip(at.actuators, amounts, strict=True)]
            goal: PoseJson = {**pose, "coordinates": given}
            reached = configuration(limbs, goal)
        except InputError:
            continue
        if max(np.abs(np.array(reached.points[n]) - target.values[n]).max() for n in reached.points) < 0.01 * at.size:
            break
    else:
        return None
    unit = "deg" if one.way.angle else limbs.unit
    shown = degrees(one.distance) if one.way.angle else f"{one.distance:.4g} {limbs.unit}".strip()
    words = f"{shown} along {one.way}, the platform's other free coordinates kept; {_NO_PROOF}"
    if short:
        words += f"; the actuators stop just short of it, at σ = {reached.margin:.1g}"
    return {
        "kind": f"along {one.way}",
        "distance": to_degrees(one.distance) if one.way.angle else one.distance,
        "unit": unit,
        "certified": False,
        "text": words,
        "pose": goal,
        "causes": list(there.causes),
    }


def _note(found: list[SingularPoseView], every: tuple[Heading, ...], stops: list[str], lost: list[str]) -> str:
    said = "Found" if found else "No singular pose was found"
    all_ways = listed([str(w) for w in every])
    words = f"{said} by a search along {all_ways}, up to 60° or 0.75 times the robot's size: {_NO_PROOF}."
    if stops:
        words += f" Along {listed(stops)} the robot does not assemble so far."
    if lost:
        words += f" There is a singular pose along {listed(lost)}, to which the sliders do not lead from home."
    return words
