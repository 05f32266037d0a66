"""Superbrackets: both forms are the determinant, the shortest counts are those of the data, signs are as documented."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction
from itertools import combinations, permutations
from math import comb
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from platform_classes import CLASSES

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, evaluate, random_points, random_rational_points
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Number, join, mul, sub
from gcrules.algebra.parts import substitute
from gcrules.algebra.scalars import superbracket
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.superbrackets.determinant import determinant_terms
from gcrules.algebra.superbrackets.shortest import SAME, Line, counts, shortest_forms, superbracket_form
from gcrules.algebra.superbrackets.superbracket import FORMS, form_terms
from gcrules.core.errors import LimitReached, StepError
from gcrules.core.linear_algebra import permutation_sign
from gcrules.views.formulas.latex import latex

ALL = pytest.mark.parametrize("facts", CLASSES, ids=[c["id"] for c in CLASSES])


def determinant(rows: list[list[int]], modulus: int) -> int:
    """By elimination; shares nothing with the package."""
    rows, value = [list(r) for r in rows], 1
    for i in range(len(rows)):
        pivot = next((r for r in range(i, len(rows)) if rows[r][i] % modulus), None)
        if pivot is None:
            return 0
        if pivot != i:
            rows[i], rows[pivot], value = rows[pivot], rows[i], -value
        value = value * rows[i][i] % modulus
        inverse = pow(rows[i][i], -1, modulus)
        for r in range(i + 1, len(rows)):
            factor = rows[r][i] * inverse % modulus
            rows[r] = [(x - factor * y) % modulus for x, y in zip(rows[r], rows[i], strict=True)]
    return value % modulus


PAIRS = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]


def lines_determinant(lines: list[Line], points: dict[str, tuple[int, ...]]) -> int:
    rows = [[points[a][i] * points[b][j] - points[a][j] * points[b][i] for i, j in PAIRS] for a, b in lines]
    return determinant(rows, PRIME)


@st.composite
def legs(draw: st.DrawFn) -> list[Line]:
    letters = "abcdefghijkl"[: draw(st.integers(4, 12))]
    pair = st.lists(st.sampled_from(letters), min_size=2, max_size=2, unique=True).map(lambda p: (p[0], p[1]))
    return draw(st.lists(pair, min_size=6, max_size=6))


def names(lines: list[Line]) -> list[str]:
    return sorted({n for line in lines for n in line})


@given(legs(), st.permutations(range(6)), st.sampled_from(FORMS), st.sets(st.sampled_from("abcd")))
def test_forms_are_the_determinant(lines: list[Line], order: list[int], form: int, ideal: set[str]) -> None:
    points = random_points(names(lines), ideal=ideal)
    found = superbracket_form(lines, order, form, ideal=sorted(ideal))
    value = evaluate(found.polynomial.to_expr(), points, modulus=PRIME)
    assert value == found.sign * lines_determinant(lines, points) % PRIME
    assert found.sign == permutation_sign(order)


@pytest.mark.parametrize("form", FORMS)
def test_twelve_points(form: int) -> None:
    lines = [("a", "b"), ("c", "d"), ("e", "f"), ("g", "h"), ("i", "j"), ("k", "l")]
    assert len(form_terms(form)) == form == len(superbracket_form(lines, form=form).polynomial)
    points = random_points("abcdefghijkl", seed=3)
    determinant = lines_determinant(lines, points)
    assert determinant
    assert evaluate(superbracket_form(lines, form=form).polynomial.to_expr(), points, modulus=PRIME) == determinant


def test_force_and_moment() -> None:
    """The superbracket is minus the determinant of the rows (force; moment)."""
    lines = [("a", "b"), ("c", "d"), ("e", "f"), ("g", "h"), ("i", "j"), ("k", "l")]
    points = random_rational_points("abcdefghijkl", seed=2)
    rows = []
    for a, b in lines:
        (x, y, z, _), (u, v, w, _) = points[a], points[b]
        fx, fy, fz = u - x, v - y, w - z
        rows.append([fx, fy, fz, y * fz - z * fy, z * fx - x * fz, x * fy - y * fx])
    text = "[[ab, cd, ef, gh, ij, kl]]"
    assert gc.evaluate(text, points) % PRIME == -determinant(rows, PRIME) % PRIME != 0


@ALL
@pytest.mark.parametrize("exchanged", [False, True], ids=["as given", "bodies exchanged"])
def test_shortest_counts(facts: dict[str, Any], exchanged: bool) -> None:
    lines = [(b, a) if exchanged else (a, b) for a, b in facts["legs"]]
    random.Random(facts["id"]).shuffle(lines)
    found = counts(lines)
    assert {form: min(n) for form, n in found.items()} == {24: facts["terms24"], 16: facts["terms16"]}
    assert all(sum(n.values()) == 720 for n in found.values())


@ALL
def test_the_shortest_form(facts: dict[str, Any]) -> None:
    lines = [(a, b) for a, b in facts["legs"]]
    first, *others = forms = shortest_forms(lines)
    least = min(facts["terms24"], facts["terms16"])
    assert all(len(f.polynomial) == least for f in forms)
    assert first.form == (24 if facts["terms24"] == least else 16)
    assert shortest_forms(lines) == (first, *others)
    points = random_points(names(lines), seed=9)
    expected = lines_determinant(lines, points)
    for f in forms:
        assert evaluate(f.polynomial.to_expr(), points, modulus=PRIME) == f.sign * expected % PRIME
    assert bool(first.polynomial) == facts["regular"]


@pytest.mark.parametrize("class_id", ["6-5", "5-5.1", "4-4.4", "3-3.3", "6-3.1"])
def test_counts_against_a_plain_loop(class_id: str) -> None:
    lines = next([(a, b) for a, b in c["legs"]] for c in CLASSES if c["id"] == class_id)
    for form, found in counts(lines).items():
        forms = [superbracket_form(lines, order, form) for order in permutations(range(6))]
        assert found == Counter(len(f.polynomial) for f in forms)
        least = [f.polynomial.terms for f in forms if len(f.polynomial) == min(found)]
        shortest = shortest_forms(lines, forms=[form])
        different = {frozenset({frozenset(p.items()), frozenset((m, -c) for m, c in p.items())}) for p in least}
        assert len(different) == len(shortest)
        assert shortest[0] == next(f for f in forms if len(f.polynomial) == min(found))


@pytest.mark.parametrize("form", FORMS)
def test_the_orders_with_the_same_terms(form: int) -> None:
    """The written list has all of them and no other."""
    lines = [(a, b) for a, b in ("ab", "cd", "ef", "gh", "ij", "kl")]
    forms = {order: superbracket_form(lines, order, form).polynomial.terms for order in permutations(range(6))}
    first = forms[0, 1, 2, 3, 4, 5]
    same = [o for o, terms in forms.items() if terms in (first, {m: -c for m, c in first.items()})]
    assert ["".join(map(str, o)) for o in same] == SAME[form].split()


EXAMPLES = [
    ("[[ab,af,cb,cd,ed,ef]]", "[abfc][acde][bdef] + [abfd][acbe][cdef]"),
    ("[[ab,af,cb,cd,ed,ef]]", r"ace /\ abf /\ cbd /\ edf"),
    ("[[ab,af,cb,cd,ed,ef]]", r"bdf /\ acb /\ ced /\ eaf"),
    ("[[Aa,Ab,Bc,Bd,Ce,Cf]]", r"-(Aab /\ Bcd /\ Cef /\ ABC)"),
    ("[[Aa,Ab,Ac,Bd,Be,Cf]]", "[Aabc][ABde][ABCf]"),
    ("[[Aa,Ab,Ac,Bd,Ce,Df]]", "-[Aabc]([ABdC][AeDf] - [ABde][ACDf])"),
    ("[[Aa,Ab,Ba,Bb,Cc,Dd]]", r"-[ABab]((AB /\ Cc)(ab /\ Dd) - (AB /\ Dd)(ab /\ Cc))"),
    ("[[S1A1,S1B1,S1C1,S2A2,S3A3,S3B3]]", "[S1A1B1C1][S1S3A3B3][S1S3S2A2]"),
    (r"((A \/ gh) /\ (A \/ kl) /\ ab) * [[Aa,Ab,Bc,Bd,gh,kl]]",
     r"-(((gh /\ Aab) \/ (kl /\ Aab)) /\ Bcd /\ (((A \/ gh) /\ (A \/ kl)) \/ B))"),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right"), EXAMPLES)
def test_examples_with_their_signs(left: str, right: str) -> None:
    assert gc.prove(left, right).verdict == "proved"
    assert gc.prove(left, f"-({right})").verdict == "refuted"


def test_order_and_number_of_terms_of_the_octahedron() -> None:
    legs = "ab af cb cd ed ef"
    assert len(gc.superbracket(legs).polynomial) == 2
    other = gc.superbracket(legs, order="ab cd af cb ed ef")
    ends = "abcdafcbedef"
    alive = [m for _, m in form_terms(24) if all(len({ends[i] for i in row}) == 4 for row in m)]
    assert (len(alive), len(other.polynomial), other.sign) == (4, 2, 1)  # two of the four cancel
    assert other == gc.superbracket(legs, order="1 4 2 3 5 6") == gc.superbracket(legs, order=[0, 3, 1, 2, 4, 5])
    assert straighten(other.polynomial) == straighten(gc.superbracket(legs).polynomial)
    odd = gc.superbracket(legs, order="2 1 3 4 5 6")
    identity = sub(mul(Number(odd.sign), odd.polynomial.to_expr()), gc.superbracket(legs).polynomial.to_expr())
    assert odd.sign == -1
    assert not straighten(identity)
    assert odd.to_json()["order"] == [1, 0, 2, 3, 4, 5]


@given(st.permutations(range(6)), st.lists(st.booleans(), min_size=6, max_size=6))
def test_alternating_in_lines_and_ends(order: list[int], turned: list[bool]) -> None:
    lines = [("a", "b"), ("c", "d"), ("a", "f"), ("g", "c"), ("i", "b"), ("g", "f")]
    moved = [lines[i][::-1] if t else lines[i] for i, t in zip(order, turned, strict=True)]
    sign = permutation_sign(order) * (-1) ** sum(turned)
    one, other = (straighten(gc.parse("[[" + ", ".join(map("".join, ls)) + "]]")) for ls in (lines, moved))
    assert other == one * sign


def test_lines_that_are_meets() -> None:
    text = r"[[abc /\ def, ab, (gh /\ bcd) \/ e, gk, cl, dh]]"
    points = random_points("abcdefghkl", seed=4)
    entries = [r"abc /\ def", "ab", r"(gh /\ bcd) \/ e", "gk", "cl", "dh"]
    rows = [list(gc.evaluate(e, points, modulus=PRIME)) for e in entries]
    value = determinant(rows, PRIME)
    assert value
    assert evaluate(gc.expand(text).to_expr(), points, modulus=PRIME) == value
    assert str(join(gc.parse("a"), gc.parse("b"))) == "ab"


# --- the superbracket in other ranks -------------------------------------------------------------------------------

RANK = pytest.mark.parametrize("rank", range(2, 9))
Graph = list[Line]


def complete(rank: int) -> Graph:
    return list(combinations("abcdefgh"[:rank], 2))


def apart(rank: int) -> Graph:
    """Lines without a common point."""
    return [(f"p{2 * i}", f"p{2 * i + 1}") for i in range(rank * (rank - 1) // 2)]


def written(lines: Graph) -> str:
    return "[[" + ", ".join(a + b for a, b in lines) + "]]"


def rows_of(lines: Graph, points: dict[str, Any], rank: int) -> list[list[Any]]:
    pairs = list(combinations(range(rank), 2))
    return [[points[a][i] * points[b][j] - points[a][j] * points[b][i] for i, j in pairs] for a, b in lines]


def value_of(poly: gc.BracketPolynomial, points: dict[str, tuple[int, ...]]) -> int:
    """The value modulo the prime, each bracket computed once by elimination."""
    known: dict[tuple[int, ...], int] = {}
    total = 0
    for m, c in poly.terms.items():
        for row in m:
            if row not in known:
                known[row] = determinant([list(points[poly.points[i]]) for i in row], PRIME)
            c = c * known[row] % PRIME
        total += int(c)
    return total % PRIME


@RANK
@pytest.mark.parametrize("lines", [complete, apart], ids=["complete", "apart"])
def test_the_oracle_takes_the_determinant_of_the_rows(rank: int, lines: Any) -> None:
    graph = lines(rank)
    points = random_points(names(graph), rank=rank, seed=rank)
    expected = determinant(rows_of(graph, points, rank), PRIME)
    assert gc.evaluate(written(graph), points, rank=rank, modulus=PRIME) == expected != 0
    whole = random_rational_points(names(graph), rank=rank, seed=rank)
    exact = gc.evaluate(written(graph), whole, rank=rank)
    assert exact % PRIME == determinant(rows_of(graph, whole, rank), PRIME)
    if rank > 6:
        return  # fractions are slow
    halves = {n: tuple(Fraction(x, 2) for x in p) for n, p in whole.items()}
    assert gc.evaluate(written(graph), halves, rank=rank) == Fraction(exact, 2 ** (rank * (rank - 1)))


@RANK
def test_the_oracle_over_floats(rank: int) -> None:
    graph = apart(rank)
    rng = np.random.default_rng(rank)
    at = {n: rng.uniform(-1, 1, (2, rank)) for n in names(graph)}
    rows = np.moveaxis(np.array(rows_of(graph, {n: p.T for n, p in at.items()}, rank)), -1, 0)
    expected = np.linalg.det(rows)
    found = gc.evaluate(written(graph), at, rank=rank)
    np.testing.assert_allclose(found, expected, rtol=1e-7)
    one = gc.evaluate(written(graph), {n: tuple(map(float, p[0])) for n, p in at.items()}, rank=rank)
    assert isinstance(one, float)
    assert one == pytest.approx(expected[0], rel=1e-7)


@pytest.mark.parametrize("rank", [2, 3, 4, 5])
def test_the_oracle_over_arrays_of_residues(rank: int) -> None:
    graph, prime = apart(rank), 2**31 - 1
    rng = np.random.default_rng(rank)
    at = {n: rng.integers(0, prime, (3, rank)) for n in names(graph)}
    found = gc.evaluate(written(graph), at, rank=rank, modulus=prime)
    for i in range(3):
        points = {n: tuple(map(int, p[i])) for n, p in at.items()}
        assert int(found[i]) == determinant(rows_of(graph, points, rank), prime)


@st.composite
def graphs(draw: st.DrawFn) -> tuple[int, Graph]:
    """A rank and as many lines as its superbracket has, between few points."""
    rank = draw(st.integers(2, 6))
    letters = "abcdefghijkl"[: draw(st.integers(rank, {5: 9, 6: 8}.get(rank, 12)))]
    pairs = list(combinations(letters, 2))
    chosen = draw(st.lists(st.sampled_from(pairs), min_size=comb(rank, 2), max_size=comb(rank, 2), unique=rank < 7))
    return rank, [p[::-1] if turned else p for p in chosen for turned in [draw(st.booleans())]]


@settings(deadline=None, max_examples=60)
@given(graphs(), st.sets(st.sampled_from("abcdef")), st.randoms(use_true_random=False))
def test_the_expansion_is_the_determinant(case: tuple[int, Graph], ideal: set[str], rng: random.Random) -> None:
    rank, lines = case
    used = names(lines)
    at_infinity = sorted(ideal & set(used))
    found = gc.expand(written(lines), rank=rank, ideal=at_infinity, points=rng.sample(used, len(used)))
    points = random_points(used, rank=rank, ideal=at_infinity, seed=1)
    assert value_of(found, points) == determinant(rows_of(lines, points, rank), PRIME)


@settings(deadline=None, max_examples=25)
@given(graphs(), st.data())
def test_alternating_in_every_rank(case: tuple[int, Graph], data: st.DataObject) -> None:
    rank, lines = case
    order = data.draw(st.permutations(range(len(lines))))
    one = gc.straighten(written(lines), rank=rank)
    other = gc.straighten(written([lines[i] for i in order]), rank=rank)
    assert other == one * permutation_sign(order)


@RANK
def test_lines_of_a_complete_graph(rank: int) -> None:
    """All joins of as many points as the rank, in lexicographic order, are the bracket to the power rank − 1."""
    bracket = "[" + "abcdefgh"[:rank] + "]"
    assert gc.prove(written(complete(rank)), f"{bracket}**{rank - 1}", rank=rank).verdict == "proved"
    assert len(gc.expand(written(complete(rank)), rank=rank)) == 1


CYCLE = [(f"p{i}", f"p{(i + 1) % 10}") for i in range(10)]
SIZES = [
    pytest.param(2, apart(2), 1, id="rank 2"),
    pytest.param(3, apart(3), 2, id="rank 3"),
    pytest.param(4, apart(4), 24, id="rank 4"),
    pytest.param(5, CYCLE, 60, id="cycle of ten"),
    pytest.param(5, apart(5), 9056, id="twenty points in rank 5"),
    pytest.param(5, [*complete(5)[:9], ("f", "g")], 1, id="complete graph less a line, and a line"),
    pytest.param(6, [(a, b) for a in "abcd" for b in "efgh"][1:], 0, id="bipartite, two sets of four points"),
]


@pytest.mark.parametrize(("rank", "lines", "terms"), SIZES)
def test_numbers_of_terms(rank: int, lines: Graph, terms: int) -> None:
    found = expand(superbracket(*(gc.parse(a + b, rank=rank) for a, b in lines), rank=rank), rank=rank)
    points = random_points(names(lines), rank=rank, seed=7)
    assert len(found) == terms
    assert value_of(found, points) == determinant(rows_of(lines, points, rank), PRIME)


def test_the_24_terms_by_the_other_method() -> None:
    """For twelve points in tableau order both methods give the normal form."""
    lines = [(2 * i, 2 * i + 1) for i in range(6)]
    expected = gc.expand("[[ab, cd, ef, gh, ij, kl]]").terms
    assert dict(determinant_terms(lines, 4)) == dict(expected)


MEETS = [
    pytest.param(3, ["ab", r"(ab /\ cd) e", r"(ac /\ de) \/ b"], id="rank 3"),
    pytest.param(3, ["2 ab - 3 cd", "[abc] de", "ae + bd"], id="rank 3, sums"),
    pytest.param(4, [r"abc /\ def", "ab", "cd", r"ace /\ bdf", "ef", "ad"], id="rank 4"),
    pytest.param(5, [r"abcd /\ efg", "ab", "cd", "ef", "gh", "ij", "ac", "bd", "eg", "fh"], id="rank 5, one meet"),
    pytest.param(
        5,
        [r"abcd /\ efgh /\ acei", r"abce /\ fgh", r"abg /\ cdef", r"aceh /\ bdg", "ij", "ac", "bd", "eg", "fh", "ae"],
        id="rank 5, meets of 3- and 4-extensors",
    ),
    pytest.param(
        6,
        [r"abcde /\ fgh", "ab", "ac", "ad", "ae", "bc", "bd", "be", "cf", "dg", "eh", "fg", "fh", "gh", "af"],
        id="rank 6",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("rank", "entries"), MEETS)
def test_lines_that_are_meets_in_every_rank(rank: int, entries: list[str]) -> None:
    lines = [gc.parse(e, rank=rank) for e in entries]
    points = random_points("abcdefghij", rank=rank, seed=2)
    expected = determinant([list(gc.evaluate(e, points, modulus=PRIME)) for e in lines], PRIME)
    assert value_of(expand(superbracket(*lines, rank=rank), rank=rank), points) == expected
    assert gc.evaluate(written_lines(entries), points, rank=rank, modulus=PRIME) == expected


def written_lines(entries: list[str]) -> str:
    return f"[[{', '.join(entries)}]]"


@pytest.mark.parametrize(
    ("rank", "left", "right"),
    [
        (2, "[[ab]]", "[ab]"),
        (3, "[[ab, cd, ef]]", r"ab /\ cd /\ ef"),
        (3, r"[[a(bc /\ de), cd, ef]]", r"a(bc /\ de) /\ cd /\ ef"),
        (3, "[[ab, ac, de]]", "[abc][ade]"),
        (5, "[[ab, ac, ad, ae, bc, de, fg, bf, cg, hi]]", "[abcde] * [[bc, de, fg, bf, cg, hi]]"),
    ],
    ids=["rank 2", "three lines meet", "a line through a meet", "two lines of a point", "four lines of a point"],
)
def test_identities_of_other_ranks(rank: int, left: str, right: str) -> None:
    if rank == 5:  # the superbracket of the quotient by a: its brackets hold a
        quotient = gc.expand("[[bc, de, fg, bf, cg, hi]]")
        right = " + ".join(
            f"({c}) [abcde]" + "".join("[a" + "".join(row) + "]" for row in rows) for c, rows in quotient.named()
        )
    assert gc.prove(left, right, rank=rank).verdict == "proved"
    assert gc.prove(left, f"-({right})", rank=rank).verdict == "refuted"


def test_factors_of_three_lines() -> None:
    found = gc.factor(gc.expand("[[ab, cd, ef]]", rank=3))
    assert str(found.to_expr()) == r"ab /\ cd /\ ef"


FAULTS = [
    (3, "[[ab, cd]]", "a superbracket of 2 lines, expected 3 in rank 3", "rank n takes n(n - 1)/2 lines"),
    (3, "[[ab, cd, ef, gh, ij, kl]]", "a superbracket of 6 lines, expected 3 in rank 3", "--rank 4 in the shell"),
    (4, "[[ab, cd, ef]]", "a superbracket of 3 lines, expected 6 in rank 4", "--rank 3 in the shell"),
    (4, "[[ab]]", "a superbracket of 1 line, expected 6 in rank 4", "1 line makes a superbracket in rank 2"),
    (5, "[[ab, cd, ef, gh, ij, kl]]", "expected 10 in rank 5", "6 lines make a superbracket in rank 4"),
    (3, "[[ab, c, ef]]", "entry 2 of the superbracket is a point (step 1)", None),
    (3, "[[ab, cde, ef]]", "entry 2 of the superbracket is the whole space (step 3)", None),
]


@pytest.mark.parametrize(("rank", "source", "message", "hint"), FAULTS)
def test_faults_of_other_ranks(rank: int, source: str, message: str, hint: str | None) -> None:
    with pytest.raises(StepError) as caught:
        gc.parse(f"[{'abcde'[:rank]}] *\n {source}", rank=rank)
    assert caught.value.place == "<input>:2:2"
    assert message in caught.value.message
    assert (caught.value.hint is None) if hint is None else (hint in (caught.value.hint or ""))


@pytest.mark.parametrize(("rank", "lines"), [(5, apart(5)), (6, apart(6)), (8, apart(8))])
def test_too_large(rank: int, lines: Graph) -> None:
    with pytest.raises(LimitReached, match=r"the expansion takes more than 20,000 products of terms") as caught:
        gc.expand(written(lines), rank=rank, limit=1000)
    assert caught.value.exit_code == 3
    assert "--limit" in (caught.value.hint or "")


@pytest.mark.parametrize("rank", [2, 3, 5, 6])
def test_shown_in_every_rank(rank: int) -> None:
    e = gc.parse(f"3 {written(complete(rank))}**2 - 1", rank=rank)
    assert gc.parse(str(e), rank=rank) == e
    assert latex(e).count(r",\,") == comb(rank, 2) - 1
    assert substitute(e, {"a": gc.parse("q")}, rank=rank) == gc.parse(str(e).replace("a", "q"), rank=rank)
    poly = gc.expand(e)
    assert (poly.rank, poly.to_json()["terms"]) == (rank, 2)
    assert len(poly.to_sympy().args) == 2
