r"""Many poses as a user gives them: shapes are checked at once, numbers chunk by chunk, and nothing large is copied."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.poses.numbers.arrays import real_numbers
from gcrules.screws.pose import UNIT_TOLERANCE

__all__ = ["Batch", "joint_batch", "output", "pose_batch"]

Array = NDArray[Any]
Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Batch:
    """Arrays whose first axis counts the poses, of any kind of real numbers; the first one stands for itself.

    `unit` says that the second one holds quaternions, whose length must be 1.
    """

    number: int
    arrays: tuple[Array, ...]
    unit: bool = False

    def columns(self, start: int, stop: int) -> tuple[Floats, Floats]:
        """These poses as two arrays of floats, (n, k) and (n, m): views where that can be."""
        n = stop - start
        parts = [np.asarray(a[start:stop], dtype=np.float64).reshape(n, a[0].size) for a in self.arrays]
        if len(parts) > 2:
            parts = [np.concatenate(parts, axis=1)]
        first, second = parts if len(parts) == 2 else (parts[0], np.empty((n, 0)))
        if self.unit:
            _check_unit(second, start)
        return first, second

    def check(self, start: int, first: Floats, second: Floats, values: Floats, unused: Sequence[int]) -> None:
        """Raise InputError for numbers that are not finite: what is NaN or infinite among the inputs makes the value
        so too, whatever is done with it, unless it is `unused`.
        """
        width = first.shape[1]
        ignored = [first[:, k] if k < width else second[:, k - width] for k in unused]
        with np.errstate(all="ignore"):
            if all(np.isfinite(column.sum()) for column in (values, *ignored)):
                return
        if all(np.isfinite(column).all() for column in (values, *ignored)):  # only their sum is beyond floats
            return
        for part in (first, second):
            wrong = ~np.isfinite(part).all(axis=1)
            if wrong.any():
                n = int(np.argmax(wrong))
                raise InputError(f"pose {start + n} is not finite: {part[n].tolist()}")
        n = int(np.argmax(~np.isfinite(values)))
        raise InputError(f"the value in pose {start + n} is beyond the range of floats", hint="use a larger unit")


def _check_unit(quaternions: Floats, start: int) -> None:
    squares = np.einsum("ij,ij->i", quaternions, quaternions)
    wrong = ~(np.abs(np.sqrt(squares) - 1) <= UNIT_TOLERANCE)  # NaN is wrong too
    if wrong.any():
        n = int(np.argmax(wrong))
        raise InputError(
            f"quaternion {start + n} has length {np.sqrt(squares[n]):.6g}, expected 1 (within {UNIT_TOLERANCE:g})",
            hint="divide by the length; the order is w x y z, w the cosine of half the angle",
        )


def pose_batch(translations: Any, rotations: Any, quaternions: Any) -> Batch:
    """Translations and turns; one row stands for all, None for no motion. Raises InputError for wrong shapes."""
    shifts = _rows([0.0, 0.0, 0.0] if translations is None else translations, (3,), "translations")
    if quaternions is not None:
        turns = _rows(quaternions, (4,), "quaternions")
    else:
        turns = _rows(np.eye(3) if rotations is None else rotations, (3, 3), "rotations")
    return Batch(*_together({"translations": shifts, "turns": turns}), unit=quaternions is not None)


def joint_batch(points: Any, names: Sequence[str]) -> Batch:
    """Coordinates of the joints that move, by name or in one array. Raises InputError for wrong names and shapes."""
    if not isinstance(points, Mapping):
        found = _rows(points, (len(names), 3), "joints")
        return Batch(len(found), (found,))
    if set(points) != set(names):
        raise InputError(
            f"coordinates of {', '.join(map(str, points)) or 'no joint'}", hint=f"give those of {', '.join(names)}"
        )
    return Batch(*_together({n: _rows(points[n], (3,), f"joint {n}: coordinates") for n in names}))


def _together(arrays: Mapping[str, Array]) -> tuple[int, tuple[Array, ...]]:
    """The number of poses, and the arrays with single rows repeated (without being copied)."""
    numbers = {len(a) for a in arrays.values()} - {1}
    if len(numbers) > 1:
        raise InputError(f"{' but '.join(f'{len(a)} {name}' for name, a in arrays.items())}")
    number = numbers.pop() if numbers else 1
    return number, tuple(np.broadcast_to(a, (number, *a.shape[1:])) for a in arrays.values())


def _rows(given: Any, shape: tuple[int, ...], what: str) -> Array:
    """An array (N, …) of real numbers; one of the shape itself is a single row."""
    expected = f"give an array of shape (N, {', '.join(map(str, shape))})"
    found = real_numbers(given, what, expected)
    if found.size == 0 and found.shape in ((0,), (0, *shape)):
        return np.empty((0, *shape))
    if found.shape == shape:
        found = found[None]
    if found.shape[1:] != shape:
        raise InputError(f"{what} of shape {found.shape}", hint=expected)
    return found


def output(batch: Batch, out: Any) -> Floats:
    """Where the values go. Raises InputError for an `out` of another shape or kind, or in the memory of the poses."""
    if out is None:
        return np.empty(batch.number)
    if not isinstance(out, np.ndarray) or out.dtype != np.float64 or out.shape != (batch.number,):
        raise InputError("out is not an array of floats for these poses", hint=f"np.empty({batch.number})")
    if not out.flags.writeable or any(np.may_share_memory(out, a) for a in batch.arrays):
        raise InputError("out cannot be written to, or shares its memory with the poses")
    return out
