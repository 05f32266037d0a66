r"""What incidences say at once: two points on two lines, a line in a plane, a meet on both of its parts.

What is `given`, what names mean and what was found before are flats, each with the points that are known to lie on it.
Wherever known points of two flats span one of them, it lies in the other; points on two different lines are one; lines
that share a point span a plane. What comes of these steps alone is taken to be trivial, and nobody wants to read it as
a discovery. That points on two planes are on a line is not among them: Desargues' theorem in space would be trivial.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import combinations

from gcrules.algebra.assumptions.conics import hexagon
from gcrules.algebra.discovery.figure import Position, Vector
from gcrules.algebra.discovery.flats import Flat
from gcrules.algebra.discovery.incidences import Incidence
from gcrules.algebra.discovery.polarity import Polarity
from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.expr import ZERO, Bracket, Expr, Join, Meet, Number, Point, Product, Sum
from gcrules.algebra.space import Assumption
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import echelon, kernel, rank

__all__ = ["Known", "learn", "unknown"]

_MAX_FLATS = 2_000  # beyond them nothing more is concluded


class Known:
    """What is known of a figure at a position. Points without a name are called by what they are, in parentheses."""

    def __init__(self, position: Position) -> None:
        self.position, self.rank = position, position.rank
        self.vectors: dict[str, Vector] = dict(position.vectors)
        self.same: dict[str, str] = {}
        self.flats: list[Flat] = []
        self.inside: list[tuple[Flat, Flat]] = []
        self.met: list[tuple[Flat, list[Flat]]] = []
        self.conics: list[set[str]] = []
        self.polarities = {n: Polarity(n, position) for n in position.figure.space.conics}
        self._flat_of: dict[Expr, Flat | None] = {}
        self._name_of: dict[Expr, str] = {}

    # --- what is told ------------------------------------------------------------------------------------------------

    def begin(self, given: Iterable[Assumption], where: Iterable[Expr]) -> None:
        """What a figure says: the meanings of names, points at infinity, assumptions and scalars that vanish."""
        figure = self.position.figure
        for name, e in figure.bound.items():
            if name in self.position.flats:
                self.flat(e)
            elif name in self.position.vectors:
                self._name_of[e] = name
                self._defined(name, e)
        at_infinity = [n for n in figure.space.ideal if n in self.vectors]
        self.dependent(at_infinity, self.rank - 1)
        for a in given:
            self._assume(a)
        for e in where:
            self._vanishing(e)
        self.close()

    def dependent(self, names: Iterable[str], step: int) -> None:
        """Points lie on one flat of this step, if they span one."""
        members = set(names)
        basis = echelon([self.vectors[n] for n in members], PRIME)[0] if members else ()
        if len(basis) == step:
            self.flats.append(Flat(basis, members))

    def equal(self, one: str, other: str) -> None:
        """Two names stand for one point."""
        a, b = sorted((self.name(one), self.name(other)))
        if a != b:
            self.same[b] = a
            for f in self.flats:
                if b in f.members:
                    f.members = {self.name(n) for n in f.members}

    def together(self, flats: Sequence[Flat], name: str) -> None:
        """The flats have a point in common, which has no name."""
        rows = [r for f in flats for r in kernel(f.span, self.rank, PRIME)]
        common = kernel(rows, self.rank, PRIME)
        if len(common) == 1:
            self.vectors[name] = common[0]
            for f in flats:
                f.members.add(name)

    def flat(self, e: Expr) -> Flat | None:
        """That of an extensor; None where it vanishes or cannot be told."""
        e = _extensor(e)
        if e not in self._flat_of:
            self._flat_of[e] = None
            if isinstance(e, Join | Meet) and not self.position.zero(e):
                self._flat_of[e] = found = Flat(self.position.span(e))
                self.flats.append(found)
                if isinstance(e, Join):
                    for part in e.args:
                        self._inside(part, found)
                else:
                    around = [f for f in map(self.flat, e.args) if f is not None]
                    self.met.append((found, around))
                    self.inside += [(found, f) for f in around]
            elif e.step and not self.position.zero(e):
                self._flat_of[e] = next(filter(None, (self._polar(e, k) for k in self.polarities.values())), None)
        return self._flat_of[e]

    def _polar(self, e: Expr, of_letter: Polarity) -> Flat | None:
        """The flat of the polar of a point, or of a line of space; None for what words made otherwise."""
        of = of_letter.polar_of(e)
        if of is None:
            return None
        if of.step == 1:
            if (name := self._point(of)) is None:
                return None
            found = of_letter.polar(name, self.vectors[name], self.flats)
            found.letter = ""
            return found
        line, found = self.flat(of), Flat(self.position.span(e))
        self.flats.append(found)
        of_letter.lines += [(line, found)] if line is not None else []
        return found

    def _inside(self, part: Expr, whole: Flat) -> None:
        part = _extensor(part)
        if part.step == 1:
            if (name := self._point(part)) is not None:
                whole.members.add(name)
        elif (f := self.flat(part)) is not None:
            self.inside.append((f, whole))

    def _point(self, e: Expr) -> str | None:
        """The name of a point, to which its own parts are told."""
        if e not in self._name_of:
            value = tuple(self.position.at.value(e))
            if not any(value):
                return None
            name = e.name if isinstance(e, Point) else f"({e})"
            self._name_of[e] = name
            self.vectors.setdefault(name, value)
            self._defined(name, e)
        return self._name_of[e]

    def _defined(self, name: str, e: Expr) -> None:
        """What follows for a point from what it is: a meet lies on its parts, a sum is dependent on its terms."""
        inner = _extensor(e)
        if inner != e and (other := self._point(inner)) is not None:
            self.equal(name, other)
        for k in self.polarities.values():
            k.on |= {name} if k.made_on(inner) else set()
            if (of := k.polar_of(inner)) is not None:
                if (f := self.flat(of)) is not None:
                    k.is_polar(name, f)
                return
        if isinstance(inner, Meet):
            for part in inner.args:
                if (f := self.flat(part)) is not None:
                    f.members.add(name)
        elif isinstance(inner, Sum):
            terms = [self._point(_extensor(t)) for t in inner.terms]
            self.dependent({name, *(t for t in terms if t is not None)}, len(terms))

    def _assume(self, a: Assumption) -> None:
        match a.kind:
            case "collinear" | "coplanar":
                names = [self._point(e) for e in a.args]
                self.dependent([n for n in names if n is not None], 2 if a.kind == "collinear" else 3)
            case "incident":
                one, other = a.args
                for small, large in ((one, other), (other, one)):
                    if small.step <= large.step and (f := self.flat(large)) is not None:
                        self._inside(small, f)
            case "concurrent":
                self.meet(a.args, f"(common point of {a})")
            case "zero":
                self._vanishing(a.args[0])

    def meet(self, args: Iterable[Expr], name: str) -> None:
        """Lines or planes have a point in common."""
        found = [self.flat(e) for e in args]
        self.together([f for f in found if f is not None], name)

    def _vanishing(self, e: Expr) -> None:
        """What follows from an expression that vanishes, if it can be told."""
        for k in self.polarities.values():
            if (p := k.point_on(e)) is not None and (n := self._point(p)) is not None:
                k.on.add(n)
                return
        six = hexagon(e, self.rank)
        if six is not None:
            self.conics.append(set(six))
        if isinstance(e, Product) and isinstance(e.factors[0], Number) and len(e.factors) == 2:
            e = e.factors[1]
        match e:
            case Join(args=args) | Bracket(args=args) if all(a.step == 1 for a in args):
                names = [n for n in map(self._point, args) if n is not None]
                if len(names) == 2:
                    self.equal(*names)
                elif len(names) == len(args):
                    self.dependent(names, len(args) - 1)
            case Join(args=args) | Bracket(args=args) | Meet(args=args, step=0) if len(args) == 2:
                small, large = sorted(args, key=lambda a: a.step)
                if small.step == 1 and (f := self.flat(large)) is not None:
                    self._inside(small, f)
            case Meet(args=args, step=0):
                self.meet(args, f"(common point of {e})")
            case Sum() if e.step == 1:
                terms = {n for t in e.terms if (n := self._point(_extensor(t))) is not None}
                if len(terms) == 2:
                    self.equal(*terms)
                self.dependent(terms, len(terms) - 1)

    # --- what follows ------------------------------------------------------------------------------------------------

    def close(self) -> None:
        """Conclude until nothing new comes."""
        while self._conclude():
            checkpoint()

    def _conclude(self) -> bool:
        before = self._extent()
        for small, large in self.inside:
            large.members |= small.members
        for f, around in self.met:
            f.members |= set.intersection(*(g.members for g in around))
        for f, g in combinations(tuple(self.flats), 2):
            common = f.members & g.members
            if common and len(self.flats) < _MAX_FLATS:
                self._compare(f, g, common)
        for k in self.polarities.values():
            for a, b in k.conclude(self.vectors, self.flats, self.name):
                self.equal(a, b)
        known = [*self.conics, *(k.on for k in self.polarities.values())]
        for one, other in combinations(known, 2):
            if len(one & other) >= 5:
                one |= other
                other |= one
        return self._extent() != before

    def _extent(self) -> tuple[int, ...]:
        return (
            len(self.flats),
            sum(len(f.members) for f in self.flats),
            len(self.same),
            sum(map(len, self.conics)),
            *(k.extent for k in self.polarities.values()),
        )

    def _compare(self, f: Flat, g: Flat, common: set[str]) -> None:
        if f.step > g.step:
            f, g = g, f
        if f.step == g.step and f.members == g.members and len(common) == 1:
            return
        if len(common) >= f.step and self._spanned(common) == f.step:
            g.members |= f.members
            if f.step == g.step:
                f.members |= g.members
            return
        both = rank([*f.span, *g.span], PRIME)
        met = f.step + g.step - both
        if met == 1:
            first, *others = sorted(common)
            for other in others:
                self.equal(first, other)
        if g.step < both < self.rank and self._spanned(common) == met:
            members = f.members | g.members
            if not any(other.step == both and members <= other.members for other in self.flats):
                self.flats.append(Flat(echelon([*f.span, *g.span], PRIME)[0], members))

    def _spanned(self, names: Iterable[str]) -> int:
        return rank([self.vectors[n] for n in names], PRIME)

    # --- what is asked -----------------------------------------------------------------------------------------------

    def name(self, name: str) -> str:
        """The name that stands for one and all that are known to be the same point."""
        while name in self.same:
            name = self.same[name]
        return name

    def names(self, names: Iterable[str]) -> set[str]:
        return {self.name(n) for n in names}

    def on_one(self, names: Iterable[str], step: int) -> bool:
        """Whether points are known to lie on one flat of this step."""
        wanted = self.names(names)
        return len(wanted) <= step or any(f.step <= step and wanted <= f.members for f in self.flats)

    def line(self, names: Sequence[str]) -> set[str]:
        """The points that are known to lie on a line, told by its own name or by two points."""
        if len(names) == 1:
            f = self.flat(self.position.figure.meaning(names[0]))
            return set() if f is None else f.members
        points = self.names(names)
        return points.union(*(f.members for f in self.flats if f.step == 2 and points <= f.members))

    def polar(self, i: Incidence) -> Flat:
        """The polar of the last point that an incidence names."""
        name = self.name(i.names[-1])
        return self.polarities[i.letter].polar(name, self.vectors[name], self.flats)

    def pole(self, i: Incidence) -> str:
        """The name of the pole of the line or plane that an incidence names last, if it is known to have one."""
        f = self.flat(self.position.figure.meaning(i.names[-1]))
        return self.name(self.polarities[i.letter].pole(f, self.vectors)) if f is not None else ""

    def touches(self, i: Incidence) -> bool:
        """Whether a line or a plane is known to touch."""
        return any(self.polarities[i.letter].touches(f, self.inside, self.name) for f in self._touching(i))

    def touch(self, i: Incidence) -> None:
        """Let it be known that it touches: its pole is on the conic or quadric."""
        k = self.polarities[i.letter]
        k.on |= {k.pole(f, self.vectors) for f in self._touching(i) if f.step == self.rank - 1}

    def _touching(self, i: Incidence) -> list[Flat]:
        """The flats that are known to be what an incidence says to touch."""
        (told,) = i.lines
        f = self.flat(self.position.figure.line(told))
        points = self.names(told) if len(told) > 1 else set()
        around = (g for g in self.flats if g.step == self.rank - 1 and points and points <= g.members)
        return [*filter(None, [f]), *around]

    def meet_in_one(self, lines: Sequence[Sequence[str]]) -> bool:
        """Whether a point is known to lie on lines."""
        return bool(set.intersection(*map(self.line, lines)))


def unknown(i: Incidence, known: Known) -> Incidence | None:
    """An incidence, or None where it follows at once from what is known; of points on a flat with a name, on a conic or
    quadric with a letter, or on the polar of a point, those of which it does not.
    """
    among = _among(i, known)
    if among is not None:
        count = len(i.names) - (i.relation in ("incident", "conjugate"))
        left = tuple(n for n in i.names[:count] if known.name(n) not in among)
        return replace(i, names=(*left, *i.names[count:])) if left else None
    match i.relation:
        case "equal":
            follows = len(known.names(i.names)) == 1
        case "concurrent":
            follows = known.meet_in_one(i.lines)
        case "on_conic":
            follows = any(known.names(i.names) <= known.names(conic) for conic in known.conics)
        case "polar":
            follows = known.pole(i) == known.name(i.names[0])
        case "touches":
            follows = known.touches(i)
        case _:
            follows = known.on_one(i.names, 2 if i.relation == "collinear" else 3)
    return None if follows else i


def _among(i: Incidence, known: Known) -> set[str] | None:
    """The points that are known to be where an incidence puts its points one by one; None for other incidences."""
    if i.relation == "incident":
        return known.line([i.names[-1]])
    if i.relation == "conjugate":
        return known.polar(i).members
    return known.polarities[i.letter].on if i.relation in ("on_conic", "on_quadric") and i.letter else None


def learn(i: Incidence, known: Known) -> None:
    """Let an incidence be known from now on."""
    match i.relation:
        case "equal":
            for other in i.names[1:]:
                known.equal(i.names[0], other)
        case "incident":
            f = known.flat(known.position.figure.meaning(i.names[-1]))
            if f is not None:
                f.members |= known.names(i.names[:-1])
        case "concurrent":
            known.meet(map(known.position.figure.line, i.lines), f"(common point of {i.lines})")
        case "on_conic" | "on_quadric" if i.letter:
            known.polarities[i.letter].on |= known.names(i.names)
        case "on_conic":
            known.conics.append(known.names(i.names))
        case "conjugate":
            known.polar(i).members |= known.names(i.names[:-1])
        case "polar":
            known.equal(known.pole(i), i.names[0])
        case "touches":
            known.touch(i)
        case _:
            known.dependent(known.names(i.names), 2 if i.relation == "collinear" else 3)
    known.close()


def _extensor(e: Expr) -> Expr:
    """Without scalars as factors."""
    if isinstance(e, Product):
        return next((f for f in e.factors if f.step), ZERO)
    return e
