"""What the actuators of a robot make of their rates, as lines of text and rows of a table."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gcrules.mechanisms.kinematics.amplification import Amplification
from gcrules.views.formulas.latex_text import latex_quantity
from gcrules.views.text_tables import columns

__all__ = ["amplification_lines", "amplification_rows", "conditioning", "conditioning_rows"]

_NOTHING = 1e-12


def conditioning(a: Amplification, unit: str) -> str:
    """ "condition number 1.2, isotropy 0.83; characteristic length 5 mm"."""
    return (
        f"condition number {_number(a.condition_number)}, isotropy {_number(a.isotropy)}; characteristic length"
        f" {a.length:.4g} {unit}"
    ).rstrip()


def amplification_lines(a: Amplification, unit: str) -> Iterator[str]:
    """For each actuator the speed and the turn of the platform; nothing where all are infinite."""
    if all(map(math.isinf, a.speeds)):
        return
    yield ""
    yield "Actuators, one at unit rate and the others locked: speed of the centre, turn of the platform"
    yield from columns(list(amplification_rows(a, unit)), "  ")


def amplification_rows(a: Amplification, unit: str) -> Iterator[tuple[str, str, str]]:
    """For each actuator its name, the speed and the turn."""
    length = unit or "length"
    for name, angle, speed, turn in zip(a.actuators, a.angles, a.speeds, a.turns, strict=True):
        units = (f" {length}/rad", "") if angle else ("", f" rad/{length}")
        speeds, turns = (_number(x) + u * math.isfinite(x) for x, u in zip((speed, turn), units, strict=True))
        yield name, speeds, turns


def conditioning_rows(a: Amplification, unit: str) -> Iterator[tuple[str, str]]:
    """Rows of a LaTeX table."""
    yield "condition number of the actuators", latex_quantity(a.condition_number)
    yield "isotropy", latex_quantity(a.isotropy)
    yield "\\quad with the characteristic length", latex_quantity(a.length, unit)


def _number(x: float) -> str:
    if math.isnan(x):
        return "not defined"
    return "infinite" if math.isinf(x) else "0" if abs(x) < _NOTHING else f"{x:.4g}"
