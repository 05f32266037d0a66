r"""The report: one self-contained HTML page with every stage, formulas as MathML, figures as SVG."""

from __future__ import annotations

from html import escape
from importlib.resources import files

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.analysis import Analysis
from gcrules.numeric.value import PoseValue
from gcrules.render.derivation import reasons
from gcrules.render.figures import graph_figure, robot_figure
from gcrules.render.mathml import mathml_terms
from gcrules.render.stages import VERDICTS, Fact, Formula, Item, Stage, stages
from gcrules.robots.geometry import Platform
from gcrules.rules.derivation import Step

__all__ = ["fragment", "report"]


def report(analysis: Analysis) -> str:
    """The HTML page of an analysis; of a platform with coordinates also the robot in its pose and the numbers there."""
    platform = analysis.platform
    title = (platform.title if platform else "") or f"Legs {analysis.structure.text()}"
    sections = [
        _header(title, analysis, platform),
        f'<section class="answer"><p>{escape(analysis.condition.statement)}</p>{_sure(analysis)}</section>',
        _figures(analysis),
        *([_numbers(analysis.pose)] if analysis.pose else []),
        "<h2>Step by step</h2>",
        '<ol class="stages">',
        *(_stage(s) for s in stages(analysis) if s.title != "In this pose"),
        "</ol>",
        _derivation(analysis),
        _footer(),
    ]
    head = f'<meta charset="utf-8"><title>{escape(title)} – gcrules</title>{_VIEWPORT}<style>{_css()}</style>'
    return f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head><body><main>{"".join(sections)}</main></body></html>\n'


def fragment(analysis: Analysis) -> str:
    """The condition, statement and graph as an HTML fragment, for notebooks."""
    graph = graph_figure(analysis).svg() if analysis.structure.joined else ""
    formula = _formula(Formula(*_identity(analysis)))
    return f'<div class="gcrules"><p>{escape(analysis.condition.statement)}</p>{formula}{graph}</div>'


def _identity(a: Analysis) -> tuple[Expr, Expr]:
    c = a.condition
    return ex.mul(c.cofactor, a.structure.superbracket), c.right_side


def _header(title: str, a: Analysis, platform: Platform | None) -> str:
    lines = []
    if a.match:
        name = f", {a.match.entry.name}" if a.match.entry.name else ""
        lines.append(f"Class {a.match.entry.id}{name}")
    lines.append(f"Legs {a.structure.text()}")
    note = f'<p class="note">{escape(platform.note)}</p>' if platform and platform.note else ""
    return f'<header><h1>{escape(title)}</h1><p class="sub">{escape(" · ".join(lines))}</p>{note}</header>'


def _sure(a: Analysis) -> str:
    return f'<p class="sure">{escape(a.condition.certificate.detail)}.</p>'


def _figures(a: Analysis) -> str:
    if not a.structure.joined:
        return ""
    graph = f"<figure>{graph_figure(a, key=False).svg()}<figcaption>The legs as a graph</figcaption></figure>"
    s = a.structure
    if s.special or s.stand_ins or s.rank != 4:  # no sample shape has such points
        return f'<div class="figures">{graph}</div>'
    robot = robot_figure(a).svg()
    caption = "The robot in the pose of the file" if a.platform else "A sample shape (no coordinates were given)"
    return (
        f'<div class="figures"><figure class="robot">{robot}<figcaption>{caption}, with the entities of the condition'
        f"</figcaption></figure>{graph}</div>"
    )


def _numbers(pose: PoseValue) -> str:
    unit = f" {pose.unit}⁹" if pose.unit else ""
    rows = [
        ("Superbracket", f"{float(pose.superbracket):.6g}{unit}", "the determinant of the six lines; 0 means singular")
    ]
    if pose.cofactor != 1:
        rows.append(("Cofactor", f"{float(pose.cofactor):.6g}", "where it is 0 the condition says nothing"))
        rows.append(("Condition", f"{float(pose.condition):.6g}", "cofactor times superbracket"))
    meaning = "dimensionless, 0 (singular) to 1, the same in every frame and unit"
    rows.append(("Closeness", f"{pose.measure:.4g}", meaning))
    body = "".join(f"<tr><th>{n}</th><td>{v}</td><td>{escape(w)}</td></tr>" for n, v, w in rows)
    head = f'<h2>In this pose</h2><p class="verdict">{VERDICTS[pose.verdict]}</p>'
    return f'<section class="numbers {pose.verdict}">{head}<table>{body}</table></section>'


def _stage(stage: Stage) -> str:
    why = f'<p class="why">{escape(stage.why)}</p>' if stage.why else ""
    return f"<li><h3>{escape(stage.title)}</h3>{why}{''.join(map(_item, stage.items))}</li>"


def _item(item: Item) -> str:
    if isinstance(item, Formula):
        return _formula(item)
    if isinstance(item, Fact):
        return f'<p><span class="key">{escape(item.key)}</span> {escape(item.value)}</p>'
    return f"<p>{escape(item)}</p>"


def _formula(item: Formula) -> str:
    left = [*mathml_terms(item.left), '<span class="gc-term"><math><mo>=</mo></math></span>'] if item.left else []
    return f'<p class="formula">{" ".join([*left, *mathml_terms(item.right)])}</p>'


def _derivation(a: Analysis) -> str:
    """The steps in one table, every single step in another that is folded away."""
    first = _formula(Formula(None, a.derivation.before))
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
    return f"<tr><th>{escape(name)}</th><td>{escape(why)}{_formula(Formula(None, step.after))}</td></tr>"


def _footer() -> str:
    from gcrules import __version__

    legend = "Brackets [abcd] are determinants of homogeneous points; ∨ is join, ∧ is meet."
    return f"<footer>gcrules {__version__}. {legend}</footer>"


def _css() -> str:
    return files("gcrules.render").joinpath("report.css").read_text(encoding="utf-8")


_VIEWPORT = '<meta name="viewport" content="width=device-width, initial-scale=1">'
