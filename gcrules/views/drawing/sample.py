"""A pleasing platform for legs without dimensions, so that there is something to look at."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import permutations
from math import atan2, cos, pi, sin

from gcrules.views.drawing.bsp import XYZ

__all__ = ["sample_coordinates"]

Legs = Sequence[tuple[str, str]]

_BASE_RADIUS = 1.0
_PLATFORM_RADIUS = 0.62
_HEIGHT = 1.05
_TWIST = 0.17
_TILT = (0.10, -0.16)
_UNEVEN = (0.0, 0.09, -0.07, 0.05, -0.1, 0.06)


def sample_coordinates(legs: Legs, base: Sequence[str], platform: Sequence[str]) -> dict[str, XYZ]:
    """Cartesian coordinates for the points of the legs, without unit; the same for the same arguments.

    Base points stand on a ring of radius about 1 in the plane z = 0, platform points on a smaller ring above it, turned
    and slightly tilted. Both follow an order that keeps legs short, and are a little uneven, so that the pose is
    generic. Points of neither body are spread over a ball.
    """
    used = list(dict.fromkeys(name for leg in legs for name in leg))
    low = [name for name in base if name in used]
    high = [name for name in platform if name in used and name not in low]
    rest = [name for name in used if name not in low and name not in high]
    found: dict[str, XYZ] = {}
    if low or high:
        lower, upper = _arranged(legs, low, high)
        for name, angle in lower.items():
            r = _BASE_RADIUS * (1 + 0.5 * _uneven(len(found)))
            found[name] = _rounded(r * cos(angle), r * sin(angle), 0.0)
        for name, angle in upper.items():
            r = _PLATFORM_RADIUS * (1 + 0.6 * _uneven(len(found) + 2))
            x, y = r * cos(angle), r * sin(angle)
            found[name] = _rounded(x, y, _HEIGHT + _TILT[0] * x + _TILT[1] * y)
    for i, name in enumerate(rest):
        found[name] = _on_ball(i, len(rest))
    return found


def _arranged(legs: Legs, low: list[str], high: list[str]) -> tuple[dict[str, float], dict[str, float]]:
    """Angles on both rings such that the ends of legs are near each other (as given for more than six points)."""
    best: tuple[float, dict[str, float], dict[str, float]] | None = None
    upper = dict(zip(high, _angles(len(high), _TWIST), strict=True))
    for order in _ring_orders(low):
        lower = dict(zip(order, _angles(len(order), 0.0), strict=True))
        for candidate in _ring_turns(legs, lower, high) if high else [upper]:
            angles = {**lower, **candidate}
            cost = sum(1 - cos(angles[a] - angles[b]) for a, b in legs if (a in lower) != (b in lower))
            if best is None or cost < best[0] - 1e-9:
                best = cost, lower, candidate
    return (best[1], best[2]) if best else ({}, upper)


def _ring_orders(names: list[str]) -> Iterator[tuple[str, ...]]:
    """Circular orders: the first name stays."""
    if not names:
        return iter(())
    if len(names) > 6:
        return iter([tuple(names)])
    return ((names[0], *rest) for rest in permutations(names[1:]))


def _ring_turns(legs: Legs, lower: dict[str, float], high: list[str]) -> Iterator[dict[str, float]]:
    """The platform points sorted by the direction of their neighbours, on a ring turned by each step and between."""

    def direction(name: str) -> float:
        near = [lower[a if b == name else b] for a, b in legs if name in (a, b) and (a in lower or b in lower)]
        x, y = sum(map(cos, near)), sum(map(sin, near))
        return round(atan2(y, x) % (2 * pi), 9) if abs(x) + abs(y) > 1e-9 else near[0] if near else 0.0

    order = sorted(high, key=direction)
    for turn in range(2 * len(order)):
        angles = _angles(len(order), _TWIST + pi * turn / len(order))
        yield dict(zip(order, angles, strict=True))


def _angles(count: int, start: float) -> list[float]:
    return [start + 2 * pi * i / count + _uneven(i) for i in range(count)]


def _uneven(i: int) -> float:
    return _UNEVEN[i % len(_UNEVEN)]


def _on_ball(i: int, count: int) -> XYZ:
    """Points of a spiral on the unit sphere."""
    z = 1 - 2 * (i + 0.5) / count
    r = (1 - z * z) ** 0.5
    angle = i * pi * (3 - 5**0.5)
    return _rounded(r * cos(angle), r * sin(angle), z)


def _rounded(x: float, y: float, z: float) -> XYZ:
    return round(x, 3), round(y, 3), round(z, 3)
