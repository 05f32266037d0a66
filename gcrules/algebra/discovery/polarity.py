r"""What is known of a conic or a quadric with a letter: which points are on it, and which are conjugate.

Each point has its polar, a line or in space a plane, and each of these is the polar of its pole, which need not have a
name. What is concluded are the steps that everybody takes in mind:

* a point that is on the polar of another one has this on its own polar;
* a point is on the conic or quadric where it is on its own polar, and conversely;
* a line meets it in two points: what is on both at one place is one point.

So the tangents at two points meet in the pole of their line, a tangent touches where it is said to, and the polars of
points of a line have its pole in common.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import combinations, permutations

from gcrules.algebra import expr as ex
from gcrules.algebra.discovery.figure import Position, Vector, normalized
from gcrules.algebra.discovery.flats import Flat
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Point, points_of, subexpressions
from gcrules.algebra.letter_forms import FORMS, polar_of
from gcrules.algebra.letters import conics_of, marked
from gcrules.core.linear_algebra import kernel, rank

__all__ = ["Polarity"]

_LINE = 2
_POLE = "~pole"  # begins the names of poles that nothing in the figure names, and comes behind all others


class Polarity:
    """Of one letter at a position: the names of points that are `on` it, and of points with `polars` the flats that are
    known to be these; `lines` are lines of space with their polar lines.
    """

    def __init__(self, letter: str, position: Position) -> None:
        self.letter, self.position, self.rank = letter, position, position.rank
        self.form = FORMS[position.rank]
        self.own = self.form.own(letter)
        self.on: set[str] = set()
        self.polars: dict[str, list[Flat]] = {}
        self.poles: dict[Flat, str] = {}
        self.lines: list[tuple[Flat, Flat]] = []
        self._matrix = self._bilinear()
        self._of: dict[Expr, Expr | None] = {}

    def _bilinear(self) -> tuple[Vector, ...]:
        """The rows of the bilinear form: the polar of x is their product with x."""
        units = [Point(f"unit {i}") for i in range(self.rank)]
        own = {p.name: self.position.at.value(p) for p in self.own}
        basis = {u.name: tuple(int(i == k) for k in range(self.rank)) for i, u in enumerate(units)}
        at = Evaluator({**own, **basis}, self.rank, PRIME)
        polars = [self.form.polar(u, *self.own) for u in units]
        return tuple(tuple(at.value(ex.join(x, polar, rank=self.rank))[0] for x in units) for polar in polars)

    # --- what words mean ---------------------------------------------------------------------------------------------

    def made_on(self, e: Expr) -> bool:
        """Whether a word has made the point on the conic or quadric."""
        return self.form.value(e, *self.own) in self.position.figure.space.on_conics

    def point_on(self, e: Expr) -> Expr | None:
        """The point that a scalar puts on it where it vanishes."""
        return next((p for p in self._points(e) if self.form.value(p, *self.own) == e), None)

    def polar_of(self, e: Expr) -> Expr | None:
        """What a point, a line or a plane is the polar or the pole of, by the words that made it."""
        if e not in self._of:
            about = self.letter in conics_of(points_of(e)) and 0 < e.step < self.rank
            self._of[e] = next((of for of in self._parts(e) if self._is_polar(e, of)), None) if about else None
        return self._of[e]

    def _is_polar(self, e: Expr, of: Expr) -> bool:
        return polar_of(of, self.own, self.rank)[1] in (e, ex.neg(e))

    def _parts(self, e: Expr) -> Iterator[Expr]:
        """What it may be the polar of: parts of it, what has a name, and joins of both."""
        step = self.rank - e.step
        bound = self.position.figure.bound.values()
        yield from dict.fromkeys(p for p in (*bound, *subexpressions(e)) if p.step == step and p not in self.own)
        if step > 1:
            for some in combinations(self._points(e), step):
                for order in permutations(some):
                    yield ex.join(*order, rank=self.rank)

    def _points(self, e: Expr) -> Iterator[Expr]:
        """The points of an expression, and those that have names."""
        bound = (p for p in self.position.figure.bound.values() if p.step == 1)
        yield from dict.fromkeys((*(Point(n) for n in points_of(e) if not marked(n)), *bound))

    # --- points and their polars -------------------------------------------------------------------------------------

    def polar(self, name: str, vector: Vector, flats: list[Flat]) -> Flat:
        """The polar of a point, one of the flats from now on."""
        if name not in self.polars:
            covector = [sum(a * b for a, b in zip(row, vector, strict=True)) % PRIME for row in self._matrix]
            found = Flat(tuple(kernel([covector], self.rank, PRIME)), letter=self.letter)
            self.polars[name], self.poles[found] = [found], name
            flats.append(found)
        return self.polars[name][0]

    def is_polar(self, name: str, flat: Flat) -> None:
        """Let a flat be known to be the polar of a point."""
        self.polars.setdefault(name, []).append(flat)
        self.poles.setdefault(flat, name)

    def pole(self, flat: Flat, vectors: dict[str, Vector]) -> str:
        """The name of the pole of a line of the plane, or a plane of space."""
        if flat not in self.poles:
            (covector,) = kernel(flat.span, self.rank, PRIME)
            (found,) = kernel([(*row, c) for row, c in zip(self._matrix, covector, strict=True)], self.rank + 1, PRIME)
            name = f"{_POLE} {len(self.poles)} for {self.letter}"
            vectors[name] = normalized(found[:-1])
            self.is_polar(name, flat)
        return self.poles[flat]

    # --- what follows ------------------------------------------------------------------------------------------------

    def conclude(
        self, vectors: dict[str, Vector], flats: list[Flat], name: Callable[[str], str]
    ) -> tuple[tuple[str, str], ...]:
        """Take each step once; the names of points that are seen to be one."""
        for f in tuple(flats):
            if f.step == self.rank - 1 and f.letter in ("", self.letter):
                self.pole(f, vectors)
        for n in tuple(vectors):
            if not n.startswith(_POLE):
                self.polar(n, vectors[n], flats)
        self.on = {name(n) for n in self.on}
        for n in tuple(self.polars):
            self._share(n, name(n))
        for n, (first, *_) in self.polars.items():
            for polar in self._of_members(first):
                polar.members.add(name(n))
            if name(n) in first.members:
                self.on.add(name(n))
        for n in self.on:
            self.polars[n][0].members.add(n)
        for f, other in (*self.lines, *(pair[::-1] for pair in self.lines)):
            polars = self._of_members(f)
            for polar in polars:
                polar.members |= other.members
            if rank([vectors[q] for q in f.members], PRIME) == _LINE:
                other.members |= set.intersection(*(polar.members for polar in polars))
        return (*self._poles(vectors, name), *self._one(flats, vectors))

    def _of_members(self, flat: Flat) -> list[Flat]:
        """The polars of the points that are known to lie on a flat."""
        return [self.polars[q][0] for q in flat.members if q in self.polars]

    def _share(self, one: str, other: str) -> None:
        """Two names of one point have one polar; so have the flats that are known to be it."""
        shared = (*self.polars[one], *self.polars.setdefault(other, self.polars[one]))
        members = set().union(*(f.members for f in shared))
        for f in shared:
            f.members |= members

    def _poles(self, vectors: dict[str, Vector], name: Callable[[str], str]) -> Iterator[tuple[str, str]]:
        """Names of one pole: of one flat, or of flats that are known to be one."""
        for n, flats in self.polars.items():
            yield from ((self.poles[f], n) for f in flats if name(self.poles[f]) != name(n))
        first: dict[Vector, Flat] = {}
        for f, n in self.poles.items():
            g = first.setdefault(normalized(vectors[n]), f)
            known = f.members & g.members
            if name(n) != name(self.poles[g]) and rank([vectors[q] for q in known], PRIME) == self.rank - 1:
                yield n, self.poles[g]

    def _one(self, flats: Iterable[Flat], vectors: dict[str, Vector]) -> Iterator[tuple[str, str]]:
        for f in flats:
            if f.step == _LINE:
                first: dict[Vector, str] = {}
                for n in sorted(f.members & self.on):
                    if (other := first.setdefault(normalized(vectors[n]), n)) != n:
                        yield other, n

    @property
    def extent(self) -> int:
        """How much is known, besides the members of flats."""
        return len(self.on) + sum(map(len, self.polars.values()))

    # --- what is asked -----------------------------------------------------------------------------------------------

    def touches(self, flat: Flat, inside: Iterable[tuple[Flat, Flat]], name: Callable[[str], str]) -> bool:
        """Whether a line or a plane is known to touch: its pole is on it, or in space a line, or its polar, is in the
        tangent plane at a point of it. What is known to be `inside` what is told.
        """
        if flat.step == self.rank - 1:
            return flat in self.poles and name(self.poles[flat]) in self.on
        around = {name(self.poles[g]) for f, g in inside if f is flat and g in self.poles}
        if around & flat.members & self.on:
            return True
        alike = (flat, *(g for pair in self.lines if flat in pair for g in pair))
        return any(
            len(f.members) > 1 and f.members <= self.polars[n][0].members for f in alike for n in f.members & self.on
        )
