"""What follows from the assumptions of a theorem, as Coq derives it by the rules of the checker.

A fact is that something vanishes, that it does not, or of which step it is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from math import prod
from typing import Any

from gcrules.algebra.bracket import sorted_row
from gcrules.views.proofs.coq_expressions import Expressions
from gcrules.views.proofs.coq_relations import relation_texts
from gcrules.views.proofs.coq_statement import CannotWrite, Statement, combination, joined, pairs

__all__ = ["NO_RULE", "Facts"]

NO_RULE = "it holds under assumptions, with points placed in a way of which scripts have no rule"


class Facts:
    """What follows from the assumptions, each fact with a name and derived once."""

    def __init__(self, statement: Statement) -> None:
        self.statement, self.tree, self.space = statement, statement.tree, statement.space
        self.stated, self.says = statement.stated, statement.says
        self.lines: list[str] = []
        self.known: dict[str, str] = {}
        self.relations: list[Any] = []
        self.flats: dict[tuple[str, str], Any] = {
            (p["name"], self.tree.key(self.tree.opened(flat["flat"]))): flat
            for p in statement.placed
            for flat in p["flats"]
        }

    def _new(self, statement: str, proof: Iterable[str]) -> str:
        """The name of a fact, which has this proof where it is new."""
        if statement in self.known:
            return self.known[statement]
        name = f"{self.statement.prefix}{len(self.known) + 1}"
        self.known[statement] = name
        self.lines += [f"  assert ({name} : {statement}).", "  {", *(f"    {line}" for line in proof), "  }"]
        return name

    def auxiliary(self) -> Iterator[str]:
        """The lines that give meets the names of auxiliary points, before anything is derived."""
        s, own = self.statement, self.statement.among(self.statement.own)
        for n, (point, e) in enumerate(s.meets.items()):
            step = f"{s.prefix}meet_{n}"
            yield f"  assert ({step} : pure {self.space} 1 {own.statement(e)})."
            yield f"  {{ refine (of_step_sound {self.space} (fun place => nth place [{'; '.join(own.points)}]"
            yield f"      {own.points[0]}) 0 1 {own.data(e)} (below_0 _ _) _). vm_cast_no_check (eq_refl true). }}"
            yield f"  destruct ({self.space}_is_point _ {step}) as [{s.coq[point]} {self._named(point)}]."

    def _named(self, auxiliary: str) -> str:
        return f"{self.statement.prefix}is_{self.statement.coq[auxiliary]}"

    def _of_auxiliary(self, e: Any, sign: str, fact: str) -> str:
        """A fact about meets, as one about the auxiliary points that they are."""
        names = sorted(self.tree.names(e).intersection(self.statement.meets))
        rewritten = " ".join(f"rewrite <- {self._named(n)}." for n in names)
        return self._new(self.says(e, sign), [f"{rewritten} exact {fact}."])

    def follows(
        self,
        e: Any,
        because: Any,
        rewritten: Iterable[str],
        relations: Sequence[Any] = (),
        at: Expressions | None = None,
    ) -> list[str]:
        """The proof that an expression vanishes since another one of the same value, up to relations, does; of points
        that are numbered as `at` says.
        """
        h, stated = self.statement.prefix, at or self.stated
        separated = "; ".join(relation_texts(relations))
        steps = "".join(f"rewrite {r}. " for r in rewritten)
        lemma, given = f"follows_sound {self.space}", ""
        if self.statement.inverse:
            row = "; ".join(map(str, self.statement.row(stated)))
            lemma = f"follows_in_fractions_sound {self.space} {self.statement.number} [{row}]"
            given = f"{h}half (eq_refl true) "
        return [
            f"refine ({lemma} {h}at {self.statement.ideal} {len(stated.points)}",
            f"  {stated.data(e)} {stated.data(because)} [{separated}] {given}{h}ideal _ _).",
            f"- change ({stated.side(because)} = number {self.space} 0). {steps}vanishes.",
            "- vm_cast_no_check (eq_refl true).",
        ]

    def for_all(self, e: Any, because: Any, fact: str) -> Iterator[str]:
        """The proof that an expression vanishes since it does so joined with all points, as a fact says."""
        s, h, every = self.statement, self.statement.prefix, self.statement.all_of(because)
        at = s.among([*s.points, *every])
        pattern = ""
        for p in reversed(every):
            pattern = f"[|{s.coq[p]} {pattern or '[|]'}]"
        yield f"refine (for_all_sound {self.space} {h}at {s.ideal} {len(s.points)} {len(every)}"
        yield f"  {at.data(e)} {at.data(because)} {h}ideal _ _)."
        yield f"- intros l {h}l. destruct l as {pattern}; try discriminate. exact ({fact} {s.named(every)})."
        yield "- vm_cast_no_check (eq_refl true)."

    def vanishing(self, e: Any, because: Any, rewritten: Iterable[str]) -> str:
        """The fact that an expression vanishes."""
        statement = self.says(e, "=")
        return self.known.get(statement) or self._new(statement, self.follows(e, because, rewritten))

    def step(self, e: Any, step: int) -> str:
        """The fact that an expression is an extensor of some step."""
        statement = f"pure {self.space} {step} {self.stated.statement(e)}"
        if statement in self.known:
            return self.known[statement]
        h = self.statement.prefix
        proof = [
            f"refine (of_step_sound {self.space} {h}at {self.statement.ideal} {step}",
            f"  {self.stated.data(e)} {h}ideal _).",
            "vm_cast_no_check (eq_refl true).",
        ]
        return self._new(statement, proof)

    def multiple_of_given(self, e: Any, index: int | None = None, number: Any = 0, relations: Any = ()) -> str:
        """The fact that an expression vanishes, as it stands or as a multiple of something given and of relations."""
        statement, factor = self.says(e, "="), Fraction(number)
        if statement in self.known:
            return self.known[statement]
        opened = self.statement.written_out(e)
        if opened != e:
            return self._of_auxiliary(e, "=", self.multiple_of_given(opened, index, number, relations))
        if index is None:
            return self.vanishing(e, ["number", 0], [])
        because = self.statement.given[index]
        if self.statement.all_of(because):
            raise CannotWrite("it holds under an assumption for all points by which a point is placed")
        because = because if factor == 1 else ["product", ["number", str(factor)], because]
        given = [f"{self.statement.prefix}given_{index}"]
        return self._new(statement, self.follows(e, because, given, self._numbered(relations)))

    def _numbered(self, relations: Any) -> list[Any]:
        """Relations of the points that the theorem names, by the places that all points have."""
        data = self.statement.data
        names = [*data["points"], *data["any"], *(p["name"] for p in data["placed"])]
        place = [self.stated.place.get(n, -1) for n in names if n not in self.statement.meets]
        place += range(len(self.stated.points), len(self.stated.points) + data["rank"])  # those that close extensors

        def row(points: Sequence[int]) -> list[int]:
            return [place[i] for i in points]

        def term(c: Any, *rows: Sequence[int]) -> list[Any]:
            """Its rows in order, with the sign that they then have."""
            sign = prod(sorted_row(row(points))[0] for points in rows)
            return [sign * Fraction(c), *sorted(sorted(row(points)) for points in rows)]

        found = [
            [row(first), row(second), count, [term(*one) for one in multiplier]]
            for first, second, count, multiplier in relations
        ]
        found = self.statement.whole_relations(found, self.stated)
        self.relations += found
        return found

    def lies(self, name: str, e: Any) -> str:
        """The fact that a point lies on an extensor: their join vanishes."""
        both = ["join", e, name]
        flat = self.flats.get((name, self.tree.key(e)))
        if flat is not None:
            own = ["join", self.tree.opened(flat["flat"]), name]
            if self.tree.key(both, turned=False) != self.tree.key(own, turned=False):
                raise CannotWrite("it holds under assumptions on meets that stand in another sequence")
            return self.vanishing(both, own, [self._flat(own, flat)])
        if isinstance(e, list) and e[0] == "meet":
            *first, last = e[1:]
            one = first[0] if len(first) == 1 else ["meet", *first]
            left, right = self.lies(name, one), self.lies(name, last)
            turned = self.vanishing(["join", name, last], ["join", last, name], [right])
            return self._new(self.says(both, "="), [f"exact (on_meet {self.space} _ _ _ {left} {turned})."])
        raise CannotWrite(NO_RULE)

    def _flat(self, e: Any, flat: dict[str, Any]) -> str:
        """The fact that a flat joined with the point vanishes."""
        if flat["room"] is None:
            return self.multiple_of_given(e, *flat["because"][0])
        room, args = self.tree.opened(flat["room"]), self.tree.args(e)
        points, not_zero = self.tree.args(room), self.not_zero(room)
        others = list(zip((a for a in args if a not in points), flat["because"], strict=True))
        if not_zero is None:
            raise CannotWrite(NO_RULE)
        if all(isinstance(part, str) for part, _ in others):
            return self._new(self.says(e, "="), self._no_room(e, points, others, not_zero))
        ((part, why), *more) = others
        if more or (self.tree.rank, self.tree.step(part), len(points), len(args)) != (4, 2, 3, 3):
            raise CannotWrite(NO_RULE)
        inside = self.multiple_of_given(["meet", part, room], *why)
        turned = self._new(
            self.says(["meet", room, part], "="),
            [f"exact (turned_of_space _ _ {self.step(part, 2)} {self.step(room, 3)} {inside})."],
        )
        scaled = ["product", ["bracket", *args], room]
        on = joined([["meet", room, part], *(a for a in args if a != part)])
        vanishing = self.vanishing(scaled, on, [turned])
        zero = self._new(self.says(["bracket", *args], "="), [f"exact (cancelled _ _ _ {vanishing} {not_zero})."])
        return self.vanishing(e, ["bracket", *args], [zero])

    def _no_room(self, e: Any, points: list[str], others: list[tuple[str, Any]], not_zero: str) -> list[str]:
        """The proof that more points than there is room for are dependent: those that span it combine to the others."""
        s, h, k, room = self.statement, self.statement.prefix, len(points), joined(points)
        say = self.stated.statement
        pure = " ".join(self.step(p, 1) for p in points)
        lines, scalars = [], {part: [s.scalar(f"{n}_{i}") for i in range(k)] for n, (part, _) in enumerate(others)}
        for n, (part, why) in enumerate(others):
            on = self.multiple_of_given(["join", part, room], *why)
            on = self.vanishing(["join", room, part], ["join", part, room], [on])
            written = f"{' '.join(map(say, points))} {say(part)} {pure} {not_zero} {on} _ _ _"
            lines += [f"refine (on_{k}_of_{self.space} {written}).", f"intros {s.named(scalars[part])} {h}on_{n}."]
        at = s.among([*s.points, *(x for new in scalars.values() for x in new), *s.units])
        places = [f"({at.place[part]}, {at.data(combination(s.rank, points, new))})" for part, new in scalars.items()]
        return [
            *lines,
            f"refine (replay_placed {self.space} (fun place => nth place [{'; '.join(at.points)}] {at.points[0]})",
            f"  0 {len(at.points)} {at.data(e)} (Number 0) [{'; '.join(places)}] [] (below_0 _ _)",
            f"  {pairs([f'{h}on_{n}' for n in range(len(others))])} _).",
            "vm_cast_no_check (eq_refl true).",
        ]

    def _otherwise(self, e: Any, other: Any) -> bool:
        """Whether the same extensors have sums, and meets that stand in another sequence, which no script compares."""
        keys = (self.tree.key(x, turned=False) for x in (e, other))
        return len({*keys}) > 1

    def not_zero(self, e: Any) -> str | None:
        """The fact that an expression does not vanish, as a part of something that does not; None where it is none."""
        statement = self.says(e, "<>")
        if statement in self.known:
            return self.known[statement]
        opened = self.statement.written_out(e)
        if opened != e:
            fact = self.not_zero(opened)
            return self._of_auxiliary(e, "<>", fact) if fact else None
        wanted = Counter(map(self.tree.key, self.tree.args(e)))
        h = self.statement.prefix
        for index, whole in enumerate(self.statement.nonzero):
            for part in self.tree.parts(whole):
                rest = list(self.tree.args(part))
                if wanted - Counter(map(self.tree.key, rest)):
                    continue
                for key in wanted.elements():
                    rest.remove(next(a for a in rest if self.tree.key(a) == key))
                if self._otherwise(part, joined([e, *rest])):
                    continue
                proof = [f"intros {h}z. apply {h}nonzero_{index}."]
                if self.stated.statement(part) != self.stated.statement(e):
                    vanishing = self.follows(part, joined([e, *rest]), [f"{h}z"])
                    proof += [f"assert ({h}p : {self.says(part, '=')}). {{", *vanishing, "}"]
                    proof.append(f"rewrite {h}p. vanishes.")
                else:
                    proof.append(f"rewrite {h}z. vanishes.")
                return self._new(statement, proof)
        return None
