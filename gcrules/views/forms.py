"""How every kind of result is shown: one row for each, looked up by its class or the nearest base class.

`text` is called with `unicode` and what else it offers, the others with the value and their options. `formula` is what
notebooks show as mathematics, `latex` unless another is named. A result without formula shows its text there.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from html import escape
from typing import Any

from gcrules.core.deferred import resolved

__all__ = ["FORMS", "Forms", "shown"]

_VIEWS = "gcrules.views"
_RESULTS = "gcrules.views.results"


@dataclass(frozen=True)
class Forms:
    """Where the forms of a kind of result are written: "package.module:function"; None for a form it does not have.

    `unicode` says whether `str` gives the signs of mathematics; ASCII text parses back. `formula` is "" where LaTeX is
    no formula.
    """

    text: str
    latex: str | None = None
    formula: str | None = None
    html: str | None = None
    unicode: bool = True
    others: dict[str, str] = field(default_factory=dict)


FORMS: dict[str, Forms] = {
    # the algebra: text is the language, so that it parses back
    "gcrules.algebra.expr.Expr": Forms(
        text="gcrules.algebra.language.text:text", latex=f"{_VIEWS}.formulas.latex:latex", unicode=False
    ),
    "gcrules.algebra.bracket.BracketPolynomial": Forms(
        text=f"{_RESULTS}.polynomial:text", latex=f"{_RESULTS}.polynomial:latex", unicode=False
    ),
    "gcrules.algebra.bracket.ExtensorPolynomial": Forms(
        text=f"{_RESULTS}.polynomial:text", latex=f"{_RESULTS}.polynomial:latex", unicode=False
    ),
    "gcrules.algebra.superbrackets.shortest.SuperbracketForm": Forms(
        text=f"{_RESULTS}.polynomial:form_text", latex=f"{_RESULTS}.polynomial:form_latex", unicode=False
    ),
    "gcrules.algebra.prove.Proof": Forms(text=f"{_RESULTS}.proof:text", latex=f"{_RESULTS}.proof:latex", unicode=False),
    "gcrules.algebra.factoring.result.Factorization": Forms(
        text=f"{_RESULTS}.factorization:text", latex=f"{_RESULTS}.factorization:latex", unicode=False
    ),
    "gcrules.algebra.shortening.result.Shortening": Forms(
        text=f"{_RESULTS}.shortening:text", latex=f"{_RESULTS}.shortening:latex", unicode=False
    ),
    # rules
    "gcrules.rules.condition.Condition": Forms(
        text=f"{_RESULTS}.condition:text", latex=f"{_RESULTS}.condition:latex", unicode=False
    ),
    "gcrules.rules.derivation.Derivation": Forms(
        text=f"{_RESULTS}.derivation:as_text", latex=f"{_RESULTS}.derivation:as_aligned"
    ),
    "gcrules.rules.rewriting.Rewriting": Forms(
        text=f"{_RESULTS}.rewriting:text", latex=f"{_RESULTS}.rewriting:latex", unicode=False
    ),
    "gcrules.rules.script.ClaimResult": Forms(
        text=f"{_RESULTS}.script:claim", latex=f"{_RESULTS}.script:formula", unicode=False
    ),
    "gcrules.rules.script.ShowResult": Forms(
        text=f"{_RESULTS}.script:shown", latex=f"{_RESULTS}.script:formula", unicode=False
    ),
    "gcrules.rules.script.RuleResult": Forms(
        text=f"{_RESULTS}.script:rule", latex=f"{_RESULTS}.script:formula", unicode=False
    ),
    "gcrules.rules.script.RewriteResult": Forms(
        text=f"{_RESULTS}.script:rewritten", latex=f"{_RESULTS}.script:formula", unicode=False
    ),
    "gcrules.rules.script.ScriptResult": Forms(
        text=f"{_RESULTS}.script:text", latex=f"{_RESULTS}.script:latex", unicode=False
    ),
    # conditions
    "gcrules.conditions.transversals.Transversals": Forms(
        text=f"{_RESULTS}.transversals:text", latex=f"{_RESULTS}.transversals:latex"
    ),
    "gcrules.conditions.analysis.Analysis": Forms(
        text=f"{_RESULTS}.analysis:as_text",
        latex=f"{_VIEWS}.formulas.latex_document:as_latex",
        formula=f"{_RESULTS}.analysis:formula",
        html=f"{_VIEWS}.report.report:fragment",
    ),
    "gcrules.conditions.manual.session.Session": Forms(
        text=f"{_RESULTS}.manual:board", latex=f"{_RESULTS}.manual:latex", unicode=False
    ),
    "gcrules.conditions.manual.outcome.Outcome": Forms(text=f"{_RESULTS}.manual:outcome", unicode=False),
    # mechanisms
    "gcrules.mechanisms.conditions.robot_analysis.RobotAnalysis": Forms(
        text=f"{_RESULTS}.robot:as_text", latex=f"{_RESULTS}.robot:as_latex", formula=f"{_RESULTS}.robot:formula"
    ),
    # poses: their LaTeX is a table
    "gcrules.poses.numbers.report.PoseReport": Forms(
        text=f"{_RESULTS}.pose:as_text", latex=f"{_RESULTS}.pose:as_latex", formula=""
    ),
    "gcrules.poses.numbers.many.PoseNumbers": Forms(
        text=f"{_RESULTS}.pose_numbers:text", latex=f"{_RESULTS}.pose_numbers:latex", formula=""
    ),
    "gcrules.poses.limbs.report.RobotPose": Forms(
        text=f"{_RESULTS}.robot_pose:as_text", latex=f"{_RESULTS}.robot_pose:as_latex", formula=""
    ),
    "gcrules.poses.paths.report.PathReport": Forms(
        text=f"{_RESULTS}.path:as_text",
        latex=f"{_RESULTS}.path:as_latex",
        formula="",
        others={"svg": f"{_VIEWS}.plots.path_plot:svg", "plot": f"{_VIEWS}.plots.path_plot:plot"},
    ),
    "gcrules.poses.maps.report.SingularMap": Forms(
        text=f"{_RESULTS}.map:as_text",
        latex=f"{_RESULTS}.map:as_latex",
        formula="",
        others={
            "svg": f"{_RESULTS}.map:picture_of",
            "save": f"{_VIEWS}.plots.map_files:save",
            "xarray": f"{_VIEWS}.plots.map_data:dataset",
        },
    ),
    "gcrules.poses.loci.report.Locus": Forms(text=f"{_RESULTS}.locus:as_text", latex=f"{_RESULTS}.locus:as_latex"),
}


@cache
def _forms(kind: type[object]) -> Forms:
    names = (f"{base.__module__}.{base.__qualname__}" for base in kind.__mro__)
    return next(FORMS[name] for name in names if name in FORMS)


def shown(value: Any, form: str, **options: Any) -> Any:
    """A form of a result: text, str, latex, formula, html, or one of its own; None for one that it does not have."""
    kind: Any = type(value)
    forms: Forms = _forms(kind)
    match form:
        case "text":
            return resolved(forms.text)(value, **options)
        case "str":
            return resolved(forms.text)(value, unicode=forms.unicode)
        case "formula":
            where = forms.latex if forms.formula is None else forms.formula
        case "html" if forms.html is None and forms.formula == "":
            return f"<pre>{escape(resolved(forms.text)(value, unicode=True))}</pre>"
        case "html":
            where = forms.html
        case "latex":
            where = forms.latex
        case _:
            where = forms.others.get(form)
    return resolved(where)(value, **options) if where else None
