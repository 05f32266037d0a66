"""Turns on the tape: by roll, then pitch, then yaw."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from gcrules.poses.compiling.roots import cosine_and_sine
from gcrules.poses.compiling.scalars import Ring, Scalar
from gcrules.poses.compiling.vectors import Turn, Vector, turned, vector

__all__ = ["TurnedBy", "about", "back", "by_angles", "level", "product", "turned_by"]


TurnedBy = Callable[[Ring], tuple[Ring, Ring]]
"""What makes the cosine and the sine of an angle."""


def turned_by(angle: Ring) -> tuple[Ring, Ring]:
    """Cosine and sine as they are: Taylor models and checkers know them."""
    assert isinstance(angle, Scalar)
    return angle.cosine_and_sine()


def by_angles(angles: Sequence[Ring], turned_by: TurnedBy = cosine_and_sine) -> Turn:
    """By roll, pitch and yaw from −π to π, in rad."""
    roll, pitch, yaw = map(turned_by, angles)
    return product(about(2, *yaw), level(roll, pitch))


def level(roll: Sequence[Ring], pitch: Sequence[Ring]) -> Turn:
    """By roll, then by pitch, given by cosine and sine."""
    return product(about(1, *pitch), about(0, *roll))


def about(axis: int, cosine: Ring, sine: Ring) -> Turn:
    """About a coordinate axis."""
    j, k = (axis + 1) % 3, (axis + 2) % 3
    rows: list[list[Ring]] = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]
    rows[axis][axis] = 1
    rows[j][j], rows[j][k], rows[k][j], rows[k][k] = cosine, -sine, sine, cosine
    return vector(rows[0]), vector(rows[1]), vector(rows[2])


def product(a: Turn, b: Turn) -> Turn:
    """By `b`, then by `a`."""
    return back([turned(a, column) for column in back(b)])


def back(turn: Sequence[Vector]) -> Turn:
    """The transpose, which turns back."""
    first, second, third = zip(*turn, strict=True)
    return first, second, third
