"""What the server tells the page of a pose, of manual mode, of the bench and of files."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from gcrules.apps.studio.protocol.requests import FileSource, PoseJson
from gcrules.apps.studio.protocol.study_views import ConditionView, FactItem, FaultView, Monomial, Piece
from gcrules.core.shapes import OneOf
from gcrules.views.scene_data import (
    Constructed,
    EntityView,
    LimbView,
    MotionView,
    PlaneView,
    SkeletonView,
    Vec3,
    Verdict,
)

__all__ = [
    "ActuatorView",
    "Along",
    "AppliedRule",
    "Bench",
    "BenchPart",
    "BenchResult",
    "Cancelled",
    "Completed",
    "CompletionView",
    "Composed",
    "DrawnPlane",
    "ExactPoint",
    "Followed",
    "FormView",
    "Headline",
    "HintView",
    "Manual",
    "ManualStep",
    "ModeView",
    "ModesAnswer",
    "Nearest",
    "Numbers",
    "ReadingView",
    "Repeated",
    "RepeatedFile",
    "Resized",
    "RuleOwner",
    "Saved",
    "Scripted",
    "Shown",
    "SignView",
    "SingularPoseView",
]


class ActuatorView(TypedDict):
    """A leg with its length, or an actuator with its amount from home, and what the file says that it reaches; at its
    unit rate, the others locked, the `speed` of the platform's centre and the `turn` of the platform, with units (""
    where there are none).
    """

    name: str
    value: float
    unit: str
    low: float | None
    high: float | None
    speed: str
    turn: str


class ModeView(TypedDict):
    """A working mode at home; its drives are from the home of the file."""

    name: str
    verdict: Verdict | None
    margin: float | None
    signs: str
    """Those of the condition's factors whose zeros are singularities."""
    svg: str
    """The robot at home in this mode; empty where it does not assemble."""
    drives: str


class ModesAnswer(TypedDict):
    modes: list[ModeView]
    number: int
    """How many there are; of very many only some are listed."""
    ways: list[str]
    """How many ways the limbs have to hold the platform."""


class ReadingView(TypedDict):
    part: str
    name: str
    meaning: str
    value: float | None
    unit: str
    why: str


class SignView(TypedDict):
    """A number that changes continuously with the pose and is 0 in singular poses only."""

    expression: str
    sign: int
    statement: str
    """What is singular where it is 0; "" for the determinant of the undriven joints' screws, which says no more."""


class Headline(TypedDict):
    """What is said first of a pose."""

    pose: PoseJson
    """The pose that this answers."""
    value: float
    """Superbracket over its scale: dimensionless, with the sign of the superbracket."""
    margin: float
    """The singularity margin σ: 0 at a singular pose, at most 1."""
    close: float | None
    """Below this margin the pose counts as close; null where the threshold is a length."""
    verdict: Verdict


class Numbers(Headline):
    freedoms: list[float]
    """Those of the study there, in their units."""
    platform: PoseJson | None
    """Where the platform of a robot with limbs is, from home; null for one on six legs, whose pose says it."""
    points: dict[str, Vec3]
    reason: str
    causes: list[str]
    readings: list[ReadingView]
    constructed: list[Constructed]
    motion: MotionView | None
    """Given near a singular pose."""
    stress: list[float]
    """Ratios of the forces in the legs that balance, near a singular pose."""
    limbs: list[LimbView]
    skeleton: SkeletonView | None
    """Of a robot with limbs."""
    directions: dict[str, Vec3]
    """Unit vectors of points at infinity, in this pose."""
    notes: list[str]
    actuators: list[ActuatorView]
    """None where there are no legs or joints with numbers."""
    jacobian: list[FactItem]
    signs: list[SignView]
    """Of the factors of the condition, and of the determinant of the undriven joints' screws: where one changes between
    two poses, every way between them is singular.
    """


class SingularPoseView(TypedDict):
    kind: str
    distance: float
    unit: str
    certified: bool
    text: str
    pose: PoseJson
    causes: list[str]


class Nearest(TypedDict):
    found: list[SingularPoseView]
    note: NotRequired[str]
    """Of a robot with limbs: what was searched, in words; the kinds are "along +z" …, the closest one stands first."""


class Along(TypedDict):
    margin: list[float]
    value: list[float]
    verdicts: list[Verdict]


class ManualStep(TypedDict):
    command: str
    answer: Annotated[str, OneOf(("confirmed", "refused", "possible", "done"))]
    words: str
    monomial: int | None


class FormView(TypedDict):
    name: str
    order: str
    monomials: list[Monomial]


class HintView(TypedDict):
    command: str
    words: str


class ExactPoint(TypedDict):
    at: Vec3
    exactly: list[str]
    """The same coordinates as fractions."""


class Manual(TypedDict):
    history: list[ManualStep]
    """The commands that were understood; the first faulty one stops the replay and is `fault`."""
    form: FormView
    entities: list[EntityView]
    left: list[str]
    hint: HintView | None
    counterexample: dict[str, ExactPoint] | None
    """Points of an exact counterexample, if the last proposal was refused by one."""
    condition: ConditionView | None
    fault: FaultView | None


class RepeatedFile(TypedDict):
    name: str
    text: str


class Repeated(TypedDict):
    shell: str
    python: str
    """Empty where no function of Python does it."""
    files: list[RepeatedFile]
    """What has to be saved first, since the lines name it."""


class DrawnPlane(PlaneView):
    kind: Literal["plane"]


class RuleOwner(TypedDict):
    """Who brought a rule: gcrules, a plugin, a file that the page has opened, or the text of the bench."""

    kind: Literal["gcrules", "plugin", "file", "text"]
    name: str
    """Of the plugin or file; "" for others."""
    line: int | None
    """In the file."""


class AppliedRule(TypedDict):
    id: str
    sentence: str
    owner: RuleOwner


class BenchResult(TypedDict):
    start: int
    """Offsets of the statement in the text."""
    end: int
    name: str | None
    command: str | None
    """The command of the prompt that was asked, if it is one."""
    verdict: Literal["value", "proved", "refuted", "undecided", "done"]
    text: str
    sentences: list[str]
    """Those with which an analysis opens."""
    way: bool
    """Whether rules have rewritten it in several steps, or in none."""
    tex: str
    """The whole answer in LaTeX; "" where it is none, or too long."""
    pieces: list[Piece]
    terms: int
    """How many pieces there are; of very many only the first are sent."""
    step: int | None
    drawn: Constructed | DrawnPlane | None
    """What can be drawn in 3D with the points of the study, at its pose."""
    applied: list[AppliedRule]
    """The rules that led to it, in their order."""
    repeat: Repeated | None
    """The lines that give this answer alone; null where they would be too long."""


class Bench(TypedDict):
    results: list[BenchResult]
    fault: FaultView | None


class BenchPart(TypedDict):
    """One result, as soon as it is there, and its place among all of them."""

    index: int
    result: BenchResult


class Scripted(TypedDict):
    text: str


class Completed(TypedDict):
    """What may stand at a place, in the place of the last `length` characters before it."""

    options: list[CompletionView]


class CompletionView(TypedDict):
    text: str
    length: int
    help: str


class Composed(TypedDict):
    text: str


class Saved(TypedDict):
    name: str
    mime: str
    data: str
    """Text, or base64 where `binary`."""
    binary: bool


class Resized(TypedDict):
    source: FileSource


class Cancelled(TypedDict):
    cancelled: bool


class Followed(TypedDict):
    after: int
    pose: PoseJson


class Shown(TypedDict):
    shared: bool
    """Whether it is a pose of the robot that is shared."""
