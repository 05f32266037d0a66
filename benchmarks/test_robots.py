"""Robots, from their files to the statement: 0.5 s or less warm, 0.8 s or less from a cold shell; numbers in a pose."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

import gcrules as gc
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.kinematics.solve import free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import actuators_target
from gcrules.mechanisms.load import read_robot

IDS = [one.id for one in robots()]


def analysed(name: str) -> Callable[[], str]:
    return lambda: analyze_robot(read_robot(name)).statement


def cold(name: str) -> Callable[[], str]:
    command = [sys.executable, "-m", "gcrules", "robot", "analyze", name]
    return lambda: subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("name", IDS)
def test_warm(ratio: Callable[..., Any], name: str) -> None:
    analysed(name)()
    ratio(analysed(name), {}, within=0.5, rounds=3)


@pytest.mark.parametrize("name", IDS)
def test_cold(ratio: Callable[..., Any], name: str) -> None:
    empty = [sys.executable, "-c", "pass"]
    others = {"an empty program": lambda: subprocess.run(empty, check=True)}
    ratio(cold(name), others, within=0.8, rounds=3)


def posed(name: str) -> Callable[[], Any]:
    """The joints solved for a pose anew, and all numbers there."""
    robot = read_robot(name)
    analysis = analyze_robot(robot)
    at = dict.fromkeys(free_coordinates(linkage(robot)), 0.05)
    found: Callable[..., Any] = gc.pose
    return lambda: found(analysis, at).margin


@pytest.mark.parametrize("name", IDS)
def test_pose(ratio: Callable[..., Any], name: str) -> None:
    ratio(posed(name), {}, within=0.1, rounds=5)


@pytest.mark.parametrize("name", ["orthoglide", "3-rrr", "6-rus"])
def test_along_a_slider(ratio: Callable[..., Any], name: str) -> None:
    """Twenty poses of one actuator, each proved to lie on home's branch: near the one before, and each from home."""
    m = linkage(read_robot(name))
    first, *others = leading(m)
    far = 0.15 * (1.0 if first.angle else m.size)
    asked = [actuators_target(m, [-(1 + n / 100) * far, *(0.0 for _ in others)]) for n in range(20)]

    def near() -> list[float]:
        last, found = None, []
        for wanted in asked:
            last = solve(m, wanted, last)
            found.append(float(last.configuration.platform[2, 3]))
        return found

    def from_home() -> list[float]:
        return [float(solve(m, wanted).configuration.platform[2, 3]) for wanted in asked]

    ratio(near, {"each from home": from_home}, agree=lambda a, b: a == pytest.approx(b, abs=1e-9), rounds=3)
