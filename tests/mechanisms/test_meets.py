"""Limbs whose forces go through no two of the file's points: directions and points that are made for them.

The second road is that of the joint screws: exact members of a family, ranks of all wrenches that are reciprocal to the
passive twists, and their determinant.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.factor_causes import ASIDE, at_member
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.lines.derived import Derived, in_words, needed, with_derived
from gcrules.mechanisms.lines.home import _pure
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.lines.wrenches import PLANAR
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.robot import Robot
from gcrules.poses.limbs.exact_values import lines_at, value_at
from gcrules.poses.limbs.factors import factor_values
from gcrules.screws import FLOATS, RATIONALS, product
from gcrules.screws.field import Row
from gcrules.screws.screw import join_of

DATA = Path(__file__).parents[1] / "data"

ROBOTS = {
    "meets/3-rrrrr": ("n1", "(u1 × B1C1) × (v1 × D1E1)", "the directions n1, n2 and n3 are parallel to one plane"),
    "meets/3-crr": ("n1", "u1 × (u1 × B1C1)", "the directions n1, n2 and n3 are parallel to one plane"),
    "meets/3-upu-skew": ("n1", "(u1 × v1) × (s1 × t1)", "belong to one linear complex"),
    "meets/4-ups-sp": ("n5", "OC × x", "the two ratios agree"),
    "meets/3-rhrpa": ("n1", "(C1D1 × e1) × (u1 × C1B1 − u1)", "the directions n1, n2 and n3 are parallel to one plane"),
    "meets/c-2ups-flat": ("n1", "w × x", "is singular exactly when (n1n1' ∧ A1S1)(wO ∧ A2S2) − "),
    "meets/c1s-flat": ("n1", "u1 × x", "leg 3 (n3n3'S3) and the platform plane S1S2S3 meet in a point"),
    "5-rpur": ("n1", "(z × A1B1) × (e × B1C1)", "belong to one linear complex"),
}


@cache
def analysis(name: str) -> RobotAnalysis:
    return analyze_robot(read_robot(DATA / f"{name}.yaml" if "/" in name else name))


@pytest.mark.parametrize("name", ROBOTS)
def test_a_condition_is_found(name: str) -> None:
    a = analysis(name)
    direction, made_of, words = ROBOTS[name]
    assert dict(a.structure.named)[direction] == f"the direction {made_of}"
    assert words in a.statement
    assert any(p.kind in ("actuation", "constraint", "mixed") and p.members for p in a.parts)
    assert a.text()
    assert a.latex()
    assert a.to_json()["statement"] == a.statement


@pytest.mark.parametrize("name", ROBOTS)
def test_lines_are_wrenches_of_their_limbs(name: str) -> None:
    """At rational members no line that a limb is said to apply has power on its passive twists."""
    a = analysis(name)
    robot = a.robot
    for seed in range(3):
        values = robot.family.member(("meets", seed), RATIONALS)
        points = lines_at(robot.family, a.structure, values)
        for limb, own in zip(robot.limbs, a.structure.limbs, strict=True):
            there = limb.at(values, RATIONALS)
            passive = [t for k, t in enumerate(there.twists(RATIONALS)) if k not in there.actuated]
            rows = [join_of(RATIONALS, *(points[n] for n in line.ends)) for line in own.lines or ()]
            assert all(product(row, t, RATIONALS) == 0 for row in rows for t in passive)
            assert RATIONALS.rank(rows) == own.dimension == 6 - RATIONALS.rank(passive)


@pytest.mark.parametrize("name", ROBOTS)
def test_numbers_have_the_sign_of_exact_values(name: str) -> None:
    a = analysis(name)
    family = a.robot.family
    members = [family.member(("meets", seed), RATIONALS) for seed in range(8)]
    stacked = {n: np.array([[float(c) for c in m[n]] for m in members]) for n in members[0]}
    found = factor_values(a, stacked)
    for k, part in enumerate(a.parts):
        if str(part.over) != "1":
            continue
        exact = [value_at(family, a.structure, m, part.expression) for m in members]
        assert [np.sign(v) for v in found[:, k]] == [(v > 0) - (v < 0) for v in exact]


def least(a: RobotAnalysis, values: dict[str, np.ndarray]) -> float:
    """The least singular value of all wrenches, as unit rows, from the joint screws alone."""
    rows = []
    for limb in a.robot.limbs:
        there = limb.at(values, FLOATS)
        twists = np.array([t for k, t in enumerate(there.twists(FLOATS)) if k not in there.actuated], dtype=float)
        _, sizes, right = np.linalg.svd(twists / np.linalg.norm(twists, axis=1)[:, None])
        rows.append(np.roll(right[int((sizes > 1e-9).sum()) :], 3, axis=1))
    return float(np.linalg.svd(np.concatenate(rows), compute_uv=False)[5])


@pytest.mark.parametrize("name", ROBOTS)
def test_wrenches_lose_rank_where_the_condition_changes_its_sign(name: str) -> None:
    """Along lines of members, and nowhere else: each zero of a factor that counts is narrowed down."""
    a = analysis(name)
    family = a.robot.family
    live = [k for k, p in enumerate(a.parts) if p.kind in ("actuation", "constraint", "mixed")]

    def member(t: float, ends: list[dict[str, tuple[Fraction, ...]]]) -> dict[str, np.ndarray]:
        first, last = ends
        between = {n: tuple(float(p) + t * float(q - p) for p, q in zip(first[n], last[n], strict=True)) for n in first}
        return {n: np.array(v, dtype=float) for n, v in family.at(between, FLOATS).items()}

    zeros = 0
    for seed in range(4):
        ends = [family.parameters(("line", seed, k), RATIONALS) for k in (0, 1)]

        def value(t: float, ends: list[dict[str, tuple[Fraction, ...]]] = ends) -> np.ndarray:
            return factor_values(a, {n: v[None] for n, v in member(t, ends).items()})[0, live]

        grid = np.linspace(0, 1, 40)
        found = np.array([value(t) for t in grid])
        for k in range(len(live)):
            for n in np.flatnonzero(found[:-1, k] * found[1:, k] < 0):
                low, high = grid[n], grid[n + 1]
                for _ in range(36):
                    middle = (low + high) / 2
                    low, high = (middle, high) if value(middle)[k] * found[n, k] > 0 else (low, middle)
                if abs(value(low)[k]) < 1e-9:  # no pole of a quotient
                    singular = least(a, member(low, ends)) < 1e-7
                    zeros += singular
                    assert singular or a.parts[live[k]].chosen  # else the statement says so
        low_places = [t for t, v in zip(grid, found, strict=True) if np.abs(v).min() > 1e-3]
        assert all(least(a, member(t, ends)) > 1e-9 for t in low_places)
    assert zeros > 1


# --- what is made ----------------------------------------------------------------------------------------------------


def term(text: str) -> tuple[tuple[Fraction, str], ...]:
    return ((Fraction(1), text),)


def test_a_point_at_infinity() -> None:
    """A line that is parallel to the plane meets it in its own direction."""
    place = Derived("p", (term("A"), term("w"), term("B"), term("n")))
    rows = with_derived([place], {"A": (1, 2, 3), "w": (1, 1, 0), "B": (0, 0, 0), "n": (0, 0, 1)}, RATIONALS)
    x, y, z, w = rows["p"]
    assert (w, z) == (0, 0)
    assert x == y != 0


def test_many_members_at_once() -> None:
    rng = np.random.default_rng(3)
    values = {n: rng.normal(size=(5, 3)) for n in ("A", "w", "B", "u", "v")}
    made = (Derived("n", (term("u"), term("v"))), Derived("p", (term("A"), term("w"), term("B"), term("n"))))
    rows = with_derived(made, {n: FLOATS.vector(v) for n, v in values.items()}, FLOATS)
    point = np.stack(rows["p"][:3], axis=1) / np.asarray(rows["p"][3])[:, None]
    normal = np.cross(values["u"], values["v"])
    assert np.abs(np.einsum("ij,ij->i", point - values["B"], normal)).max() < 1e-9
    assert np.abs(np.cross(point - values["A"], values["w"])).max() < 1e-9


def test_words() -> None:
    pair = ((Fraction(1), "B"), (Fraction(-1), "A"))
    made = (
        Derived("m", (term("u"), pair)),
        Derived("n", ((*term("m"), (Fraction(-1, 2), "u")), term("e"))),
        Derived("p", (term("A"), pair, term("C"), term("m"))),
    )
    assert in_words(made, "n") == "the direction (u × AB − 1/2 u) × e"
    assert in_words(made, "p") == "the point of the line AB in the plane through C along u and AB"
    assert [d.name for d in needed(made, {"p"})] == ["m", "p"]
    assert made[1].renamed({"m": "k", "n": "l"}).names == ("k", "u", "e")


def test_where_no_line_can_be_named() -> None:
    """The transversals of four axes in general position need a square root."""
    a = analysis("moved/3-5r")
    assert a.structure.lines is None
    assert "give it as `through`" in a.statement
    assert len({limb.kind for limb in a.structure.limbs}) == 1


def test_a_screw_is_given_as_the_force_that_it_is_modulo_a_couple() -> None:
    screw, couple = (1, 0, 0, 5, 1, 2), (0, 0, 0, 1, 1, 0)
    row = _pure(tuple(map(Fraction, screw)), [tuple(map(Fraction, couple))])
    assert RATIONALS.dot(row[:3], row[3:]) == 0
    assert RATIONALS.rank([row, screw, couple]) == 2
    assert _pure(row, [(0, 0, 0, 0, 1, 0)]) == row


def flat(name: str, **changed: tuple[Fraction, Fraction, Fraction]) -> Robot:
    robot = read_robot(DATA / f"meets/{name}.yaml")
    assert robot.home is not None
    return replace(robot, home={**robot.home, **changed})


AXES_OF_HOME = {
    "as in the file": ({}, {"w × x", "w × z"}),
    "along x": ({"w": (Fraction(1), Fraction(0), Fraction(0))}, {"w × y", "w × z"}),
    "along z": ({"w": (Fraction(0), Fraction(0), Fraction(3))}, {"w × x", "w × y"}),
}


@pytest.mark.parametrize("home", AXES_OF_HOME)
def test_lines_are_chosen_that_do_not_depend_on_each_other_at_home(home: str) -> None:
    changed, expected = AXES_OF_HOME[home]
    a = analyze_robot(flat("c-2ups-flat", **changed))
    assert {what.removeprefix("the direction ") for _, what in a.structure.named} == expected
    rows = at_home(a)
    assert RATIONALS.rank(rows) == 6


@pytest.mark.parametrize("name", ["c-2ups-flat", "c1s-flat"])
def test_where_chosen_lines_depend_on_each_other_is_told(name: str) -> None:
    """A member at which the factor is 0, and the wrenches have full rank by the joint screws."""
    a = analyze_robot(flat(name))
    live = [p for p in a.parts if p.kind not in ASIDE]
    assert a.statement.startswith(
        "Where the lines that were chosen for a limb do not depend on each other, the robot is"
    )
    assert all(p.chosen for p in live)
    for made in ("n1 is the direction", "n1' is the direction"):
        assert made in a.statement
    values = dict(a.robot.family.member("flat", RATIONALS))
    values[{"c-2ups-flat": "w", "c1s-flat": "u1"}[name]] = (Fraction(2), Fraction(0), Fraction(3))
    at = at_member(a.robot.family, a.structure, values, RATIONALS)
    assert [at.value(p.expression)[0] for p in live] == [0]
    assert ranks(a.robot.family, a.robot.limbs, values, RATIONALS).wrenches == 6


@pytest.mark.parametrize("name", [one.id for one in robots(())])
def test_lines_of_shipped_robots_are_as_independent_as_their_wrenches_at_home(name: str) -> None:
    """The second road: the rank of the wrenches by the joint screws."""
    a = analyze_robot(read_robot(name))
    if a.structure.lines is None or a.robot.home is None or not a.robot.limbs:
        pytest.skip("no lines, or no home")
    plane = PLANAR if a.robot.family.plane else ()
    every = [row for limb in a.robot.limbs_at() for row in limb.locked(RATIONALS)]
    assert RATIONALS.rank([*plane, *at_home(a)]) == RATIONALS.rank([*plane, *every])


def at_home(a: RobotAnalysis) -> list[Row]:
    points = a.structure.points(a.robot.family, a.robot.values_at(), RATIONALS)
    return [join_of(RATIONALS, *(points[n] for n in line.ends)) for line in a.structure.lines or ()]
