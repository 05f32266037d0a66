"""Transversal conditions, as text and as LaTeX."""

from __future__ import annotations

from textwrap import wrap

from gcrules.algebra.language.text import text as expression_text
from gcrules.conditions.transversals import Transversals
from gcrules.views.detail import naming_options
from gcrules.views.formulas.latex_text import latex_words
from gcrules.views.results import condition
from gcrules.views.text_tables import line_width

__all__ = ["as_latex", "as_text"]


def as_text(t: Transversals, *, unicode: bool = False) -> str:
    """For each reading the identity, the sentence, p and q, and the certificate."""
    names = t.structure.names
    lines = []
    for r in t.readings:
        identity, *sentence = condition.as_text(r.condition, unicode=unicode, names=names).splitlines()
        lines += [identity, *(line for part in sentence for line in wrap(part, line_width()))]
        for name, line in zip("pq", r.lines, strict=True):
            shown = expression_text(line.expression, unicode=unicode, names=names)
            lines.append(f"  {name:<12} {shown}, {line.words}")
        lines.append(f"  certificate  {r.condition.certificate.method}: {r.condition.certificate.detail}")
        lines += [""] * (len(t.readings) > 1)
    if t.more:
        others = f"{t.more} other reading{'s' * (t.more != 1)}"
        lines.append(f"  also         {others}{naming_options(' (shown with --full)')}")
    if not t.readings:
        lines.append(f"none: {t.reason}" if t.definite else f"none found: {t.reason}")
    for e, meaning in t.structure.assumed:
        lines.append(f"  assumed not to vanish: {e} ({meaning})" if meaning else f"  assumed not to vanish: {e}")
    return "\n".join(lines).rstrip()


def as_latex(t: Transversals) -> str:
    """The identities without dollar signs, one on each line where there are several."""
    identities = [condition.as_latex(r.condition) for r in t.readings]
    if len(identities) < 2:
        return identities[0] if identities else rf"\text{{none: {latex_words(t.reason)}}}"
    rows = " \\\\\n".join(i.replace(" = ", " &= ", 1) for i in identities)
    return f"\\begin{{aligned}}\n{rows}\n\\end{{aligned}}"
