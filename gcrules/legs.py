r"""Structure: six legs as a graph between base and platform joints.

>>> s = read_legs("ab af cb cd ed ef")
>>> s.base, s.platform
(('a', 'c', 'e'), ('b', 'd', 'f'))
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.expr import Expr, Join, Point, join, superbracket
from gcrules.algebra.syntax import Context, parse
from gcrules.algebra.text import SHORT_NAME, Names, split_names
from gcrules.errors import GcrulesError, InputError, Span, StepError

__all__ = ["Leg", "Structure", "leg_text", "legs_text", "read_legs", "read_order"]

Leg = tuple[str, str]


def leg_text(leg: Leg) -> str:
    """A leg as it is written: ab, S1A1, and with a space between longer names: left top."""
    return str(join(*map(Point, leg)))


def legs_text(legs: Iterable[Leg]) -> str:
    """Legs as one text that `read_legs` takes (with its `points` for names of several letters).

    >>> legs_text([("a", "b"), ("S1", "A1")]), legs_text([("a", "b"), ("left", "top")])
    ('ab S1A1', 'ab, left top')
    """
    words = [leg_text(leg) for leg in legs]
    return (", " if any(" " in word for word in words) else " ").join(words)


@dataclass(frozen=True)
class Structure:
    """Six legs exactly as typed, and what follows from their graph alone.

    Each connected part of the graph that is free of odd cycles has two sides. Which of them is the base is read from
    the written order of most of its legs (of its first leg where they balance). In `oriented` a leg that was written
    the other way round is turned; legs in parts with an odd cycle stay as typed and their joints have no side.
    """

    legs: tuple[Leg, ...]
    points: tuple[str, ...] = ()
    ideal: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        number = len(self.legs)
        if number != 6:
            hint = "each leg is two points written together: ab, S1A1"
            if number == 3:
                hint = "three lines in the plane are rank 3; platforms in space have six legs"
            raise InputError(f"{number} leg{'s' * (number != 1)}, expected six", hint=hint)
        for a, b in self.legs:
            if a == b:
                raise InputError(f"both ends of a leg are {a}", hint="a leg joins two different points")
        for name in self.ideal:
            if not any(name in leg for leg in self.legs):
                raise InputError(f"the point at infinity {name} is no end of a leg")

    @cached_property
    def names(self) -> tuple[str, ...]:
        """All joints in tableau order."""
        return tableau_order((p for leg in self.legs for p in leg), self.points, self.ideal)

    @cached_property
    def sides(self) -> dict[str, str]:
        """ "base" or "platform" for every joint that has a side."""
        found: dict[str, str] = {}
        for part in self._parts():
            colour = self._colouring(part)
            if colour is None:
                continue
            votes = sum(1 if colour[a] == 0 else -1 for a, _ in part)
            first = colour[part[0][0]] if votes == 0 else 0 if votes > 0 else 1
            found |= {n: "base" if c == first else "platform" for n, c in colour.items()}
        return found

    def _parts(self) -> Iterator[list[Leg]]:
        """The connected parts of the graph, each as its legs in typed order."""
        left = list(self.legs)
        while left:
            joints, part = set(left[0]), []
            while grown := [leg for leg in left if joints & set(leg)]:
                part += grown
                left = [leg for leg in left if leg not in grown]
                joints.update(n for leg in grown for n in leg)
            yield sorted(part, key=self.legs.index)

    @staticmethod
    def _colouring(part: Sequence[Leg]) -> dict[str, int] | None:
        colour = {part[0][0]: 0}
        for _ in part:
            for a, b in part:
                if a in colour:
                    colour.setdefault(b, 1 - colour[a])
                if b in colour:
                    colour.setdefault(a, 1 - colour[b])
        return None if any(colour[a] == colour[b] for a, b in part) else colour

    @cached_property
    def base(self) -> tuple[str, ...]:
        return tuple(n for n in self.names if self.sides.get(n) == "base")

    @cached_property
    def platform(self) -> tuple[str, ...]:
        return tuple(n for n in self.names if self.sides.get(n) == "platform")

    @cached_property
    def oriented(self) -> tuple[Leg, ...]:
        """The legs with the base joint first, as far as sides are known."""
        return tuple((b, a) if self.sides.get(a) == "platform" else (a, b) for a, b in self.legs)

    @cached_property
    def neutral(self) -> tuple[Leg, ...]:
        """The legs turned in a way that does not depend on how they were written, so that no answer does: in a part
        with two sides the side of its first joint (in tableau order) comes first, elsewhere each leg's first joint.
        """
        turned: dict[Leg, Leg] = {}
        for part in self._parts():
            colour = self._colouring(part) or {}
            first = min((self.names.index(n), n) for leg in part for n in leg)[1]
            for a, b in part:
                back = colour[a] != colour[first] if colour else self.names.index(a) > self.names.index(b)
                turned[a, b] = (b, a) if back else (a, b)
        return tuple(turned[leg] for leg in self.legs)

    @cached_property
    def sign(self) -> int:
        """superbracket(legs) = sign · superbracket(neutral)."""
        return -1 if sum(x != y for x, y in zip(self.legs, self.neutral, strict=True)) % 2 else 1

    @cached_property
    def superbracket(self) -> Expr:
        """The superbracket of the legs as typed."""
        return superbracket(*(join(Point(a), Point(b)) for a, b in self.legs))

    @cached_property
    def degrees(self) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Numbers of legs at the base joints and at the platform joints, largest first."""
        base, platform = (
            tuple(sorted((len(self.legs_at(n)) for n in side), reverse=True)) for side in (self.base, self.platform)
        )
        return base, platform

    def legs_at(self, name: str) -> tuple[Leg, ...]:
        return tuple(leg for leg in self.oriented if name in leg)


def read_legs(legs: str | Iterable[str | Sequence[str]], *, points: Names = (), ideal: Names = ()) -> Structure:
    """Six legs from text ("ab af cb cd ed ef", "S1A1, S2A2, …", "left top, right top, …") or pairs of names.

    Raises InputError (with its place in the text) for anything but six legs between two different points each.
    """
    points = split_names(points)
    if isinstance(legs, str):
        found = tuple(_read_text(legs, points))
        source: str | None = legs
    else:
        found = tuple(_read_item(item, points) for item in legs)
        source = None
    try:
        return Structure(found, points, split_names(ideal))
    except GcrulesError as fault:
        raise fault.located(source, span=Span(0, len(source))) if source is not None else fault from None


def _read_text(text: str, points: Sequence[str]) -> Iterator[Leg]:
    pattern = r"[^,;]+" if re.search(r"[,;]", text) else r"\S+"
    for match in re.finditer(pattern, text):
        word = match[0].strip()
        if not word:
            continue
        start = match.start() + len(match[0]) - len(match[0].lstrip())
        try:
            yield _two_points(re.sub(r"(?<=[\w'])\s*[-–]\s*(?=\w)", " ", word), points)
        except GcrulesError as fault:
            inner = InputError(f"{word!r} is not a leg: {fault.message}", hint=fault.hint)
            raise inner.located(text, span=Span(start, start + len(word))) from None


def _read_item(item: str | Sequence[str], points: Sequence[str]) -> Leg:
    if isinstance(item, str):
        return _two_points(item, points)
    if len(item) != 2 or not all(isinstance(n, str) for n in item):
        raise InputError(f"{item!r} is not a leg; expected two points")
    return _two_points(" ".join(item), (*points, *item))


def _two_points(text: str, points: Sequence[str]) -> Leg:
    hint = "a leg is two points written together: ab, S1A1; longer names need --points"
    short = _SHORT_LEG.fullmatch(text)
    if short and not any(len(n) > 1 and not SHORT_NAME.fullmatch(n) for n in points):
        return _different(short[1], short[2])
    try:
        found = parse(text, context=Context(8, tuple(points)))
    except StepError:
        raise InputError("expected two points", hint=hint) from None
    names = tuple(a.name for a in (found.args if isinstance(found, Join) else (found,)) if isinstance(a, Point))
    if len(names) != 2 or found.step != 2:
        raise InputError(f"expected two points, found {found.step if len(names) == found.step else text!r}", hint=hint)
    return _different(*names)


_SHORT_LEG = re.compile(f"({SHORT_NAME.pattern}) *({SHORT_NAME.pattern})")


def _different(a: str, b: str) -> Leg:
    if a == b:
        raise InputError(f"both ends are {a}", hint="a leg joins two different points")
    return a, b


def read_order(text: str | Sequence[int | str], structure: Structure) -> tuple[int, ...]:
    """An order of the legs: numbers "2 1 3 4 6 5" counted from 1, or the legs themselves "af ab cb cd ed ef".

    Integers in a sequence are positions counted from 0. Raises InputError unless every leg occurs once.
    """
    words: Iterable[int | str | Leg] = text
    if isinstance(text, str):
        numbers = re.fullmatch(r"[\d\s,]+", text)
        words = re.findall(r"\d+", text) if numbers else _read_text(text, structure.points)
    names = {frozenset(leg): i for i, leg in enumerate(structure.legs)}
    order = []
    for word in words:
        if isinstance(word, int):
            order.append(word)
        elif isinstance(word, str) and word.isdigit():
            order.append(int(word) - 1)
        else:
            leg = _two_points(word, structure.points) if isinstance(word, str) else word
            if frozenset(leg) not in names:
                raise InputError(f"{leg_text(leg)} is not one of the legs")
            order.append(names[frozenset(leg)])
    if sorted(order) != list(range(len(structure.legs))):
        raise InputError("an order names each of the six legs once", hint='for example --order "2 1 3 4 5 6"')
    return tuple(order)
