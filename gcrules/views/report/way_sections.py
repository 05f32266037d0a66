"""Aspects, a plan and a free region as sections of a report: where the robot can go without a singularity."""

from __future__ import annotations

from gcrules.core.english import listed
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.aspects.report import Aspects, AspectSet
from gcrules.poses.plans.report import Plan
from gcrules.poses.regions.report import FreeRegion
from gcrules.views.forms import shown
from gcrules.views.report.account_html import account_section, blocks_html, figure_card, latex_html, section_html
from gcrules.views.report.carried_files import checking_html
from gcrules.views.report.leads import path_lead
from gcrules.views.results.plan import waypoint_margins, waypoint_text
from gcrules.views.results.result_account import ResultAccount
from gcrules.views.robots.pose_picture import waypoint_picture

__all__ = ["aspects_html", "free_region_html", "plan_html"]

_DRAWN = 24  # poses of one section


def aspects_html(r: Aspects, m: SixLegs | Limbs, *, live: bool) -> str:
    """In how many aspects the poses lie, a picture of a pose of each set, the table of the sets, and how sure it is."""
    cards = "".join(_set_card(r, one, m) for one in r.sets[:_DRAWN])
    words = "All poses over two of their coordinates, with the proved ways between them."
    drawn = shown(r, "svg")
    plot = f'<figure class="plot">{drawn}<figcaption>{words}</figcaption></figure>' if drawn else ""
    return account_section(r, "Aspects", plot, f'<div class="cards">{cards}</div>' if cards else "")


def _set_card(r: Aspects, one: AspectSet, m: SixLegs | Limbs) -> str:
    """A set with its widest pose; nothing where this cannot be drawn."""
    title = f"{r.title} in a pose of {one.name}: {waypoint_text(one.witness)}"
    drawn = waypoint_picture(m, one.witness, one.margin, title)
    if drawn is None:
        return ""
    signs = f"signs {one.pattern.replace('-', '−')}" if one.pattern else ""
    modes = f"{'modes' if len(one.modes) > 1 else 'mode'} {listed(list(map(str, one.modes)))}" if one.modes else ""
    return figure_card(drawn.svg(), f"Set {one.name}", signs, modes, f"σ = {one.margin:.4g}")


def plan_html(r: Plan, m: SixLegs | Limbs, *, live: bool) -> str:
    """The answer; of a way the robot at its poses, the margin along it, and a 3D view that goes along it."""
    told: ResultAccount = shown(r, "account")
    cards = "".join(_pose_cards(r, m))
    pictures = f'<div class="cards">{cards}</div>' if cards else ""
    plot = view = ""
    if r.path is not None:
        words = "The margin along the way; whole numbers mark its poses."
        plot = f'<figure class="plot">{shown(r, "svg")}<figcaption>{words}</figcaption></figure>'
        view = path_lead(r.path, m) if live else ""
    title = "A way out" if r.end_margin is not None or r.goal is None else "A way from pose to pose"
    return section_html(
        title, told.verdict, pictures, plot, view, blocks_html(told.blocks), checking_html(r, r.title), latex_html(r)
    )


def _pose_cards(r: Plan, m: SixLegs | Limbs) -> list[str]:
    """The robot at the poses of the way that can be drawn."""
    found: list[str] = []
    for k, (pose, margin) in enumerate(zip(r.poses[:_DRAWN], waypoint_margins(r), strict=False)):
        drawn = waypoint_picture(m, pose, margin, f"{r.title} at {waypoint_text(pose)}")
        if drawn is not None:
            name = "Start" if k == 0 else "Goal" if k == len(r.poses) - 1 else f"Pose {k}"
            found.append(figure_card(drawn.svg(), name, waypoint_text(pose), f"σ = {margin:.4g}"))
    return found


def free_region_html(r: FreeRegion, m: SixLegs | Limbs, *, live: bool) -> str:
    """The sentence that says what is proved, the ranges of the coordinates, and where the proof ended."""
    words = "The range of each coordinate, and the pose at which the proof ended."
    picture = f'<figure class="plot">{shown(r, "svg")}<figcaption>{words}</figcaption></figure>'
    return account_section(r, f"A {r.shape} free of singular poses", picture, last=checking_html(r, r.title))
