"""Robots: what is found for each, its limbs, its home, and the forms of the answer."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest
from mechanisms.shipped_robots import GIVEN_BY_LINES, OTHERS, analysis, robot, singular_members
from places import DATA

import gcrules as gc
from gcrules.algebra.expr import Bracket, Expr, Point, points_of
from gcrules.algebra.language.syntax import Context, parse
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.checks import notes
from gcrules.mechanisms.conditions.robot_statement import robot_statement
from gcrules.mechanisms.conditions.words import RobotWords
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.relations import AXES, Values
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.lines.singular import interpolated, roots
from gcrules.rules.plugin import shipped_folder
from gcrules.rules.statement import Flat
from gcrules.screws import RATIONALS, RESIDUES

IDS = tuple(one.id for one in robots())
FILES = DATA / "robots"


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
    "reachy-mini-head": (6, 0, "B1C1 B2C2 B3C3 B4C4 B5C5 B6C6", ("actuation",)),
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
    "4-rpr": (3, 0, "A1B1 A2B2 A3B3", ("choice",)),
    "8-cables": (6, 0, "A1B1 A2B2 A3B3 A4B4 A5B5 A6B6", ("choice",)),
    "3-prr": (3, 0, "B1C1 B2C2 B3C3", ("actuation",)),
    "5r": (2, 0, "B1C A2B2 B2A1", ("choice", "actuation")),
    "3-crr": (3, 3, "xy xz yz A1u1 A2u2 A3u3", ("never", "never", "actuation")),
    "quadrupteron": (4, 2, "xz yz C1u1 C2u2 C3u3 C4u4", ("actuation",)),
    "5-rpur": (5, 4, "ze B1n1 B2n2 B3n3 B4n4 B5n5", ("actuation",)),
    "4-upu": (4, 2, "xz yz A1B1 A2B2 A3B3 A4B4", ("actuation",)),
    "3-uru": (3, 0, "u1v1 A1C1 u2v2 A2C2 u3v3 A3C3", ("constraint", "actuation")),
    "3-cpu": (3, 0, "u1v1 B1u1 u2v2 B2u2 u3v3 B3u3", ("actuation", "constraint")),
    "agile-eye": (3, 6, "Ox Oy Oz v1w1 v2w2 v3w3", ("never", "actuation")),
    "4-ups-sp": (4, 0, "A1B1 A2B2 A3B3 A4B4 Om On", ("actuation",)),
    "trivariant": (3, 0, "A1B1 A2B2 uv Ox Oy Oz", ("never", "actuation")),
    "2-upr-rpu": (3, 3, "A1v A1B1 A2v A2B2 B3u A3B3", ("actuation",)),
    "capaman": (3, 0, "S1b1 S1z S2b2 S2z S3b3 S3z", ("actuation", "actuation")),
    "3-sps-s": (3, 0, "A1B1 A2B2 A3B3 Ox Oy Oz", ("never", "actuation")),
    "h4": (4, 0, "d1p1 d2p1' zn1 d3p2 d4p2' zn2", ("constraint", "actuation")),
    "par4": (4, 4, "P1d1 P1d2 P2d3 P2d4 d1z d2z", ("choice", "actuation")),
    "gantry-tau": (3, 0, "A1B1 A2d2 C2d2 A3d3 C3d3 D3d3", ("actuation", "constraint", "constraint")),
    "omni-wrist-iii": (2, 4, "OO' B1O' B1v1 B2O' B3n3 B4n4", ("actuation", "choice")),
}

IDLE = {"3-sps-s": 3, "8-cables": 8, "gantry-tau": 2}  # legs that spin

STATEMENTS = {
    "8-cables": "A7B7 and A8B8 all belong to one linear complex, which takes two to three conditions at once: it has 8",
    "3-prr": "the lines B1C1, B2C2 and B3C3 meet in a point or are parallel",
    "5r": "the points B1, B2 and C are on a line",
    "3-crr": "the directions u1, u2 and u3 are parallel to one plane, and then in every pose: that is a matter of its",
    "quadrupteron": "Without the wrenches along u3C3 and u4C4 the platform can turn",
    "5-rpur": "the lines ze, B1n1, B2n2, B3n3, B4n4 and B5n5 belong to one linear complex",
    "4-upu": "Without the wrenches along A3B3 and A4B4 the platform can turn",
    "3-uru": "or the lines A1C1, A2C2 and A3C3 are parallel to one plane (actuation singularity)",
    "3-cpu": "By its design it is singular in every pose if the directions u1, u2 and u3 are parallel to one plane",
    "agile-eye": "the moments v1 × w1, v2 × w2 and v3 × w3 of the couples are parallel to one plane",
    "4-ups-sp": "about p, the line through O that crosses A1B1 and A2B2, and about q, the line in the plane mnO",
    "trivariant": "the planes A1B1O, A2B2O and uvO, which pass through O, have a common line",
    "2-upr-rpu": "the planes of leg 1 (vA1B1), leg 2 (vA2B2) and leg 3 (uA3B3) and the plane A1A2B3 meet in a point",
    "capaman": "the plane S1S2S3 contains the direction z, or the planes b1S1z, b2S2z and b3S3z, which are parallel",
    "3-sps-s": "the planes A1B1O, A2B2O and A3B3O, which pass through O, have a common line",
    "h4": "the directions z, n1 and n2 are parallel to one plane (constraint singularity), or the planes d1d2p2' and "
    "zp1p2 and the line d3d4 meet in a point",
    "gantry-tau": "the line A1B1 is parallel to the plane of the directions d2 and d3 (actuation singularity), the "
    "line A2C2 is parallel to the plane of the directions d2 and d3 (constraint singularity), or the plane A3C3D3 "
    "contains the direction d3 (constraint singularity).",
    "par4": "the planes d1d2P2, d3d4P2 and zP1P2, which pass through P2, have a common line.",
    "omni-wrist-iii": "exactly when the point B2 lies in the plane B1OO' of leg 1.",
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
    "4-rpr": "the lines A1B1, A2B2, A3B3 and A4B4 all meet in one point or are all parallel, which takes two",
    "4-ruu": "leaves out poses where the constraints of all limbs together lose rank",
}


def test_every_robot_is_in_the_tables() -> None:
    assert set(IDS) == set(FOUND)


@pytest.mark.parametrize("name", IDS)
def test_lines_and_kinds(name: str) -> None:
    mobility, over, lines, kinds = FOUND[name]
    a = analysis(name)
    assert (a.structure.mobility, a.structure.overconstraints, a.structure.idle) == (mobility, over, IDLE.get(name, 0))
    if limbs := a.robot.limbs:  # the formula of Chebychev, Grübler and Kutzbach
        loops, freedoms = len(limbs) - 1 + sum(one.loops for one in limbs), sum(one.freedoms for one in limbs)
        assert over == (3 if a.robot.family.plane else 6) * loops - freedoms + mobility + IDLE.get(name, 0)
    assert sorted(map(sorted, a.structure.legs)) == sorted(
        sorted(re.findall(r"[A-Za-z]\d?'?", w)) for w in lines.split()
    )
    assert sorted(p.kind for p in a.parts) == sorted(kinds)
    assert all(p.members >= 3 for p in a.parts if p.kind != "never")
    assert not a.cofactors or name in ("4-ruu", "tricept", "quadrupteron", "4-upu", "4-ups-sp")


@pytest.mark.parametrize(("name", "words"), (STATEMENTS | OTHERS).items(), ids=STATEMENTS | OTHERS)
def test_statements(name: str, words: str) -> None:
    assert words in analysis(name).statement


@pytest.mark.parametrize("name", [*IDS, *OTHERS])
def test_points_stand_in_flats_only(name: str) -> None:
    """No clause has a point among its words, so that a map of its flats is all that renames it."""
    a = analysis(name)
    points = {*a.robot.family.sorts, *(n for n, _ in a.structure.named)}
    for meaning in (p.meaning for p in a.parts):
        words = " ".join(str(p) for p in meaning.pieces if not isinstance(p, Flat))
        assert not points.intersection(re.findall(r"[\w']+", words.partition(" of leg ")[0])), words
        assert meaning.points <= points | AXES.keys()


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
    "reachy-mini-head": "the plane A1B1C1 contains the direction r1",
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
    assert words in [c.statement for c in a.limbs[0].conditions]
    assert words.replace("1", "3") in [c.statement for c in a.limbs[2].conditions]
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
    said = str(robot_statement(a.structure, None, a.condition, (), parts, ()))
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
    assert words in [c.statement for c in a.limbs[0].conditions]


def test_words_of_a_flat_bracket_with_a_direction() -> None:
    """[A1 B1 C1 z] where the points lie in a plane across z in every member."""
    family = parse_robot("""
title: legs across z
points: {A1: free, B1: in plane A1 perpendicular to z, C1: in plane A1 perpendicular to z, D1: free, E1: free, F1: free}
lines: A1B1 B1C1 A1D1 B1E1 C1F1 D1E1
mobility: 6
""").family
    said = RobotWords(family, (), (), (), frozenset("xyz")).clause

    def bracket(names: str) -> Expr:
        return Bracket(tuple(map(Point, names.split())))

    assert str(said(bracket("A1 B1 C1 z"))) == "the points A1, B1 and C1 are on a line"
    assert str(said(bracket("A1 B1 D1 z"))) == "the plane A1B1D1 contains the direction z"
    assert str(said(bracket("A1 B1 C1 x"))) == "the plane A1B1C1 contains the direction x"


def test_bars_of_a_parallelogram_are_across_its_axis() -> None:
    assert [c.statement for c in analysis("orthoglide").limbs[0].conditions] == ["d1 is perpendicular to A1B1"]
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
        usual = limb.at(r.family.member(9), RESIDUES).rank(RESIDUES)
        for expression in (c.expression for c in said.conditions):
            if expression:
                four = re.findall(r"[A-Za-z]\d?'?", expression)

                def flat(values: Values, four: Sequence[str] = four) -> int:
                    points = r.family.homogeneous(values)
                    return int(RESIDUES.determinant([points[n] for n in four]))

                found = list(singular_members(name, flat, 4, expression, four))
                assert found
                assert all(limb.at(v, RESIDUES).rank(RESIDUES) < usual for v in found)


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
    assert any(word in robot(name).note for word in ("example", "as published"))


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
    assert words.removeprefix("- ").startswith(a.statement[:60])  # a list where it is long
    assert "Certificate" in words
    assert a.latex().count("\\documentclass") == 1
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


@pytest.mark.needs("pdflatex", "tikz.sty")
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
    assert [str(a) for a in special.structure.incidences] == ["coplanar(A1, A2, A3, B4)"]
    assert [str(p.expression) for p in special.parts] == ["[A1A2A4B5]", r"A1B1B2 /\ A2B2B3 /\ A3B4"]
    planar = lines.replace("A1B1 A1B2 A2B2 A2B3 A3B4 A4B5", "A1B1 A2B2 A3B3").replace("title", "space: plane\ntitle")
    flat = analyze_robot(parse_robot(planar.replace("A3: free", "A3: on line A1 A2")))
    assert [str(a) for a in flat.structure.incidences] == ["collinear(A1, A2, A3)"]
