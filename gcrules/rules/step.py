r"""One link of a derivation: two equal expressions and the rule that made the one from the other."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from gcrules.algebra.assumptions.assumed import resolve
from gcrules.algebra.claims import digest
from gcrules.algebra.evaluate import Evaluator, random_rational_points, vanishes
from gcrules.algebra.expr import Expr, points_of, sub
from gcrules.algebra.language.text import text
from gcrules.algebra.space import Space
from gcrules.core.dataclass import dataclass
from gcrules.core.seeds import DRAWN, seed

__all__ = ["Step", "joined"]


@dataclass(frozen=True)
class Step:
    """before = after by the named rule, wherever the points are.

    `assumed` lists expressions that must not vanish for the conclusion: that the robot is singular exactly where the
    last expression of the derivation is zero. An `upward` step is read backwards: the rule makes `before` from `after`.
    `steps` are the single steps that a longer one is made of, where they are known.
    """

    rule: str
    before: Expr
    after: Expr
    why: str
    assumed: tuple[Expr, ...] = ()
    upward: bool = False
    steps: tuple[Step, ...] = ()

    def check(self, space: Space | None = None, *, ideal: tuple[str, ...] = (), samples: int = 2) -> bool:
        """Whether both sides agree at exact random points (when True, wrong with the probability
        `claims.error_below`), and the single steps, if there are any, lead from the one to the other and hold.
        """
        space = space or Space(ideal=ideal)
        difference = sub(self.before, self.after, rank=space.rank)
        if not _zero(difference, space, samples) or not _exactly_zero(difference, space):
            return False
        if not self.steps:
            return True
        whole = self.steps[0].before == self.before and self.steps[-1].after == self.after
        return whole and joined(self.steps) and all(s.check(space, samples=samples) for s in self.steps)

    def to_json(self, names: tuple[str, ...] = ()) -> dict[str, Any]:
        """`{rule, before, after, why, assumed, upward}` with expressions as text of the language, and `steps` of the
        same form where the single steps are known.
        """
        found = {
            "rule": self.rule,
            "before": text(self.before, names=names),
            "after": text(self.after, names=names),
            "why": self.why,
            "assumed": [text(e, names=names) for e in self.assumed],
            "upward": self.upward,
        }
        return found | ({"steps": [s.to_json(names) for s in self.steps]} if self.steps else {})


def joined(steps: tuple[Step, ...]) -> bool:
    """Whether each step begins where the one before ended."""
    return all(a.after == b.before for a, b in pairwise(steps))


def _zero(e: Expr, space: Space, samples: int) -> bool:
    """Whether an expression vanishes at exact random points of a space, those that fulfil what is given there."""
    if not space.given:
        return vanishes(e, rank=space.rank, ideal=space.ideal, samples=samples)
    return resolve(space, points_of(e)).vanishes(e, samples=samples)


def _exactly_zero(e: Expr, space: Space) -> bool:
    """The same at one position with whole coordinates, where a multiple of the prime shows; positions under
    assumptions are left to the prime.
    """
    if space.given:
        return True
    at = seed("step", digest(e))
    points = random_rational_points(points_of(e), rank=space.rank, ideal=space.ideal, seed=at, size=DRAWN)
    return not any(Evaluator(points, space.rank).value(e))
