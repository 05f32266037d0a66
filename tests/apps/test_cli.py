"""The command line: exit codes, faults, arguments, help and completion."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
from commands import Run, shell
from places import EXAMPLES, ROOT

from gcrules.apps.cli import COMMANDS, cli
from gcrules.apps.cli.catalog import COMMANDS as CATALOG_COMMANDS

MANY_TERMS = "([abcd] + [aefg])**30 ([aceg] + [bdfh])**30"

OCTAHEDRON = "ab af cb cd ed ef"

AROUND = (
    str(EXAMPLES / "octahedral.yaml"),
    *("--from", "-36.9 75 87.5; rotvec 85.27 -39.32 115.91 deg"),
    *("--to", "215.1 70.5 125.5; rotvec 2.3 -27.94 46.06 deg"),
)

EXIT_CODES: list[tuple[str, tuple[str, ...], int]] = [
    ("help", ("--help",), 0),
    ("version", ("--version",), 0),
    ("proved", ("prove", r"ab /\ cd == [abcd]"), 0),
    ("refuted", ("prove", "[abcd] == [bacd]"), 1),
    ("undecided", ("prove", f"{MANY_TERMS} == {MANY_TERMS}", "--limit", "100"), 3),
    ("expanded", ("expand", r"ab /\ cde"), 0),
    ("too many terms", ("expand", MANY_TERMS, "--limit", "100"), 3),
    ("too many dots", ("expand", "[.a.b.c.d][.e.f.g.h][.i.j.k.l][.m.n.o.p]"), 3),
    ("straightened", ("straighten", "[afgl][behk][cdij]"), 0),
    ("analysed", ("analyze", OCTAHEDRON), 0),
    ("always singular", ("analyze", "Aa Ba Ca Ab Bb Cb"), 0),
    ("outside the catalog", ("analyze", "ab bc ca de ef fd"), 0),
    ("listed", ("catalog", "list"), 0),
    ("shown", ("catalog", "show", "6-3.2"), 0),
    ("a way", ("plan", "3-rpr", "--from", "home", "--to", "x=0.1, y=0, yaw=0deg"), 0),
    ("no way", ("plan", "3-rpr", "--from", "home", "--to", "x=0, y=0, yaw=60deg"), 1),
    ("aspects", ("aspects", "examples/octahedral.yaml", "--poses", "2", "--no-modes"), 0),
    ("aspects not decided", ("aspects", "examples/octahedral.yaml", "--poses", "1", "--states", "9"), 3),
    ("regions", ("regions", "3-rpr", "--over", "q2 2..2.1, q3 2..2.1"), 0),
    ("regions not decided", ("regions", "3-rpr", "--over", "q1 2..3, q2 2..2.1, q3 2..2.1", "--slices", "2"), 3),
    ("no way known", ("plan", *AROUND, "--states", "1"), 3),
    ("syntax", ("expand", "[abcd"), 2),
    ("steps", ("expand", "[abc]"), 2),
    ("nested too deeply", ("expand", "(" * 20_000), 2),
    ("too large", ("expand", "a" * 1_000_000), 2),
    ("five legs", ("analyze", "ab af cb cd ed"), 2),
    ("a leg from a point to itself", ("analyze", "aa af cb cd ed ef"), 2),
    ("unlike steps", ("prove", "ab == c"), 2),
    ("no equation", ("prove", "ab"), 2),
    ("rank", ("expand", "a", "--rank", "9"), 2),
    ("names", ("expand", "a", "--points", "left-right"), 2),
    ("steps of an extensor", ("straighten", "ab", "--steps"), 2),
    ("no such class", ("catalog", "show", "7-7"), 2),
    ("no such file", ("analyze", "missing.yaml"), 2),
    ("no such script", ("run", "missing.gca"), 2),
    ("no such catalog", ("catalog", "list", "--catalog", "missing.yaml"), 2),
    ("no such command", ("analyse", OCTAHEDRON), 2),
    ("no such option", ("expand", "a", "--jsn"), 2),
    ("no argument", ("expand",), 2),
    ("two arguments", ("expand", "a", "b"), 2),
    ("two forms", ("expand", "a", "--json", "--latex"), 2),
    ("a wrong number", ("expand", "a", "--limit", "none"), 2),
    ("an order of five legs", ("analyze", OCTAHEDRON, "--order", "1 2 3 4 5"), 2),
    ("no directory", ("expand", "a", "-o", "missing/x.txt"), 2),
    ("figure of another kind", ("analyze", OCTAHEDRON, "--figure", "x.bmp"), 2),
]


@pytest.mark.parametrize(("arguments", "code"), [e[1:] for e in EXIT_CODES], ids=[e[0] for e in EXIT_CODES])
def test_exit_code(run: Run, arguments: tuple[str, ...], code: int) -> None:
    result = run(*arguments)
    assert result.exit_code == code, result.output
    if code == 2:
        assert result.stdout == ""
        assert result.stderr
        assert len(result.stderr) < 2_000
    else:
        assert result.stdout or code == 3


@pytest.mark.parametrize(
    "arguments",
    [
        ("expand", "[abc]", "--json"),
        ("prove", "ab == c", "--json"),
        ("analyze", "ab", "--json"),
        ("catalog", "show", "7", "--json"),
    ],
    ids=lambda a: a[0],
)
def test_faults_go_to_stderr_with_json_too(run: Run, arguments: tuple[str, ...]) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith("error: ")


def test_fault_shows_place_caret_and_hint(run: Run) -> None:
    assert run("expand", "[abc] [abcd]").stderr.splitlines() == [
        "error: <input>:1:1: a bracket of 3 points, expected 4 in rank 4",
        "  [abc] [abcd]",
        "  ^^^^^",
        "hint: for another rank say so: `rank 3` in a file, --rank 3 in the shell",
    ]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("analyse", OCTAHEDRON), "Did you mean analyze"),
        (("straigthen", "a"), "Did you mean straighten?"),
        (("catalog", "lst"), "Did you mean list?"),
        (("xyzzy",), "There are analyze, pose, path, "),
        (("expand", "a", "--jsno"), "--json"),
        (("catalog", "show", "6-3"), "did you mean 6-3.2 or 6-3.1?"),
    ],
)
def test_suggestions(run: Run, arguments: tuple[str, ...], words: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert words in result.stderr


# --- arguments -----------------------------------------------------------------------------------------------------

MINUS = [
    ("bracket", ("expand", "-[abcd][efgh]"), "-[abcd][efgh]"),
    ("letters", ("expand", "-abc"), "-abc"),
    ("one letter", ("expand", "-a"), "-a"),
    ("a letter that is an option", ("expand", "-of"), "fo"),
    ("two signs", ("expand", "--[abcd]"), "[abcd]"),
    ("two signs and a letter", ("expand", "--a"), "a"),
    ("parenthesis", ("expand", "-(ab)"), "-ab"),
    ("digit", ("expand", "-2a"), "-2 * a"),
    ("option after it", ("expand", "-[abc]", "--rank", "3"), "-[abc]"),
    ("option before it", ("expand", "--rank=3", "-[abc]"), "-[abc]"),
    ("an option's value like an option", ("expand", "--points", "c b a", "-[abcd]"), "[cbad]"),
    ("after two dashes", ("expand", "--ascii", "--", "-o"), "-o"),
]


@pytest.mark.parametrize(("arguments", "expected"), [m[1:] for m in MINUS], ids=[m[0] for m in MINUS])
def test_arguments_that_begin_with_a_minus_sign(run: Run, arguments: tuple[str, ...], expected: str) -> None:
    command, *rest = arguments
    result = run(command, *(() if "--ascii" in rest else ("--ascii",)), *rest)
    assert (result.exit_code, result.stdout) == (0, expected + "\n"), result.stderr


def test_claims_that_begin_with_a_minus_sign(run: Run) -> None:
    assert run("prove", r"-ab /\ cd == 0").exit_code == 1
    assert run("prove", r"-ab /\ cd == -[abcd]").exit_code == 0
    assert run("straighten", "-[abcd]", "--json").exit_code == 0


def test_points_and_ideal(run: Run) -> None:
    names = ("--points", "left, right top base")
    assert run("expand", "[left right top base]", *names, "--ascii").stdout == "[left right top base]\n"
    assert run("expand", "[baseleftrighttop]", *names, "--ascii").stdout == "-[left right top base]\n"
    assert run("expand", "[ijkl]", "--ideal", "i j k l").stdout == "0\n"
    assert run("prove", "[ijkl] == 0", "--ideal", "i,j,k,l").exit_code == 0
    assert run("prove", "[ijkl] == 0").exit_code == 1
    assert "declared twice" in run("expand", "a", "--points", "a b a").stderr


def test_legs_need_no_quotes(run: Run) -> None:
    one = run("analyze", OCTAHEDRON, "--json")
    assert run("analyze", *OCTAHEDRON.split(), "--json").stdout == one.stdout
    assert run("analyze", "left top", "--json").exit_code == 2
    long = "left top, left base, right top, right front, back front, back base"
    answer = json.loads(run("analyze", long, "--points", "left right back top base front", "--json").stdout)
    assert answer["class"] == "3-3.3"
    assert answer["legs"][0] == ["left", "top"]


@pytest.mark.parametrize("command", ["expand", "straighten"])
def test_standard_input(run: Run, command: str) -> None:
    assert run(command, "-", "--ascii", input="[abcd]\n - 2[abce]\n").stdout == "[abcd] - 2[abce]\n"


def test_standard_input_of_other_commands(run: Run, root: Path) -> None:
    assert run("prove", "-", input="[abcd]\n==\n[bacd]").exit_code == 1
    assert run("run", "-", input="claim a == a").exit_code == 0
    legs = json.loads(run("analyze", "-", "--json", input=OCTAHEDRON + "\n").stdout)
    file = (root / "examples" / "octahedral.yaml").read_text(encoding="utf-8")
    assert json.loads(run("analyze", "-", "--json", input=file).stdout) | {"pose": None, "dimensions": None} == legs


@pytest.mark.parametrize(
    "data", [b"\xff\xfe\x00", bytes(range(256)), b"[abcd]" * 10**6], ids=["utf-16", "bytes", "6 MB"]
)
def test_standard_input_that_is_no_text(run: Run, data: bytes) -> None:
    for command in ("expand", "prove", "run", "analyze"):
        result = run(command, "-", input=data)
        assert result.exit_code == 2
        assert result.stderr.startswith("error: <stdin>")


def test_fault_in_standard_input_names_the_place(run: Run) -> None:
    assert "<stdin>:2:6: " in run("run", "-", input="rank 3\nshow [abcd]").stderr


# --- help and completion -------------------------------------------------------------------------------------------

ALL_COMMANDS = [*((name,) for name in COMMANDS), *(("catalog", name) for name in CATALOG_COMMANDS)]


@pytest.mark.parametrize("command", ALL_COMMANDS, ids=" ".join)
def test_help(run: Run, command: tuple[str, ...]) -> None:
    result = run(*command, "--help")
    assert result.exit_code == 0
    assert "\b" not in result.stdout
    assert "\\b" not in result.stdout
    if command != ("catalog",):
        assert f"gcrules {' '.join(command)}" in result.stdout.partition("\n\n")[2]
    assert run(*command, "-h").stdout == result.stdout


@pytest.mark.parametrize("name", COMMANDS)
def test_the_list_of_commands_says_what_each_is_called(run: Run, name: str) -> None:
    assert f"\n  {name} " in run("--help").stdout
    loaded = cli.get_command(None, name)
    assert loaded is not None
    assert loaded.name == name


@pytest.mark.parametrize("kind", ["bash", "zsh", "fish"])
def test_completion_script(run: Run, kind: str) -> None:
    result = run("completion", kind)
    assert result.exit_code == 0
    assert "_GCRULES_COMPLETE" in result.stdout


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("gcrules str", {"plain,straighten"}),
        ("gcrules catalog e", {"plain,enumerate"}),
        ("gcrules expand -ab --j", {"plain,--json"}),
        ("gcrules pose del", {"plain,delta"}),
        ("gcrules analyze 3-rp", {"plain,3-rpr", "plain,3-rps"}),
        ("gcrules map boxes octahedral-", {"plain,octahedral-singular"}),
        ("gcrules catalog show 6-3.", {"plain,6-3.1", "plain,6-3.2"}),
        ("gcrules robot docs --only agile", {"plain,agile-eye"}),
        ("gcrules rules show four-p", {"plain,four-planes"}),
        ("gcrules analyze --without planes,four-p", {"plain,planes,four-planes"}),
        ("gcrules pose delta --about o", {"plain,origin"}),
        ("gcrules locus 3-rpr --rotation r", {"plain,rodrigues"}),
        ("gcrules locus octahedral --over x,tr", {"plain,x,translation"}),
        ("gcrules locus 3-rpr --export ma", {"plain,maple"}),
        ("gcrules map boxes delta --over ro", {"plain,roll"}),
        ("gcrules free delta --over x,act", {"plain,x,actuators"}),
        ("gcrules analyze my-plat", {"file,my-plat"}),
    ],
)
def test_completion(words: str, expected: set[str]) -> None:
    env = {"_GCRULES_COMPLETE": "bash_complete", "COMP_WORDS": words, "COMP_CWORD": str(len(words.split()) - 1)}
    found = shell(env=env)
    assert found.stderr == ""
    assert set(found.stdout.split()) == expected


def test_ids_of_plugins_are_completed_without_running_them(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    (folder / "tripod-of-mine").mkdir(parents=True)
    shutil.copy(ROOT / "plugins" / "3-rps" / "robot.yaml", folder / "tripod-of-mine" / "robot.yaml")
    (folder / "tripod-of-mine" / "rules.py").write_text("raise SystemExit('this ran')", encoding="utf-8")
    words = f"gcrules robot show --plugins {folder} tripod-"
    env = {"_GCRULES_COMPLETE": "bash_complete", "COMP_WORDS": words, "COMP_CWORD": "5"}
    found = shell(env=env)
    assert (found.stdout.strip(), found.stderr) == ("plain,tripod-of-mine", "")
