"""Numbers at many poses, as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gcrules.poses.numbers.many import PoseNumbers
from gcrules.screws.verdict import VERDICTS
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.text_tables import ASCII, table

__all__ = ["as_latex", "as_text"]


def as_text(n: PoseNumbers, *, unicode: bool = False) -> str:
    """How many poses are singular, close, regular, and where the margin is least; without `unicode` in ASCII."""
    lines = "\n".join(table(list(_rows(n))))
    return lines if unicode else lines.translate(ASCII)


def _rows(n: PoseNumbers) -> Iterator[tuple[str, str]]:
    yield "poses", f"{len(n):,}: {counts(n)}"
    if len(n):
        least = int(np.argmin(n.margin))
        yield "least", f"σ = {n.margin[least]:.4g} at pose {least} (counted from 0)"
        yield "median", f"σ = {float(np.median(n.margin)):.4g}"
    yield from (("note", note) for note in n.notes)


def counts(n: PoseNumbers) -> str:
    """ "2 singular, 1 close, 97 regular"."""
    return ", ".join(f"{int((n.verdict == v).sum()):,} {v}" for v in VERDICTS)


def as_latex(n: PoseNumbers) -> str:
    """A tabular of the summary; needs no package."""
    rows = [("poses", latex_quantity(len(n))), *((v, latex_quantity(int((n.verdict == v).sum()))) for v in VERDICTS)]
    if len(n):
        rows.append(("least margin $\\sigma$", latex_quantity(float(n.margin.min()))))
    return latex_table(rows)
