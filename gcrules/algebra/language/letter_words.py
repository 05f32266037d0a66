r"""Words that are said of letters for conics and quadrics, which stand behind all other arguments.

>>> [*CONSTRUCTIONS_OF_LETTERS[4]], [*RELATIONS_OF_LETTERS[4]]
(['second_on_quadric', 'tangent', 'polar', 'pole', 'quadric'], ['incident', 'on_quadric', 'touches'])
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from gcrules.algebra import conics, quadric_forms
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.words import (
    CONSTRUCTIONS,
    FLAT,
    LINE,
    PLANE,
    POINT,
    POINT_OR_LINE,
    Construction,
    Relation,
)
from gcrules.algebra.letter_forms import FORMS

__all__ = ["CONSTRUCTIONS_OF_LETTERS", "CONSTRUCTION_NAMES", "RELATIONS_OF_LETTERS"]

_PLANE, _SPACE = (3,), (4,)
_P2 = (POINT,) * 2
_Equations = Iterable[Expr]

_of_conic = partial(Construction, ranks=_PLANE, metric=False, of_conic=True)

_CONICS: Mapping[str, Construction] = {
    w.name: w
    for w in (
        _of_conic(
            "second_on_conic(p, a, K)",
            "the second point of the line pa on the conic K, of which a is a point",
            _P2,
            build=conics.second_of,
            on=1,
        ),
        _of_conic(
            "tangent(a, K)", "the tangent at a point a of the conic K", (POINT,), build=conics.polar, on=0, whole=True
        ),
        _of_conic("polar(p, K)", "the polar of p for the conic K", (POINT,), build=conics.polar, whole=True),
        _of_conic("pole(pq, K)", "the pole of any line for the conic K", (LINE,), build=conics.pole_of),
        _of_conic(
            "conic(p, K)",
            "the scalar that is zero where p is on the conic K",
            (POINT,),
            build=conics.value,
            always=True,
        ),
    )
}
_of_quadric = partial(Construction, ranks=_SPACE, metric=False, of_conic=True)


def _polar(e: Expr, *own: Expr) -> Expr:
    return (quadric_forms.polar if e.step == 1 else quadric_forms.polar_line)(e, *own)


_QUADRICS: Mapping[str, Construction] = {
    w.name: w
    for w in (
        _of_quadric(
            "second_on_quadric(p, a, Q)",
            "the second point of the line pa on the quadric Q, of which a is a point",
            _P2,
            build=quadric_forms.second_of,
            on=1,
        ),
        _of_quadric(
            "tangent(a, Q)",
            "the tangent plane at a point a of the quadric Q",
            (POINT,),
            build=quadric_forms.polar,
            on=0,
            whole=True,
        ),
        _of_quadric(
            "polar(p, Q)",
            "the polar plane of p for the quadric Q, or the polar line of a line",
            (POINT_OR_LINE,),
            build=_polar,
            whole=True,
        ),
        _of_quadric("pole(P, Q)", "the pole of any plane for the quadric Q", (PLANE,), build=quadric_forms.pole),
        _of_quadric(
            "quadric(p, Q)",
            "the scalar that is zero where p is on the quadric Q",
            (POINT,),
            build=quadric_forms.value,
            always=True,
        ),
    )
}

CONSTRUCTIONS_OF_LETTERS: Mapping[int, Mapping[str, Construction]] = {3: _CONICS, 4: _QUADRICS}
"""The words that are said of the letters of conics and quadrics, for each rank."""

CONSTRUCTION_NAMES = tuple(
    dict.fromkeys((*CONSTRUCTIONS, *(n for some in CONSTRUCTIONS_OF_LETTERS.values() for n in some)))
)
"""All words of expressions, as grammar.lark lists them."""


def _on(rank: int, own: Sequence[Expr], *points: Expr) -> _Equations:
    return [FORMS[rank].value(p, *own) for p in points]


def _touching(rank: int, own: Sequence[Expr], flat: Expr) -> _Equations:
    return [FORMS[rank].touching(flat, *own)]


def _at_point(rank: int, own: Sequence[Expr], t: Expr, flat: Expr) -> Iterator[tuple[str, tuple[Expr, ...]]]:
    """That a line or plane touches at t: it is on the polar of t, which is a point of the conic or quadric. A line of
    space has t in common with its polar line.
    """
    form = FORMS[rank]
    if flat.step < rank - 1:
        yield "incident", (t, flat)
        yield "incident", (t, quadric_forms.polar_line(flat, *own))
    else:
        yield "zero", (form.value(t, *own),)
        yield "incident", (flat, form.polar(t, *own))


def _of_letter(usage: str, meaning: str, takes: str, ranks: tuple[int, ...], **more: Any) -> Relation:
    return Relation(usage, meaning, (takes,), ranks, metric=False, of_conic=True, **more)


RELATIONS_OF_LETTERS: Mapping[int, Mapping[str, Relation]] = {
    rank: {w.name: w for w in some}
    for rank, some in {
        3: (
            _of_letter("incident(p, K)", "p is on the conic K", POINT, _PLANE, whole=_on),
            _of_letter("on_conic(p, q, …, K)", "the points are on the conic K", POINT, _PLANE, open=True, whole=_on),
            _of_letter(
                "touches(L, K)", "the line L touches the conic K", LINE, _PLANE, whole=_touching, at_point=_at_point
            ),
        ),
        4: (
            _of_letter("incident(p, Q)", "p is on the quadric Q", POINT, _SPACE, whole=_on),
            _of_letter(
                "on_quadric(p, q, …, Q)", "the points are on the quadric Q", POINT, _SPACE, open=True, whole=_on
            ),
            _of_letter(
                "touches(P, Q)",
                "the plane P touches the quadric Q, or a line does",
                FLAT,
                _SPACE,
                whole=_touching,
                at_point=_at_point,
            ),
        ),
    }.items()
}
"""Relations that are said of the letters of conics and quadrics, for each rank."""
