r"""Matrices over whole boxes: whether all of them have full rank, and what their least singular values are at least.

The matrices of a box are W = W₀ + Σ eᵢ Wᵢ + …, of Taylor models. With a left inverse B of the middle, |1 − B W| is in
all entries at most a matrix A; where the spectral radius of A is below 1, every W of the box has full rank. The radius
is at most max (A v)ᵢ / vᵢ for each positive v (Collatz and Wielandt).

Let W + D have a kernel, x in it, and |D| ≤ m. Then x = (1 − B W) x − B D x, so that |x| ≤ A |x| + m |x| ℓ with the
lengths ℓ of B's rows. With v = (1 − A)⁻¹ ℓ, positive, and t the least with |x| ≤ t v, some vᵢ ≤ (A v)ᵢ + m |v| ℓᵢ: so
the least singular value is at least 1/|v|. In small boxes σ₀ − |R| is better, σ₀ that of the middle, R the sizes of
W − W₀ and |R| ≤ √(|R|₁ |R|_∞). Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.poses.boxes.taylor import Models, pairs

__all__ = ["Matrices", "Products", "signs"]

Floats = NDArray[np.float64]
Truths = NDArray[np.bool_]

_POWERS = 4  # of a matrix: they bring a vector near to the one by which its radius is bounded best
_ROUNDING = 1e-12  # of an inverse and of products with it, in parts of their terms
_APART = 1e-6  # of wrenches of length 1: nearer to dependent ones no bound is told
_CERTAIN = 1e-9  # of the product of the rows' lengths: smaller determinants have no sign


@dataclass(frozen=True, eq=False)
class Matrices:
    """Matrices over N boxes: in the `middles` (N, r, c), what each term adds (N, T, r, c), and what is left out."""

    middles: Floats
    terms: Floats
    rest: Floats

    @classmethod
    def of(cls, found: Models, some: Truths, entries: int, columns: int) -> Matrices:
        """The first models, so many entries of matrices with so many columns, of some boxes."""
        number = int(some.sum())
        changes = np.ascontiguousarray(found.changes[:entries, :, some].transpose(2, 1, 0))
        middles, rest = (np.ascontiguousarray(c[:entries, some].T) for c in (found.centres, found.rest))
        shape = (number, -1, columns)
        return cls(middles.reshape(shape), changes.reshape(number, changes.shape[1], -1, columns), rest.reshape(shape))

    def scaled(self, by: Floats) -> Matrices:
        """Products of matrices (N, r, r) and these."""
        return Matrices(by @ self.middles, by[:, None] @ self.terms, np.abs(by) @ self.rest)

    def radius(self, n: int) -> tuple[Floats, Floats]:
        """A bound (N,) of the spectral radius of A, infinite where the middle has no inverse, and the parts (n, N) that
        the coordinates have in it.
        """
        whole, sizes = self._bounded(_left_inverses(self.middles))
        v = np.ones((*whole.shape[:2], 1))
        for _ in range(_POWERS):
            v = whole @ v + v / 8
            v /= v.max(axis=1, keepdims=True)
        found = (whole @ v / v).max(axis=(1, 2))
        parts = (sizes @ v[:, None] / v[:, None]).max(axis=(2, 3))
        return np.where(np.isfinite(found), found * (1 + _ROUNDING), np.inf), _shared(parts, n)

    def bounds(self, n: int) -> tuple[Floats, Floats]:
        """What the least singular value is at least in a box, and the parts of the coordinates."""
        back = _left_inverses(self.middles)
        whole, sizes = self._bounded(back)
        lengths = np.linalg.norm(back, axis=2)[..., None]
        small = np.isfinite(whole).all(axis=(1, 2)) & np.isfinite(lengths).all(axis=(1, 2))
        left = np.eye(whole.shape[1]) - np.where(small[:, None, None], whole, 0.0)
        small &= np.abs(np.linalg.det(left)) > _ROUNDING
        left[~small] = np.eye(whole.shape[1])
        v = np.linalg.solve(left, np.where(small[:, None, None], lengths, 1.0))
        good = small & (v > 0).all(axis=(1, 2))
        spare = ((v - whole @ v) / lengths).min(axis=(1, 2))  # is 1 but for rounding
        by_inverse = np.where(good, spare / np.linalg.norm(v, axis=(1, 2)), 0.0)
        far = np.abs(self.terms).sum(axis=1) + self.rest + _ROUNDING
        by_size = np.linalg.svd(self.middles, compute_uv=False)[:, -1] - _norm(far)
        found = np.nan_to_num(np.maximum(by_inverse, by_size) - _ROUNDING)
        parts = (sizes @ np.where(good[:, None, None], np.abs(v), 1.0)[:, None] / lengths[:, None]).max(axis=(2, 3))
        return np.maximum(found, 0.0), _shared(np.nan_to_num(parts), n)

    def _bounded(self, back: Floats) -> tuple[Floats, Floats]:
        """A (N, c, c) for left inverses, and what each term (N, T, c, c) has in it."""
        number, count, rows, columns = self.terms.shape
        flat = self.terms.transpose(0, 2, 1, 3).reshape(number, rows, count * columns)
        sizes = np.abs((back @ flat).reshape(number, columns, count, columns)).transpose(0, 2, 1, 3)
        most = np.abs(self.middles) + np.abs(self.terms).sum(axis=1) + self.rest
        off = np.abs(np.eye(columns) - back @ self.middles) + np.abs(back) @ (self.rest + _ROUNDING * most)
        return sizes.sum(axis=1) + off, sizes


def _left_inverses(matrices: Floats) -> Floats:
    """Left inverses; not numbers where there is none."""
    if matrices.shape[1] == matrices.shape[2]:
        fine = np.linalg.det(matrices) != 0
        found = np.full(matrices.shape, np.nan)
        found[fine] = np.linalg.inv(matrices[fine])
        return found
    return np.asarray(np.linalg.pinv(matrices))


def _norm(sizes: Floats) -> Floats:
    """Bounds of the largest singular values of matrices with entries of at most these sizes."""
    return np.asarray(np.sqrt(sizes.sum(axis=1).max(axis=1) * sizes.sum(axis=2).max(axis=1)))


def _shared(parts: Floats, n: int) -> Floats:
    """What each coordinate (n, N) has in parts (N, T) of terms: of those of two coordinates each a half."""
    first, second = pairs(n)
    found = parts[:, :n].copy()
    for k in range(n):
        found[:, k] += (parts[:, n:][:, first == k].sum(axis=1) + parts[:, n:][:, second == k].sum(axis=1)) / 2
    return found.T


@dataclass(frozen=True, eq=False)
class Products:
    """The products G of the rows of a limb with each other over N boxes: in the places from which rows are seen, in the
    middles of their ranges, and how far they are from these at most, (N, k, k) each.
    """

    places: Floats
    middles: Floats
    radii: Floats

    @classmethod
    def several(cls, found: Models, some: Truths, groups: Sequence[int]) -> Iterator[Products]:
        """Those of limbs with so many rows each, one limb after the other, of some boxes."""
        at = 0
        for k in groups:
            own = slice(at, at + k * k)
            parts = (found.terms[own, 0], found.centres[own], found.radii[own])
            yield cls(*(np.ascontiguousarray(c[:, some].T).reshape(-1, k, k) for c in parts))
            at += k * k

    def orthonormal(self) -> tuple[Floats, Floats]:
        """What makes the rows orthonormal in the places, (N, k, k), and the square of the factor by which others in the
        box are longer at most, (N,): infinite where they nearly depend on each other.

        With G = K Kᵀ in a place K⁻¹ makes the rows orthonormal there; elsewhere in the box the largest eigenvalue of
        K⁻¹ G K⁻ᵀ, at most its largest sum of a row, is the square of that factor.
        """
        lengths = np.sqrt(np.maximum(np.diagonal(self.places, axis1=1, axis2=2), 0.0))
        fine = np.asarray((lengths > 0).all(axis=1))
        unit = 1 / np.where(fine[:, None], lengths, 1.0)
        whole = np.where(fine[:, None, None], self.places, np.eye(self.places.shape[1]))
        alike = unit[:, :, None] * whole * unit[:, None]
        fine &= np.linalg.eigvalsh(alike)[:, 0] > _APART
        alike[~fine] = np.eye(alike.shape[1])
        back = np.linalg.inv(np.linalg.cholesky(alike)) * unit[:, None]
        sizes, turned = np.abs(back), np.swapaxes(back, 1, 2)
        changed = np.abs(back @ self.middles @ turned) + sizes @ self.radii @ np.swapaxes(sizes, 1, 2)
        return back, np.where(fine, np.maximum(changed.sum(axis=2).max(axis=1), 1.0) * (1 + _CERTAIN), np.inf)


def signs(matrices: Floats) -> NDArray[np.int8]:
    """The signs of determinants, 0 where they are 0 within rounding."""
    values = np.linalg.det(matrices)
    sizes = np.prod(np.linalg.norm(matrices, axis=2), axis=1)
    return np.where(np.abs(values) > _CERTAIN * sizes, np.sign(values), 0).astype(np.int8)
