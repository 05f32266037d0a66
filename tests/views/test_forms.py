"""Every kind of result has all its forms, each by one row of the table."""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra.language.statements import parse_script
from gcrules.conditions.manual import ManualSession
from gcrules.conditions.transversals import transversals
from gcrules.core.deferred import resolved
from gcrules.core.shown import Shown
from gcrules.rules.script import run_script
from gcrules.views.forms import FORMS

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
SCRIPT = "rank 3\nclaim [abc] == [bca]\nshow ab /\\ cd\nrewrite ab /\\ cd\nrule r: ab /\\ cd => [acd] b - [bcd] a\n"


def classes(kind: type) -> list[type]:
    subclasses: list[type] = kind.__subclasses__()
    return [kind, *(c for below in subclasses for c in classes(below))]


SHOWN = [c for c in classes(Shown) if c.__module__.startswith("gcrules.")]


@pytest.mark.parametrize("name", FORMS)
def test_rows_name_what_exists(name: str) -> None:
    module, _, kind = name.rpartition(".")
    assert issubclass(resolved(f"{module}:{kind}"), Shown)
    forms = FORMS[name]
    assert "unicode" in inspect.signature(resolved(forms.text)).parameters
    for where in (forms.latex, forms.formula, forms.html, *forms.others.values()):
        assert not where or callable(resolved(where))


@pytest.mark.parametrize("kind", SHOWN, ids=lambda kind: kind.__qualname__)
def test_every_kind_has_a_row(kind: type) -> None:
    names = {f"{c.__module__}.{c.__qualname__}" for c in kind.__mro__}
    subclasses = {f"{c.__module__}.{c.__qualname__}" for c in classes(kind)}
    assert kind is Shown or (names | subclasses) & set(FORMS)
    assert kind is Shown or kind.__name__.startswith("_") or callable(kind.to_json)  # type: ignore[attr-defined]


RESULTS: dict[str, Callable[[], Any]] = {
    "Expr": lambda: gc.parse(r"ab /\ cde"),
    "BracketPolynomial": lambda: gc.expand(r"ab /\ cd"),
    "ExtensorPolynomial": lambda: gc.expand(r"ab /\ cde"),
    "SuperbracketForm": lambda: gc.superbracket("ab af cb cd ed ef"),
    "Proof": lambda: gc.prove("[abcd] == [abdc]"),
    "Discoveries": lambda: gc.discover("rank 3 let x = ab /\\ cd"),
    "Factorization": lambda: gc.factor("[abcd][abce]"),
    "Shortening": lambda: gc.shorten("[abcd][efgh]"),
    "Condition": lambda: gc.analyze("ab af cb cd ed ef").condition,
    "Derivation": lambda: gc.analyze("ab af cb cd ed ef").derivation,
    "Rewriting": lambda: gc.rewrite(r"ab /\ cde", ["expansion"]),
    "ScriptResult": lambda: run_script(parse_script(SCRIPT)),
    "Transversals": lambda: transversals("Aa Ab Bc Bd Ce Df"),
    "Analysis": lambda: gc.analyze("ab af cb cd ed ef"),
    "ManualSession": lambda: ManualSession.start("ab af cb cd ed ef").plane("abc"),
    "RobotAnalysis": lambda: gc.analyze("3-rps"),
    "PoseReport": lambda: gc.pose(OCTAHEDRAL, nearest=False),
    "PoseNumbers": lambda: gc.pose(OCTAHEDRAL, [(0, 0, 0), (0, 0, 10)]),
    "PathReport": lambda: gc.path(OCTAHEDRAL, [(0, 0, 0), (0, 0, -400)]),
    "RobotPath": lambda: gc.path("3-rpr", ["home", "x=0, y=0, yaw=60deg"], samples=2),
    "SingularMap": lambda: gc.singular_map(OCTAHEDRAL, ["x -1:1:3", "y -1:1:3"]),
    "AssemblyModes": lambda: gc.assembly_modes(OCTAHEDRAL),
    "Locus": lambda: gc.locus(OCTAHEDRAL, "x, y"),
    "RobotLocus": lambda: gc.locus("3-rpr", "x, y"),
}


@pytest.mark.parametrize("kind", RESULTS)
def test_a_result_has_all_forms(kind: str) -> None:
    result = RESULTS[kind]()
    plain = result.text()
    assert plain
    assert plain.isascii()
    assert result.text(unicode=True)
    assert str(result) in (plain, result.text(unicode=True))
    assert result.latex()
    json.dumps(result.to_json(), allow_nan=False)
    shown = [form for form in (result._repr_latex_(), result._repr_html_(), result._repr_svg_()) if form is not None]
    assert shown
    assert all(shown)
    assert result._show("no such form") is None
