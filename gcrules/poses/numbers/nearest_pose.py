r"""What was found of the nearest singular pose of one kind, and what is proved of it."""

from __future__ import annotations

import math
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.screws.pose import Pose

__all__ = ["NearestPose"]


@dataclass(frozen=True)
class NearestPose:
    """The nearest singular pose of one `kind`: translation (orientation fixed), rotation (about the centroid of the
    legs' platform ends, which stays) or combined.

    `distance` is a length for translation and combined (`Guarantees` has the metric), an angle in radians for
    rotation; infinite with `pose` None where none was found. There is proved to be none nearer than `lower`, and, if
    `upper` is not None, one within `upper`, for the determinant changes its sign up to there. `sigma` is the measure at
    the pose that is returned, in floats; `exact` says that its superbracket is exactly 0,
    `causes` what is incident there. `never` says that there is proved to be no singular pose of this kind at all.
    """

    kind: str
    distance: float
    lower: float
    upper: float | None
    pose: Pose | None
    sigma: float | None = None
    exact: bool = False
    never: bool = False
    causes: tuple[str, ...] = ()

    @property
    def certified(self) -> bool:
        """Whether `distance` is proved to be the least, to a relative accuracy of 2e-6 (mostly it is 1e-9)."""
        return self.never or (self.upper is not None and self.lower >= self.upper * (1 - 2e-6))

    def to_json(self) -> dict[str, Any]:
        return {
            "distance": self.distance if math.isfinite(self.distance) else None,
            "lower": self.lower if math.isfinite(self.lower) else None,
            "upper": self.upper,
            "certified": self.certified,
            "never": self.never,
            "pose": self.pose.to_json() if self.pose else None,
            "sigma": self.sigma,
            "exact": self.exact,
            "causes": list(self.causes),
        }
