r"""From the places of a robot to those on the page: the ball around it, and the frame of a drawing."""

from __future__ import annotations

from collections.abc import Sequence
from math import dist
from typing import SupportsFloat

from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.bsp import XYZ, dot
from gcrules.views.drawing.drawing import XY
from gcrules.views.drawing.solids import center
from gcrules.views.drawing.viewpoint import View

__all__ = ["Frame", "Unit", "framed"]


@dataclass(frozen=True, slots=True)
class Unit:
    """A ball around the robot: its middle is the origin and its radius 1, so that distances need no unit."""

    middle: XYZ
    radius: float

    @classmethod
    def of(cls, points: Sequence[XYZ]) -> Unit:
        """The ball around the mean of points."""
        middle = center(points)
        return cls(middle, max((dist(p, middle) for p in points), default=0.0) or 1.0)

    def place(self, p: Sequence[SupportsFloat]) -> XYZ:
        """A point in this unit."""
        x, y, z = ((float(c) - m) / self.radius for c, m in zip(p, self.middle, strict=True))
        return x, y, z


@dataclass(frozen=True, slots=True)
class Frame:
    """From space to the page: `scale` points for each unit; signs of joints are drawn at `size`."""

    view: View
    scale: float
    shift: XY
    size: float = 1.0

    @property
    def point(self) -> float:
        """The length in space of a point of the page, for signs."""
        return self.size / self.scale

    def place(self, p: XYZ) -> XY:
        """The place of a point on the page."""
        x, y = self.view.flat(p)
        return self.scale * x + self.shift[0], self.scale * y + self.shift[1]

    def sight(self, p: XYZ) -> float:
        """How near to the viewer a point is."""
        return round(dot(p, self.view.eye), 6)


def framed(view: View, corners: Sequence[XYZ], width: float, height: float, margin: float, top: float = 0.0) -> Frame:
    """The frame in which these places fill a page of this size up to its margin, below a heading down to `top`."""
    flat = [view.flat(c) for c in corners]
    left, right = min(x for x, _ in flat), max(x for x, _ in flat)
    high, low = min(y for _, y in flat), max(y for _, y in flat)
    room = (width - 2 * margin, height - top - 2 * margin)
    scale = min(room[0] / ((right - left) or 1e-9), room[1] / ((low - high) or 1e-9))
    middle = (width / 2, top + (height - top) / 2)
    return Frame(view, scale, (middle[0] - scale * (left + right) / 2, middle[1] - scale * (high + low) / 2))
