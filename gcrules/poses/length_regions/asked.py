r"""Which lengths are asked for: the leg that is held, and the ranges of the others."""

from __future__ import annotations

from fractions import Fraction
from math import inf

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.limits import parse_limits
from gcrules.poses.length_regions.three_legs import ThreeLegs
from gcrules.screws.pose_text import read_named

__all__ = ["Asked", "Range"]

Range = tuple[Fraction, Fraction]


@dataclass(frozen=True)
class Asked:
    """The numbers of the legs that are free and their ranges; the leg that is held and the square of its length, if one
    is.
    """

    free: tuple[int, ...]
    ranges: tuple[Range, ...]
    held: int | None = None
    square: Fraction = Fraction(0)

    @classmethod
    def of(cls, legs: ThreeLegs, over: str | None, held: str | None) -> Asked:
        """Raises InputError for what is no range and no length."""
        limits = parse_limits(over, legs.names, option="--over") if over is not None else None
        low, high = (limits.low, limits.high) if limits else ((0.0,) * 3, (inf,) * 3)
        ranged = [k for k in range(3) if low[k] > 0 or high[k] < inf]
        given = {}
        if held is not None:
            given = read_named(held, dict.fromkeys(legs.names, False), option="--held", what="actuator")
        if len(given) > 1:
            raise InputError("two legs are held at once", hint="hold one of three; the others are free")
        if len(ranged) == 3 and not given:
            if inf in high:
                raise InputError("a range of three without an upper end", hint='as in "q1 0..4, q2 0..4, q3 0..4"')
            return cls((0, 1, 2), tuple((_exact(a), _exact(b)) for a, b in zip(low, high, strict=True)))
        still = legs.names.index(next(iter(given))) if given else next(k for k in range(3) if k not in ranged)
        if still in ranged:
            raise InputError(f"{legs.names[still]} is held, and has a range", hint="leave one of them out")
        length = next((a.number for a in given.values()), None)
        if length is not None and length <= 0:
            raise InputError(f"the length {float(length):g} of {legs.names[still]} is not positive")
        square = legs.squares[still] if length is None else length**2
        if not square:
            raise InputError(
                f"{legs.names[still]} has no length at home", hint=f'hold it at one: "{legs.names[still]}=1"'
            )
        free = tuple(k for k in range(3) if k != still)
        ranges = []
        for k in free:
            reach = legs.reach(k, still, square)
            if low[k] >= reach:
                raise InputError(
                    f"{legs.names[k]} cannot be as long as {low[k]:g}", hint=f"it reaches {float(reach):g}"
                )
            ranges.append((_exact(low[k]), reach if high[k] > reach else _exact(high[k])))
        return cls(free, tuple(ranges), still, square)


def _exact(x: float) -> Fraction:
    """The number as it is written."""
    return Fraction(repr(x))
