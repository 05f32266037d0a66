r"""What a script draws: its points, its letters for lines and planes, and what is named by `let`, at a random position.

>>> from gcrules.algebra.language.statements import parse_script
>>> figure = figure_of(parse_script("rank 3  let x = ab /\\ cd  let l = xa  claim ab == -ba").context)
>>> figure.points, figure.flats
(('a', 'b', 'c', 'd', 'x'), ('l',))
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import field, replace
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.linear import is_extensor
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.evaluate import PRIME, Evaluator, vanishes
from gcrules.algebra.expr import Expr, Point, points_of
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import SHORT_NAME, text
from gcrules.algebra.letters import conic_points, conics_of, letter, marked
from gcrules.algebra.scalars import bracket
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import kernel, rank

__all__ = ["Figure", "Position", "Vector", "figure_of", "minors", "normalized"]

Vector = tuple[int, ...]


@dataclass(frozen=True)
class Figure:
    """The names of `points` in tableau order, those bound by `let` last, and of lines and planes (`flats`); `bound`
    says what a name means. Drawn at random are `own`: the points that are not bound, and those that letters join.
    """

    space: Context
    own: tuple[str, ...]
    points: tuple[str, ...]
    flats: tuple[str, ...]
    bound: Mapping[str, Expr] = field(default=FrozenMap())

    @property
    def rank(self) -> int:
        return self.space.rank

    def meaning(self, name: str) -> Expr:
        """What a name stands for, in the user's points."""
        return self.bound.get(name) or Point(name)

    def joined(self, names: Sequence[str]) -> Expr:
        """The join of what names stand for, a bracket where it is a scalar."""
        found = ex.join(*map(self.meaning, names), rank=self.rank)
        return bracket(found, rank=self.rank) if found.step == self.rank else found

    def line(self, names: Sequence[str]) -> Expr:
        """A line, or a plane, that is given by its name or by points on it."""
        return self.meaning(names[0]) if len(names) == 1 else self.joined(names)

    @property
    def named(self) -> Figure:
        """The figure in which names stand for themselves, as they are written in scripts."""
        bound = {n: Point(n) if e.step == 1 else letter(n, e.step) for n, e in self.bound.items()}
        return replace(self, bound=FrozenMap(bound))

    def required(self, names: Collection[str], finite: Collection[str]) -> Mapping[str, str]:
        """What the words that made points, lines and planes are taken to have made, as texts with their meanings; of
        some points that they are finite.
        """
        at, told = self.space, dict[str, str]()
        weighed = [n for n in self.points if n in finite and n in self.bound and self.bound[n] not in at.finite]
        for n in (n for n in self.bound if n in names):
            told |= {r.text: r.meaning for r in at.required.get(n, ()) if n not in weighed or r.expr != self.bound[n]}
        far = at.infinity.points if at.infinity else ()
        return told | {f"[{', '.join((n, *far))}]": f"{n} is finite" for n in weighed}

    def written(self, names: Sequence[str]) -> str:
        """Their join as text, in which the names bound by `let` are names of points."""
        return text(ex.join(*map(Point, names), rank=max(self.rank, len(names))), names=(*self.points, *self.flats))


def figure_of(at: Context) -> Figure:
    """The figure that a script draws."""
    used = [*at.points, *at.ideal]
    used += (n for a in at.given for e in a.args for n in points_of(e))
    letters = {n: letter(n, step, at.screws) for n, step in at.letters.items()}
    bound = letters | {n: e for n, e in at.bound.items() if not isinstance(e, Point)}
    used += (n for e in bound.values() for n in points_of(e))
    used += (n for name in at.conics for n in conic_points(name, at.rank))
    own = tableau_order(used, at.points, at.ideal)
    points = [n for n, e in bound.items() if e.step == 1]
    flats = [n for n, e in bound.items() if 1 < e.step < at.rank and _is_flat(e, at.rank)]
    kept = FrozenMap((n, bound[n]) for n in (*points, *flats))
    written = {*at.points, *at.ideal}
    named = (n for n in own if not marked(n) and (n in written or SHORT_NAME.fullmatch(n)))
    return Figure(at, own, (*named, *points), tuple(flats), kept)


def _is_flat(e: Expr, rank: int) -> bool:
    """Whether it is a line or a plane wherever it is not zero, as polar lines of space are."""
    if is_extensor(e, rank):
        return True
    return bool(conics_of(points_of(e))) and vanishes(bracket(e, e, rank=rank), rank=rank)


class Position:
    """The figure at points modulo `PRIME`, of which `drawn` are the coordinates. `points` are those that are not zero
    there, one for each place; `same` says which name stands for a name at its place, `vanishing` which names stand for
    zero.
    """

    def __init__(self, figure: Figure, values: Mapping[str, Sequence[int]]) -> None:
        self.figure, self.rank = figure, figure.rank
        self.at = Evaluator(values, self.rank, PRIME)
        self.drawn = {n: normalized(self.at.value(Point(n))) for n in figure.own}
        self.vectors: dict[str, Vector] = {}
        self.same: dict[str, str] = {}
        first: dict[Vector, str] = {}
        vanishing = []
        for name in figure.points:
            vector = normalized(self.at.value(figure.meaning(name)))
            if not any(vector):
                vanishing.append(name)
                continue
            self.vectors[name] = vector
            self.same[name] = first.setdefault(vector, name)
        vanishing += (n for n in figure.flats if not any(self.at.value(figure.meaning(n))))
        self.vanishing = frozenset(vanishing)
        self.points = tuple(n for n, other in self.same.items() if n == other)
        self.flats = tuple(n for n in figure.flats if n not in self.vanishing)

    def zero(self, e: Expr) -> bool:
        return not any(self.at.value(e))

    def span(self, e: Expr) -> tuple[Vector, ...]:
        """A basis of the points of an extensor: those whose join with it is zero."""
        value = self.at.value(e)
        units = [tuple(int(i == j) for j in range(self.rank)) for i in range(self.rank)]
        columns = [self.at.joined(list(u), 1, value, e.step) for u in units]
        return tuple(kernel(zip(*columns, strict=True), self.rank, PRIME))

    def dimension(self, names: Iterable[str]) -> int:
        """The rank of points."""
        return rank([self.vectors[n] for n in names], PRIME)

    def independent(self, names: Iterable[str], most: int) -> tuple[str, ...]:
        """The first of the points that are independent, no more than `most`."""
        found: list[str] = []
        for n in names:
            if len(found) < most and self.dimension([*found, n]) > len(found):
                found.append(n)
        return tuple(found)


def normalized(vector: Sequence[int]) -> Vector:
    """The multiple whose first entry that is not 0 is 1, modulo `PRIME`."""
    lead = next((c for c in vector if c % PRIME), 0)
    factor = pow(lead, -1, PRIME) if lead else 0
    return tuple(c * factor % PRIME for c in vector)


def minors(rows: Sequence[Vector]) -> Vector:
    """The 2 × 2 minors of two rows: the Plücker coordinates of a line."""
    a, b = rows
    return tuple((a[i] * b[j] - a[j] * b[i]) % PRIME for i, j in combinations(range(len(a)), 2))
