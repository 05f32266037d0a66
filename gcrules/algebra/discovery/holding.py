r"""Which incidences of a figure hold at a position: of each kind the largest."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations
from math import comb

from gcrules.algebra.discovery.figure import Position, Vector, minors, normalized
from gcrules.algebra.discovery.incidences import Incidence, conics_through, squares
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.letter_forms import FORMS
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import cross, kernel, rank

__all__ = ["candidates", "incidences"]


def candidates(points: int, flats: int, rank: int, letters: int = 0) -> int:
    """How many sets of points and lines are looked at for so many points, lines or planes with names, and letters of
    conics or quadrics.
    """
    pairs = comb(points, 2)
    lines = pairs + flats
    of_letter = points + pairs + points * flats + (lines if rank == 3 else flats)
    more = comb(points, 5) if rank == 3 else comb(points, 4)
    return comb(points, 3) + comb(lines, 2) + more + letters * of_letter


def incidences(position: Position, relation: str) -> Iterator[Incidence]:
    """The largest incidences of this kind at a position. Those with points of which several are at one place name the
    first of them.
    """
    return _HOLDING[relation](position)


def _same(position: Position) -> Iterator[Incidence]:
    for first in position.points:
        names = [n for n, other in position.same.items() if other == first]
        if len(names) > 1:
            yield Incidence("equal", tuple(names))


def _on_named(position: Position) -> Iterator[Incidence]:
    figure = position.figure
    for flat in position.flats:
        value, step = position.at.value(figure.meaning(flat)), figure.meaning(flat).step
        on = [n for n in position.points if not any(position.at.joined([*position.vectors[n]], 1, value, step))]
        if on:
            yield Incidence("incident", (*on, flat))


def _lines(position: Position) -> dict[Vector, tuple[str, ...]]:
    """All points on each line through two of them."""
    found: dict[Vector, dict[str, None]] = {}
    for a, b in combinations(position.points, 2):
        checkpoint()
        line = normalized(minors((position.vectors[a], position.vectors[b])))
        found.setdefault(line, {}).update({a: None, b: None})
    order = {n: k for k, n in enumerate(position.points)}
    return {line: tuple(sorted(names, key=order.__getitem__)) for line, names in found.items()}


def _collinear(position: Position) -> Iterator[Incidence]:
    return (Incidence("collinear", names) for names in _lines(position).values() if len(names) > 2)


def _coplanar(position: Position) -> Iterator[Incidence]:
    """Planes, but for those of a line and one more point, which are no news."""
    if position.rank != 4:
        return
    seen: set[frozenset[str]] = set()
    lines = [set(names) for names in _lines(position).values() if len(names) > 2]
    for some in combinations(position.points, 3):
        checkpoint()
        if position.dimension(some) < 3 or any(plane.issuperset(some) for plane in seen):
            continue
        plane = [n for n in position.points if position.dimension([*some, n]) == 3]
        if len(plane) > 3:
            seen.add(frozenset(plane))
            if not any(len(line.intersection(plane)) >= len(plane) - 1 for line in lines):
                yield Incidence("coplanar", tuple(plane))


def _through(position: Position) -> Iterator[Incidence]:
    """Three lines or more through a point that has no name."""
    figure = position.figure
    if rank(list(position.drawn.values()), PRIME) < position.rank:
        return iter(())
    lines: list[tuple[tuple[str, ...], tuple[Vector, ...]]] = []
    named = {tuple(normalized(position.at.value(e))): n for n in position.flats if (e := figure.meaning(n)).step == 2}
    for key, names in _lines(position).items():
        own = (named.pop(key),) if key in named else names[:2]
        lines.append((own, (position.vectors[names[0]], position.vectors[names[1]])))
    lines += (((n,), position.span(figure.meaning(n))) for n in named.values())
    places = set(position.vectors.values())
    found: dict[Vector, dict[tuple[str, ...], None]] = {}
    for (one, a), (other, b) in combinations(lines, 2):
        checkpoint()
        met = _meet(a, b, position.rank)
        if met is not None and met not in places:
            found.setdefault(met, {}).update({one: None, other: None})
    return (Incidence("concurrent", (), tuple(some)) for some in found.values() if len(some) > 2)


def _meet(a: Sequence[Vector], b: Sequence[Vector], dimension: int) -> Vector | None:
    if dimension == 3:
        return normalized(cross(cross(*a), cross(*b)))
    rows = list(zip(*a, *b, strict=True))
    together = kernel(rows, 4, PRIME)
    if len(together) != 1:
        return None
    s, t, *_ = together[0]
    return normalized([s * x + t * y for x, y in zip(*a, strict=True)])


def _on_conics(position: Position) -> Iterator[Incidence]:
    """Conics through five points; those that have letters come first, with fewer points too."""
    if position.rank != 3:
        return
    with_letters = list(_on_letters(position))
    yield from with_letters
    on_line = {three for names in _lines(position).values() for three in combinations(names, 3)}
    products = {n: squares(position.vectors[n]) for n in position.points}
    seen = [frozenset(i.names) for i in with_letters]
    for five in combinations(position.points, 5):
        checkpoint()
        if any(three in on_line for three in combinations(five, 3)) or any(s.issuperset(five) for s in seen):
            continue
        (conic,) = conics_through(five, position)
        names = [n for n in position.points if not sum(map(int.__mul__, conic, products[n])) % PRIME]
        if len(names) > 5:
            seen.append(frozenset(names))
            yield Incidence("on_conic", tuple(names))


# --- of conics and quadrics with letters -----------------------------------------------------------------------------


def _on_letters(position: Position) -> Iterator[Incidence]:
    """All points on each conic or quadric."""
    form, figure = FORMS[position.rank], position.figure
    for letter in figure.space.conics:
        own = form.own(letter)
        on = [n for n in position.points if position.zero(form.value(figure.meaning(n), *own))]
        if on:
            yield Incidence(f"on_{form.word}", tuple(on), letter=letter)


def _touching(position: Position) -> Iterator[Incidence]:
    """Lines and planes with names that touch, and in the plane lines through two points."""
    form, figure = FORMS[position.rank], position.figure
    told: list[tuple[str, ...]] = [(n,) for n in position.flats]
    if position.rank == 3:
        named = {normalized(position.at.value(figure.meaning(n))) for n in position.flats}
        told += (names[:2] for key, names in _lines(position).items() if key not in named)
    for letter in figure.space.conics:
        for line in told:
            checkpoint()
            if position.zero(form.touching(figure.line(line), *form.own(letter))):
                yield Incidence("touches", (), (line,), letter)


def _poles(position: Position) -> Iterator[Incidence]:
    """Points with lines or planes that have names and are their polars."""
    figure = position.figure
    values = {n: normalized(position.at.value(figure.meaning(n))) for n in position.flats}
    for letter, p, polar in _polars(position):
        for flat, value in values.items():
            if figure.meaning(flat).step == position.rank - 1 and normalized(polar) == value:
                yield Incidence("polar", (p, flat), letter=letter)


def _conjugates(position: Position) -> Iterator[Incidence]:
    """All points on the polar of each."""
    for letter, p, polar in _polars(position):
        checkpoint()
        on = [n for n in position.points if not any(_joined(position, n, polar))]
        if others := tuple(n for n in on if n != p):
            yield Incidence("conjugate", (*others, p), letter=letter)


def _joined(position: Position, name: str, hyperplane: Sequence[int]) -> Sequence[int]:
    return position.at.joined([*position.vectors[name]], 1, [*hyperplane], position.rank - 1)


def _polars(position: Position) -> Iterator[tuple[str, str, Sequence[int]]]:
    """Each letter, each point and the value of its polar."""
    form, figure = FORMS[position.rank], position.figure
    for letter in figure.space.conics:
        for p in position.points:
            yield letter, p, position.at.value(form.polar(figure.meaning(p), *form.own(letter)))


_HOLDING: Mapping[str, Callable[[Position], Iterator[Incidence]]] = {
    "equal": _same,
    "incident": _on_named,
    "collinear": _collinear,
    "concurrent": _through,
    "coplanar": _coplanar,
    "on_conic": _on_conics,
    "on_quadric": lambda position: _on_letters(position) if position.rank == 4 else iter(()),
    "touches": _touching,
    "polar": _poles,
    "conjugate": _conjugates,
}
