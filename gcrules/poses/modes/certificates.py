r"""That there is exactly one solution in a box: Krawczyk's operator for quadratic equations, many boxes at once.

The equations are yᵀ Q_k y = 0 and c·y = 1 in one real chart c for all solutions. With B an approximate inverse of the
derivatives J at y₀ the operator y ↦ y − B F(y) maps the polydisc |y − y₀| ≤ r (all complex y, largest component) into
itself and contracts it if

    β + (κ₀ + κ₁ r) r ≤ r,    β ≥ |B F(y₀)|,   κ₀ ≥ |1 − B J|,   κ₁ ≥ |B| · 2 Σ |Q|,

for second derivatives are constant: then it holds exactly one solution, and none other is in the larger polydisc where
κ₀ + κ₁ R < 1. If y₀ and the equations are real the solution is, being the only one; if an imaginary part of y₀ exceeds
r it is not. Solutions whose polydiscs do not meet differ. All bounds are floats with more room left than they round
off; what the coefficients are known to is part of them. Source: Neumaier, Interval methods for systems of equations,
ch. 5, for Krawczyk's operator; the bounds are derived here.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.conditions import Complexes
from gcrules.poses.modes.tracking import jacobians, residuals

__all__ = ["Boxes", "boxes", "chart_for"]

Truths = NDArray[np.bool_]

_CHARTS = 24
_REAL = 1e-6  # imaginary parts, in parts of the largest component, below which a real solution is tried
_EPSILON = float(np.finfo(float).eps)
_SUMS = 64 * _EPSILON  # room for rounding in sums of 64 terms, of the sum of their sizes
_ROOM = 1 + 1e-9
_STEPS = 4  # of Newton's method
_BLUR = 1e-10  # of y where it has no box


@dataclass(frozen=True, eq=False)
class Boxes:
    """Around each of N solutions y (N, 8) in the chart a box: it holds exactly one within `radius` (N,), infinite where
    that is not proved, and no other one within `alone` (N,). `real` and `unreal` (N,) are proved; `apart` (N,) tells
    that a box meets no other one.
    """

    y: Complexes
    chart: Floats
    radius: Floats
    alone: Floats
    real: Truths
    unreal: Truths
    apart: Truths

    @property
    def proved(self) -> Truths:
        """Which of them hold exactly one solution that is in no other box, known to be real or not."""
        return np.asarray(np.isfinite(self.radius) & self.apart & (self.real | self.unreal))

    @property
    def finite(self) -> Truths:
        """Where h = a·a is not 0 in the box, nor beside y by rounding where there is no box: what is a motion."""
        a = self.y[:, :4]
        size = np.linalg.norm(a, axis=1)
        r = 2 * np.where(np.isfinite(self.radius), self.radius, _BLUR * np.linalg.norm(self.y, axis=1))
        return np.asarray(np.abs((a * a).sum(axis=1)) > r * (2 * size + r))

    def bounds(self, k: int) -> tuple[float, float]:
        """How far the motion of solution k, a real one, may be off: in its turn (rad), and in its shift in sizes."""
        r, y = 2 * float(self.radius[k]), self.y[k].real  # four components off by a radius each
        a, b = float(np.linalg.norm(y[:4])), float(np.linalg.norm(y[4:]))
        if not r < a / 2:
            return np.inf, np.inf
        return 2 * float(np.arcsin(r / a)) * _ROOM, 2 * r / (a - r) * (1 + b / a) * _ROOM


def chart_for(x: Complexes) -> Floats:
    """A real chart (8,) in which none of the solutions (N, 8) is far away."""
    rng = np.random.default_rng(8)
    tried = rng.normal(size=(_CHARTS, 8))
    size = np.linalg.norm(x, axis=1)
    least = (np.abs(tried @ x.T) / size).min(axis=1, initial=np.inf) / np.linalg.norm(tried, axis=1)
    best = tried[int(np.argmax(least))]
    return np.asarray(best / np.linalg.norm(best))


def boxes(system: Floats, known: Floats, x: Complexes) -> Boxes:
    """Boxes around solutions x (N, 8) of real quadrics (7, 8, 8), with coefficients `known` up to these numbers."""
    chart = chart_for(x)
    whole, along = system.astype(complex), chart.astype(complex)
    y = x / (x @ chart)[:, None]
    near = np.abs(y.imag).max(axis=1, initial=0.0) <= _REAL * np.abs(y).max(axis=1, initial=0.0)
    y = np.where(near[:, None], y.real, y).astype(complex)
    for _ in range(_STEPS):
        y = y - (np.linalg.inv(jacobians(whole, y, along)) @ _values(whole, along, y)[..., None])[..., 0]
    y = np.where(near[:, None], y.real, y).astype(complex)
    off = known + _SUMS * np.abs(system)
    sizes = np.abs(y)
    jacobian = jacobians(whole, y, along)
    back = np.linalg.inv(jacobian)
    back = np.where(near[:, None, None], back.real, back)
    weights = np.abs(back)
    doubt = np.einsum("nij,ki,kj->kn", off, sizes, sizes)
    doubt = np.concatenate([doubt, _SUMS * (sizes @ np.abs(chart))[:, None] + _EPSILON], axis=1)
    beta = (weights @ (np.abs(_values(whole, along, y)) + doubt)[..., None])[..., 0].max(axis=1)
    slope_doubt = 2 * np.einsum("nij,kj->kni", off, sizes)
    slope_doubt = np.concatenate([slope_doubt, np.zeros((len(y), 1, 8))], axis=1)
    rest = np.abs(np.eye(8) - back @ jacobian) + weights @ (slope_doubt + _SUMS * np.abs(jacobian))
    kappa0 = rest.sum(axis=2).max(axis=1)
    bend = np.append(2 * (np.abs(system) + off).sum(axis=(1, 2)), 0.0)
    kappa1 = (weights @ bend).max(axis=1)
    beta, kappa0, kappa1 = beta * _ROOM, kappa0 * _ROOM, kappa1 * _ROOM
    left = (1 - kappa0) ** 2 - 4 * kappa1 * beta
    sound = (kappa0 < 1) & (left > 0)
    radius = 2 * beta / (1 - kappa0 + np.sqrt(np.where(sound, left, 1.0))) * _ROOM
    sound &= (beta + (kappa0 + kappa1 * radius) * radius <= radius) & (kappa0 + kappa1 * radius < 1)
    radius = np.where(sound, radius, np.inf)
    alone = np.where(sound, (1 - kappa0) / kappa1 / _ROOM, 0.0)
    distance = np.abs(y[:, None] - y[None]).max(axis=2) + np.where(np.eye(len(y)), np.inf, 0.0)
    other = np.where(sound, radius, 0.0)
    apart = (distance > (radius[:, None] + other[None]) * _ROOM).all(axis=1)
    unreal = sound & ~near & (np.abs(y.imag).max(axis=1, initial=0.0) > radius)
    real = sound & near & (np.linalg.norm(y[:, :4], axis=1) > 4 * np.where(sound, radius, 0.0))
    return Boxes(y, chart, radius, alone, real, unreal, apart)


def _values(system: Complexes, chart: Complexes, y: Complexes) -> Complexes:
    return np.concatenate([residuals(system, y), (y @ chart - 1)[:, None]], axis=1)
