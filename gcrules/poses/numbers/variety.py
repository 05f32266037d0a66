r"""The line variety that lines span: planar pencil, bundle, regulus, congruence, linear complex and their kin.

Lines are vectors of six coordinates (u, m) with u·m = 0; the form (u, m) ↦ 2 u·m has the signature (3, 3). The span of
some lines is told by its dimension and the signature of this form on it: positive, negative and null directions.

`gcrules.screws.kinds` tells more of less: any span of screws, with the points and planes of its lines, finite and
infinite ones apart, and it raises LimitReached where floats do not decide that. Here the span is one of lines and the
words are projective (a bundle may have its point at infinity), so that the signature is enough; it always answers, as a
report of a pose must, and the signature is part of the answer. On spans of lines both agree
(`tests/screws/test_screws.py`).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import kernel

__all__ = ["Variety", "signature", "variety"]

Row = Sequence[Any]  # six numbers, all exact or all floats

_NAMES: dict[int, dict[int, str]] = {
    1: {1: "a single line"},
    2: {0: "two skew lines", 2: "a planar pencil"},
    3: {0: "a regulus", 1: "two planar pencils with a common line"},
    4: {1: "a parabolic linear congruence", 2: "a degenerate linear congruence (a bundle and a plane field)"},
}


@dataclass(frozen=True)
class Variety:
    """The `name` of the variety, the `dimension` of the span of the lines, and the span's signature (+, −, 0)."""

    name: str
    dimension: int
    signature: tuple[int, int, int]


def variety(rows: Sequence[Row], tolerance: float = 0.0) -> Variety:
    """The variety of independent lines, given by as many rows (u, m), m about any one point.

    With tolerance 0 the numbers are Fractions and the answer is exact; else they are floats of size about 1, the rows
    orthonormal, and what is smaller than `tolerance` counts as zero.
    """
    n = len(rows)
    form = [[_klein(a, b) for b in rows] for a in rows]
    signs = signature(form, tolerance)
    return Variety(_name(rows, n, signs, tolerance), n, signs)


def _name(rows: Sequence[Row], n: int, signs: tuple[int, int, int], tolerance: float) -> str:
    positive, negative, null = signs
    if n == 3 and null == 3:  # directions have rank 3 in a bundle, 1 in one of parallel lines, 2 in a plane
        if _directions(rows, tolerance) in (0, 2):  # 0 in the plane at infinity
            return "a plane field (lines in one plane)"
        return "a bundle (lines through one point, possibly at infinity)"
    if n == 4 and null == 0:
        kind = "hyperbolic" if positive == negative else "elliptic"
        return f"{'a' if kind == 'hyperbolic' else 'an'} {kind} linear congruence"
    if n == 5 and null:
        if _directions(rows, tolerance) == 2:
            return "a special linear complex (all lines parallel to one plane)"
        return "a special linear complex (all lines that meet one line)"
    if n == 5:
        return "a general linear complex"
    if n == 6:
        return "no variety: the lines are independent"
    return _NAMES[n].get(null, f"a set of lines of rank {n}")


def _klein(a: Row, b: Row) -> Any:
    return sum(x * y for x, y in zip(a[:3], b[3:], strict=True)) + sum(x * y for x, y in zip(a[3:], b[:3], strict=True))


def _directions(rows: Sequence[Row], tolerance: float) -> int:
    """The rank of the directions of lines."""
    if tolerance == 0:
        return 3 - len(kernel([row[:3] for row in rows], 3))
    import numpy as np

    return int((np.linalg.svd(np.array([row[:3] for row in rows]), compute_uv=False) > tolerance).sum())


def signature(form: Sequence[Sequence[Any]], tolerance: float = 0.0) -> tuple[int, int, int]:
    """The numbers of positive, negative and null directions of a symmetric form; exact for Fractions."""
    if tolerance > 0:
        import numpy as np

        values = np.linalg.eigvalsh(np.array(form, dtype=float)) if form else np.zeros(0)
        positive, negative = int((values > tolerance).sum()), int((values < -tolerance).sum())
        return positive, negative, len(values) - positive - negative
    m = [[Fraction(c) for c in row] for row in form]
    positive = negative = 0
    while m:
        k = next((i for i in range(len(m)) if m[i][i]), None)
        if k is None:  # all squares vanish: x + y takes the product of x and y
            pair = next(((i, j) for i in range(len(m)) for j in range(i) if m[i][j]), None)
            if pair is None:
                break
            i, j = pair
            m[i] = [a + b for a, b in zip(m[i], m[j], strict=True)]
            for row in m:
                row[i] += row[j]
            k = i
        pivot, top = m[k][k], m[k]
        positive, negative = positive + (pivot > 0), negative + (pivot < 0)
        m = [[row[j] - row[k] * top[j] / pivot for j in range(len(m)) if j != k] for i, row in enumerate(m) if i != k]
    return positive, negative, len(form) - positive - negative
