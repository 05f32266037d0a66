"""A client of the studio's server, as its page is one."""

from __future__ import annotations

import json
from types import NoneType, UnionType
from typing import (
    Annotated,
    Any,
    ForwardRef,
    Literal,
    NotRequired,
    Union,
    get_args,
    get_origin,
    get_type_hints,
    is_typeddict,
)

from gcrules.apps.studio.guard import COOKIE
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.core.shapes import EntryCount, OneOf

__all__ = [
    "DRAWING",
    "FOUR_DOF",
    "HERE",
    "HOME",
    "KNOWN",
    "OCTAHEDRAL",
    "OPENED",
    "OWN",
    "PORT",
    "TOKEN",
    "Page",
    "assert_fits",
    "faulty",
]

PORT = 8747
TOKEN = "x" * 43
OWN = f"http://127.0.0.1:{PORT}"
HERE = {"host": f"127.0.0.1:{PORT}", "origin": OWN}
KNOWN = HERE | {"cookie": f"{COOKIE}={TOKEN}"}
OCTAHEDRAL = {"kind": "class", "id": "3-3.3"}
FOUR_DOF = {"kind": "robot", "id": "gallardo-4dof"}
OPENED = {"kind": "legs", "legs": "ab af cb cd ed ef"}
HOME = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}


class Page:
    """What a page does: asks, and waits for the answer to each number."""

    def __init__(self, socket: Any) -> None:
        self.socket = socket
        self.number = 0
        self.answers: dict[int, dict[str, Any]] = {}
        self.progress: list[str] = []
        self.parts: list[Any] = []

    def send(self, do: str, channel: str | None = None, **args: Any) -> int:
        self.number += 1
        message = {"id": self.number, "do": do, "args": args} | ({"channel": channel} if channel else {})
        self.socket.send_text(json.dumps(message))
        return self.number

    def answer(self, number: int) -> dict[str, Any]:
        while number not in self.answers:
            found = json.loads(self.socket.receive_text())
            if "progress" in found:
                self.progress.append(found["progress"])
            elif "part" in found:
                self.parts.append(found["part"])
            else:
                assert found["id"] not in self.answers
                self.answers[found["id"]] = found
        return self.answers.pop(number)

    def ask(self, do: str, **args: Any) -> Any:
        found = self.answer(self.send(do, **args))
        assert found["ok"], found
        assert found["ms"] >= 0
        assert_fits(found["result"], METHODS[do].answer, do)
        return found["result"]

    def fault(self, do: str, **args: Any) -> dict[str, Any]:
        found = self.answer(self.send(do, **args))
        assert not found["ok"], found
        return found["error"]


def assert_fits(value: Any, shape: Any, where: str = "") -> None:
    """Whether an answer has the shape that the protocol gives it."""
    inner, *marks = get_args(shape) if get_origin(shape) is Annotated else (shape,)
    parts = get_args(inner)
    if is_typeddict(inner):
        hints = get_type_hints(inner, include_extras=True)
        optional = {name for name, hint in hints.items() if get_origin(hint) is NotRequired}
        assert set(hints) - optional <= set(value) <= set(hints), where
        for name, one in value.items():
            hint = get_args(hints[name])[0] if name in optional else hints[name]
            assert_fits(one, hint, f"{where}.{name}")
    elif get_origin(inner) in (Union, UnionType):
        fitting = [part for part in parts if not faulty(value, part)]
        assert fitting, f"{where}: {value!r:.200}"
    elif get_origin(inner) is Literal:
        assert value in parts, where
    elif get_origin(inner) is dict:
        for name, one in value.items():
            assert_fits(one, parts[1], f"{where}.{name}")
    elif get_origin(inner) is list:
        assert isinstance(value, list), where
        for i, one in enumerate(value):
            assert_fits(one, parts[0], f"{where}[{i}]")
    elif inner is float:
        assert type(value) in (int, float), where
    elif inner is not Any and not isinstance(inner, ForwardRef):
        assert type(value) is (NoneType if inner is None else inner), where
    for mark in marks:
        if isinstance(mark, OneOf):
            assert value in mark.words, where
        if isinstance(mark, EntryCount):
            assert mark.least <= len(value) <= mark.most, where


def faulty(value: Any, shape: Any) -> bool:
    try:
        assert_fits(value, shape)
    except (AssertionError, AttributeError, TypeError):
        return True
    return False


DRAWING: dict[str, Any] = {
    "title": 'My "robot": a sketch',
    "points": {
        "A": [0, 0, 0],
        "B": [1, 0, 0],
        "C": [0, 1.5, 0],
        "a": [0.3, 0.3, 1],
        "b": [0.5, -1e-9, 1],
        "c": [0, 0.5, 1.25],
        "idle": [9, 9, 9],
    },
    "base": ["A", "B", "C"],
    "platform": ["a", "b", "c"],
    "legs": [["A", "a"], ["A", "b"], ["B", "b"], ["B", "c"], ["C", "c"], ["C", "a"]],
}
