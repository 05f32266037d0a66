"""Paths of robots of joints beside the same path gone step by step, as from one pose to the next."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.itinerary import Itinerary
from gcrules.mechanisms.kinematics.margin import margin, margins
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.drive import drive
from gcrules.poses.limbs.nodes import Nodes
from gcrules.poses.limbs.path import path_of_limbs, path_targets
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.limbs.way import Way
from gcrules.poses.limbs.way_bounds import way_bounds
from gcrules.screws.threshold import DEFAULT

NUMBER = 120


def test_path_of_poses(ratio: Callable[..., Any]) -> None:
    """Delta through 120 poses of a curve: in both one branch is followed, and nothing on it is singular, proved."""
    found = Limbs.of(read_robot("delta"))
    found.analysis  # noqa: B018 - known before
    m = found.linkage
    places = 0.1 * np.arange(NUMBER + 1)
    poses = [{"x": 0.4 * np.sin(t), "y": 0.3 * np.sin(2 * t), "z": 0.2 * np.sin(t / 2)} for t in places]

    def at_once() -> Any:
        path = path_of_limbs(found, poses, samples=NUMBER, threshold=DEFAULT)
        assert path.branch_doubt is None
        assert not path.undecided
        return path.margins

    def step_by_step() -> Any:
        here, margins = m.home, [margin(m, m.home).sigma]
        targets = [target_of(m, p, None) for p in poses]
        for before, after in pairwise(targets):
            assert before is not None
            assert after is not None
            way, doubt = Way.to(m, after.after(before, m.centre), here)
            assert doubt is None
            assert way.signs() == ((), None)
            assert not way.unproved()
            here = way.nodes[-1][1]
            margins.append(margin(m, here).sigma)
        return np.array(margins)

    def agree(one: Any, other: Any) -> bool:
        return bool(np.abs(one - other).max() <= 1e-8)

    ratio(
        at_once, {"step by step": step_by_step}, agree=agree, at_least={"step by step": 10}, rounds=3, others_rounds=1
    )


def test_bound_of_the_margin(ratio: Callable[..., Any]) -> None:
    """Delta over 8 long pieces: the bound that is proved everywhere, beside 20,000 samples on the same branch, which
    prove nothing of the margin between them.
    """
    found = Limbs.of(read_robot("delta"))
    m = found.linkage
    places = np.arange(9)
    way = Itinerary(m, tuple(path_targets(m, [{"x": 0.4 * np.sin(t), "y": 0.3 * np.cos(2 * t), "z": 0.1 * t / 8}
                                              for t in places])))  # fmt: skip

    def proved() -> float:
        return way_bounds(way, _nodes(way, 20)).least

    def sampled() -> float:
        return min(float(margins(m, some.here).sigma.min()) for some in _nodes(way, 2_500).blocks())

    def agree(bound: float, met: float) -> bool:
        return 0.97 * met <= bound <= met + 1e-9

    ratio(proved, {"dense samples": sampled}, agree=agree, rounds=3, others_rounds=1)


def test_a_dip_that_samples_miss(ratio: Callable[..., Any]) -> None:
    """3-RPR past a dip of the margin between its poses: the bound finds it, 2 samples do not, 500 do."""
    found = Limbs.of(read_robot("3-rpr"))
    m = found.linkage
    ends = [{"x": 0.005, "y": 0.456, "yaw": 0.234}, {"x": 0.447, "y": -0.317, "yaw": 0.201}]
    way = Itinerary(m, tuple(path_targets(m, ends)))
    first, last = margins(m, _nodes(way, 1).here).sigma.tolist()

    def proved() -> float:
        return way_bounds(way, _nodes(way, 20)).least

    def sampled() -> float:
        return min(float(margins(m, some.here).sigma.min()) for some in _nodes(way, 500).blocks())

    def agree(bound: float, met: float) -> bool:
        return 0.97 * met <= bound <= met + 1e-9 and met < 0.96 * min(first, last)

    ratio(proved, {"dense samples": sampled}, agree=agree, rounds=3, others_rounds=1)


def _nodes(way: Itinerary, each: int) -> Nodes:
    """The configurations at so many places of each segment, on one branch, proved."""
    first = solve(way.m, way.poses[0])
    driven = drive(way, first.configuration, np.linspace(0, len(way.courses), each * len(way.courses) + 1))
    assert first.doubt is None
    assert driven.doubt is None
    return driven.nodes
