"""The section of a report for each kind of answer (`gcrules.poses.questions`)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from gcrules.conditions.analysis import Analysis
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.aspects.report import Aspects
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.certificates.certificate import Certificate
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.loci.limb_report import RobotLocus
from gcrules.poses.loci.report import Locus
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.modes.report import AssemblyModes
from gcrules.poses.modes.working import WorkingModes
from gcrules.poses.operation_modes.report import OperationModes
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.report import Plan
from gcrules.poses.questions import Unanswered
from gcrules.poses.regions.report import FreeRegion
from gcrules.views.report.certificate_section import certificate_html
from gcrules.views.report.locus_section import locus_html
from gcrules.views.report.mode_sections import (
    assembly_modes_html,
    operation_modes_html,
    unanswered_html,
    working_modes_html,
)
from gcrules.views.report.motion_sections import boxes_html, map_html, path_html
from gcrules.views.report.standing import Titled
from gcrules.views.report.way_sections import aspects_html, free_region_html, plan_html

__all__ = ["answers_html"]

_SECTIONS: Mapping[type, Callable[..., str]] = {
    PathReport: path_html,
    RobotPath: path_html,
    SingularMap: map_html,
    BoxMap: boxes_html,
    Certificate: certificate_html,
    AssemblyModes: assembly_modes_html,
    WorkingModes: working_modes_html,
    OperationModes: operation_modes_html,
    Unanswered: unanswered_html,
    Aspects: aspects_html,
    Plan: plan_html,
    FreeRegion: free_region_html,
    Locus: locus_html,
    RobotLocus: locus_html,
}
"""They are called with the answer, the mechanism, and whether the page is `live`, with a scene in 3D; those that can be
`Titled` with a `title` too.
"""


def answers_html(
    a: Analysis | RobotAnalysis,
    answers: Iterable[Any],
    about: Any,
    *,
    live: bool,
    own: SixLegs | Limbs | None = None,
) -> list[str]:
    """A section for each answer, all with poses `about` the same centre; `own` is the mechanism that was asked, where
    that is not the analysis's own.
    """
    m = mechanism(a, about=about) if own is None else own
    return [_section(one, m, live=live) for one in answers]


def _section(one: Any, m: Any, *, live: bool) -> str:
    if not isinstance(one, Titled):
        return _SECTIONS[type(one)](one, m, live=live)
    own = {"title": one.title} if one.title else {}
    return _SECTIONS[type(one.answer)](one.answer, m, live=live, **own)
