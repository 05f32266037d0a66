"""The arguments of all methods. What a type is annotated with checks it; `docs/studio.md` says the limits."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NotRequired, TypedDict

from gcrules.apps.studio.protocol.checking import number, text, tuple_of
from gcrules.core.errors import InputError
from gcrules.core.shapes import EntryCount
from gcrules.screws.threshold import DEFAULT

__all__ = [
    "FARTHEST",
    "HOME",
    "LONGEST_FILE",
    "LONGEST_RULES",
    "MOST_BOXES",
    "MOST_COMMANDS",
    "MOST_COORDINATES",
    "MOST_LEGS",
    "MOST_POINTS",
    "MOST_RULES",
    "MOST_RULE_FILES",
    "MOST_WAYPOINTS",
    "THRESHOLD",
    "AlongArgs",
    "BenchArgs",
    "BoxesArgs",
    "CancelArgs",
    "CertifyArgs",
    "ClassSource",
    "CompleteArgs",
    "ComposeArgs",
    "ExampleSource",
    "FileSource",
    "FollowArgs",
    "Format",
    "FreeArgs",
    "HereArgs",
    "LegsSource",
    "LocusArgs",
    "ManualArgs",
    "MapArgs",
    "ModesArgs",
    "MoveArgs",
    "NoArgs",
    "OpenArgs",
    "PathArgs",
    "PlaceArgs",
    "PoseArgs",
    "PoseJson",
    "Quaternion",
    "ResizeArgs",
    "RobotSource",
    "RuleFile",
    "RulesArgs",
    "ScriptArgs",
    "ShowArgs",
    "Sketch",
    "SourceJson",
    "SurfaceArgs",
    "WaypointsArgs",
]

FARTHEST = 1e12
MOST_COORDINATES = 24
MOST_POINTS = 40
MOST_LEGS = 24
MOST_COMMANDS = 200
MOST_BOXES = 2_000_000
MOST_WAYPOINTS = 200
LONGEST_FILE = 400_000
LONGEST_RULES = 40_000
MOST_RULES = 200
MOST_RULE_FILES = 12
THRESHOLD = DEFAULT.text
"""Closer than this is close, where nothing else is asked for."""

_Name = Annotated[str, text(200)]
_Point = Annotated[str, text(40)]
_Coordinate = Annotated[float, number(-FARTHEST, FARTHEST)]
_Vector = Annotated[list[_Coordinate], EntryCount(3, 3)]
_Threshold = Annotated[str, text(40)]
_Range = Annotated[str, text(100)]
_Ranges = Annotated[list[_Range], EntryCount(2, 2)]


# --- what is studied -----------------------------------------------------------------------------------------------


class ClassSource(TypedDict):
    kind: Literal["class"]
    id: _Name


class LegsSource(TypedDict):
    kind: Literal["legs"]
    legs: Annotated[str, text(4_000)]


class ExampleSource(TypedDict):
    kind: Literal["example"]
    name: _Name


class RobotSource(TypedDict):
    kind: Literal["robot"]
    id: _Name
    mode: NotRequired[_Name]
    """A working mode, "+-+", or an assembly mode, "assembly 3": the robot's home in that mode."""


class FileSource(TypedDict):
    """The text of a platform file or of a robot file, told apart by its keys, or of a model."""

    kind: Literal["file"]
    text: Annotated[str, text(LONGEST_FILE)]
    name: _Name
    mode: NotRequired[_Name]
    """A working or an assembly mode, of a robot file."""


SourceJson = ClassSource | LegsSource | ExampleSource | RobotSource | FileSource


# --- where the platform is -----------------------------------------------------------------------------------------


def _rotation(value: Any, where: str) -> Any:
    found = tuple_of(*[number(-10, 10)] * 4)(value, where)
    if not 1e-6 < sum(c * c for c in found) < 100:
        raise InputError(f"{where} has no length", hint="a turn is a quaternion, scalar first")
    return found


Quaternion = Annotated[list[float], EntryCount(4, 4)]
"""Unit quaternion, scalar first."""


class PoseJson(TypedDict):
    """The platform's displacement from where the file puts it: turned about `about` of the study, then shifted."""

    translation: _Vector
    quaternion: Annotated[Quaternion, _rotation]
    coordinates: NotRequired[Annotated[list[_Coordinate], EntryCount(0, MOST_COORDINATES)]]
    """For robots with limbs: amounts of the actuators from home, in the sequence and in the units of `axes`."""


HOME: PoseJson = {"translation": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}


# --- a drawing -----------------------------------------------------------------------------------------------------


class Sketch(TypedDict):
    title: Annotated[str, text(200, empty=True)]
    points: Annotated[dict[_Point, _Vector], EntryCount(0, MOST_POINTS)]
    base: Annotated[list[_Point], EntryCount(0, MOST_POINTS)]
    platform: Annotated[list[_Point], EntryCount(0, MOST_POINTS)]
    legs: Annotated[list[Annotated[list[_Point], EntryCount(2, 2)]], EntryCount(0, MOST_LEGS)]


# --- arguments -----------------------------------------------------------------------------------------------------


class NoArgs(TypedDict):
    pass


class OpenArgs(TypedDict):
    source: SourceJson


class PoseArgs(TypedDict):
    source: SourceJson
    pose: PoseJson
    threshold: NotRequired[_Threshold]


class MoveArgs(TypedDict):
    """Where the `freedoms` of the study are to be, from home and in their units (`at`), or the platform (`to`): one
    with fewer freedoms follows as far as these go. The pose is the one near it now.
    """

    source: SourceJson
    pose: PoseJson
    at: NotRequired[Annotated[list[_Coordinate], EntryCount(1, 6)]]
    to: NotRequired[PoseJson]


class AlongArgs(TypedDict):
    source: SourceJson
    poses: Annotated[list[PoseJson], EntryCount(1, 2_000)]
    threshold: NotRequired[_Threshold]


class PathArgs(TypedDict):
    """From `start` (home without it) to `goal`, or to the pose that the text `to` names; straight from pose to pose
    `through` others, or on a way around singular poses.
    """

    source: SourceJson
    start: NotRequired[PoseJson]
    goal: PoseJson
    through: NotRequired[Annotated[list[PoseJson], EntryCount(0, MOST_WAYPOINTS)]]
    to: NotRequired[Annotated[str, text(400)]]
    way: NotRequired[Literal["straight", "around"]]
    threshold: NotRequired[_Threshold]


class WaypointsArgs(TypedDict):
    """Poses as a table of comma-separated values, or such a table as poses."""

    source: SourceJson
    poses: NotRequired[Annotated[list[PoseJson], EntryCount(1, MOST_WAYPOINTS)]]
    table: NotRequired[Annotated[str, text(LONGEST_FILE, empty=True)]]


class MapArgs(TypedDict):
    """Over two coordinates with their ranges ("x -1:1:21"), the others as they are at the pose. The bands of its
    picture are the `measure`, one of those of the study; the margin, where none is asked for.
    """

    source: SourceJson
    over: _Ranges
    pose: PoseJson
    threshold: NotRequired[_Threshold]
    measure: NotRequired[Annotated[str, text(20)]]


class ModesArgs(TypedDict):
    source: SourceJson
    threshold: NotRequired[_Threshold]


class FreeArgs(TypedDict):
    """The largest region of a shape around the pose."""

    source: SourceJson
    pose: PoseJson
    shape: Literal["box", "ball"]


class BoxesArgs(TypedDict):
    """Whole ranges of coordinates ("x -1:1"), the others as they are at the pose, in so many boxes at most. Free poses
    have the `margin`; `limits` are those of legs or actuators.
    """

    source: SourceJson
    over: Annotated[list[Annotated[str, text(100)]], EntryCount(1, 6)]
    pose: PoseJson
    margin: NotRequired[Annotated[float, number(0, 1)]]
    limits: NotRequired[Annotated[str, text(400)]]
    boxes: Annotated[int, number(1, MOST_BOXES, whole=True)]


class CertifyArgs(BoxesArgs):
    """The same ranges, to be certified: joints of rods keep to a `cone` ("40 deg", "base 30 deg, C1 40 deg"), the
    platform to a `tilt` ("40 deg").
    """

    cone: NotRequired[Annotated[str, text(400)]]
    tilt: NotRequired[Annotated[str, text(40)]]


class LocusArgs(TypedDict):
    """Over these coordinates, without them over the position, else over all; the others as they are at the pose."""

    source: SourceJson
    pose: PoseJson
    over: NotRequired[Annotated[list[_Point], EntryCount(1, 3)]]


class SurfaceArgs(TypedDict):
    """Over x, y and z with their ranges ("x -1:1:21"), the other coordinates as they are at the pose."""

    source: SourceJson
    over: Annotated[list[_Range], EntryCount(3, 3)]
    pose: PoseJson


class PlaceArgs(TypedDict):
    """The pose at a place of that map or of that surface, in the units of its axes."""

    source: SourceJson
    over: Annotated[list[_Range], EntryCount(2, 3)]
    pose: PoseJson
    place: Annotated[list[_Coordinate], EntryCount(2, 3)]


class HereArgs(TypedDict):
    """Where in a map over two coordinates the pose is."""

    source: SourceJson
    over: Annotated[list[_Range], EntryCount(2, 2)]
    pose: PoseJson


class ManualArgs(TypedDict):
    source: SourceJson
    commands: Annotated[list[Annotated[str, text(500)]], EntryCount(0, MOST_COMMANDS)]


class RuleFile(TypedDict):
    """A file of rules (`.gca`), or a catalog (`.yaml`), that the user has opened, as text; the rules, or classes, that
    are `off` are left out.
    """

    name: _Name
    text: Annotated[str, text(LONGEST_RULES, empty=True)]
    off: Annotated[list[_Name], EntryCount(0, MOST_RULES)]


_RuleFiles = Annotated[list[RuleFile], EntryCount(0, MOST_RULE_FILES)]


class RulesArgs(TypedDict):
    """Files of rules, to be checked."""

    files: _RuleFiles


class BenchArgs(TypedDict):
    text: Annotated[str, text(20_000, empty=True)]
    rules: NotRequired[_RuleFiles]
    """Rules that hold from the start, those that are wrong left out."""
    source: NotRequired[SourceJson]
    pose: NotRequired[PoseJson]


class ScriptArgs(TypedDict):
    """The text of the bench, to be saved as a script."""

    text: Annotated[str, text(20_000)]
    source: NotRequired[SourceJson]


class CompleteArgs(TypedDict):
    """The text of the bench up to the cursor."""

    text: Annotated[str, text(20_000, empty=True)]
    source: NotRequired[SourceJson]


class ComposeArgs(TypedDict):
    drawing: Sketch


Format = Literal["html", "latex", "svg", "png", "pdf", "json", "yaml", "proof", "coq", "c", "cpp", "py", "rs"]


class FollowArgs(TypedDict):
    """The pose that Python or another page brings after the one of this number; `page` is a name of the page's own."""

    page: Annotated[str, text(40)]
    after: Annotated[int, number(0, 2**53, whole=True)]


class ShowArgs(TypedDict):
    """The pose that a page has moved the robot to."""

    page: Annotated[str, text(40)]
    source: SourceJson
    pose: PoseJson


class ResizeArgs(TypedDict):
    """Other coordinates of a platform's points, as they are written ("" keeps one), and other limits of its legs."""

    source: SourceJson
    points: Annotated[
        dict[_Point, Annotated[list[Annotated[str, text(40, empty=True)]], EntryCount(3, 3)]],
        EntryCount(0, MOST_POINTS),
    ]
    limits: NotRequired[Annotated[str, text(400, empty=True)]]


class CancelArgs(TypedDict):
    target: Annotated[int, number(0, 2**53, whole=True)]
