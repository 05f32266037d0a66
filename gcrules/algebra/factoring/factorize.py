r"""Factorization: is a bracket polynomial a product of brackets and one expression of joins and meets?

>>> from gcrules.algebra.language.syntax import parse
>>> print(factor(parse("[abfc][acde][bdef] + [abfd][acbe][cdef]")).to_expr())
abc /\ aef /\ bdf /\ cde
>>> print(factor(parse("[[Aa, Ab, Ac, Bd, Be, Cf]]")).to_expr())
[ABCf][ABde][Aabc]
>>> factor(parse("[[ab, cd, ef, gh, ij, kl]]")).exists
False
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from time import monotonic

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.limits import MAX_EXTENSORS, SECONDS, Effort, terms_held
from gcrules.algebra.factoring.normal import not_zero, zero
from gcrules.algebra.factoring.once import each_once
from gcrules.algebra.factoring.pieces import Pieces, factor_pieces
from gcrules.algebra.factoring.products import Groups
from gcrules.algebra.factoring.rational import COFACTORS_OF_POINTS, with_cofactor
from gcrules.algebra.factoring.result import ExpressionFamily, Factorization, brackets_of
from gcrules.algebra.factoring.trees import Written
from gcrules.algebra.factoring.whole import Whole
from gcrules.core.budget import as_float, checkpoint, punctual, within
from gcrules.core.english import listed
from gcrules.core.errors import LimitReached

__all__ = ["factor"]

BRACKETS = "products of brackets"
ONE_EXPRESSION = "products of brackets and one expression of joins and meets"
SEVERAL = "products of brackets and of expressions of joins and meets"

_TO_ANSWER = 5.0  # seconds for what is known, where a limit ended the search
_SHARE_TO_ANSWER = 0.2  # of the seconds that are given, where these are few
_NO_COFACTOR = "a cofactor: it is sought where there is certainly no expression without one"

_EQUAL_FORMS = Certificate("normal-form", "the product of the brackets has the normal form of the input")


def factor(
    e: Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_EXTENSORS,
    seconds: float = SECONDS,
    every: bool = False,
    cofactor: bool = False,
    progress: Callable[[str], None] | None = None,
) -> Factorization:
    """Decide whether an expression of step 0 is coefficient · Π brackets · ONE expression of joins and meets, or
    several where there are several irreducible factors.

    What is found is proved by normal forms, or the answer is not `proved` and says so, where the time does not
    suffice. Where a limit ends the search, the answer is undecided, and has the factors that are known. `every` asks
    for all expressions instead of the simplest. Where there is none, `cofactor` asks for one that equals a bracket, or
    meets of constructed lines, times the polynomial. `limit` is the number of extensors that may be held (a quarter of
    it that of terms, which is 200,000 at least); `progress` is told what goes on. Raises InputError for zero, for
    extensors and where a point does not occur equally often in all terms, LimitReached where a limit is reached before
    it is known that the polynomial is not zero.

    Source: White1991 for the steps of the multilinear case, else derived here (docs/factor.md).
    """
    terms = terms_held(limit)
    with within(seconds, progress=progress, grace=min(_TO_ANSWER, _SHARE_TO_ANSWER * as_float(seconds))):
        with punctual():
            checkpoint()
            effort = Effort(limit)
            pieces = factor_pieces(e, what="factored", points=points, ideal=ideal, rank=rank, limit=terms, letters=True)
            if not pieces.number:
                raise zero()
        if not pieces.ideal and pieces.once:
            found = _each_once(pieces, terms)
        else:
            found = _in_groups(pieces, effort, terms, every)
        if cofactor and pieces.letters and not found.exists:
            found = replace(found, undecided=(COFACTORS_OF_POINTS,))
        elif cofactor and found.exists is False:
            with punctual():
                found = with_cofactor(found, effort, terms=terms, every=every)
        elif cofactor and found.exists is None:
            found = replace(found, undecided=(_NO_COFACTOR,))
    return replace(found, input=e if isinstance(e, Expr) else e.to_expr(), ideal=pieces.points[: pieces.ideal])


def _each_once(pieces: Pieces, terms: int) -> Factorization:
    """The answer of the multilinear algorithm, as far as the time goes."""
    try:
        with punctual():
            return each_once(pieces, terms)
    except LimitReached as reached:
        return _ended(Whole.as_written(pieces, reached), reached, terms)


def _ended(whole: Whole, reached: LimitReached, terms: int) -> Factorization:
    """The answer where the factors themselves are not known. Raises LimitReached where they may be zero."""
    if not all(map(not_zero, whole.parts)):
        raise reached
    family = ExpressionFamily(_family(SEVERAL, whole.pieces))
    return whole.undecided(family, reached, [reached] * len(whole.parts), terms)


def _in_groups(pieces: Pieces, effort: Effort, terms: int, every: bool) -> Factorization:
    """Search for what the brackets leave, in groups of its irreducible factors, brackets left inside where need be."""
    start = monotonic()
    with punctual():
        whole = Whole.of(pieces, terms, patient=False)
    if whole.reached is not None:
        return _ended(whole, whole.reached, terms)
    if not whole.parts:
        rows = brackets_of(whole.rows.elements(), pieces.points)
        return Factorization(
            pieces.rank, pieces.points, whole.number, rows, ex.Number(1), ExpressionFamily(BRACKETS), _EQUAL_FORMS
        )
    groups = Groups(whole.rows, whole.parts, whole.times, effort)
    one = sum(whole.times) == 1
    together = ", all with" if one else ", all together with"
    name = f"{_family(ONE_EXPRESSION if one else SEVERAL, pieces)}{together} the polynomial's multidegree"
    ended: LimitReached | None = None
    with punctual():
        alone = [_first(groups.alone(i)) for i in range(len(whole.parts))]
        try:
            cover = groups.cover()
        except LimitReached as reached:
            cover, ended = None, reached.with_traceback(None)
        family = ExpressionFamily(name, effort.products, groups.built, monotonic() - start)
        if cover is not None:
            found = whole.found(cover, family, terms, every=every)
            return replace(found, family=replace(family, seconds=monotonic() - start))
        if ended is None:
            known = [e if isinstance(e, Expr) else None for e in alone]
            return whole.none(family, _exhausted(whole), known, terms)
    return whole.undecided(family, ended, alone, terms)


def _family(name: str, pieces: Pieces) -> str:
    """The name of a family, with the letters that stand whole in all its expressions."""
    return f"{name} with {listed(pieces.letters)} whole" if pieces.letters else name


def _first(found: list[Written] | LimitReached) -> Expr | LimitReached | None:
    """The simplest of expressions, or the limit that ended their search."""
    return found if isinstance(found, LimitReached) else next((w.expression for w in found), None)


def _exhausted(whole: Whole) -> Certificate:
    """The certificate that no expression of the family equals the polynomial."""
    number = sum(whole.times)
    alone = number == 1 and whole.irreducible
    detail = "every expression was refuted by its values at exact positions"
    if whole.rows:
        detail += ", also with brackets that divide left inside it"
    if alone:
        kind = _family("no other expression of joins and meets", whole.pieces)
        detail += f"; what the brackets leave is irreducible, so {kind} equals it"
    elif number > 1:
        detail += f"; so were those of all groups of the {number} irreducible factors of what the brackets leave"
    if not whole.irreducible:
        detail += "; products of several expressions that are not brackets were not tested"
    return Certificate("exhaustive-search", detail, {"irreducible": alone})
