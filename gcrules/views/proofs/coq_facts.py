"""What follows from the assumptions of a theorem, as Coq derives it by the rules of the checker.

A fact is that something vanishes, that it does not, or of which step it is.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

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

    def _follows(self, e: Any, because: Any, rewritten: Iterable[str]) -> list[str]:
        """The proof that an expression vanishes since another one of the same value does."""
        h, stated = self.statement.prefix, self.stated
        return [
            f"refine (follows_sound {self.space} {h}at {self.statement.ideal} {len(stated.points)}",
            f"  {stated.data(e)} {stated.data(because)} {h}ideal _ _).",
            f"- change ({self.says(because, '=')}). {''.join(f'rewrite {r}. ' for r in rewritten)}vanishes.",
            "- vm_cast_no_check (eq_refl true).",
        ]

    def vanishing(self, e: Any, because: Any, rewritten: Iterable[str]) -> str:
        """The fact that an expression vanishes."""
        statement = self.says(e, "=")
        return self.known.get(statement) or self._new(statement, self._follows(e, because, rewritten))

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

    def multiple_of_given(self, e: Any, index: int, number: Any) -> str:
        """The fact that an expression vanishes, as a multiple of something given."""
        factor = Fraction(number)
        if factor.denominator != 1:
            raise CannotWrite("it holds under assumptions of which fractions are used")
        because = self.statement.given[index]
        because = because if abs(factor) == 1 else ["product", ["number", int(factor)], because]
        return self.vanishing(e, because, [f"{self.statement.prefix}given_{index}"])

    def lies(self, name: str, e: Any) -> str:
        """The fact that a point lies on an extensor: their join vanishes."""
        both = ["join", e, name]
        flat = self.flats.get((name, self.tree.key(e)))
        if flat is not None:
            own = ["join", self.tree.opened(flat["flat"]), name]
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

    def not_zero(self, e: Any) -> str | None:
        """The fact that an expression does not vanish, as a part of something that does not; None where it is none."""
        statement = self.says(e, "<>")
        if statement in self.known:
            return self.known[statement]
        wanted = Counter(map(self.tree.key, self.tree.args(e)))
        h = self.statement.prefix
        for index, whole in enumerate(self.statement.nonzero):
            for part in self.tree.parts(whole):
                rest = list(self.tree.args(part))
                if wanted - Counter(map(self.tree.key, rest)):
                    continue
                for key in wanted.elements():
                    rest.remove(next(a for a in rest if self.tree.key(a) == key))
                proof = [f"intros {h}z. apply {h}nonzero_{index}."]
                if self.stated.statement(part) != self.stated.statement(e):
                    vanishing = self._follows(part, joined([e, *rest]), [f"{h}z"])
                    proof += [f"assert ({h}p : {self.says(part, '=')}). {{", *vanishing, "}"]
                    proof.append(f"rewrite {h}p. vanishes.")
                else:
                    proof.append(f"rewrite {h}z. vanishes.")
                return self._new(statement, proof)
        return None
