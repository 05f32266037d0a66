"""What a theorem under assumptions says, as Coq reads it, and expressions taken apart and put together."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import reduce
from itertools import combinations, product
from typing import Any

from gcrules.algebra.proofs.theorem import Theorem
from gcrules.views.proofs.coq_expressions import Expressions, geometry, point_names

__all__ = ["CannotWrite", "Statement", "Tree", "combination", "joined", "pairs"]


_LONGEST = 100_000  # points and operations


class CannotWrite(Exception):
    """Why a theorem has no script."""


class Statement:
    """A theorem under assumptions with the names that its points have in Coq; definitions are written out."""

    def __init__(self, t: Theorem, number: int = 1, further: Sequence[str] = ()) -> None:
        """With the inverse of a whole number, where the proof divides by this, and with further points that stand for
        all.
        """
        self.number = number
        self.data = t.to_json() if t.given else t.to_json(anywhere=[])
        self.rank, self.space, self.ideal = t.rank, geometry(t.rank), t.ideal
        self.tree = Tree(self.data)
        self.placed: list[dict[str, Any]] = self.data["placed"]
        fresh = [f for p in self.placed for f in p["fresh"]]
        self.points = [n for n in self.data["points"] if n not in fresh] + [p["name"] for p in self.placed]
        self.meets = {n: self.tree.opened(e) for n, e in self.data.get("meets", ())}
        self.own = [n for n in self.points if n not in self.meets]
        self.any: list[str] = [*self.data["any"], *further]  # stand for all points
        names = [*self.points, *fresh, *self.any]
        self.coq = dict(zip(names, point_names(names), strict=True))
        self.prefix = "h_"
        while any(n.startswith(self.prefix) for n in self.coq.values()):
            self.prefix = f"h{self.prefix}"
        self.inverse = ["the inverse"] if number > 1 else []
        self.coq |= dict.fromkeys(self.inverse, f"{self.prefix}inverse")
        self.units = [f"unit {i}" for i in range(2, self.rank + 1)]
        self.coq |= {f"unit {i}": f"{self.space}_{i}" for i in range(2, self.rank + 1)}
        if sum(self.tree.size(e) for key in ("claim", "given", "nonzero") for e in self.data[key]) > _LONGEST:
            raise CannotWrite("it holds under assumptions, and is too long where all of it is written out")
        self.claim, self.given, self.nonzero = (
            [self.tree.opened(e) for e in self.data[key]] for key in ("claim", "given", "nonzero")
        )
        divided = [*self.inverse, *self.units] if self.inverse else []
        self.stated = self.among([*self.points, *divided])
        self.everywhere = self.among([*self.points, *self.any, *divided])
        if any(self.stated.whole(e)[1] != 1 for e in (*self.given, *self.nonzero)):
            raise CannotWrite("it holds under assumptions that have fractions")

    @property
    def renamed(self) -> dict[str, str]:
        """The points that have other names in Coq."""
        return {p: self.coq[p] for p in self.own if self.coq[p] != p}

    def opening(self, name: str, sides: Sequence[str]) -> list[str]:
        """The lines that state the theorem, and name its assumptions."""
        assumed = {
            "infinite": [f"infinite {self.space} {p}" for p in self.stated.points[: self.ideal]],
            "given": [self.says(e, "=") for e in self.given],
            "nonzero": [self.says(e, "<>") for e in self.nonzero],
            "number": [self.says(["number", self.number], "<>") for _ in self.inverse],
        }
        introduced = [f"{self.prefix}{kind}_{i}" for kind, those in assumed.items() for i in range(len(those))]
        return [
            f"Theorem {name} : forall {self.named(self.own)} : vector {self.space},",
            *(f"  {f'({one})' if one.startswith('forall') else one} ->" for those in assumed.values() for one in those),
            f"  {sides[0]}",
            f"  = {sides[1]}.",
            "Proof.",
            f"  intros {' '.join([self.named(self.own), *introduced])}.",
            *(
                f"  destruct ({self.space}_inverse _ {self.prefix}number_0) as [{self.coq[i]} {self.prefix}half]."
                for i in self.inverse
            ),
        ]

    def numbering(self, further: Iterable[str] = ()) -> list[str]:
        """The lines that number the points, further ones behind them, and say which are at infinity."""
        h, points = self.prefix, [*self.stated.points, *(self.coq[p] for p in further)]
        return [
            f"  pose ({h}at := fun place => nth place [{'; '.join(points)}] {points[0]}).",
            f"  assert ({h}ideal : forall i, (i < {self.ideal})%nat -> infinite {self.space} ({h}at i)).",
            "  { let n := fresh in let below := fresh in intros n below;",
            f"    do {self.ideal} (destruct n as [|n]; [assumption|]); lia. }}",
        ]

    def written_out(self, e: Any) -> Any:
        """An expression with the meets that auxiliary points are."""
        if isinstance(e, str):
            return self.meets.get(e, e)
        return e if e[0] == "number" else [e[0], *(x if isinstance(x, int) else self.written_out(x) for x in e[1:])]

    def row(self, at: Expressions) -> list[int]:
        """The bracket that is the inverse of the number by which the proof divides."""
        return [at.place[p] for p in (*self.inverse, *self.units)]

    def whole_relations(self, relations: Iterable[Any], at: Expressions) -> list[Any]:
        """Relations with whole coefficients, where the proof divides by a number times its inverse."""
        if not self.inverse:
            return list(relations)

        def term(c: Any, *rows: list[int]) -> list[Any]:
            if Fraction(c).denominator == 1:
                return [c, *rows]
            return [Fraction(c) * self.number, *sorted([*rows, self.row(at)])]

        return [[*first, [term(*one) for one in multiplier]] for *first, multiplier in relations]

    def scalar(self, number: object) -> str:
        """The point of which a scalar is a coordinate."""
        name = f"scalar {number}"
        self.coq[name] = f"{self.prefix}s_{number}"
        return name

    def named(self, points: Iterable[str]) -> str:
        """Names of Coq, one after the other."""
        return " ".join(self.coq[p] for p in points)

    def among(self, points: Sequence[str]) -> Expressions:
        """Expressions in which points have the numbers of their places among these."""
        found = Expressions("", {"rank": self.rank, "points": [], "definitions": []})
        found.points = [self.coq[p] for p in points]
        found.place = {p: i for i, p in enumerate(points)}
        found.inverse = (self.number, self.inverse[0]) if self.inverse else None
        return found

    def says(self, e: Any, sign: str) -> str:
        """That an expression vanishes (=), or that it does not (<>); for all points that its points may stand for."""
        every = self.all_of(e)
        of_all = f"forall {self.named(every)} : vector {self.space}, " if every else ""
        return f"{of_all}{self.everywhere.side(e)} {sign} number {self.space} 0"

    def for_all(self, factor: Any) -> Any:
        """Of a bracket that vanishes for all of some points the join of the others, which does, too."""
        every = self.all_of(factor)
        rest = [p for p in factor[1:] if p not in every]
        return joined(rest) if every and factor[0] == "bracket" and rest else factor

    def parts_given(self, e: Any) -> list[int]:
        """The number of what is given of which a part of an expression is; none where none is, or it is a sum."""
        if e in self.given:
            return [self.given.index(e)]
        inside = e[1:] if isinstance(e, list) and e[0] in ("join", "meet", "bracket", "product") else []
        return [n for part in inside for n in self.parts_given(part)][:1]

    def all_of(self, e: Any) -> list[str]:
        """Those that stand for all points in an expression."""
        return [p for p in self.any if p in self.tree.names(e)]


class Tree:
    """Expressions of a theorem taken apart, definitions written out."""

    def __init__(self, t: dict[str, Any]) -> None:
        self.rank: int = t["rank"]
        self.definitions = dict(t["definitions"])
        self.sizes: dict[str, int] = {}

    def opened(self, e: Any) -> Any:
        """An expression without definitions."""
        if isinstance(e, str):
            return self.opened(self.definitions[e]) if e in self.definitions else e
        if e[0] == "number":
            return e
        return [e[0], self.opened(e[1]), e[2]] if e[0] == "power" else [e[0], *map(self.opened, e[1:])]

    def size(self, e: Any) -> int:
        """How many points and operations an expression has without definitions."""
        if not isinstance(e, str):
            return 1 + sum(self.size(part) for part in e[1:] if isinstance(part, list | str)) if e[0] != "number" else 1
        if e in self.definitions and e not in self.sizes:
            self.sizes[e] = self.size(self.definitions[e])
        return self.sizes.get(e, 1)

    def args(self, e: Any, operation: str = "join") -> list[Any]:
        """The parts of a join or meet, taken apart as far as they are such; of anything else itself."""
        return [e] if isinstance(e, str) or e[0] != operation else [x for p in e[1:] for x in self.args(p, operation)]

    def key(self, e: Any, *, turned: bool = True) -> str:
        """The same for joins of the same parts in any sequence, and for meets unless they may not be `turned`; for sums
        that are the same or the negative.
        """
        if isinstance(e, str) or e[0] == "number":
            return str(e)
        if e[0] in ("sum", "product"):
            terms = sorted(self._terms(e).items())
            sign = -1 if terms and terms[0][1] < 0 else 1
            return str([(parts, str(sign * c)) for parts, c in terms])
        parts = self.args(e, e[0]) if e[0] in ("join", "meet") else e[1:]
        keys = [self.key(part, turned=turned) for part in parts]
        shown = sorted(keys) if turned or e[0] != "meet" else keys
        return f"{e[0]}({' '.join(shown)})" if len(keys) > 1 else keys[0]

    def _terms(self, e: Any) -> dict[tuple[str, ...], Fraction]:
        """A sum as products of parts with their numbers; joins and brackets of points are in one sequence."""
        if isinstance(e, str):
            return {(e,): Fraction(1)}
        if e[0] == "number":
            return {(): Fraction(e[1])}
        if e[0] in ("join", "bracket") and all(isinstance(part, str) for part in e[1:]):
            sign = (-1) ** sum(x > y for x, y in combinations(e[1:], 2))
            return {(str([e[0], *sorted(e[1:])]),): Fraction(sign)}
        if e[0] not in ("sum", "product"):
            return {(str(e),): Fraction(1)}
        found = map(self._terms, e[1:])
        if e[0] == "product":
            return reduce(_times, found)
        return _collected(item for terms in found for item in terms.items())

    def step(self, e: Any) -> int:
        """Of joins and meets, and of sums of such."""
        if isinstance(e, str):
            return 1
        if e[0] in ("number", "power", "bracket", "superbracket"):
            return 0
        if e[0] == "sum":
            return self.step(e[1])
        steps = [self.step(p) for p in e[1:]]
        return sum(steps) - (self.rank * (len(steps) - 1) if e[0] == "meet" else 0)

    def names(self, e: Any) -> set[str]:
        """The points that occur."""
        if isinstance(e, str):
            return {e}
        return set() if e[0] == "number" else {n for p in e[1:] if not isinstance(p, int) for n in self.names(p)}

    def numbers(self, e: Any) -> list[Fraction]:
        """The numbers that occur."""
        if isinstance(e, str):
            return []
        inside = (p for p in e[1:] if isinstance(p, list))
        return [Fraction(e[1])] if e[0] == "number" else [x for p in inside for x in self.numbers(p)]

    def parts(self, e: Any) -> list[Any]:
        """An expression and the parts of it that are not zero where it is not."""
        inside = e[1:] if isinstance(e, list) and e[0] in ("join", "bracket", "meet", "product") else []
        return [["join", *inside] if e[0] == "bracket" else e, *(x for part in inside for x in self.parts(part))]


def _times(
    terms: dict[tuple[str, ...], Fraction], others: dict[tuple[str, ...], Fraction]
) -> dict[tuple[str, ...], Fraction]:
    both = product(terms.items(), others.items())
    return _collected((tuple(sorted((*parts, *more))), c * k) for (parts, c), (more, k) in both)


def _collected(terms: Iterable[tuple[tuple[str, ...], Fraction]]) -> dict[tuple[str, ...], Fraction]:
    total: dict[tuple[str, ...], Fraction] = {}
    for parts, c in terms:
        total[parts] = total.get(parts, Fraction(0)) + c
    return {parts: c for parts, c in total.items() if c}


def joined(parts: Iterable[Any]) -> Any:
    """A join, or the one part itself."""
    found = list(parts)
    return found[0] if len(found) == 1 else ["join", *found]


def combination(rank: int, parts: Sequence[Any], scalars: Sequence[str]) -> Any:
    """The sum of scalars times parts, a scalar being a bracket."""
    units = [f"unit {i}" for i in range(2, rank + 1)]
    terms = [["product", ["bracket", s, *units], p] for s, p in zip(scalars, parts, strict=True)]
    return terms[0] if len(terms) == 1 else ["sum", *terms]


def pairs(names: Sequence[str]) -> str:
    """Proofs of all of some statements, as one of their conjunction."""
    found = "I"
    for n in reversed(names):
        found = f"(conj {n} {found})"
    return found
