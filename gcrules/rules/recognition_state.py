r"""What is known while entities are being recognised in one bracket form of the superbracket."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import field, replace
from functools import cached_property
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra import scalars
from gcrules.algebra.bracket import BracketPolynomial, Coefficient, Row, sorted_row
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.scalars import bracket
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass

__all__ = ["RecognitionState", "extensor"]

Names = tuple[str, ...]


def extensor(names: Names) -> Expr:
    """The join of points given by name."""
    return ex.join(*map(Point, names))


@dataclass(frozen=True)
class RecognitionState:
    """The form's polynomial is Π tetrahedra · rest; planes and lines are entities of the rest.

    A plane is three points, a line two, that stay together in one bracket of every monomial of the rest; different
    entities sit in different brackets (`homes`: for each monomial, the bracket of each entity in turn). `taken` is what
    the left-over points make. The superbracket as typed is `sign` times the form's polynomial. `trail` holds the rules
    that led here, each with the state it led to.
    """

    structure: Structure
    form: SuperbracketForm
    rest: BracketPolynomial
    tetrahedra: tuple[Row, ...] = ()
    planes: tuple[Row, ...] = ()
    lines: tuple[Row, ...] = ()
    homes: tuple[tuple[int, ...], ...] = ()
    taken: tuple[Row, ...] = ()
    sign: int = 1
    trail: tuple[tuple[Any, RecognitionState], ...] = field(default=(), compare=False, repr=False)

    @classmethod
    def start(cls, form: SuperbracketForm, structure: Structure) -> RecognitionState:
        """Nothing recognised yet in a form of the structure's neutral legs."""
        homes = ((),) * len(form.polynomial)
        return cls(structure, form, form.polynomial, homes=homes, sign=form.sign * structure.sign)

    def after(self, rule: Any, before: RecognitionState) -> RecognitionState:
        """This state with one more rule on the trail, which led here."""
        return replace(self, trail=(*before.trail, (rule, self)))

    @cached_property
    def degree(self) -> int:
        """Number of brackets in each monomial of the rest."""
        return len(next(iter(self.rest.terms), ()))

    @cached_property
    def left(self) -> Row:
        """The points left over: content of the rest less the content of planes and lines."""
        content = Counter(i for row in next(iter(self.rest.terms), ()) for i in row)
        content.subtract(i for row in (*self.planes, *self.lines) for i in row)
        return tuple(sorted(content.elements()))

    def named(self, row: Row) -> Names:
        return tuple(self.form.polynomial.points[i] for i in row)

    @property
    def brackets(self) -> list[Expr]:
        """The tetrahedra as brackets, the factors in front of the rest."""
        return [bracket(*map(Point, self.named(row))) for row in self.tetrahedra]

    def labels(self, rows: Iterable[Row], between: str = ", ") -> str:
        """Entities as text: "Aab, Bcd"."""
        return between.join(str(extensor(self.named(row))) for row in rows)

    def listed(self, row: Row) -> str:
        """Points as text: "a, b"."""
        return ", ".join(self.named(row))

    def with_entity(self, row: Row) -> Iterator[RecognitionState]:
        """The states in which `row` (three or two points) is one more entity, in a bracket of its own everywhere."""
        homes = []
        for monomial, taken in zip(self.rest.terms, self.homes, strict=True):
            checkpoint()
            free = [i for i, b in enumerate(monomial) if i not in taken and set(row) <= set(b)]
            if not free:
                return
            homes.append((*taken, free[0]))
        known = {"planes": (*self.planes, row)} if len(row) == 3 else {"lines": (*self.lines, row)}
        yield replace(self, homes=tuple(homes), **known)  # type: ignore[arg-type]

    def swapped_sum(self, x: int, y: int) -> bool:
        """Whether P(x, y) + P(y, x) = 0 for left-over points x and y, the other entities' points being starred."""
        total: Counter[tuple[Row, ...]] = Counter()
        for (monomial, c), homes in zip(self.rest.terms.items(), self.homes, strict=True):
            checkpoint()
            plain = [list(row) for row in monomial]
            starred: list[list[int]] = [[] for _ in monomial]
            for entity, home in zip((*self.planes, *self.lines), homes, strict=True):
                for i in entity:
                    plain[home].remove(i)
                    starred[home].append(i)
            for exchange in ({}, {x: y, y: x}):
                sign: Coefficient = c
                rows = []
                for row, fixed in zip(plain, starred, strict=True):
                    s, _ = sorted_row(fixed + row)
                    t, new = sorted_row(fixed + [exchange.get(i, i) for i in row])
                    sign *= s * t
                    rows.append(new)
                total[tuple(sorted(rows))] += sign  # type: ignore[assignment]
        return not any(total.values())

    def dotted(self) -> Expr:
        """Tetrahedra times the planes' brackets, each completed by a dotted left-over point: [X ẋ][Y ẏ] …"""
        brackets = [
            [*((n, False) for n in self.named(plane)), (self.named((point,))[0], True)]
            for plane, point in zip(self.planes, self.left, strict=True)
        ]
        return ex.mul(*self.brackets, scalars.dotted(*brackets))

    def collected(self) -> Expr:
        """The form's polynomial with tetrahedra in front and each bracket beginning with its entity."""
        terms = []
        for (monomial, c), homes in zip(self.rest.terms.items(), self.homes, strict=True):
            checkpoint()
            factors, sign = [], c
            entity_of = dict(zip(homes, (*self.planes, *self.lines), strict=True))
            places = [*homes, *(i for i in range(len(monomial)) if i not in homes)]
            for i in places:
                entity = entity_of.get(i, ())
                row = (*entity, *(p for p in monomial[i] if p not in entity))
                s, _ = sorted_row(row)
                sign *= s
                factors.append(bracket(*map(Point, self.named(row))))
            terms.append(ex.mul(ex.Number(sign), *factors))
        return ex.mul(*self.brackets, ex.add(*terms)) if self.degree else ex.mul(*terms, *self.brackets)
