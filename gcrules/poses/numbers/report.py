r"""The answer for one pose: numbers, verdict and reason; shows itself as text, JSON and LaTeX."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from gcrules.conditions.dimensions.facts import Architecture
from gcrules.core.dataclass import dataclass
from gcrules.core.floats import as_float
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.motion import Dependence, Twist
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.rules.condition import Condition
from gcrules.screws.margin import jacobian
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import Threshold, safe

__all__ = ["PoseReading", "PoseReport"]

_LONGEST = 60  # signs of an exact number in JSON


@dataclass(frozen=True)
class PoseReading:
    """One `Reading` at one pose; `value` is None where it is not valid, and `why` says why."""

    part: str
    name: str
    meaning: str
    value: float | None
    unit: str = ""
    published: bool = False
    why: str = ""

    def to_json(self) -> dict[str, Any]:
        return {
            "part": self.part,
            "name": self.name,
            "meaning": self.meaning,
            "value": self.value,
            "unit": self.unit,
            "published": self.published,
            "valid": self.value is not None,
            "why": self.why,
        }


@dataclass(frozen=True)
class PoseReport(Shown):
    """A robot in one pose. Lengths are in the robot's unit, angles in radians.

    `verdict` is regular | close | singular, `reason` the sentence with it and `causes` the incidences that make the
    pose singular. `superbracket` is exact (a length⁹; singular exactly where it is 0). `margin` is the measure σ in
    [0, 1]; `turn`, `shift`, `rotation` and `combined` are what it guarantees (see `Guarantees`), for the joints' places
    as they are given; `noise` is how much σ can change for joints that are known up to `accuracy`. `jacobian` holds the
    forces along the legs. `nearest` holds the nearest singular poses (empty if they were not asked for), `softest` the
    motion that the legs notice least, `stress` the ratio of forces in the legs that nearly balance, `dependence` what
    singular legs have in common; `architecture` says of a pose that is not regular whether all are singular.
    """

    rig: MovingPlatform
    pose: Pose
    condition: Condition
    verdict: str
    reason: str
    causes: tuple[str, ...]
    superbracket: Fraction
    margin: float
    turn: float
    shift: float
    rotation: float
    combined: float
    accuracy: float
    noise: float
    threshold: Threshold
    jacobian: WrenchJacobian
    readings: tuple[PoseReading, ...]
    nearest: tuple[NearestPose, ...]
    softest: Twist
    stress: tuple[float, ...]
    dependence: Dependence | None
    notes: tuple[str, ...] = ()
    architecture: Architecture | None = None

    @property
    def value(self) -> float:
        """The superbracket as a float, in the unit to the ninth power; infinite or 0 where a float cannot hold it."""
        return as_float(self.superbracket)

    @property
    def actuator_values(self) -> dict[str, float]:
        """The lengths of the legs, by name."""
        found = jacobian(self.rig.base, self.rig.ends(*from_poses([self.pose])))
        return dict(zip(self.jacobian.actuators, found.lengths[0].tolist(), strict=True))

    def to_json(self) -> dict[str, Any]:
        """One JSON object; numbers that are infinite, beyond floats or not valid are null."""
        exact = str(self.superbracket)
        return {
            "schema": 1,
            "title": self.rig.title,
            "unit": self.rig.unit,
            "legs": [list(leg) for leg in self.rig.structure.legs],
            "platform": list(self.rig.structure.platform),
            "about": [float(c) for c in self.rig.centre],
            "pose": self.pose.to_json(),
            "actuators": [
                {"name": name, "unit": self.rig.unit or "length", "value": value}
                for name, value in self.actuator_values.items()
            ],
            "value": self.value if math.isfinite(self.value) and (self.value or not self.superbracket) else None,
            "exact": exact if len(exact) <= _LONGEST else None,
            "margin": self.margin,
            "verdict": self.verdict,
            "reason": self.reason,
            "causes": list(self.causes),
            **self.condition.wording(),
            "threshold": {"angle": self.threshold.angle, "length": self.threshold.length},
            "accuracy": self.accuracy,
            "noise": self.noise,
            "guarantees": {
                "turn": self.turn,
                "shift": self.shift,
                "rotation": self.rotation,
                "combined": self.combined,
            },
            "jacobian": self.jacobian.to_json(),
            "readings": [r.to_json() for r in self.readings],
            "nearest": {n.kind: n.to_json() for n in self.nearest},
            "softest_motion": self.softest.to_json(),
            "stress": list(self.stress),
            "architecture": self.architecture.to_json() if self.architecture else None,
            "singularity": self.dependence.to_json() if self.dependence else None,
            "notes": list(self.notes),
        }

    def __repr__(self) -> str:
        return f"<PoseReport {self.verdict}: margin {self.margin:.4g}, {safe(self.turn)}>"
