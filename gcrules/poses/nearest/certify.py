r"""A proof that a cubic has no zero in a ball: branch and bound, with a convexity argument where the ball touches.

f(0) = 1. Cubes in which Taylor's formula leaves no room for a zero in the ball are dropped, the others halved. Alone
this never ends near a nearest zero x*, where the zero set touches the ball of radius R = |x*|. There, with n = x*/R,
μ = −∇f(x*)·x*/R² and m(x) = ½ μ (1 + k (x·n/R − 1)), the cubic g = f − (R² − |x|²) m has g(x*) = 0 and ∇g(x*) = 0. Its
second derivatives are affine in x, so g is convex in a box if they are positive definite at the box's corners; then
g ≥ 0 there, and f > 0 at the points of the box with |x| < R, where m > 0. Derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.nearest.taylor import Taylor

__all__ = ["GAPS", "MAX_BOXES", "BallSearch", "search"]

Floats = NDArray[np.float64]

GAPS = (1e-9, 1e-6)
"""The ball that is searched has the radius (1 − gap) times the distance of the nearest zero that is known."""

MAX_BOXES = 200_000

_SAME = 1e-9  # distance of points that are one, found twice

_CORNERS = np.array(list(product((-1.0, 1.0), repeat=3)))
_WIDTHS = (0.7, 0.5, 0.35, 0.25, 0.18, 0.12, 0.08, 0.05, 0.03, 0.015, 0.007, 0.003)  # across n, in units of R
_BENDS = (0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)  # k


@dataclass(frozen=True, eq=False)
class BallSearch:
    """No zero is nearer than `free` (in units of the ball's radius); `better` is a point at which f < 0, if one was
    met nearer than that radius.
    """

    free: float
    better: Floats | None = None


@dataclass(frozen=True, eq=False)
class _Box:
    """Where f is proved positive inside the ball: n·x ≥ floor, and at most `across` from 0 along the other two axes."""

    axes: Floats  # n first
    floor: float
    across: float

    def holds(self, cubes: Floats, half: float) -> NDArray[np.bool_]:
        """Which cubes lie inside, as far as they lie in the ball (where n·x is at most the height of the box)."""
        reach = half * np.abs(self.axes).sum(axis=1)
        along = cubes @ self.axes.T
        deep = along[:, 0] - reach[0] >= self.floor
        found: NDArray[np.bool_] = deep & (np.abs(along[:, 1:]) + reach[1:] <= self.across).all(axis=1)
        return found


def search(f: Taylor, touching: Sequence[Floats], limit: int = MAX_BOXES) -> BallSearch:
    """Search the ball of radius 1 about 0, but for one of the `GAPS`, for zeros of f, f(0) = 1.

    `touching` are points at which f is zero and the distance from 0 is least nearby, of length about 1 or more. At
    most `limit` cubes are looked at for each gap; if that does not suffice, `free` is what has been proved by then.
    """
    different = [x for i, x in enumerate(touching) if all(np.abs(x - y).max() > _SAME for y in touching[:i])]
    boxes = [box for x in different if (box := _convex(f, x))]
    best = BallSearch(0.0)
    for gap in GAPS:
        found = _search(f, boxes, 1 - gap, limit)
        best = max(best, found, key=lambda s: s.free)
        if found.better is not None or found.free == 1 - gap:
            return found
    return best


def _search(f: Taylor, boxes: Sequence[_Box], radius: float, limit: int) -> BallSearch:
    cubes, half, seen = np.zeros((1, 3)), 1.0, 0
    while len(cubes):
        checkpoint()
        nearest = np.linalg.norm(np.maximum(np.abs(cubes) - half, 0.0), axis=1)
        cubes = cubes[nearest < radius]
        values = f.value(cubes)
        wrong = (values < -f.rounding) & (np.linalg.norm(cubes, axis=1) < radius)
        if wrong.any():
            return BallSearch(0.0, cubes[int(np.argmax(wrong))])
        cubes = cubes[~_free(f, cubes, half, radius)]
        for box in boxes:
            cubes = cubes[~box.holds(cubes, half)]
        seen += len(cubes)
        if seen + 8 * len(cubes) > limit or half < 1e-13:
            nearest = np.linalg.norm(np.maximum(np.abs(cubes) - half, 0.0), axis=1)
            return BallSearch(min(radius, float(nearest.min(initial=radius))))
        half /= 2
        cubes = (cubes[:, None, :] + half * _CORNERS).reshape(-1, 3)
    return BallSearch(radius)


def _free(f: Taylor, cubes: Floats, half: float, radius: float) -> NDArray[np.bool_]:
    """Where h(x) = f(x) − ½ μ (radius² − |x|²) is positive all over a cube; in the ball f ≥ h for any μ ≥ 0.

    The μ that takes the radial part out of the slope tells the cubes along the sphere from those that f touches.
    """
    squares = (cubes**2).sum(axis=1)
    slope = f.slope(cubes)
    mu = np.maximum(-(slope * cubes).sum(axis=1) / np.maximum(squares, 1e-300), 0.0)
    mu[squares < half * half] = 0.0  # about 0 itself a multiple of x says nothing
    found = np.zeros(len(cubes), dtype=bool)
    for m in (np.zeros_like(mu), mu):
        value = f.value(cubes) - m / 2 * (radius**2 - squares)
        first = np.abs(slope + m[:, None] * cubes).sum(axis=1)
        second = np.abs(f.curvature(cubes) + m[:, None, None] * np.eye(3)).sum(axis=(1, 2))
        room = half * (first + half * (second / 2 + half * np.abs(f.third).sum() / 6))
        found |= value > room * (1 + 1e-12) + f.rounding * (1 + m)
    return found


def _convex(f: Taylor, point: Floats) -> _Box | None:
    """The largest box at a touching point that the argument proves, None if there is none."""
    far = float(np.linalg.norm(point))
    n = point / far
    slope = f.slope(point)
    mu = -float(slope @ n) / far
    axes = np.linalg.svd(n[None, :])[2]  # the first row is ±n, the others are orthogonal to it
    axes[0] = n
    residue = abs(float(f.value(point))) + float(np.linalg.norm(slope + mu * point)) * 2 * far + f.rounding
    best: tuple[float, _Box] | None = None
    for bend in _BENDS:
        for across in _WIDTHS:
            deep = min(0.9 / bend if bend else 1.0, 4 * across)
            least = mu / 2 * (1 - bend * deep)  # of m in the box
            value = min(across, np.sqrt(deep / 1.5))
            if least * far * GAPS[0] <= residue or (best and value <= best[0]):
                continue
            corners = point + (_CORNERS * [deep / 2, across, across] - [deep / 2, 0, 0]) * far @ axes
            m = mu / 2 * (1 + bend * (corners @ n / far - 1))
            grad = mu * bend * n / (2 * far)
            mixed = np.einsum("ci,j->cij", corners, grad)
            second = f.curvature(corners) + 2 * m[:, None, None] * np.eye(3) + 2 * (mixed + mixed.transpose(0, 2, 1))
            if np.linalg.eigvalsh(second).min() > f.rounding:
                best = value, _Box(axes, far * (1 - deep), far * across)
    return best[1] if best else None
