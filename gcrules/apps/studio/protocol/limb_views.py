"""What the server tells the page of a robot that is being built limb by limb."""

from __future__ import annotations

from typing import Annotated, TypedDict

from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.core.shapes import OneOf
from gcrules.views.scene_data import SceneData

__all__ = [
    "ChainRow",
    "DriveKind",
    "JointKindView",
    "JointRow",
    "LimbRow",
    "LimbSheet",
    "LimbsAnswer",
    "MobilityView",
    "NameRow",
    "NamedPlace",
    "PartKind",
    "Undefined",
    "WrenchRow",
]


class PartKind(TypedDict):
    name: str
    form: Annotated[str, OneOf(("point", "direction", "number"))]


class DriveKind(TypedDict):
    """A way to drive a joint: as it is written, and in words."""

    star: str
    words: str


class JointKindView(TypedDict):
    symbol: str
    name: str
    parts: list[PartKind]
    drives: list[DriveKind]


class Undefined(TypedDict):
    """A name that nothing defines yet, and what it should be."""

    name: str
    sort: Annotated[str, OneOf(("point", "direction"))]


class JointRow(TypedDict):
    kind: str
    star: str
    """As it is written: empty where it is not driven; with a number where one of two freedoms is."""
    name: str
    """For couplings."""
    parts: list[str]
    undefined: list[Undefined]
    faults: list[FaultView]


class ChainRow(TypedDict):
    head: str
    """Between which bodies it leads, "base to hub"; empty in a plain limb."""
    joints: list[JointRow]


class WrenchRow(TypedDict):
    text: str
    couple: bool
    role: Annotated[str, OneOf(("constraint", "actuation", "both"))]


class LimbRow(TypedDict):
    name: str
    copies: int
    """How many limbs it stands for."""
    numbered: bool
    """Whether it stands for the copies of the file."""
    chain: str
    """Its joints in short."""
    cable: list[str]
    """The points that a cable joins; none for a limb of joints."""
    undefined: list[Undefined]
    """Of the ends of a cable."""
    chains: list[ChainRow]
    couplings: str
    system: str
    """What it applies with its actuators locked, in words; empty as long as that is not known."""
    freedoms: int
    constraints: int
    wrenches: list[WrenchRow]
    """Those of the first copy; none where no lines span them."""
    colour: int
    faults: list[FaultView]


class NamedPlace(TypedDict):
    name: str
    at: list[str]
    """Three coordinates at home as they are written; none where the relations determine them."""


class NameRow(TypedDict):
    name: str
    sort: Annotated[str, OneOf(("point", "direction"))]
    relation: str
    places: list[NamedPlace]
    """One for each copy."""
    faults: list[FaultView]


class LimbSheet(TypedDict):
    title: str
    copies: int
    turned: bool
    """Whether all copies are turned about z from the first one, evenly."""
    plane: bool
    unit: str
    platform: str
    limbs: list[LimbRow]
    names: list[NameRow]


class MobilityView(TypedDict):
    """The freedoms of the platform; null as long as they are not known. `written` is what the file says."""

    number: int | None
    written: str
    drives: int
    sentence: str
    faults: list[FaultView]


class LimbsAnswer(TypedDict):
    text: str
    """The file, after the change."""
    sheet: LimbSheet | None
    """Null where the text is no table of limbs; `every` says why."""
    faults: list[FaultView]
    """Those that are in no row of the table."""
    every: FaultView | None
    """All faults, at their places in the text."""
    mobility: MobilityView
    scene: SceneData | None
    """The robot at home, as far as it can be drawn."""
    kinds: list[JointKindView]
    units: list[str]
