"""What a mechanism computes at a pose, as programs: the factors of its condition, its margin, its actuators."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.compiling.engines import STEP, runner
from gcrules.poses.compiling.tape import Program

__all__ = ["ClosedForms", "run"]

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class ClosedForms:
    """Programs of the coordinates of a pose, angles from −π to π; None where no closed form is known.

    `factors` has a value for each factor whose zeros are singularities. `wrenches` has the entries of a matrix of so
    many `columns`, row by row, whose least singular value is the margin. `actuators` has for each of them the cosine
    and the sine of its turn, or a length, as `turns` says.
    """

    factors: Program | None = None
    wrenches: Program | None = None
    actuators: Program | None = None
    columns: int = 6
    turns: tuple[bool, ...] = ()

    @property
    def complete(self) -> bool:
        """Whether all three are known."""
        return None not in (self.factors, self.wrenches, self.actuators)

    @property
    def rows(self) -> int:
        """How many wrenches there are."""
        return len(self.wrenches.results) // self.columns if self.wrenches else 0

    def margins(self, engine: str, poses: Floats) -> Floats:
        """The margin σ by `wrenches`, (N,); not a number where the robot does not assemble."""
        assert self.wrenches is not None
        found = np.full(len(poses), np.nan)
        for start in range(0, len(poses), STEP):
            values = run(self.wrenches, engine, poses[start : start + STEP]).T
            rows = values.reshape(len(values), values.shape[1] // self.columns, self.columns)
            fine = np.isfinite(values).all(axis=1)
            sizes = np.linalg.svd(rows[fine], compute_uv=False)
            least = sizes[:, self.columns - 1] if sizes.shape[1] == self.columns else np.zeros(len(sizes))
            found[start : start + STEP][fine] = np.minimum(least, 1.0)
        return found

    def amounts(self, engine: str, poses: Floats) -> Floats:
        """The amounts of the actuators by `actuators`, (N, actuators); turns from −π to π."""
        assert self.actuators is not None
        values, found, k = run(self.actuators, engine, poses), [], 0
        for turn in self.turns:
            found.append(np.arctan2(values[k + 1], values[k]) if turn else values[k])
            k += 1 + turn
        return np.stack(found, axis=1)


def run(program: Program, engine: str, inputs: Floats) -> Floats:
    """The values (results, N) for inputs (N, k)."""
    values = np.empty((len(program.results), len(inputs)))
    call = runner(program, engine)
    for start in range(0, len(inputs), STEP):
        checkpoint()
        part = inputs[start : start + STEP]
        call(part, np.empty((len(part), 0)), values[:, start : start + STEP])
    return values
