"""Faults as the page is told of them."""

from __future__ import annotations

import re
from typing import Literal

from gcrules.apps.studio.protocol.study_views import FaultView, Place
from gcrules.core.budget import MORE_SECONDS
from gcrules.core.errors import GcrulesError, LimitReached, Span

__all__ = ["CANCELLED", "SUPERSEDED", "fault_view", "limit", "own_fault", "units"]

SUPERSEDED: FaultView = {"kind": "superseded", "message": "a later request has taken its place"}
CANCELLED: FaultView = {"kind": "cancelled", "message": "cancelled"}

_MOST, _LONGEST = 50, 600
_HERE = {MORE_SECONDS: "the command line can give it more time"}
_OPTION = re.compile(r"(?<![\w-])--[a-z]")
"""An option of the command line: a hint that names one is of no use in the page."""


def fault_view(fault: GcrulesError) -> FaultView:
    """A fault of the input or a limit, with its place in the text that was sent."""
    several = getattr(fault, "faults", ())[:_MOST]
    if several:
        views = [fault_view(f) for f in several]
        return {**views[0], "more": views[1:]}
    kind: Literal["limit", "input"] = "limit" if isinstance(fault, LimitReached) else "input"
    found: FaultView = {"kind": kind, "message": _cut(fault.message)}
    hint = _HERE.get(fault.hint, fault.hint) if fault.hint else None
    if hint and not _OPTION.search(hint):
        found["hint"] = hint
    if fault.span is not None and fault.source is not None:
        found["place"] = _place(fault.source, fault.span)
    return found


def _cut(words: str) -> str:
    """Faults quote what is wrong, which may be long."""
    return words if len(words) <= _LONGEST else f"{words[: _LONGEST // 2]} … {words[-_LONGEST // 2 :]}"


def _place(source: str, span: Span) -> Place:
    """The page counts as JavaScript does, in units of UTF-16."""
    line, column = span.line_column(source)
    return {"start": units(source[: span.start]), "end": units(source[: span.end]), "line": line, "column": column}


def units(text: str) -> int:
    """The length of a text in JavaScript."""
    return len(text) + sum(c > "\uffff" for c in text)


def limit(message: str, hint: str) -> FaultView:
    """A limit of the studio itself."""
    return {"kind": "limit", "message": message, "hint": hint}


def own_fault(message: str) -> FaultView:
    """A fault of gcrules, not of the input."""
    return {"kind": "fault", "message": message, "hint": "this is a fault of gcrules; please report it"}
