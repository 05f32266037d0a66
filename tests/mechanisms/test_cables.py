"""Robots on cables: wrench closure, against cable lengths of moved platforms, and against motions drawn at random."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from places import DATA

import gcrules as gc
from gcrules.mechanisms.kinematics.closure import closure, closures
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.report import RobotPose

FILES = {"8-cables": "8-cables", "4-cables": DATA / "redundant" / "4-cables.yaml"}
AXES = {"8-cables": ("x", "y", "z", "roll", "pitch", "yaw"), "4-cables": ("x", "y", "yaw")}
Floats = NDArray[np.float64]


@cache
def analysis(name: str) -> Any:
    return gc.analyze(FILES[name])


def poses(name: str, number: int) -> list[dict[str, float]]:
    rng = np.random.default_rng(7)
    turning = {"roll", "pitch", "yaw"}
    return [{n: float(rng.uniform(-1, 1) * (0.7 if n in turning else 2.0)) for n in AXES[name]} for _ in range(number)]


def ends(there: RobotPose) -> tuple[Floats, Floats]:
    """The cables' ends on the base and on the platform, in a configuration."""
    numbers = range(1, len(there.actuators) + 1)
    base, moved = (np.array([there.points[f"{letter}{k}"] for k in numbers]) for letter in "AB")
    return base, moved


def wrenches(there: RobotPose) -> Floats:
    """The pulls of the cables, about the origin: from the places of their ends alone."""
    base, moved = ends(there)
    f = (base - moved) / np.linalg.norm(base - moved, axis=1, keepdims=True)
    return np.concatenate([f, np.cross(moved, f)], axis=1)


@pytest.mark.parametrize("name", FILES)
def test_closure_is_what_it_says(name: str) -> None:
    """Tensions balance and are positive; or the escape makes no cable longer, seen by moving the platform."""
    seen = {True: 0, False: 0}
    rng = np.random.default_rng(3)
    for pose in poses(name, 24):
        there = gc.pose(analysis(name), pose, nearest=False)
        cables = there.jacobian.amplification.cables
        assert cables is not None
        seen[cables.held] += 1
        pulls = wrenches(there)
        if cables.held:
            tensions = np.array([effort for _, effort in cables.efforts])
            assert np.abs(tensions @ pulls).max() < 1e-9
            assert tensions.min() == pytest.approx(cables.least)
            assert tensions.mean() == pytest.approx(1)
            drawn = rng.normal(size=(4000, 6)) * ([1, 1, 0, 0, 0, 1] if name == "4-cables" else 1)
            rates = -drawn @ pulls.T  # the power of a pull is minus the rate of the cable
            assert (rates.max(axis=1) > 0).all()  # no motion shortens all of them
            assert not any("closure" in note for note in there.notes)
        else:
            assert cables.escape is not None
            assert any("wrench closure is lost" in note for note in there.notes)
            v, w = np.array(cables.escape[:3]), np.array(cables.escape[3:])
            centre = there.jacobian.centre
            base, moved = ends(there)
            before = np.linalg.norm(moved - base, axis=1)
            step = 1e-6
            after = np.linalg.norm(moved + step * (v + np.cross(w, moved - centre)) - base, axis=1)
            assert (after - before).max() <= 1e-9 * step + 1e-12
            assert (after - before).min() < -1e-8
    assert min(seen.values()) >= 3, seen


def test_least_tensions_are_the_greatest_that_can_be_had() -> None:
    """By duality: y ≥ 0 with sum 1 and y − t/c in the range of the rates proves that no least tension is above t."""
    rng = np.random.default_rng(1)
    for n, f in ((4, 3), (5, 3), (7, 6), (8, 6), (9, 6)):
        rates = rng.normal(size=(40, n, f))
        pulls = (True,) * n
        every = closures(rates, pulls)
        for k in range(40):
            one = closure(rates[k], pulls)
            assert every[k] == pytest.approx(max(one.least, -1.0))
            if one.efforts is None:
                assert one.escape is not None
                assert (rates[k] @ one.escape).max() < 1e-9
                continue
            kernel = np.linalg.svd(rates[k])[0][:, f:]
            tried = rng.normal(size=(3000, n - f)) @ kernel.T
            total = tried.sum(axis=1, keepdims=True)
            tried = tried / total * n
            assert tried.min(axis=1).max() <= one.least + 1e-9


def test_other_actuators_may_push() -> None:
    """One cable against one slide: the slide pushes as hard as the cable pulls."""
    rates = np.array([[1.0], [1.0]])
    assert closure(rates, (True, False)).efforts == pytest.approx([1, -1])
    assert closure(rates, (True, True)).efforts is None
    assert closures(rates[None], (True, True)).tolist() == [-1.0]


def test_where_it_is_told() -> None:
    a = analysis("8-cables")
    assert "it has 8 cables for 6 freedoms. Its cables only pull: elsewhere they hold the platform where" in a.statement
    assert a.robot.chain == "8-cable"
    home = gc.pose(a, nearest=False)
    assert "Wrench closure: tensions that balance each other" in home.text()
    assert home.to_json()["jacobian"]["amplification"]["cables"]["closure"] is True
    way = gc.path(a, ["home", "0 0 1; euler zyx 30 0 0 deg"], samples=20)
    assert isinstance(way, RobotPath)
    assert "closure" in way.csv().splitlines()[0]
    assert way.amplifications.indices["closure"][0] == pytest.approx(0.9944, abs=1e-4)
    found = gc.singular_map(a, ["x -3:3:5", "y -3:3:5"], measure="closure")
    (least, _), (most, place) = found.summary.index
    assert (least < 0, most, place) == (True, pytest.approx(0.9944, abs=1e-4), (0.0, 0.0))
    with pytest.raises(gc.InputError, match="no cables"):
        gc.singular_map("delta", ["x -1:1:5", "y -1:1:5"], measure="closure")


def test_too_few_cables_need_a_load() -> None:
    text = (DATA / "redundant" / "4-cables.yaml").read_text(encoding="utf-8")
    three = text.replace("copies: 4", "copies: 3").replace(", A4: [0, 8]", "").replace(", B4: [4, 3]", "")
    robot = gc.load(three)
    assert "too few to balance each other" in gc.analyze(robot).statement
    cables = gc.pose(robot, nearest=False).jacobian.amplification.cables
    assert cables is not None
    assert not cables.held


@pytest.mark.parametrize(
    ("line", "said"),
    [("cable: A% B% C%", "a cable joins two points"), ("cable: A% x", "a cable joins two points")],
)
def test_faults(line: str, said: str) -> None:
    text = (DATA / "redundant" / "4-cables.yaml").read_text(encoding="utf-8").replace("cable: A% B%", line)
    with pytest.raises(gc.GcrulesError, match=said):
        gc.load(text)
