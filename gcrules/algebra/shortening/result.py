"""What was found of the shortest form of a polynomial, as a frozen value that shows itself."""

from __future__ import annotations

from dataclasses import field
from fractions import Fraction
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown

__all__ = ["Merging", "Shortening", "TermBound"]


@dataclass(frozen=True)
class Merging:
    """At least `least` terms are left where the points of each block of `blocks` are merged, with its weight.

    Without blocks: at least one term is in an orbit that does not cancel.
    """

    weight: Fraction
    least: int
    blocks: tuple[tuple[str, ...], ...]

    def __str__(self) -> str:
        where = ", ".join(" = ".join(block) for block in self.blocks)
        what = f"merging {where} leaves at least {self.least}" if where else "at least 1 outside the orbits that cancel"
        return f"{self.weight} · ({what})"


@dataclass(frozen=True)
class TermBound:
    """That the part of one multidegree takes at least `least` terms. What proves it, by the `method` of certificates:
    all `brackets` that divide it; its `monomials`, so many; weights of `mergings`, and `symmetries` (the sign of the
    image, and each point with its own).
    """

    degrees: tuple[tuple[str, int], ...]
    least: int
    method: str
    brackets: tuple[tuple[str, ...], ...] = ()
    monomials: int = 0
    mergings: tuple[Merging, ...] = ()
    symmetries: tuple[tuple[int, tuple[tuple[str, str], ...]], ...] = ()


@dataclass(frozen=True)
class Shortening(Shown):
    """`polynomial` equals the input (proved by normal forms), and no bracket polynomial with fewer than `lower` terms
    does; `bound` says why.

    `given` is the number of terms of the input as it was expanded, `monomials` that of the bracket monomials of its
    multidegree among which was searched (0 where the answer did not take it), `symmetries` the number of permutations
    of the points known to take the input to plus or minus itself. `notes` say what stopped a search, `undecided` that
    there are more bracket monomials than the limit, so that nothing was sought among them; `input` is what was
    shortened, `bounds` are what proves `lower`, for each multidegree.
    """

    polynomial: BracketPolynomial
    given: int
    lower: int
    bound: Certificate
    certificate: Certificate
    monomials: int = 0
    symmetries: int = 1
    notes: tuple[str, ...] = ()
    undecided: str = ""
    input: Expr | None = field(default=None, compare=False, repr=False)
    bounds: tuple[TermBound, ...] = field(default=(), compare=False, repr=False)

    @property
    def terms(self) -> int:
        """The number of terms of the polynomial."""
        return len(self.polynomial)

    @property
    def minimal(self) -> bool:
        """Whether it is proved that no bracket polynomial with fewer terms equals the input."""
        return self.lower == self.terms

    def to_json(self) -> dict[str, Any]:
        """`{polynomial, terms, given, lower, minimal, monomials, symmetries, bound, certificate, notes}`, and
        `undecided` where there are more bracket monomials than the limit.
        """
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
            **({"undecided": self.undecided} if self.undecided else {}),
        }
