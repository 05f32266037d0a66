"""Theorems about screws that are reciprocal to something, as Coq proves them.

Of a theorem with points that it adds, the two ends of a line Y, follows that E ∨ Y vanishes for all lines, or the
difference of the sides; and E is not zero.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from gcrules.algebra.expr import Bracket, Join
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.views.proofs.coq_expressions import derived
from gcrules.views.proofs.coq_sums import OneCaseProof

__all__ = ["ScrewProof", "is_about_screw"]

_CANCELLED = {1: "cancelled", 2: "cancelled_twice"}  # by how often a bracket is a factor


def is_about_screw(t: Theorem) -> bool:
    """Whether by its one case the bracket of a screw vanishes with the first of what does not vanish."""
    if len(t.cases) != 1:
        return False
    first, away = (some[0] if some else None for some in (t.given, t.nonzero))
    return isinstance(first, Bracket) and isinstance(away, Join) and first.args[:-1] == away.args


class ScrewProof(OneCaseProof):
    """The proof of one theorem about a screw."""

    kind = "it holds under assumptions on screws"

    def __init__(self, t: Theorem, proof_of: Callable[[Theorem], Any]) -> None:
        super().__init__(t, proof_of)
        s = self.statement
        self.extensor = s.nonzero[0]
        *brackets, self.difference = s.tree.args(self.part.statement.claim[1], "product")
        self.ends = [p for p in brackets[0][1:] if isinstance(p, str) and p not in s.coq]
        if (len(self.ends), t.rank) != (2, 4) or len(brackets) not in _CANCELLED:
            raise self.no_rule()
        self.degree = len(brackets)

    def text(self, name: str) -> str:
        """The theorem with its proof, after that of its case."""
        s, h, own = self.statement, self.statement.prefix, derived(name, "part_0")
        pure = self.facts.step(self.extensor, 2)
        new = {end: f"{h}end_{n}" for n, end in enumerate(self.ends)}
        y, z = new.values()
        points = " ".join({**s.coq, **new}[p] for p in self.part.statement.own)
        cancelled = _CANCELLED[self.degree]
        return "\n".join(
            [
                self.part.text(own),
                "",
                *s.opening(name, list(map(s.stated.side, s.claim))),
                *s.numbering(),
                *self.facts.lines,
                f"  destruct (space_decided {s.stated.statement(self.difference)} (number space 0)) as [{h}d|{h}d].",
                f"  {{ exact (equal_to space _ _ {h}d _ _ (fun e => e)). }}",
                f"  exfalso. apply {h}nonzero_0. rewrite number_0. apply (closing_zero space 2 2);",
                f"    [exact {pure} | reflexivity |].",
                f"  intros l {h}l. destruct l as [|{y} [|{z} [|]]]; try discriminate.",
                "  cbn [span fold_right]. rewrite join_one_r, ?join_assoc.",
                "  apply (scalar_zero space). rewrite <- number_0.",
                f"  refine ({cancelled} space _ _ _ {h}d).",
                f"  etransitivity; [symmetry; apply ({own} {points}); assumption|].",
                f"  rewrite {h}given_0. repeat (rewrite join_nothing_l || rewrite join_nothing_r).",
                "  rewrite ?number_0, ?plus_zero. reflexivity.",
                "Qed.",
            ]
        )
