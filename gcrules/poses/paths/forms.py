r"""The superbracket along segments as a sum of products of three linear forms, for many segments at once.

Let t be the translation, R = N(q)/n the turn, n = |q|², β_i the platform's arms, α_i the joints of the base less the
centre, X_i = t − α_i and b_i = Rβ_i. With moments about the place of the centre the rows of the superbracket are
(X_i + b_i, b_i × X_i) (see `segment`), so by its first three columns it is, but for its sign, the sum of ± E_ijk M_lmo
over the ways to part the six legs, with

    E_ijk = [X_i + b_i, X_j + b_j, X_k + b_k],    M_lmo = [b_l X_l b_o] [b_m X_m X_o] − [b_l X_l X_o] [b_m X_m b_o].

The minors of R of order two are its entries, and t × t = 0, so n times each of these brackets is linear in the 40
products of (n, N) and (1, t): `Forms` holds the coefficients. Where q and t are linear in s, the sum is n³ D, of degree
≤ 9: no more than was proved. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, combinations_with_replacement
from math import frexp, lcm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.floats import as_float
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.screws.rotations import unscaled

__all__ = ["Forms", "forms", "superbracket"]

Array = NDArray[Any]
"""Of floats, or of whole numbers as objects: then all is exact."""

_TRIPLES = tuple(combinations(range(6), 3))
_PAIRS = {pair: n for n, pair in enumerate(combinations(range(6), 2))}
_RESTS = [sorted({*range(6)} - {*triple}) for triple in _TRIPLES]
_FIRST, _SECOND = ([_PAIRS[rest[n], rest[2]] for rest in _RESTS] for n in (0, 1))
_SQUARES = tuple(combinations_with_replacement(range(4), 2))


@dataclass(frozen=True, eq=False)
class Forms:
    """The forms n E (20, with the signs of the sum), n [b_i X_i b_j] and n [b_i X_i X_j] (15 each, i < j) in this
    order: coefficients (50, 40), at the products of (n, N row by row) with (1, t).

    `floats` are the nearest ones to the coefficients with lengths in `unit`, a power of 2 near the robot's size. With
    lengths in the unit `fine` they are the `whole` numbers.
    """

    floats: Array
    unit: Fraction
    whole: Array
    fine: Fraction


def superbracket(coefficients: Array, turns: Array, shifts: Array, *, absolute: bool = False) -> Array:
    """n³ D, but for its sign, as a polynomial (m, N), for N quaternions (4, k, N) whose components are polynomials and
    as many (1, t) (4, l, N): m = 6 (k − 1) + 3 (l − 1) + 1. All polynomials are in s alone, lowest power first, or all
    in 1 − s and s, by powers of s.

    With `absolute` it is the same sum of the absolute values of all terms, where those of the arguments are given.
    """
    squares = np.stack([_times(turns[i], turns[j]) for i, j in _SQUARES])
    table = np.abs(_TABLE) if absolute else _TABLE
    turned = np.tensordot(table.astype(squares.dtype), squares, 1)
    products = _times(turned[:, None], shifts[None, :])
    length, number = products.shape[2:]
    known = np.abs(coefficients) if absolute else coefficients
    found = (known @ products.reshape(40, -1)).reshape(50, length, number)
    first, ends, others = found[:20], found[20:35], found[35:]
    one, other = _times(ends[_FIRST], others[_SECOND]), _times(others[_FIRST], ends[_SECOND])
    return np.asarray(_times(first, one + other if absolute else one - other).sum(axis=0))


def _times(p: Array, q: Array) -> Array:
    """The products of polynomials (…, k, N) and (…, l, N): (…, k + l − 1, N)."""
    k, l = p.shape[-2], q.shape[-2]
    shape = (*np.broadcast_shapes(p.shape[:-2], q.shape[:-2]), k + l - 1, p.shape[-1])
    found = np.zeros(shape, p.dtype)
    for i in range(k):
        found[..., i : i + l, :] += p[..., i : i + 1, :] * q
    return found


def _table() -> Array:
    """|q|² and the entries of N, row by row, from the products of two components of q: (10, 10) whole numbers."""

    def entries(*axes: int) -> Array:
        q = [axes.count(n) for n in range(4)]
        return np.array([sum(c * c for c in q), *(c for row in unscaled(q) for c in row)], object)

    return np.stack([entries(i) if i == j else entries(i, j) - entries(i) - entries(j) for i, j in _SQUARES], axis=1)


_TABLE = _table()


@lru_cache(maxsize=8)
def forms(rig: MovingPlatform) -> Forms:
    """The forms of a robot; exact."""
    joints = [[[c - m for c, m in zip(rig.points[n], rig.centre, strict=True)] for n in leg] for leg in rig.legs]
    unit = Fraction(2) ** (frexp(rig.size)[1] - 1)
    parts = lcm(*((c / unit).denominator for leg in joints for place in leg for c in place))
    alpha, beta = np.array([[[int(c / unit * parts) for c in p] for p in leg] for leg in joints], object).swapaxes(0, 1)
    whole = np.stack([*_sums(alpha, beta), *_pairs(alpha, beta)])  # all are of the degree 3 in lengths, t among them
    floats = [as_float(Fraction(int(c), parts ** (2 if n % 4 else 3))) for n, c in enumerate(whole.flat)]
    return Forms(np.array(floats).reshape(50, 40), unit, whole.reshape(50, 40), unit / parts)


def _sums(alpha: Array, beta: Array) -> Iterator[Array]:
    """The forms n E: (10, 4) each."""
    for triple in _TRIPLES:
        found = np.zeros((10, 4), object)
        for i, j, k in (np.roll(triple, -n) for n in range(3)):
            found[0, 1:] += np.cross(alpha[i], alpha[j])
            found += _inner(beta[i], _cross(alpha[j], alpha[k])) + _inner(np.cross(beta[i], beta[j]), _less(alpha[k]))
        i, j, k = triple
        found[0, 0] = beta[i] @ np.cross(beta[j], beta[k]) - alpha[i] @ np.cross(alpha[j], alpha[k])
        yield found * (-1) ** (sum(triple) + 1)


def _pairs(alpha: Array, beta: Array) -> Iterator[Array]:
    """The forms n [b_i X_i b_j], then n [b_i X_i X_j]: (10, 4) each."""
    yield from (_inner(np.cross(beta[j], beta[i]), _less(alpha[i])) for i, j in _PAIRS)
    yield from (_inner(beta[i], _cross(alpha[i], alpha[j])) for i, j in _PAIRS)


def _less(a: Array) -> Array:
    """t − a, linear in (1, t): (3, 4)."""
    return np.concatenate([-a[:, None], np.eye(3, dtype=int).astype(object)], axis=1)


def _cross(a: Array, b: Array) -> Array:
    """(t − a) × (t − b) = a × b + t × (a − b), linear in (1, t): (3, 4)."""
    return np.stack([np.cross(a, b), *(np.cross(axis, a - b) for axis in np.eye(3, dtype=int).astype(object))], axis=1)


def _inner(b: Array, y: Array) -> Array:
    """n (R b) · y, y linear in (1, t), as a form (10, 4)."""
    return np.concatenate([np.zeros((1, 4), object), (y[:, None] * b[None, :, None]).reshape(9, 4)])
