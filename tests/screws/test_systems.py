"""Kinds of screw systems: tables, words, noise, and lines counted modulo a small prime."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from screws.random_screws import (
    FIELDS,
    Random,
    X,
    Y,
    Z,
    add,
    cross,
    span,
    times,
)

from gcrules.core.errors import LimitReached
from gcrules.poses.numbers.variety import variety
from gcrules.screws import (
    FLOATS,
    KINDS,
    RATIONALS,
    RESIDUES,
    Field,
    LineFamily,
    Residues,
    ScrewSystem,
    helical,
    moved,
    prismatic,
    product,
    revolute,
)

Vec = tuple[Any, ...]


# --- kinds of systems -----------------------------------------------------------------------------------------------

o, p, q = (0, 0, 0), (0, 0, 1), (0, 0, 2)
D = (1, 1, 0)
SYSTEMS: dict[str, tuple[list[Any], list[str]]] = {
    "nothing": ([], []),
    "force": ([revolute(q, X)], ["force"]),
    "couple": ([prismatic(X)], ["couple"]),
    "screw": ([helical(q, X, 2)], []),
    "planar pencil": ([revolute(q, X), revolute(q, Y)], ["planar pencil"]),
    "parallel pencil": ([revolute(q, X), revolute(p, X)], ["parallel pencil"]),
    "two couples": ([prismatic(X), prismatic(Y)], ["two couples"]),
    "two forces": ([revolute(q, X), revolute(o, Y)], ["force", "force"]),
    "force and couple": ([revolute(q, X), prismatic(D)], ["force", "couple"]),
    "force and screw": ([revolute(q, X), helical(q, Y, 1)], ["force"]),
    "couple and screw": ([prismatic(Y), helical(q, X, 1)], ["couple"]),
    "two screws": ([helical(q, X, 1), helical(q, Y, 2)], []),
    "bundle": ([revolute(q, a) for a in (X, Y, Z)], ["bundle"]),
    "parallel bundle": ([revolute(q, X), prismatic(Y), prismatic(Z)], ["parallel bundle"]),
    "plane field": ([revolute(q, X), revolute(q, Y), revolute(add(q, X), Y)], ["plane field"]),
    "all couples": ([prismatic(X), prismatic(Y), prismatic(Z)], ["all couples"]),
    "two planar pencils": ([revolute(o, Z), revolute(p, X), revolute(q, Y)], ["planar pencil"] * 2),
    "two parallel pencils": ([revolute(o, X), revolute(p, Y), prismatic(Z)], ["parallel pencil"] * 2),
    "planar pencil and couple": (
        [revolute(q, X), revolute(q, Y), prismatic(add(X, Z))],
        ["planar pencil", "parallel pencil"],
    ),
    "force and two couples": ([revolute(q, X), prismatic(X), prismatic(Y)], ["two couples", "parallel pencil"]),
    "planar pencil and screw": ([revolute(q, X), revolute(q, Y), helical(q, Z, 1)], ["planar pencil"]),
    "parallel pencil and screw": ([revolute(q, X), prismatic(Z), helical(q, Y, 1)], ["parallel pencil"]),
    "two couples and screw": ([prismatic(Y), prismatic(Z), helical(q, X, 1)], ["two couples"]),
    "force and two screws": ([revolute(q, X), helical(q, Y, 1), helical(q, Z, 2)], ["force"]),
    "couple and two screws": ([prismatic(Z), helical(q, X, 1), helical(q, Y, 2)], ["couple"]),
    "regulus": ([revolute(X, Y), revolute(Y, Z), revolute(Z, X)], []),
    "regulus with a couple": ([revolute(o, X), revolute(p, Y), revolute(q, D)], []),
    "three screws": ([helical(o, X, 1), helical(o, Y, 2), helical(o, Z, 3)], []),
    "bundle and plane field": ([*(revolute(q, a) for a in (X, Y, Z)), prismatic(Z)], ["bundle", "plane field"]),
    "parallel bundle and plane field": (
        [revolute(o, X), prismatic(Y), prismatic(Z), revolute(o, Y)],
        ["parallel bundle", "plane field"],
    ),
    "force and three couples": (
        [revolute(o, X), prismatic(X), prismatic(Y), prismatic(Z)],
        ["parallel bundle", "all couples"],
    ),
    "special complex": ([revolute(o, a) for a in (X, Y, Z)] + [revolute(p, X), revolute(p, Y)], []),
    "special complex with its axis at infinity": (
        [prismatic(X), prismatic(Y), prismatic(Z), revolute(o, X), revolute(o, Y)],
        [],
    ),
    "everything": ([revolute(o, a) for a in (X, Y, Z)] + [prismatic(a) for a in (X, Y, Z)], []),
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
        ([revolute(q, X)], "force along (1, 0, 0) through (0, 0, 2)"),
        ([prismatic(D)], "couple along (1, 1, 0)"),
        ([helical(q, X, Fraction(1, 2))], "screw with pitch 1/2 through (0, 0, 2) along (1, 0, 0)"),
        ([revolute(q, X), revolute(q, Y)], "planar pencil at (0, 0, 2) in the plane z = 2"),
        ([revolute(q, D), revolute(p, D)], "parallel pencil along (1, 1, 0) in the plane x - y = 0"),
        ([revolute(q, X), revolute((0, 2, 0), X)], "parallel pencil along (1, 0, 0) in the plane y + z = 2"),
        ([prismatic(X), prismatic(Y)], "two couples normal to (0, 0, 1)"),
        ([revolute(q, a) for a in (X, Y, Z)], "bundle at (0, 0, 2)"),
        ([revolute(q, X), prismatic(Y), prismatic(Z)], "parallel bundle along (1, 0, 0)"),
        ([revolute(q, X), revolute(q, Y), prismatic(Z)], "plane field in the plane z = 2"),
        ([prismatic(X), prismatic(Y), prismatic(Z)], "all couples"),
        (
            [revolute(q, X), prismatic(D)],
            "force and couple (force along (1, 0, 0) through (0, 0, 2); couple along (1, 1, 0))",
        ),
        (
            [*(revolute(q, a) for a in (X, Y, Z)), prismatic(Z)],
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
    rows = [helical(o, X, 1), helical(o, Y, -2)]
    exact, floats = ScrewSystem.span(rows).classify(), span(rows, FLOATS).classify()
    assert (exact.kind, exact.irrational, exact.families) == ("two forces", True, ())
    assert (floats.kind, floats.irrational, len(floats.families)) == ("two forces", False, 2)
    assert ScrewSystem.span([*rows, revolute(o, Z)]).classify().kind == "two planar pencils"
    assert ScrewSystem.span([*rows, prismatic(Z)]).classify().kind == "two parallel pencils"
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
