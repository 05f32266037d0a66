"""Theorems in cases, as Coq proves them: of a product that vanishes a factor does, or an expression vanishes or it does
not, and each case is a theorem.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

from gcrules.algebra.proofs.theorem import Theorem
from gcrules.views.proofs.coq_assumed import AssumedProof, assumed_proof
from gcrules.views.proofs.coq_expressions import derived
from gcrules.views.proofs.coq_facts import Facts
from gcrules.views.proofs.coq_screws import ScrewProof, is_about_screw
from gcrules.views.proofs.coq_statement import CannotWrite, Statement
from gcrules.views.proofs.coq_sums import SumProof, is_sum, nested

__all__ = ["Proof", "cases_proof"]


@lru_cache(maxsize=256)
def cases_proof(t: Theorem) -> Proof | str:
    """The proof of a theorem under assumptions, or of the first of its cases, or why it cannot be written."""
    if not t.cases and not t.at_once:
        return assumed_proof(t)
    try:
        if t.at_once:
            return PartProof(t)
        if is_about_screw(t):
            return ScrewProof(t, cases_proof)
        if is_sum(t):
            return SumProof(t, cases_proof)
        return FactorsProof(t) if t.split is None else SplitProof(t)
    except CannotWrite as why:
        return str(why)


class PartProof:
    """The proof that something vanishes since a part of it does."""

    factor = 1
    relations: tuple[Any, ...] = ()

    def __init__(self, t: Theorem) -> None:
        self.statement = Statement(t)
        if self.statement.stated.whole(self.statement.claim[0])[1] != 1:
            raise CannotWrite("it is proved in cases that have fractions")

    def text(self, name: str) -> str:
        """The theorem with its proof."""
        s = self.statement
        sides = list(map(s.stated.statement, s.claim))
        return "\n".join(["", *s.opening(name, sides), *vanishing(s, s.claim[0]), "Qed."])


class CasesProof:
    """The proof of one theorem in cases."""

    factor = 1

    def __init__(self, t: Theorem) -> None:
        self.statement = Statement(t)
        self.facts = Facts(self.statement)
        self.parts: list[Proof] = []
        for case in t.cases:
            part = cases_proof(case)
            if isinstance(part, str):
                raise CannotWrite(f"of its cases one has no script: {part}")
            if part.factor != 1 or part.statement.inverse:
                raise CannotWrite("it is proved in cases that have fractions")
            self.parts.append(part)

    @property
    def relations(self) -> Iterator[Any]:
        """All that it uses."""
        yield from self.facts.relations
        for part in self.parts:
            yield from part.relations

    def text(self, name: str) -> str:
        """The theorem with its proof, after those of its cases."""
        s, names = self.statement, [derived(name, f"part_{n}") for n in range(len(self.parts))]
        return "\n".join(
            [
                *(part.text(own) for part, own in zip(self.parts, names, strict=True)),
                "",
                *s.opening(name, list(map(s.stated.statement, s.claim))),
                *self._together(names),
                "Qed.",
            ]
        )

    def _together(self, names: Sequence[str]) -> Iterator[str]:
        """The lines that prove the theorem from those of its cases."""
        raise NotImplementedError

    def _applied(self, name: str, part: Proof) -> str:
        """A theorem at the points of this one, its assumptions among these."""
        own = part.statement
        points = " ".join(self.statement.coq[p] for p in own.own)
        return f"({name} {points}); assumed" if points else f"{name}; assumed"

    def _closed(self, name: str, part: Proof, more: Sequence[tuple[str, str]] = ()) -> str:
        """The end of the proof by a case; `more` does not vanish there by these facts."""
        s, case = self.statement, part.statement
        if case.claim == s.claim:
            return f"apply {self._applied(name, part)}."
        texts = [(s.stated.statement(e), f"{s.prefix}nonzero_{n}") for n, e in enumerate(s.nonzero)]
        away = dict([*texts, *more])[s.stated.statement(case.claim[0])]
        return f"exfalso. apply {away}. apply {self._applied(name, part)}."


class SplitProof(CasesProof):
    """The proof where an expression vanishes, and where it does not."""

    def __init__(self, t: Theorem) -> None:
        super().__init__(t)
        self.split = self.statement.tree.opened(self.statement.data["split"])
        if self.statement.stated.whole(self.split)[1] != 1:
            raise CannotWrite("it is proved in cases that have fractions")

    def _together(self, names: Sequence[str]) -> Iterator[str]:
        s, text = self.statement, self.statement.stated.statement(self.split)
        typed = f"({text} : extensor {s.space})" if isinstance(self.split, str) else f"({text})"
        yield f"  destruct ({s.space}_decided {typed} (number {s.space} 0)) as [{s.prefix}split|{s.prefix}split]."
        yield f"  - {self._closed(names[0], self.parts[0])}"
        yield f"  - {self._closed(names[1], self.parts[1], [(text, f'{s.prefix}split')])}"


class FactorsProof(CasesProof):
    """The proof by the factors of a product that vanishes."""

    def __init__(self, t: Theorem) -> None:
        super().__init__(t)
        s = self.statement
        self.left, self.product = self.parts[0].statement.claim
        if not s.parts_given(self.left):
            raise CannotWrite("it is proved in cases that come of several equations")
        factors = s.tree.args(self.product, "product")
        if any(e[0] == "number" and abs(Fraction(e[1])) != 1 for e in factors):
            raise CannotWrite("it is proved in cases of a multiple of what is given")
        brackets = [e for e in factors if e[0] == "bracket"]
        others = [e for e in factors if e[0] not in ("bracket", "number")]
        if len(others) > 1:
            raise CannotWrite("it is proved in cases of several factors that are sums")
        self.factors = [*brackets, *others]
        named = [p for f in self.factors for p in s.all_of(f)]
        if len({*named}) < len(named) or any(s.all_of(s.for_all(f)) for f in self.factors):
            raise CannotWrite("it is proved in cases of which factors are not those of joins with all points")

    def _together(self, names: Sequence[str]) -> Iterator[str]:
        s, h = self.statement, self.statement.prefix
        whole, case = nested(self.factors), self.parts[0].statement
        every = [p for p in s.any if p in {*s.all_of(["sum", self.left, self.product]), *case.own}]
        yield from s.numbering()
        yield f"  assert ({h}left : {s.says(self.left, '=')})."
        yield from (
            "  {",
            *(f"  {line}" for line in [*_introduced(s, self.left), *vanishing(s, self.left)]),
            "  }",
        )
        yield f"  assert ({h}zero_0 : {s.says(whole, '=')})."
        yield "  {"
        # Points that stand for all and that the product does not name may be any.
        given = [p for p in every if p not in s.all_of(whole)]
        yield from (f"  {line}" for line in _introduced(s, whole))
        yield from (f"    pose ({s.coq[p]} := {s.stated.points[0]})." for p in given)
        yield f"    clear {h}at {h}ideal."
        yield from (f"  {line}" for line in s.numbering(every))
        left = f"({h}left {s.named(s.all_of(self.left))})" if s.all_of(self.left) else f"{h}left"
        at = s.among([*s.points, *every])
        yield f"    assert ({h}product : {at.side(self.product)} = number {s.space} 0)."
        yield f"    {{ rewrite <- {left}. symmetry. apply {self._applied(names[0], self.parts[0])}. }}"
        yield from (f"    {line}" for line in self.facts.follows(whole, self.product, [f"{h}product"], at=at))
        yield "  }"
        yield from self._factors(names)

    def _factors(self, names: Sequence[str]) -> Iterator[str]:
        """Of each factor, that it vanishes and what follows; or that the rest does."""
        s, h = self.statement, self.statement.prefix
        texts = [s.stated.statement(e) for e in s.nonzero]
        listed = (self.statement.for_all(e) for e in s.tree.args(self.product, "product") if e[0] != "number")
        open_ones = [f for f in dict.fromkeys(map(s.stated.statement, listed)) if f not in texts]
        known = dict(zip(open_ones, zip(self.parts[1:], names[1:], strict=True), strict=True))
        for n, f in enumerate(self.factors):
            alone, rest = self.statement.for_all(f), self.factors[n + 1 :]
            end = self._where(s.stated.statement(alone), texts, known, f"{h}factor_{n}")
            if not rest:
                yield f"  assert ({h}factor_{n} : {s.says(alone, '=')})."
                yield from ("  {", *(f"    {line}" for line in self._alone(f, f"{h}zero_{n}")), "  }")
                yield f"  {end}"
            elif s.all_of(["sum", f, *rest]):
                ways = f"[{h}factor_{n}|{h}no_{n}]"
                yield f"  destruct ({s.space}_decided {s.stated.side(alone)} (number {s.space} 0)) as {ways}."
                yield f"  {{ {end} }}"
                yield from self._rest(n, f, nested(rest))
            else:
                after = s.stated.statement(nested(rest))
                ways = f"[{h}zero_{n + 1} | {h}rest_{n}]"
                yield f"  destruct ({s.space}_decided ({after}) (number {s.space} 0)) as {ways}."
                yield "  2: {"
                yield f"    pose proof (cancelled _ _ _ {h}zero_{n} {h}rest_{n}) as {h}factor_{n}."
                yield f"    {end}"
                yield "  }"

    def _alone(self, factor: Any, fact: str) -> Iterator[str]:
        """The proof that what is left of a factor without all points vanishes, by the fact that the factor does."""
        alone = self.statement.for_all(factor)
        yield from [f"exact {fact}."] if alone == factor else self.facts.for_all(alone, factor, fact)

    def _rest(self, n: int, f: Any, rest: Any) -> Iterator[str]:
        """The lines that tell that the rest of a product vanishes for all points since its first factor need not."""
        s, h, own, after = self.statement, self.statement.prefix, self.statement.all_of(f), self.statement.all_of(rest)
        zero = f"({h}zero_{n} {s.named([*own, *after])})"
        text = s.everywhere.statement(rest)
        yield f"  assert ({h}zero_{n + 1} : {s.says(rest, '=')})."
        yield "  {"
        yield from (f"  {line}" for line in _introduced(s, rest))
        yield f"    destruct ({s.space}_decided ({text}) (number {s.space} 0)) as [{h}z|{h}z]; [exact {h}z|]."
        yield f"    exfalso. apply {h}no_{n}."
        yield f"    assert ({h}all : {s.says(f, '=')})."
        yield f"    {{ {f'intros {s.named(own)}. ' if own else ''}exact (cancelled _ _ _ {zero} {h}z). }}"
        yield from (f"    {line}" for line in self._alone(f, f"{h}all"))
        yield "  }"

    def _where(
        self,
        factor: str,
        nonzero: Sequence[str],
        known: dict[str, tuple[Proof, str]],
        fact: str,
    ) -> str:
        """The end of the proof where a factor vanishes."""
        if factor in nonzero:
            return f"exfalso. exact ({self.statement.prefix}nonzero_{nonzero.index(factor)} {fact})."
        part, name = known[factor]
        return self._closed(name, part)


Proof = CasesProof | AssumedProof | PartProof | ScrewProof | SumProof


def vanishing(s: Statement, e: Any) -> Iterator[str]:
    """The proof that an expression vanishes since a part of it is given to."""
    (number,) = s.parts_given(e)
    yield f"  rewrite {s.prefix}given_{number}. vanishes."


def _introduced(s: Statement, e: Any) -> list[str]:
    """The line that names the points that stand for all, where some do."""
    every = s.all_of(e)
    return [f"  intros {s.named(every)}."] if every else []
