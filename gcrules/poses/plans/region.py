r"""Where poses of a plan may lie: ranges of coordinates, from home.

>>> region = Region(("x", "turn"), (-1.0, 0.0), (1.0, 0.5), (False, True))
>>> region.text("mm"), region.holds([[0.5, 0.2], [2.0, 0.2]]).tolist()
('-1 ≤ x ≤ 1 mm, 0 ≤ turn ≤ 28.6479 deg', [True, False])
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limits import LengthLimits, parse_limits
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Region", "Truths"]

Truths = NDArray[np.bool_]

_TURN = 2 * np.pi * (1 - 1e-12)


@dataclass(frozen=True)
class Region:
    """The least and the largest value of each coordinate, from home: rad where it is an angle, else the file's unit."""

    names: tuple[str, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    angles: tuple[bool, ...]

    def within(self, text: str | None, unit: str = "") -> Region:
        """With the ranges that a user gives, in place of its own ones. Raises InputError."""
        if text is None:
            return self
        given = parse_limits(text, self.names, unit, self.angles, noun="coordinate", option="--within")
        low = tuple(np.where(np.isinf(given.low), self.low, given.low).tolist())
        high = tuple(np.where(np.isinf(given.high), self.high, given.high).tolist())
        return Region(self.names, low, high, self.angles)

    def clipped(self, name: str, low: float, high: float) -> Region:
        """With no values of this coordinate, if it is one of them, beyond those."""
        mine = [n == name for n in self.names]
        return Region(
            self.names,
            tuple(max(v, low) if m else v for v, m in zip(self.low, mine, strict=True)),
            tuple(min(v, high) if m else v for v, m in zip(self.high, mine, strict=True)),
            self.angles,
        )

    def around(self, values: Floats, room: Floats) -> Region:
        """Widened so that it holds values (N, names) with some room (names,)."""
        low = np.minimum(self.low, (values - room).min(axis=0))
        high = np.maximum(self.high, (values + room).max(axis=0))
        return Region(self.names, tuple(low.tolist()), tuple(high.tolist()), self.angles)

    def holds(self, values: Any) -> Truths:
        """Which values (N, names) lie in it, but for rounding; all those of an angle whose range is a whole turn."""
        found = np.asarray(values)
        room = 1e-12 * np.maximum(np.abs(self.low), np.abs(self.high))
        inside = (found >= self.low - room) & (found <= self.high + room)
        return np.asarray((inside | self._whole_turns()).all(axis=1))

    def _whole_turns(self) -> Truths:
        return np.array(self.angles) & (np.subtract(self.high, self.low) >= _TURN)

    def drawn(self, random: np.random.Generator, number: int) -> Floats:
        """Values (number, names) at random."""
        return random.uniform(self.low, self.high, (number, len(self.names)))

    def text(self, unit: str = "") -> str:
        """The ranges in words."""
        return LengthLimits(self.names, self.low, self.high, unit, self.angles).text
