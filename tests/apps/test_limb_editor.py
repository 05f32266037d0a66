"""What the server tells the limb editor of the studio. No browser is needed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import assert_fits

from gcrules.apps.studio.limb_editor import limbs_answer
from gcrules.apps.studio.protocol.limb_views import LimbsAnswer
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.load import read_robot

ROBOTS = {one.id: Path(one.path) for one in robots()}


def ask(written: str | None = None, /, start: Any = None, **edit: Any) -> LimbsAnswer:
    found = limbs_answer(written, start, edit or None)
    assert_fits(found, LimbsAnswer)
    return found


def test_the_first_limb_is_told_of_though_it_is_no_robot_yet() -> None:
    found = ask()
    sheet, mobility = found["sheet"], found["mobility"]
    assert sheet is not None
    assert found["scene"] is not None
    assert (mobility["number"], mobility["drives"]) == (5, 1)
    assert [fault["message"] for fault in mobility["faults"]] == ["too few actuators: 1 for a platform of mobility 5"]
    assert sheet["limbs"][0]["system"] == "planar pencil"
    assert [(w["text"], w["role"]) for w in sheet["limbs"][0]["wrenches"]] == [
        ("force A1S1", "actuation"),
        ("force S1r1", "constraint"),
    ]
    robot = ask(found["text"], do="limb around", limb=0, to=3)
    assert robot["every"] is None
    assert robot["faults"] == []
    assert robot["mobility"]["number"] == 3
    assert "mobility: 3" in robot["text"]
    assert robot["sheet"] is not None
    assert robot["sheet"]["turned"]


def test_a_limb_that_leaves_the_plane_has_no_mobility_there() -> None:
    """The number of a planar robot counts on all limbs to stay in its plane."""
    text = limbs_answer(None, plane=True)["text"]
    assert ask(text, do="limb around", limb=0, to=3)["mobility"]["number"] == 3
    found = ask(text.replace("R(B1, z)", "R(B1, x)"))
    assert found["mobility"]["number"] is None
    assert found["sheet"] is not None
    assert found["sheet"]["limbs"][0]["faults"][0]["message"] == "leg 1 leaves the plane z = 0 of a planar robot"
    assert found["sheet"]["limbs"][0]["wrenches"] == []


@pytest.mark.parametrize("name", ROBOTS)
def test_every_robot_is_a_table_without_faults(name: str) -> None:
    found = ask(start={"kind": "robot", "id": name})
    robot = read_robot(ROBOTS[name])
    sheet = found["sheet"]
    assert sheet is not None
    assert found["every"] is None
    assert found["faults"] == []
    assert found["text"] == robot.text
    assert found["mobility"]["number"] == robot.mobility
    assert sum(limb["copies"] for limb in sheet["limbs"]) == len(robot.limbs)
    assert found["scene"] is not None
    assert len(found["scene"]["limbs"]) >= len(robot.limbs)


def test_a_fault_stands_at_its_joint_with_what_to_do() -> None:
    text = ask()["text"]
    found = ask(text, do="joint part", limb=0, joint=0, part=1, text="q1")
    assert found["sheet"] is not None
    first, *others = found["sheet"]["limbs"][0]["chains"][0]["joints"]
    assert first["faults"][0]["message"] == "q1 is not defined"
    assert first["faults"][0]["hint"] == "did you mean r1 or S1?"
    assert first["undefined"] == [{"name": "q1", "sort": "direction"}]
    assert [joint["faults"] for joint in others] == [[], []]
    mended = ask(found["text"], do="name add", name="q1", text="direction")
    assert mended["sheet"] is not None
    assert mended["sheet"]["limbs"][0]["chains"][0]["joints"][0]["faults"] == []
    unknown = ask(text.replace("R(A1, r1)", "X(A1, r1)"))
    assert unknown["sheet"] is not None
    (fault,) = unknown["sheet"]["limbs"][0]["chains"][0]["joints"][0]["faults"]
    assert fault["message"] == "'X' is not a kind of joint"


def test_faults_of_names_and_of_home_stand_at_the_name() -> None:
    text = ask()["text"]
    found = ask(text.replace("S1: [1, 0, 2]", "S1: [1, 1, 2]"))
    assert found["sheet"] is not None
    faults = {row["name"]: [f["message"] for f in row["faults"]] for row in found["sheet"]["names"]}
    assert faults["S1"] == ["at home S1 is not as its relation says: in plane A1 perpendicular to r1"]
    assert faults["A1"] == faults["r1"] == []
    pulled = ask(text, do="home", name="S1", texts=["1", "1", "2"], follow=False)
    assert "S1: [1, 0, 2]" in pulled["text"]  # back into its plane


def test_a_text_that_is_no_table_keeps_its_faults() -> None:
    found = ask("title: [")
    assert found["sheet"] is None
    assert found["every"] is not None
    assert "place" in found["every"]
    assert ask("")["every"] is not None
    with pytest.raises(InputError):
        ask("title: T\nlimbs: []\n", do="joint add", limb=0, text="R")
    with pytest.raises(InputError):
        ask(start={"kind": "class", "id": "3-3.3"})


def test_the_mobility_of_the_file_is_compared_and_can_be_taken_over() -> None:
    text = read_robot(ROBOTS["3-rps"]).text.replace("mobility: 3", "mobility: 4")
    found = ask(text)
    assert (found["mobility"]["number"], found["mobility"]["written"]) == (3, "4")
    assert found["mobility"]["faults"][0]["message"] == "the platform has mobility 3, not 4"
    assert ask(text, do="mobility", to=3)["every"] is None


def test_a_model_becomes_a_robot_file(tmp_path: Path) -> None:
    import gcrules as gc

    model = gc.export_model(gc.load("3-rps"), "mjcf")
    text = model if isinstance(model, str) else str(getattr(model, "text", model))
    found = ask(start={"kind": "file", "text": text, "name": "model.xml"})
    assert found["sheet"] is not None
    assert found["mobility"]["number"] == 3
