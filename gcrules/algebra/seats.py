r"""Points that are given on a conic or a quadric take the places of points of its letter: which, and what that assumes.

Any five different points of a conic determine it. Of a quadric any two points whose line is not on it are opposite
corners of a tetrahedron by which it is given (see `quadric_forms`), and any two others are neighbours.

Of quadrics some conditions need not be told. Let B be a polynomial in the points of a letter Q, in points of which
nothing is given but that they are on Q, and in points of which nothing is given. Whatever else there is, these points
run through an irreducible variety over it. All tetrahedra are alike under linear maps, and B is not zero for all such
points of one of them, so not of any: what is proved where B does not vanish holds on a dense set, and so everywhere.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import combinations

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.nondegeneracy import words
from gcrules.algebra.expr import Expr, Point, points_of
from gcrules.algebra.language.text import text
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conic_of, conic_points
from gcrules.algebra.space import Assumption, Space
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["SEATS", "Found", "Seats", "conjugate", "given_on"]

_PLANE, _SPACE = 3, 4

Found = Mapping[str, Mapping[str, Sequence[Assumption]]]
"""Of each letter the points that are given on it, each with the assumptions that say so."""


@dataclass(frozen=True, slots=True)
class Seats:
    """The points that take the `places` of those of letters, by the assumptions that are `used` up then. They are
    assumed to be `apart`: expressions, and what is told of it, as texts with their meanings. Nothing is assumed where
    the positions are `irreducible`; conditions on points of one of the sets in `generic` are not told. Of the used
    ones those are `bound` that say that points are on a line of a quadric; these points are `fixed`, and `differ`.
    """

    places: Mapping[str, str]
    used: frozenset[Assumption]
    apart: tuple[Expr, ...] = ()
    told: tuple[tuple[str, str], ...] = ()
    irreducible: bool = False
    generic: tuple[frozenset[str], ...] = ()
    bound: frozenset[Assumption] = frozenset()
    differ: tuple[tuple[str, str], ...] = ()

    @property
    def fixed(self) -> frozenset[str]:
        """The points of lines that are on quadrics."""
        return frozenset(n for e in self.apart for n in points_of(e))


def _on_conics(found: Found, at: Space, names: Sequence[str]) -> Seats:
    own = {name: conic_points(name, _PLANE) for name in found}
    seats = {name: tuple(on)[: len(own[name])] for name, on in found.items()}
    places = {n: p for name, some in seats.items() for n, p in zip(own[name], some, strict=False)}
    used = frozenset(a for name, some in seats.items() for p in some for a in found[name][p])
    several = [p for on in found.values() for p in on]
    alone = len(set(several)) == len(several) and not set(several) & set(at.ideal)
    on_conics = {a for on in found.values() for some in on.values() for a in some}
    irreducible = bool(found) and alone and all(a in on_conics for a in at.given)
    apart = dict.fromkeys(pair for some in seats.values() for pair in combinations(some, 2))
    pairs = tuple(ex.join(Point(p), Point(q), rank=_PLANE) for p, q in apart)
    told = tuple((text(e), words(e)) for e in pairs)
    return Seats(FrozenMap(places), used, pairs, told, irreducible)


def _on_quadrics(found: Found, at: Space, names: Sequence[str]) -> Seats:
    """Up to two points of each quadric, first those of which more is given."""
    places: dict[str, str] = {}
    used: set[Assumption] = set()
    bound: set[Assumption] = set()
    apart: list[Expr] = []
    told: dict[str, str] = {}
    generic = []
    often = Counter(n for a in at.given for n in points_of(*a.args, *a.also, *a.exists))
    for letter, on in found.items():
        corners = conic_points(letter, _SPACE)
        free = {n for n in names if n not in at.ideal and often[n] <= len(on.get(n, ()))}
        order = sorted(on, key=lambda n: -often[n])
        pair, said = next(
            ((pair, both) for pair in combinations(order, 2) if (both := conjugate(*pair, letter, at))),
            (order[:2], frozenset[Assumption]()),
        )
        seats = dict(zip((corners[0], corners[2 if said else 1]), pair, strict=False))
        used |= said
        if said:
            line = ex.join(*map(Point, pair), rank=_SPACE)
            apart.append(line)
            told[text(line)] = words(line)
            bound |= {*said, *(a for p in pair for a in on[p])}
        elif len(pair) > 1 and not free.intersection(pair):
            told[f"{pair[1]} \\/ polar({pair[0]}, {letter})"] = f"the line {''.join(pair)} is not on {letter}"
        used |= {a for p in seats.values() for a in on[p]}
        places |= seats
        generic.append(frozenset({*corners, *seats.values(), *free}))
    return Seats(
        FrozenMap(places),
        frozenset(used),
        tuple(apart),
        tuple(told.items()),
        generic=tuple(generic),
        bound=frozenset(bound),
        differ=tuple((text(e), words(e)) for e in apart),
    )


def conjugate(p: str, q: str, letter: str, at: Space) -> frozenset[Assumption]:
    """The assumptions that say that two points are conjugate, if there are any."""
    form, own = FORMS[_SPACE], FORMS[_SPACE].own(letter)
    pairs = [{Point(a), form.polar(Point(b), *own)} for a, b in ((p, q), (q, p))]
    return frozenset(a for a in at.given if a.kind == "incident" and set(a.args) in pairs)


def given_on(letter: str, at: Space) -> dict[str, list[Assumption]]:
    """The points that are assumed to be on a conic or a quadric, each with the assumptions that say so."""
    form = FORMS[at.rank]
    own = form.own(letter)
    found: dict[str, list[Assumption]] = {}
    for a in at.given:
        others = [n for n in points_of(*a.args) if Point(n) not in own] if a.kind == "zero" else []
        if len(others) == 1 and conic_of(others[0]) is None and a.args[0] == form.value(Point(others[0]), *own):
            found.setdefault(others[0], []).append(a)
    return found


SEATS = {_PLANE: _on_conics, _SPACE: _on_quadrics}
"""For each rank how points take places of those of letters."""
