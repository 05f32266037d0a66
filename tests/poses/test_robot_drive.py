"""Robots of joints driven along paths: many places at once, beside the same path gone step by step."""

from __future__ import annotations

import random
import re
from functools import cache
from typing import Any

import numpy as np
import pytest

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.itinerary import Itinerary
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.margin import limb_margins, margin
from gcrules.mechanisms.kinematics.solve import free_coordinates, solve
from gcrules.mechanisms.kinematics.soundness import sound
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs import drive as driving
from gcrules.poses.limbs.drive import drive
from gcrules.poses.limbs.factors import factor_values, factors
from gcrules.poses.limbs.path import path_of_limbs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.limbs.way import Stretch, Way
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.threshold import threshold_of

CASES = {
    # how far poses are from home, in parts of what joints move; how many segments
    "delta": (0.5, 6),
    "orthoglide": (0.5, 6),
    "3-upu": (0.7, 5),
    "6-rus": (0.2, 3),
    "3-rpr": (1.0, 4),
    "3-rps": (1.0, 5),
}
EACH = 2
LIMIT = threshold_of("0.5 deg")


@cache
def robot(name: str) -> Limbs:
    found = mechanism(name)
    assert isinstance(found, Limbs)
    return found


def some_poses(name: str, seed: int, scale: float, number: int) -> list[dict[str, float]]:
    rng, m = random.Random(f"{name} {seed}"), robot(name).linkage
    return [
        {n: scale * rng.uniform(-1, 1) * (0.8 if n in ANGLES else 0.4 * m.size) for n in free_coordinates(m)}
        for _ in range(number + 1)
    ]


def itinerary(name: str, poses: list[dict[str, float]]) -> Itinerary:
    m = robot(name).linkage
    targets = [target_of(m, p, None) for p in poses]
    return Itinerary(m, tuple(t for t in targets if isinstance(t, Target)))


class Stepped:
    """The path step by step, one segment after the other."""

    def __init__(self, way: Itinerary, each: int) -> None:
        self.changes: list[Stretch] = []
        self.left: list[Stretch] = []
        self.samples: dict[float, Configuration] = {}
        self.doubt = False
        here = solve(way.m, way.poses[0]).configuration
        for k, course in enumerate(way.courses):
            one, doubt = Way.to(way.m, course.target, here)
            self.doubt |= doubt is not None
            self.changes += [(k + a, k + b) for a, b in one.signs()[0]]
            self.left += [(k + a, k + b) for a, b in one.unproved()]
            self.samples |= {float(k + s): one.at(s) for s in np.linspace(0, 1, each + 1).tolist()}
            here = one.nodes[-1][1]


def stretches(found: Any) -> list[Stretch]:
    return sorted({*found.undecided, *((c.first, c.last) for c in found.crossings)})


@pytest.mark.parametrize("name", CASES)
def test_what_is_found_step_by_step(name: str) -> None:
    scale, number = CASES[name]
    compare(name, some_poses(name, 0, scale, number))


CROSSING = {
    "3-rpr": [{"x": 0.0, "y": 0.0, "yaw": y} for y in (0.0, 0.2, 0.5, 0.0)],
    "3-rps": [{"z": -0.1, "roll": 0.0, "pitch": p} for p in (0.0, 0.4, 1.0)],
}


@pytest.mark.parametrize("name", CROSSING)
def test_crossings_found_step_by_step(name: str) -> None:
    found = compare(name, CROSSING[name])
    assert found is not None
    assert found.crossings


def compare(name: str, poses: list[dict[str, float]]) -> RobotPath | None:
    """What is found at once and step by step is the same; None where the robot does not assemble in either."""
    number = len(poses) - 1
    way = itinerary(name, poses)
    try:
        slow = Stepped(way, EACH)
    except InputError as fault:
        where = fault.message.partition(" to ")[0]
        with pytest.raises(InputError, match=re.escape(where)):
            path_of_limbs(robot(name), poses, samples=EACH * number, threshold=LIMIT)
        return None
    fast = path_of_limbs(robot(name), poses, samples=EACH * number, threshold=LIMIT)
    assert (fast.branch_doubt is not None) == slow.doubt
    assert len(fast.crossings) == len(slow.changes)
    for crossing, (a, b) in zip(fast.crossings, slow.changes, strict=True):
        assert crossing.parameter == pytest.approx((a + b) / 2, abs=2e-5)
    open_fast, open_slow = stretches(fast), slow.left
    for a, b in open_slow:
        assert any(x <= b + 1e-3 and a <= y + 1e-3 for x, y in open_fast)
    assert sum(b - a for a, b in open_fast) == pytest.approx(sum(b - a for a, b in open_slow), abs=2e-3)
    m = way.m
    for p, c in slow.samples.items():
        n = int(np.argmin(np.abs(fast.parameters - p)))
        if abs(fast.parameters[n] - p) > 1e-12 or fast.parameters[n] in [x.parameter for x in fast.crossings]:
            continue
        assert fast.margins[n] == pytest.approx(margin(m, c).sigma, abs=1e-8)
        assert fast.limb_margins[n] == pytest.approx(limb_margins(m, Configurations.of([c])).min(), abs=1e-7)
        assert fast.coordinates[n] == pytest.approx(coordinates(fast.names, c.platform, m.centre), abs=1e-8)
        driven = [c.joint_values[a.place][a.coordinate] for a in m.actuators]
        assert fast.actuator_values[n] == pytest.approx(driven, abs=1e-7)
        values = [f.value for f in factors(robot(name).analysis, c.values)]
        assert fast.factor_values[n] == pytest.approx(values, abs=1e-7, nan_ok=True)
    return fast


@pytest.mark.parametrize("name", ["delta", "orthoglide"])
def test_beyond_reach_both_stop_in_the_same_segment(name: str) -> None:
    poses = [*some_poses(name, 5, 0.2, 2), dict.fromkeys(free_coordinates(robot(name).linkage), 1.4)]
    poses[-1][free_coordinates(robot(name).linkage)[0]] = 9.0
    with pytest.raises(InputError, match="between pose 2 and pose 3"):
        path_of_limbs(robot(name), poses, samples=9, threshold=LIMIT)
    with pytest.raises(InputError):
        Stepped(itinerary(name, poses), 1)


@pytest.mark.parametrize("size", [1, 256])
@pytest.mark.parametrize("name", ["delta", "6-rus", "3-rpr"])
def test_prediction_changes_nothing(name: str, size: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """However many places are predicted at once, or none: the configurations are those of the steps."""
    way = itinerary(name, some_poses(name, 2, 0.5 * CASES[name][0], 3))
    start = solve(way.m, way.poses[0]).configuration
    parameters = np.linspace(0, 3, 13)
    monkeypatch.setattr(driving, "_AT_ONCE", size)
    found = drive(way, start, parameters)
    monkeypatch.setattr(driving, "_predicted", lambda *_: None)
    slow = drive(way, start, parameters)
    assert found.doubt is slow.doubt is None
    assert not slow.regular.any()  # what is gone step by step is looked at afterwards
    assert size == 1 or found.regular.any()
    assert found.nodes.parameters.tolist() == slow.nodes.parameters.tolist()
    assert found.nodes.here.platform == pytest.approx(slow.nodes.here.platform, abs=1e-8)
    for a in way.m.actuators:
        one, other = (d.nodes.here.joint_values[a.place][:, a.coordinate] for d in (found, slow))
        assert one == pytest.approx(other, abs=1e-7)


def test_where_the_robot_strays_nothing_is_predicted(monkeypatch: pytest.MonkeyPatch) -> None:
    """What does not pass the checks of a stack is left to the steps, which have the same checks one by one."""
    way = itinerary("delta", some_poses("delta", 2, 0.3, 2))
    start = solve(way.m, way.poses[0]).configuration
    parameters = np.linspace(0, 2, 9)
    sizes: list[int] = []

    def strict(m: Any, values: Any, before: Any, links: Any, amounts: Any) -> Any:
        sizes.append(len(amounts[0]))
        if len(amounts[0]) > 3:
            raise NotClosed("some of so many")
        return sound(m, values, before, links, amounts)

    whole = drive(way, start, parameters)
    monkeypatch.setattr("gcrules.poses.limbs.drive.sound", strict)
    found = drive(way, start, parameters)
    assert max(sizes) > 3
    assert found.regular.all()
    assert found.nodes.here.platform == pytest.approx(whole.nodes.here.platform, abs=1e-9)


def test_places_of_names_and_factors_in_stacks() -> None:
    way = itinerary("3-rps", some_poses("3-rps", 1, 0.3, 2))
    found = drive(way, solve(way.m, way.poses[0]).configuration, np.linspace(0, 2, 7)).nodes
    analysis = robot("3-rps").analysis
    every = factor_values(analysis, found.values)
    assert every.shape == (7, len(analysis.parts))
    for n in range(len(found)):
        assert every[n] == pytest.approx([f.value for f in factors(analysis, found.one(n).values)], abs=1e-12)
