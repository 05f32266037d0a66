"""Duals, compared with a random linear map from points to hyperplanes, and with lines in coordinates modulo a prime."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations
from random import Random

import pytest
from faults import refused
from places import checker

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.incidences import equations
from gcrules.algebra.duality import dual
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.language.relations import parse_claim
from gcrules.algebra.language.statements import parse_assumption, parse_letters, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.letters import letter_of, letters_of, names_of
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.rules.script import ClaimResult, run_script

EXPRESSIONS = [
    (3, "", "ab /\\ cd"),
    (3, "", "(ab /\\ cd) \\/ e"),
    (3, "", "[abc] [ade] - 2 [abd] [ace]"),
    (3, "", "[[ab, cd, ef]]"),
    (3, "line L", "[a L] (b \\/ (L /\\ cd))"),
    (4, "", "ab /\\ cde"),
    (4, "", "abc /\\ ade"),
    (4, "", "abf /\\ ace /\\ edf /\\ cbd"),
    (4, "", "[[ab, ac, bd, ce, df, ef]]"),
    (4, "", "[.a b c d][.e f g h]"),
    (4, "line L M, plane P", "[L M] [a P] - [(L /\\ P), a, M]"),
    (5, "plane P", "(P /\\ abcd) \\/ e"),
]


def _null(rows: Sequence[Sequence[int]], rank: int) -> list[list[int]]:
    """Independent vectors x with row · x = 0, modulo the prime."""
    rows, pivots = [list(r) for r in rows], []
    for r, row in enumerate(rows):
        p = next(i for i, v in enumerate(row) if v % PRIME)
        inverse = pow(row[p], -1, PRIME)
        rows[r] = row = [v * inverse % PRIME for v in row]
        rows[:] = [
            [(v - other[p] * w) % PRIME for v, w in zip(other, row, strict=True)] if other is not row else row
            for other in rows
        ]
        pivots.append(p)
    free = [i for i in range(rank) if i not in pivots]
    found = []
    for f in free:
        x = [0] * rank
        x[f] = 1
        for row, p in zip(rows, pivots, strict=True):
            x[p] = -row[f] % PRIME
        found.append(x)
    return found


def _determinant(m: Sequence[Sequence[int]]) -> int:
    total = 0
    for order in permutations(range(len(m))):
        sign = (-1) ** sum(order[i] > order[j] for i in range(len(m)) for j in range(i + 1, len(m)))
        for i, j in enumerate(order):
            sign *= m[i][j]
        total += sign
    return total % PRIME


def _spanning(space: Sequence[Sequence[int]], covector: Sequence[int]) -> list[list[int]]:
    """The points of a hyperplane, scaled so that its bracket with x is covector · x."""
    rank = len(covector)
    at = next(i for i, v in enumerate(covector) if v % PRIME)
    unit = [int(i == at) for i in range(rank)]
    have = _determinant([*space, unit])
    scale = covector[at] * pow(have, -1, PRIME) % PRIME
    return [[v * scale % PRIME for v in space[0]], *map(list, space[1:])]


@pytest.mark.parametrize(("rank", "letters", "written"), EXPRESSIONS)
def test_the_dual_has_the_value_of_the_expression(rank: int, letters: str, written: str) -> None:
    at = parse_letters(letters, Context(rank)) if letters else Context(rank)
    e, rng = parse(written, context=at), Random(written)
    points = {n: [rng.randrange(PRIME) for _ in range(rank)] for n in ex.points_of(e)}
    other = dual(e, rank)
    places: dict[str, list[int]] = {n: points[n] for n in points if letter_of(n) is None}
    covectors = {}
    for n in list(places):
        covectors[n] = places.pop(n)
        places |= dict(zip(names_of(n, rank - 1), _spanning(_null([covectors[n]], rank), covectors[n]), strict=True))
    for name, step in letters_of(points).items():
        # The letter is the meet of the hyperplanes whose covectors are its points; its scale is found from the meet.
        rows = [points[n] for n in names_of(name, step)]
        space = _null(rows, rank)
        planes = {f"h{i}": _spanning(_null([r], rank), r) for i, r in enumerate(rows)}
        values = {m: v for h, some in planes.items() for m, v in zip(names_of(h, rank - 1), some, strict=True)}
        meet = ex.meet(*(dual(ex.Point(h), rank) for h in planes), rank=rank)
        met = Evaluator(values, rank, PRIME).value(meet)
        names = [f"q{i}" for i in range(rank - step)]
        flat = ex.join(*map(ex.Point, names), rank=rank)
        joined = Evaluator(dict(zip(names, space, strict=True)), rank, PRIME).value(flat)
        i = next(i for i, v in enumerate(joined) if v % PRIME)
        scale = met[i] * pow(joined[i], -1, PRIME) % PRIME
        assert all((m - scale * j) % PRIME == 0 for m, j in zip(met, joined, strict=True))
        space[0] = [v * scale % PRIME for v in space[0]]
        places |= dict(zip([name] if rank - step == 1 else names_of(name, rank - step), space, strict=True))
    basis = {f"h{i}": [int(i == j) for j in range(rank)] for i in range(rank)}
    spans = {h: _spanning(_null([u], rank), u) for h, u in basis.items()}
    values = {m: v for h, some in spans.items() for m, v in zip(names_of(h, rank - 1), some, strict=True)}
    whole = ex.meet(*(dual(ex.Point(h), rank) for h in basis), rank=rank)
    volume = Evaluator(values, rank, PRIME).value(whole)[0]
    assert volume % PRIME in (1, PRIME - 1)
    left = Evaluator(points, rank, PRIME).value(e)
    right = Evaluator(places, rank, PRIME).value(other)
    assert other.step == (rank - e.step if e.step else 0)
    if e.step == 0:
        degree = sum(points_in(e, rank)) // rank
        assert (left[0] - pow(volume, degree, PRIME) * right[0]) % PRIME == 0
        return
    assert any(v % PRIME for v in right)


def points_in(e: ex.Expr, rank: int) -> list[int]:
    """How often each point occurs in every term."""
    p = gc.expand(e, rank=rank)
    return list((p.degrees() or {}).values())


PAPPUS = (
    "rank 3 given collinear(a, b, c), collinear(d, e, f) let x = bf /\\ ec let y = cd /\\ fa let z = ae /\\ db"
    " claim dual([x, y, z] == 0) claim dual([x, y, a] == 0)"
)
DESARGUES = (
    "rank 3 given concurrent(ad, be, cf) claim dual([(ab /\\ de), (bc /\\ ef), (ca /\\ fd)] == 0)"
    " claim dual([(ab /\\ de), (bc /\\ ef), a] == 0)"
)


def _lines_in_place(names: str) -> dict[str, list[int]]:
    """Lines c and f in the pencils of a and b and of d and e; or d, e and f in those of o with a, b and c."""
    rng = Random(names)
    found = {n: [rng.randrange(PRIME) for _ in range(3)] for n in "abcdefo"}
    pencils = {"pappus": ("cab", "fde"), "desargues": ("dao", "ebo", "fco")}
    for n, p, q in pencils[names]:
        s, t = rng.randrange(PRIME), rng.randrange(PRIME)
        found[n] = [(s * x + t * y) % PRIME for x, y in zip(found[p], found[q], strict=True)]
    return found


@pytest.mark.parametrize(("name", "script"), [("pappus", PAPPUS), ("desargues", DESARGUES)])
def test_duals_of_theorems_hold_of_lines_as_they_are_printed(name: str, script: str) -> None:
    covectors = _lines_in_place(name)
    places = {
        m: v for n, h in covectors.items() for m, v in zip(names_of(n, 2), _spanning(_null([h], 3), h), strict=True)
    }
    results = [r.proof for r in run_script(parse_script(script)).results if isinstance(r, ClaimResult)]
    for proof, verdict in zip(results, ("proved", "refuted"), strict=True):
        assert proof is not None
        assert proof.dual is not None
        assert proof.verdict == verdict
        at = Context(3)
        for written in (*proof.dual.letters, *proof.dual.given):
            at = parse_assumption(written, at)
        for e in (a for one in at.given for a in equations(one, 3)):
            assert not any(v % PRIME for v in Evaluator(places, 3, PRIME).value(e))
        (claim,) = proof.dual.claims
        ((left, right),) = parse_claim(claim, at).equations
        assert right == ex.ZERO
        assert any(v % PRIME for v in Evaluator(places, 3, PRIME).value(left)) == (verdict == "refuted")


def test_the_answer_says_what_the_dual_is() -> None:
    found = gc.prove("dual([abcd] == 0)", given="coplanar(a, b, c, d)")
    assert found.text().splitlines()[:3] == [
        "proved: dual([abcd] == 0)",
        "  plane a b c d",
        "  the dual: a /\\ b /\\ c /\\ d == 0 where concurrent(a, b, c, d)",
    ]
    assert found.to_json()["dual"]["letters"] == ["plane a b c d"]
    assert "the dual fails at the hyperplanes with these coordinates" in gc.prove("dual([abcd] == 0)").text()


def test_the_proof_file_of_a_dual_is_that_of_what_it_is_the_dual_of() -> None:
    (theorem,) = gc.proof_file(gc.prove("dual([abcd] == 0)", given="coplanar(a, b, c, d)")).theorems
    assert theorem.name == "what the claim is the dual of"
    assert checker("check_proof").check(theorem.to_json()) == "[a b c d] == 0, where [a b c d] == 0 (rank 4)"


def test_the_prompt_decides_duals() -> None:
    answers = [a.text for a in Interpreter().feed("rank 3\ndual(collinear(a, b, c))\ndual([abc] == -[bac])")]
    assert [a.split(":")[0] for a in answers] == ["refuted", "proved"]


FAULTS = [
    ("rank 3 claim dual(dual([abc] == 0))", "the dual of a dual is the claim itself"),
    ("ideal i claim dual([iabc] == 0)", "i is a point at infinity"),
    ("rank 3 claim dual(incident(a, tangent(a, b, c, d, e)))", "the dual of a construction has no word"),
    ("rank 5 claim dual([[ab,ac,ad,ae,bc,bd,be,cd,ce,de]] == 0)", "a superbracket in rank 5 has no dual here"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_what_has_no_dual_is_refused(text: str, message: str) -> None:
    refused(text, message)


PRINTED = [
    (3, "concurrent(ad, be, cf)", "[(ab /\\ de), (bc /\\ ef), (ca /\\ fd)] == 0"),
    (4, "collinear(a, b, c)", "[abde] [bcdf] == [abdf][bcde]"),
    (4, "collinear(a, b, c), collinear(a, d, e)", "coplanar(b, c, d, e)"),
]


@pytest.mark.parametrize(("rank", "given", "claim"), PRINTED)
def test_a_dual_that_was_printed_is_proved_again(rank: int, given: str, claim: str) -> None:
    printed = gc.prove(f"dual({claim})", rank=rank, given=given).dual
    assert printed is not None
    letters = ", ".join(printed.letters)
    again = gc.prove(printed.claims[0], rank=rank, given=printed.given, letters=letters)
    assert again.proved
    assert again.dual is not None
    assert (again.dual.letters, again.dual.given, again.dual.claims) == (printed.letters, printed.given, printed.claims)
    assert again.text().startswith(f"proved: {printed.claims[0]}")
    false = gc.prove(printed.claims[0], rank=rank, letters=letters)
    assert false.verdict == "refuted"
    assert false.dual is None
