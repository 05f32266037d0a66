r"""Instances of the catalog's identities: what the superbracket of the legs of a known class equals.

>>> from gcrules.algebra.language.syntax import parse
>>> print(of_the_catalog(parse("[[ab, af, cb, cd, ed, ef]]"), Space()))
-(ace /\ abf /\ cbd /\ efd)
"""

from __future__ import annotations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Join, Point, Product, Superbracket
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.parts import substitute
from gcrules.algebra.space import Space
from gcrules.core.errors import InputError
from gcrules.rules.catalog.file import load
from gcrules.rules.catalog.proof_status import proof_status

__all__ = ["of_the_catalog", "structure_of", "structures_in"]


def structure_of(e: Expr, space: Space) -> Structure | None:
    """The legs of a superbracket of six joins of two different points; None for anything else."""
    if not isinstance(e, Superbracket):
        return None
    legs = []
    for line in e.lines:
        match line:
            case Join(args=(Point(name=a), Point(name=b))):
                legs.append((a, b))
            case _:
                return None
    names = {n for leg in legs for n in leg}
    try:
        return Structure(tuple(legs), space.points, tuple(n for n in space.ideal if n in names))
    except InputError:  # the two ends of a leg are one point
        return None


def structures_in(e: Expr, space: Space) -> list[Structure]:
    """Those of the superbrackets among the factors of an expression."""
    factors = e.factors if isinstance(e, Product) else (e,)
    return [s for f in factors if (s := structure_of(f, space))]


def of_the_catalog(e: Expr, space: Space) -> Expr | None:
    """cofactor · superbracket of legs of a class as coefficient · expression, by the first reading of the class with
    that cofactor.
    """
    structures = structures_in(e, space)
    if not structures:
        return None
    catalog = load()
    for structure in structures:
        match = catalog.match(structure)
        if match is None:
            continue
        names: dict[str, Expr] = {a: Point(b) for a, b in match.mapping.items()}
        for reading in (match.entry.condition, *match.entry.readings):
            same = ex.mul(substitute(reading.cofactor, names), structure.superbracket) == e
            if same and proof_status(match.entry, reading).verdict != "unproved":
                coefficient = match.sign(structure) * reading.coefficient
                return ex.signed(coefficient, substitute(reading.expression, names))
    return None
