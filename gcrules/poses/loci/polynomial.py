r"""What every locus has: one polynomial, with its degrees, its values, and how it is written elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.variables import TRANSLATION

if TYPE_CHECKING:
    import sympy

__all__ = ["LocusPolynomial", "degrees_of", "listed"]


class LocusPolynomial:
    """A locus whose polynomial is its `form`."""

    form: PolynomialForm

    @property
    def vanishes(self) -> bool:
        """Whether every pose of the question is singular."""
        return not self.form.terms

    @property
    def variables(self) -> tuple[str, ...]:
        return self.form.variables

    @property
    def degrees(self) -> dict[str, int]:
        """The degree in each variable, in the translation and the rotation (where they are free), and in all."""
        return degrees_of(self.form)

    @property
    def polynomial(self) -> sympy.Poly:
        """The polynomial as a sympy.Poly over the integers."""
        return self.form.poly

    def __call__(self, **values: Any) -> Any:
        """The polynomial's value: numbers by the names of the variables, exact for integers and Fractions."""
        return self.form([values[n] for n in self.variables])

    def to_sympy(self) -> sympy.Expr:
        """The polynomial as an expression of sympy."""
        return self.form.poly.as_expr()

    def written(self, style: str) -> str:
        """The polynomial for sympy, maple or singular, as text."""
        return self.form.written(style)


def degrees_of(form: PolynomialForm, roots: Sequence[str] = ()) -> dict[str, int]:
    """The degree in each variable, in the translation and the rotation (where they are free), and in all; without
    variables that are `roots`, whose degree is 1 at most.
    """
    free = [n for n in form.variables if n not in roots]
    turning = [n for n in free if n not in TRANSLATION]
    groups = {"translation": [n for n in TRANSLATION if n in free], "rotation": turning}
    found = {n: form.degree_in([n]) for n in free}
    found |= {name: form.degree_in(names) for name, names in groups.items() if names}
    return found | {"total": form.degree_in(free)}


def listed(form: PolynomialForm) -> dict[str, Any]:
    """Exponents and coefficients, as texts, of its terms."""
    return {"exponents": [list(e) for e, _ in form.terms], "coefficients": [str(c) for _, c in form.terms]}
