"""Assembly, working and operation modes as sections of a report."""

from __future__ import annotations

from html import escape

from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import has_six_legs
from gcrules.poses.modes.report import AssemblyMode, AssemblyModes
from gcrules.poses.modes.working import WorkingModes
from gcrules.poses.operation_modes.report import OperationModes
from gcrules.poses.questions import Unanswered
from gcrules.views.forms import shown
from gcrules.views.report.account_html import account_section, blocks_html, figure_card, latex_html, section_html
from gcrules.views.report.leads import lead_html, pose_step
from gcrules.views.results.modes import mode_picture
from gcrules.views.results.result_account import ResultAccount

__all__ = ["assembly_modes_html", "operation_modes_html", "unanswered_html", "working_modes_html"]


def assembly_modes_html(r: AssemblyModes, m: SixLegs | Limbs, *, live: bool) -> str:
    """How many there are and whether they are all, a picture of the robot in each, and their table."""
    told: ResultAccount = shown(r, "account")
    led = live and has_six_legs(m)
    cards = [_card(r, one, one.number - 1 if led else None) for one in r.modes]
    pictures = f'<div class="cards">{"".join(cards)}</div>' if cards else ""
    steps = [pose_step(one.pose, f"mode {one.number}, σ = {one.margin:.4g}") for one in r.modes]
    view = lead_html(steps, r.centre, along=False) if led else ""
    return section_html("Assembly modes", told.verdict, pictures, view, blocks_html(told.blocks), latex_html(r))


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
