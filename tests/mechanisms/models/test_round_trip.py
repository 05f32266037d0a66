"""All robots that come with gcrules, written as models and read again: they come back."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from mechanisms.models.hand_made import delta

import gcrules as gc
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.models.imported import Imported
from gcrules.mechanisms.models.importing import import_file, import_model
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.of_robot import model_of

# Where joints are told in other words: a cylindrical joint with one freedom driven is a turn and a slide, turns whose
# axes meet are a cross, limbs that are alike come first.
OTHERWISE = {
    "3-cpu": "3-RP*PU",
    "3-crr": "3-RP*RR",
    "3-rrr-spherical": "3-R*U",
    "3-ups-s": "3-UP*S + S",
    "agile-eye": "3-R*U",
    "gantry-tau": "P*SS + P*4S + P* (SS | 4S)",
    "omni-wrist-iii": "2-R*UR + 2-UU",
    "par4": "(R*4S | R*4S) RR R R (R*4S | R*4S)",
    "tricept": "3-UP*S + UP",
}
SHIPPED = tuple(one.id for one in robots() if one.id != "8-cables")


def test_there_are_robots() -> None:
    assert len(SHIPPED) == 41
    assert set(OTHERWISE) < set(SHIPPED)


def by_way_of(name: str, form: str, folder: Path) -> Imported:
    """The robot as it is read from a file of this format."""
    file = folder / f"robot.{form}"
    file.write_text(gc.export_model(name, form), encoding="utf-8")
    if form == "urdf":
        (folder / "robot-closures.yaml").write_text(gc.export_model(name, "closures"), encoding="utf-8")
    return import_file(file)


def dimensions(found: Imported) -> dict[str, np.ndarray]:
    return {name: np.array([float(c) for c in v]) for name, v in found.robot.values_at().items()}


@pytest.mark.parametrize("form", ["mjcf", "urdf"])
@pytest.mark.parametrize("name", SHIPPED)
def test_a_robot_comes_back(name: str, form: str, tmp_path: Path) -> None:
    robot = read_robot(name)
    found = by_way_of(name, form, tmp_path)
    assert found.robot.chain == OTHERWISE.get(name, robot.chain)
    assert found.robot.mobility == robot.mobility
    assert len(found.drives) == robot.chain.count("*") or found.robot.chain[0].isdigit()
    assert not any(m.distance > 1e-8 * found.size or m.angle > 1e-8 for m in found.moved)
    assert not found.exact
    assert found.deviation < 1e-8


@pytest.mark.parametrize("name", SHIPPED)
def test_what_came_back_stays_as_it_is(name: str) -> None:
    """Written and read once more, its limbs in the sequence of its file, it has the same relations and dimensions."""
    first = import_model(model_of(read_robot(name)))
    once = import_model(model_of(first.robot))
    again = import_model(model_of(once.robot))
    assert first.robot.chain == once.robot.chain == again.robot.chain
    ours, theirs = ({d.name: d.text for d in r.robot.family.definitions} for r in (once, again))
    assert sorted(kind(text) for text in ours.values()) == sorted(kind(text) for text in theirs.values())
    if "|" not in once.robot.chain:  # rods side by side have no sequence
        assert ours == theirs
        one, other = dimensions(once), dimensions(again)
        assert all(np.allclose(one[n], other[n], atol=1e-8 * once.size) for n in one)


def kind(text: str) -> str:
    """A relation without numbers."""
    return "".join(c for c in text if not c.isdigit())


def lines(found: Model, size: float) -> list[tuple[str, np.ndarray]]:
    """Each joint as its point, line or direction, in parts of the size."""
    made = []
    for j in found.joints:
        at = np.array(j.at) / size
        if j.kind == "ball":
            made.append((j.kind, at))
        elif j.kind in ("revolute", "prismatic"):
            axis = np.array(j.axes[0])
            axis *= np.sign(axis[np.argmax(np.abs(axis).round(6))])
            made.append((j.kind, axis if j.kind == "prismatic" else np.concatenate([axis, np.cross(at, axis)])))
    return made


@pytest.mark.parametrize("name", SHIPPED)
def test_all_joints_are_where_they_were(name: str) -> None:
    """The joints of a model of what came back are those of the first model: its rods have the lengths that they had."""
    own = model_of(read_robot(name))
    found = import_model(own)
    left = lines(model_of(found.robot), found.size)
    for kind, values in lines(own, found.size):
        near = [k for k, (other, theirs) in enumerate(left) if other == kind and np.allclose(values, theirs, atol=1e-8)]
        assert near, (kind, values)
        left.pop(near[0])
    assert not left


@pytest.mark.parametrize(("elbow", "rods"), [("ball", 6), ("turns", 6), ("cross", 6)])
def test_rods_of_a_delta_end_where_they_did(elbow: str, rods: int) -> None:
    own = delta(0.0, elbow)
    wrists = [j.at for j in own.joints if j.name.startswith("wrist")]
    found = [j.at for j in model_of(import_model(own).robot).joints if j.kind == "ball"]
    assert len(wrists) == rods
    assert all(min(np.abs(np.subtract(at, other)).max() for other in found) < 1e-9 for at in wrists)


def test_rods_with_crosses_keep_their_length() -> None:
    found = dimensions(import_model(delta(0.0, "crosses")))
    assert all(np.isclose(np.linalg.norm(found[f"C{k}"] - found[f"B{k}"]), np.hypot(0.34, 0.5)) for k in (1, 2, 3))
