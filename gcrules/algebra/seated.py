r"""Claims about letters for conics and quadrics, decided with points that are given on these in place of their own.

A conic K is no pair of lines. Any five different points of it determine it, so that points which an assumption puts on
it take the places of K¹, …, K⁵; then nothing is left of the assumption but that these points differ. What is proved
about them and the rest of K¹, …, K⁵ holds whichever points of K the rest are. A quadric Q is no cone, and two points of
it take the places of corners of a tetrahedron on it (see `seats`).

>>> from gcrules.algebra.language.relations import parse_claim
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> at = parse_assumption("conic K, on_conic(a, b, K)", Context(3))
>>> found = seated(parse_claim("incident(c, K)", at), at)
>>> dict(found.places), found.space.given
({'K¹': 'a', 'K²': 'b'}, ())
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from itertools import combinations
from random import Random

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.nondegeneracy import Nowhere, chosen, words
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Point, points_of, subexpressions
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.language.text import SHORT_NAME, text
from gcrules.algebra.letter_forms import FORMS, polar_of
from gcrules.algebra.letters import conic_of, conic_points, conics_of, marks_in, named_letter
from gcrules.algebra.lines_on_quadrics import OnLines, on_lines
from gcrules.algebra.parts import substitute
from gcrules.algebra.seats import SEATS, given_on
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.towers import polar_of_line, tower
from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap

__all__ = ["Seated", "in_words", "seated"]

_PLANE, _SPACE = 3, 4


@dataclass(frozen=True, slots=True)
class Seated:
    """A claim with what is given, in which the points of `places` have others in their place.

    What is assumed of these is `told`, texts with their meanings, unless the positions are `irreducible` without that:
    then those at which it holds, and nothing else vanishes that a proof asks for, are dense among all. Conditions on
    points of one of the sets in `generic` are not told for this reason. Where there are `flats`, nothing has to be told
    but that these do not vanish, and what is in `differ` (see `towers`).
    """

    claimed: Claimed
    space: Space
    places: Mapping[str, str] = FrozenMap()
    told: tuple[tuple[str, str], ...] = ()
    irreducible: bool = False
    generic: tuple[frozenset[str], ...] = ()
    flats: tuple[Expr, ...] | None = None
    differ: tuple[tuple[str, str], ...] = ()

    def put(self, e: Expr) -> Expr:
        """An expression with the points that have places of others."""
        return _put(e, self.places, self.space.rank)

    @property
    def alone(self) -> Mapping[str, str] | None:
        """What is assumed not to vanish whatever a proof asks for, in words with their meanings; None where that is
        assumed as well.
        """
        if self.irreducible:
            return {}
        if self.flats is None:
            return None
        told = dict(self.differ) | {text(e): words(e) for e in chosen(self.flats, self.space.rank)}
        return None if any(map(marks_in, told)) else told

    def assumed(self, spoken: Mapping[str, str], kinds: Iterable[object] = ()) -> Mapping[str, str] | None:
        """What is assumed not to vanish by a proof with the conditions that are `spoken`, for these kinds of positions;
        None where it cannot be said without the points of letters.
        """
        if self.alone is not None:
            return self.alone
        told = {**dict(self.told), **spoken}
        return None if self.generic and any(map(marks_in, (*told, *map(str, kinds)))) else told

    @property
    def taken(self) -> str | None:
        """What is taken for granted of points that have places, as advice; None where there are none."""
        if self.space.rank == _PLANE:
            return "points that are given on one conic are taken to differ" if self.places else None
        for letter in conics_of(self.places):
            a, *others = (self.places.get(n) for n in conic_points(letter, _SPACE))
            if a is None or not any(others):
                continue
            b = others[0]
            if b is None:
                return f"the points {a} and {others[1]} are taken to differ"
            hint = f"the points {a} and {b} are taken to differ, and their line not to be on {letter}"
            said = all(SHORT_NAME.fullmatch(n) or n in self.space.declared() for n in (a, b))
            return f"{hint}; if it is, assume incident({b}, polar({a}, {letter}))" if said else hint
        return None

    def spoken(self, e: Expr) -> tuple[str, str] | None:
        """A condition and what it means, as text in which polars are said in words; None for one that holds anyway: no
        polar of a point is zero, and no three different points of a conic are on a line.
        """
        if isinstance(e, ex.Bracket) and any(on.issuperset(e.args) for on in self._together()):
            return None
        if any(some.issuperset(points_of(e)) for some in self.generic):
            return None
        names = self.space.declared()
        if (isinstance(e, ex.Sum) or self.generic) and not e.step and (told := self._scalar(e)) is not None:
            return told
        shown, meaning = text(e, names=names), words(e, names)
        for part in subexpressions(e):
            if not isinstance(part, ex.Sum) or not part.step or (found := self._polar(part)) is None:
                continue
            polar, flat = found
            if part == e:
                exists = flat.step == 1 or named_letter(flat) is not None
                return None if exists else (text(flat, names=names), words(flat, names))
            long = text(part, names=names)
            shown, meaning = (t.replace(f"({long})", polar).replace(long, polar) for t in (shown, meaning))
        return shown, meaning

    def _together(self) -> Iterable[set[Expr]]:
        """Of each conic the points that have places of its own."""
        for conic in conics_of(self.places):
            yield {Point(self.places[n]) for n in conic_points(conic) if n in self.places}

    def _scalar(self, e: Expr) -> tuple[str, str] | None:
        """The form of a letter at a point, or at two points, that a scalar is up to a number, with what it means."""
        names, own, form = self._names(e), [n for n in points_of(e) if conic_of(n) is None], FORMS[self.space.rank]
        for letter, points in self._letters(names):
            for p in own:
                if self._multiple(e, form.value(Point(p), *points), names):
                    return f"{form.word}({p}, {letter})", f"{p} is not on {letter}"
                for q in own:
                    pair = ex.join(Point(q), form.polar(Point(p), *points), rank=form.rank)
                    if p != q and self._multiple(e, pair, names):
                        return f"{q} \\/ polar({p}, {letter})", f"{q} is not on the polar of {p}"
        return None

    def _polar(self, part: Expr) -> tuple[str, Expr] | None:
        """The polar or pole that a line, a plane or a point is up to a number, in words, and of what it is that."""
        names, rank = self._names(part), self.space.rank
        for letter, points in self._letters(names):
            for some in combinations((n for n in points_of(part) if conic_of(n) is None), rank - part.step):
                flat = ex.join(*map(Point, some), rank=rank)
                word, polar = polar_of(flat, points, rank)
                if self._multiple(part, polar, names):
                    return f"{word}({text(flat, names=self.space.declared())}, {letter})", flat
        return None

    def _names(self, e: Expr) -> tuple[str, ...]:
        return points_of(*(s for pair in self.claimed.equations for s in pair), *_expressions(self.space.given), e)

    def _letters(self, names: Sequence[str]) -> Iterable[tuple[str, tuple[Expr, ...]]]:
        """Each letter with the points that stand for it."""
        for letter in conics_of((*names, *self.places)):
            own = conic_points(letter, self.space.rank)
            yield letter, tuple(Point(self.places.get(n, n)) for n in own)

    def _multiple(self, one: Expr, other: Expr, names: Sequence[str]) -> bool:
        """Whether one extensor is the other times a number, at exact random points."""
        if {*points_of(other)} - {*names}:
            return False
        ratios: set[int] = set()
        rank = self.space.rank
        for seed in range(3):
            rng = Random(f"{names}{seed}")
            at = Evaluator({n: tuple(rng.randrange(PRIME) for _ in range(rank)) for n in names}, rank, PRIME)
            left, right = ([v % PRIME for v in at.value(e)] for e in (one, other))
            if not all(right):
                return False
            ratios.update(v * pow(w, -1, PRIME) % PRIME for v, w in zip(left, right, strict=True))
        return len(ratios) == 1 and 0 not in ratios


def seated(claimed: Claimed, at: Space) -> Seated:
    """The claim, of conics that are no pairs of lines and quadrics that are no cones, with points that are given on
    them in place of their own.
    """
    sides = (e for pair in claimed.equations for e in pair)
    names = points_of(*sides, *_expressions(at.given), *claimed.nonzero)
    letters = conics_of(names)
    if not letters:
        return Seated(claimed, at)
    form = FORMS[at.rank]
    lines = on_lines(at, letters) if at.rank == _SPACE else OnLines(at.given)
    at = replace(at, given=tuple(a for given in lines.given for a in _resolved(given, at)))
    seats = SEATS[at.rank]({name: given_on(name, at) for name in letters}, at, names)
    unbound = [a for a in lines.given if a not in seats.bound]
    flats = tower(unbound, at, seats.fixed) if at.rank == _SPACE else None
    proper = (form.proper(*form.own(name)) for name in letters)
    claimed = replace(claimed, nonzero=tuple(dict.fromkeys((*claimed.nonzero, *proper))))
    if not seats.places:
        return Seated(claimed, at, irreducible=seats.irreducible, generic=seats.generic, flats=flats)
    seated_apart = {frozenset(points_of(e)) for e in seats.apart}
    apart = [e for e in lines.apart if frozenset(points_of(e)) not in seated_apart]
    differ = tuple((text(e), words(e)) for e in apart)

    put = partial(_put, places=seats.places, rank=at.rank)
    return Seated(
        replace(
            claimed,
            equations=tuple((put(left), put(right)) for left, right in claimed.equations),
            required=tuple(replace(r, expr=put(r.expr)) for r in claimed.required),
            nonzero=(*map(put, claimed.nonzero), *seats.apart, *apart),
            args=tuple(map(put, claimed.args)),
        ),
        replace(at, given=tuple(_moved(a, put) for a in at.given if a not in seats.used)),
        seats.places,
        (*seats.told, *differ),
        seats.irreducible,
        seats.generic,
        flats,
        (*seats.differ, *differ),
    )


def _put(e: Expr, places: Mapping[str, str], rank: int) -> Expr:
    return substitute(e, {n: Point(p) for n, p in places.items()}, rank) if places else e


@contextmanager
def in_words(placed: Seated, letters: Sequence[str], given: Sequence[Assumption]) -> Iterator[None]:
    """InputErrors about what is made of assumptions, which are `given`, say it of the letters."""
    try:
        yield
    except InputError as fault:
        nowhere = isinstance(fault, Nowhere)
        if marks_in(fault.message) or (placed.generic and placed.places and nowhere):
            fault.message = (_VANISHING if nowhere else _UNRESOLVED).format(listed(letters))
        fault.hint = fault.hint or placed.taken
        place = next((a.place for a in given[::-1] if a.place is not None), None)
        if nowhere and place is not None:
            fault.located(place.source, place.filename, place.span)
        raise


_UNRESOLVED = "the assumptions about {} cannot be resolved"
_VANISHING = (
    "something that is said to exist vanishes at all positions that were found to satisfy what is assumed of {}"
)


def _expressions(given: Iterable[Assumption]) -> tuple[Expr, ...]:
    return tuple(e for a in given for e in (*a.args, *a.also, *a.exists))


def _resolved(a: Assumption, at: Space) -> Iterable[Assumption]:
    """That a point is on the polar line of a line, as that it is on the polar planes of two points of this."""
    if at.rank != _SPACE or a.kind != "incident" or {e.step for e in a.args} != {1, 2}:
        return [a]
    point, polar = sorted(a.args, key=lambda e: e.step)
    line = polar_of_line(polar)
    if not isinstance(line, ex.Join):
        return [a]
    (letter,) = conics_of(points_of(polar))
    planes = (FORMS[_SPACE].polar(p, *FORMS[_SPACE].own(letter)) for p in line.args)
    return [replace(a, args=(point, plane), exists=(*a.exists, line)) for plane in planes]


def _moved(a: Assumption, put: Callable[[Expr], Expr]) -> Assumption:
    args, also, exists = (tuple(map(put, some)) for some in (a.args, a.also, a.exists))
    return replace(a, args=args, also=also, exists=exists)
