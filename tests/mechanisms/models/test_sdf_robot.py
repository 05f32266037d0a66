"""A robot as its maker ships it in SDF: arms included from the model's folder, frames in frames, a static stand, joints
that close loops, a gripper whose fingers follow each other; from the files to the analysis.
"""

from __future__ import annotations

from pathlib import Path

import pytest

import gcrules as gc
from gcrules.core.errors import FileError
from gcrules.mechanisms.models.imported import Imported
from gcrules.mechanisms.models.importing import import_file
from gcrules.mechanisms.models.reading import read_model

ARM = """<?xml version="1.0"?>
<sdf version="1.9">
  <model name="arm" canonical_link="upper">
    <link name="upper"><pose>0.1 0 0 0 0 0</pose></link>
    <frame name="elbow" attached_to="upper"><pose degrees="true">0.17 0 -0.04 0 90 0</pose></frame>
    <link name="rod_left"><pose relative_to="elbow">0 0.03 0 0 0 0</pose></link>
    <link name="rod_right"><pose relative_to="elbow">0 -0.03 0 0 0 0</pose></link>
    <joint name="ball_left" type="ball"><parent>elbow</parent><child>rod_left</child></joint>
    <joint name="ball_right" type="ball"><parent>elbow</parent><child>rod_right</child></joint>
  </model>
</sdf>"""
CONFIG = """<?xml version="1.0"?>
<model><name>arm</name><sdf version="1.4">arm-1.4.sdf</sdf><sdf version="1.9">arm.sdf</sdf></model>"""
STAND = """<sdf version="1.9"><model name="stand"><static>true</static>
  <link name="plate"/><link name="column"><pose>0 0 0.2 0 0 0</pose></link>
</model></sdf>"""


def corner(k: int) -> str:
    """An arm at its frame, its motor, and its rods at the platform."""
    return f"""
    <frame name="foot_{k}" attached_to="stand::plate"><pose degrees="true">0 0 0 0 0 {120 * k}</pose></frame>
    <include><uri>model://arm</uri><name>arm_{k}</name><pose relative_to="foot_{k}">0 0 0 0 0 0</pose></include>
    <joint name="motor_{k}" type="revolute">
      <parent>foot_{k}</parent><child>arm_{k}::upper</child>
      <axis><xyz expressed_in="foot_{k}">0 1 0</xyz><limit><lower>-0.9</lower><upper>0.7</upper></limit></axis>
    </joint>
    <frame name="side_{k}" attached_to="platform"><pose degrees="true">0 0 0 0 0 {120 * k}</pose></frame>
    <joint name="wrist_{k}_left" type="ball">
      <parent>arm_{k}::rod_left</parent><child>platform</child><pose relative_to="side_{k}">0.05 0.03 0 0 0 0</pose>
    </joint>
    <joint name="wrist_{k}_right" type="ball">
      <parent>arm_{k}::rod_right</parent><child>platform</child><pose relative_to="side_{k}">0.05 -0.03 0 0 0 0</pose>
    </joint>
    <plugin filename="gz-sim-joint-controller-system" name="gz::sim::systems::JointController">
      <joint_name>motor_{k}</joint_name>
    </plugin>"""


FINGERS = """
    <link name="finger_left"><pose relative_to="platform">0 0.01 -0.05 0 0 0</pose></link>
    <link name="finger_right"><pose relative_to="platform">0 -0.01 -0.05 0 0 0</pose></link>
    <joint name="grip" type="prismatic"><parent>platform</parent><child>finger_left</child>
      <axis><xyz>0 1 0</xyz></axis></joint>
    <joint name="follow" type="prismatic"><parent>platform</parent><child>finger_right</child>
      <axis><xyz>0 1 0</xyz><mimic joint="grip"><multiplier>-1</multiplier></mimic></axis></joint>"""
ROBOT = f"""<?xml version="1.0"?>
<sdf version="1.11">
  <model name="maker's delta">
    <include><uri>model://stand</uri></include>
    <link name="platform"><pose>0 0 -0.36 0 0 0</pose></link>{"".join(corner(k) for k in range(3))}{FINGERS}
  </model>
</sdf>"""


def files(folder: Path, robot: str = ROBOT, stand: str = STAND) -> Path:
    (folder / "arm").mkdir()
    (folder / "arm" / "arm.sdf").write_text(ARM)
    (folder / "arm" / "model.config").write_text(CONFIG)
    (folder / "stand").mkdir()
    (folder / "stand" / "model.sdf").write_text(stand)
    (folder / "delta.sdf").write_text(robot)
    return folder / "delta.sdf"


@pytest.fixture
def imported(tmp_path: Path) -> Imported:
    return import_file(files(tmp_path))


def test_the_robot_that_is_read(imported: Imported) -> None:
    assert (imported.base, imported.platform) == ("world", "platform")
    assert imported.robot.chain == "3-R*4S"
    assert imported.robot.mobility == 3
    assert imported.actuated == ("motor_0", "motor_1", "motor_2")
    assert imported.limits == tuple((f"motor_{k}", -0.9, 0.7) for k in range(3))
    assert {"grip", "follow"} <= {*imported.left_out}
    assert imported.deviation < 1e-9


def test_it_is_analysed_as_the_delta_that_is_shipped(imported: Imported) -> None:
    ours, shipped = gc.analyze(imported.robot), gc.analyze("delta")
    assert [p.kind for p in ours.parts] == [p.kind for p in shipped.parts]
    assert "d1, d2 and d3 are parallel to one plane" in ours.statement


def test_it_has_a_certificate(imported: Imported) -> None:
    sure = gc.certify(imported.robot, over=["x -0.02..0.02", "z -0.02..0.02"], boxes=100)
    assert sure.verdict == "free"


def test_the_places_are_those_of_the_frames(imported: Imported) -> None:
    home = {n: [round(float(c), 9) for c in v] for n, v in imported.robot.values_at().items()}
    assert home["A1"] == [0.1, 0.0, 0.0]
    assert sorted((home["B1"], home["C1"])) == [[0.27, -0.03, -0.04], [0.27, 0.03, -0.04]]


def test_links_of_a_static_model_are_fixed(tmp_path: Path) -> None:
    """The stand has no joints, and is the world all the same; a robot that is static does not move."""
    model = read_model(files(tmp_path))
    assert {j.child for j in model.joints if j.kind == "fixed"} == {"stand::plate", "stand::column"}
    (tmp_path / "still").mkdir()
    still = ROBOT.replace("<include><uri>model://stand", "<static>true</static><include><uri>model://stand", 1)
    with pytest.raises(FileError, match="the model is static: nothing in it moves"):
        read_model(files(tmp_path / "still", still))


def test_an_include_makes_a_model_static(tmp_path: Path) -> None:
    stand = STAND.replace("<static>true</static>", "")
    include = ROBOT.replace("model://stand</uri>", "model://stand</uri><static>true</static>")
    model = read_model(files(tmp_path, include, stand))
    assert {j.child for j in model.joints if j.kind == "fixed"} == {"stand::plate", "stand::column"}
    (tmp_path / "loose").mkdir()
    with pytest.raises(FileError, match="link 'stand::column' is not joined"):
        read_model(files(tmp_path / "loose", ROBOT, stand))


FAULTS = {
    "unknown frame": ('relative_to="foot_1"', 'relative_to="foot_9"', "there is no frame 'foot_9'"),
    "unknown axis": ('expressed_in="foot_1"', 'expressed_in="feet"', "there is no frame 'feet'"),
    "unknown leader": ('<mimic joint="grip">', '<mimic joint="grasp">', "there is no frame 'grasp'"),
    "a follower of itself": ('<mimic joint="grip">', '<mimic joint="follow">', "joint 'follow' follows itself"),
    "a model that is not there": ("model://arm</uri><name>arm_2", "model://leg</uri><name>arm_2", "no file 'leg'"),
    "a name twice": ("<name>arm_2</name>", "<name>arm_1</name>", "the name 'arm_1' occurs twice"),
    "placement": ("<name>arm_2</name>", "<name>arm_2</name><placement_frame>elbow</placement_frame>",
                  "placement_frame of <include> is not read"),
    "second axes that lead": ('<mimic joint="grip">', '<mimic joint="grip" axis="axis2">', "the second axis"),
}  # fmt: skip


@pytest.mark.parametrize(("old", "new", "says"), FAULTS.values(), ids=FAULTS)
def test_faults(old: str, new: str, says: str, tmp_path: Path) -> None:
    assert old in ROBOT
    with pytest.raises(FileError) as found:
        import_file(files(tmp_path, ROBOT.replace(old, new, 1)))
    assert says in found.value.render()
    assert found.value.exit_code == 2
    assert "delta.sdf:" in found.value.render()
