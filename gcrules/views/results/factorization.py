"""Factorizations, as text and as LaTeX."""

from __future__ import annotations

from collections import Counter

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.result import MANY, FactoredPart, Factorization, short
from gcrules.algebra.language.text import text as expression_text
from gcrules.views.detail import naming_options
from gcrules.views.formulas import latex as formulas

__all__ = ["as_latex", "as_text"]


def as_text(f: Factorization, *, unicode: bool = False) -> str:
    """The factorization, or that there is none, with the family and the certificate."""

    def shown(e: Expr) -> str:
        return expression_text(e, unicode=unicode, names=f.points)

    times = " · " if unicode else " * "
    lines = [
        _headline(f, unicode),
        *(f"with a cofactor: {shown(r.cofactor)}{times}input = {shown(short(r.product()))}" for r in f.rational),
        f"  family       {f.family.name}",
        f"  searched     {f.family.searched()}",
        f"  certificate  {f.certificate.method}: {f.certificate.detail}",
    ]
    lines += [f"  factor       {_part(f, part, unicode)}" for part in f.parts]
    lines += [f"  also         {shown(short(form.product()))}" for form in f.alternatives]
    if f.more:
        others = f"{f.more} other expression{'s' * (f.more != 1)}"
        lines.append(f"  also         {others}{naming_options(' (shown with --full)')}")
    if (f.excluded or f.undecided) and not f.rational:
        lines.append("  cofactor     none found")
    lines += [f"  excluded     {e}" for e in f.excluded]
    lines += [f"  undecided    {e}" for e in f.undecided]
    return "\n".join(lines)


def _headline(f: Factorization, unicode: bool) -> str:
    if f.expression is not None:
        return expression_text(short(f.whole()), unicode=unicode, names=f.points)
    equal = Counter(f.factors).items()
    factors = (factor if n < MANY else ex.Power(factor, n) for factor, n in equal)
    left = " · ".join(expression_text(e, unicode=unicode, names=f.points) for e in factors)
    searched = f" of {f.family.searched()}" if f.family.extensors else ""
    brackets = f" for what is left after the brackets {left}" if left else ""
    return f"none exists in the family{brackets} ({f.certificate.method}{searched})"


def _part(f: Factorization, part: FactoredPart, unicode: bool) -> str:
    """A factor as its expression, or else as its polynomial, with what is known of it."""
    if part.expression is None:
        shown = f"{part.polynomial.text(unicode=unicode)}: no expression"
    else:
        shown = expression_text(part.expression, unicode=unicode, names=f.points)
    known = "" if part.irreducible else ", not known to be irreducible"
    return shown + known + (f", {part.times} times" if part.times > 1 else "")


def as_latex(f: Factorization) -> str:
    """Without dollar signs; what is left stands as a bracket polynomial. Where cofactors were found, the identities
    with them.
    """
    if not f.rational:
        return formulas.latex(f.whole())
    sides = ((ex.mul(form.cofactor, f.whole()), form.product()) for form in f.rational)
    return " \\\\\n".join(f"{formulas.latex(left)} = {formulas.latex(right)}" for left, right in sides)
