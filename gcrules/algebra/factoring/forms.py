"""The irreducible factors of a scalar, each with a form, as a frozen value that shows itself."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from fractions import Fraction
from itertools import repeat
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import ONE, Expr, Number
from gcrules.algebra.factoring.powers import number_power
from gcrules.algebra.factoring.result import polynomial_text
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import letter_of
from gcrules.algebra.plain_letters import in_plain_letters
from gcrules.algebra.whole_letters import in_letters
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown

__all__ = [
    "BRACKET",
    "COFACTOR",
    "EXPRESSION",
    "NONE",
    "TWO_LINES",
    "TWO_TERMS",
    "UNDECIDED",
    "Factors",
    "IrreducibleFactor",
]

BRACKET = "bracket"
EXPRESSION = "expression"
TWO_LINES = "transversals"
TWO_TERMS = "two terms"
COFACTOR = "cofactor"
NONE = "none"
UNDECIDED = "undecided"


@dataclass(frozen=True)
class IrreducibleFactor:
    """A factor, `times` its multiplicity: cofactor · polynomial = coefficient · expression.

    The polynomial has whole coprime coefficients; where there is no simpler form, it is the shortest that was found.
    `form` says what the expression is: "bracket";
    "expression", one of joins and meets; "transversals", (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g) for four lines; "two terms",
    each a product of brackets; "cofactor", one expression that needs the cofactor. It is "none" where the
    search for all of these came to its end in vain, and "undecided" where a limit ended one: then the expression is
    None. `excluded` says in words what does not exist, `undecided` what is not known.
    `irreducible` tells whether it is known that the factor does not split over the rationals. The certificate says how
    sure the form is, or that there is none.
    """

    polynomial: BracketPolynomial
    times: int
    form: str
    certificate: Certificate
    irreducible: bool = True
    expression: Expr | None = None
    coefficient: int | Fraction = 1
    cofactor: Expr = ONE
    excluded: tuple[str, ...] = ()
    undecided: tuple[str, ...] = ()

    @property
    def degrees(self) -> dict[str, int]:
        """How often each point and each letter occurs in it."""
        degrees = self.polynomial.degrees() or {}
        return {of[0] if (of := letter_of(n)) is not None else n: d for n, d in degrees.items()}

    @property
    def proved(self) -> bool:
        """Whether the form is proved, or proved not to exist."""
        return self.form != UNDECIDED and self.certificate.method != "random-points"

    @property
    def closed(self) -> bool:
        """Whether the expression is a multiple of the factor, without a cofactor."""
        return self.expression is not None and self.cofactor == ONE


@dataclass(frozen=True)
class Factors(Shown):
    """input = coefficient · Π polynomial of each factor, as often as it occurs, proved by normal forms.

    The brackets come first. `points` is the tableau order, `input` what was factored, `ideal` its points at infinity.
    """

    rank: int
    points: tuple[str, ...]
    coefficient: int | Fraction
    factors: tuple[IrreducibleFactor, ...]
    certificate: Certificate
    input: Expr = field(compare=False, repr=False)
    ideal: tuple[str, ...] = field(default=(), compare=False, repr=False)

    @property
    def irreducible(self) -> bool:
        """Whether each factor is known to be irreducible over the rationals."""
        return all(f.irreducible for f in self.factors)

    @property
    def complete(self) -> bool:
        """Whether each factor is known to be irreducible and has a form, all proved."""
        return self.irreducible and all(f.proved and f.expression is not None for f in self.factors)

    @property
    def decided(self) -> bool:
        """Whether each factor is known to be irreducible, and has a proved form or certainly none of those sought."""
        return self.irreducible and all(f.proved for f in self.factors)

    def to_expr(self) -> Expr:
        """coefficient · Π factors, equal to the input: each as its form, or as its polynomial where that has a cofactor
        or there is none.
        """
        number, factors = self.coefficient, list[Expr]()
        for f in self.factors:
            shown = in_letters(f.polynomial)
            if f.closed and f.expression is not None:
                number = Number(number * number_power(f.coefficient, f.times)).value
                shown = f.expression
            factors += repeat(shown, f.times)
        return ex.mul(Number(number), *factors)

    def product(self) -> Expr:
        """coefficient · Π polynomials, equal to the input."""
        every = (e for f in self.factors for e in repeat(in_letters(f.polynomial), f.times))
        return ex.mul(Number(self.coefficient), *every)

    def to_json(self) -> dict[str, Any]:
        """`{coefficient, factors, irreducible, certificate}`; each factor is `{polynomial, times, degrees, irreducible,
        form, expression, coefficient, cofactor, certificate, excluded, undecided}`, text of the language.
        """
        found = {
            "coefficient": _number(self.coefficient),
            "factors": [dict(self._factor(f)) for f in self.factors],
            "irreducible": self.irreducible,
            "certificate": self.certificate.to_json(),
        }
        return in_plain_letters(found, self.points)

    def _factor(self, f: IrreducibleFactor) -> Iterator[tuple[str, Any]]:
        yield "polynomial", polynomial_text(f.polynomial)
        yield "times", f.times
        yield "degrees", f.degrees
        yield "irreducible", f.irreducible
        yield "form", f.form
        yield "expression", None if f.expression is None else text(f.expression, names=self.points)
        yield "coefficient", _number(f.coefficient)
        yield "cofactor", text(f.cofactor, names=self.points)
        yield "certificate", f.certificate.to_json()
        yield "excluded", list(f.excluded)
        yield "undecided", list(f.undecided)


def _number(value: int | Fraction) -> int | str:
    return int(value) if value.denominator == 1 else str(value)
