r"""Screws in words: reciprocal to lines and to each other, with null points of planes and null planes of points.

The lines through a point that are reciprocal to a screw lie in a plane, its null plane, and the lines of a plane that
are go through a point, its null point: S ∨ a and S ∧ abc.

>>> from gcrules.algebra.language.statements import parse_letters
>>> from gcrules.algebra.language.syntax import Context, parse
>>> at = parse_letters("screw S T", Context(4))
>>> for text in (r"[S a b]", r"S /\ T", r"S /\ abc /\ def", r"S /\ S"):
...     print(reciprocity(parse(text, context=at), str))
S is reciprocal to ab
S is reciprocal to T
S is reciprocal to abc /\ def
the pitch of the screw S is zero or infinite
>>> for text in (r"S /\ abc", "S a", r"(S a) /\ (T a)", r"(S /\ abc) \/ (T /\ abc)", r"a \/ (S /\ abc)", "abc ^ def"):
...     print(built_of_screws(parse(text, context=at), str))
the null point of abc for the screw S
the null plane of a for the screw S
the line through a that is reciprocal to S and T
the line in abc that is reciprocal to S and T
the line through a in abc that is reciprocal to S
None
"""

from __future__ import annotations

from collections.abc import Callable

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, subexpressions
from gcrules.algebra.letters import wholes
from gcrules.algebra.screw_letters import Screw
from gcrules.rules.statement import Part, Statement, say

__all__ = ["built_of_screws", "has_screw", "reciprocity"]

_RANK = 4

Noun = Callable[[Expr], Part]


def has_screw(*exprs: Expr) -> bool:
    """Whether a screw is among what expressions are made of."""
    return any(isinstance(part, Screw) for e in exprs for part in subexpressions(e))


def reciprocity(e: Expr, noun: Noun) -> Statement | None:
    """That a scalar vanishes in which a screw meets a line or a screw; None for other scalars."""
    parts = wholes(e.args) if isinstance(e, Bracket | Meet) and e.step == 0 else ()
    first = next((a for a in parts if isinstance(a, Screw)), None)
    if first is None:
        return None
    rest = list(parts)
    rest.remove(first)
    other = (ex.join if isinstance(e, Bracket) else ex.meet)(*rest, rank=_RANK)
    if other == first:
        return say("the pitch of the screw {} is zero or infinite", first)
    return say("{} is reciprocal to {}", noun(first), noun(other))


def built_of_screws(e: Expr, noun: Noun) -> Statement | None:
    """What an extensor is called that is built with a screw itself; None for others."""
    match e:
        case Join(args=(Screw() as s, point)) | Join(args=(point, Screw() as s)) if point.step == 1:
            return say("the null plane of {} for the screw {}", noun(point), s)
        case Meet(args=(Screw() as s, plane)) | Meet(args=(plane, Screw() as s)):
            return say("the null point of {} for the screw {}", noun(plane), s)
        case Meet(args=(x, y)) if e.step == 2:
            return _through(x, y, noun) or _through(y, x, noun)
        case Join(args=(x, y)) if e.step == 2:
            return _inside(x, y, noun) or _inside(y, x, noun)
    return None


def _through(plane: Expr, other: Expr, noun: Noun) -> Statement | None:
    """The common line of the null plane of a point and another plane through that point."""
    match plane, other:
        case Join(args=(Screw() as s, Point() as a) | (Point() as a, Screw() as s)), Join(args=args) if a in args:
            rest = [x for x in args if x != a]
            if len(rest) == 1 and isinstance(rest[0], Screw):
                return say("the line through {} that is reciprocal to {} and {}", noun(a), s, rest[0])
            return say("the line through {} in {} that is reciprocal to {}", noun(a), noun(other), s)
    return None


def _inside(first: Expr, other: Expr, noun: Noun) -> Statement | None:
    """The join of the null point of a plane and another point of that plane."""
    match first, other:
        case Meet(args=(Screw() as s, plane) | (plane, Screw() as s)), Meet(args=args) if plane in args:
            rest = [x for x in args if x != plane]
            if len(rest) == 1 and rest[0].step == 2:
                return say("the line in {} that is reciprocal to {} and {}", noun(plane), s, rest[0])
        case Meet(
            args=(Screw() as s, Join(args=points) as plane) | (Join(args=points) as plane, Screw() as s)
        ), Point():
            if other in points:
                return say("the line through {} in {} that is reciprocal to {}", noun(other), noun(plane), s)
    return None
