"""The studio's server: what it answers. No browser is needed."""

from __future__ import annotations

import gzip
import json
import random
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import (
    Any,
    get_args,
)

import pytest

import gcrules as gc
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.core.errors import InputError
from gcrules.core.shapes import OneOf
from gcrules.mechanisms.description.discovery import examples
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.poses.limbs.exact_values import value_at
from gcrules.screws.verdict import VERDICTS
from gcrules.views import scene_data
from gcrules.views.formulas.latex import latex
from gcrules.views.report.stage_ids import STAGE_IDS

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import DRAWING, FOUR_DOF, HOME, OCTAHEDRAL, Page, assert_fits

from gcrules.apps.studio import theory
from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.formulas import pieces
from gcrules.apps.studio.numbers import exact_pose, numbers
from gcrules.apps.studio.pages import STATIC
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.sources import source_of
from gcrules.apps.studio.study import study
from gcrules.apps.studio.subject import read_subject

# --- both sides say the same ---------------------------------------------------------------------------------------


def test_the_page_has_the_protocol_of_the_server(root: Path) -> None:
    run = subprocess.run([sys.executable, str(root / "tools" / "studio_protocol.py"), "--check"], capture_output=True)
    assert run.returncode == 0, run.stdout.decode()


def test_words_of_the_protocol_are_those_of_the_engine() -> None:
    assert set(get_args(scene_data.Verdict)[1:]) == {OneOf(VERDICTS)}
    assert set(theory.THEORY) == set(STAGE_IDS)


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
    told = [item["statement"] for item in found["classes"] if not item["id"].endswith(("-2", ".s"))]
    assert [words for words in told if told.count(words) > 2] == []
    assert {item["id"] for item in found["robots"] if "hexapod" in item["words"]} >= {"gough-stewart", "6-rus", "6-pus"}
    every = [*found["classes"], *found["robots"], *found["examples"]]

    def called(word: str) -> set[str]:
        return {item["id"] for item in every if word in item["words"].split()}

    assert called("octahedron") == called("MSSM") == {"3-3.3", "octahedral"}
    assert called("TSSM") == {"6-3.2", "gough-stewart-63"}
    assert called("6-SPS") >= {"6-6", "gough-stewart", "octahedral"}
    four = {item["id"] for item in found["robots"] if item["group"].startswith("4 ")}
    assert four == called("4-dof") > {"gallardo-4dof", "h4", "4-ruu"}
    assert called("6-dof") >= {"6-6", "octahedral", "6-rus"}


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


def test_value_and_verdict_of_a_robot_come_first(page: Page) -> None:
    pose = {**HOME, "coordinates": [0.1, 0, 0, 0]}
    found = page.ask("pose", source=FOUR_DOF, pose=pose)
    (headline,) = page.parts
    assert_fits(headline, METHODS["pose"].part)
    assert headline == {name: found[name] for name in headline}
    assert headline["pose"] == pose


@pytest.mark.parametrize("name", ["gallardo-4dof", "3-rps", "delta", "3-upu", "tricept", "3-rpr", "6-rus"])
def test_value_of_a_robot_has_the_exact_sign(name: str) -> None:
    subject = read_subject({"kind": "robot", "id": name})
    assert subject.robot is not None
    assert subject.structure is not None
    robot = subject.robot.robot
    exact = value_at(robot.family, subject.robot.structure, robot.values_at(), subject.structure.superbracket)
    found = numbers(subject, HOME)["value"]
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
    subject = read_subject(source_of(name))
    assert subject.analysis is not None
    assert subject.moving is not None
    rng = random.Random(name)
    units = f"units: {subject.unit}\n" if subject.unit else ""
    text = f"{units}legs: {[list(leg) for leg in subject.analysis.structure.legs]}\npoints:\n"
    text += "".join(f"  {n}: [{', '.join(map(str, p))}]\n" for n, p in subject.points.items())
    robot = parse_platform(text.replace("'", ""))
    for shift in ([0.0, 0.0, 0.0], [0.1 * subject.size * rng.uniform(-1, 1) for _ in range(3)]):
        pose = {"translation": shift, "quaternion": [1.0, 0.1 * bool(any(shift)), 0.0, 0.05 * bool(any(shift))]}
        mine = numbers(subject, pose)
        theirs = gc.pose(robot, exact_pose(pose), about="centroid", nearest=False)
        assert mine["verdict"] == theirs.verdict
        assert mine["reason"] == theirs.reason
        assert mine["margin"] == pytest.approx(theirs.margin, abs=1e-12)
        assert (mine["value"] > 0) == (theirs.value > 0)
        assert mine["causes"] == list(theirs.causes)
        values = [r.value for r in theirs.readings[: len(mine["readings"])]]
        assert [r["value"] for r in mine["readings"]] == pytest.approx(values, rel=1e-9)


def test_every_class_opens_and_has_numbers() -> None:
    for entry in ("6-2", "5-2", "4-4.s", "6-5", "4-4.7"):
        subject = read_subject({"kind": "class", "id": entry})
        json.dumps(study(subject), allow_nan=False)
        found = numbers(subject, HOME)
        assert (found["verdict"] == "singular") == (entry in ("6-2", "5-2", "4-4.s"))


@pytest.mark.parametrize("entry", ["6-2", "5-2", "3-3.3", "6-6"])
@pytest.mark.parametrize("away", [1e2, 1e3, 1e6, 1e13])
def test_far_away_there_are_numbers_or_a_reason(entry: str, away: float) -> None:
    subject = read_subject({"kind": "class", "id": entry})
    pose = {"translation": [away, -away, 0.3 * away], "quaternion": [1.0, 0.3, -0.2, 0.1]}
    if away > 1e4:
        with pytest.raises(InputError, match="times the robot's size away"):
            numbers(subject, pose)
    else:
        found = numbers(subject, pose)
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


@pytest.mark.parametrize(
    ("legs", "points", "verdict", "words"),
    [
        ("ap bp cp aq bq cr", {"r": [2, 0, 1]}, "singular", "p, q, r of the platform lie on one line, so the robot is"),
        ("ap bp cp aq bq cr", {"r": [2, 0, 1]}, "singular", "they depend on each other, so the pose is singular"),
        (
            "ap bp cp aq bq ab",
            {},
            "singular",
            "do not tell whether a, b, c, p, q belong to the base or the platform. Only",
        ),
        ("ap bp cq ar br ab", {"q": [0.3, 0.9, 0.7]}, "regular", "do not depend on each other, so the pose is not"),
        ("ap bp cq ar br ab", {"q": [0.3, 0.9, 0.7]}, "regular", "and not an angle"),
    ],
)
def test_what_is_examined_of_shapes_without_a_platform_is_said(
    page: Page, legs: str, points: dict[str, list[float]], verdict: str, words: str
) -> None:
    at = {"a": [0, 0, 0], "b": [1, 0, 0], "c": [0, 1, 0], "p": [0, 0, 1], "q": [1, 0, 1], "r": [0, 1, 1], **points}
    named = {n: at[n] for n in sorted(set(legs) - {" "})}
    text = json.dumps({"title": "X", "points": named, "legs": [list(leg) for leg in legs.split()]})
    found = page.ask("pose", source={"kind": "file", "name": "x.yaml", "text": text}, pose=HOME)
    assert found["verdict"] == verdict
    assert words in found["reason"]


def test_legs_that_are_joined_so_that_they_are_always_singular_are_said_to_be(page: Page) -> None:
    found = page.ask("pose", source={"kind": "legs", "legs": "aA aB aC bA bB bC"}, pose=HOME)
    assert found["reason"].endswith("depend on each other in every pose: proved.")
    assert "line ab" in found["causes"][0]


def test_nearest_and_the_way_there(page: Page) -> None:
    source = {"kind": "example", "name": "octahedral"}
    found = page.ask("nearest", source=source, pose=HOME)["found"]
    assert [f["kind"] for f in found] == ["translation", "rotation", "combined"]
    assert any(words.startswith("seeking the nearest singular poses") for words in page.progress)
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
    assert any(words.startswith("searching along +yaw") for words in page.progress)
    assert "does not prove" in found["note"]
    every, one = found["found"][:2]
    assert (every["kind"], every["unit"], every["certified"]) == ("in any direction", "", False)
    assert (one["kind"], one["unit"], one["certified"]) == ("along +yaw", "deg", False)
    for met in (every, one):
        assert "meet in a point or are parallel" in met["causes"][0]
        assert "no proof" in met["text"]
        there = page.ask("pose", source=source, pose=met["pose"])
        assert there["verdict"] != "regular"
        assert there["margin"] < 1e-4


def test_search_around_says_that_nothing_was_found(page: Page) -> None:
    found = page.ask("nearest", source={"kind": "robot", "id": "3-puu"}, pose=HOME)
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
    assert [e["label"] for e in found["entities"]] == ["abc", "bdf"]
    assert [e["starred"] for e in found["entities"]] == ["abc", "b*df"]
    assert found["hint"]["command"]
    assert found["fault"] is None
    done = page.ask("manual", source=legs, commands=["plane abc", "auto"])
    assert done["condition"]["kind"] == "four-planes"
    assert done["hint"] is None


def test_manual_counterexample_refutes(page: Page) -> None:
    legs = "ab af cb cd ed ef"
    found = page.ask("manual", source={"kind": "legs", "legs": legs}, commands=[r"condition abc /\ aef /\ bdf /\ cef"])
    assert found["history"][0]["answer"] == "refused"
    told = found["counterexample"]
    points = {n: (*map(Fraction, p["exactly"]), Fraction(1)) for n, p in told.items()}
    robot, refuted = gc.analyze(legs).structure.superbracket, gc.parse(r"abc /\ aef /\ bdf /\ cef")
    assert evaluate(robot, points) == 0 != evaluate(refuted, points)
    assert all(p["at"] == [float(c) for c in points[n][:3]] for n, p in told.items())


@pytest.mark.parametrize(
    ("hint", "shown"),
    [("write z=5", "write z=5"), ("ask for less by --margin", None), ("as in --over 'x 1:2'", None), (None, None)],
)
def test_hints_name_no_options_of_the_command_line(hint: str | None, shown: str | None) -> None:
    assert fault_view(InputError("no", hint=hint)).get("hint") == shown


def test_the_general_platform_is_told_of_no_entities(page: Page) -> None:
    why = {s["id"]: s["why"] for s in page.ask("open", source={"kind": "class", "id": "6-6"})["stages"]}
    assert "linear complex" in why["condition"]
    assert "planes that meet" not in why["condition"]
    why = {s["id"]: s["why"] for s in page.ask("open", source=OCTAHEDRAL)["stages"]}
    assert "planes that meet" in why["condition"]


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
        ("latex", "\\begin{filecontents}"),
        ("svg", "<svg"),
        ("pdf", "JVBERi0"),
        ("json", "{"),
        ("yaml", "title:"),
        ("proof", '"format": "gcrules proof"'),
        ("coq", "(* "),
    ],
)
def test_saving(page: Page, source: dict[str, str], what: str, begins: str) -> None:
    if what == "pdf":
        pytest.importorskip("matplotlib")
    found = page.ask("save", source=source, pose=HOME, what=what)
    assert found["name"].endswith({"latex": ".tex", "proof": ".proof.json", "coq": ".v"}.get(what, what))
    assert re.fullmatch(r"[a-z0-9.-]+", found["name"])
    assert found["binary"] == (what == "pdf")
    assert begins in found["data"][:200]
    if what == "json":
        assert json.loads(found["data"])["studio_pose"]["verdict"] == "regular"


@pytest.mark.parametrize(("what", "language"), [("c", "c"), ("cpp", "cpp"), ("py", "python"), ("rs", "rust")])
def test_code_for_a_controller_is_saved(page: Page, what: str, language: str) -> None:
    found = page.ask("save", source={"kind": "robot", "id": "delta"}, pose=HOME, what=what)
    assert found["name"] == f"delta-robot-with-rods.{what}"
    assert found["data"] == gc.export("delta", language=language)
    by_newton = page.ask("save", source={"kind": "robot", "id": "tricept"}, pose=HOME, what=what)
    assert by_newton["data"] == gc.export("tricept", language=language)


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
