r"""The superbracket of a robot in every pose at once: an exact polynomial in a translation and a quaternion.

With p the place of the centre, β_i the platform's arms, a_i the joints of the base, d_i = p − a_i and the rotation
R = N(e)/n, n = |e|², the rows of the superbracket with moments about p are (d_i + Rβ_i, Rβ_i × d_i). R keeps triple
products and R u × R v = R (u × v), so in Laplace's expansion by three and three columns

    det(d + Rβ) of three legs i, j, k = [d d d] + [β β β] + Σ Rβ_i·(d_j × d_k) + Σ d_i·R(β_j × β_k),
    det(Rβ × d) of the others l, m, o
        = (d_l·R(β_o × β_l)) (Rβ_m·(d_m × d_o)) − (Rβ_l·(d_l × d_o)) (d_m·R(β_o × β_m)),

sums over the cyclic orders of i, j, k. They have degree 1 and 2 in R. Hence n³ times the superbracket is a form of
degree 6 in e, of degree ≤ 3 in the translation (`gcrules.poses.numbers.cubic`); it is expanded in e at twenty
translations and interpolated. Derived here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from math import lcm
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import cross, permutation_sign
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.cubic import EXPONENTS, interpolated
from gcrules.screws.rotations import unscaled

__all__ = ["Terms", "expansion"]

Terms = Mapping[tuple[int, ...], Fraction]
"""Coefficients by the exponents of x, y, z and e0, e1, e2, e3."""

Whole = tuple[int, int, int]


@lru_cache(maxsize=4)  # slices of one robot ask for the same expansion
def expansion(rig: MovingPlatform) -> Terms:
    """n³ times the superbracket of the legs as typed, n = e0² + e1² + e2² + e3²: exact, without zeros.

    Coordinates are those of the rig, translations in its unit.
    """
    unit = lcm(*(c.denominator for p in (*rig.points.values(), rig.centre) for c in p))
    base = [_whole(rig.points[a], unit) for a, _ in rig.legs]
    arms = [_sub(_whole(rig.points[b], unit), _whole(rig.centre, unit)) for _, b in rig.legs]
    centre = _whole(rig.centre, unit)
    norm, turned = _turns(arms)
    values: dict[tuple[int, ...], dict[Any, int]] = {}
    for shift in EXPONENTS:
        checkpoint()
        place = (centre[0] + shift[0], centre[1] + shift[1], centre[2] + shift[2])
        form = _form([_sub(place, a) for a in base], arms, norm, turned)
        for powers, c in form.terms():
            checkpoint()
            values.setdefault(tuple(powers), dict.fromkeys(EXPONENTS, 0))[shift] = int(c)
    scale = Fraction(-rig.structure.orientation, unit**9)
    found: dict[tuple[int, ...], Fraction] = {}
    for powers, at in values.items():
        checkpoint()
        cubic = interpolated({e: Fraction(c) for e, c in at.items()}, Fraction(1))
        for e, c in cubic.coefficients.items():
            found[(*e, *powers)] = c * scale * unit ** sum(e)
    return FrozenMap(found)


def _whole(p: Sequence[Fraction], unit: int) -> Whole:
    x, y, z = (int(c * unit) for c in p)
    return x, y, z


def _sub(u: Whole, v: Whole) -> Whole:
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


def _dot(u: Sequence[Any], v: Sequence[Any]) -> Any:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def _turns(arms: Sequence[Whole]) -> tuple[Any, dict[tuple[int, ...], Any]]:
    """n, and N β_i by (i,) and N (β_i × β_j) by (i, j), as vectors of quadratic forms in e."""
    from sympy import ZZ
    from sympy.polys.rings import ring

    _, w, x, y, z = ring("e0,e1,e2,e3", ZZ)
    rows = unscaled((w, x, y, z))
    vectors: dict[tuple[int, ...], Whole] = {(i,): b for i, b in enumerate(arms)}
    vectors |= {(i, j): cross(arms[i], arms[j]) for i in range(6) for j in range(6) if i != j}
    return w**2 + x**2 + y**2 + z**2, {key: tuple(_dot(row, v) for row in rows) for key, v in vectors.items()}


def _form(d: Sequence[Whole], arms: Sequence[Whole], norm: Any, turned: Mapping[tuple[int, ...], Any]) -> Any:
    """n³ times the determinant of the rows (d + Rβ, Rβ × d), a form of degree 6 in e."""
    pairs = {(i, j): cross(d[i], d[j]) for i in range(6) for j in range(6) if i != j}
    mixed = {(i, j, k): _dot(turned[i,], pairs[j, k]) for i in range(6) for j, k in combinations(range(6), 2)}
    arm = {(i, j): _dot(d[i], turned[j, i]) for i in range(6) for j in range(6) if i != j}  # d_i · R(β_j × β_i)
    total = 0 * norm
    for i, j, k in combinations(range(6), 3):
        checkpoint()
        rest = tuple(r for r in range(6) if r not in (i, j, k))
        first = norm * (_dot(d[i], pairs[j, k]) + _dot(arms[i], cross(arms[j], arms[k])))
        first += mixed[i, j, k] - mixed[j, i, k] + mixed[k, i, j]
        first += _dot(d[i], turned[j, k]) + _dot(d[j], turned[k, i]) + _dot(d[k], turned[i, j])
        p, q, r = rest
        second = arm[p, r] * mixed[q, q, r] - mixed[p, p, r] * arm[q, r]
        total += first * second * permutation_sign((i, j, k, *rest))
    return total
