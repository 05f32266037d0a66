"""A figure as it is placed: points that are given on conics and quadrics in place of those of their letters, polars in
place of letters that touch them, and what that assumes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.algebra.assumptions.assumed import PositionKind, kinds
from gcrules.algebra.assumptions.nondegeneracy import met
from gcrules.algebra.discovery.figure import Figure, Position
from gcrules.algebra.discovery.tangents import tangents, without
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import ZERO, Expr, Point, points_of
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import marked, marks_in, names_of
from gcrules.algebra.parts import substitute
from gcrules.algebra.seated import Seated, in_words, seated
from gcrules.core.dataclass import dataclass
from gcrules.core.linear_algebra import kernel

__all__ = ["Placement", "placement"]


@dataclass(frozen=True)
class Placement:
    """A figure whose letters `lines` are replaced by polars, with points as they are `seated`; what is left to be
    placed are the points `drawn`.
    """

    figure: Figure
    lines: Mapping[str, Expr]
    seated: Seated
    drawn: tuple[str, ...]

    @property
    def nonzero(self) -> tuple[Expr, ...]:
        """What vanishes at none of the positions that count."""
        return (*self.seated.claimed.nonzero, *(e for a in self.seated.space.given for e in a.exists))

    def kinds(self) -> list[PositionKind]:
        """The kinds of positions that the assumptions allow. Raises InputError where they are not resolved."""
        with in_words(self.seated, self.figure.space.conics, self.figure.space.given):
            return met(kinds(self.seated.space, self.drawn), self.nonzero)

    def put(self, e: Expr) -> Expr:
        """An expression of the figure in the points that are placed."""
        return self.seated.put(substitute(e, self.lines, self.figure.rank))

    def condition(self, e: Expr) -> str:
        """The text of what vanishes, in words about conics and quadrics where there are any."""
        spoken = self.seated.spoken(e)
        return spoken[0] if spoken is not None else text(e, names=self.figure.space.declared())

    def written(self, e: Expr) -> Expr:
        """What vanishes, as it is written in words where it can be: so it is known what it says."""
        shown = self.condition(e)
        names = {n for n in points_of(e) if not marked(n)}
        if not self.figure.space.conics or marks_in(shown) or not names.issubset(self.figure.points):
            return e
        return parse(shown, context=self.figure.space)

    def position(self, drawn: Mapping[str, Sequence[int]]) -> Position:
        """The figure where these points are."""
        rank = self.figure.rank
        values = {**drawn, **{own: drawn[p] for own, p in self.seated.places.items()}}
        at = Evaluator(values, rank, PRIME)
        for letter, polar in self.lines.items():
            value = at.value(polar)
            units = [tuple(int(i == j) for j in range(rank)) for i in range(rank)]
            covector = [at.joined([*u], 1, value, rank - 1)[0] for u in units]
            values |= dict(zip(names_of(letter, rank - 1), kernel([covector], rank, PRIME), strict=True))
        return Position(self.figure, values)


def placement(figure: Figure) -> Placement:
    """How a figure is placed. Raises InputError where a letter cannot be."""
    at, bound = figure.space, tuple(figure.bound.values())
    lines = tangents(at, bound)
    hidden = {n for letter in lines for n in names_of(letter, at.rank - 1)}
    own = tuple(n for n in figure.own if n not in hidden)
    meant = tuple((substitute(e, lines, at.rank), ZERO) for e in (*map(Point, own), *bound))
    found = seated(Claimed(meant), without(at, lines))
    return Placement(figure, lines, found, tuple(n for n in own if n not in found.places))
