"""The exact numbers of six lines in a pose as a section of a report."""

from __future__ import annotations

from html import escape

from gcrules.conditions.pose_value import PoseValue
from gcrules.views.numerals import figure
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.report.stages import verdict_of

__all__ = ["value_html"]

_DIGITS = 6  # as in the steps


def value_html(pose: PoseValue) -> str:
    """The exact numbers of six lines in a pose, in a short table."""
    unit = f" {pose.unit}⁹" if pose.unit else ""
    rows = [
        (
            "Superbracket",
            f"{figure(pose.superbracket, _DIGITS)}{unit}",
            "the determinant of the six lines; 0 means singular",
        )
    ]
    if pose.cofactor != 1:
        rows.append(("Cofactor", figure(pose.cofactor, _DIGITS), "where it is 0 the condition says nothing"))
        rows.append(("Condition", figure(pose.condition, _DIGITS), "cofactor times superbracket"))
    meaning = "dimensionless, 0 (singular) to 1, the same in every frame and unit"
    rows.append(("Margin", figure(pose.margin), meaning))
    body = "".join(f"<tr><th>{n}</th><td>{v}</td><td>{escape(w)}</td></tr>" for n, v, w in rows)
    head = f'<h2>{TITLES["pose"]}</h2><p class="verdict">{verdict_of(pose)}</p>'
    return f'<section class="numbers {pose.verdict}">{head}<table>{body}</table></section>'
