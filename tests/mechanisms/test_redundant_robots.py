"""Robots with more actuators than freedoms: what is said of them, against ranks of the joint screws at exact members.

Singular members are constructed here, by geometry: legs through one point, lines of one linear complex.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from mechanisms.shipped_robots import REDUNDANT
from places import DATA

import gcrules as gc
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.screws import RATIONALS

FILES = DATA / "redundant"
Members = Iterator[tuple[dict[str, Any], bool]]


@cache
def analysis(name: str) -> RobotAnalysis:
    found = gc.analyze("4-rpr" if name == "4-rpr" else FILES / f"{name}.yaml")
    assert isinstance(found, RobotAnalysis)
    return found


def rank(name: str, values: Mapping[str, Any]) -> int:
    r = analysis(name).robot
    return ranks(r.family, r.limbs, r.values_at(values), RATIONALS).wrenches


def some(rng: random.Random, number: int = 3) -> tuple[Fraction, ...]:
    return tuple(Fraction(rng.randint(-99, 99), rng.randint(1, 9)) for _ in range(number))


def mixed(t: Fraction, a: Any, b: Any) -> tuple[Fraction, ...]:
    return tuple((1 - t) * x + t * y for x, y in zip(a, b, strict=True))


def on_lines_through(points: tuple[Any, ...], heads: str = "AB") -> dict[str, Any]:
    """A leg from A through each of these points, one way or the other."""
    found = {}
    for k, (foot, through) in enumerate(points, 1):
        found[f"{heads[0]}{k}"] = foot
        found[f"{heads[1]}{k}"] = mixed(Fraction(k, 3), foot, through)
    return found


def planar_members(rng: random.Random) -> Members:
    """All four legs, and only three of them, through one point or parallel."""
    for _ in range(6):
        meeting, feet = (*some(rng, 2), Fraction(0)), [(*some(rng, 2), Fraction(0)) for _ in range(4)]
        aside = (*some(rng, 2), Fraction(0))
        along = (*some(rng, 2), Fraction(0))
        parallel = [tuple(a + d for a, d in zip(foot, along, strict=True)) for foot in feet]
        yield on_lines_through(tuple((foot, meeting) for foot in feet)), True
        yield on_lines_through(tuple(zip(feet, parallel, strict=True))), True
        for left_out in range(4):
            three = [aside if k == left_out else meeting for k in range(4)]
            yield on_lines_through(tuple(zip(feet, three, strict=True))), False


def spatial_members(rng: random.Random) -> Members:
    """Seven legs of one linear complex f·v + m·w, all of them or but six; its lines through A lie in a plane."""
    for _ in range(4):
        f, m = some(rng), some(rng)
        for left_out in (None, *range(7)):
            legs = []
            for k in range(7):
                foot, free = some(rng), some(rng)
                # of the complex where f · (A × B) + m · (B − A) = 0, which is linear in B
                normal = tuple(c + d for c, d in zip(RATIONALS.cross(f, foot), m, strict=True))
                off = RATIONALS.dot(normal, [b - a for a, b in zip(foot, free, strict=True)])
                size = RATIONALS.dot(normal, normal)
                end = free if k == left_out else tuple(b - off * n / size for b, n in zip(free, normal, strict=True))
                legs.append((foot, end))
            values = on_lines_through(tuple(legs))
            values |= {f"u{k}": some(rng) for k in range(1, 8)}
            yield values, left_out is None


MEMBERS = {"4-rpr": (planar_members, 3), "7-ups": (spatial_members, 6)}


@pytest.mark.parametrize("name", MEMBERS)
def test_singular_exactly_where_it_is_said(name: str) -> None:
    made, full = MEMBERS[name]
    seen = {True: 0, False: 0}
    for values, singular in made(random.Random(name)):
        assert (rank(name, values) < full) == singular
        seen[singular] += 1
    assert min(seen.values()) >= 4


@pytest.mark.parametrize(
    ("name", "words"),
    [
        (
            "4-rpr",
            "A4B4 all meet in one point or are all parallel, which takes two conditions at once: it has 4",
        ),
        (
            "7-ups",
            "A7B7 all belong to one linear complex, which takes two conditions at once: it has 7",
        ),
        (
            "3-rps-two-drives",
            "all wrenches of its limbs belong to one linear complex, which takes two conditions",
        ),
        ("3-upu-ups", "constraints are lost, and only the actuators hold the platform."),
    ],
)
def test_statements(name: str, words: str) -> None:
    a = analysis(name)
    assert words in a.statement
    assert (a.structure.redundant, a.robot.redundant) == (1, 1)
    assert a.common is not None
    assert a.common.degree == 0
    assert a.common.independent == a.common.subsets == a.common.lines
    assert all(one.statement for one in a.common.listed)
    assert a.to_json()["redundant_actuators"] == 1
    assert "no single condition makes the robot singular" in " ".join(a.text().split())


def test_lost_constraints_are_held_by_the_actuators() -> None:
    """Three couples in one plane, four forces: rank six by the joint screws, and the constraints are two."""
    a = analysis("3-upu-ups")
    (held,) = [p for p in a.parts if p.kind == "held"]
    assert held.types == ("IIM",)
    r = a.robot
    home: dict[str, Any] = dict(r.home or {})
    # leg i bears the couple u_i × (u_i × d_i), in one plane with u_i and its direction d_i
    for k in (1, 2, 3):
        x, y, z = home[f"A{k}"]
        home |= {f"u{k}": (1, 0, k), f"B{k}": (x + k * k, y, z + 5)}
    home["B4"] = (1, 2, 4)
    values = r.values_at({n: v for n, v in home.items() if not n.startswith("v")})
    here = ranks(r.family, r.limbs, values, RATIONALS)
    usual = ranks(r.family, r.limbs, r.values_at(), RATIONALS)
    assert (usual.constraints, usual.wrenches, here.constraints, here.wrenches) == (3, 6, 2, 6)


def singular_pose() -> gc.Robot:
    """A 4-RPR robot whose legs all meet in (5, 4) when the platform is moved by x = 1: B4 and B3 were chosen so."""
    text = {f"A{k}": foot for k, foot in enumerate([(0, 0), (10, 0), (10, 8), (0, 8)], 1)}
    parts = (Fraction(4, 5), Fraction(3, 5), Fraction(3, 4), Fraction(2, 5))
    ends = {f"B{k}": mixed(t, text[f"A{k}"], (5, 4)) for k, t in enumerate(parts, 1)}
    home = {**text, **{n: (x - 1, y) for n, (x, y) in ends.items()}}
    lines = "\n".join(f"  {n}: [{x}, {y}]" for n, (x, y) in home.items())
    found = gc.load(f"""
title: four legs that meet
space: plane
copies: 4
points: {{A%: free, B%: free}}
limbs: [{{name: leg %, joints: "R(A%, z) P*(A% B%) R(B%, z)"}}]
platform: B%
mobility: 3
home:
{lines}
""")
    assert isinstance(found, gc.Robot)
    return found


def test_poses_paths_and_maps_about_a_singular_pose() -> None:
    robot = singular_pose()
    there = gc.pose(robot, "x=1, y=0, yaw=0deg", nearest=False)
    assert there.verdict == "singular"
    assert [t.symbol for t in there.types] == ["RO", "II"]
    assert "nothing is singular is proved up to" in there.mode
    r = gc.path(robot, ["home", "x=2, y=0, yaw=0deg"], samples=50)
    assert isinstance(r, RobotPath)
    assert r.verdict == "singular"
    assert not r.crossings
    assert any(a <= 0.5 <= b for a, b in r.undecided)
    assert sum(b - a for a, b in r.undecided) < 0.05
    aside = gc.path(robot, ["home", "x=2, y=0.5, yaw=0deg"], samples=50)
    assert aside.undecided == ()
    assert "No configuration of the path is singular, proved." in aside.reason
    assert "no determinant changes its sign" in aside.text()
    found = gc.singular_map(robot, ["x 0.1:2:20", "y -0.95:1:20"])
    cells = found.summary.cells
    free, crossed, undecided = cells
    assert (free > 100, crossed, undecided > 0) == (True, 0, True)


def test_a_singular_home_is_not_driven() -> None:
    there = singular_pose()
    at = {n: tuple(c + (i == 0) * (n[0] == "B") for i, c in enumerate(v)) for n, v in (there.home or {}).items()}
    robot = replace(there, home=at)
    assert gc.pose(robot, nearest=False).verdict == "singular"
    with pytest.raises(gc.InputError, match="singular at home: its actuators do not determine the pose"):
        gc.pose(robot, actuators={"q1": 0.1})


def test_what_cannot_be_had_is_said() -> None:
    for ask, words in (
        (lambda: gc.pose("4-rpr", actuators={"q4": 0.1}), "q4 follows from the other actuators"),
        (lambda: gc.pose("4-rpr", actuators="q1=0.1, q4=0.1"), "q4 follows from the other actuators"),
        (lambda: gc.locus("4-rpr"), "two conditions at once, not one polynomial"),
        (lambda: gc.singular_map("4-rpr", ["x -1:1:5", "y -1:1:5"], measure="speed"), "none moves alone"),
    ):
        with pytest.raises(gc.InputError, match=words):
            ask()
    text = gc.pose("4-rpr").text()
    assert "not sought: with more actuators than freedoms" in " ".join(text.split())
    assert "proved: on this branch no configuration is singular" in " ".join(text.split())


def test_as_many_actuators_as_freedoms_are_driven() -> None:
    """The fourth leg has the length that its ends are apart, in a pose and in the nodes of a map."""
    there = gc.pose("4-rpr", actuators={"q1": 0.1, "q2": 0.2, "q3": -0.05}, nearest=False)
    for k in range(1, 5):
        home = [(analysis("4-rpr").robot.home or {})[f"{letter}{k}"] for letter in "AB"]
        before, after = (
            np.linalg.norm(np.subtract(*(np.array(p, dtype=float) for p in ends)))
            for ends in (home, (there.points[f"A{k}"], there.points[f"B{k}"]))
        )
        assert after - before == pytest.approx(there.actuator_values[f"q{k}"], abs=1e-9)
    assert [there.actuator_values[f"q{k}"] for k in (1, 2, 3)] == pytest.approx([0.1, 0.2, -0.05])
    found = gc.singular_map("4-rpr", ["q1 -0.3:0.3:5", "q2 -0.3:0.3:5"], "q3=-0.05")
    assert found.summary.cells == (16, 0, 0)


def test_numbers_of_many_poses() -> None:
    condition = gc.compiled("4-rpr")
    rng = random.Random(3)
    poses = [[rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.5, 0.5)] for _ in range(20)]
    found = condition.numbers(poses, "margins, isotropy, actuators")
    for k in (0, 7, 19):
        one = gc.pose("4-rpr", dict(zip(condition.coordinates, poses[k], strict=True)), nearest=False)
        assert found["margins"][k] == pytest.approx(one.margin, rel=1e-9)
        assert found["isotropy"][k] == pytest.approx(one.jacobian.amplification.isotropy, rel=1e-9)
        assert len(found["actuators"][k]) == 4


def test_isotropy_is_that_of_the_rates() -> None:
    """The rates of four legs for unit motions of the platform: a matrix of four rows and three columns."""
    j = gc.pose("4-rpr", nearest=False).jacobian
    rows = j.rows[:4, [0, 1, 5]] / [1, 1, j.length]
    assert j.amplification.condition_number == pytest.approx(np.linalg.cond(rows))


def test_a_common_factor_is_the_one_condition_that_suffices() -> None:
    """The axes u1, u2, u3 and u1 + u2 lie in one plane where the first three do."""
    a = analysis("4-crr")
    assert (
        "One condition suffices for that: the directions u1, u2 and u3 are parallel to one plane; otherwise"
        in a.statement
    )
    assert a.common is not None
    assert a.common.degree > 0
    r = a.robot
    for seed in range(4):
        values = r.family.member(seed, RATIONALS)
        assert ranks(r.family, r.limbs, values, RATIONALS).wrenches == 6
        rng = random.Random(seed)
        flat: dict[str, Any] = {n: (*some(rng, 2), Fraction(0)) for n in ("u1", "u2", "u3")}
        flat["u4"] = tuple(x + y for x, y in zip(flat["u1"], flat["u2"], strict=True))
        assert ranks(r.family, r.limbs, {**values, **flat}, RATIONALS).wrenches == 5


def test_a_limb_that_holds_the_platform_alone() -> None:
    robot = gc.load("""
title: a limb driven in all its joints, and a strut
points: {O: free, A: free, C: free, D: free}
directions: {u: free, v: "perpendicular to u, O A"}
limbs:
  - {name: arm, joints: "U*(O, u, v) P*(O A)"}
  - {name: strut, joints: "S(C) P*(C D) S(D)"}
platform: A D
mobility: 3
""")
    assert "robot is never singular: arm alone holds the platform." in gc.analyze(robot).statement


def test_the_shipped_ones_are_known() -> None:
    assert tuple(one.id for one in robots() if read_robot(one.id).redundant) == REDUNDANT


def test_every_pair_of_subsets_is_listed() -> None:
    common = analysis("4-rpr").common
    assert common is not None
    lines = [tuple(one.lines) for one in common.listed]
    assert len(set(lines)) == 4
    assert all(len(set(a) & set(b)) == 2 for a, b in combinations(lines, 2))
