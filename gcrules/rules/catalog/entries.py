"""The classes of the catalog and their identities, as they stand in a file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import Any

from gcrules.algebra.expr import ONE, Expr, Number, Point, join, mul
from gcrules.algebra.language.legs_text import Leg, Structure
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.dataclass import dataclass
from gcrules.rules.statement import Statement, filled

__all__ = ["SHIPPED", "CatalogIdentity", "Entry"]

SHIPPED = "gcrules/catalog.yaml"


@dataclass(frozen=True)
class CatalogIdentity:
    """An identity of a class in its own labels: cofactor · superbracket = coefficient · expression."""

    kind: str
    expression_text: str
    cofactor_text: str
    coefficient: int
    statement: str | None
    line_texts: tuple[tuple[str, str], ...] = ()
    place: str = field(default="", compare=False)

    @cached_property
    def lines(self) -> tuple[tuple[str, Expr], ...]:
        return tuple((name, parse(line)) for name, line in self.line_texts)

    @cached_property
    def meaning(self) -> Statement:
        """The statement with its labels as flats."""
        return filled(self.statement or "", lambda word: join(*map(Point, SHORT_NAME.findall(word)), rank=8))

    @cached_property
    def expression(self) -> Expr:
        return parse(self.expression_text)

    @cached_property
    def cofactor(self) -> Expr:
        return ONE if self.cofactor_text == "1" else parse(self.cofactor_text)  # the parser takes a while to load


@dataclass(frozen=True)
class Entry:
    """One class of platforms: its legs (base joint first) and what is known about them."""

    id: str
    legs: tuple[Leg, ...]
    degrees: tuple[tuple[int, ...], tuple[int, ...]]
    terms: Mapping[int, int]
    factors: tuple[tuple[str, ...], ...]
    group: str | None
    status: str
    sources: tuple[str, ...]
    condition: CatalogIdentity
    readings: tuple[CatalogIdentity, ...]
    name: str | None
    note: str | None
    owner: str
    place: str
    left_out: frozenset[str] = frozenset()
    shortest: int | None = None

    @property
    def structure(self) -> Structure:
        return Structure(self.legs)

    def sides(self, reading: CatalogIdentity) -> tuple[Expr, Expr]:
        """cofactor · superbracket and coefficient · expression of one of its identities."""
        left = mul(reading.cofactor, self.structure.superbracket)
        return left, mul(Number(reading.coefficient), reading.expression)

    @property
    def title(self) -> str:
        """The id and the name; those of a catalog from outside with its file."""
        name = f", {self.name}" if self.name else ""
        return f"{self.id}{name}" if self.owner == SHIPPED else f"{self.id}{name} (of {self.owner})"

    def to_json(self) -> dict[str, Any]:
        def reading(r: CatalogIdentity) -> dict[str, Any]:
            return {
                "kind": r.kind,
                "expression": r.expression_text,
                "cofactor": r.cofactor_text,
                "coefficient": r.coefficient,
                "statement": r.statement,
            }

        return {
            "id": self.id,
            "legs": [list(leg) for leg in self.legs],
            "name": self.name,
            "degrees": [list(d) for d in self.degrees],
            "terms": {str(k): v for k, v in self.terms.items()},
            "shortest": self.shortest,
            "factors": ["".join(f) for f in self.factors],
            "group": self.group,
            "status": self.status,
            "sources": list(self.sources),
            "condition": reading(self.condition),
            "readings": [reading(r) for r in self.readings],
            "note": self.note,
            "owner": self.owner,
        }
