"""The six types of singularity: by exact ranks, in floats, and by their definitions on the rates of all joints."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from mechanisms.bodies import equations
from mechanisms.shipped_robots import analysis

import gcrules as gc
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.lines.ranks import TYPES, types_of
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.limbs.singular_members import live_parts, singular_pose
from gcrules.screws import FLOATS

IDS = [one.id for one in robots()]


def symbols(r: RobotPose) -> tuple[str, ...]:
    return tuple(t.symbol for t in r.types)


def rates(robot: gc.Robot) -> tuple[np.ndarray, np.ndarray, list[int]]:
    """Independent motions of all bodies at home: the rates of the joints and the twist of the platform in each, and the
    places of the actuators; from the joint screws alone.
    """
    values = {n: tuple(map(float, v)) for n, v in home_values(robot).items()}
    rows, driven, passive = equations(robot, values, FLOATS)
    _, sizes, right = np.linalg.svd(np.array(rows, dtype=float))
    basis = right[int((sizes > 1e-9 * sizes[0]).sum()) :]
    order = sorted([*driven, *passive])
    return basis[:, order], basis[:, :6], [order.index(c) for c in driven]


def by_definition(robot: gc.Robot, idle: int) -> tuple[str, ...]:
    """The types at home, each by its own definition."""
    basis, platform, driven = rates(robot)

    def still(*blocks: np.ndarray) -> np.ndarray:
        """The rates for which all these vanish."""
        rows = np.concatenate(blocks, axis=1).T
        _, sizes, right = np.linalg.svd(rows)
        return np.asarray(right[int((sizes > 1e-9).sum()) :] @ basis)

    def rank(rows: np.ndarray) -> int:
        return int(np.linalg.matrix_rank(rows, 1e-9)) if rows.size else 0

    inputs = basis[:, driven]
    seen = {
        "RO": rank(still(inputs)) > rank(still(inputs, platform)),
        "II": rank(inputs) < len(driven),
        "RI": rank(still(platform)[:, driven]) > 0,
        "IO": rank(platform) < robot.mobility,
        "RPM": rank(still(inputs, platform)) > idle,
        "IIM": len(basis) > robot.mobility + idle,
    }
    return tuple(name for name in TYPES if seen[name])


@pytest.mark.parametrize("name", IDS)
def test_types_are_those_of_exact_ranks(name: str) -> None:
    """At exact singular members, in floats and by the definitions; the factor has these types in the whole family."""
    a = analysis(name)
    for part in live_parts(a):
        pose = singular_pose(a, part)
        if pose is None:
            continue
        moved = replace(a.robot, home={d.name: pose.values[d.name] for d in a.robot.family.definitions})
        exact = types_of(pose.ranks, pose.before)
        assert set(part.types) <= set(exact)
        here = gc.pose(replace(a, robot=moved), nearest=False)
        assert isinstance(here, RobotPose)
        assert (here.verdict, symbols(here)) == ("singular", exact)
        assert by_definition(moved, a.structure.idle) == exact


LIMBS = """
title: planar robot with two bars in each leg
space: plane
points: {A1: free, B1: free, C1: free, A2: free, B2: free, C2: free, A3: free, B3: free, C3: free}
limbs:
  - {name: one, joints: "R*(A1, z) R(B1, z) R(C1, z)"}
  - {name: two, joints: "R*(A2, z) R(B2, z) R(C2, z)"}
  - {name: three, joints: "R*(A3, z) R(B3, z) R(C3, z)"}
platform: C1 C2 C3
mobility: 3
"""

HOME = {
    "A1": (0, 0), "B1": (0, 2), "C1": (2, 3), "A2": (10, 0), "B2": (9, 2), "C2": (6, 3), "A3": (4, 9), "B3": (6, 8),
    "C3": (5, 5),
}  # fmt: skip


def in_pose(**points: tuple[float, float]) -> gc.Robot:
    robot = parse_robot(LIMBS)
    places: dict[str, Any] = {**HOME, **points}
    return replace(robot, home={n: (Fraction(x), Fraction(y), Fraction(0)) for n, (x, y) in places.items()})


KNOWN = {
    "regular": ({}, ()),
    "a stretched leg": ({"B1": (1, Fraction(3, 2))}, ("RI", "IO")),
    "a leg whose passive joints meet": ({"B1": (2, 3)}, ("II", "IO", "RPM")),
    "bars in one point": ({"B1": (0, 3), "B2": (9, 3), "C3": (5, 3), "B3": (5, 8)}, ("RO", "II")),
    "stretched, and bars in one point": (
        {"A1": (-2, 3), "B1": (0, 3), "B2": (9, 3), "C3": (5, 3), "B3": (5, 8)},
        ("RO", "II", "RI", "IO"),
    ),
}


@pytest.mark.parametrize(("points", "types"), KNOWN.values(), ids=KNOWN)
def test_known_types(points: dict[str, tuple[float, float]], types: tuple[str, ...]) -> None:
    robot = in_pose(**points)
    here = gc.pose(robot, nearest=False)
    assert isinstance(here, RobotPose)
    assert symbols(here) == by_definition(robot, 0)
    assert symbols(here) == types
    shown = {t["type"]: t for t in here.to_json()["types"]}
    assert tuple(shown) == types


def test_relations_hold_for_all_rates() -> None:
    """What is said of the actuators' rates, at each singular configuration of the table."""
    for points, types in KNOWN.values():
        if "II" not in types:
            continue
        robot = in_pose(**points)
        here = gc.pose(robot, nearest=False)
        assert isinstance(here, RobotPose)
        relations = next(t.relations for t in here.types if t.symbol == "II")
        basis, _, driven = rates(robot)
        inputs = basis[:, driven]
        assert len(relations) == len(driven) - np.linalg.matrix_rank(inputs, 1e-9)
        rows = np.array([[r.get(f"q{k + 1}", 0.0) for k in range(len(driven))] for r in relations])
        assert np.abs(inputs @ rows.T).max() < 1e-9


def test_what_shows_a_type() -> None:
    here = gc.pose(in_pose(B1=(1, Fraction(3, 2))), nearest=False)
    text = here.text()
    assert "RI  redundant input: q1 can move with the platform at rest" in text
    assert "\n  IO  impossible output: the rates of the platform have to satisfy " in text
    here = gc.pose(in_pose(B1=(2, 3)), nearest=False)
    assert "II  impossible input: the rates of the actuators have to satisfy " in here.text()
    assert "RPM redundant passive motion: passive joints of one can move with all else at rest" in here.text()
    assert "types & II, IO and RPM" in here.latex()


def test_limbs_by_themselves() -> None:
    """A stretched leg lets its actuator move with the platform at rest; so do all sentences of its kind."""
    a = gc.analyze(in_pose())
    (condition,) = a.limbs[0].conditions
    assert (condition.statement, condition.types) == ("the points A1, B1 and C1 are on a line", ("RI",))
    assert "A1, B1 and C1 are on a line (RI)" in a.text()
