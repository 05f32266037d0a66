"""What a proposal leads to: confirmed, possible, or refused with the reason in words and as data; and hints."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.shown import Shown

__all__ = ["REASONS", "Hint", "NamedValue", "ProposalOutcome", "confirmed", "plain", "possible", "refused"]

REASONS = {
    # confirmed
    "form": "the form or the order of the legs was taken",
    "common": "the bracket occurs in every term",
    "together": "the points stay together in one bracket of every term, a bracket of their own",
    "left-over": "the left-over points are shared out among the planes' brackets",
    "swapped": "P(x,y) + P(y,x) = 0",
    # confirmed, or possible
    "trial": "the test fails as it stands, but a repeated point can hide a vanished term: possible, or found by trial",
    # confirmed
    "incidence": "the incidence follows from the entities and was proved",
    "proved": "cofactor times superbracket is a constant times the expression, proved by normal forms",
    # refused
    "no-factor": "some term does not hold the bracket, and it does not divide the superbracket",
    "hidden-factor": "some term does not hold the bracket, although it divides the superbracket",
    "apart": "in some term no bracket holds the points",
    "bracket-taken": "in some term other entities have taken the brackets that hold the points",
    "points-taken": "points have been taken by other entities",
    "no-plane": "the left-over points do not make a plane",
    "not-swapped": "P(x,y) + P(y,x) is not zero",
    "missing": "entities are missing for an incidence",
    "no-incidence": "the incidence of the entities is not the superbracket",
    "zero": "the expression or the cofactor is zero for all positions of the points",
    "degrees": "the degree in some point differs from the superbracket's",
    "different": "the degrees agree, but the expression is not a multiple of the superbracket",
    "no-way": "the automatic procedure finds no way to continue from here",
}
"""What `ProposalOutcome.reason` can be."""


@dataclass(frozen=True)
class NamedValue:
    """A value to show: `name` in words (a colon follows), `value` an expression."""

    name: str
    value: Expr


@dataclass(frozen=True)
class ProposalOutcome(Shown):
    """The answer to one proposal.

    `answer` is confirmed, refused, or possible: then what was proposed stands on the board as a trial, unproved.
    `reason` is a key of `REASONS`; `words` says it, one sentence for each line; `formulas` are polynomials to show;
    `data` holds the same for programs: points, terms (counted from 1), exact coordinates and values.
    """

    answer: str
    reason: str
    words: tuple[str, ...]
    formulas: tuple[NamedValue, ...] = ()
    data: Mapping[str, Any] = FrozenMap()

    @property
    def confirmed(self) -> bool:
        return self.answer == "confirmed"

    @property
    def possible(self) -> bool:
        return self.answer == "possible"

    @property
    def refused(self) -> bool:
        return self.answer == "refused"

    def to_json(self, names: tuple[str, ...] = ()) -> dict[str, Any]:
        """`{answer, reason, words, formulas [{name, value}], data}`; numbers that are not whole are text."""
        return {
            "answer": self.answer,
            "reason": self.reason,
            "words": list(self.words),
            "formulas": [{"name": f.name, "value": text(f.value, names=names)} for f in self.formulas],
            "data": plain(self.data),
        }


def confirmed(reason: str, *words: str, formulas: tuple[NamedValue, ...] = (), **data: Any) -> ProposalOutcome:
    """The answer yes."""
    return ProposalOutcome("confirmed", reason, words, formulas, FrozenMap(data))


def possible(reason: str, *words: str, formulas: tuple[NamedValue, ...] = (), **data: Any) -> ProposalOutcome:
    """The answer perhaps: kept as a trial."""
    return ProposalOutcome("possible", reason, words, formulas, FrozenMap(data))


def refused(reason: str, *words: str, formulas: tuple[NamedValue, ...] = (), **data: Any) -> ProposalOutcome:
    """The answer no."""
    return ProposalOutcome("refused", reason, words, formulas, FrozenMap(data))


@dataclass(frozen=True)
class Hint:
    """What the automatic procedure would do next: a command, or None where there is nothing to do; and why."""

    command: str | None
    why: str

    def __str__(self) -> str:
        return f"{self.command}: {self.why}" if self.command else self.why

    def to_json(self) -> dict[str, Any]:
        return {"command": self.command, "why": self.why}


def plain(value: Any) -> Any:
    """A value of `data` as JSON."""
    if isinstance(value, Mapping):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, (tuple, list)):
        return [plain(v) for v in value]
    if isinstance(value, Fraction):
        return int(value) if value.denominator == 1 else str(value)
    return str(value) if isinstance(value, Expr) else value
