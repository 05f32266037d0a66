"""Theorems in cases, as Coq proves them: of a product that vanishes a factor does, and each case is a theorem."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

from gcrules.algebra.proofs.theorem import Theorem
from gcrules.views.proofs.coq_assumed import AssumedProof, assumed_proof
from gcrules.views.proofs.coq_expressions import derived
from gcrules.views.proofs.coq_facts import Facts
from gcrules.views.proofs.coq_screws import ScrewProof, adds_points
from gcrules.views.proofs.coq_statement import CannotWrite, Statement

__all__ = ["CasesProof", "cases_proof"]


@lru_cache(maxsize=256)
def cases_proof(t: Theorem) -> CasesProof | AssumedProof | ScrewProof | str:
    """The proof of a theorem under assumptions, or of the first of its cases, or why it cannot be written."""
    if not t.cases:
        return assumed_proof(t)
    try:
        return ScrewProof(t, cases_proof) if adds_points(t) else CasesProof(t)
    except CannotWrite as why:
        return str(why)


class CasesProof:
    """The proof of one theorem in cases."""

    def __init__(self, t: Theorem) -> None:
        self.statement = s = Statement(t)
        self.facts = Facts(s)
        self.parts: list[CasesProof | AssumedProof | ScrewProof] = []
        for case in t.cases:
            part = cases_proof(case)
            if isinstance(part, str):
                raise CannotWrite(f"of its cases one has no script: {part}")
            if part.factor != 1:
                raise CannotWrite("it is proved in cases that have fractions")
            self.parts.append(part)
        left, right = self.parts[0].statement.claim
        if left not in s.given:
            raise CannotWrite("it is proved in cases that come of several equations")
        self.given = s.given.index(left)
        self.product = right
        factors = s.tree.args(right, "product")
        if any(e[0] == "number" and abs(Fraction(e[1])) != 1 for e in factors):
            raise CannotWrite("it is proved in cases of a multiple of what is given")
        brackets = [e for e in factors if e[0] == "bracket"]
        others = [e for e in factors if e[0] not in ("bracket", "number")]
        if len(others) > 1:
            raise CannotWrite("it is proved in cases of several factors that are sums")
        self.factors = [*brackets, *others]

    factor = 1

    @property
    def relations(self) -> Iterator[Any]:
        """All that it uses."""
        yield from self.facts.relations
        for part in self.parts:
            yield from part.relations

    @property
    def renamed(self) -> dict[str, str]:
        """The points that have other names in Coq."""
        return {p: self.statement.coq[p] for p in self.statement.own if self.statement.coq[p] != p}

    def text(self, name: str) -> str:
        """The theorem with its proof, after those of its cases."""
        s, names = self.statement, [derived(name, f"part_{n}") for n in range(len(self.parts))]
        h, says = s.prefix, s.says
        equal, zero = f"{h}product", says(joined_product(self.factors), "=")
        return "\n".join(
            [
                *(part.text(own) for part, own in zip(self.parts, names, strict=True)),
                "",
                *s.opening(name, list(map(s.stated.side, s.claim))),
                *s.numbering(),
                f"  assert ({equal} : {says(self.product, '=')}).",
                f"  {{ rewrite <- {h}given_{self.given}. symmetry. apply {self._applied(names[0], self.parts[0])}. }}",
                f"  assert ({h}zero_0 : {zero}).",
                "  {",
                *(f"    {line}" for line in self.facts.follows(joined_product(self.factors), self.product, [equal])),
                "  }",
                *self._factors(names),
                "Qed.",
            ]
        )

    def _applied(self, name: str, part: CasesProof | AssumedProof | ScrewProof) -> str:
        """A theorem at the points of this one, its assumptions among these."""
        own = part.statement
        points = " ".join(self.statement.coq[p] for p in own.own)
        return f"({name} {points}); assumption" if points else f"{name}; assumption"

    def _factors(self, names: Sequence[str]) -> Iterator[str]:
        """Of each factor, that it vanishes and what follows; or that the rest does."""
        s, h = self.statement, self.statement.prefix
        texts = [s.stated.statement(e) for e in s.nonzero]
        listed = (e for e in s.tree.args(self.product, "product") if e[0] != "number")
        open_ones = [f for f in dict.fromkeys(map(s.stated.statement, listed)) if f not in texts]
        known = dict(zip(open_ones, zip(self.parts[1:], names[1:], strict=True), strict=True))
        for n, f in enumerate(self.factors):
            own, rest = s.stated.statement(f), self.factors[n + 1 :]
            if rest:
                after = s.stated.statement(joined_product(rest))
                ways = f"[{h}zero_{n + 1} | {h}rest_{n}]"
                yield f"  destruct ({s.space}_decided ({after}) (number {s.space} 0)) as {ways}."
                yield "  2: {"
                yield f"    pose proof (cancelled _ _ _ {h}zero_{n} {h}rest_{n}) as {h}factor_{n}."
                yield f"    {self._closed(own, texts, known, f'{h}factor_{n}')}"
                yield "  }"
            else:
                yield f"  {self._closed(own, texts, known, f'{h}zero_{n}')}"

    def _closed(
        self,
        factor: str,
        nonzero: Sequence[str],
        known: dict[str, tuple[CasesProof | AssumedProof | ScrewProof, str]],
        fact: str,
    ) -> str:
        """The end of the proof where a factor vanishes."""
        s = self.statement
        if factor in nonzero:
            return f"exfalso. exact ({s.prefix}nonzero_{nonzero.index(factor)} {fact})."
        part, name = known[factor]
        if part.statement.claim == s.claim:
            return f"apply {self._applied(name, part)}."
        away = nonzero.index(s.stated.statement(part.statement.claim[0]))
        return f"exfalso. apply {s.prefix}nonzero_{away}. apply {self._applied(name, part)}."


def joined_product(factors: Sequence[Any]) -> Any:
    """A product as one factor times the product of the others."""
    first, *others = factors
    return ["product", first, joined_product(others)] if others else first
