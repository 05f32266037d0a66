"""Rewriting by rules."""

from __future__ import annotations

from collections.abc import Iterable

from gcrules.algebra.expr import Expr, common_rank
from gcrules.algebra.language.text import Names
from gcrules.algebra.space import Space
from gcrules.api.reading import expression_of, where
from gcrules.api.signatures import public
from gcrules.core.errors import InputError
from gcrules.rules.plugin import Plugin
from gcrules.rules.plugins import load_rules
from gcrules.rules.rewriting import Rewriting
from gcrules.rules.rewriting import rewrite as _rewrite
from gcrules.rules.rule import RewriteRule

__all__ = ["Rewriting", "rewrite"]


@public
def rewrite(
    e: str | Expr,
    rules: Iterable[str | RewriteRule],
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
) -> Rewriting:
    """Apply rules, the first that fires each time, until all stay silent; every application is a step of the answer.

    `rules` are names of rewriting rules (of the engine and of plugins), rules, or names of `.gca` files. Raises
    InputError for a rule that is none or that is wrong, LimitReached where rewriting does not end.
    """
    at = where(rank, points, ideal, isotropic, orthonormal, letters)
    expression = expression_of(e, at)
    space = Space(common_rank(rank, expression), at.points, at.ideal)
    return _rewrite(expression, _rewriting_rules(rules), space)


def _rewriting_rules(rules: Iterable[str | RewriteRule]) -> list[RewriteRule]:
    found: list[RewriteRule] = []
    for rule in [rules] if isinstance(rules, str) else rules:
        if isinstance(rule, RewriteRule):
            found.append(rule)
        elif rule.endswith(".gca"):
            found += Plugin(rule_files=(rule,)).identities()
        else:
            named = load_rules()[rule]
            if not isinstance(named, RewriteRule):
                raise InputError(f"the rule {rule} recognises entities; it rewrites no expressions")
            found.append(named)
    return found
