"""What a factorization is, as a frozen value that shows itself."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import field
from fractions import Fraction
from itertools import chain, repeat
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial, Row
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import letters_of
from gcrules.algebra.plain_letters import in_plain_letters
from gcrules.algebra.whole_letters import in_letters
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown

__all__ = [
    "UNDECIDED",
    "ExpressionFamily",
    "FactoredForm",
    "FactoredPart",
    "Factorization",
    "brackets_of",
    "polynomial_text",
]

UNDECIDED = "undecided"

MANY = 10
"""Equal factors that a text for people shows as a power."""


@dataclass(frozen=True)
class ExpressionFamily:
    """The expressions among which one was sought.

    `size` counts the expressions tested, `extensors` the different extensors that they were made of (different: not
    equal up to one constant at the positions of the test), `seconds` the time. The multilinear algorithm makes no
    extensors; `size` then counts the meets of atomic extensors that were tried.
    """

    name: str
    size: int = 0
    extensors: int = 0
    seconds: float = field(default=0.0, compare=False, repr=False)

    def searched(self) -> str:
        """What was tested, in words; the time is in `to_json` only, for it differs from run to run."""
        if self.extensors:
            return f"{self.size:,} expressions made of {self.extensors:,} extensors"
        return f"{self.size:,} meets of atomic extensors" if self.size else "nothing; no search was needed"

    def to_json(self) -> dict[str, Any]:
        """Without the time, so that equal answers are equal texts."""
        return {"name": self.name, "size": self.size, "extensors": self.extensors}


@dataclass(frozen=True)
class FactoredForm:
    """cofactor · input = coefficient · Π factors · expression."""

    coefficient: int | Fraction
    factors: tuple[Expr, ...]
    expression: Expr
    cofactor: Expr = ONE

    def product(self) -> Expr:
        """The right side."""
        return ex.mul(ex.Number(self.coefficient), *self.factors, self.expression)


def brackets_of(rows: Iterable[Row], names: tuple[str, ...]) -> tuple[Expr, ...]:
    """Brackets given by the places of their points, sorted; each is made once, however often it occurs."""
    counted = sorted(Counter(rows).items())
    made = ((ex.Bracket(tuple(ex.Point(names[i]) for i in row)), n) for row, n in counted)
    return tuple(chain.from_iterable(repeat(bracket, n) for bracket, n in made))


@dataclass(frozen=True)
class FactoredPart:
    """A factor that is no bracket, and how often it occurs; `expression` is a multiple of it, if one was found.

    `irreducible` says whether it is known that it does not split further, `undecided` what ended the search for its
    expression, if something did.
    """

    polynomial: BracketPolynomial
    times: int
    expression: Expr | None
    irreducible: bool
    undecided: str = ""


@dataclass(frozen=True)
class Factorization(Shown):
    """input = coefficient · Π factors · expression, or the certificate that the family holds no such expression, or the
    limit that ended the search.

    The expression is a product where there are several irreducible factors that are no brackets. `points` is the
    tableau order. Where there is none, `expression` is None and input = coefficient · Π factors · `remainder`; where
    the remainder is a product, `parts` are its factors, and it is None where multiplying them takes more terms than may
    be held. `alternatives` are further expressions, each with its own
    coefficient; `more` counts those that were found but not asked for. Where a cofactor was sought, `rational` holds
    the expressions found with one (cofactor · input = coefficient · Π factors · expression), `excluded` says in words
    which cofactors were tried in vain, and `undecided` which were left at a limit. Where each point occurs once and
    there is no expression, `atoms` are the atomic extensors that are left. `input` is what was factored, `ideal` its
    points at infinity.

    Where a limit ended the search, the certificate's method is "undecided" and its detail the limit. `parts` are then
    what the brackets leave, also where it is one polynomial (input = coefficient · Π factors · Π parts, the
    `remainder` is None where they are several), `more_brackets` says whether other brackets may divide, and
    `exchangeable` are classes of points any two of which may be exchanged, each with the sign that this brings.
    """

    rank: int
    points: tuple[str, ...]
    coefficient: int | Fraction
    factors: tuple[Expr, ...]
    expression: Expr | None
    family: ExpressionFamily
    certificate: Certificate
    alternatives: tuple[FactoredForm, ...] = ()
    more: int = 0
    remainder: BracketPolynomial | None = None
    rational: tuple[FactoredForm, ...] = ()
    excluded: tuple[str, ...] = ()
    undecided: tuple[str, ...] = ()
    parts: tuple[FactoredPart, ...] = ()
    more_brackets: bool = False
    exchangeable: tuple[tuple[tuple[str, ...], int], ...] = ()
    atoms: tuple[Expr, ...] = field(default=(), compare=False, repr=False)
    input: Expr | None = field(default=None, compare=False, repr=False)
    ideal: tuple[str, ...] = field(default=(), compare=False, repr=False)

    @property
    def exists(self) -> bool | None:
        """Whether there is an expression; None where a limit ended the search."""
        if self.expression is None and self.certificate.method == UNDECIDED:
            return None
        return self.expression is not None

    @property
    def proved(self) -> bool:
        """Whether the answer is certain; else a limit ended the search, or an expression was found that was tested at
        random points only.
        """
        return self.certificate.method not in ("random-points", UNDECIDED)

    def to_expr(self) -> Expr | None:
        """coefficient · Π factors · expression, equal to the input; None if no expression was found."""
        if self.expression is None:
            return None
        return FactoredForm(self.coefficient, self.factors, self.expression).product()

    def to_json(self) -> dict[str, Any]:
        """`{coefficient, factors, expression, alternatives, more, family, certificate}`, text of the language.

        Where no expression exists `remainder` is the polynomial that has none, and `parts` are its factors where there
        are several. `rational`, `excluded` and `undecided` are there if a cofactor was sought; `more_brackets` and
        `exchangeable` if a limit ended the search.
        """
        return in_plain_letters(self._data(), self.points)

    def _data(self) -> dict[str, Any]:
        found: dict[str, Any] = {
            "coefficient": _number(self.coefficient),
            "factors": [self._text(f) for f in self.factors],
            "expression": None if self.expression is None else self._text(self.expression),
            "alternatives": [self._form(form) for form in self.alternatives],
            "more": self.more,
            "family": self.family.to_json(),
            "certificate": self.certificate.to_json(),
        }
        if self.remainder is not None:
            found["remainder"] = polynomial_text(self.remainder)
        if self.parts:
            found["parts"] = [
                {
                    "polynomial": polynomial_text(part.polynomial),
                    "times": part.times,
                    "expression": None if part.expression is None else self._text(part.expression),
                    "irreducible": part.irreducible,
                    **({"undecided": part.undecided} if part.undecided else {}),
                }
                for part in self.parts
            ]
        if self.exists is None:
            found["more_brackets"] = self.more_brackets
            found["exchangeable"] = [{"points": list(some), "sign": sign} for some, sign in self.exchangeable]
        if self.rational or self.excluded or self.undecided:
            found["rational"] = [{"cofactor": self._text(f.cofactor), **self._form(f)} for f in self.rational]
            found["excluded"] = list(self.excluded)
            found["undecided"] = list(self.undecided)
        return found

    def whole(self) -> Expr:
        """The input as it was factored; what has no expression stands as a bracket polynomial."""
        if self.expression is not None:
            return FactoredForm(self.coefficient, self.factors, self.expression).product()
        if self.parts:
            left = chain.from_iterable(repeat(in_letters(p.polynomial), p.times) for p in self.parts)
            return FactoredForm(self.coefficient, self.factors, ex.mul(*left)).product()
        assert self.remainder is not None
        return FactoredForm(self.coefficient, self.factors, in_letters(self.remainder)).product()

    def _form(self, form: FactoredForm) -> dict[str, Any]:
        return {
            "coefficient": _number(form.coefficient),
            "factors": [self._text(f) for f in form.factors],
            "expression": self._text(form.expression),
        }

    def _text(self, e: Expr, unicode: bool = False) -> str:
        return text(e, unicode=unicode, names=self.points)


def polynomial_text(p: BracketPolynomial) -> str:
    """A polynomial as text of the language, in whole letters where it can be written so."""
    return text(in_letters(p), names=p.points) if letters_of(p.points) else str(p)


def short(e: Expr) -> Expr:
    """A product with the factors that occur many times as powers, in the order of their first occurrence."""
    if not isinstance(e, ex.Product):
        return e
    equal = Counter(e.factors)
    if max(equal.values()) < MANY:
        return e
    factors: list[Expr] = []
    for f, n in equal.items():
        factors += [f] * n if n < MANY else [ex.Power(f, n)]
    return factors[0] if len(factors) == 1 else ex.Product(tuple(factors))


def _number(value: int | Fraction) -> int | str:
    return int(value) if value.denominator == 1 else str(value)
