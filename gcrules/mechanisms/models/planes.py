"""Mechanisms in a plane: its normal, and ball joints that the other joints leave one turn, that across the plane."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import networkx as nx
import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.motions import Motion

__all__ = ["Balls", "as_hinges", "balls_in_plane", "normal_of", "turn_to_z"]


def normal_of(motions: Sequence[Motion]) -> Floats | None:
    """The normal of the plane of all motions, if they are in one plane."""
    turns = [m.axis for m in motions if m.kind == "R"]
    slides = [m.axis for m in motions if m.kind == "P"]
    if not turns or len(turns) + len(slides) < len(motions):
        return None
    flat = all(np.linalg.norm(np.cross(turns[0], t)) < 1e-9 for t in turns)
    return turns[0] if flat and all(abs(turns[0] @ s) < 1e-9 for s in slides) else None


@dataclass(frozen=True, eq=False)
class Balls:
    """So many ball joints between bodies that move in a plane with this normal."""

    count: int
    normal: Floats

    @property
    def text(self) -> str:
        one = "a ball joint is taken as a hinge"
        what = one if self.count == 1 else f"{self.count} ball joints are taken as hinges"
        return f"{what}: the other joints hold all bodies in one plane"


def balls_in_plane(motions: Sequence[Motion]) -> Balls | None:
    """The ball joints of a mechanism whose other joints join all bodies, and let them move in one plane only."""
    others = [m for m in motions if m.kind != "S"]
    normal = normal_of(others)
    if normal is None or len(others) == len(motions):
        return None
    held: nx.Graph[str] = nx.Graph([(m.start, m.end) for m in others])
    bodies = {b for m in motions for b in (m.start, m.end)}
    if {*held} != bodies or not nx.is_connected(held):
        return None
    return Balls(len(motions) - len(others), normal)


def as_hinges(motions: Sequence[Motion], balls: Balls) -> tuple[Motion, ...]:
    return tuple(replace(m, kind="R", axis=balls.normal) if m.kind == "S" else m for m in motions)


def turn_to_z(normal: Floats) -> Floats:
    """A turn that takes a direction to z; x stays where it is if it can."""
    z = normal if normal.sum() > 0 else -normal
    x = np.eye(3)[np.argmin(np.abs(z).round(9))]
    x = x - z * (x @ z)
    x /= np.linalg.norm(x)
    return np.array([x, np.cross(z, x), z])
