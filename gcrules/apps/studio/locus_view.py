"""The polynomials of the singular poses around a pose of the page, as formulas to copy."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.apps.studio.items import fact
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.protocol.locus_views import (
    LocusAnswer,
    LocusFactorView,
    LocusPartView,
    PolynomialView,
    RootView,
)
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.whereabouts import coordinates_at
from gcrules.core.budget import report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.loci.elimination import FormalRoot
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.limb_question import variable
from gcrules.poses.loci.limb_report import LocusPart, RobotLocus
from gcrules.poses.loci.locus import locus_of
from gcrules.poses.loci.polynomial import degrees_of
from gcrules.poses.loci.report import Locus, LocusFactor
from gcrules.poses.methods import Methods, has_six_legs, method
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import SHIFTS, TURNS, pose_of
from gcrules.views.results import locus as of_legs
from gcrules.views.results import robot_locus as of_limbs
from gcrules.views.results.locus import form_latex
from gcrules.views.results.polynomials import zeros_text

__all__ = ["AskedLocus", "asked_locus", "locus_at", "locus_view"]

_DENOMINATORS = 1000  # of quaternions: coefficients have their sixth powers
_SAME = 1e-12  # radians, of rounding


def locus_view(subject: Subject, found: Locus | RobotLocus, pose: PoseJson, over: Sequence[str] | None) -> LocusAnswer:
    """A locus as the page is told, with how what it is asked at was rounded."""
    asked = asked_locus(subject.mechanism, pose, over)
    told: Any = of_legs if isinstance(found, Locus) else of_limbs
    roots = () if isinstance(found, Locus) or found.multiplied else found.roots
    numbered = [] if isinstance(found, Locus) else of_limbs.numbered(found)
    return {
        "variables": list(found.variables),
        "statement": told.headline(found),
        "notes": list(asked.notes),
        "parts": [_whole(found)] if isinstance(found, Locus) else [_part(p, name, roots) for name, p in numbered],
        "roots": [_root(r) for r in roots],
        "facts": [fact(name, words) for name, words in told.account(found, unicode=True)],
    }


@kept
def locus_at(subject: Subject, pose: PoseJson, over: Sequence[str] | None) -> Locus | RobotLocus:
    """Over these coordinates, or over the position, else over all. Raises InputError and LimitReached as `locus`."""
    asked = asked_locus(subject.mechanism, pose, over)
    report("eliminating the joints")
    return locus_of(subject.mechanism, asked.free, asked.fix, asked.at)


# --- what is asked -------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class AskedLocus:
    """The `free` coordinates, the others as `locus` takes them, `fix` and `at`, and how they were rounded."""

    free: tuple[str, ...]
    fix: Mapping[str, Any] | None
    at: Pose | None
    notes: tuple[str, ...]


def asked_locus(m: Mechanism, pose: PoseJson, over: Sequence[str] | None) -> AskedLocus:
    """Which polynomial is asked for at a pose of the page. Raises InputError where the robot does not assemble."""
    return method(_ASKED, m, "the locus")(pose, over)


def _of_legs(m: SixLegs, pose: PoseJson, over: Sequence[str] | None) -> AskedLocus:
    return _at(pose["translation"], pose["quaternion"], over)


def _at(translation: Sequence[float], quaternion: Sequence[float], over: Sequence[str] | None) -> AskedLocus:
    """At a turn with short numbers."""
    largest = max(quaternion, key=abs)
    w, x, y, z = (Fraction(c / largest).limit_denominator(_DENOMINATORS) for c in quaternion)
    a, b, c = (Fraction(repr(n)) for n in translation)
    near = [float(n) * math.copysign(1.0, largest) for n in (w, x, y, z)]
    apart = math.dist(*([n / math.hypot(*q) for n in q] for q in (quaternion, near)))
    notes = _away(f"the quaternion {w}, {x}, {y}, {z}", 4 * math.asin(apart / 2))
    return AskedLocus(tuple(over or SHIFTS), None, Pose((a, b, c), (w, x, y, z)), notes)


def _of_limbs(m: Limbs, pose: PoseJson, over: Sequence[str] | None) -> AskedLocus:
    if has_six_legs(m):
        there = pose_of(coordinates_at(m, pose, (*SHIFTS, *TURNS)))
        return _at([round(c, 9) for c in map(float, there.translation)], there.unit_quaternion, over)
    names = free_coordinates(m.linkage, over or ())
    free = tuple(over or [n for n in names if n in SHIFTS] or names)
    fix: dict[str, Fraction] = {}
    notes: tuple[str, ...] = ()
    for n, value in coordinates_at(m, pose, names).items():
        if n in free:
            continue
        if n in SHIFTS:
            fix[n] = Fraction(f"{value:.9f}")
            continue
        tangent = Fraction(math.tan(value / 2)).limit_denominator(_DENOMINATORS)
        fix[variable(n)] = tangent
        notes += _away(f"{variable(n)} = {tangent}", abs(2 * math.atan(tangent) - value))
    return AskedLocus(free, fix or None, None, notes)


def _away(what: str, angle: float) -> tuple[str, ...]:
    """How far a turn with short numbers is from the one on show, where it is another one."""
    if angle < _SAME:
        return ()
    away = f"{math.degrees(angle):.2g}° from that of the pose"
    return (f"So that coefficients are short, the turn is taken as {what}, {away}.",)


_ASKED: Methods[AskedLocus] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""How it is asked of each kind of mechanism."""


# --- what is answered ----------------------------------------------------------------------------------------------


def _whole(found: Locus) -> LocusPartView:
    return _shown("P", found.condition.sentence, found.form, found, ())


def _part(part: LocusPart, name: str, roots: Sequence[FormalRoot]) -> LocusPartView:
    return _shown(name, part.statement, part.form, part, roots)


def _root(r: FormalRoot) -> RootView:
    return {
        "name": r.name,
        "places": r.places,
        "square": _polynomial(f"square_of_{r.name}", r.radicand, ()),
        "sign": " · ".join(f"({p})" for p in r.sign),
    }


def _shown(
    name: str, statement: str, form: PolynomialForm, held: Locus | LocusPart, roots: Sequence[FormalRoot]
) -> LocusPartView:
    factors: tuple[LocusFactor, ...] = ()
    undecided = ""
    try:
        factors = held.factors
    except LimitReached as fault:
        undecided = fault.message
    return {
        "name": name,
        "statement": statement,
        "polynomial": _polynomial(name, form, roots),
        "factors": [_factor(f"{name}_{k}", f, roots) for k, f in enumerate(factors, 1)],
        "undecided": undecided,
    }


def _factor(name: str, f: LocusFactor, roots: Sequence[FormalRoot]) -> LocusFactorView:
    return {
        "polynomial": _polynomial(name, f.form, roots),
        "multiplicity": f.multiplicity,
        "never": f.kind == "norm",
        "zeros": zeros_text(f.form),
    }


def _polynomial(name: str, form: PolynomialForm, roots: Sequence[FormalRoot]) -> PolynomialView:
    return {
        "degree": degrees_of(form, [r.name for r in roots])["total"],
        "terms": len(form.terms),
        "plain": str(form),
        "latex": form_latex(form),
        "python": _function(name, form, roots),
    }


def _function(name: str, form: PolynomialForm, roots: Sequence[FormalRoot]) -> str:
    """A function of Python; of roots it takes the signs, in home's mode 1."""
    signs = {r.name: f"{r.name}=1" for r in roots}
    lines = [f"def {name}({', '.join(signs.get(n, n) for n in form.variables)}):"]
    for r in roots:
        turned = "".join(f" * ({p.written('sympy')}) / abs({p.written('sympy')})" for p in r.sign)
        lines.append(f"    {r.name} = {r.name} * ({r.radicand.written('sympy')}) ** 0.5{turned}")
    return "\n".join([*lines, f"    return {form.written('sympy')}", ""])
