"""The shapes of the plain data that a 3D view draws: a robot in a pose, and what is to be seen of its condition.

Coordinates are (x, y, z) in the unit of the robot, z up. `tools/studio_protocol.py` writes them for the viewer in
TypeScript, without `View` at the end of a name. Nothing heavy is loaded here.
"""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from gcrules.core.shapes import EntryCount, OneOf
from gcrules.screws.verdict import VERDICTS

__all__ = [
    "CarriedPlace",
    "CarriedSign",
    "CarriedSkeleton",
    "CarriedStroke",
    "ChainView",
    "Constructed",
    "Construction",
    "DerivedView",
    "DrawnJoint",
    "DriveView",
    "EntityKind",
    "EntityView",
    "JointSignView",
    "JointView",
    "LegEnds",
    "LimbView",
    "LineView",
    "LinkageView",
    "MotionView",
    "NamedLineView",
    "NamedPointView",
    "PlaneView",
    "RecipeLine",
    "RecipePoint",
    "RecipeView",
    "SceneData",
    "SkeletonView",
    "SpanView",
    "StrokeView",
    "Terms",
    "Thresholds",
    "Vec3",
    "Verdict",
]

Vec3 = Annotated[list[float], EntryCount(3, 3)]
LegEnds = Annotated[list[str], EntryCount(2, 2)]
Verdict = Annotated[str, OneOf(VERDICTS)]
EntityKind = Annotated[str, OneOf(("tetrahedron", "plane", "line", "point"))]
Construction = str | list["Construction"]
"""A joint, or a list of "join" or "meet" and two constructions or more."""


class EntityView(TypedDict):
    id: str
    kind: EntityKind
    points: list[str]
    label: str
    """As conditions and sentences have it: Abd."""
    starred: str
    """As the steps that find it have it, stars telling repeated points apart: A*bd."""
    colour: int
    """Number of its colour, counted from 0; six colours repeat."""


class NamedPointView(TypedDict):
    kind: Literal["point"]
    label: str
    at: Vec3
    entities: list[str]


class NamedLineView(TypedDict):
    kind: Literal["line"]
    label: str
    at: Vec3
    direction: Vec3
    entities: list[str]
    colour: NotRequired[int]


Constructed = NamedPointView | NamedLineView
"""Points and lines that the condition constructs: the common point of planes, the line p …"""


class PlaneView(TypedDict):
    """The plane normal · p = offset."""

    label: str
    normal: Vec3
    offset: float
    through: NotRequired[list[Vec3]]
    """Places around which a part of it is drawn."""
    colour: NotRequired[int]
    points: NotRequired[list[str]]
    """Points and directions that it is drawn through."""


class MotionView(TypedDict):
    """What the platform can do although its actuators are locked."""

    axis: Vec3
    through: Vec3
    pitch: float | None
    """Advance for each radian; null where it is a translation."""
    text: str


class JointView(TypedDict):
    kind: str
    actuated: bool
    point: Vec3 | None
    axes: list[Vec3]


class LineView(TypedDict):
    text: str
    wrench: Literal["force", "couple"]
    point: Vec3 | None
    direction: Vec3


class LimbView(TypedDict):
    name: str
    colour: int
    wrenches: list[str]
    joints: list[JointView]
    lines: list[LineView]


class Thresholds(TypedDict):
    """What a page needs to decide as the engine does; said once, by the engine."""

    close: float
    """Below this singularity margin a pose is close to singular."""
    rounding: float
    """Accuracy of coordinates in units of the robot's size; what it may do to the margin counts as 0."""
    digits: float
    """Accuracy of coordinates as floats, in units of the largest of them."""
    near: float
    """Planes and lines that miss a point by less than this share of the size are shown with it, marked as near."""
    met: float
    """Below this share they meet in it."""


class RecipeLine(TypedDict):
    label: str
    colour: int
    of: Construction


class RecipePoint(TypedDict):
    label: str
    of: list[Construction]
    entities: list[str]


class RecipeView(TypedDict):
    """How what changes with the pose follows from the joints, for pages that have no server."""

    lines: list[RecipeLine]
    points: list[RecipePoint]
    sign: Literal[1, -1]
    """−1 where the legs are turned round with respect to those that the user wrote."""
    thresholds: Thresholds
    size: float
    """The length of which `near` and `met` are shares."""


Terms = dict[str, float]
"""A sum of points or directions: name and factor."""


class ChainView(TypedDict):
    """A limb at home: elementary motions from the base to the platform."""

    screws: list[list[float]]
    """(ω; v) of each motion."""
    uses: list[int]
    """The coordinate that each motion takes."""
    signs: list[float]
    turns: list[bool]
    """Of each coordinate whether it is an angle."""
    end: Vec3
    ball: bool
    """Whether it ends in a ball joint that is not driven."""
    rank: int
    """Of its twists; `passive` that of those that are not driven."""
    passive: int
    applied: int
    """The dimension of its wrenches with locked actuators."""
    runs: list[list[int]]
    """Of a limb with bodies of its own its runs: their first motion, that after their last, the link on which they
    begin, and that by which an earlier run reaches the same body, −1 where there is none.
    """
    platform: int
    """The link that is the platform, of such a limb."""
    shares: list[list[int]]
    """With which sign each coordinate counts in the platform's twist, and in each loop of the limb's own."""


class SpanView(TypedDict):
    """A chain between two bodies, where limbs have loops of their own: its coordinates in its limb that are not driven,
    the rank of their twists, and the bodies, the platform being 0 and the base −1.
    """

    limb: int
    free: list[int]
    rank: int
    start: int
    end: int


class DriveView(TypedDict):
    """An actuator, with the places of its limb and of its coordinate there."""

    name: str
    text: str
    limb: int
    coordinate: int


class DrawnJoint(TypedDict):
    """The names of which the place and the axes of a joint are made; no place where there are none."""

    point: Terms
    axes: list[Terms]


class DerivedView(TypedDict):
    """The direction u × v of two `args`; of four, (P, u, Q, n), the point of the line through P along u in the plane
    through Q perpendicular to n.
    """

    name: str
    args: list[Terms]


class CarriedPlace(TypedDict):
    """What links carry: limb and link of each, the share with which it counts, and the place that it carries, at home.
    Shares of 1 and −1 make a direction.
    """

    links: list[list[int]]
    shares: list[float]
    at: list[Vec3]


class CarriedStroke(TypedDict):
    ends: list[CarriedPlace]
    look: str


class CarriedSign(TypedDict):
    kind: str
    actuated: bool
    at: CarriedPlace
    axes: list[CarriedPlace]


class CarriedSkeleton(TypedDict):
    """A skeleton whose parts are carried by links."""

    strokes: list[CarriedStroke]
    signs: list[CarriedSign]
    platform: list[CarriedPlace]
    base: list[CarriedPlace]


class LinkageView(TypedDict):
    """How a robot of joints moves by its actuators, for pages that have no server."""

    chains: list[ChainView]
    drives: list[DriveView]
    follows: list[list[int]]
    """Limbs and coordinates of actuators that follow from the drives, where there are more of them than freedoms."""
    rides: dict[str, list[list[int]]]
    """The limbs and links that carry a name."""
    points: dict[str, Vec3]
    """All points at home, and below all directions."""
    directions: dict[str, Vec3]
    derived: list[DerivedView]
    joints: list[list[DrawnJoint]]
    """Those of each of the `limbs` of the scene: a limb or, of one that has bodies of its own, one of its chains."""
    ends: list[int | None]
    """The places in `chains` of those that end on the platform."""
    rods: list[list[Terms]]
    """What is drawn of the limbs' own bodies, from one end to the other."""
    lines: list[list[LegEnds]]
    """The ends of the lines of each, as there."""
    bars: list[list[list[Terms]]]
    """The bars of each, from one end to the other, and rods between them."""
    spans: list[SpanView]
    """All chains between bodies, where limbs have loops of their own."""
    skeleton: CarriedSkeleton | None
    """What is drawn of it, where links carry it."""
    locked: list[list[int]]
    """Limbs and coordinates that stay at 0."""
    plane: bool
    centre: Vec3
    size: float
    close: float
    """Below this singularity margin a configuration is close to singular."""
    floor: float
    """Up to this margin it is singular."""


class StrokeView(TypedDict):
    ends: list[Vec3]
    look: str
    """A link, a bar (thinner), a rail or an axis."""


class JointSignView(TypedDict):
    """A joint where its sign stands, with unit vectors along its axes."""

    kind: str
    """That of the joint, "carriage" for a slide on a rail, "pin" for a hinge of a parallelogram."""
    actuated: bool
    at: Vec3
    axes: list[Vec3]


class SkeletonView(TypedDict):
    """Links, signs of joints and corners of the bodies of a robot of joints, as they are drawn on paper."""

    strokes: list[StrokeView]
    signs: list[JointSignView]
    platform: list[Vec3]
    base: list[Vec3]


class SceneData(TypedDict):
    """A robot in a pose, with its condition."""

    points: dict[str, Vec3]
    base: list[str]
    platform: list[str]
    legs: list[LegEnds]
    about: Vec3
    """Centre of the platform's turns."""
    size: float
    """A length that the camera, the balls and the handles are scaled by."""
    unit: str
    entities: list[EntityView]
    constructed: NotRequired[list[Constructed]]
    motion: NotRequired[MotionView | None]
    limbs: NotRequired[list[LimbView]]
    skeleton: NotRequired[SkeletonView | None]
    directions: NotRequired[dict[str, Vec3]]
    """Unit vectors of points at infinity, through which entities may go."""
    planes: NotRequired[list[PlaneView]]
    """Planes that are no entities."""
    recipe: NotRequired[RecipeView]
    linkage: NotRequired[LinkageView]
