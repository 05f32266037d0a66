r"""The kinds of positions that assumptions allow: scalars that vanish are taken apart into what makes them vanish.

A product of brackets vanishes where one of them does, and each of them is a kind of its own, also where it is one for
other assumptions only, or where a sum is a product in disguise: [bcd][abe] - [abd][bce] = [abc][bde].

>>> from gcrules.algebra.assumptions.assumed import kinds
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> space = parse_assumption("collinear(a, b, d), [bcd][abe] == [abd][bce]", Context(rank=3))
>>> for kind in kinds(space):
...     print(*kind.where, "==", 0)
[abe] == 0
[bcd] == 0
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from itertools import combinations
from math import comb

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.assumptions.images import MAX_KINDS
from gcrules.algebra.assumptions.incidences import equations, fault, of_points
from gcrules.algebra.bracket import BracketPolynomial, Monomial, Terms, primitive
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Bracket, Expr, Number, Point, Power, Product
from gcrules.algebra.language.text import text
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint, watched
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError, LimitReached

__all__ = ["Alternative", "ConstructionTask", "alternatives", "flats", "parts"]

bracket_factors = deferred("gcrules.algebra.factoring.brackets:bracket_factors")

_MAX_TERMS = 500  # of a scalar that is taken apart
_SPAN = {"collinear": 2, "coplanar": 3}
_MAX_ROUNDS = 200
_MAX_BRACKETS = 300  # of the points of a scalar


@dataclass(frozen=True)
class ConstructionTask:
    """What is given of the points of a space, in tableau order, and how to construct points of which some is given."""

    space: Space
    construct: Callable[[tuple[Assumption, ...]], Construction]


@dataclass(frozen=True)
class Alternative:
    """One way to satisfy the assumptions: `given` in their place, of which `where` was chosen to vanish.

    Every position that satisfies the assumptions, and at which no extensor of `nonzero` vanishes, satisfies one of the
    alternatives.
    """

    given: tuple[Assumption, ...]
    where: tuple[Expr, ...] = ()
    nonzero: tuple[Expr, ...] = ()
    fault: InputError | None = field(
        default=None, compare=False
    )  # why there are no such positions, where that is known


@dataclass(frozen=True)
class _Open:
    """Assumptions that are `plain` already, and scalars that are to be taken apart."""

    plain: tuple[Assumption, ...]
    scalars: tuple[Assumption, ...]
    where: tuple[Expr, ...] = ()
    nonzero: tuple[Expr, ...] = ()


def alternatives(task: ConstructionTask) -> list[Alternative]:
    """The alternatives that together are all that is given allows. Raises InputError where there are too many."""
    given, rank = task.space.given, task.space.rank
    plain = tuple(a for a in given if _plain(a, rank))
    pieces = {a: _pieces(a, rank) for a in given if a not in plain}
    waiting = [_Open(plain, tuple(dict.fromkeys(p for some in pieces.values() for p in some)))]
    done: dict[frozenset[str], Alternative] = {}
    for _ in range(_MAX_ROUNDS):
        if not waiting:
            return list(done.values())
        checkpoint()
        at = waiting.pop()
        failure: InputError | None = None
        try:
            further = list(_next(at, task))
        except InputError as raised:
            further, failure = [at], raised
        if further == [at]:
            found = Alternative((*at.plain, *_whole(at.scalars, pieces)), at.where, at.nonzero, failure)
            done.setdefault(frozenset(map(str, found.given)), found)
        waiting += [] if further == [at] else further
        if len(done) + len(waiting) > MAX_KINDS:
            break
    raise fault(given[-1], f"the assumptions allow more than {MAX_KINDS} kinds of positions", "assume less at a time")


def flats(given: Iterable[Assumption], rank: int) -> Iterator[Expr]:
    """The lines and planes of which assumptions speak, as joins of points: those that are written as such, and those
    on which points are said to lie.
    """
    for a in given:
        if a.kind in ("collinear", "coplanar"):
            some = [p for p in dict.fromkeys(a.args) if isinstance(p, Point)]
            yield from (ex.join(*j, rank=rank) for j in combinations(some, min(rank, _SPAN[a.kind])) if len(j) < rank)
        for e in (part for arg in a.args for part in ex.subexpressions(arg)):
            if 1 < e.step < rank and of_points(e) and (a.kind, e) != ("zero", a.args[0]):
                yield e


def _plain(a: Assumption, rank: int) -> bool:
    """Whether an assumption says of points where they lie, or something that is no scalar."""
    if all(map(of_points, a.args)) and a.kind in ("collinear", "coplanar", "incident"):
        return True
    try:
        wanted = equations(a, rank)
    except InputError:
        return True
    return not wanted or any(e.step or not ex.points_of(e) for e in wanted) or all(map(_of_points, wanted))


def _pieces(a: Assumption, rank: int) -> tuple[Assumption, ...]:
    """An assumption of several scalars as one for each of them."""
    wanted = equations(a, rank)
    return (a,) if len(wanted) == 1 else tuple(_vanishing(e, a) for e in wanted)


def _whole(scalars: Sequence[Assumption], pieces: Mapping[Assumption, tuple[Assumption, ...]]) -> Iterator[Assumption]:
    """With the assumptions of which no piece was taken apart as they were written."""
    left = dict.fromkeys(scalars)
    for a, some in pieces.items():
        if all(p in left for p in some):
            yield a
            left = {p: None for p in left if p not in some}
    yield from left


def _vanishing(scalar: Expr, cause: Assumption) -> Assumption:
    return Assumption("zero", (scalar,), f"{text(scalar, names=ex.points_of(scalar))} == 0", cause.place)


def _of_points(e: Expr) -> bool:
    return isinstance(e, Bracket) and all(isinstance(a, Point) for a in e.args)


def _next(at: _Open, task: ConstructionTask) -> Iterator[_Open]:
    """What comes of the first scalar that can be taken apart; the same again if there is none.

    Raises InputError where the plain assumptions alone cannot be satisfied.
    """
    for a in at.plain:
        if (ways := _through_a_corner(a, task.space.rank)) is not None:
            for e, some in ways:
                plain = dict.fromkeys(x for x in (*at.plain, *some) if x != a)
                where = at.where if e == ex.ZERO else tuple(dict.fromkeys((*at.where, e)))
                yield replace(at, plain=tuple(plain), where=where)
            return
    together = _solved(at, task)
    if together is not None:
        yield together
        return
    base = task.construct(at.plain) if at.scalars else None
    for i, a in enumerate(at.scalars):
        checkpoint()
        (e,) = equations(a, task.space.rank)
        found = parts(e, base, task.space) if base is not None else None
        if found is None:
            continue
        several, nonzero = tuple(dict.fromkeys(found[0])), found[1]
        others = replace(
            at,
            scalars=(*at.scalars[:i], *at.scalars[i + 1 :]),
            nonzero=tuple(dict.fromkeys((*at.nonzero, *nonzero))),
        )
        if not several:
            yield others
        for part in several:
            where = (*at.where, part) if len(several) > 1 else at.where
            yield replace(_with(others, part, a), where=tuple(dict.fromkeys(where)))
        return
    yield at


def _through_a_corner(a: Assumption, rank: int) -> list[tuple[Expr, list[Assumption]]] | None:
    """Lines through one point, two of which have a point b in common: b is that point, or both are one line.

    Each with what vanishes then, and what is to be assumed in its place. In the plane scalars tell the same.
    """
    if a.kind != "concurrent" or rank < 4 or not all(of_points(e) and e.step == 2 for e in a.args):
        return None
    if any(len(set(e.children)) < 2 for e in a.args):  # aa is zero and no line
        return None
    for one, other in watched(combinations(dict.fromkeys(a.args), 2)):
        common = [p for p in one.children if p in other.children]
        if len(common) == 1 and len(a.args) > 2:
            (b,) = common
            rest = [e for e in dict.fromkeys(a.args) if e not in (one, other)]
            aside = [e for e in rest if b not in e.children]
            if not aside:
                return [(ex.ZERO, [])]  # all of them pass through b
            ends = [p for p in (*one.children, *other.children) if p != b]
            through = [Assumption("incident", (b, e), f"incident({b}, {e})", a.place) for e in aside]
            line = Assumption("collinear", (b, *ends), f"collinear({b}, {ends[0]}, {ends[1]})", a.place)
            again = Assumption("concurrent", (one, *rest), f"concurrent({', '.join(map(str, (one, *rest)))})", a.place)
            return [(ex.join(b, aside[0], rank=rank), through), (ex.join(b, *ends, rank=rank), [line, again])]
    return None


def _with(at: _Open, scalar: Expr, cause: Assumption) -> _Open:
    more = _vanishing(scalar, cause)
    if _of_points(scalar):
        return replace(at, plain=(*(a for a in at.plain if a != more), more))
    return replace(at, scalars=(*at.scalars, more))


def parts(e: Expr, base: Construction, space: Space) -> tuple[tuple[Expr, ...], tuple[Expr, ...]] | None:
    """The factors, as often as they occur, of a scalar that vanishes in a space, and what must not vanish so that it is
    a multiple of their product wherever a construction leads.

    None where nothing is gained: it is no product.
    """
    written = tuple(_factors(e))
    if len(written) > 1 or written[:1] not in ((), (e,)):
        return written, ()

    try:
        poly = _polynomial(e, space)
        left = _without_zeros(e, base, space)
        if not len(left):
            return (), base.nonzero if len(poly) else ()
        rows, rest = bracket_factors(primitive(left)[1], limit=_MAX_TERMS * 20)
    except LimitReached:
        return None
    same = left.over(poly.points, poly.ideal).terms == poly.terms if len(left) == len(poly) else False
    nonzero = () if same else base.nonzero
    brackets = [Bracket(tuple(Point(rest.points[i]) for i in row)) for row in rows]
    remainder = [rest.to_expr()] if any(rest.terms) else []
    if not brackets:
        return None  # nothing is gained
    return (*brackets, *remainder), nonzero


def _factors(e: Expr) -> Iterator[Expr]:
    """The factors of a product as it is written, without numbers and exponents."""
    match e:
        case Product(factors=factors):
            for f in factors:
                yield from _factors(f)
        case Power(base=base, exponent=n):
            for _ in range(n):
                yield from _factors(base)
        case Number(value=value) if value:
            return
        case _:
            yield e


def _polynomial(e: Expr, space: Space) -> BracketPolynomial:
    """The normal form. Raises LimitReached for one of many terms."""
    found = straighten(e, points=space.points, ideal=space.ideal, rank=space.rank, limit=_MAX_TERMS)
    assert isinstance(found, BracketPolynomial)
    return found


def _without_zeros(e: Expr, base: Construction, space: Space) -> BracketPolynomial:
    """What is left of a scalar, in normal form, without the brackets that vanish by other assumptions: without terms
    that hold one, in whichever order of the points there are most of them.
    """
    left = expand(e, points=space.points, ideal=space.ideal, rank=space.rank, limit=_MAX_TERMS)
    assert isinstance(left, BracketPolynomial)
    used = sorted({i for m in left.terms for row in m for i in row})
    if comb(len(used), space.rank) > _MAX_BRACKETS:
        return _normal(left)
    names = [tuple(left.points[i] for i in row) for row in combinations(used, space.rank)]
    zeros = [row for row in names if _is_zero(Bracket(tuple(map(Point, row))), base)]
    left = _dropped(left, zeros)
    if len(left) == 1:
        return left  # as it is written, whatever the order of the points
    left = _normal(left)
    for row in zeros:
        checkpoint()
        order = tuple(dict.fromkeys((*left.points[: left.ideal], *row, *left.points)))
        moved = _normal(_dropped(_normal(left.over(order, left.ideal)), zeros))
        if len(moved) < len(left):
            left = moved
    return left


def _is_zero(e: Expr, base: Construction) -> bool:
    checkpoint()
    return base.vanishes(e) and base.is_zero(e)


def _dropped(poly: BracketPolynomial, zeros: Iterable[tuple[str, ...]]) -> BracketPolynomial:
    index = {n: i for i, n in enumerate(poly.points)}
    rows = {tuple(sorted(index[n] for n in row)) for row in zeros}
    return poly.with_terms({m: c for m, c in poly.terms.items() if rows.isdisjoint(m)})


def _normal(poly: BracketPolynomial) -> BracketPolynomial:
    found = straighten(poly, limit=_MAX_TERMS * 20)
    assert isinstance(found, BracketPolynomial)
    return found


# --- several scalars -----------------------------------------------------------------------------------------------


def _solved(at: _Open, task: ConstructionTask) -> _Open | None:
    """Scalars solved together as linear equations between their monomials, where that leaves fewer terms."""

    rows: dict[int, Terms] = {}
    for i, a in enumerate(at.scalars):
        (e,) = equations(a, task.space.rank)
        try:
            rows[i] = dict(_polynomial(e, task.space).over(_order(task), len(task.space.ideal)).terms)
        except LimitReached:
            continue
    reduced = _echelon(list(rows.values()))
    if len(rows) < 2 or sum(map(len, reduced)) >= sum(map(len, rows.values())):
        return None
    found = replace(at, scalars=tuple(a for i, a in enumerate(at.scalars) if i not in rows))
    cause = at.scalars[max(rows)]
    if any(set(terms) == {()} for terms in reduced):
        raise fault(cause, "it contradicts the others: together they say that 1 is 0")
    for terms in reduced:
        poly = BracketPolynomial(task.space.rank, _order(task), terms, len(task.space.ideal))
        found = _with(found, primitive(poly)[1].to_expr(), cause)
    return found


def _order(task: ConstructionTask) -> tuple[str, ...]:
    return (*task.space.ideal, *(n for n in task.space.points if n not in task.space.ideal))


def _echelon(rows: Sequence[Mapping[Monomial, int | Fraction]]) -> list[Terms]:
    """The reduced echelon form, without rows that vanish."""
    found: list[tuple[Monomial, Terms]] = []
    for row in rows:
        left: Terms = dict(row)
        for pivot, other in found:
            checkpoint()
            left = _minus(left, other, pivot)
        if left:
            pivot = min(left)
            found = [(p, _minus(other, left, pivot)) for p, other in found]
            found.append((pivot, left))
    return [row for _, row in found]


def _minus(row: Terms, other: Terms, pivot: Monomial) -> Terms:
    """The row minus the multiple of the other that leaves the pivot out."""
    if not row.get(pivot):
        return row
    factor = Fraction(row[pivot]) / other[pivot]
    found = {m: row.get(m, 0) - factor * other.get(m, 0) for m in {**row, **other}}
    return {m: c for m, c in found.items() if c}
