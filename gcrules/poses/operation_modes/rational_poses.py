"""Rational poses with small numbers: witnesses of a mode, and of two modes that meet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import islice, product, zip_longest
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import content, echelon, rank
from gcrules.poses.operation_modes.orientations import Form, Orientations, fraction
from gcrules.poses.operation_modes.random_poses import solved
from gcrules.poses.operation_modes.strata import PoseBundle, Row

__all__ = ["HOME", "at", "common_pose", "inside", "witness"]

HOME = (*map(Fraction, (1, 0, 0, 0, 0, 0, 0, 0)),)

_REACH = 7
_ENDS = 12  # orientations at which limits are looked for
_CURVES = 40  # curves that lead to each of them


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


def inside(one: PoseBundle, pose: Sequence[Fraction]) -> bool | None:
    """Whether a pose is in the closure of a stratum. It is not where an equation of the stratum is not 0; it is where
    they have their full rank, so that near it too the poses are a bundle; else None.
    """
    x, y = pose[:4], (*pose[4:], Fraction(1))
    if any(at(f, x) for f in one.stratum.orientations.basis):
        return False
    rows = _evaluated(one.rows, x)
    if any(sum(a * b for a, b in zip(row, y, strict=True)) for row in rows):
        return False
    return True if _rank(rows) == len(one.stratum.rows) else None


def _rank(rows: Sequence[Sequence[Fraction]]) -> int:
    return rank([row[:4] for row in rows])


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


def witness(one: PoseBundle) -> tuple[Fraction, ...] | None:
    """A pose of a stratum, home where it is one; None where none with small numbers is found."""
    return HOME if inside(one, HOME) else _pose([one], [one.stratum.orientations])


def common_pose(one: PoseBundle, other: PoseBundle, shared: Sequence[Orientations]) -> tuple[Fraction, ...] | None:
    """A pose in the closures of both strata, whose `shared` orientations are given: home where it is one."""
    if inside(one, HOME) and inside(other, HOME):
        return HOME
    found = _pose([one, other], shared)
    if found is None:
        limits = (p for a, b in ((one, other), (other, one)) for p in _limits(a, shared) if inside(b, p))
        found = next(limits, None)
    return found


def _limits(one: PoseBundle, shared: Sequence[Orientations]) -> Iterator[tuple[Fraction, ...]]:
    """Poses in the closure of a stratum at orientations where its equations depend on each other: ends of curves in it
    that lead there.
    """
    where = one.stratum.orientations
    if len(where.linear) < len(where.basis):
        return
    for piece in shared:
        for x in islice(_small(piece), _ENDS):
            for step in islice(_small(where), _CURVES):
                checkpoint()
                y = _limit(one.stratum.rows, x, step)
                if y is not None:
                    yield _short((*x, *y))


def _limit(rows: Sequence[Row], x: Sequence[Fraction], step: Sequence[Fraction]) -> tuple[Fraction, ...] | None:
    """Where y tends along x + s step for s to 0, what is free being 0; None where it grows without bounds."""
    y = [Fraction(0)] * 4
    used: set[int] = set()
    for row in rows:
        column = next(k for k in range(4) if row[k] and all(not r[k] for r in rows if r is not row) and k not in used)
        used.add(column)
        lead, rest = _along(row[column], x, step), _along(row[4], x, step)
        order = next((n for n, c in enumerate(lead) if c), None)
        if order is None or any(rest[:order]):
            return None
        y[column] = -(rest[order] if order < len(rest) else Fraction(0)) / lead[order]
    return tuple(y)


def _along(f: Form, x: Sequence[Fraction], step: Sequence[Fraction]) -> list[Fraction]:
    """The coefficients of a form on a line, the lowest first."""
    total: list[Fraction] = []
    for m, c in f.terms():
        term = [fraction(c)]
        for a, b, n in zip(x, step, m, strict=True):
            for _ in range(n):
                term = [p * a + q * b for p, q in zip([*term, Fraction(0)], [Fraction(0), *term], strict=True)]
        total = [p + q for p, q in zip_longest(total, term, fillvalue=Fraction(0))]
    return total


def _pose(several: Sequence[PoseBundle], where: Sequence[Orientations]) -> tuple[Fraction, ...] | None:
    for piece in where:
        for x in _small(piece):
            checkpoint()
            parts = [_evaluated(one.rows, x) for one in several]
            if any(_rank(rows) < len(one.stratum.rows) for one, rows in zip(several, parts, strict=True)):
                continue
            y = solved(echelon([row for rows in parts for row in rows])[0])
            if y is not None:
                return _short((*x, *y))
    return None


def _short(pose: tuple[Any, ...]) -> tuple[Fraction, ...]:
    divisor = content(pose) * (1 if next(c for c in pose if c) > 0 else -1)
    return tuple(Fraction(c) / divisor for c in pose)
