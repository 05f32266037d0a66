r"""Limits of leg lengths: which poses the actuators reach.

>>> parse_limits("leg lengths 1..3", ("ab", "cd"), "m").text
'1 ≤ ab ≤ 3, 1 ≤ cd ≤ 3 m'
>>> parse_limits("ab 1..2, cd ..3", ("ab", "cd")).high
(2.0, 3.0)
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.screws.pose import check_unit, read_number

__all__ = ["LengthLimits", "parse_limits"]

_ALL = ("leg lengths", "leg length", "legs", "lengths", "all")
_FORM = 'write "leg lengths 1..3", or for single legs "ab 1..3, cd 2..", in the unit of the file'


@dataclass(frozen=True)
class LengthLimits:
    """The least and the largest length of each leg, in `unit`; 0 and infinity where there is none."""

    names: tuple[str, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]
    unit: str = ""

    def allow(self, lengths: NDArray[Any]) -> NDArray[np.bool_]:
        """Which poses keep to the limits, lengths (…, 6)."""
        return np.asarray(((lengths >= self.low) & (lengths <= self.high)).all(axis=-1))

    def margin(self, lengths: NDArray[Any]) -> NDArray[np.float64]:
        """By how much poses keep to the limits, lengths (…, 6); below 0: not. Finite where there are no limits too."""
        high = np.where(np.isfinite(self.high), self.high, 1e300)
        return np.asarray(np.minimum(lengths - np.array(self.low), high - lengths).min(axis=-1))

    @property
    def text(self) -> str:
        parts = []
        if len(set(self.low)) == len(set(self.high)) == 1 and len(self.names) > 2:
            return f"{_range('every leg', self.low[0], self.high[0])} {self.unit}".rstrip()
        for name, low, high in zip(self.names, self.low, self.high, strict=True):
            if low or high < math.inf:
                parts.append(_range(name, low, high))
        return f"{', '.join(parts)} {self.unit}".rstrip()

    def to_json(self) -> dict[str, list[float | None]]:
        return {
            name: [low, high if high < math.inf else None]
            for name, low, high in zip(self.names, self.low, self.high, strict=True)
        }


def _range(name: str, low: float, high: float) -> str:
    below = f"{low:g} ≤ " if low else ""
    return f"{below}{name}{f' ≤ {high:g}' if high < math.inf else ''}"


def parse_limits(text: str, names: Sequence[str], unit: str = "") -> LengthLimits:
    """Read ranges "low..high" of all legs or of single ones (either bound may be left out); later ones count.

    Raises InputError for unknown legs, for reversed, empty or negative ranges, and for other units.
    """
    low, high = dict.fromkeys(names, 0.0), dict.fromkeys(names, math.inf)
    try:
        parts = [p.strip() for p in text.split(",") if p.strip()]
        if not parts:
            raise InputError("there are no limits", hint=_FORM)
        for part in parts:
            legs, least, most = _part(part, names, unit)
            for leg in legs:
                low[leg], high[leg] = least, most
    except GcrulesError as fault:
        raise fault.located(text, "--limits", Span(0, max(len(text), 1))) from None
    return LengthLimits(tuple(names), tuple(low.values()), tuple(high.values()), unit)


def _part(part: str, names: Sequence[str], unit: str) -> tuple[Sequence[str], float, float]:
    match = re.fullmatch(r"(.*?)\s*(\S*?)\.\.(\S*?)(?:\s+([^\s.]+))?", part)
    if not match:
        raise InputError(f"{part[:60]!r} is no range of lengths", hint=_FORM)
    who, first, last, word = match.groups()
    if word:
        check_unit(word, unit)
    known = {n.replace(" ", "").lower(): n for n in names}
    leg = known.get(who.replace(" ", "").lower())
    if leg is None and who and who.lower() not in _ALL:
        raise InputError(f"{who[:40]!r} is no leg", hint=near(who, tuple(names)) or f"the legs are {', '.join(names)}")
    if not (first or last):
        raise InputError("a range without bounds", hint=_FORM)
    least = float(read_number(first)) if first else 0.0
    most = float(read_number(last)) if last else math.inf
    if least < 0 or most < 0:
        raise InputError("lengths of legs are not negative")
    if least >= most:
        raise InputError(f"the range {first}..{last} is {'empty' if least == most else 'reversed'}", hint=_FORM)
    return [leg] if leg else names, least, most
