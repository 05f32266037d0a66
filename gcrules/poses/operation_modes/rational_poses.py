"""Rational poses with small numbers: witnesses of a mode, and of two modes that meet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from gcrules.core.linear_algebra import content, echelon
from gcrules.poses.operation_modes.orientations import Form, Orientations, fraction
from gcrules.poses.operation_modes.random_poses import solved
from gcrules.poses.operation_modes.strata import Row, Stratum

__all__ = ["HOME", "at", "common_pose", "inside", "witness"]

HOME = (*map(Fraction, (1, 0, 0, 0, 0, 0, 0, 0)),)

_REACH = 7


def at(f: Form, x: Sequence[Any]) -> Fraction:
    """A form at rational numbers."""
    total = Fraction(0)
    for m, c in f.terms():
        term = fraction(c)
        for base, n in zip(x, m, strict=True):
            term *= base**n
        total += term
    return total


def _evaluated(rows: Sequence[Row], x: Sequence[Fraction]) -> list[list[Fraction]]:
    return [[at(f, x) for f in row] for row in rows]


def inside(one: Stratum, pose: Sequence[Fraction]) -> bool:
    """Whether a pose is seen to be in the closure of a stratum: the rows are independent there too, so that near it the
    poses are a bundle.
    """
    x, y = pose[:4], (*pose[4:], Fraction(1))
    if any(at(f, x) for f in one.orientations.basis):
        return False
    rows = _evaluated(one.rows, x)
    if any(sum(a * b for a, b in zip(row, y, strict=True)) for row in rows):
        return False
    return len(echelon([row[:4] for row in rows])[1]) == len(rows)


def _small(where: Orientations) -> Iterator[tuple[Fraction, ...]]:
    """Quaternions of small numbers in a set, the smallest first."""
    basis = where.subspace()
    curved = [f for f in where.basis if sum(f.LM) > 1]
    width = len(basis)
    reach = _REACH if width < 4 else 3
    amounts = sorted(product(range(-reach, reach + 1), repeat=width), key=lambda a: (sum(map(abs, a)), [-c for c in a]))
    for own in amounts:
        if not any(own) or next(c for c in own if c) < 0:
            continue
        x = tuple(sum((c * v[n] for c, v in zip(own, basis, strict=True)), Fraction(0)) for n in range(4))
        if not any(at(f, x) for f in curved):
            yield x


def witness(one: Stratum) -> tuple[Fraction, ...] | None:
    """A pose of a stratum, home where it is one; None where none with small numbers is found."""
    if inside(one, HOME):
        return HOME
    for x in _small(one.orientations):
        if any(not at(f, x) for f in one.nonzero):
            continue
        y = solved(_evaluated(one.rows, x), None, None)
        if y is not None:
            return _short((*x, *y))
    return None


def common_pose(one: Stratum, other: Stratum, shared: Sequence[Orientations]) -> tuple[Fraction, ...] | None:
    """A pose in the closures of both strata, whose `shared` orientations are given."""
    for piece in shared:
        for x in _small(piece):
            first, second = _evaluated(one.rows, x), _evaluated(other.rows, x)
            if any(len(echelon([r[:4] for r in rows])[1]) < len(rows) for rows in (first, second)):
                continue
            rows = [r for r in echelon([*first, *second])[0]]
            y = solved(rows, None, None)
            if y is not None:
                return _short((*x, *y))
    return None


def _short(pose: tuple[Any, ...]) -> tuple[Fraction, ...]:
    divisor = content(pose) * (1 if next(c for c in pose if c) > 0 else -1)
    return tuple(Fraction(c) / divisor for c in pose)
