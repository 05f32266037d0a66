r"""The locus of a robot of joints: a polynomial for each factor of its condition, over all working modes."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.shown import Shown
from gcrules.mechanisms.robot import Robot
from gcrules.poses.loci.elimination import FormalRoot
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import whole_ring
from gcrules.poses.loci.limb_question import LimbQuestion
from gcrules.poses.loci.polynomial import LocusPolynomial, degrees_of, listed
from gcrules.poses.loci.report import LocusFactor
from gcrules.poses.loci.working_modes import Sightings

__all__ = ["LocusPart", "RobotLocus", "RobotLocusFactor"]


@dataclass(frozen=True)
class RobotLocusFactor(LocusFactor):
    """An irreducible factor of a part. `kind` is condition | norm (of a half-tangent: 1 + t², zero in no pose).
    `seen` says in which working modes the robot is singular at zeros of it; None if its roots are variables, whose
    signs are the mode.
    """

    seen: Sightings | None

    def to_json(self) -> dict[str, Any]:
        found, seen = super().to_json(), self.seen
        if seen is None:
            return found
        counts = {"zeros": seen.zeros, "every_zero": seen.every, "assembled": seen.assembled}
        return found | counts | {"modes": list(seen.modes)}


@dataclass(frozen=True)
class LocusPart:
    """A factor of the condition: its `expression`, `kind` and `statement`, as those of `RobotAnalysis.parts`. Where the
    expression is known up to a `cofactor` ("" if not), it is their quotient that is meant.

    The product of it over all signs of the `roots`, the working modes, is `coefficient` · `form` / ∏ `below`^power,
    exactly, in lowest terms. So `form`, with whole coefficients without a common divisor, is 0 exactly where the
    factor vanishes in some working mode, with roots of negative radicands counted too (and where `below` is 0 a place
    is not definite). Where roots are kept (`RobotLocus.multiplied` is False) the same is said of the factor itself,
    not of the product, and their names are variables of the form: it is 0 where the factor vanishes in the mode of
    their signs. `found` are its irreducible factors, None where they are `undecided` within the limit.
    """

    expression: str
    cofactor: str
    kind: str
    statement: str
    form: PolynomialForm
    coefficient: Fraction
    below: tuple[tuple[PolynomialForm, int], ...]
    roots: tuple[str, ...]
    found: tuple[RobotLocusFactor, ...] | None
    undecided: tuple[str, str]

    @property
    def vanishes(self) -> bool:
        """Whether the factor is 0 in some working mode at every pose of the question."""
        return not self.form.terms

    @property
    def degrees(self) -> dict[str, int]:
        """Those of the form, as `RobotLocus.degrees`."""
        return degrees_of(self.form, self.roots)

    @property
    def factors(self) -> tuple[RobotLocusFactor, ...]:
        """The irreducible factors over the rationals, up to sign. Raises LimitReached where they are not decided."""
        if self.found is None:
            raise LimitReached(self.undecided[0], hint=self.undecided[1])
        return self.found

    def to_json(self) -> dict[str, Any]:
        return {
            "expression": self.expression,
            "cofactor": self.cofactor or None,
            "kind": self.kind,
            "statement": self.statement,
            "degrees": self.degrees,
            "terms": len(self.form.terms),
            "identity": {
                "roots": list(self.roots),
                "coefficient": str(self.coefficient),
                "below": [{"polynomial": str(p), "power": n} for p, n in self.below],
            },
            "polynomial": listed(self.form),
            "factors": None if self.found is None else [f.to_json() for f in self.found],
            "factors_undecided": self.undecided[0] or None,
        }


@dataclass(frozen=True)
class RobotLocus(LocusPolynomial, Shown):
    """The singular configurations over the free variables of the `question`, whose other coordinates are fixed.

    Each of the `parts` is a factor of the condition. `roots` tell apart the working modes: if `multiplied`, the forms
    are products over all of them; else the roots are variables beside those of the question. `centre` is what the
    platform turns about, in the frame of the file. `checked` says at how many configurations the closed form was
    compared with the joints, and at how many poses each form was computed again from the working modes; `limit` is that
    of factors; `chosen` says that the condition vanishes, too, where lines that were chosen for a limb depend on each
    other.
    """

    robot: Robot
    question: LimbQuestion
    centre: tuple[Any, ...]
    parts: tuple[LocusPart, ...]
    roots: tuple[FormalRoot, ...]
    multiplied: bool
    checked: Mapping[str, int]
    limit: int
    chosen: bool = False

    @cached_property
    def form(self) -> PolynomialForm:  # type: ignore[override]
        """The product of the parts' forms."""
        if len(self.parts) == 1:
            return self.parts[0].form
        ring = whole_ring(self.variables)
        total = ring.one
        for part in self.parts:
            total = total * ring.from_dict(dict(part.form.terms))
        return PolynomialForm.of(total)

    @property
    def vanishes(self) -> bool:
        """Whether every pose of the question is singular in some working mode."""
        return any(part.vanishes for part in self.parts)

    @property
    def verdict(self) -> str:
        """regular | singular: whether every pose that was asked for is singular in some working mode."""
        return "singular" if self.vanishes else "regular"

    @property
    def variables(self) -> tuple[str, ...]:
        """Those of the question, and the roots where they are kept."""
        return self.question.free if self.multiplied else (*self.question.free, *(r.name for r in self.roots))

    @property
    def degrees(self) -> dict[str, int]:
        return degrees_of(self.form, [r.name for r in self.roots])

    @property
    def factors(self) -> tuple[RobotLocusFactor, ...]:
        """Those of all parts. Raises LimitReached where some are not decided."""
        return tuple(f for part in self.parts for f in part.factors)

    def written(self, style: str) -> str:
        """The polynomial for sympy, maple or singular, as text; with the squares of the roots where they are kept."""
        return self.form.written(style, () if self.multiplied else [(r.name, r.radicand) for r in self.roots])

    def picture(self) -> Any:
        """Over one variable the graph of the polynomial with its zeros, over two the curves of its factors: a drawing
        with `svg()`. Raises InputError for more variables, and where every pose is singular.
        """
        return self._show("picture")

    def to_json(self) -> dict[str, Any]:
        """One JSON object; coefficients are texts, exponents belong to `variables`."""
        q = self.question
        return {
            "schema": 1,
            "title": self.robot.title,
            "robot": self.robot.id,
            "about": [str(c) for c in self.centre],
            "coordinates": list(q.coordinates),
            "variables": list(self.variables),
            "fixed": {n: str(c) for n, c in q.fixed.items()},
            "rounded": bool(q.rounded),
            "verdict": self.verdict,
            "roots": [r.to_json() for r in self.roots],
            "multiplied": self.multiplied,
            "parts": [part.to_json() for part in self.parts],
            "checked": dict(self.checked),
            "vanishes_where_chosen_lines_depend": self.chosen,
        }

    def __repr__(self) -> str:
        degrees = ", ".join(
            f"{p.kind} of degree {p.degrees['total']} with {len(p.form.terms)} terms" for p in self.parts
        )
        return f"<RobotLocus {self.robot.id} in {', '.join(self.question.free)}: {degrees}>"
