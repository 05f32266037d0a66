r"""A claim as a sum of multiples of what is given: then it holds wherever that vanishes, without exceptions.

>>> from gcrules.algebra.expr import sub
>>> from gcrules.algebra.language.syntax import parse, parse_equation
>>> claim = parse_equation("[eab][ecd][fac][fbd] == [eac][ebd][fab][fcd]", rank=3)
>>> six = parse("[abc][ade][bdf][cef] - [abd][ace][bcf][def]", rank=3)
>>> print(*multipliers(sub(*claim, rank=3), [six], 3))
1
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, islice

from gcrules.algebra.bracket import Row, tableau_order
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import ZERO, Bracket, Dotted, Expr, Number, Point, Power, Sum, add, mul, points_of
from gcrules.algebra.scalars import written_out
from gcrules.algebra.screw_letters import Screw
from gcrules.algebra.straightening.diagonal import standard_tableaux
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import echelon, fraction_of

__all__ = ["multipliers"]

_MOST = 250  # standard tableaux
_MORE = 4  # positions beyond as many as there are tableaux
_CONTENTS = 60  # of points in terms

_Content = frozenset[tuple[str | Screw, int]]  # how often each point or screw occurs


def multipliers(e: Expr, given: Sequence[Expr], rank: int, ideal: Iterable[str] = ()) -> tuple[Expr, ...] | None:
    """Polynomials in brackets by which scalars that are given are multiplied to make a scalar, None where none are
    found. What is found holds at some positions more than it takes; that it holds is left to be proved.
    """
    at_infinity = tuple(ideal)
    names = tableau_order(points_of(e, *given), (), at_infinity)
    count = sum(n in at_infinity for n in names)
    bases: list[tuple[int, tuple[Expr, ...]]] = []
    for i, content in _contents_of_multipliers(e, given):
        bases += ((i, m) for m in islice(_monomials(content, names, count, rank), _MOST + 1))
        if len(bases) > _MOST:
            return None
    if not bases:
        return None
    rows = islice(_values(e, given, bases, names, at_infinity, rank), len(bases) + _MORE)
    solved, pivots = echelon(rows, PRIME)
    if len(bases) in pivots or not any(row[-1] for row in solved):
        return None
    found: list[list[Expr]] = [[] for _ in given]
    for row, column in zip(solved, pivots, strict=True):
        i, m = bases[column]
        if row[-1]:
            found[i].append(mul(Number(fraction_of(row[-1], PRIME)), *m))
    return tuple(add(*terms, rank=rank) if terms else ZERO for terms in found)


def _contents_of_multipliers(e: Expr, given: Sequence[Expr]) -> Iterator[tuple[int, _Content]]:
    """Of each thing given, by its number, the points that multipliers of it may have: with them it has terms as those
    of the expression, or as those of others with theirs.
    """
    parts = [_contents(g) for g in given]
    wanted = _contents(e)
    if wanted is None or None in parts:
        return
    waiting, seen, done = deque(wanted), {*wanted}, set()
    while waiting and len(seen) <= _CONTENTS:
        whole = Counter(dict(waiting.popleft()))
        for i, some in enumerate(parts):
            for part in some or ():
                if any(whole[n] < k for n, k in part) or (i, left := _frozen(whole - Counter(dict(part)))) in done:
                    continue
                done.add((i, left))
                yield i, left
                for other in some or ():
                    new = _frozen(Counter(dict(left)) + Counter(dict(other)))
                    if new not in seen:
                        seen.add(new)
                        waiting.append(new)


def _monomials(content: _Content, names: tuple[str, ...], ideal: int, rank: int) -> Iterator[tuple[Expr, ...]]:
    """Products of brackets with these points and screws: of points those that are standard tableaux."""
    screw = next((e for e, _ in content if isinstance(e, Screw)), None)
    if screw is not None:
        rest = Counter(dict(content)) - Counter([screw])
        for pair in combinations([n for n in names if rest[n]], 2):
            own = Bracket((screw, *map(Point, pair)))
            yield from ((own, *m) for m in _monomials(_frozen(rest - Counter(pair)), names, ideal, rank))
        return
    letters = tuple(sorted(names.index(n) for n, k in content if isinstance(n, str) for _ in range(k)))
    if len(letters) % rank == 0:
        for m in sorted(islice(standard_tableaux(letters, rank), _MOST + 1)):
            if not any(row[-1] < ideal for row in m):
                yield tuple(Bracket(tuple(Point(names[i]) for i in row)) for row in m)


def _contents(e: Expr) -> frozenset[_Content] | None:
    """How often points and screws occur in the terms of an expression; None where there are too many kinds of terms."""
    match e:
        case Point(name=name):
            return frozenset([frozenset([(name, 1)])])
        case Number():
            return frozenset([frozenset()])
        case Screw():
            return frozenset([frozenset([(e, 1)])])
        case Dotted():
            return _contents(written_out(e))
        case Sum(terms=terms):
            some = [_contents(t) for t in terms]
            return None if None in some else frozenset().union(*(s for s in some if s is not None))
        case Power(base=base, exponent=n):
            children: tuple[Expr, ...] = (base,) * n
        case _:
            children = e.children
    found: frozenset[_Content] = frozenset([frozenset()])
    for child in children:
        own = _contents(child)
        if own is None or len(found) * len(own) > _CONTENTS**2:
            return None
        found = frozenset(_frozen(Counter(dict(a)) + Counter(dict(b))) for a in found for b in own)
    return found if len(found) <= _CONTENTS else None


def _frozen(content: Counter[str | Screw]) -> _Content:
    return frozenset(content.items())


def _values(
    e: Expr,
    given: Sequence[Expr],
    bases: Sequence[tuple[int, tuple[Expr, ...]]],
    names: tuple[str, ...],
    ideal: tuple[str, ...],
    rank: int,
) -> Iterator[Row]:
    """Of the products of what is given with tableaux, and of a scalar, at one position after the other."""
    seed = 0
    while True:
        checkpoint()
        points = random_points(names, rank=rank, ideal=ideal, seed=seed)
        at = Evaluator(points, rank, PRIME)
        products = []
        for i, m in bases:
            value = at.value(given[i])[0]
            for factor in m:
                value = value * at.value(factor)[0] % PRIME
            products.append(value)
        yield (*products, at.value(e)[0])
        seed += 1
