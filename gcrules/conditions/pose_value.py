r"""Numbers for a robot in a given pose: the exact value of the condition and a dimensionless measure of margin."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Protocol

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.language.legs_text import Leg, Structure
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred, resolved
from gcrules.core.errors import InputError
from gcrules.core.linear_algebra import cross
from gcrules.rules.condition import Condition
from gcrules.screws.verdict import CLOSE, FLOOR, decide

__all__ = ["Coordinates", "PoseValue", "judged", "line_measure", "line_points", "measure", "pose_value"]

ROUNDING = "gcrules.screws.guarantees:ROUNDING"
noise = deferred("gcrules.screws.guarantees:noise")
jacobian = deferred("gcrules.screws.margin:jacobian")
on_one_line = deferred("gcrules.screws.margin:on_one_line")

XYZ = tuple[float, float, float]


class Coordinates(Protocol):
    """A platform on six legs with the places of its joints, exact and in `units` ("" if they are not named)."""

    @property
    def points(self) -> Mapping[str, tuple[Fraction, Fraction, Fraction]]: ...

    @property
    def legs(self) -> tuple[tuple[str, str], ...]: ...

    @property
    def title(self) -> str: ...

    @property
    def note(self) -> str: ...

    @property
    def units(self) -> str: ...

    @property
    def filename(self) -> str: ...

    @property
    def warnings(self) -> tuple[str, ...]: ...

    def homogeneous(self) -> dict[str, tuple[Fraction, Fraction, Fraction, Fraction]]:
        """The points as (x, y, z, 1)."""
        ...


@dataclass(frozen=True)
class PoseValue:
    """Numbers in one pose. `superbracket`, `condition` (coefficient · expression) and `cofactor` are exact, with
    cofactor · superbracket = condition; each bracket is a length³, so the superbracket is a length⁹, in `unit`s.

    `margin` is dimensionless in [0, 1] and independent of frame and unit; `verdict` is singular | close | regular and
    comes from the superbracket, never from the condition alone.
    """

    superbracket: Fraction
    condition: Fraction
    cofactor: Fraction
    margin: float
    verdict: str
    unit: str = ""

    def to_json(self) -> dict[str, Any]:
        """Exact numbers as text, the margin as a float."""
        return {
            "superbracket": str(self.superbracket),
            "condition": str(self.condition),
            "cofactor": str(self.cofactor),
            "margin": self.margin,
            "verdict": self.verdict,
            "unit": self.unit,
        }


def pose_value(
    structure: Structure,
    condition: Condition,
    points: Mapping[str, Sequence[Fraction]],
    *,
    close: float = CLOSE,
    unit: str = "",
) -> PoseValue:
    """Evaluate at exact homogeneous coordinates (x, y, z, 1) of every joint.

    Raises InputError for joints at infinity, and for joints so close to each other that floats cannot tell them apart.
    """
    if any(c[3] == 0 for c in points.values()):
        raise InputError("a pose needs finite joints (last coordinate not 0)")
    value, right, cofactor = (
        Fraction(evaluate(e, points)) for e in (structure.superbracket, condition.right_side, condition.cofactor)
    )
    size, verdict = judged(structure, _centred(structure, points), close) if value else (0.0, "singular")
    if value and not size:
        raise InputError("floats cannot tell the robot's joints apart", hint="check the units of the coordinates")
    return PoseValue(value, right, cofactor, size, verdict, unit)


def _centred(structure: Structure, points: Mapping[str, Sequence[Fraction]]) -> dict[str, XYZ]:
    """The places in floats, in a frame at the platform and a unit of the size of the whole: σ knows neither."""
    names = structure.names
    o = [points[(structure.platform or names)[0]][i] for i in range(3)]
    unit = max(abs(points[n][i] - o[i]) for n in names for i in range(3)) or Fraction(1)
    x, y, z = ({n: float((points[n][i] - o[i]) / unit) for n in names} for i in range(3))
    return {n: (x[n], y[n], z[n]) for n in names}


def measure(structure: Structure, points: Mapping[str, XYZ]) -> float:
    """The measure σ of `gcrules.screws.margin` in [0, 1], which is the same in every frame and unit; 0 for a leg
    of no length. Where the legs do not tell base from platform, `line_measure`.
    """
    return _measured(structure, points)[0]


def judged(structure: Structure, points: Mapping[str, XYZ], close: float = CLOSE) -> tuple[float, str]:
    """The measure, and singular | close | regular (below, from `close` on)."""
    size, floor = _measured(structure, points)
    return size, decide(size, floor, close=close)


def _measured(structure: Structure, points: Mapping[str, XYZ]) -> tuple[float, float]:
    """The measure, and what rounding may do to it."""
    if not all(n in structure.sides for leg in structure.legs for n in leg):
        return line_measure(structure.legs, points), FLOOR
    import numpy as np

    base, ends = (np.array([points[leg[i]] for leg in structure.oriented]) for i in (0, 1))
    if not np.linalg.norm(ends - base, axis=1).all() or on_one_line(ends):
        return 0.0, FLOOR
    j = jacobian(base, ends[None])
    places = np.array([points[n] for n in structure.names])
    size = float(np.sqrt(((places - places.mean(axis=0)) ** 2).sum(axis=1).mean()))
    return float(j.sigma[0]), float(noise(j, resolved(ROUNDING) * size)[0])


def line_measure(legs: Sequence[Leg], points: Mapping[str, XYZ]) -> float:
    """|det| of the six unit lines over the product of their rows' lengths (Hadamard's bound), in [0, 1].

    The moments are taken about the centroid of the joints and divided by their root-mean-square distance from it, so
    that neither the frame nor the unit matters. It needs no bodies, and has no unit that means anything. Derived here.
    """
    import numpy as np

    names = sorted({n for leg in legs for n in leg})
    xyz = np.array([points[n] for n in names])
    xyz = xyz - xyz.mean(axis=0)
    radius = np.sqrt((xyz**2).sum(axis=1).mean())
    at = dict(zip(names, xyz / radius if radius else xyz, strict=True))
    rows = []
    for a, b in legs:
        force = at[b] - at[a]
        length = np.linalg.norm(force)
        if not length:
            return 0.0
        rows.append(np.concatenate([force, np.cross(at[a], force)]) / length)
    sizes = np.linalg.norm(rows, axis=1)
    return float(abs(np.linalg.det(np.array(rows) / sizes[:, None])))


def line_points(plucker: Sequence[float], centre: XYZ, reach: float) -> tuple[XYZ, XYZ] | None:
    """Two points of a line given by Plücker coordinates (12, 13, 14, 23, 24, 34), `reach` to either side of the point
    nearest to `centre`; None for a line at infinity.
    """
    p12, p13, p14, p23, p24, p34 = map(float, plucker)
    d = (-p14, -p24, -p34)
    length = sum(c * c for c in d) ** 0.5
    scale = max(map(abs, (p12, p13, p14, p23, p24, p34)), default=0.0)
    if length <= 1e-12 * scale or not scale:
        return None
    unit = tuple(c / length for c in d)
    moment = (p23 / length, -p13 / length, p12 / length)  # about the origin: a × unit direction
    foot = cross(unit, moment)
    along = sum((c - f) * u for c, f, u in zip(centre, foot, unit, strict=True))
    first, last = (tuple(f + (along + s * reach) * u for f, u in zip(foot, unit, strict=True)) for s in (-1, 1))
    return (first[0], first[1], first[2]), (last[0], last[1], last[2])
