r"""Extensors of step 2 in the place of two points that stand for them.

What holds for the line through any two points u and v holds for a line L in its place, wherever u and v occur joined
only; what is linear in that line holds for a screw, too.

>>> from gcrules.algebra.language.syntax import parse
>>> line = parse(r"abc /\ def")
>>> print(written_back(parse(r"[uvgh] (gu \/ v /\ hi)"), [(("u", "v"), line)]))
[abc /\ def, g, h] * (((abc /\ def) \/ g) /\ hi)
>>> written_back(parse("[ughi]"), [(("u", "v"), line)]) is None
True
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import prod

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Bracket, Expr, Join, Point, points_of
from gcrules.algebra.scalars import bracket
from gcrules.algebra.screw_letters import Screw

__all__ = ["StandIns", "put_back", "sign_apart", "written_back"]

StandIns = Sequence[tuple[tuple[str, str], Expr]]


def written_back(e: Expr, stand_ins: StandIns, rank: int = 4) -> Expr | None:
    """The expression with lines in the place of their two points; None where these occur apart."""
    found = put_back(e, stand_ins, rank)
    names = {n for ends, _ in stand_ins for n in ends}
    return None if names & set(points_of(found)) else found


def put_back(e: Expr, stand_ins: StandIns, rank: int) -> Expr:
    """The expression with lines in the place of their two points, where these occur joined."""
    match e:
        case Join(args=args) | Bracket(args=args):
            sign, parts = _apart(put_back(a, stand_ins, rank) for a in args)
            for (first, second), line in stand_ins:
                if Point(first) in parts and Point(second) in parts:
                    for n in (second, first):  # to the front, past points and lines
                        at = parts.index(Point(n))
                        sign *= (-1) ** sum(p.step for p in parts[:at])
                        parts.insert(0, parts.pop(at))
                    parts[:2] = [line]
            made = ex.join(*parts, rank=rank) if isinstance(e, Join) else bracket(*parts, rank=rank)
            return ex.signed(sign, made)
        case ex.Meet(args=args, rank=r):
            sign, factors = _apart(put_back(a, stand_ins, rank) for a in args)
            return ex.signed(sign, ex.meet(*factors, rank=r))
        case Screw():
            return e
        case ex.Sum(terms=terms):
            return ex.add(*(put_back(t, stand_ins, rank) for t in terms), rank=rank)
        case ex.Product(factors=factors):
            return ex.mul(*(put_back(f, stand_ins, rank) for f in factors))
    return e


def sign_apart(e: Expr) -> tuple[int, Expr]:
    """A minus sign before an expression, as a number, and the rest."""
    if isinstance(e, ex.Product) and e.factors[0] == ex.Number(-1):
        return -1, ex.mul(*e.factors[1:])
    return 1, e


def _apart(parts: Iterable[Expr]) -> tuple[int, list[Expr]]:
    """The sign of a product of expressions, and these without it."""
    found = [sign_apart(part) for part in parts]
    return prod(sign for sign, _ in found), [rest for _, rest in found]
