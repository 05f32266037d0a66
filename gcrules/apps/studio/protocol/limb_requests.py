"""What a page asks of a robot that is being built limb by limb."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NotRequired, TypedDict

from gcrules.apps.studio.protocol.checking import number, text
from gcrules.apps.studio.protocol.requests import LONGEST_FILE, SourceJson
from gcrules.core.errors import InputError
from gcrules.core.shapes import EntryCount

__all__ = ["LimbsArgs", "SheetEdit"]


def _flag(value: Any, where: str) -> bool:
    if not isinstance(value, bool):
        raise InputError(f"{where} is neither true nor false")
    return value


_Index = Annotated[int, number(0, 1_000, whole=True)]


class SheetEdit(TypedDict):
    """A change of a robot's sheet; which fields it needs `do` says. Places count from 0."""

    do: Literal[
        "title", "limb add", "limb remove", "limb move", "limb name", "limb cable", "limb duplicate", "limb around",
        "limb single", "copies", "joint add", "joint remove", "joint move", "joint kind", "joint drive", "joint part",
        "name add", "name rename", "name relation", "home", "mobility", "unit",
    ]  # fmt: skip
    limb: NotRequired[_Index]
    chain: NotRequired[_Index]
    joint: NotRequired[_Index]
    part: NotRequired[_Index]
    to: NotRequired[_Index]
    name: NotRequired[Annotated[str, text(40)]]
    text: NotRequired[Annotated[str, text(400, empty=True)]]
    texts: NotRequired[Annotated[list[Annotated[str, text(40, empty=True)]], EntryCount(3, 3)]]
    degrees: NotRequired[Annotated[float, number(-360, 360)]]
    follow: NotRequired[Annotated[bool, _flag]]


class LimbsArgs(TypedDict):
    """The text of a robot file, after a change if there is one; without a text that of the robot in `start`, or of one
    to begin with.
    """

    text: NotRequired[Annotated[str, text(LONGEST_FILE, empty=True)]]
    start: NotRequired[SourceJson]
    plane: NotRequired[Annotated[bool, _flag]]
    """Whether the limb to begin with is that of a planar robot."""
    edit: NotRequired[SheetEdit]
