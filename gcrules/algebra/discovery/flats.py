"""Lines and planes of a figure at a position, with the points that are known to lie on them."""

from __future__ import annotations

from dataclasses import field

from gcrules.algebra.discovery.figure import Vector
from gcrules.core.dataclass import dataclass

__all__ = ["Flat"]


@dataclass(eq=False)
class Flat:
    """A line, plane, … with a basis of its points; `members` are names of points that are known to lie on it. One that
    nothing in the figure names is the polar of a point for a `letter`.
    """

    span: tuple[Vector, ...]
    members: set[str] = field(default_factory=set)
    letter: str = ""

    @property
    def step(self) -> int:
        return len(self.span)
