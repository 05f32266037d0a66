"""Compiled conditions of 10⁶ poses, beside stacked Jacobians and their determinants and beside the memory's bandwidth.

The reference is what one writes without them: six rows (force; moment) of each pose by einsum and cross, and
numpy.linalg.det of the stack. "rows by hand" makes the same rows without cross, which is slow; "det alone" has them
ready. "bandwidth" copies as many bytes as a pose has (12 numbers read, 1 written): less cannot be moved.
All on one core, poses as gc.pose takes them (translations (N, 3), matrices (N, 3, 3), row after row).
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gcrules as gc
from gcrules.mechanisms.analyze import analyze_legs
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.moving_platform import rig
from gcrules.poses.numbers.arrays import matrices

MANY = 1_000_000
EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
RNG = np.random.default_rng(6)
TURNS = np.ascontiguousarray(matrices(RNG.normal(size=(MANY, 4))))
SHIFTS = RNG.normal(size=(MANY, 3))
OUT = np.empty(MANY)

GOALS = {
    ("octahedral", "numba"): {"jacobians and det": 60, "det alone": 15, "bandwidth": 1 / 3},
    ("platform-6-6", "numba"): {"jacobians and det": 15},
    ("octahedral", "numpy"): {"jacobians and det": 5},
    ("platform-6-6", "numpy"): {"jacobians and det": 5},
}


def rows_by_cross(base: Any, arms: Any) -> Any:
    ends = np.einsum("nij,kj->nki", TURNS, arms) + SHIFTS[:, None, :]
    return np.concatenate([ends - base, np.cross(base, ends)], axis=2)


def rows_by_hand(base: Any, arms: Any) -> Any:
    rows = np.empty((MANY, 6, 6))
    ends = (TURNS.reshape(-1, 3) @ arms.T).reshape(MANY, 3, 6).transpose(0, 2, 1) + SHIFTS[:, None, :]
    rows[:, :, :3] = ends - base
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        rows[:, :, 3 + i] = base[:, j] * ends[:, :, k] - base[:, k] * ends[:, :, j]
    return rows


def agree(one: Any, other: Any) -> bool:
    return bool(np.abs(one - other).max() <= 1e-10 * np.abs(one).max())


@pytest.mark.parametrize(("robot", "engine"), GOALS, ids=["-".join(key) for key in GOALS])
def test_compiled(ratio: Callable[..., Any], robot: str, engine: str) -> None:
    if not find_spec(engine):
        pytest.skip(f"{engine} is not installed")
    analysis = analyze_legs(load_platform(EXAMPLES / f"{robot}.yaml"))
    assert analysis.platform is not None
    value = gc.compiled(analysis, engine=engine, about="origin")
    legs = rig(analysis.structure, analysis.platform, "origin")
    turned = sum(leg != typed for leg, typed in zip(legs.legs, analysis.structure.legs, strict=True))
    sign = -((-1) ** turned)
    ready = rows_by_cross(legs.base, legs.arms)
    expected = sign * np.linalg.det(ready)
    half = 13 * MANY // 2
    memory = np.zeros(2 * half)

    def bandwidth() -> Any:
        memory[:half] = memory[half:]
        return expected

    ratio(
        lambda: value(SHIFTS, TURNS, out=OUT),
        {
            "jacobians and det": lambda: sign * np.linalg.det(rows_by_cross(legs.base, legs.arms)),
            "rows by hand and det": lambda: sign * np.linalg.det(rows_by_hand(legs.base, legs.arms)),
            "det alone": lambda: sign * np.linalg.det(ready),
            "bandwidth": bandwidth,
        },
        agree=agree,
        at_least=GOALS[robot, engine],
        rounds=7,
    )
