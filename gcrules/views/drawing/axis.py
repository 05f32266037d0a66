r"""An axis of a drawing: numbers as places on the paper, and round numbers to be written along it."""

from __future__ import annotations

import math

from gcrules.core.dataclass import dataclass

__all__ = ["Axis"]


@dataclass(frozen=True)
class Axis:
    """Values from `low` to `high` between two places on the paper."""

    low: float
    high: float
    start: float
    end: float

    def __call__(self, value: float) -> float:
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)

    def ticks(self, about: int, whole: bool = False) -> list[float]:
        """Round values, about so many."""
        step = 10 ** math.floor(math.log10((self.high - self.low) / about))
        step = next(step * m for m in (1, 2, 5, 10) if (self.high - self.low) / (step * m) <= about)
        step = max(step, 1.0) if whole else step
        first = math.ceil(self.low / step - 1e-9)
        return [step * k for k in range(first, math.floor(self.high / step + 1e-9) + 1)]
