"""What the server tells the page of a structure: the shapes of `studio-ui/src/protocol.ts`, name by name (a test
compares them). What it tells of a pose, of manual mode, of the bench and of files stands in `answer_views`.

Coordinates are (x, y, z) in the unit of the study, z up; quaternions have the scalar first.
"""

from __future__ import annotations

from typing import Literal, NotRequired, TypedDict

from gcrules.views.robots.limb_data import JointView, LimbView, LineView, Vec3

__all__ = [
    "Axis",
    "BracketView",
    "CertificateView",
    "ClassView",
    "ConditionView",
    "EntitiesItem",
    "EntityView",
    "FactItem",
    "FaultView",
    "FormulaItem",
    "Gallery",
    "GalleryItem",
    "Hello",
    "Item",
    "JointView",
    "LimbView",
    "LineView",
    "Monomial",
    "MonomialsItem",
    "OrdersCount",
    "OrdersItem",
    "PartView",
    "Piece",
    "Place",
    "PoseJson",
    "RobotView",
    "SourceJson",
    "StageView",
    "StepView",
    "StepsItem",
    "Study",
    "TextItem",
    "Vec3",
]


class Place(TypedDict):
    start: int
    end: int
    line: int
    column: int


class FaultView(TypedDict):
    kind: Literal["input", "limit", "superseded", "cancelled", "fault"]
    message: str
    hint: NotRequired[str]
    place: NotRequired[Place]
    more: NotRequired[list[FaultView]]


class Hello(TypedDict):
    version: str
    instance: str
    opened: SourceJson | None


SourceJson = dict[str, str]


class PoseJson(TypedDict):
    translation: list[float]
    quaternion: list[float]
    coordinates: NotRequired[list[float]]


class GalleryItem(TypedDict):
    id: str
    title: str
    detail: str
    group: str
    statement: str
    svg: str
    source: SourceJson


class Gallery(TypedDict):
    classes: list[GalleryItem]
    robots: list[GalleryItem]
    examples: list[GalleryItem]


class Piece(TypedDict):
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


class StageView(TypedDict):
    id: str
    title: str
    why: str
    more: list[str]
    items: list[Item]


class Axis(TypedDict):
    name: str
    unit: str
    low: float
    high: float
    step: float


class EntityView(TypedDict):
    id: str
    kind: str
    points: list[str]
    label: str
    colour: int


class CertificateView(TypedDict):
    method: str
    detail: str


class ConditionView(TypedDict):
    kind: str
    left: list[Piece]
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
    mobility: int
    figure: NotRequired[str]
    limbs: list[LimbView]
    parts: list[PartView]


class ClassView(TypedDict):
    id: str
    name: str


Study = TypedDict(
    "Study",
    {
        "title": str,
        "note": str,
        "kind": Literal["platform", "robot"],
        "legs": list[list[str]],
        "base": list[str],
        "platform": list[str],
        "points": dict[str, Vec3],
        "unit": str,
        "invented": bool,
        "about": Vec3,
        "size": float,
        "axes": list[Axis],
        "class": ClassView | None,
        "schematic": str,
        "stages": list[StageView],
        "entities": list[EntityView],
        "condition": ConditionView,
        "readings": list[ConditionView],
        "robot": RobotView | None,
    },
)
