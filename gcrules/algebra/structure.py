r"""Structure: six legs as a graph between base and platform joints, or as many lines as another rank asks for.

>>> s = Structure((("a", "b"), ("a", "f"), ("c", "b"), ("c", "d"), ("e", "d"), ("e", "f")))
>>> s.base, s.platform
(('a', 'c', 'e'), ('b', 'd', 'f'))
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import combinations

from gcrules.algebra import scalars
from gcrules.algebra.assumptions.assumed import resolve
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.incidences import fault
from gcrules.algebra.assumptions.nondegeneracy import words
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Meet, Point, join, points_of
from gcrules.algebra.language.line_text import Leg
from gcrules.algebra.language.text import text as as_text
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import Assumption, Space
from gcrules.core.arguments import TEXT, WHOLE, instance, listed, read, row
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["NoLine", "Structure", "leg_text", "legs_text"]


def leg_text(leg: Leg) -> str:
    """A leg as it is written: ab, S1A1, and with a space between longer names: left top."""
    return str(join(*map(Point, leg)))


def legs_text(legs: Iterable[Leg]) -> str:
    """Legs as one text that `read_legs` takes (with its `points` for names of several letters).

    >>> legs_text([("a", "b"), ("S1", "A1")]), legs_text([("a", "b"), ("left", "top")])
    ('ab S1A1', 'ab, left top')
    """
    return _side_by_side([leg_text(leg) for leg in legs])


def _side_by_side(words: Sequence[str]) -> str:
    return (", " if any(" " in word for word in words) else " ").join(words)


_LEG = row("", TEXT, TEXT)
_NAMES = listed("a sequence of names of points", TEXT)
_KINDS = {
    "legs": listed("a sequence of pairs of names", _LEG).hinting(str="gc.analyze takes legs as text"),
    "points": _NAMES,
    "ideal": _NAMES,
    "given": listed("a sequence of assumptions", instance("", Assumption)),
    "rank": WHOLE,
    "stand_ins": listed("a sequence of legs, each with the line it stands for", row("", _LEG, instance("", Expr))),
}


@dataclass(frozen=True)
class Structure:
    """Six legs exactly as typed, and what follows from their graph alone; in rank n they are n (n − 1) / 2 lines.

    Each connected part of the graph that is free of odd cycles has two sides. Which of them is the base is read from
    the written order of most of its legs (of its first leg where they balance). In `oriented` a leg that was written
    the other way round is turned; legs in parts with an odd cycle stay as typed and their joints have no side.

    `given` holds what is assumed of the points. A line that is no join of two joints (a meet of planes) stands among
    the legs as two points of its own, and `stand_ins` says what they stand for.
    """

    legs: tuple[Leg, ...]
    points: tuple[str, ...] = ()
    ideal: tuple[str, ...] = ()
    given: tuple[Assumption, ...] = ()
    rank: int = 4
    stand_ins: tuple[tuple[Leg, Expr], ...] = ()

    def __post_init__(self) -> None:
        for name, kind in _KINDS.items():
            object.__setattr__(self, name, read(kind, getattr(self, name), f"gc.Structure: `{name}`"))
        number, expected = len(self.legs), self.rank * (self.rank - 1) // 2
        if number != expected:
            raise _wrong_number(number, expected, self.rank)
        for a, b in self.legs:
            if a == b:
                raise InputError(f"both ends of a leg are {a}", hint="a leg joins two different points")
        for assumption in self.given:
            for name in points_of(*assumption.args):
                if name not in (*self.names, *self.points):
                    hint = "declare a point that only helps to say what is assumed with --points"
                    raise fault(assumption, f"{name} is not an end of a leg", hint)
        for name in self.ideal:
            if name not in (*self.names, *self.points) and not any(name in points_of(*a.args) for a in self.given):
                raise InputError(f"the point at infinity {name} is not an end of a leg")

    @cached_property
    def lines(self) -> tuple[Expr, ...]:
        """The legs as expressions of step 2."""
        built = dict(self.stand_ins)
        return tuple(built.get(leg) or join(*map(Point, leg)) for leg in self.legs)

    @property
    def joined(self) -> tuple[Leg, ...]:
        """The legs between two joints, the base joint first: all but lines that are built from points."""
        built = dict(self.stand_ins)
        return tuple(right for leg, right in zip(self.legs, self.oriented, strict=True) if leg not in built)

    @cached_property
    def words(self) -> tuple[str, ...]:
        """The legs as they are written, in plain ASCII."""
        return tuple(as_text(line, names=self.names) for line in self.lines)

    def text(self) -> str:
        """The legs as one text that `read_legs` takes."""
        return _side_by_side(self.words)

    @cached_property
    def lifted(self) -> Structure:
        """The structure in which lines that are no joins of joints are general lines: their two points are joints."""
        if not self.stand_ins:
            return self
        return replace(self, points=tuple(dict.fromkeys((*self.points, *self.names))), stand_ins=())

    @property
    def special(self) -> bool:
        """Whether the points are not in general position."""
        return bool(self.given or self.ideal)

    @cached_property
    def space(self) -> Space:
        """Where the points lie: the rank, the points in tableau order, what is assumed of them."""
        return Space(self.rank, self.names, self.ideal, self.given)

    @cached_property
    def construction(self) -> Construction:
        """The points as the assumptions allow them. Raises InputError for assumptions that are not resolved, or that
        leave no line of a leg.
        """
        found = resolve(replace(self.space, points=(*self.points, *self.names)), self.names)
        for number, line in enumerate(self.lines) if self.given or self.stand_ins else ():
            if found.vanishes(line):
                raise NoLine(number, self.words[number], line)
        return found

    @property
    def assumed(self) -> tuple[tuple[str, str], ...]:
        """What must not vanish for the assumptions to say what they are taken to say, each with its meaning."""
        return tuple((as_text(e, names=self.names), words(e, self.names)) for e in self.construction.nonzero)

    @cached_property
    def dead(self) -> tuple[tuple[str, ...], ...]:
        """The brackets of joints that vanish under the assumptions, proved."""
        if not self.given:
            return ()
        at = Evaluator(self.construction.random_points(("dead", self.text())), self.rank, PRIME)
        rows = {r: bracket(*map(Point, r), rank=self.rank) for r in combinations(self.names, self.rank)}
        return tuple(r for r, e in rows.items() if not at.value(e)[0] and self.vanishes(e))

    def vanishes(self, e: Expr) -> bool:
        """Whether an expression is zero wherever the points may be, proved."""
        return self.construction.vanishes(e) and self.construction.is_zero(e)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """All joints, and the points of lines built from points, in tableau order."""
        return tableau_order(points_of(*self.lines), self.points, self.ideal)

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
        """Two sides, so that each leg joins one to the other; None where there is an odd cycle."""
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
        place = {n: i for i, n in enumerate(self.lifted.names)}
        for part in self._parts():
            colour = self._colouring(part) or {}
            first = min((place[n], n) for leg in part for n in leg)[1]
            for a, b in part:
                back = colour[a] != colour[first] if colour else place[a] > place[b]
                turned[a, b] = (b, a) if back else (a, b)
        return tuple(turned[leg] for leg in self.legs)

    @cached_property
    def sign(self) -> int:
        """superbracket(legs) = sign · superbracket(neutral)."""
        return self._sign_of(self.neutral)

    @cached_property
    def orientation(self) -> int:
        """superbracket(legs) = orientation · superbracket(oriented)."""
        return self._sign_of(self.oriented)

    def _sign_of(self, turned: tuple[Leg, ...]) -> int:
        """−1 where an odd number of legs is turned round."""
        return -1 if sum(x != y for x, y in zip(self.legs, turned, strict=True)) % 2 else 1

    @cached_property
    def superbracket(self) -> Expr:
        """The superbracket of the legs as typed."""
        return scalars.superbracket(*self.lines, rank=self.rank)

    @cached_property
    def degrees(self) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Numbers of legs at the base joints and at the platform joints, largest first."""
        base, platform = (
            tuple(sorted((len(self.legs_at(n)) for n in side), reverse=True)) for side in (self.base, self.platform)
        )
        return base, platform

    def legs_at(self, name: str) -> tuple[Leg, ...]:
        return tuple(leg for leg in self.oriented if name in leg)


class NoLine(InputError):
    """A leg that is zero wherever the points may be; `number` counts from 0."""

    def __init__(self, number: int, word: str, line: Expr) -> None:
        why = "is zero" if isinstance(line, Meet) else "has coinciding ends"
        super().__init__(f"the leg {word} is not a line: it {why} wherever the points may be")
        self.number = number


def _wrong_number(number: int, expected: int, rank: int) -> InputError:
    """The error for a number of legs that does not fit the rank, with the rank that would."""
    fitting = next((n for n in range(3, 9) if n * (n - 1) // 2 == number), None)
    word = {3: "three", 6: "six"}.get(expected, str(expected))
    hint = "each leg is two points written together: ab, S1A1"
    if rank != 4:
        hint = f"rank {rank} has {expected} lines; without --rank the six legs are lines of space, rank 4"
    if fitting is not None:
        lines = {3: "three lines in the plane", 6: "six lines in space"}.get(number, f"{number} lines")
        hint = f"{lines} are rank {fitting}: --rank {fitting} (in Python rank={fitting})"
        hint += "; platforms in space have six legs" if rank == 4 else ""
    return InputError(f"{number} leg{'s' * (number != 1)}, expected {word}", hint=hint)
