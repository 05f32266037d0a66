r"""Floats, with a stated tolerance, for one configuration or for many at once.

Ranks are decided by singular values: those above `tolerance` × max(1, the largest) count. Rows of screws are first made
comparable: moments (and velocities) are divided by `length`, then each row by its size. The origin should be near the
robot and `length` about its size, because ranks of screws in floats depend on both; exact numbers know neither.

    >>> FLOATS.rank([[1.0, 2.0], [2.0, 4.0 + 1e-13]])
    1
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.screws.field import Field, Matrix, Row, Vector

__all__ = ["FLOATS", "Floats"]

_Array = NDArray[np.float64]

_LARGEST = 1e60  # fourth powers of coordinates are computed with


@dataclass(frozen=True)
class Floats(Field):
    """Double precision. `tolerance` is relative (see above); `length` has the unit of the coordinates."""

    tolerance: float = 1e-9
    length: float = 1.0
    floating: ClassVar[bool] = True
    nothing: ClassVar[Any] = float("nan")

    def __post_init__(self) -> None:
        if not 0 < self.tolerance < 1:
            raise InputError(f"the tolerance {self.tolerance!r} is not between 0 and 1")
        if not 0 < self.length < float("inf"):
            raise InputError(f"the length {self.length!r} is not positive")

    def number(self, value: Any, what: str = "a number") -> Any:
        if isinstance(value, float) and abs(value) <= _LARGEST:
            return float(value)
        try:
            found = np.asarray(value, dtype=float)
        except (TypeError, ValueError, OverflowError):
            raise InputError(f"{what} holds something that is not a float: {str(value)[:60]}") from None
        if not np.isfinite(found).all():
            raise InputError(f"{what} is not finite")
        if np.any(np.abs(found) > _LARGEST):
            raise InputError(f"{what} is too large: over {_LARGEST:g}", hint="choose another unit of length")
        return found if found.ndim else float(found)

    def components(self, value: Any, size: int, what: str) -> Row:
        if isinstance(value, np.ndarray) and value.dtype == float and value.shape == (size,):
            one: Row = tuple(value.tolist())  # of one configuration, which NumPy is slow with
            if all(abs(x) <= _LARGEST for x in one):
                return one
        found = np.asarray(self.number(value, what))
        if not found.ndim or found.shape[-1] != size:
            raise InputError(f"{what} needs {size} coordinates along its last axis, not the shape {found.shape}")
        return tuple(found[..., i] for i in range(size)) if found.ndim > 1 else tuple(map(float, found))

    def read(self, rows: Any, width: int = 6) -> Matrix:
        found = np.asarray(self.number(rows, "the matrix"))
        if found.shape == (0,):
            found = found.reshape(0, width)
        if found.ndim < 2 or found.shape[-1] != width:
            raise InputError(f"an array of shape (..., rows, {width}) is needed, not {found.shape}")
        return found

    def matrix(self, rows: Sequence[Row]) -> Matrix:
        if not rows:
            return np.zeros((0, 6))
        if all(isinstance(x, float) for row in rows for x in row):
            return np.array(rows, dtype=float)
        shape = _common_shape((np.shape(x) for row in rows for x in row), "the screws")
        made = np.empty((*shape, len(rows), len(rows[0])))
        for i, row in enumerate(rows):
            for j, x in enumerate(row):
                made[..., i, j] = x
        return made

    def rows(self, matrix: Matrix) -> tuple[Row, ...]:
        found = np.asarray(matrix, dtype=float)
        if found.ndim != 2:
            raise InputError(
                f"one configuration is needed, not an array of shape {found.shape}",
                hint="take the configurations one by one; ranks, wrenches and Jacobians take all at once",
            )
        return tuple(tuple(map(float, row)) for row in found)

    def _ranks(self, sizes: _Array) -> NDArray[np.int64]:
        largest = np.maximum(1.0, sizes.max(axis=-1, initial=0.0))
        return np.asarray((sizes > self.tolerance * largest[..., None]).sum(axis=-1))

    def rank(self, matrix: Matrix) -> Any:
        found = self._ranks(np.linalg.svd(np.asarray(matrix, dtype=float), compute_uv=False))
        return found if found.ndim else int(found)

    def basis(self, matrix: Matrix) -> Matrix:
        """Orthonormal; with many configurations as many rows as the largest rank."""
        return self._split(matrix)[0]

    def complement(self, matrix: Matrix) -> Matrix:
        return self.basis(matrix)

    def kernel(self, matrix: Matrix, width: int = 6) -> Matrix:
        """Orthonormal; with many configurations as many rows as the smallest kernel has, those that fit best."""
        return self._split(np.reshape(matrix, (*matrix.shape[:-2], 0, width)) if not matrix.shape[-2] else matrix)[1]

    def _split(self, matrix: Matrix) -> tuple[_Array, _Array]:
        _, sizes, right = np.linalg.svd(np.asarray(matrix, dtype=float), full_matrices=True)
        rank = int(self._ranks(sizes).max(initial=0))
        return right[..., :rank, :], right[..., rank:, :]

    def determinant(self, matrix: Matrix) -> Any:
        found = np.linalg.det(np.asarray(matrix, dtype=float))
        return found if np.ndim(found) else float(found)

    def projection(self, basis: Matrix, vector: Row) -> Row:
        stacked = self.matrix([vector])[..., 0, :]
        found = np.einsum("...ki,...k->...i", basis, np.einsum("...ki,...i->...k", basis, stacked))
        return tuple(found[..., i] for i in range(found.shape[-1]))

    def row(self, matrix: Matrix, place: int) -> Row:
        return tuple(matrix[..., place, j] for j in range(matrix.shape[-1]))

    def chosen(self, matrix: Matrix, places: Sequence[int]) -> Matrix:
        return matrix[..., list(places), :]

    def height(self, matrix: Matrix) -> int:
        return int(matrix.shape[-2])

    def go_together(self, values: Iterable[Any], what: str) -> None:
        _common_shape(
            (np.shape(x) for value in values for x in (value if isinstance(value, tuple) else (value,))), what
        )

    def packed(self, row: Row) -> Any:
        found = self.matrix([row])[..., 0, :]
        return found if found.ndim > 1 else tuple(map(float, found))

    def scaled_field(self) -> Field:
        return replace(self, length=1.0)

    def scaled(self, screws: Matrix) -> Matrix:
        return screws if self.length == 1 else screws / self._units

    def unscaled(self, screws: Matrix) -> Matrix:
        return screws if self.length == 1 else screws * self._units

    @property
    def _units(self) -> _Array:
        return np.array([1.0, 1.0, 1.0, self.length, self.length, self.length])

    def comparable(self, screws: Matrix) -> Matrix:
        """Rows of zeros stay."""
        rows = self.scaled(np.asarray(screws, dtype=float))
        sizes = np.sqrt(np.einsum("...i,...i->...", rows, rows))[..., None]
        return rows / np.where(sizes == 0, 1.0, sizes)

    def joined(self, parts: Sequence[Matrix]) -> Matrix:
        shape = _common_shape((part.shape[:-2] for part in parts), "the limbs")
        return np.concatenate([np.broadcast_to(part, shape + part.shape[-2:]) for part in parts], axis=-2)

    def spread(self, matrix: Matrix, shares: Sequence[Sequence[int]]) -> Matrix:
        every = matrix[..., None, :] * np.array(shares, dtype=float)[..., None]
        return every.reshape(*every.shape[:-2], -1)

    def cut(self, matrix: Matrix, width: int) -> Matrix:
        return matrix[..., :width]

    def is_zero(self, x: Any) -> bool:
        return bool(np.all(np.abs(x) <= self.tolerance))

    def are_zero(self, components: Sequence[Any]) -> bool:
        """Whether the vector of these components is exactly zero in any of the configurations."""
        return bool(np.any(sum(np.square(x) for x in components) == 0))

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        found = np.where(condition, yes, no)
        return found if found.ndim else float(found)

    def vanishes(self, x: Any, beside: Any) -> Any:
        return np.abs(x) <= self.tolerance**2 * np.abs(beside)

    def is_couple(self, force: Vector, moment: Vector) -> Any:
        """Whether the force is at most `tolerance` times the moment divided by `length`."""
        return self.dot(force, force) * self.length**2 <= self.tolerance**2 * self.dot(moment, moment)

    def are_parallel(self, a: Vector, b: Vector) -> bool:
        sine, one, two = (self.dot(v, v) for v in (self.cross(a, b), a, b))
        return bool(np.any(sine <= self.tolerance**2 * one * two))

    def quotient(self, x: Any, y: Any) -> Any:
        with np.errstate(divide="ignore", invalid="ignore"):
            found = np.divide(x, y)
        return found if np.ndim(found) else float(found)

    def sign(self, x: Any) -> int | None:
        return int(np.sign(x))

    def root(self, x: Any) -> Any | None:
        return float(np.sqrt(x)) if x >= 0 else None

    def simplest(self, vector: Row, unit: int | None = None) -> Row:
        """The first component that is not within the tolerance of zero is positive; those that are become zero."""
        size = sum(x * x for x in vector[:unit]) ** 0.5
        within = self.tolerance * max(map(abs, vector))
        size = -size if next(x for x in vector if abs(x) > within) < 0 else size
        return tuple(0.0 if abs(x) <= within else float(x / size) for x in vector)

    def normal_pair(self, a: Vector) -> tuple[Vector, Vector]:
        """As for exact numbers, but the products with the two axes that are furthest from the vector."""
        if not any(map(np.ndim, a)):
            u, v, w = map(float, a)
            rows = ((0.0, w, -v), (-w, 0.0, u), (v, -u, 0.0))
            most = max(range(3), key=lambda k: abs(a[k]))
            return rows[(most + 1) % 3], rows[(most + 2) % 3]
        x, y, z = np.broadcast_arrays(*a)
        zero = np.zeros_like(x)
        around = np.stack([np.stack([zero, z, -y]), np.stack([-z, zero, x]), np.stack([y, -x, zero])])
        largest = np.argmax(np.abs(np.stack([x, y, z])), axis=0)
        pair = []
        for k in (1, 2):
            place = np.broadcast_to(((largest + k) % 3)[None, None], (1, *around.shape[1:]))
            u = np.take_along_axis(around, place, axis=0)[0]
            pair.append((u[0], u[1], u[2]))
        return pair[0], pair[1]


def _common_shape(shapes: Iterable[tuple[int, ...]], what: str) -> tuple[int, ...]:
    known = set(shapes)
    try:
        return np.broadcast_shapes(*known)
    except ValueError:
        listed = ", ".join(map(str, sorted(known)))
        raise InputError(
            f"the configurations of {what} do not go together: their arrays have the shapes {listed}"
        ) from None


FLOATS = Floats()
"""Tolerance 1e-9, length 1."""
