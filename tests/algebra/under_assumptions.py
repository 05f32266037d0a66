"""Claims decided under assumptions, and answers checked on exact points."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from itertools import product

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.assumed import equations, resolve
from gcrules.algebra.evaluate import Evaluator, evaluate
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.prove import Proof, prove
from gcrules.algebra.space import Assumption

__all__ = [
    "DESARGUES",
    "GALLUCCI",
    "MIDPOINTS",
    "MOEBIUS",
    "PARALLELOGRAM",
    "PERSPECTIVE",
    "SIDES",
    "THEOREMS",
    "_kinds_of_assumptions",
    "check",
    "decided",
    "everything",
    "one",
    "positions",
    "script_of",
    "shuffle",
    "vanish",
]

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
        others = [n for n in _names(e) if n not in points]
        for chosen in product(basis, repeat=len(others)):
            at = {**points, **dict(zip(others, chosen, strict=True))}
            if any(v % modulus if modulus else v for v in Evaluator(at, rank, modulus).value(e)):
                return False
    return True


_names = cache(points_of)


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


def shuffle(text: str, rng: random.Random) -> str:
    """Arguments of collinear, coplanar and concurrent in another sequence."""
    kind, _, inside = text.partition("(")
    if kind not in ("collinear", "coplanar", "concurrent"):
        return text
    args = inside.rstrip(")").split(", ")
    rng.shuffle(args)
    return f"{kind}({', '.join(args)})"


def one(text: str, at: Context) -> Assumption:
    return parse_assumption(text, Context(at.rank, at.points, at.ideal)).given[0]
