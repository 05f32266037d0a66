"""What was found of the shortest form of a polynomial, as a frozen value that shows itself."""

from __future__ import annotations

from dataclasses import field
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown

__all__ = ["Shortening"]


@dataclass(frozen=True)
class Shortening(Shown):
    """`polynomial` equals the input (proved by normal forms), and no bracket polynomial with fewer than `lower` terms
    does; `bound` says why.

    `given` is the number of terms of the input as it was expanded, `monomials` that of the bracket monomials of its
    multidegree among which was searched (0 where the answer did not take it), `symmetries` the number of permutations
    of the points known to take the input to plus or minus itself. `notes` say what stopped a search; `input` is what
    was shortened.
    """

    polynomial: BracketPolynomial
    given: int
    lower: int
    bound: Certificate
    certificate: Certificate
    monomials: int = 0
    symmetries: int = 1
    notes: tuple[str, ...] = ()
    input: Expr | None = field(default=None, compare=False, repr=False)

    @property
    def terms(self) -> int:
        """The number of terms of the polynomial."""
        return len(self.polynomial)

    @property
    def minimal(self) -> bool:
        """Whether it is proved that no bracket polynomial with fewer terms equals the input."""
        return self.lower == self.terms

    def to_json(self) -> dict[str, Any]:
        """`{polynomial, terms, given, lower, minimal, monomials, symmetries, bound, certificate, notes}`."""
        return {
            "polynomial": str(self.polynomial),
            "terms": self.terms,
            "given": self.given,
            "lower": self.lower,
            "minimal": self.minimal,
            "monomials": self.monomials,
            "symmetries": self.symmetries,
            "bound": self.bound.to_json(),
            "certificate": self.certificate.to_json(),
            "notes": list(self.notes),
        }
