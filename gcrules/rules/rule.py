r"""A rule of recognition: what it finds, and what it records in the derivation."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from gcrules.algebra.expr import Expr
from gcrules.rules.oracle import Oracle
from gcrules.rules.state import State

__all__ = ["Rule", "applied", "reach"]


@dataclass(frozen=True)
class Rule:
    """One step of recognition.

    `apply` yields the states that a state may lead to, most telling first (none where the rule stays silent); `after`
    gives what the superbracket equals then (None where the step rewrites nothing), `why` the reason in words.
    """

    id: str
    sentence: str
    source: str
    apply: Callable[[State], Iterator[State]]
    after: Callable[[State, Oracle], Expr | None]
    why: Callable[[State], str]


def applied(rule: Rule, state: State) -> Iterator[State]:
    """The states that a rule leads to, each with the rule on its trail."""
    for found in rule.apply(state):
        yield replace(found, trail=(*state.trail, (rule, found)))


def reach(rules: Sequence[Rule], state: State) -> Iterator[State]:
    """All states that the rules lead to, one after the other."""
    if not rules:
        yield state
        return
    for found in applied(rules[0], state):
        yield from reach(rules[1:], found)
