r"""The answer to how large a region around a pose is free of singular ones."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any

from gcrules.core.arguments import FILE, checked
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.shown import Shown
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.certificate_files import write_certificate
from gcrules.poses.regions.certificate import region_certificate
from gcrules.screws.pose import Pose

__all__ = ["FreeRegion"]


@dataclass(frozen=True)
class FreeRegion(Shown):
    """A box, or a ball, around a pose in which it is proved that nothing is singular.

    `centre` are the coordinates `names` of its middle, `weights` what one part of `scale` is of each: lengths in the
    unit of the file, and rad where `angles` say so. A box holds all values that differ from those of the middle by at
    most scale × weight, a ball those whose differences, in parts of the weights, have squares that add up to at most
    scale². It is proved by so many `boxes`.

    With the larger `tried` scale the proof ended: around the coordinates `worst`, of margin `margin`, 0 where the robot
    is singular or does not assemble. None where no scale was tried that is not proved.

    It is of this `mechanism`; around six legs' pose `at`, which the centre is counted from.
    """

    title: str
    unit: str
    shape: str
    pose: str
    names: tuple[str, ...]
    angles: tuple[bool, ...]
    driven: bool
    centre: tuple[float, ...]
    weights: tuple[float, ...]
    scale: float
    boxes: int
    tried: float | None
    worst: Mapping[str, float]
    margin: float
    mechanism: Mechanism = field(repr=False, compare=False)
    at: Pose | None = field(repr=False, compare=False)
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "worst", FrozenMap(self.worst))

    @property
    def half_widths(self) -> tuple[float, ...]:
        """By how much each coordinate may change alone."""
        return tuple(self.scale * w for w in self.weights)

    @property
    def ranges(self) -> dict[str, tuple[float, float]]:
        """The least and the largest value of each coordinate."""
        ends = zip(self.names, self.centre, self.half_widths, strict=True)
        return {name: (c - h, c + h) for name, c, h in ends}

    def to_json(self) -> dict[str, Any]:
        """One JSON object; lengths in the unit, angles in rad."""
        return {
            "schema": 1,
            "title": self.title,
            "unit": self.unit,
            "shape": self.shape,
            "pose": self.pose,
            "driven": self.driven,
            "ranges": {name: list(ends) for name, ends in self.ranges.items()},
            "weights": dict(zip(self.names, self.weights, strict=True)),
            "scale": self.scale,
            "boxes": self.boxes,
            "tried": self.tried,
            "worst": dict(self.worst) if self.tried is not None else None,
            "margin": self.margin if self.tried is not None else None,
            "notes": list(self.notes),
        }

    def certificate(self) -> dict[str, Any]:
        """The robot and the region, with all that another program needs to prove it again, as JSON: see
        `save_certificate`.

        Raises LimitReached for regions of actuators and for robots of joints without closed forms of their limbs.
        """
        return region_certificate(self)

    @checked("region.save_certificate", path=FILE)
    def save_certificate(self, path: str) -> None:
        """Write the robot and the region, .json or .json.gz, for the program check_free.py, which proves it again.

        Raises as `certificate`, and FileError.
        """
        write_certificate(self, path)

    def picture(self) -> Any:
        """The range of each coordinate, and the pose at which the proof ended: a drawing with `svg()`."""
        return self._show("picture")

    def __repr__(self) -> str:
        return f"<FreeRegion {self.shape} over {', '.join(self.names)}: {self.scale:.4g}>"
