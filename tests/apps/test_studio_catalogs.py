"""Catalogs of the user's own on the studio's bench: opened as files of rules are, checked, at work, and marked."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from commands import Run

from gcrules.apps.studio import catalog_files
from gcrules.apps.studio.bench import bench
from gcrules.apps.studio.rule_files import checked_view, usable
from gcrules.apps.studio.rule_files_saved import saved, saved_catalogs
from gcrules.rules.catalog import catalog
from gcrules.rules.catalog.proof_status import ProofStatus

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

if TYPE_CHECKING:
    from apps.studio_client import Page
    from studio_page import Desk

LEGS = "pq qr rp Aa Bb Cc"
ENTRY = r"""  - id: {id}
    name: a triangle
    legs: {legs}
    condition:
      kind: one-incidence
      coefficient: {sign}
      expression: '((Dd /\ abc) \/ (Ee /\ abc)) /\ Ff'
      statement: 'Mine: {{Dd}}, {{Ee}} and {{Ff}} pierce {{abc}} in points of one line.'
"""
CLASS = ENTRY.format(id="triangle", legs="ab bc ca Dd Ee Ff", sign=-1)
MINE = f"classes:\n{CLASS}"
WRONG = ENTRY.format(id="wrong", legs="ab bc ca Dd Ee Ff", sign=2)
PIERCE = 'rule pierce "line and plane": ab /\\ cde => [acde] b - [bcde] a'


def opened(text: str, *off: str, name: str = "mine.yaml") -> Any:
    return {"name": name, "text": text, "off": list(off)}


def test_classes_are_proved_or_told_with_what_is_wrong(page: Page) -> None:
    files = [opened(f"{MINE}{WRONG}"), opened(PIERCE, name="mine.gca"), opened(MINE, name="other.yml")]
    own, rules, again = page.ask("rules", files=files)["files"]
    assert [f["kind"] for f in (own, rules, again)] == ["catalog", "rules", "catalog"]
    assert [(r["id"], r["line"], r["verdict"], r["sentence"]) for r in own["rules"]] == [
        ("triangle", 2, "proved", "a triangle: ab bc ca Dd Ee Ff"),
        ("wrong", 10, "refuted", "a triangle: ab bc ca Dd Ee Ff"),
    ]
    assert "is not an identity: it fails at" in own["rules"][1]["fault"]["message"]
    (clash,) = again["rules"]
    assert clash["verdict"] == "refused"
    assert clash["fault"]["message"] == "two classes are called triangle: one of mine.yaml, one of other.yml"
    assert [r.id for r in usable(files)] == ["pierce"]


@pytest.mark.parametrize(
    ("text", "words", "line"),
    [
        ("classes:\n  - id: one\n    legs: ab\n", "condition", 2),
        ("classes: []\n", "holds no classes", None),
        ("legs: ab af cb cd ed ef\n", "unknown key", 1),
        ("classes: [\n", "", 2),
    ],
)
def test_a_catalog_that_cannot_be_read_says_where(text: str, words: str, line: int | None) -> None:
    (found,) = checked_view([opened(text)])["files"]
    assert found["fault"] is not None
    assert words in found["fault"]["message"]
    assert found["fault"].get("place", {}).get("line") == line


def test_a_class_is_at_work_in_analyses_and_named() -> None:
    text = f"[abcd]\n:analyze {LEGS}"
    _, plain = bench(text, None, None)["results"]
    assert "Mine" not in plain["text"]
    _, found = bench(text, None, None, [opened(MINE)])["results"]
    assert "In the words of mine.yaml, class triangle: Mine: Aa, Bb and Cc pierce pqr" in found["text"]
    (own,) = [r for r in found["applied"] if r["owner"]["kind"] == "file"]
    assert own["id"] == "triangle"
    assert own["owner"] == {"kind": "file", "name": "mine.yaml", "line": 2}
    (off,) = bench(f":analyze {LEGS}", None, None, [opened(MINE, "triangle")])["results"]
    assert "Mine" not in off["text"]


def test_a_class_that_is_wrong_takes_no_part() -> None:
    found = bench(f":analyze {LEGS}", None, None, [opened(f"classes:\n{WRONG}")])
    assert found["fault"] is None
    assert "Mine" not in found["results"][0]["text"]


def test_what_is_not_proved_is_used_and_marked(monkeypatch: pytest.MonkeyPatch) -> None:
    open_ = ProofStatus("unproved", "too many terms", "0" * 64)
    for module in (catalog_files, catalog):
        monkeypatch.setattr(module, "proof_status", lambda entry, reading: open_)
    text = MINE.replace("a triangle", "another triangle")  # that nothing is remembered of
    (file,) = checked_view([opened(text)])["files"]
    (row,) = file["rules"]
    assert (row["verdict"], row["fault"]) == ("undecided", None)
    assert row["reason"] == "unproved, and its answers say so: too many terms"
    (found,) = bench(f":analyze {LEGS}  # anew", None, None, [opened(text)])["results"]
    assert "claimed by mine.yaml, class triangle; unproved" in " ".join(found["text"].split())


def test_the_lines_that_repeat_it_name_the_catalog(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = [opened(f"{MINE}{WRONG}", name="../my own.YML"), opened(PIERCE, name="mine.gca")]
    (found,) = bench(f":analyze {LEGS}", None, None, files)["results"]
    lines = found["repeat"]
    assert lines is not None
    assert lines["shell"] == f'gcrules analyze "{LEGS}" --rules mine.gca --catalog my-own.yaml'
    assert 'catalogs=["my-own.yaml"]' in lines["python"]
    for file in lines["files"]:
        (tmp_path / file["name"]).write_text(file["text"], encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    shown = run("analyze", LEGS, "--rules", "mine.gca", "--catalog", "my-own.yaml")
    assert shown.exit_code == 0
    assert "Mine: Aa, Bb and Cc pierce pqr" in shown.output
    said = run("repl", "--catalog", "my-own.yaml", "-e", f":analyze {LEGS}")
    assert "In the words of my-own.yaml, class triangle" in " ".join(said.output.split())


def test_classes_that_are_left_out_are_comments() -> None:
    text = (
        f"# head\n{MINE}{CLASS.replace('triangle', 'second')}statements:\n  linear-complex: 'Mine, in one complex.'\n"
    )
    (found,) = saved_catalogs([opened(text, "triangle")])
    assert found["text"].splitlines()[2].startswith("#   - id: triangle")
    assert "\n  - id: second" in found["text"]
    assert "\nstatements:\n" in found["text"]
    assert saved([opened(MINE)]) == []
    assert saved_catalogs([opened(MINE, "triangle"), opened("classes: [", name="b.yaml")]) == []


def test_a_wrong_catalog_is_told_when_the_prompt_starts(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text("classes:\n  - id: one\n", encoding="utf-8")
    found = run("repl", "--catalog", str(path), "-e", "[abcd]")
    assert found.exit_code == 2
    assert "mine.yaml:2:5" in found.output


@pytest.mark.browser
def test_a_catalog_is_opened_and_seen_at_work(desk: Desk, tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text(f"{MINE}{WRONG}", encoding="utf-8")
    desk.one("panel-bench").click()
    desk.run("text => gcrules.edit({bench: text})", f"[abcd]\n:analyze {LEGS}")
    desk.one("bench-rules-open").click()
    desk.one("rules-file").set_input_files(str(path))
    row = desk.one("rule-triangle")
    row.get_by_test_id("rule-work").wait_for()
    assert row.get_by_test_id("rule-work").inner_text() == "at work in line 2"
    assert desk.one("rules-of-0").locator(".tag", has_text="catalog").count() == 1
    assert desk.one("rule-wrong").get_attribute("data-verdict") == "refuted"
    assert desk.one("rule-wrong").locator("input").is_disabled()
    row.locator("input").uncheck()
    row.get_by_test_id("rule-work").wait_for(state="detached")
    row.locator("input").check()
    row.get_by_test_id("rule-work").wait_for()
