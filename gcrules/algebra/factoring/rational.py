"""A factorization with a cofactor, where there is none without."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, replace
from functools import reduce
from itertools import islice
from operator import mul

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import Row
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.factoring.certify import certified
from gcrules.algebra.factoring.cofactor import Rational, bracket_cofactors, line_cofactors
from gcrules.algebra.factoring.irreducible import irreducible
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.normal import normal
from gcrules.algebra.factoring.result import FactoredForm, Factorization, brackets_of
from gcrules.algebra.factoring.splitting import split
from gcrules.algebra.factoring.symmetry import Symmetries
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["COFACTORS_OF_POINTS", "with_cofactor"]

COFACTORS_OF_POINTS = "a cofactor: it is sought where all letters are points"


def with_cofactor(found: Factorization, effort: Effort, *, terms: int, every: bool) -> Factorization:
    """Seek a cofactor: brackets first, one of each orbit, then meets of constructed lines, which multiply what the
    brackets leave, or else the whole polynomial; without `every` up to the first that works.

    Where a limit is reached, what was found before stands, and `undecided` says so.
    """
    if found.remainder is None:
        return replace(found, undecided=(f"a cofactor: what is left has more than {terms:,} terms",))
    search = _Search(found, effort, terms, every)
    try:
        search.run()
    except LimitReached as reached:
        search.undecided.append(f"all others ({reached.message})")
    return replace(found, rational=tuple(search.rational), excluded=search.in_vain(), undecided=tuple(search.undecided))


@dataclass
class _Search:
    found: Factorization
    effort: Effort
    terms: int
    every: bool
    rational: list[FactoredForm] = field(default_factory=list)
    excluded: list[str] = field(default_factory=list)
    undecided: list[str] = field(default_factory=list)
    images: int = 0
    what: str = "expression"

    def run(self) -> None:
        poly, effort = self.found.remainder, self.effort
        assert poly is not None
        rows = tuple(tuple(poly.points.index(n) for n in ex.points_of(f)) for f in self.found.factors)
        alone = bool(irreducible(poly))
        parts = [poly] if alone else split(poly, limit=self.terms) or [poly]
        if not alone and len(parts) == 1:
            self.what = "single expression"
        whole = normal(reduce(mul, (poly.with_terms({(row,): 1}) for row in rows), poly), self.terms) if rows else poly
        symmetries = Symmetries(whole, limit=self.terms)
        self._brackets(bracket_cofactors(rows, parts, effort, symmetries), poly.points)
        most = None if self.every else 1
        if not self.rational:
            own = Symmetries(poly, limit=self.terms) if rows else symmetries
            for constructed in islice(line_cofactors(poly, effort, own), most):
                self._note(constructed, self.found.factors)
        if rows and not self.rational:
            for constructed in islice(line_cofactors(whole, effort, symmetries), most):
                self._note(constructed, ())

    def _brackets(
        self, outcomes: Iterator[tuple[list[Row], Rational | LimitReached | None]], points: tuple[str, ...]
    ) -> None:
        for orbit, outcome in outcomes:
            shown = str(brackets_of(orbit[:1], points)[0])
            if isinstance(outcome, LimitReached):
                self.undecided.append(shown)
            elif outcome is None:
                self.excluded.append(shown)
                self.images += len(orbit)
            else:
                self._note(outcome, brackets_of(outcome.outside, points))
                if not self.every:
                    return

    def _note(self, outcome: Rational, factors: tuple[Expr, ...]) -> None:
        for e in outcome.expressions if self.every else outcome.expressions[:1]:
            coefficient, _ = certified(outcome.polynomial, e, self.terms)
            value = Number(self.found.coefficient * coefficient).value
            self.rational.append(FactoredForm(value, factors, e, outcome.cofactor))

    def in_vain(self) -> tuple[str, ...]:
        if not self.excluded:
            return ()
        tried = ", ".join(self.excluded)
        return (f"no {self.what} with the cofactor {tried} or an image by symmetry ({self.images} in all)",)
