"""Where the robot can go, in the studio: the answers are those of the library, and lead the robot on the page."""

from __future__ import annotations

from typing import Any

import pytest

import gcrules as gc

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import HOME, Page
from places import EXAMPLES

OCTAHEDRAL = {"kind": "example", "name": "octahedral"}
FILE = str(EXAMPLES / "octahedral.yaml")
RPR = {"kind": "robot", "id": "3-rpr"}
AWAY = {"translation": [0.0, 0.0, -30.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}


def facts(found: dict[str, Any]) -> dict[str, str]:
    """What is told beside the sentence; of a name that comes twice the last."""
    return {f["key"]: f["value"] for f in found["facts"]}


def told(result: Any) -> str:
    """The text of a result in one line, for what is wrapped there."""
    return " ".join(result.text(unicode=True).split())


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
    assert found["verdict"] in told(same)
    assert [r["name"] for r in found["ranges"]] == list(same.names)
    for one, half in zip(found["ranges"], same.half_widths, strict=True):
        assert float(one["high"]) == -float(one["low"])
        shown = float(one["high"]) * (3.14159265358979 / 180 if one["unit"] == "deg" else 1)
        assert half * (1 - 1e-5) < shown <= half


def test_a_free_box_of_a_robot_of_joints(page: Page) -> None:
    found = page.ask("free", source=RPR, pose={**HOME, "coordinates": [0, 0, 0]}, shape="box")
    assert found["verdict"] in told(gc.free_region("3-rpr"))
    assert [r["name"] for r in found["ranges"]] == ["x", "y", "yaw"]


@pytest.mark.parametrize("shape", ["cube", True, None])
def test_shapes_are_checked(page: Page, shape: Any) -> None:
    assert page.fault("free", source=OCTAHEDRAL, pose=HOME, shape=shape)["kind"] == "input"


def test_around_a_singular_pose_nothing_is_free(page: Page) -> None:
    singular = {"translation": [0.0, 0.0, -350.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}
    assert "nothing is proved" in page.fault("free", source=OCTAHEDRAL, pose=singular, shape="box")["message"]
