"""A path from one pose of the page to another: σ along it, every singular place, what is not decided."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from gcrules.apps.studio.items import fact
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.motion_views import (
    DetourView,
    PathAnswer,
    PathPlaceView,
    PathSampleView,
    PathStretchView,
)
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.apps.studio.whereabouts import Reached, all_reached, poses_of_limbs
from gcrules.core.budget import report
from gcrules.core.dataclass import dataclass
from gcrules.core.english import as_sentence
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.methods import Methods, method
from gcrules.poses.path_report import path_of
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.plan import plan_of
from gcrules.poses.plans.report import Plan
from gcrules.screws.pose import Pose
from gcrules.views.forms import shown
from gcrules.views.plots.path_plot import FRAME
from gcrules.views.results.path_account import PathAccount, PathPlace, PathStretch
from gcrules.views.results.plan import waypoint_text

__all__ = ["Way", "ends", "path_view", "way_of"]

_SHOWN = {PathReport: 100, RobotPath: 40}  # samples to which it can be moved; the loops of a robot are closed for each
_MOST = 100  # places that are listed

Found = PathReport | RobotPath
PosedAt = Callable[[list[int]], Sequence[Reached | None]]


@dataclass(frozen=True)
class Way:
    """A path; where a way around singular poses was looked for, the `plan` that came of it too."""

    path: PathReport | RobotPath
    plan: Plan | None = None


@kept
def way_of(
    subject: Subject,
    start: PoseJson | None,
    goal: PoseJson,
    to: str | None,
    limit: str | None,
    *,
    around: bool,
    through: Sequence[PoseJson] = (),
) -> Way:
    """The path from `start`, or home, to `goal`, or to the pose that the text says: straight from pose to pose
    `through` others, or on a way `around` singular poses if one is found.

    Raises InputError where there is no such path.
    """
    m = subject.mechanism
    poses = ends(m, start, goal, to, through)
    plan: Plan | None = None
    if around:
        report("looking for a way")
        plan = plan_of(m, poses[0], poses[-1])
        poses = list(plan.poses) or poses
    report("going along the path")
    return Way(path_of(m, poses, threshold=threshold_of(limit, m.unit)), plan)


def path_view(subject: Subject, found: Way) -> PathAnswer:
    """A path as the page is told, with poses along it to which it can be moved."""
    posed = method(_POSED, subject.mechanism, "a path")(found.path, subject.about)
    return _view(found.path, posed, None if found.plan is None else _detour(found.plan))


def ends(
    m: Mechanism, start: PoseJson | None, goal: PoseJson, to: str | None, through: Sequence[PoseJson] = ()
) -> list[Any]:
    """The poses of such a path, as paths and plans take them. Raises InputError likewise."""
    return method(_ENDS, m, "a path")(start, goal, to, through)


def _detour(found: Plan) -> DetourView:
    return {"outcome": found.outcome, "words": found.reason, "poses": [waypoint_text(p) for p in found.poses]}


def _ends_of_legs(
    _: SixLegs, start: PoseJson | None, goal: PoseJson, to: str | None, through: Sequence[PoseJson]
) -> list[Any]:
    first = Pose() if start is None else exact_pose(start)
    return [first, *map(exact_pose, through), exact_pose(goal) if to is None else to]


_ENDS: Methods[list[Any]] = {SixLegs: _ends_of_legs, Limbs: poses_of_limbs}
"""The poses of a path."""


def _posed_of_legs(_: SixLegs, r: PathReport, about: Sequence[float]) -> PosedAt:
    def at(k: int) -> Reached:
        pose: PoseJson = {"translation": r.translations[k].tolist(), "quaternion": r.quaternions[k].tolist()}
        return Reached(pose, pose)

    return lambda chosen: [at(k) for k in chosen]


def _posed_of_limbs(m: Limbs, r: RobotPath, about: Sequence[float]) -> PosedAt:
    lead = [r.actuators.index(a) for a in leading(m.linkage)]
    return lambda chosen: all_reached(m, r.actuator_values[chosen][:, lead], r.names, r.coordinates[chosen], about)


_POSED: Methods[PosedAt] = {SixLegs: _posed_of_legs, Limbs: _posed_of_limbs}
"""What tells the page's poses of samples of what was found."""


def _view(found: Found, posed: PosedAt, detour: DetourView | None) -> PathAnswer:
    a: PathAccount = shown(found, "account")
    margins = found.numbers.margin if isinstance(found, PathReport) else found.margins
    places = [p.parameter for p in a.places[:_MOST]]
    report("setting the robot along the path")
    chosen = _chosen(found.parameters, places, _SHOWN[type(found)])
    samples = [
        _sample(float(found.parameters[k]), float(margins[k]), there)
        for k, there in zip(chosen, posed(chosen), strict=True)
    ]
    poses = {s["parameter"]: s["pose"] for s in samples}
    left, right, top, bottom = FRAME
    return {
        "verdict": a.verdict,
        "reason": a.reason,
        "svg": shown(found, "svg"),
        "frame": {"left": left, "right": right, "top": top, "bottom": bottom},
        "end": float(found.parameters[-1]),
        "samples": samples,
        "places": [_place(p, poses.get(p.parameter)) for p in a.places[:_MOST]],
        "more": max(len(a.places) - _MOST, 0),
        "stretches": [_stretch(s) for s in a.stretches],
        "detour": detour,
        "facts": [fact(name, value) for name, value in a.facts],
    }


def _sample(parameter: float, margin: float, there: Reached | None) -> PathSampleView:
    pose, platform = (None, None) if there is None else (there.pose, there.platform)
    return {"parameter": parameter, "margin": margin, "pose": pose, "platform": platform}


def _chosen(parameters: Any, places: Sequence[float], number: int) -> list[int]:
    """About so many samples, evenly, and those at singular places."""
    even = np.linspace(0, len(parameters) - 1, min(len(parameters), number + 1)).round().astype(int)
    special = np.flatnonzero(np.isin(parameters, places))
    return [int(k) for k in np.union1d(even, special)]


def _place(p: PathPlace, pose: PoseJson | None) -> PathPlaceView:
    words = [as_sentence(p.kind), *p.causes, *p.motions]
    sure = as_sentence(p.sure)
    exactly = p.exactly.strip()
    return {"parameter": p.parameter, "exactly": exactly, "at": p.pose, "words": words, "sure": sure, "pose": pose}


def _stretch(s: PathStretch) -> PathStretchView:
    words = [as_sentence(s.words), *s.causes, *s.motions]
    return {"start": s.start, "end": s.end, "singular": s.singular, "words": words}
