r"""The zero of an exact cubic that is nearest to 0, certified: the nearest singular pose at a fixed orientation.

The zero is found from rays in all directions and polished by Newton's method on the Lagrange equations; a search of the
ball (`certify`) then proves that there is none nearer. If the search meets one, it starts again from there.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.nearest.certify import BallSearch, search
from gcrules.poses.nearest.taylor import Taylor, taylor
from gcrules.poses.numbers.cubic import Cubic
from gcrules.poses.numbers.quadric import one_sign, split, touching

__all__ = ["FAR", "NearestZero", "fibonacci", "nearest_zero"]

Floats = NDArray[np.float64]

FAR = 1000
"""How far is searched where no zero is found, in units of the size that is given."""

_RAYS = 4000
_STARTS = 16
_AGAIN = 8
_BESIDE = Fraction(1, 10**12)
_SHORT = 10**4  # denominators of coordinates that are tried as exact ones


@dataclass(frozen=True)
class NearestZero:
    """The nearest zero of a polynomial f in t, its `distance` from 0, and what is proved about it.

    No zero is nearer than `lower`. `upper` is a distance within which there is proved to be one (f changes its sign, or
    is exactly 0), None where f seems to touch zero only. `point` is None where no zero was found; `never` says that
    there is proved to be none at any distance. `residual` is |f(point) / f(0)|, from exact arithmetic.
    """

    point: tuple[Fraction, Fraction, Fraction] | None
    distance: float
    lower: float
    upper: float | None
    residual: float = 0.0
    never: bool = False

    @property
    def certified(self) -> bool:
        """Whether the distance is proved to a relative accuracy of 2e-6 (mostly it is 1e-9)."""
        return self.never or (self.upper is not None and self.lower >= self.upper * (1 - 2e-6))


def nearest_zero(f: Cubic, size: float) -> NearestZero:
    """The zero of f nearest to 0; `size` is the length in which distances are counted (of the order of the robot)."""
    found = _nearest(f, size)
    if found.certified:
        return found
    factors = split(f)  # multiple zeros and planes through the zero set of another factor hinder the proof
    if sum(g.degree for g in factors) == f.degree and len(factors) == 1:
        return found
    parts = [_nearest(g, size) for g in factors]
    best = min(parts, key=lambda z: z.distance)
    uppers = [z.upper for z in parts if z.upper is not None]
    return replace(
        best,
        lower=min(z.lower for z in parts),
        upper=min(uppers, default=None),
        never=all(z.never for z in parts),
    )


def _nearest(f: Cubic, size: float) -> NearestZero:
    zero = Fraction(0)
    if not f(zero, zero, zero):
        return NearestZero((zero, zero, zero), 0.0, 0.0, 0.0)
    if one_sign(f):
        point = touching(f)
        if point is None:
            return NearestZero(None, np.inf, np.inf, None, never=True)
        distance = math.sqrt(sum(c * c for c in point))
        return NearestZero(point, distance, distance, distance)
    unit = Fraction(size)
    g = taylor(f, unit)
    points = _candidates(g)
    if not len(points):
        unit *= FAR
        far = search(taylor(f, unit), ())
        if far.better is None:
            return NearestZero(None, np.inf, far.free * float(unit), None)
        points = _candidates(taylor(f, unit), far.better)
    found = BallSearch(0.0)
    for _ in range(_AGAIN):
        checkpoint()
        nearest = Fraction(float(np.linalg.norm(points, axis=1).min()))
        unit *= nearest
        points = points / float(nearest)
        g = taylor(f, unit)
        points = np.concatenate([points, _candidates(g)])
        if np.linalg.norm(points, axis=1).min() < 1 - 1e-10:
            continue  # the finer scale has shown a nearer zero
        found = search(g, list(points))
        if found.better is None:
            break
        points = np.concatenate([points, _candidates(g, found.better)])
    best = points[int(np.argmin(np.linalg.norm(points, axis=1)))]
    return _verified(f, unit, best, found.free)


def _verified(f: Cubic, unit: Fraction, best: Floats, free: float) -> NearestZero:
    """The exact sign of f at the point and just beyond says whether a zero lies on the way there."""
    zero = Fraction(0)
    x, y, z = _simple(f, [Fraction(float(c)) * unit for c in best])
    start, value = f(zero, zero, zero), f(x, y, z)
    distance = math.sqrt(x * x + y * y + z * z)
    more = 1 + _BESIDE
    crossed = value * start <= 0 or f(x * more, y * more, z * more) * start <= 0
    upper = distance * float(1 + 2 * _BESIDE) if crossed else None
    lower = min(free * float(unit), distance)
    return NearestZero((x, y, z), distance, lower, upper, abs(float(value / start)))


def _simple(f: Cubic, point: list[Fraction]) -> tuple[Fraction, Fraction, Fraction]:
    """A point with short coordinates at which f is exactly zero, if there is one beside a zero in floats."""
    x, y, z = (c.limit_denominator(_SHORT) for c in point)
    off, size = (sum(float(c) ** 2 for c in v) for v in ((x - point[0], y - point[1], z - point[2]), point))
    if off <= 1e-18 * size and not f(x, y, z):
        return x, y, z
    x, y, z = point
    return x, y, z


def _candidates(f: Taylor, start: Floats | None = None) -> Floats:
    """Zeros of f nearest to 0 among their neighbours, shape (N, 3), from rays (or from one point at which f ≤ 0)."""
    if start is None:
        directions = fibonacci(_RAYS)
        distances = f.on_rays(directions)
        chosen: list[int] = []
        for i in np.argsort(distances):
            if len(chosen) == _STARTS or not np.isfinite(distances[i]):
                break
            if not chosen or (directions[chosen] @ directions[i]).max() < 0.95:
                chosen.append(int(i))
        starts = directions[chosen] * distances[chosen, None]
    else:
        n = start / np.linalg.norm(start)
        starts = n[None, :] * f.on_rays(n[None, :])[:, None]
    return _polished(f, starts)


def _polished(f: Taylor, starts: Floats) -> Floats:
    """Newton's method for f = 0, ∇f + μ x = 0 from zeros (N, 3) at once; the zeros themselves where that leads away."""
    x, slope = starts.copy(), f.slope(starts)
    mu = -(slope * x).sum(axis=1) / (x * x).sum(axis=1)
    going = np.arange(len(x))
    for _ in range(40):
        checkpoint()
        at = x[going]
        slope = f.slope(at)
        system = np.zeros((len(at), 4, 4))
        system[:, :3, :3] = f.curvature(at) + mu[going, None, None] * np.eye(3)
        system[:, :3, 3], system[:, 3, :3] = at, slope
        aim = -np.concatenate([slope + mu[going, None] * at, f.value(at)[:, None]], axis=1)
        try:
            step = np.linalg.solve(system, aim[:, :, None])[:, :, 0]
        except np.linalg.LinAlgError:  # one of them has no answer
            return starts if len(starts) == 1 else np.concatenate([_polished(f, start[None]) for start in starts])
        length, size = np.linalg.norm(step[:, :3], axis=1), np.linalg.norm(at, axis=1)
        x[going] += step[:, :3] * np.minimum(1.0, 0.3 * size / np.maximum(length, 1e-300))[:, None]
        mu[going] += step[:, 3]
        going = going[~(length <= 1e-15 * np.linalg.norm(x[going], axis=1))]
        if not len(going):
            break
    size = np.linalg.norm(x, axis=1)
    good = np.isfinite(x).all(axis=1) & (np.abs(f.value(x)) <= 1e-9) & (size > 0)
    good &= size <= np.linalg.norm(starts, axis=1) * (1 + 1e-9)
    return np.where(good[:, None], x, starts)


def fibonacci(number: int) -> Floats:
    """Unit vectors spread evenly over the sphere, shape (number, 3)."""
    i = np.arange(number) + 0.5
    z = 1 - 2 * i / number
    around = np.pi * (1 + 5**0.5) * i
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(around), r * np.sin(around), z], axis=1)
