r"""Rewriting an expression by rules: each application is a step that replays on the exact oracle.

>>> from gcrules.algebra.language.statements import parse_script
>>> from gcrules.algebra.language.syntax import parse
>>> from gcrules.rules.rule_file import identities
>>> meet = identities(parse_script("rule meet: ab /\\ cde => [acde] b - [bcde] a"))
>>> print(rewrite(parse("pq /\\ rst"), meet))
pq /\ rst
  = [prst] * q - [qrst] * p
      by meet: ab /\ cde => [acde] b - [bcde] a
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gcrules.algebra.assumptions.assumed import resolve
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.space import Space
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.rules.derivation import Derivation, Step
from gcrules.rules.identity import Identity, rewrite_all
from gcrules.rules.rule import RewriteRule

__all__ = ["Rewriting", "rewrite"]


@dataclass(frozen=True)
class Rewriting(Shown):
    """before = … = after, one step for each application of a rule; no steps where every rule stayed silent."""

    before: Expr
    steps: tuple[Step, ...]
    space: Space

    @property
    def after(self) -> Expr:
        """The expression on which all rules stay silent."""
        return self.steps[-1].after if self.steps else self.before

    @property
    def derivation(self) -> Derivation:
        """The steps as a chain that replays and unfolds."""
        return Derivation(self.steps, self.space)

    def to_json(self) -> dict[str, Any]:
        """`{before, after, derivation}`, the derivation as in `Derivation.to_json`."""
        names = self.space.points
        return {
            "before": text(self.before, names=names),
            "after": text(self.after, names=names),
            "derivation": self.derivation.to_json(),
        }


def rewrite(e: Expr, rules: Iterable[RewriteRule], space: Space | None = None) -> Rewriting:
    """Apply rules, the first that fires each time, until all stay silent.

    Raises LimitReached where they never do, or where matching takes too long.
    """
    space = space or Space()
    steps = []
    before = e
    for rule, after in rewrite_all(e, tuple(rules), space):
        step = Step(rule.id, before, after, rule.sentence, _assumed(rule, space))
        if not step.check(space):
            raise rule.fault(f"the rule {rule.id} makes {after} of {before}, which is not equal")
        steps.append(step)
        before = after
    return Rewriting(e, tuple(steps), space)


def _assumed(rule: RewriteRule, space: Space) -> tuple[Expr, ...]:
    """What must not vanish for a rule with assumptions to hold."""
    instance = rule.instance(space.rank) if isinstance(rule, Identity) else None
    return resolve(space).nonzero if instance is not None and instance.given else ()
