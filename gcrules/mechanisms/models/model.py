"""A model of links and joints, of whatever format: the value between the readers of model files and robot files.

All places are those of the model's home, its joints at the values that it gives them, in the frame of its base.
Lengths are metres, angles radians.
"""

from __future__ import annotations

from gcrules.core.dataclass import dataclass

__all__ = ["AXES", "Model", "ModelCoupling", "ModelJoint", "Vector"]

Vector = tuple[float, float, float]

# How many axes a joint of each kind has: of a planar one the normal of its plane.
AXES = {
    "fixed": 0,
    "revolute": 1,
    "prismatic": 1,
    "cylindrical": 1,
    "screw": 1,
    "universal": 2,
    "ball": 0,
    "planar": 1,
    "free": 0,
}


@dataclass(frozen=True)
class ModelJoint:
    """A joint between two links: its centre, its axes (of length 1), and the limits of its value from home, of a ball
    those of its angle.
    """

    name: str
    kind: str  # of AXES
    parent: str
    child: str
    at: Vector
    axes: tuple[Vector, ...] = ()
    limits: tuple[float, float] | None = None
    pitch: float = 0.0  # of a screw: metres for each radian
    closing: bool = False  # it closes a loop, and is no joint of the tree of links
    line: int = 1  # where the file has it
    column: int = 1


@dataclass(frozen=True)
class ModelCoupling:
    """The value of one joint follows that of another: value = ratio · value of `leader`, both measured from home."""

    joint: str
    leader: str
    ratio: float


@dataclass(frozen=True)
class Model:
    """Links, the base first, the joints between them, which of these are driven, and which follow others; `notes` are
    what is to be said of its home.
    """

    name: str
    format: str  # urdf, sdf or mjcf
    filename: str
    links: tuple[str, ...]
    joints: tuple[ModelJoint, ...]
    actuated: tuple[str, ...] = ()
    couplings: tuple[ModelCoupling, ...] = ()
    notes: tuple[str, ...] = ()
