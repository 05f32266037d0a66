r"""When a pose is close to singular: a threshold in a meaningful unit, and the verdict with its reason."""

from __future__ import annotations

import math
from fractions import Fraction

from gcrules.core.arguments import described
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.floats import rounded_down
from gcrules.screws.pose import check_unit, read_number

__all__ = [
    "DEFAULT",
    "Threshold",
    "angle_threshold",
    "degrees",
    "margin_of",
    "parse_length",
    "parse_threshold",
    "safe",
    "threshold_of",
    "turn_of",
]

_ANGLES = {"deg": math.pi / 180, "°": math.pi / 180, "rad": 1.0}


@dataclass(frozen=True)
class Threshold:
    """`angle` (radians): how far every leg can turn relative to the platform without a singular pose; or `length`: how
    far the platform can shift at its orientation. The other is None.
    """

    angle: float | None = None
    length: float | None = None
    text: str = ""


def margin_of(angle: float) -> float:
    """The margin σ that guarantees this turn (radians) of a leg, or of a limb's wrenches: its sine. No margin, which is
    at most 1, guarantees more than a right angle: 2 for that.
    """
    return math.sin(angle) if angle <= math.pi / 2 else 2.0


def turn_of(margin: float) -> float:
    """The turn (radians) that a margin guarantees: no pose is singular before some leg, or the wrenches of some limb,
    have turned by asin σ relative to the platform.
    """
    return math.asin(min(max(margin, 0.0), 1.0))


DEFAULT = Threshold(angle=math.radians(0.5), text="0.5 deg")
"""No leg turns by half a degree (an example; choose your own for a real robot)."""


def threshold_of(given: str | Threshold, unit: str = "") -> Threshold:
    """What a user gives as a threshold. Raises InputError for anything without a unit."""
    if isinstance(given, Threshold):
        return given
    if not isinstance(given, str):
        raise InputError(f"the threshold {described(given)} has no unit", hint='write threshold="2 deg" or "5 mm"')
    return parse_threshold(given, unit)


def angle_threshold(given: str | Threshold, where: str) -> Threshold:
    """The same `where` only angles have a meaning ("in a map"). Raises InputError for a length, in whatever unit."""
    word = _parts(given)[1] if isinstance(given, str) else "rad"
    if not word:
        raise InputError("a threshold without a unit", hint="write 2deg or 0.03rad")
    if word not in _ANGLES or (isinstance(given, Threshold) and given.angle is None):
        shown = given.text if isinstance(given, Threshold) else str(given).strip()
        raise InputError(
            f"{where} the threshold is an angle, not {shown[:40]}",
            hint="how far a leg, or a limb's wrenches, may turn relative to the platform, as in 2deg",
        )
    return threshold_of(given)


def parse_threshold(text: str, unit: str = "") -> Threshold:
    """Read "2 deg", "0.03 rad", or a length in the robot's unit "5 mm". Raises InputError for anything else."""
    number, word = _parts(text)
    if number <= 0:
        raise InputError(f"the threshold {text.strip()[:40]} is not positive")
    if word in _ANGLES:
        angle = float(number) * _ANGLES[word]
        if angle > math.pi / 2:
            raise InputError(
                f"the threshold {text.strip()[:40]} is more than a right angle, which no margin guarantees",
                hint="every pose would be close; write an angle up to 90deg",
            )
        return Threshold(angle=angle, text=text.strip())
    if not word:
        raise InputError("a threshold without a unit", hint=f"write 2deg, 0.03rad or 5{unit or 'mm'}")
    check_unit(word, unit)
    return Threshold(length=float(number), text=text.strip())


def parse_length(text: str, unit: str = "") -> float:
    """Read a length ≥ 0 with or without the robot's unit. Raises InputError for anything else."""
    number, word = _parts(text)
    if word:
        check_unit(word, unit)
    if number < 0:
        raise InputError(f"the length {text.strip()[:40]} is negative")
    return float(number)


def _parts(text: str) -> tuple[Fraction, str]:
    whole = text.strip()
    word = whole[len(whole.rstrip("abcdefghijklmnopqrstuvwxyz°")) :]
    if whole.lower() in ("nan", "inf", "-inf", "infinity"):
        word = ""
    return read_number(whole.removesuffix(word).strip() or whole), word


def safe(bound: float, unit: str | None = None, digits: int = 3) -> str:
    """A change below which nothing is singular, as text: never more than it is. Without a unit of lengths, which may be
    "", it is an angle in radians, written in degrees.

    >>> safe(math.asin(0.27527)), safe(12.3456, "mm"), safe(0.0)
    ('15.9°', '12.3 mm', '0°')
    """
    if unit is None:
        return f"{rounded_down(math.degrees(bound), digits)}°"
    return f"{rounded_down(bound, digits)} {unit}".rstrip()


def degrees(angle: float) -> str:
    """An angle in radians as text in degrees."""
    return f"{math.degrees(angle):.3g}°"
