"""What the server tells the page of a structure, and of faults.

Coordinates are (x, y, z) in the unit of the study, z up.
"""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from gcrules.apps.studio.protocol.requests import SourceJson
from gcrules.core.shapes import OneOf
from gcrules.views.report.stage_ids import STAGE_IDS
from gcrules.views.scene_data import EntityView, LegEnds, LimbView, RecipeView, Vec3

__all__ = [
    "AccountView",
    "Axis",
    "BracketView",
    "CertificateView",
    "ConditionView",
    "DriveView",
    "EntitiesItem",
    "EntryView",
    "FactItem",
    "FaultView",
    "FormulaItem",
    "Gallery",
    "GalleryItem",
    "Hello",
    "Item",
    "MeasureView",
    "ModelView",
    "Monomial",
    "MonomialsItem",
    "OrdersCount",
    "OrdersItem",
    "PartView",
    "Piece",
    "Place",
    "RobotView",
    "ShapeGroup",
    "ShapeRow",
    "ShapeView",
    "StageId",
    "StageView",
    "StepView",
    "StepsItem",
    "Study",
    "TextItem",
    "Theorem",
]


class Place(TypedDict):
    """Where in a text that was sent: offsets in characters of JavaScript from its start."""

    start: int
    end: int
    line: int
    column: int


class FaultView(TypedDict):
    """A fault in words."""

    kind: Literal["input", "limit", "superseded", "cancelled", "fault"]
    message: str
    hint: NotRequired[str]
    place: NotRequired[Place]
    more: NotRequired[list[FaultView]]
    """Further faults of the same text (files tell all faults at once)."""


class Hello(TypedDict):
    version: str
    instance: str
    """Changes when the server is another process."""
    opened: SourceJson | None
    """What the command line named: opened by a page that holds nothing else."""
    shared: bool
    """Whether Python shares the pose of what it has opened: the page follows it (`follow`), and tells it (`show`)."""
    guide: bool
    """Whether the guide is served below `guide/`."""


class GalleryItem(TypedDict):
    id: str
    title: str
    detail: str
    """A few words: the legs, the mobility."""
    group: str
    statement: str
    words: str
    """More words by which it is found."""
    familiar: int | None
    """The place among the cards that a newcomer knows; null for all others."""
    svg: str
    """A drawing, trusted (made by the server)."""
    source: SourceJson


class Theorem(TypedDict):
    """A script for the bench."""

    title: str
    text: str


class Gallery(TypedDict):
    classes: list[GalleryItem]
    robots: list[GalleryItem]
    examples: list[GalleryItem]
    theorems: list[Theorem]


class Piece(TypedDict):
    """A piece of a formula that stays on one line, with the points and entities in it."""

    tex: str
    points: list[str]
    brackets: list[list[str]]


class BracketView(TypedDict):
    points: list[str]
    tex: str


class Monomial(TypedDict):
    sign: Literal[1, -1]
    coefficient: str
    brackets: list[BracketView]


class OrdersCount(TypedDict):
    terms: int
    orders: int


class StepView(TypedDict):
    rule: str
    why: str
    before: list[Piece]
    after: list[Piece]


class TextItem(TypedDict):
    kind: Literal["text"]
    text: str


class FactItem(TypedDict):
    kind: Literal["fact"]
    key: str
    value: str


class AccountView(TypedDict):
    """The answer in a sentence, and what it consists of, with how sure it is."""

    verdict: str
    facts: list[FactItem]


class FormulaItem(TypedDict):
    kind: Literal["formula"]
    left: list[Piece]
    right: list[Piece]


class MonomialsItem(TypedDict):
    kind: Literal["monomials"]
    monomials: list[Monomial]


class OrdersItem(TypedDict):
    kind: Literal["orders"]
    tried: int
    counts: list[OrdersCount]
    best: str


class EntitiesItem(TypedDict):
    kind: Literal["entities"]
    entities: list[str]


class StepsItem(TypedDict):
    kind: Literal["steps"]
    steps: list[StepView]


Item = TextItem | FactItem | FormulaItem | MonomialsItem | OrdersItem | EntitiesItem | StepsItem


StageId = Annotated[str, OneOf(STAGE_IDS)]


class StageView(TypedDict):
    id: StageId
    title: str
    why: str
    """What is done and why, for a non-expert."""
    more: list[str]
    """The theory, in a few paragraphs of text."""
    items: list[Item]


class MeasureView(TypedDict):
    name: str
    meaning: str
    unit: str


class Axis(TypedDict):
    name: str
    unit: str
    low: float
    high: float
    step: float


class CertificateView(TypedDict):
    method: str
    detail: str


class ConditionView(TypedDict):
    kind: str
    left: list[Piece]
    """The left and the right side of the identity, one piece for each monomial or factor."""
    right: list[Piece]
    text: str
    cofactor: str
    statement: str
    certificate: CertificateView


class PartView(TypedDict):
    text: str
    tex: str
    kind: str
    statement: str


class RobotView(TypedDict):
    """A robot with limbs: what Fig. 1 of the paper shows side by side."""

    mobility: int
    statement: str
    """When it is singular, in its own words."""
    figure: NotRequired[str]
    """SVG: the robot with its wrenches, and beside it the lines that stand for them, at home."""
    limbs: list[LimbView]
    parts: list[PartView]


class DriveView(TypedDict):
    """An actuator, the joint of the model that it is, and what it reaches from home ("", where there is no limit)."""

    name: str
    joint: str
    limits: str


class ModelView(AccountView):
    """How a model was read as a robot."""

    drives: list[DriveView]


class EntryView(TypedDict):
    id: str
    name: str


class ShapeRow(TypedDict):
    name: str
    at: Vec3 | None
    """Where it is in the file; null where that follows from others."""


class ShapeGroup(TypedDict):
    title: str
    sort: Literal["point", "direction"]
    axes: list[str]
    rows: list[ShapeRow]


class ShapeView(TypedDict):
    """The dimensions as they are changed, all of them at home."""

    groups: list[ShapeGroup]
    bars: list[LegEnds]
    """What a plan joins by lines."""


class Study(TypedDict):
    """Everything about the structure that does not change with the pose."""

    title: str
    note: str
    kind: Literal["platform", "robot"]
    legs: list[LegEnds]
    base: list[str]
    platform: list[str]
    points: dict[str, Vec3]
    """Coordinates at the file's own pose."""
    unit: str
    shape: ShapeView
    limits: str
    """What its file says that legs or actuators reach, as written."""
    invented: bool
    """The coordinates are a sample shape, none were given."""
    about: Vec3
    """Centre of the platform's turns."""
    size: float
    """A length to scale sliders and the camera by."""
    axes: list[Axis]
    """What the pose consists of: six coordinates of a platform; the actuators of a robot with limbs."""
    freedoms: list[Axis]
    """Of a robot with limbs: coordinates of its platform that are independent at home."""
    ranges: list[Axis]
    """Coordinates of its pose, then its actuators, over which it can be mapped, with ranges to begin with."""
    wholes: list[Axis]
    """Coordinates of its pose over which a map of whole boxes can go, with ranges to begin with."""
    measures: list[MeasureView]
    """What the bands of such a map can be, the margin first."""
    loci: list[list[str]]
    """Pairs of coordinates of the map over which the singular poses may have a formula."""
    no_locus: str
    """Why they have none over any coordinates; "" where they may have one."""
    entry: EntryView | None
    """The class of the catalog."""
    schematic: str
    """SVG of the legs as a graph. Elements carry data-point="a" and data-leg="ab"."""
    stages: list[StageView]
    entities: list[EntityView]
    recipe: RecipeView | None
    """How what is constructed follows from the joints of a platform that moves, for poses that are drawn in passing."""
    condition: ConditionView
    readings: list[ConditionView]
    robot: RobotView | None
    model: ModelView | None
    """What was made of the model of links and joints that was opened; null for other files."""
