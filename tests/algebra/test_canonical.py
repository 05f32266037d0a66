"""Canonical names: the same problem gets the same ones, whatever its points are called and however it is written."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from itertools import combinations, permutations

import pytest

from gcrules.algebra import expr as ex
from gcrules.algebra.canonical import Canonical, canonical
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.expr import Expr, Point, points_of
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.parts import substitute
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import Assumption
from gcrules.algebra.spelling import normal

ASSUMPTIONS = [
    (3, "collinear(a, b, c), collinear(a, b, d)"),
    (3, "[abe][acd] == [abc][aed], collinear(a, b, c)"),
    (3, "concurrent(ae, fd, fe), [cfd][fbe] == [cad][bae], incident(e, da)"),
    (3, r"collinear(a, b, cd /\ ef), m == [bij] a + [aij] b, [abc]**2 [def] == 2/3 [abd][cef][abc]"),
    (3, "incident(x, bc), incident(x, ef), incident(y, ca), incident(y, fd), incident(z, ab), incident(z, de)"),
    (3, "[abc][ade][bdf][cef] == [abd][ace][bcf][def]"),
    (4, "coplanar(a, b, c, h), coplanar(a, b, d, g), coplanar(a, c, d, f), coplanar(b, c, d, e), coplanar(e, f, g, d)"),
    (4, r"incident(bac /\ eaf, bfd), concurrent(ab, cd, ef), abd /\ dec /\ afb == 0"),
    (4, "[[ab, cd, ef, gh, ij, kl]] == 0, [a'bcd][a'efg] == 0"),
    (3, ", ".join(f"collinear({', '.join(some)})" for some in ("abc", "def", "ghi", "adg", "beh", "cfi"))),
    (3, ", ".join(f"incident({a}, {b}{c})" for a, b, c in permutations("abcd", 3))),
    (3, "collinear(a, b, c, d, e, f, g, h, i, j, k, l)"),
    # what is said of some points, or of all, cancels
    (3, r"[cbe] * (ab /\ ba /\ fe) == 0, be == 0"),
    (3, "[adf] == [fad]"),
]


def problem(rank: int, given: Sequence[Assumption], ideal: Sequence[str], claim: Sequence[Expr] = ()) -> Canonical:
    names = points_of(*(e for a in given for e in a.args), *claim)
    return canonical(rank, names, ideal, given, claim)


def spelled(e: Expr, names: Mapping[str, Expr], rank: int, rng: random.Random) -> Expr:
    """With other names; points of brackets and lines, factors and terms in another sequence (a sign is kept)."""
    match e:
        case ex.Point():
            return names[e.name]
        case ex.Bracket(args=args):
            i, j = rng.sample(range(len(args)), 2)
            moved = [spelled(a, names, rank, rng) for a in args]
            if moved[i].step % 2 and moved[j].step % 2:
                moved[i], moved[j] = moved[j], moved[i]
                return ex.neg(bracket(*moved, rank=rank))
            return bracket(*moved, rank=rank)
        case ex.Sum(terms=terms):
            return ex.add(*(spelled(t, names, rank, rng) for t in rng.sample(terms, len(terms))), rank=rank)
        case ex.Product(factors=factors):
            return ex.mul(*(spelled(f, names, rank, rng) for f in rng.sample(factors, len(factors))))
    return substitute(e, dict(names), rank)


@pytest.mark.parametrize(("rank", "text"), ASSUMPTIONS)
def test_the_same_problem_in_other_words(rank: int, text: str) -> None:
    given = parse_assumption(text, Context(rank)).given
    names = points_of(*(e for a in given for e in a.args))
    rng = random.Random(text)
    claim = bracket(*map(Point, names[:rank]), rank=rank)
    for ideal in ((), names[:1], names[-2:]):
        expected = problem(rank, given, ideal, [claim])
        place = {n: i for i, n in enumerate(expected.points)}
        inside = {n: Point(new) for n, new in expected.names.items()}
        for _ in range(3):
            other: dict[str, Expr] = dict(zip(names, map(Point, rng.sample(names, len(names))), strict=True))
            renamed = []
            for a in rng.sample(given, len(given)):
                args = [spelled(e, other, rank, rng) for e in a.args]
                if a.kind != "zero":
                    rng.shuffle(args)
                renamed.append(Assumption(a.kind, tuple(args), f"another {a.text}"))
            moved = [str(other[n]) for n in ideal]
            asked = substitute(claim, other, rank)
            found = problem(rank, [*renamed, renamed[0]], moved, [asked])
            assert found.given == expected.given
            assert {found.names[n] for n in moved} == {expected.names[n] for n in ideal}
            there: dict[str, Expr] = {n: Point(new) for n, new in found.names.items()}
            one, two = (substitute(e, dict(at), rank) for e, at in ((claim, inside), (asked, there)))
            assert normal(one, place, rank).key == normal(two, place, rank).key


@pytest.mark.parametrize(("rank", "text"), ASSUMPTIONS)
def test_symmetries_leave_the_assumptions_as_they_are(rank: int, text: str) -> None:
    given = parse_assumption(text, Context(rank)).given
    found = problem(rank, given, ())
    for symmetry in found.symmetries:
        moved = [
            Assumption(
                a.kind, tuple(substitute(e, {o: Point(n) for o, n in symmetry.items()}, rank) for e in a.args), ""
            )
            for a in found.given
        ]
        names = {n: n for n in found.points}
        assert canonical(rank, names, (), moved).given == found.given


def test_all_symmetries_are_found() -> None:
    """Three lines that meet three others in nine points: the group is counted in another way."""
    lines = ("abc", "def", "ghi", "adg", "beh", "cfi")
    given = parse_assumption(", ".join(f"collinear({', '.join(x)})" for x in lines), Context(3)).given
    found = problem(3, given, ())
    group = {found.points}
    waiting = [found.points]
    for at in waiting:
        for s in found.symmetries:
            image = tuple(s[n] for n in at)
            if image not in group:
                group.add(image)
                waiting.append(image)
    sets = {frozenset(x) for x in lines}
    slow = 0
    for rows in permutations(range(3)):
        for columns in permutations(range(3)):
            for turned in (False, True):
                place = {"abcdefghi"[3 * i + j]: (rows[i], columns[j]) for i in range(3) for j in range(3)}
                moved = {n: "abcdefghi"[3 * j + i if turned else 3 * i + j] for n, (i, j) in place.items()}
                slow += {frozenset(moved[n] for n in x) for x in lines} == sets
    assert len(group) == slow == 72


SCALARS = ["[bad][cef] - 2[cab][fed]", "[abc]**2 [def] + [cba]**2 [edf]", r"[ab /\ cd, e, f] + 3[f, ba /\ cd, e]"]


@pytest.mark.parametrize("text", SCALARS)
def test_one_form_has_the_same_value(text: str) -> None:
    e = parse(text, rank=3)
    for seed, order in enumerate(("abcdef", "fedcba", "cafbed")):
        found = normal(e, {n: i for i, n in enumerate(order)}, 3)
        points = random_rational_points("abcdef", rank=3, seed=seed)
        assert found.factor * (evaluate(found.expr, points) if found.factor else 0) == evaluate(e, points)


def test_any_number_of_points_that_are_alike() -> None:
    names = [f"{x}{i}" for x in "abcdefgh" for i in range(8)]
    given = [Assumption("collinear", tuple(map(Point, names)), "on a line")]
    assert len(canonical(3, names, (), given).points) == 64
    pairs = [Assumption("zero", (ex.join(Point(a), Point(b), rank=3),), "") for a, b in combinations(names[:8], 2)]
    one, two = (
        canonical(3, names[:8], (), rng.sample(pairs, 28)).given for rng in (random.Random(1), random.Random(2))
    )
    assert one == two
