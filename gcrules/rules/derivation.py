r"""Derivations: chains of equal expressions, each link with the rule that made it, replayable on the exact oracle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import Expr, sub
from gcrules.algebra.text import text

__all__ = ["Derivation", "Step"]


@dataclass(frozen=True)
class Step:
    """before = after by the named rule. `assumed` lists expressions that must not vanish for the step to hold."""

    rule: str
    before: Expr
    after: Expr
    why: str
    assumed: tuple[Expr, ...] = ()

    def check(self, *, ideal: tuple[str, ...] = (), samples: int = 2) -> bool:
        """Whether both sides agree at exact random points (wrong with probability below 10⁻²⁰ when True)."""
        return vanishes(sub(self.before, self.after), ideal=ideal, samples=samples)

    def to_json(self, names: tuple[str, ...] = ()) -> dict[str, Any]:
        """`{rule, before, after, why, assumed}` with expressions as text of the language."""
        return {
            "rule": self.rule,
            "before": text(self.before, names=names),
            "after": text(self.after, names=names),
            "why": self.why,
            "assumed": [text(e, names=names) for e in self.assumed],
        }


@dataclass(frozen=True)
class Derivation:
    """Steps in sequence; each begins where the one before ended."""

    steps: tuple[Step, ...] = ()
    ideal: tuple[str, ...] = ()

    def __iter__(self) -> Iterator[Step]:
        return iter(self.steps)

    def __len__(self) -> int:
        return len(self.steps)

    def then(self, rule: str, after: Expr, why: str) -> Derivation:
        """The derivation with one more step from where this one ends."""
        return Derivation((*self.steps, Step(rule, self.steps[-1].after, after, why)), self.ideal)

    def check(self) -> bool:
        """Replay on the exact oracle: every step holds, and each begins where the one before ended."""
        joined = all(a.after == b.before for a, b in zip(self.steps, self.steps[1:], strict=False))
        return joined and all(step.check(ideal=self.ideal) for step in self.steps)
