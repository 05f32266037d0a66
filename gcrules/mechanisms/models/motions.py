"""The joints of a model between two bodies as motions one after the other: turns, slides, screws, ball joints."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.graph import Graph
from gcrules.mechanisms.models.model import ModelJoint

__all__ = ["Motion", "motions_of"]

_KINDS = {
    "revolute": "R",
    "prismatic": "P",
    "screw": "H",
    "cylindrical": "C",
    "universal": "R",
    "ball": "S",
    "planar": "E",
}


@dataclass(frozen=True, eq=False)
class Motion:
    """One motion of a joint, from body `start` to body `end`: of kind R, P, H, C, S or E as in robot files. A universal
    joint is two turns, `place` 0 and 1, with a body between them.
    """

    joint: str
    kind: str
    start: str
    end: str
    at: Floats
    axis: Floats  # of length 1; zeros of a ball joint
    pitch: float = 0.0
    driven: bool = False
    place: int = 0

    @property
    def has_line(self) -> bool:
        """Whether its axis is a line, not a direction alone."""
        return self.kind in ("R", "H", "C")

    @property
    def screws(self) -> Floats:
        """Its twists (n, 6), rows (ω; v)."""
        x, y, z = np.eye(3)
        turn = np.concatenate([self.axis, np.cross(self.at, self.axis) + self.pitch * self.axis])
        slide = np.concatenate([np.zeros(3), self.axis])
        match self.kind:
            case "S":
                return np.array([np.concatenate([t, np.cross(self.at, t)]) for t in (x, y, z)])
            case "P":
                return np.array([slide])
            case "C":
                return np.array([turn, slide])
            case "E":
                across = np.cross(self.axis, np.eye(3)[np.argmin(np.abs(self.axis))])
                across /= np.linalg.norm(across)
                others = (across, np.cross(self.axis, across))
                return np.array([*(np.concatenate([np.zeros(3), t]) for t in others), turn])
            case _:
                return np.array([turn])

    def backwards(self) -> Motion:
        """The same as seen from the other body, along the same axis."""
        return replace(self, start=self.end, end=self.start)


def motions_of(graph: Graph, names: Collection[str], driven: Collection[str]) -> tuple[Motion, ...]:
    """The motions of the joints with these names. Raises InputError where a joint is driven that cannot be."""
    found: list[Motion] = []
    for j in graph.joints:
        if j.name in names:
            if j.name in driven and j.kind in ("ball", "planar"):
                raise InputError(
                    f"joint {j.name} (line {j.line}) is {'a ball joint' if j.kind == 'ball' else 'planar'},"
                    " and cannot be driven",
                    hint="name what is driven: --actuators a,b,c",
                )
            found += _motions(j, graph.body[j.parent], graph.body[j.child], driven=j.name in driven)
    return tuple(found)


def _motions(j: ModelJoint, start: str, end: str, *, driven: bool) -> Iterator[Motion]:
    at = np.array(j.at)
    if not j.axes:
        yield Motion(j.name, _KINDS[j.kind], start, end, at, np.zeros(3), driven=driven)
    bodies = [start, *(f"{j.name} cross" for _ in j.axes[1:]), end]
    for place, axis in enumerate(j.axes):
        own = np.array(axis) / np.linalg.norm(axis)
        yield Motion(j.name, _KINDS[j.kind], bodies[place], bodies[place + 1], at, own, j.pitch, driven, place)
