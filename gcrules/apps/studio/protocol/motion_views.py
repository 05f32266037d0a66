"""What the server tells the page of a path and of a map, the same for every kind of mechanism."""

from __future__ import annotations

from typing import Annotated, TypedDict

from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.study_views import Axis, FactItem
from gcrules.core.shapes import OneOf
from gcrules.views.scene_data import Verdict

__all__ = [
    "CellStatus",
    "CurveView",
    "DetourView",
    "FrameView",
    "HereAnswer",
    "MapAnswer",
    "PathAnswer",
    "PathPlaceView",
    "PathSampleView",
    "PathStretchView",
    "PlacedPose",
    "PlanOutcome",
    "SurfaceAnswer",
    "WaypointsAnswer",
]


class FrameView(TypedDict):
    """Where the axes are in a picture, as parts of its width and of its height from above."""

    left: float
    right: float
    top: float
    bottom: float


class PathSampleView(TypedDict):
    parameter: float
    margin: float
    pose: PoseJson | None
    """null where it is not known that the sliders lead to this configuration from home."""
    platform: PoseJson | None
    """Where the platform is then, from home, turned about `about` of the study: of a platform on six legs, its pose."""


class PathPlaceView(TypedDict):
    """A singular place on a path, with what happens there, why, and what is gained, in sentences."""

    parameter: float
    exactly: str
    """The parameter as a fraction; "" where it is none."""
    at: str
    """The pose, as `gcrules pose --at` takes it."""
    words: list[str]
    sure: str
    pose: PoseJson | None


class PathStretchView(TypedDict):
    start: float
    end: float
    singular: bool
    """Every pose is singular; else it is not decided whether one is."""
    words: list[str]


PlanOutcome = Annotated[str, OneOf(("way", "none", "undecided"))]


class DetourView(TypedDict):
    """What came of looking for a way around singular poses; where there is none the path is the straight one."""

    outcome: PlanOutcome
    words: str
    poses: list[str]
    """Those that the way goes straight through, as `gcrules path --pose` takes them."""


class PathAnswer(TypedDict):
    verdict: Verdict
    reason: str
    svg: str
    frame: FrameView
    end: float
    """The parameter of the last pose; that of the first is 0."""
    samples: list[PathSampleView]
    places: list[PathPlaceView]
    more: int
    """Places that are left out."""
    stretches: list[PathStretchView]
    detour: DetourView | None
    facts: list[FactItem]


class WaypointsAnswer(TypedDict):
    poses: list[PoseJson]
    table: str
    """The same poses as `gcrules path --poses` reads them."""
    notes: list[str]


CellStatus = Annotated[str, OneOf(("free", "crossed", "undecided", "outside"))]


class CurveView(TypedDict):
    """Singular poses in the coordinates of the axes, within the limits throughout (`reached`) or nowhere."""

    points: list[list[float]]
    reached: bool


class MapAnswer(TypedDict):
    """A map over two coordinates. Arrays run over the first axis, then over the second."""

    axes: list[Axis]
    curves: list[CurveView]
    margin: list[list[float | None]]
    """σ at the nodes; null where the robot does not get."""
    index: list[list[float | None]]
    """The measure at the nodes, where it is another one than the margin; null where it is infinite."""
    status: list[list[CellStatus]]
    """Of the cells between them."""
    fixed: str
    """What the coordinates are that no axis shows; empty where there are none."""
    guarantee: str
    statement: str
    facts: list[FactItem]


class SurfaceAnswer(TypedDict):
    """The singular surface over x, y and z: how far the platform is from home where it is singular."""

    vertices: list[float]
    """x, y, z of each corner in turn, in the unit of lengths."""
    faces: list[int]
    """Three corners each, by number."""
    reached: list[bool]
    """Which corners keep to the limits."""
    nodes: list[int]
    """How many poses there are along each coordinate."""
    free: int
    """Cells that are proved free of singular poses, of so many `cells`."""
    cells: int
    guarantee: str
    resolution: str
    facts: list[FactItem]
    held: dict[str, float]
    """Other freedoms of a robot with limbs, at which this holds: in radians or in its unit. Of a platform on six legs
    it holds at the turn of its pose.
    """


class HereAnswer(TypedDict):
    """Where a pose is in a map: its coordinates in the units of the axes, and what the others are."""

    at: list[float]
    fixed: str


class PlacedPose(TypedDict):
    pose: PoseJson
