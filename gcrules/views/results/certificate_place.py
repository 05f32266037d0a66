"""The pose through which slices of a certificate's range pass."""

from __future__ import annotations

from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.poses.certificates.certificate import Certificate
from gcrules.poses.maps.cells import CROSSED, UNDECIDED

__all__ = ["ShownPlace", "shown_place"]


@dataclass(frozen=True)
class ShownPlace:
    """A pose that slices of the range pass through, by its coordinates in the units of the axes; what it is in words;
    whether it is marked.
    """

    place: tuple[float, ...]
    words: str
    marked: bool


def shown_place(c: Certificate) -> ShownPlace:
    """The pose that matters most: one that is singular, or the largest box that is not decided, or the one with the
    smallest margin.
    """
    if c.bad is not None:
        return ShownPlace(c.bad.place, "a singular pose" if c.bad.ends else "a pose below the margin", True)
    leaves = c.leaves()
    left = [k for k, status in enumerate(leaves.status) if status in (CROSSED, UNDECIDED)]
    if left:
        largest = max(left, key=lambda k: float(leaves.shares[k]))
        return ShownPlace(
            _units(c, leaves.boxes.middles[largest]), "the middle of the largest box that is undecided", False
        )
    if c.place is not None:
        return ShownPlace(c.place, "the pose with the smallest margin that was seen", True)
    return ShownPlace(_units(c, c.task.box(0).middles[0]), "the middle of the range", False)


def _units(c: Certificate, place: Any) -> tuple[float, ...]:
    return tuple((place / c.task.units).tolist())
