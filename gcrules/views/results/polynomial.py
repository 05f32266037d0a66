"""Polynomials in brackets, as text and as LaTeX."""

from __future__ import annotations

import re
from itertools import chain

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial, repeats
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.algebra.language.text import text as expression_text
from gcrules.algebra.letters import conic_points, conics_of, letters_of, marked, names_of
from gcrules.algebra.screw_letters import screw_points, screws_of
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.algebra.whole_letters import in_letters
from gcrules.core.budget import watched
from gcrules.core.english import listed
from gcrules.views.formulas import latex as formulas

__all__ = ["as_latex", "as_text", "form_latex", "form_text", "points_shown"]


def as_text(p: BracketPolynomial | ExtensorPolynomial, *, unicode: bool = False, short: bool = False) -> str:
    """The text of the language; `short` writes many equal brackets as a power (of which the language reads those up to
    64 back).
    """
    if any(map(marked, p.points)):
        return _of_letters(p, unicode, short)
    if isinstance(p, BracketPolynomial) and not (short and any(map(repeats, p.terms))):
        return _of_brackets(p, unicode)
    return expression_text(p.to_expr(short=short), unicode=unicode, names=p.points)


def _of_brackets(p: BracketPolynomial, unicode: bool) -> str:
    """As for any expression, without making one of each of the terms, which may be many."""
    between = "" if all(map(SHORT_NAME.fullmatch, p.points)) else " "
    minus = "−" if unicode else "-"
    rows = {row: f"[{between.join(p.points[i] for i in row)}]" for row in set(chain.from_iterable(p.terms))}
    words: list[str] = []
    last = sorted(p.terms.items(), key=lambda term: not term[0])  # a number comes last
    for m, c in watched(last):
        words.append(f" {minus if c < 0 else '+'} " if words else minus * (c < 0))
        words.append("" if abs(c) == 1 and m else str(ex.Number(c if c > 0 else -c).value))
        words += map(rows.__getitem__, m)
    return "".join(words) or "0"


def _of_letters(p: BracketPolynomial | ExtensorPolynomial, unicode: bool, short: bool) -> str:
    """In whole letters where that can be; a comment says what points are shown of others."""
    e = in_letters(p, short=short)
    shown = expression_text(e, unicode=unicode, names=[n for n in p.points if not marked(n)])
    return "  # ".join([shown, *filter(None, [points_shown(shown, p.rank)])])


def points_shown(shown: str, rank: int = 4) -> str:
    """What the points of letters are that a text shows: "L = L₁ ∨ L₂", for each letter.

    >>> points_shown("[abc L₁]")
    'L = L₁ ∨ L₂, whichever points of it these are'
    """
    names = _MARKED.findall(shown)
    told = [f"{name} = {' ∨ '.join(names_of(name, step))}" for name, step in letters_of(names).items()]
    told += [_through(name, rank) for name in conics_of(names)]
    screws = [_two_lines(name, *screw_points(name)) for name in screws_of(names)]
    of = "" if screws else " of it" if len(told) == 1 else " of them"
    return f"{', '.join((*told, *screws))}, whichever points{of} these are" if (*told, *screws) else ""


def _through(name: str, rank: int) -> str:
    points = listed(conic_points(name, rank))
    return f"{name} is the conic through {points}" if rank == 3 else f"a tetrahedron on {name} has the corners {points}"


def _two_lines(name: str, a: str, b: str, c: str, d: str) -> str:
    return f"{name} = {a} ∨ {b} + {c} ∨ {d}"


_MARKED = re.compile(r"[A-Za-z][A-Za-z0-9_]*'*(?:[₁-₉]+|[¹²³⁴⁵ᵃᵇᶜᵈ])")


def as_latex(p: BracketPolynomial | ExtensorPolynomial) -> str:
    """Without dollar signs."""
    return formulas.latex(in_letters(p))


def form_text(form: SuperbracketForm, *, unicode: bool = False) -> str:
    """The form, the order of the lines (counted from 1) and the polynomial."""
    order, n = " ".join(str(i + 1) for i in form.order), len(form.polynomial)
    name = f"{form.form}-term form" if form.form else "expansion"
    shown = as_text(form.polynomial, unicode=unicode)
    return f"{name}, lines in the order {order}, {n} term{'s' * (n != 1)}:\n  {shown}"


def form_latex(form: SuperbracketForm) -> str:
    """The polynomial, without dollar signs."""
    return as_latex(form.polynomial)
