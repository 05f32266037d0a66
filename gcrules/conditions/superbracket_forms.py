r"""The superbracket of a structure as bracket polynomials: as typed, and shortest over all orders of its lines."""

from __future__ import annotations

from math import prod

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.superbrackets.shortest import SuperbracketForm, shortest_forms, superbracket_form
from gcrules.core.errors import LimitReached
from gcrules.rules.generic_lines import written_out
from gcrules.rules.strategy import Strategy

__all__ = ["built", "in_order", "shortest", "typed_form"]

_WORK = 4_000  # terms of the shortest forms in general lines that are written out in the points of built lines


def typed_form(structure: Structure) -> SuperbracketForm:
    """The superbracket of the lines in the order given, without the brackets that vanish under the assumptions."""
    if structure.rank == 4 and not structure.stand_ins:
        s = structure
        return superbracket_form(s.legs, points=s.points, ideal=s.ideal, dead=s.dead)
    try:
        expanded = expand(structure.superbracket, points=structure.points, ideal=structure.ideal, rank=structure.rank)
    except LimitReached as limited:
        hint = "share points between the lines, or give lines that are built from fewer points"
        raise LimitReached(f"the superbracket of these lines is too large: {limited.message}", hint=hint) from None
    assert isinstance(expanded, BracketPolynomial)
    return SuperbracketForm(0, tuple(range(len(structure.legs))), _alive(expanded, structure))


def shortest(structure: Structure, strategy: Strategy) -> tuple[SuperbracketForm, ...]:
    """The polynomials with the fewest terms, the first of them *the* shortest form; beyond six lines the expansion."""
    if structure.rank != 4:
        return (typed_form(structure),)
    s = structure.lifted
    found = shortest_forms(s.neutral, points=s.points, ideal=s.ideal, forms=strategy.forms, dead=s.dead)
    return _of_built_lines(found, structure)


def in_order(structure: Structure, order: tuple[int, ...], strategy: Strategy) -> tuple[SuperbracketForm, ...]:
    """Both forms in the user's own order, the shorter one first."""
    s = structure.lifted
    forms = (
        superbracket_form(s.neutral, order, form, points=s.points, ideal=s.ideal, dead=s.dead)
        for form in strategy.forms
    )
    return _of_built_lines(tuple(sorted(forms, key=lambda f: len(f.polynomial))), structure)


def _of_built_lines(forms: tuple[SuperbracketForm, ...], structure: Structure) -> tuple[SuperbracketForm, ...]:
    """Forms of general lines with the lines that are built from points written out, the fewest terms first."""
    if not structure.stand_ins:
        return forms
    size = len(forms[0].polynomial) * prod(len(points_of(line)) // 2 for _, line in structure.stand_ins)
    found = [built(f, structure) for f in forms[: max(1, _WORK // max(1, size))]]
    return tuple(sorted(found, key=lambda f: len(f.polynomial)))


def built(form: SuperbracketForm, structure: Structure) -> SuperbracketForm:
    """A form of general lines with the lines of the structure in their place."""
    if not structure.stand_ins:
        return form
    polynomial = written_out(form.polynomial, structure.stand_ins, structure.names)
    return SuperbracketForm(form.form, form.order, _alive(polynomial, structure))


def _alive(poly: BracketPolynomial, structure: Structure) -> BracketPolynomial:
    """Without the terms that hold a bracket which vanishes under the assumptions."""
    place = {n: i for i, n in enumerate(poly.points)}
    dead = {tuple(sorted(place[n] for n in row)) for row in structure.dead if all(n in place for n in row)}
    return poly.with_terms({m: c for m, c in poly.terms.items() if not dead.intersection(m)}) if dead else poly
