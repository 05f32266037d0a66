"""Over-constrained robots: the common factor of all six-subsets; repeated factors; limbs whose wrenches are screws."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from itertools import combinations

import pytest
from click.testing import CliRunner
from places import DATA

import gcrules as gc
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.language.text import text
from gcrules.apps.cli import cli
from gcrules.core.errors import GcrulesError, InputError
from gcrules.core.seeds import repeated
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.common_factor import Subset
from gcrules.mechanisms.conditions.factor_causes import ASIDE, FactorCause, at_member
from gcrules.mechanisms.conditions.overlaps import of_several_kinds
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.family import circles
from gcrules.mechanisms.description.relations import Values
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.lines.ranks import Ranks, ranks
from gcrules.mechanisms.lines.singular import divided, gcd, interpolated, radical, roots
from gcrules.mechanisms.load import read_robot
from gcrules.screws import RATIONALS, RESIDUES, axis, jacobian, product

FILES = DATA / "robots"
IDS = [one.id for one in robots()]


@cache
def load(name: str) -> gc.Robot:
    return read_robot(name if name in IDS else FILES / f"{name}.yaml")


@cache
def analysis(name: str) -> RobotAnalysis:
    return analyze_robot(load(name))


# --- six-subsets -----------------------------------------------------------------------------------------------------

COMMON = {
    # different lines of the limbs, their subsets, those that do not vanish, cofactors of some constraints
    "4-ruu": (8, 28, 6, {"ze1 ze2": "[ze1e2B1]", "xz yz": "1"}),
    "orthoglide": (
        9,
        84,
        20,
        {
            "d1e1 e1n1 d2e2": "[e1d1n1A1][e1d2e2A1]",
            "d1e1 d2e2 d3e3": r"d1e1A1 /\ d2e2A1 /\ d3e3",
            "xy xz yz": "1",
        },
    ),
    "3-rrr-spherical": (6, 1, 1, {"Ox Oy Oz": "1"}),
    "exechon": (7, 7, 3, {"A1v A2v A3s": "the points A1 and A2 coincide", "A1v uv A3s": "1"}),
    "4-upu": (8, 28, 6, {"zv1 zv2": "[zv1v2A1]"}),
    "4-upu-pairs": (6, 1, 1, {"zv1 zv2": "1"}),
    "3-rrr-space": (12, 924, 84, {"A1z B1z C1z": "[zA1B1C1]", "xz yz A1z": "1"}),
    "3-prrr": (9, 84, 18, {"u1x u1y u2x": "[u1xyA1][u1u2xA1]"}),
}


def subsets(a: RobotAnalysis) -> dict[str, Subset]:
    assert a.common
    every = (*a.common.listed, a.common.chosen)
    return {" ".join("".join(ends) for ends in one.lines): one for one in every}


@pytest.mark.parametrize(("name", "found"), COMMON.items(), ids=COMMON)
def test_common_factor(name: str, found: tuple[int, int, int, dict[str, str]]) -> None:
    a = analysis(name)
    assert a.common
    assert (a.common.lines, a.common.subsets, a.common.independent) == found[:3]
    known = subsets(a)
    for constraints, cofactor in found[3].items():
        one = known[constraints]
        assert cofactor == (one.statement if one.cofactor is None else text(one.cofactor))
    shown = json.loads(json.dumps(a.to_json()))["common_factor"]
    assert shown["subsets"] == found[1]
    assert len(shown["cofactors"]) == found[2]
    assert "six-subsets of the limbs' lines" in a.text()
    assert "six-subsets of the limbs' lines" in a.latex()


def superbrackets(name: str, a: RobotAnalysis, values: Values, only: str = "") -> dict[str, int]:
    """Determinants of all six-subsets (or one) with these constraints, of the limbs' lines themselves."""
    points = a.structure.points(load(name).family, values)
    driven = {one.ends: one for limb in a.structure.limbs for one in limb.lines or () if one.role == "actuation"}
    by_ends = {one.ends: one for limb in a.structure.limbs for one in limb.lines or ()}
    by_ends |= {one.ends: one for one in a.structure.lines or ()}
    rest = [one.row(points) for one in driven.values()]
    return {
        words: RESIDUES.determinant([*(by_ends[ends].row(points) for ends in one.lines), *rest])
        for words, one in subsets(a).items()
        if only in ("", words)
    }


@pytest.mark.parametrize("name", COMMON)
def test_cofactors_times_the_common_factor_are_the_superbrackets(name: str) -> None:
    """superbracket = number · cofactor · common factor: at random members, with one number for each subset."""
    a, r = analysis(name), load(name)
    numbers: dict[str, set[int]] = {}
    for seed in range(6):
        values = r.family.member(("subsets", seed))
        value = at_member(r.family, a.structure, values).value
        common = 0
        known = subsets(a)
        found = superbrackets(name, a, values)
        simple = next(words for words, one in known.items() if one.cofactor is not None)
        e = known[simple].cofactor
        assert e is not None
        common = found[simple] * pow(value(e)[0], -1, PRIME) % PRIME
        for words, one in known.items():
            if one.cofactor is not None:
                left = value(one.cofactor)[0] * common % PRIME
                numbers.setdefault(words, set()).add(found[words] * pow(left, -1, PRIME) % PRIME)
    assert numbers
    assert all(len(some) == 1 for some in numbers.values())


@pytest.mark.parametrize("name", ["4-ruu", "orthoglide", "exechon", "3-prrr"])
def test_where_a_cofactor_vanishes_the_wrenches_keep_their_rank(name: str) -> None:
    a, r = analysis(name), load(name)
    usual = ranks(r.family, r.limbs, r.family.member(10**9))
    # Members are drawn anew in each run; along one line of them no cofactor may have a root modulo the prime.
    assert any(zeros_of_cofactors(name, a, r.family.across(("cofactors", line)), usual) for line in range(20))


def zeros_of_cofactors(name: str, a: RobotAnalysis, member: Callable[[int], Values], usual: Ranks) -> int:
    """At how many members along a line a cofactor vanishes and no limb is singular; the wrenches keep full rank."""
    r, met = load(name), 0
    chosen = next(reversed(subsets(a)))
    all_of_them = interpolated(lambda t: superbrackets(name, a, member(t), chosen)[chosen])
    for words, one in [*subsets(a).items()][:2] + [*subsets(a).items()][5:9]:
        if not one.degree:
            continue
        own = interpolated(lambda t, words=words: superbrackets(name, a, member(t), words)[words])
        assert own
        assert all_of_them
        for t in roots(divided(radical(own), gcd(radical(own), radical(all_of_them)))[0]):
            values = member(t)
            assert superbrackets(name, a, values, words)[words] == 0
            here = ranks(r.family, r.limbs, values)
            if here.limbs == usual.limbs:
                assert here.wrenches == 6
                met += 1
    return met


def test_the_factorization_of_a_subset_is_an_identity() -> None:
    """[xyzA] [[ze1, ze2, four lines]] = ± [ze1e2A] [[xz, yz, four lines]], for any rods: proved by normal forms."""
    rods = "Bb, Cc, Dd, Ee"
    for sign in ("", "-"):
        claim = f"[xyzB] [[zu, zv, {rods}]] == {sign}[zuvB] [[xz, yz, {rods}]]"
        if gc.prove(claim, ideal="x y z u v").verdict == "proved":
            return
    pytest.fail("not proved with either sign")


def test_a_constraint_singularity_that_lines_of_the_frame_do_not_see() -> None:
    """Legs in parallel pairs: two different couples, which are parallel where v1 and v2 are."""
    a, r = analysis("4-upu-pairs"), load("4-upu-pairs")
    assert {p.kind for p in a.parts} == {"mixed"}
    assert "x" not in {n for line in a.structure.lines or () for n in line.ends}
    path = r.family.path("parallel", "B1")

    def cross(t: int) -> int:
        at = path.member(t)
        return int(RESIDUES.cross(at["v1"], at["v2"])[2])

    members = [path.member(t) for t in roots(interpolated(cross) or [])]
    assert members
    for values in members:
        found = ranks(r.family, r.limbs, values)
        assert (found.constraints, found.wrenches) == (1, 5)
        assert not any(at_member(r.family, a.structure, values).value(p.expression)[0] for p in a.parts)


def test_families_of_a_high_degree_are_not_compared() -> None:
    """Each direction is made from the two before it: degrees 1, 1, 2, 3, 5, 8 … and the answer stays."""
    names = [f"c{n}" for n in range(1, 12)]
    chain = ", ".join(f'{c}: "perpendicular to {b}, {a}"' for a, b, c in zip(names, names[1:], names[2:], strict=False))
    source = (FILES / "3-prrr.yaml").read_text("utf-8")
    source = source.replace("{u%: free}", f"{{c1: free, c2: free, {chain}, u1: free, u2: free, u3: 'c10 + c11'}}")
    a = analyze_robot(parse_robot(source))
    assert a.common is None
    assert "the directions u1, u2 and u3 are parallel to one plane" in a.statement
    assert "not compared" in a.text()


# --- repeated factors ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*IDS, "3-cru", "3-upu-wrist"])
def test_no_two_factors_say_the_same(name: str) -> None:
    """Where one factor vanishes at constructed members, another one that is stated does not, on some of them."""
    a, r = analysis(name), load(name)
    live = [p for p in a.parts if p.kind not in ASIDE]
    stated = [p for p in live if p.same is None]
    for p, q in combinations(stated, 2):
        member = r.family.across(("same", str(p.expression)))

        def zeros(part: FactorCause, member: Callable[[int], Values] = member) -> list[int]:
            value = lambda t: at_member(r.family, a.structure, member(t)).value(part.expression)[0]  # noqa: E731
            return radical(interpolated(value) or [])

        both = [bool(divided(f, g)[1]) for f, g in ((zeros(p), zeros(q)), (zeros(q), zeros(p)))]
        assert all(both)
    assert len(live) - len(stated) == (name == "3-upu-wrist")
    assert a.statement.count("singular exactly when") <= 1


def test_a_factor_that_is_implied_is_shown_as_such() -> None:
    a = analysis("3-upu-wrist")
    assert r"implies that A1B1O /\ A2B2O /\ A3B3 is zero" in " ".join(a.text().split())
    assert [part["same"] for part in a.to_json()["parts"]] == [r"A1B1O /\ A2B2O /\ A3B3", None]
    assert "implies that" in a.latex()
    r = load("3-upu-wrist")
    factors = [p.expression for p in a.parts]
    assert factors[1] in of_several_kinds(r.family, a.structure, factors)


def test_chosen_lines_that_depend_on_each_other_are_left_out() -> None:
    """Three points of a plane span the pencil there, but where they are on a line."""
    source = (
        (FILES / "3-psp.yaml").read_text("utf-8").replace("S%: free", 'S%: free, T%: "in plane S% perpendicular to e%"')
    )
    a = analyze_robot(parse_robot(source.replace('P(e%)"', 'P(e%)", through: T%')))
    assert [p.chosen > 0 for p in a.parts] == [True]
    assert a.statement.startswith("Where the lines that were chosen for a limb do not depend on each other, the robot")
    assert "others only the chosen lines depend on each other" in " ".join(a.text().split())


# --- wrenches that are screws ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", [16, 55, 56])  # eight members each were of one kind
def test_a_kind_that_some_members_have_is_not_told_of_all(seed: int) -> None:
    """Of the constraint and the actuator's wrench most members have two forces in their system, others none."""
    r = read_robot(DATA / "moved" / "3-5r.yaml")
    kinds = {
        r.limbs[0].at(r.family.member(n, RATIONALS), RATIONALS).locked_system(RATIONALS).classify().kind
        for n in range(40)
    }
    assert kinds == {"two forces", "two screws"}
    with repeated(seed):
        found = analyze_robot(r).structure.limbs
    assert {one.kind for one in found} == {"2-system of screws, its constraint a screw of finite pitch"}


def test_screws_at_home() -> None:
    """Limbs of five hinges askew: constraints of finite pitch, as the joint screws have them."""
    r = read_robot(DATA / "moved" / "3-5r.yaml")
    a = analyze_robot(r)
    assert a.structure.lines is None
    assert "2-system of screws, its constraint a screw of finite pitch" in a.statement
    assert "Margin, pose, path and map need none" in a.statement
    limbs = r.limbs_at()
    held = [one for one in a.wrenches if one.role == "constraint"]
    assert [one.limb for one in held] == ["leg 1", "leg 2", "leg 3"]
    for found, limb in zip(held, limbs, strict=True):
        (row,) = limb.constraints(RATIONALS)
        assert all(product(row, twist) == 0 for twist in limb.twists(RATIONALS))
        true = axis(row)
        assert true.point is not None
        assert found.kind == "screw"
        assert found.pitch == pytest.approx(float(true.pitch))
        assert found.point == pytest.approx([float(c) for c in true.point])
        size = math.hypot(*map(float, true.direction))
        assert [abs(c) for c in found.direction] == pytest.approx([abs(float(c)) / size for c in true.direction])
    shown = a.to_json()["home_wrenches"]
    assert len(shown) == 6
    assert {key for one in shown for key in one} == {"limb", "role", "kind", "pitch", "point", "direction"}
    words = " ".join(a.text().split())
    assert "leg 1, constraint: screw of pitch 2.25743 through (1.84158, 1.22772, 1.84158)" in words
    assert "screw of pitch" in a.latex()


def test_the_numeric_road_stays_open() -> None:
    r = load("3-upu-askew")
    rows = jacobian(r.limbs_at())
    assert len(rows.labels) == 6
    assert rows.determinant() != 0
    assert r.home is not None
    moved = {**r.home, "B1": (1.5, 0, 3), "B2": (-1, Fraction(3, 2), 3)}
    assert jacobian(r.limbs_at(moved)).determinant() not in (0, rows.determinant())
    with pytest.raises(InputError, match="the configuration gives no coordinates for A1"):
        r.limbs_at({})
    good = load("3-rps")
    assert good.home is not None
    with pytest.raises(InputError, match="the coordinates of S1 violate its relation: in plane A1 perpendicular to r1"):
        good.limbs_at({**good.home, "S1": (1, 1, 1)})


HELICAL = """
title: legs with a helical hinge
copies: 3
points: {A%: free, S%: "in plane A% perpendicular to r%"}
directions: {r%: free}
limbs: [{joints: "H(A%, r%, 1/2) P*(A% S%) S(S%)"}]
mobility: 3
"""


def test_a_pencil_whose_plane_is_turned_by_a_pitch() -> None:
    """The forces of an HPS leg go through S; no pair of the file's points is in their plane."""
    a = analyze_robot(parse_robot(HELICAL))
    assert {limb.kind for limb in a.structure.limbs} == {"planar pencil"}
    assert dict(a.structure.named)["n1"] == "the direction (r1 × S1A1 − 1/2 r1) × x"
    assert "meet in a point" in a.statement
    assert a.wrenches == ()


def test_wrenches_without_a_home() -> None:
    source = (DATA / "moved" / "3-5r.yaml").read_text("utf-8")
    a = analyze_robot(parse_robot(source[: source.index("home:")]))
    assert a.structure.lines is None
    assert a.wrenches == ()
    assert "not known: the file has no home configuration" in a.text()


def test_limbs_without_lines_are_checked_and_shown() -> None:
    path = str(DATA / "moved" / "3-5r.yaml")
    for command in ("check", "show", "analyze"):
        done = CliRunner().invoke(cli, ["robot", command, path])
        assert done.exit_code == 0, done.output


# --- faults ----------------------------------------------------------------------------------------------------------

LEGS = """\
title: three legs
copies: 3
points: {A%: free, S%: in plane A% perpendicular to r%}
directions: {r%: free}
limbs: [{name: leg %, joints: "R(A%, r%) P*(A% S%) S(S%)"}]
mobility: 3
"""

ONCE = {
    "circle": (
        "r%: free",
        "r%: perpendicular to A% S%",
        "S1 is defined in terms of itself: S1 needs r1, r1 needs S1",
    ),
    "zero": ("r%: free", "r%: x - x", "the direction r1 is zero"),
    "one point": (
        "S%: in plane A% perpendicular to r%",
        "S%: A% + 0 x",
        "A1 and S1 are in one place, whatever the coordinates are",
    ),
}


@pytest.mark.parametrize(("old", "new", "said"), ONCE.values(), ids=ONCE)
def test_copies_report_a_fault_once(old: str, new: str, said: str) -> None:
    with pytest.raises(GcrulesError) as caught:
        parse_robot(LEGS.replace(old, new))
    assert said in caught.value.render()
    assert caught.value.render().count("error:") == 1


def test_circles() -> None:
    needs = {"a": ["b"], "b": ["c"], "c": ["b"], "d": ["d"], "e": ["a"]}
    assert sorted(map(sorted, circles(needs))) == [["b", "c"], ["d"]]


# --- words -----------------------------------------------------------------------------------------------------------


def test_words_of_planar_robots() -> None:
    head = "title: planar\nspace: plane\ncopies: 3\npoints: {A%: free, B%: free}\n"
    head += "directions: {d%: perpendicular to z, e%: perpendicular to z}\n"
    rods = "  - {name: a, joints: 'P*(d1) R(A1, z) R(B1, z)'}\n  - {name: b, joints: 'P*(d2) R(A2, z) R(B2, z)'}\n"
    said = {
        "R*(A3, z) P(d3) P(e3)": "the lines A1B1 and A2B2 are parallel",
        "P*(d3) P(e3) R(A3, z)": "the lines A1B1, A2B2 and n3A3 meet in a point or are parallel. Here n3 is the",
    }
    for last, words in said.items():
        source = f"{head}limbs:\n{rods}  - {{name: c, joints: '{last}'}}\nmobility: 3\n"
        a = analyze_robot(parse_robot(source))
        assert words in a.statement
        assert [limb.kind for limb in a.structure.limbs][:2] == ["force", "force"]
