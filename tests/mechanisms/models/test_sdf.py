"""SDF: frames relative to each other, loops, models inside, and faults at their places."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from mechanisms.models.model_files import fault, read, shape

HEAD = '<sdf version="1.11"><model name="bars">'
TAIL = "</model></sdf>"
LINKS = (
    '<link name="crank"><pose>0 0 0 0 0.5 0</pose></link>'
    '<frame name="tip" attached_to="crank"><pose>0 0 2 0 0 0</pose></frame>'
    '<link name="rod"><pose relative_to="tip">0 0 0 0 -0.5 0</pose></link>'
    '<link name="rocker"><pose degrees="true">3 0 0 0 28.64788975654116 0</pose></link>'
)
HINGE = '<joint name="{}" type="revolute"><parent>{}</parent><child>{}</child>{}<axis><xyz>0 1 0</xyz></axis></joint>'
A, B = HINGE.format("a", "world", "crank", ""), HINGE.format("b", "tip", "rod", "")
C = HINGE.format("c", "rod", "rocker", "<pose>0 0 2 0 0 0</pose>")
D = HINGE.format("d", "world", "rocker", "")
GOOD = HEAD + LINKS + A + B + C + D + TAIL


def test_a_loop_in_the_graph(tmp_path: Path) -> None:
    model = read(tmp_path, GOOD)
    assert model.links == ("world", "crank", "rod", "rocker")
    assert shape(model)["b"] == ("revolute", "crank", "rod")  # its parent is a frame on the crank
    assert [j.name for j in model.joints if j.closing] == ["d"]
    places = {j.name: j.at for j in model.joints}
    tip = np.array((2 * math.sin(0.5), 0, 2 * math.cos(0.5)))
    assert np.allclose(places["b"], tip)
    assert np.allclose(places["c"], tip + np.array((3, 0, 0)))
    assert {j.axes for j in model.joints} == {((0.0, 1.0, 0.0),)}


def test_axes_are_expressed_in_frames(tmp_path: Path) -> None:
    for xyz, axis in (
        ("<xyz>1 0 0</xyz>", (math.cos(0.5), 0, -math.sin(0.5))),  # in the joint's frame, which is its child's
        ('<xyz expressed_in="__model__">2 0 0</xyz>', (1, 0, 0)),
        ('<xyz expressed_in="rod">0 0 1</xyz>', (0, 0, 1)),
        ("<xyz>1 0 0</xyz><use_parent_model_frame>true</use_parent_model_frame>", (1, 0, 0)),
    ):
        text = GOOD.replace(A, A.replace("<xyz>0 1 0</xyz>", xyz))
        assert np.allclose(read(tmp_path, text).joints[0].axes[0], axis)


@pytest.mark.parametrize(("version", "z"), [("1.4", 0.0), ("1.5", -math.sin(0.5)), ("", -math.sin(0.5))])
def test_axes_of_old_files_are_those_of_the_model(tmp_path: Path, version: str, z: float) -> None:
    text = GOOD.replace(A, A.replace("<xyz>0 1 0</xyz>", "<xyz>1 0 0</xyz>")).replace('"1.11"', f'"{version}"')
    assert read(tmp_path, text).joints[0].axes[0][2] == pytest.approx(z)


KINDS = {
    "continuous": ("revolute", 0.0),
    "prismatic": ("prismatic", 0.0),
    "screw": ("screw", 0.25 / (2 * math.pi)),
}


@pytest.mark.parametrize(("word", "kind", "pitch"), [(w, *k) for w, k in KINDS.items()], ids=KINDS)
def test_kinds(tmp_path: Path, word: str, kind: str, pitch: float) -> None:
    limit = "</xyz><limit><lower>-1</lower><upper>0.5</upper></limit>"
    joint = (
        A.replace("revolute", word)
        .replace("</xyz>", limit)
        .replace("</joint>", "<screw_thread_pitch>0.25</screw_thread_pitch></joint>")
    )
    first = read(tmp_path, GOOD.replace(A, joint)).joints[0]
    assert (first.kind, first.limits) == (kind, None if word == "continuous" else (-1.0, 0.5))
    assert first.pitch == pytest.approx(pitch)


def test_an_older_pitch(tmp_path: Path) -> None:
    """Radians for each metre, and the other way round: with a minus sign, 2π through it is metres for each turn."""
    joint = A.replace("revolute", "screw").replace("</joint>", "<thread_pitch>-4</thread_pitch></joint>")
    assert read(tmp_path, GOOD.replace(A, joint)).joints[0].pitch == 0.25


def test_two_axes(tmp_path: Path) -> None:
    for word in ("universal", "revolute2"):
        joint = A.replace("revolute", word).replace("</axis>", "</axis><axis2><xyz>0 0 1</xyz></axis2>")
        first = read(tmp_path, GOOD.replace(A, joint)).joints[0]
        assert first.kind == "universal"
        assert np.allclose(first.axes, ((0, 1, 0), (math.sin(0.5), 0, math.cos(0.5))))


INNER = (
    '<model name="arm"><pose>0 0 1 0 0 0</pose><link name="hand"><pose>1 0 0 0 0 0</pose></link>'
    '<frame name="f"/></model>'
)


def test_models_inside(tmp_path: Path) -> None:
    joint = '<joint name="j" type="ball"><parent>crank</parent><child>arm::hand</child></joint>'
    model = read(tmp_path, GOOD.replace(TAIL, INNER + joint + TAIL))
    assert shape(model)["j"] == ("ball", "crank", "arm::hand")
    assert model.joints[-1].at == (1.0, 0.0, 1.0)
    to_frame = joint.replace("arm::hand", "arm::f")  # a frame of the model, which its first link stands for
    assert shape(read(tmp_path, GOOD.replace(TAIL, INNER + to_frame + TAIL)))["j"] == ("ball", "crank", "arm::hand")


def test_models_that_are_included(tmp_path: Path) -> None:
    (tmp_path / "arm").mkdir()
    (tmp_path / "arm" / "model.sdf").write_text(f'<sdf version="1.9">{INNER}</sdf>')
    include = "<include><uri>model://arm</uri><name>left</name><pose>0 0 2 0 0 0</pose></include>"
    joint = '<joint name="j" type="ball"><parent>crank</parent><child>left::hand</child></joint>'
    model = read(tmp_path, GOOD.replace(TAIL, include + joint + TAIL))
    assert model.joints[-1].at == (1.0, 0.0, 2.0)


def test_joints_that_follow(tmp_path: Path) -> None:
    mimic = '<mimic joint="a"><multiplier>-2</multiplier>{}</mimic></axis>'
    text = GOOD.replace(B, B.replace("</axis>", mimic.format("")))
    (coupling,) = read(tmp_path, text).couplings
    assert (coupling.joint, coupling.leader, coupling.ratio) == ("b", "a", -2.0)
    off = GOOD.replace(B, B.replace("</axis>", mimic.format("<offset>0.1</offset>")))
    assert "joint 'b' is off by 0.1 rad" in str(fault(tmp_path, off))


def test_what_is_driven(tmp_path: Path) -> None:
    plugin = (
        '<plugin filename="gz-sim-joint-position-controller-system" name="gz::sim::systems::JointPositionController">'
    )
    named = "<joint_name>d</joint_name></plugin><plugin filename='camera'><joint_name>a</joint_name></plugin>"
    assert read(tmp_path, GOOD.replace(TAIL, plugin + named + TAIL)).actuated == ("d",)


FAULTS = {
    "unknown child": ("<child>rod</child>", "<child>rood</child>", "there is no frame 'rood'"),
    "unknown kind": ('type="revolute"', 'type="hinge"', "type='hinge' is not known"),
    "a gearbox": ('type="revolute"', 'type="gearbox"', "joint 'a' is a gearbox"),
    "a name twice": ('<link name="rod">', '<link name="crank">', "the name 'crank' occurs twice"),
    "a reserved name": ('<link name="rod">', '<link name="world">', "the name 'world' is not allowed"),
    "a ring of poses": ('<pose>0 0 0 0 0.5 0', '<pose relative_to="rod">0 0 0 0 0 0', "relative to itself"),
    "a ring of frames": ('attached_to="crank"', 'attached_to="tip"', "itself, by way of others"),
    "unknown frame": ('relative_to="tip"', 'relative_to="top"', "there is no frame 'top'"),
    "five numbers": ("0 0 0 0 0.5 0", "0 0 0 0.5 0", "<pose> has 5 numbers, expected 6"),
    "not finite": ("0 0 0 0 0.5 0", "0 0 0 0 nan 0", "'nan' is not a finite number"),
    "no axis": ("<axis><xyz>0 1 0</xyz></axis>", "", "<joint name='a'> has no <axis>"),
    "no direction": ("<xyz>0 1 0</xyz>", "<xyz>0 0 0</xyz>", "has no direction"),
    "a link of nothing": ("<link name=\"rod\">", "<link name=\"x\"/><link name=\"rod\">", "link 'x' is not joined"),
    "limits": ("</xyz>", "</xyz><limit><lower>1</lower><upper>0</upper></limit>", "the lower limit is above"),
    "a second model": (HEAD, HEAD + "</model><model name='x'>", "the file holds 2 models"),
    "an include outside": ("</model>", "<include><uri>../x.sdf</uri></include></model>", "outside the model's folder"),
    "an include from afar": ("</model>", "<include><uri>https://x.y/z</uri></include></model>", "not on this machine"),
    "an include of nothing": ("</model>", "<include><uri>x.sdf</uri></include></model>", "there is no file 'x.sdf'"),
    "an include of itself": ("</model>", "<include><uri>model.xml</uri></include></model>", "includes itself"),
    "a merge": ("</model>", '<include merge="true"><uri>x</uri></include></model>', "merge of <include> is not read"),
}  # fmt: skip


@pytest.mark.parametrize(("old", "new", "says"), FAULTS.values(), ids=FAULTS)
def test_faults(tmp_path: Path, old: str, new: str, says: str) -> None:
    assert old in GOOD
    found = fault(tmp_path, GOOD.replace(old, new, 1))
    assert says in found.render()
    assert f"{tmp_path / 'model.xml'}:1:" in found.render()
