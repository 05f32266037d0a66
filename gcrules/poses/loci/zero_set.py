r"""What the zeros of a polynomial of degree 1 or 2 in lengths are: a plane, a quadric, a line, a conic; exactly.

>>> zero_set(PolynomialForm(("x", "y"), (((2, 0), 1), ((0, 2), 1), ((0, 0), -1)))).kind
'circle'
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.variables import TRANSLATION

__all__ = ["EMPTY", "ZeroSet", "zero_set", "zeros_json"]

EMPTY = "empty"
"""The kind of a polynomial that is 0 at no real point."""

_LINEAR = {2: "line", 3: "plane"}
_ROUND = {"ellipse": "circle", "ellipsoid": "sphere"}

_Inertia = tuple[int, int]

# By how many eigenvalues are positive and negative: of the matrix of the quadratic part, and of the whole one.
_CONICS: dict[tuple[_Inertia, _Inertia], str] = {
    ((2, 0), (3, 0)): EMPTY,
    ((2, 0), (2, 1)): "ellipse",
    ((2, 0), (2, 0)): "point",
    ((1, 1), (2, 1)): "hyperbola",
    ((1, 1), (1, 1)): "pair of lines that cross",
    ((1, 0), (2, 1)): "parabola",
    ((1, 0), (2, 0)): EMPTY,
    ((1, 0), (1, 1)): "pair of parallel lines",
    ((1, 0), (1, 0)): "double line",
}
_QUADRICS: dict[tuple[_Inertia, _Inertia], str] = {
    ((3, 0), (4, 0)): EMPTY,
    ((3, 0), (3, 1)): "ellipsoid",
    ((3, 0), (3, 0)): "point",
    ((2, 1), (2, 2)): "hyperboloid of one sheet",
    ((2, 1), (3, 1)): "hyperboloid of two sheets",
    ((2, 1), (2, 1)): "cone",
    ((2, 0), (3, 1)): "elliptic paraboloid",
    ((2, 0), (3, 0)): EMPTY,
    ((2, 0), (2, 1)): "elliptic cylinder",
    ((2, 0), (2, 0)): "line",
    ((1, 1), (2, 2)): "hyperbolic paraboloid",
    ((1, 1), (2, 1)): "hyperbolic cylinder",
    ((1, 1), (1, 1)): "pair of planes that cross",
    ((1, 0), (2, 1)): "parabolic cylinder",
    ((1, 0), (2, 0)): EMPTY,
    ((1, 0), (1, 1)): "pair of parallel planes",
    ((1, 0), (1, 0)): "double plane",
}


@dataclass(frozen=True)
class ZeroSet:
    """The real zeros of a polynomial: their `kind`, "empty" where there are none, and the `normal` of a plane, or of a
    line among two coordinates, in whole numbers.
    """

    kind: str
    normal: tuple[int, ...] = ()


def zero_set(form: PolynomialForm) -> ZeroSet | None:
    """What a polynomial in two or three of x, y and z has as zeros; None for other variables and degrees."""
    number = len(form.variables)
    if number not in _LINEAR or not set(form.variables) <= set(TRANSLATION) or form.degree not in (1, 2):
        return None
    if form.degree == 1:
        normal = [dict(form.terms).get(_exponents(number, i), 0) for i in range(number)]
        common = gcd(*normal)
        return ZeroSet(_LINEAR[number], tuple(c // common for c in normal))
    part, whole = _matrices(form)
    kinds = _QUADRICS if number == 3 else _CONICS
    found = _inertia(part), _inertia(whole)
    kind = kinds.get(found) or kinds[found[0][::-1], found[1][::-1]]  # of −form, which has the same zeros
    return ZeroSet(_ROUND.get(kind, kind) if _is_scalar(part) else kind)


def zeros_json(zeros: ZeroSet | None) -> dict[str, Any]:
    """The entries of a factor's JSON: null for other polynomials; the normal as texts, since it may be long."""
    normal = [str(c) for c in zeros.normal] if zeros and zeros.normal else None
    return {"zero_set": zeros.kind if zeros else None, "normal": normal}


def _exponents(number: int, *of: int) -> tuple[int, ...]:
    return tuple(of.count(i) for i in range(number))


def _matrices(form: PolynomialForm) -> tuple[list[list[int]], list[list[int]]]:
    """Twice the matrix of the quadratic part, and twice that of the whole polynomial with 1 as last coordinate."""
    terms, number = dict(form.terms), len(form.variables)
    last = number  # the 1
    whole = [
        [
            terms.get(_exponents(number, *(k for k in (i, j) if k != last)), 0) * (2 if i == j else 1)
            for j in range(number + 1)
        ]
        for i in range(number + 1)
    ]
    return [row[:last] for row in whole[:last]], whole


def _is_scalar(matrix: Sequence[Sequence[int]]) -> bool:
    return all(c == (matrix[0][0] if i == j else 0) for i, row in enumerate(matrix) for j, c in enumerate(row))


def _inertia(matrix: Sequence[Sequence[int]]) -> _Inertia:
    """How many eigenvalues of a symmetric matrix are positive, and how many negative: by squares that are split off,
    which by Sylvester's law are as many, whichever they are.
    """
    m = [[Fraction(c) for c in row] for row in matrix]
    signs = []
    while m:
        k = next((i for i, row in enumerate(m) if row[i]), None)
        if k is None:
            pair = next(((i, j) for i, row in enumerate(m) for j, c in enumerate(row) if c), None)
            if pair is None:
                break
            k, j = pair  # xy is the square of (x + y)/2 less that of (x − y)/2
            m[k] = [a + b for a, b in zip(m[k], m[j], strict=True)]
            for row in m:
                row[k] += row[j]
        pivot = m.pop(k)
        square = pivot.pop(k)
        signs.append(square > 0)
        for row in m:
            c = row.pop(k) / square
            row[:] = [a - c * b for a, b in zip(row, pivot, strict=True)]
    return sum(signs), len(signs) - sum(signs)
