"""Proofs and refutations, as text and as LaTeX."""

from __future__ import annotations

from gcrules.algebra.language.text import text as expression_text
from gcrules.algebra.prove import Proof, number_text
from gcrules.views.formulas import latex as formulas

__all__ = ["as_latex", "as_text", "conditions"]

_SIGNS = {"proved": "=", "refuted": "\\neq", "undecided": "\\stackrel{?}{=}"}


def as_text(proof: Proof, *, unicode: bool = False) -> str:
    """The verdict in words, with the counterexample if there is one."""
    left, right = (expression_text(e, unicode=unicode) for e in (proof.left, proof.right))
    lines = [f"{proof.verdict}: {proof.relation or f'{left} == {right}'}", f"  {proof.reason}"]
    if proof.counterexample is not None:
        lines += [f"  {name} = ({', '.join(map(str, c))})" for name, c in proof.counterexample.items()]
    if proof.values is not None and not proof.relation:
        lines += [f"  left side  = {number_text(proof.values[0])}", f"  right side = {number_text(proof.values[1])}"]
    return "\n".join([*lines, *conditions(proof)])


def conditions(proof: Proof) -> list[str]:
    """The lines that say what was assumed not to vanish, and what that means, which points coincide, and which kinds of
    positions there are; none if nothing was assumed and there is only one.
    """
    meanings = proof.meanings or [""] * len(proof.assumed)
    shown = [f"{e} ({m})" if m else e for e, m in zip(proof.assumed, meanings, strict=True)]
    lines = [f"  assumed not to vanish: {', '.join(shown)}"] if shown else []
    lines += [
        f"  at all positions that this speaks of {a} and {b} are one point, which the assumptions do not say"
        for a, b in proof.together
    ]
    if proof.kinds:
        lines += ["  the assumptions allow several kinds of positions", *(f"    {k}" for k in proof.kinds)]
    return lines


def as_latex(proof: Proof) -> str:
    """The sides with the sign that the verdict calls for, or the relation; without dollar signs."""
    if proof.relation:
        return f"\\text{{{proof.relation.replace('_', chr(92) + '_')}}}"
    return f"{formulas.latex(proof.left)} {_SIGNS[proof.verdict]} {formulas.latex(proof.right)}"
