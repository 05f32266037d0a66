"""All irreducible factors of what is factored, and the answers that are made of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import product, repeat
from math import isfinite, prod
from operator import mul

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Row, primitive
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.factoring.certify import PROVED, certified
from gcrules.algebra.factoring.decomposition import Decomposition, decomposed
from gcrules.algebra.factoring.pieces import Pieces
from gcrules.algebra.factoring.powers import number_power
from gcrules.algebra.factoring.products import Cover, Group
from gcrules.algebra.factoring.result import (
    UNDECIDED,
    ExpressionFamily,
    FactoredForm,
    FactoredPart,
    Factorization,
    brackets_of,
)
from gcrules.algebra.factoring.symmetry import exchangeable
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint, seconds_left, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Whole", "together"]

_TERMS_SHOWN = 50_000
_SHARE = 0.2  # of the time that is left, for writing what is left in the given order


@dataclass(frozen=True)
class Whole:
    """number · Π rows · Π parts, each part as often as `times` says; whether each part is known to be irreducible.

    Where a limit ended the search for factors, `reached` is that limit: more brackets may divide then.
    """

    pieces: Pieces
    number: int | Fraction
    rows: Counter[Row]
    parts: tuple[BracketPolynomial, ...]
    times: tuple[int, ...]
    irreducible: bool
    reached: LimitReached | None = None

    @classmethod
    def of(cls, pieces: Pieces, terms: int, *, patient: bool = True) -> Whole:
        """The factors of all pieces. Raises LimitReached; where not `patient`, a piece is left as it is instead."""
        number, rows, parts, known = pieces.number, Counter(pieces.rows), Counter[BracketPolynomial](), True
        limit = None
        for poly, n in pieces.polynomials.items():
            try:
                found = decomposed(poly, terms)
            except LimitReached as reached:
                if patient:
                    raise
                limit = limit or reached.with_traceback(None)
                found = Decomposition(1, (), (poly,), False)
            number = Number(number * number_power(found.number, n)).value
            rows.update({row: n * k for row, k in Counter(found.rows).items()})
            parts.update({part: n * k for part, k in Counter(found.parts).items()})
            known &= found.irreducible
        return cls(pieces, number, rows, tuple(parts), tuple(parts.values()), known, limit)

    @classmethod
    def as_written(cls, pieces: Pieces, reached: LimitReached) -> Whole:
        """The pieces themselves, where a limit ended the search before their factors were sought."""
        parts, times = tuple(pieces.polynomials), tuple(pieces.polynomials.values())
        return cls(pieces, pieces.number, Counter(pieces.rows), parts, times, False, reached)

    @property
    def as_given(self) -> BracketPolynomial | None:
        """The only part, as it was written: where nothing but what was taken out as written divides it."""
        given = tuple(self.pieces.polynomials.items())
        if len(given) != 1 or self.rows != self.pieces.rows or self.times != (1,) or given[0][1] != 1:
            return None
        return given[0][0]

    def found(self, cover: Cover, family: ExpressionFamily, terms: int, *, every: bool) -> Factorization:
        """The answer for groups that are expressions; each is certified by itself."""
        names = self.pieces.points
        factors = brackets_of(cover.outside.elements(), names)
        some = None if every else 1
        certain = [
            [(e, *certified(self._target(group), e, terms)) for e in (w.expression for w in group.expressions[:some])]
            for group in cover.groups
        ]
        forms = []
        for choice in product(*certain):
            checkpoint()
            number = self.number
            expressions: list[Expr] = []
            for group, (e, c, _) in zip(cover.groups, choice, strict=True):
                number = Number(number * number_power(c, group.times)).value
                expressions += repeat(e, group.times)
            forms.append(FactoredForm(number, factors, ex.mul(*expressions)))
        first, *others = forms
        return Factorization(
            self.pieces.rank,
            names,
            first.coefficient,
            factors,
            first.expression,
            family,
            together([certificate for group in certain for _, _, certificate in group]),
            alternatives=tuple(others),
            more=prod(len(group.expressions) for group in cover.groups) - len(forms),
        )

    def none(
        self, family: ExpressionFamily, certificate: Certificate, alone: Iterable[Expr | None], terms: int
    ) -> Factorization:
        """The answer that there is none; `alone` are expressions of single parts."""
        number, parts = self._shown(alone, terms)
        remainder = self._product(parts, terms)
        some = tuple(parts) if sum(self.times) > 1 else ()
        return replace(self._without(number, family, certificate), remainder=remainder, parts=some)

    def undecided(
        self, family: ExpressionFamily, reached: LimitReached, alone: Sequence[Expr | LimitReached | None], terms: int
    ) -> Factorization:
        """The answer where a limit ended the search: what is known, and of `alone` the parts with an expression of
        their own, those without and those whose search a limit ended.
        """
        found = [e if isinstance(e, Expr) else None for e in alone]
        number, parts = self._shown(found, terms)
        why = [e.message if isinstance(e, LimitReached) else "" for e in alone]
        known = tuple(replace(part, undecided=words) for part, words in zip(parts, why, strict=True))
        given = self.as_given
        if given is not None and len(known) == 1 and len(given) <= len(known[0].polynomial):
            number, known = self.pieces.number, (replace(known[0], polynomial=given),)
        return replace(
            self._without(number, family, Certificate(UNDECIDED, reached.message, {"hint": reached.hint or ""})),
            remainder=known[0].polynomial if sum(self.times) == 1 else None,
            parts=known,
            more_brackets=self.reached is not None,
            exchangeable=exchangeable(self.parts[0], limit=terms) if sum(self.times) == 1 else (),
        )

    def _without(self, number: int | Fraction, family: ExpressionFamily, certificate: Certificate) -> Factorization:
        """The answer without an expression."""
        names = self.pieces.points
        rows = brackets_of(self.rows.elements(), names)
        return Factorization(self.pieces.rank, names, number, rows, None, family, certificate)

    def _shown(self, alone: Iterable[Expr | None], terms: int) -> tuple[int | Fraction, list[FactoredPart]]:
        """The number in front of the parts, and these in the order of points that was asked for."""
        number, parts = self.number, []
        for part, n, e in zip(self.parts, self.times, alone, strict=True):
            shown = e if e is not None and _certain(part, e, terms) else None
            content, written = primitive(in_order_of_points(part))
            number = Number(number * number_power(content, n)).value
            parts.append(FactoredPart(written, n, shown, self.irreducible))
        return number, parts

    def _target(self, group: Group) -> BracketPolynomial:
        target = reduce(mul, (self.parts[i] for i in group.parts))
        return target * target.with_terms({group.inside: 1})

    def _product(self, parts: Sequence[FactoredPart], terms: int) -> BracketPolynomial | None:
        """The product of the parts, in normal form where that is not long; None where the product itself is long."""
        if prod(len(part.polynomial) ** min(part.times, 64) for part in parts) > terms:
            return parts[0].polynomial if len(parts) == parts[0].times == 1 else None
        factors = [part.polynomial for part in parts for _ in range(part.times)]
        return factors[0] if len(factors) == 1 else in_order_of_points(reduce(mul, factors))


def together(certificates: Sequence[Certificate]) -> Certificate:
    """What holds for a product of which each factor has a certificate."""
    weak = [c for c in certificates if c.method != PROVED.method]
    if weak:
        return weak[0]
    if len(certificates) < 2:
        return PROVED
    return Certificate(PROVED.method, f"{PROVED.detail}, factor by factor")


def in_order_of_points(poly: BracketPolynomial) -> BracketPolynomial:
    """The normal form in the order of the points that was asked for; the polynomial as it is where that is too long."""
    left = seconds_left()
    try:
        with within(_SHARE * left if isfinite(left) else None):
            normal = straighten(poly, limit=_TERMS_SHOWN)
    except LimitReached:
        return poly
    assert isinstance(normal, BracketPolynomial)
    return normal


def _certain(part: BracketPolynomial, e: Expr, terms: int) -> bool:
    return certified(part, e, terms)[1].method == PROVED.method
