r"""Where the parts of a condition meet in a pose, and how the platform can move there: exact linear algebra."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import combinations

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Expr, Meet, Number, Power, Product
from gcrules.algebra.language.legs_text import Leg
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import cross, kernel

__all__ = ["Screw", "common_point", "factors", "free_motions", "incidence_rows", "vanishing"]

Vector = tuple[Fraction, ...]
Points = Mapping[str, Sequence[int | Fraction]]


@lru_cache(maxsize=256)
def factors(e: Expr) -> tuple[Expr, ...]:
    """The factors of a scalar, numbers and signs left out, each one once."""
    return tuple({str(f): f for f in _factors(e)}.values())


def _factors(e: Expr) -> Iterator[Expr]:
    if isinstance(e, Product):
        for child in e.children:
            yield from _factors(child)
    elif isinstance(e, Power):
        yield from _factors(e.children[0])
    elif not isinstance(e, Number):
        yield e


def vanishing(e: Expr, points: Points) -> tuple[Expr, ...]:
    """Those factors of a scalar that are zero at these points (homogeneous coordinates, exact)."""
    return tuple(f for f in factors(e) if evaluate(f, points) == 0)


def common_point(e: Expr, points: Points) -> Vector | None:
    """The one point (homogeneous) that all operands of a meet have in common; None for none, or for more than one.

    The operands may be planes, lines or points in space, constructed ones too.
    """
    if not isinstance(e, Meet):
        return None
    rows = [row for part in e.children for row in incidence_rows(evaluate(part, points), part.step)]
    found = kernel(rows, 4)
    return found[0] if len(found) == 1 else None


def incidence_rows(plucker: Sequence[Fraction], step: int) -> list[Vector]:
    """The linear equations of the points of an extensor (step 1, 2 or 3) of rank 4: their join with it is zero."""
    coordinate = dict(zip(combinations(range(4), step), plucker, strict=True))
    rows = []
    for subset in combinations(range(4), step + 1):
        row = [Fraction(0)] * 4
        for place, i in enumerate(subset):
            row[i] = (-1) ** place * Fraction(coordinate[tuple(j for j in subset if j != i)])
        rows.append(tuple(row))
    return rows


@dataclass(frozen=True)
class Screw:
    """An instantaneous motion: a turn about the line through `foot` along `axis` with `pitch` as length of advance per
    radian (in units of length; 0 is a pure turn). A translation has no foot, and no pitch.
    """

    axis: Vector
    foot: Vector | None
    pitch: Fraction | None


def free_motions(legs: Iterable[Leg], points: Points) -> list[Screw]:
    """Independent motions of the platform that to first order change the length of no leg; all joints are finite."""
    rows = []
    for a, b in legs:
        start, end = _finite(points[a]), _finite(points[b])
        rows.append((*(q - p for p, q in zip(start, end, strict=True)), *cross(start, end)))
    return [_screw(v[:3], v[3:]) for v in kernel(rows, 6)]


def _screw(velocity: Vector, turn: Vector) -> Screw:
    """From the velocity of the origin and the angular velocity."""
    square = sum((c * c for c in turn), Fraction(0))
    if not square:
        return Screw(velocity, None, None)
    foot = tuple(c / square for c in cross(turn, velocity))
    return Screw(turn, foot, sum((w * v for w, v in zip(turn, velocity, strict=True)), Fraction(0)) / square)


def _finite(point: Sequence[int | Fraction]) -> Vector:
    return tuple(Fraction(c) / Fraction(point[3]) for c in point[:3])
