r"""Claims about conic letters, decided with points that are given on a conic in place of its own.

A conic K is no pair of lines. Any five different points of it determine it, so that points which an assumption puts on
it take the places of K¹, …, K⁵; then nothing is left of the assumption but that these points differ. What is proved
about them and the rest of K¹, …, K⁵ holds whichever points of K the rest are.

>>> from gcrules.algebra.language.relations import parse_claim
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> at = parse_assumption("conic K, on_conic(a, b, K)", Context(3))
>>> found = seated(parse_claim("incident(c, K)", at), at)
>>> dict(found.places), found.space.given
({'K¹': 'a', 'K²': 'b'}, ())
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from random import Random

from gcrules.algebra import conics
from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.nondegeneracy import words
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, Point, points_of, subexpressions
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import conic_of, conic_points, conics_of
from gcrules.algebra.parts import substitute
from gcrules.algebra.space import Assumption, Space
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["Seated", "seated"]

_PLANE = 3
_FIVE = 5


@dataclass(frozen=True, slots=True)
class Seated:
    """A claim with what is given, in which the points of `places` have others in their place.

    These are assumed to differ, as pairs in `apart`, unless the positions are `irreducible` without that: then those at
    which they differ, and nothing else vanishes that a proof asks for, are dense among all.
    """

    claimed: Claimed
    space: Space
    places: Mapping[str, str] = FrozenMap()
    apart: tuple[Expr, ...] = ()
    irreducible: bool = False

    def spoken(self, e: Expr) -> tuple[str, str] | None:
        """A condition and what it means, as text in which polars are said in words; None for one that holds anyway: no
        polar of a point is zero, and no three different points of a conic are on a line.
        """
        if isinstance(e, ex.Bracket) and any(on.issuperset(e.args) for on in self._together()):
            return None
        names = self.space.declared()
        if isinstance(e, ex.Sum) and not e.step and (told := self._scalar(e)) is not None:
            return told
        shown, meaning = text(e, names=names), words(e, names)
        for part in subexpressions(e):
            if not isinstance(part, ex.Sum) or part.step != 2 or (polar := self._polar(part)) is None:
                continue
            if part == e:
                return None
            long = text(part, names=names)
            shown, meaning = (t.replace(f"({long})", polar).replace(long, polar) for t in (shown, meaning))
        return shown, meaning

    def _together(self) -> Iterable[set[Expr]]:
        """Of each conic the points that have places of its own."""
        for conic in conics_of(self.places):
            yield {Point(self.places[n]) for n in conic_points(conic) if n in self.places}

    def _scalar(self, e: Expr) -> tuple[str, str] | None:
        """The form of a conic at a point, or at two points, that a scalar is up to a number, with what it means."""
        names, own = self._names(e), [n for n in points_of(e) if conic_of(n) is None]
        for conic, five in self._conics(names):
            for p in own:
                if _multiple(e, conics.value(Point(p), *five), names):
                    return f"conic({p}, {conic})", f"{p} is not on {conic}"
                for q in own:
                    pair = ex.join(Point(q), conics.polar(Point(p), *five), rank=_PLANE)
                    if p != q and _multiple(e, pair, names):
                        return f"{q} \\/ polar({p}, {conic})", f"{q} is not on the polar of {p}"
        return None

    def _polar(self, line: Expr) -> str | None:
        """The polar that a line is up to a number, in words."""
        names = self._names(line)
        for conic, five in self._conics(names):
            for name in (n for n in points_of(line) if conic_of(n) is None):
                if _multiple(line, conics.polar(Point(name), *five), names):
                    return f"polar({name}, {conic})"
        return None

    def _names(self, e: Expr) -> tuple[str, ...]:
        return points_of(*(s for pair in self.claimed.equations for s in pair), *_expressions(self.space.given), e)

    def _conics(self, names: Sequence[str]) -> Iterable[tuple[str, tuple[Expr, ...]]]:
        """Each conic with the five points that stand for it."""
        for conic in conics_of((*names, *self.places)):
            yield conic, tuple(Point(self.places.get(n, n)) for n in conic_points(conic))


def seated(claimed: Claimed, at: Space) -> Seated:
    """The claim, of conics that are no pairs of lines, with points that are given on them in place of their own."""
    sides = (e for pair in claimed.equations for e in pair)
    names = points_of(*sides, *_expressions(at.given), *claimed.nonzero)
    letters = conics_of(names)
    found = {name: _given_on(name, at.given) for name in letters}
    seats = {name: tuple(on)[:_FIVE] for name, on in found.items()}
    places = {n: p for name, some in seats.items() for n, p in zip(conic_points(name), some, strict=False)}
    used = {a for name, some in seats.items() for p in some for a in found[name][p]}
    rest = tuple(a for a in at.given if a not in used)
    several = [p for on in found.values() for p in on]
    alone = len(set(several)) == len(several) and not set(several) & set(at.ideal)
    on_conics = {a for on in found.values() for some in on.values() for a in some}
    irreducible = bool(letters) and alone and all(a in on_conics for a in at.given)
    proper = (conics.discriminant(*map(Point, conic_points(name))) for name in letters)
    claimed = replace(claimed, nonzero=tuple(dict.fromkeys((*claimed.nonzero, *proper))))
    if not places:
        return Seated(claimed, at, irreducible=irreducible)
    seat: dict[str, Expr] = {n: Point(p) for n, p in places.items()}
    apart = dict.fromkeys(pair for some in seats.values() for pair in combinations(some, 2))
    pairs = tuple(ex.join(Point(p), Point(q), rank=_PLANE) for p, q in apart)

    def put(e: Expr) -> Expr:
        return substitute(e, seat, _PLANE)

    return Seated(
        replace(
            claimed,
            equations=tuple((put(left), put(right)) for left, right in claimed.equations),
            required=tuple(replace(r, expr=put(r.expr)) for r in claimed.required),
            nonzero=(*map(put, claimed.nonzero), *pairs),
            args=tuple(map(put, claimed.args)),
        ),
        replace(at, given=tuple(_moved(a, seat) for a in rest)),
        FrozenMap(places),
        pairs,
        irreducible,
    )


def _multiple(line: Expr, other: Expr, names: Sequence[str]) -> bool:
    """Whether one line is the other times a number, at exact random points."""
    if {*points_of(other)} - {*names}:
        return False
    ratios: set[int] = set()
    for seed in range(3):
        rng = Random(f"{names}{seed}")
        at = Evaluator({n: tuple(rng.randrange(PRIME) for _ in range(_PLANE)) for n in names}, _PLANE, PRIME)
        one, two = ([v % PRIME for v in at.value(e)] for e in (line, other))
        if not all(two):
            return False
        ratios.update(v * pow(w, -1, PRIME) % PRIME for v, w in zip(one, two, strict=True))
    return len(ratios) == 1 and 0 not in ratios


def _expressions(given: Iterable[Assumption]) -> tuple[Expr, ...]:
    return tuple(e for a in given for e in (*a.args, *a.also, *a.exists))


def _moved(a: Assumption, seat: Mapping[str, Expr]) -> Assumption:
    args, also, exists = (tuple(substitute(e, seat, _PLANE) for e in some) for some in (a.args, a.also, a.exists))
    return replace(a, args=args, also=also, exists=exists)


def _given_on(conic: str, given: Iterable[Assumption]) -> dict[str, list[Assumption]]:
    """The points that are assumed to be on a conic, each with the assumptions that say so."""
    five = tuple(map(Point, conic_points(conic)))
    found: dict[str, list[Assumption]] = {}
    for a in given:
        others = [n for n in points_of(*a.args) if n not in conic_points(conic)] if a.kind == "zero" else []
        if len(others) == 1 and conic_of(others[0]) is None and a.args[0] == conics.value(Point(others[0]), *five):
            found.setdefault(others[0], []).append(a)
    return found
