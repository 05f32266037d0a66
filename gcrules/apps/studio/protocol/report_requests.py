"""The arguments of what writes files, a report of the state of the page among them, and of what repeats it."""

from __future__ import annotations

import re
from typing import Annotated, Any, Literal, NotRequired, TypedDict

from gcrules.apps.studio.protocol.checking import text
from gcrules.apps.studio.protocol.requests import Format, PoseArgs, SourceJson
from gcrules.core.errors import InputError
from gcrules.core.shapes import EntryCount

__all__ = [
    "LARGEST_PICTURE",
    "LONGEST_LINK",
    "LONGEST_NOTE",
    "LONGEST_TITLE",
    "CertificateFileArgs",
    "Checkable",
    "NoteJson",
    "RepeatArgs",
    "Repeatable",
    "ReportedJson",
    "SaveArgs",
    "StateJson",
]

LARGEST_PICTURE = 400_000
"""Characters of a picture of the page that goes into a report."""
LONGEST_LINK = 65_000
"""Characters of the state in a link that programs take whole; what makes it longer is left out, and the reader is told.
"""
_ADDRESS = 300  # characters before the state

LONGEST_TITLE = 200
LONGEST_NOTE = 20_000
"""Characters of a title, and of a note, that go into a report."""

_Title = Annotated[str, text(LONGEST_TITLE)]


def _object(value: Any, where: str) -> Any:
    if not isinstance(value, dict):
        raise InputError(f"{where} is not an object")
    return value


Repeatable = Literal[
    "open", "pose", "actuators", "path", "map", "surface", "locus",
    "assemblies", "aspects", "free", "boxes", "certify", "manual", "bench",
]  # fmt: skip
"""What a line repeats: methods, and the table of the actuators."""


class RepeatArgs(TypedDict):
    """A method with its arguments, which are checked as if it were asked for."""

    source: NotRequired[SourceJson]
    what: Repeatable
    args: Annotated[dict[str, Any], _object]


Checkable = Literal["path", "map", "free", "boxes"]
"""Methods whose answers have certificates of their own."""


class CertificateFileArgs(TypedDict):
    """A method with its arguments, as for a line that repeats it."""

    source: SourceJson
    what: Checkable
    args: Annotated[dict[str, Any], _object]


class ReportedJson(TypedDict):
    """The same with a title, for a report; the source is that of the report."""

    title: _Title
    what: Repeatable
    args: Annotated[dict[str, Any], _object]


class NoteJson(TypedDict):
    title: _Title
    text: Annotated[str, text(LONGEST_NOTE, empty=True)]


def _image(value: Any, where: str) -> Any:
    found = text(LARGEST_PICTURE, empty=True)(value, where)
    if found and not re.fullmatch(r"data:image/(png|svg\+xml);base64,[A-Za-z0-9+/]+={0,2}", found):
        raise InputError(f"{where} is not a picture: no data address of PNG or SVG in base64")
    return found


def _link(value: Any, where: str) -> Any:
    found = text(LONGEST_LINK + _ADDRESS, empty=True)(value, where)
    if found and not re.fullmatch(r"http://[\w.\[\]:-]+/?(#[sz]=[\w-]+)?", found):
        raise InputError(f"{where} is not an address of a state of the studio")
    return found


class StateJson(TypedDict):
    """What a report shows of the state of the page beside the analysis and the pose: answers of its panels, which
    lines repeat, the picture as it stands, notes, and the link that opens the state again.
    """

    answers: Annotated[list[ReportedJson], EntryCount(0, 20)]
    picture: Annotated[str, _image]
    notes: Annotated[list[NoteJson], EntryCount(0, 100)]
    link: Annotated[str, _link]


class SaveArgs(PoseArgs):
    what: Format
    state: NotRequired[StateJson]
