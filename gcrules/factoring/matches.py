"""The expressions that are multiples of a polynomial: candidates of the search, confirmed by the oracle, and proofs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from itertools import combinations
from math import factorial, prod

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr, Number
from gcrules.algebra.straighten import straighten
from gcrules.condition import Certificate
from gcrules.core.budget import checkpoint
from gcrules.errors import LimitReached
from gcrules.factoring.brackets import vanishing_pairs
from gcrules.factoring.extensors import Extensors, Letters, Tree, leaves
from gcrules.factoring.limits import Budget
from gcrules.factoring.residues import values
from gcrules.factoring.search import Candidate, candidates
from gcrules.factoring.trees import Written, simplest

__all__ = ["certified", "proved", "search"]

_SEEDS = 20
_FORMS = 10_000
_FURTHER = 3


def search(
    poly: BracketPolynomial, budget: Budget, given: Sequence[tuple[Tree, int]] = (), *, first: bool = False
) -> tuple[list[Written], int]:
    """All expressions without a scalar part that are multiples of a polynomial, simplest first, and how many extensors
    they were made of. With `given` (trees and their steps) only those that hold these extensors; with
    `first` the one that comes first alone.

    Each holds at the test's positions and at two of the oracle's. Raises LimitReached.
    """
    degrees = poly.degrees()
    assert degrees is not None
    names = tuple(n for n in poly.points if n in degrees)
    spent = Counter(n for tree, _ in given for n in leaves(tree))
    letters = Letters(names, tuple(degrees[n] - spent[n] for n in names), poly.rank, tuple(given))
    ideal = sum(n in degrees for n in poly.points[: poly.ideal])
    restricted = poly.over(names, ideal)
    apart = set(combinations(range(len(names)), 2)) - vanishing_pairs(restricted)
    for seed in range(_SEEDS):
        extensors = Extensors(letters, ideal=ideal, seed=seed, budget=budget, apart=apart)
        at = [int(v) for v in values(restricted, extensors.positions, extensors.field.p)]
        if all(at):
            break
    else:
        raise LimitReached(f"the polynomial vanishes at {_SEEDS} random positions modulo {extensors.field.p}")
    oracle = _Oracle(restricted)
    found: dict[str, Written] = {}
    for candidate in candidates(extensors, at):
        w = _confirmed(candidate, extensors, oracle)
        if w is not None:
            found.setdefault(str(w), w)
            if first:
                break
    if not found and prod(map(factorial, letters.degrees)) >= extensors.field.p:
        raise LimitReached(
            "the constant between an expression and the polynomial might be a multiple of the prime "
            f"{extensors.field.p} of the test, as points occur so often"
        )
    built = sum(map(len, extensors.levels.values()))
    budget.held -= built
    return sorted(found.values(), key=lambda w: w.key), built


class _Oracle:
    """Whether an expression is a multiple of the polynomial at two exact random positions modulo a prime near 2⁶¹."""

    def __init__(self, poly: BracketPolynomial) -> None:
        ideal = poly.points[: poly.ideal]
        points = (random_points(poly.points, rank=poly.rank, ideal=ideal, seed=n) for n in (1, 2))
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


def _confirmed(candidate: Candidate, extensors: Extensors, oracle: _Oracle) -> Written | None:
    letters = extensors.letters
    for number, (a, b) in enumerate(candidate.trees(extensors)):
        checkpoint()
        w = simplest(a, b, rank=letters.rank, order=letters.names)
        if oracle.confirms(w.expression):
            return w
        if number >= _FORMS:
            raise LimitReached(f"more than {_FORMS:,} expressions agree at the positions of the test")
    return None


def proved(poly: BracketPolynomial, e: Expr, terms: int) -> int | Fraction | None:
    """The c with poly = c · e, proved by equal normal forms; None if there is none. `poly` is in normal form."""
    ideal = poly.points[: poly.ideal]
    value = expand(e, points=poly.points, ideal=ideal, rank=poly.rank, limit=terms)
    assert isinstance(value, BracketPolynomial)
    normal = straighten(value.over(poly.points, poly.ideal), limit=terms)
    assert isinstance(normal, BracketPolynomial)
    leading, c = next(iter(poly.terms.items()))
    if leading not in normal.terms:
        return None
    ratio = Fraction(c) / normal.terms[leading]
    return Number(ratio).value if (normal * ratio).terms == poly.terms else None


def certified(
    poly: BracketPolynomial, e: Expr, terms: int, *, proof: bool = True
) -> tuple[int | Fraction, Certificate]:
    """The c with poly = c · e for an expression that was found, with the proof, or with the reason why there is none.

    Raises LimitReached where it does not hold after all.
    """
    reason = "the normal form of the input is too large"
    if proof:
        try:
            normal = straighten(poly, limit=terms)
            assert isinstance(normal, BracketPolynomial)
            coefficient = proved(normal, e, terms)
        except LimitReached as reached:
            reason = reached.message
        else:
            if coefficient is None:
                raise LimitReached("an expression that holds at random positions has another normal form")
            return coefficient, Certificate("normal-form", "both sides have the same normal form of standard tableaux")
    return _small_ratio(poly, e), Certificate(
        "random-points", f"equal at {_FURTHER} exact random positions, error below 1e-12; no proof: {reason}"
    )


def _small_ratio(poly: BracketPolynomial, e: Expr) -> int:
    """poly / e, the same whole number below 2³⁰ at exact random positions modulo a prime."""
    found = set()
    for n in range(_FURTHER):
        ideal = poly.points[: poly.ideal]
        at = Evaluator(random_points(poly.points, rank=poly.rank, ideal=ideal, seed=20 + n), poly.rank, PRIME)
        found.add(int(at.value(poly.to_expr())[0] * pow(at.value(e)[0], -1, PRIME) % PRIME))
    (ratio,) = found if len(found) == 1 else (0,)
    ratio = ratio - PRIME if ratio > PRIME // 2 else ratio
    if not 0 < abs(ratio) < 1 << 30:
        raise LimitReached("a factorization that was found does not hold at further random positions")
    return ratio
