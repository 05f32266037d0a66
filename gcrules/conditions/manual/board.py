"""The board: one bracket form of the superbracket, and what has been recognised in it by hand.

An entity sits in a bracket of its own in every term. No bracket is settled when an entity is confirmed: a set of
entities is possible if in each term they can be given different brackets, so that the sequence of proposals does not
matter.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import reduce
from itertools import islice, permutations, product
from operator import and_

from gcrules.algebra.bracket import BracketPolynomial, Coefficient, Monomial, Row
from gcrules.algebra.expr import Expr, Number, Point, mul, signed
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.scalars import bracket
from gcrules.algebra.superbrackets.shortest import SuperbracketForm, superbracket_form
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.rules.condition import Condition, Entity, starred
from gcrules.rules.recognition_state import RecognitionState, extensor

__all__ = ["KINDS", "Board", "placements"]

KINDS = {4: "tetrahedron", 3: "plane", 2: "line"}
"""What an entity of so many points is called."""

_MOST_STATES = 256  # ways to share out the brackets that the test of a pair goes through


def placements(monomial: Monomial, entities: tuple[Row, ...]) -> Iterator[tuple[int, ...]]:
    """All ways to give each entity a bracket of its own that holds its points."""
    for homes in permutations(range(len(monomial)), len(entities)):
        checkpoint()
        if all(set(row) <= set(monomial[i]) for row, i in zip(entities, homes, strict=True)):
            yield homes


@dataclass(frozen=True)
class Board:
    """`form` is written for the structure's neutral legs; `entities` (four, three or two points that stay together) and
    `taken` (what left-over points make, or may make) hold positions of `structure.names`, in the sequence of proposals.
    `chosen` says that the user chose the form; `condition` is the one confirmed.
    """

    structure: Structure
    form: SuperbracketForm
    chosen: bool = False
    entities: tuple[Row, ...] = ()
    taken: tuple[Row, ...] = ()
    condition: Condition | None = None

    @classmethod
    def of(cls, structure: Structure, order: tuple[int, ...] = tuple(range(6)), form: int = 24) -> Board:
        """Nothing recognised yet in the form with the legs in this order."""
        points, ideal = structure.points, structure.ideal
        return cls(structure, superbracket_form(structure.neutral, order, form, points=points, ideal=ideal))

    @property
    def polynomial(self) -> BracketPolynomial:
        """The form with the sign that makes it equal to the superbracket as typed."""
        return self.form.polynomial * (self.form.sign * self.structure.sign)

    @property
    def terms(self) -> list[tuple[Monomial, Coefficient]]:
        return list(self.polynomial.terms.items())

    def of_size(self, size: int) -> tuple[Row, ...]:
        """The entities with so many points, sorted."""
        return tuple(sorted(row for row in self.entities if len(row) == size))

    @property
    def left(self) -> Row:
        """The points that neither an entity nor a left-over line or plane has taken."""
        place = {n: i for i, n in enumerate(self.structure.names)}
        content = Counter(place[n] for leg in self.structure.legs for n in leg)
        content.subtract(i for row in (*self.entities, *self.taken) for i in row)
        return tuple(sorted(content.elements()))

    @property
    def common(self) -> int:
        """How many brackets stand in every term."""
        brackets = [Counter(monomial) for monomial in self.form.polynomial.terms]
        return sum(reduce(and_, brackets).values())

    @property
    def free(self) -> int:
        """How many brackets of each term have no entity yet."""
        return 3 - len(self.entities)

    def row(self, names: tuple[str, ...]) -> Row:
        return tuple(sorted(map(self.structure.names.index, names)))

    def named(self, row: Row) -> tuple[str, ...]:
        return tuple(self.structure.names[i] for i in row)

    def label(self, row: Row) -> str:
        """Points as one word: Aab."""
        return str(extensor(self.named(row)))

    def entity_text(self, row: Row) -> str:
        return f"{KINDS[len(row)]} {self.label(row)}"

    def term_text(self, number: int) -> str:
        """A term, counted from 1: "term 2, -[abcf][acde][bdef]"."""
        monomial, c = self.terms[number - 1]
        shown = mul(Number(c), *(bracket(*map(Point, self.named(row))) for row in monomial))
        return f"term {number}, {shown}"

    @property
    def starred(self) -> tuple[Entity, ...]:
        """Everything that stands (confirmed, or possible), stars telling repeated points apart."""
        return starred([(KINDS[len(row)], self.named(row)) for row in (*self.entities, *self.taken)])

    def broken(self, row: Row) -> int | None:
        """The number of the first term in which the entities and `row` cannot have brackets of their own."""
        entities = (*self.entities, row)
        for number, (monomial, _) in enumerate(self.terms, 1):
            if next(placements(monomial, entities), None) is None:
                return number
        return None

    def states(self) -> Iterator[RecognitionState]:
        """What is known, as the rules see it: one state for each way to share out the brackets (at most 256 of them).

        Entities stand in the sequence in which the rules find them.
        """
        tetrahedra, planes, lines = (self.of_size(n) for n in (4, 3, 2))
        terms = {}
        for monomial, c in self.form.polynomial.terms.items():
            remaining = list(monomial)
            for row in tetrahedra:
                remaining.remove(row)
            terms[tuple(remaining)] = c
        rest = self.form.polynomial.with_terms(terms)
        start = replace(RecognitionState.start(self.form, self.structure), rest=rest, tetrahedra=tetrahedra)
        state = replace(start, planes=planes, lines=lines, taken=tuple(sorted(self.taken)))
        ways = [list(placements(monomial, (*planes, *lines))) for monomial in rest.terms]
        for homes in islice(product(*ways), _MOST_STATES):
            checkpoint()
            yield replace(state, homes=homes)

    @property
    def state(self) -> RecognitionState:
        return next(self.states())

    def collected(self) -> Expr | None:
        """The superbracket with tetrahedra in front and each bracket beginning with its entity; None without any."""
        if not self.entities:
            return None
        return signed(self.state.sign, self.state.collected())
