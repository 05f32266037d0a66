"""Assembly, working and operation modes as sections of a report."""

from __future__ import annotations

from dataclasses import replace
from html import escape

from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import has_six_legs
from gcrules.poses.modes.choose import robot_in_mode
from gcrules.poses.modes.report import AssemblyMode, AssemblyModes
from gcrules.poses.modes.working import WorkingModes
from gcrules.poses.operation_modes.report import OperationModes
from gcrules.poses.questions import Unanswered
from gcrules.views.forms import shown
from gcrules.views.report.account_html import account_section, blocks_html, figure_card, latex_html, section_html
from gcrules.views.report.leads import Step, lead_html, pose_step
from gcrules.views.report.robot_report import robot_scene
from gcrules.views.results.modes import mode_picture
from gcrules.views.results.result_account import ResultAccount

__all__ = ["assembly_modes_html", "operation_modes_html", "unanswered_html", "working_modes_html"]


def assembly_modes_html(r: AssemblyModes, m: SixLegs | Limbs, *, live: bool) -> str:
    """How many there are and whether they are all, a picture of the robot in each, and their table."""
    told: ResultAccount = shown(r, "account")
    steps = {one.number: step for one in r.modes[:_IN_SPACE] if live and (step := _step(one, m))}
    numbers = list(steps)
    cards = [_card(r, one, numbers.index(one.number) if one.number in steps else None) for one in r.modes]
    pictures = f'<div class="cards">{"".join(cards)}</div>' if cards else ""
    view = lead_html(list(steps.values()), r.centre, along=False)
    return section_html("Assembly modes", told.verdict, pictures, view, blocks_html(told.blocks), latex_html(r))


_IN_SPACE = 40
"""Modes that are shown in 3D; each scene of a robot of joints takes about 20 kB."""


def _step(one: AssemblyMode, m: SixLegs | Limbs) -> Step | None:
    """What shows a mode in 3D: the pose; of a robot of joints, whose actuators do not lead there, the robot with its
    home in the mode. None where it has no such home.
    """
    text = f"mode {one.number}, σ = {one.margin:.4g}"
    if has_six_legs(m):
        return pose_step(one.pose, text)
    assert isinstance(m, Limbs)
    try:
        robot = robot_in_mode(m, one, text)
    except InputError:
        return None
    return {"scene": robot_scene(replace(m.analysis, robot=robot)), "text": text}


def _card(r: AssemblyModes, m: AssemblyMode, step: int | None) -> str:
    signs = m.signs.replace("-", "−")
    numbers = f"{m.verdict}, σ = {m.margin:.4g}" + (f", signs {signs}" if signs else "")
    heading = f"Mode {m.number}" + " (given)" * m.given
    return figure_card(mode_picture(r, m).svg(), heading, numbers, m.certificate.method, step=step)


def working_modes_html(r: WorkingModes, m: SixLegs | Limbs, *, live: bool) -> str:
    """The ways of the limbs, and a table of the modes."""
    return account_section(r, "Working modes")


def operation_modes_html(r: OperationModes, m: SixLegs | Limbs, *, live: bool) -> str:
    """A table for each mode, where they meet, and how sure this is."""
    return account_section(r, "Operation modes")


def unanswered_html(r: Unanswered, m: SixLegs | Limbs, *, live: bool) -> str:
    """Why a question has no answer."""
    return f'<section class="motion"><h2>{escape(r.question)}</h2><p class="why">{escape(r.reason)}.</p></section>'
