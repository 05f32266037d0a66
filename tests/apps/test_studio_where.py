"""Where the robot can go, in the studio: the answers are those of the library, and lead the robot on the page."""

from __future__ import annotations

import gzip
import json
import re
import subprocess
import sys
from base64 import b64decode
from pathlib import Path
from typing import Any

import pytest

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import HOME, Page
from places import EXAMPLES, ROOT

from gcrules.views.numerals import in_prose

OCTAHEDRAL = {"kind": "example", "name": "octahedral"}
FILE = str(EXAMPLES / "octahedral.yaml")
RPR = {"kind": "robot", "id": "3-rpr"}
AWAY = {"translation": [0.0, 0.0, -30.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}


def facts(found: dict[str, Any]) -> dict[str, str]:
    """What is told beside the sentence; of a name that comes twice the last."""
    return {f["key"]: f["value"] for f in found["facts"]}


def told(result: Any) -> str:
    """The text of a result in one line, for what is wrapped there, with its numbers as pages show them."""
    return in_prose(" ".join(result.text(unicode=True).split()))


@pytest.mark.parametrize("pose", [HOME, AWAY], ids=["home", "away"])
def test_assembly_modes_of_a_platform_are_poses(page: Page, pose: dict[str, Any]) -> None:
    found = page.ask("assemblies", source=OCTAHEDRAL, pose=pose)
    same = gc.assembly_modes(FILE, "0 0 -30" if pose is AWAY else None)
    assert [(m["number"], m["verdict"], m["given"]) for m in found["modes"]] == [
        (m.number, m.verdict, m.given) for m in same.modes
    ]
    assert [m["sure"] for m in found["modes"]] == [m.certificate.method for m in same.modes]
    assert found["verdict"] in told(same)
    assert facts(found)["certified"] in told(same)
    for mode in found["modes"]:
        assert mode["svg"].startswith("<svg")
        there = page.ask("pose", source=OCTAHEDRAL, pose=mode["pose"])
        assert there["margin"] == pytest.approx(mode["margin"], abs=1e-7)


def test_assembly_modes_of_a_robot_are_homes(page: Page) -> None:
    found = page.ask("assemblies", source=RPR, pose={**HOME, "coordinates": [0.1, 0, 0]})
    same = gc.assembly_modes("3-rpr")
    assert [m["mode"] for m in found["modes"]] == [None, "assembly 2"]
    assert all(m["pose"] is None for m in found["modes"])
    there = page.ask("pose", source=RPR | {"mode": "assembly 2"}, pose=HOME)
    assert there["margin"] == pytest.approx(same.modes[1].margin, abs=1e-9)
    listed = page.ask("assemblies", source=RPR | {"mode": "assembly 2"}, pose=HOME)
    assert listed["modes"] == found["modes"]


@pytest.mark.parametrize(("source", "robot"), [(OCTAHEDRAL, FILE), (RPR, "3-rpr")], ids=["six legs", "joints"])
def test_aspects(page: Page, source: dict[str, str], robot: str) -> None:
    found = page.ask("aspects", source=source)
    same = gc.aspects(robot)
    assert (found["least"], found["most"]) == (same.least, same.most)
    assert [(s["name"], s["poses"], tuple(s["modes"])) for s in found["sets"]] == [
        (s.name, len(s.poses), s.modes) for s in same.sets
    ]
    assert found["verdict"] in told(same)
    assert any(s["pose"] for s in found["sets"])
    for one in found["sets"]:
        if one["pose"] is not None:
            there = page.ask("pose", source=source, pose=one["pose"])
            assert there["margin"] == pytest.approx(one["margin"], abs=1e-5)


def test_a_free_ball_around_a_pose(page: Page) -> None:
    found = page.ask("free", source=OCTAHEDRAL, pose=AWAY, shape="ball")
    same = gc.free_region(FILE, "0 0 -30", ball=True)
    assert found["verdict"].removesuffix(".") in told(same)
    assert [r["name"] for r in found["ranges"]] == list(same.names)
    for one, half in zip(found["ranges"], same.half_widths, strict=True):
        assert float(one["high"]) == -float(one["low"])
        shown = float(one["high"]) * (3.14159265358979 / 180 if one["unit"] == "deg" else 1)
        assert half * (1 - 1e-5) < shown <= half


def test_a_free_box_of_a_robot_of_joints(page: Page) -> None:
    found = page.ask("free", source=RPR, pose={**HOME, "coordinates": [0, 0, 0]}, shape="box")
    assert found["verdict"].removesuffix(".") in told(gc.free_region("3-rpr"))
    assert [r["name"] for r in found["ranges"]] == ["x", "y", "yaw"]


@pytest.mark.parametrize("shape", ["cube", True, None])
def test_shapes_are_checked(page: Page, shape: Any) -> None:
    assert page.fault("free", source=OCTAHEDRAL, pose=HOME, shape=shape)["kind"] == "input"


def test_around_a_singular_pose_nothing_is_free(page: Page) -> None:
    singular = {"translation": [0.0, 0.0, -350.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}
    assert "nothing is proved" in page.fault("free", source=OCTAHEDRAL, pose=singular, shape="box")["message"]


# --- whole ranges ---------------------------------------------------------------------------------------------------

BOXES = {"margin": 0.01, "boxes": 4_000}


def boxes(page: Page, source: dict[str, str], over: list[str], pose: Any = HOME, **more: Any) -> Any:
    return page.ask("boxes", source=source, over=over, pose=pose, **BOXES | more)


def test_whole_ranges_of_a_platform(page: Page) -> None:
    over = ["x -60:60", "z -60:60", "yaw -20:20 deg"]
    found = boxes(page, OCTAHEDRAL, over, AWAY, limits="leg lengths 200..500")
    same = gc.box_map(FILE, over, "0 0 -30", margin=0.01, limits="leg lengths 200..500", tiles=8, boxes=6)
    assert found["verdict"].removesuffix(".") in told(same)
    assert facts(found)["limits"] in told(same)
    shares = {s["kind"]: s["share"] for s in found["shares"]}
    assert sum(shares.values()) == pytest.approx(1)
    assert shares["free"] == pytest.approx(same.summary.shares[0])
    assert found["decided"] == pytest.approx(same.summary.decided)
    assert found["so_much"].endswith("or not to be reached within the limits.")


def test_whole_ranges_of_a_robot_of_joints(page: Page) -> None:
    pytest.importorskip("matplotlib")
    study = page.ask("open", source=RPR)
    assert [r["name"] for r in study["wholes"]] == ["x", "y", "yaw"]
    found = boxes(page, RPR, ["x -0.5:0.5", "yaw -60:80 deg"], {**HOME, "coordinates": [0, 0, 0]}, margin=0.0)
    assert "is not free" in found["verdict"]
    words = {s["kind"]: s["words"] for s in found["shares"]}
    assert words["crossed"].endswith("in boxes that hold a pose that is singular")
    assert words["other"].endswith("free with the other sign")
    assert b64decode(found["picture"]).startswith(b"<?xml")
    assert found["seen"].startswith("Boxes of poses of Planar 3-RPR robot over x and yaw: ")


def test_the_other_coordinates_are_those_of_the_pose(page: Page) -> None:
    """Two legs of other lengths: the platform stands elsewhere, and y goes with it."""
    moved = {**HOME, "coordinates": [0.1, 0.0, 0.05]}
    found = boxes(page, RPR, ["x -0.2:0.2"], moved)
    rest = facts(found)["rest"]
    assert "y = 0," not in rest
    assert "yaw" in rest
    assert "rest" not in facts(boxes(page, RPR, ["x -0.2:0.2", "y -0.1:0.1", "yaw -5:5 deg"], moved))


@pytest.mark.parametrize(
    ("over", "more", "message"),
    [
        ([], {}, "over"),
        (["x 1:-1"], {}, "reversed"),
        (["x -1:1", "x -1:1"], {}, "twice"),
        (["q1 -1:1 deg"], {}, "range over q1|no actuator|not mapped"),
        (["x -1:1"], {"margin": 2}, "margin"),
        (["x -1:1"], {"boxes": 0}, "boxes"),
        (["x -1:1"], {"boxes": 10**9}, "boxes"),
        (["x -1:1"], {"limits": "q9 1..2"}, "q9"),
    ],
)
def test_faults_of_whole_ranges(page: Page, over: list[str], more: dict[str, Any], message: str) -> None:
    fault = page.fault("boxes", source=OCTAHEDRAL, over=over, pose=HOME, **BOXES | more)
    assert fault["kind"] == "input"
    assert re.search(message, str(fault))


# --- certificates ---------------------------------------------------------------------------------------------------

HEAD = {"kind": "robot", "id": "reachy-mini-head"}


def certified(page: Page, source: dict[str, str], over: list[str], pose: Any = HOME, **more: Any) -> Any:
    return page.ask("certify", source=source, over=over, pose=pose, **{"boxes": 4_000, **more})


def test_a_certificate_is_that_of_the_library(page: Page) -> None:
    over, more = ["x -50:50", "roll -10:10 deg"], {"cone": "60 deg", "tilt": "8 deg", "limits": "legs 300..900"}
    found = certified(page, OCTAHEDRAL, over, AWAY, margin=0.05, **more)
    same = gc.certify(FILE, over, "0 0 -30", margin=0.05, boxes=4_000, **more)
    assert found["answer"] == same.verdict == "free"
    assert found["verdict"].removesuffix(".") in told(same)
    assert found["bound"] == same.bound
    assert found["decided"] == same.decided == 1
    assert sum(s["share"] for s in found["shares"]) == pytest.approx(1)
    assert {f["value"] for f in found["facts"]} >= {"a margin of 0.05 at least", "tilt ≤ 8 deg in any direction"}
    assert "check_certificate.py FILE" in found["check"]
    assert found["place"]["kind"] == "least"
    assert found["place"]["margin"] == same.least
    there = page.ask("pose", source=OCTAHEDRAL, pose=found["place"]["pose"])
    assert there["margin"] == pytest.approx(same.least)
    assert any("decided" in words for words in page.progress)


def test_the_file_of_a_certificate(page: Page) -> None:
    over = ["x -50:50", "roll -10:10 deg"]
    found = certified(page, OCTAHEDRAL, over)
    file = found["file"]
    assert (file["name"], file["binary"]) == ("octahedral-platform-3-3-certificate.json.gz", True)
    same = json.loads(json.dumps(gc.certify(FILE, over, boxes=4_000).to_json()))
    assert json.loads(gzip.decompress(b64decode(file["data"]))) == same


def test_the_platform_is_taken_to_the_singular_pose_of_a_certificate(page: Page) -> None:
    pytest.importorskip("matplotlib")
    found = certified(page, OCTAHEDRAL, ["z -400:0", "roll -5:5 deg"])
    place = found["place"]
    assert (found["answer"], place["kind"], place["short"]) == ("singular", "singular", False)
    there = page.ask("pose", source=OCTAHEDRAL, pose=place["pose"])
    assert there["verdict"] == "singular"
    assert there["margin"] == pytest.approx(place["margin"], abs=1e-9)
    assert place["causes"] == [f["value"] for f in found["facts"] if f["key"] == "cause"]
    assert b64decode(found["picture"]).startswith(b"<?xml")
    assert found["seen"].startswith("Boxes of poses of Octahedral platform (3-3) over z and roll: ")


def test_actuators_that_come_to_a_stop_end_just_short_of_it(page: Page) -> None:
    found = certified(page, HEAD, ["yaw 0:95 deg"])
    place = found["place"]
    assert place["words"].startswith("yaw = 93.2")
    assert "linear complex" in place["causes"][0]
    assert place["short"]
    there = page.ask("pose", source=HEAD, pose=place["pose"])
    assert there["margin"] < 1e-2


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"over": []}, "over"),
        ({"over": ["x -1:1:5"]}, "not a range"),
        ({"cone": "40"}, "is not a cone"),
        ({"cone": "Z 40 deg"}, "not a ball or universal joint"),
        ({"tilt": "40"}, "not an angle"),
        ({"tilt": 40}, "tilt"),
        ({"boxes": 0}, "boxes"),
        ({"margin": 2}, "margin"),
    ],
)
def test_faults_of_certificates(page: Page, more: dict[str, Any], message: str) -> None:
    fault = page.fault("certify", source=OCTAHEDRAL, pose=HOME, **{"over": ["x -1:1"], "boxes": 4_000, **more})
    assert fault["kind"] == "input"
    assert re.search(message, str(fault))


SLICE = {"over": ["z -0.2:0.2:9", "roll -20:20:9 deg"], "pose": HOME}
CHECKED: dict[str, tuple[str, dict[str, Any], str]] = {
    "free": ("3-rps", {"pose": HOME, "shape": "box"}, "check_free"),
    "boxes": ("3-rps", {"over": ["z -0.1..0.1", "roll -10..10 deg"], "pose": HOME, "boxes": 2000}, "check_boxes"),
    "map": ("3-rps", SLICE, "check_map"),
}


@pytest.mark.parametrize("what", CHECKED)
def test_answers_give_certificates_that_their_programs_accept(page: Page, what: str, tmp_path: Path) -> None:
    robot, asked, program = CHECKED[what]
    source = {"kind": "robot", "id": robot}
    found = page.ask("certificate", source=source, what=what, args={"source": source, **asked})
    assert f"checkers/{program}.py" in found["check"]
    file = tmp_path / found["file"]["name"]
    file.write_bytes(b64decode(found["file"]["data"]))
    command = [sys.executable, ROOT / "checkers" / f"{program}.py", file]
    assert subprocess.run(command, capture_output=True, check=False, timeout=300).returncode == 0
    changed = json.loads(gzip.decompress(file.read_bytes()))
    changed["title"] += "!"
    file.write_bytes(gzip.compress(json.dumps(changed).encode()))
    assert subprocess.run(command, capture_output=True, check=False, timeout=300).returncode != 0


def test_a_way_has_no_certificate(page: Page) -> None:
    """Only that there is none has one."""
    asked = {"source": OCTAHEDRAL, "goal": {**AWAY, "translation": [0.0, 0.0, -490.0]}, "way": "around"}
    none = page.ask("path", **asked)
    assert none["detour"]["outcome"] == "none"
    found = page.ask("certificate", source=OCTAHEDRAL, what="path", args=asked)
    assert json.loads(gzip.decompress(b64decode(found["file"]["data"])))["signs"]
    straight = page.fault("certificate", source=OCTAHEDRAL, what="path", args={"source": OCTAHEDRAL, "goal": AWAY})
    assert "a way has no certificate" in straight["message"]
