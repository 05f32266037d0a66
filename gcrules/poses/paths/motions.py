r"""Motions between two poses in floats, many at once: where the platform is, and how far away it gets."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass

__all__ = ["Motions"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Motions:
    """N motions as in `segment`: translations `t0` and `t1` (N, 3), quaternions `q0` and `q1` (N, 4), each pair of the
    same length and at no obtuse angle.
    """

    t0: Floats
    t1: Floats
    q0: Floats
    q1: Floats

    @cached_property
    def angles(self) -> Floats:
        """How far the platform turns, in radians, less than π."""
        p, q = (x / np.linalg.norm(x, axis=1, keepdims=True) for x in (self.q0, self.q1))
        return np.asarray(4 * np.arctan2(np.linalg.norm(p - q, axis=1), np.linalg.norm(p + q, axis=1)))

    @cached_property
    def distances(self) -> Floats:
        """How far the centre moves."""
        return np.asarray(np.linalg.norm(self.t1 - self.t0, axis=1))

    def turned(self, k: Any, s: Floats) -> Floats:
        """How far the platforms of the motions k have turned at s, in radians: tan(θ/2) = s sin(Θ/2) / (1 − s + s
        cos(Θ/2)), Θ the whole angle.
        """
        half = self.angles[k] / 2
        return np.asarray(2 * np.arctan2(s * np.sin(half), 1 - s + s * np.cos(half)))

    def arrays(self, k: Any, s: Floats) -> tuple[Floats, Floats]:
        """Translations (M, 3) and quaternions (M, 4) of the motions k at some s."""
        t0, q0 = self.t0[k], self.q0[k]
        return t0 + s[:, None] * (self.t1[k] - t0), q0 + s[:, None] * (self.q1[k] - q0)

    def spans(self, k: Any, cells: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        """The middles of parts (M, 2) of the motions k as `arrays`, and how far the centre is from there at most within
        them, and how far the platform is turned, in radians: (M,) each.
        """
        middle = cells.mean(axis=1)
        start, there, end = (self.turned(k, x) for x in (cells[:, 0], middle, cells[:, 1]))
        moved = self.distances[k] * (cells[:, 1] - cells[:, 0]) / 2
        return (*self.arrays(k, middle), moved, np.maximum(there - start, end - there))
