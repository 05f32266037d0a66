"""Ten points on a quadric, beside the determinant of the products of their coordinates."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, islice

import pytest
from commands import invoke
from faults import refused

import gcrules as gc
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring import brackets
from gcrules.algebra.factoring.irreducible import irreducible
from gcrules.algebra.language.relations import parse_claim
from gcrules.algebra.language.syntax import parse
from gcrules.core.linear_algebra import determinant

NAMES = "abcdefghij"
WORDS = f"({', '.join(NAMES)})"
TEN = parse(f"quadric{WORDS}")

Vector = Sequence[int]


def products(p: Vector) -> list[int]:
    return [p[i] * p[k] for i, k in combinations_with_replacement(range(4), 2)]


def value(e: Expr, points: Mapping[str, Vector]) -> Fraction:
    return Fraction(Evaluator({n: tuple(p) for n, p in points.items()}, 4).value(e)[0])


def drawn(rng: random.Random, size: int = 9) -> list[int]:
    return [rng.randint(-size, size) for _ in range(4)]


def among(points: Sequence[Vector]) -> dict[str, Vector]:
    return dict(zip(NAMES, points, strict=True))


@pytest.mark.parametrize("seed", range(6))
def test_it_is_the_determinant(seed: int) -> None:
    rng = random.Random(seed)
    points = among([drawn(rng) for _ in NAMES])
    found = determinant((products(p) for p in points.values()), PRIME)
    assert value(TEN, points) % PRIME == found != 0


def hyperboloid(rng: random.Random) -> Iterator[Vector]:
    while True:
        s, t = rng.randint(-9, 9), rng.randint(-9, 9)
        yield s * t, 1, s, t


def cone(rng: random.Random) -> Iterator[Vector]:
    """Points of lines through (0, 0, 0, 1)."""
    while True:
        s, t = rng.randint(-9, 9), rng.randint(-9, 9)
        yield s * s, s * t, t * t, rng.randint(-9, 9)


def two_planes(rng: random.Random) -> Iterator[Vector]:
    while True:
        x, z, w, _ = drawn(rng)
        yield rng.choice([(x, 0, z, w), (x, x, z, w)])


def sphere(rng: random.Random) -> Iterator[Vector]:
    """x² + y² + z² = w²."""
    while True:
        a, b, c, d = drawn(rng, 5)
        yield 2 * (a * c + b * d), 2 * (b * c - a * d), c * c + d * d - a * a - b * b, a * a + b * b + c * c + d * d


@pytest.mark.parametrize("points_of", [hyperboloid, cone, two_planes, sphere])
def test_it_vanishes_for_points_of_a_quadric(points_of) -> None:  # type: ignore[no-untyped-def]
    rng = random.Random(points_of.__name__)
    frame = [drawn(rng) for _ in range(4)]
    points = points_of(rng)
    on = [[sum(c * e[k] for c, e in zip(p, frame, strict=True)) for k in range(4)] for p in islice(points, 10)]
    assert value(TEN, among(on)) == 0
    assert value(TEN, among([*on[:-1], drawn(rng)])) != 0


def test_its_terms() -> None:
    """Twelve products of five brackets, in which each point occurs twice, and 138 standard tableaux."""
    written, normal = gc.expand(TEN), gc.straighten(TEN)
    assert isinstance(written, BracketPolynomial)
    assert isinstance(normal, BracketPolynomial)
    assert {len(m) for m in (*written.terms, *normal.terms)} == {5}
    assert set((written.degrees() or {}).values()) == {2}
    assert len(written) == 12
    assert Counter(abs(c) for c in written.terms.values()) == {1: 12}
    assert Counter(abs(c) for c in normal.terms.values()) == {1: 116, 2: 16, 3: 6}
    assert gc.straighten(written) == normal


def test_every_exchange_of_two_points_changes_its_sign() -> None:
    for one, other in combinations(range(10), 2):
        order = list(NAMES)
        order[one], order[other] = order[other], order[one]
        assert gc.prove(f"quadric({', '.join(order)}) == -quadric{WORDS}").proved


def test_it_is_irreducible() -> None:
    """It vanishes where any two points coincide, so no four of them can be held: all move."""
    poly = gc.straighten(TEN)
    assert isinstance(poly, BracketPolynomial)
    assert irreducible(poly) is True


def test_no_division_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    """It vanishes where any two points coincide, but not where any four are in a plane."""
    poly = gc.straighten(TEN)
    assert isinstance(poly, BracketPolynomial)
    tried = list[object]()
    monkeypatch.setattr(brackets, "divided", lambda *args, **_: tried.append(args))
    assert brackets.bracket_factors(poly, limit=1_000) == ((), poly)
    assert not tried


def test_more_points_are_on_one_quadric_if_any_ten_are() -> None:
    claimed = parse_claim(f"on_quadric({', '.join(NAMES)}, k)")
    assert len(claimed.equations) == 11
    rng = random.Random(11)
    on = dict(zip((*NAMES, "k"), islice(hyperboloid(rng), 11), strict=True))
    assert not any(value(e, on) for e, _ in claimed.equations)
    assert any(value(e, on | {"k": (1, 2, 3, 4)}) for e, _ in claimed.equations)


def test_six_points_of_a_plane() -> None:
    """Both sides of the theorem where they are not zero."""
    right = parse("[ghij]([abcg][adeh][bdfi][cefj] - [abdg][aceh][bcfi][defj])")
    rng = random.Random(6)
    for _ in range(5):
        points = {n: (rng.randint(-9, 9), rng.randint(-9, 9), 0, rng.randint(1, 3)) for n in "abcdef"}
        points |= {n: (*drawn(rng)[:2], rng.randint(1, 9), rng.randint(1, 3)) for n in "ghij"}
        assert value(TEN, points) == value(right, points) != 0


CASES = [
    (f"on_quadric{WORDS}", "on_quadric(b, c, a, d, e, f, g, h, i, j)", "proved"),
    (f"on_quadric{WORDS}", "on_quadric(a, b, c, d, e, f, g, h, i, k)", "refuted"),
    (f"on_quadric{WORDS}", f"2 quadric{WORDS} == 3 quadric(b, a, c, d, e, f, g, h, i, j)", "proved"),
    (f"quadric Q, on_quadric({', '.join(NAMES)}, Q)", f"on_quadric{WORDS}", "proved"),
    (f"quadric Q, on_quadric({', '.join(NAMES[:9])}, Q)", f"on_quadric{WORDS}", "refuted"),
    ("collinear(a, b, c)", "", "refuted"),
    ("collinear(a, b, c), collinear(a, b, d)", "", "proved"),
    ("coplanar(a, b, c, d), coplanar(a, b, c, e), coplanar(f, g, h, i), coplanar(f, g, h, j)", "", "proved"),
    ("coplanar(a, b, c, d), coplanar(a, b, c, e), coplanar(f, g, h, i)", "", "refuted"),
]


@pytest.mark.parametrize(("given", "claim", "verdict"), CASES)
def test_claims(given: str, claim: str, verdict: str) -> None:
    found = gc.prove(claim or f"on_quadric{WORDS}", given=given)
    assert found.verdict == verdict


FAULTS = [
    ("show quadric(a, b, c, d, e, f, g, h, i, jk)", "a line (step 2) where a point is expected"),
    (f"rank 3 show quadric{WORDS}", "is a word of space (rank 4); this is rank 3"),
    ("claim on_quadric(a, b, c, d, e, f, g, h, i)", "takes at least 10 arguments, found 9"),
    (f"quadric Q show quadric({', '.join(NAMES[:9])}, Q)", "quadric(p, Q) takes 2 arguments, found 10"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_faults(text: str, message: str) -> None:
    refused(text, message)


@pytest.mark.parametrize(("text", "letter"), [("quadric(p, Q)", "quadric Q"), ("polar(p, K)", "conic K")])
def test_a_letter_that_is_not_declared(text: str, letter: str) -> None:
    done = invoke("expand", text, "--rank", "4" if "Q" in letter else "3")
    assert f"a letter that stands last is declared first: `{letter}`" in done.output
