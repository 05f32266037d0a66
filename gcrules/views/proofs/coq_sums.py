"""Theorems that are sums of multiples of what is given, as Coq proves them.

Of the one case follows that a product of brackets with further points and of the difference of both sides vanishes for
all these points. Either the difference vanishes, or one bracket after the other does for all its points; but what
stands in it does not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from gcrules.algebra.expr import Bracket, Number, Product, Sum
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.views.proofs.coq_expressions import derived
from gcrules.views.proofs.coq_facts import Facts
from gcrules.views.proofs.coq_statement import CannotWrite, Statement

__all__ = ["OneCaseProof", "SumProof", "is_sum", "nested"]


def is_sum(t: Theorem) -> bool:
    """Whether the last factor in its one case is the difference of its sides, or that with further points."""
    if len(t.cases) != 1 or t.split is not None:
        return False
    last = t.cases[0].right
    while isinstance(last, Product):
        last = last.factors[-1]
    inside = last.args[0] if isinstance(last, Bracket) else last
    return inside == Sum((t.left, Product((Number(-1), t.right))))


class OneCaseProof:
    """The proof of one theorem by that of its case, which may name further points."""

    factor = 1
    kind = ""  # of theorem, for the reason why there is no proof

    def __init__(self, t: Theorem, proof_of: Callable[[Theorem], Any], further: Sequence[str] = ()) -> None:
        self.statement = Statement(t, further=further)
        self.facts = Facts(self.statement)
        self.part = proof_of(t.cases[0])
        if isinstance(self.part, str):
            raise CannotWrite(f"of its cases one has no script: {self.part}")
        whole = all(self.statement.stated.whole(e)[1] == 1 for e in self.statement.claim)
        if self.part.factor != 1 or self.part.statement.inverse or not whole:
            raise CannotWrite(f"{self.kind}, with fractions")

    @property
    def relations(self) -> Iterator[Any]:
        """All that it uses."""
        yield from self.facts.relations
        yield from self.part.relations

    def no_rule(self) -> CannotWrite:
        """That scripts have no proof of this kind."""
        return CannotWrite(f"{self.kind}, of a kind of which scripts have no rule")


class SumProof(OneCaseProof):
    """The proof of a sum of multiples."""

    kind = "it is a sum of multiples of what is given"

    def __init__(self, t: Theorem, proof_of: Callable[[Theorem], Any]) -> None:
        known = Statement(t).coq
        super().__init__(t, proof_of, [n for n in t.cases[0].order if n not in known])
        s, (self.left, product) = self.statement, self.part.statement.claim
        self.factors = s.tree.args(product, "product")
        left, right = s.claim
        self.difference = ["sum", left, ["product", ["number", -1], right]]
        texts = [s.stated.statement(e) for e in s.nonzero]
        own = [s.stated.statement(s.for_all(f)) for f in self.factors]
        ends = [p for f in self.factors for p in s.all_of(f)]
        brackets = all(isinstance(f, list) and f[0] == "bracket" for f in self.factors[:-1])
        used = [s.parts_given(term) for term in s.tree.args(self.left, "sum")]
        as_said = all(text in texts for text in own[:-1]) and own[-1] == s.stated.statement(self.difference)
        if not brackets or len({*ends}) < len(ends) or not as_said or not all(used):
            raise self.no_rule()
        self.alive = list(map(texts.index, own[:-1]))
        self.used = sorted({n for numbers in used for n in numbers})

    def text(self, name: str) -> str:
        """The theorem with its proof, after that of its case."""
        s, h, own = self.statement, self.statement.prefix, derived(name, "part_0")
        return "\n".join(
            [
                self.part.text(own),
                "",
                *s.opening(name, list(map(s.stated.side, s.claim))),
                *s.numbering(),
                f"  destruct ({s.space}_decided {s.stated.side(self.difference)} (number {s.space} 0)) as [{h}d|{h}d].",
                f"  {{ exact (equal_to {s.space} _ _ {h}d _ _ (fun e => e)). }}",
                f"  exfalso. apply {h}d.",
                *self._product(own),
                *(line for n in range(len(self.factors) - 1) for line in self._rest(n)),
                *self._alone(self.factors[-1], f"{h}zero_{len(self.factors) - 1}"),
                "Qed.",
            ]
        )

    def _product(self, own: str) -> Iterator[str]:
        """The lines that tell that the product vanishes for all further points."""
        s, h, whole = self.statement, self.statement.prefix, nested(self.factors)
        points = " ".join(s.coq[p] for p in self.part.statement.own)
        yield f"  assert ({h}zero_0 : {s.says(whole, '=')})."
        yield "  {"
        yield from (f"    intros {s.named(every)}." for every in [s.all_of(whole)] if every)
        yield f"    transitivity ({s.everywhere.statement(self.left)})."
        yield f"    {{ symmetry. apply ({own} {points}); assumption. }}"
        yield f"    {' '.join(f'rewrite {h}given_{n}.' for n in self.used)}"
        yield "    repeat (rewrite join_nothing_l || rewrite join_nothing_r || rewrite meet_nothing_l"
        yield "      || rewrite meet_nothing_r || rewrite bracket_nothing)."
        yield "    rewrite ?number_0, ?plus_zero. reflexivity."
        yield "  }"

    def _rest(self, n: int) -> Iterator[str]:
        """The lines that tell that the factors behind one vanish for all further points, since it does not."""
        s, h, f, rest = self.statement, self.statement.prefix, self.factors[n], nested(self.factors[n + 1 :])
        own, after = s.all_of(f), s.all_of(rest)
        yield f"  assert ({h}zero_{n + 1} : {s.says(rest, '=')})."
        yield "  {"
        yield from (f"    intros {s.named(every)}." for every in [after] if every)
        text = s.everywhere.side(rest)
        yield f"    destruct ({s.space}_decided {text} (number {s.space} 0)) as [{h}z|{h}z]; [exact {h}z|]."
        yield f"    exfalso. apply {h}nonzero_{self.alive[n]}."
        yield f"    assert ({h}all : {s.says(f, '=')})."
        zero = f"({h}zero_{n} {s.named([*own, *after])})"
        yield f"    {{ {f'intros {s.named(own)}. ' if own else ''}exact (cancelled _ _ _ {zero} {h}z). }}"
        yield from (f"    {line}" for line in self._alone(f, f"{h}all"))
        yield "  }"

    def _alone(self, factor: Any, fact: str) -> Iterator[str]:
        """The lines that tell that what stands in a factor vanishes, by the fact that this does for all points."""
        alone = self.statement.for_all(factor)
        yield from [f"exact {fact}."] if alone == factor else self.facts.for_all(alone, factor, fact)


def nested(factors: Sequence[Any]) -> Any:
    """A product as one factor times the product of the others."""
    first, *others = factors
    return ["product", first, nested(others)] if others else first
