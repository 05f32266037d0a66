"""Results of scripts, as text and as LaTeX."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from gcrules.algebra.language.text import text as expression_text
from gcrules.algebra.letters import marked
from gcrules.algebra.whole_letters import in_letters
from gcrules.rules.script import ClaimResult, Result, RewriteResult, RuleResult, ScriptResult, ShowResult
from gcrules.views.formulas import latex as formulas
from gcrules.views.formulas.latex_text import latex_words
from gcrules.views.results import polynomial, proof, rewriting

__all__ = ["as_latex", "as_text", "claim", "formula", "rewritten", "rule", "shown", "totals"]

_LABEL = 100  # characters of a label that the text shows


def claim(r: ClaimResult, *, unicode: bool = False) -> str:
    """The verdict and the label; what refutes the claim, or what was assumed."""
    lines = [f"line {r.line}: {r.verdict}: {_shortened(r.label)}"]
    if r.proof is None:
        details = [f"  {r.reason}"] if r.verdict != "proved" else []
    elif r.verdict == "proved":
        details = [*proof.dual_lines(r.proof), *proof.conditions(r.proof)]
    else:
        details = proof.as_text(r.proof, unicode=unicode).splitlines()[1:]
    return "\n".join([*lines, *("  " + line for line in details)])


def shown(r: ShowResult, *, unicode: bool = False) -> str:
    """The expansion."""
    if r.polynomial is None:
        return f"line {r.line}: undecided: {_shortened(r.label)}\n    {r.reason}"
    e, names = in_letters(r.polynomial), [n for n in (*r.names, *r.polynomial.points) if not marked(n)]
    expansion = expression_text(e, unicode=unicode, names=names)
    expansion = "  # ".join([expansion, *filter(None, [polynomial.points_shown(expansion, r.polynomial.rank)])])
    return f"line {r.line}: {_shortened(r.label)} = {expansion}"


def rule(r: RuleResult, *, unicode: bool = False) -> str:
    """The verdict, and the reason where the rule is not accepted."""
    lines = [f"line {r.line}: {r.check.verdict}: {r.label}"]
    return "\n".join(lines if r.check.ok else [*lines, f"    {r.check.reason}"])


def rewritten(r: RewriteResult, *, unicode: bool = False) -> str:
    """The chain of equal expressions."""
    if r.rewriting is None:
        return f"line {r.line}: undecided: {_shortened(r.label)}\n    {r.reason}"
    first, *rest = rewriting.as_text(r.rewriting, unicode=unicode).splitlines()
    return "\n".join([f"line {r.line}: {first}", *(f"  {line}" for line in rest)])


def as_text(r: ScriptResult, *, unicode: bool = False) -> str:
    """A line or more for each result, and how many claims came out which way."""
    return "\n".join([*(one.text(unicode=unicode) for one in r.results), *totals(r)])


def totals(r: ScriptResult) -> tuple[str, ...]:
    """ "3 claims: 2 proved, 1 refuted", and the same for rules where there are any."""
    claims = [_count("claim", r.claims)] if r.claims or not r.rules else []
    return (*claims, *([_count("rule", r.rules)] if r.rules else []))


def _count(what: str, results: Sequence[Result]) -> str:
    counts = Counter(r.verdict for r in results)
    total = f"{len(results)} {what}{'' if len(results) == 1 else 's'}"
    verdicts = ", ".join(f"{counts[v]} {v}" for v in ("proved", "refuted", "undecided") if counts[v])
    return f"{total}: {verdicts}" if verdicts else total


def _shortened(label: str) -> str:
    return label if len(label) <= _LABEL else f"{label[:_LABEL]}…"


def as_latex(r: ScriptResult) -> str:
    """One row for each result in an `aligned` environment (package amsmath), without dollar signs."""
    rows = " \\\\\n".join(f"&{formula(one)}" for one in r.results)
    return f"\\begin{{aligned}}\n{rows}\n\\end{{aligned}}"


def formula(r: Result) -> str:
    """One result, without dollar signs."""
    match r:
        case ClaimResult(proof=p) if p is not None:
            return f"{proof.as_latex(p)} && \\text{{{r.verdict}}}"
        case ShowResult(polynomial=p) if p is not None:
            return f"\\text{{{latex_words(_shortened(r.label))}}} = {polynomial.as_latex(p)}"
        case RewriteResult(rewriting=w) if w is not None:
            return f"{formulas.latex(w.before)} = {formulas.latex(w.after)}"
    return f"\\text{{{latex_words(_shortened(r.label))}: {r.verdict}}}"
