r"""Whether an expression is zero wherever a construction leads, decided in coordinates with respect to its own points.

Let F be the expression as a polynomial in the coordinates of the free points and in the parameters. It is zero exactly
when it vanishes on a dense set of them, for instance where d of the free points span the space. Linear maps keep joins,
meets and brackets, up to powers of the determinant. Hence, where all terms of F have the same degree in all free points
together, these d points may be taken to be e1, …, ed: what F is elsewhere follows, and nothing is assumed.

Points at infinity lie in one hyperplane, but so do any d − 1 points: where F has no more of them than that, a linear
map brings any positions of all points to such positions, and nothing is lost when they are points like the others. Of
more than that d − 1 are among the basis, which then has one point that is not at infinity, and the last coordinate of
the others at infinity is 0. They are taken for the basis first.

What is left are the parameters and the coordinates of the other free points. Where F is homogeneous in a point, or in
several together, scaling these multiplies each of them by a power of the factor, its weight. If the weights of some of
them are linearly independent, there are factors (in an algebraically closed field) that make all of these 1 wherever
they are not 0: a dense set again. So one further point becomes e1 + … + ed, the unit point of a projective frame.

    >>> from gcrules.algebra.language.syntax import parse
    >>> free = Construction(3, tuple("abcdef"), (), points=tuple("abcdef"))
    >>> found = frame_of(free, parse("[abc][def] - [dbc][aef] - [adc][bef] - [abd][cef]", rank=3))
    >>> found.base, found.unit, len(found.variables), found.is_zero()
    (('a', 'b', 'c'), 'd', 4, True)
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from gcrules.algebra.assumptions.construction import Construction, ConstructionStep, coordinates
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import MAX_COEFFICIENT_BITS, Dotted, Expr, Point, Power, Sum, points_of
from gcrules.algebra.scalars import written_out
from gcrules.algebra.sparse import Ring
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import echelon, kernel

__all__ = ["Frame", "frame_of", "occurrences", "zero_by"]

_FIRST = 1_000  # terms within which brackets are straightened before a frame is tried
_SLACK = 28  # a determinant of so many lines is computed through polynomials of up to so many times its degree

Degrees = Mapping[str, int]


@dataclass(frozen=True)
class Frame:
    """Coordinates in which the free points of `base` are e1, e2, …

    The coordinates of `others`, free points too, and the parameters of `steps` are numbered in this order; the last of
    the others are `at_infinity`, whose last coordinate is 0 and has no number. Each row of `scalings` are exponents of
    them: where each is multiplied by this power of one factor, the expression is multiplied by a power of it. So `ones`
    of them may be taken to be 1.
    """

    rank: int
    expression: Expr
    base: tuple[str, ...]
    others: tuple[str, ...]
    steps: tuple[ConstructionStep, ...]
    numbers: int
    scalings: tuple[tuple[Fraction, ...], ...]
    degree: int
    at_infinity: tuple[str, ...] = ()

    @cached_property
    def ones(self) -> frozenset[int]:
        """Numbers whose exponents are independent: suitable factors make them 1 unless one of them is 0."""
        return frozenset(echelon(self.scalings)[1])

    @property
    def unit(self) -> str | None:
        """The point all of whose coordinates are 1."""
        finite = self.others[: len(self.others) - len(self.at_infinity)]
        return finite[0] if finite and self.ones.issuperset(range(self.rank)) else None

    @property
    def variables(self) -> tuple[int, ...]:
        """The numbers that are not 1."""
        return tuple(i for i in range(self.numbers) if i not in self.ones)

    def is_zero(self, limit: int = MAX_TERMS) -> bool:
        """Whether the expression is zero for all values of the variables, and so wherever the construction leads.

        Raises LimitReached where a polynomial has more than `limit` terms.
        """
        ring = Ring(self.degree, limit)
        entries: list[Any] = [1] * self.numbers
        for place, i in enumerate(self.variables):
            entries[i] = ring.variable(place)
        return not any(self.value(entries))

    def value(self, entries: Iterable[Any], modulus: int | None = None) -> list[Any]:
        """The coordinates of the expression, from those of the other points and from parameters."""
        given = iter(entries)
        points: dict[str, Any] = {}
        for i, name in enumerate(self.base):
            points[name] = tuple(int(i == j) for j in range(self.rank))
        for name in self.others:
            last = () if name not in self.at_infinity else (0,)
            points[name] = (*(next(given) for _ in range(self.rank - len(last))), *last)
        at = Evaluator(points, self.rank, modulus)
        for step in self.steps:
            points[step.name] = tuple(coordinates(step, at, lambda: next(given)))
        return at.value(self.expression)


def frame_of(c: Construction, e: Expr) -> Frame | None:
    """Coordinates in which an expression can be decided; None where its terms have different degrees."""
    steps = _needed(c, e)
    size = c.size(e)
    named = {*points_of(e), *(n for s in steps for part in s.parts for n in points_of(part))}
    free = [n for n in c.order if n in named]
    if not free or size.bits > MAX_COEFFICIENT_BITS:
        return None
    often = occurrences(free, steps, e)
    free.sort(key=lambda n: -often[n])
    base, others, at_infinity = _divided(free, c)
    degrees = _DegreesOf(free)
    parameters = [degrees.step(s) for s in steps]
    degrees.of(e)
    made = [s.name for s in steps if all(map(s.scaled, s.parts))]
    together = _together(free, made, degrees.uneven)
    if together is None:
        return None
    weights = [
        {p: Fraction(1), b: Fraction(1)} for p in others for b in (base[: c.rank - 1] if p in at_infinity else base)
    ]
    for own in chain.from_iterable(parameters):
        # Where a point of the base was scaled, a map that multiplies one coordinate of all points brings it back.
        share = sum((k * own.get(n, 0) for n, k in together.items()), Fraction(0)) / c.rank
        weights.append({n: share - own.get(n, 0) if n in base else Fraction(own[n]) for n in {*own, *base}})
    scaled = (*free, *made)
    # Factors of several points together are found where the terms of no sum are multiplied by different powers.
    rows = {tuple(d.get(n, 0) * (-1 if n in base else 1) for n in scaled) for d in degrees.uneven}
    scalings = tuple(
        tuple(sum((k * w.get(n, 0) for k, n in zip(some, scaled, strict=True) if k), Fraction(0)) for w in weights)
        for some in kernel(rows, len(scaled))
    )
    return Frame(c.rank, e, base, others, steps, len(weights), scalings, _SLACK * size.degree, at_infinity)


def _divided(free: Sequence[str], c: Construction) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """The basis, the other points, and those of them that are at infinity, which come last. Of each kind those that
    come first here are in the basis.
    """
    ideal = [n for n in free if n in c.ideal]
    finite = [n for n in free if n not in c.ideal]
    known = min(len(ideal), c.rank - 1)
    more = c.rank - known
    at_infinity = tuple(ideal[known:])
    return (*ideal[:known], *finite[:more]), (*finite[more:], *at_infinity), at_infinity


def _together(free: Sequence[str], made: Sequence[str], uneven: Iterable[Degrees]) -> Mapping[str, Fraction] | None:
    """By which powers of a factor points are multiplied so that no sum has terms that are multiplied by different ones,
    and all free points by the factor itself; None where there are none.
    """
    rows = {(sum(d.get(n, 0) for n in free), *(d.get(n, 0) for n in made)) for d in uneven}
    for first, *others in kernel(rows, 1 + len(made)):
        if first:
            return dict.fromkeys(free, Fraction(1)) | {
                n: k / Fraction(first) for n, k in zip(made, others, strict=True)
            }
    return None


def _needed(c: Construction, e: Expr) -> tuple[ConstructionStep, ...]:
    """The steps on whose points an expression depends."""
    names = set(points_of(e))
    found = []
    for s in reversed(c.steps):
        if s.name in names:
            found.append(s)
            names.update(n for part in s.parts for n in points_of(part))
    return tuple(reversed(found))


def occurrences(free: Iterable[str], steps: Iterable[ConstructionStep], e: Expr) -> Mapping[str, int]:
    """How often free points occur in an expression with the constructed points written out."""
    known: dict[Expr, Counter[str]] = {Point(n): Counter([n]) for n in free}

    def of(parts: Iterable[Expr]) -> Counter[str]:
        total: Counter[str] = Counter()
        for part in parts:
            if part not in known:
                known[part] = of([written_out(part)] if isinstance(part, Dotted) else part.children)
            total.update(known[part])
        return total

    for s in steps:
        known[Point(s.name)] = of(s.parts)
    return of([e])


class _DegreesOf:
    """Degrees of expressions in each point; `uneven` are the differences of these between terms of one sum.

    A constructed point has degree 1 in itself; in the points that it depends on it has the degree of the parts without
    parameters, or 0: parameters have the degrees that the other parts lack.
    """

    def __init__(self, free: Iterable[str]) -> None:
        self.uneven: list[Degrees] = []
        self._known: dict[Expr, Degrees] = {Point(n): {n: 1} for n in free}

    def of(self, e: Expr) -> Degrees:
        if e not in self._known:
            self._known[e] = self._of(e)
        return self._known[e]

    def _of(self, e: Expr) -> Degrees:
        match e:
            case Sum(terms=terms):
                return self._common([self.of(t) for t in terms])
            case Power(base=base, exponent=n):
                return {name: n * k for name, k in self.of(base).items()}
            case Dotted():
                return self.of(written_out(e))
        total: Counter[str] = Counter()
        for child in e.children:
            total.update(self.of(child))
        return total

    def _common(self, several: Sequence[Degrees]) -> Degrees:
        first = several[0]
        for other in several[1:]:
            difference = {n: k for n in {*first, *other} if (k := first.get(n, 0) - other.get(n, 0))}
            if difference:
                self.uneven.append(difference)
        return first

    def step(self, s: ConstructionStep) -> list[Degrees]:
        """The degrees of the parameters of a step; afterwards those of its point are known."""
        fixed = [self.of(part) for part in s.parts if not s.scaled(part)]
        own = {**(self._common(fixed) if fixed else {}), s.name: 1}
        self._known[Point(s.name)] = own
        found: list[Degrees] = []
        for part in s.parts:
            if s.scaled(part):
                degrees = self.of(part)
                found.append({n: own.get(n, 0) - degrees.get(n, 0) for n in {*own, *degrees}})
        return found


def zero_by(c: Construction, e: Expr, brackets: Callable[[int], bool], limit: int) -> bool | Frame:
    """Whether an expression is zero wherever a construction leads, as `brackets` decides within a limit of terms; the
    frame in which it is, if one was tried because brackets take more than a few terms.

    Raises LimitReached where both ways take more than `limit` terms.
    """
    try:
        return brackets(min(limit, _FIRST))
    except LimitReached as limited:
        reached = limited
    frame = frame_of(c, e)
    if frame is not None:
        try:
            return frame if frame.is_zero(limit) else False
        except LimitReached:
            pass
    if limit <= _FIRST:
        raise reached
    return brackets(limit)
