"""The theorems of a proof file as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.core.english import counted
from gcrules.views.formulas.latex import latex

__all__ = ["as_latex", "as_text"]


def as_text(file: ProofFile, *, unicode: bool = False) -> str:
    """Each theorem with the number of exchanges that prove it, what is recomputed, what is left out, and the digest."""
    return "\n".join(_lines(file, unicode))


def _lines(file: ProofFile, unicode: bool) -> Iterator[str]:
    yield file.title
    for t in file.theorems:
        yield f"  {t.name}, by {counted(t.size, 'exchange')}"
        yield f"    {_side(t, t.left, unicode)} == {_side(t, t.right, unicode)}"
    for absence in file.absences:
        yield f"  stated, to be recomputed: {absence.claim}"
    for one in file.left_out:
        yield f"  not proved here: {one}"
    yield f"  digest {file.digest}"


def _side(t: Theorem, e: Expr, unicode: bool) -> str:
    return text(e, unicode=unicode, names=t.order)


def as_latex(file: ProofFile) -> str:
    """The theorems as aligned equations."""
    rows = (rf"{latex(t.left)} &= {latex(t.right)}" for t in file.theorems)
    return "\\begin{aligned}\n" + " \\\\\n".join(rows) + "\n\\end{aligned}"
