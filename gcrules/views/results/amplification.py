"""What the actuators of a robot make of their rates, as lines of text and rows of a table."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.amplification import INDICES, Amplification, Amplifications
from gcrules.mechanisms.kinematics.transmission import Transmission
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.views.formulas.latex_text import latex_quantity
from gcrules.views.text_tables import columns, wrapped

__all__ = [
    "above_rounding",
    "actuator_notes",
    "amplification_lines",
    "amplification_rows",
    "clearances",
    "conditioning",
    "conditioning_rows",
    "index_ranges",
    "jacobian_numbers",
    "transmission_lines",
    "transmission_rows",
]

_NOTHING = 1e-12
_SINGULAR = 1e-7  # isotropies below, as of a zero that is known up to rounding
_ALONG = ("isotropy", "speed", "turn", "transmission", "constraint_transmission", "closure")


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


def jacobian_numbers(j: WrenchJacobian, unit: str) -> str:
    """ "smallest singular value 0.5, condition number 3; characteristic length 5 mm"."""
    return (
        f"smallest singular value {_number(j.smallest_singular_value)}, condition number"
        f" {_number(j.condition_number)}; characteristic length {j.length:.4g} {unit}"
    ).rstrip()


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


def transmission_lines(a: Amplification, unit: str) -> Iterator[str]:
    """What the limbs pass on, actuator by actuator, and what clearances do; nothing where a limb has loops of its
    own.
    """
    if a.transmission is None:
        return
    yield ""
    if rows := list(transmission_rows(a)):
        yield "Transmission, from 0 to 1: from the actuator to its wrench, from that to the platform"
        yield from columns(rows, "  ")
    if a.transmission.clearance_shift:  # cables have no joints
        yield from wrapped(f"{clearances(a.transmission, unit)}.", "", "  ")


def transmission_rows(a: Amplification) -> Iterator[tuple[str, str, str]]:
    """For each actuator that moves alone its name, what it passes on to its wrench, and what this passes on to the
    platform; at last the least of the constraints.
    """
    t = a.transmission
    if t is None:
        return
    passed = [row for row in zip(a.actuators, t.inputs, t.outputs, strict=True) if not math.isnan(row[2])]
    yield from ((name, _number(first), _number(last)) for name, first, last in passed)
    if t.constraints:
        yield "constraints", "", f"{_number(min(t.constraints))}, the least of {len(t.constraints)}"


def actuator_notes(a: Amplification, unit: str) -> Iterator[str]:
    """ "Actuators: condition number 1.2, …." and "Transmission: 0.8299 at least (q2, to its wrench), …."."""
    yield f"Actuators: {conditioning(a, unit)}."
    if a.transmission is None:
        return
    ways = (("to its wrench", a.transmission.inputs), ("to the platform", a.transmission.outputs))
    each = [(x, f"{name}, {way}") for way, passed in ways for name, x in zip(a.actuators, passed, strict=True)]
    least, where = min(pair for pair in each if not math.isnan(pair[0]))
    held = a.transmission.constraints
    of_constraints = f", {_number(min(held))} of the constraints" if held else ""
    yield f"Transmission: {_number(least)} at least ({where}){of_constraints}."


def clearances(t: Transmission, unit: str) -> str:
    """ "Joints with clearances c, and no tilts, shift the centre by at most 17 c and turn the platform by …"."""
    shift, turn = t.clearance_shift, t.clearance_turn
    if math.isinf(shift):
        return "Clearances of the joints, however small, have no bound here"
    turned = f" and turn the platform by at most {_number(turn)} rad/{unit or 'length'} · c" if turn else ""
    return f"Joints with clearances c, and no tilts, shift the centre by at most {_number(shift)} c{turned}"


def index_ranges(a: Amplifications, parameters: NDArray[np.float64], unit: str) -> Iterator[tuple[str, str]]:
    """The worst isotropy, speed and turn of the samples, and at which parameter; nothing where one is singular."""
    if not a.isotropy.min(initial=1.0) > _SINGULAR:
        return
    for name in (n for n in _ALONG if n in a.indices):
        index, values = INDICES[name], a.indices[name]
        worst = int(values.argmin() if index.small else values.argmax())
        if values[worst]:
            number = f"{_number(float(values[worst]))} {index.unit(unit, a.drives.angles)}".rstrip()
            end = "least" if index.small else "largest"
            yield name.replace("_", " "), f"{number} at parameter {parameters[worst]:.4g}, the {end} of the samples"


def conditioning_rows(a: Amplification, unit: str) -> Iterator[tuple[str, str]]:
    """Rows of a LaTeX table."""
    yield "condition number of the actuators", latex_quantity(a.condition_number)
    yield "isotropy", latex_quantity(a.isotropy)
    yield "\\quad with the characteristic length", latex_quantity(a.length, unit)


def _number(x: float) -> str:
    if math.isnan(x):
        return "not defined"
    return "infinite" if math.isinf(x) else f"{above_rounding(x):.4g}"


def above_rounding(x: float) -> float:
    """The number, 0 where it is rounding only."""
    return 0.0 if abs(x) < _NOTHING else x
