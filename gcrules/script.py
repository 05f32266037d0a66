r"""Running a script: every claim is proved, refuted or left undecided, every `show` is expanded.

>>> from gcrules.algebra.statements import parse_script
>>> print(run_script(parse_script("claim ab /\\ cd == [abcd]   show ab /\\ cde")).text())
line 1: proved: ab /\ cd == [abcd]
line 1: ab /\ cde = [acde] * b - [bcde] * a
1 claim: 1 proved
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.prove import Proof, prove
from gcrules.algebra.statements import Claim, Script, Show
from gcrules.algebra.text import text
from gcrules.errors import LimitReached

__all__ = ["ClaimResult", "ScriptResult", "ShowResult", "results", "run_script"]

_LABEL = 100  # characters of a label that the text shows


@dataclass(frozen=True)
class ClaimResult:
    """The answer to a claim in the given line of the script; without a `proof` a limit was reached (`reason`)."""

    line: int
    label: str
    verdict: str
    reason: str
    proof: Proof | None

    def to_json(self) -> dict[str, Any]:
        place = {"kind": "claim", "line": self.line, "label": self.label}
        if self.proof is not None:
            return place | self.proof.to_json()
        return place | {"verdict": self.verdict, "reason": self.reason, "counterexample": None, "assumed": []}

    def text(self, *, unicode: bool = False) -> str:
        lines = [f"line {self.line}: {self.verdict}: {_shortened(self.label)}"]
        if self.verdict != "proved":
            details = (
                self.proof.text(unicode=unicode).splitlines()[1:] if self.proof is not None else [f"  {self.reason}"]
            )
            lines += ["  " + line for line in details]
        return "\n".join(lines)

    def __str__(self) -> str:
        return self.text()


@dataclass(frozen=True)
class ShowResult:
    """The expansion that `show` asks for; without a `polynomial` a limit was reached (`reason`)."""

    line: int
    label: str
    polynomial: BracketPolynomial | ExtensorPolynomial | None
    names: tuple[str, ...]
    reason: str = ""

    @property
    def verdict(self) -> str:
        return "undecided" if self.polynomial is None else "shown"

    def to_json(self) -> dict[str, Any]:
        place = {"kind": "show", "line": self.line, "label": self.label}
        if self.polynomial is None:
            return place | {"polynomial": None, "reason": self.reason}
        return place | self.polynomial.to_json()

    def text(self, *, unicode: bool = False) -> str:
        if self.polynomial is None:
            return f"line {self.line}: undecided: {_shortened(self.label)}\n    {self.reason}"
        shown = text(self.polynomial.to_expr(), unicode=unicode, names=(*self.names, *self.polynomial.points))
        return f"line {self.line}: {_shortened(self.label)} = {shown}"

    def __str__(self) -> str:
        return self.text()


@dataclass(frozen=True)
class ScriptResult:
    """The results of a script, one for each claim and show, in the sequence of the file."""

    results: tuple[ClaimResult | ShowResult, ...]

    @property
    def verdict(self) -> str:
        """refuted if any claim is, else undecided if anything is, else proved."""
        found = {r.verdict for r in self.results}
        return next((v for v in ("refuted", "undecided") if v in found), "proved")

    @property
    def claims(self) -> tuple[ClaimResult, ...]:
        return tuple(r for r in self.results if isinstance(r, ClaimResult))

    def to_json(self) -> dict[str, Any]:
        """`{verdict, results [{kind: claim | show, line, label, …}]}`."""
        return {"verdict": self.verdict, "results": [r.to_json() for r in self.results]}

    def text(self, *, unicode: bool = False) -> str:
        """A line or more for each result, and how many claims came out which way."""
        counts = Counter(r.verdict for r in self.claims)
        total = f"{len(self.claims)} claim{'' if len(self.claims) == 1 else 's'}"
        found = ", ".join(f"{counts[v]} {v}" for v in ("proved", "refuted", "undecided") if counts[v])
        return "\n".join([*(r.text(unicode=unicode) for r in self.results), f"{total}: {found}" if found else total])

    def __str__(self) -> str:
        return self.text()


def run_script(script: Script, *, limit: int = MAX_TERMS) -> ScriptResult:
    """Answer every claim and show of a script. Limits that are reached stand in the results."""
    return ScriptResult(tuple(results(script, limit=limit)))


def results(script: Script, *, limit: int = MAX_TERMS) -> Iterator[ClaimResult | ShowResult]:
    """The results one after the other, as they are found."""
    for statement in script.statements:
        if isinstance(statement, Claim):
            yield _claim(statement, limit)
        elif isinstance(statement, Show):
            yield _show(statement, limit)


def _claim(claim: Claim, limit: int) -> ClaimResult:
    at = claim.context
    try:
        proof = prove(claim.left, claim.right, points=at.points, ideal=at.ideal, rank=at.rank, limit=limit)
    except LimitReached as limited:
        return ClaimResult(claim.line, claim.label, "undecided", limited.message, None)
    return ClaimResult(claim.line, claim.label, proof.verdict, proof.reason, proof)


def _show(show: Show, limit: int) -> ShowResult:
    at = show.context
    try:
        found = expand(show.expr, points=at.points, ideal=at.ideal, rank=at.rank, limit=limit)
    except LimitReached as limited:
        return ShowResult(show.line, show.label, None, at.points, limited.message)
    return ShowResult(show.line, show.label, found, at.points)


def _shortened(label: str) -> str:
    return label if len(label) <= _LABEL else f"{label[:_LABEL]}…"
