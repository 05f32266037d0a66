r"""Incidences of a figure: what they are, and what they ask for.

Whole sets are meant, not parts of them: all points of a line, all lines through a point. Of a set, the equations
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
from gcrules.algebra.discovery.figure import Figure, Position, Vector, normalized
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.letter_forms import FORMS, LetterForm
from gcrules.algebra.scalars import bracket
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import kernel, rank

__all__ = ["Incidence", "conics_through", "squares"]

_SIX = 6
_MOST_SIXES = 84  # six of nine points


@dataclass(frozen=True)
class Incidence:
    """`names` of points that coincide, or lie on a line, plane or conic ("equal", "collinear", "coplanar", "on_conic");
    of points and the line or plane, the last one, on which they lie ("incident"); `lines`, each told by a name or by
    two points on it, that pass through one point ("concurrent").

    Of the `letter` of a conic or a quadric points may be on it ("on_conic", "on_quadric"), lie on the polar of the last
    one ("conjugate"), or a point be the pole of the line or plane behind it ("polar"); one of the `lines`, which may be
    a plane with a name, may touch it ("touches").
    """

    relation: str
    names: tuple[str, ...] = ()
    lines: tuple[tuple[str, ...], ...] = ()
    letter: str = ""

    @property
    def size(self) -> int:
        """How many points and lines it is about."""
        return len(self.names) + len(self.lines)

    @property
    def involved(self) -> frozenset[str]:
        """The names that occur in it."""
        letter = (self.letter,) if self.letter else ()
        return frozenset((*self.names, *(n for line in self.lines for n in line), *letter))

    def on_circle(self, figure: Figure) -> tuple[str, ...]:
        """The points of a circle, which is a conic through the isotropic points; none of other incidences."""
        far = figure.space.infinity.points if figure.space.infinity else ()
        circle = self.relation == "on_conic" and not self.letter and far and set(far) <= set(self.names)
        return tuple(n for n in self.names if n not in far) if circle else ()

    def equations(self, position: Position) -> tuple[Expr, ...]:
        """Expressions that all vanish wherever a construction leads that it holds for, if they do at its positions."""
        return tuple(self._equations(position, position.figure))

    def expressions(self, position: Position) -> tuple[str, ...]:
        """The same as texts: in the points of the script, or where there are conics or quadrics in its names."""
        figure = position.figure
        if self.letter:
            return tuple(_OF_LETTERS[self.relation].texts(self, figure))
        if not figure.space.conics:
            return tuple(text(e, names=figure.space.declared()) for e in self.equations(position))
        return tuple(text(e, names=figure.space.declared()) for e in self._equations(position, figure.named))

    def _equations(self, position: Position, figure: Figure) -> Iterator[Expr]:
        if self.letter:
            form = FORMS[position.rank]
            return _OF_LETTERS[self.relation].equations(self, figure, form, form.own(self.letter))
        return _EQUATIONS[self.relation](self, position, figure)

    def text(self, position: Position) -> str:
        """As it is written in scripts, if names bound by `let` are points there; of what is at infinity in words."""
        figure = position.figure
        far = set(figure.space.infinity.points) if figure.space.infinity else set()
        if self.letter:
            return ", ".join(_OF_LETTERS[self.relation].claims(self, figure))
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


def _equal(i: Incidence, position: Position, figure: Figure) -> Iterator[Expr]:
    first, *others = i.names
    return (figure.joined([first, other]) for other in others)


def _incident(i: Incidence, position: Position, figure: Figure) -> Iterator[Expr]:
    *names, flat = i.names
    return (figure.joined([n, flat]) for n in names)


def _on_flat(i: Incidence, position: Position, figure: Figure) -> Iterator[Expr]:
    step = 2 if i.relation == "collinear" else 3
    base = position.independent([n for n in i.names if n in position.vectors], step)
    for n in i.names:
        if n not in base:
            yield figure.joined([*base, n])


def _concurrent(i: Incidence, position: Position, figure: Figure) -> Iterator[Expr]:
    first, *rest = i.lines
    second = next((line for line in rest if not _one_line(first, line, position)), rest[0])
    for other in rest:
        if other is not second:
            if position.rank == 3:
                yield ex.meet(*map(figure.line, (first, second, other)), rank=3)
            else:
                yield from _in_space((first, second, other), position, figure)


def _in_space(three: Sequence[tuple[str, ...]], position: Position, figure: Figure) -> Iterator[Expr]:
    """Any two of three lines meet; where they are in a plane, the point of two, told by a point off it, is on the third
    one.
    """
    a, b, c = map(figure.line, three)
    yield from (bracket(ex.join(p, q, rank=4), rank=4) for p, q in ((a, b), (a, c), (b, c)))
    spanned = [v for line in three for v in position.span(position.figure.line(line))]
    if rank(spanned, PRIME) == 3:
        points = {n: position.vectors[n] for n in position.points} | position.drawn
        off = next(n for n, vector in points.items() if rank([*spanned, vector], PRIME) == 4)
        plane = ex.join(b, figure.meaning(off), rank=4)
        yield ex.join(ex.meet(a, plane, rank=4), c, rank=4)


def _one_line(a: tuple[str, ...], b: tuple[str, ...], position: Position) -> bool:
    one, other = (normalized(position.at.value(position.figure.line(line))) for line in (a, b))
    return one == other


def _conic(i: Incidence, position: Position, figure: Figure) -> Iterator[Expr]:
    known = [n for n in i.names if n in position.vectors]
    five = next((f for f in combinations(known, 5) if len(conics_through(f, position)) == 1), None)
    if five is None:
        sixes = combinations(i.names, _SIX) if comb(len(i.names), _SIX) <= _MOST_SIXES else iter(())
    else:
        sixes = ((*five, n) for n in i.names if n not in five)
    for six in sixes:
        yield on_conic(*map(figure.meaning, six))


def conics_through(five: Iterable[str], position: Position) -> list[Vector]:
    """The conics through points at a position, each by the coefficients of x², y², z², xy, xz and yz."""
    return kernel([squares(position.vectors[n]) for n in five], 6, PRIME)


def squares(p: Vector) -> Vector:
    """The products x², y², z², xy, xz and yz of the coordinates of a point."""
    x, y, z = p
    return x * x % PRIME, y * y % PRIME, z * z % PRIME, x * y % PRIME, x * z % PRIME, y * z % PRIME


_EQUATIONS: Mapping[str, Callable[[Incidence, Position, Figure], Iterator[Expr]]] = {
    "equal": _equal,
    "incident": _incident,
    "collinear": _on_flat,
    "coplanar": _on_flat,
    "concurrent": _concurrent,
    "on_conic": _conic,
}


# --- of letters ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _OfLetter:
    """A relation to a conic or a quadric: what it asks for, that as texts in words, and the claims of it."""

    equations: Callable[[Incidence, Figure, LetterForm, tuple[Expr, ...]], Iterator[Expr]]
    texts: Callable[[Incidence, Figure], Iterable[str]]
    claims: Callable[[Incidence, Figure], Iterable[str]]


def _on(i: Incidence, figure: Figure, form: LetterForm, own: tuple[Expr, ...]) -> Iterator[Expr]:
    return (form.value(figure.meaning(n), *own) for n in i.names)


def _on_texts(i: Incidence, figure: Figure) -> Iterable[str]:
    return (f"{FORMS[figure.rank].word}({n}, {i.letter})" for n in i.names)


def _on_claims(i: Incidence, figure: Figure) -> Iterable[str]:
    word = i.relation if len(i.names) > 1 else "incident"
    return [f"{word}({', '.join((*i.names, i.letter))})"]


def _touching(i: Incidence, figure: Figure, form: LetterForm, own: tuple[Expr, ...]) -> Iterator[Expr]:
    return (form.touching(figure.line(line), *own) for line in i.lines)


def _touching_texts(i: Incidence, figure: Figure) -> Iterable[str]:
    for line in i.lines:
        step = figure.line(line).step
        word, told = "pole" if step == figure.rank - 1 else "polar", figure.written(line)
        yield f"[{', '.join(line)}, {word}({told}, {i.letter})]"


def _touching_claims(i: Incidence, figure: Figure) -> Iterable[str]:
    return (f"touches({figure.written(line)}, {i.letter})" for line in i.lines)


def _conjugate(i: Incidence, figure: Figure, form: LetterForm, own: tuple[Expr, ...]) -> Iterator[Expr]:
    *names, p = i.names
    polar = form.polar(figure.meaning(p), *own)
    return (bracket(figure.meaning(n), polar, rank=figure.rank) for n in names)


def _conjugate_texts(i: Incidence, figure: Figure) -> Iterable[str]:
    return (f"[{n}, polar({i.names[-1]}, {i.letter})]" for n in i.names[:-1])


def _conjugate_claims(i: Incidence, figure: Figure) -> Iterable[str]:
    return (f"incident({n}, polar({i.names[-1]}, {i.letter}))" for n in i.names[:-1])


def _pole(i: Incidence, figure: Figure, form: LetterForm, own: tuple[Expr, ...]) -> Iterator[Expr]:
    p, flat = map(figure.meaning, i.names)
    yield ex.meet(form.polar(p, *own), flat, rank=figure.rank)


def _pole_texts(i: Incidence, figure: Figure) -> Iterable[str]:
    return [f"polar({i.names[0]}, {i.letter}) /\\ {i.names[1]}"]


def _pole_claims(i: Incidence, figure: Figure) -> Iterable[str]:
    return [f"incident({i.names[1]}, polar({i.names[0]}, {i.letter}))"]


_OF_LETTERS: Mapping[str, _OfLetter] = {
    "on_conic": _OfLetter(_on, _on_texts, _on_claims),
    "on_quadric": _OfLetter(_on, _on_texts, _on_claims),
    "touches": _OfLetter(_touching, _touching_texts, _touching_claims),
    "polar": _OfLetter(_pole, _pole_texts, _pole_claims),
    "conjugate": _OfLetter(_conjugate, _conjugate_texts, _conjugate_claims),
}
