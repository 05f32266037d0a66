"""What a benchmark found: times beside each other, goals, and how they are shown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

__all__ = ["Measurement", "Over", "short", "show"]


class Over(float):
    """Seconds after which a form was stopped that had not finished."""


@dataclass
class Measurement:
    """Best times in seconds of one benchmark; ``None`` for a peer that is not there.

    `megabytes` are the most that processes had, by the names of forms; "" is the form itself.
    """

    name: str
    seconds: float
    others: Mapping[str, float | None]
    within: float | None = None
    at_least: Mapping[str, float] = field(default_factory=dict)
    megabytes: Mapping[str, float] = field(default_factory=dict)

    def ratio(self, other: str) -> float | None:
        """How many times longer the other form takes."""
        seconds = self.others[other]
        return None if seconds is None else seconds / self.seconds

    def memory(self, form: str = "") -> str:
        """The most memory that a form had; nothing where that was not measured."""
        return f"  {self.megabytes[form]:.0f} MB" if form in self.megabytes else ""

    def missed(self) -> list[str]:
        """The goals that were not reached, in words."""
        found = []
        if self.within is not None and self.seconds > self.within:
            found.append(f"{show(self.seconds)} is over the goal of {show(self.within)}")
        for other, goal in self.at_least.items():
            reached = self.ratio(other)
            if reached is not None and reached < goal:
                found.append(f"{reached:.3g} times faster than {other}, the goal is {goal:g}")
        return found


def show(seconds: float | None) -> str:
    """A time in a unit that suits it."""
    if seconds is None:
        return "not installed"
    if isinstance(seconds, Over):
        return f"over {seconds:g} s"
    for unit, size in (("s", 1), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def short(seconds: float) -> str:
    """A time in seconds or milliseconds, for tables."""
    return f"{seconds:.3g} s" if seconds >= 1 else f"{1000 * seconds:.3g} ms"
