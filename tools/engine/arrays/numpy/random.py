"""Random whole numbers."""

import math
from random import Random

from .ndarray import int64, ndarray

__all__ = ["default_rng"]


class Generator:
    def __init__(self, seed):
        self._random = Random(seed)

    def integers(self, low, high, size):
        shape = (size,) if isinstance(size, int) else size
        return ndarray([self._random.randrange(low, high) for _ in range(math.prod(shape))], shape, int64)


def default_rng(seed=None):
    return Generator(seed)
