"""Robots: files and their faults, wrenches as lines, and the independent road by the joint screws for each robot."""

from __future__ import annotations

import contextlib
import json
import os
import random
import re
import subprocess
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st
from places import DATA

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Bracket, Expr, Point, points_of
from gcrules.algebra.language.syntax import Context, parse
from gcrules.apps.cli import cli
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.analyze_robot import _statement
from gcrules.mechanisms.conditions.checks import notes
from gcrules.mechanisms.conditions.factor_causes import ranks
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.conditions.words import Words
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.family import Path as MemberPath
from gcrules.mechanisms.description.limb_file import read_joints
from gcrules.mechanisms.description.relations import RELATIONS, Values, relation
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.description.skeleton import skeleton
from gcrules.mechanisms.lines.singular import interpolated, roots
from gcrules.mechanisms.load import read_robot
from gcrules.rules.plugins import shipped_folder
from gcrules.screws import JOINTS, RATIONALS, RESIDUES

IDS = tuple(one.id for one in robots())
FILES = DATA / "robots"
OTHERS = {  # robots from the literature's families, and what is said of them
    "2-prr-ppr": "the lines A1B1, A2B2 and n3C meet in a point or are parallel",
    "2-ups-u": "the planes A1B1O, A2B2O and uvO, which pass through O, have a common line",
    "3-cru": "the lines B1C1, B2C2 and B3C3 are parallel to one plane (actuation singularity)",
    "3-prrr": "the directions u1, u2 and u3 are parallel to one plane",
    "3-psp": "the planes of leg 1 (n1n1'S1), leg 2 (n2n2'S2) and leg 3 (n3n3'S3) and the plane S1S2S3 meet in a point",
    "3-rrr-space": "the planes B1C1z, B2C2z and B3C3z, which are parallel to the direction z, have a common line",
    "3-rrs": "the planes of leg 1 (r1B1S1), leg 2 (r2B2S2) and leg 3 (r3B3S3) and the platform plane S1S2S3 meet",
    "3-ruu": "the moments u1 × v1, u2 × v2 and u3 × v3 of the couples are parallel to one plane (constraint",
    "3-upu-wrist": "the planes A1B1O, A2B2O and A3B3O, which pass through O, have a common line (constraint",
    "4-upu": "Without the wrenches along A3B3 and A4B4 the platform can turn",
    "4-upu-pairs": "Without the wrenches along A3B3 and A4B4 the platform can turn",
    "5-ups-prpu": "the lines A1B1, A2B2, A3B3, A4B4, A5B5 and rs belong to one linear complex",
    "6-pss": "the lines A1B1, A2B2, A3B3, A4B4, A5B5 and A6B6 belong to one linear complex",
}
ROAD = (*IDS, *OTHERS)
MEMBERS = 200
Row = tuple[Any, ...]


@cache
def robot(name: str) -> gc.Robot:
    return read_robot(FILES / f"{name}.yaml" if name in OTHERS else name)


@cache
def analysis(name: str) -> RobotAnalysis:
    return analyze_robot(robot(name))


# --- what is found for each robot ------------------------------------------------------------------------------------

FOUND: dict[str, tuple[int, int, str, tuple[str, ...]]] = {
    # mobility, constraints that are there twice, lines, kinds of the factors
    "gough-stewart": (6, 0, "A1B1 A2B2 A3B3 A4B4 A5B5 A6B6", ("actuation",)),
    "gough-stewart-63": (6, 0, "A1B1 A2B1 A3B2 A4B2 A5B3 A6B3", ("actuation",)),
    "octahedral": (6, 0, "A1B1 A1B3 A2B1 A2B2 A3B2 A3B3", ("actuation",)),
    "gallardo-4dof": (4, 0, "A1S1 B1S1 C1S1 A2S2 A3S3 B3S3", ("actuation", "actuation", "never")),
    "3-rps": (3, 0, "A1S1 S1r1 A2S2 S2r2 A3S3 S3r3", ("actuation",)),
    "3-prs": (3, 0, "B1S1 S1r1 B2S2 S2r2 B3S3 S3r3", ("actuation",)),
    "3-pprs": (6, 0, "A1S1 S1r1 A2S2 S2r2 A3S3 S3r3", ("actuation",)),
    "3-prps": (6, 0, "A1S1 S1r1 A2S2 S2r2 A3S3 S3r3", ("actuation",)),
    "6-rus": (6, 0, "B1C1 B2C2 B3C3 B4C4 B5C5 B6C6", ("actuation",)),
    "6-pus": (6, 0, "B1C1 B2C2 B3C3 B4C4 B5C5 B6C6", ("actuation",)),
    "3-upu": (3, 0, "A1B1 u1v1 A2B2 u2v2 A3B3 u3v3", ("actuation", "constraint")),
    "3-ups-s": (3, 0, "Ox Oy Oz A1B1 A2B2 A3B3", ("actuation", "never")),
    "delta": (3, 0, "A1d1 d1r1 A2d2 d2r2 A3d3 d3r3", ("actuation", "constraint")),
    "3-rpr": (3, 0, "A1B1 A2B2 A3B3", ("actuation",)),
    "3-rrr": (3, 0, "B1C1 B2C2 B3C3", ("actuation",)),
    "3-puu": (3, 0, "A1B1 u1v1 A2B2 u2v2 A3B3 u3v3", ("actuation", "constraint")),
    "4-ruu": (4, 2, "xz yz B1C1 B2C2 B3C3 B4C4", ("actuation",)),
    "3-rrr-spherical": (3, 6, "Ox Oy Oz v1w1 v2w2 v3w3", ("actuation", "never")),
    "tricept": (3, 0, "Ov On1 uv A1B1 A2B2 A3B3", ("actuation",)),
    "exechon": (3, 2, "A1B1 A1v A2B2 A2v A3B3 A3s", ("actuation",)),
    "orthoglide": (3, 3, "xy xz yz A1B1 A2B2 A3B3", ("actuation",)),
}

STATEMENTS = {
    "3-rps": "planes of leg 1 (r1A1S1), leg 2 (r2A2S2) and leg 3 (r3A3S3) and the platform plane S1S2S3 meet",
    "octahedral": "legs 1 and 2 (A1B1B3), legs 3 and 4 (A2B1B2) and legs 5 and 6 (A3B2B3) and the base plane",
    "gallardo-4dof": "the points A2, S1, S2 and S3 lie in one plane, or the point S1 lies in the plane A3B3S3 of leg 3",
    "3-upu": "the lines A1B1, A2B2 and A3B3 are parallel to one plane (actuation singularity)",
    "delta": "the directions d1, d2 and d3 are parallel to one plane (actuation singularity), or the moments d1 × r1,",
    "3-ups-s": "the planes A1B1O, A2B2O and A3B3O, which pass through O, have a common line",
    "3-rrr-spherical": "the moments v1 × w1, v2 × w2 and v3 × w3 of the couples are parallel to one plane",
    "3-rrr": "the lines B1C1, B2C2 and B3C3 meet in a point or are parallel",
    "3-puu": "the moments u1 × v1, u2 × v2 and u3 × v3 of the couples are parallel to one plane (constraint",
    "3-rpr": "the lines A1B1, A2B2 and A3B3 meet in a point or are parallel",
    "gough-stewart": "the lines A1B1, A2B2, A3B3, A4B4, A5B5 and A6B6 belong to one linear complex",
    "exechon": "the planes of leg 1 (vA1B1), leg 2 (vA2B2) and leg 3 (sA3B3) and the base plane A1A2A3 meet in a point",
    "4-ruu": "singular too where the constraints of all limbs together lose rank",
}


def test_every_robot_is_in_the_tables() -> None:
    assert set(IDS) == set(FOUND)


@pytest.mark.parametrize("name", IDS)
def test_lines_and_kinds(name: str) -> None:
    mobility, over, lines, kinds = FOUND[name]
    a = analysis(name)
    assert (a.structure.mobility, a.structure.over, a.structure.idle) == (mobility, over, 0)
    assert sorted(map(sorted, a.structure.legs)) == sorted(sorted(re.findall(r"[A-Za-z]\d?", w)) for w in lines.split())
    assert sorted(p.kind for p in a.parts) == sorted(kinds)
    assert all(p.members >= 3 for p in a.parts if p.kind != "never")
    assert not a.cofactors or name in ("4-ruu", "tricept")


@pytest.mark.parametrize(("name", "words"), (STATEMENTS | OTHERS).items(), ids=STATEMENTS | OTHERS)
def test_statements(name: str, words: str) -> None:
    assert words in analysis(name).statement


VARIANTS = {
    # a robot, what is replaced in its file, and what its special family is told
    "3-rps with parallel hinges": (
        "3-rps",
        ("r%: free", "r%: parallel to z"),
        ("the plane S1S2S3 contains the direction z (constraint singularity)", "A1S1z, A2S2z and A3S3z, which are"),
    ),
    "delta with horizontal hinges": ("delta", ("r%: free", "r%: perpendicular to z"), ("(constraint singularity)",)),
    "delta with rails": ("delta", ("R*(O%, r%)", "P*(r%)"), ("(constraint singularity)", "d1, d2 and d3 are parallel")),
    "planar base": ("3-rps", ("A%: free", "O: free\n  A%: in plane O along x, y"), ("leg 2 (r2A2S2)",)),
    "exechon, third hinge along u": ("exechon", ("s: perpendicular to v", "s: parallel to u"), ("leg 3 (uA3B3)",)),
}


def variant(name: str, old: str, new: str) -> gc.Robot:
    folder = shipped_folder()
    assert folder is not None
    text = (folder / name / "robot.yaml").read_text("utf-8").partition("\nhome:")[0]
    assert old in text
    return parse_robot(text.replace(old, new) + "\n")


@pytest.mark.parametrize(("name", "change", "words"), VARIANTS.values(), ids=VARIANTS)
def test_special_families(name: str, change: tuple[str, str], words: tuple[str, ...]) -> None:
    statement = analyze_robot(variant(name, *change)).statement
    assert [w for w in words if w not in statement] == []


def test_a_family_that_is_singular_everywhere_is_refused() -> None:
    with pytest.raises(GcrulesError, match="the actuators never hold the platform"):
        variant("gough-stewart-63", "B3: free", "B3: on line B1 B2")
    with pytest.raises(GcrulesError, match="the platform has mobility 4, not 3"):
        variant("3-upu", "u%: free", "u%: parallel to x")


LIMBS = {
    "6-rus": "the plane A1B1C1 contains the direction r1",
    "6-pus": "d1 is perpendicular to B1C1",
    "3-prps": "p1 is perpendicular to r1",
    "3-prs": "d1 is perpendicular to B1S1",
    "4-ruu": "the plane A1B1C1 contains the direction z",
    "3-rrr-spherical": "the directions u1, v1 and w1 are parallel to one plane",
    "delta": "the line O1A1 is parallel to the plane of the directions r1 and d1",
    "3-pprs": "the directions p1, q1 and r1 × A1S1 are parallel to one plane",
}


@pytest.mark.parametrize(("name", "words"), LIMBS.items(), ids=LIMBS)
def test_limbs_have_singularities_of_their_own(name: str, words: str) -> None:
    a = analysis(name)
    assert words in [s for _, s in a.limbs[0].conditions]
    assert words.replace("1", "3") in [s for _, s in a.limbs[2].conditions]
    assert not any(s.unexplained for s in a.limbs)
    assert "singularities of its limbs" in a.statement


WRIST = """
title: 3-UPU wrist, whose two factors vanish together
copies: 3
points: {O: free, A%: on line O along u%, B%: on line O along w%}
directions: {u%: free, w%: free, v%: "perpendicular to u%, A% B%"}
limbs: [{joints: "U(A%, u%, v%) P*(A% B%) U(B%, v%, w%)"}]
mobility: 3
"""


def test_factors_that_vanish_together_are_told_by_what_loses_rank() -> None:
    """Where the v are parallel to one plane the constraints, forces through O, lose rank, at exact members too."""
    r = parse_robot(WRIST)
    a = analyze_robot(r)
    assert [(p.kind, p.members >= 3) for p in a.parts] == [("constraint", True)] * 2
    assert [str(p.same) for p in a.parts] == [r"A1B1O /\ A2B2O /\ A3B3", "None"]  # said once, by the weaker condition
    assert a.statement.count("(constraint singularity)") == 1
    path = r.family.path("wrist", "w1")

    def triple(t: int) -> int:
        at = path.member(t)
        return int(RESIDUES.determinant([at["v1"], at["v2"], at["v3"]]))

    members = [path.member(t) for t in roots(interpolated(triple) or [])]
    found = [ranks(r.family, r.limbs, m) for m in members if not r.family.merged(m)]
    assert found
    assert {(one.constraints, one.wrenches) for one in found} == {(2, 5)}
    assert not r.family.merged(r.family.member(1))
    assert r.family.merged({**r.family.member(1), "A1": r.family.member(1)["O"]})


def test_a_factor_that_is_not_met_has_no_kind_in_the_statement() -> None:
    a = analysis("3-upu")
    assert a.condition is not None
    parts = [replace(p, kind=kind) for p, kind in zip(a.parts, ("not met", "constraint"), strict=True)]
    said = _statement(a.structure, a.condition, (), parts, ())
    assert "not met" not in said
    assert said.count("singularity") == 1


SCREWS = """
title: driven helical joints
copies: 6
points: {A%: free, B%: free, C%: free}
directions: {r%: free, u%: free, v%: "perpendicular to u%, B% C%"}
limbs: [{joints: "H*(A%, r%, 1/3) U(B%, u%, v%) S(C%)"}]
mobility: 6
"""


def test_singular_limbs_without_words_are_left_out_too() -> None:
    a = analyze_robot(parse_robot(SCREWS))
    assert all(s.unexplained and not s.conditions for s in a.limbs)
    assert a.statement.startswith("Outside the singularities of its limbs, the robot is singular exactly when")
    assert "none found" not in a.text()


CHAINS = {
    "planar": ("space: plane", "free", "R(C%, z)", "the points A1, B1 and C1 are on a line"),
    "hinges across the limb's plane": (
        "directions: {r%: free}",
        "in plane A% perpendicular to r%",
        "S(C%)",
        "the points A1, B1 and C1 are on a line",
    ),
    "oblique": ("directions: {r%: free}", "free", "S(C%)", "the plane A1B1C1 contains the direction r1"),
}


@pytest.mark.parametrize(("key", "relation", "last", "words"), CHAINS.values(), ids=CHAINS)
def test_chains_of_parallel_axes(key: str, relation: str, last: str, words: str) -> None:
    axis = "z" if "plane" in key else "r%"
    a = analyze_robot(
        parse_robot(f"""
title: chains of parallel axes
{key}
copies: 3
points: {{A%: free, B%: {relation}, C%: {relation}}}
limbs: [{{joints: "R*(A%, {axis}) R(B%, {axis}) {last}"}}]
mobility: 3
""")
    )
    assert words in [said for _, said in a.limbs[0].conditions]


def test_words_of_a_flat_bracket_with_a_direction() -> None:
    """[A1 B1 C1 z] where the points lie in a plane across z in every member."""
    family = parse_robot("""
title: legs across z
points: {A1: free, B1: in plane A1 perpendicular to z, C1: in plane A1 perpendicular to z, D1: free, E1: free, F1: free}
lines: A1B1 B1C1 A1D1 B1E1 C1F1 D1E1
mobility: 6
""").family
    said = Words(family, (), (), (), frozenset("xyz")).clause

    def bracket(names: str) -> Expr:
        return Bracket(tuple(map(Point, names.split())))

    assert said(bracket("A1 B1 C1 z")) == "the points A1, B1 and C1 are on a line"
    assert said(bracket("A1 B1 D1 z")) == "the plane A1B1D1 contains the direction z"
    assert said(bracket("A1 B1 C1 x")) == "the plane A1B1C1 contains the direction x"


def test_bars_of_a_parallelogram_are_across_its_axis() -> None:
    assert [s for _, s in analysis("orthoglide").limbs[0].conditions] == ["d1 is perpendicular to A1B1"]
    assert notes(robot("orthoglide")) == ()
    loose = variant("orthoglide", "n%: perpendicular to e%, A% B%", "n%: perpendicular to e%")
    assert [said.partition(",")[0] for said in notes(loose)] == [
        f"leg {i}: the bars of Pa(A{i} B{i}" for i in (1, 2, 3)
    ]


@pytest.mark.parametrize("name", IDS)
def test_limbs_lose_rank_where_said(name: str) -> None:
    """At members at which a bracket vanishes that is said to make a limb singular, its twists lose rank."""
    a, r = analysis(name), robot(name)
    assert not any(s.unexplained for s in a.limbs)
    assert len(a.limbs) == len(r.limbs)
    for limb, said in list(zip(r.limbs, a.limbs, strict=True))[::2]:
        usual = RESIDUES.rank(limb.at(r.family.member(9), RESIDUES).twists(RESIDUES))
        for expression, _ in said.conditions:
            if expression:
                four = re.findall(r"[A-Za-z]\d?", expression)

                def flat(values: Values, four: Sequence[str] = four) -> int:
                    points = r.family.homogeneous(values)
                    return int(RESIDUES.determinant([points[n] for n in four]))

                found = list(singular_members(name, flat, 4, expression, four))
                assert found
                assert all(RESIDUES.rank(limb.at(v, RESIDUES).twists(RESIDUES)) < usual for v in found)


def test_the_published_condition_is_proved_or_refuted() -> None:
    published = analysis("gallardo-4dof").published
    assert published is not None
    assert published.verdict == "proved"
    folder = shipped_folder()
    assert folder is not None
    text = (folder / "gallardo-4dof" / "robot.yaml").read_text("utf-8")
    other = analyze_robot(parse_robot(text.replace("[S1A1B1C1] [S1S3A3B3]", "[S1A1B1C1] [S2S3A3B3]")))
    assert other.published is not None
    assert other.published.verdict == "refuted"


# --- the independent road: ranks and determinants of the joint screws ------------------------------------------------


def locked(name: str, values: Values) -> list[Row]:
    """All wrenches with the actuators locked, of the joint screws alone; in the plane with those that keep it there."""
    r = robot(name)
    rows = [row for limb in r.limbs for row in limb.at(values, RESIDUES).locked(RESIDUES)]
    return [*rows, *((0,) * i + (1,) + (0,) * (5 - i) for i in ((2, 3, 4) if r.family.plane else ()))]


def passive_ranks(name: str, values: Values) -> list[int]:
    return [6 - len(limb.at(values, RESIDUES).locked(RESIDUES)) for limb in robot(name).limbs]


def at(name: str, values: Values) -> Evaluator:
    a = analysis(name)
    points = a.structure.points(robot(name).family, values)
    if robot(name).family.plane:
        points = {n: (p[0], p[1], p[3]) for n, p in points.items()}
    return Evaluator(points, 3 if robot(name).family.plane else 4, PRIME)


def of_the_condition(name: str, values: Values) -> tuple[int, int]:
    """cofactor and coefficient · expression at a member."""
    c = analysis(name).condition
    assert c is not None
    value = at(name, values).value
    return value(c.cofactor)[0], c.coefficient * value(c.expression)[0] % PRIME


def jacobian_determinant(name: str, values: Values) -> int:
    """det of the bases of the limbs' wrench systems (from the screws), times for each limb the determinant that leads
    from this basis to the lines: the reduced echelon form shows it in its columns of leading ones.
    """
    a, r = analysis(name), robot(name)
    points = a.structure.points(r.family, values)
    rows: list[Row] = []
    change = 1
    for limb in r.limbs:
        screws = limb.at(values, RESIDUES).locked(RESIDUES)
        if r.family.plane:
            screws = [[row[0], row[1], row[5]] for row in RESIDUES.basis(screws)]
        basis, pivots = RESIDUES.echelon(screws)
        if r.family.plane:
            basis, pivots = planar_part(limb, values)
        lines = [line.row(points) for line in a.structure.lines or () if line.limb == limb.name]
        assert len(lines) == len(basis)
        change = change * RESIDUES.determinant([[line[p] for p in pivots] for line in lines]) % PRIME
        rows += basis
    if r.family.plane:
        rows = [(row[0], row[1], row[5]) for row in rows]
    return int(RESIDUES.determinant(rows)) * change % PRIME


def planar_part(limb: Any, values: Values) -> tuple[list[Row], tuple[int, ...]]:
    """The wrench in the plane of a planar limb with one actuator."""
    screws = limb.at(values, RESIDUES).locked(RESIDUES)
    flat = [(row[0], row[1], 0, 0, 0, row[5]) for row in screws]
    return RESIDUES.echelon(flat)


@pytest.mark.parametrize("name", ROAD)
def test_joint_screws_against_the_condition(name: str) -> None:
    a, r = analysis(name), robot(name)
    exact = not a.structure.over
    ratios = set()
    for seed in range(MEMBERS if name in IDS else MEMBERS // 5):
        values = r.family.member(("road", seed))
        cofactor, right = of_the_condition(name, values)
        assert cofactor
        assert right
        if exact:
            ratios.add(jacobian_determinant(name, values) * cofactor * pow(right, -1, PRIME) % PRIME)
        else:
            every = locked(name, values)
            assert RESIDUES.rank(every) == 6
            points = a.structure.points(r.family, values)
            assert RESIDUES.rank([*every, *(line.row(points) for line in a.structure.lines or ())]) == 6
            assert RESIDUES.rank([line.row(points) for line in a.structure.lines or ()]) == 6
    assert not exact or ratios in ({1}, {PRIME - 1})


def singular_members(
    name: str, value: Callable[[Values], int], number: int, seed: object, among: Sequence[str] = ()
) -> Iterator[Values]:
    """Members at which a polynomial in the parameters vanishes, on `number` paths that each move one name."""
    family = robot(name).family
    names = [n for n in family.moving if n in among or not among]
    random.Random(f"{name} {seed}").shuffle(names)
    for n in range(number):
        path: MemberPath = family.path((seed, n), names[n % len(names)])
        polynomial = interpolated(lambda t, path=path: value(path.member(t)))
        for t in roots(polynomial or []):
            yield path.member(t)


def stacked(name: str, values: Values) -> int:
    """A determinant that vanishes where the platform can move with locked actuators, and where passive twists depend.

    Unknown are the twist of the platform and the rates of all passive freedoms; each limb says that the twist is the
    sum of its rates. Where there are more equations than unknowns, fixed random combinations of them are taken.
    """
    r = robot(name)
    passive = []
    for limb in r.limbs:
        made = limb.at(values, RESIDUES)
        driven = made.actuated
        passive.append([row for i, row in enumerate(made.twists(RESIDUES)) if i not in driven])
    size = 6 + sum(map(len, passive))
    rows = []
    start = 6
    for twists in passive:
        for c in range(6):
            row = [int(i == c) for i in range(6)] + [0] * (size - 6)
            row[start : start + len(twists)] = [-t[c] for t in twists]
            rows.append(row)
        start += len(twists)
    if len(rows) > size:
        rng = random.Random("combinations")
        mixed = [[rng.randrange(PRIME) for _ in rows] for _ in range(size)]
        rows = [[sum(m * row[c] for m, row in zip(ms, rows, strict=True)) % PRIME for c in range(size)] for ms in mixed]
    return int(RESIDUES.determinant(rows))


@pytest.mark.parametrize("name", ROAD)
def test_rank_drops_where_claimed_and_nowhere_else(name: str) -> None:
    r = robot(name)
    full = 6
    usual = passive_ranks(name, r.family.member("usual"))
    seen = 0

    def both(values: Values) -> None:
        nonlocal seen
        try:
            lost = RESIDUES.rank(locked(name, values)) < full
            here = passive_ranks(name, values)
        except GcrulesError:  # a joint is none there
            return
        cofactor, right = of_the_condition(name, values)
        if here != usual or not cofactor:
            return
        assert lost == (right == 0)
        seen += lost

    paths = 3 if len(r.limbs) > 4 else 5 if name in IDS and name != "3-pprs" else 9
    for values in singular_members(name, lambda v: stacked(name, v), paths, "screws"):
        both(values)
    for values in singular_members(name, lambda v: of_the_condition(name, v)[1], paths, "lines"):
        both(values)
    assert seen >= 2


@pytest.mark.parametrize("name", ROAD)
def test_factors_vanish_where_they_say(name: str) -> None:
    """Where a factor vanishes rank drops, that of the constraints where it says so; one that never does has no root."""
    a, r = analysis(name), robot(name)
    usual = passive_ranks(name, r.family.member("usual"))
    for part in a.parts:
        value = lambda v, part=part: at(name, v).value(part.expression)[0]  # noqa: E731
        found = list(singular_members(name, value, 3, part.kind))
        if part.kind == "never":
            assert not found
            continue
        for values in found[:4]:
            try:
                held = [row for limb in r.limbs for row in limb.at(values, RESIDUES).constraints(RESIDUES)]
                here = passive_ranks(name, values)
            except GcrulesError:
                continue
            if here != usual or r.family.merged(values) or any(not at(name, values).value(c)[0] for c in a.cofactors):
                continue
            lost = 6 - a.structure.mobility - (RESIDUES.rank(held) if held else 0)
            assert part.kind == "mixed" or (lost > 0) == (part.kind == "constraint")
            assert RESIDUES.rank(locked(name, values)) < 6


# --- homes and members -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", IDS)
def test_members_satisfy_their_relations(name: str) -> None:
    family = robot(name).family
    for field in (RESIDUES, RATIONALS):
        values = family.member(3, field)
        for d in family.definitions:
            assert not any(d.relation.residual(d.sort, field, values, values[d.name]))


@pytest.mark.parametrize("name", IDS)
def test_every_robot_has_a_home_that_is_called_an_example(name: str) -> None:
    assert robot(name).home is not None
    assert "example" in robot(name).note


# --- answers ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", IDS)
def test_json_text_and_latex(name: str) -> None:
    a = analysis(name)
    found = json.loads(json.dumps(a.to_json()))
    assert found["schema"] == 1
    assert found["robot"] == name
    assert found["mobility"] == robot(name).mobility
    assert [limb["name"] for limb in found["limbs"]] == [limb.name for limb in robot(name).limbs]
    assert set(found["equivalent"]) == {"legs", "ideal", "given", "derived points"}
    ideal = [*dict.fromkeys((*found["equivalent"]["ideal"], *"xyz"))]
    for part in found["parts"]:
        e = parse(part["expression"], context=Context(found["rank"], (), tuple(ideal)))
        assert e.step == 0
        assert set(points_of(e)) <= {*found["points"], *"xyz"}
    words = " ".join(a.text().split())
    assert words.startswith(a.statement[:60])
    assert "Certificate" in words
    assert a.latex().startswith("\\documentclass")
    assert a.latex().rstrip().endswith("\\end{document}")


CHOSEN = {
    # points that span the bundle of forces through S1 of the robot with four degrees of freedom; what is said of them
    "free points": (("free", "free", "free"), "choice", "[A1B1C1S1]"),
    "along the frame": (("S1 + x", "S1 + y", "S1 + z"), "never", "[A1B1C1S1]"),
    "at right angles": (("S1 + u2", "S1 + v2", "S1 + w"), "never", "[A1B1C1S1]"),
    "none given": (None, "never", "[xyzS1]"),
}


@pytest.mark.parametrize(("relations", "kind", "bracket"), CHOSEN.values(), ids=CHOSEN)
def test_factors_of_chosen_lines(relations: Sequence[str] | None, kind: str, bracket: str) -> None:
    folder = shipped_folder()
    assert folder is not None
    text = (folder / "gallardo-4dof" / "robot.yaml").read_text("utf-8").partition("\ncondition:")[0] + "\n"
    for old, new in zip(("S1 + x", "S1 + y", "S1 + z"), relations or (), strict=False):
        text = text.replace(old, new)
    text = text.replace("  d3: free", "  d3: free\n  w: perpendicular to u2, v2")
    a = analyze_robot(parse_robot(text if relations else text.replace("    through: A1 B1 C1\n", "")))
    assert {str(p.expression): p.kind for p in a.parts} == {
        bracket: kind,
        "[A2S1S2S3]": "actuation",
        "[A3B3S1S3]": "actuation",
    }
    assert "A1" not in a.statement


def test_a_link_may_spin_between_two_ball_joints() -> None:
    a = analyze_robot(
        parse_robot("""
title: legs with a ball joint at both ends
copies: 6
points: {A%: free, B%: free}
limbs: [{joints: "S(A%) P*(A% B%) S(B%)"}]
mobility: 6
""")
    )
    assert (a.structure.mobility, a.structure.idle) == (6, 6)
    assert "belong to one linear complex" in a.statement


@pytest.mark.needs("pdflatex")
@pytest.mark.parametrize("name", ["4-ruu", "3-upu", "gallardo-4dof"])
def test_latex_compiles(name: str, tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_text(analysis(name).latex(), encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=120, check=False)
    log = (tmp_path / "a.log").read_text(encoding="utf-8", errors="replace")
    assert done.returncode == 0, log[-2000:]
    assert not [w for w in re.findall(r"Overfull .hbox \(([0-9.]+)pt", log) if float(w) > 40]


def test_limbs_whose_wrench_is_a_screw_are_reported() -> None:
    general = """
title: general axes
copies: 3
points: {A%: free, B%: free, C%: free, D%: free, E%: free}
directions: {a%: free, b%: free, c%: free, d%: free, e%: free}
limbs: [{joints: "R*(A%, a%) R(B%, b%) R(C%, c%) R(D%, d%) R(E%, e%)"}]
mobility: 3
"""
    a = analyze_robot(parse_robot(general))
    assert a.structure.lines is None
    assert a.condition is None
    assert "a screw of finite pitch" in a.statement
    assert a.to_json()["condition"] is None
    assert a.text()
    assert a.latex()


GIVEN_BY_LINES = """
title: lines of the paper
points: {S1: free, S2: free, S3: free, A1: free, B1: free, C1: free, A2: free, A3: free, B3: free}
lines: S1A1 S1B1 S1C1 S2A2 S3A3 S3B3
mobility: 4
"""


def test_a_robot_is_given_by_its_lines() -> None:
    a = analyze_robot(parse_robot(GIVEN_BY_LINES))
    assert [str(p.expression) for p in a.parts] == ["[A1B1C1S1]", "[A2S1S2S3]", "[A3B3S1S3]"]
    dead = GIVEN_BY_LINES.replace("S1A1 S1B1 S1C1 S2A2 S3A3 S3B3", "S1A1 S1B1 S1C1 S1A2 S3A3 S3B3")
    with pytest.raises(InputError, match="singular in every pose"):
        analyze_robot(parse_robot(dead))
    special = analyze_robot(parse_robot(GIVEN_BY_LINES.replace("C1: free", "C1: in plane A1 B1 S2")))
    assert "[A1B1C1S1]" in [str(p.expression) for p in special.parts]


def test_incidences_of_the_family_are_assumed_where_they_help() -> None:
    lines = """
title: six lines
points: {A1: free, A2: free, A3: free, A4: free, B1: free, B2: free, B3: free, B4: free, B5: free}
lines: A1B1 A1B2 A2B2 A2B3 A3B4 A4B5
mobility: 6
"""
    a = analyze_robot(parse_robot(lines))
    assert a.structure.given == ()
    assert len(a.parts) == 1
    special = analyze_robot(parse_robot(lines.replace("B4: free", "B4: in plane A1 A2 A3")))
    assert special.structure.incidences == ("coplanar(A1, A2, A3, B4)",)
    assert [str(p.expression) for p in special.parts] == ["[A1A2A4B5]", r"A1B1B2 /\ A2B2B3 /\ A3B4"]
    planar = lines.replace("A1B1 A1B2 A2B2 A2B3 A3B4 A4B5", "A1B1 A2B2 A3B3").replace("title", "space: plane\ntitle")
    flat = analyze_robot(parse_robot(planar.replace("A3: free", "A3: on line A1 A2")))
    assert flat.structure.incidences == ("collinear(A1, A2, A3)",)


# --- files -----------------------------------------------------------------------------------------------------------

GOOD = """\
title: three legs
copies: 3
points:
  A%: free
  S%: in plane A% perpendicular to r%
directions:
  r%: free
limbs:
  - name: leg %
    joints: R(A%, r%) P*(A% S%) S(S%)
mobility: 3
"""


def told(text: str) -> str:
    with pytest.raises(GcrulesError) as caught:
        parse_robot(text, "robot.yaml")
    assert caught.value.exit_code == 2
    return caught.value.render()


FAULTS: dict[str, tuple[str, str, str]] = {
    # what is replaced, by what, what is said and where
    "unknown joint": ("P*(A% S%)", "Q*(A% S%)", "robot.yaml:10:23: 'Q' is no kind of joint"),
    "near joint": ("P*(A% S%)", "p*(A% S%)", "did you mean P"),
    "no actuated joint": ("P*", "P", "robot.yaml:10:13: no joint is actuated"),
    "too many actuators": ("R(A%", "R*(A%", "too many actuators: 6 for a platform of mobility 3"),
    "too few actuators": (
        "  - name: leg %\n    joints: R(A%, r%) P*(A% S%) S(S%)",
        "  - joints: R(A1, r1) P*(A1 S1) S(S1)\n  - joints: R(A2, r2) P(A2 S2) S(S2)\n"
        "  - joints: R(A3, r3) P(A3 S3) S(S3)",
        "too few actuators: 1 for a platform of mobility 3",
    ),
    "limb of mobility 7": ("S(S%)", "S(S%) R(A%, x) R(A%, y)", "leg 1 has mobility 7"),
    "wrong mobility": ("mobility: 3", "mobility: 4", "robot.yaml:11:11: the platform has mobility 3, not 4"),
    "coincident points": ("  S%: in", "  T1: A1\n  S%: in", "A1 and T1 are one point"),
    "zero direction": ("  r%: free", "  r%: free\n  w: r1 - r1", "the direction w is zero in every member"),
    "zero product": ("  r%: free", "  r%: free\n  w: perpendicular to r1, r1", "the direction w is zero"),
    "no plane": ("  S%: in", "  T1: in plane A1 along r1, r1\n  S%: in", "the plane on which T1 lies is none"),
    "no line": ("  S%: in", "  T1: on line A1 A1\n  S%: in", "the line on which T1 lies is none"),
    "contradiction": ("mobility: 3", 'mobility: 3\nfacts: ["r1 parallel to r2"]', "contradicts the relations"),
    "cycle": ("  r%: free", "  r%: perpendicular to A% S%", "is defined by itself, in a circle"),
    "self": ("  r%: free", "  r%: free\n  w: parallel to w", "w is defined by itself"),
    "unknown name": ("A%: free", "A%: free\n  B1: A1 + Q7 - A2", "Q7 is not defined"),
    "unknown in joint": ("S(S%)", "S(T%)", "robot.yaml:10:33: T1 is not defined"),
    "direction for point": ("R(A%, r%)", "R(r%, r%)", "r1 is a direction, and R(r1, r1) needs a point there"),
    "point for direction": ("R(A%, r%)", "R(A%, A%)", "A1 is a point, and R(A1, A1) needs a direction there"),
    "wrong number of parts": ("R(A%, r%)", "R(A%)", "a joint R takes 2 parts, found 1"),
    "no such drive": ("S(S%)", "S*(S%)", "this freedom of a joint S cannot be actuated"),
    "weights": ("A%: free", "A%: free\n  B1: A1 + A2", "A1 is no point"),
    "no relation": ("A%: free", "A%: free\n  B1: near A1", "'near A1' is no relation of a point"),
    "axis as a name": ("A%: free", "A%: free\n  x: free", "x is a direction of the frame"),
    "bad name": ("A%: free", "A%: free\n  foot: free", "'foot' is no name"),
    "twice": ("  r%: free", "  r%: free\n  A1: free", "A1 is defined twice"),
    "copies missing": ("copies: 3\n", "", "there is no key copies"),
    "many copies": ("copies: 3", "copies: 99", "copies are 1 to 12"),
    "parallel axes": ("R(A%, r%)", "U(A%, r%, r%)", "the two axes of a joint U are parallel"),
    "tag": (
        "title: three",
        "title: !!python/object:os.system three",
        "tags (tag:yaml.org,2002:python/object:os.system)",
    ),
    "anchor": ("title: three", "title: &a three", "anchors (&a) are not read"),
    "unknown key": ("mobility", "code: import os\nmobility", "unknown key 'code'"),
    "no limbs": ("limbs:\n  - name: leg %\n    joints: R(A%, r%) P*(A% S%) S(S%)\n", "", "the key 'limbs' is missing"),
    "empty limbs": ("limbs:\n  - name: leg %\n    joints: R(A%, r%) P*(A% S%) S(S%)\n", "limbs: []\n", "no limbs"),
    "same limb": ("name: leg %", "name: leg", "two limbs bear the name 'leg'"),
    "long relation": ("A%: free", "A%: free\n  B1: A1" + " " * 400 + "+ x", "more than 300 characters"),
    "home missing": ("mobility: 3", "mobility: 3\nhome: {A1: [0, 0, 0]}", "home gives no coordinates for"),
    "home numbers": ("mobility: 3", "mobility: 3\nhome: {A1: [0, 0]}", "a list of 2, expected 3"),
    "home unknown": ("mobility: 3", "mobility: 3\nhome: {Q1: [0, 0, 0]}", "Q1 is not defined"),
    "platform": ("mobility: 3", "mobility: 3\nplatform: r1", "r1 is no point"),
    "division by zero": ("A%: free", "A%: free\n  B1: A1 + 1/0 x", "division by zero"),
    "lines and limbs": ("mobility: 3", "mobility: 3\nlines: A1S1", "by its limbs or by lines, not by both"),
    "planar": ("copies: 3", "copies: 3\nspace: plane", "S1 does not lie in the plane z = 0 of a planar robot"),
}


@pytest.mark.parametrize(("old", "new", "said"), FAULTS.values(), ids=FAULTS)
def test_faults_have_a_message_and_a_place(old: str, new: str, said: str) -> None:
    assert old in GOOD
    found = told(GOOD.replace(old, new))
    assert said in found
    assert "robot.yaml:" in found


def test_all_faults_come_out_at_once() -> None:
    found = told(GOOD.replace("S(S%)", "S(T%)").replace("A%: free", "A%: free\n  B1: near A1\n  foot: free"))
    assert found.count("error:") == 3


def test_home_that_violates_a_relation() -> None:
    home = "home: {A1: [1,0,0], A2: [-1,2,0], A3: [-1,-2,0], r1: [0,1,0], r2: [2,1,0], r3: [2,-1,0],"
    good = f"{GOOD}{home} S1: [1/2,0,2], S2: [-1/2,1,2], S3: [-1/2,-1,2]}}\n"
    assert parse_robot(good).home
    assert "home violates the relation of S1" in told(good.replace("S1: [1/2,0,2]", "S1: [1/2,1,2]"))
    assert "home violates" not in told(good.replace("r1: [0,1,0]", "r1: [0,0,0]"))
    assert "S2 is in the same place as another point" in told(good.replace("S2: [-1/2,1,2]", "S2: [-1,2,0]"))


def test_large_files_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "robot.yaml"
    path.write_bytes(b"#" * 10_000_000)
    with pytest.raises(InputError, match="larger than"):
        read_robot(path)


def test_bombs_are_refused() -> None:
    bomb = "a: &a [x, x]\n" + "\n".join(f"{b}: &{b} [*{a}, *{a}]" for a, b in zip("abcdefgh", "bcdefghi", strict=True))
    assert "aliases" in told(bomb)


@settings(max_examples=60)
@given(st.text(alphabet="RPUS*(),:%A1r xy\n-+/free", max_size=60), st.sampled_from(["joints", "A%", "r%", "mobility"]))
def test_any_text_is_read_or_refused_with_a_place(junk: str, key: str) -> None:
    text = re.sub(rf"({re.escape(key)}:).*", lambda m: f"{m[1]} {json.dumps(junk)}", GOOD, count=1)
    with contextlib.suppress(GcrulesError):  # anything else is a fault of gcrules
        parse_robot(text)


# --- relations and joints --------------------------------------------------------------------------------------------

WRITTEN = {
    "point": ["free", "on line A B", "on line A along u", "in plane A B C", "in plane A along u, v", "B + C - A",
              "A + u", "in plane A perpendicular to u", "in plane A normal to B C", "1/2 A + 1/2 B"],
    "direction": ["free", "along A B", "parallel to u", "perpendicular to u", "perpendicular to u, v", "in span u, A B",
                  "u + 2 v", "B - A"],
}  # fmt: skip


@pytest.mark.parametrize(("sort", "text"), [(s, t) for s, ts in WRITTEN.items() for t in ts])
def test_values_satisfy_their_relation_and_others_do_not(sort: str, text: str) -> None:
    rng = random.Random(text)
    values = {n: tuple(rng.randrange(PRIME) for _ in range(3)) for n in "ABCuv"}
    found = relation(sort, text)
    parameters = [rng.randrange(PRIME) for _ in range(found.parameters(sort))]
    own = found.value(sort, RESIDUES, values, parameters)
    assert not any(found.residual(sort, RESIDUES, values, own))
    other = tuple(rng.randrange(PRIME) for _ in range(3))
    assert any(found.residual(sort, RESIDUES, values, other)) == (text != "free")


def test_every_form_of_relation_is_tested() -> None:
    kinds = {relation(sort, text).kind for sort, texts in WRITTEN.items() for text in texts}
    assert kinds == {kind for forms in RELATIONS.values() for kind in forms} | {"sum"}


@pytest.mark.parametrize(
    ("text", "actuated"),
    [("R*(A, u)", (0,)), ("U*(A, u, v)", (0, 1)), ("U*2(A, u, v)", (1,)), ("C*1(A, u)", (0,)), ("E*(A, u)", (2,))],
)
def test_stars_mark_what_is_driven(text: str, actuated: tuple[int, ...]) -> None:
    assert read_joints(text)[0].actuated == actuated
    assert str(read_joints(text)[0]) == text


def test_roots_are_roots() -> None:
    rng = random.Random(5)
    for _ in range(20):
        wanted = {rng.randrange(PRIME) for _ in range(4)}

        def value(t: int, wanted: set[int] = wanted) -> int:
            product = t * t + 1  # no roots: the prime is 3 mod 4
            for root in wanted:
                product = product * (t - root) % PRIME
            return product

        assert set(roots(interpolated(value) or [])) == wanted
    assert roots([]) == roots([5]) == ()


# --- discovery and commands ------------------------------------------------------------------------------------------


def run(*words: str) -> Any:
    return CliRunner().invoke(cli, ["robot", *words])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "robot.yaml").write_text(GOOD, "utf-8")
    return tmp_path


def test_robots_are_found_by_id_and_by_path(folder: Path) -> None:
    assert read_robot("mine", plugins=[folder]).id == "mine"
    assert read_robot(folder / "mine" / "robot.yaml").title == "three legs"
    with pytest.raises(InputError, match="there is no robot '3-rsp'") as caught:
        read_robot("3-rsp")
    assert "3-rps" in (caught.value.hint or "")


def test_a_clash_names_both_owners(folder: Path) -> None:
    (folder / "mine").rename(folder / "delta")
    with pytest.raises(InputError) as caught:
        read_robot("delta", plugins=[folder])
    assert "gcrules" in caught.value.message
    assert f"folder {folder}" in caught.value.message


def test_a_folder_that_is_known_is_no_clash() -> None:
    folder = shipped_folder()
    assert folder is not None
    assert read_robot("delta", plugins=[os.path.relpath(folder)]).owner == "gcrules"


def test_a_file_of_code_beside_a_robot_is_not_run(folder: Path) -> None:
    (folder / "mine" / "rules.py").write_text("raise SystemExit(7)", "utf-8")
    assert analyze_robot(read_robot("mine", plugins=[folder])).structure.mobility == 3


def test_robots_of_installed_packages(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = folder / "robots_of_others"
    package.mkdir()
    (package / "__init__.py").write_text("raise SystemExit(7)", "utf-8")  # finding robots does not run it
    (folder / "mine").rename(package / "mine")
    monkeypatch.syspath_prepend(str(folder))
    entry = type("Entry", (), {"name": "others", "value": "robots_of_others", "dist": None})
    monkeypatch.setattr("gcrules.mechanisms.description.discovery.metadata.entry_points", lambda group: [entry])
    assert read_robot("mine").owner == "package robots_of_others"


def test_commands(folder: Path) -> None:
    listed = run("list", "--plugins", str(folder))
    assert listed.exit_code == 0
    assert "3-rps" in listed.output
    assert f"(folder {folder})" in listed.output
    assert {r["id"] for r in json.loads(run("list", "--json").output)["robots"]} == set(IDS)
    shown = run("show", "3-rps")
    assert "S1: in plane A1 perpendicular to r1" in shown.output
    assert json.loads(run("analyze", "3-rps", "--json").output)["class"] == "6-3.2"
    assert run("analyze", "3-rps", "--latex").output.startswith("\\documentclass")
    assert "mobility 3" in run("check", "mine", "--plugins", str(folder)).output
    assert run("analyze", "nothing").exit_code == 2


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["3-rps"], 0, "3-RPS robot (3-rps)"),
        (["mine/robot.yaml"], 0, "three legs"),
        (["mine", "--plugins", "."], 0, "three legs"),
        (["3-rps", "--json"], 0, '"class": "6-3.2"'),
        (["3rps"], 2, "did you mean 3-rps"),
        (["3-rps", "--full"], 2, "A robot of joints takes"),
        (["3-rps", "--rank", "3"], 2, "A robot of joints takes"),
        (["ab,af,cb,cd,ed,ef"], 0, "four planes abc, aef, bdf and cde"),
        (["abaf"], 2, "no id of a robot, a class or an example, and no legs"),
    ],
    ids=["id", "file", "of a folder", "JSON", "typing error", "option", "rank", "legs in one word", "no legs"],
)
def test_analyze_takes_robots(
    words: list[str], code: int, said: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    result = CliRunner().invoke(cli, ["analyze", *words])
    assert result.exit_code == code
    assert said in (result.stderr if code else result.stdout)


def test_a_refuted_condition_is_a_definite_no(folder: Path) -> None:
    path = folder / "mine" / "robot.yaml"
    path.write_text(f'{GOOD}condition: "[A1A2A3S1]"\n', "utf-8")
    found = run("check", str(path))
    assert found.exit_code == 1
    assert "refuted" in found.output
    for wrong in ("A1A2A3", "[A1A2A3Q9]", "[A1A2"):
        path.write_text(f'{GOOD}condition: "{wrong}"\n', "utf-8")
        assert run("check", str(path)).exit_code == 2


def test_a_new_robot_passes_its_check(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("new", "my-robot").exit_code == 0
    assert run("check", "my-robot/robot.yaml").exit_code == 0
    again = run("new", "my-robot")
    assert again.exit_code == 2
    assert "already" in again.output
    assert run("new", "../up").exit_code == 2


# --- the schema for editors ------------------------------------------------------------------------------------------

SCHEMA = json.loads((Path(gc.__file__).parent / "mechanisms" / "description" / "robot.schema.json").read_text("utf-8"))


def fits(value: Any, schema: Any) -> bool:
    """Whether a value fits a schema, as far as the keywords go that this schema uses."""
    if "$ref" in schema:
        return fits(value, SCHEMA["$defs"][schema["$ref"].rsplit("/", 1)[1]])
    kinds = {"object": dict, "array": list, "string": str, "integer": int, "number": (int, float)}
    if "type" in schema and not isinstance(value, kinds[schema["type"]]):
        return False
    tests = [
        "enum" not in schema or value in schema["enum"],
        "anyOf" not in schema or any(fits(value, s) for s in schema["anyOf"]),
        "oneOf" not in schema or sum(fits(value, s) for s in schema["oneOf"]) == 1,
        "not" not in schema or not fits(value, schema["not"]),
        "minimum" not in schema or value >= schema["minimum"],
        "maximum" not in schema or value <= schema["maximum"],
        "minItems" not in schema or len(value) >= schema["minItems"],
        "maxItems" not in schema or len(value) <= schema["maxItems"],
        "pattern" not in schema or re.search(schema["pattern"], value) is not None,
        all(key in value for key in schema.get("required", ())),
    ]
    if isinstance(value, dict):
        known = schema.get("properties", {})
        more = schema.get("additionalProperties", True)
        tests += [fits(v, known[k]) for k, v in value.items() if k in known]
        tests += [more is not False and (more is True or fits(v, more)) for k, v in value.items() if k not in known]
        tests += [fits(k, schema["propertyNames"]) for k in value if "propertyNames" in schema]
    if isinstance(value, list) and "items" in schema:
        tests += [fits(v, schema["items"]) for v in value]
    return all(tests)


def texts() -> Sequence[tuple[str, str]]:
    folder = shipped_folder()
    assert folder is not None
    return [*((n, (folder / n / "robot.yaml").read_text("utf-8")) for n in IDS), ("new", skeleton("new")),
            ("lines", GIVEN_BY_LINES)]  # fmt: skip


@pytest.mark.parametrize(("name", "text"), texts(), ids=[name for name, _ in texts()])
def test_files_fit_the_schema(name: str, text: str) -> None:
    import yaml

    assert fits(yaml.safe_load(text), SCHEMA)


@pytest.mark.parametrize(
    "case",
    [
        "unknown joint",
        "unknown key",
        "many copies",
        "axis as a name",
        "home numbers",
        "no limbs",
        "lines and limbs",
        "bad name",
    ],
)
def test_the_schema_refuses_faults(case: str) -> None:
    import yaml

    old, new, _ = FAULTS[case]
    assert not fits(yaml.safe_load(GOOD.replace(old, new)), SCHEMA)


def test_the_schema_knows_all_joints() -> None:
    assert all(re.search(SCHEMA["$defs"]["joints"]["pattern"], f"{symbol}(A)") for symbol in JOINTS)
