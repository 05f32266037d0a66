r"""Is a platform on six legs singular in every pose? Decided exactly.

With the turn given by a quaternion q of any length and N = |q|², the determinant of the six lines times N³ is a
polynomial, homogeneous of degree 6 in q and of degree 3 at most in the translation t: by its expansion it is a sum of
products of three brackets, and each of these, a volume of four joints, is of degree 1 at most in the entries of the
rotation (minors of order 2 are entries again, that of order 3 is 1), and in t. Such a polynomial is zero if it vanishes
at all whole q ≥ 0 of sum 6 and all whole t ≥ 0 of sum at most 3: 84 · 20 poses, which are a unisolvent lattice. Derived
here. The first pose at which it does not vanish proves that there are regular poses.

>>> square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (3, 1, 0), (1, 5, 2)]
>>> found = singular_everywhere(square, [(x, y, 3 * x) for x, y, z in square])
>>> found.everywhere, found.poses, singular_everywhere([(0, 0, 0)] * 4 + square[-2:], square).everywhere
(False, 1, True)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from math import lcm
from random import Random
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import determinant, kernel, whole_determinant
from gcrules.screws.rotations import unscaled

__all__ = ["Everywhere", "balance", "lines_at", "singular_everywhere", "whole"]

PRIME = (1 << 61) - 1
_SAMPLES = 3
_DEGREES = 15  # of the determinant in the numbers of a pose as they are drawn: 12 in q and 3 in t at most

Places = Sequence[Sequence[Any]]
Whole = tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class Everywhere:
    """Whether the determinant vanishes in every pose; after how many exact `poses` of the lattice that was known."""

    everywhere: bool
    poses: int


def singular_everywhere(base: Places, platform: Places) -> Everywhere:
    """Whether six legs between these joints, exact numbers in one order, are linearly dependent in every pose."""
    return _decided(*whole(base, platform))


@lru_cache(maxsize=256)
def _decided(base: Whole, platform: Whole) -> Everywhere:
    if any(determinant(lines_at(base, platform, *pose), PRIME) for pose in _random_poses()):
        return Everywhere(False, 1)  # not 0 modulo a prime, and so not 0
    for number, (q, t) in enumerate(_lattice_poses(), 1):
        checkpoint()
        if whole_determinant(lines_at(base, platform, q, t)):
            return Everywhere(False, number)
    return Everywhere(True, number)


def _random_poses() -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    draw = Random("poses of an architecture")
    for _ in range(_SAMPLES):
        yield tuple(draw.randrange(PRIME) for _ in range(4)), tuple(draw.randrange(PRIME) for _ in range(3))


def _lattice_poses() -> Iterator[tuple[tuple[int, ...], tuple[int, ...]]]:
    for q in _lattice(4, 6):
        for t in _lattice(4, 3):
            yield q, t[:3]


def _lattice(size: int, total: int) -> Iterator[tuple[int, ...]]:
    """All rows of so many whole numbers, none negative, of this sum."""
    if size == 1:
        yield (total,)
        return
    for first in range(total + 1):
        for rest in _lattice(size - 1, total - first):
            yield (first, *rest)


def whole(base: Places, platform: Places) -> tuple[Whole, Whole]:
    """The joints in a unit in which all coordinates are whole."""
    exact = [[tuple(map(Fraction, p)) for p in body] for body in (base, platform)]
    unit = lcm(*(c.denominator for body in exact for p in body for c in p))
    first, second = (tuple(tuple(int(c * unit) for c in p) for p in body) for body in exact)
    return first, second


def lines_at(base: Places, platform: Places, q: Sequence[Any], t: Sequence[Any]) -> list[list[Any]]:
    """The lines from the base to the platform moved to (R(q) p + t), each as direction and moment, times |q|²."""
    turn, scale = unscaled(q), sum(c * c for c in q)
    rows = []
    for b, p in zip(base, platform, strict=True):
        end = [sum(r * c for r, c in zip(row, p, strict=True)) + scale * s for row, s in zip(turn, t, strict=True)]
        x, y, z = end
        rows.append(
            [
                *(e - scale * c for e, c in zip(end, b, strict=True)),
                b[1] * z - b[2] * y,
                b[2] * x - b[0] * z,
                b[0] * y - b[1] * x,
            ]
        )
    return rows


def balance(base: Places, platform: Places) -> tuple[tuple[Fraction, ...], ...]:
    """All relations Σ λᵢ (bᵢ, 1) ⊗ (pᵢ, 1) = 0, a basis of the λ. As the Plücker coordinates of the line from bᵢ to
    the moved pᵢ are linear in that product, each is a relation of the lines in every pose (after affine maps too):
    forces λᵢ times the length of the leg balance everywhere.
    """
    products = [[Fraction(x) * y for x in (*b, 1) for y in (*p, 1)] for b, p in zip(base, platform, strict=True)]
    return tuple(kernel(zip(*products, strict=True), len(products)))
