"""Claims decided in coordinates with respect to their own points: as the oracle decides at random points."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from math import lcm
from typing import Any

import pytest
from algebra.under_assumptions import THEOREMS, script_of
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES
from strategies import expressions
from sympy import QQ, ring

from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.frame import Frame, frame_of, zero_by
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.decide import about_points, decide
from gcrules.algebra.evaluate import PRIME, vanishes
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import ZERO, Bracket, Expr, Number, Point, add, mul, points_of, sub
from gcrules.algebra.language.statements import Claim, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.parts import substitute
from gcrules.algebra.prove import difference_of, prove
from gcrules.algebra.seated import seated
from gcrules.algebra.sparse import Polynomial, Ring
from gcrules.algebra.straightening.straighten import is_zero, straighten
from gcrules.core.errors import InputError, LimitReached

# --- polynomials ----------------------------------------------------------------------------------------------------

Terms = dict[tuple[int, ...], int | Fraction]
TERMS = st.dictionaries(
    st.tuples(*[st.integers(0, 3)] * 3), st.integers(-3, 3) | st.fractions(-2, 2, max_denominator=3), max_size=5
)


@settings(max_examples=60)
@given(TERMS, TERMS, TERMS, st.integers(-2, 2))
def test_arithmetic_of_polynomials(p: Terms, q: Terms, r: Terms, number: int) -> None:
    """As sympy's."""
    ours, theirs = Ring(12, 10_000), ring("x,y,z", QQ)[0]
    variables = [ours.variable(i) for i in range(3)]

    def both(terms: Terms) -> tuple[Polynomial, Any]:
        total = Polynomial(ours, {})
        for exponents, c in terms.items():
            monomial = c + Polynomial(ours, {})
            for v, n in zip(variables, exponents, strict=True):
                for _ in range(n):
                    monomial = monomial * v
            total = total + monomial
        return total, theirs.from_dict({m: QQ(c.numerator, c.denominator) for m, c in terms.items() if c})

    (a, x), (b, y), (c, z) = both(p), both(q), both(r)
    found, expected = (
        -(a * b - c * number) + (number - c) * a * number,
        -(x * y - z * number) + (number - z) * x * number,
    )
    exponents = [tuple(m >> (i * ours.width) & ((1 << ours.width) - 1) for i in range(3)) for m in found.terms]
    assert dict(zip(exponents, found.terms.values(), strict=True)) == dict(expected)
    assert bool(found) == bool(expected)


def test_polynomials_have_limits() -> None:
    ring = Ring(100, 5)
    x, y = ring.variable(0), ring.variable(1)
    with pytest.raises(LimitReached, match="the expansion in coordinates has more than 5 terms"):
        (x + y) * (x + 1) * (y + 1) * (x + y + 2)
    with pytest.raises(LimitReached, match="takes more than 100 products of terms"):
        sum((x + y) * (x + 1) for _ in range(30))


# --- any points -----------------------------------------------------------------------------------------------------


def anywhere(e: Expr, rank: int) -> Construction:
    names = points_of(e)
    return Construction(rank, names, (), points=names)


def decided(c: Construction, e: Expr) -> bool | None:
    frame = frame_of(c, e)
    return None if frame is None else frame.is_zero()


@settings(max_examples=150)
@given(st.data(), st.integers(2, 4))
def test_any_expression(data: st.DataObject, rank: int) -> None:
    e = data.draw(expressions(rank, depth=2, names=tuple("abcdefg")))
    try:
        assert decided(anywhere(e, rank), e) in (None, vanishes(e, rank=rank))
        zero = sub(e, straighten(expand(e, rank=rank), limit=2_000).to_expr(), rank=rank) if points_of(e) else ZERO
        assert decided(anywhere(zero, rank), zero) in (None, True)
    except LimitReached:
        return


@settings(max_examples=150)
@given(st.randoms(use_true_random=False), st.integers(2, 4))
def test_sums_of_products_of_brackets(rng: random.Random, rank: int) -> None:
    """Of the same degree in all points together, but not in each; true or false."""
    names = "abcdefgh"[: rank + rng.randint(1, 4)]
    products = [
        mul(Number(rng.choice((1, -1, 2))), *(Bracket(tuple(map(Point, rng.sample(names, rank)))) for _ in range(3)))
        for _ in range(rng.randint(1, 4))
    ]
    e = add(*products, rank=rank)
    zero = sub(e, straighten(expand(e, rank=rank)).to_expr(), rank=rank)
    for claim in (e, zero, add(zero, products[0], rank=rank)):
        if claim != ZERO:
            frame = frame_of(anywhere(claim, rank), claim)
            assert frame is not None
            scaled_as_it_says(frame, rng)
            assert frame.is_zero() == vanishes(claim, rank=rank)
    assert zero == ZERO or decided(anywhere(zero, rank), zero)


@pytest.mark.parametrize(
    ("text", "rank"),
    [("[abc][def] - [abc]", 3), ("[abc] d - a", 3), ("[abcd]**2 - [abcd] + 1", 4)],
)
def test_other_degrees_are_left_to_brackets(text: str, rank: int) -> None:
    e = parse(text, rank=rank)
    assert frame_of(anywhere(e, rank), e) is None


# --- points at infinity ---------------------------------------------------------------------------------------------


def with_ideal(e: Expr, ideal: tuple[str, ...], rank: int) -> Construction:
    order = tableau_order(points_of(e), (), ideal)
    return Construction(rank, order, tuple(n for n in order if n in ideal), points=order)


@settings(max_examples=200)
@given(st.randoms(use_true_random=False), st.integers(2, 4))
def test_sums_of_products_of_brackets_with_points_at_infinity(rng: random.Random, rank: int) -> None:
    """As at random points, and as brackets decide; any number of points at infinity, true or false claims."""
    names = "abcdefgh"[: rank + rng.randint(1, 4)]
    ideal = tuple(rng.sample(names, rng.randint(1, len(names) - 1)))
    products = [
        mul(Number(rng.choice((1, -1, 2))), *(Bracket(tuple(map(Point, rng.sample(names, rank)))) for _ in range(3)))
        for _ in range(rng.randint(1, 4))
    ]
    e = add(*products, rank=rank)
    zero = sub(e, straighten(expand(e, rank=rank, ideal=ideal)).to_expr(), rank=rank)
    for claim in (e, zero, add(zero, products[0], rank=rank)):
        if claim != ZERO:
            frame = frame_of(with_ideal(claim, ideal, rank), claim)
            assert frame is not None
            scaled_as_it_says(frame, rng)
            found = frame.is_zero()
            assert found == vanishes(claim, rank=rank, ideal=ideal)
            assert found == is_zero(claim, rank=rank, ideal=ideal)


@settings(max_examples=100)
@given(st.data(), st.integers(2, 4))
def test_any_expression_with_points_at_infinity(data: st.DataObject, rank: int) -> None:
    e = data.draw(expressions(rank, depth=2, names=tuple("abcdefg")))
    ideal = tuple(data.draw(st.sets(st.sampled_from("abcdefg"), max_size=5)))
    try:
        assert decided(with_ideal(e, ideal, rank), e) in (None, vanishes(e, rank=rank, ideal=ideal))
    except LimitReached:
        return


@pytest.mark.parametrize(
    ("text", "ideal", "rank", "base", "at_infinity", "zero"),
    [
        # Fewer than the rank: they are points like the others.
        ("[abi][cdj] - [abj][cdi]", "ij", 3, 3, "", False),
        ("[abi][cdj] - [abj][cdi] - [cdj][abi] + [abj][cdi]", "ij", 3, 3, "", True),
        # Three points at infinity are on a line, four are in a plane.
        ("[ijk][abc]", "ijk", 3, 3, "k", True),
        ("[aij][bjk] - [ajk][bij]", "ijk", 3, 3, "k", True),
        ("[aij][bjk] + [ajk][bij]", "ijk", 3, 3, "k", False),
        ("[ijka][lbcd] - [ijla][kbcd] + [ikla][jbcd] - [jkla][ibcd]", "ijkl", 4, 4, "l", True),
        ("[ijka][lbcd] - [ijla][kbcd] + [ikla][jbcd] + [jkla][ibcd]", "ijkl", 4, 4, "l", False),
        ("[ijkl][abcd] + [ijkm][abcd]", "ijklm", 4, 4, "lm", True),
    ],
)
def test_points_at_infinity(text: str, ideal: str, rank: int, base: int, at_infinity: str, zero: bool) -> None:
    e = parse(text, rank=rank)
    if not points_of(e):
        assert zero
        return
    frame = frame_of(with_ideal(e, tuple(ideal), rank), e)
    assert frame is not None
    assert len(frame.base) == base
    assert len(frame.at_infinity) == len(at_infinity)
    assert set(ideal[: rank - 1]) <= {*frame.base, *frame.at_infinity}
    assert frame.is_zero() == zero == vanishes(e, rank=rank, ideal=ideal)


def test_their_last_coordinate_is_zero() -> None:
    e = parse("[ajk][bil] - [bjk][ail]", rank=3)
    frame = frame_of(with_ideal(e, tuple("ijkl"), 3), e)
    assert frame is not None
    (known,), others = frame.base[2:], frame.others
    assert {known, *others[:1]} == {"a", "b"}
    assert frame.others[1:] == frame.at_infinity
    assert frame.numbers == 3 + 2 * 2


def test_scaling_takes_no_value_that_matters() -> None:
    """Both terms are 1 where c and d are (1, 1); but they have different degrees in these points, and d stays free."""
    e = parse("[ab][ac] - [ab][ad]", rank=2)
    frame = frame_of(anywhere(e, 2), e)
    assert frame is not None
    assert (frame.base, frame.unit, frame.variables) == (("a", "b"), "c", (2, 3))
    assert not frame.is_zero()


def scaled_as_it_says(frame: Frame, rng: random.Random) -> None:
    """Where the numbers are multiplied by powers of a factor, so is the expression: by the square for the square."""
    for exponents in frame.scalings:
        times = lcm(*(x.denominator for x in exponents))
        whole = [int(times * x) for x in exponents]
        factor, numbers = rng.randrange(2, PRIME), [rng.randrange(1, PRIME) for _ in exponents]
        once, twice, thrice = (
            frame.value([n * pow(factor, k * e, PRIME) % PRIME for n, e in zip(numbers, whole, strict=True)], PRIME)
            for k in (0, 1, 2)
        )
        assert all(x * z % PRIME == y * y % PRIME for x, y, z in zip(once, twice, thrice, strict=True))


# --- constructions --------------------------------------------------------------------------------------------------


def mutated(e: Expr, rank: int, names: list[str], rng: random.Random) -> Expr:
    """With one point in place of another one."""
    old, new = rng.choice(points_of(e)), rng.choice(names)
    return substitute(e, {old: Point(new)}, rank)


def agree(at: Context, claim: Expr, rank: int) -> int:
    """In how many kinds of positions it was decided; wherever it was, as at random points."""
    found, rng = 0, random.Random(1)
    for kind in kinds(at, points_of(claim), (claim,)):
        frame = frame_of(kind.construction, claim)
        if frame is not None:
            found += 1
            scaled_as_it_says(frame, rng)
            assert frame.is_zero() == kind.construction.vanishes(claim, samples=3)
    return found


@pytest.mark.parametrize("name", THEOREMS)
def test_theorems_their_siblings_and_mutations(name: str) -> None:
    text, *claims = THEOREMS[name]
    at, rng = script_of(text), random.Random(name)
    for claim in claims:
        left, right = parse_equation(claim, context=at)
        difference = difference_of(left, right, at.rank)
        agree(at, difference, at.rank)
        names = sorted({n for a in at.given for e in a.args for n in points_of(e)} | set(points_of(difference)))
        for _ in range(3):
            try:
                other = mutated(difference, at.rank, names, rng)
            except InputError:
                continue
            if points_of(other):
                agree(at, other, at.rank)


LINE = "rank 3 points a b c d o given collinear(a, b, c, d)"
QUADRANGLE = "rank 3 points a b c d p q given incident(p, ab), incident(p, cd), collinear(a, p, q)"
MODULI = [
    # assumptions, a claim that is false although it holds for some values, how many numbers the positions depend on
    (LINE, "[aco][bdo] == [ado][bco]", 1),
    (LINE, "[aco][bdo] == -[ado][bco]", 1),
    (LINE, "[aco][bdo] == 2 [ado][bco]", 1),
    (QUADRANGLE, "[acq][pbd] == [pcq][abd]", 1),
    (QUADRANGLE, "[acq][pbd] == -[pcq][abd]", 1),
    ("rank 2", "[ac][bd] == [ad][bc]", 1),
    ("rank 2", "[ac][bd] == -[ad][bc]", 1),
    ("rank 3 given m == a + b", "[amc] == 2 [bmc]", 0),
    ("rank 3 let m = a + b given collinear(m, c, d)", "[abd] == [abc]", 1),
    ("rank 3 let m = a + b given collinear(a, b, c)", "[mcd] == [acd]", 1),
    ("rank 2 let m = a + b let n = a - b", "[mc][nd] == 2 [md][nc]", 2),
]


@pytest.mark.parametrize(("text", "claim", "numbers"), MODULI)
def test_as_many_variables_as_positions_have_invariants(text: str, claim: str, numbers: int) -> None:
    at = script_of(text)
    difference = difference_of(*parse_equation(claim, context=at), at.rank)
    (kind,) = kinds(at, points_of(difference), (difference,))
    frame = frame_of(kind.construction, difference)
    assert frame is not None
    assert len(frame.variables) == numbers
    scaled_as_it_says(frame, random.Random(1))
    assert not frame.is_zero()


def examples() -> Iterator[tuple[str, Claim]]:
    for path in sorted((EXAMPLES / "theorems").rglob("*.gca")):
        script = parse_script(path.read_text(encoding="utf-8"), str(path))
        for i, claim in enumerate(s for s in script.statements if isinstance(s, Claim)):
            yield f"{path.parent.name}/{path.stem}-{i + 1}", claim


CLAIMS = dict(examples())


@pytest.mark.parametrize("name", CLAIMS)
def test_examples_are_decided_in_a_frame_too(name: str) -> None:
    claimed, at = CLAIMS[name].claimed, CLAIMS[name].context
    tangents = any(w.kind == "touches" for a in at.given for w in a.written)
    by_points = about_points(claimed, at) if tangents else None  # as they are proved
    placed = seated(*(by_points or (claimed, at)))
    for left, right in placed.claimed.equations:
        assert agree(placed.space, difference_of(left, right, at.rank), at.rank)


# --- which way ------------------------------------------------------------------------------------------------------


def test_the_answer_names_the_points() -> None:
    claim = CLAIMS["theorems/double-six-4"]
    proof = decide(claim.claimed, claim.context)
    assert (proof.verdict, proof.method) == ("proved", "frame")
    assert re.fullmatch(
        r"both sides are the same polynomial in coordinates in which (p\d|q\d), (p\d|q\d), (p\d|q\d) and (p\d|q\d) are "
        r"the basis, at all points that satisfy the assumptions",
        proof.reason,
    )


def test_the_answer_names_the_unit_point() -> None:
    claim = CLAIMS["theorems/five-lines-1"]
    proof = decide(claim.claimed, claim.context)
    assert (proof.verdict, proof.method) == ("proved", "frame")
    assert proof.reason == (
        "both sides are the same polynomial in coordinates in which a1, a2, a3 and a4 are the basis and a5 is their sum"
    )


def test_a_conic_of_five_points_in_a_construction_with_other_points() -> None:
    """Miquel's theorem with the conics as they are; only a frame decides it."""
    at = script_of(
        "rank 3 points i j a b c m p q r given collinear(a, b, r), collinear(a, c, q), collinear(b, c, p)"
        "given [aqi][rmi][amj][rqj] == [ami][rqi][aqj][rmj] given [bpi][rmi][bmj][rpj] == [bmi][rpi][bpj][rmj]"
    )
    claim = parse_equation("[cqi][pmi][cmj][qpj] == [cmi][qpi][cqj][pmj]", context=at)
    proof = prove(*claim, rank=3, points=at.points, given=at.given)
    assert proof.verdict == "proved"
    assert proof.reason == (
        "both sides are the same polynomial in coordinates in which points of the construction are the basis, "
        "at all points that satisfy the assumptions"
    )


def asked(limits: list[int], enough: int) -> Callable[[int], bool]:
    """Brackets that decide that something is zero within so many terms."""

    def brackets(limit: int) -> bool:
        limits.append(limit)
        if limit < enough:
            raise LimitReached(f"more than {limit} terms")
        return True

    return brackets


def test_brackets_come_first_then_a_frame_then_brackets_again() -> None:
    e = parse("[abc][def] - [dbc][aef] - [adc][bef] - [abd][cef]", rank=3)
    uneven = parse("[abc][def] - [abc]", rank=3)
    limits: list[int] = []
    assert zero_by(anywhere(e, 3), e, asked(limits, 10), 100_000) is True
    found = zero_by(anywhere(e, 3), e, asked(limits, 5_000), 100_000)
    assert isinstance(found, Frame)
    assert zero_by(anywhere(uneven, 3), uneven, asked(limits, 5_000), 100_000) is True
    assert limits == [1_000, 1_000, 1_000, 100_000]
    with pytest.raises(LimitReached, match="more than 5 terms"):
        zero_by(anywhere(e, 3), e, asked(limits, 5_000), 5)
    false = parse("[abc][def] - [abd][cef]", rank=3)
    assert zero_by(anywhere(false, 3), false, asked(limits, 5_000), 100_000) is False
