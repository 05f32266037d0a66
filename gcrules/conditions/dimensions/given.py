"""What is assumed of a platform with coordinates must hold of them, and go on to hold as the platform moves."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from gcrules.algebra.assumptions.incidences import equations
from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr, Point, points_of
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.text import text
from gcrules.algebra.space import Assumption
from gcrules.conditions.dimensions.bodies import deviation
from gcrules.conditions.dimensions.measures import size_of
from gcrules.core.english import listed
from gcrules.core.errors import InputError

__all__ = ["check_given"]

Points = Mapping[str, tuple[Fraction, Fraction, Fraction]]

_SPAN = {"collinear": 2, "coplanar": 3}
_ANYWHERE = {"any1": (3, 1, 4, 1), "any2": (5, 9, 2, 6)}  # stand for all points where lines are to be concurrent


def check_given(structure: Structure, points: Points, unit: str = "") -> None:
    """Raises InputError for an assumption that the coordinates contradict, with the number by which they do, for one
    about joints of both bodies, which a motion would end, and where what must not vanish does.
    """
    homogeneous: dict[str, Any] = {n: (*p, Fraction(1)) for n, p in points.items()} | _ANYWHERE
    for assumption in structure.given:
        names = points_of(*assumption.args)
        _check_names(assumption, names, structure, points)
        off = _missed(assumption, homogeneous, unit)
        if off:
            raise _fault(assumption, f"the coordinates contradict {assumption}: {off}")
    for e in structure.construction.nonzero:
        if not _values(e, homogeneous):
            word = text(e, names=structure.names)
            raise InputError(
                f"{word} is zero at these coordinates; what is given says nothing about such joints",
                hint="give what holds in addition, or leave it out: exact facts of the coordinates are found anyway",
            )


def _check_names(assumption: Assumption, names: tuple[str, ...], structure: Structure, points: Points) -> None:
    for name in names:
        if name not in points or name not in structure.sides:
            raise _fault(
                assumption, f"{name} has no coordinates on one of the bodies, to be compared with {assumption}"
            )
    if len({structure.sides[name] for name in names}) > 1:
        raise _fault(
            assumption,
            f"{assumption} is about joints of base and platform, so that it no longer holds when the platform moves",
            "give the legs without coordinates to analyse what holds in one pose",
        )


def _missed(assumption: Assumption, homogeneous: Mapping[str, Any], unit: str) -> str:
    """By how much an assumption is missed, in words; "" where it holds exactly."""
    values = [v for e in equations(assumption, 4) for v in _values(e, homogeneous)]
    if not values:
        return ""
    span = _SPAN.get(assumption.kind)
    if span and all(isinstance(e, Point) for e in assumption.args):
        places = [homogeneous[n][:3] for n in points_of(*assumption.args)]
        size = size_of(places)
        far = f"{deviation(places, span, size) * size:.6g} {unit}".strip()
        what = "line" if span == 2 else "plane"
        return f"{listed(points_of(*assumption.args))} miss one {what} by {far}"
    return f"what should vanish is {float(max(values, key=abs)):.6g}"


def _values(e: Expr, homogeneous: Mapping[str, Any]) -> list[Fraction]:
    """The coordinates of an expression that are not 0."""
    found = evaluate(e, homogeneous)
    return [c for c in (found if isinstance(found, (list, tuple)) else [found]) if c]


def _fault(assumption: Assumption, message: str, hint: str | None = None) -> InputError:
    place = assumption.place
    if place is None:
        return InputError(message, hint=hint)
    return InputError(message, hint=hint, span=place.span, source=place.source, filename=place.filename)
