r"""Conditions: what the superbracket of a structure equals, in geometric terms, and how sure that is."""

from __future__ import annotations

from typing import Any

from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import ONE, Expr, Number, mul, signed, sub
from gcrules.algebra.language.text import text
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.rules.statement import Statement

__all__ = ["Condition", "Entity", "starred"]


@dataclass(frozen=True)
class Entity:
    """A tetrahedron, plane, line or point given by its points; `starred` tells repeated points apart (a, a*, a**)."""

    kind: str
    points: tuple[str, ...]
    starred: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.kind} {' '.join(self.starred)}"

    def to_json(self) -> dict[str, Any]:
        return {"kind": self.kind, "points": list(self.points), "starred": list(self.starred)}


def starred(kinds_and_points: list[tuple[str, tuple[str, ...]]]) -> tuple[Entity, ...]:
    """Entities in sequence, the n-th occurrence of a point bearing n − 1 stars."""
    seen: dict[str, int] = {}
    found = []
    for kind, points in kinds_and_points:
        names = []
        for n in points:
            names.append(n + "*" * seen.get(n, 0))
            seen[n] = seen.get(n, 0) + 1
        found.append(Entity(kind, points, tuple(names)))
    return tuple(found)


@dataclass(frozen=True)
class Condition(Shown):
    """cofactor · superbracket = coefficient · expression, for the legs exactly as typed, and what that means.

    `lines` are the lines that the meaning names (p and q, about which the platform could turn); `group` is the group of
    entities in the published procedure, a … g, where the condition comes from one. Whether the `meaning` is what the
    expression says cannot be told by a machine: `statement_source` names the catalog or rule that it comes from, "" for
    the sentences of gcrules itself.
    """

    kind: str
    expression: Expr
    meaning: Statement
    certificate: Certificate
    cofactor: Expr = ONE
    coefficient: int = 1
    entities: tuple[Entity, ...] = ()
    lines: tuple[tuple[str, Expr], ...] = ()
    group: str | None = None
    statement_source: str = ""

    @property
    def statement(self) -> str:
        """The meaning in words."""
        return str(self.meaning)

    @property
    def sentence(self) -> str:
        """The statement as it is shown: with whose words it is where it comes from outside."""
        return f"{self.whose}{self.statement}" if self.meaning else ""

    @property
    def whose(self) -> str:
        """What stands before a statement that comes from outside."""
        return f"In the words of {self.statement_source}: " if self.statement_source else ""

    @property
    def right_side(self) -> Expr:
        """coefficient · expression, a minus sign written into the terms of a sum."""
        return signed(self.coefficient, self.expression)

    def identity(self, superbracket: Expr) -> Expr:
        """The expression that must vanish identically."""
        return sub(mul(self.cofactor, superbracket), mul(Number(self.coefficient), self.expression))

    def to_json(self, names: tuple[str, ...] = ()) -> dict[str, Any]:
        """The interface's object: kind, expression, cofactor, coefficient, statement (and whose words it is, null where
        they are those of gcrules), certificate.
        """
        return {
            "kind": self.kind,
            "expression": text(self.expression, names=names),
            "cofactor": text(self.cofactor, names=names),
            "coefficient": self.coefficient,
            **self.wording(),
            "certificate": self.certificate.to_json(),
        }

    def wording(self) -> dict[str, str | None]:
        """The statement and its source for JSON objects."""
        return {"statement": self.statement, "statement_source": self.statement_source or None}
