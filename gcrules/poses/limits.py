r"""Limits of leg lengths, or of the amounts of actuators: which poses they reach.

>>> parse_limits("leg lengths 1..3", ("ab", "cd"), "m").text
'1 ≤ ab ≤ 3, 1 ≤ cd ≤ 3 m'
>>> parse_limits("ab 1..2, cd ..3", ("ab", "cd")).high
(2.0, 3.0)
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.screws.pose import check_unit, read_number

__all__ = ["LengthLimits", "parse_limits"]

_ALL = ("leg lengths", "leg length", "legs", "lengths", "all")
_ANGLES = ("deg", "degree", "degrees", "°", "rad", "radian", "radians")
_RANGES = {
    "actuator": 'write "actuators -0.1..0.2", or for single ones "q1 -30..30 deg, q2 0.."',
    "coordinate": 'write "x -0.1..0.2, z 0.., yaw -30..30 deg"',
}
_FORM = 'write "leg lengths 1..3", or for single legs "ab 1..3, cd 2..", in the unit of the file'


@dataclass(frozen=True)
class LengthLimits:
    """The least and the largest length of each leg, in `unit`; 0 and infinity where there is none.

    Of a robot of joints `names` are its actuators, `angles` tells which of these are angles (in radians), and amounts
    from home may be negative: minus infinity where there is no least one.
    """

    names: tuple[str, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    unit: str = ""
    angles: tuple[bool, ...] = ()

    def allow(self, lengths: NDArray[Any]) -> NDArray[np.bool_]:
        """Which poses keep to the limits, lengths (…, 6)."""
        return np.asarray(((lengths >= self.low) & (lengths <= self.high)).all(axis=-1))

    def margin(self, lengths: NDArray[Any]) -> NDArray[np.float64]:
        """By how much poses keep to the limits, lengths (…, 6); below 0: not. Finite where there are no limits too."""
        high = np.where(np.isfinite(self.high), self.high, 1e300)
        low = np.where(np.isfinite(self.low), self.low, -1e300)
        return np.asarray(np.minimum(lengths - low, high - lengths).min(axis=-1))

    @property
    def text(self) -> str:
        parts = []
        if self.angles:
            return ", ".join(self._actuators())
        if len(set(self.low)) == len(set(self.high)) == 1 and len(self.names) > 2:
            return f"{_range('every leg', self.low[0], self.high[0])} {self.unit}".rstrip()
        for name, low, high in zip(self.names, self.low, self.high, strict=True):
            if low or high < math.inf:
                parts.append(_range(name, low, high))
        return f"{', '.join(parts)} {self.unit}".rstrip()

    def _actuators(self) -> Iterator[str]:
        for name, low, high, angle in zip(self.names, self.low, self.high, self.angles, strict=True):
            least, most = (math.degrees(c) if angle else c for c in (low, high))
            below = f"{least:.6g} ≤ " if low > -math.inf else ""
            above = f" ≤ {most:.6g}" if high < math.inf else ""
            if below or above:
                yield f"{below}{name}{above} {'deg' if angle else self.unit}".rstrip()

    def to_json(self) -> dict[str, list[float | None]]:
        return {
            name: [low if low > -math.inf else None, high if high < math.inf else None]
            for name, low, high in zip(self.names, self.low, self.high, strict=True)
        }


def _range(name: str, low: float, high: float) -> str:
    below = f"{low:g} ≤ " if low else ""
    return f"{below}{name}{f' ≤ {high:g}' if high < math.inf else ''}"


def parse_limits(
    text: str,
    names: Sequence[str],
    unit: str = "",
    angles: Sequence[bool] = (),
    *,
    noun: str = "actuator",
    option: str = "--limits",
) -> LengthLimits:
    """Read ranges "low..high" of all legs or of single ones (either bound may be left out); later ones count. With
    `angles`, one for each name, they are actuators of a robot of joints, or what else the `noun` says.

    Raises InputError for unknown legs, for reversed or empty ranges, negative lengths, and for other units.
    """
    low, high = dict.fromkeys(names, -math.inf if angles else 0.0), dict.fromkeys(names, math.inf)
    kinds = dict(zip(names, angles, strict=True)) if angles else {}
    try:
        parts = [p.strip() for p in text.split(",") if p.strip()]
        if not parts:
            raise InputError("there are no limits", hint=_RANGES[noun] if kinds else _FORM)
        for part in parts:
            legs, least, most, word = _part(part, names, unit, kinds, noun)
            for leg in legs:
                scale = _scale(leg, kinds[leg], word, unit) if kinds else 1.0
                low[leg], high[leg] = least * scale, most * scale
    except GcrulesError as fault:
        raise fault.located(text, option, Span(0, max(len(text), 1))) from None
    return LengthLimits(tuple(names), tuple(low.values()), tuple(high.values()), unit, tuple(angles))


def _scale(name: str, angle: bool, word: str | None, unit: str) -> float:
    """What a number of this unit is in radians or in the unit of the file."""
    turned = word is not None and word.lower() in _ANGLES
    if angle and not word:
        raise InputError(f"{name} is an angle without a unit", hint='end with deg or rad: "q1 -30..30 deg"')
    if angle != turned:
        kinds = ("an angle", "lengths") if angle else ("a length", "angles")
        raise InputError(f"{name} is {kinds[0]}, {word} a unit of {kinds[1]}", hint='as in "q1 -30..30 deg, q2 0..1"')
    if word is not None and not angle:
        check_unit(word, unit)
    return math.radians(1.0) if word is not None and angle and not word.lower().startswith("rad") else 1.0


def _part(
    part: str, names: Sequence[str], unit: str, kinds: Mapping[str, bool], noun: str
) -> tuple[Sequence[str], float, float, str | None]:
    match = re.fullmatch(r"(.*?)\s*(\S*?)\.\.(\S*?)(?:\s+([^\s.]+))?", part.replace("°", " °"))
    form, every = (_RANGES[noun], (f"{noun}s", noun, "all")) if kinds else (_FORM, _ALL)
    if not match:
        raise InputError(f"{part[:60]!r} is no range{'' if kinds else ' of lengths'}", hint=form)
    who, first, last, word = match.groups()
    if word and not kinds:
        check_unit(word, unit)
    known = {n.replace(" ", "").lower(): n for n in names}
    leg = known.get(who.replace(" ", "").lower())
    if leg is None and who and who.lower() not in every:
        one = noun if kinds else "leg"
        raise InputError(
            f"{who[:40]!r} is no {one}", hint=near(who, tuple(names)) or f"the {one}s are {', '.join(names)}"
        )
    if not (first or last):
        raise InputError("a range without bounds", hint=form)
    least = float(read_number(first)) if first else -math.inf if kinds else 0.0
    most = float(read_number(last)) if last else math.inf
    if not kinds and (least < 0 or most < 0):
        raise InputError("lengths of legs are not negative")
    if least >= most:
        raise InputError(f"the range {first}..{last} is {'empty' if least == most else 'reversed'}", hint=form)
    return [leg] if leg else names, least, most, word
