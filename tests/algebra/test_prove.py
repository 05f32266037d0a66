"""Claims decided: proved ones hold at fresh points, refuted ones come with points that really refute them."""

from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import expressions

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import PRIME, evaluate, random_points, vanishes
from gcrules.algebra.expr import Expr, points_of, sub
from gcrules.algebra.prove import Proof, prove
from gcrules.algebra.scalars import bracket
from gcrules.core.errors import StepError

PROVED = [
    (r"ab /\ cd == [abcd]", 4, ""),
    (r"ab /\ cde == cde /\ ab", 4, ""),
    (r"abc /\ def == -def /\ abc", 4, ""),
    (r"a /\ bcd == -bcd /\ a", 4, ""),
    (r"ab /\ cd == [abd] c - [abc] d", 3, ""),
    ("[abcd] efgh == [efgh] abcd", 4, ""),
    ("[abcd] e == [ebcd] a + [aecd] b + [abed] c + [abce] d", 4, ""),
    ("[[ab,af,cb,cd,ed,ef]] == [abfc][acde][bdef] + [abfd][acbe][cdef]", 4, ""),
    (r"[[ab,af,cb,cd,ed,ef]] == ace /\ abf /\ cbd /\ edf", 4, ""),
    (r"[[ab,af,cb,cd,ed,ef]] == bdf /\ acb /\ ced /\ eaf", 4, ""),
    ("[ijka][lbcd] - [ijla][kbcd] + [ikla][jbcd] - [jkla][ibcd] == 0", 4, "ijkl"),
    ("[ijkl] == 0", 4, "ijkl"),
    (r"ijk /\ abc == -abc /\ ijk", 4, "ijk"),
    ("0 == 0", 4, ""),
    (r"0 == abc /\ abc", 4, ""),
    ("[abac] d == 0", 4, ""),
    ("1/3 [abcd] + 2/3 [abcd] == [abcd]", 4, ""),
    ("[ab][cd] - [ac][bd] + [ad][bc] == 0", 2, ""),
    ("([abcd] + [abce])**2 == [abcd]**2 + 2[abcd][abce] + [abce]**2", 4, ""),
]

REFUTED = [
    (r"a /\ bcd == bcd /\ a", 4, ""),
    (r"abc /\ def == def /\ abc", 4, ""),
    ("a == b", 4, ""),
    ("ab == ba", 4, ""),
    ("0 == ab", 4, ""),
    ("0 == 1", 4, ""),
    ("[abcd] efgh == -[efgh] abcd", 4, ""),
    ("[ijka][lbcd] - [ijla][kbcd] + [ikla][jbcd] - [jkla][ibcd] == 0", 4, "ijk"),
    ("[ijka] == 0", 4, "ijk"),
    ("[abcd]**2 == [abcd]", 4, ""),
    ("PRIME [abcd] == 0", 4, ""),
    ("[abcd] == (PRIME + 1)[abcd]", 4, ""),
    ("[ab][cd] == [ac][bd]", 2, ""),
    ("[abcdefgh] == [bcdefgha] * 2", 8, ""),
]


def sides(claim: str, rank: int) -> tuple[Expr, Expr]:
    left, right = claim.split("==")
    return gc.parse(left, rank=rank), gc.parse(right, rank=rank)


def check(proof: Proof, rank: int, ideal: str) -> None:
    """What the verdict promises, evaluated anew."""
    if proof.verdict == "proved":
        assert not proof.counterexample
        difference = (
            proof.right
            if proof.left == ex.ZERO
            else proof.left
            if proof.right == ex.ZERO
            else sub(proof.left, proof.right, rank=rank)
        )
        assert vanishes(difference, rank=rank, ideal=ideal, seed=77)
    else:
        assert proof.verdict == "refuted"
        points = proof.counterexample
        assert points is not None
        assert set(points) == set(points_of(proof.left, proof.right))
        assert all(len(c) == rank and any(c) and (c[-1] == 0) == (n in set(ideal)) for n, c in points.items())
        left, right = evaluate(proof.left, points), evaluate(proof.right, points)
        assert proof.values == (left, right)
        parts = [v if isinstance(v, tuple) else (v,) for v in (left, right)]
        assert set(parts[0]) | set(parts[1]) != {0}
        assert left != right
    json.dumps(proof.to_json())
    assert proof.verdict in proof.text()


@pytest.mark.parametrize(("claim", "rank", "ideal"), PROVED)
def test_proved(claim: str, rank: int, ideal: str) -> None:
    proof = prove(*sides(claim, rank), rank=rank, ideal=ideal)
    assert (proof.verdict, proof.method, proof.proved) == ("proved", "normal-form", True)
    check(proof, rank, ideal)


@pytest.mark.parametrize(("claim", "rank", "ideal"), REFUTED)
def test_refuted(claim: str, rank: int, ideal: str) -> None:
    claim = claim.replace("PRIME", str(PRIME))
    proof = prove(*sides(claim, rank), rank=rank, ideal=ideal)
    assert (proof.verdict, proof.proved) == ("refuted", False)
    check(proof, rank, ideal)


SCRAMBLED = "".join(f"[p{i}p{19 - i}p{20 + i}p{39 - i}]" for i in range(10))
UNDECIDED = [
    pytest.param("[[ab,cd,ef,gh,ij,kl]]**2 == [[cd,ab,ef,gh,ij,kl]]**2", 100, "100", id="limit of terms"),
    pytest.param("[.a.b.c.d][.e.f.g.h][.i.j.k.l][.m.n.o.p] == 0", 1000, "50,000", id="dots"),
    pytest.param(f"1/{PRIME} [abcd] == 1/{PRIME} [abcd] * 2", 1000, "modulus", id="a denominator of the oracle"),
]


@pytest.mark.parametrize(("claim", "limit", "why"), UNDECIDED)
def test_undecided(claim: str, limit: int, why: str) -> None:
    proof = gc.prove(claim, limit=limit)
    assert proof.verdict == "undecided"
    assert why in proof.reason
    assert not proof.proved
    assert proof.counterexample is None


def test_values_too_long_to_show() -> None:
    proof = gc.prove(f"({'7' * 1900} [abcd])**3 == 0")
    assert proof.verdict == "refuted"
    assert "bits" in proof.text()
    assert "bits" in str(json.loads(json.dumps(proof.to_json()))["values"])


@pytest.mark.parametrize("claim", ["a == ab", "abcd == [abcd]", "1 == a", r"ab /\ cde == cd"])
def test_unlike_steps(claim: str) -> None:
    with pytest.raises(StepError):
        gc.prove(claim)


@settings(max_examples=60)
@given(st.integers(2, 5).flatmap(lambda d: st.tuples(st.just(d), expressions(d, depth=2), st.sampled_from(["", "ab"]))))
def test_any_expression(case: tuple[int, Expr, str]) -> None:
    """e == e is proved, e == 0 is decided truly, e == 2e is refuted unless e is zero."""
    rank, e, ideal = case
    assert prove(e, e, rank=rank, ideal=ideal, limit=2_000).verdict in ("proved", "undecided")
    for right in (ex.ZERO, ex.mul(ex.Number(2), e)):
        proof = prove(e, right, rank=rank, ideal=ideal, limit=2_000)
        if proof.verdict != "undecided":
            check(proof, rank, ideal)
            points = random_points(points_of(e), rank=rank, ideal=ideal, seed=5)
            zero = not any(v % PRIME for v in _parts(evaluate(e, points, modulus=PRIME)))
            assert zero == (proof.verdict == "proved")


def _parts(value: object) -> tuple[int, ...]:
    return value if isinstance(value, tuple) else (value,)


# --- which weights count --------------------------------------------------------------------------------------------

# Terms in which finite points occur unequally often: false, for the weight of a point is any number.
WEIGHTS = [
    # claim, rank, ideal, whether it holds for finite points with last coordinate 1
    ("[aij] == [bij]", 3, "ij", True),
    ("[ai] == [bi]", 2, "i", True),
    (r"[[b \/ i]] == -[i j]", 2, "i", True),
    ("[aijk] == [bijk]", 4, "ijk", True),
    ("[abc] == [abd] + [bcd] - [acd]", 3, "", True),
    ("[ai] b - [bi] a == 0", 2, "i", False),
    ("[aij] b == [bij] b", 3, "ij", True),
    ("ab + bc + ca == ac", 3, "", False),
    ("[abi] == [abj]", 3, "ij", False),
    ("[ai] == [aj]", 2, "ij", False),
    (r"[[b \/ i]] == -[i j]", 2, "ij", False),
    ("[aij] == [aij]**2", 3, "ij", False),
    ("[aij] == 2 [bij]", 3, "ij", False),
    ("[aij][bik] == [bij][aik] + [aij]", 3, "ijk", False),
    ("[aij][bik] == [bij][aik]", 3, "ijk", None),
    ("[ij] == 0", 2, "ij", None),
    ("ij == 0", 2, "ij", None),
    ("[ai][bj] == [aj][bi]", 2, "ij", None),
    ("[ijk] == 0", 3, "ijk", None),
    (r"ij /\ kl == 0", 3, "ijkl", None),
    ("[aijk] b == [bijk] a + [ijkl] c", 4, "ijkl", False),
]


@pytest.mark.parametrize("assumption", ["", "collinear(a, b, z)"], ids=["free", "given"])
@pytest.mark.parametrize(("claim", "rank", "ideal", "units"), WEIGHTS)
def test_every_weight_counts(claim: str, rank: int, ideal: str, units: bool | None, assumption: str) -> None:
    """One convention with and without assumptions, and the answer says where weights 1 would make a difference."""
    if assumption and rank == 2:
        assumption = "[az] == [bz]"
    proof = gc.prove(claim, rank=rank, ideal=" ".join(ideal), given=assumption or ())
    assert proof.verdict == ("proved" if units is None else "refuted"), proof.text()
    assert proof.unit_weights is bool(units)
    assert proof.to_json()["unit_weights"] is bool(units)
    assert ("every finite point has last coordinate 1" in proof.text()) is bool(units)
    if proof.counterexample is not None:
        assert all(any(c) and (c[-1] == 0) == (n in ideal) for n, c in proof.counterexample.items())


def _sums_of_brackets(case: tuple[int, int]) -> st.SearchStrategy[tuple[int, str, Expr]]:
    rank, at_infinity = case
    names = "ijkl"[:at_infinity] + "abc"
    row = st.lists(st.sampled_from(names), min_size=rank, max_size=rank, unique=rank <= len(names))
    term = st.tuples(st.integers(-2, 2), st.lists(row, min_size=1, max_size=2))

    def built(terms: list[tuple[int, list[list[str]]]]) -> Expr:
        return ex.add(
            *(ex.mul(ex.Number(c), *(bracket(*map(ex.Point, r), rank=rank) for r in rows)) for c, rows in terms),
            rank=rank,
        )

    found = st.lists(term, min_size=1, max_size=3).map(built)
    return st.tuples(st.just(rank), st.just(names[:at_infinity]), found)


@settings(max_examples=120)
@given(st.tuples(st.integers(2, 4), st.integers(0, 4)).flatmap(_sums_of_brackets))
def test_sums_with_points_at_infinity_are_decided(case: tuple[int, str, Expr]) -> None:
    """Against random points: proved if it vanishes with all weights, else refuted; told if it does with weights 1."""
    rank, ideal, e = case
    proof = prove(e, ex.ZERO, rank=rank, ideal=ideal)
    points = random_points(points_of(e), rank=rank, ideal=ideal, seed=91)
    assert proof.verdict == ("proved" if not evaluate(e, points, modulus=PRIME) else "refuted")
    check(proof, rank, ideal)
    if proof.verdict == "refuted":
        units = {n: c if n in ideal else (*c[:-1], 1) for n, c in points.items()}
        assert proof.unit_weights == (not evaluate(e, units, modulus=PRIME))
