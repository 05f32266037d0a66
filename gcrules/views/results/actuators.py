"""The legs or actuators at a pose as a table: how long or how far they are, what they reach, what they make of it."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, isfinite

from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.report import PoseReport
from gcrules.views.results.amplification import amplification_rows
from gcrules.views.results.result_account import Grid

__all__ = ["actuator_grid", "reaches"]


def reaches(m: Mechanism) -> dict[str, tuple[float | None, float | None]]:
    """What the file says that each leg or actuator reaches: lengths, and degrees from home; None where there is no
    limit.
    """
    if not m.limits:
        return {}
    found = m.read_limits(m.limits)
    angles = found.angles or (False,) * len(found.names)

    def shown(value: float, angle: bool) -> float | None:
        return (degrees(value) if angle else value) if isfinite(value) else None

    rows = zip(found.names, found.low, found.high, angles, strict=True)
    return {name: (shown(low, angle), shown(high, angle)) for name, low, high, angle in rows}


def actuator_grid(r: PoseReport | RobotPose, m: Mechanism) -> Grid:
    """Of each leg its length, of each actuator its amount from home, with the limits of its file, and the speed and the
    turn that it gives to the platform at unit rate.
    """
    legs = isinstance(r, PoseReport)
    driven = {name: rest for name, *rest in amplification_rows(r.jacobian.amplification, m.unit)}
    known = reaches(m)
    head = ["leg" if legs else "actuator", "length" if legs else "from home"]
    head += ["limits"] * bool(known) + ["speed of the centre", "turn"] * bool(driven)
    rows = []
    for name, value, angle in _amounts(r):
        unit = "°" if angle else f" {m.unit}".rstrip()
        amount = degrees(value) if angle else value
        limits = [_limits(amount, *known.get(name, (None, None)), unit)] * bool(known)
        rows.append((name, f"{_number(amount)}{unit}", *limits, *driven.get(name, ("", "") if driven else ())))
    return Grid(tuple(head), tuple(rows), "Legs" if legs else "Actuators")


def _amounts(r: PoseReport | RobotPose) -> Iterator[tuple[str, float, bool]]:
    angles = {} if isinstance(r, PoseReport) else {a.name: a.angle for a, _ in r.actuators}
    for name, value in r.actuator_values.items():
        yield name, value, angles.get(name, False)


def _limits(value: float, low: float | None, high: float | None, unit: str) -> str:
    """The limits, and by how much the value is beyond them."""
    if low is None and high is None:
        return "none"
    words = f"{'' if low is None else _number(low)} … {'' if high is None else _number(high)}".strip() + unit
    out = max(0.0 if low is None else low - value, 0.0 if high is None else value - high)
    return f"{words}, beyond by {_number(out)}{unit}" if out > 0 else words


def _number(x: float) -> str:
    return f"{0.0 if abs(x) < 1e-12 else x:.4g}"
