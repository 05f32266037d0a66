"""Polars and poles for the letters of conics and quadrics as they are written, before they are points of their own.

A polarity takes points to hyperplanes and these back to points, lines of space to lines; up to a factor it is its own
inverse. So the dual of the polar of a point is the pole of a hyperplane, for the conic of the tangents or the quadric
of the tangent planes, which the dual calls by the same letter.

>>> from gcrules.algebra.expr import Point, join
>>> print(Polar(Point("p"), "K", 3), Polar(join(Point("a"), Point("b")), "K", 3), Polar(Point("p"), "Q", 4).step)
polar(p, K) pole(ab, K) 3
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number, measure
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import shortened
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["Polar", "check_degrees", "form_at", "polars_in", "second_of"]


@dataclass(frozen=True, slots=True)
class Polar(Expr):
    """The polar of a point, or of a line of space, or the pole of a hyperplane, `of` which it is, for a `letter`."""

    of: Expr
    letter: str
    rank: int

    def __post_init__(self) -> None:
        measure(self, self.rank - self.of.step, (self.of,))

    @property
    def word(self) -> str:
        """How the language calls it."""
        return "pole" if self.step == 1 else "polar"


def form_at(p: Expr, letter: str, rank: int) -> Expr:
    """The form of a conic or a quadric at a point: the bilinear form [p polar] of p and p is twice that."""
    return ex.mul(Number(Fraction(1, 2)), bracket(p, Polar(p, letter, rank), rank=rank))


def second_of(p: Expr, a: Expr, letter: str, rank: int) -> Expr:
    """The second point of the line pa on a conic or a quadric, of which a is a point: at s a + t p the form is
    t (s B + t F), where B is the bilinear form of a and p, and F the form at p.
    """
    both = bracket(p, Polar(a, letter, rank), rank=rank)
    return ex.sub(ex.mul(both, p), ex.mul(form_at(p, letter, rank), a), rank=rank)


def polars_in(exprs: Iterable[Expr]) -> tuple[Polar, ...]:
    """All polars and poles, each once, the outer ones first."""
    return tuple(dict.fromkeys(part for e in exprs for part in ex.subexpressions(e) if isinstance(part, Polar)))


def check_degrees(*exprs: Expr) -> None:
    """That all these, terms of one equation, have each kind of polars of a letter equally often, and so have the terms
    of each sum in them: duality multiplies polars of one kind by one factor, for which there is no word.

    Raises InputError.
    """
    _common(exprs)


_Degrees = Counter[tuple[str, int]]
"""For each letter and each step how often there is a polar of what is of this step."""


def _common(terms: Iterable[Expr]) -> _Degrees:
    """What all terms have."""
    found = [(e, _degrees(e)) for e in terms if e != ex.ZERO]
    first, common = found[0] if found else (ex.ZERO, Counter())
    other = next((e for e, degrees in found if degrees != common), None)
    if other is not None:
        one, two = (shortened(str(e)) for e in (first, other))
        raise InputError(
            f"duality multiplies {one} and {two} by different factors, for which there is no word",
            hint="in both there must be as many polars and as many poles; say it as an incidence, which has no factors",
        )
    return common


def _degrees(e: Expr) -> _Degrees:
    match e:
        case ex.Sum(terms=terms):
            return _common(terms)
        case ex.Power(base=base, exponent=n):
            return Counter({key: n * number for key, number in _degrees(base).items()})
    found: _Degrees = Counter([(e.letter, e.of.step)] if isinstance(e, Polar) else [])
    for part in e.children:
        found += _degrees(part)
    return found
