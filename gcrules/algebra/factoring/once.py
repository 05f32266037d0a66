"""The answer for polynomials in which every point occurs once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import ceil, log10
from time import monotonic

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, primitive
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.factoring.certify import PROVED, certified
from gcrules.algebra.factoring.multilinear import Multilinear, factor_multilinear, seems_zero
from gcrules.algebra.factoring.normal import normal
from gcrules.algebra.factoring.pieces import Pieces
from gcrules.algebra.factoring.result import ExpressionFamily, Factorization, brackets_of
from gcrules.algebra.factoring.tree_letters import extensor
from gcrules.algebra.factoring.trees import simplest
from gcrules.algebra.factoring.whole import Whole, together
from gcrules.algebra.language.text import text
from gcrules.algebra.straightening.order import easy_order
from gcrules.core.seeds import remark

__all__ = ["each_once", "no_factor", "scalars_of"]

MULTILINEAR = "products of expressions of joins and meets, each point used once"


def each_once(pieces: Pieces, terms: int) -> Factorization:
    """Decide by the multilinear algorithm. Raises InputError where a polynomial is zero, LimitReached."""
    start = monotonic()
    answers = [(poly, _decided(poly, terms)) for poly in pieces.polynomials]
    size = sum(found.accepted + found.rejected for _, found in answers)
    incomplete = [found for _, found in answers if not found.complete]
    if incomplete:
        whole = Whole.of(pieces, terms, patient=False)
        alone = [_alone(factor_multilinear(part), part) for part in whole.parts]
        family = ExpressionFamily(MULTILINEAR, size, 0, monotonic() - start)
        none = whole.none(family, no_factor(incomplete, pieces.rank, pieces.points), alone, terms)
        return replace(none, atoms=tuple(extensor(a, pieces.rank) for found in incomplete for a in found.atoms))
    number, certificates = pieces.number, []
    scalars: list[Expr] = list(brackets_of(pieces.rows, pieces.points))
    for poly, found in answers:
        some = scalars_of(found, poly)
        coefficient, certificate = certified(poly, ex.mul(*some), terms)
        number = Number(number * coefficient).value
        scalars += some
        certificates.append(certificate)
    place = {n: i for i, n in enumerate(pieces.points)}
    factors = sorted(filter(_of_points, scalars), key=lambda s: [place[n] for n in ex.points_of(s)])
    others = [s for s in scalars if not _of_points(s)]
    certificate = together(certificates)
    if certificate.method == PROVED.method:
        certificate = Certificate(PROVED.method, f"{certificate.detail}; there is no other expression")
    family = ExpressionFamily(MULTILINEAR, size, 0, monotonic() - start)
    return Factorization(pieces.rank, pieces.points, number, tuple(factors), ex.mul(*others), family, certificate)


def _decided(poly: BracketPolynomial, terms: int) -> Multilinear:
    """The algorithm's answer. Raises InputError for zero; what is zero only modulo the algorithm's prime is divided."""
    if seems_zero(poly):
        poly = primitive(normal(poly.over(easy_order(poly)), terms))[1].over(poly.points)
    return factor_multilinear(poly)


def scalars_of(found: Multilinear, poly: BracketPolynomial) -> list[Expr]:
    """The factors that were found, each as simple as it can be written."""
    return [simplest(*pair, rank=poly.rank, order=poly.points).expression for pair in found.scalars]


def _alone(found: Multilinear, poly: BracketPolynomial) -> Expr | None:
    return ex.mul(*scalars_of(found, poly)) if found.complete else None


def _of_points(e: Expr) -> bool:
    return isinstance(e, ex.Bracket) and all(isinstance(a, ex.Point) for a in e.args)


def no_factor(incomplete: Sequence[Multilinear], rank: int, points: tuple[str, ...]) -> Certificate:
    """The certificate that a multilinear polynomial has no further factor."""
    first = incomplete[0]
    atoms = ", ".join(text(extensor(a, rank), names=points) for a in first.atoms)
    detail = f"the atomic extensors that are left are {atoms}; no meet of two of them is a primitive factor"
    if first.error:
        united = f"points united, {first.accepted} meets accepted" if first.accepted else "points united"
        error = ceil(log10(first.error))
        detail += f" ({united} at exact random positions, error below 1e{error}{remark()})"
    return Certificate("multilinear-algorithm", detail, {"rejected": first.rejected, "accepted": first.accepted})
