"""Signals at any moment: no traceback, the exit code of the signal, no file that is half written or left over."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

if sys.platform == "win32":
    pytest.skip("needs signals", allow_module_level=True)

READY = """
import sys
import gcrules.apps.main as m
answered = m._answered
m._answered = lambda: (print("ready", file=sys.stderr, flush=True), answered())[1]
m.main()
"""
OVER = [word for c in "xyz" for word in ("--over", f"{c} -1:1:41")]
COMMANDS = {
    "factor": ["factor", "[[Aa,Ab,Bc,Bd,Ca,Dc]]", "--cofactor", "-o", "OUT.txt"],
    "shorten": ["shorten", "[[Aa,Bb,Cc,Dd,Ee,Ff]]", "-o", "OUT.txt"],
    "report": ["report", "{examples}/platform-6-3.yaml", "-o", "OUT.html"],
    "map": ["map", "{examples}/platform-6-3.yaml", *OVER, "-o", "OUT.nc", "-o", "OUT.glb"],
    "figure": ["analyze", "{examples}/platform-6-3.yaml", "--figure", "OUT.pdf", "-o", "OUT.txt"],
    "path": ["path", "{examples}/platform-6-3.yaml", "--at", "0 0 0", "--at", "0 0 -3", "--plot", "OUT.svg"],
    "rules": ["rules", "check", "-o", "OUT.txt"],
    "studio": ["studio", "ab af cb cd ed ef", "--no-browser", "--port", "0"],
}
ANSWERS = {"factor": 1}  # exit codes of those that answer no
KEPT = ("OUT.nc.part", "OUT.nc.part.tiles", "state")  # what a map has done is kept for the next time
MOMENTS = 5


@pytest.mark.parametrize("moment", range(MOMENTS))
@pytest.mark.parametrize("name", COMMANDS)
def test_a_signal_at_any_moment(root: Path, tmp_path: Path, name: str, moment: int) -> None:
    number = (signal.SIGINT, signal.SIGTERM)[moment % 2]
    wait = random.Random(f"{name} {moment}").uniform(0, 0.5 * (moment + 1))
    words = [w.replace("{examples}", str(root / "examples")) for w in COMMANDS[name]]
    with subprocess.Popen(
        [sys.executable, "-c", READY, *words],
        cwd=tmp_path,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=os.environ | {"XDG_STATE_HOME": str(tmp_path / "state")},
    ) as process:
        assert process.stderr is not None
        assert process.stderr.readline() == b"ready\n"
        time.sleep(wait)
        process.send_signal(number)
        try:
            _, errors = process.communicate(timeout=60)
        finally:
            process.kill()
    assert b"Traceback" not in errors, errors
    assert b"ignored" not in errors, errors
    left = [p.name for p in tmp_path.iterdir() if p.name not in KEPT]
    assert not [n for n in left if n.startswith(".")]
    if process.returncode == ANSWERS.get(name, 0):  # it had its answer already; and Ctrl-C is how the studio is left
        assert name == "studio" or left or wait > 0.2
    else:
        assert process.returncode == 128 + number
        assert not left


# One process has everything loaded; a copy of it for each line at which the signal comes.
SWEEP = """
import os, signal, sys
words, lines = sys.argv[1].split("\\n"), [int(n) for n in sys.argv[2].split()]
import gcrules.apps.main as m
import gcrules.apps.cli, gcrules.apps.cli.{module}
sys.argv = ["gcrules", *words]
for at in lines:
    child = os.fork()
    if child == 0:
        left = at
        def trace(frame, event, arg):
            global left
            left -= 1
            if left == 0:
                sys.settrace(None)
                signal.raise_signal(signal.SIGINT)
                return None
            return trace
        answered = m._answered
        def watched():
            sys.settrace(trace)
            return answered()
        m._answered = watched
        os.close(1)
        os.open(os.devnull, os.O_WRONLY)
        m.main()
    _, status = os.waitpid(child, 0)
    print(at, os.waitstatus_to_exitcode(status), flush=True)
"""
LINES = [*range(1, 40, 3), 60, 100, 150, 250, 400, 600, 900, 1500, 2500, 4000, 7000, 12000, 20000]


@pytest.mark.parametrize(
    ("module", "words"),
    [
        ("algebra", ["prove", "[abcd][abef] == [abce][abdf]", "-o", "OUT.txt"]),
        ("legs", ["analyze", "ab af cb cd ed ef", "--figure", "OUT.svg", "-o", "OUT.txt"]),
    ],
    ids=["prove", "analyze"],
)
def test_a_signal_at_any_line(tmp_path: Path, module: str, words: list[str]) -> None:
    lines = " ".join(map(str, LINES))
    done = subprocess.run(
        [sys.executable, "-c", SWEEP.replace("{module}", module), "\n".join(words), lines],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    assert not done.stderr.strip(), done.stderr
    found = {int(at): int(code) for at, code in map(str.split, done.stdout.splitlines())}
    assert list(found) == LINES
    interrupted = [at for at, code in found.items() if code == 130]
    assert len(interrupted) > len(LINES) // 2
    assert set(found.values()) <= {0, 1, 130}  # the last lines may be past the end
    assert not list(tmp_path.glob(".*"))
    assert bool(list(tmp_path.glob("OUT*"))) is any(code != 130 for code in found.values())


def program(code: str) -> subprocess.CompletedProcess[str]:
    """What becomes of a program that is interrupted in the given lines."""
    script = f"import signal, sys, time\nfrom gcrules.core import interrupts\n{code}\nsys.exit(interrupts.run(program))"
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)


LOST = {
    "swallowed": "try:\n        signal.raise_signal(signal.SIGINT); time.sleep(30)\n    except BaseException: pass",
    "turned into another error": (
        "try:\n        signal.raise_signal(signal.SIGINT); time.sleep(30)\n"
        "    except BaseException: raise ImportError('broken') from None"
    ),
    "in a destructor": (
        "class A:\n        def __del__(self): signal.raise_signal(signal.SIGINT); time.sleep(0)\n"
        "    A(); time.sleep(30)"
    ),
    "in a loop that swallows": (
        "for _ in range(3):\n        try:\n            signal.raise_signal(signal.SIGINT); time.sleep(30)\n"
        "        except BaseException: pass"
    ),
    "in a constructor, and the destructor fails": (
        "class A:\n        def __init__(self): signal.raise_signal(signal.SIGINT); time.sleep(30); self.part = 1\n"
        "        def __del__(self): del self.part\n"
        "    A()"
    ),
    "twice": "signal.raise_signal(signal.SIGINT); signal.raise_signal(signal.SIGINT)",
    "while deferred": "with interrupts.deferred(): signal.raise_signal(signal.SIGINT)\n    time.sleep(30)",
}


@pytest.mark.parametrize("name", LOST)
def test_an_interrupt_is_not_lost(name: str) -> None:
    wrapped = f"def inner():\n    {LOST[name]}\ndef program():\n"
    done = program(wrapped + "    try: inner()\n    except ImportError: pass\n    return 0")
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")


@pytest.mark.parametrize(
    ("name", "code"), [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)], ids=["SIGINT", "SIGTERM", "SIGHUP"]
)
def test_each_signal_has_its_code(name: str, code: int) -> None:
    heard = f"signal.signal(signal.{name}, signal.SIG_DFL)"  # who runs the tests may have it ignored
    assert program(f"{heard}\ndef program(): signal.raise_signal(signal.{name}); return 0").returncode == code


def test_a_signal_that_is_ignored_stays_so() -> None:
    done = program(
        "signal.signal(signal.SIGHUP, signal.SIG_IGN)\ndef program(): signal.raise_signal(signal.SIGHUP); return 0"
    )
    assert done.returncode == 0


@pytest.mark.parametrize(("moment", "code", "there"), [("before", 130, []), ("between", 0, ["a.txt", "b.txt"])])
def test_the_files_and_the_exit_code_agree(tmp_path: Path, moment: str, code: int, there: list[str]) -> None:
    """A signal that comes when the files take their places comes too late."""
    done = program(
        "import atexit, os\nfrom gcrules.core.files import held, remove_unfinished, write_file\n"
        "atexit.register(remove_unfinished)\n"
        f"os.chdir({str(tmp_path)!r})\n"
        "interrupt = lambda: signal.raise_signal(signal.SIGINT)\n"
        "replace = os.replace\n"
        f"if {moment!r} == 'between': os.replace = lambda a, b: (interrupt(), replace(a, b), interrupt())\n"
        "def program():\n"
        "    with held():\n"
        "        write_file('a.txt', 'a'); write_file('b.txt', 'b')\n"
        f"        if {moment!r} == 'before': interrupt()\n"
        "    interrupt(); return 0"
    )
    assert (done.returncode, done.stderr) == (code, "")
    assert sorted(os.listdir(tmp_path)) == there


def test_a_prompt_goes_on_after_an_interrupt_and_ends_when_asked() -> None:
    code = (
        "def program():\n"
        "    try: signal.raise_signal(signal.SIGINT)\n"
        "    except KeyboardInterrupt: interrupts.go_on()\n"
        "    time.sleep(1)\n"
        "    print('on', flush=True)\n"
        "    try: signal.raise_signal(signal.SIGTERM)\n"
        "    except KeyboardInterrupt: interrupts.go_on()\n"
        "    print('never')"
    )
    done = program(code)
    assert (done.returncode, done.stdout, done.stderr) == (143, "on\n", "")
