r"""What an identity claims, as a digest, and how sure it is that it holds if it does so at random points.

>>> from gcrules.algebra.language.syntax import parse
>>> digest(parse("[abcd]")) == digest(parse("[a b c d]")), digest(parse("[abcd]")) == digest(parse("[abce]"))
(True, False)
>>> size(parse("3 [abcd][efgh]"))
PolynomialSize(degree=8, bits=11)
>>> error_below(parse("[[ab, cd, ef, gh, ij, kl]]"), 2)
'error below 1e-33'
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from hashlib import blake2b
from math import ceil, comb, factorial, log2

from gcrules.algebra.expr import Bracket, Dotted, Expr, Join, Meet, Number, Point, Power, Product, Sum, Superbracket
from gcrules.algebra.scalars import written_out
from gcrules.core import seeds
from gcrules.core.dataclass import dataclass

__all__ = ["PolynomialSize", "digest", "error_below", "size"]


@dataclass(frozen=True)
class PolynomialSize:
    """The degree in all coordinates together, and the bits of a number which no coefficient exceeds."""

    degree: int
    bits: int


def digest(e: Expr) -> str:
    """The same for equal expressions, in every run; parts that occur again are looked at once."""
    known: dict[int, bytes] = {}

    def of(x: Expr) -> bytes:
        if id(x) not in known:
            match x:
                case Number(value=value):
                    own: object = str(Fraction(value))
                case Point(name=name):
                    own = name
                case Power(exponent=exponent):
                    own = exponent
                case Meet(rank=rank):
                    own = rank
                case Dotted(brackets=brackets):
                    own = brackets
                case _:
                    own = ""
            hashed = blake2b(repr((type(x).__name__, own)).encode(errors="replace"), digest_size=16)
            for child in x.children:
                hashed.update(of(child))
            known[id(x)] = hashed.digest()
        return known[id(x)]

    return of(e).hex()


_Parts = tuple[int, float, float]  # degree, log₂ of the sum of the sizes of all coefficients, log₂ of the denominator


def size(e: Expr, points: Mapping[str, PolynomialSize] | None = None, *, rank: int = 4) -> PolynomialSize:
    """The size of an expression; points that are polynomials themselves have the sizes given."""
    given = points or {}
    known: dict[int, tuple[Expr, _Parts]] = {}  # the expressions are kept, so that no other one gets their ids

    def of(x: Expr) -> _Parts:
        if id(x) not in known:
            known[id(x)] = x, measured(x)
        return known[id(x)][1]

    def multiplied(parts: list[_Parts], terms: float = 1) -> _Parts:
        return sum(p[0] for p in parts), log2(terms) + sum(p[1] for p in parts), sum(p[2] for p in parts)

    def measured(x: Expr) -> _Parts:
        match x:
            case Number(value=value):
                exact = Fraction(value)
                return 0, log2(max(1, abs(exact.numerator))), log2(exact.denominator)
            case Point(name=name):
                here = given.get(name, PolynomialSize(1, 0))
                return here.degree, here.bits, 0.0
            case Join(args=args) | Bracket(args=args):
                terms, step = 1, 0
                for a in args:
                    step += a.step
                    terms *= comb(step, a.step)
                return multiplied([of(a) for a in args], terms)
            case Meet(args=args, rank=d):
                terms, step = 1, args[0].step
                for a in args[1:]:
                    terms *= comb(2 * d - step - a.step, d - a.step)
                    step += a.step - d
                return multiplied([of(a) for a in args], terms)
            case Superbracket(lines=lines):
                return multiplied([of(line) for line in lines], factorial(len(lines)))
            case Sum(terms=summands):
                parts = [of(t) for t in summands]
                largest = max(p[1] for p in parts)
                return max(p[0] for p in parts), largest + log2(len(parts)), sum(p[2] for p in parts)
            case Product(factors=factors):
                return multiplied([of(f) for f in factors])
            case Power(base=base, exponent=n):
                return multiplied([of(base)] * n)
            case Dotted():
                return of(written_out(x))
        raise TypeError(f"not an expression: {x!r}")

    degree, norm, denominator = of(e)
    return PolynomialSize(degree, ceil(norm + denominator))


def error_below(e: Expr, samples: int, points: Mapping[str, PolynomialSize] | None = None) -> str:
    """In words, the chance at most that an expression which is not zero vanishes at so many random points."""
    found = size(e, points)
    return seeds.error_below(found.degree, found.bits, samples)
