r"""The answer for a path: numbers at samples as arrays, every singular place, the least margin."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.floats import rounded_down
from gcrules.core.frozen import HoldsArrays
from gcrules.core.shown import Shown
from gcrules.mechanisms.kinematics.amplification import index_columns
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.numbers.many import PoseNumbers
from gcrules.poses.numbers.motion import Dependence
from gcrules.poses.paths.least import Least
from gcrules.poses.paths.zeros import Stretch
from gcrules.rules.condition import Condition
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import Threshold, safe, turn_of

if TYPE_CHECKING:
    pass

__all__ = ["PathReport", "Zero"]

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Zero:
    """A singular place of a path, between the parameters `lower` and `upper` (exactly there if they are equal).

    `kind` is crosses (the superbracket changes its sign there) | touches (it does not) | starts | ends (the path does
    so), `multiplicity` that of the zero (where two segments meet: the smaller one of the two). `pose` is exact, or in
    the middle of the interval; `causes` are sentences, `dependence` says what the legs have in common and which motion
    is gained (None where a leg has no length).
    """

    lower: Fraction
    upper: Fraction
    kind: str
    multiplicity: int
    pose: Pose
    causes: tuple[str, ...]
    dependence: Dependence | None

    @property
    def parameter(self) -> float:
        return float((self.lower + self.upper) / 2)

    @property
    def exact(self) -> bool:
        """Whether the place is known exactly, not just up to the interval."""
        return self.lower == self.upper

    def to_json(self) -> dict[str, Any]:
        return {
            "parameter": self.parameter,
            "exact": str(self.lower) if self.exact else None,
            "width": float(self.upper - self.lower),
            "kind": self.kind,
            "multiplicity": self.multiplicity,
            "pose": self.pose.to_json(),
            "causes": list(self.causes),
            "singularity": self.dependence.to_json() if self.dependence else None,
        }


@dataclass(frozen=True, eq=False)
class PathReport(HoldsArrays, Shown):
    """A robot along a path through `poses`. The parameter is 0 at the first of them, 1 at the second, and so on.

    `zeros` are all singular places, but for the `stretches` that are singular throughout: both are proved complete, as
    the superbracket along each segment is a polynomial (`degrees`: of what degree; −1 where it is zero), which is found
    exactly unless floats prove that it has no zero.
    `least` is the least margin with a bound that holds everywhere. `parameters` (N,), `translations` (N, 3) and unit
    `quaternions` (N, 4; w, x, y, z) are the samples, the zeros among them, and `numbers` what `gc.pose` says of these.
    """

    rig: MovingPlatform
    condition: Condition
    poses: tuple[Pose, ...]
    verdict: str
    reason: str
    zeros: tuple[Zero, ...]
    stretches: tuple[Stretch, ...]
    least: Least
    degrees: tuple[int, ...]
    threshold: Threshold
    parameters: Floats
    translations: Floats
    quaternions: Floats
    numbers: PoseNumbers
    notes: tuple[str, ...] = ()

    def kinds(self) -> list[str]:
        """For each sample the kind of the zero there, "stretch" inside a singular stretch, else ""."""
        at = {z.parameter: z.kind for z in self.zeros}
        inside = [(s.start, s.end) for s in self.stretches]
        return [
            at.get(float(x), "stretch" if any(a <= x <= b for a, b in inside) else "") for x in self.parameters.tolist()
        ]

    def to_json(self) -> dict[str, Any]:
        """One JSON object; the numbers at samples are lists."""
        return {
            "schema": 1,
            "title": self.rig.title,
            "unit": self.rig.unit,
            "legs": [list(leg) for leg in self.rig.structure.legs],
            "platform": list(self.rig.structure.platform),
            "about": [float(c) for c in self.rig.centre],
            "poses": [p.to_json() for p in self.poses],
            "verdict": self.verdict,
            "reason": self.reason,
            **self.condition.wording(),
            "zeros": [z.to_json() for z in self.zeros],
            "stretches": [s.to_json() for s in self.stretches],
            "least": {
                "margin": self.least.margin,
                "parameter": self.least.parameter,
                "bound": self.least.bound,
            },
            "threshold": {"angle": self.threshold.angle},
            "polynomial_degrees": list(self.degrees),
            "samples": {
                "parameter": self.parameters.tolist(),
                "translation": self.translations.tolist(),
                "quaternion": self.quaternions.tolist(),
                "zero": self.kinds(),
                **self.numbers.to_json(),
            },
            "notes": list(self.notes),
        }

    def csv(self) -> str:
        """A table of the samples, the zeros among them; `gcrules path --poses` reads it back."""
        return "".join(f"{','.join(row)}\n" for row in self._rows())

    def _rows(self) -> Iterator[list[str]]:
        u = f" [{self.rig.unit}]" if self.rig.unit else ""
        n = self.numbers
        yield [
            *("parameter", f"x{u}", f"y{u}", f"z{u}", "qw", "qx", "qy", "qz"),
            *(f"superbracket{f' [{self.rig.unit}^9]' if u else ''}", "margin", "free turn [rad]", f"free shift{u}"),
            *("smallest singular value", "condition number"),
            *(f"{r.name} of {r.part}{u if r.power else ''}" for r in n.readings),
            *index_columns(n.amplifications, self.rig.unit),
            *("verdict", "zero"),
        ]
        columns: list[Floats] = [n.value, n.margin, n.turn, n.shift, n.smallest_singular_value, n.condition_number]
        columns += [np.where(r.valid, r.values, np.nan) for r in n.readings]
        columns += n.amplifications.indices.values()
        numbers = np.column_stack([self.parameters, self.translations, self.quaternions, *columns])
        for row, verdict, kind in zip(numbers.tolist(), n.verdict.tolist(), self.kinds(), strict=True):
            yield [*("" if x != x else repr(x + 0.0).removesuffix(".0") for x in row), verdict, kind]

    def __len__(self) -> int:
        return len(self.parameters)

    def plot(self) -> Any:
        """A `Drawing` of the margin and the superbracket over the parameter, the zeros marked; it has `svg()` and
        `pdf()`.
        """
        return self._show("plot")

    def __repr__(self) -> str:
        angle = safe(turn_of(self.least.bound))
        found = f"{len(self.zeros)} zeros" + (f", {len(self.stretches)} stretches" if self.stretches else "")
        return f"<PathReport {self.verdict}: {found}, margin at least {rounded_down(self.least.bound)}, {angle}>"
