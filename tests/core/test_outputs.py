"""Output files: names that will not do, two outputs in one place, and that nothing is written without an answer."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from gcrules.apps.cli import cli
from gcrules.core.errors import FileError
from gcrules.core.files import check_target, held, replacing, write_file

LEGS = "ab af cb cd ed ef"
PATH = ("path", "ROBOT", "--at", "0 0 0", "--at", "0 0 -3", "--samples", "2")
MAP = ("map", "ROBOT", "--over", "x -1:1:3", "--over", "y -1:1:3", "--measure", "value")
# commands, each to be followed by the name of a file
OUTPUTS = {
    "expand -o": ("expand", "[abcd]", "-o"),
    "prove -o": ("prove", "[abcd] == [abcd]", "--output"),
    "analyze -o": ("analyze", LEGS, "-o"),
    "analyze --figure": ("analyze", LEGS, "--figure"),
    "report -o": ("report", LEGS, "-o"),
    "run -o": ("run", "SCRIPT", "-o"),
    "rules list -o": ("rules", "list", "-o"),
    "catalog list -o": ("catalog", "list", "-o"),
    "robot new -o": ("robot", "new", "mine", "-o"),
    "path --csv": (*PATH, "--csv"),
    "path --plot": (*PATH, "--plot"),
    "path -o": (*PATH, "-o"),
    "map -o": (*MAP, "-o"),
}
NAMES = {
    "an empty name": ("", "is not the name of a file"),
    "an ending only": (".svg", "an ending without a name"),
    "an ending in a folder": ("sub/.SVG", "an ending without a name"),
    "a surrogate": ("\ud800.svg", "cannot hold the character U+D800"),
    "NUL": ("a\0.svg", "cannot hold the character NUL"),
    "a folder": ("sub.svg", "this is a directory"),
    "a folder that is not there": ("no/such/a.svg", "no such directory"),
    "a file as a folder": ("file/a.svg", "cannot be written"),
    "too long": ("a" * 300 + ".svg", "name too long"),
}


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, root: Path) -> Path:
    """A folder with a file, two folders, a script that is not decided, and a robot; commands run in it."""
    for name in ("sub", "sub.svg"):
        (tmp_path / name).mkdir()
    (tmp_path / "file").write_text("mine", encoding="utf-8")
    (tmp_path / "script.gca").write_text(SCRIPT, encoding="utf-8")
    (tmp_path / "robot.yaml").write_bytes((root / "examples" / "platform-6-3.yaml").read_bytes())
    monkeypatch.chdir(tmp_path)
    return tmp_path


SCRIPT = "claim [abcd] == [abcd]\n"


def run(*words: str) -> Any:
    given = [{"ROBOT": "robot.yaml", "SCRIPT": "script.gca"}.get(w, w) for w in words]
    return CliRunner().invoke(cli, given)


def files(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("command", OUTPUTS)
def test_names_that_will_not_do(here: Path, command: str, name: str) -> None:
    before = files(here)
    path, words = NAMES[name]
    done = run(*OUTPUTS[command], path)
    assert (done.exit_code, done.stdout) == (2, ""), done.stderr
    assert words.lower() in done.stderr.lower() or ("map" in command and "not a kind of output" in done.stderr)
    assert "Traceback" not in done.stderr
    assert files(here) == before


PATHS = [
    ("pose", "{}.yaml"),
    ("path", "robot.yaml", "--poses", "{}.csv"),
    ("map", "{}.yaml", "--over", "x 0:1:3", "--over", "y 0:1:3"),
    ("locus", "{}.yaml"),
    ("modes", "{}.yaml"),
    ("analyze", "{}.yaml"),
    ("analyze", LEGS, "--catalog", "{}.yaml"),
    ("analyze", LEGS, "--rules", "{}.gca"),
    ("analyze", LEGS, "--plugins", "{}"),
    ("analyze", LEGS, "--session", "{}.yaml", "--propose", "hint"),
    ("report", "{}.yaml"),
    ("run", "{}.gca"),
    ("repl", "{}.gca"),
    ("rules", "check", "{}.gca"),
    ("rules", "list", "--plugins", "{}"),
    ("catalog", "show", "6-3.2", "--catalog", "{}.yaml"),
    ("catalog", "list", "--plugins", "{}"),
    ("robot", "analyze", "{}.yaml"),
    ("robot", "check", "{}.yaml"),
    ("robot", "list", "--plugins", "{}"),
    ("robot", "new", "{}"),
    ("studio", "{}.yaml", "--no-browser"),
]


@pytest.mark.parametrize("name", ["\ud800", "a\0b", "a" * 300], ids=["surrogate", "NUL", "long"])
@pytest.mark.parametrize("command", PATHS, ids=" ".join)
def test_inputs_that_are_no_names(here: Path, command: tuple[str, ...], name: str) -> None:
    done = run(*(w.replace("{}", name) for w in command))
    assert done.exit_code == 2, (done.stderr, done.exception)
    assert "Traceback" not in done.stderr


CLASHES = {
    "two on standard output": ((*PATH, "--csv", "-", "--json"), "--csv - and --json cannot both go to standard output"),
    "two named so": ((*PATH, "--csv", "-", "-o", "-"), "are one file"),
    "one name": ((*PATH, "--csv", "a.txt", "-o", "a.txt"), "--csv a.txt and --output a.txt are one file"),
    "two names of one file": ((*PATH, "--csv", "sub/../file", "-o", "file"), "are one file"),
    "two outputs of a map": ((*MAP, "-o", "a.json", "-o", "./a.json"), "are one file"),
    "figure and answer": (("analyze", LEGS, "--figure", "a.svg", "-o", "a.svg"), "are one file"),
    "over the robot": ((*PATH, "-o", "robot.yaml"), "--output robot.yaml would overwrite what is read"),
    "values over the robot": ((*PATH, "--csv", "sub/../robot.yaml"), "would overwrite what is read"),
    "over the script": (("run", "SCRIPT", "-o", "script.gca"), "would overwrite what is read"),
    "report over its robot": (("report", "ROBOT", "-o", "robot.yaml"), "would overwrite what is read"),
}


@pytest.mark.parametrize("name", CLASHES)
def test_outputs_that_clash(here: Path, name: str) -> None:
    before = files(here)
    words, says = CLASHES[name]
    done = run(*words)
    assert (done.exit_code, done.stdout) == (2, ""), done.stderr
    assert says in done.stderr
    assert files(here) == before


def test_two_outputs_in_two_places(here: Path) -> None:
    done = run(*PATH, "--csv", "-", "-o", "answer.txt")
    assert done.exit_code == 0
    assert done.stdout.startswith("parameter,")
    assert not (here / "answer.txt").read_text(encoding="utf-8").startswith("parameter")


UNDECIDED = {
    "prove": ("prove", "[[ab,cd,ef,gh,ij,kl]] == -[[cd,ab,ef,gh,ij,kl]]", "--limit", "1"),
    "run": ("run", "SCRIPT", "--limit", "1"),
    "expand": ("expand", "[[ab,cd,ef,gh,ij,kl]]", "--limit", "1"),
}


@pytest.mark.parametrize("form", [(), ("--json",)], ids=["text", "json"])
@pytest.mark.parametrize("name", UNDECIDED)
def test_what_is_not_decided_is_not_written(here: Path, name: str, form: tuple[str, ...]) -> None:
    (here / "script.gca").write_text(f"claim {UNDECIDED['prove'][1]}\n", encoding="utf-8")
    plain, done = run(*UNDECIDED[name], *form), run(*UNDECIDED[name], *form, "-o", "file")
    assert (done.exit_code, done.stdout) == (plain.exit_code, plain.stdout)
    assert done.exit_code == 3
    assert ("file is not written" in done.stderr) is bool(done.stdout)
    assert (here / "file").read_text(encoding="utf-8") == "mine"


def test_a_definite_no_is_written(here: Path) -> None:
    assert run("prove", "[abcd] == 0", "-o", "file").exit_code == 1
    assert "refuted" in (here / "file").read_text(encoding="utf-8")


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
@pytest.mark.parametrize("words", [("--figure", "a.svg", "-o", "/dev/full"), ("-o", "/dev/full", "--json")])
def test_a_file_does_not_appear_without_the_others(here: Path, words: tuple[str, ...]) -> None:
    before = files(here)
    done = run("analyze", LEGS, *words)
    assert done.exit_code == 2
    assert "No space left" in done.stderr
    assert files(here) == before


def process(words: list[str], redirection: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "gcrules", *words]
    shell = ["sh", "-c", f'"$@" {redirection}', "sh", *command]
    return subprocess.run(shell, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)


@pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")
@pytest.mark.parametrize(
    ("words", "redirection", "code"),
    [
        (["expand", "[abcd]"], ">&-", 2),
        (["prove", "[abcd] == 0"], ">&-", 2),
        (["robot", "list"], ">&-", 2),
        (["catalog", "list"], "> /dev/full", 2),
        (["robot", "list", "--json"], "> /dev/full", 2),
        (["prove", "[abcd] == 0"], "> /dev/full", 2),
        (["expand", "-"], "<&-", 2),
        (["prove", "[abcd] == 0"], "2>&-", 1),
        (["expand", "[abcd]", "-o", "/dev/stdout"], "", 0),
    ],
)
def test_standard_streams_that_are_not_there(words: list[str], redirection: str, code: int) -> None:
    done = process(words, redirection)
    assert done.returncode == code, done.stderr
    assert "Traceback" not in done.stderr
    assert "ignored" not in done.stderr
    assert bool(done.stdout) is (code < 2)


@pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")
def test_the_file_of_standard_output_is_an_output_too(here: Path) -> None:
    done = process(["analyze", LEGS, "--figure", "a.svg"], "> a.svg")
    assert done.returncode == 2
    assert "goes to standard output, and so does the answer" in done.stderr


# --- the module itself ---------------------------------------------------------------------------------------------


def test_files_that_are_held_appear_together(here: Path) -> None:
    before = files(here)
    with held():
        write_file("one", "1")
        with replacing("two") as temporary:
            Path(temporary).write_text("2", encoding="utf-8")
        write_file("now", "3", at_once=True)
        assert not Path("one").exists()
        assert Path("now").exists()
    assert files(here) == before | {"one": b"1", "two": b"2", "now": b"3"}


def lost(*_: Any) -> None:
    write_file("one", "1")
    raise KeyboardInterrupt


def test_files_that_are_held_are_lost_together(here: Path) -> None:
    before = files(here)
    with pytest.raises(KeyboardInterrupt), held():
        lost()
    assert files(here) == before


def test_text_that_is_no_unicode_is_written(here: Path) -> None:
    write_file("one", "a\ud800b")
    assert Path("one").read_bytes() == b"a?b"


def test_a_hidden_file_is_a_file(here: Path) -> None:
    check_target(".mine")
    with pytest.raises(FileError):
        check_target(".yaml")
