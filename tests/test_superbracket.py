"""Superbrackets: both forms are the determinant, the shortest counts are those of the data, signs are as documented."""

from __future__ import annotations

import random
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, evaluate, random_points, random_rational_points
from gcrules.algebra.expr import Number, join, mul, permutation_sign, sub
from gcrules.algebra.shortest import Line, counts, shortest_forms, superbracket_form
from gcrules.algebra.straighten import straighten
from gcrules.algebra.superbracket import FORMS, form_terms

CLASSES: list[dict[str, Any]] = yaml.safe_load(
    (Path(__file__).parent / "data" / "gsp_classes.yaml").read_text(encoding="utf-8")
)["classes"]
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
    assert {form: int(n.min()) for form, n in found.items()} == {24: facts["terms24"], 16: facts["terms16"]}
    assert all(len(n) == 720 for n in found.values())


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
    sample = random.Random(1).sample(range(720), 40)
    orders = list(permutations(range(6)))
    found = counts(lines)
    for form in FORMS:
        plain = [len(superbracket_form(lines, orders[i], form).polynomial) for i in sample]
        assert plain == [int(found[form][i]) for i in sample]


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
