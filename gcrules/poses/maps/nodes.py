r"""The nodes of a map: all combinations of the nodes of its axes; and what is said of the other coordinates.

>>> from gcrules.poses.maps.axes import read_axes
>>> nodes = Nodes(read_axes(["x -2:2:5", "yaw 0:90:4 deg"]))
>>> nodes.shape, nodes.size
((5, 4), 20)
>>> nodes.coordinates(np.array([[0, 0], [4, 1.5]])).tolist()
[[-2.0, 0.0], [2.0, 45.0]]
>>> in_words(others(nodes.axes, ("x", "y", "yaw"), (0.0, 0.25, 0.0)), "mm")
'y = 0.25 mm'
"""

from __future__ import annotations

import math
from collections.abc import Container, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.poses.maps.axes import TURNS, GridAxis

__all__ = ["Nodes", "in_words", "others"]

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Nodes:
    """All combinations of the nodes of `axes`, the last of which changes fastest."""

    axes: tuple[GridAxis, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(a.number for a in self.axes)

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    def coordinates(self, nodes: NDArray[Any]) -> Floats:
        """The coordinates (N, axes), in the units of the axes, of places (N, axes) that are counted in nodes."""
        return np.stack([a.at(nodes[:, k]) for k, a in enumerate(self.axes)], axis=1)

    def places(self, coordinates: Floats) -> Floats:
        """The places (N, axes), counted in nodes, of coordinates (N, axes) in the units of the axes."""
        start, step = np.array([(float(a.start), float(a.step)) for a in self.axes]).T
        return np.asarray((coordinates - start) / step)


def others(axes: Sequence[GridAxis], names: Sequence[str], values: Sequence[float]) -> dict[str, float]:
    """The values of those coordinates for which no axis stands."""
    over = {a.name for a in axes}
    return {n: v for n, v in zip(names, values, strict=True) if n not in over}


def in_words(values: Mapping[str, float], unit: str = "", angles: Container[str] = TURNS) -> str:
    """Coordinates, in radians and the file's unit, as text: `angles` in degrees, the others in that unit, 0 without."""
    return ", ".join(
        f"{n} = {math.degrees(v):.6g}°" if n in angles else f"{n} = {v:.6g} {unit if v else ''}".rstrip()
        for n, v in values.items()
    )
