r"""Identities: rules written in the language, which rewrite bracket polynomials and expressions.

`rule gp3: [R... a b][R... c d] => [R... a c][R... b d] - [R... a d][R... b c] if a < c` stands for one identity in
each rank. An identity whose left side is made of brackets alone rewrites bracket polynomials; any other rewrites the
parts of an expression that look like its left side.
"""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expr import Expr, Sum, points_of
from gcrules.algebra.language.rule_text import Instance
from gcrules.algebra.parts import first_part
from gcrules.algebra.prove import prove
from gcrules.algebra.space import Space
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.rules.applying import applications, left_terms, only_brackets, polynomial_of, rewrite_expression
from gcrules.rules.rule import RewriteRule, reductions

__all__ = ["MAX_REWRITES", "Identity", "instance_fault", "rewrite_all", "rewritten"]

MAX_REWRITES = 1_000
MAX_PARTS = 20_000


@dataclass(frozen=True, kw_only=True)
class Identity(RewriteRule):
    """left = right in each rank of `instances`, where the guards hold; `text` is the rule as written."""

    text: str
    instances: tuple[Instance, ...]

    def instance(self, rank: int) -> Instance | None:
        """The identity in this rank."""
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
            return rewrite_expression(instance, e, space)
        if not only_brackets(e):
            return first_part(e, lambda part: self.rewrite(part, space) if only_brackets(part) else None, space.rank)
        found = self.step(polynomial_of(e, space), space)
        return None if found is None else found.to_expr()

    def step(self, polynomial: BracketPolynomial, space: Space) -> BracketPolynomial | None:
        """One application to a bracket polynomial; None where the rule stays silent."""
        instance = self.instance(polynomial.rank)
        if instance is None or not only_brackets(instance.left) or (instance.given and not space.given):
            return None  # where nothing is assumed, an assumption holds by accident at most
        for after in applications(instance, polynomial, space):
            if not instance.given or _proved(polynomial.to_expr(), after.to_expr(), space):
                return after
        return None


def _proved(before: Expr, after: Expr, space: Space) -> bool:
    found = prove(before, after, points=space.points, ideal=space.ideal, rank=space.rank, given=space.given)
    return found.proved


def instance_fault(instance: Instance) -> str | None:
    """What keeps an instance from being applied: a sentence that follows "the rule …"."""
    if points_of(instance.left) == ():
        return "has no points on its left side"
    if only_brackets(instance.left):
        terms = left_terms(instance)
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
    for rule, after in reductions(e, rules, space):
        what = f"the rule {rule.id} loops: it" if len(rules) == 1 else f"the rules loop: {rule.id}"
        if _parts(after) > MAX_PARTS:
            raise LimitReached(f"{what} makes expressions of more than {MAX_PARTS:,} parts", hint=_GUARD)
        if after in seen:
            raise LimitReached(f"{what} comes back to {_short(after)}", hint=_GUARD)
        if len(seen) > MAX_REWRITES:
            raise LimitReached(f"{what} does not end within {MAX_REWRITES:,} applications", hint=_GUARD)
        yield rule, after
        seen.add(after)


def _parts(e: Expr) -> int:
    """The number of parts of an expression, shared ones counted each time they occur."""
    known: dict[int, int] = {}

    def count(x: Expr) -> int:
        if id(x) not in known:
            checkpoint()
            known[id(x)] = 1 + sum(map(count, x.children))
        return known[id(x)]

    return count(e)


def _short(value: object) -> str:
    shown = str(value)
    return shown if len(shown) <= 80 else f"{shown[:80]}…"
