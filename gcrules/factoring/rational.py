"""A factorization with a cofactor, where there is none without."""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from itertools import islice
from operator import mul

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number
from gcrules.errors import LimitReached
from gcrules.factoring.cofactor import Rational, bracket_cofactors, line_cofactors
from gcrules.factoring.irreducible import irreducible
from gcrules.factoring.limits import Budget
from gcrules.factoring.matches import certified
from gcrules.factoring.normal import normal
from gcrules.factoring.result import Factorization, Form, brackets_of
from gcrules.factoring.splitting import split
from gcrules.factoring.symmetry import Symmetries

__all__ = ["with_cofactor"]


def with_cofactor(found: Factorization, budget: Budget, *, terms: int, every: bool) -> Factorization:
    """Seek a cofactor: brackets first, one of each orbit, then meets of constructed lines, which multiply what the
    brackets leave, or else the whole polynomial; without `every` up to the first that works.
    """
    poly = found.remainder
    assert poly is not None
    rows = tuple(tuple(poly.points.index(n) for n in ex.points_of(f)) for f in found.factors)
    whole = normal(reduce(mul, (poly.with_terms({(row,): 1}) for row in rows), poly), terms) if rows else poly
    symmetries = Symmetries(whole, limit=terms)
    alone = bool(irreducible(poly, budget))
    parts = [poly] if alone else split(poly, budget, limit=terms) or [poly]
    most = None if every else 1
    rational: list[Form] = []
    excluded: list[str] = []
    undecided: list[str] = []
    images = 0

    def note(outcome: Rational, factors: tuple[Expr, ...]) -> None:
        for e in outcome.expressions[:most]:
            coefficient, _ = certified(outcome.polynomial, e, terms)
            rational.append(Form(Number(found.coefficient * coefficient).value, factors, e, outcome.cofactor))

    for orbit, outcome in bracket_cofactors(rows, parts, budget, symmetries):
        shown = str(brackets_of(orbit[:1], poly.points)[0])
        if isinstance(outcome, LimitReached):
            undecided.append(shown)
        elif outcome is None:
            excluded.append(shown)
            images += len(orbit)
        else:
            note(outcome, brackets_of(outcome.outside, poly.points))
            if not every:
                break
    if not rational:
        own = Symmetries(poly, limit=terms) if rows else symmetries
        for constructed in islice(line_cofactors(poly, budget, own), most):
            note(constructed, found.factors)
    if rows and not rational:
        for constructed in islice(line_cofactors(whole, budget, symmetries), most):
            note(constructed, ())
    one = "expression" if alone or len(parts) > 1 else "single expression"
    notes = []
    if excluded:
        notes.append(f"no {one} with the cofactor {', '.join(excluded)} or an image by symmetry ({images} in all)")
    if undecided:
        notes.append(f"not decided within the limits: {', '.join(undecided)}")
    return replace(found, rational=tuple(rational), excluded=tuple(notes))
