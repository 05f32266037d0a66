"""Shortest forms, as text and as LaTeX."""

from __future__ import annotations

from gcrules.algebra.shortening.result import Shortening
from gcrules.core.english import counted
from gcrules.views.detail import naming_options
from gcrules.views.results import polynomial

__all__ = ["as_latex", "as_text"]


def as_text(s: Shortening, *, unicode: bool = False, short: bool = False) -> str:
    """The polynomial (`short`: with powers), its number of terms, whether fewer are possible and why, and the
    certificate.
    """
    sure = "proved minimal" if s.minimal else f"the fewest that were found; at least {s.lower} are needed"
    lines = [
        polynomial.as_text(s.polynomial, unicode=unicode, short=short),
        f"{counted(s.terms, 'term')} of {s.given}, {sure}",
        f"  lower bound  {s.bound.method}: {s.bound.detail}",
        f"  certificate  {s.certificate.method}: {s.certificate.detail}",
    ]
    if s.monomials:
        symmetries = f"{s.symmetries:,} symmetr{'y' if s.symmetries == 1 else 'ies'}"
        lines.insert(2, f"  searched     {s.monomials:,} bracket monomials, {symmetries}")
    if s.undecided:
        more = naming_options(" (--limit raises the limit)")
        lines.append(f"  undecided    whether a shorter one exists: {s.undecided}{more}")
    return "\n".join([*lines, *(f"  note         {note}" for note in s.notes)])


def as_latex(s: Shortening) -> str:
    """The polynomial, without dollar signs."""
    return polynomial.as_latex(s.polynomial)
