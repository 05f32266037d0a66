r"""Over which coordinates a region extends, and in which proportions.

>>> [(e.name, e.width) for e in parse_extents("x, rz 10 deg", {"x": False, "rz": True}, 2.0, "mm")]
[('x', 2.0), ('rz', 0.17453292519943295)]
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import radians

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.screws.pose import check_unit, read_number

__all__ = ["ACTUATORS", "Extent", "parse_extents"]

ACTUATORS = "actuators"
"""The word for all actuators."""

_MOST = 1e6
_FORM = 'write "x, y, z", with proportions "x 2, y 1, rz 30 deg", or "actuators"'


@dataclass(frozen=True)
class Extent:
    """A coordinate, and by how much it changes where others change by theirs: a length, or rad."""

    name: str
    width: float


def parse_extents(text: str, angles: Mapping[str, bool], size: float, unit: str) -> tuple[Extent, ...]:
    """Read names with proportions: those left out are the robot's size, or 1 rad. `angles` tells which names there are,
    and which of them are angles. Raises InputError.
    """
    try:
        parts = [part.strip() for part in text.split(",") if part.strip()]
        if not parts:
            raise InputError("no coordinate is named", hint=_FORM)
        found = [_extent(part, angles, size, unit) for part in parts]
        names = [e.name for e in found]
        twice = next((n for n in names if names.count(n) > 1), None)
        if twice is not None:
            raise InputError(f"{twice} is named twice")
    except GcrulesError as fault:
        raise fault.located(text, "--over", Span(0, max(len(text), 1))) from None
    return tuple(found)


def _extent(part: str, angles: Mapping[str, bool], size: float, unit: str) -> Extent:
    match = re.fullmatch(r"(\S+)(?:\s+(\S+?))?(?:\s*(deg|°|rad|[a-zA-Zµ]+))?", part)
    if match is None:
        raise InputError(f"{part[:40]!r} is not a coordinate with its width", hint=_FORM)
    name, number, word = match.groups()
    if name not in angles:
        known = ", ".join(angles)
        raise InputError(f"{name[:40]!r} is not a coordinate", hint=near(name, tuple(angles)) or f"there are {known}")
    angle = angles[name]
    if number is None:
        return Extent(name, 1.0 if angle else size)
    width = float(read_number(number))
    if not 0 < width <= _MOST * (1.0 if angle else size):
        least = "above 0" if width <= 0 else f"of {_MOST:g} of the robot's sizes, or rad, at most"
        raise InputError(f"the width of {name} is {number}, expected one {least}")
    if angle and word not in ("deg", "°", "rad"):
        raise InputError(f"{name} is an angle without a unit", hint='end with deg or rad: "rz 30 deg"')
    if not angle and word is not None:
        check_unit(word, unit)
    return Extent(name, radians(width) if word in ("deg", "°") else width)
