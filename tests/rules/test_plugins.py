"""Plugins: packs that come with gcrules, folders of the user's, and packages installed by entry point."""

from __future__ import annotations

import json
import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import FileError, InputError
from gcrules.rules.check import check_rules
from gcrules.rules.plugin import plugins_in, shipped_folder
from gcrules.rules.plugins import load_rules

RULE = """
from gcrules.rules.plugins import ConditionRule, bracket, mul, points

RULES = (
    ConditionRule(
        id="mine",
        sentence="Three tetrahedra, in words of my own.",
        fires=("Aa Ab Ac Bd Be Cf",),
        silent=("ab af cb cd ed ef",),
        degree=0,
        expression=lambda s: mul(*(bracket(*points(s.named(row))) for row in s.tetrahedra)),
        statement="Mine: {tetrahedra} and {expression}.",
    ),
)
"""
LEGS = "Aa Ab Ac Bd Be Cf"


@pytest.fixture
def folder(tmp_path: Path) -> Callable[..., Path]:
    """Writes a folder of plugins with one plugin, `mine`."""

    def write(code: str | None = None, identities: str | None = None) -> Path:
        (tmp_path / "mine").mkdir(exist_ok=True)
        if code is not None:
            (tmp_path / "mine" / "rules.py").write_text(code, encoding="utf-8")
        if identities is not None:
            (tmp_path / "mine" / "mine.gca").write_text(identities, encoding="utf-8")
        return tmp_path

    return write


def test_shipped_plugins_are_found() -> None:
    assert shipped_folder() is not None
    owners = {r.owner.partition(",")[0] for r in load_rules()}
    assert owners >= {"gcrules", "plugin plucker", "plugin legs-meet"}


def test_legs_that_meet_are_a_reading() -> None:
    a = gc.analyze("Aa Ab Ac Ba Bd Ce")
    assert a.condition.kind == "three-tetrahedra"
    (reading,) = (r for r in a.readings if r.kind == "legs-meet")
    assert str(reading.expression) == r"[ABCe](Aa /\ Bd)[Aabc]"
    assert reading.certificate.method == "normal-form"
    assert "the legs Aa and Bd meet (possibly at infinity)" in reading.statement
    assert gc.prove(f"[[Aa, Ab, Ac, Ba, Bd, Ce]] == {reading.coefficient} * ({reading.expression})").proved


def test_a_rule_of_a_folder_adds_a_reading(folder: Callable[..., Path]) -> None:
    strategy = load_rules(folders=[folder(RULE)], identities=False).strategy()
    a = gc.analyze(LEGS, strategy=strategy)
    assert a.condition.kind == "three-tetrahedra"
    (reading,) = (r for r in a.readings if r.kind == "mine")
    assert reading.statement.startswith("Mine: ")
    assert str(reading.expression) in reading.statement


def test_a_folder_that_is_a_plugin_itself_may_be_named(folder: Callable[..., Path]) -> None:
    around = folder(RULE, "rule pierce: ab /\\ cde => [acde] b - [bcde] a")
    inside, outside = load_rules(folders=[around / "mine"]), load_rules(folders=[around])
    assert [(r.id, r.owner) for r in inside] == [(r.id, r.owner) for r in outside]
    assert "mine" in {r.id for r in inside}
    assert len(list(plugins_in(around / "mine"))) == 1


def test_a_rule_of_a_folder_can_be_the_only_one(folder: Callable[..., Path]) -> None:
    a = gc.analyze(LEGS, strategy=load_rules(folders=[folder(RULE)]).strategy(["mine"]))
    assert a.condition.kind == "mine"
    assert a.strategy.ids[-2:] == ("tetrahedra", "mine")
    assert a.derivation.check()


def test_a_wrong_claim_is_never_made(folder: Callable[..., Path]) -> None:
    wrong = RULE.replace("for row in s.tetrahedra", "for row in s.tetrahedra[:2]")
    strategy = load_rules(folders=[folder(wrong)]).strategy(["mine"])
    assert gc.analyze(LEGS, strategy=strategy).condition.kind == "linear-complex"


def test_a_wrong_claim_is_refuted_by_the_check(folder: Callable[..., Path]) -> None:
    wrong = RULE.replace("mul(*(bracket(*points(s.named(row))) for row in s.tetrahedra))", "bracket(*points('Aabd'))")
    found = {c.rule.id: c for c in check_rules(folders=[folder(wrong)])}["mine"]
    assert not found.ok
    assert "its claim that the superbracket is a multiple of [Aabd] is wrong: at A = (" in found.reason
    assert found.fault is not None
    assert found.fault.filename.endswith("rules.py:11")


def test_the_check_sees_clashes(tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    for name in ("planes", "cross"):
        path.write_text(f"rule {name}: ab /\\ cd => [abcd]\n", encoding="utf-8")
        with pytest.raises(InputError, match=f"two rules are called {name}"):
            list(check_rules([path]))


BROKEN = [
    ("syntax", "RULES = (", "rules.py:1", "was never closed"),
    ("error", "x = 1\n\nraise ValueError('no')\n", "rules.py:3", "ValueError: no"),
    ("import", "import gcrules.no_such_module\n", "rules.py:1", "ModuleNotFoundError"),
    ("no rules", "x = 1\n", "rules.py", "defines no tuple RULES"),
    ("a list", "RULES = []\n", "rules.py", "defines no tuple RULES"),
    ("no rule", "RULES = (1,)\n", "rules.py", "which is not a rule"),
]


WHOLE = "mul(*(bracket(*points(s.named(row))) for row in s.tetrahedra))"
FAILING = [
    ("an error", "for row in s.tetrahedra", "for row in s.no_such_thing", "rules.py:11", "AttributeError"),
    ("a step", WHOLE, "points(s.named(s.tetrahedra[0]))[0]", "rules.py:11", "has step 1"),
]


@pytest.mark.parametrize(("old", "new", "place", "words"), [f[1:] for f in FAILING], ids=[f[0] for f in FAILING])
def test_a_rule_that_fails_is_reported_with_its_place(
    folder: Callable[..., Path], old: str, new: str, place: str, words: str
) -> None:
    strategy = load_rules(folders=[folder(RULE.replace(old, new))]).strategy()
    with pytest.raises(FileError) as caught:
        gc.analyze(LEGS, strategy=strategy)
    assert "the rule mine fails" in caught.value.message
    assert words in caught.value.message
    assert caught.value.filename.endswith(place)


def test_a_statement_with_an_unknown_part(folder: Callable[..., Path]) -> None:
    with pytest.raises(FileError, match="cannot be filled into the statement of mine"):
        load_rules(folders=[folder(RULE.replace("{expression}", "{expresion}"))])


@pytest.mark.parametrize(("code", "place", "words"), [b[1:] for b in BROKEN], ids=[b[0] for b in BROKEN])
def test_a_broken_plugin_is_reported_with_its_place(
    folder: Callable[..., Path], code: str, place: str, words: str
) -> None:
    with pytest.raises(FileError) as caught:
        load_rules(folders=[folder(code)])
    assert place in caught.value.filename
    assert words in caught.value.message


def test_a_folder_that_is_none() -> None:
    with pytest.raises(FileError, match="folder of plugins"):
        load_rules(folders=["no/such/folder"])


def test_clashes_name_both_owners(folder: Callable[..., Path]) -> None:
    path = folder(RULE.replace('id="mine"', 'id="four-planes"'), "rule exchange: ab /\\ cd => [abcd]")
    with pytest.raises(InputError) as caught:
        load_rules(folders=[path], identities=False)
    assert caught.value.message == "two rules are called four-planes: one of gcrules, one of plugin mine"
    (path / "mine" / "rules.py").unlink()
    with pytest.raises(InputError) as caught:
        load_rules(folders=[path])
    assert "one of plugin plucker, plucker.gca:4, one of plugin mine, mine.gca:1" in caught.value.message


def test_identities_of_a_folder_are_proved(folder: Callable[..., Path]) -> None:
    path = folder(identities="rule mine: ab /\\ cd => -[abcd]")
    assert [p.owner for p in plugins_in(path)] == ["plugin mine"]
    load_rules(folders=[path], identities=False)
    with pytest.raises(InputError, match="the rule mine is not an identity"):
        load_rules(folders=[path])


def test_analyses_with_rules_of_plugins_can_be_pickled() -> None:
    a = gc.analyze("Aa Ab Ac Ba Bd Ce")
    assert pickle.loads(pickle.dumps(a)).condition == a.condition


OWN = """
classes:
  - id: own-1
    legs: Aa Ab Ac Bd Be Cf
    condition: {kind: mine, expression: '[Aabc][ABde][ABCf]', statement: 'In my own words.'}
"""


def test_a_catalog_may_have_kinds_that_a_plugin_brings(folder: Callable[..., Path], tmp_path: Path) -> None:
    plugins, own = str(folder(RULE)), tmp_path / "own.yaml"
    own.write_text(OWN, encoding="utf-8")
    words = ["--catalog", str(own), "--plugins", plugins]
    shown = CliRunner().invoke(cli, ["catalog", "show", "own-1", *words])
    assert (shown.exit_code, "mine: superbracket =" in shown.output) == (0, True)
    found = json.loads(CliRunner().invoke(cli, ["analyze", LEGS, "--json", *words]).output)
    assert "In my own words." in {r["statement"] for r in found["readings"]}
    refused = CliRunner().invoke(cli, ["catalog", "show", "own-1", *words[:2]])
    assert refused.exit_code == 2
    assert "'mine' is not one of" in refused.stderr


def test_a_folder_brings_its_catalog(folder: Callable[..., Path]) -> None:
    """Its entries are found by their ids, may be of the kinds of its rules, and make readings."""
    plugins = folder(RULE)
    (plugins / "mine" / "catalog.yaml").write_text(OWN, encoding="utf-8")
    assert gc.load("own-1", plugins=[plugins]) == gc.load(LEGS)
    a = gc.analyze("own-1", plugins=[plugins])
    assert {"In my own words."} < {r.statement for r in (a.condition, *a.readings)}
    words = ["--plugins", str(plugins)]
    found = json.loads(CliRunner().invoke(cli, ["analyze", LEGS, "--json", *words]).output)
    assert "In my own words." in {r["statement"] for r in found["readings"]}
    named = CliRunner().invoke(cli, ["analyze", LEGS, "--json", "--rules", "four-planes", *words])
    assert named.exit_code == 0  # the kinds of a plugin's rules are known to its catalog whatever rules run
    checked = CliRunner().invoke(cli, ["catalog", "check", *words])
    assert (checked.exit_code, "own-1" in checked.output) == (0, True)
    assert "In my own words." not in {r.statement for r in gc.analyze(LEGS).readings}


REFUSED = {
    "no catalog": ("classes: 1", "plugin mine: expected a list", "catalog.yaml:1"),
    "another kind": (OWN.replace("kind: mine", "kind: yours"), "plugin mine: 'yours' is not one of", "catalog.yaml:5"),
    "a class that is known": (OWN.replace("own-1", "3-3.3"), "class 3-3.3 is also defined in ", "catalog.yaml:3"),
    "two faults": (OWN.replace("mine", "yours").replace("[Aabc]", "[Aabz]"), "plugin mine: 'yours'", "catalog.yaml:5"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_wrong_catalog_is_told_with_its_plugin_and_place(folder: Callable[..., Path], name: str) -> None:
    text, words, place = REFUSED[name]
    plugins = folder(RULE)
    (plugins / "mine" / "catalog.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(FileError) as caught:
        gc.analyze(LEGS, plugins=[plugins])
    assert words in str(caught.value)
    assert place in str(caught.value)


def test_a_false_entry_of_a_plugin_is_no_answer(folder: Callable[..., Path]) -> None:
    plugins = folder(RULE)
    false = OWN.replace("[Aabc][ABde][ABCf]", "[Aabc][ABde][ABCd]")
    (plugins / "mine" / "catalog.yaml").write_text(false, encoding="utf-8")
    with pytest.raises(FileError, match=r"catalog.yaml:5:41: the reading .* is not an identity: it fails at"):
        gc.analyze(LEGS, plugins=[plugins])
    checked = CliRunner().invoke(cli, ["catalog", "check", "--plugins", str(plugins)])
    assert checked.exit_code == 1


def test_code_is_run_only_for_rules_and_catalogs(folder: Callable[..., Path]) -> None:
    plugins = folder("raise SystemExit(7)")
    assert list(plugins_in(plugins, "robots")) == list(plugins_in(plugins, "catalogs")) == []
    (plugins / "mine" / "catalog.yaml").write_text(OWN, encoding="utf-8")
    assert [len(p.catalogs) for p in plugins_in(plugins, "robots")] == [1]
    for bringing in ("catalogs", "rules"):
        with pytest.raises(FileError, match="plugin mine cannot be loaded: SystemExit: 7"):
            list(plugins_in(plugins, bringing))


@pytest.fixture(scope="module")
def outside(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the distribution of tests/outside installed."""
    target = tmp_path_factory.mktemp("outside")
    command = [sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--no-build-isolation", "--no-index"]
    subprocess.run([*command, "--target", str(target), str(root / "tests" / "outside")], check=True, timeout=300)
    return target


def run(outside: Path, root: Path, *words: str) -> subprocess.CompletedProcess[str]:
    path = os.pathsep.join([str(outside), str(root)])
    return subprocess.run(
        [sys.executable, "-m", "gcrules", *words],
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=300,
        env={**os.environ, "PYTHONPATH": path, "PYTHONUTF8": "1"},
    )


def test_an_outside_package_plugs_in(outside: Path, root: Path) -> None:
    rules = {r["id"]: r for r in json.loads(run(outside, root, "rules", "list", "--json").stdout)}
    assert rules["volumes"]["owner"] == "package gcrules-outside"
    assert rules["outside"]["owner"] == "package gcrules-outside, outside.gca:1"
    found = json.loads(run(outside, root, "analyze", LEGS, "--json").stdout)
    statements = {r["statement"] for r in found["readings"] if r["kind"] == "volumes"}
    assert any(s.startswith("The robot is singular exactly when the product of the volumes of ") for s in statements)
    rewritten = run(outside, root, "rewrite", "pq /\\ rs", "--rules", "outside", "--json")
    assert json.loads(rewritten.stdout)["after"] == "[pqrs]"
    assert "(package gcrules-outside)" in run(outside, root, "robot", "list").stdout
    assert json.loads(run(outside, root, "robot", "analyze", "outside-rps", "--json").stdout)["condition"]
    assert "Three volumes, one of which is 0." in statements
    assert "outside-1" in run(outside, root, "catalog", "list").stdout
    checked = run(outside, root, "rules", "check")
    assert checked.returncode == 0
    assert "volumes" in checked.stdout


def test_an_outside_package_that_clashes_is_named(outside: Path, root: Path, tmp_path: Path) -> None:
    mine = tmp_path / "mine.gca"
    mine.write_text("rule outside: ab /\\ cd => [abcd]\n", encoding="utf-8")
    result = run(outside, root, "rules", "list", "--rules", str(mine))
    assert result.returncode == 2
    assert "one of package gcrules-outside, outside.gca:1, one of " in result.stderr


def test_without_the_package_its_rules_are_gone(root: Path, tmp_path: Path) -> None:
    assert '"volumes"' not in run(tmp_path, root, "rules", "list", "--json").stdout
