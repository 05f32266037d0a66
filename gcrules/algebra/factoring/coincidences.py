r"""Cofactors that are excluded where points coincide.

If E = bracket · P for an expression E, then so where some points coincide: E, with one name for these points, is an
expression of the same kind. So no expression equals bracket · P as soon as none does after such a coincidence (with
both sides not zero). There are fewer points then, and several brackets have the same image: the search over all
expressions is many times shorter, and one search excludes many brackets.

The reverse does not hold. A bracket that no coincidence excludes is searched for in full.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from functools import cached_property
from itertools import combinations

from gcrules.algebra.bracket import BracketPolynomial, Row, Terms, sorted_row
from gcrules.algebra.factoring.brackets import vanishing_pairs
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import search
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Coincidences", "coinciding", "united"]

_MOST = 20  # points with which coincidences are tried
_FEW = 3  # points beyond the rank that are left apart
_TRIES = 2  # searches in vain before the full one, for each point beyond
_IMAGES = 6
_PAIRS = 60  # coincidences that are tried, one after the other


def coinciding(poly: BracketPolynomial, kept: int, gone: int) -> BracketPolynomial:
    """The polynomial where a point coincides with another, which is kept, in normal form."""
    normal = straighten(united(poly, kept, gone))
    assert isinstance(normal, BracketPolynomial)
    return normal


def united(poly: BracketPolynomial, kept: int, gone: int) -> BracketPolynomial:
    """The polynomial where a point coincides with another, which is kept, equal terms collected."""
    terms: Terms = {}
    for monomial, c in poly.terms.items():
        sign, rows = c, []
        for row in monomial:
            s, new = sorted_row(tuple(kept if i == gone else i for i in row))
            sign *= s
            rows.append(new)
        if sign:
            key = tuple(sorted(rows))
            terms[key] = terms.get(key, 0) + sign
    return poly.with_terms(terms)


@dataclass
class _Image:
    """The polynomial after some coincidences; `home` says where each point lies. `excluded` remembers, for brackets,
    whether the search found no expression.
    """

    poly: BracketPolynomial
    home: dict[int, int]
    excluded: dict[Row, bool] = field(default_factory=dict)

    def image(self, row: Row) -> Row | None:
        """The bracket after the coincidences; None if it vanishes."""
        moved = tuple(sorted({self.home[i] for i in row}))
        return moved if len(moved) == len(row) else None

    def excludes(self, row: Row, effort: Effort) -> bool:
        """Whether no expression equals this bracket times the polynomial, by a search over all of them."""
        if row not in self.excluded:
            multiple = self.poly * self.poly.with_terms({(row,): 1})
            self.excluded[row] = not search(multiple, effort.renewed(), first=True)[0]
        return self.excluded[row]


class Coincidences:
    """What coincidences exclude for one polynomial in normal form, which is itself no expression."""

    def __init__(self, poly: BracketPolynomial, effort: Effort) -> None:
        self.poly = poly
        self.effort = effort
        self.images: list[_Image] = []

    def exclude(self, orbit: list[Row]) -> bool:
        """Whether a bracket of an orbit under symmetries, so all of them, is excluded as a cofactor."""
        if self.poly.ideal or not self.poly.rank + _FEW < len(self._used) <= _MOST:
            return False
        try:
            return self._known(orbit) or any(m.excludes(row, self.effort) for m, row in self._new(orbit))
        except LimitReached:
            return False

    @cached_property
    def _used(self) -> list[int]:
        return sorted({i for m in self.poly.terms for row in m for i in row})

    def _known(self, orbit: list[Row]) -> bool:
        return any(m.excluded.get(image, False) for m in self.images for row in orbit if (image := m.image(row)))

    def _new(self, orbit: list[Row]) -> Iterator[tuple[_Image, Row]]:
        """Images of the orbit's brackets that were not searched yet, the fewer the fewer points there are: those under
        known coincidences, then one under new ones.
        """
        tries = _TRIES * (len(self._used) - self.poly.rank - _FEW)
        for m in self.images:
            for row in orbit:
                image = m.image(row)
                if image and image not in m.excluded and tries > 0:
                    tries -= 1
                    yield m, image
        if tries > 0 and len(self.images) < _IMAGES:
            m = self._image(orbit[0])
            self.images.append(m)
            image = m.image(orbit[0])
            assert image is not None
            yield m, image

    def _image(self, apart: Row) -> _Image:
        """A polynomial in few points that is no expression, the points of a bracket staying apart."""
        poly, home = self.poly, {i: i for i in self._used}
        points, tried = list(self._used), 0
        while len(points) > poly.rank + _FEW:
            vanishing = vanishing_pairs(poly)
            for kept, gone in combinations(points, 2):
                tried += 1
                checkpoint()
                if (kept, gone) in vanishing or {home[i] for i in apart} >= {kept, gone}:
                    continue
                candidate = coinciding(poly, kept, gone)
                if not search(candidate, self.effort.renewed(), first=True)[0]:
                    poly = candidate
                    home = {i: kept if h == gone else h for i, h in home.items()}
                    points.remove(gone)
                    break
                if tried > _PAIRS:
                    return _Image(poly, home)
            else:
                break
        return _Image(poly, home)
