r"""Exact numbers: fractions, and residues modulo a prime.

>>> RATIONALS.rank([[1, 2], [2, 4]]), RATIONALS.kernel([[1, 2]])
(1, ((Fraction(-2, 1), Fraction(1, 1)),))
>>> Residues(7).number(Fraction(1, 3))
5
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import isqrt
from operator import mul
from typing import Any

from gcrules.algebra.evaluate import PRIME
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import content, determinant, echelon, kernel, kernel_part, rank
from gcrules.screws.field import Field, Matrix, Row

__all__ = ["RATIONALS", "RESIDUES", "Exact", "Rationals", "Residues"]


class Exact(Field):
    """Linear algebra by Gauss and Jordan's elimination, over the rationals (no `modulus`) or modulo a prime."""

    @property
    def modulus(self) -> int | None:
        """The prime, None for the rationals."""
        return None

    def components(self, value: Any, size: int, what: str) -> Row:
        if isinstance(value, str | Mapping) or not isinstance(value, Iterable):
            raise InputError(f"{what} needs {size} coordinates")
        found = tuple(value)
        if len(found) != size:
            raise InputError(f"{what} needs {size} coordinates, not {len(found)}")
        return tuple(self.number(x, what) for x in found)

    def read(self, rows: Any, width: int = 6) -> Matrix:
        if isinstance(rows, str | Mapping) or not isinstance(rows, Iterable):
            raise InputError(f"rows of {width} numbers are needed")
        return tuple(self.components(row, width, f"row {n + 1}") for n, row in enumerate(rows))

    def matrix(self, rows: Sequence[Row]) -> Matrix:
        return tuple(rows)

    def rows(self, matrix: Matrix) -> tuple[Row, ...]:
        return tuple(map(tuple, matrix))

    def echelon(self, matrix: Matrix) -> tuple[tuple[Row, ...], tuple[int, ...]]:
        """The reduced echelon form without zero rows, and the columns of its leading ones."""
        return echelon([[self.number(x) for x in row] for row in matrix], self.modulus)

    def rank(self, matrix: Matrix) -> int:
        return len(self.echelon(matrix)[1])

    def basis(self, matrix: Matrix) -> Matrix:
        """The reduced echelon form: the same for all matrices with the same span."""
        return self.echelon(matrix)[0]

    def kernel(self, matrix: Matrix, width: int = 6) -> Matrix:
        """One vector for each column without a leading one; `width` counts where there are no rows."""
        rows = [[self.number(x) for x in row] for row in matrix]
        return tuple(kernel(rows, len(rows[0]) if rows else width, self.modulus))

    def kernel_part(self, matrix: Matrix, width: int) -> tuple[Matrix, int]:
        return kernel_part([[self.number(x) for x in row] for row in matrix], width, 6, self.modulus)

    def complement(self, matrix: Matrix) -> Matrix:
        """Unit vectors at the leading ones: a kernel vector is zero where it is zero in the other columns."""
        width = len(matrix[0]) if matrix else 6
        pivots = self.echelon(matrix)[1]
        return tuple(tuple(self.number(int(i == pivot)) for i in range(width)) for pivot in pivots)

    def determinant(self, matrix: Matrix) -> Any:
        rows = [[self.number(x) for x in row] for row in matrix]
        value = self.number(1)
        for k in range(len(rows)):
            pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
            if pivot is None:
                return self.number(0)
            if pivot != k:
                rows[k], rows[pivot] = rows[pivot], rows[k]
                value = -value
            value = self.reduced(value * rows[k][k])
            inverse = self.quotient(1, rows[k][k])
            for i in range(k + 1, len(rows)):
                factor = self.reduced(rows[i][k] * inverse)
                rows[i] = [self.reduced(x - factor * y) for x, y in zip(rows[i], rows[k], strict=True)]
        return value

    def projection(self, basis: Matrix, vector: Row) -> Row:
        """Raises LimitReached where the basis is orthogonal to a part of itself, which no real vectors are."""
        if not basis:
            return tuple(self.number(0) for _ in vector)
        gram = [(*(self.dot(a, b) for b in basis), self.dot(a, vector)) for a in basis]
        solved, pivots = self.echelon(gram)
        if pivots != tuple(range(len(basis))):
            raise LimitReached("the basis has isotropic vectors modulo the prime", hint="use other random coordinates")
        return self.combination([row[-1] for row in solved], basis)

    def row(self, matrix: Matrix, place: int) -> Row:
        return tuple(matrix[place])

    def chosen(self, matrix: Matrix, places: Sequence[int]) -> Matrix:
        return tuple(matrix[i] for i in places)

    def height(self, matrix: Matrix) -> int:
        return len(matrix)

    def joined(self, parts: Sequence[Matrix]) -> Matrix:
        return tuple(row for part in parts for row in part)

    def spread(self, matrix: Matrix, shares: Sequence[Sequence[int]]) -> Matrix:
        return tuple(
            tuple(self.number(c * x) for c in own for x in row) for row, own in zip(matrix, shares, strict=True)
        )

    def cut(self, matrix: Matrix, width: int) -> Matrix:
        return tuple(row[:width] for row in matrix)

    def go_together(self, values: Iterable[Any], what: str) -> None:
        """Exact numbers are of one configuration."""

    def is_zero(self, x: Any) -> bool:
        return not self.reduced(x)


@dataclass(frozen=True)
class Rationals(Exact):
    """Whole numbers and Fractions, exact."""

    def number(self, value: Any, what: str = "a number") -> Any:
        if isinstance(value, int | Fraction):
            return Fraction(value)
        if isinstance(value, float):
            raise InputError(f"{what} holds the float {value!r}", hint="write a Fraction, or compute with floats")
        raise InputError(f"{what} holds {value!r}, which is not a number")

    def quotient(self, x: Any, y: Any) -> Any:
        return Fraction(x) / y

    def sign(self, x: Any) -> int | None:
        return int(x > 0) - int(x < 0)

    def root(self, x: Any) -> Any | None:
        if x < 0:
            return None
        x = Fraction(x)
        above, below = isqrt(x.numerator), isqrt(x.denominator)
        return Fraction(above, below) if above * above == x.numerator and below * below == x.denominator else None

    def simplest(self, vector: Row, unit: int | None = None) -> Row:
        """Whole numbers without a common divisor, the first of which is positive."""
        divisor = content(map(Fraction, vector)) * next(-1 if x < 0 else 1 for x in vector if x)
        return tuple(Fraction(x) / divisor for x in vector)


@dataclass(frozen=True)
class Residues(Exact):
    """Whole numbers and Fractions modulo a prime p with p mod 4 = 3 (roots are then powers); 0 … p − 1."""

    p: int = PRIME

    def __post_init__(self) -> None:
        if self.p % 4 != 3 or any(pow(b, self.p - 1, self.p) != 1 for b in (2, 3, 5, 7) if self.p != b):
            raise InputError(f"{self.p} is not a prime of the form 4n + 3")

    @property
    def modulus(self) -> int | None:
        return self.p

    def number(self, value: Any, what: str = "a number") -> int:
        if isinstance(value, int):
            return value % self.p
        if isinstance(value, Fraction) and value.denominator == 1:
            return value.numerator % self.p
        if isinstance(value, Fraction):
            if value.denominator % self.p == 0:
                raise LimitReached(f"a denominator is a multiple of the modulus {self.p}")
            return value.numerator * pow(value.denominator, -1, self.p) % self.p
        raise InputError(f"{what} holds {value!r}, which has no residue", hint="write whole numbers or Fractions")

    def reduced(self, x: Any) -> Any:
        return x % self.p

    def components(self, value: Any, size: int, what: str) -> Row:
        if type(value) is tuple and len(value) == size and set(map(type, value)) == {int}:
            return tuple([x % self.p for x in value])
        return super().components(value, size, what)

    def dot(self, a: Sequence[Any], b: Sequence[Any]) -> Any:
        if len(a) != len(b):
            raise ValueError("vectors of different lengths")
        return sum(map(mul, a, b)) % self.p

    def echelon(self, matrix: Matrix) -> tuple[tuple[Row, ...], tuple[int, ...]]:
        return echelon(map(self._read, matrix), self.p)

    def rank(self, matrix: Matrix) -> int:
        return rank(map(self._read, matrix), self.p)

    def kernel(self, matrix: Matrix, width: int = 6) -> Matrix:
        return tuple(kernel(map(self._read, matrix), len(matrix[0]) if matrix else width, self.p))

    def kernel_part(self, matrix: Matrix, width: int) -> tuple[Matrix, int]:
        return kernel_part(tuple(map(self._read, matrix)), width, 6, self.p)

    def spread(self, matrix: Matrix, shares: Sequence[Sequence[int]]) -> Matrix:
        rows = zip(map(self._read, matrix), shares, strict=True)
        return tuple(tuple([c * x % self.p for c in own for x in row]) for row, own in rows)

    def determinant(self, matrix: Matrix) -> Any:
        return determinant(map(self._read, matrix), self.p)

    def _read(self, row: Row) -> Row:
        """The row as whole numbers, which linear algebra takes modulo the prime."""
        return row if set(map(type, row)) == {int} else tuple(map(self.number, row))

    def quotient(self, x: Any, y: Any) -> Any:
        if y % self.p == 0:
            raise LimitReached(f"a divisor is zero modulo {self.p}", hint="use other random coordinates")
        return x * pow(y, -1, self.p) % self.p

    def sign(self, x: Any) -> int | None:
        return None if x % self.p else 0

    def root(self, x: Any) -> Any | None:
        found = pow(x, (self.p + 1) // 4, self.p)
        return found if found * found % self.p == x % self.p else None

    def simplest(self, vector: Row, unit: int | None = None) -> Row:
        """The last coordinate that is not zero becomes 1."""
        last = next(x for x in reversed(vector) if x)
        return tuple(self.quotient(x, last) for x in vector)


RATIONALS = Rationals()
RESIDUES = Residues()
"""Residues modulo the prime of the oracle, see `seeds`."""
