"""Screws against incidence: conventions, single screws, what no motion may change, faults."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from screws.random_screws import (
    LIMBS,
    O,
    Random,
    X,
    Y,
    Z,
    cross,
    dot,
    fields,
    leg_of,
    quaternion,
    rps,
    span,
    sub,
    times,
    upu,
)

from gcrules.algebra.evaluate import PRIME, evaluate, random_points, random_rational_points
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import InputError, LimitReached
from gcrules.screws import (
    FLOATS,
    RATIONALS,
    RESIDUES,
    Field,
    Floats,
    Limb,
    Residues,
    ScrewSystem,
    axis,
    from_plucker,
    helical,
    jacobian,
    joint,
    limb,
    line_through,
    mobility,
    moved,
    pitch,
    plucker,
    prismatic,
    product,
    reciprocal,
    revolute,
)
from gcrules.screws.margin import jacobian as leg_jacobian

Vec = tuple[Any, ...]


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
            assert wrench == revolute(a, sub(b, a))
            assert pitch(wrench) == 0


def test_a_couple_is_a_line_at_infinity() -> None:
    assert line_through((*X, 0), (*Y, 0)) == prismatic(Z)
    assert pitch(prismatic(Z)) == math.inf


def test_product_is_the_bracket_of_the_points() -> None:
    for seed in range(50):
        points = random_rational_points("abcd", seed=seed, ideal="d" if seed % 3 == 0 else "")
        one, other = line_through(points["a"], points["b"]), line_through(points["c"], points["d"])
        assert product(one, other) == -evaluate(parse("[abcd]"), points)
    points = random_points("abcd", seed=1)
    one, other = (line_through(points[a], points[b], RESIDUES) for a, b in ("ab", "cd"))
    assert product(one, other, RESIDUES) == -evaluate(parse("[abcd]"), points, modulus=PRIME) % PRIME


def test_lines_that_meet_are_reciprocal() -> None:
    r = Random("meet")
    for _ in range(50):
        p, q, d, e = r.vector(), r.vector(), r.vector(), r.vector()
        assert product(revolute(p, d), revolute(p, e)) == 0  # in a point
        assert product(revolute(p, d), revolute(q, times(r.nonzero(), d))) == 0  # parallel
        assert (product(revolute(p, d), revolute(q, e)) == 0) == (dot(sub(q, p), cross(d, e)) == 0)
        assert product(revolute(p, d), prismatic(e)) == dot(d, e)


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
        rows = [revolute(points[p][:3], sub(points[q], points[p])[:3]) for p, q in lines]
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
        found = axis(helical(p, d, h))
        assert found.pitch == pitch(helical(p, d, h)) == h
        assert found.direction == d
        assert cross(sub(found.point, p), d) == (0, 0, 0)
        assert dot(found.point, d) == 0
        floating = axis(tuple(map(float, helical(p, d, h))))
        assert floating.pitch == pytest.approx(float(h), abs=1e-12)
        assert floating.point == pytest.approx(tuple(map(float, found.point)), abs=1e-12)
    assert axis(prismatic(X)) == type(found)(None, X, math.inf)


def test_pitch_of_many_screws() -> None:
    rows = np.array([helical(X, Z, 0.5), prismatic((1.0, 0, 0)), revolute(Y, (0.0, 0, 2))])
    assert pitch(rows).tolist() == [0.5, math.inf, 0]
    points = np.random.default_rng(0).normal(size=(7, 3))
    lines = revolute(points, (1.0, 2, 0))
    assert np.allclose(from_plucker(plucker(lines)), lines)
    ends = np.hstack([points, np.ones((7, 1))])
    assert np.allclose(line_through(ends, ends + np.array([1.0, 2, 0, 0])), lines)
    assert np.allclose(pitch(helical(points, (0.0, 1, 1), 3.0)), 3)


@settings(max_examples=30)
@given(seed=st.integers(0, 10**6))
def test_a_motion_keeps_products_and_pitches(seed: int) -> None:
    r = Random(seed)
    rows = [helical(r.vector(), r.vector(), r.scalar()) for _ in range(2)]
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


# --- the wrenches of limbs ------------------------------------------------------------------------------------------

Lines = tuple[Limb, list[Any], str]


# --- properties -----------------------------------------------------------------------------------------------------

SMALL = st.integers(-2, 2)
ROWS = st.lists(st.tuples(*[SMALL] * 6), max_size=6)
LINES = st.lists(
    st.builds(lambda a, w: line_through((*a, w), (1, 3, -1, 1)), st.tuples(st.just(1), SMALL, SMALL), st.integers(0, 1))
    | st.builds(lambda a: prismatic(a), st.tuples(SMALL, SMALL, st.just(1)))
    | st.builds(lambda a, b: revolute(a, b), st.tuples(*[SMALL] * 3), st.tuples(st.just(1), SMALL, SMALL)),
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
        (lambda: joint("Q", point=O), "'Q' is not a kind of joint"),
        (lambda: joint(["R"], point=O), "is not a kind of joint"),
        (lambda: joint("R", point=O), "a joint R needs its axis"),
        (lambda: joint("R"), "needs its point and its axis"),
        (lambda: joint("R", **HINGE, pitch=1), "a joint R has no pitch"),
        (lambda: joint("R", point=O, axis=O), "the axis of a joint R is zero"),
        (lambda: joint("P", direction=(0.0, 0.0, 0.0)), "the direction of a joint P is zero"),
        (lambda: joint("P", direction=np.array([[1.0, 0, 0], [0, 0, 0]])), "is zero"),
        (lambda: joint("P", direction=(0, float("nan"), 1.0)), "is not finite"),
        (lambda: joint("P", direction=(0, 1.0, float("inf"))), "is not finite"),
        (lambda: joint("P", direction=(1.0, 10**400, 0)), "holds something that is not a float"),
        (lambda: joint("P", direction=(1e61, 0, 0)), "is too large: over 1e+60"),
        (lambda: joint("R", point=np.ones((4, 3)), axis=np.ones((5, 3))), "of a joint R do not go together"),
        (lambda: joint("H", point=np.ones((4, 3)), axis=Z, pitch=np.ones(3)), "of a joint H do not go together"),
        (lambda: revolute(np.ones((4, 3)), np.ones((5, 3))), "shapes (4,), (5,)"),
        (lambda: helical(np.ones((4, 3)), Z, np.ones(3)), "do not go together"),
        (lambda: product(np.ones((4, 6)), np.ones((5, 6))), "do not go together"),
        (lambda: moved(np.ones((4, 1, 6)), np.eye(3), np.ones((5, 3))), "do not go together"),
        (lambda: limb(*(joint("P", direction=np.ones((n, 3))) for n in (4, 5))).twists(), "the shapes (4,), (5,)"),
        (lambda: jacobian([limb(joint("P", direction=np.ones((n, 3)))) for n in (4, 5)]), "of the limbs do not go"),
        (lambda: joint("R", point=(0, 0), axis=Z), "the point of a joint R needs 3 coordinates, not 2"),
        (lambda: joint("R", point=(0.0, 0), axis=Z), "needs 3 coordinates along its last axis, not the shape (2,)"),
        (lambda: joint("R", point=3, axis=Z), "needs 3 coordinates"),
        (lambda: joint("R", point="abc", axis=Z), "needs 3 coordinates"),
        (lambda: joint("R", point=("a", 0, 0), axis=Z), "holds 'a', which is not a number"),
        (lambda: joint("R", point=(None, 0.0, 0), axis=Z), "is not finite"),
        (lambda: joint("H", **HINGE, pitch="x"), "which is not a number"),
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
        (lambda: limb("R"), "is not a joint"),
        (lambda: jacobian([]), "there are no limbs"),
        (lambda: mobility(["UPS"]), "is not a limb"),
        (lambda: jacobian([limb(joint("R", **HINGE, actuated=True))] * 2).determinant(), "12 rows"),
        (lambda: limb(*[joint("R", **HINGE, actuated=True)] * 2).actuations(), "depends on the others"),
        (lambda: batch([upu(Random(0))[0]] * 2).system(), "one configuration is needed"),
        (lambda: mobility([batch([upu(Random(0))[0]] * 2)]), "one configuration is needed"),
        (lambda: ScrewSystem.span([(1, 2, 3)]), "row 1 needs 6 coordinates, not 3"),
        (lambda: ScrewSystem.span([(1.0, 2, 3)]), "an array of shape (..., rows, 6) is needed"),
        (lambda: ScrewSystem.span([[1.0] * 6, [1.0] * 5]), "is not a float"),
        (lambda: ScrewSystem.span(3), "rows of 6 numbers are needed"),
        (lambda: reciprocal([[math.nan] * 6]), "is not finite"),
        (lambda: pitch((0,) * 6), "six zeros are not a screw"),
        (lambda: axis((0.0,) * 6), "six zeros are not a screw"),
        (lambda: axis(np.ones((2, 6))), "the axis of one screw"),
        (lambda: line_through(np.ones((4, 4)), np.ones((5, 4))), "do not go together"),
        (lambda: revolute(O, O), "a direction is zero"),
        (lambda: line_through((1, 2, 3, 1), (2, 4, 6, 2)), "two different points"),
        (lambda: moved([revolute(O, X)], [X, Y, times(-1, Z)], O), "not an orthogonal matrix of determinant 1"),
        (lambda: moved([revolute(O, X)], [X, Y], O), "a rotation needs three rows"),
        (lambda: Residues(8), "not a prime"),
        (lambda: Residues(13), "not a prime"),
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
    assert str(ScrewSystem.span([prismatic(X)])) == "1-system: couple along (1, 0, 0)"
    far = ScrewSystem.span([helical((0.0, 3, 0), X, 5)], Floats(length=10.0)).classify().screw
    assert far.pitch == pytest.approx(5)
    assert far.point == pytest.approx((0, 3, 0))


def test_values_can_be_hashed_and_compared() -> None:
    one, other = (rps(Random(1))[0] for _ in range(2))
    assert one == other
    assert len({one, other}) == len({one.locked_system(), other.locked_system()}) == 1
    assert str(one) == "RP\u0332S"


@pytest.mark.parametrize("seed", range(6))
def test_turned_platforms_have_the_margins_of_their_jacobians(seed: int) -> None:
    """The bounds that are proved around a pose rest on the short way; the long one makes every leg anew."""
    rng = np.random.default_rng(seed)
    base, ends = rng.normal(size=(6, 3)), rng.normal(size=(6, 3)) + np.array([0.0, 0.0, 3.0])
    here = leg_jacobian(base, ends[None])
    turns = np.linalg.qr(rng.normal(size=(20, 3, 3)))[0]
    turns *= np.sign(np.linalg.det(turns))[:, None, None]
    sigma, lengths = here.turned(turns, base)
    centre = ends.mean(axis=0)
    long = leg_jacobian(base, (ends - centre) @ np.swapaxes(turns, 1, 2) + centre)
    assert np.allclose(sigma, long.sigma, atol=1e-12)
    assert (sigma <= long.sigma + 1e-15).all(), "never too large"
    assert np.allclose(lengths, long.lengths, rtol=1e-12)
