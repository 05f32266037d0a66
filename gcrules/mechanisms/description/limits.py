r"""Limits of leg lengths, or of the amounts of actuators, as files and commands have them: which poses they reach.

>>> parse_limits("leg lengths 1..3", ("ab", "cd"), "m").text
'1 ≤ ab ≤ 3, 1 ≤ cd ≤ 3 m'
>>> parse_limits("ab 1..2, cd ..3", ("ab", "cd")).high
(2.0, 3.0)
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from gcrules.algebra.language.legs_text import leg_text
from gcrules.core.dataclass import dataclass
from gcrules.core.english import with_article
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.mechanisms.description.driven import driven_freedoms
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.screws.pose import check_unit, read_number

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

__all__ = ["LengthLimits", "limits_of_legs", "limits_of_limbs", "parse_limits"]

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
    from home may be negative: minus infinity where there is no least one. `of_file` says that the robot's file has
    them, and that nobody asked for others.
    """

    names: tuple[str, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    unit: str = ""
    angles: tuple[bool, ...] = ()
    of_file: bool = False

    def allow(self, lengths: NDArray[Any]) -> NDArray[np.bool_]:
        """Which poses keep to the limits, lengths (…, 6)."""
        return cast("NDArray[np.bool_]", ((lengths >= self.low) & (lengths <= self.high)).all(axis=-1))

    def margin(self, lengths: NDArray[Any]) -> NDArray[np.float64]:
        """By how much poses keep to the limits, lengths (…, 6); below 0: not. Finite where there are no limits too."""
        high = tuple(c if math.isfinite(c) else 1e300 for c in self.high)
        low = tuple(c if math.isfinite(c) else -1e300 for c in self.low)
        return cast("NDArray[np.float64]", (lengths - low).clip(max=high - lengths).min(axis=-1))

    @property
    def text(self) -> str:
        """In words."""
        return self._text + " (of the file)" * self.of_file

    @property
    def _text(self) -> str:
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
    others: Mapping[str, tuple[str, ...]] = FrozenMap(),
    noun: str = "actuator",
    option: str = "--limits",
) -> LengthLimits:
    """Read ranges "low..high" of all legs or of single ones (either bound may be left out); later ones count. With
    `angles`, one for each name, they are actuators of a robot of joints, or what else the `noun` says. `others` are
    further words, each for some of the names.

    Raises InputError, with its place in the text, for unknown legs, for reversed or empty ranges, negative lengths, and
    for other units.
    """
    low, high = dict.fromkeys(names, -math.inf if angles else 0.0), dict.fromkeys(names, math.inf)
    kinds = dict(zip(names, angles, strict=True)) if angles else {}
    known = {"".join(n.split()).lower(): own for n, own in (*others.items(), *((n, (n,)) for n in names))}
    parts = [m for m in re.finditer(r"[^,]+", text) if m[0].strip()]
    place = Span(0, max(len(text), 1))
    try:
        if not parts:
            raise InputError("there are no limits", hint=_RANGES[noun] if kinds else _FORM)
        for part in parts:
            place = Span(part.end() - len(part[0].lstrip()), part.start() + len(part[0].rstrip()))
            legs, least, most, word = _part(part[0].strip(), names, unit, kinds, known, noun)
            for leg in legs:
                scale = _scale(leg, kinds[leg], word, unit) if kinds else 1.0
                low[leg], high[leg] = least * scale, most * scale
    except GcrulesError as fault:
        raise fault.located(text, option, place) from None
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
    part: str,
    names: Sequence[str],
    unit: str,
    kinds: Mapping[str, bool],
    known: Mapping[str, tuple[str, ...]],
    noun: str,
) -> tuple[Sequence[str], float, float, str | None]:
    match = re.fullmatch(r"(.*?)\s*(\S*?)\.\.(\S*?)(?:\s+([^\s.]+))?", part.replace("°", " °"))
    form, every = (_RANGES[noun], (f"{noun}s", noun, "all")) if kinds else (_FORM, _ALL)
    if not match:
        raise InputError(f"{part[:60]!r} is not a range{'' if kinds else ' of lengths'}", hint=form)
    who, first, last, word = match.groups()
    if word and not kinds:
        check_unit(word, unit)
    own = known.get("".join(who.split()).lower())
    if own is None and who and who.lower() not in every:
        one = noun if kinds else "leg"
        general = form if who.lower() in (*_ALL, "actuators", "actuator") else None
        raise InputError(
            f"{who[:40]!r} is not {with_article(one)}",
            hint=general or near(who, tuple(names)) or f"the {one}s are {', '.join(names)}",
        )
    if not (first or last):
        raise InputError("a range without bounds", hint=form)
    least = float(read_number(first)) if first else -math.inf if kinds else 0.0
    most = float(read_number(last)) if last else math.inf
    if not kinds and (least < 0 or most < 0):
        raise InputError("lengths of legs are not negative")
    if least >= most:
        raise InputError(f"the range {first}..{last} is {'empty' if least == most else 'reversed'}", hint=form)
    return own or names, least, most, word


def limits_of_limbs(text: str, limbs: Sequence[LimbSpec], unit: str = "", option: str = "--limits") -> LengthLimits:
    """Limits of the actuators of limbs, q1, q2 … in their order; the name of a driven joint stands for all joints that
    bear it. Raises InputError as `parse_limits`, and where nothing is driven.
    """
    driven = driven_freedoms(limbs)
    if not driven:
        raise InputError("limits apply to actuators, and no joint is driven").located(text, option, Span(0, len(text)))
    joints: dict[str, tuple[str, ...]] = {}
    for d in driven:
        if d.joint:
            joints[d.joint] = (*joints.get(d.joint, ()), d.name)
    names, angles = tuple(d.name for d in driven), tuple(d.angle for d in driven)
    return parse_limits(text, names, unit, angles, others=joints, option=option)


def limits_of_legs(
    text: str, legs: Sequence[tuple[str, str]], unit: str = "", option: str = "--limits"
) -> LengthLimits:
    """Limits of the lengths of legs, each named from either end. Raises InputError as `parse_limits`."""
    names = tuple(leg_text(leg) for leg in legs)
    back = {leg_text((b, a)): (name,) for (a, b), name in zip(legs, names, strict=True)}
    return parse_limits(text, names, unit, others=back, option=option)
