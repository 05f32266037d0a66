r"""How the superbracket of six legs follows from two lines that meet four of them.

Let p and q meet the legs L1 … L4. For any lines g and h

    cofactor · [[L1, …, L4, g, h]] = c · tetrahedra · ((p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)),

since both sides are alternating bilinear forms in g and h that vanish as soon as g depends on L1 … L4, and such a form
(one on a space of 6 − 4 dimensions) is unique up to a factor. So the cofactor and the tetrahedra depend on the four
legs only. Their degrees in the joints are those of p and q less those of the legs, so that few products of brackets and
of meets p ∧ ab are left to try.

>>> four = FourLegs((("A", "a"), ("A", "b"), ("B", "a"), ("C", "c")))
>>> p, q = four.lines
>>> [str(f) for f in balance(four, p, q).cofactor]
['[ACac]']
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import reduce
from itertools import combinations, product

from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Point, meet
from gcrules.algebra.scalars import bracket, superbracket
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.rules.common_lines import FREE, CommonLine, FourLegs, letters
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import extensor

__all__ = ["Balance", "balance", "compared", "quotient"]

Factors = tuple[Expr, ...]


@dataclass(frozen=True)
class Balance:
    """Π cofactor · superbracket = c · Π tetrahedra · comparison of the turns, for some number c."""

    cofactor: Factors
    tetrahedra: Factors


def compared(p: Expr, q: Expr, g: Expr, h: Expr) -> Expr:
    """(p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)."""
    return ex.sub(ex.mul(meet(p, g), meet(q, h)), ex.mul(meet(p, h), meet(q, g)))


def balance(four: FourLegs, p: CommonLine, q: CommonLine) -> Balance | None:
    """The factors on both sides for two lines that meet four legs, all joints finite and generic; None where they are
    no products of brackets and meets p ∧ ab of these degrees.
    """
    g, h = extensor(FREE[:2]), extensor(FREE[2:])
    whole = superbracket(*map(extensor, four.legs), g, h)
    turns = compared(p.expression, q.expression, g, h)
    sides = [(at.value(whole)[0], at.value(turns)[0]) for at in four.positions]
    if not all(x and y for x, y in sides):
        return None
    content = Counter(n for leg in four.legs for n in leg)
    spent = p.letters + q.letters
    lines = (p.expression, q.expression)
    tetrahedra = list(_products(content - spent, (), four.joints))
    for left, right in product(_products(spent - content, lines, four.joints), tetrahedra):
        checkpoint()
        ratios = [
            (x * _value(at, left) % PRIME, y * _value(at, right) % PRIME)
            for at, (x, y) in zip(four.positions, sides, strict=True)
        ]
        if _proportional(ratios):
            return Balance(left, right)
    return None


def quotient(e: Expr, divisor: Expr, oracle: RandomWitness, names: Sequence[str]) -> Factors | None:
    """The brackets of the joints `names` whose product is ± e / divisor; None where there are none."""
    more, less = letters(e), letters(divisor)
    for brackets in _products(more - less, (), names) if less <= more else ():
        checkpoint()
        product_ = ex.mul(divisor, *brackets)
        if oracle.zero(ex.sub(e, product_)) or oracle.zero(ex.add(e, product_)):
            return brackets
    return None


def _value(at: Evaluator, factors: Factors) -> int:
    return reduce(lambda value, f: value * at.value(f)[0] % PRIME, factors, 1)


def _proportional(pairs: Sequence[tuple[int, int]]) -> bool:
    """Whether x / y is the same for all pairs, and not 0."""
    (x, y), *others = pairs
    return bool(x and y) and not any((x * w - y * v) % PRIME for v, w in others)


def _products(degrees: Counter[str], lines: Factors, names: Sequence[str]) -> Iterator[Factors]:
    """The products of brackets and of meets of one of the lines with the join of two joints, with these degrees; those
    of brackets first. Each is made once: brackets one after the other by their first joint.
    """
    left = [n for n in names if degrees[n]]
    if not left:
        yield ()
        return
    if degrees.total() % 4:
        return
    for rest in combinations(left[1:], 3):
        checkpoint()
        row = (left[0], *rest)
        for more in _products(degrees - Counter(row), (), names):
            yield (bracket(*map(Point, row)), *more)
    for line in lines:
        for ends in combinations(left, 2):
            factor = meet(line, extensor(ends))
            spent = letters(factor)
            if spent <= degrees:
                for more in _products(degrees - spent, lines, names):
                    yield (factor, *more)
