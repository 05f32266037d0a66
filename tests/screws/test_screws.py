"""Screws against incidence: lines that meet, tables of limbs, systems and robots, and what no motion may change."""

from __future__ import annotations

import math
import random
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gcrules.algebra.evaluate import PRIME, evaluate, random_points, random_rational_points
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.numbers.variety import variety
from gcrules.screws import (
    FLOATS,
    JOINTS,
    KINDS,
    RATIONALS,
    RESIDUES,
    Field,
    Floats,
    Limb,
    LineFamily,
    Residues,
    ScrewSystem,
    axis,
    from_plucker,
    helix,
    jacobian,
    joint,
    limb,
    line_through,
    mobility,
    moved,
    pitch,
    plucker,
    product,
    reciprocal,
    slide,
    turn,
)

Vec = tuple[Any, ...]
FIELDS = {"rationals": RATIONALS, "residues": RESIDUES, "floats": FLOATS}
X, Y, Z, O = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)
fields = pytest.mark.parametrize("field", FIELDS.values(), ids=FIELDS)


class Random:
    """Random exact geometry: small fractions, in general position."""

    def __init__(self, seed: Any) -> None:
        self.rng = random.Random(str(seed))

    def scalar(self) -> Fraction:
        return Fraction(self.rng.randint(-9, 9), self.rng.randint(1, 4))

    def vector(self) -> Vec:
        while not any(v := tuple(self.scalar() for _ in range(3))):
            pass
        return v

    def nonzero(self) -> Fraction:
        return Fraction(self.rng.choice([-5, -3, -2, -1, 1, 2, 3, 5]), self.rng.randint(1, 3))

    def vectors(self, count: int) -> list[Vec]:
        """Any three of them independent."""
        while True:
            found = [self.vector() for _ in range(count)]
            if all(dot(a, cross(b, c)) for a, b, c in combinations(found, 3)):
                return found

    def rotation(self) -> list[Vec]:
        """An exact rotation, from a quaternion."""
        a, b, c, d = (self.rng.randint(-4, 4) for _ in range(4))
        return quaternion(a or 1, b, c, d)

    def mixed(self, rows: list[Vec]) -> list[Vec]:
        """Other rows with the same span, one more than needed."""
        while True:
            mixing = [[self.rng.randint(-3, 3) for _ in rows] for _ in range(len(rows) + 1)]
            if RATIONALS.rank(mixing) == len(rows):
                return [tuple(dot(m, column) for column in zip(*rows, strict=True)) for m in mixing]


def quaternion(a: int, b: int, c: int, d: int) -> list[Vec]:
    n = a * a + b * b + c * c + d * d
    rows = (
        (a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
        (2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
        (2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d),
    )
    return [tuple(Fraction(x, n) for x in row) for row in rows]


def dot(a: Any, b: Any) -> Any:
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a: Vec, b: Vec) -> Vec:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def sub(a: Vec, b: Vec) -> Vec:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def add(a: Vec, b: Vec) -> Vec:
    return tuple(x + y for x, y in zip(a, b, strict=True))


def times(s: Any, a: Vec) -> Vec:
    return tuple(s * x for x in a)


def span(rows: Any, field: Field) -> ScrewSystem:
    """In floats the fractions become floats, in residues residues."""
    if field.floating:
        rows = [[float(x) for x in row] for row in rows]
    return ScrewSystem.span(rows, field)


# --- conventions ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ideal", ["", "b", "ab"])
def test_plucker_coordinates_are_those_of_the_oracle(ideal: str) -> None:
    for seed in range(20):
        points = random_rational_points("abcd", ideal=ideal, seed=seed)
        if len({points["a"], points["b"]}) < 2 or not any(evaluate(parse("ab"), points)):
            continue
        wrench = line_through(points["a"], points["b"])
        assert plucker(wrench) == evaluate(parse("ab"), points)
        assert from_plucker(plucker(wrench)) == wrench
        if not ideal:
            a, b = points["a"][:3], points["b"][:3]
            assert wrench == turn(a, sub(b, a))
            assert pitch(wrench) == 0


def test_a_couple_is_a_line_at_infinity() -> None:
    assert line_through((*X, 0), (*Y, 0)) == slide(Z)
    assert pitch(slide(Z)) == math.inf


def test_product_is_the_bracket_of_the_points() -> None:
    for seed in range(50):
        points = random_rational_points("abcd", seed=seed, ideal="d" if seed % 3 == 0 else "")
        one, other = line_through(points["a"], points["b"]), line_through(points["c"], points["d"])
        assert product(one, other) == -evaluate(parse("[abcd]"), points)
    points = random_points("abcd", seed=1)
    lines = [line_through(points[a], points[b], RESIDUES) for a, b in ("ab", "cd")]
    assert product(*lines, RESIDUES) == -evaluate(parse("[abcd]"), points, modulus=PRIME) % PRIME


def test_lines_that_meet_are_reciprocal() -> None:
    r = Random("meet")
    for _ in range(50):
        p, q, d, e = r.vector(), r.vector(), r.vector(), r.vector()
        assert product(turn(p, d), turn(p, e)) == 0  # in a point
        assert product(turn(p, d), turn(q, times(r.nonzero(), d))) == 0  # parallel
        assert (product(turn(p, d), turn(q, e)) == 0) == (dot(sub(q, p), cross(d, e)) == 0)
        assert product(turn(p, d), slide(e)) == dot(d, e)


def test_superbracket_is_minus_the_determinant() -> None:
    names = "abcdefghijkl"
    lines = [names[i : i + 2] for i in range(0, 12, 2)]
    for seed in range(5):
        points = random_rational_points(names, seed=seed)
        legs = [
            limb(joint("S", point=points[p][:3]), joint("P", direction=sub(points[q], points[p])[:3], actuated=True),
                 joint("S", point=points[q][:3]))
            for p, q in lines
        ]  # fmt: skip
        rows = [turn(points[p][:3], sub(points[q], points[p])[:3]) for p, q in lines]
        value = evaluate(parse(f"[[{','.join(lines)}]]"), points)
        assert RATIONALS.determinant(rows) == -value
        j = jacobian(legs)
        scale = math.prod(dot(row[:3], row[:3]) for row in rows)
        assert j.determinant() * scale == -value  # each actuation is the force, divided by its square
        assert [label.kind for label in j.labels] == ["actuation"] * 6


# --- single screws --------------------------------------------------------------------------------------------------


def test_pitch_and_axis_of_known_screws() -> None:
    r = Random("pitch")
    for _ in range(30):
        p, d, h = r.vector(), r.vector(), r.scalar()
        found = axis(helix(p, d, h))
        assert found.pitch == pitch(helix(p, d, h)) == h
        assert found.direction == d
        assert cross(sub(found.point, p), d) == (0, 0, 0)
        assert dot(found.point, d) == 0
        floating = axis(tuple(map(float, helix(p, d, h))))
        assert floating.pitch == pytest.approx(float(h), abs=1e-12)
        assert floating.point == pytest.approx(tuple(map(float, found.point)), abs=1e-12)
    assert axis(slide(X)) == type(found)(None, X, math.inf)


def test_pitch_of_many_screws() -> None:
    rows = np.array([helix(X, Z, 0.5), slide((1.0, 0, 0)), turn(Y, (0.0, 0, 2))])
    assert pitch(rows).tolist() == [0.5, math.inf, 0]
    points = np.random.default_rng(0).normal(size=(7, 3))
    lines = turn(points, (1.0, 2, 0))
    assert np.allclose(from_plucker(plucker(lines)), lines)
    ends = np.hstack([points, np.ones((7, 1))])
    assert np.allclose(line_through(ends, ends + np.array([1.0, 2, 0, 0])), lines)
    assert np.allclose(pitch(helix(points, (0.0, 1, 1), 3.0)), 3)


@settings(max_examples=30)
@given(seed=st.integers(0, 10**6))
def test_a_motion_keeps_products_and_pitches(seed: int) -> None:
    r = Random(seed)
    rows = [helix(r.vector(), r.vector(), r.scalar()) for _ in range(2)]
    turned = moved(rows, r.rotation(), r.vector())
    assert product(*turned) == product(*rows)
    assert list(map(pitch, turned)) == list(map(pitch, rows))


def test_products_and_motions_of_many_screws() -> None:
    rng = np.random.default_rng(2)
    rows, others, shifts = rng.normal(size=(5, 3, 6)), rng.normal(size=(5, 3, 6)), rng.normal(size=(5, 3))
    turns = np.array([quaternion(2, n, 1, -1) for n in range(5)], dtype=float)
    there, also = moved(rows, turns, shifts), moved(others, turns, shifts)
    assert np.allclose(product(there, also), product(rows, others))
    assert np.allclose(pitch(there), pitch(rows))
    assert np.allclose(there[4], moved(rows[4], turns[4], shifts[4]))


# --- joints ---------------------------------------------------------------------------------------------------------

EXAMPLES: dict[str, tuple[dict[str, Any], list[Any]]] = {
    "R": ({"point": (1, 2, 3), "axis": Z}, [(0, 0, 1, 2, -1, 0)]),
    "P": ({"direction": (1, 2, 3)}, [(0, 0, 0, 1, 2, 3)]),
    "H": ({"point": X, "axis": Z, "pitch": Fraction(1, 2)}, [(0, 0, 1, 0, -1, Fraction(1, 2))]),
    "C": ({"point": X, "axis": Z}, [(0, 0, 1, 0, -1, 0), (0, 0, 0, 0, 0, 1)]),
    "U": ({"point": X, "first": Z, "second": Y}, [(0, 0, 1, 0, -1, 0), (0, 1, 0, 0, 0, 1)]),
    "S": ({"point": X}, [(1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 1), (0, 0, 1, 0, -1, 0)]),
    "E": ({"point": X, "normal": Z}, [(0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1, 0), (0, 0, 1, 0, -1, 0)]),
    "Pa": ({"bars": X, "axis": Z}, [(0, 0, 0, 0, 1, 0)]),
    "4S": (
        {"first": O, "second": Y, "bars": X},
        [(0, 0, 0, 0, 1, 0), (0, 0, 0, 0, 0, 1), (1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0)],
    ),
}


@fields
@pytest.mark.parametrize("kind", JOINTS)
def test_twists_of_joints(kind: str, field: Field) -> None:
    geometry, expected = EXAMPLES[kind]
    made = joint(kind, **geometry)
    assert made.freedoms == len(made.kind.freedoms) == len(made.twists(field)) == len(expected)
    assert limb(made).system(field).dimension == len(expected)
    assert limb(made).system(field).same(span(expected, field))
    floats = joint(kind, **{k: np.array(v, dtype=float) for k, v in geometry.items()})
    assert floats.field == FLOATS
    assert limb(floats).system().same(span(expected, FLOATS))


def test_every_kind_of_joint_has_an_example() -> None:
    assert EXAMPLES.keys() == JOINTS.keys()


# The same motion, made of hinges and sliders.
@pytest.mark.parametrize("seed", range(5))
def test_joints_made_of_hinges_and_sliders(seed: int) -> None:
    r = Random(seed)
    p, (u, v, w) = r.vector(), r.vectors(3)
    same = [
        (joint("C", point=p, axis=u), [joint("P", direction=u), joint("R", point=add(p, u), axis=u)]),
        (joint("U", point=p, first=u, second=v), [joint("R", point=p, axis=u), joint("R", point=p, axis=v)]),
        (joint("S", point=p), [joint("R", point=p, axis=a) for a in (u, v, w)]),
        (joint("E", point=p, normal=u), [joint("R", point=q, axis=u) for q in (p, add(p, v), add(p, w))]),
        (joint("H", point=p, axis=u, pitch=0), [joint("R", point=p, axis=u)]),
        (joint("Pa", bars=u, axis=v), [joint("P", direction=cross(u, v))]),
    ]
    for one, others in same:
        assert limb(one).system() == limb(*others).system(), one
    rods = [ScrewSystem.span([turn(q, u)]) for q in (p, add(p, v))]
    assert limb(joint("4S", first=p, second=add(p, v), bars=u)).system() == (rods[0] | rods[1]).reciprocal()


# --- the wrenches of limbs ------------------------------------------------------------------------------------------

Lines = tuple[Limb, list[Any], str]


def rps(r: Random) -> Lines:
    a, s, axis_ = r.vector(), r.vector(), r.vector()
    leg = limb(
        joint("R", point=a, axis=axis_), joint("P", direction=sub(s, a), actuated=True), joint("S", point=s), name="RPS"
    )
    return leg, [turn(s, sub(s, a)), turn(s, axis_)], "planar pencil"


def prs(r: Random) -> Lines:
    a, s, axis_ = r.vector(), r.vector(), r.vector()
    leg = limb(joint("P", direction=r.vector(), actuated=True), joint("R", point=a, axis=axis_), joint("S", point=s))
    return leg, [turn(s, sub(s, a)), turn(s, axis_)], "planar pencil"


def driven_rps(r: Random) -> Lines:
    a, s, d = r.vector(), r.vector(), r.vector()
    leg = limb(joint("R", point=a, axis=r.vector(), actuated=True), joint("P", direction=d), joint("S", point=s))
    u, v = cross(d, X), cross(d, Y)
    return leg, [turn(s, u), turn(s, v)], "planar pencil"


def upu(r: Random) -> Lines:
    a, b, (u, v) = r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("U", point=a, first=u, second=v),
        joint("P", direction=sub(b, a), actuated=True),
        joint("U", point=b, first=v, second=u),
    )
    return leg, [turn(a, sub(b, a)), slide(cross(u, v))], "force and couple"


def ruu(r: Random) -> Lines:
    a, b, c, (x, z) = r.vector(), r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("R", point=a, axis=z, actuated=True),
        joint("U", point=b, first=z, second=x),
        joint("U", point=c, first=x, second=z),
    )
    return leg, [turn(b, sub(c, b)), slide(cross(z, x))], "force and couple"


def spherical_rr(r: Random) -> Lines:
    o, (u, v, w) = r.vector(), r.vectors(3)
    leg = limb(joint("R", point=o, axis=w, actuated=True), joint("R", point=o, axis=u), joint("R", point=o, axis=v))
    return leg, [*(turn(o, a) for a in (X, Y, Z)), slide(cross(u, v))], "bundle and plane field"


def up(r: Random) -> Lines:
    o, (u, v, w) = r.vector(), r.vectors(3)
    leg = limb(joint("U", point=o, first=u, second=v), joint("P", direction=w))
    forces = [turn(o, cross(w, a)) for a in r.vectors(2)]
    return leg, [*forces, slide(cross(u, v))], "planar pencil and couple"


def upr(r: Random) -> Lines:
    a, b, (u, v) = r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("U", point=a, first=u, second=v),
        joint("P", direction=sub(b, a), actuated=True),
        joint("R", point=b, axis=v),
    )
    return leg, [turn(a, sub(b, a)), turn(a, v), slide(cross(u, v))], "planar pencil and couple"


def spr(r: Random) -> Lines:
    a, b, s = r.vector(), r.vector(), r.vector()
    leg = limb(joint("S", point=a), joint("P", direction=sub(b, a), actuated=True), joint("R", point=b, axis=s))
    return leg, [turn(a, sub(b, a)), turn(a, s)], "planar pencil"


def rpur(r: Random) -> Lines:
    a, b, c, (e, f) = r.vector(), r.vector(), r.vector(), r.vectors(2)
    leg = limb(
        joint("R", point=a, axis=e),
        joint("P", direction=r.vector()),
        joint("U", point=b, first=e, second=f),
        joint("R", point=c, axis=f),
    )
    return leg, [slide(cross(e, f))], "couple"


def rods(r: Random) -> Lines:
    a, d, side = r.vector(), *r.vectors(2)
    leg = limb(
        joint("R", point=r.vector(), axis=r.vector(), actuated=True),
        joint("4S", first=a, second=add(a, side), bars=d),
    )
    return leg, [turn(a, d), turn(add(a, side), d)], "parallel pencil"


def orthoglide(r: Random) -> Lines:
    a, (d, e, n) = r.vector(), r.vectors(3)
    leg = limb(
        joint("P", direction=r.vector(), actuated=True),
        joint("R", point=a, axis=e),
        joint("Pa", bars=d, axis=n),
        joint("R", point=add(a, times(r.nonzero(), d)), axis=e),
    )
    normal = [slide(cross(e, x)) for x in r.vectors(2)]
    return leg, [turn(a, d), *normal], "force and two couples"


LIMBS: dict[str, Callable[[Random], Lines]] = {
    "RPS, P actuated": rps,
    "PRS, P actuated": prs,
    "RPS, R actuated": driven_rps,
    "UPU, parallel pairs": upu,
    "RUU, Schönflies": ruu,
    "RR, spherical": spherical_rr,
    "UP, passive": up,
    "UPR": upr,
    "SPR": spr,
    "RPUR, 3T2R": rpur,
    "two rods with ball ends": rods,
    "R-Pa-R, Orthoglide": orthoglide,
}


@fields
@pytest.mark.parametrize("name", LIMBS)
def test_wrenches_of_limbs(name: str, field: Field) -> None:
    for seed in range(6):
        leg, lines, kind = LIMBS[name](Random((name, seed)))
        found = leg.locked_system(field)
        assert found.dimension == len(lines) == field.height(leg.locked(field))
        assert found.same(span(lines, field))
        assert found.classify().kind == kind
        assert found.classify().spanned_by_lines
        assert leg.constraint_system(field).dimension == 6 - leg.rank(field) == len(lines) - len(leg.actuated)
        # Actuations: product 1 with their own twist, 0 with all others; with the constraints they span the wrenches.
        rows = [*field.rows(leg.actuations(field)), *field.rows(leg.constraints(field))]
        assert span(rows, field).same(found)
        own = [field.row(leg.twists(field), i) for i in range(leg.freedoms)]
        for place, row in zip(leg.actuated, rows, strict=False):
            assert [product(row, t, field) for t in own] == pytest.approx([int(i == place) for i in range(len(own))])


@pytest.mark.parametrize("name", LIMBS)
def test_actuations_in_floats_are_the_exact_ones(name: str) -> None:
    leg, _, _ = LIMBS[name](Random(name))
    assert np.allclose(np.array(leg.actuations(), dtype=float).reshape(-1, 6), leg.actuations(FLOATS).reshape(-1, 6))


def test_actuations_are_orthogonal_to_constraints() -> None:
    leg, _, _ = upu(Random(3))
    (row,) = leg.actuations()
    assert [dot(row, c) for c in leg.constraints()] == [0]


# --- kinds of systems -----------------------------------------------------------------------------------------------

o, p, q = (0, 0, 0), (0, 0, 1), (0, 0, 2)
D = (1, 1, 0)
SYSTEMS: dict[str, tuple[list[Any], list[str]]] = {
    "nothing": ([], []),
    "force": ([turn(q, X)], ["force"]),
    "couple": ([slide(X)], ["couple"]),
    "screw": ([helix(q, X, 2)], []),
    "planar pencil": ([turn(q, X), turn(q, Y)], ["planar pencil"]),
    "parallel pencil": ([turn(q, X), turn(p, X)], ["parallel pencil"]),
    "two couples": ([slide(X), slide(Y)], ["two couples"]),
    "two forces": ([turn(q, X), turn(o, Y)], ["force", "force"]),
    "force and couple": ([turn(q, X), slide(D)], ["force", "couple"]),
    "force and screw": ([turn(q, X), helix(q, Y, 1)], ["force"]),
    "couple and screw": ([slide(Y), helix(q, X, 1)], ["couple"]),
    "two screws": ([helix(q, X, 1), helix(q, Y, 2)], []),
    "bundle": ([turn(q, a) for a in (X, Y, Z)], ["bundle"]),
    "parallel bundle": ([turn(q, X), slide(Y), slide(Z)], ["parallel bundle"]),
    "plane field": ([turn(q, X), turn(q, Y), turn(add(q, X), Y)], ["plane field"]),
    "all couples": ([slide(X), slide(Y), slide(Z)], ["all couples"]),
    "two planar pencils": ([turn(o, Z), turn(p, X), turn(q, Y)], ["planar pencil"] * 2),
    "two parallel pencils": ([turn(o, X), turn(p, Y), slide(Z)], ["parallel pencil"] * 2),
    "planar pencil and couple": ([turn(q, X), turn(q, Y), slide(add(X, Z))], ["planar pencil", "parallel pencil"]),
    "force and two couples": ([turn(q, X), slide(X), slide(Y)], ["two couples", "parallel pencil"]),
    "planar pencil and screw": ([turn(q, X), turn(q, Y), helix(q, Z, 1)], ["planar pencil"]),
    "parallel pencil and screw": ([turn(q, X), slide(Z), helix(q, Y, 1)], ["parallel pencil"]),
    "two couples and screw": ([slide(Y), slide(Z), helix(q, X, 1)], ["two couples"]),
    "force and two screws": ([turn(q, X), helix(q, Y, 1), helix(q, Z, 2)], ["force"]),
    "couple and two screws": ([slide(Z), helix(q, X, 1), helix(q, Y, 2)], ["couple"]),
    "regulus": ([turn(X, Y), turn(Y, Z), turn(Z, X)], []),
    "regulus with a couple": ([turn(o, X), turn(p, Y), turn(q, D)], []),
    "three screws": ([helix(o, X, 1), helix(o, Y, 2), helix(o, Z, 3)], []),
    "bundle and plane field": ([*(turn(q, a) for a in (X, Y, Z)), slide(Z)], ["bundle", "plane field"]),
    "parallel bundle and plane field": (
        [turn(o, X), slide(Y), slide(Z), turn(o, Y)],
        ["parallel bundle", "plane field"],
    ),
    "force and three couples": ([turn(o, X), slide(X), slide(Y), slide(Z)], ["parallel bundle", "all couples"]),
    "special complex": ([turn(o, a) for a in (X, Y, Z)] + [turn(p, X), turn(p, Y)], []),
    "special complex with its axis at infinity": ([slide(X), slide(Y), slide(Z), turn(o, X), turn(o, Y)], []),
    "everything": ([turn(o, a) for a in (X, Y, Z)] + [slide(a) for a in (X, Y, Z)], []),
}
# Dimension 4 and 5 as what is reciprocal to 2 and 1.
AXES = {
    "hyperbolic congruence": "two forces",
    "hyperbolic congruence with an axis at infinity": "force and couple",
    "parabolic congruence": "force and screw",
    "parabolic congruence with its axis at infinity": "couple and screw",
    "elliptic congruence": "two screws",
    "special complex": "force",
    "special complex with its axis at infinity": "couple",
    "general complex": "screw",
}
SIGNED = ("two screws", "three screws", "force and two screws", "couple and two screws", "elliptic congruence")
"""Told from others by a sign, which residues have not."""


def test_every_kind_has_an_example() -> None:
    assert SYSTEMS.keys() | AXES.keys() == KINDS.keys()


PROJECTIVE = {  # how `gcrules.poses.numbers.variety` names spans of lines, points at infinity being points
    "a single line": ("force", "couple"),
    "two skew lines": ("two forces", "force and couple"),
    "a planar pencil": ("planar pencil", "parallel pencil", "two couples"),
    "a bundle": ("bundle", "parallel bundle"),
    "a plane field": ("plane field", "all couples"),
    "a regulus": ("regulus", "regulus with a couple"),
    "two planar pencils": (
        "two planar pencils",
        "two parallel pencils",
        "planar pencil and couple",
        "force and two couples",
    ),
    "a degenerate linear congruence": (
        "bundle and plane field",
        "parallel bundle and plane field",
        "force and three couples",
    ),
    "a hyperbolic linear congruence": (
        "hyperbolic congruence",
        "hyperbolic congruence with an axis at infinity",
    ),
    "a parabolic linear congruence": ("parabolic congruence", "parabolic congruence with its axis at infinity"),
    "an elliptic linear congruence": ("elliptic congruence",),
    "a special linear complex": ("special complex", "special complex with its axis at infinity"),
    "a general linear complex": ("general complex",),
    "no variety": ("everything",),
}


@pytest.mark.parametrize(("kind", "name"), [(kind, name) for name, kinds in PROJECTIVE.items() for kind in kinds])
def test_both_classifications_agree_on_spans_of_lines(kind: str, name: str) -> None:
    for seed in range(3):
        r = Random((kind, seed))
        own = SYSTEMS[kind][0] if kind in SYSTEMS else span(SYSTEMS[AXES[kind]][0], RATIONALS).reciprocal().basis
        system = span(r.mixed(list(moved(own, r.rotation(), r.vector()))), RATIONALS)
        assert system.classify().kind == kind
        assert variety(system.basis).name.startswith(name)


def is_line(row: Any, field: Field) -> bool:
    return abs(product(row, row, field)) < 1e-9


def contains(f: LineFamily, field: Field) -> bool:
    """Whether the point and the plane of a family are incident with all its lines."""
    found = True
    for row in f.rows:
        force, moment = row[:3], row[3:]
        if f.point:
            ends = zip(cross(f.point[:3], force), times(f.point[3], moment), strict=True)
            found &= all(field.is_zero(field.reduced(a - b)) for a, b in ends)
            found &= field.is_zero(field.dot(moment, f.point[:3]))
        if f.plane:
            ends = zip(cross(f.plane[:3], moment), times(f.plane[3], force), strict=True)
            found &= all(field.is_zero(field.reduced(a - b)) for a, b in ends)
            found &= field.is_zero(field.dot(force, f.plane[:3]))
    return found


@pytest.mark.parametrize(
    ("kind", "field"),
    [
        pytest.param(kind, field, id=f"{kind}, {name}")
        for kind in SYSTEMS
        for name, field in FIELDS.items()
        if field != RESIDUES or kind not in SIGNED
    ],
)
def test_kinds_of_systems(kind: str, field: Field) -> None:
    rows, families = SYSTEMS[kind]
    for seed in range(5):
        r = Random((kind, seed))
        there = r.mixed(list(moved(rows, r.rotation(), r.vector()))) if rows else []
        system = span(there, field)
        found = system.classify()
        assert (found.kind, found.dimension, found.irrational) == (kind, len(rows), False)
        assert [f.kind for f in found.families] == families
        for f in found.families:
            assert ScrewSystem.span(f.rows, field).dimension == len(f.rows)
            assert all(row in system and is_line(row, field) for row in f.rows)
            assert contains(f, field)
        if found.spanned_by_lines and families:
            assert span([row for f in found.families for row in f.rows], field).same(system)


@pytest.mark.parametrize(
    ("kind", "field"),
    [
        pytest.param(kind, field, id=f"{kind}, {name}")
        for kind in AXES
        for name, field in FIELDS.items()
        if field != RESIDUES or kind not in SIGNED
    ],
)
def test_kinds_by_their_axes(kind: str, field: Field) -> None:
    for seed in range(5):
        r = Random((kind, seed))
        rows = moved(SYSTEMS[AXES[kind]][0], r.rotation(), r.vector())
        axes = span(r.mixed(list(rows)), field)
        found = axes.reciprocal().classify()
        assert (found.kind, found.dimension) == (kind, 6 - len(rows))
        assert [f.kind for f in found.axes] == SYSTEMS[AXES[kind]][1]
        assert all(row in axes for f in found.axes for row in f.rows)
        assert found.screw == axes.classify().screw or field.floating


@pytest.mark.parametrize(
    ("rows", "text"),
    [
        ([turn(q, X)], "force along (1, 0, 0) through (0, 0, 2)"),
        ([slide(D)], "couple along (1, 1, 0)"),
        ([helix(q, X, Fraction(1, 2))], "screw with pitch 1/2 through (0, 0, 2) along (1, 0, 0)"),
        ([turn(q, X), turn(q, Y)], "planar pencil at (0, 0, 2) in the plane z = 2"),
        ([turn(q, D), turn(p, D)], "parallel pencil along (1, 1, 0) in the plane x - y = 0"),
        ([turn(q, X), turn((0, 2, 0), X)], "parallel pencil along (1, 0, 0) in the plane y + z = 2"),
        ([slide(X), slide(Y)], "two couples normal to (0, 0, 1)"),
        ([turn(q, a) for a in (X, Y, Z)], "bundle at (0, 0, 2)"),
        ([turn(q, X), slide(Y), slide(Z)], "parallel bundle along (1, 0, 0)"),
        ([turn(q, X), turn(q, Y), slide(Z)], "plane field in the plane z = 2"),
        ([slide(X), slide(Y), slide(Z)], "all couples"),
        ([turn(q, X), slide(D)], "force and couple (force along (1, 0, 0) through (0, 0, 2); couple along (1, 1, 0))"),
        (
            [*(turn(q, a) for a in (X, Y, Z)), slide(Z)],
            "bundle and plane field (bundle at (0, 0, 2); plane field in the plane z = 2)",
        ),
    ],
    ids=lambda value: value.split(" (")[0] if isinstance(value, str) else "",
)
def test_systems_in_words(rows: list[Any], text: str) -> None:
    assert str(ScrewSystem.span(rows).classify()) == text
    for fraction, decimal in (
        ("1/2", "0.5"),
        ("(1, 1, 0)", "(0.707107, 0.707107, 0)"),
        ("x - y = 0", "0.707107*x - 0.707107*y = 0"),
        ("y + z = 2", "0.707107*y + 0.707107*z = 1.41421"),
    ):
        text = text.replace(fraction, decimal)
    assert str(span(rows, FLOATS).classify()) == text


def test_lines_without_rational_coordinates() -> None:
    rows = [helix(o, X, 1), helix(o, Y, -2)]
    exact, floats = ScrewSystem.span(rows).classify(), span(rows, FLOATS).classify()
    assert (exact.kind, exact.irrational, exact.families) == ("two forces", True, ())
    assert (floats.kind, floats.irrational, len(floats.families)) == ("two forces", False, 2)
    assert ScrewSystem.span([*rows, turn(o, Z)]).classify().kind == "two planar pencils"
    assert ScrewSystem.span([*rows, slide(Z)]).classify().kind == "two parallel pencils"
    congruence = ScrewSystem.span(rows).reciprocal().classify()
    assert (congruence.kind, congruence.irrational) == ("hyperbolic congruence", True)


@pytest.mark.parametrize("exponent", range(-13, -5))
def test_noise_gives_a_kind_or_is_undecided(exponent: int) -> None:
    """Far below the tolerance of 1e-9 the kind is the exact one; near it there may be none, above it a general one."""
    rng = np.random.default_rng(exponent + 20)
    for kind, (rows, _) in SYSTEMS.items():
        noisy = np.array(rows, dtype=float).reshape(-1, 6)
        noisy = noisy + 10.0**exponent * rng.uniform(-1, 1, noisy.shape)
        try:
            found = ScrewSystem.span(noisy).classify().kind
        except LimitReached:
            found = "undecided"
        assert found == kind or (exponent > -11 and found in KINDS) or (-11 < exponent < -7 and found == "undecided")


def number_of_lines(kind: str, p: int, irrational: bool) -> int:
    """In a system over the field with p elements."""
    plane, line = p * p + p + 1, p + 1
    isotropic = {"force": 1, "couple": 1, "planar pencil": line, "parallel pencil": line, "two couples": line}
    isotropic |= dict.fromkeys(("bundle", "parallel bundle", "plane field", "all couples"), plane)
    two = {"two forces": (2, 0), "force and couple": (2, 0)}
    two |= dict.fromkeys(("two planar pencils", "two parallel pencils"), (2 * p + 1, 1))
    two |= dict.fromkeys(("planar pencil and couple", "force and two couples"), (2 * p + 1, 1))
    two |= dict.fromkeys(
        ("hyperbolic congruence", "hyperbolic congruence with an axis at infinity"), (line**2, p * p + 1)
    )
    one = {"regulus": line, "regulus with a couple": line, "special complex": p * line**2 + 1, "screw": 0, "nothing": 0}
    one |= {"special complex with its axis at infinity": p * line**2 + 1, "general complex": p**3 + plane}
    one |= dict.fromkeys(("parabolic congruence", "parabolic congruence with its axis at infinity"), plane)
    one |= dict.fromkeys(
        ("bundle and plane field", "parallel bundle and plane field", "force and three couples"), 2 * plane - line
    )
    if kind in two:
        return two[kind][irrational]
    return (isotropic | one)[kind.removesuffix(" and screw")]


@settings(max_examples=150)
@given(data=st.data(), size=st.integers(1, 5))
def test_lines_counted_modulo_seven(data: st.DataObject, size: int) -> None:
    """All screws of a system over the field with seven elements are listed, and the lines among them counted."""
    field, residue = Residues(7), st.sampled_from([0, 0, 0, 1, 2, 3, 4, 5, 6])
    rows = data.draw(st.lists(st.tuples(*[residue] * 6), min_size=size, max_size=size))
    try:
        system = ScrewSystem.span(rows, field)
        found = system.classify()
    except LimitReached:
        assume(False)
    size = system.dimension
    assume(size)
    coefficients = np.array(np.meshgrid(*[range(7)] * size, indexing="ij")).reshape(size, -1).T
    screws = coefficients @ np.array(system.basis).reshape(size, 6) % 7
    lines = screws[(screws[:, :3] * screws[:, 3:]).sum(axis=1) % 7 == 0]
    assert (len(lines) - 1) / 6 == number_of_lines(found.kind, 7, found.irrational)
    if not found.irrational:
        chosen = np.random.default_rng(0).permutation(lines)[:200].tolist()
        assert (field.rank(chosen) == size) == found.spanned_by_lines


# --- properties -----------------------------------------------------------------------------------------------------

SMALL = st.integers(-2, 2)
ROWS = st.lists(st.tuples(*[SMALL] * 6), max_size=6)
LINES = st.lists(
    st.builds(lambda a, w: line_through((*a, w), (1, 3, -1, 1)), st.tuples(st.just(1), SMALL, SMALL), st.integers(0, 1))
    | st.builds(lambda a: slide(a), st.tuples(SMALL, SMALL, st.just(1)))
    | st.builds(lambda a, b: turn(a, b), st.tuples(*[SMALL] * 3), st.tuples(st.just(1), SMALL, SMALL)),
    max_size=4,
)


@fields
@settings(max_examples=60)
@given(rows=ROWS | LINES, others=ROWS)
def test_reciprocal_systems(field: Field, rows: list[Any], others: list[Any]) -> None:
    one, other = span(rows, field), span(others, field)
    assert one.dimension == field.rank(field.read(rows)) if rows else one.dimension == 0
    assert one.dimension + one.reciprocal().dimension == 6
    assert one.reciprocal().reciprocal().same(one)
    assert all(abs(product(a, b, field)) < 1e-9 for a in one.basis for b in one.reciprocal().basis)
    assert (one | other).dimension + (one & other).dimension == one.dimension + other.dimension
    assert all(row in one for row in (one & other).basis)
    if not field.floating:
        assert one.reciprocal().reciprocal() == one
        assert (one == other) == one.same(other)


@settings(max_examples=150)
@given(rows=ROWS | LINES, turned=st.tuples(*[st.integers(-3, 3)] * 3), shift=st.tuples(*[SMALL] * 3))
def test_kinds_do_not_depend_on_frame_basis_or_numbers(rows: list[Any], turned: Vec, shift: Vec) -> None:
    system = ScrewSystem.span(rows)
    there = ScrewSystem.span(moved(rows, quaternion(2, *turned), shift)) if rows else system
    found = system.classify()
    assert there.classify().kind == found.kind
    assert there.classify().irrational == found.irrational
    assert span(rows, FLOATS).classify().kind == found.kind
    assert span(rows, Floats(1e-9, 2.5)).classify().kind == found.kind
    if there.dimension == system.dimension == 1 and found.screw:
        assert there.classify().screw.pitch == found.screw.pitch


def test_length_is_the_unit_of_moments() -> None:
    """A robot in millimetres, measured with a length of 1000, gives what it gives in metres."""
    leg, _, _ = rps(Random(7))
    metres = leg.actuations(FLOATS)
    joints = []
    for j in leg.joints:
        parts = {part: times(1000, v) if part == "point" else v for part, v in j.geometry.items()}
        joints.append(joint(j.kind.symbol, actuated=j.actuated, **parts))
    scaled = limb(*joints)
    found = scaled.actuations(Floats(length=1000.0))
    assert np.allclose(found, metres * [1, 1, 1, 1000, 1000, 1000])
    (family,) = scaled.locked_system(Floats(length=1000.0)).classify().families
    (other,) = leg.locked_system(FLOATS).classify().families
    assert np.allclose(family.point, np.array(other.point) * [1000, 1000, 1000, 1])
    assert np.allclose(family.plane, np.array(other.plane) * [1, 1, 1, 1000])


# --- robots ---------------------------------------------------------------------------------------------------------


def leg_of(kinds: str, r: Random, *, base: Vec | None = None, top: Vec | None = None) -> Limb:
    """A leg like "UPS" or "RPS" from a random point to another, the slider along it and actuated."""
    a, b = base or r.vector(), top or r.vector()
    middle = joint("P", direction=sub(b, a), actuated=True)
    u, v = r.vectors(2)
    ends = {"U": {"first": u, "second": v}, "R": {"axis": u}, "S": {}}
    first, _, last = kinds
    return limb(joint(first, point=a, **ends[first]), middle, joint(last, point=b, **ends[last]))


def delta(r: Random) -> list[Limb]:
    limbs = []
    for _ in range(3):
        a, e, d = r.vector(), *r.vectors(2)
        arm = joint("R", point=r.vector(), axis=e, actuated=True)
        limbs.append(limb(arm, joint("4S", first=a, second=add(a, e), bars=d)))
    return limbs


def schoenflies(r: Random) -> list[Limb]:
    limbs = []
    for _ in range(4):
        a, b, c, x = r.vector(), r.vector(), r.vector(), r.vectors(2)[0]
        first = joint("R", point=a, axis=Z, actuated=True)
        limbs.append(
            limb(first, joint("U", point=b, first=Z, second=x), joint("U", point=c, first=x, second=Z))
        )  # fmt: skip
    return limbs


def spherical(r: Random) -> list[Limb]:
    o = r.vector()
    legs = [[joint("R", point=o, axis=a, actuated=i == 0) for i, a in enumerate(r.vectors(3))] for _ in range(3)]
    return [limb(*leg) for leg in legs]


def planar(r: Random) -> list[Limb]:
    n = r.vector()
    legs = [[joint("R", point=r.vector(), axis=n, actuated=i == 0) for i in range(3)] for _ in range(3)]
    return [limb(*leg) for leg in legs]


def exechon(r: Random) -> list[Limb]:
    v = (0, r.nonzero(), r.nonzero())
    legs = []
    for a in ((-1, 0, 0), (1, 0, 0)):
        b = add(times(r.nonzero(), cross(X, v)), (r.scalar(), 0, 0))
        legs.append(limb(joint("U", point=a, first=X, second=v), joint("P", direction=sub(b, a), actuated=True),
                         joint("R", point=b, axis=v)))  # fmt: skip
    a, b = r.vector(), r.vector()
    third = limb(joint("S", point=a), joint("P", direction=sub(b, a), actuated=True), joint("R", point=b, axis=X))
    return [*legs, third]


def four_dof(r: Random) -> list[Limb]:
    """PS, UPS, PRPS: the robot of SinguLab2008."""
    one = limb(joint("P", direction=r.vector(), actuated=True), joint("S", point=r.vector()))
    a, s = r.vector(), r.vector()
    three = limb(
        joint("P", direction=r.vector(), actuated=True),
        joint("R", point=a, axis=r.vector()),
        joint("P", direction=sub(s, a), actuated=True),
        joint("S", point=s),
    )
    return [one, leg_of("UPS", r), three]


def sarrus(r: Random) -> list[Limb]:
    legs = [limb(*(joint("R", point=r.vector(), axis=e, actuated=i == 0) for i in range(3))) for e in r.vectors(2)]
    return [legs[0], limb(*(joint("R", **j.geometry) for j in legs[1].joints))]


def serial(r: Random) -> list[Limb]:
    return [limb(*(joint("R", point=r.vector(), axis=r.vector(), actuated=True) for _ in range(5)))]


# limbs, freedom of the platform, over-constraints, idle freedoms
ROBOTS: dict[str, tuple[Callable[[Random], list[Limb]], int, int, int]] = {
    "6-UPS": (lambda r: [leg_of("UPS", r) for _ in range(6)], 6, 0, 0),
    "6-SPS": (lambda r: [leg_of("SPS", r) for _ in range(6)], 6, 0, 6),
    "3-RPS": (lambda r: [leg_of("RPS", r) for _ in range(3)], 3, 0, 0),
    "3-UPU": (lambda r: [upu(r)[0] for _ in range(3)], 3, 0, 0),
    "Delta": (delta, 3, 0, 0),
    "4-RUU": (schoenflies, 4, 2, 0),
    "3-RRR spherical": (spherical, 3, 6, 0),
    "3-RRR planar": (planar, 3, 6, 0),
    "Tricept": (lambda r: [up(r)[0], *(leg_of("UPS", r) for _ in range(3))], 3, 0, 0),
    "Exechon": (exechon, 3, 2, 0),
    "PS, UPS, PRPS": (four_dof, 4, 0, 0),
    "Sarrus": (sarrus, 1, 1, 0),
    "serial arm": (serial, 5, 0, 0),
}


@fields
@pytest.mark.parametrize("name", ROBOTS)
def test_mobility_of_robots(name: str, field: Field) -> None:
    make, freedom, overconstraints, idle = ROBOTS[name]
    for seed in range(3):
        limbs = make(Random((name, seed)))
        found = mobility(limbs, field)
        assert (found.freedom, found.overconstraints, found.idle) == (freedom, overconstraints, idle)
        assert found.grubler + found.overconstraints == found.freedom + found.idle
        assert found.regular
        assert found.actuators == found.freedom
        assert found.free.dimension == 0
        together = limbs[0].system(field)
        for other in limbs[1:]:
            together &= other.system(field)
        assert found.twists.same(together)
        # The Jacobian: rates of the actuators for a motion of the platform, and nothing for the constraints.
        j = jacobian(limbs, field)
        assert j.rank() == 6
        assert len(j.labels) == found.actuators + sum(6 - rank for rank in found.ranks)
        for twist in found.twists.basis:
            rates = [product(row, twist, field) for row in field.rows(j.matrix)]
            assert rates[found.actuators :] == pytest.approx([0] * (len(rates) - found.actuators), abs=1e-9)
            assert any(rates[: found.actuators])
        if len(j.labels) == 6:
            assert j.determinant() != 0


def test_three_tetrahedra_of_the_robot_with_four_freedoms() -> None:
    """The wrenches with locked actuators are those of DESIGN: bundle, force, planar pencil."""
    one, two, three = four_dof(Random(5))
    kinds = [leg.locked_system().classify().kind for leg in (one, two, three)]
    assert kinds == ["bundle", "force", "planar pencil"]
    s = three.joints[-1].geometry["point"]
    a, e = (three.joints[1].geometry[part] for part in ("point", "axis"))
    assert three.locked_system() == ScrewSystem.span([turn(s, sub(s, a)), turn(s, e)])


@pytest.mark.parametrize("name", ["6-UPS", "Tricept"])
def test_singular_when_locked(name: str) -> None:
    """All platform joints in the plane of the base: the locked robot can still move."""
    r = Random(name)
    flat = [(*r.vector()[:2], 0) for _ in range(12)]
    number = {"6-UPS": 6, "Tricept": 3}[name]
    limbs = [leg_of("UPS", r, base=flat[2 * i], top=flat[2 * i + 1]) for i in range(number)]
    if name == "Tricept":
        limbs.append(limb(joint("U", point=O, first=X, second=Y), joint("P", direction=X)))
    found = mobility(limbs)
    assert not found.regular
    assert found.free.dimension == 6 - jacobian(limbs).rank() > 0
    assert jacobian(limbs, FLOATS).rank() == jacobian(limbs).rank()


# --- many configurations at once ------------------------------------------------------------------------------------

MANY = 12


def batch(limbs: list[Limb]) -> Limb:
    """One limb with arrays, of limbs with the same joints."""
    joints = []
    for same in zip(*(one.joints for one in limbs), strict=True):
        parts = {p: np.array([j.geometry[p] for j in same], dtype=float) for p in same[0].kind.parts}
        joints.append(joint(same[0].kind.symbol, actuated=same[0].actuated, **parts))
    return limb(*joints)


@pytest.mark.parametrize("name", LIMBS)
def test_many_configurations_are_those_one_by_one(name: str) -> None:
    limbs = [LIMBS[name](Random((name, seed)))[0] for seed in range(MANY)]
    together = batch(limbs)
    assert together.twists().shape == (MANY, limbs[0].freedoms, 6)
    assert together.rank().tolist() == [one.rank() for one in limbs]
    for i, one in enumerate(limbs):
        assert np.allclose(together.twists()[i], np.array(one.twists(FLOATS)))
        assert np.allclose(together.actuations()[i], one.actuations(FLOATS)) or not one.actuated
        for rows, system in (
            (together.locked()[i], one.locked_system(FLOATS)),
            (together.constraints()[i], one.constraint_system(FLOATS)),
        ):
            assert ScrewSystem.span(rows, FLOATS).same(system)


def test_jacobians_of_many_configurations() -> None:
    robots = [[leg_of("RPS", r) for _ in range(3)] for r in map(Random, range(MANY))]
    together = jacobian([batch(list(legs)) for legs in zip(*robots, strict=True)])
    assert together.matrix.shape == (MANY, 6, 6)
    assert together.rank().tolist() == [6] * MANY
    assert [str(label) for label in together.labels[2:4]] == ["3: actuation 0", "1: constraint 0"]
    for i, robot in enumerate(robots):
        one = jacobian(robot, FLOATS)
        assert abs(together.determinant()[i]) == pytest.approx(abs(one.determinant()))


def test_fixed_and_moving_parts_go_together() -> None:
    tops = np.random.default_rng(0).normal(size=(4, 5, 3))
    leg = limb(joint("R", point=O, axis=X), joint("P", direction=tops, actuated=True), joint("S", point=tops))
    other = limb(
        joint("U", point=X, first=Y, second=Z),
        joint("P", direction=(-1, 2, 3), actuated=True),
        joint("S", point=(0, 2, 3)),
    )
    j = jacobian([leg, other])
    assert j.matrix.shape == (4, 5, 3, 6)
    assert j.rank().shape == (4, 5)


def test_a_singular_configuration_among_others() -> None:
    """The axes of the second hinge become parallel: the limb loses a freedom, and one more wrench is left."""
    axes = np.array([[0.0, 0, 1], [0, 0.1, 1], [0, 1, 1], [1, 0, 0]])
    arm = limb(joint("R", point=(0.0, 0, 0), axis=Z, actuated=True), joint("R", point=(0.0, 0, 0), axis=axes))
    assert arm.rank().tolist() == [1, 2, 2, 2]
    assert arm.constraints().shape == (4, 4, 6)
    assert np.isnan(arm.actuations()[0]).all()
    assert np.isfinite(arm.actuations()[1:]).all()


# --- input at fault -------------------------------------------------------------------------------------------------

HINGE = {"point": O, "axis": Z}


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: joint("Q", point=O), "'Q' is no kind of joint"),
        (lambda: joint(["R"], point=O), "is no kind of joint"),
        (lambda: joint("R", point=O), "a joint R needs its axis"),
        (lambda: joint("R"), "needs its point and its axis"),
        (lambda: joint("R", **HINGE, pitch=1), "a joint R has no pitch"),
        (lambda: joint("R", point=O, axis=O), "the axis of a joint R is zero"),
        (lambda: joint("P", direction=(0.0, 0.0, 0.0)), "the direction of a joint P is zero"),
        (lambda: joint("P", direction=np.array([[1.0, 0, 0], [0, 0, 0]])), "is zero"),
        (lambda: joint("P", direction=(0, float("nan"), 1.0)), "is not finite"),
        (lambda: joint("P", direction=(0, 1.0, float("inf"))), "is not finite"),
        (lambda: joint("P", direction=(1.0, 10**400, 0)), "holds something that is no float"),
        (lambda: joint("P", direction=(1e61, 0, 0)), "is too large: over 1e+60"),
        (lambda: joint("R", point=np.ones((4, 3)), axis=np.ones((5, 3))), "of a joint R do not go together"),
        (lambda: joint("H", point=np.ones((4, 3)), axis=Z, pitch=np.ones(3)), "of a joint H do not go together"),
        (lambda: turn(np.ones((4, 3)), np.ones((5, 3))), "shapes (4,), (5,)"),
        (lambda: helix(np.ones((4, 3)), Z, np.ones(3)), "do not go together"),
        (lambda: product(np.ones((4, 6)), np.ones((5, 6))), "do not go together"),
        (lambda: moved(np.ones((4, 1, 6)), np.eye(3), np.ones((5, 3))), "do not go together"),
        (lambda: limb(*(joint("P", direction=np.ones((n, 3))) for n in (4, 5))).twists(), "the shapes (4,), (5,)"),
        (lambda: jacobian([limb(joint("P", direction=np.ones((n, 3)))) for n in (4, 5)]), "of the limbs do not go"),
        (lambda: joint("R", point=(0, 0), axis=Z), "the point of a joint R needs 3 coordinates, not 2"),
        (lambda: joint("R", point=(0.0, 0), axis=Z), "needs 3 coordinates along its last axis, not the shape (2,)"),
        (lambda: joint("R", point=3, axis=Z), "needs 3 coordinates"),
        (lambda: joint("R", point="abc", axis=Z), "needs 3 coordinates"),
        (lambda: joint("R", point=("a", 0, 0), axis=Z), "holds 'a', which is no number"),
        (lambda: joint("R", point=(None, 0.0, 0), axis=Z), "is not finite"),
        (lambda: joint("H", **HINGE, pitch="x"), "which is no number"),
        (lambda: joint("U", point=O, first=X, second=(2, 0, 0)), "the two axes of a joint U are parallel"),
        (lambda: joint("U", point=O, first=X, second=(1.0, 1e-12, 0)), "the two axes of a joint U are parallel"),
        (lambda: joint("Pa", bars=X, axis=X), "parallel to its axes"),
        (lambda: joint("4S", first=O, second=O, bars=X), "start at one point"),
        (lambda: joint("4S", first=O, second=X, bars=X), "lie on one line"),
        (lambda: joint("S", point=O, actuated=True), "cannot be actuated by itself"),
        (lambda: joint("E", point=O, normal=Z, actuated=0), "cannot be actuated by itself"),
        (lambda: joint("R", **HINGE, actuated=1), "has no freedom 1"),
        (lambda: joint("R", **HINGE, actuated=[-1]), "has no freedom -1"),
        (lambda: joint("R", **HINGE, actuated="x"), "has no freedom 'x'"),
        (lambda: joint("R", point=(0.5, 0, 0), axis=Z).twists(RATIONALS), "holds the float 0.5"),
        (lambda: joint("R", point=(0.5, 0, 0), axis=Z).twists(RESIDUES), "has no residue"),
        (lambda: joint("P", direction=(PRIME, 0, 0)).twists(RESIDUES), "is zero"),
        (limb, "a limb needs joints"),
        (lambda: limb("R"), "is no joint"),
        (lambda: jacobian([]), "there are no limbs"),
        (lambda: mobility(["UPS"]), "is no limb"),
        (lambda: jacobian([limb(joint("R", **HINGE, actuated=True))] * 2).determinant(), "12 rows"),
        (lambda: limb(*[joint("R", **HINGE, actuated=True)] * 2).actuations(), "depends on the others"),
        (lambda: batch([upu(Random(0))[0]] * 2).system(), "one configuration is needed"),
        (lambda: mobility([batch([upu(Random(0))[0]] * 2)]), "one configuration is needed"),
        (lambda: ScrewSystem.span([(1, 2, 3)]), "row 1 needs 6 coordinates, not 3"),
        (lambda: ScrewSystem.span([(1.0, 2, 3)]), "an array of shape (..., rows, 6) is needed"),
        (lambda: ScrewSystem.span([[1.0] * 6, [1.0] * 5]), "is no float"),
        (lambda: ScrewSystem.span(3), "rows of 6 numbers are needed"),
        (lambda: reciprocal([[math.nan] * 6]), "is not finite"),
        (lambda: pitch((0,) * 6), "six zeros are no screw"),
        (lambda: axis((0.0,) * 6), "six zeros are no screw"),
        (lambda: axis(np.ones((2, 6))), "the axis of one screw"),
        (lambda: line_through(np.ones((4, 4)), np.ones((5, 4))), "do not go together"),
        (lambda: turn(O, O), "a direction is zero"),
        (lambda: line_through((1, 2, 3, 1), (2, 4, 6, 2)), "two different points"),
        (lambda: moved([turn(O, X)], [X, Y, times(-1, Z)], O), "no orthogonal matrix of determinant 1"),
        (lambda: moved([turn(O, X)], [X, Y], O), "a rotation needs three rows"),
        (lambda: Residues(8), "no prime"),
        (lambda: Residues(13), "no prime"),
        (lambda: Floats(tolerance=0), "the tolerance 0 is not between 0 and 1"),
        (lambda: Floats(length=math.nan), "the length nan is not positive"),
    ],
)
def test_input_at_fault(make: Callable[[], Any], words: str) -> None:
    with pytest.raises(InputError) as fault:
        make()
    assert words in fault.value.message
    assert fault.value.exit_code == 2


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda seven: pitch((1, 2, 3, 1, 0, 0), seven), "a divisor is zero modulo 7"),  # 1 + 4 + 9 = 14
        (lambda seven: joint("P", direction=(Fraction(1, 7), 0, 0)).twists(seven), "a denominator is a multiple"),
        (lambda seven: seven.projection([(1, 2, 3)], (1, 0, 0)), "isotropic vectors"),
    ],
    ids=["divisor", "denominator", "isotropic"],
)
def test_bad_luck_modulo_a_small_prime(make: Callable[[Field], Any], words: str) -> None:
    with pytest.raises(LimitReached, match=words) as reached:
        make(Residues(7))
    assert reached.value.exit_code == 3


# --- the package ----------------------------------------------------------------------------------------------------


def test_numpy_is_loaded_for_floats_only() -> None:
    code = (
        "import sys; from gcrules.screws import joint, limb; leg = limb(joint('R', point=(0, 0, 0), axis=(0, 0, 1)));"
        "assert leg.system().classify().kind == 'force'; assert 'numpy' not in sys.modules;"
        "joint('R', point=(0.5, 0, 0), axis=(0, 0, 1)); assert 'numpy' in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_text_of_a_system() -> None:
    assert str(ScrewSystem.span([slide(X)])) == "1-system: couple along (1, 0, 0)"
    far = ScrewSystem.span([helix((0.0, 3, 0), X, 5)], Floats(length=10.0)).classify().screw
    assert far.pitch == pytest.approx(5)
    assert far.point == pytest.approx((0, 3, 0))


def test_values_can_be_hashed_and_compared() -> None:
    one, other = (rps(Random(1))[0] for _ in range(2))
    assert one == other
    assert len({one, other}) == len({one.locked_system(), other.locked_system()}) == 1
    assert str(one) == "RP\u0332S"
