"""`gcrules robot import`, and model files wherever a robot is taken."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from commands import invoke

import gcrules as gc
from gcrules.apps.studio.subject import read_subject

FIVE_BAR = """<mujoco model="five-bar">
  <compiler angle="radian"/>
  <worldbody>
    <body name="left" pos="0 0 0">
      <joint name="a" axis="0 0 1" range="-1 1" limited="true"/>
      <geom size="0.01" mass="1"/>
      <body name="hand" pos="-0.1 0.3 0">
        <joint name="b" axis="0 0 1"/>
        <geom size="0.01" mass="1"/>
      </body>
    </body>
    <body name="right" pos="0.4 0 0">
      <joint name="d" axis="0 0 1" range="-1 1" limited="true"/>
      <geom size="0.01" mass="1"/>
      <body name="rod" pos="0.1 0.3 0">
        <joint name="e" axis="0 0 1"/>
        <geom size="0.01" mass="1"/>
      </body>
    </body>
  </worldbody>
  <equality><connect body1="rod" body2="hand" anchor="-0.3 0.2 0"/></equality>
  <actuator><motor joint="a"/><motor joint="d"/></actuator>
</mujoco>
"""


@pytest.fixture
def model(tmp_path: Path) -> Path:
    """A model as its maker ships it."""
    file = tmp_path / "delta.xml"
    file.write_text(gc.export_model("delta"))
    return file


def test_a_file_and_an_account_of_it(model: Path) -> None:
    out = model.with_suffix(".yaml")
    run = invoke("robot", "import", str(model), "-o", str(out))
    assert run.exit_code == 0, run.stderr
    assert "platform, by its name; mobility 3" in run.stdout
    assert "R*4S" in run.stdout
    checked = invoke("robot", "check", str(out))
    assert checked.exit_code == 0, checked.stderr
    assert checked.stdout.startswith("delta: mobility 3, home satisfies the relations")


def test_without_a_file_it_is_printed(model: Path) -> None:
    run = invoke("robot", "import", str(model))
    assert run.stdout.startswith("title: delta")
    assert "checked" in run.stderr
    answer = json.loads(invoke("robot", "import", str(model), "--json").stdout)
    assert answer["platform"] == "platform"
    assert gc.load(answer["yaml"]).chain == "3-R*4S"


def test_the_platform_is_asked_for(tmp_path: Path) -> None:
    file = tmp_path / "five-bar.xml"
    file.write_text(FIVE_BAR)
    run = invoke("robot", "import", str(file))
    assert run.exit_code == 2
    assert "which link is the platform" in run.stderr
    found = invoke("robot", "import", str(file), "--platform", "hand")
    assert found.exit_code == 0, found.stderr
    assert "R(C2, z)" in found.stdout  # what connects two bodies is a ball joint, and in a plane a hinge
    assert "a ball joint is taken as a hinge" in found.stderr
    assert "limits: actuators -1..1 rad" in found.stdout
    assert "driven" in found.stderr
    wrong = invoke("robot", "import", str(file), "--platform", "hand", "--actuators", "a,c")
    assert (wrong.exit_code, "there is no joint 'c'" in wrong.stderr) == (2, True)


def test_a_tree_in_urdf_asks_for_its_closures(tmp_path: Path) -> None:
    """Which are found beside it under the name that the export gives them."""
    run = invoke("robot", "export", "3-upu", "-o", str(tmp_path / "upu.urdf"))
    assert run.exit_code == 0, run.stderr
    assert gc.Robot.from_model(tmp_path / "upu.urdf").chain == "3-UP*U"
    (tmp_path / "upu-closures.yaml").rename(tmp_path / "loops.yaml")
    refused = invoke("robot", "import", str(tmp_path / "upu.urdf"))
    assert (refused.exit_code, "--closures FILE" in refused.stderr) == (2, True)
    told = invoke("robot", "import", str(tmp_path / "upu.urdf"), "--closures", str(tmp_path / "loops.yaml"))
    assert told.exit_code == 0, told.stderr


def test_models_wherever_a_robot_is_taken(model: Path) -> None:
    robot = gc.load(model)
    assert isinstance(robot, gc.Robot)
    assert robot == gc.load(str(model)) == gc.Robot.from_model(model)
    assert gc.load(model.read_text()).family == robot.family
    assert invoke("robot", "show", str(model)).stdout.startswith("delta (delta): 3-R*4S, mobility 3")
    assert invoke("pose", str(model), "--no-nearest").exit_code == 0


def test_the_studio_opens_models(model: Path) -> None:
    subject = read_subject({"kind": "file", "text": model.read_text(), "name": "delta.xml"})
    assert subject.limbs is not None
    assert subject.limbs.robot.chain == "3-R*4S"
    text = "<mujoco><include file='/etc/passwd'/></mujoco>"
    with pytest.raises(gc.GcrulesError, match="cannot include files"):
        read_subject({"kind": "file", "text": text, "name": "model.xml"})
