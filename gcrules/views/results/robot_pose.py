r"""A robot's numbers in one configuration as plain text and as LaTeX: the verdict with its reason, then tables."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from gcrules.core.english import counted, listed
from gcrules.mechanisms.kinematics.closure import CableTensions
from gcrules.poses.limbs.factors import ConditionFactor
from gcrules.poses.limbs.report import NearestConfiguration, RobotPose
from gcrules.poses.numbers.motion import twist_of
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS
from gcrules.screws.threshold import degrees, safe
from gcrules.views.formulas.latex import latex_name
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.results.amplification import (
    above_rounding,
    amplification_lines,
    conditioning,
    conditioning_rows,
    jacobian_numbers,
    transmission_lines,
)
from gcrules.views.results.singularity_types import in_words
from gcrules.views.text_tables import ASCII, columns, table, wrapped

__all__ = ["amount_rows", "as_latex", "as_text", "divided", "meaning", "motions", "rows", "signed", "small"]

_EXACT = 1e-12


def as_text(r: RobotPose, *, unicode: bool = False) -> str:
    """The whole report; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else found.translate(ASCII)


def _lines(r: RobotPose) -> Iterator[str]:
    yield from wrapped(f"{r.verdict}: {r.reason}")
    for sentence in r.causes:
        yield from wrapped(sentence, "  ")
    yield ""
    j = r.jacobian
    yield from table([("robot", f"{r.title} ({r.robot}), at {r.target}"), *rows(r)])
    yield ""
    yield "Actuators, from home"
    yield from columns(amount_rows(r), "  ")
    yield from amplification_lines(j.amplification, r.unit)
    yield from transmission_lines(j.amplification, r.unit)
    if j.amplification.cables:
        yield from _cables(j.amplification.cables, r)
    if r.factors:
        yield ""
        yield "Factors of the condition"
        for f in r.factors:
            yield from wrapped(f"{signed(f.expression)}", "  ", "      ")
            yield from wrapped(f"{small(f.value)}, {meaning(f.kind, f.statement)}", "    ", "      ")
            if below := divided(f):
                yield from wrapped(below, "    ", "      ")
    yield ""
    yield "Limbs by themselves: margin to their own singularities (0 singular)"
    yield from columns([(limb.name, small(limb.margin), "") for limb in r.limbs], "  ")
    if r.verdict != "regular":
        yield ""
        yield f"{'Nearly d' if r.verdict == 'close' else 'D'}ependent wrenches, which balance in these ratios"
        shares = [(limb.name, small(limb.share), limb.wrench(j.centre, j.length)) for limb in r.limbs]
        yield from columns(shares, "  ")
    yield ""
    for sentence in motions(r):
        yield from wrapped(sentence)
    if r.types:
        yield ""
        yield "Types of singularity (Zlatanov, Fenton and Benhabib)"
        for t in r.types:
            yield from wrapped(f"{t.symbol:<3} {in_words(t)}", "  ", "      ")
    if r.nearest:
        yield ""
        yield from _nearest(r.nearest, r.unit)


def rows(r: RobotPose) -> Iterator[tuple[str, str]]:
    """The pose and its numbers, names with what they say."""
    j = r.jacobian
    yield "pose", _pose(r)
    yield "margin", f"σ = {small(r.margin)} (0 singular, at most 1; the same in every frame and unit)"
    yield "Jacobian", f"{len(j.labels)} wrenches, {jacobian_numbers(j, r.unit)}"
    yield "actuators", conditioning(j.amplification, r.unit)
    yield (
        "assembled",
        f"loops open by {_off(r.residual)} of the robot's size, relations off by {_off(r.disagreement)}; "
        f"{counted(r.steps, 'step')} from home, {counted(r.iterations, 'iteration')}",
    )
    yield "branch", r.assembly.branch
    yield "mode", r.mode
    yield from (("note", note) for note in r.notes)


def divided(f: ConditionFactor) -> str:
    """By what the value of a factor is divided, where it is known up to that; else nothing."""
    return (
        f"divided by the cofactor {signed(f.cofactor)}, which is {small(f.cofactor_value)} here" if f.cofactor else ""
    )


def amount_rows(r: RobotPose) -> list[tuple[str, str, str]]:
    """Of each actuator its name, its amount from home, and where it is."""
    return [(a.name, _amount(value, a.angle, r.unit), f"{a.limb}: {a.joint}") for a, value in r.actuators]


def _cables(c: CableTensions, r: RobotPose) -> Iterator[str]:
    yield ""
    if c.escape is None:
        yield f"Wrench closure: tensions that balance each other, for a mean of 1; the least is {small(c.least)}"
        limbs = {a.name: a.limb for a, _ in r.actuators}
        yield from columns([(name, small(effort), limbs[name]) for name, effort in c.efforts], "  ")
        return
    motion = twist_of(np.array(c.escape[:3]), np.array(c.escape[3:]), r.jacobian.centre, r.jacobian.length)
    words = "Wrench closure is lost: no tensions that are all positive balance each other. The platform can"
    yield from wrapped(f"{words} {motion.text(r.unit)} without any cable getting longer.")


def _nearest(n: NearestConfiguration, unit: str) -> Iterator[str]:
    if not n.directions:
        yield "Nearest singular configuration"
        words = "not sought: with more actuators than freedoms the sign of no determinant tells where it is"
        yield from wrapped(words, "  ", "    ")
        yield from _free_box(n, unit)
        return
    yield "Nearest singular configuration, by a search in all directions"
    stopped = f"; in {n.stopped} of them the robot cannot be followed that far" if n.stopped else ""
    measure = f"shifts as parts of the robot's size, {_length(n.size, unit)}, and angles in radians"
    if n.changes:
        where = ", ".join(f"{name} {_change(name, v, unit)}" for name, v in n.changes.items())
        yield from wrapped(f"{where} from here; distance {n.distance:.4g} ({measure})", "  ", "    ")
        for cause in n.causes:
            yield from wrapped(cause, "    ", "      ")
        if n.actuators and not n.branch_proved:
            yield from wrapped("that it is on the same branch of solutions is not proved", "    ", "      ")
        yield from wrapped(
            f"found from {n.directions} directions{stopped}; another one may be nearer", "    ", "      "
        )
    else:
        words = f"none found up to the distance {n.reach:.4g} ({measure}) in {n.directions} directions{stopped}"
        yield from wrapped(words, "  ", "    ")
    yield from _free_box(n, unit)


def _free_box(n: NearestConfiguration, unit: str) -> Iterator[str]:
    if not any(n.free.values()):
        yield from wrapped("no box around this configuration was proved free of them", "  ", "    ")
        return
    bounds = []
    for angle in (False, True):
        names = [name for name in n.free if (name in ANGLES) == angle]
        if names:
            each = " each" if len(names) > 1 else ""
            change = "changes" if len(names) == 1 else "change"
            least = safe(n.free[names[0]], None if angle else unit)
            bounds.append(f"{listed(names)}{each} {change} by less than {least}")
    yield from wrapped(
        f"proved: on this branch no configuration is singular while {' and '.join(bounds)}", "  ", "    "
    )


def _change(name: str, value: float, unit: str) -> str:
    shown = _amount(value, name in ANGLES, unit)
    return shown if value <= 0 else f"+{shown}"


def motions(r: RobotPose) -> tuple[str, ...]:
    """What the platform gains, or the motion that the limbs notice least, as sentences."""
    if r.motions:
        return tuple(
            f"Gained motion: the platform can {m.text(r.unit)}; to first order no limb resists." for m in r.motions
        )
    return (
        f"Softest motion: the platform can {r.softest.text(r.unit)}. The limbs' wrenches notice only {r.margin:.3g}"
        " times as much of it as the platform's joints move (root mean squares).",
    )


def _pose(r: RobotPose) -> str:
    c = r.coordinates
    parts = [f"{n} {_amount(c[n], False, r.unit)}" for n in SHIFTS] + [f"{n} {_degrees(c[n])}" for n in TURNS]
    about = ", ".join(f"{x:.4g}" for x in r.centre)
    return f"{', '.join(parts)}; of the centre ({about}){f' {r.unit}'.rstrip()}, from home"


def _off(x: float) -> str:
    return f"at most {x:.1g}" if x > _EXACT else f"less than {_EXACT:g}"


def meaning(kind: str, statement: str) -> str:
    """The kind of a factor, and where it vanishes."""
    return f"{kind}: 0 where {statement}" if statement else kind


def _amount(value: float, angle: bool, unit: str) -> str:
    return _degrees(value) if angle else f"{small(value)} {unit}".rstrip()


def _length(value: float, unit: str) -> str:
    return f"{value:.4g} {unit}".rstrip()


def _degrees(angle: float) -> str:
    return degrees(angle if abs(angle) > 1e-12 else 0.0)


def signed(expression: str) -> str:
    """An expression with the signs of join and meet."""
    return expression.replace("/\\", "∧").replace("\\/", "∨")


def small(x: float) -> str:
    """A number with four digits; what is rounding only is 0."""
    return "0" if abs(x) < 1e-12 else _number(x)


def _number(x: float) -> str:
    return "not defined" if math.isnan(x) else f"{x:.4g}" if math.isfinite(x) else "infinite"


def as_latex(r: RobotPose) -> str:
    """A tabular of the numbers; needs no package."""
    rows = [
        ("verdict", r.verdict),
        *((("types", listed([t.symbol for t in r.types])),) if r.types else ()),
        ("margin $\\sigma$", latex_quantity(r.margin)),
        ("smallest singular value", latex_quantity(above_rounding(r.jacobian.smallest_singular_value))),
        ("condition number", latex_quantity(r.jacobian.condition_number)),
        ("characteristic length", latex_quantity(r.jacobian.length, r.unit)),
        *conditioning_rows(r.jacobian.amplification, r.unit),
        *((f"${latex_name(a.name)}$", latex_quantity(v, "rad" if a.angle else r.unit)) for a, v in r.actuators),
        *_latex_nearest(r.nearest, r.unit),
    ]
    return latex_table(rows)


def _latex_nearest(n: NearestConfiguration | None, length: str) -> Iterator[tuple[str, str]]:
    if n and n.changes:
        yield "nearest singular configuration found, distance", latex_quantity(n.distance)
        for name, v in n.changes.items():
            unit = "rad" if name in ANGLES else length
            yield f"\\quad change of ${latex_name(name)}$", latex_quantity(v, unit)
