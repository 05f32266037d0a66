r"""Incidences of a figure: what they are, what they ask for, and which of them hold at a position.

Whole sets are found, not parts of them: all points of a line, all lines through a point. Of a set, the equations
compare each element with a few that span the rest and are independent at the position. They are enough. Wherever a
construction leads, points are polynomials in what is drawn; where these few are independent, the equations give that
all elements are incident, so any other condition of the set is a polynomial that vanishes on a dense set, and is zero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import combinations
from math import comb

from gcrules.algebra import expr as ex
from gcrules.algebra.conics import on_conic
from gcrules.algebra.discovery.figure import Figure, Position, Vector, minors, normalized
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.expr import Expr
from gcrules.algebra.scalars import bracket
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import cross, kernel, rank

__all__ = ["Incidence", "candidates", "incidences"]

_SIX = 6
_MOST_SIXES = 84  # six of nine points


@dataclass(frozen=True)
class Incidence:
    """`names` of points that coincide, or lie on a line, plane or conic ("equal", "collinear", "coplanar", "on_conic");
    of points and the line or plane, the last one, on which they lie ("incident"); `lines`, each told by a name or by
    two points on it, that pass through one point ("concurrent").
    """

    relation: str
    names: tuple[str, ...] = ()
    lines: tuple[tuple[str, ...], ...] = ()

    @property
    def size(self) -> int:
        """How many points and lines it is about."""
        return len(self.names) + len(self.lines)

    @property
    def involved(self) -> frozenset[str]:
        """The names that occur in it."""
        return frozenset((*self.names, *(n for line in self.lines for n in line)))

    def on_circle(self, figure: Figure) -> tuple[str, ...]:
        """The points of a circle, which is a conic through the isotropic points; none of other incidences."""
        far = figure.space.infinity.points if figure.space.infinity else ()
        circle = self.relation == "on_conic" and far and set(far) <= set(self.names)
        return tuple(n for n in self.names if n not in far) if circle else ()

    def equations(self, position: Position) -> tuple[Expr, ...]:
        """Expressions that all vanish wherever a construction leads that it holds for, if they do at its positions."""
        return tuple(_EQUATIONS[self.relation](self, position))

    def text(self, position: Position) -> str:
        """As it is written in scripts, if names bound by `let` are points there; of what is at infinity in words."""
        figure = position.figure
        far = set(figure.space.infinity.points) if figure.space.infinity else set()
        if on_circle := self.on_circle(figure):
            return f"concyclic({', '.join(on_circle)})"
        if self.relation == "concurrent" and len(self.lines) == 3 and far in map(set, self.lines):
            return f"parallel({', '.join(figure.written(line) for line in self.lines if set(line) != far)})"
        if self.relation == "equal":
            first, *others = self.names
            return ", ".join(f"{figure.written((first, other))} == 0" for other in others)
        if self.relation == "incident":
            return ", ".join(f"incident({n}, {self.names[-1]})" for n in self.names[:-1])
        shown = [*self.names, *(figure.written(line) for line in self.lines)]
        return f"{self.relation}({', '.join(shown)})"


# --- what is asked ---------------------------------------------------------------------------------------------------


def _equal(i: Incidence, position: Position) -> Iterator[Expr]:
    first, *others = i.names
    return (position.figure.joined([first, other]) for other in others)


def _incident(i: Incidence, position: Position) -> Iterator[Expr]:
    *names, flat = i.names
    figure = position.figure
    return (figure.joined([n, flat]) for n in names)


def _on_flat(i: Incidence, position: Position) -> Iterator[Expr]:
    step = 2 if i.relation == "collinear" else 3
    base = position.independent([n for n in i.names if n in position.vectors], step)
    for n in i.names:
        if n not in base:
            yield position.figure.joined([*base, n])


def _concurrent(i: Incidence, position: Position) -> Iterator[Expr]:
    figure = position.figure
    lines = [figure.meaning(line[0]) if len(line) == 1 else figure.joined(line) for line in i.lines]
    first, *rest = lines
    second = next((e for e in rest if not _one_line(first, e, position)), rest[0])
    for other in rest:
        if other is not second:
            if position.rank == 3:
                yield ex.meet(first, second, other, rank=3)
            else:
                yield from _in_space(first, second, other, position)


def _in_space(a: Expr, b: Expr, c: Expr, position: Position) -> Iterator[Expr]:
    """Any two of three lines meet; where they are in a plane, the point of two, told by a point off it, is on the third
    one.
    """
    yield from (bracket(ex.join(p, q, rank=4), rank=4) for p, q in ((a, b), (a, c), (b, c)))
    spanned = [*position.span(a), *position.span(b), *position.span(c)]
    if rank(spanned, PRIME) == 3:
        off = next(n for n, vector in position.drawn.items() if rank([*spanned, vector], PRIME) == 4)
        plane = ex.join(b, position.figure.meaning(off), rank=4)
        yield ex.join(ex.meet(a, plane, rank=4), c, rank=4)


def _one_line(a: Expr, b: Expr, position: Position) -> bool:
    return normalized(position.at.value(a)) == normalized(position.at.value(b))


def _conic(i: Incidence, position: Position) -> Iterator[Expr]:
    figure = position.figure
    known = [n for n in i.names if n in position.vectors]
    five = next((f for f in combinations(known, 5) if len(_conics_through(f, position)) == 1), None)
    if five is None:
        sixes = combinations(i.names, _SIX) if comb(len(i.names), _SIX) <= _MOST_SIXES else iter(())
    else:
        sixes = ((*five, n) for n in i.names if n not in five)
    for six in sixes:
        yield on_conic(*map(figure.meaning, six))


_EQUATIONS: Mapping[str, Callable[[Incidence, Position], Iterator[Expr]]] = {
    "equal": _equal,
    "incident": _incident,
    "collinear": _on_flat,
    "coplanar": _on_flat,
    "concurrent": _concurrent,
    "on_conic": _conic,
}


# --- what holds ------------------------------------------------------------------------------------------------------


def candidates(points: int, flats: int, rank: int) -> int:
    """How many sets of points and lines are looked at for so many points, and lines or planes with names."""
    lines = comb(points, 2) + flats
    return comb(points, 3) + comb(lines, 2) + (comb(points, 5) if rank == 3 else comb(points, 4))


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
    if position.rank != 3:
        return
    on_line = {three for names in _lines(position).values() for three in combinations(names, 3)}
    squares = {n: _squares(position.vectors[n]) for n in position.points}
    seen: list[frozenset[str]] = []
    for five in combinations(position.points, 5):
        checkpoint()
        if any(three in on_line for three in combinations(five, 3)) or any(s.issuperset(five) for s in seen):
            continue
        (conic,) = _conics_through(five, position)
        names = [n for n in position.points if not sum(map(int.__mul__, conic, squares[n])) % PRIME]
        if len(names) > 5:
            seen.append(frozenset(names))
            yield Incidence("on_conic", tuple(names))


def _squares(p: Vector) -> Vector:
    x, y, z = p
    return x * x % PRIME, y * y % PRIME, z * z % PRIME, x * y % PRIME, x * z % PRIME, y * z % PRIME


def _conics_through(five: Iterable[str], position: Position) -> list[Vector]:
    return kernel([_squares(position.vectors[n]) for n in five], 6, PRIME)


_HOLDING: Mapping[str, Callable[[Position], Iterator[Incidence]]] = {
    "equal": _same,
    "incident": _on_named,
    "collinear": _collinear,
    "concurrent": _through,
    "coplanar": _coplanar,
    "on_conic": _on_conics,
}
