"""Paths of robots of joints beside the same path gone step by step, as from one pose to the next."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.path import path_of_limbs
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.limbs.way import Way
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
