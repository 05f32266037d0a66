"""The numbers of a robot of joints at home, as a section of its report."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from gcrules.poses.limbs.report import RobotPose
from gcrules.views.results.amplification import amplification_rows, clearances, conditioning, transmission_rows
from gcrules.views.results.robot_pose import meaning, motions, signed, small
from gcrules.views.results.singularity_types import in_words

__all__ = ["numbers_html"]


def numbers_html(r: RobotPose) -> str:
    """Verdict with its reason and causes, margin, factors, each limb's own margin, and the softest or gained motion."""
    reasons = "".join(f'<p class="why">{escape(one)}</p>' for one in (r.reason, *r.causes))
    head = f'<h2>Numbers at home</h2><p class="verdict">{escape(r.verdict.capitalize())}</p>{reasons}'
    body = "".join(
        f"<tr><th>{escape(key)}</th><td>{escape(value)}</td><td>{escape(note)}</td></tr>"
        for key, value, note in _rows(r)
    )
    types = [f"{t.symbol}, {in_words(t)}." for t in r.types]
    last = "".join(f"<p>{escape(one)}</p>" for one in (*motions(r), *types, *r.notes))
    return f'<section class="numbers {r.verdict}">{head}<table>{body}</table>{last}</section>'


def _rows(r: RobotPose) -> Iterator[tuple[str, str, str]]:
    yield "margin σ", small(r.margin), "0 singular, at most 1; the same in every frame and unit"
    actuators = r.jacobian.amplification
    yield "actuators", "", conditioning(actuators, r.unit)
    for name, speed, turn in amplification_rows(actuators, r.unit):
        yield name, speed, f"speed of the centre at unit rate, the others locked; turn of the platform: {turn}"
    for name, first, last in transmission_rows(actuators):
        yield (
            f"transmission of {name}",
            last,
            "from its wrench to the platform" + f"; to its wrench: {first}" * bool(first),
        )
    if actuators.transmission and actuators.transmission.clearance_shift:
        yield "clearances", "", clearances(actuators.transmission, r.unit)
    for f in r.factors:
        below = f"; divided by the cofactor {signed(f.cofactor)}, {small(f.cofactor_value)} here" if f.cofactor else ""
        yield signed(f.expression), small(f.value), f"{meaning(f.kind, f.statement)}{below}"
    for limb in r.limbs:
        yield limb.name, small(limb.margin), "margin to its own singularities, 0 singular"
