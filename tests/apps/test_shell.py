"""The command line as a shell sees it: a process, its streams, a terminal, signals."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest
from commands import shell

MANY_TERMS = "([abcd] + [aefg])**30 ([aceg] + [bdfh])**30"

OCTAHEDRON = "ab af cb cd ed ef"


# --- a real shell --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("prove", "[abcd] == -[bacd]"), 0),
        (("prove", "-[abcd] == [abcd]"), 1),
        (("expand", "[abc]"), 2),
        (("expand", MANY_TERMS, "--limit", "9"), 3),
        (("expnd", "a"), 2),
        (("--version",), 0),
    ],
    ids=["proved", "refuted", "input", "undecided", "usage", "version"],
)
def test_exit_codes_of_the_process(arguments: tuple[str, ...], code: int) -> None:
    done = shell(*arguments)
    assert done.returncode == code
    assert "Traceback" not in done.stderr


def test_output_encoding_decides_about_unicode() -> None:
    assert shell("expand", "-a").stdout == "−a\n"
    for encoding in ("ascii", "latin-1"):
        assert shell("expand", "-a", env={"PYTHONIOENCODING": encoding}).stdout == "-a\n"
    done = shell("analyze", OCTAHEDRON, env={"PYTHONIOENCODING": "ascii"})
    assert done.returncode == 0
    assert done.stdout.isascii()


def test_no_colour_in_a_pipe() -> None:
    assert "\x1b" not in shell("prove", "[abcd] == 0").stdout
    assert "\x1b" not in shell("expand", "[abc]").stderr


def in_terminal(*arguments: str, env: dict[str, str]) -> str:
    """What the command writes to a terminal."""
    import pty

    child, terminal = pty.fork()
    if child == 0:  # pragma: no cover
        code = "from gcrules.apps.main import main; main()"
        os.execve(sys.executable, [sys.executable, "-c", code, *arguments], os.environ | env)
    chunks = []
    while True:
        try:
            chunk = os.read(terminal, 65536)
        except OSError:
            break
        if not chunk:
            break
        chunks.append(chunk)
    os.waitpid(child, 0)
    os.close(terminal)
    return b"".join(chunks).decode("utf-8")


def test_colour_on_a_terminal_unless_told_otherwise() -> None:
    plain = {"NO_COLOR": "", "TERM": "xterm"}
    assert "\x1b[" in in_terminal("prove", "[abcd] == 0", env=plain)
    assert "\x1b[" in in_terminal("expand", "[abc]", env=plain)
    assert "\x1b" not in in_terminal("prove", "[abcd] == 0", env=plain | {"NO_COLOR": "1"})
    assert "\x1b" not in in_terminal("expand", "[abc]", env=plain | {"NO_COLOR": "1"})


def test_broken_pipe_is_quiet() -> None:
    code = "from gcrules.apps.main import main; main()"
    with subprocess.Popen(
        [sys.executable, "-c", code, "straighten", "[afgl][behk][cdij]", "--steps"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 141


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs timers")
@pytest.mark.parametrize("unbuffered", ["1", ""])
def test_nothing_is_lost_where_signals_interrupt_writing(unbuffered: str) -> None:
    """Limits ring a timer; a reader that is slow lets it ring amid a write."""
    script = (
        "import signal, sys; from gcrules.core.streams import prepare; prepare()\n"
        "signal.signal(signal.SIGALRM, lambda *_: None); signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)\n"
        "print('x' * 400_000)\n"
        "signal.setitimer(signal.ITIMER_REAL, 0)\n"
    )
    env = os.environ | {"PYTHONUNBUFFERED": unbuffered}
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, env=env) as process:
        assert process.stdout is not None
        number = 0
        while piece := os.read(process.stdout.fileno(), 30_000):
            number += len(piece)
            time.sleep(0.005)
    assert (process.returncode, number) == (0, 400_001)


def test_interrupt_is_quiet() -> None:
    """The expansion takes minutes; the interrupt comes when it has begun."""
    started = (
        "import sys, gcrules.apps.cli.algebra; print('ready', flush=True); from gcrules.apps.main import main; main()"
    )
    long = "*".join(["(abc /\\ def /\\ ghi /\\ jkl)"] * 40)
    with subprocess.Popen(
        [sys.executable, "-c", started, "expand", long, "--limit", "1000000000"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert process.stdout.readline() == b"ready\n"
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        try:
            assert process.communicate(timeout=60) == (b"", b"")
        finally:
            process.kill()
    assert process.returncode == 130


def test_internal_faults_are_not_hidden() -> None:
    code = (
        "import gcrules.apps.cli.algebra as a; from gcrules.apps.main import main\n"
        "def broken(*args, **options): raise RuntimeError('broken')\n"
        "a.expanded = broken; main()"
    )
    done = subprocess.run([sys.executable, "-c", code, "expand", "a"], capture_output=True, text=True)
    assert done.returncode == 70
    assert "RuntimeError: broken" in done.stderr
    assert "a fault of gcrules" in done.stderr


def test_starting_loads_nothing_heavy() -> None:
    code = "import sys, gcrules.apps.cli; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"numpy", "networkx", "sympy", "matplotlib", "lark", "yaml", "gcrules.conditions.analysis"} & set(loaded)


@pytest.mark.parametrize(
    "words", [["expand", "ab"], ["straighten", "[abcd]"], ["prove", "ab /\\ cd == [abcd]"]], ids=" ".join
)
def test_small_answers_load_nothing_heavy(words: list[str]) -> None:
    code = f"import sys; from gcrules.apps.cli import cli; cli({words!r}, standalone_mode=False); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "gcrules.apps.cli.algebra" in loaded
    assert not {"numpy", "networkx", "sympy", "matplotlib", "gcrules.conditions.analysis"} & set(loaded)


@pytest.mark.parametrize("legs", ["ab af cb cd ed ef", "Aa Ab Bc Bd Ce Cf"])
def test_analyzing_legs_loads_no_arrays(legs: str) -> None:
    words = ["analyze", legs]
    code = f"import sys; from gcrules.apps.cli import cli; cli({words!r}, standalone_mode=False); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "gcrules.conditions.analysis" in loaded
    assert not {"numpy", "networkx", "sympy", "matplotlib"} & set(loaded)
