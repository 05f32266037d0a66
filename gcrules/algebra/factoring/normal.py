"""The polynomial that is factored: in normal form, not zero, homogeneous in the points, whole and coprime numbers."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Terms, primitive
from gcrules.algebra.factoring.residues import random_positions, residues, values
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.errors import InputError

__all__ = ["normal", "not_zero", "zero"]

_TIMES = {0: "never", 1: "once", 2: "twice"}

Degrees = tuple[tuple[int, int], ...]  # point, how often it occurs


def normal(poly: BracketPolynomial, terms: int) -> BracketPolynomial:
    """The normal form. Raises InputError if it is zero or not homogeneous in the points, LimitReached.

    Syzygies keep how often each point occurs, so terms of different multidegrees never cancel: a polynomial with two
    parts that are not zero somewhere is not homogeneous, which is told without its normal form.
    """
    parts: dict[Degrees, Terms] = {}
    for m, c in poly.terms.items():
        parts.setdefault(_degrees(m), {})[m] = c
    if len(parts) > 1:
        _one_of([d for d, part in parts.items() if not_zero(poly.with_terms(part))], poly.points)
    found = straighten(poly, limit=terms)
    assert isinstance(found, BracketPolynomial)
    if not found:
        raise zero()
    _one_of(list(dict.fromkeys(map(_degrees, found.terms))), poly.points)
    return found


def zero() -> InputError:
    """What is raised for the polynomial zero."""
    return InputError("the polynomial is zero: every expression divides it", hint="check the signs and the points")


def _degrees(m: Monomial) -> Degrees:
    return tuple(sorted(Counter(i for row in m for i in row).items()))


def not_zero(part: BracketPolynomial) -> bool:
    """Whether a polynomial is not zero at random positions, which is certain if it is so."""
    p = residues(part.rank).p
    at = random_positions(2, len(part.points), part.rank, p, ideal=part.ideal, seed=1)
    return bool(values(primitive(part)[1], at, p).any())


def _one_of(degrees: Sequence[Degrees], points: Sequence[str]) -> None:
    """Raises InputError for two different multidegrees."""
    if len(degrees) < 2:
        return
    one, other = map(dict, degrees[:2])
    i = min(i for i in range(len(points)) if one.get(i, 0) != other.get(i, 0))
    first, second = (_TIMES.get(n, f"{n} times") for n in (one.get(i, 0), other.get(i, 0)))
    raise InputError(
        f"the polynomial is not homogeneous in the points: {points[i]} occurs {first} in some terms of its normal form "
        f"and {second} in others",
        hint="an expression of joins and meets uses each point equally often in every term",
    )
