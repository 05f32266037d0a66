"""Messages between the page and what answers it: a request is read, a reply written."""

from __future__ import annotations

import json
from collections.abc import Mapping
from time import perf_counter
from typing import Any

from gcrules.apps.studio.protocol.checking import choice, decoded, number, record, text
from gcrules.apps.studio.protocol.methods import LONGEST, METHODS
from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError

__all__ = [
    "Misread",
    "Part",
    "Request",
    "Told",
    "fault_message",
    "message_text",
    "read_request",
    "result_message",
    "told_message",
]

_LARGEST = 2**53


def _any(value: Any, where: str) -> Any:
    return value


_REQUEST = record({"id": number(0, _LARGEST, whole=True), "do": choice(*METHODS), "args": _any}, {"channel": text(40)})


@dataclass(frozen=True, eq=False)
class Request:
    """What a page asks, since when (`perf_counter`); the arguments are checked."""

    id: int
    do: str
    args: Mapping[str, Any]
    channel: str | None
    since: float


@dataclass(frozen=True)
class Part:
    """What is there already of an answer that takes long, in the shape that its method says."""

    value: Any


Told = str | Part
"""What is said before an answer: in words how far it is, or a part of it."""


class Misread(Exception):
    """A message that is no request: its number, or 0, and what is wrong with it."""

    def __init__(self, id: int, fault: GcrulesError) -> None:
        super().__init__(id, fault)
        self.id = id
        self.fault = fault


def read_request(data: str | bytes) -> Request:
    """Raises Misread."""
    id, since = 0, perf_counter()
    try:
        found = decoded(data, LONGEST)
        if isinstance(found.get("id"), int) and not isinstance(found["id"], bool):
            id = min(max(found["id"], 0), _LARGEST)
        asked = _REQUEST(found, "the message")
        args = METHODS[asked["do"]].check(asked["args"], "args")
    except GcrulesError as fault:
        raise Misread(id, fault) from fault
    return Request(asked["id"], asked["do"], args, asked.get("channel"), since)


def result_message(request: Request, result: Any) -> Mapping[str, Any]:
    """The answer to a request, with the milliseconds that it took."""
    ms = round(1000 * (perf_counter() - request.since), 3)
    return {"id": request.id, "ok": True, "result": result, "ms": ms}


def told_message(id: int, told: Told) -> Mapping[str, Any]:
    """What is said before the answer to a request."""
    return {"id": id, "part": told.value} if isinstance(told, Part) else {"id": id, "progress": told}


def fault_message(id: int, fault: FaultView) -> Mapping[str, Any]:
    """Why a request has no answer."""
    return {"id": id, "ok": False, "error": fault}


def message_text(content: Mapping[str, Any]) -> str:
    """The text of a message. Raises ValueError for numbers that are not finite."""
    return json.dumps(content, allow_nan=False, separators=(",", ":"))
