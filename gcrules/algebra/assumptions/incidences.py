r"""What an assumption asks of its points: conditions that are solved for one of them.

A condition is an equation. Solved for one of its points p it says that p lies on an extensor S of the other points:
whenever S is not zero, the equation holds exactly for the p that lie on S.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> (assumption,) = parse_assumption("incident(p, ab)").given
>>> (condition,) = facts(assumption, 4).conditions
>>> print(condition.equation, *(f"{name} on {within}" for name, within in condition.within.items()), sep=", ")
abp, a on bp, b on ap, p on ab
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from fractions import Fraction
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.linear import hyperplane, is_extensor, simplified, weighted, weights
from gcrules.algebra.assumptions.quadrics import Quadric
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Meet, Number, Point, Power, Product, Sum, points_of
from gcrules.algebra.names import point_key
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import Assumption
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap

__all__ = [
    "Facts",
    "Helper",
    "IncidenceCondition",
    "all_of",
    "dependent",
    "equal",
    "equations",
    "facts",
    "fault",
    "name_key",
    "of_points",
    "on",
    "small_first",
]

MAX_CONDITIONS = 500


@dataclass(frozen=True, eq=False)
class IncidenceCondition:
    """`equation` vanishes; `within[p]` is the extensor on which p then lies (`exact`: the value that p then has), and
    `through[p]` the quadric, of which points are known.

    Conditions are compared by identity.
    """

    equation: Expr
    within: Mapping[str, Expr]
    cause: Assumption
    exact: bool = False
    through: Mapping[str, Quadric] = FrozenMap()
    names: frozenset[str] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "within", FrozenMap(self.within))
        object.__setattr__(self, "through", FrozenMap(self.through))
        object.__setattr__(self, "names", frozenset(points_of(self.equation)))


@dataclass(frozen=True)
class Helper:
    """A point that exists wherever the assumption holds: `meet` where that is not zero, or some point on `line`."""

    name: str
    meet: Expr | None = None
    line: Expr | None = None


@dataclass(frozen=True)
class Facts:
    """The conditions of an assumption; they are equivalent to it wherever the extensors of `nonzero` do not vanish."""

    conditions: tuple[IncidenceCondition, ...] = ()
    nonzero: tuple[Expr, ...] = ()
    helpers: tuple[Helper, ...] = ()


def fault(assumption: Assumption, why: str, hint: str | None = None) -> InputError:
    """The error that an assumption cannot be resolved, with its place where it is known."""
    message = f"the {assumption.role} {assumption} cannot be resolved: {why}"
    place = assumption.place
    if place is None:
        return InputError(message, hint=hint)
    return InputError(message, hint=hint, span=place.span, source=place.source, filename=place.filename)


def facts(assumption: Assumption, rank: int) -> Facts:
    """The conditions of an assumption. Raises InputError for one that is neither linear nor made of such."""
    if sum(1 for _ in combinations(assumption.args, _POINTS.get(assumption.kind, 1))) > MAX_CONDITIONS:
        raise fault(assumption, "it has too many points", "split it into several assumptions")
    return _FACTS[assumption.kind](assumption, rank)


def equations(assumption: Assumption, rank: int) -> tuple[Expr, ...]:
    """Expressions of any step all of which vanish exactly where the assumption holds (none: it always holds).

    Where lines of rank 4 and more pass through one point, points that occur nowhere else ("any1", …) stand for all
    points. An incidence of X and Y says that every point (or extensor) whose join X is lies on Y.
    """
    d, args = rank, assumption.args
    match assumption.kind:
        case "collinear" | "coplanar":
            return tuple(f.equation for f in facts(assumption, d).conditions)
        case "incident":
            return tuple(e for X, Y in _inclusions(*args) for e in _incidences(assumption, X, Y, d))
        case "concurrent":
            return tuple(_concurrences(assumption, d))
    return () if args[0] == ZERO else args


# --- one condition -------------------------------------------------------------------------------------------------


def _vanishing(cause: Assumption, e: Expr, rank: int) -> IncidenceCondition:
    """The condition that a scalar, or a join, is zero."""
    e = _sorted(e, rank)
    within: dict[str, Expr] = {}
    if e.step == 0:
        for n in points_of(e):
            s = hyperplane(e, n, rank)
            if s is not None and s != ZERO:
                within[n] = _unsigned(s)
    else:
        assert isinstance(e, Join)
        for i, a in enumerate(e.args):
            rest = ex.join(*e.args[:i], *e.args[i + 1 :], rank=rank)
            if isinstance(a, Point) and a.name not in points_of(rest) and is_extensor(rest, rank):
                within[a.name] = rest
    return IncidenceCondition(e, within, cause)


def _sorted(e: Expr, rank: int) -> Expr:
    """Up to its sign, with brackets and joins in one order: the answer must not depend on how they were written."""
    if isinstance(e, Meet):
        return ex.meet(*sorted((_sorted(a, rank) for a in e.args), key=name_key), rank=rank)
    if isinstance(e, Join | Bracket):
        args = sorted(e.args, key=lambda a: (not isinstance(a, Point), *name_key(a)))
        joined = ex.join(*args, rank=rank)
        return bracket(joined, rank=rank) if joined.step == rank else joined
    return e


def _unsigned(e: Expr) -> Expr:
    """Without a number as a factor: the same line or plane."""
    return ex.mul(*e.factors[1:]) if isinstance(e, Product) and isinstance(e.factors[0], Number) else e


def name_key(e: Expr) -> tuple[tuple[str, int, int], str]:
    return point_key(e.name if isinstance(e, Point) else ""), str(e)


def on(cause: Assumption, p: Expr, X: Expr, rank: int) -> IncidenceCondition:
    return _vanishing(cause, ex.join(p, X, rank=rank), rank)


# --- the kinds of assumptions --------------------------------------------------------------------------------------


def _dependent(number: int) -> Callable[[Assumption, int], Facts]:
    return lambda assumption, rank: dependent(assumption, sorted(assumption.args, key=name_key), number, rank)


def dependent(cause: Assumption, points: Sequence[Expr], number: int, rank: int) -> Facts:
    """Any `number` of the points are dependent."""
    if number > rank:
        return Facts()
    return Facts(
        tuple(
            _vanishing(cause, joined, rank)
            for some in combinations(points, number)
            if len(set(some)) == number
            for joined in [ex.join(*some, rank=rank)]
        )
    )


def _incident(assumption: Assumption, rank: int) -> Facts:
    return all_of(_contained(assumption, X, Y, rank) for X, Y in _inclusions(*assumption.args))


def _inclusions(X: Expr, Y: Expr) -> Iterable[tuple[Expr, Expr]]:
    """Which extensor lies on which: the smaller one on the other, and of two joins of one step each on the other, so
    that it matters to no position, not even to one where a join vanishes, which of the two is written first.
    """
    X, Y = small_first(X, Y)
    yield X, Y
    if X.step == Y.step and isinstance(X, Join) and isinstance(Y, Join):
        yield Y, X


def small_first(X: Expr, Y: Expr) -> tuple[Expr, Expr]:
    if X.step != Y.step:
        return (X, Y) if X.step < Y.step else (Y, X)
    return (Y, X) if isinstance(Y, Join | Point) and not isinstance(X, Join | Point) else (X, Y)


def _contained(cause: Assumption, X: Expr, Y: Expr, rank: int) -> Facts:
    """X lies on Y."""
    if X.step == 1:
        return Facts((on(cause, X, Y, rank),))
    if isinstance(X, Join):
        return all_of(_contained(cause, a, Y, rank) for a in X.args)
    if Y.step == rank - 1 and of_points(Y) and is_extensor(X, rank):
        # Y is spanned by X and as many of its points as are missing, if these are not on X; the others lie there.
        points = Y.args if isinstance(Y, Join) else ()
        spanned = ex.join(X, *points[: rank - 1 - X.step], rank=rank)
        rest = points[rank - 1 - X.step :]
        return Facts(tuple(on(cause, p, spanned, rank) for p in rest), (spanned, Y))
    raise fault(cause, f"{X} is not a join of points", "assume it of two points on it: incident(p, X), incident(q, X)")


def _incidences(cause: Assumption, X: Expr, Y: Expr, rank: int) -> Iterable[Expr]:
    """What vanishes where X lies in Y, point by point of X."""
    for part in X.args if isinstance(X, Join) else (X,):
        if part.step == 1:
            yield _sorted(ex.join(part, Y, rank=rank), rank)
        elif Y.step == rank - 1:
            yield ex.meet(part, Y, rank=rank)
        else:
            raise fault(cause, f"{part} is not a join of points", "assume it of points: incident(p, X), incident(q, X)")


def of_points(e: Expr) -> bool:
    return isinstance(e, Point) or (isinstance(e, Join) and all(isinstance(a, Point) for a in e.args))


def _concurrent(assumption: Assumption, rank: int) -> Facts:
    args = sorted(assumption.args, key=name_key)
    if _through_lines(args, rank):
        return _one_point(assumption, args, rank)
    return Facts(tuple(_vanishing(assumption, e, rank) for e in _concurrences(assumption, rank)))


def _through_lines(args: Sequence[Expr], rank: int) -> bool:
    return len(args) > 2 and rank > 3 and all(a.step == 2 for a in args)


def _concurrences(assumption: Assumption, rank: int) -> Iterable[Expr]:
    """The equations: d hyperplanes meet in a scalar; of lines any two meet, and in the same point."""
    args = sorted(assumption.args, key=name_key)
    missing = sum(rank - a.step for a in args)
    if missing < rank:
        return
    if all(a.step == rank - 1 for a in args):
        for some in combinations(args, rank):
            yield ex.meet(*some, rank=rank)
    elif missing == rank and not any(a.step == 1 for a in args):
        yield ex.meet(*args, rank=rank)
    elif all(a.step == 2 for a in args):
        free = [Point(f"any{i + 1}") for i in range(rank - 3)]
        for one, other in combinations(args, 2):
            yield _sorted(ex.join(one, other, rank=rank), rank)
        for one, other, third in combinations(args, 3):
            yield ex.join(ex.meet(one, ex.join(other, *free, rank=rank), rank=rank), third, rank=rank)
    else:
        raise fault(
            assumption,
            "extensors of these steps have no single condition for meeting in a point",
            "name the point: given incident(p, X), incident(p, Y)",
        )


def _one_point(assumption: Assumption, lines: Sequence[Expr], rank: int) -> Facts:
    """Lines in space through a point q, which is constructed on one of them."""
    if not all(of_points(line) for line in lines):
        raise fault(assumption, "the lines are not joins of points", "name the point: given incident(p, X), …")
    helper = Helper(f"common:{assumption}", line=lines[0])
    q = Point(helper.name)
    return Facts(tuple(on(assumption, q, line, rank) for line in lines), helpers=(helper,))


def _zero(assumption: Assumption, rank: int) -> Facts:
    (e,) = assumption.args
    return _vanishes(assumption, e, rank)


def _vanishes(cause: Assumption, e: Expr, rank: int) -> Facts:
    """The conditions under which an expression is zero, by its outermost operation."""
    match e:
        case Number(value=value):
            if value:
                raise fault(cause, f"{value} is not 0")
            return Facts()
        case Point():
            raise fault(cause, "a point is never zero")
        case Power(base=base):
            return _vanishes(cause, base, rank)
        case Product(factors=(Number(), *rest)):
            return _vanishes(cause, ex.mul(*rest), rank)
        case Sum() if e.step == 1:
            return equal(cause, weights(e), rank)
        case Sum() if (simpler := simplified(e, rank)) != e:
            return _vanishes(cause, simpler, rank)
        case Meet(args=args) if e.step:
            return _no_meet(cause, args, rank)
        case Join():
            return Facts((_vanishing(cause, e, rank),))
    if e.step == 0:
        return Facts((_vanishing(cause, e, rank),))
    hint = "use incident(X, Y), collinear(a, b, c) or coplanar(a, b, c, d)"
    if isinstance(e, Sum):
        hint += "; of two extensors that are equal write one in place of the other"
    raise fault(cause, "it is not linear in a point", hint)


def equal(cause: Assumption, row: Mapping[Expr, Fraction], rank: int) -> Facts:
    """A sum of points is zero: each of them is what the others add up to."""
    if len(row) < 2:
        return all_of(_vanishes(cause, e, rank) for e in row)
    within = {}
    for e, c in row.items():
        rest = {other: -k / c for other, k in row.items() if other != e}
        # Points are tried modulo a prime, where its multiples have no inverse.
        known = all(k.denominator % PRIME for k in rest.values())
        if isinstance(e, Point) and known and not any(e.name in points_of(other) for other in rest):
            within[e.name] = weighted(rest, rank)
    return Facts((IncidenceCondition(weighted(row, rank), within, cause, exact=True),))


def _no_meet(cause: Assumption, args: Sequence[Expr], rank: int) -> Facts:
    """A meet with a hyperplane is zero: the rest lies on the hyperplane."""
    for spanned in (False, True):
        for i in reversed(range(len(args))):
            X, Y = ex.meet(*args[:i], *args[i + 1 :], rank=rank), args[i]
            if Y.step < rank - 1 or not is_extensor(X, rank):
                continue
            if of_points(Y) if spanned else isinstance(X, Join):
                found = _contained(cause, X, Y, rank)
                return Facts(found.conditions, (*found.nonzero, X, Y))
    raise fault(cause, "a meet of these steps can be zero in many ways", "use incident(X, Y) or concurrent(X, Y, Z)")


def all_of(parts: Iterable[Facts]) -> Facts:
    found = list(parts)
    return Facts(
        tuple(c for f in found for c in f.conditions),
        tuple(e for f in found for e in f.nonzero),
        tuple(h for f in found for h in f.helpers),
    )


_POINTS = {"collinear": 3, "coplanar": 4}
_FACTS: Mapping[str, Callable[[Assumption, int], Facts]] = {
    "collinear": _dependent(3),
    "coplanar": _dependent(4),
    "incident": _incident,
    "concurrent": _concurrent,
    "zero": _zero,
}
