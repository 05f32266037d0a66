r"""The shortest bracket polynomial equal to a given one, with a proof that none is shorter, or a lower bound.

>>> from gcrules.algebra.language.syntax import parse
>>> found = shorten(parse("[abc][def] - [abd][cef] + [abe][cdf] - [abf][cde] + [acd][bef]", rank=3))
>>> print(found.polynomial, found.minimal, sep="; ")
[acd][bef]; True
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import reduce
from operator import add
from time import monotonic

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Terms
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.pieces import Pieces, factor_pieces
from gcrules.algebra.shortening.limits import MAX_MONOMIALS, SECONDS
from gcrules.algebra.shortening.monomials import canonical, degree_vector
from gcrules.algebra.shortening.result import Shortening, TermBound
from gcrules.algebra.shortening.search import Divided, SearchLimits, ShortestSearch, shortest_of
from gcrules.algebra.straightening.straighten import is_zero, straighten
from gcrules.algebra.superbrackets.shortest import shortest_forms
from gcrules.core.budget import as_float, checkpoint, within
from gcrules.core.errors import EngineFault, LimitReached

__all__ = ["shorten"]

_TERMS_PER_MONOMIAL = 50
_PREPARATION = 10.0  # seconds for expansion and normal form, and for the proof of the answer, where less are given
_PROVED = Certificate("normal-form", "both sides have the same normal form of standard tableaux")
_COLLECTED = Certificate("normal-form", "the terms of the input, collected")
_MONOMIAL = Certificate("normal-form", "a product of brackets is not zero")
_ZERO = Certificate("normal-form", "the normal form is zero")


def shorten(
    e: Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    points: Iterable[str] = (),
    ideal: Iterable[str] = (),
    rank: int | None = None,
    limit: int = MAX_MONOMIALS,
    seconds: float = SECONDS,
    progress: Callable[[str], None] | None = None,
) -> Shortening:
    """The bracket polynomial with the fewest terms that was found for an expression of step 0, and a lower bound.

    Coefficients may be any rational numbers. Parts of different multidegree are independent, so each is shortened by
    itself. `limit` is the number of bracket monomials among which is searched (fifty times as many terms may be held).
    After `seconds` no search goes on and what was found so far is the answer, which takes ten seconds more at most;
    `progress` is told what goes on. Where there are more bracket monomials, the answer is the shortest form that is
    known without them, and `undecided`. Raises InputError for extensors, LimitReached where there is no normal form in
    the time.
    """
    terms = max(_TERMS_PER_MONOMIAL * limit, MAX_TERMS)
    start, seconds = monotonic(), as_float(seconds)
    limits = SearchLimits(limit, terms)
    written = e if isinstance(e, Expr) else e.to_expr()
    with within(seconds, grace=max(0.0, _PREPARATION - seconds)):
        pieces = factor_pieces(e, what="shortened", points=points, ideal=ideal, rank=rank, limit=terms)
        rows, poly = tuple(sorted(pieces.rows.elements())), _multiplied(pieces, terms)
        kept = _canonical(poly * poly.with_terms({rows: 1}))
        if len(kept) == 1:
            degrees = degree_vector(next(iter(kept.terms)), len(kept.points))
            used = tuple((name, n) for name, n in zip(kept.points, degrees, strict=True) if n)
            one = TermBound(used, 1, _MONOMIAL.method)
            return Shortening(kept, len(poly), 1, _MONOMIAL, _COLLECTED, input=written, bounds=(one,))
        normal = straighten(poly, limit=terms)
        assert isinstance(normal, BracketPolynomial)
        if not normal:
            return Shortening(normal, len(poly), 0, _ZERO, _ZERO, input=written)
        forms = [kept, *(_canonical(f.over(poly.points, poly.ideal)) for f in _superbracket_forms(e, poly))]
        divided = [Divided.of(rows, part, terms) for part in _by_multidegree(normal).values()]
        alike = [_alike(forms, part) for part in divided]
    with within(max(0.0, seconds - (monotonic() - start)), progress=progress):
        found = [shortest_of(part, some, limits) for part, some in zip(divided, alike, strict=True)]
    with within(_PREPARATION):
        bounds = tuple(one.term_bound(part) for one, part in zip(found, divided, strict=True))
        return replace(_together(poly, kept, found, terms), input=written, bounds=bounds)


def _multiplied(pieces: Pieces, terms: int) -> BracketPolynomial:
    """What stands beside the brackets, multiplied."""
    product = BracketPolynomial(pieces.rank, pieces.points, {(): pieces.number}, pieces.ideal)
    for poly, n in pieces.polynomials.items():
        for _ in range(n):
            if len(product) * len(poly) > terms:
                raise LimitReached(
                    f"the expansion has more than {terms:,} terms",
                    hint="raise the limit with --limit (in Python limit=...)",
                )
            checkpoint()
            product *= poly
    return product


def _superbracket_forms(
    e: Expr | BracketPolynomial | ExtensorPolynomial, poly: BracketPolynomial
) -> list[BracketPolynomial]:
    """The shortest of the 24-term and 16-term forms over all orders of the lines, for a superbracket of six lines."""
    if not isinstance(e, ex.Superbracket) or len(e.lines) != 6 or not len(poly):
        return []
    lines = []
    for line in e.lines:
        match line:
            case ex.Join(args=(ex.Point(name=a), ex.Point(name=b))):
                lines.append((a, b))
            case _:
                return []
    names = poly.points
    return [f.polynomial * f.sign for f in shortest_forms(lines, points=names, ideal=names[: poly.ideal])]


def _canonical(poly: BracketPolynomial) -> BracketPolynomial:
    """The polynomial with equal monomials collected and those that vanish left out."""
    terms: Terms = {}
    for m, c in poly.terms.items():
        kept = canonical(m, poly.ideal)
        if kept is not None:
            terms[kept] = terms.get(kept, 0) + c
    return poly.with_terms(terms)


def _by_multidegree(poly: BracketPolynomial) -> dict[tuple[int, ...], BracketPolynomial]:
    parts: dict[tuple[int, ...], Terms] = {}
    for m, c in poly.terms.items():
        parts.setdefault(degree_vector(m, len(poly.points)), {})[m] = c
    return {degrees: poly.with_terms(terms) for degrees, terms in sorted(parts.items())}


def _alike(forms: list[BracketPolynomial], part: Divided) -> list[BracketPolynomial]:
    """The parts of forms that have the multidegree of a polynomial."""
    degrees = degree_vector(next(iter(part.times(part.quotient).terms)), len(part.quotient.points))
    return [form for f in forms if (form := _by_multidegree(f).get(degrees)) is not None]


def _together(poly: BracketPolynomial, kept: BracketPolynomial, found: list[ShortestSearch], terms: int) -> Shortening:
    """The parts as one answer, which is proved, or else the input with its terms collected."""
    best, notes = reduce(add, (s.best for s in found)), tuple(note for s in found for note in s.notes)
    certificate = _PROVED
    try:
        if not is_zero(best - kept, limit=terms):
            raise EngineFault(f"{best} does not equal the input")
    except LimitReached as reached:
        best, certificate, notes = kept, _COLLECTED, (*notes, f"proof of what was found: {reached.message}")
    if len(found) == 1:
        bound = found[0].bound
    else:
        details = "; ".join(f"{s.lower} by {s.bound.method}: {s.bound.detail}" for s in found)
        bound = Certificate("parts", f"{len(found)} parts of different multidegree are independent: {details}")
    return Shortening(
        best,
        len(poly),
        sum(s.lower for s in found),
        bound,
        certificate,
        sum(s.monomials for s in found),
        max(s.symmetries for s in found),
        notes,
        next((s.undecided for s in found if s.undecided), ""),
    )
