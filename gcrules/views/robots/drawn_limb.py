"""What is drawn of a limb in space: its joints, its links and rails, and where it begins and ends."""

from __future__ import annotations

from dataclasses import field
from typing import NamedTuple

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec
from gcrules.views.drawing.bsp import XYZ, dot

__all__ = ["DrawnJoint", "DrawnLimb", "Rail", "Rod", "plus", "unit_vector"]


@dataclass(frozen=True, slots=True)
class DrawnJoint:
    """A joint where it is drawn, with unit vectors along its axes."""

    kind: str
    at: XYZ
    axes: tuple[XYZ, ...] = ()
    driven: bool = False


@dataclass(frozen=True, slots=True)
class Rod:
    """A link, a `bar` (thinner), a `tube` (thicker), a `rail` or an `axis` from one place to another."""

    start: XYZ
    end: XYZ
    look: str = "link"


class Rail(NamedTuple):
    """How far a rail reaches from its carriage against its axis and along it, and which of its ends stands on the base:
    0 for that against the axis, 1 for the other.
    """

    low: float
    high: float
    grounded: int


@dataclass
class DrawnLimb:
    """A limb in space, or one of its chains: its joints, its strokes, and its first and last place; from which body it
    leads to which; `normals` are those of its parallelograms and arcs, `around` is the point through which all its axes
    pass, `spheres` are the radii on which its links move about it, `rails` how those under it lie.
    """

    limb: LimbSpec
    joints: tuple[JointSpec, ...]
    start: str = BASE
    end: str = PLATFORM
    places: list[DrawnJoint] = field(default_factory=list)
    strokes: list[Rod] = field(default_factory=list)
    normals: list[XYZ] = field(default_factory=list)
    foot: XYZ = (0.0, 0.0, 0.0)
    head: XYZ = (0.0, 0.0, 0.0)
    around: XYZ | None = None
    spheres: tuple[float, ...] = ()
    rails: list[Rail] = field(default_factory=list)


def plus(p: XYZ, u: XYZ, s: float = 1.0) -> XYZ:
    """p + s·u."""
    return p[0] + s * u[0], p[1] + s * u[1], p[2] + s * u[2]


def unit_vector(v: XYZ) -> XYZ:
    """The unit vector along a vector that is not zero."""
    length = dot(v, v) ** 0.5 or 1.0
    return v[0] / length, v[1] / length, v[2] / length
