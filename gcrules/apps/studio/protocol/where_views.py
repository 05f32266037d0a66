"""What the server tells the page of where the robot can go: assembly modes, aspects, free regions."""

from __future__ import annotations

from typing import Literal, TypedDict

from gcrules.apps.studio.protocol.answer_views import Saved
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.study_views import AccountView
from gcrules.views.scene_data import Verdict

__all__ = [
    "AspectSetView",
    "AspectsAnswer",
    "AssembliesAnswer",
    "AssemblyModeView",
    "BoxesAnswer",
    "CertificateAnswer",
    "CertificateFile",
    "CertifiedPlaceView",
    "FreeAnswer",
    "RangeView",
    "ShareView",
]


class AssemblyModeView(TypedDict):
    number: int
    given: bool
    """It is the pose that was asked about."""
    verdict: Verdict
    margin: float
    signs: str
    at: str
    """The pose, from that of the file."""
    sure: str
    """What is proved of it."""
    svg: str
    pose: PoseJson | None
    """null where the actuators do not lead there: the robot is opened in this `mode` instead."""
    mode: str | None


class AssembliesAnswer(AccountView):
    modes: list[AssemblyModeView]


class AspectSetView(TypedDict):
    """Poses of one aspect: how many, with which signs, the assembly modes among them, and the one farthest from being
    singular.
    """

    name: str
    signs: str
    poses: int
    modes: list[int]
    at: str
    margin: float
    pose: PoseJson | None
    """null where the sliders do not lead to it."""


class AspectsAnswer(AccountView):
    least: int
    most: int
    sets: list[AspectSetView]
    changes: list[str]
    """Which assembly modes share an aspect, in sentences."""


class RangeView(TypedDict):
    """What a coordinate may be, both ends rounded to the inside."""

    name: str
    low: str
    high: str
    unit: str


class FreeAnswer(AccountView):
    ranges: list[RangeView]


class ShareView(TypedDict):
    """A part of the volume, from 0 to 1, of which the same is known."""

    kind: Literal["free", "other", "outside", "crossed", "undecided"]
    share: float
    words: str


class BoxesAnswer(AccountView):
    decided: float
    """The share of the volume that is proved to be free, or not to be reached."""
    so_much: str
    """The same in a sentence."""
    shares: list[ShareView]
    picture: str
    """SVG in base64; empty where matplotlib is missing, or nothing is left to be seen."""
    seen: str
    """What it shows, in words."""


class CertifiedPlaceView(TypedDict):
    """A pose that is singular, or has a margin below the one asked for; else the one with the smallest margin that was
    seen.
    """

    kind: Literal["singular", "below", "least"]
    words: str
    """Its coordinates over which the range goes."""
    margin: float
    causes: list[str]
    pose: PoseJson | None
    """null where the sliders do not lead there."""
    short: bool
    """They end just short of it."""


class CertificateAnswer(BoxesAnswer):
    """Whether the whole range is free, with the file that says so."""

    answer: Literal["free", "outside", "singular", "below", "undecided"]
    bound: float | None
    """What the margin is at least in all boxes that are free, proved."""
    place: CertifiedPlaceView | None
    file: Saved
    check: str
    """How it is checked again."""


class CertificateFile(TypedDict):
    """The file of an answer that another program checks."""

    file: Saved
    check: str
    """How it is checked again."""
