"""What holds everywhere on ways of robots of joints, against dense samples and other roads to the margin."""

import json
import random
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from commands import invoke
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES

import gcrules as gc
from gcrules.mechanisms.kinematics.branch import Steps
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import Course, close_loops
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.margin_bounds import bounds_of
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.compiling.compiled_limbs import CompiledLimbs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.plans.domain import Proved
from gcrules.poses.plans.limb_domain import LimbDomain
from gcrules.poses.plans.report import Waypoint
from gcrules.screws.pose_text import ANGLES

LOOPED = ("gantry-tau", "h4", "par4")
ROBOTS = ("3-rpr", "3-rrr", "3-rps", "6-rus", "delta", "tricept", "3-prs", "orthoglide", "3-upu", *LOOPED)

ROOM = 1e-9


def robot(name: str) -> Limbs:
    found = mechanism(name)
    assert isinstance(found, Limbs)
    return found


def path(name: str, pose: object, samples: int = 10) -> RobotPath:
    found = gc.path(name, ["home", pose], samples=samples)
    assert isinstance(found, RobotPath)
    return found


def some_pose(name: str, part: float, seed: int) -> dict[str, float]:
    rng, m = random.Random(seed), robot(name).linkage
    part /= 10 if name == "3-rrr" else 1  # its legs are near their reach
    return {n: rng.uniform(-1, 1) * part * (1.0 if n in ANGLES else m.size) for n in free_coordinates(m)}


def driven(m: Linkage) -> list[int]:
    return [sum(len(c.turns) for c in m.home.chains[: a.place]) + a.coordinate for a in m.actuators]


@pytest.mark.parametrize("name", ROBOTS)
def test_no_sample_is_below_the_bound_or_outside_the_ranges(name: str) -> None:
    pose = some_pose(name, 0.03, 1)
    found, dense = path(name, pose), path(name, pose, 300)
    assert 0 < found.least.bound <= dense.margins.min() + ROOM
    assert found.least.bound >= 0.95 * dense.margins.min()
    low, high = found.actuator_ranges.T
    assert (dense.actuator_values >= low - ROOM).all()
    assert (dense.actuator_values <= high + ROOM).all()
    span = dense.actuator_values.max(axis=0) - dense.actuator_values.min(axis=0)
    assert (high - low <= span + 1e-2 * max(robot(name).linkage.size, 1)).all()


@pytest.mark.parametrize("name", ["3-rps", "6-rus", "delta"])
def test_the_compiled_margin_is_not_below_the_bound(name: str) -> None:
    pose = some_pose(name, 0.03, 2)
    found = path(name, pose)
    compiled = gc.compiled(name, coordinates=list(pose))
    assert isinstance(compiled, CompiledLimbs)
    parts = np.sort(np.random.default_rng(0).uniform(0, 1, 1000))
    values = parts[:, None] * np.array(list(pose.values()))
    margins_there = compiled.numbers(values, "margins")["margins"]
    assert np.isfinite(margins_there).all()
    assert margins_there.min() >= found.least.bound - ROOM


@settings(max_examples=15, deadline=None)
@given(st.sampled_from(ROBOTS), st.integers(0, 10_000), st.floats(0.001, 0.1))
def test_every_step_keeps_to_its_bounds(name: str, seed: int, part: float) -> None:
    k = robot(name).linkage
    pose = some_pose(name, part, seed)
    target = Target(tuple(pose), np.array(list(pose.values())))
    course, home = Course(k, target), Configurations.of([k.home])
    joints = close_loops(course, home, course.goal(np.ones(1)))
    if not joints.closed[0]:
        return
    found = bounds_of(k, target, Steps.of(home, joints, target.values[None]))
    if not found.followed[0]:
        assert found.least[0] == 0
        return
    here, parts = home, np.linspace(0, 1, 41)[1:]
    for p in parts:
        step = close_loops(course, here, course.goal(np.array([p])))
        here = here.after(step.amounts, step.links)
        assert margins(k, here).sigma[0] >= found.least[0] - ROOM
        values = np.concatenate(here.joint_values, axis=1)[0]
        within = (values >= found.low[0] - ROOM) & (values <= found.high[0] + ROOM)
        assert within[driven(k)].all()  # rods may spin about themselves
        if name != "gantry-tau":
            assert within.all()


def test_a_dip_between_samples_is_found() -> None:
    ends = ["x=0.005, y=0.456, yaw=0.234rad", "x=0.447, y=-0.317, yaw=0.201rad"]
    coarse, fine = (gc.path("3-rpr", ends, samples=n) for n in (1, 500))
    assert isinstance(coarse, RobotPath)
    assert isinstance(fine, RobotPath)
    assert coarse.margins.min() > 1.04 * fine.margins.min()  # the samples miss it
    assert coarse.least.margin <= 1.01 * fine.margins.min()
    assert 0.9 * fine.margins.min() < coarse.least.bound <= fine.margins.min() + ROOM


def test_nothing_is_told_of_a_singular_path() -> None:
    found = path("3-rpr", "x=0, y=0, yaw=60deg")
    assert found.least.bound == found.least.margin == 0
    assert np.isinf(found.actuator_ranges).all()
    assert json.loads(json.dumps(found.to_json()))["actuator_ranges"]["q1"] == [None, None]


def test_a_plan_proves_margin_and_limits() -> None:
    found = gc.plan("3-rps", "home", "z=0.1, roll=5deg, pitch=5deg", margin=0.5, limits="actuators -0.5..0.5")
    assert found.outcome == "way"
    assert found.proved
    assert found.limits_proved
    assert found.path is not None
    assert found.path.least.bound == found.least >= 0.5
    assert "everywhere" in found.reason


def test_limits_that_a_way_ends_at_are_those_of_samples() -> None:
    amounts = path("3-rps", "z=0.1, roll=0deg, pitch=0deg").actuator_values
    most = float(amounts.max())
    found = gc.plan("3-rps", "home", "z=0.1, roll=0deg, pitch=0deg", limits=f"actuators -1..{most!r}")
    assert found.outcome == "way"
    assert found.proved
    assert not found.limits_proved


def test_the_answer_in_words() -> None:
    run = invoke("path", "3-rps", "--at", "home", "--at", "z=0.1, roll=5deg, pitch=5deg")
    assert run.exit_code == 0, run.output
    assert "everywhere on the path, proved" in run.stdout
    plan = invoke("plan", "3-rps", "--from", "home", "--to", "z=0.1, roll=5deg, pitch=5deg", "--margin", "0.3")
    assert plan.exit_code == 0, plan.output
    assert "proved everywhere" in plan.stdout


def test_a_margin_of_limbs_with_loops_is_proved() -> None:
    found = gc.plan("gantry-tau", "home", "x=0.1, y=0, z=0.1", margin=0.0235)
    assert (found.outcome, found.proved) == ("way", True)
    assert "everywhere" in found.reason


def test_a_margin_that_is_named_is_proved_or_the_plan_is_undecided() -> None:
    name, goal = "3-rps", "z=0.1, roll=5deg, pitch=5deg"
    ends = path(name, goal).margins[[0, -1]]
    proved, close = (gc.plan(name, "home", goal, margin=float(ends.min() * part)) for part in (0.99, 1 - 1e-6))
    assert (proved.outcome, proved.proved) == ("way", True)
    assert (close.outcome, close.proved) == ("undecided", False)
    assert len(close.poses) > 1
    assert close.path is not None
    assert close.path.verdict == "regular"
    assert "the start or the goal has hardly more" in close.reason
    assert "at all samples of it" in close.reason
    run = invoke("plan", name, "--from", "home", "--to", goal, "--margin", repr(float(ends.min() * (1 - 1e-6))))
    assert run.exit_code == 3
    assert "at the samples of the path" in run.stdout


def test_six_legs_keep_the_same_rule() -> None:
    """A margin is proved up to a ten-thousandth of the least one; nearer to it a plan is undecided, with the way."""
    file, goal = EXAMPLES / "octahedral.yaml", "0 0 -100"
    least = gc.path(file, ["home", goal], samples=500).least
    ends = [gc.pose(file, at, nearest=False).margin for at in ("home", goal)]
    assert least.margin == pytest.approx(min(ends), rel=1e-3)
    proved, close = (gc.plan(file, "home", goal, margin=min(ends) * part) for part in (0.995, 1 - 1e-6))
    assert (proved.outcome, proved.proved) == ("way", True)
    assert (close.outcome, close.proved) == ("undecided", False)
    assert len(close.poses) > 1


def test_pieces_whose_margin_is_not_proved_are_gone_around(monkeypatch: pytest.MonkeyPatch) -> None:
    """The straight way is taken for one of which no margin is proved."""
    whole = LimbDomain.prove

    def doubting(self: LimbDomain, way: Sequence[Waypoint], samples: int | None = None) -> Proved:
        found = whole(self, way, samples)
        return replace(found, doubts=(0,), margin_proved=False) if len(way) == 2 else found

    monkeypatch.setattr(LimbDomain, "prove", doubting)
    found = gc.plan("3-rpr", "x=0.3, y=0, yaw=0deg", "x=-0.3, y=0, yaw=-20deg", margin=0.1)
    assert (found.outcome, found.proved) == ("way", True)
    assert len(found.poses) > 2
    never = gc.plan("3-rpr", "x=0.3, y=0, yaw=0deg", "x=-0.3, y=0, yaw=-20deg", margin=0.1, states=2)
    assert (never.outcome, never.proved, len(never.poses)) == ("undecided", False, 2)
    told = gc.plan("3-rpr", "x=0.3, y=0, yaw=0deg", "x=-0.3, y=0, yaw=-20deg", states=2)
    assert (told.outcome, told.proved, len(told.poses)) == ("way", False, 2)
