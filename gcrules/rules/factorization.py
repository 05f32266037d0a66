"""Conditions found by factorization: the superbracket's polynomial as brackets times one expression of joins and meets.

Under assumptions several polynomials equal the superbracket at the points that satisfy them, and each may factor.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from time import monotonic

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.letters import conics_of, letters_of
from gcrules.algebra.screw_letters import screws_of
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import GcrulesError, LimitReached
from gcrules.rules.claims import certify
from gcrules.rules.condition import Condition
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.sentences import sentence
from gcrules.rules.strategy import FACTORIZATION

__all__ = ["BRACKETS_ONLY", "SECONDS", "FactorizationOutcome", "factored"]

factor = deferred("gcrules.algebra.factoring.factorize:factor")

BRACKETS_ONLY = "bracket-factors"
SECONDS = 3.0
"""How long an analysis may search unless it is given more time."""

_MOST = 12  # polynomials that are tried under assumptions
_MORE = "--search with more seconds seeks one (in Python search=...)"
_NOT_FACTORED = "conics, quadrics and screws stand in none"
_MANY_TERMS = 200  # beyond, only who asks for more time waits
_FEW_TERMS = 10  # beyond, a cofactor is sought only by who asks for more time: there are hundreds of brackets to try
_TESTED = Certificate("random-points", "holds at exact random points")


@dataclass(frozen=True)
class FactorizationOutcome:
    """The condition found, if any, and in words what was searched in vain."""

    condition: Condition | None = None
    note: str | None = None


def factored(
    polynomials: Iterable[BracketPolynomial],
    structure: Structure,
    oracle: RandomWitness,
    *,
    seconds: float = SECONDS,
    cofactor: bool = True,
) -> FactorizationOutcome:
    """A condition from a factorization of the first of the polynomials that has one; else, with a `cofactor`, of the
    first that has one with a cofactor; else at least the brackets that divide. The polynomials equal the superbracket
    up to sign where the assumptions hold; which of them are given and in what order does not matter.
    """
    end = monotonic() + seconds
    polynomials = tuple(polynomials)
    names = {n for p in polynomials for n in p.points}
    if conics_of(names) or screws_of(names):
        return FactorizationOutcome(note=f"no factorization was sought: {_NOT_FACTORED}")
    lettered = bool(letters_of(names))
    candidates = [p for p in _in_order(polynomials) if len(p) <= _MANY_TERMS or seconds > SECONDS]
    if not candidates:
        return FactorizationOutcome(
            note=f"no factorization was sought: the polynomial has more than {_MANY_TERMS} terms; {_MORE}"
        )
    rounds = (False, True) if cofactor and len(candidates) > 1 else (cofactor,)
    partial: Condition | None = None
    family, sought = "", False
    for with_cofactor in rounds:
        for poly in candidates if not with_cofactor or len(candidates) == 1 else candidates[:1]:
            left = end - monotonic()
            if left <= 0:
                return FactorizationOutcome(partial, _out_of_time(seconds))
            try:
                sought = with_cofactor and not lettered and (len(poly) <= _FEW_TERMS or seconds > SECONDS)
                found = factor(poly, seconds=left, cofactor=sought)
            except LimitReached as limited:
                return FactorizationOutcome(partial, _limited(limited.message, seconds, end))
            except GcrulesError:  # not homogeneous in the points: terms that cancel elsewhere
                continue
            if found.exists is None:
                return FactorizationOutcome(partial, _limited(found.certificate.detail, seconds, end))
            for expression, factor_in_front in _expressions(found):
                condition = _condition(expression, factor_in_front, structure, oracle)
                if condition is not None:
                    return FactorizationOutcome(condition)
            family = found.family.name
            if partial is None and found.factors and found.remainder is not None:
                product = ex.mul(*found.factors, _rest(poly, found).to_expr())
                partial = _condition(product, ONE, structure, oracle, BRACKETS_ONLY)
    return FactorizationOutcome(partial, _in_vain(family, len(candidates), structure, sought, cofactor, lettered))


def _in_vain(family: str, number: int, structure: Structure, sought: bool, wanted: bool, lettered: bool) -> str:
    """What was searched without success."""
    note = f"no factorization exists among {family}"
    if structure.given:
        which = f"{number} polynomials" if number > 1 else "polynomial"
        note = f"the shortest {which} equal to the superbracket under the assumptions: no factorization among {family}"
    if lettered:
        return f"{note}; with a cofactor it is sought where all letters are points" if wanted else note
    if sought:
        return f"{note}, nor was one found with a cofactor"
    return f"{note}; with a cofactor it was not sought (--search with more seconds seeks it)" if wanted else note


def _limited(reason: str, seconds: float, end: float) -> str:
    return _out_of_time(seconds) if monotonic() >= end else f"no factorization was found: {reason}"


def _out_of_time(seconds: float) -> str:
    more = "--search gives it more time (in Python search=...)"
    return f"no factorization was found in {seconds:g} seconds; {more}"


def _in_order(polynomials: Iterable[BracketPolynomial]) -> list[BracketPolynomial]:
    """Different ones up to sign, simplest first, whatever the sequence in which they come."""
    found: dict[str, BracketPolynomial] = {}
    for poly in polynomials:
        checkpoint()
        sign = -1 if next(iter(poly.terms.values()), 1) < 0 else 1
        found.setdefault(str(poly * sign), poly * sign)
    return [found[key] for key in sorted(found, key=lambda k: (len(found[k]), k))[:_MOST]]


def _rest(poly: BracketPolynomial, found: Factorization) -> BracketPolynomial:
    """What the brackets leave: the terms of the polynomial without them if all terms hold them, else the quotient."""
    assert found.remainder is not None
    terms = {}
    for m, c in poly.terms.items():
        rows = list(m)
        for f in found.factors:
            row = tuple(sorted(poly.points.index(n) for n in ex.points_of(f)))
            if row not in rows:
                return found.remainder
            rows.remove(row)
        terms[tuple(rows)] = c
    return poly.with_terms(terms)


def _expressions(found: Factorization) -> Iterator[tuple[Expr, Expr]]:
    """Expressions with their cofactors."""
    if found.expression is not None:
        yield ex.mul(*found.factors, found.expression), ONE
    for form in found.rational:
        yield ex.mul(*form.factors, form.expression), form.cofactor


def _condition(
    expression: Expr, cofactor: Expr, structure: Structure, oracle: RandomWitness, kind: str = FACTORIZATION
) -> Condition | None:
    coefficient = oracle.coefficient(expression, cofactor)
    if coefficient is None:
        return None
    known, besides = (_without_sum(expression), (_NO_INCIDENCE,)) if kind == BRACKETS_ONLY else (expression, ())
    condition = Condition(
        kind=kind,
        expression=expression,
        cofactor=cofactor,
        coefficient=coefficient,
        meaning=sentence(known, structure, oracle, cofactor, besides=besides),
        certificate=_TESTED,
    )
    return certify(condition, structure)


_NO_INCIDENCE = "the other factor is zero, for which no incidence was found"


def _without_sum(expression: Expr) -> Expr:
    """The brackets, without the rest."""
    factors = expression.factors if isinstance(expression, ex.Product) else (expression,)
    return ex.mul(*(f for f in factors if not isinstance(f, ex.Sum)))
