"""The form of one irreducible factor: the kinds that are sought, one after the other, each in its share of the time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import replace
from math import isfinite

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.blocks import each_point_once
from gcrules.algebra.factoring.certify import certified
from gcrules.algebra.factoring.forms import (
    COFACTOR,
    EXPRESSION,
    NONE,
    TWO_LINES,
    TWO_TERMS,
    UNDECIDED,
    IrreducibleFactor,
)
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import search
from gcrules.algebra.factoring.multilinear import factor_multilinear
from gcrules.algebra.factoring.once import no_factor, scalars_of
from gcrules.algebra.factoring.rational import COFACTORS_OF_POINTS, with_cofactor
from gcrules.algebra.factoring.result import ExpressionFamily, Factorization
from gcrules.algebra.factoring.two_lines import two_lines
from gcrules.algebra.letters import letters_of
from gcrules.algebra.shortening.shorten import shorten
from gcrules.core.budget import Budget, seconds_left, within
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import LimitReached

__all__ = ["NOT_DECIDED", "formed", "share_of_time"]

_MOST_OF = 0.8  # of the time that is left, where others may follow
_HALF = 0.5
_DIGITS = 1
_SECONDS_TO_SHORTEN = 10.0
_TERMS = 2
_RANK_OF_LINES = 4
NOT_DECIDED = Certificate("undecided", "a limit was reached before the answer")
_OF_POINTS = Certificate("undecided", "two terms and cofactors are sought where all letters are points")
_NOTHING = ExpressionFamily("")


def share_of_time(share: float) -> AbstractContextManager[Budget]:
    """A budget of this share of the time that is left."""
    left = seconds_left()
    return within(round(max(0.0, share * left), _DIGITS) if isfinite(left) else None)


@dataclass(frozen=True)
class _Absence:
    """Why there is no form of a kind: the certificate, or in words; `undecided` where it is not excluded. `shorter` is
    a form of the polynomial with fewer terms.
    """

    certificate: Certificate = NOT_DECIDED
    words: str = ""
    undecided: str = ""
    shorter: BracketPolynomial | None = None


_Found = Expr | _Absence
_Seek = Callable[[BracketPolynomial, bool, Effort], _Found]


def formed(
    poly: BracketPolynomial, shown: BracketPolynomial, times: int, irreducible: bool, effort: Effort, terms: int
) -> IrreducibleFactor:
    """The factor in the first form that it has: `poly` in normal form, `shown` equal to it. What a limit ended is said,
    and the next kind is sought.
    """
    part = IrreducibleFactor(shown, times, UNDECIDED, NOT_DECIDED, irreducible)
    excluded, undecided, absent = list[str](), list[str](), NOT_DECIDED
    for kind, seek in _KINDS.items():
        try:
            with share_of_time(_HALF):
                found = seek(poly, irreducible, effort.renewed())
            if not isinstance(found, _Absence):
                coefficient, certificate = certified(poly, found, terms)
                return replace(
                    part,
                    form=kind,
                    certificate=certificate,
                    expression=found,
                    coefficient=coefficient,
                    excluded=tuple(excluded),
                    undecided=tuple(undecided),
                )
        except LimitReached as reached:
            undecided.append(f"{_NAMES[kind]}: {reached.message}")
            continue
        if kind == EXPRESSION:
            absent = found.certificate
        excluded += [found.words] if found.words else []
        undecided += [f"{_NAMES[kind]}: {found.undecided}"] if found.undecided else []
        if found.shorter is not None and len(found.shorter) < len(part.polynomial):
            part = replace(part, polynomial=found.shorter)
    if absent is NOT_DECIDED:
        return replace(part, excluded=tuple(excluded), undecided=(*undecided, "a cofactor: it was not sought"))
    if letters_of(poly.points):
        none, unsought = f"one expression: {absent.detail}", (*undecided, COFACTORS_OF_POINTS)
        return replace(part, certificate=_OF_POINTS, excluded=(none, *excluded), undecided=unsought)
    last = Factorization(poly.rank, poly.points, 1, (), None, _NOTHING, absent, remainder=poly)
    with share_of_time(_MOST_OF):
        last = with_cofactor(last, effort.renewed(), terms=terms, every=False)
    excluded += last.excluded
    undecided += [f"a cofactor: {words}" for words in last.undecided]
    part = replace(part, excluded=tuple(excluded), undecided=tuple(undecided))
    if last.rational:
        form = last.rational[0]
        whole = ex.mul(*form.factors, form.expression)
        proved = certified(_multiplied(poly, form.cofactor, terms), whole, terms)[1]
        return replace(
            part,
            form=COFACTOR,
            certificate=proved,
            expression=whole,
            coefficient=form.coefficient,
            cofactor=form.cofactor,
        )
    return part if undecided else replace(part, form=NONE, certificate=absent)


def _multiplied(poly: BracketPolynomial, cofactor: Expr, terms: int) -> BracketPolynomial:
    ideal = poly.points[: poly.ideal]
    expanded = expand(cofactor, points=poly.points, ideal=ideal, rank=poly.rank, limit=terms)
    assert isinstance(expanded, BracketPolynomial)
    return poly * expanded.over(poly.points, poly.ideal)


def _one_expression(poly: BracketPolynomial, irreducible: bool, effort: Effort) -> _Found:
    if not poly.ideal and each_point_once(poly):
        found = factor_multilinear(poly)
        if found.complete:
            return ex.mul(*scalars_of(found, poly))
        return _Absence(no_factor([found], poly.rank, poly.points))
    written, built = search(poly, effort)
    if written:
        return written[0].expression
    family = ExpressionFamily("", effort.products, built)
    detail = f"{family.searched()}: each was refuted by its values at exact positions"
    if irreducible:
        whole = f" with {listed(letters)} whole" if (letters := [*letters_of(poly.points)]) else ""
        detail += f"; the factor is irreducible, so no other expression of joins and meets{whole} equals it"
    return _Absence(Certificate("exhaustive-search", detail, {"irreducible": irreducible}))


def _two_lines(poly: BracketPolynomial, irreducible: bool, effort: Effort) -> _Found:
    if poly.rank != _RANK_OF_LINES or poly.ideal:
        return _Absence()
    found = two_lines(poly, effort)
    own = "two lines that are joins of two points or letters" if letters_of(poly.points) else "two joins of two points"
    none = f"no comparison of the turns about two lines made of its points, with {own}"
    return _Absence(words=none) if found is None else found


def _two_terms(poly: BracketPolynomial, irreducible: bool, effort: Effort) -> _Found:
    if letters_of(poly.points):
        return _Absence(undecided="they are sought where all letters are points")
    short = shorten(poly, seconds=min(_SECONDS_TO_SHORTEN, max(0.0, seconds_left())))
    if short.terms <= _TERMS:
        return short.polynomial.to_expr()
    whole = all(c.denominator == 1 for c in short.polynomial.terms.values())
    shorter = short.polynomial if whole and len(short.polynomial) < len(poly) else None
    if short.undecided:
        return _Absence(undecided=short.undecided, shorter=shorter)
    if short.lower <= _TERMS:
        return _Absence(
            undecided=f"whether two bracket monomials equal it is not known, {short.terms} do", shorter=shorter
        )
    return _Absence(words=f"no bracket polynomial with fewer than {short.lower} terms", shorter=shorter)


_KINDS: Mapping[str, _Seek] = {EXPRESSION: _one_expression, TWO_LINES: _two_lines, TWO_TERMS: _two_terms}
_NAMES = {EXPRESSION: "one expression", TWO_LINES: "four lines", TWO_TERMS: "two terms"}
