"""Robots as their files describe them: limbs of joints over a family of points and directions, as frozen values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from gcrules.frozen import FrozenMap
from gcrules.robots.family import Definition, Family
from gcrules.robots.limbs import LimbText

__all__ = ["Fact", "RobotText"]

Vector = tuple[Fraction, Fraction, Fraction]


@dataclass(frozen=True)
class Fact:
    """What the file says follows from the relations, as a relation of a name, and as written."""

    said: Definition
    text: str


@dataclass(frozen=True, repr=False)
class RobotText:
    """A robot as its file describes it; `Robot` adds what can be done with it.

    `family` holds the points and directions with the relations that make them, `limbs` the joints; `lines` are given in
    place of limbs where wrenches are known already. `mobility` is that expected of the platform (checked), `home` one
    configuration (empty for names that the relations determine), `condition` a published one in the language.
    """

    id: str
    title: str
    family: Family
    limbs: tuple[LimbText, ...]
    mobility: int
    lines: tuple[tuple[str, str], ...] = ()
    platform: tuple[str, ...] = ()
    home: Mapping[str, Vector] | None = None
    condition: str = ""
    source: str = ""
    note: str = ""
    facts: tuple[Fact, ...] = ()
    filename: str = "<input>"
    owner: str = ""

    def __post_init__(self) -> None:
        if self.home is not None:
            object.__setattr__(self, "home", FrozenMap(self.home))

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.id}: {self.chain or 'given by its lines'}, mobility {self.mobility}>"

    @property
    def chain(self) -> str:
        """The limbs' joints in short: 3-UP*S, 2-UP*R + SP*R."""
        counts: dict[str, int] = {}
        for limb in self.limbs:
            counts[limb.chain] = counts.get(limb.chain, 0) + 1
        return " + ".join(f"{n}-{chain}" if n > 1 else chain for chain, n in counts.items())
