"""Choices among numbers that are equal but for their rounding, as those of poses that a symmetry of the robot takes to
each other are: the first of them is chosen, so that answers are the same on all machines.

>>> lowest(np.array([0.5, 0.3 + 1e-16, 0.3])), highest(np.array([[2.0, 1.0], [2.0 + 1e-15, 3.0]])).tolist()
(1, [0, 1])
>>> upwards(np.array([0.3 + 1e-16, 0.5, 0.3, 0.1])).tolist()
[3, 0, 2, 1]
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

__all__ = ["LOWER", "highest", "lowest", "upwards"]

Floats = NDArray[np.float64]

LOWER = 1 - 1e-9
"""A number is lower than another one where it is so by this factor; nearer ones differ by rounding."""
_BITS = 2.0**30


def lowest(numbers: Floats) -> int:
    """The place of the lowest of some numbers ≥ 0 (N,)."""
    return int(np.argmax(numbers * LOWER <= numbers.min()))


def highest(numbers: Floats) -> NDArray[np.intp]:
    """The places (N,) of the highest of each column of numbers ≥ 0 (n, N)."""
    return np.asarray(np.argmax(numbers >= numbers.max(axis=0) * LOWER, axis=0))


def upwards(numbers: Floats) -> NDArray[np.intp]:
    """The places of numbers (N,) in their order, equal ones as they stand."""
    fraction, exponent = np.frexp(numbers)
    return np.argsort(np.ldexp(np.round(fraction * _BITS), exponent), kind="stable")
