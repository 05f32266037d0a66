"""The answer for a robot in one configuration: numbers, verdict and reason; shows itself as text, JSON and LaTeX."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gcrules.core.frozen import FrozenMap, HoldsArrays
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.linkage import Actuator
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.poses.limbs.assembly_mode import AssemblyMode
from gcrules.poses.limbs.balance import LimbNumbers
from gcrules.poses.limbs.factors import ConditionFactor
from gcrules.poses.numbers.motion import Twist
from gcrules.screws.threshold import Threshold

__all__ = ["RobotPose"]


@dataclass(frozen=True, eq=False)
class RobotPose(HoldsArrays, Shown):
    """A robot in one configuration. Lengths are in the unit of its file, angles in radians, all from home.

    `verdict` is regular | close | singular, `reason` the sentence with it, `causes` the factors that vanish, in words.
    `coordinates` are x, y, z of the platform's `centre`, roll, pitch, yaw and the rotation vector; `actuators` holds
    each driven freedom with its amount. `residual` is how far the loops are open and `disagreement` how far names are
    from their relations, in parts of the robot's size; `steps` and `iterations` are those of the solution, `assembly`
    says what is proved of the way to it from home: its branch, and its mode. `margin` is σ in [0, 1] and `turn` = asin
    σ its guarantee (see docs/robot-numbers.md). `factors` are those of the condition; `motions` what the platform gains
    where it is singular, `softest` the motion that the limbs notice least, `points` the places of all points and
    directions.
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
    assembly: AssemblyMode
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
    notes: tuple[str, ...] = ()

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
                    "unit": "rad" if a.angle else "length",
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
            "points": {n: list(p) for n, p in self.points.items()},
            "notes": list(self.notes),
        }

    def __repr__(self) -> str:
        return f"<RobotPose {self.robot}: {self.verdict}, margin {self.margin:.4g}, {math.degrees(self.turn):.3g}°>"
