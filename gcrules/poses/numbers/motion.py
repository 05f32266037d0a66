r"""At or near a singular pose: the motion that the platform gains, the dependent legs, and their line variety."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.language.legs_text import Leg
from gcrules.conditions.gained_motion import Screw, free_motions
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import kernel
from gcrules.poses.numbers.variety import Variety, variety
from gcrules.screws.margin import LegJacobians

__all__ = ["Dependence", "Twist", "dependence", "exact_dependence", "scaled", "softest_twist", "twist_of"]

Floats = NDArray[np.float64]
XYZ = tuple[float, float, float]

_TOLERANCE = 1e-6
_NOISE = 1e-9  # of coordinates beside others


@dataclass(frozen=True)
class Twist:
    """An instantaneous motion: a turn about the line through `point` along the unit vector `axis` with `pitch` as
    advance for each radian (a length; 0 is a pure turn). `point` is the foot of the perpendicular from the centroid of
    the legs' platform ends. A translation along `axis` has neither point nor pitch.
    """

    axis: XYZ
    point: XYZ | None
    pitch: float | None

    @property
    def kind(self) -> str:
        """translation, rotation or screw motion."""
        return "translation" if self.pitch is None else "screw motion" if self.pitch else "rotation"

    def to_json(self) -> dict[str, Any]:
        return {"kind": self.kind, "axis": self.axis, "point": self.point, "pitch": self.pitch}

    def text(self, unit: str = "") -> str:
        """In words, after "the platform can"."""
        axis = _tuple(self.axis)
        if self.point is None:
            return f"shift along {axis}"
        where = f"about the line through {_tuple(self.point)} along {axis}"
        if not self.pitch:
            return f"turn {where}"
        return f"screw {where} with pitch {self.pitch:.4g}{f' {unit}' if unit else ''}/rad"


def _tuple(numbers: Sequence[float]) -> str:
    """Coordinates with four digits; what is rounding beside the largest of them is 0."""
    least = _NOISE * max(map(abs, numbers))
    return "(" + ", ".join(f"{c if abs(c) > least else 0.0:.4g}" for c in numbers) + ")"


@dataclass(frozen=True)
class Dependence:
    """What the legs of a singular pose have in common.

    `motions` are independent gained motions; `stress` gives each leg's share in a balance of forces along the legs
    (largest 1; None where there are several independent balances); `legs` are those that take part in any, `within` the
    variety that they span, `all_legs` the variety of all six. `exact` says whether it was all exact arithmetic.
    """

    motions: tuple[Twist, ...]
    stress: tuple[float, ...] | None
    legs: tuple[str, ...]
    within: Variety
    all_legs: Variety
    exact: bool

    def to_json(self) -> dict[str, Any]:
        return {
            "motions": [m.to_json() for m in self.motions],
            "stress": None if self.stress is None else list(self.stress),
            "dependent_legs": list(self.legs),
            "variety": self.within.name,
            "variety_of_all_legs": self.all_legs.name,
            "exact": self.exact,
        }


def exact_dependence(
    legs: Sequence[Leg], names: Sequence[str], points: Mapping[str, Sequence[Fraction]], centroid: Floats
) -> Dependence:
    """At a pose that is singular exactly; points are homogeneous with last coordinate 1."""
    rows = []
    for a, b in legs:
        p, q = points[a][:3], points[b][:3]
        moment = (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])
        rows.append((*(d - c for c, d in zip(p, q, strict=True)), *moment))
    balances = kernel(list(zip(*rows, strict=True)), 6)
    taking = [i for i in range(6) if any(v[i] for v in balances)]
    lengths = [float(sum(c * c for c in row[:3])) ** 0.5 for row in rows]
    stress = None
    if len(balances) == 1:
        stress = scaled([float(c) * length for c, length in zip(balances[0], lengths, strict=True)])
    return Dependence(
        motions=tuple(_twist_of(s, centroid) for s in free_motions(legs, points)),
        stress=stress,
        legs=tuple(names[i] for i in taking),
        within=variety(_independent([rows[i] for i in taking])),
        all_legs=variety(_independent(rows)),
        exact=True,
    )


def dependence(j: LegJacobians, names: Sequence[str], n: int = 0) -> Dependence:
    """At pose n, which is singular within the accuracy of the numbers: singular values below 1e-6 count as zero."""
    rows = j.rows[n]
    left, s, _ = np.linalg.svd(rows)
    rank = min(int((s > _TOLERANCE * s[0]).sum()), 5)
    balances = left[:, rank:].T
    taking = [i for i in range(6) if np.abs(balances[:, i]).max() > _TOLERANCE]
    right = np.linalg.svd(rows)[2][rank:]
    return Dependence(
        motions=tuple(twist_of(v[:3], v[3:] / j.radius, j.centroid[n], j.radius) for v in right),
        stress=scaled(balances[0].tolist()) if rank == 5 else None,
        legs=tuple(names[i] for i in taking),
        within=_spanned(rows[taking]),
        all_legs=_spanned(rows),
        exact=False,
    )


def softest_twist(j: LegJacobians, n: int = 0) -> Twist:
    """The motion of the platform that the legs notice least in pose n: Σ (u_i·v_i)² = σ² Σ |v_i|²."""
    v = j.softest[n]
    return twist_of(v[:3], v[3:] / j.radius, j.centroid[n], j.radius)


def _spanned(rows: Floats) -> Variety:
    _, s, right = np.linalg.svd(rows)
    rank = max(1, min(int((s > _TOLERANCE * s[0]).sum()), len(rows) - 1 if len(rows) > 1 else 1, 5))
    return variety([tuple(map(float, v)) for v in right[:rank]], _TOLERANCE)


def _independent(rows: Sequence[Sequence[Fraction]]) -> list[Sequence[Fraction]]:
    chosen: list[Sequence[Fraction]] = []
    for row in rows:
        if len(kernel([*chosen, row], 6)) == 5 - len(chosen):
            chosen.append(row)
    return chosen


def scaled(stress: Sequence[float]) -> tuple[float, ...]:
    """The same ratio with 1 as its largest entry."""
    largest = max(stress, key=abs)
    return tuple(c / largest if abs(c / largest) > 1e-12 else 0.0 for c in stress)


def _twist_of(s: Screw, centroid: Floats) -> Twist:
    axis = np.array([float(c) for c in s.axis])
    axis /= np.linalg.norm(axis)
    if s.foot is None or s.pitch is None:
        return Twist(_xyz(axis), None, None)
    foot = np.array([float(c) for c in s.foot])
    return Twist(_xyz(axis), _xyz(foot + axis * float((centroid - foot) @ axis)), float(s.pitch))


def twist_of(velocity: Floats, turn: Floats, centroid: Floats, radius: float) -> Twist:
    """From the velocity of the centroid and the angular velocity; a turn so slow that it moves no joint is none."""
    size = float(np.linalg.norm(turn))
    if size * radius <= 1e-9 * float(np.linalg.norm(velocity)):
        return Twist(_xyz(velocity / np.linalg.norm(velocity)), None, None)
    axis = turn / size
    pitch = float(axis @ velocity) / size
    foot = centroid + np.cross(turn, velocity) / size**2
    return Twist(_xyz(axis), _xyz(foot), pitch if abs(pitch) > 1e-9 * radius else 0.0)


def _xyz(v: Floats) -> XYZ:
    x, y, z = (float(c) for c in v)
    return x, y, z
