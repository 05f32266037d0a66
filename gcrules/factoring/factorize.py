r"""Factorization: is a bracket polynomial a product of brackets and one expression of joins and meets?

>>> from gcrules.algebra.syntax import parse
>>> print(factor(parse("[abfc][acde][bdef] + [abfd][acbe][cdef]")).to_expr())
abc /\ aef /\ bdf /\ cde
>>> print(factor(parse("[[Aa, Ab, Ac, Bd, Be, Cf]]")).to_expr())
[ABCf][ABde][Aabc]
>>> factor(parse("[[ab, cd, ef, gh, ij, kl]]")).found
False
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from itertools import combinations
from math import gcd, lcm
from operator import mul
from time import monotonic

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.straighten import straighten
from gcrules.algebra.text import text
from gcrules.condition import ONE, Certificate
from gcrules.errors import InputError, LimitReached
from gcrules.factoring.brackets import bracket_factors
from gcrules.factoring.cofactor import Rational, bracket_cofactors, line_cofactors
from gcrules.factoring.extensors import extensor
from gcrules.factoring.irreducible import irreducible
from gcrules.factoring.limits import MAX_EXTENSORS, SECONDS, Budget
from gcrules.factoring.matches import certified, search
from gcrules.factoring.multilinear import Multilinear, factor_multilinear
from gcrules.factoring.result import Factorization, Family, Form
from gcrules.factoring.trees import simplest

__all__ = ["factor"]

BRACKETS = "products of brackets"
ONE_EXPRESSION = "products of brackets and one expression of joins and meets, all with the polynomial's multidegree"
MULTILINEAR = "products of expressions of joins and meets, each point used once"

_EQUAL_FORMS = Certificate("normal-form", "the product of the brackets has the normal form of the input")
_TIMES = {0: "not", 1: "once", 2: "twice"}


@dataclass(frozen=True)
class _Task:
    """What was asked for: every expression or the simplest, a cofactor or none, within these limits."""

    budget: Budget
    terms: int
    every: bool
    cofactor: bool


def factor(
    e: Expr | BracketPolynomial,
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
    """Decide whether an expression of step 0 is coefficient · Π brackets · ONE expression of joins and meets.

    What is found is proved by normal forms. `every` asks for all expressions instead of the simplest. Where there is
    none, `cofactor` asks for one that equals a bracket, or meets of constructed lines, times the polynomial. `limit` is
    the number of extensors that may be held (and that of terms where it is more than 200,000); `progress` is told what
    goes on. Raises InputError for zero, for extensors and where a point does not occur equally often in all terms,
    LimitReached where the answer takes more than a limit.

    Source: White1991 for the steps of the multilinear case, else derived here (docs/factor.md).
    """
    terms = max(limit, MAX_TERMS)
    task = _Task(Budget(limit, seconds, progress), terms, every, cofactor)
    poly = e if isinstance(e, BracketPolynomial) else expand(e, points=points, ideal=ideal, rank=rank, limit=terms)
    if not isinstance(poly, BracketPolynomial):
        raise InputError(f"only scalars are factored, this is {ex.step_name(poly.step, poly.rank)}")
    if not poly.ideal and set((poly.degrees() or {}).values()) == {1}:
        found = _multilinear(poly, task)
    else:
        content, normal = _primitive(_normal(poly, terms))
        rows, remainder = bracket_factors(normal, limit=terms)
        found = _one_expression(content, rows, remainder, task)
    return _with_cofactor(found, task) if cofactor and not found.found else found


def _normal(poly: BracketPolynomial, terms: int) -> BracketPolynomial:
    """The normal form. Raises InputError if it is zero or not homogeneous in the points."""
    normal = straighten(poly, limit=terms)
    assert isinstance(normal, BracketPolynomial)
    if not normal:
        raise InputError("the polynomial is zero: every expression divides it", hint="check the signs and the points")
    if normal.degrees() is None:
        first, *others = normal.terms
        for m in others:
            for i, name in enumerate(normal.points):
                one, other = (sum(i in row for row in rows) for rows in (first, m))
                if one != other:
                    raise InputError(
                        f"the polynomial is not homogeneous in the points: {name} occurs "
                        f"{_TIMES.get(one, f'{one} times')} in one term of its normal form and "
                        f"{_TIMES.get(other, f'{other} times')} in another",
                        hint="an expression of joins and meets uses each point equally often in every term",
                    )
    return normal


def _primitive(poly: BracketPolynomial) -> tuple[int | Fraction, BracketPolynomial]:
    """The content (with the sign of the first term) and the polynomial divided by it: whole, coprime numbers."""
    coefficients = [Fraction(c) for c in poly.terms.values()]
    content = Fraction(gcd(*(c.numerator for c in coefficients)), lcm(*(c.denominator for c in coefficients)))
    if coefficients[0] < 0:
        content = -content
    return Number(content).value, poly * (1 / content)


# --- multilinear polynomials ---------------------------------------------------------------------------------------


def _multilinear(poly: BracketPolynomial, task: _Task) -> Factorization:
    start = monotonic()
    proof = True
    try:
        poly = _normal(poly, task.terms)
    except LimitReached:  # the algorithm itself needs values only
        proof = False
    content, poly = _primitive(poly)
    found = factor_multilinear(poly)
    family = Family(MULTILINEAR, found.accepted + found.rejected, 0, monotonic() - start)
    if not found.complete:
        rows, remainder = bracket_factors(poly, limit=task.terms) if proof else ((), poly)
        return _none(content, rows, remainder, family, _no_factor(found, poly))
    scalars = [simplest(*pair, rank=poly.rank, order=poly.points).expression for pair in found.scalars]
    whole = ex.mul(*scalars)
    coefficient, certificate = certified(poly, whole, task.terms, proof=proof)
    place = {n: i for i, n in enumerate(poly.points)}
    factors = sorted((s for s in scalars if _of_points(s)), key=lambda s: [place[n] for n in ex.points_of(s)])
    expression = ex.mul(*(s for s in scalars if not _of_points(s)))
    return Factorization(
        poly.rank,
        poly.points,
        Number(content * coefficient).value,
        tuple(factors),
        expression,
        family,
        replace(certificate, detail=f"{certificate.detail}; there is no other expression"),
    )


def _no_factor(found: Multilinear, poly: BracketPolynomial) -> Certificate:
    atoms = ", ".join(text(extensor(a, poly.rank), names=poly.points) for a in found.atoms)
    detail = f"the atomic extensors that are left are {atoms}; no meet of two of them is a primitive factor"
    if found.accepted:
        detail += f" ({found.accepted} accepted before, error below 1e-12)"
    return Certificate("multilinear-algorithm", detail, {"rejected": found.rejected, "accepted": found.accepted})


def _of_points(e: Expr) -> bool:
    return isinstance(e, ex.Bracket) and all(isinstance(a, ex.Point) for a in e.args)


# --- any other polynomial ------------------------------------------------------------------------------------------


def _one_expression(
    content: int | Fraction, rows: tuple[Row, ...], remainder: BracketPolynomial, task: _Task
) -> Factorization:
    """Search for what the brackets leave, then with some of the brackets left inside the expression."""
    start = monotonic()
    names, rank = remainder.points, remainder.rank
    if set(remainder.terms) == {()}:
        family = Family(BRACKETS, 0, 0, monotonic() - start)
        coefficient = Number(content * remainder.terms[()]).value
        return Factorization(rank, names, coefficient, _brackets(rows, names), ONE, family, _EQUAL_FORMS)
    built = 0
    for inside in _sub_multisets(rows):
        target = remainder * remainder.with_terms({tuple(sorted(inside)): 1})
        written, extensors = search(target, task.budget)
        built = max(built, extensors)
        if not written:
            continue
        outside = list(rows)
        for row in inside:
            outside.remove(row)
        factors = _brackets(outside, names)
        forms, certificates = [], []
        for w in written if task.every else written[:1]:
            coefficient, certificate = certified(target, w.expression, task.terms)
            forms.append(Form(Number(content * coefficient).value, factors, w.expression))
            certificates.append(certificate)
        return Factorization(
            rank,
            names,
            forms[0].coefficient,
            factors,
            forms[0].expression,
            Family(ONE_EXPRESSION, task.budget.products, built, monotonic() - start),
            certificates[0],
            alternatives=tuple(forms[1:]),
            more=len(written) - len(forms),
        )
    family = Family(ONE_EXPRESSION, task.budget.products, built, monotonic() - start)
    return _none(content, rows, remainder, family, _exhausted(rows, remainder))


def _sub_multisets(rows: tuple[Row, ...]) -> Iterator[tuple[Row, ...]]:
    """The brackets that may be left inside the expression, fewest first."""
    for size in range(len(rows) + 1):
        yield from dict.fromkeys(combinations(rows, size))


def _exhausted(rows: tuple[Row, ...], remainder: BracketPolynomial) -> Certificate:
    whole = irreducible(remainder)
    detail = "every expression was refuted by its values at exact positions"
    if rows:
        detail += ", also with brackets that divide left inside it"
    if whole:
        detail += "; what the brackets leave is irreducible, so no other expression of joins and meets equals it"
    else:
        detail += "; products of several expressions that are no brackets were not tested"
    return Certificate("exhaustive-search", detail, {"irreducible": bool(whole)})


def _none(
    content: int | Fraction,
    rows: tuple[Row, ...],
    remainder: BracketPolynomial,
    family: Family,
    certificate: Certificate,
) -> Factorization:
    names = remainder.points
    factors = _brackets(rows, names)
    return Factorization(remainder.rank, names, content, factors, None, family, certificate, remainder=remainder)


def _brackets(rows: Iterable[Row], names: tuple[str, ...]) -> tuple[Expr, ...]:
    return tuple(ex.Bracket(tuple(ex.Point(names[i]) for i in row)) for row in sorted(rows))


# --- one expression that equals a multiple of the polynomial ---------------------------------------------------------


def _with_cofactor(found: Factorization, task: _Task) -> Factorization:
    """Seek a cofactor: brackets first, one of each orbit, then meets of constructed lines; without `every` up to the
    first that works. What the brackets leave is multiplied; if nothing works, the whole polynomial.
    """
    assert found.remainder is not None
    poly = found.remainder
    rational: list[Form] = []
    excluded: list[str] = []
    undecided: list[str] = []
    images = 0

    def note(outcome: Rational, factors: tuple[Expr, ...]) -> None:
        for w in outcome.expressions if task.every else outcome.expressions[:1]:
            coefficient, _ = certified(outcome.polynomial, w.expression, task.terms)
            rational.append(
                Form(Number(found.coefficient * coefficient).value, factors, w.expression, outcome.cofactor)
            )

    for orbit, outcome in bracket_cofactors(poly, task.budget, task.terms):
        shown = str(_brackets(orbit[:1], poly.points)[0])
        if isinstance(outcome, LimitReached):
            undecided.append(shown)
        elif outcome is None:
            excluded.append(shown)
            images += len(orbit)
        else:
            note(outcome, found.factors)
            if not task.every:
                break
    whole = reduce(mul, (poly.with_terms({(_row(f, poly),): 1}) for f in found.factors), poly)
    for target, factors in ((poly, found.factors), (whole, ())):
        if not rational:
            for constructed in line_cofactors(target, task.budget):
                note(constructed, factors)
                if not task.every:
                    break
    notes = []
    if excluded:
        notes.append(f"no expression with the cofactor {', '.join(excluded)} or an image by symmetry ({images} in all)")
    if undecided:
        notes.append(f"not decided within the limits: {', '.join(undecided)}")
    return replace(found, rational=tuple(rational), excluded=tuple(notes))


def _row(bracket: Expr, poly: BracketPolynomial) -> Row:
    return tuple(poly.points.index(n) for n in ex.points_of(bracket))
