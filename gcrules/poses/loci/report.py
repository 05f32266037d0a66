r"""The locus of the singular poses of six legs: a polynomial in the variables of a pose, and its factors."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.shown import Shown
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.poses.loci.factors import factored
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import candidates, whole_ring
from gcrules.poses.loci.polynomial import LocusPolynomial, listed
from gcrules.poses.loci.variables import Question
from gcrules.poses.loci.zero_set import ZeroSet, zero_set, zeros_json
from gcrules.rules.condition import Condition

__all__ = ["Locus", "LocusFactor"]


@dataclass(frozen=True)
class LocusFactor:
    """An irreducible factor. `kind` is norm (of the quaternion: zero in no pose) | bracket (of `name`) | condition."""

    kind: str
    name: str
    form: PolynomialForm
    multiplicity: int

    @cached_property
    def zero_set(self) -> ZeroSet | None:
        """What the zeros are of a factor of degree 1 or 2 in two or three of x, y and z."""
        return zero_set(self.form)

    def to_json(self) -> dict[str, Any]:
        return {
            "kind": self.kind,
            "name": self.name,
            "multiplicity": self.multiplicity,
            "degree": self.form.degree,
            "terms": len(self.form.terms),
            **zeros_json(self.zero_set),
            **listed(self.form),
        }


@dataclass(frozen=True)
class Locus(LocusPolynomial, Shown):
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
    def verdict(self) -> str:
        """regular | singular (every pose that was asked for) | architecturally singular (every pose of the robot)."""
        if not self.vanishes:
            return "regular"
        return "architecturally singular" if self.question.whole else "singular"

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

    def picture(self) -> Any:
        """Over one variable the graph of the polynomial with its zeros, over two the curves of its factors: a drawing
        with `svg()`. Raises InputError for more variables, and where every pose is singular.
        """
        return self._show("picture")

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
            "rounded": q.turn_is_rounded,
            "quaternion": None if q.turn is None else [str(c) for c in q.turn],
            "verdict": self.verdict,
            "degrees": self.degrees,
            "terms": len(self.form.terms),
            "identity": {
                "norm": [str(n) for n in self.norms],
                "power": 3,
                "coefficient": str(self.coefficient),
            },
            "polynomial": listed(self.form),
            "factors": factors,
            "factors_undecided": undecided,
            "checked": dict(self.checked),
        }

    def __repr__(self) -> str:
        if self.vanishes:
            return f"<Locus 0 in {', '.join(self.variables)}: {self.verdict}>"
        return f"<Locus of degree {self.form.degree} in {', '.join(self.variables)}: {len(self.form.terms)} terms>"
