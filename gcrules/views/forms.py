"""How every kind of result is shown: one row for each, looked up by its class or the nearest base class.

`text` is called with `unicode` and what else it offers, the others with the value and their options. `formula` is what
notebooks show as mathematics, `latex` unless another is named. A result without formula shows its text there.
"""

from __future__ import annotations

from dataclasses import field
from functools import cache
from html import escape
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import resolved

__all__ = ["FORMS", "Forms", "shown"]

_VIEWS = "gcrules.views"
_RESULTS = "gcrules.views.results"


@dataclass(frozen=True)
class Forms:
    """Where the forms of a kind of result are written: "package.module:function"; `latex` every kind of result has.

    `unicode` says whether `str` gives the signs of mathematics; ASCII text parses back. `formula` is "" where LaTeX is
    no formula.
    """

    text: str
    latex: str
    formula: str | None = None
    html: str | None = None
    unicode: bool = True
    others: dict[str, str] = field(default_factory=dict)


def _result(module: str, *, text: str = "as_text", latex: str = "as_latex", **more: Any) -> Forms:
    """The forms that a module of `views.results` writes."""
    return Forms(text=f"{_RESULTS}.{module}:{text}", latex=f"{_RESULTS}.{module}:{latex}", **more)


def _in_ascii(module: str, **names: str) -> Forms:
    """The same for results whose text is the language, so that it parses back."""
    return _result(module, unicode=False, **names)


def _told(module: str, **others: str) -> Forms:
    """The same for results whose LaTeX is a table, with the pieces of their text, `account`."""
    return _result(module, formula="", others={"account": f"{_RESULTS}.{module}:account", **others})


FORMS: dict[str, Forms] = {
    "gcrules.algebra.expr.Expr": Forms(
        text="gcrules.algebra.language.text:text", latex=f"{_VIEWS}.formulas.latex:latex", unicode=False
    ),
    "gcrules.algebra.bracket.BracketPolynomial": _in_ascii("polynomial"),
    "gcrules.algebra.bracket.ExtensorPolynomial": _in_ascii("polynomial"),
    "gcrules.algebra.superbrackets.shortest.SuperbracketForm": _in_ascii(
        "polynomial", text="form_text", latex="form_latex"
    ),
    "gcrules.algebra.prove.Proof": _in_ascii("proof"),
    "gcrules.algebra.discovery.result.Discoveries": _result("discoveries", unicode=False),
    "gcrules.algebra.factoring.result.Factorization": _in_ascii("factorization"),
    "gcrules.algebra.factoring.forms.Factors": _in_ascii("factors"),
    "gcrules.algebra.shortening.result.Shortening": _in_ascii("shortening"),
    "gcrules.algebra.proofs.proof_file.ProofFile": _result(
        "proof_file",
        unicode=False,
        others={"coq": f"{_VIEWS}.proofs.coq:script", "lean": f"{_VIEWS}.proofs.lean:script"},
    ),
    # rules
    "gcrules.rules.condition.Condition": _in_ascii("condition"),
    "gcrules.rules.derivation.Derivation": _result("derivation", latex="as_aligned"),
    "gcrules.rules.rewriting.Rewriting": _in_ascii("rewriting"),
    "gcrules.rules.script.ClaimResult": _in_ascii("script", text="claim", latex="formula"),
    "gcrules.rules.script.ShowResult": _in_ascii("script", text="shown", latex="formula"),
    "gcrules.rules.script.RuleResult": _in_ascii("script", text="rule", latex="formula"),
    "gcrules.rules.script.RewriteResult": _in_ascii("script", text="rewritten", latex="formula"),
    "gcrules.rules.script.ScriptResult": _in_ascii("script"),
    # conditions
    "gcrules.conditions.transversals.Transversals": _result("transversals"),
    "gcrules.conditions.analysis.Analysis": Forms(
        text=f"{_RESULTS}.analysis:as_text",
        latex=f"{_VIEWS}.paper.paper:as_latex",
        formula=f"{_RESULTS}.analysis:formula",
        html=f"{_VIEWS}.report.report:fragment",
    ),
    "gcrules.conditions.manual.session.ManualSession": _in_ascii("manual"),
    "gcrules.conditions.manual.outcome.ProposalOutcome": _in_ascii("manual", text="outcome", latex="outcome_latex"),
    # mechanisms
    "gcrules.mechanisms.conditions.robot_analysis.RobotAnalysis": Forms(
        text=f"{_RESULTS}.robot:as_text", latex=f"{_VIEWS}.paper.paper:as_latex", formula=f"{_RESULTS}.robot:formula"
    ),
    "gcrules.mechanisms.models.imported.Imported": _told("imported"),
    # poses: their LaTeX is a table
    "gcrules.poses.numbers.report.PoseReport": _result("pose", formula=""),
    "gcrules.poses.numbers.many.PoseNumbers": _result("pose_numbers", formula=""),
    "gcrules.poses.limbs.report.RobotPose": _result("robot_pose", formula=""),
    "gcrules.poses.paths.report.PathReport": _result(
        "path",
        formula="",
        others={
            "svg": f"{_VIEWS}.plots.path_plot:svg",
            "plot": f"{_VIEWS}.plots.path_plot:plot",
            "account": f"{_RESULTS}.path:account",
        },
    ),
    "gcrules.poses.limbs.path_report.RobotPath": _result(
        "robot_path",
        formula="",
        others={
            "svg": f"{_VIEWS}.plots.path_plot:svg_of_robot",
            "plot": f"{_VIEWS}.plots.path_plot:plot_of_robot",
            "account": f"{_RESULTS}.robot_path:account",
        },
    ),
    "gcrules.poses.maps.report.SingularMap": _result(
        "map",
        formula="",
        others={
            "svg": f"{_RESULTS}.map:picture_of",
            "save": f"{_VIEWS}.plots.map_files:save",
            "xarray": f"{_VIEWS}.plots.map_data:dataset",
        },
    ),
    "gcrules.poses.boxes.report.BoxMap": _told(
        "box_map",
        svg=f"{_RESULTS}.box_map:picture_of",
        save=f"{_VIEWS}.plots.box_files:save",
        xarray=f"{_VIEWS}.plots.box_files:dataset",
    ),
    "gcrules.poses.certificates.certificate.Certificate": _told(
        "certificate", svg=f"{_RESULTS}.certificate:picture_of", picture=f"{_VIEWS}.plots.certificate_plot:picture"
    ),
    "gcrules.poses.tiles.status.MapStatus": _result("tiles", formula=""),
    "gcrules.poses.stored_maps.verifying.MapVerified": _result(
        "tiles", text="verified_text", latex="verified_latex", formula=""
    ),
    "gcrules.poses.modes.working.WorkingModes": _told("working_modes"),
    "gcrules.poses.modes.report.AssemblyModes": _told(
        "modes", svg=f"{_RESULTS}.modes:svg", picture=f"{_RESULTS}.modes:picture"
    ),
    "gcrules.poses.length_regions.report.LengthRegions": _result(
        "length_regions",
        formula="",
        others={
            "svg": f"{_VIEWS}.plots.length_regions_plot:svg",
            "picture": f"{_VIEWS}.plots.length_regions_plot:picture",
        },
    ),
    "gcrules.poses.operation_modes.report.OperationModes": _told("operation_modes"),
    "gcrules.poses.regions.report.FreeRegion": _told(
        "free_region", svg=f"{_VIEWS}.plots.free_plot:svg", picture=f"{_VIEWS}.plots.free_plot:picture"
    ),
    "gcrules.poses.aspects.report.Aspects": _told(
        "aspects", svg=f"{_VIEWS}.plots.aspects_plot:svg", picture=f"{_VIEWS}.plots.aspects_plot:picture"
    ),
    "gcrules.poses.plans.report.Plan": _told(
        "plan", svg=f"{_VIEWS}.plots.path_plot:svg_of_plan", plot=f"{_VIEWS}.plots.path_plot:plot_of_plan"
    ),
    "gcrules.poses.loci.report.Locus": _result("locus", others={"picture": f"{_VIEWS}.plots.locus_plot:picture"}),
    "gcrules.poses.loci.limb_report.RobotLocus": _result(
        "robot_locus", others={"picture": f"{_VIEWS}.plots.locus_plot:picture"}
    ),
}


@cache
def _forms(kind: type[object]) -> Forms:
    names = (f"{base.__module__}.{base.__qualname__}" for base in kind.__mro__)
    return next(FORMS[name] for name in names if name in FORMS)


def shown(value: Any, form: str, **options: Any) -> Any:
    """A form of a result: text, str, latex, formula, html, or one of its own; None for one that it does not have."""
    kind: Any = type(value)
    forms: Forms = _forms(kind)
    if form in ("text", "str"):
        return resolved(forms.text)(value, **({"unicode": forms.unicode} if form == "str" else options))
    if form == "html" and forms.html is None and forms.formula == "":
        return f"<pre>{escape(resolved(forms.text)(value, unicode=True))}</pre>"
    formula = forms.latex if forms.formula is None else forms.formula
    where = {"latex": forms.latex, "formula": formula, "html": forms.html, **forms.others}.get(form)
    return resolved(where)(value, **options) if where else None
