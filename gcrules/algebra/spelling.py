r"""One form of expressions that may be written in several: sorted, with signs and numbers taken out.

>>> from gcrules.algebra.language.syntax import parse
>>> place = {n: i for i, n in enumerate("abcd")}
>>> for text in ("[bad] - 2[cab]", "4[cab] + 2[abd]"):
...     found = normal(parse(text, rank=3), place, 3)
...     print(found.factor, found.expr, sep=" * ")
-1 * 2[abc] + [abd]
2 * 2[abc] + [abd]
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import (
    ZERO,
    Bracket,
    Dotted,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    Superbracket,
    points_of,
)
from gcrules.algebra.scalars import bracket, power, superbracket
from gcrules.algebra.screw_letters import Screw
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import content

__all__ = ["Key", "Normal", "normal", "split"]

Key = tuple[Any, ...]
_ONE = Number(1)


@dataclass(frozen=True)
class Normal:
    """`factor` · `expr` is the expression; its joins, meets, products and sums are sorted, and `key` compares it."""

    factor: Fraction
    expr: Expr
    key: Key


_ZERO = Normal(Fraction(0), ZERO, (1,))


def normal(e: Expr, place: Mapping[str, int], rank: int) -> Normal:
    """The expression in one form, where points stand in the order of their places: signs and numbers are taken out,
    like terms collected.
    """
    known: dict[Expr, Normal] = {}

    def of(x: Expr) -> Normal:
        if x not in known:
            checkpoint()
            known[x] = made(x)
        return known[x]

    def made(x: Expr) -> Normal:
        match x:
            case Number(value=value):
                return Normal(Fraction(value), _ONE, (1,)) if value else _ZERO
            case Point(name=name):
                return Normal(Fraction(1), x, (0, place[name]))
            case Join(args=args) | Bracket(args=args):
                tag, build = (2, ex.join) if isinstance(x, Join) else (7, bracket)
                return arranged(_flat(map(of, args), Join, of), tag, 0, lambda *a: build(*a, rank=rank))
            case Meet(args=args, rank=d):
                return arranged(_flat(map(of, args), Meet, of), 3, d, lambda *a: ex.meet(*a, rank=d))
            case Superbracket(lines=lines):
                d = x.rank
                return arranged([*map(of, lines)], 8, None, lambda *a: superbracket(*a, rank=d))
            case Product(factors=factors):
                return multiplied(map(of, factors))
            case Power(base=base, exponent=n):
                return multiplied([of(base)] * n)
            case Screw():
                return Normal(Fraction(1), x, (10, *(place[n] for n in points_of(x))))
            case Sum(terms=terms):
                return added(map(of, terms))
            case Dotted(brackets=brackets):
                return Normal(Fraction(1), x, (9, tuple((place[n], d) for b in brackets for n, d in b)))
        raise TypeError(f"not an expression: {x!r}")

    def arranged(parts: list[Normal], tag: int, codim: int | None, build: Callable[..., Expr]) -> Normal:
        """Sorted; two parts of odd step (of odd codimension in a meet) change the sign where they change places."""
        factor = Fraction(1)
        for part in parts:
            factor *= part.factor
        odd = [codim is None or abs(codim - part.expr.step) % 2 for part in parts]
        for i, j in combinations(range(len(parts)), 2):
            if odd[i] and odd[j]:
                if parts[i].key == parts[j].key:
                    return _ZERO
                if parts[i].key > parts[j].key:
                    factor = -factor
        parts = sorted(parts, key=lambda p: p.key)
        e = build(*(p.expr for p in parts)) if factor else ZERO
        return Normal(factor, e, (tag, len(parts), *(p.key for p in parts))) if e != ZERO else _ZERO

    def multiplied(parts: Iterable[Normal]) -> Normal:
        factor = Fraction(1)
        bases: dict[Key, tuple[Expr, int]] = {}
        for part in parts:
            factor *= part.factor
            factors = part.expr.factors if isinstance(part.expr, Product) else (part.expr,)
            for f in factors:
                base, n = (f.base, f.exponent) if isinstance(f, Power) else (f, 1)
                if base != _ONE:
                    key = of(base).key
                    bases[key] = base, n + bases.get(key, (base, 0))[1]
        if not factor:
            return _ZERO
        found = sorted(bases.items(), key=lambda item: item[0])
        if not found:
            return Normal(factor, _ONE, (1,))
        if len(found) == 1 and found[0][1][1] == 1:
            return Normal(factor, found[0][1][0], found[0][0])
        e = ex.mul(*(power(base, n) if n > 1 else base for _, (base, n) in found))
        return Normal(factor, e, (5, len(found), *((n, key) for key, (_, n) in found)))

    def added(parts: Iterable[Normal]) -> Normal:
        row: dict[Key, tuple[Expr, Fraction]] = {}
        for part in parts:
            checkpoint()
            inner = [(Fraction(1), part.expr, part.key)]
            if isinstance(part.expr, Sum) and not isinstance(part.expr, Screw):
                inner = [(c, t, of(t).key) for c, t in map(split, part.expr.terms)]
            for c, t, key in inner:
                row[key] = t, part.factor * c + row.get(key, (t, Fraction(0)))[1]
        terms = sorted(((key, t, c) for key, (t, c) in row.items() if c), key=lambda item: item[0])
        if not terms:
            return _ZERO
        if len(terms) == 1:
            ((key, t, c),) = terms
            return Normal(c, t, key)
        common = content(c for *_, c in terms) * (-1 if terms[0][2] < 0 else 1)
        e = ex.add(*(ex.mul(Number(c / common), t) for _, t, c in terms), rank=rank)
        return Normal(common, e, (4, len(terms), *((key, c / common) for key, _, c in terms)))

    return of(e)


def _flat(parts: Iterable[Normal], kind: type, of: Callable[[Expr], Normal]) -> list[Normal]:
    """With joins inside joins (meets inside meets), which come of sums of one term, taken apart."""
    found = []
    for part in parts:
        if isinstance(part.expr, kind) and part.factor:
            first, *others = (of(a) for a in part.expr.children)
            found += [Normal(first.factor * part.factor, first.expr, first.key), *others]
        else:
            found.append(part)
    return found


def split(t: Expr) -> tuple[Fraction, Expr]:
    """The number in front of a term, and the rest."""
    match t:
        case Number(value=value):
            return Fraction(value), _ONE
        case Product(factors=(Number(value=value), *rest)):
            return Fraction(value), ex.mul(*rest)
    return Fraction(1), t
