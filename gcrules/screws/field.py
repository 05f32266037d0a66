r"""What screws ask of the numbers they are computed with: reading, products of vectors, and linear algebra.

Formulas are written once, component by component; a component is a Fraction, a residue modulo a prime, or (for floats)
an array with one entry for each configuration. A matrix is a tuple of rows, for floats an array (..., rows, columns).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from typing import Any, ClassVar

__all__ = ["Field", "Matrix", "Row", "Vector"]

Vector = tuple[Any, Any, Any]
Row = tuple[Any, ...]
Matrix = Any  # tuple[Row, ...], or an array (..., rows, columns) of floats


class Field(ABC):
    """What all fields can do. `length` is the unit in which moments are compared with forces (1 for exact numbers)."""

    length: Any = 1
    floating: ClassVar[bool] = False
    nothing: ClassVar[Any] = None  # stands for a number that there is not

    @abstractmethod
    def number(self, value: Any, what: str = "a number") -> Any:
        """Read one number (for floats an array of any shape). Raises InputError, in which it is called `what`."""

    @abstractmethod
    def components(self, value: Any, size: int, what: str) -> Row:
        """Read a vector of this size along the last axis: its components. Raises InputError."""

    @abstractmethod
    def read(self, rows: Any, width: int = 6) -> Matrix:
        """Read a matrix of rows of this width. Raises InputError."""

    @abstractmethod
    def matrix(self, rows: Sequence[Row]) -> Matrix:
        """The matrix of rows of components."""

    @abstractmethod
    def rows(self, matrix: Matrix) -> tuple[Row, ...]:
        """The rows of the matrix of one configuration, as tuples of Python numbers."""

    @abstractmethod
    def rank(self, matrix: Matrix) -> Any:
        """The rank: a whole number, for floats of many configurations an array of them."""

    @abstractmethod
    def basis(self, matrix: Matrix) -> Matrix:
        """Independent rows with the same span."""

    @abstractmethod
    def kernel(self, matrix: Matrix, width: int = 6) -> Matrix:
        """A basis of the vectors orthogonal to all rows; `width` counts where there are none."""

    def kernel_part(self, matrix: Matrix, width: int) -> tuple[Matrix, int]:
        """A basis of the first six columns of the `kernel`, of rows of this width, and the rank of the rows."""
        found = self.kernel(matrix, width)
        return self.basis(self.cut(found, 6)), width - self.height(found)

    @abstractmethod
    def complement(self, matrix: Matrix) -> Matrix:
        """Independent vectors that together with the kernel span everything."""

    @abstractmethod
    def determinant(self, matrix: Matrix) -> Any:
        """The determinant of a square matrix."""

    @abstractmethod
    def projection(self, basis: Matrix, vector: Row) -> Row:
        """The orthogonal projection of a vector to the span of a basis that `kernel` returned."""

    @abstractmethod
    def row(self, matrix: Matrix, place: int) -> Row:
        """The components of one row."""

    @abstractmethod
    def chosen(self, matrix: Matrix, places: Sequence[int]) -> Matrix:
        """The rows at these places."""

    @abstractmethod
    def height(self, matrix: Matrix) -> int:
        """The number of rows."""

    @abstractmethod
    def joined(self, parts: Sequence[Matrix]) -> Matrix:
        """The rows of all parts, one part below the other."""

    @abstractmethod
    def spread(self, matrix: Matrix, shares: Sequence[Sequence[int]]) -> Matrix:
        """Each row (k, 6) as often side by side as it has shares, times each of them: (k, 6 n)."""

    @abstractmethod
    def cut(self, matrix: Matrix, width: int) -> Matrix:
        """The first columns of a matrix."""

    @abstractmethod
    def is_zero(self, x: Any) -> bool:
        """Whether a number is zero (for floats: within the tolerance of zero, in all configurations)."""

    @abstractmethod
    def quotient(self, x: Any, y: Any) -> Any:
        """x / y; for floats inf or nan where y is zero."""

    @abstractmethod
    def sign(self, x: Any) -> int | None:
        """1, 0 or −1; None for a nonzero residue, which has no sign."""

    @abstractmethod
    def root(self, x: Any) -> Any | None:
        """A square root; None where the field has none."""

    @abstractmethod
    def simplest(self, vector: Row, unit: int | None = None) -> Row:
        """A multiple of a nonzero vector that is easy to read, the same for all multiples. Of floats the first `unit`
        components (all, if None) make a unit vector.
        """

    def reduced(self, x: Any) -> Any:
        """The representative of a sum of products."""
        return x

    @abstractmethod
    def go_together(self, values: Iterable[Any], what: str) -> None:
        """Raises InputError for arrays whose shapes do not fit one another."""

    def packed(self, row: Row) -> Any:
        """A row as it is given back: a tuple, for floats of many configurations an array (..., 6)."""
        return row

    def scaled_field(self) -> Field:
        """The field for rows that are scaled already: the same with `length` 1."""
        return self

    def scaled(self, screws: Matrix) -> Matrix:
        """Rows of screws with their second halves divided by `length`."""
        return screws

    def unscaled(self, screws: Matrix) -> Matrix:
        """The inverse of `scaled`."""
        return screws

    def comparable(self, screws: Matrix) -> Matrix:
        """Rows of screws, scaled and of unit size, in which ranks are decided; exact rows stay as they are."""
        return screws

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """yes where the condition holds, else no; for floats entry by entry."""
        return yes if condition else no

    def vanishes(self, x: Any, beside: Any) -> Any:
        """Whether a square is zero beside another square, that is at most tolerance² times it; entry by entry."""
        return self.is_zero(x)

    def is_couple(self, force: Vector, moment: Vector) -> Any:
        """Whether the force is nothing beside the moment; for floats entry by entry."""
        return self.are_zero(force)

    def vector(self, value: Any, what: str = "a vector") -> Vector:
        """Read three coordinates."""
        x, y, z = self.components(value, 3, what)
        return x, y, z

    def dot(self, a: Sequence[Any], b: Sequence[Any]) -> Any:
        """The sum of the products of components."""
        total = a[0] * b[0]
        for x, y in zip(a[1:], b[1:], strict=True):
            total = total + x * y
        return self.reduced(total)

    def cross(self, a: Vector, b: Vector) -> Vector:
        """The vector product."""
        return (
            self.reduced(a[1] * b[2] - a[2] * b[1]),
            self.reduced(a[2] * b[0] - a[0] * b[2]),
            self.reduced(a[0] * b[1] - a[1] * b[0]),
        )

    def combination(self, coefficients: Sequence[Any], rows: Sequence[Row]) -> Row:
        """Σ coefficient · row."""
        return tuple(self.dot(coefficients, column) for column in zip(*rows, strict=True))

    def are_zero(self, components: Sequence[Any]) -> bool:
        """Whether all components are zero."""
        return all(map(self.is_zero, components))

    def are_parallel(self, a: Vector, b: Vector) -> bool:
        """Whether two vectors are dependent (for floats: in any of the configurations)."""
        return self.are_zero(self.cross(a, b))

    def normal_pair(self, a: Vector) -> tuple[Vector, Vector]:
        """Two independent vectors orthogonal to a nonzero vector: its products with two of the coordinate axes."""
        x, y, z = a
        around = ((x * 0, z, -y), (-z, x * 0, x), (y, -x, x * 0))
        i = next(i for i in range(3) if not self.is_zero(a[i]))
        return around[(i + 1) % 3], around[(i + 2) % 3]
