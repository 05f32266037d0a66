"""Lines that a robot file gives as meets of two planes, against the command's own lines."""

from __future__ import annotations

from fractions import Fraction

import pytest

import gcrules as gc
from gcrules.core.errors import GcrulesError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.lines.derived import with_derived
from gcrules.screws import RATIONALS, RESIDUES

FILE = r"""
title: lines of a robot
copies: 2
points: {a: free, b: free, c: free, d: free, e: free, f: free, g: free, h: free, S%: free}
directions: {u: free, v: free}
lines: LINES
mobility: 6
"""
LEGS = "ab, cd, ef, ag, ch, "


def read(lines: str) -> gc.Robot:
    found = gc.load(FILE.replace("LINES", lines))
    assert isinstance(found, gc.Robot)
    return found


@pytest.mark.parametrize("written", [LEGS + r"bdf /\ egh", r"[ab, 'c d', [e, f], ag, ch, 'b d f ^ e g h']"])
def test_a_meet_of_planes_is_the_line_that_the_command_knows(written: str) -> None:
    robot = read(written)
    assert robot.lines[-1] == ("p1", "p2")
    a = gc.analyze(robot)
    assert isinstance(a, RobotAnalysis)
    assert "p1 is the point of the line bd in the plane through e along eg and eh" in a.statement
    alone = gc.analyze(LEGS + r"bdf /\ egh")
    assert alone.condition is not None
    assert a.condition is not None
    assert a.condition.kind == alone.condition.kind == "two-planes-three-lines"
    swapped = str(alone.condition.expression).replace(r"bdf /\ egh", "p1p2")
    assert set(swapped) == set(str(a.condition.expression))


@pytest.mark.parametrize(
    ("planes", "ends"),
    [
        (r"abe /\ adh", ("a", "p1")),
        (r"abe /\ bea", None),
        (r"abe /\ abh", ("a", "b")),
        (r"auv /\ bcd", ("p1", "p2")),
        (r"S1S2a /\ u b v", ("p1", "p2")),
    ],
)
def test_points_of_the_line_lie_in_both_planes(planes: str, ends: tuple[str, str] | None) -> None:
    if ends is None:
        with pytest.raises(GcrulesError, match="its planes coincide"):
            read(LEGS + planes)
        return
    robot = read(LEGS + planes)
    assert robot.lines[-1] == ends
    for seed in range(3):
        member = robot.family.member(("meets", seed))
        points = robot.family.homogeneous(member) | with_derived(robot.derived, member, RESIDUES)
        rows = [points[n] for n in ends]
        assert RESIDUES.rank(rows) == 2
        for side in planes.split("/\\"):
            plane = side.split() if " " in side.strip() else [n for n in points if n in side]
            assert RESIDUES.rank([*rows, *(points[n] for n in plane)]) == 3


@pytest.mark.parametrize(
    ("planes", "said"),
    [
        (r"abe /\ ad", "'ad' does not name a plane by three points or directions"),
        (r"abe /\ adk", "k is not defined"),
        (r"abe /\ cdf /\ agh", "is not a meet of two planes"),
        (r"abe /\ uvx", "has no point"),
    ],
)
def test_faults(planes: str, said: str) -> None:
    with pytest.raises(GcrulesError) as caught:
        read(LEGS + planes)
    assert said in caught.value.render()
    assert "<input>:6:8" in caught.value.render()


def test_an_exact_member() -> None:
    """The line of the planes z = 0 and x = 1 through two of its points."""
    robot = read(LEGS + r"abc /\ dgh")
    at = {"a": (0, 0, 0), "b": (1, 1, 0), "c": (3, 0, 0), "d": (1, 0, 1), "g": (1, 1, 2), "h": (1, 0, 5)}
    rows = with_derived(robot.derived, {n: RATIONALS.vector(v) for n, v in at.items()}, RATIONALS)
    places = [[Fraction(c) / row[3] for c in row[:3]] for name, row in rows.items() if row[3]]
    assert len(places) == 2
    assert all((x, z) == (1, 0) for x, _, z in places)
