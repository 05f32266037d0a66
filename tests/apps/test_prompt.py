"""The session from a pipe, its history, and the prompt itself."""

from __future__ import annotations

import os
import re
import select
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest
from apps.repl_session import MEET, said
from commands import Run, invoke

from gcrules.apps.repl.answers import worst, wrapped
from gcrules.apps.repl.history import history_path, private_file
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.state import PromptState

# --- without a terminal --------------------------------------------------------------------------------------------


@pytest.fixture
def run() -> Run:
    return partial(invoke, "repl")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", 0),
        ("[abcd] == -[bacd]", 0),
        ("[abcd] == 0", 1),
        ("ab /\\ c", 2),
        (":limit 3\n[[ab,cd,ef,gh,ij,kl]]", 3),
        ("[abcd] == 0\nab /\\ c\nab", 2),
        (":limit 3\n[[ab,cd,ef,gh,ij,kl]]\n[abcd] == 0", 1),
        (":quit\nab /\\ c", 0),
    ],
)
def test_exit_codes(run: Run, text: str, code: int) -> None:
    assert run(input=text).exit_code == code
    assert worst([0, 3, 1, 2, 0]) == 2


def test_a_transcript(run: Run) -> None:
    result = run("--ascii", "--echo", input="points left\n\n[left\n a b c]\n% == 0\n:quit\n[")
    assert result.stdout.splitlines()[:5] == [
        "> points left",
        "> [left",
        "   a b c]",
        "-[a b c left]" if "-[a b c left]" in result.stdout else "[left a b c]",
        "> % == 0",
    ]
    assert result.stdout.splitlines()[-1] == "> :quit"


def test_faults_of_a_pipe_name_the_line_and_go_to_stderr(run: Run) -> None:
    result = run(input="ab\n\nlet p = a +\n  b + cd\nab")
    assert result.exit_code == 2
    assert result.stdout == "ab\nab\n"
    assert result.stderr.startswith("error: <stdin>:4:7: cannot add a line")


def test_a_file_comes_first(run: Run, root: Path, tmp_path: Path) -> None:
    result = run(str(root / "examples" / "plane.gca"), input="[x, y, z] == 0")
    assert (result.exit_code, result.stdout.splitlines()[0]) == (1, "line 4: proved: three-term relation")
    assert run(str(tmp_path / "nosuch.gca")).exit_code == 2


def test_inputs_as_options(run: Run) -> None:
    assert run("--ascii", "-e", "-[abcd]", "-e", "% * 2", input="no [").stdout == "-[abcd]\n-2[abcd]\n"
    assert run("--limit", "3", "-e", "[[ab,cd,ef,gh,ij,kl]]").exit_code == 3


def test_a_pipe_that_is_no_text(run: Run) -> None:
    result = run(input=b"ab\n\xff\nab")
    assert (result.exit_code, result.stdout) == (2, "ab\n") or result.stdout == ""
    assert "<stdin>: this is not text in UTF-8 (byte 1, line 2)" in result.stderr


def test_the_prompt_library_loads_for_the_prompt_only() -> None:
    code = (
        "import sys, gcrules.apps.cli.repl, gcrules.apps.repl.interpreter; from gcrules.apps.cli import cli; "
        "cli(['repl', '-e', '[abcd]'], standalone_mode=False); print(*sys.modules)"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"prompt_toolkit", "sympy", "matplotlib"} & set(loaded)
    code = "import sys, gcrules.apps.cli; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "gcrules.apps.repl" not in loaded


def test_long_sums_are_broken_before_signs() -> None:
    assert wrapped("a + b − c", 6) == "a + b\n  − c"
    assert wrapped("[abcdefgh] + b", 6) == "[abcdefgh]\n  + b"
    assert wrapped("short\nab + cd", 6) == "short\nab\n  + cd"


# --- history -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("environment", "platform", "expected"),
    [
        ({"HOME": "/h"}, "linux", "/h/.local/state/gcrules/history"),
        ({"HOME": "/h", "XDG_STATE_HOME": "/s"}, "linux", "/s/gcrules/history"),
        ({"HOME": "/h", "XDG_STATE_HOME": "relative"}, "linux", "/h/.local/state/gcrules/history"),
        ({"HOME": "/h"}, "darwin", "/h/Library/Application Support/gcrules/history"),
        ({"HOME": "/h", "LOCALAPPDATA": "/l"}, "win32", "/l/gcrules/history"),
        ({"GCRULES_HISTORY": "/x/y"}, "linux", "/x/y"),
        ({"GCRULES_HISTORY": ""}, "linux", None),
    ],
)
def test_place_of_the_history(environment: dict[str, str], platform: str, expected: str | None) -> None:
    found = history_path(environment, platform)
    assert (found.as_posix() if found else None) == expected


def test_the_history_is_private(tmp_path: Path) -> None:
    path = tmp_path / "state" / "history"
    assert private_file(path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    path.chmod(0o644)
    assert private_file(path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert not private_file(tmp_path)
    assert not private_file(path / "below")


# --- the prompt ----------------------------------------------------------------------------------------------------

ENTER, ALT_ENTER, TAB, CTRL_C, CTRL_D, UP = "\r", "\x1b\r", "\t", "\x03", "\x04", "\x1b[A"


@pytest.fixture
def typed(repl: Interpreter) -> Callable[[str], list[str]]:
    """`typed(keys)`: the inputs that the prompt hands over; Ctrl-D at the end leaves it."""
    from prompt_toolkit.history import InMemoryHistory
    from prompt_toolkit.input import create_pipe_input
    from prompt_toolkit.output import DummyOutput

    from gcrules.apps.repl.terminal import make_session

    def type_(keys: str) -> list[str]:
        found = []
        with create_pipe_input() as pipe:
            pipe.send_text(keys + CTRL_D)
            session = make_session(repl, input=pipe, output=DummyOutput(), history=InMemoryHistory())
            while True:
                try:
                    found.append(session.prompt())
                except KeyboardInterrupt:
                    found.append("^C")
                except EOFError:
                    return found
                said(repl, found[-1])

    return type_


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        (f"ab{ENTER}", ["ab"]),
        (f"[ab{ENTER}cd]{ENTER}", ["[ab\ncd]"]),
        (f"[ab{ENTER}{ENTER}", ["[ab"]),
        (f"a{ALT_ENTER}+ b{ENTER}", ["a\n+ b"]),
        (f"{ENTER}a{ENTER}", ["", "a"]),
        (f"rule x: ab => ba{ALT_ENTER}if a < b{ENTER}", ["rule x: ab => ba\nif a < b"]),
        (f"ab/\\cd{ENTER}", ["ab∧cd"]),
        (f"a\\/b{ENTER}", ["a∨b"]),
        (f"a \\we{TAB} bcd{ENTER}", ["a ∧ bcd"]),
        (f"a\\dot{TAB}b{ENTER}", ["a\u0307b"]),
        (f"points left right{ENTER}ab le{TAB} ri{TAB}{ENTER}", ["points left right", "ab left right"]),
        (f":unic{TAB} off{ENTER}a/\\b{ENTER}", [":unicode off", "a/\\b"]),
        (f"ab{CTRL_C}cd{ENTER}", ["^C", "cd"]),
        (f"\x1b[200~let p = ab\nlet q = cd\np + q\x1b[201~{ENTER}", ["let p = ab\nlet q = cd\np + q"]),
    ],
    ids=lambda value: ascii(value)[:40],
)
def test_keys(typed: Callable[[str], list[str]], keys: str, expected: list[str]) -> None:
    assert typed(keys) == expected


def test_the_loop(repl: Interpreter, capsys: pytest.CaptureFixture[str]) -> None:
    from prompt_toolkit.history import InMemoryHistory
    from prompt_toolkit.input import create_pipe_input
    from prompt_toolkit.output import DummyOutput

    from gcrules.apps.repl.terminal import make_session, run_terminal

    with create_pipe_input() as pipe:
        pipe.send_text(f"ab/\\cde{ENTER}ab/\\c{ENTER}{CTRL_C}:quit{ENTER}ab{ENTER}")
        run_terminal(repl, make_session(repl, input=pipe, output=DummyOutput(), history=InMemoryHistory()))
    out, err = capsys.readouterr()
    assert out.splitlines()[1:] == ["[acde] · b − [bcde] · a"]
    assert err.splitlines()[1:3] == ["  ab∧c", "  ^^^^"]


def test_no_fault_ends_the_session(
    repl: Interpreter, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import gcrules.rules.script
    from gcrules.apps.repl.terminal import respond

    for error, words in (
        (KeyboardInterrupt(), "interrupted"),
        (MemoryError(), "not enough memory"),
        (RuntimeError("broken"), "a fault of gcrules, not of your input; please report it: RuntimeError: broken"),
    ):

        def broken(*args: object, error: BaseException = error, **options: object) -> None:
            raise error

        monkeypatch.setattr(gcrules.rules.script, "expand", broken)
        respond(repl, "show [abcd]")
        out, err = capsys.readouterr()
        assert out == ""
        assert words in err
        assert "Traceback" not in err
    assert repl.state == PromptState()


class Interrupted:
    """Is interrupted while it is collected, where Python only prints exceptions."""

    def __del__(self) -> None:
        signal.raise_signal(signal.SIGINT)
        time.sleep(0)  # here at the latest


def pause() -> None:
    """Long enough for an interrupt; on Windows in pieces, since one delivered again does not end a system call."""
    for _ in range(200 if sys.platform == "win32" else 1):
        time.sleep(0.1 if sys.platform == "win32" else 20)
    raise AssertionError("not interrupted")


def test_an_interrupt_in_a_destructor_is_not_lost(capsys: pytest.CaptureFixture[str]) -> None:
    from gcrules.core.interrupts import interruptible

    def compute() -> None:
        with interruptible():
            Interrupted()
            pause()

    before = sys.unraisablehook
    for _ in range(3):
        with pytest.raises(KeyboardInterrupt):
            compute()
        assert sys.unraisablehook is before
    assert "Exception ignored" not in capsys.readouterr().err


def test_an_interrupt_of_what_is_collected_first_is_not_lost(
    repl: Interpreter, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import gcrules.rules.script
    from gcrules.apps.repl.terminal import respond

    monkeypatch.setattr(gcrules.rules.script, "expand", lambda *args, **options: pause())
    left = Interrupted()
    left.itself = left  # type: ignore[attr-defined]
    del left
    respond(repl, "show [abcd]")
    assert "interrupted; what is declared stays" in capsys.readouterr().err


def test_other_faults_of_destructors_are_still_told(monkeypatch: pytest.MonkeyPatch) -> None:
    from gcrules.core.interrupts import interruptible

    class Broken:
        def __del__(self) -> None:
            raise ValueError("broken")

    told: list[type[BaseException]] = []
    monkeypatch.setattr(sys, "unraisablehook", lambda ignored: told.append(ignored.exc_type))
    with interruptible():
        Broken()
    assert told == [ValueError]


def test_toolbar(repl: Interpreter) -> None:
    from gcrules.apps.repl.terminal import toolbar

    assert toolbar(repl) == " rank 4"
    said(repl, f"points left right\ngiven collinear(a, b, c)\nlet p = a\n{MEET}")
    assert toolbar(repl) == " rank 4 · 2 points · given collinear(a, b, c) · let p · 1 rule"


def test_history_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from gcrules.apps.repl import terminal

    path = tmp_path / "history"
    monkeypatch.setenv("GCRULES_HISTORY", str(path))
    terminal._history().store_string("[ab\ncd]")
    assert list(terminal._history().load_history_strings()) == ["[ab\ncd]"]
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    monkeypatch.setenv("GCRULES_HISTORY", str(tmp_path))  # a folder
    terminal._history().store_string("x")


class Terminal:
    """A process on a terminal of its own."""

    def __init__(self, *arguments: str, env: dict[str, str]) -> None:
        import fcntl
        import pty
        import struct
        import termios

        self.child, self.handle = pty.fork()
        if self.child == 0:  # pragma: no cover
            code = "from gcrules.apps.main import main; main()"
            os.execve(sys.executable, [sys.executable, "-c", code, "repl", *arguments], os.environ | env)
        fcntl.ioctl(self.handle, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 100, 0, 0))
        self.shown = ""

    def until(self, words: str, timeout: float = 60) -> str:
        """Wait for these words and give what was shown up to now, without control sequences."""
        end = time.monotonic() + timeout
        while words not in self.plain:
            assert time.monotonic() < end, f"{words!r} not in {self.plain!r}"
            if select.select([self.handle], [], [], 0.1)[0]:
                self._read()
        shown, self.shown = self.plain, ""
        return shown

    @property
    def plain(self) -> str:
        return re.sub(r"\x1b\[[0-9;?>]*[A-Za-z]", "", self.shown)

    def _read(self) -> bool:
        try:
            chunk = os.read(self.handle, 65536)
        except OSError:
            return False
        if b"\x1b[6n" in chunk:  # where is the cursor?
            os.write(self.handle, b"\x1b[1;1R")
        self.shown += chunk.decode("utf-8", errors="replace")
        return bool(chunk)

    def type(self, keys: str) -> None:
        os.write(self.handle, keys.encode())

    def leave(self) -> int:
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if select.select([self.handle], [], [], 0.1)[0] and not self._read():
                break
        else:
            os.kill(self.child, signal.SIGKILL)
        status = os.waitpid(self.child, 0)[1]
        os.close(self.handle)
        return os.waitstatus_to_exitcode(status)


@pytest.mark.skipif(sys.platform == "win32", reason="needs a pseudo-terminal")
def test_on_a_terminal(tmp_path: Path) -> None:
    history = tmp_path / "history"
    env = {"TERM": "xterm", "GCRULES_HISTORY": str(history), "PYTHONIOENCODING": "utf-8", "NO_COLOR": "1"}
    terminal = Terminal(env=env)
    terminal.until(":help says what can be typed")
    terminal.until("rank 4")
    terminal.type("let p = [ab\rcd]\r")
    terminal.until("p = [abcd], a scalar (step 0)")
    terminal.type("ab/\\c\r")
    terminal.until("did you mean a join")
    terminal.type("*".join(["(abc ^ def ^ ghi ^ jkl)"] * 40) + "\r")
    terminal.until("computing … 1 s")
    os.kill(terminal.child, signal.SIGINT)
    terminal.until("interrupted; what is declared stays")
    terminal.type("2p\r")
    assert "Traceback" not in terminal.until("2[abcd]")
    terminal.until("rank 4")
    terminal.type(UP + UP)
    terminal.until("jkl")
    terminal.type(CTRL_C)
    terminal.until("rank 4")
    terminal.type(CTRL_D)
    assert terminal.leave() == 0
    assert "+let p = [ab\n+cd]\n" in history.read_text(encoding="utf-8")
    assert stat.S_IMODE(history.stat().st_mode) == 0o600
