"""Small maps of the platforms of examples/."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.moving_platform import MovingPlatform, rig
from gcrules.poses.maps.grid import Grid
from gcrules.poses.numbers.cubic import superbracket_at

__all__ = ["HUNT", "TURNING", "exact_value", "ranges", "rig_of"]

F = Fraction


def rig_of(a: Analysis) -> MovingPlatform:
    assert a.platform is not None
    return rig(a.structure, a.platform)


def exact_value(g: Grid, coordinates: Any) -> Fraction:
    try:
        return superbracket_at(g.rig.structure.legs, g.rig.exact(g.pose([F(c) for c in coordinates])))
    except InputError:  # a leg of no length
        return F(0)


def ranges(a: Analysis, names: str, number: int, size: float = 1.2) -> list[str]:
    far = F(str(round(rig_of(a).size * size, 2)))
    return [f"{n} {-far}:{far}:{number + k}" for k, n in enumerate(names.split())]


TURNING = [
    ("octahedral", ["rx -60:60:21 deg", "rz -120:120:23 deg"], "0 0 -100"),
    ("octahedral", ["x -300:300:15", "zyx1 -100:100:17 deg"], None),
    ("platform-6-6", ["azimuth -180:180:19 deg", "tilt 1:60:17 deg"], "0.1 0 -0.2"),
    ("platform-6-4", ["XYZ2 -1:1:17 rad", "z -1/2:1/2:11"], "0 0 0; euler XYZ 0.1 0 0.2 rad"),
]


HUNT = """
title: symmetric octahedral platform
units: m
legs: [ab, af, cb, cd, ed, ef]
points:
  a: [1, 0, 0]
  c: [-0.5, 0.8660254037844386, 0]
  e: [-0.5, -0.8660254037844386, 0]
  b: [0.25, 0.4330127018922193, 1]
  d: [-0.5, 0, 1]
  f: [0.25, -0.4330127018922193, 1]
"""
