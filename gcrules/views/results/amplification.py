"""What the actuators of a robot make of their rates, as lines of text and rows of a table."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.amplification import INDICES, Amplification, Amplifications
from gcrules.views.formulas.latex_text import latex_quantity
from gcrules.views.text_tables import columns

__all__ = ["amplification_lines", "amplification_rows", "conditioning", "conditioning_rows", "index_ranges"]

_NOTHING = 1e-12
_SINGULAR = 1e-7  # isotropies below, as of a zero that is known up to rounding
_ALONG = ("isotropy", "speed", "turn", "closure")


def conditioning(a: Amplification, unit: str) -> str:
    """ "condition number 1.2, isotropy 0.83; characteristic length 5 mm"."""
    words = (
        f"condition number {_number(a.condition_number)}, isotropy {_number(a.isotropy)}; characteristic length"
        f" {a.length:.4g} {unit}"
    ).rstrip()
    if a.cables is None:
        return words
    closed = f"wrench closure, least tension {_number(a.cables.least)} of the mean one"
    return f"{words}; {closed if a.cables.held else 'wrench closure is lost'}"


def amplification_lines(a: Amplification, unit: str) -> Iterator[str]:
    """For each actuator the speed and the turn of the platform; nothing where there are no such numbers."""
    if not (rows := list(amplification_rows(a, unit))):
        return
    yield ""
    yield "Actuators, one at unit rate and the others locked: speed of the centre, turn of the platform"
    yield from columns(rows, "  ")


def amplification_rows(a: Amplification, unit: str) -> Iterator[tuple[str, str, str]]:
    """For each actuator its name, the speed and the turn; nothing where there are no such numbers."""
    if not any(map(math.isfinite, a.speeds)):
        return
    length = unit or "length"
    for name, angle, speed, turn in zip(a.actuators, a.angles, a.speeds, a.turns, strict=True):
        units = (f" {length}/rad", "") if angle else ("", f" rad/{length}")
        speeds, turns = (_number(x) + u * math.isfinite(x) for x, u in zip((speed, turn), units, strict=True))
        yield name, speeds, turns


def index_ranges(a: Amplifications, parameters: NDArray[np.float64], unit: str) -> Iterator[tuple[str, str]]:
    """The worst isotropy, speed and turn of the samples, and at which parameter; nothing where one is singular."""
    if not a.isotropy.min(initial=1.0) > _SINGULAR:
        return
    for name in (n for n in _ALONG if n in a.indices):
        index, values = INDICES[name], a.indices[name]
        worst = int(values.argmin() if index.small else values.argmax())
        if values[worst]:
            number = f"{_number(float(values[worst]))} {index.unit(unit, a.angles)}".rstrip()
            end = "least" if index.small else "largest"
            yield name, f"{number} at parameter {parameters[worst]:.4g}, the {end} of the samples"


def conditioning_rows(a: Amplification, unit: str) -> Iterator[tuple[str, str]]:
    """Rows of a LaTeX table."""
    yield "condition number of the actuators", latex_quantity(a.condition_number)
    yield "isotropy", latex_quantity(a.isotropy)
    yield "\\quad with the characteristic length", latex_quantity(a.length, unit)


def _number(x: float) -> str:
    if math.isnan(x):
        return "not defined"
    return "infinite" if math.isinf(x) else "0" if abs(x) < _NOTHING else f"{x:.4g}"
