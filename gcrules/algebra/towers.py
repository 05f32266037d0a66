r"""Assumptions about quadrics that put one point after the other on a quadric, a line or a plane.

Each point is then on something that earlier points determine: a quadric that is no cone, or a linear space of one
dimension wherever its extensor is not zero. All of this is irreducible, over quadrics and points of which nothing is
given, and so are all positions at which these extensors do not vanish. What is proved of them where something else does
not vanish, though not everywhere, holds on a dense set, and so at all of them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra import quadric_forms
from gcrules.algebra.expr import Expr, Point, Sum, points_of
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conic_of, conics_of, named_letter
from gcrules.algebra.space import Assumption, Space

__all__ = ["polar_of_line", "tower"]

_SPACE = 4


def tower(given: Sequence[Assumption], at: Space, fixed: Collection[str]) -> tuple[Expr, ...] | None:
    """The lines and planes on which points are put, whose order is sought from the last one; None where there is no
    such order, in which the `fixed` points come first.
    """
    left, flats = list(given), list[Expr]()
    while left:
        used = [set(points_of(*a.args)) for a in left]
        for i, a in enumerate(left):
            others = set().union(*used[:i], *used[i + 1 :])
            found = next((flat for x, flat in _last(a) if not {x} & {*others, *fixed, *at.ideal}), _NONE)
            if found is not _NONE:
                break
        else:
            return None
        if isinstance(found, Expr):
            flats.append(found)
        del left[i]
    return tuple(flats)


_NONE = object()


def _last(a: Assumption) -> Iterator[tuple[str, Expr | None]]:
    """The points that an assumption puts on a quadric, or on something that is not zero where the extensor is not."""
    if a.also:
        return
    if a.kind == "zero":
        letters = conics_of(points_of(*a.args))
        others = [n for n in points_of(*a.args) if conic_of(n) is None]
        if len(letters) == 1 == len(others):
            form = FORMS[_SPACE]
            if a.args[0] == form.value(Point(others[0]), *form.own(letters[0])):
                yield others[0], None
    elif a.kind == "incident":
        for point, flat in (a.args, a.args[::-1]):
            if isinstance(point, Point) and conic_of(point.name) is None and point.name not in points_of(flat):
                if isinstance(flat, Point) or _polar_plane(flat) or named_letter(flat) is not None:
                    yield point.name, None
                elif not isinstance(flat, Sum) or flat.step != 2:
                    yield point.name, flat
                elif (line := polar_of_line(flat)) is not None:
                    yield point.name, line


def _polar_plane(e: Expr) -> bool:
    """Whether it is the polar plane of a point for a quadric, which is never zero."""
    names = [n for n in points_of(e) if conic_of(n) is None]
    if e.step != 3 or len(names) != 1:
        return False
    form = FORMS[_SPACE]
    return any(e == form.polar(Point(names[0]), *form.own(letter)) for letter in conics_of(points_of(e)))


def polar_of_line(e: Expr) -> Expr | None:
    """The line through two points whose polar line for a quadric this is."""
    names = points_of(e)
    for letter in conics_of(names):
        own = FORMS[_SPACE].own(letter)
        for two in combinations(map(Point, (n for n in names if conic_of(n) is None)), 2):
            for line in (ex.join(*some, rank=_SPACE) for some in (two, two[::-1])):
                if e == quadric_forms.polar_line(line, *own):
                    return line
    return None
