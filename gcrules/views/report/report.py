r"""The report: one self-contained HTML page with every stage, formulas as MathML, the robot in 3D and as SVG."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import Coordinates, PoseValue
from gcrules.core.deferred import deferred
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.rules.derivation import Step
from gcrules.views.drawing.figures import graph_figure, robot_figure
from gcrules.views.formulas.terms import formula_html
from gcrules.views.report.items import Formula, Item, KeyValue
from gcrules.views.report.parts import answer_html
from gcrules.views.report.report_page import footer, page, robot_figure_html
from gcrules.views.report.robot_report import moves, robot_report
from gcrules.views.report.scene_json import drawable, scene
from gcrules.views.report.stages import Stage, leading_sentences, stages, verdict_of
from gcrules.views.results.derivation import reasons

__all__ = ["fragment", "report"]

answers_html = deferred("gcrules.views.report.answer_sections:answers_html")  # numpy, for numbers only


def report(
    analysis: Analysis | RobotAnalysis,
    *,
    interactive: bool = True,
    answers: Sequence[Any] = (),
    about: Any = "centroid",
) -> str:
    """The HTML page of an analysis; of a platform with coordinates also the robot in its pose and the numbers there, of
    a robot with limbs these too; a section for each answer of `gcrules.poses.questions` for the same robot, with poses
    `about` the same centre.

    `interactive` adds the 3D viewer (about 700 kB), in which the platform can be moved.
    """
    live = interactive and (moves(analysis) if isinstance(analysis, RobotAnalysis) else drawable(analysis))
    more = answers_html(analysis, answers, about, live=live) if answers else []
    if isinstance(analysis, RobotAnalysis):
        return robot_report(analysis, live=live, more=more)
    platform = analysis.platform
    title = (platform.title if platform else "") or f"Legs {analysis.structure.text()}"
    sections = [
        _header(title, analysis, platform),
        f'<section class="answer">{_answer(analysis)}{_sure(analysis)}</section>',
        _figures(analysis, live=live),
        *([_numbers(analysis.pose)] if analysis.pose else []),
        *more,
        "<h2>Step by step</h2>",
        '<ol class="stages">',
        *(_stage(s) for s in stages(analysis) if s.id != "pose"),
        "</ol>",
        _derivation(analysis),
        footer(),
    ]
    return page(title, sections, scene(analysis) if live else None)


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


def _figures(a: Analysis, *, live: bool) -> str:
    if not a.structure.joined:
        return ""
    graph = f"<figure>{graph_figure(a, key=False).svg()}<figcaption>The legs as a graph</figcaption></figure>"
    if not drawable(a):  # no sample shape has such points
        return f'<div class="figures">{graph}</div>'
    caption = "The robot in the pose of the file" if a.platform else "A sample shape (no coordinates were given)"
    caption += ", with the entities of the condition"
    hint = "Drag to turn the view, shift and turn the platform."
    robot = robot_figure_html(robot_figure(a).svg(), caption, live=live, hint=hint)
    return f'<div class="figures">{robot}{graph}</div>'


def _numbers(pose: PoseValue) -> str:
    unit = f" {pose.unit}⁹" if pose.unit else ""
    rows = [
        ("Superbracket", f"{float(pose.superbracket):.6g}{unit}", "the determinant of the six lines; 0 means singular")
    ]
    if pose.cofactor != 1:
        rows.append(("Cofactor", f"{float(pose.cofactor):.6g}", "where it is 0 the condition says nothing"))
        rows.append(("Condition", f"{float(pose.condition):.6g}", "cofactor times superbracket"))
    meaning = "dimensionless, 0 (singular) to 1, the same in every frame and unit"
    rows.append(("Margin", f"{pose.margin:.4g}", meaning))
    body = "".join(f"<tr><th>{n}</th><td>{v}</td><td>{escape(w)}</td></tr>" for n, v, w in rows)
    head = f'<h2>In this pose</h2><p class="verdict">{verdict_of(pose)}</p>'
    return f'<section class="numbers {pose.verdict}">{head}<table>{body}</table></section>'


def _stage(stage: Stage) -> str:
    why = f'<p class="why">{escape(stage.why)}</p>' if stage.why else ""
    return f"<li><h3>{escape(stage.title)}</h3>{why}{''.join(map(_item, stage.items))}</li>"


def _item(item: Item) -> str:
    if isinstance(item, Formula):
        return formula_html(item)
    if isinstance(item, KeyValue):
        return f'<p><span class="key">{escape(item.key)}</span> {escape(item.value)}</p>'
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
