r"""Derivations: chains of equal expressions, each link with the rule that made it, replayable on the exact oracle.

>>> from gcrules.algebra.language.syntax import parse
>>> start = parse("[[ab, af, cb, cd, ed, ef]]")
>>> two_terms = parse("[abce][abdf][cdef] - [abcf][acde][bdef]")
>>> d = Derivation((Step("superbracket", start, two_terms, "brackets with a repeated point are 0"),))
>>> [step.rule for step in d.full()], d.full().check()
(['superbracket', 'vanishing', 'sorting'], True)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from gcrules.algebra.expr import Expr
from gcrules.algebra.space import Space
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.shown import Shown
from gcrules.rules.rule import Rule
from gcrules.rules.step import Step, joined
from gcrules.rules.unfold import unfold

__all__ = ["Derivation", "Step"]

_SPACE = Space()


@dataclass(frozen=True)
class Derivation(Shown):
    """Steps in sequence in one space, each beginning where the one before ended: first = … = last expression."""

    steps: tuple[Step, ...] = ()
    space: Space = _SPACE

    def __iter__(self) -> Iterator[Step]:
        return iter(self.steps)

    def __len__(self) -> int:
        return len(self.steps)

    @property
    def ideal(self) -> tuple[str, ...]:
        """The points at infinity."""
        return self.space.ideal

    @property
    def before(self) -> Expr:
        """The expression that is derived from. Raises IndexError where there are no steps, as `after` does."""
        return self.steps[0].before

    @property
    def after(self) -> Expr:
        """The expression that is arrived at."""
        return self.steps[-1].after

    @property
    def assumed(self) -> tuple[Expr, ...]:
        """What must not vanish for the conclusion, all steps together."""
        return tuple(dict.fromkeys(e for step in self.steps for e in step.assumed))

    def then(self, rule: str, after: Expr, why: str, assumed: tuple[Expr, ...] = ()) -> Derivation:
        """The derivation with one more step from where this one ends."""
        return replace(self, steps=(*self.steps, Step(rule, self.after, after, why, assumed)))

    def check(self) -> bool:
        """Replay on the exact oracle: every step holds, and each begins where the one before ended."""
        return joined(self.steps) and all(step.check(self.space) for step in self.steps)

    def unfolded(self, rules: Iterable[Rule] = ()) -> Derivation:
        """The same steps, each with the single steps that it is made of; `rules` are known beside the elementary ones.

        Where a step has too many of them, its reason says so.
        """
        known = tuple(rules)
        return replace(self, steps=tuple(_unfolded(step, self.space, known) for step in self.steps))

    def full(self, rules: Iterable[Rule] = ()) -> Derivation:
        """The derivation in single steps, which replay like the longer ones."""
        steps = self.unfolded(rules).steps
        return replace(self, steps=tuple(single for step in steps for single in step.steps or (step,)))

    def to_json(self, names: tuple[str, ...] = (), *, full: bool = False) -> list[dict[str, Any]]:
        """`[{rule, before, after, why, assumed, upward}]`, with `full` each with its single `steps`."""
        chosen = self.unfolded() if full else self
        return [step.to_json(names or self.space.points) for step in chosen.steps]


def _unfolded(step: Step, space: Space, rules: tuple[Rule, ...]) -> Step:
    if step.steps:
        return step
    try:
        single = unfold(step, space, rules)
    except LimitReached as limited:
        return replace(step, why=f"{step.why} (Not shown in single steps: {limited.message}.)")
    return step if single == (step,) else replace(step, steps=single)
