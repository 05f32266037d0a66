"""The nearest singular poses, for the page."""

from __future__ import annotations

import math

from gcrules.apps.studio.limb_search import first_around
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.answer_views import Nearest, SingularPoseView
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.core.budget import report as report_progress
from gcrules.core.errors import InputError
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.poses.pose_report import report
from gcrules.screws.guarantees import ROUNDING
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
    if subject.limbed:
        return first_around(subject, pose)
    moving, a = subject.moving, subject.analysis
    if moving is None or a is None:
        why = subject.why_not or "the nearest singular pose is sought for platforms on six legs"
        raise InputError(why)
    report_progress("seeking the nearest singular poses")
    limit = threshold_of(threshold, subject.unit)
    found = report(a, moving, exact_pose(pose), threshold=limit, accuracy=ROUNDING * moving.size)
    return {"found": [_view(n, n.pose, subject.unit) for n in found.nearest if n.pose is not None]}


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
