"""The polynomials of the singular poses as a section of a report."""

from __future__ import annotations

from html import escape

from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.limb_report import RobotLocus
from gcrules.poses.loci.report import Locus
from gcrules.views.report.account_html import facts_html, latex_html, section_html
from gcrules.views.results import locus as of_legs
from gcrules.views.results import robot_locus as of_limbs

__all__ = ["locus_html"]

_LONG = 4_000
"""Characters of a polynomial that stand open in the page; longer ones are folded away."""


def locus_html(r: Locus | RobotLocus, m: SixLegs | Limbs, *, live: bool, title: str = "The locus") -> str:
    """What the zeros are, what was computed and checked, and the polynomials, exact."""
    if isinstance(r, Locus):
        rows = facts_html(of_legs.account(r, unicode=True))
        return section_html(title, of_legs.headline(r), _picture(r), rows, _polynomial("P", r.form), latex_html(r))
    rows = facts_html(of_limbs.account(r, unicode=True))
    parts = []
    for name, part in of_limbs.numbered(r):
        told = facts_html(of_limbs.part_rows(part, name, r, unicode=True))
        parts.append(told + _polynomial(name, part.form))
    return section_html(title, of_limbs.headline(r), _picture(r), rows, *parts, latex_html(r))


def _picture(r: Locus | RobotLocus) -> str:
    """Of loci over one variable or two."""
    try:
        drawn = r.picture().svg()
    except InputError:
        return ""
    words = f"The singular poses over {listed(r.question.free)}."
    return f'<figure class="plot">{drawn}<figcaption>{words}</figcaption></figure>'


def _polynomial(name: str, form: PolynomialForm) -> str:
    """It as the language writes it; nothing where it is 0."""
    if not form.terms:
        return ""
    text = str(form)
    shown = f'<pre class="polynomial">{escape(name)} = {escape(text)}</pre>'
    words = f"{escape(name)}, {len(form.terms):,} terms"
    return shown if len(text) <= _LONG else f"<details><summary>{words}</summary>{shown}</details>"
