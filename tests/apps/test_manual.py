"""Manual mode on the command line and at its prompt."""

from __future__ import annotations

import json
import os
import re
import select
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from commands import Run
from conditions.by_hand import played

from gcrules.conditions.manual import load_session, save_session
from gcrules.conditions.manual.file import parse_session, session_yaml
from gcrules.core.errors import FileError, InputError, LimitReached

OCTAHEDRON = "ab af cb cd ed ef"
LINES = "Aa Ab Ba Bb Cc Dd"


def test_what_is_not_decided_is_possible(run: Run, tmp_path: Path) -> None:
    """A line whose test fails where a repeated point can hide a term: kept, neither confirmed nor refused."""
    session = played(OCTAHEDRON, "plane abc", "pair a c")
    outcome = session.outcome
    assert outcome is not None
    assert (outcome.answer, outcome.confirmed, outcome.possible, outcome.refused) == ("possible", False, True, False)
    words = "line ac: P(a,c) + P(c,a) is not zero, but a repeated point can hide a vanished term"
    assert outcome.text() == f"possible: {words}; a condition made of it is proved or refused"
    assert session.to_json()["history"][-1]["answer"] == "possible"
    assert [e.points for e in session.board.starred] == [("a", "b", "c"), ("a", "c")]
    with pytest.raises(InputError, match="line ac is already on the board"):
        session.pair("a c")
    assert session.undo().board == played(OCTAHEDRON, "plane abc").board
    assert session.undo().redo() == session
    assert "answer: possible, reason: trial" in session_yaml(session)
    for kept in (session, session.undo(), session.plane("abd")):
        path = tmp_path / "session.yaml"
        save_session(kept, path)
        assert load_session(path) == kept
    with pytest.raises(FileError, match="is possible now"):
        parse_session(session_yaml(session).replace("answer: possible", "answer: confirmed"))
    result = run("analyze", OCTAHEDRON, "--manual", *proposals("plane abc", "pair a c", "history"))
    assert result.exit_code == 0
    assert f"possible: {words}" in result.output
    assert "2  possible   pair a c" in result.output


# --- the command line ----------------------------------------------------------------------------------------------


def proposals(*commands: str) -> tuple[str, ...]:
    return tuple(word for command in commands for word in ("--propose", command))


CLI = [
    ("confirmed", ("plane abc",), 0, "confirmed: plane abc"),
    ("refused", ("plane abc", "plane abd"), 1, "refused: term 2"),
    ("finished", ("auto", "statement"), 0, "The robot is singular exactly when the four planes"),
    ("malformed", ("plane abc", "plane abx"), 2, "error: <input>:1:9: x is not a point of the legs"),
    ("misspelt", ("tetraheron abcd",), 2, "did you mean tetrahedron?"),
    ("quit", ("quit", "nonsense"), 0, "left over"),
    ("views", ("show", "left", "hint", "suggest", "orders", "history", "help"), 0, "nothing was proposed yet"),
    ("statement too early", ("statement",), 2, "no condition is confirmed yet"),
]  # fmt: skip


@pytest.mark.parametrize(("commands", "code", "words"), [c[1:] for c in CLI], ids=[c[0] for c in CLI])
def test_cli(run: Run, commands: tuple[str, ...], code: int, words: str) -> None:
    result = run("analyze", OCTAHEDRON, "--manual", *proposals(*commands))
    assert result.exit_code == code, result.output
    assert words in result.output
    script = run("analyze", OCTAHEDRON, "--manual", input="# a script\n\n" + "\n".join(commands) + "\n")
    assert script.exit_code == code
    assert words.replace("<input>:1", f"<stdin>:{len(commands) + 2}") in script.output


def test_limits(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What cannot be decided is neither confirmed nor refused, and what was confirmed before stays saved."""

    def limited(*_: Any, **__: Any) -> None:
        raise LimitReached("more than 0 terms", hint="raise the limit")

    monkeypatch.setattr("gcrules.conditions.manual.conditions.straighten", limited)
    path = str(tmp_path / "session.yaml")
    result = run(
        "analyze", OCTAHEDRON, "--session", path, *proposals("plane abc", r"condition abc /\ aef /\ bdf /\ cde")
    )
    assert result.exit_code == 3
    assert "more than 0 terms" in result.stderr
    assert [r.command for r in load_session(path).history] == ["plane abc"]


def test_cli_json(run: Run) -> None:
    result = run(
        "analyze",
        OCTAHEDRON,
        "--manual",
        "--json",
        *proposals("plane abc", "show", "plane abd", "undo", "auto", "undo"),
    )
    assert result.exit_code == 1
    assert result.stdout.isascii()
    found = json.loads(result.stdout)
    assert found["schema"] == 1
    assert found["legs"] == [list(leg) for leg in OCTAHEDRON.split()]
    assert [h["answer"] for h in found["history"]] == ["confirmed"] * 4
    assert found["undone"] == ["condition"]
    assert found["hint"] == {"command": "condition", "why": "all entities are there"}
    assert found["condition"] is None
    assert [e["kind"] for e in found["entities"]] == ["plane"] * 4
    fault = run("analyze", OCTAHEDRON, "--manual", "--json", *proposals("plane xyz"))
    assert (fault.exit_code, fault.stdout) == (2, "")


def test_cli_sessions(run: Run, tmp_path: Path) -> None:
    path = str(tmp_path / "session.yaml")
    assert (
        run("analyze", OCTAHEDRON, "--session", path, input="plane abc\nplane abd\nplane bdf\nplane abx\n").exit_code
        == 2
    )
    assert [r.command for r in load_session(path).history] == ["plane abc", "plane abd", "plane bdf"]
    assert run("analyze", "--session", path, *proposals("auto")).exit_code == 0
    assert load_session(path).confirmed is not None
    assert run("analyze", OCTAHEDRON, "--session", path, *proposals("undo")).exit_code == 0
    assert load_session(path).confirmed is None
    other = run("analyze", LINES, "--session", path, *proposals("undo"))
    assert other.exit_code == 2
    assert "about other legs" in other.stderr
    assert run("analyze", "--session", path, "--order", "6 5 4 3 2 1", *proposals("undo")).exit_code == 2
    copy = str(tmp_path / "copy.yaml")
    assert run("analyze", "--session", path, *proposals(f"save {copy}")).exit_code == 0
    assert load_session(copy) == load_session(path)


USAGE = [
    ("no legs", ("analyze",), "Missing argument"),
    ("no session", ("analyze", "--session", "missing.yaml", "--propose", "show"), "there is no such session file"),
    ("no legs for manual", ("analyze", "--manual", "--propose", "show"), "legs are missing"),
    ("latex", ("analyze", OCTAHEDRON, "--manual", "--latex"), "Manual mode goes with"),
    ("recheck", ("analyze", OCTAHEDRON, "--manual", "--recheck"), "Manual mode goes with"),
    ("legs from standard input", ("analyze", "-", "--manual"), "standard input holds the commands"),
    ("output", ("analyze", OCTAHEDRON, "--manual", "-o", "x.txt"), "--output goes with --json"),
    ("no directory", ("analyze", OCTAHEDRON, "--session", "missing/x.yaml", "--propose", "show"), "no such directory"),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "words"), [u[1:] for u in USAGE], ids=[u[0] for u in USAGE])
def test_usage(run: Run, arguments: tuple[str, ...], words: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert words in result.stderr


def test_geometry_files_give_legs(run: Run, root: Path) -> None:
    result = run("analyze", str(root / "examples" / "octahedral.yaml"), *proposals("auto"))
    assert result.exit_code == 0
    assert "four planes" in result.output


def test_ascii(run: Run) -> None:
    result = run("analyze", OCTAHEDRON, "--manual", "--ascii", *proposals("auto", "show"))
    assert result.stdout.isascii()


def test_prompt(tmp_path: Path) -> None:
    """On a terminal: an answer, a fault, Ctrl-C in the middle of a line, Ctrl-D; all without a traceback."""
    path = tmp_path / "session.yaml"
    master, slave = pytest.importorskip("pty").openpty()
    code = "from gcrules.apps.main import main; main()"
    process = subprocess.Popen(
        [sys.executable, "-c", code, "analyze", OCTAHEDRON, "--manual", "--session", str(path)],
        stdin=slave, stdout=slave, stderr=slave, start_new_session=True, preexec_fn=_controlling,
    )  # fmt: skip
    os.close(slave)
    seen = ""
    for text, answer in (
        (b"", r"Ctrl-D ends\s+> $"),
        (b"plane abc\n", "confirmed: plane abc.*> $"),
        (b"plane abx\n", "not a point.*> $"),
        (b"plane a\x03", "interrupted.*> $"),
        (b"\x04", "the session is in"),
    ):
        seen = _until(master, text, answer)
    while _read(master):
        pass
    os.close(master)
    assert process.wait(timeout=30) == 0
    assert "Traceback" not in seen
    assert [r.command for r in load_session(path).history] == ["plane abc"]


def _controlling() -> None:
    """Make standard input the terminal from which Ctrl-C comes."""
    import fcntl
    import termios

    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


def _read(master: int) -> str:
    try:
        return os.read(master, 4096).decode(errors="replace")
    except OSError:
        return ""


def _until(master: int, text: bytes, words: str) -> str:
    """What the program answers until this pattern is there; Ctrl-C is pressed again if nothing happens, as one that
    comes just before the program begins to read is only seen by the next.
    """
    os.write(master, text)
    seen, end = "", time.monotonic() + 30
    while not re.search(words, seen, re.DOTALL):
        assert time.monotonic() < end, seen
        if select.select([master], [], [], 2)[0]:
            seen += _read(master)
        elif text.endswith(b"\x03"):
            os.write(master, b"\x03")
    assert "Traceback" not in seen
    return seen
