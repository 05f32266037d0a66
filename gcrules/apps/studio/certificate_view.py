"""Whether whole ranges of poses are free of singular ones: the answer, the pose that matters most, and the file."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from typing import Literal

from gcrules.apps.studio.boxes_view import range_view, rest_at
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.where_views import CertificateAnswer, CertifiedPlaceView
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.whereabouts import near_coordinates, pose_json
from gcrules.core.budget import report
from gcrules.core.files import file_name
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.certificates.asked import asked
from gcrules.poses.certificates.certificate import Certificate
from gcrules.poses.certificates.certify import certified
from gcrules.screws.pose_text import pose_of
from gcrules.views.results.certificate import check, decided, parts, place_text, seen

__all__ = ["certificate_of", "certificate_view"]

_TIME = 240.0  # s, after which the answer tells what is decided


def certificate_view(subject: Subject, found: Certificate) -> CertificateAnswer:
    """A certificate as the page is told, with its file."""
    return {
        **range_view(found, parts(found), found.decided, decided(found), seen(found), drawn=True),
        "answer": found.verdict,  # type: ignore[typeddict-item]  # those of certificates
        "bound": found.bound,
        "place": _place(subject, found),
        "file": {
            "name": file_name(f"{subject.title} certificate", "json.gz"),
            "mime": "application/gzip",
            "data": b64encode(found.to_bytes(packed=True)).decode(),
            "binary": True,
        },
        "check": check(found),
    }


@kept
def certificate_of(
    subject: Subject,
    over: Sequence[str],
    pose: PoseJson,
    margin: float,
    limits: str | None,
    boxes: int,
    *,
    cone: str | None,
    tilt: str | None,
) -> Certificate:
    """A certificate of so many boxes at most over the ranges, the other coordinates as they are at the pose. Raises
    InputError for what makes no sense, and where something has no closed form.
    """
    report("proving boxes")
    m = subject.mechanism
    question = asked(m, over, rest_at(m, over, pose), limits or None, cone or None, tilt or None, margin)
    return certified(question, _TIME, boxes)


def _place(subject: Subject, c: Certificate) -> CertifiedPlaceView | None:
    """A pose that is not free, or the one with the smallest margin that was seen."""
    if c.bad is not None:
        kind = "singular" if c.bad.ends else "below"
        return _view(subject, c, kind, c.bad.place, c.bad.margin, c.bad.causes)  # type: ignore[arg-type]  # a kind
    if c.least is None or c.place is None:
        return None
    return _view(subject, c, "least", c.place, c.least)


def _view(
    subject: Subject,
    c: Certificate,
    kind: Literal["singular", "below", "least"],
    place: tuple[float, ...],
    margin: float,
    causes: tuple[str, ...] = (),
) -> CertifiedPlaceView:
    pose, short = _posed(subject, c.coordinates(place))
    return {
        "kind": kind,
        "words": place_text(c, place),
        "margin": margin,
        "causes": list(causes),
        "pose": pose,
        "short": short,
    }


def _posed(subject: Subject, at: dict[str, float]) -> tuple[PoseJson | None, bool]:
    """The pose for the page, and whether the sliders of a robot end short of it."""
    m = subject.mechanism
    if not isinstance(m, Limbs):
        return pose_json(pose_of(at)), False
    report("setting the actuators")
    return near_coordinates(m, at) or (None, False)
