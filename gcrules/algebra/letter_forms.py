"""What letters for conics and quadrics stand for: the form, the polar and when it is proper, by points of their own.

>>> [FORMS[rank].word for rank in FORMS], FORMS[4].own("Q")[0].name
(['conic', 'quadric'], 'Q¹')
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from gcrules.algebra import conics, quadric_forms
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.letters import conic_points
from gcrules.core.dataclass import dataclass

__all__ = ["FORMS", "LetterForm", "coefficients", "polar_of"]


@dataclass(frozen=True, slots=True)
class LetterForm:
    """The letters of one rank, with their `word`. Functions take what they are about, then the points of a letter;
    `value` is the form at a point, `touching` is zero where a line or a plane touches, `proper` is not zero where the
    conic is not a pair of lines, the quadric not a cone; `instead` of a letter other things are written with points,
    of which `by_points` says that they are on one.
    """

    rank: int
    word: str
    instead: str
    by_points: str
    value: Callable[..., Expr]
    polar: Callable[..., Expr]
    touching: Callable[..., Expr]
    proper: Callable[..., Expr]

    def own(self, name: str) -> tuple[Point, ...]:
        """The points of a letter."""
        return tuple(map(Point, conic_points(name, self.rank)))


FORMS: Mapping[int, LetterForm] = {
    3: LetterForm(
        3,
        "conic",
        "the conic through five points",
        "on_conic(a, b, c, d, e, f)",
        conics.value,
        conics.polar,
        conics.touching,
        conics.discriminant,
    ),
    4: LetterForm(
        4,
        "quadric",
        "the quadric through nine points",
        "on_quadric(a, b, c, d, e, f, g, h, i, j)",
        quadric_forms.value,
        quadric_forms.polar,
        quadric_forms.touching,
        quadric_forms.discriminant,
    ),
}


def polar_of(flat: Expr, own: Sequence[Expr], rank: int) -> tuple[str, Expr]:
    """The word for the polar of a point, or of a line or plane of space, and what it is."""
    if flat.step == 1:
        return "polar", FORMS[rank].polar(flat, *own)
    if flat.step == rank - 1:
        return "pole", (quadric_forms.pole if rank == _SPACE else conics.pole_of)(flat, *own)
    return "polar", quadric_forms.polar_line(flat, *own)


_SPACE = 4
_MIXED = {3: ((1, 2), (2, 0), (0, 1)), 4: ((1, 2), (2, 0), (0, 1), (0, 3), (1, 3), (2, 3))}


def coefficients(form: Callable[[Sequence[int]], Any], rank: int) -> tuple[Any, ...]:
    """Of x², y², z², … and of yz, zx, xy, … in a quadratic form, from its values at points."""
    squares = [form([int(i == k) for i in range(rank)]) for k in range(rank)]
    mixed = [form([int(i in pair) for i in range(rank)]) for pair in _MIXED[rank]]
    return *squares, *(c - squares[i] - squares[j] for c, (i, j) in zip(mixed, _MIXED[rank], strict=True))
