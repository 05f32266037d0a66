"""The answer for a robot of joints along a path: singular places, what is proved between them, numbers at samples."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import HoldsArrays
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.amplification import Amplifications, index_columns
from gcrules.mechanisms.kinematics.linkage import Actuator
from gcrules.poses.numbers.motion import Twist
from gcrules.poses.paths.least import Least
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.threshold import Threshold

__all__ = ["Crossing", "RobotPath"]

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Crossing:
    """A singular place at about this `parameter`, and for sure between `lower` and `upper`: the determinant of all
    wrenches changes its sign there. Between `first` and `last` there is an odd number of them, and nothing is singular
    just outside, as far as that is proved.

    `coordinates` are those at the parameter, `causes` the factors of the condition that change their sign, in words,
    `motion` what the platform gains.
    """

    parameter: float
    lower: float
    upper: float
    first: float
    last: float
    coordinates: tuple[float, ...]
    causes: tuple[str, ...]
    motion: Twist

    def to_json(self) -> dict[str, Any]:
        return {
            "parameter": self.parameter,
            "between": [self.lower, self.upper],
            "alone_between": [self.first, self.last],
            "coordinates": list(self.coordinates),
            "causes": list(self.causes),
            "motion": self.motion.to_json(),
        }


@dataclass(frozen=True, eq=False)
class RobotPath(HoldsArrays, Shown):
    """A robot of joints along a path through poses, `texts`; the parameter is 0 at the first of them, 1 at the second.

    Between two poses the coordinates `names` grow evenly, lengths in the file's `unit`, angles in radians, from home.
    Outside of the `crossings` and of the `undecided` stretches it is proved that no configuration is singular; at each
    crossing one is. `branch_doubt` is the parameter from which on it is not proved that the configurations follow one
    branch of solutions from home (None: it is proved throughout).

    Nowhere on the path is the margin below the bound of `least`, which is proved; 0 where nothing is. Those between two
    poses each are `segment_bounds` (segments,). `actuator_ranges`
    (actuators, 2) are those between which it is proved that the actuators stay, infinite where it is not.

    A `redundant` robot has more actuators than freedoms: there are no crossings.

    `parameters` (N,), `coordinates` (N, names) and `actuator_values` (N, actuators) are the samples, `margins` (N,)
    their σ, `limb_margins` (N,) the least of the limbs' own, `factor_values` (N, F) those of the condition's `factors`
    (nan where a cofactor is 0 too), `verdicts` (N,) regular | close | singular, `amplifications` what the
    actuators make of their rates there.
    """

    robot: str
    title: str
    statement: str
    texts: tuple[str, ...]
    names: tuple[str, ...]
    actuators: tuple[Actuator, ...]
    verdict: str
    reason: str
    crossings: tuple[Crossing, ...]
    undecided: tuple[tuple[float, float], ...]
    branch_doubt: float | None
    threshold: Threshold
    redundant: bool
    least: Least
    segment_bounds: Floats
    actuator_ranges: Floats
    parameters: Floats
    coordinates: Floats
    actuator_values: Floats
    margins: Floats
    limb_margins: Floats
    factors: tuple[str, ...]
    factor_values: Floats
    verdicts: NDArray[np.str_]
    amplifications: Amplifications
    unit: str = ""
    notes: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """One JSON object; the numbers at samples are lists."""
        return {
            "schema": 1,
            "robot": self.robot,
            "title": self.title,
            "unit": self.unit,
            "statement": self.statement,
            "poses": list(self.texts),
            "verdict": self.verdict,
            "reason": self.reason,
            "crossings": [c.to_json() for c in self.crossings],
            "undecided": [list(s) for s in self.undecided],
            "branch_proved_to": None if self.branch_doubt is None else self.branch_doubt,
            "least": {
                "margin": self.least.margin,
                "parameter": self.least.parameter,
                "bound": self.least.bound,
            },
            "segment_bounds": self.segment_bounds.tolist(),
            "actuator_ranges": {
                a.name: [_finite(c) for c in self.actuator_ranges[k].tolist()] for k, a in enumerate(self.actuators)
            },
            "threshold": {"angle": self.threshold.angle},
            "samples": {
                "parameter": self.parameters.tolist(),
                "coordinates": {n: self.coordinates[:, k].tolist() for k, n in enumerate(self.names)},
                "actuators": {a.name: self.actuator_values[:, k].tolist() for k, a in enumerate(self.actuators)},
                "margin": self.margins.tolist(),
                "limb_margin": self.limb_margins.tolist(),
                "factors": {f: [_finite(v) for v in self.factor_values[:, k]] for k, f in enumerate(self.factors)},
                "verdict": self.verdicts.tolist(),
                **self.amplifications.to_json(),
            },
            "notes": list(self.notes),
        }

    def csv(self) -> str:
        """A table of the samples."""
        return "".join(f"{','.join(row)}\n" for row in self._rows())

    def _rows(self) -> Iterator[list[str]]:
        units = {True: " [rad]", False: f" [{self.unit}]" if self.unit else ""}
        yield [
            "parameter",
            *(f"{n}{units[n in ANGLES]}" for n in self.names),
            *(f"{a.name}{units[a.angle]}" for a in self.actuators),
            *("margin", "limb margin", *self.factors),
            *index_columns(self.amplifications, self.unit),
            "verdict",
        ]
        columns = [self.parameters, self.coordinates, self.actuator_values, self.margins, self.limb_margins]
        columns += [self.factor_values, *self.amplifications.indices.values()]
        for row, verdict in zip(np.column_stack(columns).tolist(), self.verdicts.tolist(), strict=True):
            yield [*("" if x != x else repr(x + 0.0).removesuffix(".0") for x in row), verdict]

    def __len__(self) -> int:
        return len(self.parameters)

    def plot(self) -> Any:
        """A `Drawing` of the margin over the parameter, the crossings marked; it has `svg()` and `pdf()`."""
        return self._show("plot")

    def __repr__(self) -> str:
        crossings = f"{len(self.crossings)} crossings"
        return f"<RobotPath {self.verdict}: {crossings}, {len(self.undecided)} undecided stretches>"


def _finite(x: float) -> float | None:
    return float(x) if np.isfinite(x) else None
