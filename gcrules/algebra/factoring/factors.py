r"""Complete factorization: the irreducible factors of a scalar, each as one expression, in two terms or with a
cofactor.

>>> from gcrules.algebra.language.syntax import parse
>>> for f in factors(parse("[[Aa, Ab, Ba, Bb, Cc, Dd]]")).factors:
...     print(f.times, f.form, f.expression)
1 bracket [ABab]
1 transversals (AB /\ Cc)(ab /\ Dd) - (AB /\ Dd)(ab /\ Cc)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from fractions import Fraction

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Row, primitive
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.factoring.forms import BRACKET, UNDECIDED, Factors, IrreducibleFactor
from gcrules.algebra.factoring.irreducible import irreducible
from gcrules.algebra.factoring.limits import MAX_EXTENSORS, SECONDS, Effort, terms_held
from gcrules.algebra.factoring.normal import normal, not_zero, zero
from gcrules.algebra.factoring.pieces import factor_pieces
from gcrules.algebra.factoring.powers import number_power
from gcrules.algebra.factoring.result import brackets_of
from gcrules.algebra.factoring.seeking import NOT_DECIDED, formed, share_of_time
from gcrules.algebra.factoring.whole import Whole
from gcrules.core.budget import checkpoint, report, within

__all__ = ["factors"]

_FOR_PARTS = 0.5  # of the time, for the factors themselves
_FOR_ONE = 0.8  # of what is left then, for their forms
_ITSELF = Certificate("normal-form", "it is a bracket")
_AS_WRITTEN = Certificate("normal-form", "factors that were written as such, or are brackets that all terms share")
_PRODUCT = Certificate("normal-form", "the product of the factors has the normal form of the input, factor by factor")


def factors(
    e: Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_EXTENSORS,
    seconds: float = SECONDS,
    progress: Callable[[str], None] | None = None,
) -> Factors:
    """The irreducible factors (over the rationals) of an expression of step 0, each in the first form that it has: one
    expression of joins and meets, a comparison of the turns about two lines, two bracket monomials, one expression
    with a cofactor.

    Where a limit ends a search, the factor is undecided and says why; the factors that were found stand. `limit` is as
    for `factor`. Raises InputError for zero, for extensors and where a point does not occur equally often in all terms,
    LimitReached where a limit is reached before it is known that the polynomial is not zero.

    Source: derived here (docs/factor.md).
    """
    terms = terms_held(limit)
    with within(seconds, progress=progress):
        checkpoint()
        pieces = factor_pieces(e, what="factored", points=points, ideal=ideal, rank=rank, limit=terms, letters=True)
        if not pieces.number:
            raise zero()
        with share_of_time(_FOR_PARTS):
            whole = Whole.of(pieces, terms, patient=False)
        found = [_bracket(whole, row, n) for row, n in sorted(whole.rows.items())]
        if whole.reached is not None and not all(map(not_zero, whole.parts)):
            raise whole.reached
        number, parts = (whole.number, []) if whole.reached is not None else _parts(whole, terms)
        found += _left(whole)
        for k, (part, shown, n) in enumerate(parts):
            report(f"factor {k + 1} of {len(parts)}")
            known = whole.irreducible or bool(irreducible(part))
            with share_of_time(_FOR_ONE / (len(parts) - k)):
                found.append(formed(part, shown, n, known, Effort(limit), terms))
    return Factors(
        pieces.rank,
        pieces.points,
        number,
        tuple(found),
        _PRODUCT if whole.reached is None else _AS_WRITTEN,
        e if isinstance(e, Expr) else e.to_expr(),
        pieces.points[: pieces.ideal],
    )


def _parts(whole: Whole, terms: int) -> tuple[int | Fraction, list[tuple[BracketPolynomial, BracketPolynomial, int]]]:
    """The number in front, and the different factors that are no brackets: in normal form (of p and -p one), as shown,
    and the multiplicity. Factors of several pieces may be the same.
    """
    number, counted = whole.number, Counter[BracketPolynomial]()
    for part, n in zip(whole.parts, whole.times, strict=True):
        content, written = primitive(normal(part, terms))
        sign = -1 if written.terms[min(written.terms)] < 0 else 1
        number = Number(number * number_power(content * sign, n)).value
        counted[written * sign] += n
    pieces = whole.pieces
    given = whole.as_given
    if given is not None and len(counted) == 1:
        (written,) = counted
        ratio = Fraction(number / pieces.number)
        if abs(ratio) == 1 and len(given) < len(written):
            return pieces.number, [(written * ratio, given, 1)]
    return number, [(part, part, n) for part, n in counted.items()]


def _left(whole: Whole) -> list[IrreducibleFactor]:
    """Where a limit ended the search for factors, what it left of the brackets that were taken out."""
    if whole.reached is None:
        return []
    why = (f"its factors: {whole.reached.message}",)
    return [
        IrreducibleFactor(part, n, UNDECIDED, NOT_DECIDED, irreducible=False, undecided=why)
        for part, n in zip(whole.parts, whole.times, strict=True)
    ]


def _bracket(whole: Whole, row: Row, times: int) -> IrreducibleFactor:
    (written,) = brackets_of([row], whole.pieces.points)
    poly = BracketPolynomial(whole.pieces.rank, whole.pieces.points, {(row,): 1}, whole.pieces.ideal)
    return IrreducibleFactor(poly, times, BRACKET, _ITSELF, expression=written)
