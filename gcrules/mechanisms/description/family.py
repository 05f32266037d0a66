r"""The family of a robot: points and directions made one after the other, and exact members of it.

>>> from gcrules.mechanisms.description.relations import relation
>>> family = Family((Definition("A", "point", relation("point", "free")),
...                  Definition("u", "direction", relation("direction", "free")),
...                  Definition("S", "point", relation("point", "in plane A perpendicular to u"))))
>>> at = family.member(1, RATIONALS)
>>> a, u, s = (at[n] for n in "AuS")
>>> RATIONALS.dot(tuple(p - q for p, q in zip(a, s)), u)
Fraction(0, 1)
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.seeds import DRAWN, drawn
from gcrules.mechanisms.description.relations import AXES, Relation, Values, Vector
from gcrules.screws import RATIONALS, RESIDUES, Field

__all__ = ["Definition", "Family", "Path", "circles", "in_order"]

_SMALL = 9


@dataclass(frozen=True)
class Definition:
    """The name of a point or direction (`sort`) with its defining relation, as written in `text`."""

    name: str
    sort: str
    relation: Relation
    text: str = ""

    @property
    def parameters(self) -> int:
        """How many random numbers it takes."""
        return self.relation.parameters(self.sort)


@dataclass(frozen=True)
class Family:
    """Definitions in an order in which each uses earlier ones only. In the `plane` all points have z = 0, directions
    too.
    """

    definitions: tuple[Definition, ...]
    plane: bool = False

    @cached_property
    def sorts(self) -> Mapping[str, str]:
        """ "point" or "direction" for every name, the axes of the frame included."""
        return {**dict.fromkeys(AXES, "direction"), **{d.name: d.sort for d in self.definitions}}

    @cached_property
    def parametrized(self) -> tuple[str, ...]:
        """Names that have parameters of their own."""
        return tuple(d.name for d in self.definitions if d.parameters)

    def parameters(self, seed: object, field: Field, *, decides: bool = False) -> dict[str, tuple[Any, ...]]:
        """Random parameters of every name: residues, which nobody can foresee (see `seeds`), or small whole numbers,
        the same in every run. With `decides` rational numbers are large and unforeseeable too.
        """
        exact = decides or field is not RATIONALS
        rng = drawn("robot", seed) if exact else random.Random(f"robot {seed}")
        found = {}
        for d in self.definitions:
            numbers = [rng.randrange(1, DRAWN) if exact else _small(rng) for _ in range(d.parameters)]
            if self.plane and len(numbers) == 3 and d.relation.kind == "free":
                numbers[2] = 0
            found[d.name] = tuple(field.number(n) for n in numbers)
        return found

    def at(self, parameters: Mapping[str, Sequence[Any]], field: Field) -> dict[str, Vector]:
        """The member with these parameters: Cartesian coordinates of all points and directions."""
        values: dict[str, Vector] = {n: field.vector(axis) for n, axis in AXES.items()}
        for d in self.definitions:
            values[d.name] = d.relation.value(d.sort, field, values, parameters[d.name])
        return values

    def member(self, seed: object, field: Field = RESIDUES, *, decides: bool = False) -> dict[str, Vector]:
        """A random exact member; see `parameters`."""
        return self.at(self.parameters(seed, field, decides=decides), field)

    def path(self, seed: object, name: str) -> Path:
        """Members that differ in the parameters of one name, along a line."""
        start, other = self.parameters((seed, "start"), RESIDUES), self.parameters((seed, "end"), RESIDUES)
        return Path(self, {n: start[n] for n in start}, name, other[name])

    def across(self, seed: object) -> Callable[[int], dict[str, Vector]]:
        """Members along a random line on which all parameters change; coordinates are polynomials modulo the prime.

        A common factor of polynomials in the parameters is found there as that of polynomials in one variable, and a
        factor of one of them divides another there only if it does so everywhere (but for lines of a chance of about
        degree² / 2^60).
        """
        start, step = self.parameters((seed, "from"), RESIDUES), self.parameters((seed, "to"), RESIDUES)

        def member(t: int) -> dict[str, Vector]:
            return self.at(
                {n: tuple(RESIDUES.reduced(a + t * b) for a, b in zip(start[n], step[n], strict=True)) for n in start},
                RESIDUES,
            )

        return member

    def merged(self, values: Values) -> bool:
        """Whether points of different names coincide at a member."""
        places = [values[d.name] for d in self.definitions if d.sort == "point"]
        return len(set(places)) < len(places)

    def level(self, points: Sequence[str], direction: str) -> bool:
        """Whether the points lie in one plane perpendicular to the direction at a random member, thus at all."""
        at = self.member("level")
        if not {*points, direction} <= at.keys():
            return False
        heights = {int(RESIDUES.dot(at[p], at[direction])) for p in points}
        return len(heights) == 1

    def homogeneous(self, values: Values) -> dict[str, tuple[Any, ...]]:
        """The values as points (x, y, z, 1) and, for directions, (x, y, z, 0)."""
        return {n: (*v, 0 if self.sorts.get(n, "direction") == "direction" else 1) for n, v in values.items()}


@dataclass(frozen=True, eq=False)
class Path:
    """Members along a line in the parameters of one name; every coordinate is a polynomial in t modulo the prime."""

    family: Family
    start: Mapping[str, tuple[Any, ...]]
    name: str
    step: tuple[Any, ...]

    def member(self, t: int) -> dict[str, Vector]:
        """The member at t."""
        own = tuple(RESIDUES.reduced(a + t * b) for a, b in zip(self.start[self.name], self.step, strict=True))
        values, moving = self._still
        found = dict(values)
        for d in moving:
            parameters = own if d.name == self.name else self.start[d.name]
            found[d.name] = d.relation.value(d.sort, RESIDUES, found, parameters)
        return found

    @cached_property
    def _still(self) -> tuple[dict[str, Vector], tuple[Definition, ...]]:
        """The member at the start, and the definitions of what moves, in their order."""
        names, moving = {self.name}, []
        for d in self.family.definitions:
            if d.name in names or not names.isdisjoint(d.relation.names):
                names.add(d.name)
                moving.append(d)
        return self.family.at(self.start, RESIDUES), tuple(moving)


def _small(rng: random.Random) -> Fraction:
    return Fraction(rng.choice([-1, 1]) * rng.randint(1, _SMALL))


def in_order(definitions: Iterable[Definition], cyclic: Callable[[tuple[str, ...]], None]) -> tuple[Definition, ...]:
    """The definitions so sorted that each uses earlier ones only; what is left over in a circle is told to `cyclic`."""
    left = list(definitions)
    found: list[Definition] = []
    known = set(AXES)
    while left:
        ready = [d for d in left if known.issuperset(d.relation.names)]
        if not ready:
            cyclic(tuple(d.name for d in left))
            break
        found += ready
        known.update(d.name for d in ready)
        left = [d for d in left if d.name not in known]
    return tuple(found)


def circles(needs: Mapping[str, Sequence[str]]) -> Iterator[tuple[str, ...]]:
    """Circles among names of which each needs another one, without those that only hang on a circle."""
    seen: set[str] = set()
    for start in needs:
        walk: list[str] = []
        name = start
        while name not in walk and name not in seen and needs.get(name):
            walk.append(name)
            name = needs[name][0]
        seen.update(walk)
        if name in walk:
            yield tuple(walk[walk.index(name) :])
