r"""Points that satisfy assumptions, one constructed after the other: as random points, and as polynomials.

A constructed point is Σ parameter · part, where the parts are expressions of step 1 in earlier points. As the values
run through all parameters and all positions of the free points, the points run through every position that satisfies
the assumptions and at which no extensor of `nonzero` is zero. Parameters and free points are independent of each
other, so a polynomial in them that is zero in normal form is zero, and one that is not is not.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from itertools import combinations, product
from typing import Any

from gcrules.algebra import claims
from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import Monomial, Terms, by_parameters, tableau_order
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points, random_rational_points
from gcrules.algebra.expand import MAX_TERMS, Expander, Multivector
from gcrules.algebra.expr import Expr, Join, Point, points_of
from gcrules.algebra.parts import substitute
from gcrules.algebra.straightening.straighten import terms_are_zero
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import content
from gcrules.core.seeds import DRAWN, drawn

__all__ = ["Construction", "ConstructionStep", "Within", "coordinates", "step_on"]


_FACTORS = (1, 1, -1, 2, -2, 3)
_SCALED = 30  # seeds beyond which coordinates have common factors: some claims fail for no other reason


@dataclass(frozen=True)
class ConstructionStep:
    """The point `name` on the extensor `within`: Σ parameter · part over `parts`, or the one part itself if `exact`.

    `fresh` are free points that occur in the step only. Every point of `within` is reached where the extensors of
    `nonzero` are not zero.
    """

    name: str
    within: Expr
    parts: tuple[Expr, ...]
    fresh: tuple[str, ...] = ()
    exact: bool = False
    nonzero: tuple[Expr, ...] = ()

    def scaled(self, part: Expr) -> bool:
        """Whether a part has a parameter; one that holds fresh points takes any size without."""
        return not (self.exact or (self.fresh and any(n in self.fresh for n in points_of(part))))


def step_on(within: Within, rank: int, *, exact: bool = False) -> ConstructionStep:
    """The point in general position on an extensor of step 1 to rank.

    A join is taken apart; any other extensor of step k > 1 is met with the join of rank − k + 1 fresh points.
    """
    parts: list[Expr] = []
    fresh = list(within.fresh)
    for part in within.extensor.args if isinstance(within.extensor, Join) else (within.extensor,):
        if part.step > 1:
            new = within.new(rank - part.step + 1, len(fresh))
            fresh += new
            part = ex.meet(part, ex.join(*map(Point, new), rank=rank), rank=rank)
        parts.append(part)
    return ConstructionStep(within.name, within.extensor, tuple(parts), tuple(fresh), exact, within.nonzero)


@dataclass(frozen=True)
class Within:
    """Where the point `name` lies; the extensor may hold fresh points. It is what it stands for, not too small and not
    too large, where the extensors of `nonzero` are not zero.
    """

    name: str
    extensor: Expr
    nonzero: tuple[Expr, ...]
    fresh: tuple[str, ...] = ()

    def new(self, number: int, used: int | None = None) -> list[str]:
        """Names of more fresh points."""
        first = len(self.fresh) if used is None else used
        return [f"{self.name}:{first + i + 1}" for i in range(number)]

    def met(self, other: Expr, rank: int) -> Within | None:
        """On another extensor too, which spans the whole space with this one."""
        if self.fresh or self.extensor.step + other.step <= rank:
            return None  # that a meet with fresh points is not zero could not be told without them
        both = ex.meet(self.extensor, other, rank=rank)
        return Within(self.name, both, (both,))

    def met_inside(self, other: Expr, rank: int, extra: int) -> Iterator[Within]:
        """On another extensor T too, where this one, S, spans with T a space of step rank − `extra` only.

        For fresh points R in general position S ∩ T = (S ∨ R) ∩ T as long as S and T span so much, which they do where
        the join of S with some points of T is not zero.
        """
        s, missing = self.extensor, rank - extra - self.extensor.step
        if self.fresh or extra < 1 or missing < 1 or s.step + other.step + extra <= rank:
            return
        new = self.new(extra)
        met = ex.meet(ex.join(s, *map(Point, new), rank=rank), other, rank=rank)
        ends = [a for a in (other.args if isinstance(other, Join) else ()) if a.step == 1]
        for some in combinations(ends, missing):
            yield Within(self.name, met, (ex.join(s, *some, rank=rank), other), tuple(new))


@dataclass(frozen=True)
class Construction:
    """Free points, and constructed points in an order in which each depends on earlier ones only.

    `nonzero` are the extensors that must not vanish for the construction to reach every position; `equations` vanish
    where the assumptions hold; `points` are all points of the user in tableau order. Free points and steps whose names
    hold a colon are not the user's; `meets` tells which meets of the user's points some of them are. `extensors` are
    the lines and planes that the assumptions speak of.
    """

    rank: int
    free: tuple[str, ...]
    ideal: tuple[str, ...]
    steps: tuple[ConstructionStep, ...] = ()
    nonzero: tuple[Expr, ...] = ()
    equations: tuple[Expr, ...] = ()
    points: tuple[str, ...] = ()
    extensors: tuple[Expr, ...] = ()
    meets: Mapping[str, Expr] = FrozenMap()

    @property
    def names(self) -> tuple[str, ...]:
        """The points of the user: free ones, then constructed ones."""
        return tuple(n for n in (*self.free, *(s.name for s in self.steps)) if ":" not in n)

    def renamed(self, name: Callable[[str], str], points: tuple[str, ...]) -> Construction:
        """With other names for all points; `points` are those of the user in tableau order, in the new names."""

        def of(es: Iterable[Expr]) -> tuple[Expr, ...]:
            return tuple(substitute(e, {n: Point(name(n)) for n in points_of(e)}, self.rank) for e in es)

        def step(s: ConstructionStep) -> ConstructionStep:
            (within,) = of([s.within])
            return ConstructionStep(
                name(s.name), within, of(s.parts), tuple(map(name, s.fresh)), s.exact, of(s.nonzero)
            )

        return Construction(
            self.rank,
            tuple(map(name, self.free)),
            tuple(map(name, self.ideal)),
            tuple(map(step, self.steps)),
            of(self.nonzero),
            of(self.equations),
            points,
            of(self.extensors),
            FrozenMap(zip(map(name, self.meets), of(self.meets.values()), strict=True)),
        )

    def random_points(self, seed: object = 0) -> dict[str, tuple[int, ...]]:
        """Random residues modulo `PRIME` that satisfy the assumptions; ideal points have last coordinate 0. They may
        decide, as nobody can foresee them (see `seeds`).
        """
        points = random_points(self._needed, rank=self.rank, ideal=self.ideal, seed=seed)
        rng, at = drawn("parameters", seed), Evaluator(points, self.rank, PRIME)
        for step in self.steps:
            value = coordinates(step, at, lambda: rng.randrange(DRAWN))
            points[step.name] = tuple(value)
        return points

    def rational_points(self, seed: int = 0, size: int = 9) -> dict[str, tuple[int | Fraction, ...]] | None:
        """Small exact coordinates of the user's points that satisfy the assumptions, whole wherever that is possible.

        None where the points drawn are degenerate: an extensor is zero, or a finite point at infinity.
        """
        points: dict[str, Any] = dict(
            random_rational_points(self._needed, rank=self.rank, ideal=self.ideal, seed=seed, size=size)
        )
        rng = random.Random(f"parameters {seed}")
        if seed > _SCALED:
            points = {n: tuple(k * c for c in v) for n, v in points.items() for k in [rng.choice(_FACTORS)]}
        at = Evaluator(points, self.rank)
        for step in self.steps:
            value = coordinates(step, at, lambda: rng.choice(_FACTORS))
            if not any(value) or ((value[-1] == 0) != (step.name in self.ideal) and ":" not in step.name):
                return None
            points[step.name] = tuple(value) if step.exact or seed > _SCALED else _primitive(value)
        if any(not any(Evaluator(points, self.rank).value(e)) for e in (*self.nonzero, *self.extensors)):
            return None
        found = {n: points[n] for n in self.names}
        return found if all(_holds(e, found, self.rank) for e in self.equations) else None

    @property
    def _needed(self) -> tuple[str, ...]:
        return (*self.free, *(n for s in self.steps for n in s.fresh))

    @cached_property
    def order(self) -> tuple[str, ...]:
        """The points that nothing is asked of: free ones, those at infinity first, then fresh ones."""
        fresh = [n for s in self.steps for n in s.fresh]
        return (*tableau_order(self.free, self.free, self.ideal), *fresh)

    @cached_property
    def at_infinity(self) -> int:
        """How many of `order` are at infinity."""
        return sum(n in self.ideal for n in self.order)

    def vanishes(self, e: Expr, *, samples: int = 2, seed: object = 0) -> bool:
        """Whether an expression is zero at random points modulo `PRIME`, which depend on the expression; False is
        certain, True wrong with the probability `error_below`.
        """
        claim = claims.digest(e)
        at = (self.random_points((claim, seed, n)) for n in range(samples))
        return all(not any(Evaluator(points, self.rank, PRIME).value(e)) for points in at)

    def error_below(self, e: Expr, samples: int) -> str:
        """In words, the chance at most that `vanishes` is wrong where it says so."""
        return claims.error_below(e, samples, self._sizes)

    def size(self, e: Expr) -> claims.PolynomialSize:
        """Of an expression, as a polynomial in what is drawn."""
        return claims.size(e, self._sizes)

    @cached_property
    def _sizes(self) -> dict[str, claims.PolynomialSize]:
        """Of the constructed points, as polynomials in what is drawn."""
        found: dict[str, claims.PolynomialSize] = {}
        for step in self.steps:
            parts = [(claims.size(part, found), step.scaled(part)) for part in step.parts]
            degree = max(size.degree + scaled for size, scaled in parts)
            # Each part may have denominators, which the others are multiplied by.
            found[step.name] = claims.PolynomialSize(
                degree, sum(size.bits for size, _ in parts) + len(parts).bit_length()
            )
        return found

    def is_zero(self, e: Expr, *, limit: int = MAX_TERMS) -> bool:
        """Whether an expression is zero wherever the construction leads, decided by its normal form.

        Raises LimitReached where more than `limit` terms would be made.
        """
        parts = by_parameters(self.closed_terms(e, limit))
        return all(terms_are_zero(terms, self.at_infinity, limit) for terms in parts.values())

    def closed_terms(self, e: Expr, limit: int = MAX_TERMS, *, as_defined: bool = False) -> Terms:
        """The expression as a polynomial in brackets of the points of `order`, whose numbers make its rows, and in the
        parameters, which are rows of one entry; an extensor of step k is closed by d - k more points, numbered last.
        Meets are expanded as `Expander` does.
        """
        n = len(self.order)
        new = tuple(range(n, n + self.rank - e.step)) if e.step else ()
        closed: Terms = {}
        for row, terms in self._expanded(e, limit, as_defined).items():
            for m, c in terms.items():
                checkpoint()
                key = tuple(sorted((*m, row + new))) if e.step else m
                closed[key] = closed.get(key, 0) + c
        return closed

    def _expanded(self, e: Expr, limit: int, as_defined: bool) -> Multivector:
        """The expression with the constructed points written out; parameters are rows of one entry."""
        expander = Expander(self.order, self.rank, self.at_infinity, limit, as_defined=as_defined)
        parameters = 0
        for step in self.steps:
            value: Multivector = {}
            for part in step.parts:
                parameter: Monomial = ((parameters,),) if step.scaled(part) else ()
                parameters += 1
                for row, terms in expander.value(part).items():
                    into = value.setdefault(row, {})
                    for m, c in terms.items():
                        checkpoint()
                        key = tuple(sorted((*m, *parameter)))
                        into[key] = into.get(key, 0) + c
            expander.known[Point(step.name)] = value
        try:
            return expander.value(e)
        except LimitReached as limited:
            limited.message = limited.message.replace("the expansion", "the expansion with the constructed points")
            raise


def coordinates(step: ConstructionStep, at: Evaluator, draw: Callable[[], Any]) -> list[Any]:
    """The value of a step at given points, with drawn parameters."""
    total: list[Any] = [0] * at.rank
    for part in step.parts:
        factor = draw() if step.scaled(part) else 1
        total = [t + factor * c for t, c in zip(total, at.value(part), strict=True)]
    return [at.reduced(c) for c in total]


def _primitive(value: Iterable[int | Fraction]) -> tuple[int, ...]:
    """The same point in whole coordinates without a common factor, the last one not negative."""
    exact = list(value)
    divisor = content(exact) * (-1 if exact[-1] < 0 else 1)
    return tuple(int(c / divisor) for c in exact)


def _holds(e: Expr, points: Mapping[str, Any], rank: int) -> bool:
    """Whether an equation holds exactly; the points that stand for all points run through a basis."""
    return all(not any(Evaluator(p, rank).value(e)) for p in _every(e, points, rank))


def _every(e: Expr, points: Mapping[str, Any], rank: int) -> Iterator[Mapping[str, Any]]:
    open_points = [n for n in points_of(e) if n not in points]
    basis = [tuple(int(i == j) for j in range(rank)) for i in range(rank)]
    # Equations are linear in each of these and change sign when two of them change places.
    for chosen in combinations(basis, len(open_points)) if open_points else product():
        checkpoint()
        yield {**points, **dict(zip(open_points, chosen, strict=True))}
