"""Certificates where two singular sheets are so near each other that a grid of samples steps over both.

The determinant of `two-tripods.yaml` has a factor without zeros in these ranges, and the heights of A above a, b, c
and of B above d, e: signs are checked by these heights, which had no part in the certificate.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.poses.certificates.certificate import Certificate

PLATFORM: Any = gc.load(EXAMPLES / "two-tripods.yaml")
HOME = PLATFORM.points["A"][2]
OVER = ("x -100:100", "y -100:100", "z -500:500", "roll -20:20 deg", "yaw -20:20 deg")
NODES = {3: 40, 5: 8}
"""Nodes along each coordinate, by the number of coordinates: tens of thousands in all."""
STEPPED_OVER = {3: 1, 5: 10}
"""Sheets that are so many millimetres apart, or nearer, are between two nodes."""


def apart(gap: Fraction) -> Any:
    """The platform with its sheets so many millimetres apart."""
    moved = {name: (*PLATFORM.points[name][:2], gap) for name in "de"}
    return replace(PLATFORM, points={**PLATFORM.points, **moved})


@cache
def certificate(gap: Fraction, number: int, boxes: int = 1000) -> Certificate:
    return gc.certify(apart(gap), OVER[:number], about=f"0,0,{float(HOME)}", boxes=boxes)


@pytest.mark.parametrize("number", [3, 5])
@pytest.mark.parametrize("gap", [100, 10, 1, Fraction(1, 10)], ids=lambda gap: f"{float(gap):g}")
def test_a_pose_on_a_sheet_is_found(gap: Fraction, number: int) -> None:
    found = certificate(Fraction(gap), number)
    assert (found.verdict, found.holds) == ("singular", False)
    heights = [Fraction(end[2]) + HOME for end in found.bad.ends]
    inside = [0 < height < gap for height in heights]
    assert sorted(inside) == [False, True]
    assert found.bad.place[2] + float(HOME) == pytest.approx(0 if min(heights) < 0 else float(gap), abs=1e-6)


@pytest.mark.parametrize("gap", [10, 1, Fraction(1, 10)], ids=lambda gap: f"{float(gap):g}")
def test_sheets_may_lean(gap: Fraction) -> None:
    """The robot turned about A: its sheets lie across no coordinate."""
    platform, middle = apart(Fraction(gap)), PLATFORM.points["A"]
    turned = [[Fraction(c, 3) for c in row] for row in ((2, -2, 1), (1, 2, 2), (-2, -1, 2))]
    points = {
        name: tuple(
            sum((t * (c - m) for t, c, m in zip(row, place, middle, strict=True)), start)
            for row, start in zip(turned, middle, strict=True)
        )
        for name, place in platform.points.items()
    }
    over = [f"{name} -300:300" for name in "xyz"]
    found = gc.certify(replace(platform, points=points), over, about=f"0,0,{float(HOME)}", boxes=1000)
    assert found.verdict == "singular"
    up = [row[2] for row in turned]
    heights = [sum((u * Fraction(c) for u, c in zip(up, end, strict=True)), HOME) for end in found.bad.ends]
    assert sorted(0 < height < gap for height in heights) == [False, True]


@pytest.mark.parametrize("number", [3, 5])
@pytest.mark.parametrize("gap", [100, 10, 1, Fraction(1, 10), Fraction(1, 100), 0], ids=lambda gap: f"{float(gap):g}")
def test_a_grid_steps_over_thin_sheets(gap: Fraction, number: int) -> None:
    """It sees one sign (the table in docs/certify.md)."""
    ends = np.array([100, 100, 500, np.radians(20), np.radians(20)])[:number]
    axes = [np.linspace(-end, end, NODES[number]) for end in ends]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, number)
    turns = np.zeros((len(nodes), 3)) if number == 3 else np.stack([nodes[:, 3], 0 * nodes[:, 3], nodes[:, 4]], axis=1)
    cosines, sines = np.cos(turns / 2), np.sin(turns / 2)
    quaternions = np.stack(  # a roll and then a yaw
        [
            cosines[:, 2] * cosines[:, 0],
            cosines[:, 2] * sines[:, 0],
            sines[:, 2] * sines[:, 0],
            sines[:, 2] * cosines[:, 0],
        ],
        axis=1,
    )
    value = gc.compiled(apart(Fraction(gap)), about=f"0,0,{float(HOME)}", engine="numpy")
    signs = set(np.sign(value(nodes[:, :3], quaternions=quaternions)).tolist())
    assert len(signs) == (1 if gap <= STEPPED_OVER[number] else 2)


@pytest.mark.parametrize("number", [3, 5])
@pytest.mark.parametrize("gap", [0, Fraction(1, 100)], ids=lambda gap: f"{float(gap):g}")
def test_sheets_without_a_certain_change_of_sign_stay_undecided(gap: Fraction, number: int) -> None:
    """They are in no free box, and boxes away from them are free."""
    found = certificate(Fraction(gap), number, 2000)
    assert (found.verdict, found.holds) == ("undecided", None)
    for sign, low, high in stretches(found):
        beside = high + float(HOME) < 0 or low + float(HOME) > gap
        assert beside if sign in "fg" else sign == "u" and low - 125 < -float(HOME) < high + 125
    assert 0 < found.shares[4] < {3: 0.1, 5: 0.4}[number]


def stretches(found: Certificate) -> Iterator[tuple[str, float, float]]:
    """The status of each box, and from where to where it goes along z."""
    waiting = [(-500.0, 500.0)]
    for sign in found.tree:
        low, high = waiting.pop()
        if not sign.isdigit():
            yield sign, low, high
        elif sign == "2":
            waiting += [((low + high) / 2, high), (low, (low + high) / 2)]
        else:
            waiting += [(low, high)] * 2
