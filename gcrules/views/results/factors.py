"""Complete factorizations, as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.forms import BRACKET, COFACTOR, EXPRESSION, UNDECIDED, Factors, IrreducibleFactor
from gcrules.algebra.factoring.result import short
from gcrules.algebra.language.text import text as expression_text
from gcrules.algebra.whole_letters import in_letters
from gcrules.views.formulas import latex as formulas

__all__ = ["as_latex", "as_text"]

Shown = Callable[[Expr], str]

_WORDS = {EXPRESSION: "one expression", COFACTOR: "one expression with a cofactor"}


def as_text(f: Factors, *, unicode: bool = False) -> str:
    """The product of the factors in their forms, then each factor with what is known of it."""

    def shown(e: Expr) -> str:
        return expression_text(e, unicode=unicode, names=f.points)

    def lines() -> Iterator[str]:
        yield shown(short(f.to_expr()))
        for factor in f.factors:
            yield f"  factor       {_name(factor, shown)}"
            yield from _known(factor, shown, unicode)
        yield f"  certificate  {f.certificate.method}: {f.certificate.detail}"

    return "\n".join(lines())


def _name(f: IrreducibleFactor, shown: Shown) -> str:
    written = f.expression if f.closed and f.expression is not None else in_letters(f.polynomial)
    return shown(written) + (f", {f.times} times" if f.times > 1 else "")


def _known(f: IrreducibleFactor, shown: Shown, unicode: bool) -> Iterator[str]:
    yield f"    degrees      {', '.join(f'{n} {d}' for n, d in f.degrees.items())}"
    if f.form == BRACKET:
        return
    if not f.irreducible:
        yield "    irreducible  not known"
    sure = f": {f.certificate.detail}" if f.form == UNDECIDED else f" ({f.certificate.method}: {f.certificate.detail})"
    yield f"    form         {_WORDS.get(f.form, f.form)}{sure}"
    if f.expression is not None and not f.closed:
        times = " · " if unicode else " * "
        right = ex.mul(ex.Number(f.coefficient), f.expression)
        yield f"    identity     {shown(f.cofactor)}{times}factor = {shown(right)}"
    yield from (f"    excluded     {words}" for words in f.excluded)
    yield from (f"    undecided    {words}" for words in f.undecided)


def as_latex(f: Factors) -> str:
    """Without dollar signs: the product, then the identities of the factors with a cofactor."""
    rows = [formulas.latex(f.to_expr())]
    for factor in f.factors:
        if factor.expression is not None and not factor.closed:
            left = ex.mul(factor.cofactor, in_letters(factor.polynomial))
            right = ex.mul(ex.Number(factor.coefficient), factor.expression)
            rows.append(f"{formulas.latex(left)} = {formulas.latex(right)}")
    return " \\\\\n".join(rows)
