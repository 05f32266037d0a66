"""Theorems under assumptions, as Coq proves them: points are placed one after the other, as the checker places them.

Each fact that a step uses is derived first: that the point lies on its extensor, and that this is not zero. Then points
are written as combinations of what they were placed on, and the claim is replayed. Where an extensor joins free points
and may be zero, one of these and the point that is placed is a combination of the others: a proof for each of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import chain, product
from math import lcm
from typing import Any

from gcrules.algebra.assumptions.construction import Construction
from gcrules.algebra.proofs.coverage import Flat, turned
from gcrules.algebra.proofs.sequences import Sequences
from gcrules.algebra.proofs.theorem import PlacedPoint, Theorem, with_roles
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.views.proofs.coq_expressions import derived, multiple
from gcrules.views.proofs.coq_facts import NO_RULE, Facts
from gcrules.views.proofs.coq_relations import denominator, written_relations
from gcrules.views.proofs.coq_statement import CannotWrite, Statement, Tree, combination, joined, pairs

__all__ = ["AssumedProof", "assumed_proof"]


@lru_cache(maxsize=256)
def assumed_proof(t: Theorem) -> AssumedProof | str:
    """The proof of a theorem under assumptions, or why it cannot be written."""
    try:
        return AssumedProof(t)
    except CannotWrite as why:
        return str(why)
    except LimitReached:
        return "it holds under assumptions, and where points depend on each other its proof is too long"


def _aligned(t: Theorem) -> Theorem:
    """With meets in the sequence in which they are said not to vanish."""
    wanted = Sequences(t.nonzero, t.meets, t.rank)
    c = Construction(t.rank, t.order, t.order[: t.ideal])
    c = replace(c, equations=t.given, meets=t.meets)

    def flats(p: PlacedPoint) -> tuple[Flat, ...]:
        return tuple(turned(flat, p.name, wanted.of(flat.extensor), c) or flat for flat in p.flats)

    placed = tuple(p if p.equal else replace(p, within=wanted.of(p.within), flats=flats(p)) for p in t.placed)
    return t if placed == t.placed else with_roles(replace(t, placed=placed), {})


def _divided_by(t: Theorem) -> int:
    """A whole number by which the places of points, and the reasons for these, are whole."""
    data = t.to_json() if t.given else t.to_json(anywhere=[])
    becauses = [p["equal"] for p in data["placed"] if "equal" in p]
    becauses += [b for p in data["placed"] for flat in p["flats"] for b in flat["because"]]
    tree = Tree(data)
    numbers = [x for p in data["placed"] for x in tree.numbers(tree.opened(p["on"]))]
    numbers += [Fraction(b[1]) for b in becauses if b]
    relations = [r for b in becauses for rs in b[2:] for r in rs]
    found = lcm(*(x.denominator for x in numbers), denominator(relations))
    return lcm(found, denominator(data["relations"])) if found > 1 else 1


class AssumedProof:
    """The proof of one theorem under assumptions."""

    def __init__(self, t: Theorem) -> None:
        if any(m.written_out for p in t.placed for flat in p.flats for m in flat.because) or any(
            p.equal.written_out for p in t.placed if p.equal
        ):
            raise CannotWrite("it holds under assumptions that place a point together")
        t = _aligned(t)
        self.statement = s = Statement(t, _divided_by(t))
        self.facts = Facts(s)
        self.steps: list[_Step] = []
        parts = 0
        for p in s.placed:
            on = s.tree.opened(p["on"])
            self.steps.append(_step(self.facts, p, on, parts))
            parts += len(s.tree.args(on))
        self.variants = [_Variant(s, self.steps, t, roles) for roles in self._roles()]

    def _roles(self) -> Iterator[dict[str, str]]:
        """Which points are placed instead of those that depend on others, in all ways."""
        dense = [s for s in self.steps if s.dense]
        for chosen in product(*([s.name, *s.points] for s in dense)):
            yield {s.name: by for s, by in zip(dense, chosen, strict=True) if s.name != by}

    @property
    def factor(self) -> int:
        """By what both sides are multiplied, so that all numbers are whole."""
        sides = (self.statement.stated.whole(e)[1] for e in self.statement.claim)
        return lcm(*sides, *(v.denominator for v in self.variants))

    @property
    def relations(self) -> Iterator[Any]:
        """All that it uses."""
        yield from self.facts.relations
        for v in self.variants:
            yield from v.relations

    def text(self, name: str) -> str:
        """The theorem with its proof."""
        s, stated, factor = self.statement, self.statement.stated, self.factor
        sides = [stated.side(multiple(e, factor // own)) for e, own in map(stated.whole, s.claim)]
        cases = [(v, derived(name, f"case_{n}")) for n, v in enumerate(self.variants)]
        return "\n".join(
            [
                *(line for v, case in cases for line in v.definitions(case, factor)),
                "",
                *s.opening(name, sides),
                *self.facts.auxiliary(),
                *s.numbering(),
                *self.facts.lines,
                *self._placing(name, 0, {}),
                "Qed.",
            ]
        )

    def _placing(self, name: str, number: int, roles: dict[str, str]) -> Iterator[str]:
        """The lines that place the points from one on."""
        if number == len(self.steps):
            (at,) = (n for n, v in enumerate(self.variants) if v.roles == roles)
            yield from self.variants[at].replayed(derived(name, f"case_{at}"))
            return
        step, s = self.steps[number], self.statement
        yield f"  refine ({step.lemma})."
        for by in [step.name, *step.points]:
            more = roles if by == step.name else {**roles, step.name: by}
            lines = self._placing(name, number + 1, more)
            lines = chain([f"  intros {s.named([*step.scalars, *step.fresh])} {s.prefix}on_{number}."], lines)
            yield from chain(["  {"], lines, ["  }"]) if step.dense else lines


@dataclass(frozen=True)
class _Step:
    """How a point is placed: the lemma that does it, and the expression that it is with scalars and fresh points.

    A `dense` step joins `points` that may depend on each other.
    """

    name: str
    lemma: str
    expression: Any
    scalars: tuple[str, ...]
    fresh: tuple[str, ...] = ()
    points: tuple[str, ...] = ()

    @property
    def dense(self) -> bool:
        return bool(self.points)

    def in_role(self, by: str, rank: int) -> Any:
        """The expression of a point that is placed instead of this one."""
        if by == self.name:
            return self.expression
        return combination(rank, [self.name if p == by else p for p in self.points], self.scalars)


def _step(facts: Facts, p: dict[str, Any], on: Any, first: int) -> _Step:
    """How a point is placed; scalars have numbers from `first` on."""
    s, tree, name, fresh = facts.statement, facts.tree, p["name"], tuple(p["fresh"])
    if "equal" in p:
        fact = facts.multiple_of_given(["sum", name, ["product", ["number", -1], on]], *p["equal"])
        return _Step(name, f"equal_to {s.space} _ _ {fact} _ _ _", on, ())
    if tree.names(on).intersection(fresh):
        return _on_meeting_lines(facts, name, on, fresh)
    parts = tree.args(on)
    steps, count = [tree.step(part) for part in parts], len(parts)
    scalars = tuple(s.scalar(first + i) for i in range(count))
    lies, not_zero = facts.lies(name, on), facts.not_zero(on)
    written = " ".join(map(s.stated.statement, [*parts, name]))
    if not_zero is None:
        if not all(isinstance(part, str) for part in parts):
            raise CannotWrite(NO_RULE)
        lemma = f"dependent_{count + 1}_of_{s.space} {written} {lies} _ _{' _' * (count + 1)}"
        return _Step(name, lemma, combination(s.rank, parts, scalars), scalars, (), tuple(parts))
    pure = " ".join(facts.step(part, step) for part, step in zip(parts, steps, strict=True))
    rest = f"{written} {pure} {not_zero} {lies} _ _ _"
    if set(steps) == {1}:
        return _Step(name, f"on_{count}_of_{s.space} {rest}", combination(s.rank, parts, scalars), scalars)
    line = ["meet", parts[-1], ["join", *fresh]]
    if steps == [s.rank - 1]:
        return _Step(name, f"on_hyperplane_of_{s.space} {rest}", line, (), fresh)
    if (s.rank, steps) == (4, [2]):
        return _Step(name, f"on_line_of_space {rest}", line, (), fresh)
    if (s.rank, steps) == (4, [1, 2]):
        found = ["sum", combination(s.rank, parts[:1], scalars[:1]), line]
        return _Step(name, f"on_point_and_line_of_space {rest}", found, scalars[:1], fresh)
    raise CannotWrite(NO_RULE)


def _on_meeting_lines(facts: Facts, name: str, on: Any, fresh: tuple[str, ...]) -> _Step:
    """A point on two lines of space that meet, one of which is made a plane by a fresh point."""
    tree = facts.tree
    (one, *others), (new, *more) = tree.args(on, "meet"), fresh
    kept, lines = [a for a in tree.args(one) if a != new], len(others) == 1 and not more
    if (tree.rank, [tree.step(e) for e in (joined(kept), *others)]) != (4, [2, 2]) or not lines:
        raise CannotWrite(NO_RULE)
    line, other, not_zero = joined(kept), others[0], facts.not_zero(others[0])
    for end in tree.args(other):
        spans = facts.not_zero(["join", *kept, end]) if isinstance(end, str) else None
        if spans and not_zero:
            lemma = [
                "on_meeting_lines_of_space",
                *map(facts.stated.statement, (line, other, end, name)),
                *(facts.step(line, 2), facts.step(other, 2), spans, not_zero),
                facts.vanishing(["join", other, end], ["number", 0], []),
                *(facts.lies(name, line), facts.lies(name, other)),
            ]
            return _Step(name, f"{' '.join(lemma)} _ _ _", ["meet", ["join", line, new], other], (), fresh)
    raise CannotWrite(NO_RULE)


class _Variant:
    """The claim with its points placed in one way, as data; of some steps other points are placed, in `roles`."""

    def __init__(self, s: Statement, steps: Sequence[_Step], t: Theorem, roles: dict[str, str]) -> None:
        self.statement, self.roles = s, roles
        data = with_roles(t, roles).to_json() if roles else s.data
        placed = [roles.get(step.name, step.name) for step in steps]
        free, scalars = data["points"], [x for step in steps for x in step.scalars]
        self.at = s.among([*free, *scalars, *s.inverse, *s.units, *placed])
        units = [self.at.place[u] for u in s.units]
        behind = len(self.at.points) - len(free)

        def row(old: Sequence[int]) -> list[int]:
            """Points that close an extensor come after all others, and scalars are brackets."""
            if len(old) == 1:
                return [self.at.place[f"scalar {old[0]}"], *units]
            return [x if x < len(free) else x + behind for x in old]

        self.relations = [
            [row(first), row(second), count, [[c, *sorted(map(row, rows))] for c, *rows in multiplier]]
            for first, second, count, multiplier in data["relations"]
        ]
        self.relations = s.whole_relations(self.relations, self.at)
        self.denominator = denominator(self.relations)
        self.places = [
            (self.at.place[by], self.at.data(step.in_role(by, s.rank)))
            for by, step in reversed(list(zip(placed, steps, strict=True)))
        ]

    def definitions(self, name: str, factor: int) -> list[str]:
        """Both sides times a factor, the places and the relations."""
        lines = []
        for side, (e, own) in zip(("left", "right"), map(self.at.whole, self.statement.claim), strict=True):
            lines.append(f"Definition {derived(name, side)} := {self.at.data(multiple(e, factor // own))}.")
        separated = ";\n  ".join(f"({i}, {e})" for i, e in self.places)
        lines.append(f"Definition {derived(name, 'places')} : list (nat * expression) := [\n  {separated}].")
        return [*lines, *written_relations(name, self.relations, factor)]

    def replayed(self, name: str) -> list[str]:
        """The lines that replay the claim."""
        s, points, parts = self.statement, self.at.points, ("left", "right", "places", "relations")
        on = pairs([f"{s.prefix}on_{n}" for n in reversed(range(len(self.places)))])
        lemma, divided = f"replay_placed {s.space}", ""
        if s.inverse:
            lemma = f"replay_in_fractions {s.space} {s.number} [{'; '.join(map(str, s.row(self.at)))}]"
            divided = f"{s.prefix}half (eq_refl true) "
        return [
            f"  refine ({lemma} (fun place => nth place [{'; '.join(points)}] {points[0]}) {s.ideal}",
            f"    {len(points)} {' '.join(derived(name, part) for part in parts)} {divided}_ {on} _).",
            "  - let n := fresh in let below := fresh in intros n below;",
            f"    do {s.ideal} (destruct n as [|n]; [assumption|]); lia.",
            "  - vm_cast_no_check (eq_refl true).",
        ]
