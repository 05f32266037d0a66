"""The studio without a server answers as the server does, and says of everything else that it needs an installation."""

from __future__ import annotations

import json
from typing import Any

import pytest

from gcrules.apps.studio.gallery import gallery
from gcrules.apps.studio.in_page import ANSWERED, Answering
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.protocol.requests import SourceJson
from gcrules.apps.studio.study import study
from gcrules.apps.studio.subject import read_subject

OCTAHEDRAL: SourceJson = {"kind": "legs", "legs": "ab af cb cd ed ef"}
HOME = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}


def ask(do: str, args: Any, told: list[Any] | None = None) -> Any:
    heard: list[str] = []
    reply = json.loads(Answering().answer(json.dumps({"id": 7, "do": do, "args": args}), heard.append))
    if told is not None:
        told += map(json.loads, heard)
    return reply


@pytest.mark.parametrize(
    ("source", "steps"),
    [(OCTAHEDRAL, 10), ({"kind": "class", "id": "6-6"}, 6), ({"kind": "class", "id": "3-3.1"}, 9)],
    ids=["octahedral", "6-6", "3-3.1"],
)
def test_opening(source: SourceJson, steps: int) -> None:
    told: list[Any] = []
    reply = ask("open", {"source": source}, told)
    assert reply["id"] == 7
    assert reply["ok"]
    assert reply["result"] == json.loads(json.dumps(study(read_subject(source))))
    assert len(reply["result"]["stages"]) == steps
    assert told == [{"id": 7, "progress": "analysing"}, {"id": 7, "progress": "stages"}]


def test_the_gallery_is_that_of_what_can_be_opened() -> None:
    reply = ask("gallery", {})
    whole = json.loads(json.dumps(gallery()))
    assert reply["result"] == {**whole, "robots": [], "examples": []}
    assert reply["result"]["classes"]


def test_hello() -> None:
    reply = ask("hello", {})
    assert reply["result"]["opened"] is None
    assert not reply["result"]["shared"]


def test_the_bench() -> None:
    told: list[Any] = []
    reply = ask("bench", {"text": ":prove ab /\\ cd == [abcd]\n[abce]"}, told)
    assert [found["verdict"] for found in reply["result"]["results"]] == ["proved", "value"]
    parts = [said["part"] for said in told if "part" in said]
    assert parts == [{"index": i, "result": found} for i, found in enumerate(reply["result"]["results"])]


@pytest.mark.parametrize(
    ("do", "args"),
    [
        ("pose", {"source": OCTAHEDRAL, "pose": HOME}),
        ("open", {"source": {"kind": "robot", "id": "3-rps"}}),
        ("open", {"source": {"kind": "example", "name": "octahedral"}}),
        ("bench", {"text": "[abcd]", "source": {"kind": "robot", "id": "3-rps"}}),
        ("plugins", {}),
    ],
)
def test_what_needs_an_installation(do: str, args: Any) -> None:
    reply = ask(do, args)
    assert not reply["ok"]
    assert "NumPy" in reply["error"]["message"]
    assert "pip install" in reply["error"]["hint"]


def test_what_is_wrong_is_said_as_by_the_server() -> None:
    reply = ask("open", {"source": {"kind": "legs", "legs": "ab a"}})
    assert reply["error"]["place"] == {"start": 3, "end": 4, "line": 1, "column": 4}
    assert ask("open", {"source": {"kind": "nothing"}})["error"]["kind"] == "input"
    assert json.loads(Answering().answer("[]", print)) == {
        "id": 0,
        "ok": False,
        "error": {"kind": "input", "message": "the message is not an object"},
    }


def test_a_package_that_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(*_: Any) -> None:
        raise ModuleNotFoundError("numpy.linalg.norm is not there", name="numpy")

    monkeypatch.setattr("gcrules.apps.studio.bench.bench", missing)
    reply = ask("bench", {"text": "[abcd]"})
    assert reply["error"]["message"] == "this answer needs numpy, which is not installed here"


def test_methods_are_those_of_the_server() -> None:
    assert set(ANSWERED) <= set(METHODS)
