r"""A problem in names of its own: what is found for it cannot depend on how its points are called, on the order in
which assumptions stand, or on how each of them is spelled.

Points get the names p1, p2, … in an order that the assumptions alone tell: colours are refined until points that differ
in what is said of them have different ones; where several are left with one colour, each of them is taken out in turn,
and the arrangement is kept in which the assumptions, brought into one form, come first in the order of texts. What is
left to choose is a symmetry of the assumptions, and then the claim decides in the same way.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> for text in ("incident(x, ab), [xac] == [dbx]", "[acd] == [dbe], incident(d, ea)"):
...     given = parse_assumption(text, Context(rank=3)).given
...     print(*canonical(3, points_of(*(e for a in given for e in a.args)), (), given).given, sep=", ")
incident(p1, p2p3), [p1p2p4] + [p1p3p5] == 0
incident(p1, p2p3), [p1p2p4] + [p1p3p5] == 0
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any, TypeVar

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Dotted, Expr, Number, Point, Power, Sum, points_of
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.algebra.letters import without_marks
from gcrules.algebra.names import point_key
from gcrules.algebra.parts import substitute
from gcrules.algebra.space import Assumption
from gcrules.algebra.spelling import Key, normal, split
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError
from gcrules.core.frozen import FrozenMap

__all__ = ["Canonical", "canonical", "renamings"]

MAX_LEAVES = 400  # arrangements that are compared
MAX_CLAIM = 2_000  # parts of a claim that is looked at

_Fault = TypeVar("_Fault", bound=GcrulesError)


def _stated(a: Assumption, place: Mapping[str, int], rank: int) -> tuple[Key, tuple[Expr, ...]]:
    """An assumption in one form, with its key."""
    parts = [normal(e, place, rank) for e in a.args]
    if a.kind == "zero":
        return ("zero", parts[0].factor != 0, parts[0].key), (parts[0].expr,)
    # An extensor that is always zero stays what it is written as.
    shown = [(p.key, p.expr) if p.factor else ((10, e.step), e) for p, e in zip(parts, a.args, strict=True)]
    found = sorted(shown, key=lambda item: item[0])
    if a.kind != "incident":
        found = list(dict(found).items())
    return (a.kind, True, *(key for key, _ in found)), tuple(e for _, e in found)


# --- the order of the points ----------------------------------------------------------------------------------------


class _Names:
    """The points of expressions, and sums as numbers and what they multiply; looked up again and again."""

    def __init__(self) -> None:
        self._inside: dict[Expr, frozenset[str]] = {}
        self._terms: dict[Expr, list[tuple[Fraction, Expr]]] = {}

    def inside(self, e: Expr) -> frozenset[str]:
        if e not in self._inside:
            names = map(self.inside, e.children) if e.children else [points_of(e)]
            self._inside[e] = frozenset().union(*names)
        return self._inside[e]

    def terms(self, e: Sum) -> list[tuple[Fraction, Expr]]:
        if e not in self._terms:
            self._terms[e] = [(abs(c), t) for c, t in map(split, e.terms)]
        return self._terms[e]


class _Shapes:
    """What is left of expressions in normal form if points are their colours, one of them is marked, and signs and
    orders don't count. Parts without the marked point are looked at once.
    """

    def __init__(self, colour: Mapping[str, int], names: _Names) -> None:
        self.colour = colour
        self.names = names
        self.known: dict[tuple[Expr, str], Key] = {}

    def of(self, e: Expr, marked: str) -> Key:
        at = e, marked if marked in self.names.inside(e) else ""
        if at not in self.known:
            self.known[at] = self._of(*at)
        return self.known[at]

    def _of(self, e: Expr, marked: str) -> Key:
        match e:
            case Point(name=name):
                return 0, self._colour(name, marked)
            case Sum():
                return 4, tuple(sorted((c, self.of(t, marked)) for c, t in self.names.terms(e)))
            case Number(value=value):
                return 1, abs(value)
            case Power(base=base, exponent=n):
                return 6, n, self.of(base, marked)
            case Dotted(brackets=brackets):
                return 9, tuple(sorted((self._colour(n, marked), d) for b in brackets for n, d in b))
        return 2, type(e).__name__, tuple(sorted(self.of(c, marked) for c in e.children))

    def _colour(self, name: str, marked: str) -> int:
        return -1 if name == marked else self.colour[name]


@dataclass(frozen=True)
class _Statement:
    """An assumption, or a claim, as far as the order of the points depends on it."""

    kind: str
    args: tuple[Expr, ...]
    key: Callable[[Mapping[str, int]], Key]

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(points_of(*self.args))

    def shape(self, shapes: _Shapes, marked: str) -> Key:
        return self.kind, tuple(sorted(shapes.of(e, marked) for e in self.args))


class _Arrangement:
    """Searches for the order of points in which the keys of the statements are the smallest."""

    def __init__(self, names: Sequence[str], ideal: Iterable[str], statements: Sequence[_Statement]) -> None:
        self.statements = statements
        self.holding = {n: [s for s in statements if n in s.names] for n in names}
        self.names = [n for n in names if self.holding[n]]
        self.others = [n for n in names if not self.holding[n]]  # what is said of these cancels
        at_infinity = set(ideal)
        # Points of which more is said come first: those that are constructed are sought among the last.
        often = {n: sum(s.kind != "claim" for s in self.holding[n]) for n in self.names}
        self.first = _ranks({n: (n not in at_infinity, -often[n]) for n in self.names})
        self.best: tuple[Key, tuple[str, ...], tuple[str, ...]] | None = None
        self.symmetries: list[dict[str, str]] = []
        self.leaves = 0
        self.about = _Names()
        self.place = {n: i for i, n in enumerate((*self.names, *self.others))}
        self.keys: dict[int, Key] = {}  # of statements, at these places

    def order(self) -> tuple[str, ...]:
        self._search(self.first, ())
        assert self.best is not None
        return (*self.best[1], *self.others)

    def _refined(self, colour: Mapping[str, int]) -> Mapping[str, int]:
        """Colours made finer until points of one colour are alike in all statements."""
        while True:
            checkpoint()
            shapes = _Shapes(colour, self.about)
            seen = {n: (colour[n], tuple(sorted(s.shape(shapes, n) for s in self.holding[n]))) for n in self.names}
            finer = _ranks(seen)
            if len(set(finer.values())) == len(set(colour.values())):
                return finer
            colour = finer

    def _search(self, colour: Mapping[str, int], path: tuple[str, ...]) -> int:
        """The length of the path up to which nothing new is to be found any more."""
        colour = self._refined(colour)
        sizes = Counter(colour.values())
        cell = min((c for c, n in sizes.items() if n > 1), default=None)
        if cell is None:
            return self._leaf(tuple(sorted(self.names, key=colour.__getitem__)), path)
        alike = [n for n in self.names if colour[n] == cell]
        if all(self._exchanged(one, other) for one, other in pairwise(alike)):
            # Any two of them may change places; so it does not matter which comes first.
            many = len(alike)
            finer = {n: many * c + (alike.index(n) if c == cell else 0) for n, c in colour.items()}
            return min(self._search(finer, (*path, *alike)), len(path))
        tried: list[str] = []
        for name in alike:
            if self.leaves >= MAX_LEAVES:
                break
            if tried and self._alike(name, tried, path):
                continue
            back = self._search({n: 2 * c - (n == name) for n, c in colour.items()}, (*path, name))
            if back < len(path):
                return back
            tried.append(name)
        return len(path)

    def _exchanged(self, one: str, other: str) -> bool:
        """Whether it is a symmetry that two points change places, which is kept then."""
        changed = {**self.place, one: self.place[other], other: self.place[one]}
        about = {id(s): s for s in (*self.holding[one], *self.holding[other])}.values()
        for claims in (False, True):  # which take longer
            some = [s for s in about if (s.kind == "claim") == claims]
            if sorted((s.kind, self._key(s)) for s in some) != sorted((s.kind, s.key(changed)) for s in some):
                return False
        self.symmetries.append({**{n: n for n in self.names}, one: other, other: one})
        return True

    def _key(self, s: _Statement) -> Key:
        if id(s) not in self.keys:
            self.keys[id(s)] = s.key(self.place)
        return self.keys[id(s)]

    def _alike(self, name: str, tried: Sequence[str], path: Sequence[str]) -> bool:
        """Whether a symmetry that leaves the path as it is leads to a point that was tried."""
        useful = [s for s in self.symmetries if all(s[n] == n for n in path)]
        seen, waiting = {name}, [name]
        while waiting:
            at = waiting.pop()
            for s in useful:
                if s[at] not in seen:
                    seen.add(s[at])
                    waiting.append(s[at])
        return not seen.isdisjoint(tried)

    def _leaf(self, order: tuple[str, ...], path: tuple[str, ...]) -> int:
        """Compare a complete order with the best; what is returned is the level at which to go on."""
        self.leaves += 1
        place = {n: i for i, n in enumerate((*order, *self.others))}
        groups: dict[bool, list[Key]] = {False: [], True: []}
        for s in self.statements:
            groups[s.kind == "claim"].append(s.key(place))
        key = tuple(tuple(sorted(keys)) for keys in groups.values())
        if self.best is None or key < self.best[0]:
            self.best = key, order, path
            return len(path)
        if key == self.best[0]:
            self.symmetries.append(dict(zip(order, self.best[1], strict=True)))
            together = (i for i, (a, b) in enumerate(zip(path, self.best[2], strict=False)) if a != b)
            return next(together, len(path))
        return len(path)


def _ranks(keys: Mapping[str, Any]) -> dict[str, int]:
    place = {key: i for i, key in enumerate(sorted(set(keys.values())))}
    return {n: place[key] for n, key in keys.items()}


# --- the whole problem ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Canonical:
    """`given` in canonical names, sorted; `names` maps the user's points to these; `written` holds each as it was
    written. `symmetries` permute canonical names and leave what is given as it is; together they make all of these.
    """

    names: Mapping[str, str]
    given: tuple[Assumption, ...]
    written: Mapping[str, Assumption]
    symmetries: tuple[FrozenMap[str, str], ...] = ()

    @cached_property
    def points(self) -> tuple[str, ...]:
        """The canonical names in their order."""
        return tuple(sorted(self.names.values(), key=point_key))

    @cached_property
    def users(self) -> Mapping[str, str]:
        """The user's name of each canonical one."""
        return FrozenMap({new: old for old, new in self.names.items()})

    def name_back(self, name: str) -> str:
        """Names of fresh points, as p3:1, are those of the point that they were drawn for."""
        stem, colon, rest = name.partition(":")
        return f"{self.users.get(stem, stem)}{colon}{rest}"

    def back(self, e: Expr, rank: int) -> Expr:
        """An expression in the user's names."""
        return substitute(e, {n: Point(self.name_back(n)) for n in points_of(e)}, rank)

    def words_back(self, words: str) -> str:
        """Words about canonical names in the user's."""

        def told(found: re.Match[str]) -> str:
            names = [self.users.get(n, n) for n in re.findall(r"p[0-9]+", found[0])]
            return ("" if all(map(SHORT_NAME.fullmatch, names)) else " ").join(names)

        for text, a in self.written.items():
            words = words.replace(f"the assumption {text} ", f"the assumption \0{a.text}\0 ")
        parts = words.split("\0")
        return "".join(p if i % 2 else re.sub(r"(?<![A-Za-z_'])(?:p[0-9]+)+", told, p) for i, p in enumerate(parts))

    def fault_back(self, fault: _Fault) -> _Fault:
        """The error, which speaks of the user's points now."""
        fault.message = self.words_back(fault.message)
        fault.hint = self.words_back(fault.hint) if fault.hint else None
        without_marks(fault)
        return fault


def canonical(
    rank: int,
    names: Iterable[str],
    ideal: Iterable[str],
    given: Sequence[Assumption],
    claim: Sequence[Expr] = (),
) -> Canonical:
    """The problem in canonical names. A claim (expressions, up to a factor) decides between arrangements of the points
    that are alike for the assumptions; it does not change what these are in canonical names.
    """
    return next(renamings(rank, names, ideal, given, claim))


def renamings(
    rank: int,
    names: Iterable[str],
    ideal: Iterable[str],
    given: Sequence[Assumption],
    claim: Sequence[Expr] = (),
) -> Iterator[Canonical]:
    """The problem in canonical names, and in others that depend on nothing else either."""
    order, symmetries = _order(rank, tuple(dict.fromkeys(names)), frozenset(ideal), tuple(given), tuple(claim))
    half = len(order) // 2
    for other in dict.fromkeys((order, order[::-1], (*order[half:], *order[:half]))):
        yield _renamed(rank, other, given, symmetries)


def _renamed(
    rank: int, order: Sequence[str], given: Iterable[Assumption], symmetries: Iterable[Mapping[str, str]]
) -> Canonical:
    new = {n: f"p{i + 1}" for i, n in enumerate(order)}
    place = {n: i for i, n in enumerate(order)}
    points: dict[str, Expr] = {old: Point(name) for old, name in new.items()}
    found: dict[Key, Assumption] = {}
    written: dict[str, Assumption] = {}
    for a in given:
        key, args = _stated(a, place, rank)
        args = tuple(substitute(e, points, rank) for e in args)
        text = f"{args[0]} == 0" if a.kind == "zero" else f"{a.kind}({', '.join(map(str, args))})"
        found.setdefault(key, Assumption(a.kind, args, text, a.place))
        written.setdefault(text, a)
    moved = tuple(FrozenMap({new[a]: new[b] for a, b in s.items()}) for s in symmetries)
    return Canonical(FrozenMap(new), tuple(found[key] for key in sorted(found)), FrozenMap(written), moved)


@lru_cache(maxsize=256)
def _order(
    rank: int,
    names: tuple[str, ...],
    ideal: frozenset[str],
    given: tuple[Assumption, ...],
    claim: tuple[Expr, ...],
) -> tuple[tuple[str, ...], tuple[Mapping[str, str], ...]]:
    """The canonical order of the names, and generators of the symmetries of what is given."""
    place = {n: i for i, n in enumerate(names)}
    assumed = list({_stated(a, place, rank)[0]: _assumed(a, place, rank) for a in given}.values())
    if claim and sum(1 for e in claim for _ in ex.subexpressions(e)) <= MAX_CLAIM:
        names = _Arrangement(names, ideal, [*assumed, _claimed(claim, place, rank)]).order()
    found = _Arrangement(names, ideal, assumed)
    return found.order(), tuple(FrozenMap(s) for s in found.symmetries)


def _assumed(a: Assumption, place: Mapping[str, int], rank: int) -> _Statement:
    _, args = _stated(a, place, rank)
    return _Statement(a.kind, args, lambda order: _stated(a, order, rank)[0])


def _claimed(claim: Sequence[Expr], place: Mapping[str, int], rank: int) -> _Statement:
    args = tuple(normal(e, place, rank).expr for e in claim)

    def key(order: Mapping[str, int]) -> Key:
        return tuple(sorted(normal(e, order, rank).key for e in claim))

    return _Statement("claim", args, key)
