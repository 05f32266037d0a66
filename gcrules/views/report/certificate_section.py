"""A certificate as a section of a report: the question, the answer, a picture, and how it is checked again."""

from __future__ import annotations

from typing import Any

from gcrules.core.english import listed
from gcrules.core.files import file_name
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.certificates.certificate import Certificate
from gcrules.poses.methods import has_six_legs
from gcrules.screws.pose_text import pose_of
from gcrules.views.forms import shown
from gcrules.views.report.account_html import (
    NO_PICTURE,
    blocks_html,
    figure_card,
    inline_svg,
    latex_html,
    map_figure,
    section_html,
    words_html,
)
from gcrules.views.report.carried_files import carried_html
from gcrules.views.report.leads import lead_html, pose_step
from gcrules.views.results.certificate import captioned, check, seen
from gcrules.views.results.result_account import ResultAccount
from gcrules.views.robots.pose_picture import waypoint_picture

__all__ = ["certificate_html"]


def certificate_html(c: Certificate, m: SixLegs | Limbs, *, live: bool) -> str:
    """The sentence, the boxes or slices through them, the singular pose, what was asked and is proved; the file itself,
    with how it is checked again.
    """
    told: ResultAccount = shown(c, "account")
    return section_html(
        f"A certificate over {listed([a.name for a in c.axes])}",
        told.verdict,
        _picture(c),
        _bad_pose(c, m, live=live),
        blocks_html(told.blocks),
        _checking(c),
        latex_html(c),
        kind={True: "", False: "singular", None: "undecided"}[c.holds],
    )


def _picture(c: Certificate) -> str:
    drawn = shown(c, "svg")
    return NO_PICTURE if drawn is None else map_figure(inline_svg(drawn, seen(c)), captioned(c))


def _bad_pose(c: Certificate, m: SixLegs | Limbs, *, live: bool) -> str:
    """The robot where it is singular, or its margin is too small; of a platform in 3D too."""
    if c.bad is None:
        return ""
    at = c.coordinates(c.bad.place)
    goal: Any = pose_of(at) if has_six_legs(m) else at
    where = f"σ = {c.bad.margin:.3g}"
    view = lead_html([pose_step(goal, where)], m.six_legs().rig.centre, along=False) if live and has_six_legs(m) else ""
    drawn = waypoint_picture(m, goal, c.bad.margin, f"{c.task.mechanism.title} at {c.bad.at}")
    if drawn is None:
        return view
    name = "Singular pose" if c.bad.ends else "Pose below the margin"
    card = figure_card(drawn.svg(), name, c.bad.at, where, *c.bad.causes, step=0 if view else None)
    return f'<div class="cards">{card}</div>{view}'


def _checking(c: Certificate) -> str:
    """How it is checked again, and the file, which the page carries."""
    words = f"<p>{words_html(check(c))}</p>"
    name, data = file_name(c.task.mechanism.title, "json.gz"), c.to_bytes(packed=True)
    file = f"<p>{carried_html(name, 'application/gzip', data, 'gcrules certify … -o FILE')}</p>"
    more = "" if c.verdict != "undecided" else f"<p>{_MORE}</p>"
    return f"<h3>Checking it again</h3>{words}{file}{more}"


_MORE = (
    "More boxes decide more: <code>gcrules certify … --resume FILE --time S -o FILE</code> goes on from the file, and "
    "<code>--resume FILE</code> shows it in a report."
)
