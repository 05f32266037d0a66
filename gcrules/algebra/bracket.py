r"""Bracket polynomials and extensor polynomials as frozen values.

A bracket is the increasing tuple of the indices of its points in the tableau order, a monomial the sorted tuple of
its brackets; signs and vanishing brackets are dealt with when a term is made. Two polynomials are equal as values if
they have the same terms; whether they are equal as functions (modulo syzygies) is decided by their normal forms.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from itertools import chain, groupby
from typing import TYPE_CHECKING, Any

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.names import point_key
from gcrules.core.budget import watched
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, StepError
from gcrules.core.floats import exact_number
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import content
from gcrules.core.shown import Shown

if TYPE_CHECKING:
    import sympy

__all__ = [
    "BracketPolynomial",
    "Coefficient",
    "ExtensorPolynomial",
    "Monomial",
    "Row",
    "Terms",
    "by_parameters",
    "primitive",
    "sorted_row",
    "tableau_order",
]

Coefficient = int | Fraction
Row = tuple[int, ...]
Monomial = tuple[Row, ...]
Terms = dict[Monomial, Coefficient]

MANY_EQUAL = 10  # brackets that are written as a power where a short text is asked for


def by_parameters(terms: Mapping[Monomial, Coefficient]) -> dict[Monomial, Terms]:
    """The polynomial in brackets with which each product of parameters, which are rows of one entry, occurs.

    >>> by_parameters({((0,), (0, 1)): 2, ((0, 2), (1, 2)): 1})
    {((0,),): {((0, 1),): 2}, (): {((0, 2), (1, 2)): 1}}
    """
    parts: dict[Monomial, Terms] = {}
    for m, c in terms.items():
        parameters = tuple(row for row in m if len(row) == 1)
        parts.setdefault(parameters, {})[tuple(row for row in m if len(row) > 1)] = c
    return parts


def tableau_order(names: Iterable[str], declared: Iterable[str] = (), ideal: Iterable[str] = ()) -> tuple[str, ...]:
    """Points in tableau order: points at infinity first, then declared ones as declared, then the others sorted.

    >>> tableau_order(["b", "p10", "p2", "a", "i"], declared=["b"], ideal=["i"])
    ('i', 'b', 'a', 'p2', 'p10')
    """
    present = dict.fromkeys(names)
    at_infinity = [n for n in dict.fromkeys(ideal) if n in present]
    first = [n for n in dict.fromkeys(declared) if n in present and n not in at_infinity]
    rest = sorted((n for n in present if n not in at_infinity and n not in first), key=point_key)
    return (*at_infinity, *first, *rest)


def sorted_row(indices: Iterable[int]) -> tuple[int, Row]:
    """Sign and increasing order of a bracket's points; sign 0 if a point is repeated.

    >>> sorted_row([2, 0, 1]), sorted_row([1, 0, 1])
    ((1, (0, 1, 2)), (0, (0, 1, 1)))
    """
    row = list(indices)
    sign = 1
    for i in range(1, len(row)):
        j = i
        while j and row[j - 1] > row[j]:
            row[j - 1], row[j] = row[j], row[j - 1]
            sign = -sign
            j -= 1
    return (sign if len(set(row)) == len(row) else 0), tuple(row)


def _nonzero(terms: Mapping[Monomial, Coefficient]) -> Terms:
    return {
        m: (c.numerator if isinstance(c, Fraction) and c.denominator == 1 else c) for m, c in sorted(terms.items()) if c
    }


def repeats(monomial: Monomial) -> bool:
    """Whether a bracket occurs so often that a power is shorter."""
    return any(a == b for a, b in zip(monomial, monomial[MANY_EQUAL - 1 :], strict=False))


class _Polynomial(Shown, ABC):
    """What both kinds of polynomials have."""

    points: tuple[str, ...]

    @abstractmethod
    def __len__(self) -> int: ...

    @abstractmethod
    def _step(self) -> int: ...

    @abstractmethod
    def to_expr(self, *, short: bool = False) -> Expr: ...

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self}>" if len(self) <= 24 else f"<{type(self).__name__} of {len(self)} terms>"

    def to_json(self) -> dict[str, Any]:
        """`{"polynomial": text, "terms": number of terms, "step": step}`."""
        return {"polynomial": str(self), "terms": len(self), "step": self._step()}


@dataclass(frozen=True, repr=False)
class BracketPolynomial(_Polynomial):
    """Σ coefficient · monomial in brackets of the given rank over `points`, the first `ideal` at infinity."""

    rank: int
    points: tuple[str, ...]
    terms: Mapping[Monomial, Coefficient]
    ideal: int = 0

    def __post_init__(self) -> None:
        object.__setattr__(self, "terms", FrozenMap(_nonzero(self.terms)))

    def __len__(self) -> int:
        return len(self.terms)

    def __bool__(self) -> bool:
        return bool(self.terms)

    @property
    def step(self) -> int:
        return 0

    def _step(self) -> int:
        return self.step

    def with_terms(self, terms: Mapping[Monomial, Coefficient]) -> BracketPolynomial:
        """The polynomial over the same points with other terms."""
        return BracketPolynomial(self.rank, self.points, terms, self.ideal)

    def __neg__(self) -> BracketPolynomial:
        return self.with_terms({m: -c for m, c in self.terms.items()})

    def __add__(self, other: BracketPolynomial) -> BracketPolynomial:
        if not isinstance(other, BracketPolynomial):
            return NotImplemented
        a, b = self._aligned(other)
        terms = dict(a.terms.items())
        for m, c in b.terms.items():
            terms[m] = terms.get(m, 0) + c
        return a.with_terms(terms)

    def __sub__(self, other: BracketPolynomial) -> BracketPolynomial:
        if not isinstance(other, BracketPolynomial):
            return NotImplemented
        return self + -other

    def __mul__(self, other: BracketPolynomial | int | Fraction) -> BracketPolynomial:
        if not isinstance(other, BracketPolynomial):
            number = exact_number(other)
            return NotImplemented if number is None else self.with_terms({m: c * number for m, c in self.terms.items()})
        a, b = self._aligned(other)
        if len(a) < len(b):
            a, b = b, a
        terms: Terms = {}
        for m, c in watched(a.terms.items(), every=8):
            for n, k in b.terms.items():
                product = tuple(sorted(m + n))
                terms[product] = terms.get(product, 0) + c * k
        return a.with_terms(terms)

    __rmul__ = __mul__
    __array_ufunc__ = None  # arrays take no polynomials apart

    def _aligned(self, other: BracketPolynomial) -> tuple[BracketPolynomial, BracketPolynomial]:
        if self.rank != other.rank:
            raise StepError(f"brackets of rank {self.rank} and of rank {other.rank} in one polynomial")
        if self.points == other.points and self.ideal == other.ideal:
            return self, other
        ideal = dict.fromkeys((*self.points[: self.ideal], *other.points[: other.ideal]))
        order = tableau_order((*self.points, *other.points), self.points, ideal)
        return self.over(order, len(ideal)), other.over(order, len(ideal))

    def over(self, points: tuple[str, ...], ideal: int = 0) -> BracketPolynomial:
        """The same polynomial written over another tuple of points. Raises InputError if one that occurs is missing."""
        index = {n: i for i, n in enumerate(points)}
        moved = [index.get(n, -1) for n in self.points]
        gone = [i for i, j in enumerate(moved) if j < 0 and any(i in row for m in self.terms for row in m)]
        if gone:
            raise InputError(f"points that occur are missing: {', '.join(self.points[i] for i in gone)}")
        terms: Terms = {}
        for m, c in watched(self.terms.items()):
            sign, rows = 1, []
            for row in m:
                s, r = sorted_row(moved[i] for i in row)
                sign *= s
                rows.append(r)
            key = tuple(sorted(rows))
            terms[key] = terms.get(key, 0) + sign * c
        return BracketPolynomial(self.rank, points, terms, ideal)

    def degrees(self) -> dict[str, int] | None:
        """How often each point occurs in every monomial; None if that differs from one monomial to another."""
        counts = {tuple(sorted(i for row in m for i in row)) for m in self.terms}
        if len(counts) > 1:
            return None
        return {self.points[i]: len(list(g)) for c in counts for i, g in groupby(c)}

    def named(self) -> Iterator[tuple[Coefficient, tuple[tuple[str, ...], ...]]]:
        """The terms with their brackets as tuples of names."""
        for m, c in self.terms.items():
            yield c, tuple(tuple(self.points[i] for i in row) for row in m)

    def to_expr(self, *, short: bool = False) -> Expr:
        """The polynomial as an expression of the language; with `short` many equal brackets are a power."""
        points = [ex.Point(n) for n in self.points]
        brackets = {row: ex.Bracket(tuple(points[i] for i in row)) for row in set(chain.from_iterable(self.terms))}

        def factors(monomial: Monomial) -> Iterator[Expr]:
            for row, run in groupby(monomial) if short else ((row, (row,)) for row in monomial):
                equal = [brackets[row] for _ in run]
                yield from equal if len(equal) < MANY_EQUAL else [ex.Power(equal[0], len(equal))]

        terms = (ex.mul(ex.Number(c), *factors(m)) for m, c in watched(self.terms.items()))
        return ex.add(*terms, rank=self.rank)

    def to_sympy(self) -> sympy.Expr:
        """A sympy expression with one symbol for each bracket, named as in the text ("[abcd]")."""
        import sympy

        def symbol(row: tuple[str, ...]) -> sympy.Symbol:
            return sympy.Symbol(text(ex.Bracket(tuple(map(ex.Point, row))), names=self.points))

        terms = [sympy.Mul(sympy.Rational(c), *map(symbol, rows)) for c, rows in self.named()]
        return sympy.Add(*terms)


def primitive(poly: BracketPolynomial) -> tuple[Coefficient, BracketPolynomial]:
    """The content (with the sign of the first term) and the polynomial divided by it: whole, coprime numbers."""
    coefficients = [Fraction(c) for c in poly.terms.values()]
    common = content(coefficients)
    if coefficients[0] < 0:
        common = -common
    return ex.Number(common).value, poly * (1 / common)


@dataclass(frozen=True, repr=False)
class ExtensorPolynomial(_Polynomial):
    """Σ (bracket polynomial) · extensor for extensors of one positive step, each an increasing tuple of points."""

    rank: int
    points: tuple[str, ...]
    step: int
    parts: Mapping[Row, BracketPolynomial]
    ideal: int = 0

    def __post_init__(self) -> None:
        parts = {r: p for r, p in sorted(self.parts.items()) if p}
        object.__setattr__(self, "parts", FrozenMap(parts))

    def __len__(self) -> int:
        return sum(map(len, self.parts.values()))

    def _step(self) -> int:
        return self.step

    def __bool__(self) -> bool:
        return bool(self.parts)

    def to_expr(self, *, short: bool = False) -> Expr:
        """The polynomial as an expression of the language; with `short` many equal brackets are a power."""
        return ex.add(
            *(
                ex.mul(p.to_expr(short=short), ex.join(*(ex.Point(self.points[i]) for i in row), rank=self.rank))
                for row, p in sorted(self.parts.items(), reverse=True)
            ),
            rank=self.rank,
        )

    def to_sympy(self) -> dict[str, sympy.Expr]:
        """The coefficient of each extensor (named by its points) as a sympy expression."""
        return {
            text(ex.join(*(ex.Point(self.points[i]) for i in row), rank=self.rank), names=self.points): p.to_sympy()
            for row, p in self.parts.items()
        }
