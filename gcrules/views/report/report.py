r"""The report: one self-contained HTML page with every stage, formulas as MathML, the robot in 3D and as SVG."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import Coordinates
from gcrules.core.deferred import deferred
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.rules.derivation import Step
from gcrules.views.drawing.figures import graph_figure, robot_figure
from gcrules.views.formulas.terms import formula_html
from gcrules.views.report.account_html import words_html
from gcrules.views.report.items import Formula, Item, KeyValue
from gcrules.views.report.parts import answer_html
from gcrules.views.report.proof_section import proof_html
from gcrules.views.report.report_page import footer, page, robot_figure_html
from gcrules.views.report.robot_report import moves, robot_report
from gcrules.views.report.scene_json import drawable, scene
from gcrules.views.report.stages import Stage, leading_sentences, stages
from gcrules.views.report.standing import Standing
from gcrules.views.report.standing_sections import (
    bench_html,
    notes_html,
    numbers_here_html,
    repeating_html,
    started,
    view_html,
)
from gcrules.views.report.value_section import value_html
from gcrules.views.results.derivation import reasons

__all__ = ["fragment", "report"]

answers_html = deferred("gcrules.views.report.answer_sections:answers_html")  # numpy, for numbers only


def report(
    analysis: Analysis | RobotAnalysis,
    *,
    interactive: bool = True,
    answers: Sequence[Any] = (),
    about: Any = "centroid",
    standing: Standing | None = None,
) -> str:
    """The HTML page of an analysis; of a platform with coordinates also the robot in its pose and the numbers there, of
    a robot with limbs these too; a section for each answer of `gcrules.poses.questions` for the same robot, with poses
    `about` the same centre.

    `interactive` adds the 3D viewer (about 700 kB), in which the platform can be moved. Where a robot is `standing`
    somewhere, the page shows it there, with numbers, notes, and what repeats it; answers may be `Titled`.
    """
    live = interactive and (moves(analysis) if isinstance(analysis, RobotAnalysis) else drawable(analysis))
    own = standing.mechanism if standing else None
    more = answers_html(analysis, answers, about, live=live, own=own) if answers else []
    if isinstance(analysis, RobotAnalysis):
        return robot_report(analysis, live=live, more=more, standing=standing)
    platform = analysis.platform
    title = (platform.title if platform else "") or f"Legs {analysis.structure.text()}"
    sections = [
        _header(title, analysis, platform),
        f'<section class="answer">{_answer(analysis)}{_sure(analysis)}</section>',
        view_html(standing, title),
        _figures(analysis, standing, live=live),
        numbers_here_html(standing) if standing else value_html(analysis.pose) if analysis.pose else "",
        notes_html(standing),
        *more,
        "<h2>Step by step</h2>",
        '<ol class="stages">',
        *(_stage(s) for s in stages(analysis) if s.id != "pose"),
        "</ol>",
        _derivation(analysis),
        proof_html(analysis),
        bench_html(standing),
        repeating_html(standing),
        footer(),
    ]
    return page(title, sections, started(scene(analysis) if live else None, standing))


def fragment(analysis: Analysis) -> str:
    """The condition, statement and graph as an HTML fragment, for notebooks."""
    graph = graph_figure(analysis).svg() if analysis.structure.joined else ""
    formula = formula_html(Formula(*_identity(analysis)))
    return f'<div class="gcrules">{_answer(analysis)}{formula}{graph}</div>'


def _identity(a: Analysis) -> tuple[Expr, Expr]:
    c = a.condition
    return ex.mul(c.cofactor, a.structure.superbracket), c.right_side


def _header(title: str, a: Analysis, platform: Coordinates | None) -> str:
    lines = []
    if a.match:
        lines.append(f"Class {a.match.entry.title}")
    lines.append(f"Legs {a.structure.text()}")
    note = f'<p class="note">{escape(platform.note)}</p>' if platform and platform.note else ""
    return f'<header><h1>{escape(title)}</h1><p class="sub">{escape(" · ".join(lines))}</p>{note}</header>'


def _answer(a: Analysis) -> str:
    return answer_html(leading_sentences(a))


def _sure(a: Analysis) -> str:
    return f'<p class="sure">{escape(a.condition.certificate.detail)}.</p>'


def _figures(a: Analysis, standing: Standing | None, *, live: bool) -> str:
    if not a.structure.joined:
        return ""
    graph = f"<figure>{graph_figure(a, key=False).svg()}<figcaption>The legs as a graph</figcaption></figure>"
    if not drawable(a):  # no sample shape has such points
        return f'<div class="figures">{graph}</div>'
    caption = "The robot in the pose of the file" if a.platform else "A sample shape (no coordinates were given)"
    if standing and standing.drawing:
        caption = "The robot as it stands" if a.platform else "A sample shape as it stands (no coordinates were given)"
    caption += ", with the entities of the condition"
    hint = "Drag to turn the view, shift and turn the platform."
    drawing = (standing and standing.drawing) or robot_figure(a).svg()
    robot = robot_figure_html(drawing, caption, live=live, hint=hint)
    return f'<div class="figures">{robot}{graph}</div>'


def _stage(stage: Stage) -> str:
    why = f'<p class="why">{escape(stage.why)}</p>' if stage.why else ""
    return f"<li><h3>{escape(stage.title)}</h3>{why}{''.join(map(_item, stage.items))}</li>"


def _item(item: Item) -> str:
    if isinstance(item, Formula):
        return formula_html(item)
    if isinstance(item, KeyValue):
        return f'<p><span class="key">{escape(item.key)}</span> {words_html(item.value)}</p>'
    return f"<p>{escape(item)}</p>"


def _derivation(a: Analysis) -> str:
    """The steps in one table, every single step in another that is folded away."""
    first = formula_html(Formula(None, a.derivation.before))
    table = f'<table class="derivation">{"".join(_step(s, s.rule, s.why) for s in a.derivation)}</table>'
    unfolded = a.unfolded()
    words = reasons(unfolded)
    rows = [
        row
        for step in unfolded
        for row in [
            *([f'<tr><th colspan="2">{escape(f"{step.rule}: {step.why}")}</th></tr>'] if step.steps else []),
            *(_step(s, s.rule, next(words)) for s in step.steps or (step,)),
        ]
    ]
    every = f'<table class="derivation">{"".join(rows)}</table>'
    return f"<h2>Derivation</h2>{first}{table}<details><summary>Every single step</summary>{first}{every}</details>"


def _step(step: Step, name: str, why: str) -> str:
    return f"<tr><th>{escape(name)}</th><td>{escape(why)}{formula_html(Formula(None, step.after))}</td></tr>"
