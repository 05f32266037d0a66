r"""What a product of brackets, joins and meets says: geometric sentences.

>>> from gcrules.algebra.language.syntax import parse
>>> from gcrules.algebra.language.legs_text import read_legs
>>> structure = read_legs("ab bc ca de fg hi")
>>> print(sentence(parse(r"ab /\ de"), structure, RandomWitness(structure)))
The robot is singular exactly when the lines ab and de meet (possibly at infinity).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field
from itertools import groupby

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import ONE, Bracket, Expr, Join, Meet, Number, Point, Power, Product, Sum
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.letters import letter_of, letters_of, wholes
from gcrules.algebra.screw_letters import Screw, screws_of
from gcrules.core.dataclass import dataclass
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.screw_words import built_of_screws, reciprocity
from gcrules.rules.statement import Flat, Part, Statement, listing, say, together

__all__ = ["comparison", "described", "factors_of", "sentence"]


def factors_of(e: Expr) -> Iterator[Expr]:
    """The factors of a scalar without numbers, repeated ones as often as they are there."""
    match e:
        case Product(factors=factors):
            for f in factors:
                yield from factors_of(f)
        case Power(base=base, exponent=exponent):
            for _ in range(exponent):
                yield from factors_of(base)
        case Number():
            return
        case _:
            yield e


def sentence(
    e: Expr, structure: Structure, oracle: RandomWitness, cofactor: Expr = ONE, *, besides: tuple[Part, ...] = ()
) -> Statement:
    """When the robot is singular, for an expression that equals the superbracket, or `cofactor` times it; `besides`
    says when it is singular too.
    """
    return _said(_Words(structure, oracle), e, cofactor, besides)


def comparison(
    e: Expr, lines: Sequence[Expr], single: Sequence[Expr], structure: Structure, oracle: RandomWitness, cofactor: Expr
) -> Statement:
    """The same of an expression with a factor that compares the turns about two lines p and q which two legs allow."""
    words = _Words(structure, oracle)
    about = [words.noun(line) for line in lines]
    lets = words.told()
    words.names |= dict(zip(lines, "pq", strict=True))
    rest = ex.mul(*(f for f in factors_of(e) if not isinstance(f, Sum)))
    turns = say(
        "Without the legs {} and {} the platform can turn, to first order, about p, {}, and about q, {}. "
        "Each of {} and {} allows these two turns in one ratio only. ",
        *(*single, *about, *single),
    )
    return say("{}{}{}", lets, turns, _said(words, rest, cofactor, ("the two ratios agree",)))


def described(e: Expr, structure: Structure, oracle: RandomWitness) -> Statement:
    """What an extensor is called."""
    words = _Words(structure, oracle)
    noun = words.noun(e)
    return say("{} ({})", noun, _each(words.lets, ", and ")) if words.lets else say("{}", noun)


def _said(words: _Words, e: Expr, cofactor: Expr, besides: tuple[Part, ...]) -> Statement:
    outside = words.clauses(cofactor)
    words.constructed = False  # what the cofactor leaves undetermined is outside
    clauses = [c for c in words.clauses(e) if c not in outside]
    lets = words.told()
    where = say("Outside the poses where {}, the", _each(outside)) if outside else "The"
    undetermined = " Where one of these is not determined, the robot is also singular." if words.constructed else ""
    whole = _each([*clauses, *besides])
    return say("{}{} robot is singular exactly when {}.{}", lets, where, whole, undetermined)


def _each(parts: Iterable[Part], between: str = ", or ") -> Statement:
    some = list(parts)
    return say(between.join(["{}"] * len(some)), *some)


@dataclass
class _Words:
    """Words for extensors and for what makes a factor vanish; constructed extensors inside others are given names."""

    structure: Structure
    oracle: RandomWitness
    lets: list[Statement] = field(default_factory=list)
    names: dict[Expr, str] = field(default_factory=dict)
    more: list[Statement] = field(default_factory=list)  # clauses about planes at infinity that must be planes
    constructed: bool = False

    @property
    def rank(self) -> int:
        return self.structure.rank

    def told(self) -> Part:
        """The names given so far, which are told once."""
        lets = say("Let {}. ", _each(self.lets, ", and ")) if self.lets else ""
        self.lets = []
        return lets

    def clauses(self, e: Expr) -> list[Statement]:
        """What makes the factors vanish, each once; flat tetrahedra together."""
        found = []
        factors = list(dict.fromkeys(factors_of(e)))
        flat = [f for f in factors if isinstance(f, Bracket) and self._tetrahedron(f)]
        if flat:
            found.append(self._flat(flat))
        for f in factors:
            if f not in flat:
                clause = self._clause(f)
                found += [*self.more, clause]
                self.more = []
        return list(dict.fromkeys(found))

    # --- factors ---

    def _tetrahedron(self, e: Bracket) -> bool:
        ideal = sum(self.oracle.at_infinity(a) for a in e.args) if self.structure.special else 0
        return all(isinstance(a, Point) and letter_of(a.name) is None for a in e.args) and ideal < 2

    def _flat(self, brackets: Sequence[Bracket]) -> Statement:
        if self.rank == 4:
            which = "one of the tetrahedra" if len(brackets) > 1 else "the tetrahedron"
            shown = listing(self.plain(ex.join(*b.args)) for b in brackets)
            return say("{} {} is flat (its four points lie in one plane)", which, shown)
        where = "are on a line" if self.rank == 3 else "lie in one hyperplane"
        return _each(say("the points {} {}", listing(map(self.plain, b.args)), where) for b in brackets)

    def _clause(self, e: Expr) -> Statement:
        reciprocal = reciprocity(e, self.noun)
        if reciprocal is not None:
            return reciprocal
        match e:
            case Bracket(args=args):
                return self._dependent(wholes(args))
            case Meet(args=args) if e.step == 0:
                return self._meeting(args)
        return say("{} is zero", self.plain(e))

    def _dependent(self, args: tuple[Expr, ...]) -> Statement:
        """Extensors whose steps add up to the rank lie in one hyperplane."""
        far = [a for a in args if self.oracle.at_infinity(a)]
        near = [a for a in args if a not in far]
        if self.rank == 4 and sum(a.step for a in far) >= 2 and all(isinstance(a, Point) for a in near):
            return self._parallel(far, near)
        space = {3: "are on a line", 4: "lie in one plane"}.get(self.rank, "lie in one hyperplane")
        return say("{} {}", listing(self.noun(a) for a in args), space)

    def _parallel(self, far: Sequence[Expr], near: Sequence[Expr]) -> Statement:
        """Directions, and that of the line of two finite points, are parallel to one plane."""
        items = [self._direction(a) for a in far]
        if len(near) == 2:
            items.append(("line", self.plain(ex.join(*near))))
        return say("{} are parallel to one plane", together(items))

    def _direction(self, e: Expr) -> tuple[str, Part]:
        """The kind of what has this direction, and what it is called."""
        match e:
            case Meet(args=args):
                finite = [a for a in args if not self.oracle.at_infinity(a)]
                if len(finite) == 1 and finite[0].step == 2 and _is_plain(finite[0]):
                    self._plane_at_infinity(*(a for a in args if a.step == 3))
                    return "line", self.plain(finite[0])
            case Point():
                return "direction", self.plain(e)
        return "", self.noun(e)

    def _plane_at_infinity(self, *planes: Expr) -> None:
        """Three points at infinity are the plane at infinity unless they are in line: one clause more."""
        for plane in planes:
            parts = plane.args if isinstance(plane, Join) else (plane,)
            if all(isinstance(p, Point) for p in parts):
                places = sorted(parts, key=lambda p: self.structure.names.index(str(p)))
                clause = say("the directions {} are parallel to one plane", listing(map(self.plain, places)))
            else:
                lines = [line for p in _grouped(parts) for line in self._lines_at_infinity(p)]
                words = "the lines at infinity {} meet in a point (their axes are parallel to one plane)"
                clause = say(words, listing(lines))
            if clause not in self.more:
                self.more.append(clause)

    def _lines_at_infinity(self, e: Expr) -> list[Flat]:
        """The lines at infinity whose common point is meant, or the line itself."""
        if not isinstance(e, Meet):
            return [self.plain(e)]
        return [self.plain(self._ideal_part(a)) for a in e.args]

    def _ideal_part(self, plane: Expr) -> Expr:
        """The line at infinity of a plane that is written with two points at infinity; anything else as it is."""
        if isinstance(plane, Join) and plane.step == 3 and _is_plain(plane):
            far = [p for p in plane.args if self.oracle.at_infinity(p)]
            if len(far) == 2:
                return ex.join(*far)
        return plane

    def _meeting(self, args: tuple[Expr, ...]) -> Statement:
        """Extensors with a point in common."""
        infinite = [a for a in args if a.step == self.rank - 1 and self.rank == 4 and self.oracle.at_infinity(a)]
        if infinite:
            self._plane_at_infinity(*infinite)
            rest = [a for a in args if a not in infinite]
            if all(a.step == 3 for a in rest):
                return say("{} are parallel to one line", self._kinds(rest))
            if len(rest) == 2:
                return self._parallel_pair(*sorted(rest, key=lambda a: a.step))
        point = next((a for a in args if a.step == 1), None)
        if point is not None:
            (other,) = (a for a in args if a is not point)
            where = "on" if other.step == 2 else "in"
            return say("{} lies {} {}", self.noun(point), where, self.noun(other))
        if self.rank == 3:
            return say("{} meet in a point or are parallel", self._kinds(args, "three "))
        if [a.step for a in args] == [2, 2]:
            far = [a for a in args if self.oracle.at_infinity(a)]
            if len(far) == 1 and _is_plain(far[0]):
                (near,) = (a for a in args if a not in far)
                directions = listing(map(self.plain, far[0].children))
                return say("{} and the directions {} are parallel to one plane", self.noun(near), directions)
            return say("{} meet (possibly at infinity)", self._kinds(args))
        alike = len(args) == 4 and all(a.step == args[0].step for a in args)
        return say("{} meet in a point (possibly at infinity)", self._kinds(args, "four " * alike))

    def _parallel_pair(self, line: Expr, plane: Expr) -> Statement:
        """A line parallel to a plane; the plane through a direction and a line is told by these."""
        if isinstance(plane, Join) and not _is_plain(plane):
            parts = _grouped(plane.args)
            far = [p for p in parts if self.oracle.at_infinity(p)]
            near = [p for p in parts if p not in far]
            if len(far) == 1 and far[0].step == 1 and len(near) == 1 and _is_plain(near[0]) and _is_plain(line):
                items = [self._direction(far[0]), ("line", self.plain(near[0])), ("line", self.plain(line))]
                return say("{} are parallel to one plane", together(items))
        return say("{} is parallel to {}", self.noun(line), self.noun(plane))

    def _kinds(self, args: Sequence[Expr], number: str = "") -> Statement:
        """ "the planes abc and def and the line gh"; constructed ones as they are described. `number` is how many they
        are, where all are written with their points.
        """
        found: list[Part] = []
        number *= all(map(_is_plain, args))
        ordered = sorted(args, key=lambda a: (-a.step, not _is_plain(a)))
        for (step, plain), group in groupby(ordered, lambda a: (a.step, _is_plain(a))):
            members = list(group)
            if plain:
                shown = listing(sorted(map(self.plain, members), key=str))
                found.append(say("the {} {}", f"{number}{self._kind(step)}{'s' * (len(members) > 1)}", shown))
                number = ""
            else:
                found += [self.noun(a) for a in members]
        return listing(found)

    # --- extensors ---

    def plain(self, e: Expr) -> Flat:
        """Points, and joins of points as they are written; a leg in the direction in which it was typed."""
        if isinstance(e, Join) and e.step == 2:
            leg = next((leg for leg in self.structure.legs if {Point(n) for n in leg} == set(e.args)), None)
            e = ex.join(*map(Point, leg)) if leg else e
        return Flat(e, self.structure.names)

    def noun(self, e: Expr, *, inside: bool = False) -> Part:
        """What an extensor is called; inside the description of another one a constructed one gets a name."""
        if isinstance(e, Point):
            return self.plain(e)
        if isinstance(e, Screw):
            return say("the screw {}", self.plain(e))
        if _is_plain(e):
            return self._of_points(e)
        self.constructed = True
        if not inside:
            return self.names.get(e) or self._built(e)
        if e not in self.names:
            described = self._built(e)
            self.names[e] = self._free_name(e.step)
            self.lets.append(say("{} be {}", self.names[e], described))
        return self.names[e]

    def _kind(self, step: int) -> str:
        return "hyperplane" if self.rank > 4 and step == self.rank - 1 else _KINDS.get(step, "span")

    def _of_points(self, e: Expr) -> Statement:
        far = self.rank == 4 and self.structure.special and self.oracle.at_infinity(e)
        return say("the {}{} {}", self._kind(e.step), " at infinity" * far, self.plain(e))

    def _built(self, e: Expr) -> Statement:
        if (found := built_of_screws(e, lambda part: self.noun(part, inside=True))) is not None:
            return found
        if isinstance(e, Meet):
            return self._common(e)
        parts = e.children if all(c.step == 1 for c in e.children) else _grouped(e.children)
        return say("the {} through {}", self._kind(e.step), listing(self.noun(p, inside=True) for p in parts))

    def _common(self, e: Meet) -> Statement:
        args = sorted(e.args, key=lambda a: a.step)
        if self.rank == 4 and self.structure.special:
            far = [a for a in args if a.step == 3 and self.oracle.at_infinity(a)]
            if far and len(args) == 2:
                self._plane_at_infinity(*far)
                (near,) = (a for a in args if a not in far)
                what = "direction" if near.step == 2 else "line at infinity"
                return say("the {} of {}", what, self.noun(near, inside=True))
            if any(self.oracle.at_infinity(a) for a in args):
                args = [self._ideal_part(a) for a in args]
        shown = [self.noun(a, inside=True) for a in args]
        if e.step == 2 and self.rank == 4:
            return say("the common line of {}", self._named(args))
        if len(args) == 2 and e.step == 1:
            if args[0].step == args[1].step:
                return say("the point where {} meet", self._named(args))
            return say("the point where {} meets {}", *shown)
        return say("the common {} of {}", "point" if e.step == 1 else "span", self._named(args))

    def _named(self, args: Sequence[Expr]) -> Statement:
        """ "the planes abc and p"."""
        if all(map(_is_plain, args)):
            return self._kinds(args)
        return listing(self.noun(a, inside=True) for a in args)

    def _free_name(self, step: int) -> str:
        names = self.structure.names
        taken = {*names, *letters_of(names), *screws_of(names), *self.names.values()}
        letters = {1: "PQRSTU", 2: "pqrstu"}.get(step, "XYZWVU")
        return next(n for primes in range(len(taken) + 1) for c in letters if (n := c + "'" * primes) not in taken)


_KINDS = {1: "point", 2: "line", 3: "plane"}


def _is_plain(e: Expr) -> bool:
    """Whether it is a point or a join of points."""
    return isinstance(e, Point) or (isinstance(e, Join) and all(isinstance(a, Point) for a in e.args))


def _grouped(args: Sequence[Expr]) -> list[Expr]:
    """The arguments of a join, points side by side joined."""
    found: list[Expr] = []
    for is_point, run in groupby(args, lambda a: isinstance(a, Point)):
        members = list(run)
        found += [ex.join(*members, rank=8)] if is_point else members
    return found
