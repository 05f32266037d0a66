r"""Claims that follow from several things that are given together: as a sum of multiples of them.

Where N ∨ Y does not vanish for all points Y, since N does not, and (N ∨ Y) times the difference of both sides is a sum
of multiples of what is given, the sides are equal wherever that vanishes. A line or a plane is closed by further points
Y, so that all are scalars. By Hilbert's Nullstellensatz every claim that holds over all fields follows so, with powers;
those that are sought have few factors.

>>> from gcrules.algebra.language.syntax import parse, parse_equation
>>> given = [parse(e, rank=3) for e in ("[abd] - [abc]", "[abd] - 2 [abc]")]
>>> found = by_multiples("claim", *parse_equation("[acd] == 0", rank=3), given, [parse("ab", rank=3)], 3)
>>> print(found.cases[0].right)
[ab, y1]([acd] - 0)
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import chain, combinations, combinations_with_replacement, count, islice

from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Number, Point, Power, Product, Sum, mul, points_of
from gcrules.algebra.names import primed
from gcrules.algebra.proofs.multiples import multipliers
from gcrules.algebra.proofs.theorem import Theorem, placed_theorem
from gcrules.algebra.prove import difference_of
from gcrules.core.errors import EngineFault, InputError, LimitReached

__all__ = ["by_multiples"]

_EXPONENT = 2
_FACTORS = 2  # that do not vanish
_TRIES = 20  # products of these


def by_multiples(
    name: str,
    left: Expr,
    right: Expr,
    given: Sequence[Expr],
    nonzero: Sequence[Expr],
    rank: int,
    ideal: Iterable[str] = (),
) -> Theorem | None:
    """The proof that two expressions are equal wherever what is given vanishes and some things do not, by an identity;
    None where none is found.
    """
    own = points_of(left, right)
    left, right, *equations = (_scalar(e) if e.step == rank else e for e in (left, right, *given))
    at_infinity = tuple(ideal)
    written, difference = Sum((left, Product((Number(-1), right)))), difference_of(left, right, rank)
    taken = {*points_of(left, right, *given, *nonzero)}
    for factors, exponent in _products(nonzero, {*own, *points_of(*equations)}):
        # Each factor is closed by points of its own; the difference is not written as it is computed with.
        each = [*((n, n) for n in factors), *[(difference, written)] * exponent]
        further = (primed(f"y{i}", taken.__contains__) for i in count(1))
        ends = [tuple(islice(further, (rank - e.step) % rank)) for e, _ in each]
        whole = mul(*(_closed(e, some) for (e, _), some in zip(each, ends, strict=True)))
        parts = [part for g in equations for part in _closings(g, (*points_of(whole), *points_of(g)), rank)]
        points = tableau_order(points_of(left, right, *equations, *factors), (), at_infinity)
        infinite = tuple(n for n in points if n in at_infinity)
        c = Construction(rank, (*points, *chain.from_iterable(ends)), infinite)
        try:
            found = multipliers(whole, parts, rank, at_infinity)
            if found is None:
                continue
            terms = tuple(Product((m, part)) for m, part in zip(found, parts, strict=True) if m != ZERO)
            product = _nested([_closed(e, some) for (_, e), some in zip(each, ends, strict=True)])
            lemma = placed_theorem(f"{name}, times what does not vanish", Sum(terms), product, c, ())
        except (EngineFault, InputError, LimitReached):
            continue
        away = tuple(dict.fromkeys(factors))
        return Theorem(name, rank, left, right, points, len(infinite), (), tuple(equations), away, cases=(lemma,))
    return None


def _products(nonzero: Sequence[Expr], names: Collection[str]) -> Iterator[tuple[tuple[Expr, ...], int]]:
    """Of what does not vanish of some points, each with an exponent of what does: of single factors first."""
    whole = [tuple(_factors(n)) for n in nonzero]
    alone = [(f,) for f in chain.from_iterable(whole)]
    blocks = [block for block in dict.fromkeys((*alone, *whole)) if {*points_of(*block)} <= {*names}]
    for exponent in range(1, _EXPONENT + 1):
        some = (combinations_with_replacement(blocks, k) for k in range(_FACTORS + 1))
        for chosen in islice(chain.from_iterable(some), _TRIES):
            yield tuple(chain.from_iterable(chosen)), exponent


def _factors(e: Expr) -> Iterator[Expr]:
    """The factors of a product, powers written out: none of them vanishes where it does not."""
    match e:
        case Product(factors=factors):
            yield from (f for factor in factors for f in _factors(factor))
        case Power(base=base, exponent=n):
            yield from (*_factors(base),) * n
        case Number():
            return
        case _:
            yield e


def _scalar(e: Expr) -> Expr:
    """The bracket of what has full step."""
    return Bracket(e.args if isinstance(e, Join) else (e,))


def _nested(factors: Sequence[Expr]) -> Expr:
    """A product as one factor times the product of the others."""
    first, *others = factors
    return Product((first, _nested(others))) if others else first


def _closed(e: Expr, points: Sequence[str]) -> Expr:
    """The bracket of an extensor with further points; a scalar as it is."""
    return Bracket((e, *map(Point, points))) if points else e


def _closings(e: Expr, points: Iterable[str], rank: int) -> Iterator[Expr]:
    """The brackets of an extensor with any points; a scalar as it is."""
    if not e.step:
        yield e
        return
    for some in combinations(dict.fromkeys(points), rank - e.step):
        yield Bracket((e, *map(Point, some)))
