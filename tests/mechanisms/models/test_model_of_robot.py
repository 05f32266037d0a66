"""Robots as models: what is written is read again, moves as the robot does, and holds together in MuJoCo."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from mechanisms.models.model_files import joints, read
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.couplings import couplings
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.limb_file import LimbSpec, read_joints
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.models.closing import Loop, Tree
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.of_robot import model_of
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS
from gcrules.views.models.mjcf import mjcf_text
from gcrules.views.models.urdf import urdf_files

WRITTEN = tuple(one.id for one in robots() if one.id != "8-cables")


@cache
def robot(name: str) -> Robot:
    found = gc.load(name)
    assert isinstance(found, Robot)
    return found


@cache
def model(name: str) -> Model:
    return model_of(robot(name))


def test_there_are_robots() -> None:
    assert len(WRITTEN) == 41


def coupled(found: Model) -> list[tuple[str, str, float]]:
    return sorted((c.joint, c.leader, round(c.ratio, 9)) for c in found.couplings)


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_written_as_mjcf_is_read_again(name: str, tmp_path: Path) -> None:
    again = read(tmp_path, gc.export_model(name))
    assert joints(again) == joints(model(name))
    assert set(again.links) == {"world", *model(name).links}
    assert again.actuated == model(name).actuated
    assert coupled(again) == coupled(model(name))
    assert not again.notes


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_written_as_urdf_is_read_again(name: str, tmp_path: Path) -> None:
    """But for the names of joints that close loops, which are pairs of frames there."""
    again = read(tmp_path, gc.export_model(name, "urdf"), gc.export_model(name, "closures"))
    meant = joints(model(name))
    tree = {n: j for n, j in joints(again).items() if n in meant and not j[5]}
    assert tree == {n: j for n, j in meant.items() if not j[5]}
    closing = sorted((j.kind, j.parent, tuple(np.round(j.at, 8) + 0.0)) for j in again.joints if j.closing)
    assert closing == sorted(
        (j.kind, f"{j.name}_a", tuple(np.round(j.at, 8) + 0.0)) for j in model(name).joints if j.closing
    )
    assert again.actuated == model(name).actuated
    assert coupled(again) == coupled(model(name))
    assert not again.notes


def twists_of_platform(found: Model, *, locked: bool) -> np.ndarray:
    """Those that all loops allow, from the model alone: the null space of the rates of its loops."""
    tree = Tree(found.links[0], [j for j in found.joints if not j.closing], found.couplings)
    _, twists = tree.motions(np.zeros(len(tree.screws)))
    rows = []
    for j in (j for j in found.joints if j.closing):
        at = np.eye(4)
        at[:3, 3] = j.at
        own = []
        for link in (j.parent, j.child):
            some = np.zeros_like(twists)
            some[tree.before[link]] = twists[tree.before[link]]
            own.append(some)
        rows += [r.T @ tree.parts for r in Loop(j.name, j.kind, (j.parent, j.child), (at, at)).rates((own[0], own[1]))]
    free = tree.parts.any(axis=0)
    if locked:
        for j, place in tree.steps:
            free[place] &= j.name not in found.actuated
    loops = np.concatenate(rows)[:, free]
    _, sizes, v = np.linalg.svd(loops)
    null = v[int((sizes > 1e-9 * sizes.max()).sum()) :]
    way = np.zeros_like(twists)
    way[tree.before["platform"]] = twists[tree.before["platform"]]
    return null @ (tree.parts.T @ way)[free]


def rank(rows: np.ndarray) -> int:
    sizes = np.linalg.svd(rows, compute_uv=False) if rows.size else np.zeros(1)
    return int((sizes > 1e-8).sum())


@pytest.mark.parametrize("locked", [False, True], ids=["moving", "locked"])
@pytest.mark.parametrize("name", WRITTEN)
def test_the_platform_moves_as_the_robot_says(name: str, locked: bool) -> None:
    """The twists that the model's loops allow are those reciprocal to the wrenches of the robot's limbs."""
    limbs = robot(name).limbs_at()
    applied = [limb.locked(FLOATS) if locked else limb.constraints(FLOATS) for limb in limbs]
    wrenches = np.concatenate([np.asarray(rows).reshape(-1, 6) for rows in applied])
    twists = twists_of_platform(model(name), locked=locked)
    assert np.abs(wrenches @ np.roll(twists, 3, axis=1).T).max(initial=0) < 1e-8
    assert rank(twists) == 6 - rank(wrenches)
    assert rank(twists) == (0 if locked else robot(name).mobility)


@pytest.mark.parametrize("name", WRITTEN)
def test_mujoco_holds_it_together(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Some hundred steps with random torques: it moves, and its loops stay closed."""
    mujoco = pytest.importorskip("mujoco")
    monkeypatch.chdir(tmp_path)  # its warnings go to a file where it runs
    theirs = mujoco.MjModel.from_xml_string(gc.export_model(name))
    assert theirs.nu == len(model(name).actuated)
    theirs.opt.gravity[:] = 0
    state = mujoco.MjData(theirs)
    rng = np.random.default_rng(7)
    size = theirs.stat.extent
    most = 0.0
    driven = theirs.actuator_trnid[:, 0]
    turns = theirs.jnt_type[driven] == mujoco.mjtJoint.mjJNT_HINGE
    inertia = theirs.dof_M0[theirs.jnt_dofadr[driven]]
    state.ctrl[:] = rng.choice((-5, 5), size=theirs.nu) * inertia * np.where(turns, 1, size)
    for _ in range(200):
        mujoco.mj_step(theirs, state)
        equalities = state.efc_type[: state.nefc] == mujoco.mjtConstraint.mjCNSTR_EQUALITY
        most = max(most, float(np.abs(state.efc_pos[: state.nefc][equalities]).max()))
    assert most < 1e-4 * size
    assert np.abs(state.qvel).max() > 1e-3
    assert not any(tmp_path.iterdir())


# --- other joints, units, platforms --------------------------------------------------------------------------------


@cache
def all_kinds() -> Robot:
    """No robot that anybody would build: two limbs with joints of many kinds, of which two are coupled."""
    first = read_joints("H*(A1, r1, 1/2) U(A1, r1, r2) C*1(S1, r2) S(S2)")
    second = read_joints("E*(A1, r2) R:a(A1, r1) R:b(S1, r1) U(S1, r1, r2) P(r3)")
    coupled = couplings("a = -1/2 b", second, (), ())
    return replace(robot("3-rps"), limbs=(LimbSpec("limb 1", first), LimbSpec("limb 2", second, couplings=coupled)))


def test_joints_with_several_freedoms_are_several() -> None:
    made = model_of(all_kinds())
    found = {j.name: j.kind for j in made.joints if j.name.startswith("limb_1")}
    assert list(found.values()) == ["revolute", "prismatic", "revolute", "revolute", "revolute", "prismatic", "ball"]
    screw = made.couplings[0]
    assert (screw.joint, screw.leader, screw.ratio) == ("limb_1_H_2", "limb_1_H_1", 0.5)
    assert made.actuated == ("limb_1_H_1", "limb_1_C_1", "limb_2_E_3")
    assert [(c.joint, c.leader, c.ratio) for c in made.couplings[1:]] == [("limb_2_b", "limb_2_a", -2.0)]


def test_lengths_in_a_unit() -> None:
    made, in_mm = model_of(all_kinds()), model_of(all_kinds(), "mm")
    assert np.allclose([j.at for j in in_mm.joints], np.array([j.at for j in made.joints]) / 1000)
    assert [c.ratio for c in in_mm.couplings] == [0.0005, -2.0]
    with pytest.raises(InputError, match="not a unit of length"):
        gc.export_model("3-rps", unit="furlong")


def test_platforms_on_six_legs() -> None:
    text = gc.export_model(EXAMPLES / "octahedral.yaml")
    assert text.count('type="slide"') == 6
    points = {n: [k, k * k, k**3] for k, n in enumerate("abcdef")}
    with pytest.raises(InputError, match="the file's unit is"):
        gc.export_model({"legs": "ab af cb cd ed ef", "units": "mm", "points": points}, unit="m")


REFUSED = {
    "cables": ("8-cables", "mjcf", "is a cable, which only pulls"),
    "legs": ("ab af cb cd ed ef", "mjcf", "have no dimensions"),
    "format": ("3-rps", "sdf", "models are not written in 'sdf'"),
}


@pytest.mark.parametrize(("source", "form", "says"), REFUSED.values(), ids=REFUSED)
def test_what_is_refused(source: str, form: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        gc.export_model(source, form)


def test_robots_without_joints_or_home() -> None:
    points = ", ".join(f"{n}: free" for n in "abcdef")
    lines = f"title: t\nmobility: 6\npoints: {{{points}}}\nlines: ab af cb cd ed ef\n"
    with pytest.raises(InputError, match="given by its lines"):
        model_of(parse_robot(lines))
    with pytest.raises(InputError, match="no home"):
        model_of(replace(robot("3-rps"), home=None))


LIMITED = """<robot name="arm"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
<joint name="p" type="revolute"><parent link="a"/><child link="b"/><axis xyz="1 2 2"/>
<limit lower="-1" upper="2"/></joint>
<joint name="q" type="prismatic"><parent link="b"/><child link="c"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/>
<limit lower="0" upper="0.5"/></joint>
<joint name="f" type="fixed"><parent link="c"/><child link="d"/><origin xyz="0 1 0"/></joint></robot>"""


def test_limits_and_fixed_links_are_kept(tmp_path: Path) -> None:
    """Of a model that was read: what is written of it is the same."""
    arm = read(tmp_path, LIMITED)
    assert [j.limits for j in arm.joints] == [(-1.0, 2.0), (0.0, 0.5), None]
    for again in (read(tmp_path, mjcf_text(arm)), read(tmp_path, urdf_files(arm).urdf)):
        assert joints(again) == joints(arm)
        assert {"a", "b", "c", "d"} <= set(again.links)


def test_joints_that_no_format_holds(tmp_path: Path) -> None:
    cylinder = read(tmp_path, LIMITED.replace('type="prismatic"', 'type="cylindrical"'))
    with pytest.raises(InputError, match="joint q is cylindrical"):
        mjcf_text(cylinder)
