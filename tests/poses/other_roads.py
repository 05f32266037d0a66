"""Direct kinematics by roads that share nothing with the engine's: circles that meet, spheres, a sextic, lengths."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["circle_points", "lengths_of", "planar_roots", "sphere_points", "three_on_circles"]

Floats = NDArray[np.float64]

Circle = tuple[Floats, Floats, Floats]
"""Centre, and two perpendicular radii."""


def circle_points(a: Floats, b: Floats, p: Floats) -> Circle:
    """The circle on which a point at p turns about the line a b."""
    along = (b - a) / np.linalg.norm(b - a)
    centre = a + along * ((p - a) @ along)
    return centre, p - centre, np.cross(along, p - centre)


def _at(c: Circle, angle: Any) -> Any:
    centre, u, v = c
    return centre + np.multiply.outer(np.cos(angle), u) + np.multiply.outer(np.sin(angle), v)


def _meeting(c: Circle, p: Floats, distance: float) -> Floats:
    """Points (2, N, 3) of a circle at a distance from points (N, 3); nan where there are none."""
    centre, u, v = c
    arm = p - centre
    a, b = arm @ u, arm @ v
    rest = ((arm * arm).sum(axis=1) + u @ u - distance**2) / 2
    size, middle = np.hypot(a, b), np.arctan2(b, a)
    with np.errstate(invalid="ignore"):
        half = np.arccos(rest / size)
    return np.stack([_at(c, middle + half), _at(c, middle - half)])


def three_on_circles(circles: Sequence[Circle], sides: Sequence[float], samples: int = 20_000) -> list[Floats]:
    """All triples of points, one on each of three circles, at distances 12, 23, 31: the first goes round its circle,
    the others follow in two ways each, and the third distance is bisected where it changes over the right one.
    """

    def gap(angle: Floats, way: tuple[int, int]) -> tuple[Floats, Floats]:
        first = _at(circles[0], angle)
        second = _meeting(circles[1], first, sides[0])[way[0]]
        third = _meeting(circles[2], first, sides[2])[way[1]]
        return np.linalg.norm(second - third, axis=1) - sides[1], np.stack([first, second, third], axis=1)

    found: list[Floats] = []
    angles = np.linspace(0, 2 * np.pi, samples + 1) + 1e-4
    for way in ((0, 0), (0, 1), (1, 0), (1, 1)):
        values, _ = gap(angles, way)
        for k in np.flatnonzero(values[:-1] * values[1:] < 0):
            found.append(_bisected(lambda x, w=way: gap(x, w), float(angles[k]), float(angles[k + 1])))
    return found


def _bisected(gap: Callable[[Floats], tuple[Floats, Floats]], a: float, b: float) -> Floats:
    left = float(gap(np.array([a]))[0][0])
    for _ in range(60):
        middle = (a + b) / 2
        value = float(gap(np.array([middle]))[0][0])
        if value * left > 0:
            a = middle
        else:
            b = middle
    return np.asarray(gap(np.array([(a + b) / 2]))[1][0])


def sphere_points(centres: Floats, radii: Floats) -> list[Floats]:
    """The two points in which three spheres meet."""
    first = centres[0]
    rows = 2 * (centres[1:] - first)
    right = (centres[1:] ** 2).sum(axis=1) - first @ first - radii[1:] ** 2 + radii[0] ** 2
    line = np.cross(*rows)
    at = np.linalg.lstsq(rows, right, rcond=None)[0]
    at = at + line * ((first - at) @ line) / (line @ line)
    part = math.sqrt((radii[0] ** 2 - (at - first) @ (at - first)) / (line @ line))
    return [at + part * line, at - part * line]


def planar_roots(base: Floats, body: Floats, lengths: Floats) -> list[complex]:
    """The six values of z = exp(iφ), φ the turn of a planar platform with points (3, 2) on legs from points (3, 2):
    differences of the conditions are linear in the shift, which leaves one polynomial in z of degree 6.
    """

    def value(z: complex) -> complex:
        c, s = (z + 1 / z) / 2, (z - 1 / z) / 2j
        turned = body @ np.array([[c, s], [-s, c]])
        arms = turned - base
        right = lengths**2 - (arms * arms).sum(axis=1)
        rows = 2 * (arms[1:] - arms[0])
        det = rows[0, 0] * rows[1, 1] - rows[0, 1] * rows[1, 0]
        d = right[1:] - right[0]
        shift = np.array([d[0] * rows[1, 1] - d[1] * rows[0, 1], rows[0, 0] * d[1] - rows[1, 0] * d[0]])
        return complex(shift @ shift + 2 * det * (arms[0] @ shift) - det**2 * right[0])

    circle = np.exp(2j * np.pi * np.arange(7) / 7)
    values = np.array([value(complex(z)) * z**3 for z in circle])
    return [complex(z) for z in np.roots((np.fft.fft(values) / 7)[::-1])]


def lengths_of(
    base: Floats, body: Floats, centre: Floats, translation: Sequence[Any], quaternion: Sequence[Any]
) -> Floats:
    """The distances of points (N, 3) of the base and points (N, 3) of the body after a motion about a centre."""
    w, *v = (float(c) for c in quaternion)
    axis = np.array(v)
    arms = body - centre
    turned = (w * w - axis @ axis) * arms + 2 * np.outer(arms @ axis, axis) + 2 * w * np.cross(axis, arms)
    moved = turned / (w * w + axis @ axis) + centre + np.array([float(c) for c in translation])
    return np.asarray(np.linalg.norm(moved - base, axis=1))
