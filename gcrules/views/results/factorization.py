"""Factorizations, as text and as LaTeX."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.result import MANY, FactoredPart, Factorization, short
from gcrules.algebra.language.text import text as expression_text
from gcrules.algebra.letters import letter_of
from gcrules.core.english import agreeing, listed
from gcrules.views.detail import is_everything, naming_options
from gcrules.views.formulas import latex as formulas

__all__ = ["as_latex", "as_text"]

_SHOWN = 40
"""Factors of more terms are not printed with the answer."""


def as_text(f: Factorization, *, unicode: bool = False) -> str:
    """The factorization, or that there is none, with the family and the certificate."""

    def shown(e: Expr) -> str:
        return expression_text(e, unicode=unicode, names=f.points)

    times = " · " if unicode else " * "
    lines = [
        _headline(f, unicode),
        *(f"with a cofactor: {shown(r.cofactor)}{times}input = {shown(short(r.product()))}" for r in f.rational),
        f"  family       {f.family.name}",
        *([] if f.exists is None else [f"  searched     {f.family.searched()}"]),
        f"  certificate  {f.certificate.method}: {_limit(f) if f.exists is None else f.certificate.detail}",
        *(_known(f, unicode) if f.exists is None else []),
    ]
    lines += [f"  factor       {_part(f, part, unicode)}" for part in f.parts]
    lines += [f"  symmetry     {_symmetry(*some)}" for some in f.exchangeable]
    lines += [f"  also         {shown(short(form.product()))}" for form in f.alternatives]
    if f.more:
        others = f"{f.more} other expression{'s' * (f.more != 1)}"
        lines.append(f"  also         {others}{naming_options(' (shown with --full)')}")
    if (f.excluded or f.undecided) and not f.rational:
        lines.append("  cofactor     none found")
    lines += [f"  excluded     {e}" for e in f.excluded]
    lines += [f"  undecided    {e}" for e in f.undecided]
    return "\n".join(lines)


def _limit(f: Factorization) -> str:
    """The limit that ended the search, and how to raise it."""
    hint = f.certificate.data["hint"]
    return f.certificate.detail + (naming_options(f" ({hint})") if hint else "")


def _known(f: Factorization, unicode: bool) -> Iterator[str]:
    """Of an answer that is undecided: the brackets that divide."""
    names = [expression_text(e, unicode=unicode, names=f.points) for e in dict.fromkeys(f.factors)]
    others = "whether others divide is not known" if f.more_brackets else "no others divide"
    none = "whether one divides is not known" if f.more_brackets else "none divides it"
    yield "  brackets     " + (f"{agreeing(names, 'divides', 'divide')}; {others}" if names else none)


def _symmetry(points: tuple[str, ...], sign: int) -> str:
    effect = "leaves it as it is" if sign > 0 else "changes its sign"
    return f"the exchange of {'' if len(points) == 2 else 'any two of '}{listed(points)} {effect}"


def _headline(f: Factorization, unicode: bool) -> str:
    if f.expression is not None:
        return expression_text(short(f.whole()), unicode=unicode, names=f.points)
    if f.exists is None:
        several = sum(part.times for part in f.parts) > 1
        return f"not decided whether {'a product of expressions' if several else 'one expression'} equals it"
    equal = Counter(f.factors).items()
    factors = (factor if n < MANY else ex.Power(factor, n) for factor, n in equal)
    left = " · ".join(expression_text(e, unicode=unicode, names=f.points) for e in factors)
    searched = f" of {f.family.searched()}" if f.family.extensors else ""
    brackets = f" for what is left after the brackets {left}" if left else ""
    return f"none exists in the family{brackets} ({f.certificate.method}{searched})"


def _part(f: Factorization, part: FactoredPart, unicode: bool) -> str:
    """A factor as its expression, or else as its polynomial, with what is known of it."""
    if part.expression is None:
        shown = f"{_polynomial(part.polynomial, unicode)}: {'not decided' if part.undecided else 'no expression'}"
    else:
        shown = expression_text(part.expression, unicode=unicode, names=f.points)
    sure = ", irreducible" if f.exists is None else ""
    known = sure if part.irreducible else ", not known to be irreducible"
    return shown + known + (f", {part.times} times" if part.times > 1 else "")


def _polynomial(p: BracketPolynomial, unicode: bool) -> str:
    """All of it where it is short, else how long it is."""
    if len(p) <= _SHOWN or is_everything():
        return p.text(unicode=unicode)
    degrees = ", ".join(dict.fromkeys(f"{_of_letter(n)} {d}" for n, d in (p.degrees() or {}).items()))
    return f"a polynomial of {len(p):,} terms{naming_options(' (shown with --full)')} with the degrees {degrees}"


def _of_letter(point: str) -> str:
    of = letter_of(point)
    return point if of is None else of[0]


def as_latex(f: Factorization) -> str:
    """Without dollar signs; what is left stands as a bracket polynomial. Where cofactors were found, the identities
    with them.
    """
    if not f.rational:
        return formulas.latex(f.whole())
    sides = ((ex.mul(form.cofactor, f.whole()), form.product()) for form in f.rational)
    return " \\\\\n".join(f"{formulas.latex(left)} = {formulas.latex(right)}" for left, right in sides)
