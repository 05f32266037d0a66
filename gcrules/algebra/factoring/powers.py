r"""A scalar as a number times powers, as it was written: nothing is expanded, and equal factors are counted.

>>> from gcrules.algebra.language.syntax import parse
>>> number, counted = powers(parse("-2 [abc]**3 [def] ([abc][deg] - 3[abc][dfg])", rank=3), rank=3)
>>> print(number, *(f"{e}: {n}" for e, n in counted.items()), sep="; ")
-2; [abc]: 4; [def]: 1; [deg] - 3[dfg]: 1
"""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from functools import reduce
from operator import and_

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Number
from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError, LimitReached

__all__ = ["MAX_FACTORS", "number_power", "powers"]

MAX_FACTORS = 1_000_000

_Powers = tuple[int | Fraction, Counter[Expr]]


def powers(e: Expr, *, rank: int) -> _Powers:
    """The number and how often each other factor occurs; the factors that all terms of a sum share are taken out.

    Raises LimitReached beyond a million factors.
    """
    checkpoint()
    match e:
        case Number(value=value):
            return value, Counter()
        case ex.Product(factors=factors):
            number: int | Fraction = 1
            counted: Counter[Expr] = Counter()
            for factor, n in Counter(factors).items():
                inner, more = powers(factor, rank=rank)
                number = Number(number * number_power(inner, n)).value
                counted += _times(more, n)
            return number, counted
        case ex.Power(base=base, exponent=n):
            inner, more = powers(base, rank=rank)
            return number_power(inner, n), _times(more, n)
        case ex.Sum(terms=terms):
            parts = [powers(t, rank=rank) for t in terms]
            common = reduce(and_, (counted for _, counted in parts))
            if common:
                rest = ex.add(*(_product(number, counted - common) for number, counted in parts), rank=rank)
                number, left = powers(rest, rank=rank) if not isinstance(rest, ex.Sum) else (1, Counter([rest]))
                return number, common + left
    return 1, Counter([e])


def number_power(base: int | Fraction, exponent: int) -> int | Fraction:
    """base ** exponent. Raises InputError where that is a longer number than expressions may hold."""
    bits = max(abs(base.numerator), base.denominator).bit_length() - 1
    if bits * exponent > ex.MAX_COEFFICIENT_BITS:
        raise InputError(f"a coefficient has more than {ex.MAX_COEFFICIENT_BITS} bits")
    return Number(base**exponent).value


def _times(counted: Counter[Expr], exponent: int) -> Counter[Expr]:
    if counted.total() * exponent > MAX_FACTORS:
        raise LimitReached(f"a product of more than {MAX_FACTORS:,} factors")
    return Counter({e: n * exponent for e, n in counted.items()})


def _product(number: int | Fraction, counted: Counter[Expr]) -> Expr:
    return ex.mul(Number(number), *(ex.Power(e, n) if n > 1 else e for e, n in counted.items()))
