"""All 40 real postures of Dietmaier's platform, followed at once, beside the same paths one at a time and a search.

The search solves the legs' lengths by Newton's method from random poses. It is asked for as many starts as take a few
seconds; what it finds are fewer postures than there are, and nothing tells it so.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gcrules as gc
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.modes.conditions import forms_of_pairs, motions, quadrics
from gcrules.poses.modes.start import start
from gcrules.poses.modes.tracking import Accuracy, follow
from gcrules.poses.modes.zeros import zeros_of

FILE = Path(__file__).resolve().parent.parent / "examples" / "dietmaier.yaml"
LENGTHS = np.array([1, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071])
STARTS = 300


def legs() -> tuple[Any, Any]:
    """The points of the base and of the platform."""
    rig = mechanism(FILE).six_legs().rig
    return rig.base - rig.centre_of_turns, rig.arms


def at_once() -> int:
    base, arms = legs()
    return int(zeros_of(*forms_of_pairs(base, arms, LENGTHS)).boxes.real.sum())


def one_at_a_time() -> int:
    base, arms = legs()
    forms, _ = forms_of_pairs(base, arms, LENGTHS)
    first, known = start()
    system, target = quadrics(first), quadrics(np.linalg.qr(forms.T)[0].T)
    ends = [follow(system, target, known[k : k + 1].copy(), Accuracy()).x[0] for k in range(len(known))]
    turned = [x * np.conj(x[np.argmax(np.abs(x))]) for x in ends]
    return sum(bool(np.abs(x.imag).max() < 1e-8) for x in turned)


def search() -> int:
    """Different postures found from random poses by Newton's method with six unknowns."""
    base, arms = legs()
    rng = np.random.default_rng(0)
    found: list[Any] = []
    for _ in range(STARTS):
        motion = motions(_random(rng)[None])[0]
        turn, shift = motion[:3, :3], motion[:3, 3]
        for _ in range(50):
            ends = arms @ turn.T
            along = ends + shift - base
            off = (along * along).sum(axis=1) - LENGTHS**2
            rows = 2 * np.concatenate([along, np.cross(ends, along)], axis=1)
            step = np.linalg.lstsq(rows, -off, rcond=None)[0]
            step *= 0.5 / max(0.5, np.abs(step).max())
            shift = shift + step[:3]
            turn = _turned(step[3:]) @ turn
            if np.abs(step).max() < 1e-12:
                break
        place = (arms @ turn.T + shift).ravel()
        if np.abs(off).max() < 1e-9 and all(np.abs(place - other).max() > 1e-6 for other in found):
            found.append(place)
    return len(found)


def _random(rng: np.random.Generator) -> Any:
    x = rng.normal(size=8)
    x[4:] -= x[:4] * (x[:4] @ x[4:]) / (x[:4] @ x[:4])
    return x


def _turned(vector: Any) -> Any:
    angle = float(np.linalg.norm(vector)) or 1e-300
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def test_forty_postures(ratio: Callable[..., Any]) -> None:
    ratio(at_once, {"one path at a time": one_at_a_time}, agree=lambda a, b: a == b == 40, within=0.5, rounds=3)


def test_beside_a_search(ratio: Callable[..., Any]) -> None:
    missed = f"Newton from {STARTS} random poses"
    ratio(at_once, {missed: search}, agree=lambda a, b: a == 40 and b < a, within=0.5, rounds=1)


@pytest.mark.parametrize("form", ["whole answer"])
def test_with_margins_and_verdicts(ratio: Callable[..., Any], form: str) -> None:
    analysis = gc.analyze(FILE)
    ratio(lambda: gc.assembly_modes(analysis, actuators=LENGTHS), {}, within=2, rounds=3)
