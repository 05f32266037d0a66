"""Plugins that misbehave: each is named as the culprit with exit code 2; standard output stays that of the answer."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import FileError, LimitReached
from gcrules.rules import foreign
from gcrules.rules.plugin import installed
from gcrules.rules.plugins import ConditionRule, load_rules

LEGS = "Aa Ab Ac Bd Be Cf"

RULE = """
{imports}
from gcrules.rules.plugins import ConditionRule, add, bracket, mul, points

def expression(s):
    {body}

def whole(s):
    return mul(*(bracket(*points(s.named(row))) for row in s.tetrahedra))

RULES = (
    ConditionRule(
        id="mine", sentence="Mine.", fires=("Aa Ab Ac Bd Be Cf",), silent=("ab af cb cd ed ef",), degree=0,
        expression=expression, statement="Mine: {{tetrahedra}}.",{fields}
    ),
)
"""

NEW = "class New(BaseException):\n    pass\n"
SILENT = "class New(Exception):\n    def __str__(self):\n        raise SystemExit(0)\n"
THREAD = "import threading, time"
START = "threading.Thread(target=time.sleep, args=(3600,), daemon={}).start()"

# what is run at import, in the function, further fields; where and what is told
CULPRITS = {
    "sys.exit at import": ("raise SystemExit(0)", "", "", "rules.py:2", "plugin mine cannot be loaded: SystemExit: 0"),
    "sys.exit": ("import sys", "sys.exit(0)", "", "rules.py:6", "SystemExit: 0"),
    "exit without words": (
        "import sys",
        "sys.exit()",
        "",
        "rules.py:6",
        "plugin mine: the rule mine fails: SystemExit",
    ),
    "KeyboardInterrupt at import": ("raise KeyboardInterrupt", "", "", "rules.py:2", "KeyboardInterrupt"),
    "KeyboardInterrupt": ("", "raise KeyboardInterrupt", "", "rules.py:6", "the rule mine fails: KeyboardInterrupt"),
    "GeneratorExit": ("", "raise GeneratorExit", "", "rules.py:6", "GeneratorExit"),
    "StopIteration": ("", "raise StopIteration", "", "rules.py:6", "StopIteration"),
    "BaseException": (NEW, "raise New('no')", "", "rules.py:8", "New: no"),
    "an error that cannot be shown": (SILENT, "raise New", "", "rules.py:9", "an error without a message"),
    "MemoryError": ("", "raise MemoryError", "", "rules.py:6", "MemoryError"),
    "RecursionError": ("", "return expression(s)", "", "rules.py:6", "RecursionError"),
    "ZeroDivisionError": ("", "return 1 / 0", "", "rules.py:6", "ZeroDivisionError"),
    "a limit of its own": (
        "from gcrules.core.errors import LimitReached",
        "raise LimitReached('too much')",
        "",
        "rules.py:6",
        "too much",
    ),
    "closes stdout": ("import sys", "sys.stdout.close(); sys.__stdout__.close(); 1 / 0", "", "rules.py:6", "ZeroDiv"),
    "no expression": ("", "return 'abc'", "", "rules.py:5", "it gives 'abc', expected an expression"),
    "a point": ("", "return points('a')[0]", "", "rules.py:5", "has step 1"),
    "a huge sum": ("", "return add(*(whole(s) for _ in range(10_000)))", "", "rules.py:5", "20,000 points"),
    "a huge power": (
        "from gcrules.algebra.expr import Power",
        "return Power(Power(Power(whole(s), 64), 64), 64)",
        "",
        "rules.py:5",
        "20,000 points",
    ),
    "deep": (
        "",
        "e = whole(s)\n    for _ in range(999):\n        e = add(e, e) ** 2\n    return e",
        "",
        "rules.py",
        "",
    ),
    "no cofactor": ("", "return whole(s)", "cofactor=lambda s: None,", "rules.py:14", "expected an expression"),
    "no text": ("", "return whole(s)", "group=5,", "rules.py", "group of the rule mine is 5"),
    "no function": ("", "return whole(s)", "cofactor=5,", "rules.py", "cofactor of the rule mine is 5"),
    "cases": ("", "return whole(s)", "uses=5,", "rules.py", "uses of the rule mine is 5"),
}
# rules.py as a whole
WHOLE = {
    "RULES = None": ("RULES = None", "plugin mine defines no tuple RULES"),
    "a rule that is none": ("RULES = (None,)", "plugin mine: rules holds None, which is not a rule"),
    "no module": ("import gcrules.nowhere", "ModuleNotFoundError"),
    "a lazy attribute": ("def __getattr__(name):\n    return 1 / 0\n", "ZeroDivisionError"),
}


def write(folder: Path, code: str) -> str:
    (folder / "mine").mkdir()
    (folder / "mine" / "rules.py").write_text(code, encoding="utf-8")
    return str(folder)


def rule(imports: str = "", body: str = "", fields: str = "") -> str:
    return RULE.format(imports=imports, body=body or "return None", fields=fields)


def assert_named(code: int, out: str, err: str, place: str, words: str) -> None:
    assert (code, out) == (2, ""), err
    assert "Traceback" not in err
    (line,) = (line for line in err.splitlines() if line.startswith("error:"))
    assert place in line
    assert words in line


@pytest.mark.parametrize("name", CULPRITS)
def test_a_plugin_is_the_culprit(tmp_path: Path, name: str) -> None:
    *code, place, words = CULPRITS[name]
    done = CliRunner().invoke(cli, ["analyze", LEGS, "--json", "--plugins", write(tmp_path, rule(*code))])
    assert_named(done.exit_code, done.stdout, done.stderr, place, words)


COMMANDS = (
    ["analyze", LEGS],
    ["report", LEGS],
    ["catalog", "list"],
    ["catalog", "show", "6-3.2"],
    ["catalog", "check"],
    ["catalog", "docs", "--check"],
    ["rules", "list"],
    ["rules", "show", "planes"],
    ["rules", "check"],
    ["rewrite", "abc /\\ de", "--rules", "expansion"],
)


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
@pytest.mark.parametrize("name", WHOLE)
def test_a_plugin_that_cannot_be_loaded_is_named_by_every_command(
    tmp_path: Path, name: str, command: list[str]
) -> None:
    code, words = WHOLE[name]
    done = CliRunner().invoke(cli, [*command, "--plugins", write(tmp_path, code)])
    assert_named(done.exit_code, done.stdout, done.stderr, "rules.py", words)


@pytest.mark.parametrize("command", [c for c in COMMANDS if c != ["rules", "check"]], ids=" ".join)
def test_identities_that_are_wrong_are_refused_by_every_command(tmp_path: Path, command: list[str]) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "mine.gca").write_text("rule mine: ab /\\ cd => -[abcd]\n", encoding="utf-8")
    done = CliRunner().invoke(cli, [*command, "--plugins", str(tmp_path)])
    assert_named(done.exit_code, done.stdout, done.stderr, "mine.gca:1", "the rule mine is not an identity")


@pytest.mark.parametrize("body", ["raise KeyboardInterrupt", "return 1 / 0", "import sys; sys.exit(0)"])
def test_the_python_api_names_the_plugin(tmp_path: Path, body: str) -> None:
    strategy = load_rules(folders=[write(tmp_path, rule(body=body))], identities=False).strategy()
    with pytest.raises(FileError, match="plugin mine: the rule mine fails") as caught:
        gc.analyze(LEGS, strategy=strategy)
    assert caught.value.filename.endswith("rules.py:6")


def test_a_rule_of_the_caller_is_told_with_its_place() -> None:
    own = ConditionRule(id="own", sentence="Own.", degree=0, expression=lambda s: 1 / 0)  # type: ignore[return-value]
    with pytest.raises(FileError, match="the rule own fails: ZeroDivisionError") as caught:
        gc.analyze(LEGS, strategy=load_rules().plus([own]).strategy(["own"]))
    assert f"{Path(__file__).name}:" in caught.value.filename


PRINTS = "import os, sys\nprint('loud'); sys.__stdout__.write('loud'); "


WRONG = """
from dataclasses import replace
from gcrules.rules.plugins import ConditionRule, EntityRule, add, bracket, mul, points

def find(state, number):
    yield state

ENTITIES = EntityRule(
    id="mine-entities", sentence="Mine.", fires=(), find=find,
    after=lambda state, oracle: bracket(*points("Aabc")), why=lambda state: "so I say",
)
RULES = (
    ENTITIES,
    ConditionRule(
        id="mine", sentence="Mine.", uses=((ENTITIES, 1),), statement="Mine.",
        expression=lambda s: mul(*(bracket(*points(s.named(row))) for row in s.tetrahedra)),
    ),
)
"""


def test_a_step_that_is_wrong_is_the_plugins_own(tmp_path: Path) -> None:
    words = ["--rules", "mine", "--plugins", write(tmp_path, WRONG)]
    done = CliRunner().invoke(cli, ["analyze", LEGS, *words])
    assert_named(
        done.exit_code, done.stdout, done.stderr, "plugin mine", "a step of the rule mine-entities is not an identity"
    )


REWRITES = """
from gcrules.rules.plugins import Rule, bracket, points
from gcrules.rules.rule import Elementary, RewriteRule

class Kind(RewriteRule):
    def rewrite(self, e, space):
        {body}

RULES = (
    Elementary(id="mine", sentence="Mine.", apply=lambda e, space: bracket(*points("abcd"))),
    Kind(id="own-kind", sentence="Mine."),
)
"""


@pytest.mark.parametrize(
    ("name", "body", "words"),
    [
        ("mine", "pass", "the rule mine makes [abcd] of pq"),
        ("own-kind", "return bracket(*points('abcd'))", "the rule own-kind makes [abcd] of pq"),
        ("own-kind", "return 5", "the rule own-kind fails: it gives 5, expected an expression"),
        ("own-kind", "raise SystemExit(0)", "the rule own-kind fails: SystemExit: 0"),
    ],
)
def test_a_rewriting_rule_that_is_wrong(tmp_path: Path, name: str, body: str, words: str) -> None:
    folder = write(tmp_path, REWRITES.format(body=body))
    done = CliRunner().invoke(cli, ["rewrite", "pq /\\ rs", "--rules", name, "--plugins", folder])
    assert_named(done.exit_code, done.stdout, done.stderr, "mine", words)


def test_what_a_plugin_prints_is_no_part_of_the_answer(tmp_path: Path) -> None:
    folder = write(tmp_path, rule(PRINTS, "print('loud'); print('loud', file=sys.__stdout__)\n    return whole(s)"))
    done = CliRunner().invoke(cli, ["analyze", LEGS, "--json", "--plugins", folder])
    assert json.loads(done.stdout)["condition"]["kind"] == "three-tetrahedra"
    assert done.stderr.count("loud") >= 4


@pytest.mark.skipif(sys.platform == "win32", reason="needs a timer signal")
@pytest.mark.parametrize(
    ("body", "limit"),
    [
        ("while True: pass", "0.2"),
        ("import time; time.sleep(3600)", "0.7"),
        ("import itertools; return [None for _ in itertools.count()]", "0.2"),
        ("while True: bracket(*points('abcd'))", "0.2"),
    ],
)
def test_a_plugin_that_does_not_end_is_stopped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, body: str, limit: str
) -> None:
    monkeypatch.setattr(foreign, "SECONDS", 0.2)
    monkeypatch.setattr(foreign, "WAITING", 0.7 if "sleep" in body else 1000.0)
    done = CliRunner().invoke(cli, ["analyze", LEGS, "--plugins", write(tmp_path, rule(body=body))])
    assert_named(done.exit_code, done.stdout, done.stderr, "rules.py:6", f"it does not end within {limit} seconds")


def test_a_machine_that_runs_something_else_meanwhile_is_no_fault_of_the_plugin(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Asleep, as the whole process is where it is not given the machine: time passes, and nothing is computed."""
    monkeypatch.setattr(foreign, "SECONDS", 0.2)
    asleep = rule(body="import time; time.sleep(0.5); return whole(s)")
    done = CliRunner().invoke(cli, ["analyze", LEGS, "--json", "--plugins", write(tmp_path, asleep)])
    assert json.loads(done.stdout)["condition"]["kind"] == "three-tetrahedra", done.stderr


def test_a_limit_of_the_caller_is_no_fault_of_the_plugin() -> None:
    from gcrules.core.budget import checkpoint, within

    def wait() -> None:
        with foreign.foreign("what", "where"):
            while True:
                checkpoint()

    with within(seconds=0), pytest.raises(LimitReached):
        wait()


# what only a process of its own shows
PROCESS = {
    "a thread at import": (THREAD + "\n" + START.format(False), "", "it leaves a thread running"),
    "a thread": (THREAD, START.format(False), "it leaves a thread running"),
    "a daemon thread": (THREAD, START.format(True), "it leaves a thread running"),
    "closes file 1": ("import os", "os.close(1); 1 / 0", "ZeroDivisionError"),
    "closes stdout and prints": ("import sys", "sys.__stdout__.close(); print('loud'); 1 / 0", "ZeroDivisionError"),
    "writes to file 1": ("import os", "os.write(1, b'loud\\n'); os.system('echo loud'); 1 / 0", "ZeroDivisionError"),
    "prints at exit": ("import atexit; atexit.register(print, 'loud')", "1 / 0", "ZeroDivisionError"),
    "swallows everything": (
        "import time",
        "while True:\n        try:\n            time.sleep(9)\n        except BaseException:\n            pass",
        "it does not end within 0.3 seconds",
    ),
}
SHORT = (
    "import gcrules.rules.foreign as f; f.WAITING, f._AGAIN, f._LAST = 0.3, 0.05, 3\n"
    "from gcrules.apps.main import main; main()"
)


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals and a shell")
@pytest.mark.parametrize("name", PROCESS)
def test_a_process_survives_its_plugin(tmp_path: Path, name: str) -> None:
    imports, body, words = PROCESS[name]
    command = [sys.executable, "-c", SHORT if "swallows" in name else "from gcrules.apps.main import main; main()"]
    done = subprocess.run(
        [*command, "analyze", LEGS, "--json", "--plugins", write(tmp_path, rule(imports, body))],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert_named(done.returncode, done.stdout, done.stderr, "rules.py", words)


PACKAGES = {
    "no such name": ("broken:NOTHING", "", "package broken cannot be loaded: AttributeError"),
    "no such module": ("nowhere:PLUGIN", "", "package broken cannot be loaded: ModuleNotFoundError"),
    "no name at all": ("what is this?", "", "package broken cannot be loaded"),
    "None": ("broken:PLUGIN", "PLUGIN = None", "broken:PLUGIN is not a gcrules.Plugin but NoneType"),
    "rules that are None": (
        "broken:PLUGIN",
        "from gcrules.rules.plugins import Plugin\nPLUGIN = Plugin(rules=None)",
        "package broken cannot be loaded: InputError: gc.Plugin: `rules` must be a sequence of rules, got None",
    ),
    "files that are numbers": (
        "broken:PLUGIN",
        "from gcrules.rules.plugins import Plugin\nPLUGIN = Plugin(rule_files=(1,))",
        "`rule_files` must be a sequence of names of files, got a tuple of 1 that holds 1",
    ),
    "ends the program": ("broken:PLUGIN", "raise SystemExit(0)", "package broken cannot be loaded: SystemExit: 0"),
}


@pytest.mark.parametrize("name", PACKAGES)
def test_a_package_is_the_culprit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    entry, code, words = PACKAGES[name]
    about = tmp_path / "broken-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: broken\nVersion: 1.0\n", encoding="utf-8")
    (about / "entry_points.txt").write_text(f"[gcrules.plugins]\nbroken = {entry}\n", encoding="utf-8")
    (tmp_path / "broken.py").write_text(code, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "broken", raising=False)
    installed.cache_clear()
    try:
        for command in COMMANDS[:1] + COMMANDS[6:7]:
            done = CliRunner().invoke(cli, command)
            assert_named(done.exit_code, done.stdout, done.stderr, "broken", words)
    finally:
        installed.cache_clear()


def test_rules_are_checked_by_their_ids() -> None:
    done = CliRunner().invoke(cli, ["rules", "check", "four-planes", "shared_line"])
    assert done.exit_code == 0
    assert "2 rules: 2 hold" in done.stdout
    done = CliRunner().invoke(cli, ["rules", "check", "four-plane"])
    assert (done.exit_code, "did you mean four-planes" in done.stderr) == (2, True)


def test_the_whole_counterexample_is_shown(tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    path.write_text("rule mine: ab /\\ cd => -[abcd]\n", encoding="utf-8")
    done = CliRunner().invoke(cli, ["rules", "check", str(path)])
    assert done.exit_code == 1
    assert "where the left side is" in done.stdout
    assert "…" not in done.stdout
