r"""The locus of the singular poses: a polynomial in the variables of a pose, what it is of, and its factors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

from gcrules.core.errors import LimitReached
from gcrules.core.shown import Shown
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.loci.factors import factored
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import candidates, whole_ring
from gcrules.poses.loci.variables import TRANSLATION, Question
from gcrules.rules.condition import Condition

if TYPE_CHECKING:
    import sympy

__all__ = ["Locus", "LocusFactor"]


@dataclass(frozen=True)
class LocusFactor:
    """An irreducible factor. `kind` is norm (of the quaternion: zero in no pose) | bracket (of `name`) | condition."""

    kind: str
    name: str
    form: PolynomialForm
    multiplicity: int

    def to_json(self) -> dict[str, Any]:
        return {
            "kind": self.kind,
            "name": self.name,
            "multiplicity": self.multiplicity,
            "degree": self.form.degree,
            "terms": len(self.form.terms),
            **_listed(self.form),
        }


@dataclass(frozen=True)
class Locus(Shown):
    """norm³ · superbracket = `coefficient` · `form`, exactly, for every pose of the `question`.

    `norms` are polynomials whose product is the squared length of the quaternion up to a constant, so positive in every
    pose: the singular poses are the zeros of `form`, which has whole coefficients without a common divisor. It is 0
    where every pose of the question is singular (`vanishes`). `checked` says how many poses were computed again apart
    from the expansion, exact and modulo a prime; `limit` is that of `factors`. Lengths are in the robot's unit.
    """

    rig: MovingPlatform
    condition: Condition
    question: Question
    form: PolynomialForm
    coefficient: Fraction
    norms: tuple[PolynomialForm, ...]
    checked: Mapping[str, int]
    limit: int

    @property
    def vanishes(self) -> bool:
        """Whether every pose of the question is singular."""
        return not self.form.terms

    @property
    def verdict(self) -> str:
        """regular | singular (every pose that was asked for) | architecturally singular (every pose of the robot)."""
        if not self.vanishes:
            return "regular"
        return "architecturally singular" if self.question.whole else "singular"

    @property
    def variables(self) -> tuple[str, ...]:
        return self.form.variables

    @property
    def degrees(self) -> dict[str, int]:
        """The degree in each variable, in the translation and the rotation (where they are free), and in all."""
        turning = [n for n in self.variables if n not in TRANSLATION]
        groups = {"translation": [n for n in TRANSLATION if n in self.variables], "rotation": turning}
        found = {n: self.form.degree_in([n]) for n in self.variables}
        found |= {name: self.form.degree_in(names) for name, names in groups.items() if names}
        return found | {"total": self.form.degree}

    @property
    def polynomial(self) -> sympy.Poly:
        """The polynomial as a sympy.Poly over the integers."""
        return self.form.poly

    @cached_property
    def factors(self) -> tuple[LocusFactor, ...]:
        """The irreducible factors over the rationals, up to sign; none of the polynomial 0.

        Raises LimitReached for one of more than `limit` terms that cannot be told to be irreducible.
        """
        if self.vanishes:
            return ()
        ring = whole_ring(self.variables)
        p = ring.from_dict(dict(self.form.terms))
        found = factored(p, candidates(self.rig, self.question, self.condition, self.norms), self.limit)
        return tuple(LocusFactor(kind, name, PolynomialForm.of(f), n) for kind, name, f, n in found)

    def __call__(self, **values: Any) -> Any:
        """The polynomial's value: numbers by the names of the variables, exact for integers and Fractions."""
        return self.form([values[n] for n in self.variables])

    def to_sympy(self) -> sympy.Expr:
        """The polynomial as an expression of sympy."""
        return self.form.poly.as_expr()

    def written(self, style: str) -> str:
        """The polynomial for sympy, maple or singular, as text."""
        return self.form.written(style)

    def to_json(self) -> dict[str, Any]:
        """One JSON object; coefficients are texts, exponents belong to `variables`. `factors` is null, with the reason
        in `factors_undecided`, where the limit was reached.
        """
        q = self.question
        undecided = None
        try:
            factors: Any = [f.to_json() for f in self.factors]
        except LimitReached as fault:
            factors, undecided = None, fault.message
        return {
            "schema": 1,
            "title": self.rig.title,
            "unit": self.rig.unit,
            "legs": [list(leg) for leg in self.rig.structure.legs],
            "about": [str(c) for c in self.rig.centre],
            "rotation": q.rotation,
            "variables": list(self.variables),
            "fixed": {n: str(c) for n, c in q.fixed.items()},
            "quaternion": None if q.turn is None else [str(c) for c in q.turn],
            "verdict": self.verdict,
            "degrees": self.degrees,
            "terms": len(self.form.terms),
            "identity": {
                "norm": [str(n) for n in self.norms],
                "power": 3,
                "coefficient": str(self.coefficient),
            },
            "polynomial": _listed(self.form),
            "factors": factors,
            "factors_undecided": undecided,
            "checked": dict(self.checked),
        }

    def __repr__(self) -> str:
        if self.vanishes:
            return f"<Locus 0 in {', '.join(self.variables)}: {self.verdict}>"
        return f"<Locus of degree {self.form.degree} in {', '.join(self.variables)}: {len(self.form.terms)} terms>"


def _listed(form: PolynomialForm) -> dict[str, Any]:
    return {"exponents": [list(e) for e, _ in form.terms], "coefficients": [str(c) for _, c in form.terms]}
