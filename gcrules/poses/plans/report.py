r"""The answer to where a robot can go: a way that is proved, the proof that there is none, or neither."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any

from gcrules.core.arguments import FILE, checked
from gcrules.core.dataclass import dataclass
from gcrules.core.floats import rounded_down
from gcrules.core.shown import Shown
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.certificate_files import write_certificate
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.paths.report import PathReport
from gcrules.poses.paths.table import table_text
from gcrules.poses.plans.certificate import plan_certificate
from gcrules.screws.pose import Pose

__all__ = ["OpposedSign", "Plan", "Search", "Waypoint", "pose_json"]

Waypoint = Pose | Mapping[str, float]
"""A pose; of a robot of joints coordinates by name, angles in radians."""


@dataclass(frozen=True)
class OpposedSign:
    """What has one sign at the start and the other one at the goal, so that it is 0 somewhere on every way between
    them: the expression with its two values, and what is singular there, in words.
    """

    expression: str
    start: float
    goal: float
    statement: str

    def to_json(self) -> dict[str, Any]:
        return {
            "expression": self.expression,
            "start": self.start,
            "goal": self.goal,
            "statement": self.statement,
        }


@dataclass(frozen=True)
class Search:
    """What a search had: the `region` of coordinates and the `limits` of actuators in words ("" for none), how many
    `states` it came to, and the `seed` of its draws.
    """

    region: str
    limits: str
    states: int
    seed: int

    def to_json(self) -> dict[str, Any]:
        return {"region": self.region, "limits": self.limits or None, "states": self.states, "seed": self.seed}


@dataclass(frozen=True)
class Plan(Shown):
    """Where a robot can go without a singularity.

    `outcome` is way | none | undecided, `reason` says it in a sentence. A way goes straight through the `poses`, and
    `path` is its proof: nothing on it is singular. Its margin is `asked` at least, and `least`: everywhere (`proved`),
    or at the samples of the path, and so are its limits (`limits_proved`). Where a margin was named and is proved of no
    way, the outcome is undecided, and `poses` and `path` are those of the best one that was found.
    A way out, with an `end_margin`, has `asked` at its end only; where none is found there is no `goal`. That there is
    none between two poses is proved by what is `opposed`. It is of this `mechanism`, of a robot whose limbs are six
    legs by its platform. `length` is how long the way is, lengths in parts of the robot's `size`, angles in rad, and
    `straight` that from start to goal.
    """

    title: str
    unit: str
    outcome: str
    reason: str
    asked: float
    start: Waypoint
    goal: Waypoint | None
    poses: tuple[Waypoint, ...]
    path: PathReport | RobotPath | None
    least: float
    proved: bool
    limits_proved: bool
    length: float
    straight: float
    size: float
    opposed: tuple[OpposedSign, ...]
    search: Search | None
    mechanism: Mechanism = field(repr=False, compare=False)
    end_margin: float | None = None
    notes: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """One JSON object, with the proof."""
        way = self.path is not None
        return {
            "schema": 1,
            "title": self.title,
            "unit": self.unit,
            "outcome": self.outcome,
            "reason": self.reason,
            "margin_asked": self.asked,
            "start": pose_json(self.start),
            "goal": pose_json(self.goal) if self.goal is not None else None,
            "poses": [pose_json(p) for p in self.poses],
            "least_margin": self.least if way else None,
            "margin_proved": self.proved if way else None,
            "limits_proved": self.limits_proved if way else None,
            "end_margin": self.end_margin,
            "length": self.length if way else None,
            "straight_length": self.straight,
            "size": self.size,
            "opposed": [o.to_json() for o in self.opposed],
            "search": self.search.to_json() if self.search else None,
            "path": self.path.to_json() if self.path is not None else None,
            "notes": list(self.notes),
        }

    def csv(self) -> str:
        """A table of the way's poses; that of a platform on six legs `gcrules path --poses` reads."""
        return table_text(self.poses, self.unit)

    def certificate(self) -> dict[str, Any]:
        """That there is no way, with all that another program needs to see it again, as JSON: see `save_certificate`.

        Raises InputError for another plan, LimitReached for robots of joints, and where only factors of the condition
        have opposite signs.
        """
        return plan_certificate(self)

    @checked("plan.save_certificate", path=FILE)
    def save_certificate(self, path: str) -> None:
        """Write the poses and the signs, .json or .json.gz, for the program check_plan.py, which computes them again.

        Raises as `certificate`, and FileError.
        """
        write_certificate(self, path)

    def plot(self) -> Any:
        """The margin along the way, with the one that was asked for: a drawing with `svg()`. Raises InputError where
        there is no way.
        """
        return self._show("plot")

    def __repr__(self) -> str:
        if self.path is None:
            return f"<Plan {self.outcome}: {self.reason}>"
        return f"<Plan way of {len(self.poses)} poses, margin at least {rounded_down(self.least)}>"


def pose_json(pose: Waypoint) -> dict[str, Any]:
    return pose.to_json() if isinstance(pose, Pose) else dict(pose)
