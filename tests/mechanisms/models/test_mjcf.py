"""MJCF: bodies, defaults, equalities and actuators as MuJoCo itself reads them, and faults at their places."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mechanisms.models.model_files import fault, read, shape

from gcrules.mechanisms.models.model import Model

GOOD = """<mujoco model="bars">
  <compiler angle="radian"/>
  <default><joint axis="0 1 0"/><default class="short"><joint range="-1 1"/></default></default>
  <worldbody>
    <body name="crank"><joint name="a" class="short"/><inertial pos="0 0 1" mass="1" diaginertia="1 1 1"/>
      <body name="rod" pos="0 0 2"><joint name="b"/><inertial pos="0 0 1" mass="1" diaginertia="1 1 1"/>
        <site name="tip" pos="3 0 0"/></body></body>
    <body name="rocker" pos="3 0 0" childclass="short"><joint name="d"/><site name="top" pos="0 0 2"/>
      <inertial pos="0 0 1" mass="1" diaginertia="1 1 1"/></body>
  </worldbody>
  <equality><connect name="c" body1="rod" body2="rocker" anchor="3 0 0"/></equality>
  <actuator><motor name="m" joint="a"/></actuator>
</mujoco>"""


def changed(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new, 1)


def test_bodies_and_joints(tmp_path: Path) -> None:
    model = read(tmp_path, GOOD)
    assert model.links == ("world", "crank", "rod", "rocker")
    assert model.actuated == ("a",)
    assert shape(model)["c"] == ("ball", "rod", "rocker")
    assert {j.name: j.limits for j in model.joints} == {"a": (-1.0, 1.0), "b": None, "d": (-1.0, 1.0), "c": None}
    assert all(j.axes == ((0.0, 1.0, 0.0),) for j in model.joints if j.name != "c")


@pytest.mark.parametrize("kind", ["connect", "weld"])
def test_sites_that_coincide(tmp_path: Path, kind: str) -> None:
    text = changed(
        '<connect name="c" body1="rod" body2="rocker" anchor="3 0 0"/>', f'<{kind} name="c" site1="tip" site2="top"/>'
    )
    model = read(tmp_path, text)
    assert model.joints[-1].at == (3.0, 0.0, 2.0)
    assert shape(model)["c"] == ({"connect": "ball", "weld": "fixed"}[kind], "rod", "rocker")


def test_two_points_are_a_hinge_and_three_fix(tmp_path: Path) -> None:
    two = (
        '<connect name="c" body1="rod" body2="rocker" anchor="3 -1 0"/>'
        '<connect body1="rocker" body2="rod" anchor="0 1 2"/>'
    )
    three = two + '<connect body1="rod" body2="rocker" anchor="2 0 0"/>'
    old = '<connect name="c" body1="rod" body2="rocker" anchor="3 0 0"/>'
    (hinge,) = (j for j in read(tmp_path, changed(old, two)).joints if j.closing)
    assert hinge.kind == "revolute"
    assert np.allclose(np.abs(hinge.axes[0]), (0, 1, 0))
    (fixed,) = (j for j in read(tmp_path, changed(old, three)).joints if j.closing)
    assert fixed.kind == "fixed"


def test_several_joints_of_one_body(tmp_path: Path) -> None:
    text = changed(
        '<joint name="b"/>',
        '<joint name="b"/><joint name="b2" axis="1 0 0"/><joint name="b3" type="slide" axis="0 0 1"/>',
    )
    model = read(tmp_path, text)
    assert shape(model) | {"c": ()} == {
        "a": ("revolute", "world", "crank"),
        "b": ("revolute", "crank", "rod link 1"),
        "b2": ("revolute", "rod link 1", "rod link 2"),
        "b3": ("prismatic", "rod link 2", "rod"),
        "d": ("revolute", "world", "rocker"),
        "c": (),
    }


def test_joints_that_are_coupled_or_held(tmp_path: Path) -> None:
    more = '<joint joint1="b" joint2="a" polycoef="0 -2 0 0 0"/><joint joint1="d"/>'
    model = read(tmp_path, changed("</equality>", more + "</equality>"))
    assert [(c.joint, c.leader, c.ratio) for c in model.couplings] == [("b", "a", -2.0)]
    assert shape(model)["d"][0] == "fixed"
    idle = read(
        tmp_path, changed("</equality>", '<joint active="false" joint1="b" joint2="a" polycoef="1 1 1"/></equality>')
    )
    assert not idle.couplings


def test_the_keyframe_home(tmp_path: Path) -> None:
    keys = '<keyframe><key name="rest" qpos="9 9 9"/><key name="home" qpos="0.25 -0.25 0.25"/></keyframe></mujoco>'
    model = read(tmp_path, changed("</mujoco>", keys))
    assert np.allclose(model.joints[1].at, (2 * np.sin(0.25), 0, 2 * np.cos(0.25)))
    assert model.joints[0].limits == (-1.25, 0.75)
    assert not model.notes  # the loop is closed there


def test_what_is_included(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "more.xml").write_text('<mujocoinclude><joint name="more" axis="1 0 0"/></mujocoinclude>')
    text = changed('<joint name="b"/>', '<joint name="b"/><include file="parts/more.xml"/>')
    assert shape(read(tmp_path, text))["more"] == ("revolute", "rod link 1", "rod")
    (tmp_path / "ring.xml").write_text('<mujoco><include file="ring.xml"/></mujoco>')
    again = fault(tmp_path, changed("</equality>", '</equality><include file="ring.xml"/>'))
    assert "'ring.xml' is included twice, or by itself" in str(again)
    assert f"{tmp_path / 'ring.xml'}:1:24" in str(again)


FAULTS = {
    "outside": ("</equality>", '</equality><include file="../x.xml"/>', "outside the model's folder"),
    "outside, absolute": ("</equality>", '</equality><include file="/etc/passwd"/>', "outside the model's folder"),
    "by itself": ("</equality>", '</equality><include file="model.xml"/>', "included twice, or by itself"),
    "no such file": ("</equality>", '</equality><include file="x.xml"/>', "there is no file 'x.xml'"),
    "no such class": ('class="short"', 'class="shirt"', "there is no class of defaults 'short'"),
    "a class twice": ('<default class="short">', '<default class="short"/><default class="short">', "a second class"),
    "a class without name": ('<default class="short">', "<default>", "needs a name"),
    "no such body": ('body2="rocker"', 'body2="rock"', "there is no body 'rock'"),
    "no such joint": ('joint="a"', 'joint="z"', "there is no joint 'z'"),
    "a body twice": ('<body name="rod"', '<body name="crank"', "a second body named 'crank'"),
    "a joint twice": ('<joint name="b"', '<joint name="a"', "a second joint named 'a'"),
    "no type": ('<joint name="b"', '<joint type="screw" name="b"', "type='screw' is not known"),
    "a joint of the world": ("<worldbody>", '<worldbody><joint name="w"/>', "the world has no joints"),
    "free inside": ('<joint name="b"/>', '<freejoint name="b"/>', "belongs to a body of the world"),
    "two turns": ('name="rocker"', 'name="rocker" quat="1 0 0 0" euler="0 0 0"', "a turn is written in one way"),
    "no turn": ('name="rocker"', 'name="rocker" quat="0 0 0 0"', "quat is not a turn"),
    "parallel axes": ('name="rocker"', 'name="rocker" xyaxes="1 0 0 2 0 0"', "xyaxes is not a turn"),
    "eulerseq": ('angle="radian"', 'angle="radian" eulerseq="xyw"', "eulerseq is three letters"),
    "global": ('angle="radian"', 'angle="radian" coordinate="global"', "global coordinates are not read"),
    "range": ('range="-1 1"', 'range="1 -1"', "the lower limit is above the upper one"),
    "not finite": ('pos="0 0 2"', 'pos="0 0 inf"', "'inf' is not a finite number"),
    "a tendon": ("</actuator>", '<motor tendon="t"/></actuator>', "acts by a tendon"),
    "a limited tendon": ("</actuator>", '</actuator><tendon><fixed name="t" range="0 1"/></tendon>', "as a cable does"),
    "an equality of tendons": ("</equality>", '<tendon tendon1="t"/></equality>', "an equality <tendon> is not read"),
    "a flex": ("<worldbody>", '<worldbody><flexcomp name="f"/>', "<flexcomp>: soft bodies are not read"),
    "a composite": ("<worldbody>", '<worldbody><composite type="cable"/>', "<composite>: "),
    "a replica": ("<worldbody>", '<worldbody><replicate count="3"/>', "<replicate>: bodies that are repeated"),
    "not linear": ("</equality>", '<joint joint1="b" joint2="a" polycoef="0 1 2"/></equality>', "not linear"),
    "off at home": ("</equality>", '<joint joint1="b" joint2="a" polycoef="0.5 1"/></equality>', "is off by 0.5 rad"),
    "round": (
        "</equality>",
        '<joint joint1="b" joint2="a"/><joint joint1="a" joint2="b"/></equality>',
        "follows itself",
    ),
    "the keyframe": ("</mujoco>", '<keyframe><key name="home" qpos="1 2"/></keyframe></mujoco>', "expected 3"),
}


@pytest.mark.parametrize(("old", "new", "says"), FAULTS.values(), ids=FAULTS)
def test_faults(tmp_path: Path, old: str, new: str, says: str) -> None:
    found = fault(tmp_path, changed(old, new))
    assert says in found.render()
    assert f"{tmp_path / 'model.xml'}:" in found.render()


# --- as MuJoCo reads it --------------------------------------------------------------------------------------------


def tree(rng: random.Random) -> tuple[str, int]:
    """A random tree of bodies with all that moves places: ways to write turns, defaults, frames, several joints."""

    def numbers(n: int, scale: float = 1.0) -> str:
        return " ".join(f"{rng.uniform(-scale, scale):.4f}" for _ in range(n))

    def turned() -> str:
        count = {"quat": 4, "axisangle": 4, "xyaxes": 6, "zaxis": 3, "euler": 3}
        word = rng.choice([*count, ""])
        return f'{word}="{numbers(count[word], 50 if word == "euler" else 1)}"' if word else ""

    count = 0

    def body(depth: int) -> str:
        nonlocal count
        count += 1
        own = count
        joints = ""
        for k in range(rng.randrange(3)):
            kind = rng.choice(("hinge", "slide", 'ball" axis="0 0 1', "default"))
            word = f'type="{kind}"' if kind != "default" else 'class="other"'
            ref = f'ref="{rng.uniform(-30, 30):.3f}"' if rng.random() < 0.5 and "ball" not in kind else ""
            joint = f'<joint name="j{own}_{k}" {word} pos="{numbers(3)}" {ref}/>'
            joints += f'<frame pos="{numbers(3)}" {turned()}>{joint}</frame>' if rng.random() < 0.3 else joint
            if "ball" in kind:
                break  # MuJoCo has no turns after it
        inside = "".join(body(depth + 1) for _ in range(rng.randrange(3) if depth < 4 else 0))
        if rng.random() < 0.3:
            inside = f'<frame childclass="other" pos="{numbers(3)}" {turned()}>{inside}</frame>'
        mass = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
        return f'<body name="b{own}" pos="{numbers(3)}" {turned()}>{mass}{joints}{inside}</body>'

    bodies = "".join(body(0) for _ in range(3))
    mass = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    bodies += f'<body name="free" pos="1 2 3" euler="10 20 30"><freejoint name="f"/>{mass}</body>'
    sequence = "".join(rng.choice((rng.choice("xyz"), rng.choice("XYZ"))) for _ in range(3))
    other = '<default class="other"><joint type="slide" axis="0 1 1"/></default>'
    head = f'<compiler eulerseq="{sequence}"/><default><joint axis="1 2 3" armature="1"/>{other}</default>'
    return f"<mujoco>{head}<worldbody>{bodies}</worldbody></mujoco>", count


@pytest.mark.parametrize("seed", range(12))
def test_places_are_those_of_mujoco(tmp_path: Path, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Joints at the file's own state, and in a keyframe with random values."""
    mujoco = pytest.importorskip("mujoco")
    monkeypatch.chdir(tmp_path)  # its warnings go to a file where it runs
    rng = random.Random(seed)
    text, _ = tree(rng)
    theirs = mujoco.MjModel.from_xml_string(text)
    state = mujoco.MjData(theirs)
    for key in (False, True):
        if key:
            state.qpos[:] = [rng.uniform(-1, 1) for _ in range(theirs.nq)]
            mujoco.mj_normalizeQuat(theirs, state.qpos)
            words = " ".join(repr(float(q)) for q in state.qpos)
            text = text.replace("</mujoco>", f'<keyframe><key name="home" qpos="{words}"/></keyframe></mujoco>')
        mujoco.mj_forward(theirs, state)
        assert compared(read(tmp_path, text), mujoco, theirs, state) == theirs.njnt
    assert sorted(f.name for f in tmp_path.iterdir()) == ["model.xml"]


def compared(model: Model, mujoco: Any, theirs: Any, state: Any) -> int:
    found = 0
    for j in model.joints:
        place = mujoco.mj_name2id(theirs, mujoco.mjtObj.mjOBJ_JOINT, j.name)
        if place < 0:
            assert j.kind == "fixed"
            continue
        found += 1
        if j.kind != "free":
            assert np.allclose(j.at, state.xanchor[place], atol=1e-9)
        if j.axes:
            assert np.allclose(j.axes[0], state.xaxis[place], atol=1e-9)
    return found
