r"""From a robot of joints to the polynomials of its singular configurations.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> found = limb_locus(mechanism("3-rpr"), "x, y", None, "yaw=90deg", "quaternion", 300)
>>> print(found.parts[0].form)
450*x^2 - 126*x*y + 324*y^2 - 279*x + 525*y - 3959
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gcrules.core.errors import LimitReached
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.vectors import add
from gcrules.poses.loci.closed_form import ClosedFactor, closed_form
from gcrules.poses.loci.elimination import Eliminated, Numerator, eliminated
from gcrules.poses.loci.factors import PossibleFactor, factored
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import whole_ring
from gcrules.poses.loci.limb_question import TANGENTS, limb_question
from gcrules.poses.loci.limb_report import LocusPart, RobotLocus, RobotLocusFactor
from gcrules.poses.loci.working_modes import CHECKS, Modes
from gcrules.screws.pose import Pose

__all__ = ["limb_locus"]


def limb_locus(
    m: Limbs,
    over: str | Sequence[str] | None,
    fix: str | Mapping[str, Any] | None,
    at: str | Mapping[str, Any] | Pose | None,
    rotation: str,
    limit: int,
    product: bool | None = None,
) -> RobotLocus:
    """The locus of a robot of joints; arguments as those of `locus`.

    Raises InputError for what is no question about its coordinates, and where its loops are not eliminated;
    LimitReached where that makes too large polynomials.
    """
    asked = limb_question(m.linkage, over, fix, at, rotation)
    form = closed_form(m, asked.coordinates)
    found = eliminated(form, asked, product)
    modes = Modes(form, asked, found, m.linkage.size)
    parts = []
    for factor, numerator in zip(form.factors, found.numerators, strict=True):
        if numerator.form.terms:
            modes.check(factor, numerator)
        parts.append(_part(modes, factor, numerator, found, limit))
    return RobotLocus(
        robot=m.robot,
        question=asked,
        centre=add(form.centre, m.linkage.origin),
        parts=tuple(parts),
        roots=found.roots,
        multiplied=found.multiplied,
        checked=FrozenMap({"configurations": form.compared, "norms": CHECKS}),
        limit=limit,
        chosen=any(part.chosen for part in m.analysis.parts),
    )


def _part(modes: Modes, factor: ClosedFactor, numerator: Numerator, every: Eliminated, limit: int) -> LocusPart:
    found: tuple[RobotLocusFactor, ...] | None = ()
    undecided = ("", "")
    if numerator.form.terms:
        ring = whole_ring(numerator.form.variables)
        turns = [PossibleFactor("norm", "", 1 + x**2) for x in ring.gens if str(x) in TANGENTS]
        try:
            irreducible = factored(ring.from_dict(dict(numerator.form.terms)), turns, limit)
            forms = [(kind, name, PolynomialForm.of(f), times) for kind, name, f, times in irreducible]
            found = tuple(
                RobotLocusFactor(
                    kind, name, p, times, modes.sightings(factor, numerator, p) if every.multiplied else None
                )
                for kind, name, p, times in forms
            )
        except LimitReached as fault:
            if not fault.hint or "--limit" not in fault.hint:
                raise
            found, undecided = None, (fault.message, fault.hint)
    return LocusPart(
        factor.expression,
        factor.cofactor,
        factor.kind,
        factor.statement,
        numerator.form,
        numerator.coefficient,
        numerator.below,
        tuple(every.roots[k].name for k in numerator.roots),
        found,
        undecided,
    )
