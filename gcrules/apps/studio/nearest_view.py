"""The nearest singular poses, for the page."""

from __future__ import annotations

import math

from gcrules.apps.studio.limb_search import first_around
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.answer_views import Nearest, SingularPoseView
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.core.budget import report
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.poses.pose_report import report_of_legs
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import degrees

__all__ = ["nearest"]

_WORDS = {
    "translation": "the same orientation",
    "rotation": "turned about the centroid of the legs' platform ends",
    "combined": "shifted and turned",
}


def nearest(subject: Subject, pose: PoseJson, threshold: str | None) -> Nearest:
    """Those in translation, in rotation, in both; for a robot with limbs, those that a search finds around the pose.

    Raises InputError where the platform does not move.
    """
    return method(_NEAREST, subject.mechanism, "the search for the nearest singular poses")(pose, threshold)


def _of_legs(m: SixLegs, pose: PoseJson, threshold: str | None) -> Nearest:
    report("seeking the nearest singular poses")
    found = report_of_legs(m, exact_pose(pose), threshold=threshold_of(threshold, m.unit))
    return {"found": [_view(n, n.pose, m.unit) for n in found.nearest if n.pose is not None]}


_NEAREST: Methods[Nearest] = {SixLegs: _of_legs, Limbs: lambda m, pose, _: first_around(m, pose)}


def _view(n: NearestPose, pose: Pose, unit: str) -> SingularPoseView:
    angle = n.kind == "rotation"
    distance = math.degrees(n.distance) if angle else n.distance
    shown = degrees(n.distance) if angle else f"{n.distance:.4g} {unit}".strip()
    sure = "proved to be the nearest" if n.certified else "the nearest that was found"
    return {
        "kind": n.kind,
        "distance": distance,
        "unit": "deg" if angle else unit,
        "certified": n.certified,
        "text": f"{shown} away ({_WORDS[n.kind]}), {sure}",
        "pose": {"translation": [float(c) for c in pose.translation], "quaternion": list(pose.unit_quaternion)},
        "causes": list(n.causes),
    }
