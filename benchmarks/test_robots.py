"""Robots, from their files to the statement: 0.5 s or less warm, 2 s or less from a cold shell; numbers in a pose."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

import gcrules as gc
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.kinematics.mechanism import mechanism
from gcrules.mechanisms.kinematics.solve import free_coordinates

IDS = [one.id for one in robots()]


def analysed(name: str) -> Callable[[], str]:
    return lambda: gc.Robot.load(name).analyze().statement


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
    ratio(cold(name), others, within=2, rounds=3)


def posed(name: str) -> Callable[[], float]:
    """The joints solved for a pose anew, and all numbers there."""
    robot = gc.Robot.load(name)
    robot.pose()  # the analysis, once
    at = dict.fromkeys(free_coordinates(mechanism(robot)), 0.05)
    return lambda: robot.pose(at).closeness


@pytest.mark.parametrize("name", IDS)
def test_pose(ratio: Callable[..., Any], name: str) -> None:
    ratio(posed(name), {}, within=0.1, rounds=5)
