"""The answer for a robot in one configuration: numbers, verdict and reason; shows itself as text, JSON and LaTeX."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap, HoldsArrays
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.linkage import Actuator
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.poses.limbs.balance import LimbNumbers
from gcrules.poses.limbs.factors import ConditionFactor
from gcrules.poses.limbs.singularity_types import SingularityType
from gcrules.poses.limbs.way_from_home import WayFromHome
from gcrules.poses.numbers.motion import Twist
from gcrules.screws.threshold import Threshold, safe

__all__ = ["NearestConfiguration", "RobotPose"]


@dataclass(frozen=True)
class NearestConfiguration:
    """The nearest singular configuration that a search in `directions` found around a configuration of a robot.

    `changes` are those of the coordinates from there (radians and the unit of the file), none where nothing was found
    up to `reach`; `distance` is √Σ of the squares of angles and of shifts in parts of the robot's `size`, infinite
    then. `coordinates` and `actuators` are its pose and the amounts of its actuators, from home; `margin` is σ there,
    `causes` are the factors that vanish, in words. That it lies on the same branch is `branch_proved` or not. It is a
    search: another one may be nearer. But no configuration is singular where each of the coordinates named in
    `free` changes by less than that: proved. In `stopped` of the directions the robot could not be followed so far.
    """

    changes: Mapping[str, float]
    distance: float
    reach: float
    size: float
    free: Mapping[str, float]
    directions: int
    stopped: int
    coordinates: Mapping[str, float]
    actuators: Mapping[str, float]
    margin: float | None
    causes: tuple[str, ...]
    branch_proved: bool

    def __post_init__(self) -> None:
        for name in ("changes", "free", "coordinates", "actuators"):
            object.__setattr__(self, name, FrozenMap(getattr(self, name)))

    def to_json(self) -> dict[str, Any]:
        """One JSON object; what does not exist is null."""
        return {
            "distance": self.distance if math.isfinite(self.distance) else None,
            "reach": self.reach,
            "size": self.size,
            "changes": dict(self.changes),
            "free": dict(self.free),
            "directions": self.directions,
            "stopped": self.stopped,
            "pose": dict(self.coordinates),
            "actuators": dict(self.actuators),
            "sigma": self.margin,
            "causes": list(self.causes),
            "branch_proved": self.branch_proved,
        }


@dataclass(frozen=True, eq=False)
class RobotPose(HoldsArrays, Shown):
    """A robot in one configuration. Lengths are in `unit`, that of its file, angles in radians, all from home.

    `verdict` is regular | close | singular, `reason` the sentence with it, `causes` the factors that vanish, in words.
    `coordinates` are x, y, z of the platform's `centre`, roll, pitch, yaw and the rotation vector; `actuators` holds
    each driven freedom with its amount. `residual` is how far the loops are open and `disagreement` how far names are
    from their relations, in parts of the robot's size; `steps` and `iterations` are those of the solution, `assembly`
    says what is proved of the way to it from home: its branch, and its mode. `margin` is σ in [0, 1] and `turn` = asin
    σ its guarantee (see docs/robot-numbers.md). `factors` are those of the condition; `motions` what the platform gains
    where it is singular, `types` the types of that singularity, `softest` the motion that the limbs notice least,
    `points` the places of all points and directions. `nearest` is the nearest singular configuration, where it was
    asked for.
    """

    robot: str
    title: str
    target: str
    verdict: str
    reason: str
    causes: tuple[str, ...]
    coordinates: Mapping[str, float]
    centre: tuple[float, ...]
    actuators: tuple[tuple[Actuator, float], ...]
    residual: float
    disagreement: float
    steps: int
    iterations: int
    assembly: WayFromHome
    margin: float
    turn: float
    threshold: Threshold
    jacobian: WrenchJacobian
    factors: tuple[ConditionFactor, ...]
    statement: str
    limbs: tuple[LimbNumbers, ...]
    softest: Twist
    motions: tuple[Twist, ...]
    points: Mapping[str, tuple[float, ...]]
    unit: str = ""
    types: tuple[SingularityType, ...] = ()
    notes: tuple[str, ...] = ()
    nearest: NearestConfiguration | None = None

    def __post_init__(self) -> None:
        for name in ("coordinates", "points"):
            object.__setattr__(self, name, FrozenMap(getattr(self, name)))

    @property
    def mode(self) -> str:
        """On which assembly mode it lies, in words."""
        return self.assembly.text

    @property
    def actuator_values(self) -> dict[str, float]:
        """The amounts of the actuators from home, by name."""
        return {a.name: value for a, value in self.actuators}

    def to_json(self) -> dict[str, Any]:
        """One JSON object; numbers that are infinite or do not exist are null."""
        return {
            "schema": 1,
            "robot": self.robot,
            "title": self.title,
            "unit": self.unit,
            "target": self.target,
            "verdict": self.verdict,
            "reason": self.reason,
            "causes": list(self.causes),
            "statement": self.statement,
            "pose": {"about": list(self.centre), **self.coordinates},
            "actuators": [
                {
                    "name": a.name,
                    "limb": a.limb,
                    "joint": a.joint,
                    "freedom": a.freedom,
                    "unit": "rad" if a.angle else self.unit or "length",
                    "value": value,
                }
                for a, value in self.actuators
            ],
            "assembly": {
                "residual": self.residual,
                "relations": self.disagreement,
                "steps": self.steps,
                "iterations": self.iterations,
                "mode": self.mode,
                **self.assembly.to_json(),
            },
            "margin": self.margin,
            "guarantees": {"turn": self.turn},
            "threshold": {"angle": self.threshold.angle},
            "jacobian": self.jacobian.to_json(),
            "factors": [f.to_json() for f in self.factors],
            "limbs": [limb.to_json() for limb in self.limbs],
            "softest_motion": self.softest.to_json(),
            "gained_motions": [motion.to_json() for motion in self.motions],
            "types": [t.to_json() for t in self.types],
            "points": {n: list(p) for n, p in self.points.items()},
            "nearest": self.nearest.to_json() if self.nearest else None,
            "notes": list(self.notes),
        }

    def __repr__(self) -> str:
        return f"<RobotPose {self.robot}: {self.verdict}, margin {self.margin:.4g}, {safe(self.turn)}>"
