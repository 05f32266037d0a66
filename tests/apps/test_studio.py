"""The studio's server: what it answers, whom it turns away, and that nothing brings it down. No browser is needed."""

from __future__ import annotations

import asyncio
import gzip
import json
import os
import random
import re
import signal
import stat
import subprocess
import sys
import time
import warnings
from collections.abc import Iterator
from contextlib import ExitStack
from fractions import Fraction
from pathlib import Path
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

import pytest
from click.testing import CliRunner
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.apps.cli import cli
from gcrules.core.errors import EngineFault, FileError, InputError, LimitReached
from gcrules.core.shapes import Size, Words
from gcrules.mechanisms.description.discovery import examples
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.screws.verdict import VERDICTS
from gcrules.views import scene_data
from gcrules.views.formulas.latex import latex
from gcrules.views.report.stage_ids import STAGE_IDS
from gcrules.views.robots.exact_values import value_at

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

with warnings.catch_warnings():  # it says which client it will use one day
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from gcrules.apps.studio import serving, theory, token_file
from gcrules.apps.studio.app import MOST_PAGES, make_app
from gcrules.apps.studio.formulas import pieces
from gcrules.apps.studio.guard import COOKIE
from gcrules.apps.studio.numbers import exact_pose, numbers
from gcrules.apps.studio.pages import STATIC, Pages
from gcrules.apps.studio.pool import Pool
from gcrules.apps.studio.protocol.methods import LONGEST, METHODS
from gcrules.apps.studio.stages import stage_views
from gcrules.apps.studio.study import study
from gcrules.apps.studio.subject import read_subject, source_of
from gcrules.apps.studio.wire import framed

PORT = 8747
TOKEN = "x" * 43
OWN = f"http://127.0.0.1:{PORT}"
HERE = {"host": f"127.0.0.1:{PORT}", "origin": OWN}
KNOWN = HERE | {"cookie": f"{COOKIE}={TOKEN}"}

OCTAHEDRAL = {"kind": "class", "id": "3-3.3"}
FOUR_DOF = {"kind": "robot", "id": "gallardo-4dof"}
HOME = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}


class Page:
    """What a page does: asks, and waits for the answer to each number."""

    def __init__(self, socket: Any) -> None:
        self.socket = socket
        self.number = 0
        self.answers: dict[int, dict[str, Any]] = {}
        self.progress: list[str] = []

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


@pytest.fixture(scope="module")
def client() -> Iterator[TestClient]:
    with TestClient(make_app(PORT, TOKEN, {"kind": "legs", "legs": "ab af cb cd ed ef"}), base_url=OWN) as client:
        yield client


@pytest.fixture
def page(client: TestClient) -> Iterator[Page]:
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        yield Page(socket)


# --- both sides say the same ---------------------------------------------------------------------------------------


def test_the_page_has_the_protocol_of_the_server(root: Path) -> None:
    run = subprocess.run([sys.executable, str(root / "tools" / "studio_protocol.py"), "--check"], capture_output=True)
    assert run.returncode == 0, run.stdout.decode()


def test_words_of_the_protocol_are_those_of_the_engine() -> None:
    assert set(get_args(scene_data.Verdict)[1:]) == {Words(VERDICTS)}
    assert set(theory.THEORY) == set(STAGE_IDS)


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
        if isinstance(mark, Words):
            assert value in mark.words, where
        if isinstance(mark, Size):
            assert mark.least <= len(value) <= mark.most, where


def faulty(value: Any, shape: Any) -> bool:
    try:
        assert_fits(value, shape)
    except (AssertionError, AttributeError, TypeError):
        return True
    return False


# --- what is asked for ---------------------------------------------------------------------------------------------


def test_hello_tells_what_was_opened(page: Page) -> None:
    said = page.ask("hello")
    assert said["version"] == gc.__version__
    assert said["opened"] == {"kind": "legs", "legs": "ab af cb cd ed ef"}
    assert re.fullmatch(r"[0-9a-f]{16}", said["instance"])


def test_gallery_lists_what_can_be_opened(page: Page) -> None:
    found = page.ask("gallery")
    assert len(found["classes"]) == 39
    assert {"gallardo-4dof", "3-rps", "delta"} <= {item["id"] for item in found["robots"]}
    assert {item["id"] for item in found["examples"]} == set(examples())
    for item in [*found["classes"], *found["robots"], *found["examples"]]:
        assert item["title"]
        assert item["group"]
        assert item["svg"].startswith("<svg")
    assert page.ask("gallery") == found


def product(monomial: dict[str, Any], points: Any) -> Fraction:
    value = Fraction(monomial["sign"] * Fraction(monomial["coefficient"] or 1))
    for bracket in monomial["brackets"]:
        value *= Fraction(evaluate(gc.parse(f"[{' '.join(bracket['points'])}]"), points))
    return value


@pytest.mark.parametrize("legs", ["ab af cb cd ed ef", "Aa Ab Bc Bd Ce Df", "Aa Ab Ac Bd Be Cf", "Aa Bb Cc Dd Ee Ff"])
def test_tables_of_terms_are_the_superbracket(page: Page, legs: str) -> None:
    found = page.ask("open", source={"kind": "legs", "legs": legs})
    structure = gc.analyze(legs).structure
    points = random_rational_points(structure.names, seed=7)
    value = evaluate(structure.superbracket, points)
    tables = [item["monomials"] for s in found["stages"] for item in s["items"] if item["kind"] == "monomials"]
    assert len(tables) >= 2
    for table in tables:
        assert sum(product(m, points) for m in table) == value


PATHS = {
    "3-3.3": ["structure", "superbracket", "shortest", "tetrahedra", "planes", "lines", "left-over"],
    "6-4.2": ["structure", "superbracket", "shortest", "tetrahedra", "planes", "lines", "left-over"],
    "5-4.2": ["structure", "superbracket", "shortest", "tetrahedra", "planes", "lines"],
    "6-6": ["structure", "superbracket", "shortest"],
}


@pytest.mark.parametrize("name", PATHS)
def test_guided_path(page: Page, name: str) -> None:
    found = page.ask("open", source={"kind": "class", "id": name})
    assert [s["id"] for s in found["stages"]] == [*PATHS[name], "condition", "statement", "check"]
    assert found["entry"]["id"] == name
    assert found["invented"]
    for s in found["stages"]:
        assert s["title"]
        assert s["why"]
        assert s["more"]
        assert s["items"]
    ids = {e["id"] for e in found["entities"]}
    shown = {e for s in found["stages"] for i in s["items"] if i["kind"] == "entities" for e in i["entities"]}
    assert shown <= ids
    (orders,) = (i for s in found["stages"] for i in s["items"] if i["kind"] == "orders")
    assert orders["tried"] == sum(c["orders"] for c in orders["counts"]) == 1440
    table = next(i for s in found["stages"] if s["id"] == "shortest" for i in s["items"] if i["kind"] == "monomials")
    assert min(c["terms"] for c in orders["counts"]) == len(table["monomials"])
    assert set(re.findall(r'data-point="([^"]+)"', found["schematic"])) == set(found["points"])


def test_four_dof_robot_shows_its_three_tetrahedra(page: Page) -> None:
    found = page.ask("open", source=FOUR_DOF)
    assert found["kind"] == "robot"
    assert [s["id"] for s in found["stages"]][:2] == ["limbs", "equivalent"]
    tetrahedra = next(s for s in found["stages"] if s["id"] == "tetrahedra")
    (ids,) = (i["entities"] for i in tetrahedra["items"] if i["kind"] == "entities")
    corners = {" ".join(sorted(e["points"])) for e in found["entities"] if e["id"] in ids}
    assert corners == {"A1 B1 C1 S1", "A3 B3 S1 S3", "A2 S1 S2 S3"}
    robot = found["robot"]
    assert robot["mobility"] == 4 == len(found["axes"])
    assert [limb["name"] for limb in robot["limbs"]] == ["leg 1", "leg 2", "leg 3"]
    assert [len(limb["lines"]) for limb in robot["limbs"]] == [3, 1, 2]
    assert robot["figure"].startswith("<svg")


def test_robot_moves_by_its_actuators(page: Page) -> None:
    at_home = page.ask("pose", source=FOUR_DOF, pose=HOME)
    moved = page.ask("pose", source=FOUR_DOF, pose=HOME | {"coordinates": [0.2, 0.1, 0, 0]})
    assert at_home["verdict"] == "regular"
    assert moved["points"]["S1"] != at_home["points"]["S1"]
    assert moved["points"]["A2"] == at_home["points"]["A2"]
    assert [limb["name"] for limb in moved["limbs"]] == ["leg 1", "leg 2", "leg 3"]
    fault = page.fault("pose", source=FOUR_DOF, pose=HOME | {"coordinates": [1.0]})
    assert "4 actuators" in fault["message"]


@pytest.mark.parametrize("name", ["gallardo-4dof", "3-rps", "delta", "3-upu", "tricept", "3-rpr", "6-rus"])
def test_value_of_a_robot_has_the_exact_sign(name: str) -> None:
    subject = read_subject({"kind": "robot", "id": name})
    assert subject.robot is not None
    assert subject.structure is not None
    robot = subject.robot.robot
    exact = value_at(robot.family, subject.robot.structure, robot.values_at(), subject.structure.superbracket)
    found = numbers(subject, HOME)["value"]  # type: ignore[arg-type]
    assert 0 < abs(found) <= 1
    assert (found > 0) == (exact > 0)


@pytest.mark.parametrize("kind", theory.THEORY)
def test_theory_cites_what_is_in_the_bibliography(root: Path, kind: str) -> None:
    keys = set(re.findall(r"^@\w+\{(\w+),", (root / "gcrules" / "references.bib").read_text(encoding="utf-8"), re.M))
    told = theory.THEORY[kind]
    cited = set(re.findall(r"\[([A-Z]\w+\d{4}\w*)\]", " ".join(told.more)))
    assert cited <= keys
    assert 1 <= len(told.more) <= 3


@pytest.mark.parametrize("name", ["3-3.3", "6-4.2", "4-4.4", "6-5", "5-4.4", "3-3.1"])
def test_pieces_are_the_formula(name: str) -> None:
    a = read_subject({"kind": "class", "id": name}).analysis
    assert a is not None

    def bare(tex: str) -> str:
        return tex.replace("{}", "").replace(" ", "")

    for c in (a.condition, *a.readings):
        for e in (c.right_side, c.cofactor, a.structure.superbracket):
            assert bare("".join(p["tex"] for p in pieces(e))) == bare(latex(e))


@pytest.mark.parametrize("name", ["3-3.3", "6-4.2", "6-6", "octahedral", "octahedral-singular"])
def test_numbers_are_those_of_the_library(name: str) -> None:
    subject = read_subject(source_of(name, str))
    assert subject.analysis is not None
    assert subject.moving is not None
    rng = random.Random(name)
    units = f"units: {subject.unit}\n" if subject.unit else ""
    text = f"{units}legs: {[list(leg) for leg in subject.analysis.structure.legs]}\npoints:\n"
    text += "".join(f"  {n}: [{', '.join(map(str, p))}]\n" for n, p in subject.points.items())
    robot = parse_platform(text.replace("'", ""))
    for shift in ([0.0, 0.0, 0.0], [0.1 * subject.size * rng.uniform(-1, 1) for _ in range(3)]):
        pose = {"translation": shift, "quaternion": [1.0, 0.1 * bool(any(shift)), 0.0, 0.05 * bool(any(shift))]}
        mine = numbers(subject, pose)  # type: ignore[arg-type]
        theirs = gc.pose(robot, exact_pose(pose), about="centroid", nearest=False)  # type: ignore[arg-type]
        assert mine["verdict"] == theirs.verdict
        assert mine["reason"] == theirs.reason
        assert mine["margin"] == pytest.approx(theirs.closeness, abs=1e-12)
        assert (mine["value"] > 0) == (theirs.value > 0)
        assert mine["causes"] == list(theirs.causes)
        values = [r.value for r in theirs.readings[: len(mine["readings"])]]
        assert [r["value"] for r in mine["readings"]] == pytest.approx(values, rel=1e-9)


def test_every_class_opens_and_has_numbers() -> None:
    for entry in ("6-2", "5-2", "4-4.s", "6-5", "4-4.7"):
        subject = read_subject({"kind": "class", "id": entry})
        json.dumps(study(subject), allow_nan=False)
        found = numbers(subject, HOME)  # type: ignore[arg-type]
        assert (found["verdict"] == "singular") == (entry in ("6-2", "5-2", "4-4.s"))


@pytest.mark.parametrize("entry", ["6-2", "5-2", "3-3.3", "6-6"])
@pytest.mark.parametrize("away", [1e3, 1e8, 1e11, 1e13])
def test_far_away_there_are_numbers_or_a_reason(entry: str, away: float) -> None:
    subject = read_subject({"kind": "class", "id": entry})
    pose = {"translation": [away, -away, 0.3 * away], "quaternion": [1.0, 0.3, -0.2, 0.1]}
    if away > 1e12:
        with pytest.raises(InputError, match="times the robot's size away"):
            numbers(subject, pose)  # type: ignore[arg-type]
    else:
        found = numbers(subject, pose)  # type: ignore[arg-type]
        assert 0 <= found["margin"] <= 1
        assert json.dumps(found, allow_nan=False)


def test_singular_example(page: Page) -> None:
    found = page.ask("pose", source={"kind": "example", "name": "octahedral-singular"}, pose=HOME)
    assert found["verdict"] == "singular"
    assert found["value"] == found["margin"] == 0
    assert found["motion"]["text"].startswith("the platform can")
    assert len(found["stress"]) == 6
    assert "meet in a point" in found["causes"][0]
    assert any(c["kind"] == "point" for c in found["constructed"])


def test_nearest_and_the_way_there(page: Page) -> None:
    source = {"kind": "example", "name": "octahedral"}
    found = page.ask("nearest", source=source, pose=HOME)["found"]
    assert [f["kind"] for f in found] == ["translation", "rotation", "combined"]
    assert "seeking the nearest singular poses" in page.progress
    there = found[0]["pose"]
    assert page.ask("pose", source=source, pose=there)["verdict"] == "singular"
    poses = [HOME | {"translation": [t * c for c in there["translation"]]} for t in (0, 0.5, 1)]
    way = page.ask("along", source=source, poses=poses)
    assert min(way["margin"]) == way["margin"][2] < 1e-9
    assert way["verdicts"][0] == "regular"
    assert abs(way["value"][2]) < 1e-9 < abs(way["value"][0])


@pytest.mark.parametrize("given", [{}, {"coordinates": [0.02, -0.03, 0.01]}], ids=["home", "away"])
def test_singular_poses_around_a_robot_with_limbs(page: Page, given: dict[str, Any]) -> None:
    source = {"kind": "robot", "id": "3-rpr"}
    found = page.ask("nearest", source=source, pose=HOME | given)
    assert "searching along +yaw" in page.progress
    assert "no proof" in found["note"]
    one = found["found"][0]
    assert (one["kind"], one["unit"], one["certified"]) == ("along +yaw", "deg", False)
    assert "meet in a point or are parallel" in one["causes"][0]
    assert "no proof" in one["text"]
    there = page.ask("pose", source=source, pose=one["pose"])
    assert there["verdict"] != "regular"
    assert there["margin"] < 1e-4


def test_search_around_says_that_nothing_was_found(page: Page) -> None:
    found = page.ask("nearest", source={"kind": "robot", "id": "delta"}, pose=HOME)
    assert found["found"] == []
    assert found["note"].startswith("No singular pose was found by a search along +x, −x, +y")


def test_search_around_needs_all_actuators(page: Page) -> None:
    fault = page.fault("nearest", source={"kind": "robot", "id": "3-rpr"}, pose=HOME | {"coordinates": [1.0]})
    assert "3 actuators" in fault["message"]


# --- by hand -------------------------------------------------------------------------------------------------------


def test_manual_accepts_and_refuses(page: Page) -> None:
    legs = {"kind": "legs", "legs": "ab af cb cd ed ef"}
    found = page.ask("manual", source=legs, commands=["plane abc", "plane abd", "plane bdf"])
    assert [r["answer"] for r in found["history"]] == ["confirmed", "refused", "confirmed"]
    assert found["history"][1]["monomial"] == 1
    assert found["counterexample"] is None
    assert [e["label"] for e in found["entities"]] == ["abc", "b*df"]
    assert found["hint"]["command"]
    assert found["fault"] is None
    done = page.ask("manual", source=legs, commands=["plane abc", "auto"])
    assert done["condition"]["kind"] == "four-planes"
    assert done["hint"] is None


def test_manual_counterexample_refutes(page: Page) -> None:
    legs = "ab af cb cd ed ef"
    found = page.ask("manual", source={"kind": "legs", "legs": legs}, commands=[r"condition abc /\ aef /\ bdf /\ cef"])
    assert found["history"][0]["answer"] == "refused"
    points = {n: (*p, 1.0) for n, p in found["counterexample"].items()}
    robot, refuted = gc.analyze(legs).structure.superbracket, gc.parse(r"abc /\ aef /\ bdf /\ cef")
    assert abs(evaluate(robot, points)) < 1e-6 < 1 < abs(evaluate(refuted, points))


def test_manual_stops_at_a_fault(page: Page) -> None:
    found = page.ask("manual", source=OCTAHEDRAL, commands=["shortest", "plan ABC", "plane ABC"])
    assert [r["command"] for r in found["history"]] == ["shortest"]
    assert found["fault"]["place"] == {"start": 0, "end": 4, "line": 1, "column": 1}


# --- the bench -----------------------------------------------------------------------------------------------------

BENCH = {
    "value": ("[abcd] - [abdc]", [("value", None, 0)], None),
    "let": ("let p = ab /\\ cde", [("value", "p", 1)], None),
    "equation": ("ab /\\ cd == [abcd]", [("proved", None, None)], None),
    "refuted": ("[abcd] == [abdc]", [("refuted", None, None)], None),
    "claim": ("claim [abcd] == -[abdc]", [("proved", None, None)], None),
    "several": ("let p = abc\np /\\ de\n\n[abcd]", [("value", "p", 3), ("value", None, 1), ("value", None, 0)], None),
    "comment": ("# nothing\n", [], None),
    "nothing": ("", [], None),
    "fault": ("[abcd]\nab /\\", [("value", None, 0)], (12, 2, 6)),
    "place": ("let p = a\n  [abc", [], (16, 2, 7)),
    "command": (":load /etc/passwd", [], (0, 1, 1)),
    "astral": ("# 𝔸\n[abc", [], (9, 2, 5)),
}


@pytest.mark.parametrize("name", BENCH)
def test_bench(page: Page, name: str) -> None:
    text, results, place = BENCH[name]
    found = page.ask("bench", text=text)
    assert [(r["verdict"], r["name"], r["step"]) for r in found["results"]] == results
    if place is None:
        assert found["fault"] is None
    else:
        at = found["fault"]["place"]
        assert (at["start"], at["line"], at["column"]) == place
    for r in found["results"]:
        assert text[r["start"] : r["end"]].strip() == text[r["start"] : r["end"]]
        assert r["text"]


def test_bench_draws_at_the_pose(page: Page) -> None:
    source = {"kind": "example", "name": "octahedral"}
    lifted = HOME | {"translation": [0, 0, 10]}
    points = page.ask("pose", source=source, pose=lifted)["points"]
    found = page.ask("bench", text="b\nab\nlet P = abc\nab /\\ cde\npq\nab /\\ ab", source=source, pose=lifted)
    drawn = [r["drawn"] for r in found["results"]]
    assert drawn[0]["at"] == pytest.approx(points["b"])
    line, plane, point = drawn[1:4]
    for name in "ab":
        arm = [p - q for p, q in zip(points[name], line["at"], strict=True)]
        along = sum(c * d for c, d in zip(arm, line["direction"], strict=True))
        assert arm == pytest.approx([along * d for d in line["direction"]], abs=1e-6)
    for name in "abc":
        height = sum(c * n for c, n in zip(points[name], plane["normal"], strict=True))
        assert height == pytest.approx(plane["offset"])
    assert point["kind"] == "point"
    assert drawn[4] is None
    assert found["results"][2]["name"] == "P"


# --- drawing, taking away ------------------------------------------------------------------------------------------

DRAWING = {
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


def test_drawing_becomes_a_file(page: Page) -> None:
    text = page.ask("compose", drawing=DRAWING)["text"]
    found = parse_platform(text)
    assert found.title == DRAWING["title"]
    assert {n: [float(c) for c in p] for n, p in found.points.items()} == {
        n: p for n, p in DRAWING["points"].items() if n != "idle"
    }
    opened = page.ask("open", source={"kind": "file", "text": text, "name": "sketch.yaml"})
    assert opened["entry"]["id"] == "3-3.3"
    assert not opened["invented"]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"legs": []}, "there are no legs"),
        ({"legs": [["A", "A"]] * 6}, "from a point to itself"),
        ({"legs": [["A", "a"]]}, "expected six"),
        ({"legs": [["A", "nowhere"]] * 6}, "no coordinates"),
        ({"points": {"A": [0, 0, 0], "a": [0, 0, 0]}, "legs": [["A", "a"]] * 6}, "in the same place"),
        ({"points": {"A b": [0, 0, 0]}}, "there are no points"),
    ],
)
def test_drawings_at_fault(page: Page, change: dict[str, Any], words: str) -> None:
    fault = page.fault("compose", drawing=DRAWING | change)
    assert fault["kind"] == "input"
    assert words in " ".join([fault["message"], *(f["message"] for f in fault.get("more", []))])


@pytest.mark.parametrize("source", [OCTAHEDRAL, {"kind": "example", "name": "octahedral"}, FOUR_DOF], ids=str)
@pytest.mark.parametrize(
    ("what", "begins"),
    [
        ("html", "<!DOCTYPE html>"),
        ("latex", "\\documentclass"),
        ("svg", "<svg"),
        ("pdf", "JVBERi0"),
        ("json", "{"),
        ("yaml", "title:"),
    ],
)
def test_saving(page: Page, source: dict[str, str], what: str, begins: str) -> None:
    if what == "pdf":
        pytest.importorskip("matplotlib")
    found = page.ask("save", source=source, pose=HOME, what=what)
    assert found["name"].endswith("tex" if what == "latex" else what)
    assert re.fullmatch(r"[a-z0-9.-]+", found["name"])
    assert found["binary"] == (what == "pdf")
    assert begins in found["data"][:200]
    if what == "json":
        assert json.loads(found["data"])["studio_pose"]["verdict"] == "regular"


def test_saved_file_is_in_the_pose(page: Page) -> None:
    source = {"kind": "example", "name": "octahedral"}
    pose = {"translation": [1, -2, 3], "quaternion": [0.9, 0.1, 0, 0.2]}
    points = page.ask("pose", source=source, pose=pose)["points"]
    text = page.ask("save", source=source, pose=pose, what="yaml")["data"]
    again = page.ask("open", source={"kind": "file", "text": text, "name": "again.yaml"})
    for name, place in again["points"].items():
        assert place == pytest.approx(points[name], abs=1e-8)
    same = page.ask("save", source={"kind": "file", "text": text, "name": "again.yaml"}, pose=HOME, what="yaml")
    assert same["data"] == text


def test_saved_file_of_a_robot_is_in_the_pose_too(root: Path, page: Page) -> None:
    source = {"kind": "robot", "id": "octahedral"}
    at_home = page.ask("save", source=source, pose=HOME, what="yaml")["data"]
    assert at_home == (root / "plugins" / "octahedral" / "robot.yaml").read_text(encoding="utf-8")
    pose = {"translation": [0.25, -0.5, 0.125], "quaternion": [0.9, 0.1, 0, 0.2]}
    points = page.ask("pose", source=source, pose=pose)["points"]
    moved = parse_platform(page.ask("save", source=source, pose=pose, what="yaml")["data"])
    for name, place in moved.points.items():
        assert [float(c) for c in place] == pytest.approx(points[name], abs=1e-8)


LINES = """title: A platform as lines
points: {A: free, B: free, C: free, a: free, b: free, c: free}
lines: Aa Ab Bb Bc Cc Ca
mobility: 6
home: {A: [0, 0, 0], B: [3, 0, 0], C: [0, 3, 0], a: [1, 0, 2], b: [2, 0, 2], c: [1, 2, 3]}
"""


def test_robot_of_legs_moves_as_a_platform(page: Page) -> None:
    for source in ({"kind": "file", "text": LINES, "name": "lines.yaml"}, {"kind": "robot", "id": "octahedral"}):
        opened = page.ask("open", source=source)
        assert opened["kind"] == "platform"
        assert opened["entry"]["id"] == "3-3.3"
        assert [axis["name"] for axis in opened["axes"]] == ["x", "y", "z", "rx", "ry", "rz"]
        moved = page.ask("pose", source=source, pose=HOME | {"translation": [0.25, 0, 0]})
        for name in opened["platform"]:
            assert moved["points"][name][0] == pytest.approx(opened["points"][name][0] + 0.25)


def test_bundle_is_small() -> None:
    files = [p for folder in STATIC for p in folder.rglob("*") if p.is_file()]
    if not files:
        pytest.skip("the page is not built")
    assert sum(len(gzip.compress(p.read_bytes())) for p in files) <= 1_500_000


def test_robot_file_is_told_from_a_platform_file(root: Path, page: Page) -> None:
    text = (root / "plugins" / "3-rps" / "robot.yaml").read_text(encoding="utf-8")
    opened = page.ask("open", source={"kind": "file", "text": text, "name": "robot.yaml"})
    assert opened["kind"] == "robot"
    fault = page.fault(
        "open", source={"kind": "file", "text": text.replace("S%: in plane", "S%: on plane"), "name": "r"}
    )
    assert fault["place"]["line"] > 1
    faults = page.fault("open", source={"kind": "file", "text": "legs: [ab, cc]\npoints: {a: [0, 0]}\n", "name": "p"})
    assert len(faults["more"]) >= 1


# --- messages that are no requests ---------------------------------------------------------------------------------

POSE = {"source": OCTAHEDRAL, "pose": HOME}


def asked(do: str, args: Any, **more: Any) -> str:
    return json.dumps({"id": 1, "do": do, "args": args} | more)


HOSTILE: dict[str, str | bytes] = {
    "empty": "",
    "no JSON": "{",
    "no object": "[]",
    "number": "1",
    "null": "null",
    "nested lists": "[" * 100_000,
    "nested objects": '{"id":' * 50_000,
    "nested arguments": '{"id": 1, "do": "open", "args": ' + '{"a":' * 500 + "1" + "}" * 501,
    "binary": b"\x00\xff\xfe",
    "binary JSON": b'{"id": 1, "do": "hello", "args": {}}',
    "NaN": asked("pose", POSE).replace("[0, 0, 0]", "[NaN, 0, 0]"),
    "infinity": asked("pose", POSE).replace("[0, 0, 0]", "[1e999, 0, 0]"),
    "no arguments": '{"id": 1, "do": "hello"}',
    "no id": '{"do": "hello", "args": {}}',
    "id text": '{"id": "1", "do": "hello", "args": {}}',
    "id true": '{"id": true, "do": "hello", "args": {}}',
    "id negative": '{"id": -1, "do": "hello", "args": {}}',
    "id fraction": '{"id": 1.5, "do": "hello", "args": {}}',
    "id huge": '{"id": 1' + "0" * 400 + ', "do": "hello", "args": {}}',
    "id too long to read": '{"id": 1' + "0" * 5000 + ', "do": "hello", "args": {}}',
    "unknown method": asked("eval", {}),
    "method of a dict": asked("__class__", {}),
    "method no text": asked([], {}),  # type: ignore[arg-type]
    "channel no text": asked("hello", {}, channel=7),
    "channel long": asked("hello", {}, channel="c" * 100),
    "more keys": asked("hello", {}, token=TOKEN),
    "more arguments": asked("hello", {"x": 1}),
    "arguments a list": asked("open", [OCTAHEDRAL]),
    "source missing": asked("open", {}),
    "source null": asked("open", {"source": None}),
    "source kind": asked("open", {"source": {"kind": "path", "id": "/etc/passwd"}}),
    "source keys": asked("open", {"source": {"kind": "class", "id": "3-3.3", "name": "x"}}),
    "class unknown": asked("open", {"source": {"kind": "class", "id": "9-9"}}),
    "class long": asked("open", {"source": {"kind": "class", "id": "x" * 10_000}}),
    "robot is a path": asked("open", {"source": {"kind": "robot", "id": "../../etc/passwd"}}),
    "robot is a file": asked("open", {"source": {"kind": "robot", "id": "plugins/3-rps/robot.yaml"}}),
    "example is a path": asked("open", {"source": {"kind": "example", "name": "../pyproject"}}),
    "legs wrong": asked("open", {"source": {"kind": "legs", "legs": "ab cd"}}),
    "legs nested": asked("open", {"source": {"kind": "legs", "legs": "(" * 3000}}),
    "file empty": asked("open", {"source": {"kind": "file", "text": " ", "name": "x"}}),
    "file with anchors": asked("open", {"source": {"kind": "file", "text": "a: &a [*a, *a]\nlegs: *a\n", "name": "x"}}),
    "file nested": asked("open", {"source": {"kind": "file", "text": "legs: " + "[" * 5000, "name": "x"}}),
    "file of tags": asked("open", {"source": {"kind": "file", "text": "!!python/object/apply:f []", "name": "x"}}),
    "lone surrogate": asked("open", {"source": {"kind": "legs", "legs": "\ud800"}}),
    "null character": asked("open", {"source": {"kind": "legs", "legs": "ab\0cd"}}),
    "pose short": asked("pose", POSE | {"pose": {"translation": [0, 0], "quaternion": [1, 0, 0, 0]}}),
    "pose of texts": asked("pose", POSE | {"pose": {"translation": ["0", "0", "0"], "quaternion": [1, 0, 0, 0]}}),
    "pose of truths": asked("pose", POSE | {"pose": {"translation": [True, 0, 0], "quaternion": [1, 0, 0, 0]}}),
    "pose far away": asked("pose", POSE | {"pose": {"translation": [1e300, 0, 0], "quaternion": [1, 0, 0, 0]}}),
    "no turn": asked("pose", POSE | {"pose": {"translation": [0, 0, 0], "quaternion": [0, 0, 0, 0]}}),
    "threshold": asked("pose", POSE | {"threshold": "2"}),
    "threshold of a unit": asked("pose", POSE | {"threshold": "2 parsec"}),
    "poses none": asked("along", {"source": OCTAHEDRAL, "poses": []}),
    "poses many": asked("along", {"source": OCTAHEDRAL, "poses": [HOME] * 3000}),
    "commands no list": asked("manual", {"source": OCTAHEDRAL, "commands": "auto"}),
    "commands many": asked("manual", {"source": OCTAHEDRAL, "commands": ["undo"] * 1000}),
    "bench long": asked("bench", {"text": "a" * 30_000}),
    "format": asked("save", POSE | {"what": "exe"}),
    "picture": asked("save", POSE | {"what": "png"}),
    "drawing": asked("compose", {"drawing": {}}),
    "drawing of legs": asked("compose", {"drawing": DRAWING | {"legs": [["A", "a", "b"]]}}),
    "cancel nothing": asked("cancel", {"target": "1"}),
    "too long": "x" * (LONGEST + 1),
    "ten megabytes": json.dumps({"id": 1, "do": "bench", "args": {"text": "x" * 10_000_000}}),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_messages_get_an_error(page: Page, name: str) -> None:
    message = HOSTILE[name]
    if isinstance(message, bytes):
        page.socket.send_bytes(message)
    else:
        page.socket.send_text(message)
    while "progress" in (found := json.loads(page.socket.receive_text())):
        pass
    assert found["ok"] is False
    assert found["error"]["kind"] in ("input", "limit")
    assert found["error"]["message"]
    assert len(found["error"]["message"]) < 1000
    page.number = 10
    assert page.ask("hello")["version"] == gc.__version__


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=6), inner, max_size=4),
    max_leaves=12,
)
cheap = ["hello", "pose", "open", "manual", "bench", "compose", "along", "save", "cancel", "nearest"]


@st.composite
def broken(draw: st.DrawFn) -> str:
    """A request of which one part is anything at all."""
    args: dict[str, Any] = {"source": OCTAHEDRAL, "pose": HOME}
    message: dict[str, Any] = {"id": 1, "do": draw(st.sampled_from(cheap)), "args": args}
    place = draw(st.sampled_from(["id", "args", "channel", "source", "pose", "translation", "quaternion", "id of"]))
    value = draw(json_values)
    if place in ("id", "args", "channel"):
        message[place] = value
    elif place in ("source", "pose"):
        args[place] = value
    elif place == "id of":
        args["source"] = {
            "kind": draw(st.sampled_from(["class", "legs", "robot", "example"])),
            "id": value,
            "legs": value,
        }
    else:
        args["pose"] = HOME | {place: value}
    return json.dumps(message)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.one_of(broken(), st.text(max_size=40), json_values.map(json.dumps), st.binary(max_size=20)))
def test_fuzzed_messages_leave_the_server_up(page: Page, message: str | bytes) -> None:
    if isinstance(message, bytes):
        page.socket.send_bytes(message)
    else:
        page.socket.send_text(message.encode("utf-8", "replace").decode())
    page.number += 1000
    probe = page.send("hello")
    while (found := json.loads(page.socket.receive_text())).get("id") != probe:
        if "error" in found:
            assert found["error"]["kind"] != "fault", found
    assert found["ok"]


# --- many requests -------------------------------------------------------------------------------------------------


def test_latest_wins(page: Page) -> None:
    page.ask("pose", **POSE)
    poses = [HOME | {"translation": [n / 1000, 0, 0]} for n in range(40)]
    sent = [page.send("pose", channel="pose", source=OCTAHEDRAL, pose=pose) for pose in poses]
    last = page.answer(sent[-1])
    assert last["ok"]
    assert last["result"]["pose"]["translation"][0] == 0.039
    others = [page.answer(n) for n in sent[:-1]]
    assert all(a["ok"] or a["error"]["kind"] == "superseded" for a in others)
    assert sum(a["ok"] for a in others) < len(others)


def test_slow_work_on_a_channel_gives_way(page: Page) -> None:
    slow = [page.send("nearest", channel="n", source={"kind": "class", "id": "6-6"}, pose=HOME) for _ in range(3)]
    last = page.send("bench", channel="n", text="[abcd]")
    assert page.answer(last)["ok"]
    assert [page.answer(n)["error"]["kind"] for n in slow] == ["superseded"] * 3


def test_cancel_ends_the_work(page: Page) -> None:
    slow = page.send("nearest", source={"kind": "class", "id": "6-6"}, pose=HOME)
    assert page.ask("cancel", target=slow) == {"cancelled": True}
    assert page.answer(slow)["error"]["kind"] == "cancelled"
    assert page.ask("cancel", target=slow) == {"cancelled": False}
    assert page.ask("bench", text="[abcd]")["fault"] is None


def test_floods_are_bounded(page: Page) -> None:
    sent = [page.send("bench", text=f"[[ab, cd, ef, gh, ij, k{n}]]") for n in range(200)]
    answers = [page.answer(n) for n in sent]
    limits = [a for a in answers if not a["ok"]]
    assert 0 < len(limits) <= 200 - 64
    assert {a["error"]["kind"] for a in limits} == {"limit"}


def test_same_number_twice(page: Page) -> None:
    legs = {"kind": "legs", "legs": "ab ac bd be cf cg"}
    message = json.dumps({"id": 5, "do": "manual", "args": {"source": legs, "commands": ["auto"]}})
    page.socket.send_text(message)
    page.socket.send_text(message)
    page.number = 5
    assert "is being answered" in page.answer(5)["error"]["message"]
    assert page.answer(5)["ok"]


def test_two_pages_do_not_hear_each_other(client: TestClient) -> None:
    with client.websocket_connect("/ws", headers=KNOWN) as one, client.websocket_connect("/ws", headers=KNOWN) as two:
        first, second = Page(one), Page(two)
        second.ask("pose", **POSE)
        first.number = second.number
        slow = first.send("open", source={"kind": "legs", "legs": "ac ad bc be cf cg"})
        assert second.send("pose", **POSE) == slow
        assert second.answer(slow)["result"]["verdict"] == "regular"
        assert second.ask("cancel", target=slow) == {"cancelled": False}
        assert first.answer(slow)["ok"]


def test_pages_are_bounded(client: TestClient) -> None:
    with ExitStack() as stack:
        for _ in range(MOST_PAGES):
            stack.enter_context(client.websocket_connect("/ws", headers=KNOWN))
        with pytest.raises(WebSocketDisconnect), client.websocket_connect("/ws", headers=KNOWN):
            pass
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        assert Page(socket).ask("hello")["version"] == gc.__version__


def test_a_page_that_leaves_ends_its_work(client: TestClient) -> None:
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        for _ in range(6):
            Page(socket).send("nearest", source={"kind": "class", "id": "6-6"}, pose=HOME)
    with client.websocket_connect("/ws", headers=KNOWN) as socket:
        assert Page(socket).ask("bench", text="[abcd]")["fault"] is None


def test_time_limit_ends_a_worker() -> None:
    async def run() -> None:
        pool = Pool(1, late=0.0)
        try:
            with pytest.raises(LimitReached, match=r"within 0\.01 seconds"):
                await pool.run(("open", {"source": OCTAHEDRAL}, None), 0.01, lambda _: None)
            result, subject = await pool.run(("open", {"source": OCTAHEDRAL}, None), 60, lambda _: None)
            assert result["kind"] == "platform"
            assert subject is not None
        finally:
            await pool.close()

    asyncio.run(run())


OPEN = ("open", {"source": OCTAHEDRAL}, None)


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_worker_that_is_killed_costs_nobody_an_answer() -> None:
    """While it waits, while it starts, and in the middle of work."""
    chance = random.Random(1)

    async def run() -> None:
        pool = Pool(2)

        async def kill(after: float) -> None:
            await asyncio.sleep(after)
            for process in list(pool.all):
                if process.returncode is None:
                    os.kill(process.pid, signal.SIGKILL)

        try:
            for _ in range(6):
                killing = asyncio.ensure_future(kill(chance.uniform(0, 0.6)))
                result, _ = await pool.run(OPEN, 60, lambda _: None)
                assert result["kind"] == "platform"
                await killing
                assert (await pool.run(OPEN, 60, lambda _: None))[0]["kind"] == "platform"
        finally:
            await pool.close()

    asyncio.run(run())


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_job_that_ends_every_worker_is_a_fault_and_the_next_is_none() -> None:
    async def run() -> None:
        pool = Pool(1)

        def kill(_: str) -> None:
            for process in list(pool.all):
                if process.returncode is None:
                    os.kill(process.pid, signal.SIGKILL)

        try:
            with pytest.raises(EngineFault, match="twice"):
                await pool.run(OPEN, 60, kill)  # as soon as it says what it does
            assert (await pool.run(OPEN, 60, lambda _: None))[0]["kind"] == "platform"
        finally:
            await pool.close()

    asyncio.run(run())


def test_what_a_worker_prints_is_no_frame() -> None:
    script = (
        "import os, sys, gcrules.apps.studio.worker as w\n"
        "w.done = lambda *given: (os.write(1, b'loud'), print('loud'), ('done', 1, None))[2]\n"
        "w.serve()\n"
    )
    sent = framed(("bench", {}, None))
    done = subprocess.run([sys.executable, "-c", script], input=sent, capture_output=True, timeout=60)
    assert done.stdout == framed(("done", 1, None))


# --- who may speak -------------------------------------------------------------------------------------------------

STRANGERS = {
    "no token": HERE,
    "wrong token": HERE | {"cookie": f"{COOKIE}={'y' * 43}"},
    "empty token": HERE | {"cookie": f"{COOKIE}="},
    "broken cookie": HERE | {"cookie": ';;="'},
    "other origin": KNOWN | {"origin": "http://evil.example"},
    "origin null": KNOWN | {"origin": "null"},
    "origin of another port": KNOWN | {"origin": "http://127.0.0.1:1"},
    "origin by https": KNOWN | {"origin": f"https://127.0.0.1:{PORT}"},
    "origin that begins alike": KNOWN | {"origin": f"{OWN}.evil.example"},
    "origin of the other name": KNOWN | {"origin": f"http://localhost:{PORT}"},
    "no origin": {"host": HERE["host"], "cookie": KNOWN["cookie"]},
    "other host": KNOWN | {"host": f"evil.example:{PORT}", "origin": f"http://evil.example:{PORT}"},
    "host of another port": KNOWN | {"host": "127.0.0.1:1", "origin": "http://127.0.0.1:1"},
    "host without a port": KNOWN | {"host": "127.0.0.1", "origin": "http://127.0.0.1"},
}


@pytest.mark.parametrize("name", STRANGERS)
def test_strangers_get_no_websocket(client: TestClient, name: str) -> None:
    with pytest.raises(WebSocketDisconnect), client.websocket_connect("/ws", headers=STRANGERS[name]):
        pass


def test_localhost_is_a_name_of_its_own(client: TestClient) -> None:
    named = KNOWN | {"host": f"localhost:{PORT}", "origin": f"http://localhost:{PORT}"}
    with client.websocket_connect("/ws", headers=named) as socket:
        assert Page(socket).ask("hello")["version"] == gc.__version__


def test_token_becomes_a_cookie(client: TestClient) -> None:
    assert client.get("/").status_code == 403
    assert client.get("/?token=wrong").status_code == 403
    answer = client.get(f"/?token={TOKEN}", follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (303, "/")
    cookie = answer.headers["set-cookie"].lower()
    assert "httponly" in cookie
    assert "samesite=strict" in cookie
    client.cookies.clear()


def test_ticket_is_good_once() -> None:
    client = TestClient(make_app(PORT, TOKEN, tickets=["t" * 43]), base_url=OWN)
    assert [client.get(f"/?ticket={t}").status_code for t in ("", "x", "t" * 42, TOKEN)] == [403] * 4
    answer = client.get(f"/?ticket={'t' * 43}", follow_redirects=False)
    assert (answer.status_code, answer.headers["location"]) == (303, "/")
    assert TOKEN in answer.headers["set-cookie"]
    client.cookies.clear()
    assert client.get(f"/?ticket={'t' * 43}").status_code == 403


def test_port_that_browsers_leave_out() -> None:
    client = TestClient(make_app(80, TOKEN), base_url="http://127.0.0.1")
    known = {"cookie": KNOWN["cookie"], "origin": "http://127.0.0.1"}
    assert client.get("/studio.js", headers=known | {"host": "127.0.0.1"}).status_code == 200
    assert client.get("/studio.js", headers=known | {"host": f"127.0.0.1:{PORT}"}).status_code == 421


@pytest.mark.parametrize(
    ("path", "headers", "status"),
    [
        ("/", {"host": "evil.example"}, 421),
        ("/studio.js", {"host": f"evil.example:{PORT}"}, 421),
        ("/studio.js", {"origin": "http://evil.example"}, 403),
        ("/../pyproject.toml", {}, 404),
        ("/%2e%2e/app.py", {}, 404),
        ("/..%2fapp.py", {}, 404),
        ("//etc/passwd", {}, 404),
        ("/fonts/", {}, 404),
        ("/static/index.html", {}, 404),
    ],
)
def test_nothing_else_is_served(client: TestClient, path: str, headers: dict[str, str], status: int) -> None:
    assert client.get(path, headers=headers | {"cookie": KNOWN["cookie"]}).status_code == status


def test_only_get_is_served(client: TestClient) -> None:
    for method in ("POST", "PUT", "DELETE", "OPTIONS"):
        assert client.request(method, "/", headers={"cookie": KNOWN["cookie"]}).status_code == 405


def test_files_have_types_tags_and_a_policy(client: TestClient, tmp_path: Path) -> None:
    from starlette.applications import Starlette
    from starlette.routing import Route

    (tmp_path / "fonts").mkdir()
    for name in ("index.html", "studio.js", "studio.css", "fonts/a.woff2", "secret.pem"):
        (tmp_path / name).write_text(name)
    pages = Pages(tmp_path)
    app = Starlette(routes=[Route("/", pages.answer), Route("/{name:path}", pages.answer)])
    served = TestClient(app, base_url=OWN)
    types = {
        "/": "text/html",
        "/studio.js": "text/javascript",
        "/studio.css": "text/css",
        "/fonts/a.woff2": "font/woff2",
    }
    for path, mime in types.items():
        answer = served.get(path)
        assert answer.headers["content-type"].startswith(mime)
        assert served.get(path, headers={"if-none-match": answer.headers["etag"]}).status_code == 304
    assert served.get("/secret.pem").status_code == 404
    (tmp_path / "studio.js").write_text("changed")
    os.utime(tmp_path / "studio.js", ns=(1, 1))
    assert served.get("/studio.js").text == "changed"
    policy = client.get("/").headers["content-security-policy"]
    assert "default-src 'self'" in policy
    assert "unsafe-eval" not in policy
    assert "script-src 'self';" in policy


# --- the token's file ----------------------------------------------------------------------------------------------

needs_modes = pytest.mark.skipif(sys.platform == "win32", reason="needs modes of files")


def test_token_is_kept(tmp_path: Path) -> None:
    first = token_file.token(tmp_path / "state")
    assert re.fullmatch(r"[\w-]{43}", first)
    assert token_file.token(tmp_path / "state") == first
    assert token_file.token(tmp_path / "other") != first
    assert [p.name for p in (tmp_path / "state").iterdir()] == ["studio-token"]


@needs_modes
def test_token_is_for_the_user_alone(tmp_path: Path) -> None:
    first = token_file.token(tmp_path)
    path = tmp_path / "studio-token"
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    path.chmod(0o644)
    second = token_file.token(tmp_path)
    assert second != first
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


@needs_modes
@pytest.mark.parametrize("text", ["", "short", "x" * 44, "\xff" * 43])
def test_token_file_at_fault_is_made_anew(tmp_path: Path, text: str) -> None:
    path = tmp_path / "studio-token"
    path.write_bytes(text.encode("latin-1"))
    path.chmod(0o600)
    assert token_file.token(tmp_path) != text


@needs_modes
def test_token_is_no_link(tmp_path: Path) -> None:
    target = tmp_path / "target"
    target.write_text("z" * 43)
    target.chmod(0o600)
    (tmp_path / "studio-token").symlink_to(target)
    assert token_file.token(tmp_path) != "z" * 43
    assert target.read_text() == "z" * 43


@needs_modes
def test_token_is_no_pipe(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "studio-token", 0o600)
    assert re.fullmatch(r"[\w-]{43}", token_file.token(tmp_path))


def test_token_that_cannot_be_kept(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError, match="cannot be kept"):
        token_file.token(tmp_path / "file")


def test_state_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    if sys.platform != "win32":
        monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
        assert token_file.state_folder() == tmp_path / "gcrules"
        monkeypatch.setenv("XDG_STATE_HOME", "relative")
        assert token_file.state_folder().is_relative_to(Path.home())


# --- the command ---------------------------------------------------------------------------------------------------


def test_next_free_port() -> None:
    with serving.free_socket(0) as first:
        port = first.getsockname()[1]
        assert first.getsockname()[0] == "127.0.0.1"
        with serving.free_socket(port) as second:
            assert second.getsockname()[1] != port


def run_studio(state: Path, *arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "gcrules", "studio", "--no-browser", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | {"XDG_STATE_HOME": str(state), "LOCALAPPDATA": str(state), "PYTHONUNBUFFERED": "1"},
    )


def address_of(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    line = process.stdout.readline()
    found = re.search(r"http://127\.0\.0\.1:\d+/\?token=\S+", line)
    assert found, line + (process.stderr.read() if process.stderr and process.poll() is not None else "")
    return found[0]


def test_browser_is_not_started_with_the_token(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Other users of the machine see what a program was started with; a ticket is worth nothing once it was used."""
    asked, said, tickets = [], [], []
    monkeypatch.setattr(serving, "token", lambda: TOKEN)
    monkeypatch.setattr(serving, "make_app", lambda *given: tickets.extend(given[3]) or make_app(*given))
    monkeypatch.setattr(serving.webbrowser, "open", asked.append)
    monkeypatch.setattr(serving.uvicorn.Server, "run", lambda server, sockets: server.ready())
    serving.serve(port=0, say=said.append)
    while not asked:
        time.sleep(0.01)
    assert TOKEN in said[0]
    assert TOKEN not in asked[0]
    assert asked[0].endswith(f"/?ticket={tickets[0]}")


@pytest.mark.skipif(sys.platform == "win32", reason="needs the number of the process that started another")
def test_worker_ends_when_the_server_is_killed() -> None:
    """In the middle of work, which nobody waits for any more."""
    script = (
        "import subprocess, sys, time\n"
        "from gcrules.apps.studio.wire import framed\n"
        "worker = subprocess.Popen([sys.executable, '-m', 'gcrules.apps.studio.worker'], stdin=-1, stdout=1)\n"
        "worker.stdin.write(framed(('bench', {'text': '[abcd]' * 15_000}, None)))\n"
        "worker.stdin.flush()\n"
        "print('at work', flush=True)\n"
        "time.sleep(60)\n"
    )
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        assert server.stdout.readline() == b"at work\n"
        server.kill()
        assert b"done" not in server.stdout.read()  # no answer, and the worker has let the pipe go


BROKEN_FRAMES = {
    "invalid UTF-8": b"\x81\x84\0\0\0\0\xff\xfe\xfd\xfc",
    "no frame": b"\xff" * 40,
    "no mask": b"\x81\x02{}",
    "control frame too long": b"\x89\xfe\x02\0" + bytes(4 + 512),
    "a length of 2^63": b"\x81\xff\x80" + bytes(11),
}


def hello(address: str) -> Any:
    """One connection to a studio that runs, of a page that knows its token."""
    host, _, token = address.removeprefix("http://").partition("/?token=")
    return connect(f"ws://{host}/ws", origin=f"http://{host}", additional_headers={"Cookie": f"{COOKIE}={token}"})


def survives(address: str) -> None:
    """Frames that are none, and one that is far too long, end their own connection only."""
    for broken in BROKEN_FRAMES.values():
        with hello(address) as page:
            page.socket.sendall(broken)
            with pytest.raises(ConnectionClosed):
                page.recv()
    with hello(address) as page:
        page.socket.sendall(b"\x81\xff" + (20_000_000).to_bytes(8, "big") + bytes(4))
        with pytest.raises(ConnectionClosed):
            page.recv()
    with hello(address) as page:
        page.send(json.dumps({"id": 1, "do": "hello", "args": {}}))
        assert json.loads(page.recv())["result"]["opened"] == {"kind": "legs", "legs": "ab af cb cd ed ef"}


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_studio_runs_until_it_is_interrupted(tmp_path: Path) -> None:
    """Twice: the second one has the port and the token of the first, so that an open page goes on with it."""
    addresses: list[str] = []
    for turn in range(2):
        port = addresses[0].split("/")[2].partition(":")[2] if turn else "0"
        process = run_studio(tmp_path, "ab af cb cd ed ef", "--port", port)
        try:
            addresses.append(address_of(process))
            if not turn:
                survives(addresses[0])
            process.send_signal(signal.SIGINT)
            _, errors = process.communicate(timeout=20)
        finally:
            process.kill()
        assert process.returncode == 0, errors
        assert errors == ""
    assert addresses[0] == addresses[1]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["ab cd"], "expected six"),
        (["nowhere.yaml"], "there is no such file"),
        (["ab af cb cd ed ef", "--port", "99999"], "99999"),
        (["-"], "is not a leg"),
    ],
)
def test_studio_refuses(arguments: list[str], words: str) -> None:
    done = CliRunner().invoke(cli, ["studio", "--no-browser", *arguments], input="nothing")
    assert done.exit_code == 2
    assert words in done.stderr


def test_studio_refuses_what_a_page_could_not_send() -> None:
    text = "legs: [ab]\n#" + "x" * 400_000
    done = CliRunner().invoke(cli, ["studio", "--no-browser", "-"], input=text)
    assert done.exit_code == 2
    assert "more than 400,000 characters" in done.stderr


def test_without_the_extra_it_is_said_how_to_get_it() -> None:
    code = (
        "import sys; sys.modules['starlette'] = None; sys.modules['uvicorn'] = None\n"
        "from gcrules.apps.main import main; sys.argv = ['gcrules', 'studio', '--no-browser']; main()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 2
    assert 'pip install "gcrules[studio]"' in done.stderr


def test_stages_are_told_in_words_of_the_table() -> None:
    for source in (OCTAHEDRAL, FOUR_DOF):
        assert {s["id"] for s in stage_views(read_subject(source))} <= set(theory.THEORY)


@pytest.mark.parametrize(
    ("kind", "key", "name"), [("class", "id", "3-3.33"), ("robot", "id", "3-rpx"), ("example", "name", "octahedra")]
)
def test_unknown_sources_are_told_what_is_near(kind: str, key: str, name: str) -> None:
    with pytest.raises(InputError) as fault:
        read_subject({"kind": kind, key: name})
    assert "did you mean" in (fault.value.hint or "")
