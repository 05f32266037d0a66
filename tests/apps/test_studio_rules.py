"""Rules on the studio's bench: files that a page opens are checked and at work, plugins are those of the start."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from commands import Run

from gcrules.apps.studio.bench import bench
from gcrules.apps.studio.plugins_view import plugins_view
from gcrules.apps.studio.protocol.requests import LONGEST_RULES, MOST_RULE_FILES, MOST_RULES
from gcrules.apps.studio.rule_files import checked_view, usable
from gcrules.apps.studio.rule_files_saved import saved
from gcrules.core.budget import within
from gcrules.core.errors import FileError

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

if TYPE_CHECKING:
    from apps.studio_client import Page
    from studio_page import Desk

PIERCE = 'rule pierce "line and plane": ab /\\ cde => [acde] b - [bcde] a'
WRONG = "rule wrong: ab /\\ cde => [acde] b + [bcde] a"
TURN = 'rule turn "two lines": ab /\\ cd => [abcd]'
CODE = """
import os
from gcrules.rules.plugins import ConditionRule, bracket, mul, points

print("this goes nowhere")
RULES = (
    ConditionRule(
        id="mine",
        sentence="Three tetrahedra, in words of my own.",
        fires=("Aa Ab Ac Bd Be Cf",),
        silent=(SILENT,),
        degree=0,
        expression=lambda s: mul(*(bracket(*points(s.named(row))) for row in s.tetrahedra)),
        statement="Mine: {tetrahedra} and {expression}.",
    ),
)
"""
SOUND = CODE.replace("SILENT", '"ab af cb cd ed ef"')


def opened(text: str, *off: str, name: str = "mine.gca") -> Any:
    return {"name": name, "text": text, "off": list(off)}


# --- files of rules ------------------------------------------------------------------------------------------------


def test_each_rule_is_proved_or_told_with_its_place(page: Page) -> None:
    text = f"# mine\n{PIERCE}\n{WRONG}\nrule loop: [abcd][abef] => [abce][abdf] - [abcf][abde]\n{TURN}\n"
    (found,) = page.ask("rules", files=[opened(text)])["files"]
    assert found["fault"] is None
    assert [(r["id"], r["line"], r["verdict"]) for r in found["rules"]] == [
        ("pierce", 2, "proved"),
        ("wrong", 3, "refuted"),
        ("loop", 4, "refused"),
        ("turn", 5, "proved"),
    ]
    assert [r["fault"] and r["fault"]["place"]["line"] for r in found["rules"]] == [None, 3, 4, None]
    assert "is not an identity: at a = (" in found["rules"][1]["reason"]
    assert "proved in rank 4" in found["rules"][0]["reason"]


@pytest.mark.parametrize(
    ("text", "words", "place"),
    [
        (f"{PIERCE}\nrule loose: [abcd] => [abce]", "unbound point e", (2, 23)),
        ("rule", "ends too early", (1, 5)),
        ("legs: [1, 2", "unexpected 'legs'", (1, 1)),
        ("[abcd] == [abcd]", "", (1, 1)),
        ("let p = ab", "holds no rules", None),
        ("", "holds no rules", None),
    ],
)
def test_a_file_that_cannot_be_read_is_told_with_its_place(text: str, words: str, place: Any) -> None:
    (found,) = checked_view([opened(text)])["files"]
    assert found["rules"] == []
    assert found["fault"] is not None
    assert words in found["fault"]["message"]
    at = found["fault"].get("place")
    assert (at and (at["line"], at["column"])) == place


def test_ids_that_are_taken_name_both_owners() -> None:
    files = [opened(PIERCE), opened(f"{PIERCE}\n{TURN}", name="other.gca"), opened(TURN.replace("turn", "cross"))]
    first, second, third = checked_view(files)["files"]
    assert first["rules"][0]["fault"] is None
    assert second["rules"][0]["reason"] == "two rules are called pierce: one of mine.gca:1, one of other.gca:1"
    assert "plugin plucker" in third["rules"][0]["reason"]
    assert [r.id for r in usable(files)] == ["pierce", "turn"]
    files[0]["off"] = ["pierce"]
    assert [(r.id, r.owner) for r in usable(files)] == [("pierce", "other.gca:1"), ("turn", "other.gca:2")]


def test_rules_are_at_work_and_answers_say_which() -> None:
    text = "rewrite ab /\\ cde\nrewrite ab /\\ cd"
    both, none = bench(text, None, None, [opened(f"{PIERCE}\n{WRONG}\n{TURN}", "turn")])["results"]
    assert both["applied"] == [
        {"id": "pierce", "sentence": "line and plane", "owner": {"kind": "file", "name": "mine.gca", "line": 1}}
    ]
    assert none["applied"] == []
    assert "no rule fires" in none["text"]
    (alone,) = bench("rewrite ab /\\ cd", None, None, [opened(f"{PIERCE}\n{TURN}")])["results"]
    assert [rule["id"] for rule in alone["applied"]] == ["turn"]


def test_the_bench_goes_on_with_files_that_are_wrong() -> None:
    files = [opened("rule ("), opened(WRONG, name="b.gca"), opened(PIERCE, "nothing of this name", name="c.gca")]
    (found,) = bench("rewrite ab /\\ cde", None, None, files)["results"]
    assert [rule["owner"] for rule in found["applied"]] == [{"kind": "file", "name": "c.gca", "line": 1}]


def test_a_rule_of_the_text_that_a_file_has_is_a_fault_at_its_place() -> None:
    found = bench(f"[abcd]\n{PIERCE}", None, None, [opened(PIERCE)])
    assert found["fault"] is not None
    assert "there is a rule pierce already" in found["fault"]["message"]
    assert found["fault"]["place"]["line"] == 2


def test_an_analysis_tells_the_rules_that_led_to_it() -> None:
    found, other = bench(":analyze Aa Ab Ac Ba Bd Ce\n:analyze ab af cb cd ed ef", None, None)["results"]
    assert {"id", "sentence", "owner"} == set(found["applied"][0])
    assert [r["owner"] for r in found["applied"] if r["id"] == "legs-meet"] == [
        {"kind": "plugin", "name": "plugin legs-meet", "line": None}
    ]
    assert all(r["owner"] == {"kind": "gcrules", "name": "", "line": None} for r in other["applied"])
    (swapped,) = bench(f"{TURN}\nrewrite ab /\\ cd", None, None)["results"][1:]
    assert [r["owner"] for r in swapped["applied"]] == [{"kind": "text", "name": "", "line": None}]


def test_a_limit_has_its_line_and_what_stands_before_it_stays() -> None:
    with within(0.0):
        found = bench("[abcd]\n:shorten [[Aa, Bb, Cc, Dd, Ee, Ff]]", None, None)
    assert found["fault"] is not None
    assert found["fault"]["kind"] == "limit"
    assert found["fault"]["place"]["line"] >= 1
    again = bench("[abcd]\n:shorten [[ab, af, cb, cd, ed, ef]]", None, None)
    assert again["fault"] is None


def test_what_is_saved_beside_a_line_holds_what_was_used() -> None:
    (found,) = saved([opened(f"{PIERCE}\n{WRONG}\n{TURN}\n", "turn")])
    assert found["text"].splitlines() == [PIERCE, f"# {WRONG}", f"# {TURN}"]
    assert saved([opened(f"{WRONG}\n"), opened("rule (")]) == []
    twice = [opened(f"{PIERCE}\n", name="Mine.gca"), opened(f"{PIERCE}\n{TURN}\n", name="mine.gca")]
    assert [(one["name"], one["text"].splitlines()) for one in saved(twice)] == [
        ("Mine.gca", [PIERCE]),
        ("mine-2.gca", [f"# {PIERCE}", TURN]),
    ], "an id that is taken is not used twice, and no disk takes two names for one"


# --- hostile -------------------------------------------------------------------------------------------------------

NAMES = [
    "../../.ssh/authorized_keys",
    "$(echo ran).gca",
    "`x`.gca",
    "-o.gca",
    "a\nb.gca",
    "con.gca",
    "..",
    "é…",
    "x" * 200,
]


def test_names_of_files_in_lines_are_plain() -> None:
    files = [opened(PIERCE.replace("pierce", f"p{i}"), name=name) for i, name in enumerate(NAMES)]
    names = [one["name"] for one in saved(files)]
    assert all(name.isascii() and name[:1].isalnum() and "/" not in name for name in names)
    assert len(set(names)) == len(files)
    (found,) = bench("rewrite ab /\\ cde", None, None, files[:3])["results"]
    assert found["repeat"] is not None
    assert "$" not in found["repeat"]["shell"]
    assert "`" not in found["repeat"]["shell"]


BAD: dict[str, Any] = {
    "a folder of plugins": {"files": [], "folders": ["/tmp"]},
    "no files": {},
    "many files": {"files": [opened(PIERCE)] * (MOST_RULE_FILES + 1)},
    "a long file": {"files": [opened("#" * (LONGEST_RULES + 1))]},
    "many that are off": {"files": [opened(PIERCE, *["x"] * (MOST_RULES + 1))]},
    "a path": {"files": ["/etc/passwd"]},
    "a path in the place of text": {"files": [{"name": "x", "path": "/etc/passwd", "off": []}]},
    "no name": {"files": [opened(PIERCE, name=" ")]},
    "off is not a list": {"files": [{"name": "x", "text": PIERCE, "off": "pierce"}]},
    "a null character": {"files": [opened("rule a\0b")]},
    "a lone surrogate": {"files": [opened("\ud800")]},
}


@pytest.mark.parametrize("name", BAD)
def test_what_is_no_file_of_rules_is_refused(page: Page, name: str) -> None:
    assert page.fault("rules", **BAD[name])["kind"] == "input"
    args = {k: v for k, v in BAD[name].items() if k != "files"} | ({"rules": BAD[name]["files"]} if BAD[name] else {})
    if args:
        assert page.fault("bench", text="[abcd]", **args)["kind"] == "input"


ASKED: dict[str, Any] = {"plugins": {}, "bench": {"text": ""}, "repeat": {"what": "bench", "args": {}}}


def test_no_page_names_plugins(page: Page, tmp_path: Path) -> None:
    for method in ASKED:
        args = ASKED[method]
        fault = page.fault(method, **args, folders=[str(tmp_path)])
        assert "has no key 'folders'" in fault["message"]
    assert page.fault("repeat", what="bench", args={"text": "x", "folders": [str(tmp_path)]})["kind"] == "input"


STRANGE = {
    "Python": SOUND,
    "nested": "rule deep: " + "(" * 5_000,
    "YAML of a tag": "!!python/object/apply:os.system ['echo ran']",
    "many rules": "\n".join(f"rule r{i}: ab /\\ cde => [acde] b - [bcde] a" for i in range(60)),
    "rules that grow": "rule grow: [R... a][R... b] => [R... a][R... b] + [R... a][R... b] - [R... a][R... b]",
    "a command": f":load /etc/passwd\n{PIERCE}",
    "an end": f"{PIERCE}\nEND\necho ran",
}


@pytest.mark.parametrize("name", STRANGE)
def test_strange_files_are_data(page: Page, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = opened(STRANGE[name], name="rules.py")
    (found,) = page.ask("rules", files=[file])["files"]
    assert found["fault"] or found["rules"]
    if name != "many rules":
        assert found["fault"] or all(rule["fault"] for rule in found["rules"])
    answers = page.ask("bench", text="[abcd] == -[bacd]", rules=[file])
    assert [r["verdict"] for r in answers["results"]] == ["proved"]


# --- plugins -------------------------------------------------------------------------------------------------------


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "own").mkdir()
    (tmp_path / "own" / "rules.py").write_text(SOUND, encoding="utf-8")
    (tmp_path / "own" / "own.gca").write_text(f"{PIERCE}\n", encoding="utf-8")
    return tmp_path


@pytest.fixture
def with_plugins(folder: Path) -> Iterator[Page]:
    """A page of a studio that was started with a folder of plugins."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from starlette.testclient import TestClient
    from apps.studio_client import KNOWN, OWN, PORT, TOKEN, Page

    from gcrules.apps.studio.app import make_app

    app = make_app(PORT, TOKEN, folders=(str(folder),))
    with TestClient(app, base_url=OWN) as client, client.websocket_connect("/ws", headers=KNOWN) as socket:
        yield Page(socket)


def test_plugins_of_the_start_are_listed_checked_and_at_work(with_plugins: Page, folder: Path) -> None:
    found = with_plugins.ask("plugins")
    assert found["folders"] == [str(folder)]
    (own,) = [p for p in found["plugins"] if p["kind"] == "folder"]
    assert [(r["id"], r["holds"], r["reason"]) for r in own["rules"]] == [
        ("mine", True, "2 cases hold"),
        ("pierce", True, "proved in rank 4"),
    ]
    answers = with_plugins.ask("bench", text=":analyze Aa Ab Ac Bd Be Cf")
    (result,) = answers["results"]
    assert [r["owner"]["name"] for r in result["applied"] if r["id"] == "mine"] == ["plugin own"]
    assert f"--plugins {folder}" in result["repeat"]["shell"]
    whole = with_plugins.ask("repeat", what="bench", args={"text": ":analyze Aa Ab Ac Bd Be Cf"})
    assert whole["shell"].startswith(f"gcrules repl --plugins {folder} <<'END'")


def test_a_rule_that_fails_its_cases_is_told(folder: Path) -> None:
    code = CODE.replace("SILENT", '"Aa Ab Ac Bd Be Cf"')
    (folder / "own" / "rules.py").write_text(code, encoding="utf-8")
    found = plugins_view([str(folder)])["plugins"][-1]["rules"]
    assert [(r["id"], r["holds"]) for r in found] == [("mine", False), ("pierce", True)]
    assert "fires on Aa Ab Ac Bd Be Cf" in found[0]["reason"]


def test_plugins_that_come_with_gcrules_are_listed(page: Page) -> None:
    found = page.ask("plugins")
    assert found["folders"] == []
    assert {"plugin legs-meet", "plugin plucker"} <= {p["name"] for p in found["plugins"]}
    assert all(rule["holds"] for p in found["plugins"] for rule in p["rules"])
    assert found["robots"] > 30


def test_a_plugin_that_is_broken_is_told_before_a_page_is_opened(folder: Path, run: Run) -> None:
    (folder / "own" / "rules.py").write_text("RULES = 1 / 0", encoding="utf-8")
    found = run("studio", "--no-browser", "--plugins", str(folder))
    assert found.exit_code == 2
    assert "rules.py" in found.output
    with pytest.raises(FileError):
        plugins_view([str(folder)])


# --- the prompt ----------------------------------------------------------------------------------------------------


def test_rules_hold_at_the_prompt_from_its_start(run: Run, tmp_path: Path, folder: Path) -> None:
    (tmp_path / "mine.gca").write_text(f"{TURN}\n", encoding="utf-8")
    found = run("repl", "--rules", str(tmp_path / "mine.gca"), "-e", "rewrite ab /\\ cd")
    assert found.exit_code == 0
    assert "by turn: two lines" in found.output
    told = run("repl", "--plugins", str(folder), "-e", ":analyze Aa Ab Ac Bd Be Cf")
    assert "Mine:" in told.output
    wrong = tmp_path / "wrong.gca"
    wrong.write_text(WRONG, encoding="utf-8")
    assert run("repl", "--rules", str(wrong), "-e", "[abcd]").exit_code == 2


# --- the page ------------------------------------------------------------------------------------------------------


@pytest.mark.browser
def test_rules_are_opened_switched_and_seen_at_work(desk: Desk, tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    path.write_text(f"{PIERCE}\n{WRONG}\n", encoding="utf-8")
    desk.one("panel-bench").click()
    desk.run("text => gcrules.edit({bench: text})", "[abcd]\nrewrite ab /\\ cde")
    desk.one("bench-rules-open").click()
    desk.one("plugin-legs-meet").wait_for()
    assert "this page does not load any" in desk.text("bench-plugins")
    assert "gcrules studio --plugins DIR" in desk.text("bench-plugins")
    desk.one("rules-file").set_input_files(str(path))
    rule = desk.one("rule-pierce")
    rule.get_by_test_id("rule-work").wait_for()
    assert rule.get_by_test_id("rule-work").inner_text() == "at work in line 2"
    assert desk.one("bench-applied").inner_text().split() == ["by", "pierce"]
    wrong = desk.one("rule-wrong")
    assert wrong.get_attribute("data-verdict") == "refuted"
    assert wrong.locator("input").is_disabled()
    assert wrong.locator("mark").inner_text() == WRONG
    rule.locator("input").uncheck()
    desk.page.wait_for_function("() => document.body.innerText.includes('no rule fires')")
    desk.one("undo").click()
    desk.one("bench-applied").wait_for()
    desk.page.reload()
    desk.one("bench-applied").wait_for()  # they are kept
    desk.one("bench-rules-open").click()
    desk.one("rules-close-0").click()
    desk.one("bench-applied").wait_for(state="detached")
    desk.one("rule-write-cross").click()
    assert desk.run("gcrules.bench$.value").splitlines()[0].startswith('rule cross "line and plane meet in a point":')


@pytest.mark.browser
def test_each_answer_is_copied_and_repeated(desk: Desk, tmp_path: Path) -> None:
    desk.one("panel-bench").click()
    desk.run("text => gcrules.edit({bench: text})", "let p = ab /\\ cde\np f\n[abcd] == [bacd]")
    second = desk.one("bench-result").nth(1)
    second.wait_for()
    second.get_by_test_id("bench-copy").click()
    desk.page.wait_for_selector(".notice.told")
    assert desk.run("navigator.clipboard.readText()") == "[acde] · bf − [bcde] · af"
    second.get_by_test_id("bench-copy-tex").click()
    desk.page.wait_for_function("async () => (await navigator.clipboard.readText()).includes('\\\\,')")
    second.get_by_test_id("bench-repeat").click()
    lines = second.get_by_test_id("bench-lines").locator("pre")
    assert lines.first.inner_text() == 'gcrules expand "(ab /\\ cde) \\/ f"'
    second.get_by_test_id("repeat-copy-python").click()
    desk.page.wait_for_function("async () => (await navigator.clipboard.readText()).includes('gc.expand')")
    shown: list[Any] = []
    exec(str(desk.run("navigator.clipboard.readText()")), {"print": shown.append})
    assert str(shown[0]) == "[acde] * bf - [bcde] * af"
    refuted = desk.one("bench-result").nth(2)
    assert refuted.get_by_test_id("bench-copy-tex").count() == 0  # nobody takes a wrong equation along
    assert refuted.get_by_test_id("bench-copy").count() == 1


@pytest.mark.browser
def test_a_long_question_says_how_far_it_is_and_is_stopped(desk: Desk) -> None:
    turns = ["abcdef"[i:] + "abcdef"[:i] for i in range(6)]
    legs = [", ".join(f"{a.upper()}{b}" for a, b in zip("abcdef", turn, strict=True)) for turn in turns]
    long = "\n".join(f":shorten [[{one}]]" for one in legs)
    desk.one("panel-bench").click()
    desk.run("text => gcrules.edit({bench: text})", "[abcd] == -[bacd]\n[abce]")
    desk.one("bench-result").nth(1).wait_for()
    desk.run("text => gcrules.edit({bench: text})", f"[abcd] == -[bacd]\n{long}")
    desk.page.wait_for_function(
        "() => /line \\d+, :shorten .*, \\d+ s/.test(document.querySelector('.bench').innerText)"
    )
    found = desk.one("bench-result").count()
    assert found >= 1  # what has not changed is still true
    desk.one("bench-stop").click()
    desk.one("bench-stop").wait_for(state="detached")
    assert desk.text("bench-note").startswith("Stopped with")
    assert found <= desk.one("bench-result").count() <= len(turns)
    assert desk.page.get_by_test_id("fault").count() == 0
    desk.run("text => gcrules.edit({bench: text})", "[abcd] == -[bacd]\n[abcd]")
    desk.one("bench-result").nth(1).wait_for()
