"""Assumptions with several kinds of positions; names of points do not matter."""

from __future__ import annotations

import random
import re
from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import Any

import pytest
from algebra.under_assumptions import (
    GALLUCCI,
    _kinds_of_assumptions,
    check,
    decided,
    everything,
    one,
    positions,
    script_of,
    shuffle,
    vanish,
)

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import holds, kinds, resolve
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.prove import Proof, prove
from gcrules.core.budget import within
from gcrules.core.errors import InputError

# --- several kinds of positions -----------------------------------------------------------------------------------

CONIC = "[abc][ade][bdf][cef] == [abd][ace][bcf][def]"
PASCAL = r"[ab /\ de, bc /\ ef, cd /\ fa] == 0"
KINDS = [
    # rank, assumptions, claim, verdict, verdicts of the kinds if there are several
    (3, "[abc][abd] == 0", "[abc] == 0", "refuted", ["proved", "refuted"]),
    (3, "[abc]**2 [abd]**3 == 0", "[abc][abd] == 0", "proved", ["proved", "proved"]),
    (3, "[abc]**2 == 0", "[abc] == 0", "proved", []),
    (3, "concurrent(ab, ac, bc)", "[abc] == 0", "proved", []),
    (3, "concurrent(ab, ac, bc)", "[abd] == 0", "refuted", []),
    (3, "collinear(a, b, d), [bcd][abe] == [abd][bce]", "[bde] == 0", "refuted", ["refuted", "proved"]),
    (3, "[abe][acd] == [abc][aed], collinear(a, b, c)", "[abd] == 0", "refuted", ["proved", "refuted"]),
    (3, "[abe][acd] == [abc][aed]", "[abd][ace] == 0", "proved", ["proved", "proved"]),
    (3, "[abd] == [abc], [abd] == 2 [abc]", "[acd] == 0", "proved", []),
    (3, "collinear(c,d,e), incident(a,be), [bed][bac] == -[bea][bdc]", "[abd] == 0", "proved", []),
    (3, "collinear(d, b, ce /\\ ae)", "[bde] == 0", "proved", []),
    (4, "concurrent(be, bd, ca)", "abc == 0", "proved", []),
    (4, "concurrent(be, bd, ca)", "bde == 0", "refuted", []),
    (4, "[abcd][abef] == [abce][abdf]", "[abcf][abde] == 0", "proved", ["proved", "proved"]),
    (3, CONIC, PASCAL, "proved", []),
    (3, CONIC, r"[ac /\ de, cb /\ ef, bd /\ fa] == 0", "proved", []),
    (3, f"2 ({CONIC.split(' == ')[0]}) == 2 {CONIC.split(' == ')[1]}", "[abc] == 0", "refuted", []),
    (3, r"collinear(ab /\ de, bc /\ ef, cd /\ fa)", CONIC, "proved", []),
    (
        3,
        f"{CONIC}, [abc][ade][bdg][ceg] == [abd][ace][bcg][deg]",
        r"[ab /\ dg, bc /\ fg, cd /\ fa] == 0",
        "proved",
        [],
    ),
    # a symmetry exchanges b, c with f, e; the line of both planes is ab or af
    (4, r"incident(abc /\ aef, bdf)", "[abef] == 0", "refuted", ["proved", "refuted"]),
    (4, r"bcd /\ bcf /\ abc == 0", "[bcde] == 0", "refuted", []),
    (3, f"{CONIC}, collinear(a, b, c)", "[def] == 0", "refuted", ["refuted", "refuted", "refuted", "proved"]),
    # One kind lies within the other, but for positions that its construction does not reach.
    (3, "[ace] == 0, [abc][bce] == 0", "[bce] == 0", "proved", []),
    (3, "d == e + (1/2) c, [dea]**2 == 0, [bad][bec] == [bae][bdc]", "[cbe][dcb] == 0", "proved", []),
    (3, "[abd][bcd] == [acd][abd], [bcd]**2 == 0", "[abc][acd] == [acd][bcd]", "proved", []),
    (4, "[abde][bcde] == 0, coplanar(a, b, c, d)", "[acde] == 0", "proved", []),
]


@pytest.mark.parametrize(("rank", "assumption", "claim", "verdict", "verdicts"), KINDS)
def test_kinds(rank: int, assumption: str, claim: str, verdict: str, verdicts: list[str]) -> None:
    proof = gc.prove(claim, rank=rank, given=assumption)
    assert proof.verdict == verdict, proof.text()
    assert sorted(k.verdict for k in proof.kinds) == sorted(verdicts)
    assert proof.to_json()["kinds"] == [k.to_json() for k in proof.kinds]
    assert all(str(k) in proof.text() for k in proof.kinds)
    at = parse_assumption(assumption, Context(rank))
    if verdict == "refuted":
        check(proof, at)
    names = sorted({n for a in at.given for e in a.args for n in points_of(e)} | {*points_of(proof.left, proof.right)})
    check_kinds(proof, at, names)


def check_kinds(proof: Proof, at: Context, names: Sequence[str]) -> None:
    """Each kind by itself over F_7: what is proved for it holds at its positions, and together they are all."""
    wanted, difference = everything(at), ex.sub(proof.left, proof.right, rank=at.rank)
    said = [
        (k.verdict, *([parse(t, context=at) for t in texts] for texts in (k.where, k.assumed))) for k in proof.kinds
    ]
    said = said or [(proof.verdict, [], [parse(t, context=at) for t in proof.assumed])]
    for points in positions(names, at, 7, 11, 2000):
        if not vanish(wanted, points, at.rank, 7):
            continue
        here = [(verdict, assumed) for verdict, where, assumed in said if vanish(where, points, at.rank, 7)]
        assert here or any(vanish([e], points, at.rank, 7) for *_, assumed in said for e in assumed), points
        for verdict, assumed in here:
            if verdict == "proved" and not any(vanish([e], points, at.rank, 7) for e in assumed):
                assert vanish([difference], points, at.rank, 7), (proof.text(), points)


IDEAL = ("", "", "a", "ab", "ef", "cde")


def random_case(rng: random.Random) -> tuple[int, list[str], str, str]:
    """Rank, assumptions, points at infinity and a claim."""
    rank = rng.choice([3, 4])
    texts = [
        rng.choice(_kinds_of_assumptions(rank, lambda n: rng.sample("abcdef", n), rng.choice([3, 4])))()
        for _ in range(rng.randint(1, 3))
    ]
    return rank, texts, rng.choice(IDEAL), f"[{''.join(rng.sample('abcdef', rank))}] == 0"


def spelled_anew(text: str, other: Mapping[str, str], rng: random.Random) -> str:
    """With other names, and arguments in another sequence where that says the same."""
    renamed = re.sub(r"(?:collinear|coplanar|concurrent|incident)\(|[a-f]", lambda m: other.get(m[0], m[0]), text)
    return shuffle(renamed, rng)


def answer(rank: int, texts: Sequence[str], ideal: str, claim: str) -> tuple[str, list[str]]:
    """The verdict, and those of the kinds; why there is none."""
    at = Context(rank, tuple("abcdef"), tuple(ideal))
    try:
        for t in texts:
            at = parse_assumption(t, at)
        proof = decided(claim, at)
    except InputError as refused:
        return "refused", [] if "cannot be resolved" in refused.message else [refused.message]
    return proof.verdict, sorted(k.verdict for k in proof.kinds)


def differently_named(rank: int, texts: Sequence[str], ideal: str, claim: str, rng: random.Random) -> Any:
    """The same problem with other names, its assumptions in another order."""
    other = dict(zip("abcdef", rng.sample("abcdef", 6), strict=True))
    shuffled = rng.sample(texts, len(texts))
    renamed = [spelled_anew(t, other, rng) for t in shuffled]
    return rank, renamed, spelled_anew(ideal, other, rng), spelled_anew(claim, other, rng)


@pytest.mark.parametrize("part", range(4))
def test_names_do_not_matter(part: int) -> None:
    """Points renamed and assumptions in another order: the same verdict, for each kind too, or none for both."""
    answered = 0
    for number in range(40):
        rng = random.Random(f"names {part} {number}")
        case = random_case(rng)
        expected = answer(*case)
        answered += expected[0] != "refused"
        other = differently_named(*case, rng)
        assert answer(*other) == expected, (case, other)
    assert answered > 20


NAMED = [
    (3, ["concurrent(ae, fd, fe)", "[cfd][fbe] == [cad][bae]", "incident(e, da)"]),
]


@pytest.mark.parametrize(("rank", "texts"), NAMED)
def test_names_that_did_matter(rank: int, texts: list[str]) -> None:
    rng = random.Random(0)
    for claim in (f"[{''.join(some)}] == 0" for some in combinations("abcdef", rank)):
        expected = answer(rank, texts, "", claim)
        other = differently_named(rank, texts, "", claim, rng)
        assert answer(*other) == expected, (claim, other)


def test_errors_speak_of_the_points_as_they_are_called() -> None:
    with pytest.raises(InputError) as found:
        gc.prove("xyz == 0", given="ideal x y, collinear(y, z, x)")
    assert "the assumption collinear(y, z, x) cannot be resolved" in found.value.message
    assert "the finite point z would have to lie at infinity" in found.value.message
    assert found.value.hint == "declare it with `ideal z`"
    names = "left right top p1"
    with pytest.raises(InputError) as found:
        gc.prove("left == right", rank=3, points=names, given="[left right p1] [left top p1] == -3")
    assert "[left right p1] [left top p1] == -3" in found.value.message


def test_no_time_for_the_assumptions_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gcrules.algebra.prove.common_rank", lambda rank, *_: rank)  # the first that would need time
    at = script_of(GALLUCCI)
    left, right = parse_equation("[p4q4xy] == 0", context=at)
    with within(seconds=0):
        proof = prove(left, right, points=at.points, rank=4, given=at.given)
    assert proof.verdict == "undecided"
    assert "0 seconds" in proof.reason
    assert "assumptions are not resolved" in proof.reason


TRIED = [
    "ideal i j, collinear(i, a, j)",
    "incident(x, ab), incident(x, cd), incident(y, ac), incident(y, bd), incident(z, ad),incident(z, bc),[xyz]==0",
]


@pytest.mark.parametrize("assumption", TRIED)
def test_a_refusal_speaks_of_what_was_tried(assumption: str) -> None:
    """That points coincide, say, is known of the constructions that were tried only."""
    with pytest.raises(InputError, match="no construction that was tried satisfies it; in the one that got farthest,"):
        gc.prove("[abc] == 0", rank=3, given=assumption)


def test_a_contradiction_is_told_before_anything_is_proved() -> None:
    with pytest.raises(InputError, match="it contradicts the others: together they say that 1 is 0"):
        gc.prove("[abc] == 0", rank=3, given="[abd] == [abc], [abd] == [abc] + 1")


def test_one_kind_for_those_who_need_one_construction() -> None:
    at = parse_assumption("[abc][abd] == 0", Context(3))
    found = kinds(at)
    assert [[str(e) for e in k.where] for k in found] == [["[abc]"], ["[abd]"]]
    assert "[abd]" in map(str, resolve(at).nonzero)
    assert not holds(one("collinear(a, b, c)", at), at)


def test_too_many_kinds() -> None:
    product_of_many = "".join(f"[{x}]" for x in map("".join, combinations("abcdefg", 3)))
    with pytest.raises(InputError, match="kinds of positions"):
        gc.prove("[abc] == 0", rank=3, given=", ".join([f"{product_of_many} == 0", f"{product_of_many}[abh] == 0"]))
