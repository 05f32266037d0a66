"""What the server tells the page of a pose, of manual mode, of the bench and of files: further shapes of
`studio-ui/src/protocol.ts`.
"""

from __future__ import annotations

from typing import Literal, NotRequired, TypedDict

from gcrules.apps.studio.views import ConditionView, EntityView, FaultView, LimbView, Monomial, Piece, PoseJson, Vec3

__all__ = [
    "Along",
    "Bench",
    "BenchResult",
    "Composed",
    "Constructed",
    "FormView",
    "Format",
    "FoundView",
    "HintView",
    "Manual",
    "MotionView",
    "Nearest",
    "Numbers",
    "PlaneView",
    "ReadingView",
    "RecordView",
    "Saved",
]


class ReadingView(TypedDict):
    part: str
    name: str
    meaning: str
    value: float | None
    unit: str
    why: str


class Constructed(TypedDict):
    kind: Literal["point", "line"]
    label: str
    at: Vec3
    direction: NotRequired[Vec3]
    entities: list[str]


class PlaneView(TypedDict):
    kind: Literal["plane"]
    label: str
    normal: Vec3
    offset: float


class MotionView(TypedDict):
    axis: Vec3
    through: Vec3
    pitch: float | None
    text: str


class Numbers(TypedDict):
    pose: PoseJson
    points: dict[str, Vec3]
    value: float
    closeness: float
    verdict: str
    reason: str
    causes: list[str]
    readings: list[ReadingView]
    constructed: list[Constructed]
    motion: MotionView | None
    stress: list[float]
    limbs: list[LimbView]
    notes: list[str]


class FoundView(TypedDict):
    kind: str
    distance: float
    unit: str
    certified: bool
    text: str
    pose: PoseJson
    causes: list[str]


class Nearest(TypedDict):
    found: list[FoundView]
    note: NotRequired[str]


class Along(TypedDict):
    closeness: list[float]
    value: list[float]
    verdicts: list[str]


class RecordView(TypedDict):
    command: str
    answer: str
    words: str
    monomial: int | None


class FormView(TypedDict):
    name: str
    order: str
    monomials: list[Monomial]


class HintView(TypedDict):
    command: str
    words: str


class Manual(TypedDict):
    history: list[RecordView]
    form: FormView
    entities: list[EntityView]
    left: list[str]
    hint: HintView | None
    counterexample: dict[str, Vec3] | None
    condition: ConditionView | None
    fault: FaultView | None


class BenchResult(TypedDict):
    start: int
    end: int
    name: str | None
    verdict: Literal["value", "proved", "refuted", "undecided", "done"]
    text: str
    pieces: list[Piece]
    step: int | None
    drawn: Constructed | PlaneView | None


class Bench(TypedDict):
    results: list[BenchResult]
    fault: FaultView | None


class Composed(TypedDict):
    text: str


Format = Literal["html", "latex", "svg", "png", "pdf", "json", "yaml"]


class Saved(TypedDict):
    name: str
    mime: str
    data: str
    binary: bool
