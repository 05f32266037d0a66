"""What is proved of whole ranges of poses around the pose on show: how much is free, what is not, and the picture."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from typing import Any

from gcrules.apps.studio.accounts import account_view
from gcrules.apps.studio.moving import amounts_at
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.where_views import BoxesAnswer
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.whereabouts import coordinates_at
from gcrules.core.budget import report
from gcrules.core.deferred import deferred
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.boxes.box_map import boxes_done
from gcrules.poses.boxes.task import box_task, within_boxes
from gcrules.poses.methods import Methods, method
from gcrules.views.results.box_map import decided, leaves_nothing, parts, seen

__all__ = ["boxes_view"]

picture = deferred("gcrules.views.plots.box_plot:picture")  # matplotlib, an extra of the installation


def boxes_view(
    subject: Subject, over: Sequence[str], pose: PoseJson, margin: float, limits: str | None, boxes: int
) -> BoxesAnswer:
    """A map of so many boxes at most over the ranges, the other coordinates as they are at the pose. Raises InputError
    where there is none.
    """
    report("proving boxes")
    m = subject.mechanism
    rest = method(_REST, m, "a map of whole boxes")(over, pose)
    found = boxes_done(box_task(m, over, rest, limits or None, margin, *within_boxes(len(over), boxes)))
    report("drawing the boxes")
    return {
        **account_view(found),
        "decided": found.summary.decided,
        "so_much": decided(found),
        "shares": [{"kind": kind, "share": share, "words": words} for kind, share, words in parts(found)],  # type: ignore[typeddict-item]  # kinds are those of boxes
        "picture": "" if leaves_nothing(found) else _drawn(found),
        "seen": seen(found),
    }


def _drawn(found: Any) -> str:
    try:
        return b64encode(picture(found, "svg")).decode()
    except ImportError:
        return ""


def _rest_of_limbs(m: Limbs, over: Sequence[str], pose: PoseJson) -> dict[str, float]:
    names = [words.split()[0] for words in over if words.split()]
    if not amounts_at(m, pose):
        return {}
    now = coordinates_at(m, pose, free_coordinates(m.linkage, names))
    return {n: v for n, v in now.items() if n not in names}


_REST: Methods[Any] = {SixLegs: lambda m, over, pose: exact_pose(pose), Limbs: _rest_of_limbs}
"""What the pose says of the coordinates that are no ranges."""
