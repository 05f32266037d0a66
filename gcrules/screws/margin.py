r"""The six legs' Jacobian at poses, and the measure σ, the same in every frame and unit; vectorised over N poses.

A twist moves the platform; leg i changes its length at the rate u_i·v_i, u_i its unit direction and v_i the velocity of
its joint on the platform. σ² is the least value of Σ (u_i·v_i)² / Σ |v_i|² over all twists: how much of the platform's
softest motion the legs notice. 0 ≤ σ ≤ 1, and σ = 0 exactly where the robot is singular. Derived here (docs/pose.md).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["LegJacobians", "jacobian", "on_one_line"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LegJacobians:
    """Arrays for N poses; twists are (v, ρω) with v the velocity of the centroid of the legs' platform ends.

    `centroid` (N, 3); `arms` (N, 6, 3) are the ends less the centroid; `radius` ρ, their root-mean-square length, is
    the characteristic length; `rows` (N, 6, 6) are the legs' (u, (arm/ρ) × u); `lengths` (N, 6); `directions` u
    (N, 6, 3).
    `spread` is the root of the summed squared distances of the ends from the line that is nearest to them; `far` and
    `far_ends` (N,) are the largest coordinates of all points and of the platform's, by which floats are rounded.
    """

    centroid: Floats
    arms: Floats
    radius: float
    rows: Floats
    lengths: Floats
    directions: Floats
    spread: float
    far: Floats
    far_ends: Floats
    _turn: Floats  # (N, 3, 3), the inverse root of the ends' inertia

    @cached_property
    def sigma(self) -> Floats:
        """The measure, shape (N,)."""
        found: Floats = np.minimum(np.linalg.svd(self._balanced, compute_uv=False)[:, 5], 1.0)
        return found

    @cached_property
    def softest(self) -> Floats:
        """The twist that takes the measure, with root-mean-square speed 1 of the ends, shape (N, 6)."""
        soft = self._vectors[2][:, 5, :]
        turned = np.einsum("nij,nj->ni", self._turn, soft[:, 3:])
        return np.concatenate([soft[:, :3], turned * np.sqrt(6)], axis=1)

    @property
    def stress(self) -> Floats:
        """The forces in the legs, of length 1 together, that nearly balance, shape (N, 6)."""
        found: Floats = self._vectors[0][:, :, 5]
        return found

    @cached_property
    def singular_values(self) -> Floats:
        """Those of `rows`, largest first, shape (N, 6)."""
        found: Floats = np.asarray(np.linalg.svd(self.rows, compute_uv=False), dtype=np.float64)
        return found

    @cached_property
    def _balanced(self) -> Floats:
        """The rows for twists in whose coordinates Σ |v_i|² is the sum of squares."""
        return np.concatenate([self.rows[:, :, :3] / np.sqrt(6), self.rows[:, :, 3:] @ self._turn], axis=2)

    @cached_property
    def _vectors(self) -> tuple[Floats, Floats, Floats]:
        left, sizes, right = np.linalg.svd(self._balanced)
        return left, sizes, right

    def turned(self, rotations: Floats, base: Floats) -> tuple[Floats, Floats]:
        """σ and the legs' lengths, (N,) and (N, 6), with the platform of the first pose turned about the centroid by
        rotations (N, 3, 3): at most by 1e-13 in σ² too small, never too large, and several times as fast.

        Seen from the platform its ends and their inertia stay; σ² is the least eigenvalue of the rows' products.
        """
        products, lengths = self._products(rotations, base)
        squares = np.linalg.eigvalsh(products)[:, 0]
        return np.sqrt(np.clip(squares - _OFF, 0.0, 1.0)), lengths

    def keeps(self, rotations: Floats, base: Floats, least: Callable[[Floats], Floats]) -> NDArray[np.bool_]:
        """Where the same σ is at least that which `least` gives for the legs' lengths: by elimination, many times as
        fast as eigenvalues.
        """
        products, lengths = self._products(rotations, base)
        m = np.ascontiguousarray(np.moveaxis(products, 0, 2))
        m[np.arange(6), np.arange(6)] -= least(lengths) ** 2 + _OFF
        positive = np.ones(len(lengths), dtype=bool)
        for k in range(6):
            positive &= m[k, k] > 0
            m[k + 1 :, k + 1 :] -= m[k + 1 :, k, None] * (m[k, k + 1 :] / np.where(positive, m[k, k], 1.0))
        return positive

    def _products(self, rotations: Floats, base: Floats) -> tuple[Floats, Floats]:
        """The products (N, 6, 6) of the balanced rows, seen from the platform, and the legs' lengths."""
        along = self.arms[0] + (self.centroid[0] - base) @ rotations
        lengths = np.linalg.norm(along, axis=2)
        u = along / lengths[:, :, None]
        (a, b, c), (x, y, z) = (self.arms[0] / self.radius).T, np.moveaxis(u, 2, 0)
        moments = np.stack([b * z - c * y, c * x - a * z, a * y - b * x], axis=2)
        rows = np.concatenate([u / np.sqrt(6), moments @ self._turn[0]], axis=2)
        return rows @ np.swapaxes(rows, 1, 2), lengths

    @property
    def condition_number(self) -> Floats:
        """Largest by smallest singular value of `rows`, infinite in singular poses."""
        s = self.singular_values
        with np.errstate(divide="ignore"):
            found: Floats = s[:, 0] / s[:, 5]
        return found

    @property
    def reach(self) -> Floats:
        """Distances of the legs' platform ends from their centroid, shape (6,); the same in every pose."""
        found: Floats = np.linalg.norm(self.arms[0], axis=1)
        return found


def on_one_line(ends: Floats) -> bool:
    """Whether platform points (6, 3) lie on one line or in one place, up to what their coordinates are rounded by: far
    away more.
    """
    blur = _ROUNDED * float(np.abs(ends).max())
    return bool(np.linalg.matrix_rank(ends - ends.mean(axis=0), blur) < 2)


_ROUNDED = 16 * float(np.finfo(np.float64).eps)
_RESOLVED = 1000 * _ROUNDED  # of the coordinates: a platform that is smaller or thinner is not known well enough
_THIN = 1e-6
_OFF = 1e-13  # more than rounding takes from squares of σ


def jacobian(base: Floats, ends: Floats) -> LegJacobians:
    """The Jacobian of legs from base points (6, 3) to platform points (N, 6, 3) that move as one body.

    The legs have lengths other than 0. Raises InputError where the platform's points are all on one line, but for the
    rounding of their coordinates: so far away that floats cannot tell them apart.
    """
    along = ends - base
    lengths = np.linalg.norm(along, axis=2)
    directions = along / lengths[:, :, None]
    centroid = ends.mean(axis=1)
    arms = ends - centroid[:, None, :]
    radius = float(np.sqrt((arms[0] ** 2).sum(axis=1).mean()))
    far_ends = np.abs(ends).max(axis=(1, 2))
    least = _RESOLVED * float(far_ends.max())
    if not radius > least:
        raise _too_far()
    scaled = arms / radius
    rows = np.concatenate([directions, np.cross(scaled, directions)], axis=2)
    # Σ |v_i|² = 6 |v|² + ωᵀ I ω: the centroid parts the two, and I has the same eigenvalues in every pose.
    inertia = (scaled**2).sum(axis=(1, 2))[:, None, None] * np.eye(3) - np.einsum("nki,nkj->nij", scaled, scaled)
    values, vectors = np.linalg.eigh(inertia)
    if values.min() < _THIN:  # I is rounded by more than that of a thin platform: its extents are not
        extents, vectors = np.linalg.svd(scaled, full_matrices=False)[1:]
        values = np.stack([(np.delete(extents, k, axis=1) ** 2).sum(axis=1) for k in range(3)], axis=1)
        vectors = np.swapaxes(vectors, 1, 2)
    spread = radius * float(np.sqrt(values.min()))
    if not spread > least:
        raise _too_far()
    turn = np.einsum("nij,nj,nkj->nik", vectors, 1 / np.sqrt(values), vectors)
    far = np.maximum(far_ends, np.abs(base).max())
    return LegJacobians(centroid, arms, radius, rows, lengths, directions, spread, far, far_ends, turn)


def _too_far() -> InputError:
    return InputError(
        "floats cannot tell the platform's joints apart here: they are in one place or on one line, up to rounding",
        hint="use poses closer to the robot, and an origin near it",
    )
