r"""What the measure σ guarantees: how far the platform can go before it can be singular, and what noise does to σ.

Proofs stand in docs/pose.md, derived here. In a singular pose some twist moves every joint b_i across its leg: w′_i·v_i
= 0, all seen from the platform: v_i lies in the plane across w′_i, where w_i has a part of the length sin θ_i, θ_i the
angle between the two. So Σ (w_i·v_i)² ≤ max sin² θ_i Σ |v_i|², that is σ ≤ sin θ_i for some leg. The rest is how fast
legs can turn.
"""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.screws.margin import LegJacobians

__all__ = ["DIGITS", "ROUNDING", "Guarantees", "Measured", "guarantees", "noise", "sigma_for"]

Floats = NDArray[np.float64]

ROUNDING = 1e-12
"""Accuracy of coordinates, in units of the robot's size, where none is stated: that of the arithmetic alone."""

DIGITS = 4 * float(np.finfo(np.float64).eps)
"""Accuracy of coordinates as floats, in units of the largest of them."""

_ROUNDING = 1e-13  # of σ, in floats
_LESS = 1 - 1e-12  # rounding of the bounds themselves, to the safe side
_SAFE = 1e-12
_NEWTON = 8  # steps, each of which doubles the digits


@dataclass(frozen=True, eq=False)
class Guarantees:
    """For N poses, shape (N,) each: no singular pose before some leg has turned by `turn` (rad) relative to the
    platform, none within the translation `shift` at the same orientation, none within the rotation `rotation` (rad)
    about the centroid of the legs' platform ends, none within the distance `combined`.

    `combined` is a length: the root of |d|² + (ρφ)², d the shift of that centroid, φ the angle of the rotation and ρ
    the `radius` of the Jacobian.
    """

    sigma: Floats
    turn: Floats
    shift: Floats
    rotation: Floats
    combined: Floats

    def at(self, n: int) -> dict[str, Any]:
        """The numbers of one pose."""
        return {name: float(getattr(self, name)[n]) for name in ("sigma", "turn", "shift", "rotation", "combined")}


class Measured(Protocol):
    """What guarantees are computed from, as in `LegJacobians`."""

    @property
    def sigma(self) -> Floats: ...

    @property
    def lengths(self) -> Floats: ...

    @property
    def reach(self) -> Floats: ...

    @property
    def radius(self) -> float: ...


def guarantees(j: Measured) -> Guarantees:
    """The guarantees of σ.

    A leg of length l whose end moves by x < l turns by at most asin(x/l); turning the platform by φ adds φ. asin is
    convex, so asin(x/l) ≤ κ x/l up to the angle θ, κ = θ/sin θ, and x ≤ |d| + rφ for an end at the distance r.
    """
    sigma = np.maximum(j.sigma - _ROUNDING, 0.0)
    turn = np.arcsin(np.minimum(sigma, 1.0))
    kappa = 1 / np.sinc(turn / np.pi)[:, None]
    per_shift = kappa / j.lengths  # turn of each leg for each unit of translation
    per_angle = 1 + per_shift * j.reach  # and for each radian of rotation
    rate = np.sqrt(per_shift**2 + (per_angle / j.radius) ** 2)
    return Guarantees(
        sigma=j.sigma,
        turn=turn * _LESS,
        shift=j.lengths.min(axis=1) * np.sin(turn) * _LESS,
        rotation=turn / per_angle.max(axis=1) * _LESS,
        combined=turn / rate.max(axis=1) * _LESS,
    )


def sigma_for(rotation: float, lengths: Floats, reach: Floats) -> Floats:
    """From which σ on more than this `rotation` is guaranteed, by the legs' lengths (N, 6); 2 where by none.

    The turn t of the legs has to be so large that 1/t + (1/sin t) max r/l is less than 1/φ. Newton's method comes to
    it from below.
    """
    most, limit = (reach / lengths).max(axis=1), _LESS / rotation
    t = np.minimum((1 + most) / limit, np.pi / 2)
    for _ in range(_NEWTON):
        s = np.sin(t)
        t = np.minimum(t + (1 / t + most / s - limit) / (1 / t**2 + most * np.cos(t) / s**2), np.pi / 2)
    return np.where(t < np.pi / 2, np.sin(t) * (1 + _SAFE) + _ROUNDING, 2.0)


def noise(j: LegJacobians, accuracy: float) -> Floats:
    """How much σ can change when each joint is elsewhere by up to `accuracy` (a length) or by the rounding of its
    coordinates, shape (N,); at most 1.

    A leg turns by at most asin(2ε/l). The velocities of a twist with angular velocity ω change by |ω|ε each, that is
    by at most η = √6 ε / spread relative to the root of Σ |v_i|², which is at least |ω| spread.
    """
    leg = np.minimum(2 * np.maximum(accuracy, DIGITS * j.far) / j.lengths.min(axis=1), 1.0)
    turned = 2 * np.sin(np.arcsin(leg) / 2)
    eta = np.minimum(np.sqrt(6) * np.maximum(accuracy, DIGITS * j.far_ends) / j.spread, 0.5)
    found: Floats = np.where((leg >= 1) | (eta >= 0.5), 1.0, np.minimum((turned + 2 * eta) / (1 - eta), 1.0))
    return found
