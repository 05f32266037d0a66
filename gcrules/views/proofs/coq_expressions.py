"""Expressions of a theorem as Coq reads them: as statements on points, and as the data that proofs compute with."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from math import lcm
from typing import Any

__all__ = ["RESERVED", "SPACES", "Expressions", "derived", "geometry", "multiple", "nested", "point_names"]

SPACES = {3: "plane", 4: "space"}  # with coordinates of their own in the library, and theorems under assumptions
RESERVED = frozenset(  # words of Coq, and names that statements and proofs use
    re.findall(
        r"\w+",
        "as at by cofix else end exists exists2 fix for forall fun if IF in let match mod return then using where with "
        "Prop Set SProp Type bracket extensor infinite number place plane power pure space superbracket vector "
        "I conj eq_refl list nat nth true vanishes",
    )
)
_SIGNS = {"join": " ∨ ", "meet": " ∧ ", "sum": " + ", "product": " · "}
_CONSTRUCTORS = {"join": "Join", "meet": "Meet", "sum": "Sum", "product": "Join"}


def geometry(rank: int) -> str:
    """What Coq calls the space of a rank."""
    return SPACES.get(rank, f"rank_{rank}")


def multiple(e: Any, factor: int) -> Any:
    return e if factor == 1 else ["product", ["number", factor], e]


class Expressions:
    """The expressions of a theorem with whole numbers, as statements and as data."""

    def __init__(self, name: str, t: dict[str, Any]) -> None:
        self.name = name
        self.rank: int = t["rank"]
        self.points = point_names(t["points"])
        self.place = {p: i for i, p in enumerate(t["points"])}
        self.factors: dict[str, int] = {}
        self.inverse: tuple[int, str] | None = None  # a number and the point that is a bracket 1 / number
        self.definitions: list[tuple[str, Any]] = []
        for n, e in t["definitions"]:
            found, factor = self.whole(e)
            self.factors[n] = factor
            self.definitions.append((defined(n), found))

    def whole(self, e: Any) -> tuple[Any, int]:
        """A multiple of an expression, and by what it is multiplied, so that all its numbers are whole."""
        if isinstance(e, str):
            return e, self.factors.get(e, 1)
        kind, *parts = e
        if kind == "number":
            value = Fraction(parts[0])
            return ["number", value.numerator], value.denominator
        if kind == "power":
            base, factor = self.whole(parts[0])
            return ["power", base, parts[1]], factor ** parts[1]
        found = [self.whole(part) for part in parts]
        if kind == "sum":
            common = lcm(*(factor for _, factor in found))
            return ["sum", *(multiple(part, common // factor) for part, factor in found)], common
        factor = 1
        for _, further in found:
            factor *= further
        return [kind, *(part for part, _ in found)], factor

    def fraction(self, e: Any) -> Any:
        """A number that is no whole one as a whole one times a bracket; any other as it is."""
        if self.inverse is None or Fraction(e[1]).denominator == 1:
            return e
        number, point = self.inverse
        units = [f"unit {i}" for i in range(2, self.rank + 1)]
        return ["product", ["number", int(Fraction(e[1]) * number)], ["bracket", point, *units]]

    def plain(self, e: Any) -> Any:
        """A superbracket as what it is: on a line one bracket, in the plane the meet of three lines."""
        instead = {2: "bracket", 3: "meet"}.get(self.rank)
        return [instead, *e[1:]] if e[0] == "superbracket" and instead else e

    def statement(self, e: Any) -> str:
        """An expression on points."""
        if isinstance(e, str):
            return self.points[self.place[e]] if e in self.place else defined(e)
        kind, *parts = self.plain(self.fraction(e) if e[0] == "number" else e)
        if kind == "number":
            return f"(number {geometry(self.rank)} ({parts[0]}))"
        if kind == "power":
            return f"(power {self.statement(parts[0])} {parts[1]})"
        written = [self.statement(part) for part in parts]
        if kind == "bracket":
            return f"(bracket ({_SIGNS['join'].join(written)}))"
        if kind == "superbracket":
            return f"(superbracket {' '.join(written)})"
        return f"({_SIGNS[kind].join(written)})"

    def side(self, e: Any) -> str:
        """An expression on points, as a side of an equation: of a point the extensor that it is."""
        written = self.statement(e)
        return f"({written} : extensor {geometry(self.rank)})" if isinstance(e, str) and e in self.place else written

    def data(self, e: Any) -> str:
        """An expression as it is computed with."""
        if isinstance(e, str):
            return f"(Point {self.place[e]})" if e in self.place else derived(self.name, defined(e))
        kind, *parts = self.plain(self.fraction(e) if e[0] == "number" else e)
        if kind == "number":
            return f"(Number ({parts[0]}))"
        if kind == "power":
            return f"(Power {self.data(parts[0])} {parts[1]})"
        written = [self.data(part) for part in parts]
        if kind == "bracket":
            return f"(Bracket {nested('Join', written)})"
        if kind == "superbracket":
            return f"(Superbracket {' '.join(written)})"
        return nested(_CONSTRUCTORS[kind], written)


def nested(constructor: str, parts: Sequence[str]) -> str:
    found = parts[0]
    for part in parts[1:]:
        found = f"({constructor} {found} {part})"
    return found


def derived(name: str, part: str) -> str:
    """The name of what belongs to a theorem; neither theorems nor points have two underscores together."""
    return f"{name}__{part}"


def defined(name: str) -> str:
    return name.replace("#", "part_")


def point_names(points: Sequence[str]) -> list[str]:
    taken: list[str] = []
    for i, p in enumerate(points):
        fits = re.fullmatch(r"(?!.*__|part_|plane_|space_|rank_)[A-Za-z][A-Za-z0-9_']*", p) and p not in RESERVED
        name = p if fits else f"point_{i}"
        while name in taken or (name != p and name in points):
            name += "_"
        taken.append(name)
    return taken
