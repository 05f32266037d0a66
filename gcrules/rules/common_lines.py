r"""Lines that meet four legs, constructed from their joints: where two legs share a joint, the common transversals of
four legs are rational in the joints.

>>> four = FourLegs((("A", "a"), ("A", "b"), ("B", "c"), ("B", "d")))
>>> for line in four.lines:
...     print(line.expression, "-", line.words)
AB - the line AB through the joints A and B
Aab /\ Bcd - the common line of the leg planes Aab and Bcd
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr, Point, join, meet
from gcrules.algebra.language.legs_text import Leg
from gcrules.algebra.names import point_key
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.rules.recognition_state import extensor
from gcrules.rules.statement import Statement, say

__all__ = ["FREE", "CommonLine", "FourLegs", "letters", "line_of_joints"]

FREE = ("free 1", "free 2", "free 3", "free 4")
"""Four more points at the random positions; these are no names of joints."""

_SAMPLES = 2


def letters(*exprs: Expr) -> Counter[str]:
    """The points of expressions, each as often as it is written."""
    return Counter(part.name for e in exprs for part in ex.subexpressions(e) if isinstance(part, Point))


@dataclass(frozen=True)
class CommonLine:
    """A line, and what it is in words."""

    expression: Expr
    meaning: Statement

    @property
    def words(self) -> str:
        """The meaning in words."""
        return str(self.meaning)

    @cached_property
    def letters(self) -> Counter[str]:
        return letters(self.expression)


@dataclass(frozen=True)
class FourLegs:
    """Four legs; `names` is the order in which their joints are written (else sorted), `ideal` are at infinity."""

    legs: tuple[Leg, ...]
    names: tuple[str, ...] = ()
    ideal: tuple[str, ...] = ()

    @cached_property
    def joints(self) -> tuple[str, ...]:
        """The joints in their order."""
        used = {n for leg in self.legs for n in leg}
        return tuple(n for n in self.names if n in used) or tuple(sorted(used, key=point_key))

    @cached_property
    def positions(self) -> tuple[Evaluator, ...]:
        """Exact random positions of the joints and of the points FREE, all finite."""
        names = [*self.joints, *FREE]
        return tuple(
            Evaluator(random_points(names, seed=("four legs", self.legs, n)), 4, PRIME) for n in range(_SAMPLES)
        )

    @cached_property
    def lines(self) -> tuple[CommonLine, ...]:
        """The constructed lines that meet all four legs for generic positions of the joints, no two of them equal.

        Two for most legs; some of a pencil of lines where three legs share a joint or lie in a plane; none where no two
        legs share a joint (the transversals then take a square root).
        """
        through = [extensor(leg) for leg in self.legs]
        known: dict[tuple[int, ...], CommonLine] = {}
        # The simplest construction of a line is kept.
        for line in sorted(self._constructed(), key=lambda c: (c.letters.total(), c.expression.depth)):
            checkpoint()
            at = [p.value(line.expression) for p in self.positions]
            crossing = (p.value(meet(line.expression, g))[0] == 0 for p in self.positions for g in through)
            if all(any(v) for v in at) and all(crossing):
                known.setdefault(tuple(x for v in at for x in _scaled(v)), line)
        return tuple(known.values())

    def _constructed(self) -> Iterator[CommonLine]:
        """Lines through joints, in planes of two legs with a common joint, and across single legs, that meet all legs
        by the way they are constructed.
        """
        for a, b in combinations(self.joints, 2):
            checkpoint()
            if not self._missed((a, b), ()):
                yield CommonLine(extensor((a, b)), line_of_joints(a, b, self.ideal))
        planes = [self._plane(*g, *h) for g, h in combinations(self.legs, 2) if len({*g, *h}) == 3]
        for two in combinations(dict.fromkeys(planes), 2):
            checkpoint()
            if not self._missed((), two):
                x, y = map(extensor, two)
                yield CommonLine(meet(x, y), say("the common line of the leg planes {} and {}", x, y))
        for a in self.joints:
            missed = self._missed((a,), ())
            if len(missed) == 2:
                g, h = missed
                line = meet(extensor(self._plane(a, *g)), extensor(self._plane(a, *h)))
                words = say("the line {} that crosses {} and {}", self._through(a), extensor(g), extensor(h))
                yield CommonLine(line, words)
        for plane in dict.fromkeys(planes):
            yield from self._in_plane(plane)

    def _in_plane(self, x: tuple[str, ...]) -> Iterator[CommonLine]:
        """Lines in a plane of two legs, through one of its joints or across two legs."""
        plane = extensor(x)
        missed = self._missed((), (x,))
        if len(missed) == 2:
            g, h = missed
            line = join(meet(extensor(g), plane), meet(extensor(h), plane))
            where = "at infinity" if set(x) <= set(self.ideal) else say("in the plane {}", plane)
            yield CommonLine(line, say("the line {} that crosses {} and {}", where, *map(extensor, missed)))
        for a in x:
            missed = self._missed((a,), (x,))
            if len(missed) == 1:
                (g,) = missed
                line = join(Point(a), meet(extensor(g), plane))
                words = "the line {} in the plane {} that crosses {}"
                yield CommonLine(line, say(words, self._through(a), plane, extensor(g)))

    def _through(self, a: str) -> Statement:
        return say("in the direction {}" if a in self.ideal else "through {}", Point(a))

    def _plane(self, *names: str) -> tuple[str, ...]:
        return tuple(sorted(set(names), key=self.joints.index))

    def _missed(self, points: tuple[str, ...], planes: tuple[tuple[str, ...], ...]) -> list[Leg]:
        """The legs that go through none of the points and lie in none of the planes."""
        return [g for g in self.legs if not set(g) & set(points) and not any(set(g) <= set(x) for x in planes)]


def line_of_joints(a: str, b: str, ideal: Sequence[str]) -> Statement:
    """What the line through two joints is, of which some may be at infinity."""
    line, finite = extensor((a, b)), [n for n in (a, b) if n not in ideal]
    if not finite:
        return say("the line at infinity {}", line)
    if len(finite) == 2:
        return say("the line {} through the joints {} and {}", line, Point(a), Point(b))
    (direction,) = {a, b} - set(finite)
    return say("the line {} through the joint {} in the direction {}", line, Point(finite[0]), Point(direction))


def _scaled(values: Sequence[int]) -> list[int]:
    leading = pow(next(v for v in values if v), -1, PRIME)
    return [v * leading % PRIME for v in values]
