"""URDF: trees, what closes their loops, and faults at their places."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from mechanisms.models.model_files import fault, read, shape

from gcrules.core.errors import FileError

HEAD = '<robot name="four bars"><link name="base"/><link name="crank"/><link name="rod"/><link name="rocker"/>'
HINGE = (
    '<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/><origin xyz="{}"/><axis xyz="0 1 0"/>{}</joint>'
)


def hinge(name: str, parent: str, child: str, at: str, more: str = "", kind: str = "continuous") -> str:
    return HINGE.format(name, kind, parent, child, at, more)


TREE = (
    HEAD
    + hinge("a", "base", "crank", "0 0 0")
    + hinge("b", "crank", "rod", "0 0 2")
    + hinge("d", "base", "rocker", "3 0 0")
)
CLOSERS = {
    "loop_joint": '<loop_joint name="c" type="{}"><link1 link="rod" xyz="3 0 0"/><link2 link="rocker" xyz="0 0 2"/>'
    '<axis xyz="0 1 0"/></loop_joint>',
    "loop_joint with link1 twice": '<loop_joint name="c" type="{}"><link1 link="rod" xyz="3 0 0"/>'
    '<link1 link="rocker" xyz="0 0 2"/><axis xyz="0 1 0"/></loop_joint>',
    "loop_joint with origins": '<loop_joint name="c" type="{}"><parent link="rod"/><child link="rocker"/>'
    '<parent_origin xyz="3 0 0"/><child_origin xyz="0 0 2"/><axis xyz="0 1 0"/></loop_joint>',
    "constraint": '<constraint name="c" type="{}"><parent link="rod"/><parent_origin xyz="3 0 0"/>'
    '<parent_axis xyz="0 1 0"/>'
    '<child link="rocker"/><child_origin xyz="0 0 2"/><child_axis xyz="0 1 0"/></constraint>',
}


@pytest.mark.parametrize(("kind", "read_as"), [("spherical", "ball"), ("revolute", "revolute"), ("fixed", "fixed")])
@pytest.mark.parametrize("closer", CLOSERS.values(), ids=CLOSERS)
def test_elements_that_close_a_loop(tmp_path: Path, closer: str, kind: str, read_as: str) -> None:
    model = read(tmp_path, TREE + closer.format(kind) + "</robot>")
    assert model.links == ("base", "crank", "rod", "rocker")
    assert shape(model)["c"] == (read_as, "rod", "rocker")
    (closing,) = (j for j in model.joints if j.closing)
    assert closing.at == (3.0, 0.0, 2.0)
    assert closing.axes == (((0.0, 1.0, 0.0),) if kind == "revolute" else ())
    assert not model.notes


def test_a_link_with_two_parents_closes_a_loop(tmp_path: Path) -> None:
    model = read(tmp_path, TREE + hinge("c", "rocker", "end", "0 0 2") + '<link name="end"/>'
                 + hinge("c'", "rod", "end", "3 0 0") + "</robot>")  # fmt: skip
    assert [(j.name, j.kind) for j in model.joints if j.closing] == [("c'", "revolute")]


FRAMES = (
    '<link name="A"/><link name="B"/><joint name="A_frame" type="fixed"><parent link="rod"/><child link="A"/>'
    '<origin xyz="3 0 0"/></joint><joint name="B_frame" type="fixed"><parent link="rocker"/><child link="B"/>'
    '<origin xyz="0 0 2"/></joint>'
)


@pytest.mark.parametrize(("word", "kind"), [("3d", "ball"), ("3D", "ball"), ("6d", "fixed"), (None, "fixed")])
def test_a_second_file_closes_loops(tmp_path: Path, word: str | None, kind: str) -> None:
    types = f"type: [{word}]\n" if word else ""
    closures = (
        f"closed_loop: [[A, B_frame]]\n{types}name_mot: [a]\njoint_name: [d, b]\njoint_type: [SPHERICAL, UJOINT_ZY]\n"
    )
    model = read(tmp_path, TREE + FRAMES + "</robot>", closures)
    assert shape(model)["A = B_frame"] == (kind, "A", "B")
    assert shape(model)["d"][0] == "ball"
    assert model.actuated == ("a",)
    universal = next(j for j in model.joints if j.name == "b")
    assert universal.kind == "universal"
    assert universal.axes == ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0))


def test_open_loops_are_closed_by_the_joints_that_are_not_driven(tmp_path: Path) -> None:
    """A parallelogram whose rocker leans in the file: it stands up, or the driven crank would have to move."""
    leaning = TREE.replace('<origin xyz="3 0 0"/>', '<origin xyz="3 0 0" rpy="0 0.3 0"/>')
    model = read(tmp_path, leaning + FRAMES + "</robot>", "closed_loop: [[A, B]]\ntype: [3d]\nname_mot: [a]\n")
    ball = next(j for j in model.joints if j.closing)
    assert np.allclose(ball.at, (3, 0, 2), atol=1e-8)
    (note,) = model.notes
    assert "1 of 1 loops are open" in note
    assert "joint d moved by -0.3 rad" in note


def test_loops_that_no_values_close(tmp_path: Path) -> None:
    far = FRAMES.replace('"0 0 2"', '"0 0 20"')
    found = fault(tmp_path, TREE + far + "</robot>", "closed_loop: [[A, B]]\ntype: [3d]\n")
    assert "open by 18 m, " in str(found)
    assert "no values of the joints were found" in str(found)
    assert found.place == f"{tmp_path / 'closures.yaml'}:1:15"


def test_joints_that_follow(tmp_path: Path) -> None:
    """An offset is part of home, and a chain of followers has one leader."""
    text = (
        HEAD
        + hinge("a", "base", "crank", "0 0 0", '<limit lower="-1" upper="2" effort="1" velocity="1"/>', "revolute")
        + hinge("b", "crank", "rod", "0 0 2", '<mimic joint="a" multiplier="-2" offset="0.5"/>')
        + hinge("d", "rod", "rocker", "1 0 0", '<mimic joint="b" multiplier="3"/>')
        + "</robot>"
    )
    model = read(tmp_path, text)
    assert [(c.joint, c.leader, c.ratio) for c in model.couplings] == [("b", "a", -2.0), ("d", "a", -6.0)]
    d = next(j for j in model.joints if j.name == "d")
    assert np.allclose(d.at, (math.cos(0.5), 0, 2 - math.sin(0.5)))
    assert model.joints[0].limits == (-1.0, 2.0)


def test_frames_are_turned_as_roll_pitch_and_yaw_say(tmp_path: Path) -> None:
    text = TREE.replace('<origin xyz="0 0 2"/>', '<origin xyz="0 0 2" rpy="0.1 -0.7 2"/>') + "</robot>"
    b = next(j for j in read(tmp_path, text).joints if j.name == "b")
    roll, pitch, yaw = 0.1, -0.7, 2.0
    cr, sr, cp, sp, cy, sy = (f(x) for x in (roll, pitch, yaw) for f in (math.cos, math.sin))
    second = (cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr)  # second column of Rz Ry Rx
    assert np.allclose(b.axes[0], second)


def test_what_is_driven(tmp_path: Path) -> None:
    transmission = '<transmission name="t"><joint name="a"/></transmission>'
    control = (
        '<ros2_control><joint name="d"><command_interface name="position"/></joint><joint name="b"/></ros2_control>'
    )
    assert read(tmp_path, TREE + transmission + control + "</robot>").actuated == ("a", "d")


def test_what_has_no_limits(tmp_path: Path) -> None:
    for limit in ("", '<limit effort="1" velocity="2"/>', '<limit lower="-inf" upper="inf"/>'):
        text = HEAD + hinge("a", "base", "crank", "0 0 0", limit, "revolute")
        text += hinge("b", "crank", "rod", "0 0 2") + hinge("d", "base", "rocker", "3 0 0") + "</robot>"
        assert read(tmp_path, text).joints[0].limits is None


FAULTS = {  # what is put in the place of what, and what is said, and where
    "unknown parent": ('<parent link="crank"/>', '<parent link="cronk"/>', "there is no link 'cronk'"),
    "unknown kind": ('type="continuous"', 'type="hinge"', "type='hinge' is not known for <joint>"),
    "a link twice": ('<link name="crank"/>', '<link name="rod"/>', "a second link named 'rod'"),
    "a joint twice": ('<joint name="b"', '<joint name="a"', "a second joint named 'a'"),
    "no name": ('<link name="crank"/>', "<link/>", "the attribute name of <link> is missing"),
    "an empty name": ('<link name="crank"/>', '<link name=" "/>', "the attribute name of <link name=' '> is empty"),
    "no child": ('<child link="rod"/>', "", "<joint name='b'> has no <child>"),
    "two children": ('<child link="rod"/>', '<child link="rod"/><child link="base"/>', "a second <child>"),
    "no direction": ('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>', "the axis of joint 'a' has no direction"),
    "two numbers": ('<origin xyz="0 0 2"/>', '<origin xyz="0 2"/>', "xyz has 2 numbers, expected 3"),
    "infinite": ('<origin xyz="0 0 2"/>', '<origin xyz="0 0 inf"/>', "'inf' is not a finite number"),
    "too large": ('<origin xyz="0 0 2"/>', '<origin xyz="0 0 1e400"/>', "'1e400' is beyond any machine"),
    "a joint with itself": ('<child link="rod"/>', '<child link="crank"/>', "joins 'crank' with itself"),
    "a link of nothing": ('<link name="crank"/>', '<link name="crank"/><link name="x"/>', "which is the base?"),
    "no turn": ('<origin xyz="0 0 2"/>', '<origin quat_xyzw="0 0 0 0"/>', "not a turn"),
    "mimics no one": ("</joint>", '<mimic joint="x"/></joint>', "there is no joint 'x'"),
    "mimics itself": ("</joint>", '<mimic joint="a"/></joint>', "follows itself"),
    "drives no one": ("</robot>", '<transmission><joint name="x"/></transmission></robot>', "there is no joint 'x'"),
    "closes nothing": ("</robot>", '<loop_joint name="c" type="fixed"><link1 link="a"/><link2 link="b"/></loop_joint>'
                       "</robot>", "there is no link 'a'"),
}  # fmt: skip


@pytest.mark.parametrize(("old", "new", "says"), FAULTS.values(), ids=FAULTS)
def test_faults(tmp_path: Path, old: str, new: str, says: str) -> None:
    good = TREE + "</robot>"
    assert old in good
    found = fault(tmp_path, good.replace(old, new, 1))
    assert says in str(found)
    assert f"{tmp_path / 'model.xml'}:1:" in found.render()
    assert "^" in found.render()


def test_links_that_go_round(tmp_path: Path) -> None:
    ring = (
        '<robot name="r"><link name="x"/><link name="y"/>'
        + hinge("p", "x", "y", "0 0 0")
        + hinge("q", "y", "x", "0 0 0")
    )
    assert "every link is the child" in str(fault(tmp_path, ring + "</robot>"))
    island = ring + '<link name="base"/><link name="z"/>' + hinge("r", "base", "z", "0 0 0") + "</robot>"
    assert "its joints form a circle" in str(fault(tmp_path, island))


CLOSURE_FAULTS = {
    "unknown frame": ("closed_loop: [[A, C]]", "there is no link or joint 'C'"),
    "three frames": ("closed_loop: [[A, B, A]]", "a list of 3, expected 2"),
    "unknown type": ("closed_loop: [[A, B]]\ntype: [4d]", "is not a type of loop"),
    "too few types": ("closed_loop: [[A, B]]\ntype: []", "a list of 0, expected 1"),
    "unknown motor": ("name_mot: [q]", "there is no joint 'q'"),
    "a fixed motor": ("name_mot: [A_frame]", "is fixed, and cannot be driven"),
    "unknown joint": ("joint_name: [q]\njoint_type: [SPHERICAL]", "there is no joint 'q'"),
    "unknown joint type": ("joint_name: [a]\njoint_type: [HOOKE]", "'HOOKE' is not one of"),
    "no joint types": ("joint_name: [a]", "the key 'joint_type' is missing"),
    "unknown key": ("loops: [[A, B]]", "unknown key 'loops'"),
    "code": ("closed_loop: !!python/object/apply:os.system [ls]", "tags"),
    "one frame twice": ("closed_loop: [[A, A]]", "with itself"),
}


@pytest.mark.parametrize(("text", "says"), CLOSURE_FAULTS.values(), ids=CLOSURE_FAULTS)
def test_faults_of_closures(tmp_path: Path, text: str, says: str) -> None:
    found = fault(tmp_path, TREE + FRAMES + "</robot>", text)
    assert says in found.render()
    assert f"{tmp_path / 'closures.yaml'}:" in found.render()


def test_closures_go_with_urdf_only(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="goes with a model in URDF"):
        read(tmp_path, "<mujoco/>", "closed_loop: []")
