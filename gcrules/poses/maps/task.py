"""What a map is made of: the slice of poses and the task over it, of any kind of mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.tiles.task import Stage

if TYPE_CHECKING:
    from gcrules.poses.maps.slices import SliceFactor
    from gcrules.poses.maps.summary import MapSummary

__all__ = ["KINDS", "MEASURES", "Chunk", "InLayers", "MapTask", "Slice", "width_of"]

Floats = NDArray[np.float64]
Chunk = Mapping[str, NDArray[Any]]

KINDS: Mapping[str, Any] = {
    "superbracket": np.float64,
    "margin": np.float32,
    "sign": np.int8,
    "leg_length": np.float32,
    "actuator": np.float32,
    "allowed": np.uint8,
    "cell_status": np.uint8,
    **dict.fromkeys(INDICES, np.float32),
}
"""The arrays that a chunk can have, and their types."""


MEASURES = ("margin", "value", *INDICES)
"""What a map can be of: the margin, the superbracket alone, or the margin and an index of the actuators."""


class Slice(Protocol):
    """The poses of a map: its `axes`, and `rest`, what the other coordinates are, in words; `fixed` are these one by
    one, for pictures, empty where there are none.

    `title` and `unit` are those of the mechanism, `actuators` the names of its legs or actuators, `angles_driven` which
    of these turn; `home` is the given pose in the axes' coordinates (not a number where it is not in the slice),
    `moved` whether it is another one than that of the file.
    """

    @property
    def axes(self) -> tuple[GridAxis, ...]: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def size(self) -> int: ...
    @property
    def home(self) -> tuple[float, ...]: ...
    @property
    def title(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def actuators(self) -> tuple[str, ...]: ...
    @property
    def rest(self) -> str: ...
    @property
    def fixed(self) -> str: ...
    @property
    def moved(self) -> bool: ...
    @property
    def angles_driven(self) -> tuple[bool, ...]: ...
    @property
    def notes(self) -> tuple[str, ...]: ...

    def coordinates(self, nodes: NDArray[Any]) -> Floats:
        """The coordinates (N, axes) of places (N, axes) that are counted in nodes."""
        ...

    def to_json(self) -> dict[str, Any]: ...


class MapTask(Protocol):
    """What is computed over a slice, in chunks of whole layers along the first axis.

    `measure` is margin, value, or an index of the actuators; `limits` are those of legs or actuators; `factors` are the
    exact ones of the condition on the slice, None where it is no polynomial; `everywhere` says that every pose is
    singular; `names` are the arrays of each chunk; zeros are brought nearer by so many `halvings`; `beyond` says what
    poses that are not allowed are, `accuracy` how curves are found, `guard` what a margin guarantees; `stage` is what
    comes before all chunks, None for nothing.
    """

    @property
    def grid(self) -> Slice: ...
    @property
    def measure(self) -> str: ...
    @property
    def limits(self) -> LengthLimits | None: ...
    @property
    def factors(self) -> tuple[SliceFactor, ...] | None: ...
    @property
    def everywhere(self) -> bool: ...
    @property
    def names(self) -> tuple[str, ...]: ...
    @property
    def layers(self) -> int: ...
    @property
    def number(self) -> int: ...
    @property
    def halvings(self) -> int: ...
    @property
    def beyond(self) -> str: ...
    @property
    def accuracy(self) -> str: ...
    @property
    def guard(self) -> str: ...
    @property
    def manifest(self) -> dict[str, Any]: ...
    @property
    def stage(self) -> Stage | None: ...

    def span(self, chunk: int) -> tuple[int, int]:
        """The layers of a chunk, the first one and the one after the last."""
        ...

    def compute(self, chunk: int) -> Chunk:
        """All arrays of a chunk."""
        ...

    def level(self, chunk: Chunk) -> Floats:
        """What changes its sign at singular poses, at the nodes of a chunk; not a number where it is not known."""
        ...

    def value(self, places: Floats) -> Floats:
        """The same at places (N, axes) that are counted in nodes."""
        ...

    def spare(self, coordinates: Floats) -> Floats:
        """By how much poses (N, axes) keep to the limits; below 0: not, or not followed to."""
        ...

    def about(self, sentence: str) -> dict[str, str]:
        """What the map is of, for the attributes of files."""
        ...

    def subject(self) -> dict[str, Any]:
        """What the map is of, as JSON."""
        ...

    def guarantee(self, summary: MapSummary) -> str:
        """What is proved, in one sentence."""
        ...


class InLayers:
    """The chunks of a `MapTask`: so many whole layers along the first axis."""

    @property
    def number(self: MapTask) -> int:
        """How many chunks there are."""
        return -(-self.grid.shape[0] // self.layers)

    def span(self: MapTask, chunk: int) -> tuple[int, int]:
        """The layers of a chunk, the first one and the one after the last."""
        return chunk * self.layers, min((chunk + 1) * self.layers, self.grid.shape[0])


def width_of(task: MapTask, name: str) -> int:
    """How many numbers an array has for each pose."""
    return len(task.grid.actuators) if name in ("leg_length", "actuator") else 1
