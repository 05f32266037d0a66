"""What is proved of whole ranges of poses around the pose on show: how much is free, what is not, and the picture."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterable, Sequence
from typing import Any

from gcrules.apps.studio.accounts import account_view
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.moving import amounts_at
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.where_views import BoxesAnswer
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.whereabouts import coordinates_at
from gcrules.core.budget import report
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.boxes.box_map import boxes_done
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.boxes.task import box_task, within_boxes
from gcrules.poses.certificates.certificate import Certificate
from gcrules.poses.methods import Methods, method
from gcrules.views.forms import shown
from gcrules.views.results.box_map import decided, leaves_nothing, parts, seen
from gcrules.views.results.box_shares import Share

__all__ = ["boxes_of", "boxes_view", "range_view", "rest_at"]


def boxes_view(found: BoxMap) -> BoxesAnswer:
    """A map of boxes as the page is told."""
    share, drawn = found.summary.decided, not leaves_nothing(found)
    return range_view(found, parts(found), share, decided(found), seen(found), drawn=drawn)


@kept
def boxes_of(
    subject: Subject, over: Sequence[str], pose: PoseJson, margin: float, limits: str | None, boxes: int
) -> BoxMap:
    """A map of so many boxes at most over the ranges, the other coordinates as they are at the pose. Raises InputError
    where there is none.
    """
    report("proving boxes")
    m = subject.mechanism
    return boxes_done(
        box_task(m, over, rest_at(m, over, pose), limits or None, margin, *within_boxes(len(over), boxes))
    )


def range_view(
    found: BoxMap | Certificate, shares: Iterable[Share], share: float, so_much: str, seen: str, *, drawn: bool
) -> BoxesAnswer:
    """What maps and certificates show alike: which `share` is decided, and which part of the volume is what."""
    report("drawing the boxes")
    svg = shown(found, "svg") if drawn else None
    return {
        **account_view(found),
        "decided": share,
        "so_much": so_much,
        "shares": [{"kind": kind, "share": part, "words": words} for kind, part, words in shares],  # type: ignore[typeddict-item]  # kinds are those of boxes
        "picture": b64encode(svg.encode()).decode() if svg else "",
        "seen": seen,
    }


def rest_at(m: Mechanism, over: Sequence[str], pose: PoseJson) -> Any:
    """What the pose says of the coordinates that are no ranges."""
    return method(_REST, m, "a map of whole boxes")(over, pose)


def _rest_of_limbs(m: Limbs, over: Sequence[str], pose: PoseJson) -> dict[str, float]:
    names = [words.split()[0] for words in over if words.split()]
    if not amounts_at(m, pose):
        return {}
    now = coordinates_at(m, pose, free_coordinates(m.linkage, names))
    return {n: v for n, v in now.items() if n not in names}


_REST: Methods[Any] = {SixLegs: lambda m, over, pose: exact_pose(pose), Limbs: _rest_of_limbs}
