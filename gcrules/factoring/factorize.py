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

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from math import prod
from time import monotonic

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, Row
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.text import text
from gcrules.condition import ONE, Certificate
from gcrules.errors import InputError, LimitReached
from gcrules.factoring.brackets import bracket_factors
from gcrules.factoring.extensors import extensor
from gcrules.factoring.irreducible import irreducible
from gcrules.factoring.limits import MAX_EXTENSORS, SECONDS, Budget
from gcrules.factoring.matches import certified
from gcrules.factoring.multilinear import Multilinear, factor_multilinear
from gcrules.factoring.normal import normal, primitive
from gcrules.factoring.products import Groups
from gcrules.factoring.rational import with_cofactor
from gcrules.factoring.result import Factorization, Family, Form, brackets_of
from gcrules.factoring.splitting import split
from gcrules.factoring.trees import simplest

__all__ = ["factor"]

BRACKETS = "products of brackets"
ONE_EXPRESSION = "products of brackets and one expression of joins and meets, all with the polynomial's multidegree"
SEVERAL = "products of brackets and of expressions of joins and meets, all together with the polynomial's multidegree"
MULTILINEAR = "products of expressions of joins and meets, each point used once"

_EQUAL_FORMS = Certificate("normal-form", "the product of the brackets has the normal form of the input")


@dataclass(frozen=True)
class _Task:
    """What was asked for: every expression or the simplest, a cofactor or none, within these limits."""

    budget: Budget
    terms: int
    every: bool
    cofactor: bool


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

    What is found is proved by normal forms. `every` asks for all expressions instead of the simplest. Where there is
    none, `cofactor` asks for one that equals a bracket, or meets of constructed lines, times the polynomial. `limit` is
    the number of extensors that may be held (and that of terms where it is more than 200,000); `progress` is told what
    goes on. Raises InputError for zero, for extensors and where a point does not occur equally often in all terms,
    LimitReached where the answer takes more than a limit.

    Source: White1991 for the steps of the multilinear case, else derived here (docs/factor.md).
    """
    terms = max(limit, MAX_TERMS)
    task = _Task(Budget(limit, progress), terms, every, cofactor)
    poly = expand(e, points=points, ideal=ideal, rank=rank, limit=terms) if isinstance(e, Expr) else e
    if not isinstance(poly, BracketPolynomial):
        raise InputError(f"only scalars are factored, this is {ex.step_name(poly.step, poly.rank)}")
    if not poly.ideal and set((poly.degrees() or {}).values()) == {1}:
        found = _multilinear(poly, task)
    else:
        content, whole = primitive(normal(poly, terms))
        rows, remainder = bracket_factors(whole, limit=terms)
        found = _expressions(content, rows, remainder, task)
    return with_cofactor(found, task.budget, terms=terms, every=every) if cofactor and not found.found else found


# --- multilinear polynomials ---------------------------------------------------------------------------------------


def _multilinear(poly: BracketPolynomial, task: _Task) -> Factorization:
    start = monotonic()
    proof = True
    try:
        poly = normal(poly, task.terms)
    except LimitReached:  # the algorithm itself needs values only
        proof = False
    content, poly = primitive(poly)
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


def _expressions(
    content: int | Fraction, rows: tuple[Row, ...], remainder: BracketPolynomial, task: _Task
) -> Factorization:
    """Search for what the brackets leave, in groups of its irreducible factors, brackets left inside where need be."""
    start = monotonic()
    names, rank = remainder.points, remainder.rank
    if set(remainder.terms) == {()}:
        coefficient = Number(content * remainder.terms[()]).value
        return Factorization(rank, names, coefficient, brackets_of(rows, names), ONE, Family(BRACKETS), _EQUAL_FORMS)
    whole = irreducible(remainder)
    parts = [remainder] if whole else split(remainder, limit=task.terms) or [remainder]
    groups = Groups(rows, parts, task.budget)
    found = groups.cover()
    name = ONE_EXPRESSION if len(parts) == 1 else SEVERAL
    family = Family(name, task.budget.products, groups.built, monotonic() - start)
    if found is None:
        return _none(content, rows, remainder, family, _exhausted(rows, parts, whole=bool(whole)))
    outside, expressions = found
    inside = tuple(sorted((Counter(rows) - Counter(outside)).elements()))
    target = remainder * remainder.with_terms({inside: 1})
    factors = brackets_of(outside, names)
    forms, certificates = [], []
    choices = product(*expressions)
    for choice in choices if task.every else [next(choices)]:
        expression = ex.mul(*(w.expression for w in choice))
        coefficient, certificate = certified(target, expression, task.terms)
        forms.append(Form(Number(content * coefficient).value, factors, expression))
        certificates.append(certificate)
    return Factorization(
        rank,
        names,
        forms[0].coefficient,
        factors,
        forms[0].expression,
        replace(family, seconds=monotonic() - start),
        certificates[0],
        alternatives=tuple(forms[1:]),
        more=prod(map(len, expressions)) - len(forms),
    )


def _exhausted(rows: tuple[Row, ...], parts: Sequence[BracketPolynomial], *, whole: bool) -> Certificate:
    detail = "every expression was refuted by its values at exact positions"
    if rows:
        detail += ", also with brackets that divide left inside it"
    if whole:
        detail += "; what the brackets leave is irreducible, so no other expression of joins and meets equals it"
    elif len(parts) > 1:
        detail += f"; so were those of all groups of the {len(parts)} irreducible factors of what the brackets leave"
    else:
        detail += "; products of several expressions that are no brackets were not tested"
    return Certificate("exhaustive-search", detail, {"irreducible": whole})


def _none(
    content: int | Fraction,
    rows: tuple[Row, ...],
    remainder: BracketPolynomial,
    family: Family,
    certificate: Certificate,
) -> Factorization:
    names = remainder.points
    factors = brackets_of(rows, names)
    return Factorization(remainder.rank, names, content, factors, None, family, certificate, remainder=remainder)
