"""The public functions, which take text or expressions; `import gcrules` forwards to this module."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.evaluate import evaluate as _evaluate
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expand import expand as _expand
from gcrules.algebra.expr import Expr
from gcrules.algebra.prove import Proof
from gcrules.algebra.prove import prove as _prove
from gcrules.algebra.shortest import SuperbracketForm, shortest_forms, superbracket_form
from gcrules.algebra.straighten import straighten as _straighten
from gcrules.algebra.syntax import Context, parse, parse_equation
from gcrules.algebra.text import Names, split_names
from gcrules.analysis import Analysis, analyze
from gcrules.condition import Condition
from gcrules.errors import GcrulesError, InputError, LimitReached, StepError, SyntaxFault
from gcrules.legs import Structure, read_legs, read_order
from gcrules.render.report import report
from gcrules.robots.geometry import Platform, load_platform

__all__ = [
    "Analysis",
    "BracketPolynomial",
    "Condition",
    "Expr",
    "ExtensorPolynomial",
    "GcrulesError",
    "InputError",
    "LimitReached",
    "Platform",
    "Proof",
    "StepError",
    "Structure",
    "SyntaxFault",
    "analyze",
    "evaluate",
    "expand",
    "load_platform",
    "parse",
    "prove",
    "report",
    "shortest",
    "straighten",
    "superbracket",
]


def _expression(e: str | Expr, rank: int | None, points: Names, ideal: Names) -> Expr:
    context = Context(rank or 4, split_names(points), split_names(ideal))
    return e if isinstance(e, Expr) else parse(e, context=context)


def expand(
    e: str | Expr,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    limit: int = MAX_TERMS,
) -> BracketPolynomial | ExtensorPolynomial:
    """Expand an expression into brackets (step 0) or Σ (bracket polynomial) · extensor (any other step).

    `rank` is that of the expression (4 for text that is read); `points` declares long names and the tableau order,
    `ideal` the points at infinity, as sequences or as text ("left right"). Raises SyntaxFault or StepError for text
    that does not make sense or another rank, LimitReached beyond `limit` terms.
    """
    expression = _expression(e, rank, points, ideal)
    return _expand(expression, points=split_names(points), ideal=split_names(ideal), rank=rank, limit=limit)


def straighten(
    e: str | Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    limit: int = MAX_TERMS,
) -> BracketPolynomial | ExtensorPolynomial:
    """The normal form of standard tableaux; arguments and errors as for `expand`."""
    if isinstance(e, (BracketPolynomial, ExtensorPolynomial)):
        return _straighten(e, limit=limit)
    expression = _expression(e, rank, points, ideal)
    return _straighten(expression, points=split_names(points), ideal=split_names(ideal), rank=rank, limit=limit)


def prove(
    claim: str | Expr,
    right: str | Expr | None = None,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    limit: int = MAX_TERMS,
) -> Proof:
    """Decide "LHS == RHS" (one text, or two expressions): proved, refuted with exact points, or undecided."""
    if right is None:
        if isinstance(claim, Expr):
            raise TypeError("prove needs a claim LHS == RHS as text, or two expressions")
        sides = parse_equation(claim, context=Context(rank or 4, split_names(points), split_names(ideal)))
    else:
        sides = (_expression(claim, rank, points, ideal), _expression(right, rank, points, ideal))
    return _prove(*sides, points=split_names(points), ideal=split_names(ideal), rank=rank, limit=limit)


def evaluate(e: str | Expr, points: dict[str, Any], *, rank: int | None = None, modulus: int | None = None) -> Any:
    """The value of an expression at points given by homogeneous coordinates (exact numbers, or arrays of floats)."""
    return _evaluate(_expression(e, rank, tuple(points), ()), points, modulus=modulus)


def superbracket(
    legs: str | Iterable[str | Sequence[str]],
    *,
    order: str | Sequence[int | str] | None = None,
    form: int = 24,
    points: Names = (),
    ideal: Names = (),
) -> SuperbracketForm:
    """The superbracket of six legs as a bracket polynomial, in the 24-term or 16-term form."""
    structure = read_legs(legs, points=points, ideal=ideal)
    chosen = range(6) if order is None else read_order(order, structure)
    return superbracket_form(structure.legs, chosen, form, points=structure.points, ideal=structure.ideal)


def shortest(legs: str | Iterable[str | Sequence[str]], *, points: Names = (), ideal: Names = ()) -> SuperbracketForm:
    """The shortest superbracket over all 720 orders and both forms."""
    structure = read_legs(legs, points=points, ideal=ideal)
    return shortest_forms(structure.legs, points=structure.points, ideal=structure.ideal)[0]
