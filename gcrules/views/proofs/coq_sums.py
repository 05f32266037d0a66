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

__all__ = ["SumProof", "is_sum", "nested"]


def is_sum(t: Theorem) -> bool:
    """Whether the last factor in its one case is the difference of its sides, or that with further points."""
    if len(t.cases) != 1 or t.split is not None:
        return False
    last = t.cases[0].right
    while isinstance(last, Product):
        last = last.factors[-1]
    inside = last.args[0] if isinstance(last, Bracket) else last
    return inside == Sum((t.left, Product((Number(-1), t.right))))


class SumProof:
    """The proof of one theorem by that of its case."""

    factor = 1

    def __init__(self, t: Theorem, proof_of: Callable[[Theorem], Any]) -> None:
        known = Statement(t).coq
        (lemma, *others) = t.cases
        self.statement = s = Statement(t, further=[n for n in lemma.order if n not in known])
        self.facts = Facts(s)
        self.part = proof_of(lemma)
        if isinstance(self.part, str):
            raise CannotWrite(f"of its cases one has no script: {self.part}")
        if self.part.factor != 1 or self.part.statement.inverse or any(s.stated.whole(e)[1] != 1 for e in s.claim):
            raise CannotWrite("it is a sum of multiples of what is given, with fractions")
        self.left, product = self.part.statement.claim
        self.factors = s.tree.args(product, "product")
        left, right = s.claim
        self.difference = ["sum", left, ["product", ["number", -1], right]]
        texts = [s.stated.statement(e) for e in s.nonzero]
        own = [s.stated.statement(s.for_all(f)) for f in self.factors]
        ends = [p for f in self.factors for p in s.all_of(f)]
        whole = all(isinstance(f, list) and f[0] == "bracket" for f in self.factors[:-1])
        if others or not whole or len({*ends}) < len(ends) or own[-1] != s.stated.statement(self.difference):
            raise CannotWrite("it is a sum of multiples of what is given, of a kind of which scripts have no rule")
        self.alive = [texts.index(text) for text in own[:-1] if text in texts]
        self.used = sorted({n for term in s.tree.args(self.left, "sum") for n in self._given(term)})
        if len(self.alive) < len(self.factors) - 1 or not self.used:
            raise CannotWrite("it is a sum of multiples of what is given, of a kind of which scripts have no rule")

    @property
    def relations(self) -> Iterator[Any]:
        """All that it uses."""
        yield from self.facts.relations
        yield from self.part.relations

    @property
    def renamed(self) -> dict[str, str]:
        """The points that have other names in Coq."""
        return {p: self.statement.coq[p] for p in self.statement.own if self.statement.coq[p] != p}

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

    def _given(self, e: Any) -> list[int]:
        """The numbers of what is given of which a part of an expression is."""
        s = self.statement
        if e in s.given:
            return [s.given.index(e)]
        inside = e[1:] if isinstance(e, list) and e[0] in ("join", "meet", "bracket", "product") else []
        return [n for part in inside for n in self._given(part)][:1]


def nested(factors: Sequence[Any]) -> Any:
    """A product as one factor times the product of the others."""
    first, *others = factors
    return ["product", first, nested(others)] if others else first
