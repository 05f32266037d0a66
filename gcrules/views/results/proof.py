"""Proofs and refutations, as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import gcd, lcm
from operator import mul
from typing import Any

from gcrules.algebra.evaluate import evaluate, plucker
from gcrules.algebra.expr import Point
from gcrules.algebra.language.text import number_text
from gcrules.algebra.language.text import text as expression_text
from gcrules.algebra.letter_forms import FORMS, coefficients
from gcrules.algebra.letters import conics_of, letter, letters_of, marked
from gcrules.algebra.prove import Proof
from gcrules.algebra.screw_letters import screw, screws_of
from gcrules.core.english import listed
from gcrules.views.formulas import latex as formulas
from gcrules.views.results.polynomial import points_shown

__all__ = ["as_latex", "as_text", "conditions", "dual_lines"]

_SIGNS = {"proved": "=", "refuted": "\\neq", "undecided": "\\stackrel{?}{=}"}


def as_text(proof: Proof, *, unicode: bool = False) -> str:
    """The verdict in words, with the counterexample if there is one."""
    left, right = (expression_text(e, unicode=unicode) for e in (proof.left, proof.right))
    lines = [f"{proof.verdict}: {proof.relation or f'{left} == {right}'}", *dual_lines(proof), f"  {proof.reason}"]
    if proof.counterexample is not None:
        lines += [f"  {name} = {c}" for name, c in _coordinates(proof.counterexample, proof.rank)]
        lines += [_failing(proof.counterexample, proof.rank)] if proof.dual else []
    if proof.values is not None and not proof.relation:
        lines += [f"  left side  = {number_text(proof.values[0])}", f"  right side = {number_text(proof.values[1])}"]
    return "\n".join([*lines, *conditions(proof)])


def _failing(points: Mapping[str, Sequence[Any]], rank: int) -> str:
    """Where a dual fails, by the counterexample to the claim that it is the dual of."""
    where = f"  the dual fails at the hyperplanes with {_OF[bool(letters_of(points))]}"
    conics = conics_of(points)
    if not conics:
        return where
    plural, forms = ("", "its form is") if len(conics) == 1 else ("s", "their forms are")
    word = f"{FORMS[rank].word}{plural} {listed(conics)}"
    return f"{where}, for the {word} of the {_TANGENTS[rank]} at whose coordinates {forms} zero"


_TANGENTS = {3: "lines", 4: "planes"}


def dual_lines(proof: Proof) -> list[str]:
    """The lines that say what the dual is, where that is not the claim itself, and by what it is decided; none for
    other claims.
    """
    if proof.dual is None:
        return []
    given = f" where {', '.join(proof.dual.given)}" if proof.dual.given else ""
    how = "points and hyperplanes change places, joins and meets too, which keeps what holds"
    claims = " and ".join(proof.dual.claims)
    shown = [*proof.dual.letters, f"the dual: {claims}{given}"] if claims != proof.relation else []
    shown.append(f"decided for the claim that it is the dual of: {how}")
    return [f"  {line}" for line in shown]


def _coordinates(points: Mapping[str, Sequence[Any]], rank: int) -> Iterator[tuple[str, str]]:
    """The coordinates of points and of letters, in place of the points that these are joins of."""
    found = letters_of(points)
    for name, step in found.items():
        value = plucker(letter(name, step), points)
        if step == rank - 1:
            value = tuple((-1) ** (step - i) * c for i, c in enumerate(reversed(value)))
        kind = "coordinates of the hyperplane" if step == rank - 1 else "Plücker coordinates"
        yield name, f"{number_text(value)}, {_KINDS.get((step, rank), kind)}"
    for name in screws_of(points):
        yield name, _screw(plucker(screw(name), points))
    for name in conics_of(points):
        yield name, f"{number_text(_form(name, points, rank))}, coefficients of {_SQUARES[rank]}"
    yield from ((name, number_text(tuple(c))) for name, c in points.items() if not marked(name))


def _screw(value: tuple[Any, ...]) -> str:
    """Plücker coordinates of a screw, which are (m_z, -m_y, -f_x, m_x, -f_y, -f_z), with its pitch f·m / f·f."""
    z, y, fx, x, fy, fz = value
    force, moment = (-fx, -fy, -fz), (x, -y, z)
    square = sum(c * c for c in force)
    pitch = Fraction(sum(map(mul, force, moment)), square) if square else None
    kind = "a couple" if pitch is None else f"of pitch {pitch}" if pitch else "a line"
    return f"{number_text(value)}, Plücker coordinates, {kind}"


def _form(name: str, points: Mapping[str, Sequence[Any]], rank: int) -> tuple[Any, ...]:
    """The coefficients of the form of a letter for a conic or a quadric, without a common factor."""
    form = FORMS[rank].value(Point("x"), *FORMS[rank].own(name))
    found = coefficients(lambda p: evaluate(form, {**points, "x": p}), rank)
    common = Fraction(gcd(*(c.numerator for c in found)), lcm(*(c.denominator for c in found)))
    sign = -1 if next(c for c in found if c) < 0 else 1
    return tuple(int(sign * c / common) for c in found)


_SQUARES = {3: "x², y², z², yz, zx and xy", 4: "x², y², z², w², yz, zx, xy, xw, yw and zw"}
_OF = ("these coordinates", "the coordinates of the points, and where the letters go with them")
_KINDS = {(2, 3): "coordinates of the line", (3, 4): "coordinates of the plane"}


def conditions(proof: Proof) -> list[str]:
    """The lines that say what was assumed not to vanish, and what that means, which points coincide, and which kinds of
    positions there are; none if nothing was assumed and there is only one.
    """
    meanings = proof.meanings or [""] * len(proof.assumed)
    shown = [f"{e} ({m})" if m else e for e, m in zip(proof.assumed, meanings, strict=True)]
    of = ", in the claim that it is the dual of" if proof.dual else ""
    lines = [f"  assumed not to vanish{of}: {', '.join(shown)}"] if shown else []
    told = ", ".join((*proof.assumed, *(e for k in proof.kinds for e in (*k.where, *k.assumed))))
    lines += [f"  where {points}" for points in filter(None, [points_shown(told, proof.rank)])]
    lines += [
        f"  at all positions that this speaks of {a} and {b} coincide, which the assumptions do not say"
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
