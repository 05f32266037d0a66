r"""A polynomial with whole coefficients in named variables: its degrees, its value, and how it is written elsewhere.

>>> f = PolynomialForm(("x", "e0"), (((2, 1), 3), ((0, 0), -1)))
>>> print(f), f.degree, f((2, 5))
3*x^2*e0 - 1
(None, 3, 59)
>>> print(f.written("singular"))
ring R = 0, (x, e0), dp;
poly P = 3*x^2*e0 - 1;
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import TYPE_CHECKING, Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.hints import near

if TYPE_CHECKING:
    import sympy

__all__ = ["FORMATS", "PolynomialForm"]

FORMATS = ("sympy", "maple", "singular")
_WRITTEN = {
    "sympy": "{0}",
    "maple": "P := {0}:",
    "singular": "ring R = 0, ({1}), dp;\npoly P = {0};",
}
_WITH_ROOTS = {
    "sympy": "[{0}, [{2}]]",
    "maple": "P := {0}:\nroots := [{2}]:",
    "singular": "ring R = 0, ({1}), dp;\npoly P = {0};\nideal roots = {2};",
}


@dataclass(frozen=True)
class PolynomialForm:
    """Σ coefficient · variables to the exponents; `terms` lists (exponents, coefficient), none of them 0."""

    variables: tuple[str, ...]
    terms: tuple[tuple[tuple[int, ...], int], ...]

    @classmethod
    def of(cls, p: Any) -> PolynomialForm:
        """That of an element of a ring of sympy, highest degree first."""
        return cls.ordered(tuple(map(str, p.ring.symbols)), ((tuple(map(int, e)), int(c)) for e, c in p.terms()))

    @classmethod
    def ordered(cls, names: tuple[str, ...], terms: Iterable[tuple[tuple[int, ...], int]]) -> PolynomialForm:
        """That of terms in any order, highest degree first."""
        return cls(names, tuple(sorted(terms, key=lambda t: (-sum(t[0]), tuple(-n for n in t[0])))))

    @cached_property
    def degree(self) -> int:
        """The total degree; −1 for 0."""
        return self.degree_in(self.variables)

    def degree_in(self, names: Iterable[str]) -> int:
        """The total degree in some of the variables; −1 for 0."""
        at = [self.variables.index(n) for n in names if n in self.variables]
        return max((sum(e[i] for i in at) for e, _ in self.terms), default=-1)

    @property
    def digits(self) -> int:
        """The digits of the longest coefficient."""
        return max((len(str(abs(c))) for _, c in self.terms), default=1)

    @cached_property
    def largest(self) -> int:
        """The largest coefficient in size; 1 for 0."""
        return max((abs(c) for _, c in self.terms), default=1)

    def __call__(self, values: Sequence[Any]) -> Any:
        """The value; exact for integers and Fractions, one for each variable."""
        if any(isinstance(v, Fraction) for v in values) and all(isinstance(v, int | Fraction) for v in values):
            below = lcm(*(v.denominator for v in values))
            return Fraction(self.scaled([int(v * below) for v in values], below), below ** max(self.degree, 0))
        return self._value(values)

    def scaled(self, values: Sequence[int], below: int) -> int:
        """The value at values/below, times below to the power of the degree: a whole number."""
        powers = [1]
        for _ in range(self.degree):
            powers.append(powers[-1] * below)
        found = self._value(values, powers)
        return int(found)

    def _value(self, values: Sequence[Any], below: Sequence[int] | None = None) -> Any:
        degree = self.degree
        powers = [[1] for _ in self.variables]
        for row, v in zip(powers, values, strict=True):
            for _ in range(degree):
                row.append(row[-1] * v)
        total: Any = 0
        for exponents, c in self.terms:
            checkpoint()
            for row, n in zip(powers, exponents, strict=True):
                if n:
                    c = c * row[n]
            if below is not None:
                c = c * below[degree - sum(exponents)]
            total = total + c
        return total

    @cached_property
    def poly(self) -> sympy.Poly:
        """A sympy.Poly over the integers."""
        from sympy import ZZ, Poly, symbols

        return Poly.from_dict(dict(self.terms), *symbols(self.variables), domain=ZZ)

    @property
    def real_zeros(self) -> tuple[float, ...]:
        """All real zeros of a polynomial in one variable, isolated exactly and rounded; each once, the least first."""
        found = (root.evalf(20) for root in self.poly.real_roots(radicals=False))
        return tuple(dict.fromkeys(map(float, found)))

    def __str__(self) -> str:
        return self._sum("^")

    def rounded(self, digits: int) -> str:
        """The polynomial over its largest coefficient in size, with decimals of so many significant digits, 15 at most.

        >>> print(PolynomialForm(("x",), (((2,), 400), ((0,), -3))).rounded(2))
        x^2 - 0.0075
        """
        return self._sum("^", lambda c: f"{c / self.largest:.{digits}g}")

    def written(self, style: str, roots: Sequence[tuple[str, PolynomialForm]] = ()) -> str:
        """Text for another program: sympy (`sympify`), maple or singular; after the polynomial those that are 0 by the
        `roots` among its variables, each with its square. Raises InputError for other programs.
        """
        if style not in FORMATS:
            raise InputError(
                f"there is no format {style[:20]!r}", hint=near(style, FORMATS) or f"choose {', '.join(FORMATS)}"
            )
        power = "**" if style == "sympy" else "^"
        zeros = ", ".join(f"{name}{power}2 - ({square._sum(power)})" for name, square in roots)
        return (_WITH_ROOTS if roots else _WRITTEN)[style].format(self._sum(power), ", ".join(self.variables), zeros)

    def _sum(self, power: str, number: Callable[[int], str] = str) -> str:
        def factor(name: str, n: int) -> str:
            return name if n == 1 else f"{name}{power}{n}"

        return joined(
            (
                (c, "*".join(factor(v, n) for v, n in zip(self.variables, e, strict=True) if n), "*")
                for e, c in self.terms
            ),
            number=number,
        )


def joined(terms: Iterable[tuple[int, str, str]], *, first: bool = True, number: Callable[[int], str] = str) -> str:
    """A sum of coefficients, what they are multiplied by, and the sign of that product; `number` writes the first."""
    found: list[str] = []
    for c, monomial, times in terms:
        checkpoint()
        sign = ("- " if c < 0 else "+ ") if found or not first else ("-" if c < 0 else "")
        size = number(abs(c))
        size = "" if size == "1" and monomial else size
        found.append(f"{sign}{size}{times if size and monomial else ''}{monomial}")
    return " ".join(found) or "0"
