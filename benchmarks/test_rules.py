"""Rules and assumptions, each beside a naive form: matching by trying all names, proofs by coordinates."""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations
from typing import Any

from gcrules.algebra.assumptions.assumed import _kinds
from gcrules.algebra.bracket import BracketPolynomial, sorted_row
from gcrules.algebra.expand import expand
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.prove import prove
from gcrules.algebra.space import Space
from gcrules.rules.identity import rewritten
from gcrules.rules.rule_file import identities

CONTRACT = "rule c: [R... a b][R... c d] - [R... a c][R... b d] => -[R... a d][R... b c]"


def test_rewrite(ratio: Callable[..., Any]) -> None:
    """The three-term relation looked for among 12 terms; the naive form tries every way to name the points."""
    (rule,) = identities(parse_script(CONTRACT))
    p = expand(
        parse("([abcd][abef] - [abce][abdf]) [cdef] + [acde][abcf][bdef] - [abcd][acef][bdef] + [abde][acdf][bcef]")
    )
    assert isinstance(p, BracketPolynomial)
    ratio(lambda: rewritten(p, rule, Space()), {"all names": lambda: naive(p)}, agree=lambda a, b: a == b)


def naive(p: BracketPolynomial) -> BracketPolynomial:
    """Replaces [xyab][xycd] − [xyac][xybd] by −[xyad][xybc] for the first names under which both terms occur."""

    def image(rows: tuple[tuple[int, ...], ...], rest: tuple[Any, ...]) -> tuple[int, tuple[Any, ...]]:
        signs = [sorted_row(r) for r in rows]
        return signs[0][0] * signs[1][0], tuple(sorted((*(r for _, r in signs), *rest)))

    while True:
        for x, y, a, b, c, d in permutations(range(len(p.points)), 6):
            first, second = ((x, y, a, b), (x, y, c, d)), ((x, y, a, c), (x, y, b, d))
            third = ((x, y, a, d), (x, y, b, c))
            for m, k in p.terms.items():
                s, rows = image(first, ())
                rest = list(m)
                if any(r not in rest for r in rows):
                    continue
                for r in rows:
                    rest.remove(r)
                t, other = image(second, tuple(rest))
                if p.terms.get(other, 0) != -k * s * t:
                    continue
                u, new = image(third, tuple(rest))
                terms = {n: v for n, v in p.terms.items() if n not in (m, other)}
                terms[new] = terms.get(new, 0) - k * s * u
                p = p.with_terms(terms)
                break
            else:
                continue
            break
        else:
            return p


DESARGUES = r"[ab /\ de, bc /\ ef, ca /\ fd] == 0"
PERSPECTIVE = "collinear(o, a, d), collinear(o, b, e), collinear(o, c, f)"


def test_proof_under_assumptions(ratio: Callable[..., Any]) -> None:
    """Desargues' theorem; the naive form writes coordinates and lets sympy multiply out."""
    space = parse_assumption(PERSPECTIVE, Context(rank=3))
    sides = parse_equation(DESARGUES, context=space)

    def ours() -> bool:
        _kinds.cache_clear()
        return prove(*sides, rank=3, given=space.given).proved

    ratio(ours, {"sympy, coordinates": by_coordinates}, agree=lambda a, b: a is b is True, others_rounds=1)


def by_coordinates() -> bool:
    import sympy
    from sympy.core.cache import clear_cache

    clear_cache()  # else only the first round would compute anything

    def vector(name: str) -> sympy.Matrix:
        return sympy.Matrix(sympy.symbols(f"{name}0:3"))

    o, a, b, c = map(vector, "oabc")
    d, e, f = (sympy.Symbol(f"s{i}") * o + sympy.Symbol(f"t{i}") * p for i, p in enumerate((a, b, c)))

    def crossing(p: Any, q: Any, r: Any, s: Any) -> Any:
        return p.cross(q).cross(r.cross(s))

    points = [crossing(a, b, d, e), crossing(b, c, e, f), crossing(c, a, f, d)]
    return bool(sympy.expand(sympy.Matrix.hstack(*points).det(method="berkowitz")) == 0)
