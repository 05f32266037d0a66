r"""What is given of lines and quadrics, said as what it means: where a line touches, and that it is on the quadric.

A point of a line that is on the polar of this line too is conjugate to itself, and so on the quadric.

A line that has three different points in common with a quadric is on it. Its points are conjugate to each other, and
conversely points of a quadric that is no cone are on one line of it where all of them are conjugate to each other. Of
three such points two are said to be on the quadric and conjugate then, and the third to be on their line.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> at = parse_assumption("quadric Q, on_quadric(a, b, c, Q), collinear(a, b, c)", Context())
>>> found = on_lines(at, ["Q"])
>>> len(found.given), [str(e) for e in found.apart]
(4, ['ab', 'ac', 'bc'])
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Join, Point, points_of
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conics_of, named_letter
from gcrules.algebra.seats import conjugate, given_on
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.towers import polar_of_line
from gcrules.core.dataclass import dataclass

__all__ = ["OnLines", "on_lines"]

_SPACE = 4


@dataclass(frozen=True, slots=True)
class OnLines:
    """What is given, which is the same as before wherever the joins of `apart` do not vanish."""

    given: tuple[Assumption, ...]
    apart: tuple[Expr, ...] = ()


def on_lines(at: Space, letters: Iterable[str]) -> OnLines:
    """What is given in space, with what it means for three points of a quadric that they are on a line."""
    touched = _touched(at)
    given, apart = touched.given, dict.fromkeys(touched.apart)
    for letter in letters:
        often = Counter(n for a in given for n in points_of(*a.args))
        on = sorted(given_on(letter, replace(at, given=given)), key=lambda n: -often[n])
        for three in combinations(on, 3):
            found = _on_line(three, letter, replace(at, given=given))
            given = found.given
            apart |= dict.fromkeys(found.apart)
    return OnLines(given, tuple(apart))


def _touched(at: Space) -> OnLines:
    """With other words for points that are on a line and on the polar of this: they are on the quadric, and conjugate
    to another point of the line, which is one of the quadric where such a point is given.
    """
    given, apart = at.given, dict[Expr, None]()
    asked = [(q, other) for q, other, _ in _points_on_lines(at.given)]
    for p, polar, says in _points_on_lines(at.given):
        line = polar_of_line(polar)
        there = [(q, a) for q, other, a in _points_on_lines(given) if line in _both_ways(other)]
        lies = [a for q, a in there if q == p]
        if line is None or not lies or p.name in points_of(line):
            continue
        (letter,) = conics_of(points_of(polar))
        form, own, on = FORMS[_SPACE], FORMS[_SPACE].own(letter), given_on(letter, replace(at, given=given))
        first, second = map(Point, points_of(line))
        known = next((q for q, _ in there if q != p and (q.name in on or (q, polar) in asked)), None)
        given = tuple(a for a in given if a != says)
        if p.name not in on:
            given += (replace(says, kind="zero", args=(form.value(p, *own),), exists=()),)
        given += (replace(says, args=(known or first, form.polar(p, *own)), exists=()),)
        if known is None:
            given = tuple(a for a in given if a not in lies)
            given += (replace(lies[0], args=(second, ex.join(p, first, rank=_SPACE)), exists=()),)
        if named_letter(line) is None:
            apart[line] = None
        if known is not None or named_letter(line) is None:
            apart[ex.join(p, known or first, rank=_SPACE)] = None
    return OnLines(given, tuple(apart))


def _both_ways(line: Expr) -> tuple[Expr, ...]:
    """A join of two points, and the other way round."""
    args = line.args if isinstance(line, Join) else ()
    return (line, ex.join(*args[::-1], rank=_SPACE))


def _points_on_lines(given: Sequence[Assumption]) -> Iterator[tuple[Point, Expr, Assumption]]:
    """The points that are put on lines."""
    for a in given:
        for p, line in (a.args, a.args[::-1]) if a.kind == "incident" else ():
            if isinstance(p, Point) and line.step == 2:
                yield p, line, a


def _on_line(three: Sequence[str], letter: str, at: Space) -> OnLines:
    """The same for three points."""
    on = given_on(letter, at)
    if not on.keys() >= {*three}:
        return OnLines(at.given)
    pairs = {pair: conjugate(*pair, letter, at) for pair in combinations(three, 2)}
    line = next(_lines(three, at.given), None)
    if line is None and not all(pairs.values()):
        return OnLines(at.given)
    p, q = next((pair for pair, said in pairs.items() if said), three[:2])
    (third,) = {*three} - {p, q}
    left_out = {*on[third], *(a for pair, said in pairs.items() if third in pair for a in said)}
    given = [a for a in at.given if a not in left_out]
    if line is None:
        cause = next(a for a in at.given[::-1] if a in left_out and a.kind == "incident")
        given.append(replace(cause, args=(Point(third), _join(p, q))))
        return OnLines(tuple(given), (_join(p, q),))
    if pairs[p, q]:
        return OnLines(tuple(given), (_join(p, q), *line[1]))
    polar = FORMS[_SPACE].polar(Point(p), *FORMS[_SPACE].own(letter))
    given.append(replace(line[0], kind="incident", args=(Point(q), polar), also=(), exists=()))
    return OnLines(tuple(given), (*(_join(*pair) for pair in pairs), *line[1]))


def _join(p: str, q: str) -> Expr:
    return ex.join(Point(p), Point(q), rank=_SPACE)


def _lines(three: Sequence[str], given: Sequence[Assumption]) -> Iterator[tuple[Assumption, tuple[Expr, ...]]]:
    """The assumptions that put the last of three points on one line, each with the join that this is, if it is one of
    other points.
    """
    points = {*map(Point, three)}
    on: dict[Expr, set[Expr]] = {}
    for a in given:
        if a.kind == "collinear" and points <= {*a.args}:
            yield a, ()
        if a.kind == "zero" and a.args[0].step == 3 and isinstance(a.args[0], Join) and points == {*a.args[0].args}:
            yield a, ()
    for p, line, a in _points_on_lines(given):
        if p in points and isinstance(line, Join) and all(isinstance(e, Point) for e in line.args):
            there = on.setdefault(line, {*line.args})
            there.add(p)
            if points <= there:
                yield a, () if named_letter(line) is not None or points >= {*line.args} else (line,)
