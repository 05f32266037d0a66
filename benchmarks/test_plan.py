"""Ways of plans and aspects, many at once, beside one after the other as planners usually go."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.plans.leg_domain import leg_space
from gcrules.poses.plans.limb_domain import limb_space
from gcrules.poses.plans.space import Space, Ways

OCTAHEDRAL = Path(__file__).resolve().parent.parent / "examples" / "octahedral.yaml"
NUMBER = 256
MARGIN = 0.02


def of_legs() -> tuple[Space, Any]:
    home = np.array([[0.0, 0, 0, 1, 0, 0, 0]])
    return leg_space(mechanism(OCTAHEDRAL).six_legs(), home, MARGIN, None, None), home


def of_limbs() -> tuple[Space, Any]:
    m = Limbs.of(read_robot("3-rps"))
    space = limb_space(m, ("z", "roll", "pitch"), (), MARGIN, None, None)
    return space, np.zeros((1, 3 + space.joints))


@pytest.mark.parametrize(("kind", "goal"), [(of_legs, 2), (of_limbs, 20)], ids=["six legs", "3-RPS"])
def test_ways_from_home(ratio: Callable[..., Any], kind: Callable[[], tuple[Space, Any]], goal: int) -> None:
    """How far the straight ways from home to poses at random keep a margin."""
    space, home = kind()
    random = np.random.default_rng(1)
    goals = space.drawn(random, NUMBER, np.concatenate([home, home]), 0.5)
    starts = np.repeat(home, len(goals), axis=0)

    def at_once() -> Any:
        return space.gone(starts, goals).parts

    def one_by_one() -> Any:
        ways: list[Ways] = [space.gone(home, goal[None]) for goal in goals]
        return np.concatenate([w.parts for w in ways])

    def agree(one: Any, other: Any) -> bool:
        return bool(np.abs(one - other).max() <= 1e-9)

    ratio(at_once, {"one by one": one_by_one}, agree=agree, at_least={"one by one": goal}, rounds=3, others_rounds=1)
