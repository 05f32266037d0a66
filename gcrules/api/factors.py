"""The public function that finds irreducible factors."""

from __future__ import annotations

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.forms import Factors
from gcrules.algebra.factoring.limits import MAX_EXTENSORS, SECONDS
from gcrules.algebra.language.text import Names
from gcrules.api.reading import expression_of, where
from gcrules.api.signatures import public
from gcrules.core.deferred import deferred

__all__ = ["Factors", "factors"]

_factors = deferred("gcrules.algebra.factoring.factors:factors")


@public
def factors(
    e: str | Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
    limit: int = MAX_EXTENSORS,
    seconds: float = SECONDS,
) -> Factors:
    """The irreducible factors of a scalar over the rationals, each with its multiplicity, its degrees and a form.

    The form of a factor is one expression of joins and meets, else a comparison of the turns about two lines, else two
    bracket monomials, else one expression with a cofactor, else none, with what was excluded. Where a limit ends the
    search for a form, or that for the factors themselves, these are undecided. Raises InputError for zero and for what
    is not homogeneous in the points, LimitReached where a limit is reached before it is known that the scalar is not
    zero.
    """
    at = where(rank, points, ideal, isotropic, orthonormal, letters)
    answer: Factors = _factors(
        e if isinstance(e, (BracketPolynomial, ExtensorPolynomial)) else expression_of(e, at),
        points=at.points,
        ideal=at.ideal,
        rank=rank,
        limit=limit,
        seconds=seconds,
    )
    return answer
