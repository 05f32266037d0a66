r"""Terms in which screws stand as sums of two lines, put together to terms in which lines stand in their place.

What is linear in a screw SᵃSᵇ + SᶜSᵈ is the sum of its values at the two lines, so that the terms with the first line
tell all; of a form that is quadratic the terms with both lines are twice its polar form, which is linear in two lines.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from fractions import Fraction

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.for_two_points import StandIns
from gcrules.algebra.letters import names_of
from gcrules.algebra.names import primed
from gcrules.algebra.screw_letters import screw, screw_points

__all__ = ["gathered", "linear_in_lines"]

_Rows = Sequence[Sequence[str]]
_Term = tuple[Fraction, _Rows]


def linear_in_lines(terms: Iterable[_Term], screws: Sequence[str]) -> Iterator[tuple[list[_Term], StandIns]]:
    """For each degree in the screws the terms, linear in lines, and for the points of each line the screw it is for.

    A degree above 2 in a screw gives the terms as they are.
    """
    parts: dict[tuple[int, ...], list[_Term]] = {}
    for c, rows in terms:
        parts.setdefault(tuple(sum(_counts(name, rows)) // 2 for name in screws), []).append((c, rows))
    for degrees, some in parts.items():
        kept, lines = some, list[tuple[tuple[str, str], Expr]]()
        for name, degree in zip(screws, degrees, strict=True) if max(degrees) <= 2 else ():
            if degree:
                two = [_fresh_line(name, _names(kept))]
                two += [_fresh_line(name, {*_names(kept), *two[0]})] if degree == 2 else []
                new = dict(zip(screw_points(name), (n for line in two for n in line), strict=False))
                alike = (2, 2) if degree == 2 else (2, 0)
                kept = [
                    (c / degree, [[new.get(n, n) for n in row] for row in rows])
                    for c, rows in kept
                    if _counts(name, rows) == alike
                ]
                lines += [(line, screw(name)) for line in two]
        yield kept, lines


def gathered(e: Expr) -> Expr:
    """A sum with terms that have the same factors as one."""
    terms: dict[tuple[str, ...], tuple[Fraction, list[Expr]]] = {}
    for term in e.terms if type(e) is ex.Sum else (e,):
        factors = term.factors if isinstance(term, ex.Product) else (term,)
        number, rest = Fraction(1), []
        for f in factors:
            if isinstance(f, ex.Number):
                number *= f.value
            else:
                rest.append(f)
        key = tuple(sorted(map(str, rest)))
        before, first = terms.get(key, (Fraction(0), rest))
        terms[key] = before + number, first
    return ex.add(*(ex.mul(ex.Number(c), *factors) for c, factors in terms.values()))


def _counts(name: str, rows: _Rows) -> tuple[int, int]:
    """How often the points of the two lines of a screw stand in a term."""
    points = screw_points(name)
    first, second = (sum(n in two for row in rows for n in row) for two in (points[:2], points[2:]))
    return first, second


def _names(terms: Iterable[_Term]) -> set[str]:
    return {n for _, rows in terms for row in rows for n in row}


def _fresh_line(name: str, taken: Collection[str]) -> tuple[str, str]:
    """The points of a line letter that is not taken."""
    first, second = names_of(primed(name, lambda n: not set(names_of(n, 2)).isdisjoint(taken)), 2)
    return first, second
