r"""Identities: rules written in the language, which rewrite bracket polynomials and expressions.

`rule gp3: [R... a b][R... c d] => [R... a c][R... b d] - [R... a d][R... b c] if a < c` stands for one identity in
each rank. An identity whose left side is made of brackets alone rewrites bracket polynomials; any other rewrites the
parts of an expression that look like its left side.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Coefficient, Monomial, Terms, sorted_row
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import (
    Bracket,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    points_of,
    substitute,
)
from gcrules.algebra.given import holds
from gcrules.algebra.parts import first_part
from gcrules.algebra.prove import prove
from gcrules.algebra.rule_text import Instance, Order
from gcrules.algebra.space import Assumption, Space
from gcrules.errors import LimitReached
from gcrules.rules.matching import Budget, match_monomial, matches
from gcrules.rules.rule import RewriteRule

__all__ = ["MAX_REWRITES", "Identity", "instance_fault", "only_brackets", "rewrite_all", "rewritten"]

MAX_REWRITES = 1_000
MAX_PARTS = 20_000


@dataclass(frozen=True, kw_only=True)
class Identity(RewriteRule):
    """left = right in each rank of `instances`, where the guards hold; `text` is the rule as written."""

    text: str
    instances: tuple[Instance, ...]

    def instance(self, rank: int) -> Instance | None:
        return next((i for i in self.instances if i.rank == rank), None)

    def rewrite(self, e: Expr, space: Space) -> Expr | None:
        """One application. A sum of bracket monomials is rewritten as a bracket polynomial; in any other expression the
        first part, from the outside in, that looks like the left side. What a rule with assumptions makes is proved
        once more, under the assumptions of the space, before it is used.
        """
        instance = self.instance(space.rank)
        if instance is None:
            return None
        found = self._rewritten(instance, e, space)
        if found is not None and instance.given and not _proved(e, found, space):
            return None
        return found

    def _rewritten(self, instance: Instance, e: Expr, space: Space) -> Expr | None:
        if not only_brackets(instance.left):
            return _rewrite_expression(instance, e, space)
        if not only_brackets(e):
            return first_part(e, lambda part: self.rewrite(part, space) if only_brackets(part) else None, space.rank)
        found = self.step(_polynomial(e, space), space)
        return None if found is None else found.to_expr()

    def step(self, polynomial: BracketPolynomial, space: Space) -> BracketPolynomial | None:
        """One application to a bracket polynomial; None where the rule stays silent."""
        instance = self.instance(polynomial.rank)
        if instance is None or not only_brackets(instance.left):
            return None
        return next(_applications(instance, polynomial, space), None)


def instance_fault(instance: Instance) -> str | None:
    """What keeps an instance from being applied: a sentence that follows "the rule …"."""
    if points_of(instance.left) == ():
        return "has no points on its left side"
    if only_brackets(instance.left):
        terms = _left(instance)
        if not terms:
            return "has a left side that is 0"
        names = {n for _, rows in terms for row in rows for n in row}
        if names != {n for row in terms[0][1] for n in row}:
            return "has no term on its left side that holds all its points"
        if not names >= set(points_of(instance.right)):
            return "has points that cancel on its left side"
    elif isinstance(instance.left, Sum):
        return "has a sum on its left side with more than brackets of points in it"
    return None


def rewritten(polynomial: BracketPolynomial, rule: Identity, space: Space) -> BracketPolynomial:
    """The polynomial after as many applications of the rule as there are. Raises LimitReached where it loops."""
    seen = {polynomial}
    while (after := rule.step(polynomial, space)) is not None:
        if after in seen:
            raise LimitReached(f"the rule {rule.id} loops: it comes back to {_short(after)}", hint=_GUARD)
        if len(seen) > MAX_REWRITES:
            raise LimitReached(f"the rule {rule.id} does not end within {MAX_REWRITES:,} applications", hint=_GUARD)
        seen.add(after)
        polynomial = after
    return polynomial


_GUARD = "add a guard such as `if a < b` that the result does not satisfy"


def rewrite_all(e: Expr, rules: tuple[RewriteRule, ...], space: Space) -> Iterator[tuple[RewriteRule, Expr]]:
    """The rules in sequence, the first that fires each time, until all stay silent: each rule with what it leads to.

    Raises LimitReached where an expression comes back or the applications do not end.
    """
    seen = {e}
    while True:
        for rule in rules:
            after = rule.rewrite(e, space)
            if after is not None:
                break
        else:
            return
        what = f"the rule {rule.id} loops: it" if len(rules) == 1 else f"the rules loop: {rule.id}"
        if _parts(after) > MAX_PARTS:
            raise LimitReached(f"{what} makes expressions of more than {MAX_PARTS:,} parts", hint=_GUARD)
        if after in seen:
            raise LimitReached(f"{what} comes back to {_short(after)}", hint=_GUARD)
        if len(seen) > MAX_REWRITES:
            raise LimitReached(f"{what} does not end within {MAX_REWRITES:,} applications", hint=_GUARD)
        yield rule, after
        seen.add(after)
        e = after


def _parts(e: Expr) -> int:
    """The number of parts of an expression, shared ones counted each time they occur."""
    known: dict[int, int] = {}

    def count(x: Expr) -> int:
        if id(x) not in known:
            known[id(x)] = 1 + sum(map(count, x.children))
        return known[id(x)]

    return count(e)


def _short(value: object) -> str:
    shown = str(value)
    return shown if len(shown) <= 80 else f"{shown[:80]}…"


# --- bracket polynomials -------------------------------------------------------------------------------------------


def only_brackets(e: Expr) -> bool:
    """Whether an expression is a polynomial in brackets of points, as it stands."""
    match e:
        case Number():
            return True
        case Bracket(args=args):
            return all(isinstance(a, Point) for a in args)
        case Sum(terms=parts) | Product(factors=parts):
            return all(map(only_brackets, parts))
        case Power(base=base):
            return only_brackets(base)
    return False


def _polynomial(e: Expr, space: Space) -> BracketPolynomial:
    found = expand(e, points=space.points, ideal=space.ideal, rank=space.rank)
    assert isinstance(found, BracketPolynomial)
    return found


_Patterns = tuple[tuple[Coefficient, tuple[tuple[str, ...], ...]], ...]


@lru_cache(maxsize=256)
def _left(instance: Instance) -> _Patterns:
    """The terms of the left side, those with the most different points first."""
    found = expand(instance.left, rank=instance.rank)
    assert isinstance(found, BracketPolynomial)
    terms = [(c, rows) for c, rows in found.named()]
    return tuple(sorted(terms, key=lambda t: -len({n for row in t[1] for n in row})))


@lru_cache(maxsize=256)
def _right(instance: Instance) -> _Patterns:
    found = expand(instance.right, rank=instance.rank)
    assert isinstance(found, BracketPolynomial)
    return tuple(found.named())


def _applications(instance: Instance, polynomial: BracketPolynomial, space: Space) -> Iterator[BracketPolynomial]:
    """The polynomials that one application leads to, none of them equal to it."""
    left = _left(instance)
    if not left:
        return
    c, first = left[0]
    run_of = {n: run for run, names in instance.runs.items() for n in names}
    budget = Budget()
    for monomial, coefficient in polynomial.terms.items():
        for binding, sign, used in match_monomial(first, monomial, run_of, budget):
            rest = tuple(row for i, row in enumerate(monomial) if i not in used)
            factor = Fraction(coefficient, c) * sign
            images = [(factor * k, *_image(rows, binding, rest)) for k, rows in left]
            if any(polynomial.terms.get(m, 0) != s * k for k, s, m in images if s):
                continue
            if len({m for _, s, m in images if s}) < sum(1 for _, s, _ in images if s):
                continue
            if not all(_holds(guard, binding, polynomial, space) for guard in instance.guards):
                continue
            terms: Terms = dict(polynomial.terms)
            for _, s, m in images:
                if s:
                    del terms[m]
            for k, rows in _right(instance):
                s, m = _image(rows, binding, rest)
                if s:
                    terms[m] = terms.get(m, 0) + factor * k * s
            after = polynomial.with_terms(_finite(terms, polynomial.ideal))
            if after != polynomial:
                yield after


def _image(rows: tuple[tuple[str, ...], ...], binding: Mapping[str, int], rest: Monomial) -> tuple[int, Monomial]:
    """Sign (0 where a point repeats in a bracket) and monomial of a pattern under a binding, times the rest."""
    sign, brackets = 1, list(rest)
    for row in rows:
        s, bracket = sorted_row(binding[n] for n in row)
        sign *= s
        brackets.append(bracket)
    return sign, tuple(sorted(brackets))


def _finite(terms: Terms, ideal: int) -> Terms:
    """Without the terms that have a bracket of points at infinity."""
    return {m: c for m, c in terms.items() if not any(row[-1] < ideal for row in m)}


def _holds(guard: Order | Assumption, binding: Mapping[str, int], polynomial: BracketPolynomial, space: Space) -> bool:
    if isinstance(guard, Order):
        a, b = binding[guard.left], binding[guard.right]
        return a < b if guard.sign == "<" else a != b
    return _assumed(guard, {n: Point(polynomial.points[i]) for n, i in binding.items()}, space)


def _assumed(guard: Assumption, values: Mapping[str, Expr], space: Space) -> bool:
    """Whether an assumption, with its points replaced, is proved in the space: where nothing is known, it is not."""
    args = tuple(substitute(a, dict(values), space.rank) for a in guard.args)
    return holds(Assumption(guard.kind, args, guard.text), space)


def _proved(before: Expr, after: Expr, space: Space) -> bool:
    found = prove(before, after, points=space.points, ideal=space.ideal, rank=space.rank, given=space.given)
    return found.proved


# --- expressions ---------------------------------------------------------------------------------------------------


def _rewrite_expression(instance: Instance, e: Expr, space: Space) -> Expr | None:
    budget = Budget()

    def at(part: Expr) -> Expr | None:
        for values, sign, rest in matches(instance.left, part, space.rank, budget):
            if not all(_satisfied(g, values, space) for g in instance.guards):
                continue
            right = substitute(instance.right, dict(values), space.rank)
            after = ex.signed(sign, _with_rest(part, right, rest, space.rank))
            if after != part:
                return after
        return None

    return first_part(e, at, space.rank)


def _satisfied(guard: Order | Assumption, values: Mapping[str, Expr], space: Space) -> bool:
    if isinstance(guard, Assumption):
        return _assumed(guard, values, space)
    a, b = values[guard.left], values[guard.right]
    if guard.sign == "!=":
        return a != b
    if not (isinstance(a, Point) and isinstance(b, Point)):
        return False
    place = {n: i for i, n in enumerate((*space.ideal, *space.points))}
    return _key(a.name, place) < _key(b.name, place)


def _key(name: str, place: Mapping[str, int]) -> tuple[int, tuple[str, int, int]]:
    return place.get(name, len(place)), ex.point_key(name)


def _with_rest(part: Expr, new: Expr, rest: tuple[Expr, ...], rank: int) -> Expr:
    """What stands for the matched parts of a join, meet or product, with the parts left over behind it."""
    if not rest:
        return new
    match part:
        case Join():
            return ex.join(new, *rest, rank=rank)
        case Meet():
            return ex.meet(new, *rest, rank=rank)
    return ex.mul(new, *rest)
