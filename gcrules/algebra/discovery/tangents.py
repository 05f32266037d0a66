r"""Letters that are said to touch a conic or a quadric: each is the polar of the point at which it does.

A line of the plane, or a plane of space, that touches is the polar of a point, and of one point only. So a letter of
which nothing else is assumed runs through all polars of points that are given on it, and is replaced by such a polar:
nothing but that point is left to be placed. A polar is the letter up to a number, which must make no difference.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> at = parse_assumption("conic K, line L, touches(L, K), incident(a, L)", Context(3))
>>> [*tangents(at, ())], [*tangents(parse_assumption("conic K, line L, touches(L, K)", Context(3)), ())]
([], ['L'])
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from gcrules.algebra.discovery.figure import normalized
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr, Point, points_of
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import named_letter, names_of
from gcrules.algebra.parts import substitute
from gcrules.algebra.seats import given_on
from gcrules.algebra.space import Assumption

__all__ = ["tangents", "without"]


def tangents(at: Context, meant: Sequence[Expr]) -> Mapping[str, Expr]:
    """The letters that can be replaced by polars where a figure is about these expressions, each with its polar."""
    found: dict[str, Expr] = {}
    for a in at.given:
        letter = _touching(a, at)
        if letter is not None and not any(_own(letter, at) & {*points_of(*b.args)} for b in at.given if b is not a):
            polar = {letter: a.args[1]}
            about = [e for e in meant if _own(letter, at) & {*points_of(e)}]
            if all(_alike(e, letter, at) and _gone(e, letter, polar, at) for e in about):
                found |= polar
    return found


def without(at: Context, lines: Mapping[str, Expr]) -> Context:
    """What is left to be assumed when letters have been replaced."""
    left = (a for a in at.given if _touching(a, at) not in lines)

    def put(es: Iterable[Expr]) -> tuple[Expr, ...]:
        return tuple(substitute(e, lines, at.rank) for e in es)

    return replace(at, given=tuple(replace(a, args=put(a.args), also=put(a.also), exists=put(a.exists)) for a in left))


def _touching(a: Assumption, at: Context) -> str | None:
    """The letter that an assumption says to be the polar of a point on a conic or a quadric."""
    letter = named_letter(a.args[0]) if a.kind == "incident" else None
    if letter is None or at.letters.get(letter) != at.rank - 1:
        return None
    form = FORMS[at.rank]
    polars = (form.polar(Point(n), *form.own(name)) for name in at.conics for n in given_on(name, at))
    return letter if a.args[1] in polars else None


def _own(letter: str, at: Context) -> set[str]:
    return {*names_of(letter, at.letters[letter])}


def _gone(e: Expr, letter: str, polar: Mapping[str, Expr], at: Context) -> bool:
    return not _own(letter, at) & {*points_of(substitute(e, polar, at.rank))}


def _alike(e: Expr, letter: str, at: Context) -> bool:
    """Whether multiples of a letter make multiples of an expression, at random points."""
    points = random_points(points_of(e), rank=at.rank, seed=("multiples", letter, str(e)))
    first = names_of(letter, at.letters[letter])[0]
    other = {**points, first: tuple(2 * c for c in points[first])}
    one, two = (Evaluator(p, at.rank, PRIME).value(e) for p in (points, other))
    return normalized(one) == normalized(two)
