r"""Permutations of the points that take a polynomial to plus or minus itself, and how they permute bracket monomials.

Exchanges of up to three pairs of points are tried at random positions; the generators that are kept are proved by
normal forms. There may be more symmetries: orbits may then be finer than they could be, which costs time only.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.factoring.modular import Ints
from gcrules.algebra.factoring.symmetry import exchanges, sign_under
from gcrules.algebra.shortening.monomials import Monomials, canonical
from gcrules.core.dataclass import dataclass

__all__ = ["Orbits", "Symmetry", "orbits", "symmetry"]

_ELEMENTS = 50_000
_GENERATORS = 8  # elements that stand for a stabilizer when its orbits are formed


@dataclass(frozen=True)
class Symmetry:
    """`elements`: permutations of the points, one in each row, the identity among them, with P(g) = ±P.

    `generators` generate them, and `signs` are those of the generators; `order` is the number of symmetries that are
    known. Where they are too many only the identity is listed.
    """

    order: int
    elements: Ints
    generators: Ints
    signs: Ints

    @staticmethod
    def none(poly: BracketPolynomial) -> Ints:
        """The identity as the only element."""
        return np.arange(len(poly.points))[None, :]


def symmetry(poly: BracketPolynomial, limit: int) -> Symmetry:
    """The symmetries of a homogeneous polynomial in normal form."""
    n = len(poly.points)
    group = _Group(n)
    signs: list[int] = []
    for permutation in exchanges(poly):
        if permutation.tobytes() not in group.listed and (sign := sign_under(poly, permutation, limit)):
            signs.append(sign)
            group.add(permutation)
    generators = np.array(group.generators, dtype=np.int64).reshape(-1, n)
    return Symmetry(group.order, group.elements, generators, np.array(signs, dtype=np.int64))


class _Group:
    """A group of permutations that grows; beyond a number of elements only the identity is listed."""

    def __init__(self, n: int) -> None:
        self.generators: list[Ints] = []
        self.elements = np.arange(n)[None, :]
        self.listed = {self.elements[0].tobytes()}
        self.order = 1

    def add(self, permutation: Ints) -> None:
        """Add cosets of the group so far until all generators permute them (Dimino's algorithm)."""
        self.generators.append(permutation)
        if self.order > _ELEMENTS:
            return
        before, found, fresh = self.elements, [self.elements], [self.elements[0]]
        while fresh:
            one = fresh.pop()
            for g in self.generators:
                if one[g].tobytes() not in self.listed:
                    coset = before[:, one[g]]
                    self.listed.update(map(bytes, coset))
                    found.append(coset)
                    fresh.append(one[g])
            self.order = len(self.listed)
            if self.order > _ELEMENTS:
                self.elements, self.listed = before[:1], {before[0].tobytes()}
                return
        self.elements = np.concatenate(found)


@dataclass(frozen=True)
class Orbits:
    """Which orbit each monomial is in (named by its smallest member), and which orbits cancel.

    An orbit cancels if some symmetry takes one of its monomials to ±itself with another sign than the polynomial: the
    sum of the polynomial's images, each with its sign, then holds no monomial of the orbit.
    """

    label: Ints
    cancels: np.ndarray[tuple[int], np.dtype[np.bool_]]


class Action:
    """How permutations of the points act on bracket monomials."""

    def __init__(self, monomials: Monomials) -> None:
        self.monomials = monomials
        self.points = len(monomials.degrees)
        self.codes = self._codes(monomials.rows)
        self.order = np.argsort(self.codes)
        self.sorted = self.codes[self.order]
        different = (self.sorted[1:] != self.sorted[:-1]).all()
        self.exact = bool(different) and monomials.ideal < monomials.rank - 1  # images can be found by their codes

    def _codes(self, rows: Ints) -> Ints:
        """A number for each monomial; numbers that overflow may be shared."""
        rows = np.sort(rows, axis=-1)
        code = rows @ (np.int64(self.points) ** np.arange(rows.shape[-1]))
        code = np.sort(code, axis=-1)
        total = np.zeros(code.shape[:-1], dtype=np.int64)
        for k in range(code.shape[-1]):
            total = total * np.int64(6364136223846793005) + code[..., k]
        return total

    def image(self, permutation: Ints) -> Ints:
        """The places of the images of all monomials."""
        if self.exact:
            places: Ints = self.order[np.searchsorted(self.sorted, self._codes(permutation[self.monomials.rows]))]
            return places
        place, ideal = self.monomials.place, self.monomials.ideal
        moved = np.sort(permutation[self.monomials.rows], axis=-1).tolist()
        found = [canonical(tuple(sorted(map(tuple, m))), ideal) for m in moved]
        return np.array([place[m] for m in found if m is not None], dtype=np.int64)

    def signs(self, permutation: Ints) -> Ints:
        """The signs with which the brackets of the images are put in order."""
        moved = permutation[self.monomials.rows]
        rank = moved.shape[-1]
        turned = sum((moved[..., i] > moved[..., j]).sum(axis=-1) for i, j in combinations(range(rank), 2))
        return np.asarray(1 - 2 * (np.asarray(turned) % 2), dtype=np.int64)

    def stabilizer(self, elements: Ints, place: int) -> Ints:
        """The elements that take one monomial to plus or minus itself (a part of them, where codes do not tell)."""
        if not self.exact:
            return elements[:0]
        kept: Ints = elements[self._codes(elements[:, self.monomials.rows[place]]) == self.codes[place]]
        return kept

    def labels(self, elements: Ints) -> Ints:
        """The orbits under the group that some of the elements generate, each named by its smallest member."""
        step = max(1, len(elements) // _GENERATORS)
        some = elements[::step] if len(elements) > _GENERATORS else elements
        return _components(len(self.monomials), [self.image(g) for g in some])


def orbits(monomials: Monomials, found: Symmetry) -> Orbits:
    """The orbits of bracket monomials under the symmetries of a polynomial."""
    n = len(monomials)
    action = Action(monomials)
    twice = []  # on a second copy of the monomials stand those with the other sign
    for permutation, sign in zip(found.generators, found.signs, strict=True):
        image, turned = action.image(permutation), action.signs(permutation) != sign
        twice.append(np.concatenate([image + n * turned, image + n * ~turned]))
    label = _components(2 * n, twice)
    return Orbits(np.minimum(label[:n], label[n:]), label[:n] == label[n:])


def _components(n: int, images: list[Ints]) -> Ints:
    """The components of the graph on 0 … n − 1 with edges i – image[i], each named by its smallest member."""
    label = np.arange(n)
    while True:
        new = label.copy()
        for image in images:
            np.minimum(new, new[image], out=new)
            np.minimum.at(new, image, new.copy())
        if (new == label).all():
            return label
        label = new
