r"""Running a script: every claim and rule is proved, refuted or left undecided, every `show` is expanded.

>>> from gcrules.algebra.language.statements import parse_script
>>> print(run_script(parse_script("claim ab /\\ cd == [abcd]   show ab /\\ cde")).text())
line 1: proved: ab /\ cd == [abcd]
line 1: ab /\ cde = [acde] * b - [bcde] * a
1 claim: 1 proved
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.decide import decide
from gcrules.algebra.expand import MAX_TERMS, expand
from gcrules.algebra.language.rule_text import RuleText
from gcrules.algebra.language.statements import Claim, Rewrite, Script, Show
from gcrules.algebra.prove import Proof
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.shown import Shown
from gcrules.rules.rewriting import Rewriting, rewrite
from gcrules.rules.rule import RewriteRule
from gcrules.rules.rule_file import RuleCheck, check_rule

__all__ = [
    "ClaimResult",
    "Result",
    "RewriteResult",
    "RuleResult",
    "ScriptResult",
    "ScriptResults",
    "ShowResult",
    "results",
    "run_script",
]


@dataclass(frozen=True)
class ClaimResult(Shown):
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


@dataclass(frozen=True)
class ShowResult(Shown):
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


@dataclass(frozen=True)
class RuleResult(Shown):
    """What became of a rule of the script: proved in all its ranks, refuted (or looping, or a failing case)."""

    line: int
    check: RuleCheck

    @property
    def label(self) -> str:
        return f"rule {self.check.rule.id}"

    @property
    def verdict(self) -> str:
        return "refuted" if self.check.verdict == "refused" else self.check.verdict

    def to_json(self) -> dict[str, Any]:
        return {"kind": "rule", "line": self.line, "label": self.label, **self.check.to_json()}


@dataclass(frozen=True)
class RewriteResult(Shown):
    """What `rewrite` gives by the rules that stand before it; without a `rewriting` a limit was reached (`reason`)."""

    line: int
    label: str
    rewriting: Rewriting | None
    reason: str = ""

    @property
    def verdict(self) -> str:
        return "undecided" if self.rewriting is None else "shown"

    def to_json(self) -> dict[str, Any]:
        place = {"kind": "rewrite", "line": self.line, "label": self.label}
        if self.rewriting is None:
            return place | {"after": None, "reason": self.reason}
        return place | self.rewriting.to_json()


Result = ClaimResult | ShowResult | RuleResult | RewriteResult


@dataclass(frozen=True)
class ScriptResult(Shown):
    """The results of a script, one for each claim, show, rule and rewrite, in the sequence of the file."""

    results: tuple[Result, ...]

    @property
    def verdict(self) -> str:
        """refuted if any claim is, else undecided if anything is, else proved."""
        found = {r.verdict for r in self.results}
        return next((v for v in ("refuted", "undecided") if v in found), "proved")

    @property
    def claims(self) -> tuple[ClaimResult, ...]:
        return tuple(r for r in self.results if isinstance(r, ClaimResult))

    @property
    def rules(self) -> tuple[RuleResult, ...]:
        return tuple(r for r in self.results if isinstance(r, RuleResult))

    def to_json(self) -> dict[str, Any]:
        """`{verdict, results [{kind: claim | show | rule | rewrite, line, label, …}]}`."""
        return {"verdict": self.verdict, "results": [r.to_json() for r in self.results]}


@dataclass(frozen=True)
class ScriptResults:
    """The results of several scripts, by the names of their files."""

    files: tuple[str, ...]
    answers: tuple[ScriptResult, ...]

    @property
    def whole(self) -> ScriptResult:
        """All results as those of one script."""
        return ScriptResult(tuple(r for a in self.answers for r in a.results))

    def to_json(self) -> dict[str, Any]:
        """`{verdict, files [{file, verdict, results}]}`."""
        files = [{"file": name, **a.to_json()} for name, a in zip(self.files, self.answers, strict=True)]
        return {"verdict": self.whole.verdict, "files": files}


def run_script(script: Script, *, limit: int = MAX_TERMS) -> ScriptResult:
    """Answer every claim, show, rule and rewrite of a script. Limits that are reached stand in the results."""
    return ScriptResult(tuple(results(script, limit=limit)))


def results(script: Script, *, limit: int = MAX_TERMS, rules: Iterable[RewriteRule] = ()) -> Iterator[Result]:
    """The results one after the other, as they are found; `rules` are those that came before the script."""
    rules = list(rules)
    for statement in script.statements:
        if isinstance(statement, Claim):
            yield _claim(statement, limit)
        elif isinstance(statement, Show):
            yield _show(statement, limit)
        elif isinstance(statement, RuleText):
            checked = check_rule(statement, script, limit=limit)
            rules += [checked.rule] if checked.ok else []
            yield RuleResult(statement.line, checked)
        else:
            yield _rewrite(statement, rules)


def _claim(claim: Claim, limit: int) -> ClaimResult:
    at = claim.context
    try:
        proof = decide(claim.claimed, at, limit=limit)
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


def _rewrite(asked: Rewrite, rules: Sequence[RewriteRule]) -> RewriteResult:
    try:
        found = rewrite(asked.expr, rules, asked.context)
    except LimitReached as limited:
        return RewriteResult(asked.line, asked.label, None, limited.message)
    return RewriteResult(asked.line, asked.label, found)
