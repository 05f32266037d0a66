"""The numbers in a pose as a section of a report: verdict, legs or actuators, Jacobian, readings, motion."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from html import escape
from typing import Any

from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.report import PoseReport
from gcrules.views.report.account_html import blocks_html, words_html
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.results import pose as of_legs
from gcrules.views.results import robot_pose as of_limbs
from gcrules.views.results.actuators import actuator_grid
from gcrules.views.results.amplification import clearances, transmission_rows
from gcrules.views.results.result_account import Block, Facts, Grid, Sentences
from gcrules.views.results.singularity_types import in_words

__all__ = ["pose_html"]


def pose_html(r: PoseReport | RobotPose, m: SixLegs | Limbs, title: str = TITLES["pose"]) -> str:
    """The verdict with its reason and causes, then all numbers as tables."""
    reasons = "".join(f'<p class="why">{words_html(one)}</p>' for one in (r.reason, *r.causes))
    head = f'<h2>{escape(title)}</h2><p class="verdict">{escape(r.verdict.capitalize())}</p>{reasons}'
    return f'<section class="motion {r.verdict}">{head}{blocks_html(_BLOCKS[type(r)](r, m))}</section>'


def _of_legs(r: PoseReport, m: SixLegs | Limbs) -> Iterator[Block]:
    yield Facts(tuple(of_legs.rows(r)))
    yield actuator_grid(r, m)
    yield from _transmission(r)
    for part, readings in of_legs.reading_rows(r).items():
        yield Grid(("reading", "value", "meaning"), tuple(readings), f"Readings of {part}")
    yield Sentences(tuple(of_legs.motions(r)), "Motion")


def _of_limbs(r: RobotPose, m: SixLegs | Limbs) -> Iterator[Block]:
    yield Facts(tuple(of_limbs.rows(r)))
    yield actuator_grid(r, m)
    yield from _transmission(r)
    if r.factors:
        factors = tuple(
            (of_limbs.signed(f.expression), of_limbs.small(f.value), "; ".join(filter(None, words)))
            for f in r.factors
            for words in ((of_limbs.meaning(f.kind, f.statement), of_limbs.divided(f)),)
        )
        yield Grid(("factor", "value", "meaning"), factors, "Factors of the condition")
    limbs = tuple((one.name, of_limbs.small(one.margin)) for one in r.limbs)
    yield Grid(("limb", "margin to its own singularities, 0 singular"), limbs, "Limbs by themselves")
    yield Sentences(tuple(of_limbs.motions(r)), "Motion")
    if r.types:
        types = tuple((t.symbol, in_words(t)) for t in r.types)
        yield Facts(types, "Types of singularity (Zlatanov, Fenton and Benhabib)")


def _transmission(r: PoseReport | RobotPose) -> Iterator[Block]:
    """What is passed on from actuators to the platform; nothing where a limb has loops of its own."""
    a = r.jacobian.amplification
    if rows := tuple(transmission_rows(a)):
        yield Grid(("transmission", "from the actuator to its wrench", "from that to the platform"), rows)
    if a.transmission is not None and a.transmission.clearance_shift:
        yield Sentences((f"{clearances(a.transmission, _unit(r))}.",))


def _unit(r: PoseReport | RobotPose) -> str:
    """The unit of lengths, "" where there is none."""
    return r.rig.unit if isinstance(r, PoseReport) else r.unit


_BLOCKS: Mapping[type, Callable[[Any, SixLegs | Limbs], Iterator[Block]]] = {PoseReport: _of_legs, RobotPose: _of_limbs}
