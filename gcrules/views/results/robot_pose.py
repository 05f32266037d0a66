r"""A robot's numbers in one configuration as plain text and as LaTeX: the verdict with its reason, then tables."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gcrules.poses.limbs.report import RobotPose
from gcrules.screws.pose_text import SHIFTS, TURNS
from gcrules.screws.threshold import degrees
from gcrules.views.formulas.latex import latex_name
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.text_tables import ASCII, columns, table, wrapped

__all__ = ["as_latex", "as_text"]

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
    yield from table(
        [
            ("robot", f"{r.title} ({r.robot}), at {r.target}"),
            ("pose", _pose(r)),
            ("margin", f"σ = {_small(r.margin)} (0 singular, at most 1; knows neither frame nor unit)"),
            (
                "Jacobian",
                f"{len(j.labels)} wrenches, smallest singular value {_small(j.smallest_singular_value)}, condition "
                f"number {_number(j.condition_number)}; characteristic length {j.length:.4g}",
            ),
            (
                "assembled",
                f"loops open by {_off(r.residual)} of the robot's size, relations off by {_off(r.disagreement)}; "
                f"{_counted(r.steps, 'step')} from home, {_counted(r.iterations, 'iteration')}",
            ),
            ("branch", r.assembly.branch),
            ("mode", r.mode),
            *(("note", note) for note in r.notes),
        ]
    )
    yield ""
    yield "Actuators, from home"
    yield from columns([(a.name, _amount(value, a.angle), f"{a.limb}: {a.joint}") for a, value in r.actuators], "  ")
    if r.factors:
        yield ""
        yield "Factors of the condition"
        for f in r.factors:
            yield from wrapped(f"{_sign(f.expression)}", "  ", "      ")
            yield from wrapped(f"{_small(f.value)}, {_meaning(f.kind, f.statement)}", "    ", "      ")
            if f.cofactor:
                below = f"divided by the cofactor {_sign(f.cofactor)}, which is {_small(f.cofactor_value)} here"
                yield from wrapped(below, "    ", "      ")
    yield ""
    yield "Limbs by themselves: margin to their own singularities (0 singular)"
    yield from columns([(limb.name, _small(limb.margin), "") for limb in r.limbs], "  ")
    if r.verdict != "regular":
        yield ""
        yield f"{'Nearly d' if r.verdict == 'close' else 'D'}ependent wrenches, which balance in these ratios"
        rows = [(limb.name, _small(limb.share), limb.wrench(j.centre, j.length)) for limb in r.limbs]
        yield from columns(rows, "  ")
    yield ""
    yield from _motion(r)


def _motion(r: RobotPose) -> Iterator[str]:
    if r.motions:
        for motion in r.motions:
            yield from wrapped(f"Gained motion: the platform can {motion.text()}; to first order no limb resists.")
        return
    yield from wrapped(
        f"Softest motion: the platform can {r.softest.text()}. The limbs' wrenches notice only {r.margin:.3g} times"
        " as much of it as the platform's joints move (root mean squares)."
    )


def _pose(r: RobotPose) -> str:
    c = r.coordinates
    parts = [f"{n} {_small(c[n])}" for n in SHIFTS] + [f"{n} {_degrees(c[n])}" for n in TURNS]
    about = ", ".join(f"{x:.4g}" for x in r.centre)
    return f"{', '.join(parts)}; of the centre ({about}), from home"


def _off(x: float) -> str:
    return f"at most {x:.1g}" if x > _EXACT else f"less than {_EXACT:g}"


def _counted(n: int, word: str) -> str:
    return f"{n} {word}{'s' * (n != 1)}"


def _meaning(kind: str, statement: str) -> str:
    return f"{kind}: 0 where {statement}" if statement else kind


def _amount(value: float, angle: bool) -> str:
    return _degrees(value) if angle else _small(value)


def _degrees(angle: float) -> str:
    return degrees(angle if abs(angle) > 1e-12 else 0.0)


def _sign(expression: str) -> str:
    return expression.replace("/\\", "∧").replace("\\/", "∨")


def _small(x: float) -> str:
    return "0" if abs(x) < 1e-12 else _number(x)


def _number(x: float) -> str:
    return "not defined" if math.isnan(x) else f"{x:.4g}" if math.isfinite(x) else "infinite"


def as_latex(r: RobotPose) -> str:
    """A tabular of the numbers; needs no package."""
    rows = [
        ("verdict", r.verdict),
        ("margin $\\sigma$", latex_quantity(r.margin)),
        ("smallest singular value", latex_quantity(r.jacobian.smallest_singular_value)),
        ("condition number", latex_quantity(r.jacobian.condition_number)),
        ("characteristic length", latex_quantity(r.jacobian.length)),
        *((f"${latex_name(a.name)}$", latex_quantity(v, "rad" if a.angle else "")) for a, v in r.actuators),
    ]
    return latex_table(rows)
