"""What is factored, taken apart as it was written: a number, brackets, and polynomials whose terms share no bracket."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from functools import reduce
from operator import and_

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Row, primitive, tableau_order
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.factoring.powers import number_power, powers
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conics_of, letters_of
from gcrules.algebra.names import step_name
from gcrules.algebra.screw_letters import screws_of
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["Pieces", "factor_pieces"]


@dataclass(frozen=True)
class Pieces:
    """number · Π brackets · Π polynomials: each bracket (places in `points`) and each polynomial so often.

    The polynomials have whole coprime coefficients; they are neither constant nor in normal form, and may be zero as
    functions. Where no term is left of one the number is 0.
    """

    rank: int
    points: tuple[str, ...]
    ideal: int
    number: int | Fraction
    rows: Counter[Row]
    polynomials: Counter[BracketPolynomial]

    @property
    def letters(self) -> tuple[str, ...]:
        """The lines, planes and hyperplanes that are letters."""
        return tuple(letters_of(self.points))

    @property
    def once(self) -> bool:
        """Whether each point that occurs does so once in each term, so that all parts have points of their own."""
        used = Counter(i for row, n in self.rows.items() for i in row for _ in range(min(n, 2)))
        for poly, n in self.polynomials.items():
            degrees = poly.degrees()
            if degrees is None or n > 1 or set(degrees.values()) != {1}:
                return False
            used.update(poly.points.index(name) for name in degrees)
        return set(used.values()) <= {1}


def factor_pieces(
    e: Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    what: str,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int,
    letters: bool = False,
) -> Pieces:
    """The pieces of a scalar; each factor is expanded by itself, and once.

    Raises InputError for letters of conics, quadrics and screws, without `letters` also for those of lines and planes,
    and for extensors (only scalars are `what`), LimitReached
    beyond `limit` terms.
    """
    names = ex.points_of(e) if isinstance(e, Expr) else e.points
    lettered = letters_of(names)
    for conic in conics_of(names):
        word = FORMS[ex.common_rank(rank, e) if isinstance(e, Expr) else e.rank].word
        raise InputError(f"only expressions of points are {what}, and {conic} is a {word}")
    for name in screws_of(names):
        hint = "write it as a sum of two lines, ab + cd" if isinstance(e, Expr) else None
        raise InputError(f"only expressions of points are {what}, and {name} is a screw", hint=hint)
    if lettered and not letters:
        name, step = next(iter(lettered.items()))
        hint = f"write {name} as a join of points" if isinstance(e, Expr) else None
        raise InputError(f"only expressions of points are {what}, and {name} is {step_name(step)}", hint=hint)
    if not isinstance(e, Expr):
        if not isinstance(e, BracketPolynomial):
            raise _no_scalar(what, e.step, e.rank)
        return _together(e.rank, e.points, e.ideal, 1, [(e, 1)])
    rank = ex.common_rank(rank, e)
    if e.step:
        raise _no_scalar(what, e.step, rank)
    at_infinity = tuple(dict.fromkeys(ideal))
    order = tableau_order(ex.points_of(e), points, at_infinity)
    number, counted = powers(e, rank=rank)
    if not number:
        counted.clear()
    expanded = []
    for base, n in counted.items():
        poly = expand(base, points=order, ideal=at_infinity, rank=rank, limit=limit)
        assert isinstance(poly, BracketPolynomial)
        expanded.append((poly.over(order, sum(i in at_infinity for i in order)), n))
    return _together(rank, order, sum(i in at_infinity for i in order), number, expanded)


def _together(
    rank: int, points: tuple[str, ...], ideal: int, number: int | Fraction, factors: list[tuple[BracketPolynomial, int]]
) -> Pieces:
    """A product of powers, brackets common to all terms of a factor apart."""
    rows: Counter[Row] = Counter()
    polynomials: Counter[BracketPolynomial] = Counter()
    for poly, n in factors:
        poly = poly.with_terms({m: c for m, c in poly.terms.items() if all(row[-1] >= ideal for row in m)})
        if not poly:
            return Pieces(rank, points, ideal, 0, Counter(), Counter())
        common = reduce(and_, map(Counter, poly.terms))
        rest = poly.with_terms({tuple(sorted((Counter(m) - common).elements())): c for m, c in poly.terms.items()})
        content, rest = primitive(rest)
        number = Number(number * number_power(content, n)).value
        rows.update({row: k * n for row, k in common.items()})
        if set(rest.terms) != {()}:
            polynomials[rest] += n
    return Pieces(rank, points, ideal, number, rows, polynomials)


def _no_scalar(what: str, step: int, rank: int) -> InputError:
    return InputError(f"only scalars are {what}, this is {step_name(step, rank)}")
