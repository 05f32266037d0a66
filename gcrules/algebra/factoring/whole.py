"""All irreducible factors of what is factored, and the answers that are made of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
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
from gcrules.algebra.factoring.result import ExpressionFamily, FactoredForm, FactoredPart, Factorization, brackets_of
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint, seconds_left, within
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Whole", "together"]

_TERMS_SHOWN = 50_000
_SHARE = 0.2  # of the time that is left, for writing what is left in the given order


@dataclass(frozen=True)
class Whole:
    """number · Π rows · Π parts, each part as often as `times` says; whether each part is known to be irreducible."""

    pieces: Pieces
    number: int | Fraction
    rows: Counter[Row]
    parts: tuple[BracketPolynomial, ...]
    times: tuple[int, ...]
    irreducible: bool

    @classmethod
    def of(cls, pieces: Pieces, terms: int, *, patient: bool = True) -> Whole:
        """The factors of all pieces. Raises LimitReached; where not `patient`, a piece is left as it is instead."""
        number, rows, parts, known = pieces.number, Counter(pieces.rows), Counter[BracketPolynomial](), True
        for poly, n in pieces.polynomials.items():
            try:
                found = decomposed(poly, terms)
            except LimitReached:
                if patient:
                    raise
                found = Decomposition(1, (), (poly,), False)
            number = Number(number * number_power(found.number, n)).value
            rows.update({row: n * k for row, k in Counter(found.rows).items()})
            parts.update({part: n * k for part, k in Counter(found.parts).items()})
            known &= found.irreducible
        return cls(pieces, number, rows, tuple(parts), tuple(parts.values()), known)

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
        names = self.pieces.points
        number, parts = self.number, []
        for part, n, e in zip(self.parts, self.times, alone, strict=True):
            shown = e if e is not None and _certain(part, e, terms) else None
            content, written = primitive(in_order_of_points(part))
            number = Number(number * number_power(content, n)).value
            parts.append(FactoredPart(written, n, shown, self.irreducible))
        remainder = self._product(parts, terms)
        return Factorization(
            self.pieces.rank,
            names,
            number,
            brackets_of(self.rows.elements(), names),
            None,
            family,
            certificate,
            remainder=remainder,
            parts=tuple(parts) if sum(self.times) > 1 else (),
        )

    def _target(self, group: Group) -> BracketPolynomial:
        target = reduce(mul, (self.parts[i] for i in group.parts))
        return target * target.with_terms({group.inside: 1})

    def _product(self, parts: Sequence[FactoredPart], terms: int) -> BracketPolynomial:
        """The product of the parts, in normal form where that is not long."""
        if prod(len(part.polynomial) ** min(part.times, 64) for part in parts) > terms:
            raise LimitReached(f"there is no such expression, but what is left has more than {terms:,} terms")
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
