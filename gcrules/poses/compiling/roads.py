"""The roads to the superbracket of six legs, and the joints from which they are traced."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.text import text as as_text
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.compiling.tracing import Joints, Road
from gcrules.poses.compiling.vectors import of_expression, of_legs, of_polynomial

__all__ = ["as_written", "check_finite", "joints_of", "roads_of"]


def check_finite(structure: Structure) -> None:
    """Raises InputError for legs that are no lines between finite joints in space."""
    if structure.special or structure.stand_ins or structure.rank != 4:
        raise InputError("only legs between finite joints in space are compiled", hint="analyze a platform")


def roads_of(analysis: Analysis) -> list[Road]:
    """What the superbracket of the legs equals; a condition with a cofactor is not among them."""
    shortest = analysis.shortest
    conditions = {c.right_side: None for c in (analysis.condition, *analysis.readings) if c.cofactor == ONE}
    return [
        ("six legs", lambda places: of_legs(analysis.structure.legs, places)),
        ("shortest bracket form", lambda places: shortest.sign * of_polynomial(shortest.polynomial, places)),
        *map(as_written, conditions),
    ]


def as_written(e: Expr) -> Road:
    return as_text(e), lambda places: of_expression(e, places)


def joints_of(analysis: Analysis, moving: MovingPlatform | None) -> Joints:
    """The joints with their coordinates; without a platform all of them move."""
    if moving is None:
        return Joints({}, analysis.structure.names, {})
    body = analysis.structure.platform
    arms = {n: _less(moving.points[n], moving.centre) for n in body}
    fixed = {n: p for n, p in moving.points.items() if n not in arms}
    return Joints(fixed, tuple(body), arms, moving.centre)


def _less(p: Sequence[Fraction], q: Sequence[Fraction]) -> tuple[Fraction, Fraction, Fraction]:
    x, y, z = (a - b for a, b in zip(p, q, strict=True))
    return x, y, z
