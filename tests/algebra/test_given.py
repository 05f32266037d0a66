"""Claims under assumptions: theorems are proved, their false siblings refuted, and nothing is assumed silently.

The second road knows nothing of constructions: it draws points over a small field, many of them equal or on few lines,
keeps those that satisfy the equations, and looks whether a proved claim holds wherever its `assumed` do not vanish.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations, product
from typing import Any

import pytest
from click.testing import CliRunner, Result
from hypothesis import given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import equations, holds, kinds, resolve
from gcrules.algebra.evaluate import PRIME, Evaluator, evaluate
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.prove import Proof, prove
from gcrules.algebra.space import Assumption
from gcrules.apps.cli import cli
from gcrules.core.budget import within
from gcrules.core.errors import InputError
from gcrules.rules.script import run_script

DESARGUES = (
    "given incident(x, bc), incident(x, b'c'), incident(y, ca), incident(y, c'a'), incident(z, ab), incident(z, a'b')"
)
PERSPECTIVE = "given incident(q, aa'), incident(q, bb'), incident(q, cc')"
SIDES = "given incident(d, bc), incident(e, ca), incident(f, ab)"
GALLUCCI = """
points k k' l l' m m' p1 p2 p3 p4 q1 q2 q3 q4 x y
given incident(p1, kk'), incident(p2, kk'), incident(p3, kk'), incident(p4, kk')
given incident(q1, ll'), incident(q2, ll'), incident(q3, ll'), incident(q4, ll')
given coplanar(p1, q1, m, m'), coplanar(p2, q2, m, m'), coplanar(p3, q3, m, m'), coplanar(p4, q4, m, m')
given incident(x, p1q1), incident(y, p2q2), coplanar(x, y, p3, q3)
"""
MOEBIUS = """
given coplanar(a2, a3, a4, b1), coplanar(a1, a3, a4, b2), coplanar(a1, a2, a4, b3), coplanar(a1, a2, a3, b4)
given coplanar(b2, b3, b4, a1), coplanar(b1, b3, b4, a2), coplanar(b1, b2, b4, a3)
"""
MIDPOINTS = "rank 3 ideal i j given m == [bij] a + [aij] b, n == [cij] a + [aij] c"
PARALLELOGRAM = "rank 3 ideal i j given incident(i, ab), incident(i, cd), incident(j, ad), incident(j, bc)"

THEOREMS = {
    # name: (script, true claim, false sibling)
    "Desargues": (f"rank 3 {PERSPECTIVE} {DESARGUES}", "[xyz] == 0", "[xya] == 0"),
    "Desargues, converse": (f"rank 3 {DESARGUES} given collinear(x, y, z)", r"aa' /\ bb' /\ cc' == 0", "[abx] == 0"),
    "Desargues, lines": (
        r"rank 3 given concurrent(aa', bb', cc')",
        r"[bc /\ b'c', ca /\ c'a', ab /\ a'b'] == 0",
        r"[bc /\ b'c', ca /\ c'a', ab /\ a'c'] == 0",
    ),
    "Desargues, converse with meets": (
        r"rank 3 let x = bc /\ b'c' let y = ca /\ c'a' let z = ab /\ a'b' given collinear(x, y, z)",
        r"aa' /\ bb' /\ cc' == 0",
        r"aa' /\ bb' /\ cb' == 0",
    ),
    "Desargues in space": (
        f"{PERSPECTIVE} given incident(x, bc), incident(x, b'c'), incident(y, ca), incident(y, c'a')",
        r"xy /\ ab == 0",
        r"xy /\ aq == 0",
    ),
    "Pappus": (
        r"rank 3 given collinear(a, b, c), collinear(a', b', c')",
        r"[bc' /\ b'c, ca' /\ c'a, ab' /\ a'b] == 0",
        r"[bc' /\ b'c, ca' /\ c'a, aa' /\ bb'] == 0",
    ),
    "Pappus with points": (
        "rank 3 given collinear(a, b, c), collinear(d, e, f), collinear(x, b, f), collinear(x, c, e),"
        "collinear(y, c, d), collinear(y, a, f), collinear(z, a, e), collinear(z, b, d)",
        "[xyz] == 0",
        "[xya] == 0",
    ),
    "Ceva": (
        rf"rank 3 {SIDES} given concurrent(ad, be, cf)",
        "[abd][bce][caf] == [adc][bea][cfb]",
        "[abd][bce][caf] == -[adc][bea][cfb]",
    ),
    "Menelaus": (
        f"rank 3 {SIDES} given collinear(d, e, f)",
        "[abd][bce][caf] == -[adc][bea][cfb]",
        "[abd][bce][caf] == [adc][bea][cfb]",
    ),
    "Ceva, converse": (
        f"rank 3 {SIDES} given [abd][bce][caf] == [adc][bea][cfb]",
        r"ad /\ be /\ cf == 0",
        "[def] == 0",
    ),
    "complete quadrilateral": (
        # x and y, where the diagonal through two diagonal points meets two sides, are harmonic: (p, q; x, y) = -1
        "rank 3 points a b c d p q x y o given incident(p, ab), incident(p, cd), incident(q, ad), incident(q, bc),"
        "incident(x, ac), incident(x, pq), incident(y, bd), incident(y, pq)",
        "[opx][oqy] + [opy][oqx] == 0",
        "[opx][oqy] - [opy][oqx] == 0",
    ),
    "Moebius": (MOEBIUS, "[b1b2b3a4] == 0", "[b1b2b3a1] == 0"),
    "Gallucci": (GALLUCCI, "[p4q4xy] == 0", "[p4q3xy] == 0"),
    "three planes through a line": (
        r"given abc /\ def /\ ghk == 0",
        r"abc /\ def /\ ghk /\ xyz == 0",
        r"abc /\ def == 0",
    ),
    "planes through two points": (
        "given incident(x, abc), incident(y, abc), incident(x, def), incident(y, def), incident(xy, ghk)",
        r"abc /\ def /\ ghk == 0",
        "[abde] == 0",
    ),
    "planes through a point": (
        "given concurrent(abc, abd, cde, efg)",
        r"(abc /\ abd) /\ (cde /\ efg) == 0",
        "[abcd] == 0",
    ),
    "five in a plane": ("given coplanar(a, b, c, d), coplanar(a, b, c, e)", "[bcde] == 0", "[acef] == 0"),
    "a chain in a plane": (
        "given coplanar(a, b, c, d), coplanar(b, c, d, e), coplanar(c, d, e, f), coplanar(d, e, f, g)",
        "[aceg] == 0",
        "[aceh] == 0",
    ),
    "lines through a point in space": (
        "given concurrent(ab, cd, ef)",
        r"(ab /\ cdx) \/ ef == 0",
        "[abce] == 0",
    ),
    "a line in a plane": ("given incident(ab, cde)", "[abcd] == 0", "abc == 0"),
    "a line on a line": ("given incident(ab, cd)", "acd + bcd == 0", "ab == cd"),
    "a line of two planes in a plane": (r"given incident(abc /\ def, ghk)", r"abc /\ def /\ ghk == 0", "[abcd] == 0"),
    "equal points": ("rank 3 given ab == 0", "[acd][bce] == [bcd][ace]", "a == b"),
    "a value": ("rank 3 given p == 1/2 a + 1/2 b", "[apc] == 1/2 [abc]", "[apc] == [abc]"),
    "equations together": ("rank 3 given a - c == d - b, a == c", "b == d", "a == b"),
    "more equations": ("rank 3 given a + b == c + d, 2 a - (b + c) == c - d", "3 a == 3 c", "a == b"),
    "weights": ("rank 3 given [abc] == [abd]", "[abc] - [abd] == 0", "[abc] == 0"),
    "parallelogram": (
        PARALLELOGRAM,
        r"(ac /\ bd) \/ ([cij] a + [aij] c) == 0",
        r"(ac /\ bd) \/ ([cij] a - [aij] c) == 0",
    ),
    "midline": (f"{MIDPOINTS} ideal k given incident(k, bc)", "[mnk] == 0", "[mnj] == 0"),
    "Thomsen": (
        # Lines parallel to the sides of abc, drawn from a point of one side, close after six turns.
        "rank 3 points a b c p1 p2 p3 p4 p5 p6 ideal i j k given incident(i, bc), incident(j, ca), incident(k, ab)"
        "given incident(p1, ab), incident(p2, bc), incident(p2, p1 j), incident(p3, ca), incident(p3, p2 k),"
        "incident(p4, ab), incident(p4, p3 i), incident(p5, bc), incident(p5, p4 j), incident(p6, ca),"
        "incident(p6, p5 k)",
        "[p6 p1 i] == 0",
        "[p3 p1 i] == 0",
    ),
}


def script_of(text: str) -> Context:
    return parse_script(text).context


def decided(claim: str, at: Context, limit: int = 200_000) -> Proof:
    left, right = parse_equation(claim, context=at)
    return prove(left, right, points=at.points, ideal=at.ideal, rank=at.rank, given=at.given, limit=limit)


def vanish(es: Sequence[Expr], points: Mapping[str, Sequence[int]], rank: int, modulus: int | None = None) -> bool:
    """Whether expressions are zero; points that have no coordinates run through a basis."""
    basis = [tuple(int(i == j) for j in range(rank)) for i in range(rank)]
    for e in es:
        others = [n for n in points_of(e) if n not in points]
        for chosen in product(basis, repeat=len(others)):
            at = {**points, **dict(zip(others, chosen, strict=True))}
            if any(v % modulus if modulus else v for v in Evaluator(at, rank, modulus).value(e)):
                return False
    return True


def everything(at: Context) -> list[Expr]:
    return [e for a in at.given for e in equations(a, at.rank)]


def check(proof: Proof, at: Context) -> None:
    """What the verdict promises, evaluated anew."""
    difference = proof.left if proof.right == ex.ZERO else ex.sub(proof.left, proof.right, rank=at.rank)
    assumed = [parse(text, context=at) for text in proof.assumed]
    if proof.verdict == "refuted":
        points = proof.counterexample
        assert points is not None
        used = {n for a in at.given for e in a.args for n in points_of(e)}
        assert set(points) == used | set(points_of(proof.left, proof.right))
        assert vanish(everything(at), points, at.rank)
        assert not vanish([difference], points, at.rank)
        assert all((c[-1] == 0) == (n in at.ideal) for n, c in points.items())
        assert proof.values == (evaluate(proof.left, points), evaluate(proof.right, points))
        return
    assert proof.verdict == "proved"
    construction = resolve(at, points_of(proof.left, proof.right), [difference])
    drawn = 0
    for seed in range(1000, 1060):
        points = construction.rational_points(seed, 4)
        if points is not None:
            drawn += 1
            assert vanish(everything(at), points, at.rank)
            assert vanish([difference], points, at.rank)
            assert not any(vanish([e], points, at.rank) for e in assumed)
    assert drawn > 3


@pytest.mark.parametrize(("text", "claim", "sibling"), THEOREMS.values(), ids=THEOREMS)
def test_theorems(text: str, claim: str, sibling: str) -> None:
    at = script_of(text)
    for asked, verdict in ((claim, "proved"), (sibling, "refuted")):
        proof = decided(asked, at)
        assert proof.verdict == verdict, proof.text()
        check(proof, at)
    # Without the assumptions the theorem is none.
    bare = Context(at.rank, at.points, at.ideal, (), at.bound)
    assert decided(claim, bare).verdict == "refuted"


# --- the second road: all positions over a small field ------------------------------------------------------------


def positions(
    names: Sequence[str], at: Context, modulus: int, seed: int, number: int
) -> Iterator[dict[str, tuple[int, ...]]]:
    """Points of a small field, many of them equal or in line."""
    rng = random.Random(seed)

    def vector(ideal: bool) -> tuple[int, ...]:
        while True:
            v = [rng.randrange(modulus) for _ in range(at.rank)]
            if ideal:
                v[-1] = 0
            if any(v):
                return tuple(v)

    for _ in range(number * (4 if at.ideal else 1)):
        few = [vector(False) for _ in range(rng.randint(2, 6))]
        found = {}
        for n in names:
            if n in at.ideal:
                found[n] = vector(True)
                continue
            u, v, k = rng.choice(few), rng.choice(few), rng.randrange(modulus)
            on = tuple((x + k * y) % modulus for x, y in zip(u, v, strict=True))
            found[n] = on if any(on) else u
        # Where some points are at infinity, the others are finite; else no plane is singled out.
        if not at.ideal or all(found[n][-1] for n in names if n not in at.ideal):
            yield found


def check_everywhere(proofs: Sequence[Proof], at: Context, names: Sequence[str], seed: int, number: int) -> int:
    """Proved claims hold at every position that satisfies the assumptions; returns how many were looked at."""
    wanted = everything(at)
    told = [(p, ex.sub(p.left, p.right, rank=at.rank), [parse(t, context=at) for t in p.assumed]) for p in proofs]
    seen = 0
    for modulus in (2, 3):
        for points in positions(names, at, modulus, seed, number):
            if not vanish(wanted, points, at.rank, modulus):
                continue
            for proof, difference, assumed in told:
                if not any(vanish([e], points, at.rank, modulus) for e in assumed):
                    seen += 1
                    assert vanish([difference], points, at.rank, modulus), (at.given, proof.text(), points, modulus)
    return seen


SMALL = [
    "Pappus", "five in a plane", "a line in a plane", "a line on a line", "three planes through a line", "equal points",
    "planes through a point", "Ceva", "Menelaus", "lines through a point in space", "Desargues, lines",
    "a chain in a plane", "parallelogram", "Ceva, converse",
]  # fmt: skip


@pytest.mark.parametrize("name", SMALL)
def test_theorems_over_small_fields(name: str) -> None:
    text, claim, _ = THEOREMS[name]
    at = script_of(text)
    proof = decided(claim, at)
    names = resolve(at, points_of(proof.left, proof.right)).names
    assert check_everywhere([proof], at, names, 5, 2500) > 20


def _kinds_of_assumptions(rank: int, some: Callable[[int], Sequence[str]], most: int) -> list[Callable[[], str]]:
    """Texts of assumptions about the points that `some` draws; `most` points are collinear."""

    def run(n: int) -> str:
        return "".join(some(n))

    plane = [
        lambda: f"collinear({', '.join(some(most))})",
        lambda: f"collinear({', '.join(some(3))})",
        lambda: f"incident({run(1)}, {run(2)})",
        lambda: f"concurrent({run(2)}, {run(2)}, {run(2)})",
        lambda: r"incident({}, {}{} /\ {}{})".format(*some(5)),
        lambda: f"{run(2)} == 0",
        lambda: rf"collinear({', '.join(some(2))}, {run(2)} /\ {run(2)})",
        lambda: f"incident({run(2)}, {run(2)})",
        lambda: rf"[{run(3)}] * ({run(2)} /\ {run(2)} /\ {run(2)}) == 0",
        lambda: f"[{run(3)}] == [{run(3)}]",
        lambda: f"[{run(3)}][{run(3)}] == [{run(3)}][{run(3)}]",
        lambda: "{0} == [{1}{2}{3}] {4} - 2[{1}{2}{4}] {3}".format(*some(5)),
        lambda: "incident({0}, {2}{3}), incident({1}, {2}{3})".format(*some(4)),
    ]
    space = [
        lambda: f"coplanar({', '.join(some(4))})",
        lambda: f"coplanar({', '.join(some(5))})",
        lambda: f"collinear({', '.join(some(3))})",
        lambda: f"incident({run(2)}, {run(3)})",
        lambda: f"concurrent({run(2)}, {run(2)}, {run(2)})",
        lambda: f"concurrent({run(2)}, {run(2)})",
        lambda: rf"incident({run(1)}, {run(3)} /\ {run(3)})",
        lambda: rf"{run(3)} /\ {run(3)} == 0",
        lambda: rf"{run(3)} /\ {run(3)} /\ {run(3)} == 0",
        lambda: rf"incident({run(3)} /\ {run(3)}, {run(3)})",
        lambda: f"concurrent({run(3)}, {run(3)}, {run(3)}, {run(3)})",
        lambda: rf"coplanar({', '.join(some(3))}, {run(2)} /\ {run(3)})",
        lambda: "incident({0}, {2}{3}{4}), incident({1}, {2}{3}{4})".format(*some(5)),
        lambda: "incident({0}{1}, {2}{3}{4}), incident({5}, {2}{3}{4})".format(*some(6)),
    ]
    return plane if rank == 3 else space


def _assumption(rank: int, draw: st.DrawFn) -> str:
    most = draw(st.integers(3, 4))
    return draw(st.sampled_from(_kinds_of_assumptions(rank, lambda n: draw(st.permutations("abcdef"))[:n], most)))()


@st.composite
def assumptions(draw: st.DrawFn, most: int = 4) -> tuple[int, list[str], str]:
    rank = draw(st.sampled_from([3, 3, 4]))
    ideal = draw(st.sampled_from(["", "", "a", "ab", "ef", "cde"]))
    return rank, [_assumption(rank, draw) for _ in range(draw(st.integers(1, most)))], ideal


def context_of(rank: int, texts: Sequence[str], ideal: str) -> Context | None:
    at = Context(rank, tuple("abcdef"), tuple(ideal))
    try:
        for t in texts:
            at = parse_assumption(t, at)
        resolve(at, "abcdef")
    except InputError:
        return None
    return at


@settings(max_examples=60)
@given(assumptions(), st.integers(0, 1000))
def test_nothing_false_is_proved(case: tuple[int, list[str], str], seed: int) -> None:
    rank, texts, ideal = case
    at = context_of(rank, texts, ideal)
    if at is None:
        return
    found = [kind.construction for kind in kinds(at, "abcdef")]
    dependent = [f"{''.join(some)} == 0" for k in range(2, rank) for some in combinations("abcdef", k)]
    claims = dependent + [f"[{''.join(some)}] == 0" for some in combinations("abcdef", rank)]
    proofs = []
    for claim in claims:
        left, right = parse_equation(claim, context=at)
        if all(c.vanishes(left) for c in found):
            proofs.append(prove(left, right, points=at.points, ideal=at.ideal, rank=rank, given=at.given))
            assert proofs[-1].verdict == "proved"
    if proofs:
        check_everywhere(proofs, at, "abcdef", seed, 250)
    refuted = [c for c in claims if not all(k.vanishes(parse_equation(c, context=at)[0]) for k in found)]
    if refuted:
        proof = decided(refuted[seed % len(refuted)], at)
        assert proof.verdict == "refuted"
        check(proof, at)


@settings(max_examples=40)
@given(assumptions(), st.randoms(use_true_random=False))
def test_order_does_not_matter(case: tuple[int, list[str], str], rng: random.Random) -> None:
    rank, texts, ideal = case
    at = context_of(rank, texts, ideal)
    shuffled = [shuffle(t, rng) for t in texts]
    rng.shuffle(shuffled)
    other = context_of(rank, shuffled, ideal)
    assert (at is None) == (other is None), (texts, shuffled)
    if at is None or other is None:
        return
    claim = f"[{''.join(rng.sample('abcdef', rank))}] == 0"
    assert decided(claim, at).verdict == decided(claim, other).verdict


def shuffle(text: str, rng: random.Random) -> str:
    """Arguments of collinear, coplanar and concurrent in another sequence."""
    kind, _, inside = text.partition("(")
    if kind not in ("collinear", "coplanar", "concurrent"):
        return text
    args = inside.rstrip(")").split(", ")
    rng.shuffle(args)
    return f"{kind}({', '.join(args)})"


# --- what was assumed ----------------------------------------------------------------------------------------------

ASSUMED = [
    # one dependency of free points: its positions are the closure of those that are reached
    (3, "collinear(a, b, c)", "[abc] == 0", ()),
    (4, "coplanar(a, b, c, d), collinear(e, f, g)", "efg == 0", ()),
    # two that share points: a and b could be one point, and c and d anywhere
    (3, "collinear(a, b, c), collinear(a, b, d)", "[acd] == 0", ("ab",)),
    (4, "coplanar(a, b, c, d), coplanar(a, b, c, e)", "[abde] == 0", ("abc",)),
    (3, r"incident(p, ab /\ cd)", "[pab] == 0", (r"ab /\ cd",)),
    (3, "p == a + b", "[pab] == 0", ()),
]


@pytest.mark.parametrize(("rank", "assumption", "claim", "assumed"), ASSUMED)
def test_assumed(rank: int, assumption: str, claim: str, assumed: tuple[str, ...]) -> None:
    proof = gc.prove(claim, rank=rank, given=assumption)
    assert (proof.verdict, proof.assumed) == ("proved", assumed)
    assert proof.to_json()["assumed"] == list(assumed)
    assert ("assumed not to vanish" in proof.text()) == bool(assumed)


def test_words_of_what_was_assumed() -> None:
    text = gc.prove("[acd] == 0", rank=3, given=["collinear(a, b, c)", "collinear(a, b, d)"]).text()
    assert "assumed not to vanish: ab (the points a and b differ)" in text


def test_the_other_component_is_excluded() -> None:
    """Where a and b are one point, c and d need not be in line with it; the answer says that it leaves this out."""
    at = parse_assumption("collinear(a, b, c), collinear(a, b, d)", Context(3))
    points = {"a": (0, 0, 1), "b": (0, 0, 1), "c": (1, 0, 1), "d": (0, 1, 1)}
    assert vanish(everything(at), points, 3)
    assert not vanish([parse("[acd]", rank=3)], points, 3)


REDUNDANT = [
    (3, "collinear(a, b, c), collinear(b, c, d), collinear(c, d, a), collinear(d, a, b)", "[abd] == 0"),
    (4, "[abcd] == 0, [abcd] == 0, [bacd] == 0, [abcd]**2 == 0", "[abcd] == 0"),
    (4, "collinear(a, b, c), coplanar(a, b, c, d)", "abc == 0"),
    (3, "coplanar(a, b, c, d), collinear(a, b, c)", "[abc] == 0"),
    (4, "[aabc] == 0, 0 == 0, concurrent(abc, def), concurrent(ab, cde)", "[aabc] == 0"),
    (4, "incident(p, abc), incident(p, ab)", "abp == 0"),
    # nine lines with three points each: the ninth follows by the theorem of Pappus
    (
        3,
        "collinear(a, b, c), collinear(d, e, f), collinear(x, b, f), collinear(x, c, e), collinear(y, c, d),"
        "collinear(y, a, f), collinear(z, a, e), collinear(z, b, d), collinear(x, y, z)",
        "[xyz] == 0",
    ),
]


@pytest.mark.parametrize(("rank", "assumption", "claim"), REDUNDANT)
def test_assumptions_that_follow_from_others(rank: int, assumption: str, claim: str) -> None:
    proof = gc.prove(claim, rank=rank, given=assumption)
    assert proof.verdict == "proved"
    check(proof, parse_assumption(assumption, Context(rank)))


# --- what is refused ------------------------------------------------------------------------------------------------

REFUSED = [
    (4, "1 == 0", "1 is not 0"),
    (4, "a == 0", "never zero"),
    (4, "ab == cd", "not linear"),
    (4, "[abcd] == 1", "not linear"),
    (4, "[abcd][abef] + [cdef][abce] == [cdef]**2", "not linear"),
    (4, "ideal i j k, collinear(i, a, j)", "the finite point a would have to lie at infinity"),
    (4, "ideal p, p == a", "would have to lie at infinity"),
    (3, "collinear(a, b, c), [abc] == 1", ""),
    # the plane of seven points, of which only degenerate ones exist
    (
        3,
        "incident(x, ab), incident(x, cd), incident(y, ac), incident(y, bd), incident(z, ad),incident(z, bc),[xyz]==0",
        "asks too much",
    ),
    (3, r"abc /\ def == 0", "step 4"),
    (4, r"concurrent(ab, cd, efg)", "name the point"),
    (6, r"incident(abcde /\ fghij, klmn /\ opqrs)", "no join of points"),
    (4, r"concurrent(abc /\ def, gh, kl)", "name the point"),
]


@pytest.mark.parametrize(("rank", "assumption", "why"), REFUSED)
def test_refused(rank: int, assumption: str, why: str) -> None:
    with pytest.raises(InputError) as found:
        gc.prove("a == b", rank=rank, given=assumption)
    assert "cannot be resolved" in found.value.message
    assert why in found.value.render()
    assert found.value.exit_code == 2
    assert found.value.span is not None


EQUATIONS = [
    "a - c == d - b, a == c",
    "a == c, a - c == d - b",
    "a == c, a - (d - b) == c",
    "a + b == c + d, c == a",
    "a + b - (c + d) == 0, 2 a - c == a",
    "a + b == c + d, a - b == c - d",
    "c == a, -(c + d) == -a - b, b == d",
    "d == a + b - c, 1/2 a == 1/2 c",
]


@pytest.mark.parametrize("text", EQUATIONS)
def test_spelling_of_equations_does_not_matter(text: str) -> None:
    for names in ("a b c d", "d c b a", "c a d b"):
        at = Context(3, tuple(names.split()))
        for claim, verdict in (("a == c", "proved"), ("b == d", "proved"), ("[abe] == 0", "refuted")):
            proof = gc.prove(claim, rank=3, points=names, given=text)
            assert (proof.verdict, proof.assumed) == (verdict, ())
            check(proof, parse_assumption(text, at))


@pytest.mark.parametrize(
    ("given", "claim", "sibling"),
    [
        ("PRIME [abc] + PRIME [abd] == 0", "[abc] == -[abd]", "[abc] == 0"),
        ("PRIME a + PRIME b == PRIME c", "a + b == c", "a == c"),
        ("a == c + PRIME d", "[acd] == 0", "[abd] == 0"),
        ("[abc] + PRIME [abd] == 0", "[abc] == -PRIME [abd]", "[abd] == 0"),
    ],
)
def test_multiples_of_the_prime_are_not_dropped(given: str, claim: str, sibling: str) -> None:
    # the prime of the oracle: a condition that is a multiple of it is still one
    given, claim, sibling = (text.replace("PRIME", str(PRIME)) for text in (given, claim, sibling))
    assert gc.prove(claim, rank=3, given=given).verdict == "proved"
    proof = gc.prove(sibling, rank=3, given=given)
    assert proof.verdict == "refuted"
    check(proof, parse_assumption(given, Context(3)))


def test_a_script_names_the_line() -> None:
    script = parse_script("rank 3\n\ngiven collinear(a, b, c),\n      [abc] == 1\nclaim a == b\n", "file.gca")
    with pytest.raises(InputError) as found:
        run_script(script)
    assert found.value.place == "file.gca:4:7"


# --- interfaces -----------------------------------------------------------------------------------------------------


def test_each_claim_has_the_assumptions_before_it() -> None:
    found = run_script(
        parse_script(
            "rank 3 claim [abc]==0 given collinear(a, b, c) claim [abc]==0 given collinear(a, b, d) claim [bcd]==0"
        )
    )
    assert [c.verdict for c in found.claims] == ["refuted", "proved", "proved"]
    assert "ab (the points a and b differ)" in found.text()


def test_given_as_text_or_several() -> None:
    one = gc.prove("[bcd] == 0", rank=3, given="collinear(a, b, c), collinear(a, b, d)")
    two = gc.prove("[bcd] == 0", rank=3, given=["collinear(a, b, c)", "collinear(a, b, d)"])
    assert one == two
    e = gc.parse("[bcd]", rank=3)
    assert gc.prove(e, ex.ZERO, given="collinear(a, b, c), collinear(a, b, d)").proved


def test_command_line() -> None:
    def run(*words: str) -> Result:
        return CliRunner().invoke(cli, ["prove", *words])

    done = run("[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c)", "--given=collinear(a, b, d)", "--json")
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["assumed"] == ["ab"]
    assert run("[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c)").exit_code == 1
    assert run("ijk == 0", "--given", "ideal i j, collinear(i, j, k)").exit_code == 2
    assert run("ijk == 0", "--given", "ideal i j k, collinear(i, j, k)").exit_code == 0
    assert run("abc == 0", "--given", "collinear(a, b, c) claim a == b").exit_code == 2
    assert run("a == b", "--given", "").exit_code == 2
    shown = run("[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c), collinear(a, b, d)", "--latex").stdout
    assert "% " in shown.splitlines()[-1]
    assert "assumed not to vanish" in shown.splitlines()[-1]


def test_long_names() -> None:
    proof = gc.prove(
        "[left right top] == 0",
        rank=3,
        points="left right top base",
        given="collinear(left, right, base), incident(top, left right)",
    )
    assert proof.proved
    assert proof.assumed == ("left right",)


def test_names_bound_by_let() -> None:
    found = run_script(
        parse_script(
            r"rank 3 let x = ab/\cd given incident(p, x) let l = ac given incident(q, l) claim [pab]==0 claim [qac]==0"
        )
    )
    assert found.verdict == "proved"


def test_undecided_says_so() -> None:
    text, claim, _ = THEOREMS["Moebius"]
    proof = decided(claim, script_of(text), limit=10)
    assert proof.verdict == "undecided"
    assert "satisfy the assumptions" in proof.reason
    assert "limit" in proof.reason


def test_random_points_satisfy_the_assumptions() -> None:
    for text, *_ in THEOREMS.values():
        at = script_of(text)
        construction = resolve(at)
        points = construction.random_points(7)
        assert vanish(everything(at), points, at.rank, PRIME)
        assert all(points[n][-1] == 0 for n in construction.names if n in at.ideal)


def one(text: str, at: Context) -> Assumption:
    return parse_assumption(text, Context(at.rank, at.points, at.ideal)).given[0]


HOLDS = [
    ("rank 3", "collinear(a, b, c)", False),
    ("rank 3", "coplanar(a, b, c, d)", True),
    ("rank 3", "collinear(a, b, ab /\\ cd)", True),
    ("rank 3 given collinear(a, b, c), collinear(a, b, d)", "collinear(a, b, c, d)", True),
    ("rank 3 given collinear(a, b, c), collinear(a, d, e)", "collinear(a, b, c, d)", False),
    ("given incident(q, ab), incident(q, cd), incident(q, ef)", "concurrent(ab, cd, ef)", True),
    ("given coplanar(a, b, c, d), coplanar(a, b, e, f), coplanar(c, d, e, f)", "concurrent(ab, cd, ef)", True),
    ("given coplanar(a, b, c, d), coplanar(a, b, c, e), coplanar(a, b, c, f)", "concurrent(ab, cd, ef)", False),
    ("given concurrent(ab, cd, ef)", "concurrent(cd, ef, ab)", True),
    ("", "[abcd] == -[bacd]", True),
    ("ideal i j k l", "coplanar(i, j, k, l)", True),
    ("", "coplanar(i, j, k, l)", False),
]


@pytest.mark.parametrize(("text", "assumption", "expected"), HOLDS)
def test_holds(text: str, assumption: str, expected: bool) -> None:
    at = script_of(text)
    assert holds(one(assumption, at), at) is expected


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
    said = [(k.verdict, k.where, [parse(t, context=at) for t in k.assumed]) for k in proof.kinds]
    said = said or [(proof.verdict, (), [parse(t, context=at) for t in proof.assumed])]
    for points in positions(names, at, 7, 11, 4000):
        if not vanish(wanted, points, at.rank, 7):
            continue
        here = [
            (verdict, assumed)
            for verdict, where, assumed in said
            if vanish([parse(t, context=at) for t in where], points, at.rank, 7)
        ]
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


@pytest.mark.parametrize("part", range(8))
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
    with pytest.raises(InputError, match="no construction that was tried satisfies it; in the one that came farthest,"):
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
