"""The expressions that are multiples of a polynomial: candidates of the search, confirmed by the oracle."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from itertools import combinations
from math import factorial, prod

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.brackets import vanishing_pairs
from gcrules.algebra.factoring.extensors import Extensors
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.residues import residues, values
from gcrules.algebra.factoring.search import Candidate, candidates
from gcrules.algebra.factoring.tree_letters import Given, Letters, joined, leaves
from gcrules.algebra.factoring.trees import Written, simplest
from gcrules.algebra.letters import letters_of, names_of
from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached

__all__ = ["Oracle", "constant_below", "search", "with_whole_letters"]

_SEEDS = 20
_FORMS = 10_000


def search(
    poly: BracketPolynomial, effort: Effort, given: Sequence[Given] = (), *, first: bool = False
) -> tuple[list[Written], int]:
    """All expressions without a scalar part that are multiples of a polynomial, simplest first, and how many extensors
    they were made of. Letters stand in them whole. With `given` only those that hold these extensors; with `first` the
    one that comes first alone.

    Each holds at the test's positions and at two of the oracle's. Raises LimitReached.
    """
    degrees = poly.degrees()
    assert degrees is not None
    names = tuple(n for n in poly.points if n in degrees)
    left = Counter(degrees) - Counter(n for g in given for n in leaves(g.tree))
    letters = with_whole_letters(names, left, poly.rank, given)
    ideal = sum(n in degrees for n in poly.points[: poly.ideal])
    restricted = poly.over(names, ideal)
    apart = set(combinations(range(len(names)), 2)) - vanishing_pairs(restricted)
    for seed in range(_SEEDS):
        extensors = Extensors(letters, ideal=ideal, seed=seed, effort=effort, apart=apart)
        at = [int(v) for v in values(restricted, extensors.positions, extensors.field.p)]
        if all(at):
            break
    else:
        raise LimitReached(f"the polynomial vanishes at {_SEEDS} random positions modulo {extensors.field.p}")
    oracle = Oracle(restricted)
    found: dict[str, Written] = {}
    for candidate in candidates(extensors, at):
        w = _confirmed(candidate, extensors, oracle)
        if w is not None:
            found.setdefault(str(w), w)
            if first:
                break
    if not found and _most(left.values(), 0 if ideal or given else poly.rank) >= extensors.field.p:
        raise LimitReached(
            "the constant between an expression and the polynomial might be a multiple of the prime "
            f"{extensors.field.p} of the test, as points occur so often"
        )
    built = sum(map(len, extensors.levels.values()))
    effort.release(built)
    return sorted(found.values(), key=lambda w: w.key), built


def with_whole_letters(
    names: tuple[str, ...], degrees: Mapping[str, int], rank: int, given: Sequence[Given] = ()
) -> Letters:
    """Points that occur so often, and beside the extensors that are given the letters to which some of them belong."""
    whole = _whole_letters(degrees)
    spent = {n: g.times for g in whole for n in g.points}
    return Letters(names, tuple(degrees.get(n, 0) - spent.get(n, 0) for n in names), rank, (*given, *whole))


def _whole_letters(degrees: Mapping[str, int]) -> tuple[Given, ...]:
    """The lines, planes and hyperplanes to which points belong, as extensors: those whose points occur equally often,
    as they do in what is made of whole letters.
    """
    found = []
    for name, step in letters_of(degrees).items():
        points = names_of(name, step)
        times = {degrees.get(n, 0) for n in points}
        if len(times) == 1:
            found.append(Given(joined(*points), step, times.pop()))
    return tuple(found)


def _most(degrees: Iterable[int], fixed: int) -> int:
    """No constant between an expression of points of these degrees and a primitive polynomial is larger: it divides all
    coefficients of the expression in the coordinates of the points, of which so many, `fixed`, may be unit vectors.
    """
    return prod(map(factorial, sorted(degrees, reverse=True)[fixed:]))


def constant_below(degrees: Iterable[int], rank: int) -> bool:
    """Whether the constant between a primitive polynomial with points of these degrees and a difference of two products
    is smaller than the test's prime.
    """
    return 2 * prod(map(factorial, sorted(degrees, reverse=True)[rank:])) < residues(rank).p


class Oracle:
    """Whether an expression is a multiple of the polynomial at two exact random positions modulo a prime."""

    def __init__(self, poly: BracketPolynomial) -> None:
        ideal = poly.points[: poly.ideal]
        points = (random_points(poly.points, rank=poly.rank, ideal=ideal, seed=("factor", n)) for n in range(2))
        self.poly = poly
        self.at = [Evaluator(p, poly.rank, PRIME) for p in points]

    @cached_property
    def values(self) -> list[int]:
        """Those of the polynomial; most searches come to no candidate that asks for them."""
        e = self.poly.to_expr()
        return [at.value(e)[0] for at in self.at]

    def confirms(self, e: Expr) -> bool:
        one, other = (at.value(e)[0] for at in self.at)
        first, second = self.values
        return bool(one) and (one * second - other * first) % PRIME == 0


def _confirmed(candidate: Candidate, extensors: Extensors, oracle: Oracle) -> Written | None:
    """The simplest expression of a candidate that equals the polynomial at exact positions too."""
    letters = extensors.letters
    for number, (a, b) in enumerate(candidate.trees(extensors)):
        checkpoint()
        w = simplest(a, b, rank=letters.rank, order=letters.names)
        if oracle.confirms(w.expression):
            return w
        if number >= _FORMS:
            raise LimitReached(f"more than {_FORMS:,} expressions agree at the positions of the test")
    return None
