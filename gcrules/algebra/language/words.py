r"""Words that make points, lines, planes and scalars of others: midpoint(a, b), foot(c, ab), tangent(a, b, c, d, e).

Each is written out in brackets, joins and meets where it is read. Where what it makes can be zero, it is among what the
words of a text are taken to have `made`: a claim is about positions at which these exist.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from gcrules.algebra import conics, metric, quadric_forms
from gcrules.algebra.expr import Expr, Join, Point
from gcrules.algebra.letters import named_letter
from gcrules.algebra.metric import Infinity
from gcrules.algebra.names import step_name
from gcrules.algebra.screw_letters import refuse_screw
from gcrules.algebra.space import Space
from gcrules.core.dataclass import dataclass
from gcrules.core.english import counted
from gcrules.core.errors import InputError, Span, StepError

__all__ = [
    "CONSTRUCTIONS",
    "FLAT",
    "LINE",
    "METRICS",
    "PLANE",
    "POINT",
    "POINT_OR_LINE",
    "SEGMENT",
    "Construction",
    "Relation",
    "Requirement",
    "Word",
    "constructed",
    "ends",
    "with_infinity",
]

_S = TypeVar("_S", bound=Space)

METRICS = ("isotropic", "orthonormal")
"""How the points at infinity are declared by which right angles and lengths are known."""

POINT, LINE, FLAT, SEGMENT = "a point", "a line", "a line or a plane", "a line of two points"
PLANE, POINT_OR_LINE = "a plane", "a point or a line"
"""What a word takes; a line of two points is written as their join, ab."""

_PLANE, _SPACE = (3,), (4,)
_BOTH = (3, 4)


@dataclass(frozen=True, slots=True)
class Requirement:
    """What must not vanish so that words mean something: as text of the language, with what that says; `letter` is that
    of a conic or a quadric of which the word is said.
    """

    expr: Expr
    text: str
    meaning: str
    letter: str = ""


@dataclass(frozen=True, slots=True)
class Word:
    """A word of the language: how it is written and what it is.

    `takes` are its arguments, the last of which may come again if `open`; it stands in `ranks`, and if it is `metric`
    only where the isotropic points or orthonormal directions are declared. Of its points none is at infinity then.
    """

    usage: str
    meaning: str
    takes: tuple[str, ...]
    ranks: tuple[int, ...]
    metric: bool = True
    open: bool = False
    of_conic: bool = False  # said of the letter of a conic or a quadric, which stands behind the arguments
    letter: str = ""  # a declaration of a letter that it is said of as well, with fewer arguments

    @property
    def name(self) -> str:
        return self.usage.partition("(")[0]

    def check(self, args: Sequence[Expr], spans: Sequence[Span], at: Space) -> None:
        """Raises InputError and StepError where the word cannot be said of these arguments in this space."""
        if at.rank not in self.ranks:
            where = " and ".join(_ROOMS[r] for r in self.ranks)
            raise InputError(f"{self.usage} is a word of {where}; this is rank {at.rank}", hint=_rank_hint(self.ranks))
        if self.metric and at.infinity is None:
            raise InputError(f"{self.usage} needs to know the points at infinity", hint=_DECLARE[at.rank])
        least = self.least(at.rank)
        if len(args) < least or (len(args) > least and not self.open):
            number = f"{'at least ' if self.open else ''}{counted(least + self.of_conic, 'argument')}"
            found = f"{self.usage} takes {number}, found {len(args) + self.of_conic}"
            raise InputError(found, hint=self._advice(args))
        for arg, span, kind in zip(args, spans, self.kinds(len(args)), strict=True):
            refuse_screw(arg, span)
            if not _FITS[kind](arg, at.rank):
                joined = isinstance(arg, Join) and named_letter(arg) is None
                hint = "separate the points with commas" if kind == POINT and joined else None
                raise StepError(f"{step_name(arg.step, at.rank)} where {kind} is expected", span=span, hint=hint)
            far = next((n for n in _ends_at_infinity(arg, at)), None) if self.metric else None
            if far is not None:
                raise InputError(f"{far} is at infinity, and {self.name}(…) is about finite points", span=span)

    def least(self, rank: int) -> int:
        """How many arguments there are at least."""
        return len(self.takes)

    def kinds(self, number: int) -> list[str]:
        """What each of so many arguments is."""
        return [self.takes[min(i, len(self.takes) - 1)] for i in range(number)]

    def _advice(self, args: Sequence[Expr]) -> str | None:
        if self.letter and 1 < len(args) < len(self.takes):
            return f"a letter that stands last is declared first: `{self.letter}`"
        joined = len(args) == 1 and isinstance(args[0], Join) and named_letter(args[0]) is None
        return "separate the points with commas" if joined and POINT in self.takes else None


@dataclass(frozen=True, slots=True)
class Construction(Word):
    """A word that stands in expressions: `build` writes it out. `always` says that finite points have a finite one.

    Of a letter `build` takes its own points last. The argument of the number `on` is a point of the conic, and
    what is `whole` is not zero where all arguments are points or letters.
    """

    build: Callable[..., Expr] = metric.midpoint
    always: bool = False
    by_rank: bool = False  # as many points as the rank says
    on: int | None = None
    whole: bool = False

    def least(self, rank: int) -> int:
        return rank if self.by_rank else len(self.takes)


@dataclass(frozen=True, slots=True)
class Relation(Word):
    """A word of `given` and `claim`, for the expressions that vanish where it holds.

    `whole` gives all of them, `chain` as many as say the same where the first of the points are in general position.
    Said of a letter, `whole` takes the rank and the points of the letter first. What is assumed `at_point`, with one
    more point, says the same as incidences and scalars that vanish.
    """

    whole: Callable[..., Iterable[Expr]] = lambda *_: []
    chain: Callable[..., Iterable[Expr]] | None = None
    at_point: Callable[..., Iterable[tuple[str, tuple[Expr, ...]]]] | None = None


def constructed(word: Construction, args: Sequence[Expr], at: Space, own: Sequence[Expr] = ()) -> tuple[Expr, bool]:
    """What a construction makes of its arguments, and whether that may be zero although the arguments are finite."""
    if word.of_conic:
        never_zero = word.always or (word.whole and all(isinstance(a, Point) or named_letter(a) for a in args))
        return word.build(*args, *own), not never_zero
    given = [ends(a) if kind == SEGMENT else a for a, kind in zip(args, word.kinds(len(args)), strict=True)]
    made = word.build(at.infinity, *given) if word.metric else word.build(*given)
    return made, not word.always


def with_infinity(at: _S, kind: str, names: Sequence[str]) -> _S:
    """A space in which these points at infinity are isotropic, or orthonormal. Raises InputError where they cannot."""
    found = Infinity(kind, tuple(dict.fromkeys(names)))
    expected = 2 if kind == "isotropic" else at.rank - 1
    if at.rank not in (_PLANE if kind == "isotropic" else _BOTH):
        where = "the plane (rank 3)" if kind == "isotropic" else "the plane (rank 3) and space (rank 4)"
        hint = _DECLARE.get(at.rank) or _rank_hint(_PLANE)
        raise InputError(f"{kind} points are points of {where}; this is rank {at.rank}", hint=hint)
    if len(found.points) != expected:
        what = f"{kind} declares {expected} points in rank {at.rank}, found {len(found.points)}"
        raise InputError(what, hint=f"`{kind} {' '.join('ijk'[:expected])}`")
    if at.infinity not in (None, found):
        raise InputError(f"{at.infinity} is declared already", hint="right angles are known by one of both only")
    return replace(at, ideal=tuple(dict.fromkeys((*at.ideal, *found.points))), infinity=found)


def ends(line: Expr) -> tuple[Expr, Expr]:
    """The two points of a line that is written as their join."""
    assert isinstance(line, Join)
    a, b = line.args
    return a, b


def _is_segment(e: Expr, rank: int) -> bool:
    return isinstance(e, Join) and [a.step for a in e.args] == [1, 1] and named_letter(e) is None


def _ends_at_infinity(e: Expr, at: Space) -> list[str]:
    """Points at infinity that an argument is, or both of two whose line it is."""
    points = e.args if isinstance(e, Join) else (e,)
    far = [p.name for p in points if isinstance(p, Point) and p.name in at.ideal]
    return far if far and len(far) == len(points) else []


_FITS: Mapping[str, Callable[[Expr, int], bool]] = {
    POINT: lambda e, rank: e.step == 1,
    LINE: lambda e, rank: e.step == 2,
    FLAT: lambda e, rank: 2 <= e.step < rank,
    PLANE: lambda e, rank: e.step == 3,
    POINT_OR_LINE: lambda e, rank: 1 <= e.step <= 2,
    SEGMENT: _is_segment,
}
_ROOMS = {3: "the plane (rank 3)", 4: "space (rank 4)"}
_DECLARE = {
    3: "declare the isotropic points first, `isotropic i j`, or directions at right angles, `orthonormal i j`",
    4: "declare three directions at right angles first: `orthonormal i j k`",
}


def _rank_hint(ranks: tuple[int, ...]) -> str:
    return f"`rank {ranks[0]}` in a file, --rank {ranks[0]} in the shell"


_P2, _P3, _P5 = (POINT,) * 2, (POINT,) * 3, (POINT,) * 5

CONSTRUCTIONS: Mapping[str, Construction] = {
    w.name: w
    for w in (
        Construction("midpoint(a, b)", "the midpoint of a and b", _P2, _BOTH, build=metric.midpoint, always=True),
        Construction(
            "centroid(a, b, c, …)",
            "the centroid of the points",
            _P2,
            _BOTH,
            open=True,
            build=metric.centroid,
            always=True,
        ),
        Construction("reflection(p, f)", "p reflected in f", _P2, _BOTH, build=metric.reflection, always=True),
        Construction(
            "mirror(p, ab)",
            "p reflected in a line of the plane, in a line or a plane in space",
            (POINT, FLAT),
            _BOTH,
            build=metric.mirror,
        ),
        Construction("direction(ab)", "the point at infinity of a line", (LINE,), _BOTH, build=metric.direction),
        Construction(
            "parallel_through(c, ab)",
            "the line through c parallel to ab",
            (POINT, LINE),
            _BOTH,
            build=metric.parallel_through,
        ),
        Construction(
            "perpendicular_through(c, ab)",
            "the perpendicular through c; in space of a line a plane, and of a plane a line",
            (POINT, FLAT),
            _BOTH,
            build=metric.perpendicular_through,
        ),
        Construction(
            "foot(c, ab)",
            "the foot of the perpendicular from c to a line, or to a plane",
            (POINT, FLAT),
            _BOTH,
            build=metric.foot,
        ),
        Construction(
            "bisector(a, b)",
            "the perpendicular bisector of a and b: a line, in space a plane",
            _P2,
            _BOTH,
            build=metric.bisector,
        ),
        Construction(
            "circumcentre(a, b, c)",
            "the centre of the circle through three points; in space of the sphere through four",
            _P3,
            _BOTH,
            build=metric.circumcentre,
            by_rank=True,
        ),
        Construction(
            "orthocentre(a, b, c)",
            "where the altitudes of a triangle meet",
            _P3,
            _PLANE,
            build=metric.orthocentre,
        ),
        Construction(
            "second_on_circle(p, a, b, c)",
            "the second point of the line pa on the circle through a, b and c",
            (POINT,) * 4,
            _PLANE,
            build=metric.on_circle_again,
        ),
        Construction(
            "second_on_conic(p, a, b, c, d, e)",
            "the second point of the line pa on the conic through a, b, c, d and e",
            (POINT,) * 6,
            _PLANE,
            metric=False,
            letter="conic K",
            build=conics.on_conic_again,
        ),
        Construction(
            "tangent(a, b, c, d, e)",
            "the tangent at a of the conic through the five points",
            _P5,
            _PLANE,
            metric=False,
            letter="conic K",
            build=conics.tangent,
        ),
        Construction(
            "polar(p, a, b, c, d, e)",
            "the polar of p for the conic through the other points",
            (POINT,) * 6,
            _PLANE,
            metric=False,
            letter="conic K",
            build=conics.polar,
        ),
        Construction(
            "pole(pq, a, b, c, d, e)",
            "the pole of the line pq for the conic through the other points",
            (SEGMENT, *_P5),
            _PLANE,
            metric=False,
            letter="conic K",
            build=conics.pole,
        ),
        Construction(
            "conic(a, b, c, d, e, f)",
            "the scalar that is zero where the six points are on a conic",
            (POINT,) * 6,
            _PLANE,
            metric=False,
            letter="conic K",
            build=conics.on_conic,
            always=True,
        ),
        Construction(
            "quadric(a, b, c, d, e, f, g, h, i, j)",
            "the scalar that is zero where the ten points are on a quadric",
            (POINT,) * 10,
            _SPACE,
            metric=False,
            letter="quadric Q",
            build=quadric_forms.on_quadric,
            always=True,
        ),
    )
}
"""The words of expressions by their names."""
