"""Robots and configurations of them a part of the way from home."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import gcrules as gc
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.kinematics.linkage import Linkage, linkage
from gcrules.mechanisms.kinematics.solve import Solution, free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import (
    coordinates_target,
)
from gcrules.mechanisms.load import read_robot

__all__ = ["REACH", "STEPS", "analysed", "machine", "moves", "robot", "there"]

STEPS = {"x": 0.1, "y": -0.15, "z": 0.2, "roll": 0.1, "pitch": -0.15, "yaw": 0.2}
"""How far coordinates go: lengths in parts of the robot's size, rad."""

REACH = {"4-ruu": 1 / 3}
"""What part of this a robot goes whose limbs are stretched before the end."""


@cache
def machine(name: str) -> Linkage:
    return linkage(read_robot(name))


def moves(m: Linkage, part: float, more: Mapping[str, float] | None = None) -> dict[str, float]:
    found = {n: REACH.get(m.robot.id, 1) * STEPS[n] for n in free_coordinates(m)}
    for n, step in (more or {}).items():
        found[n] += step
    return {n: part * v * (m.size if n in "xyz" else 1) for n, v in found.items()}


@cache
def there(name: str, part: float) -> Solution:
    m = machine(name)
    return solve(m, coordinates_target(m, moves(m, part)))


@cache
def robot(name: str) -> gc.Robot:
    return read_robot(name)


@cache
def analysed(name: str) -> Any:
    return analyze_robot(robot(name))
