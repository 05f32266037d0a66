"""Interrupts and kills: at any moment of a command, in this process and in one of its own.

In this process the moment is a count of function calls, so that a case can be run again: there the handler of the
signal is called. In a process of its own a true signal comes after a time.
"""

from __future__ import annotations

import atexit
import os
import signal
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from random import Random
from time import monotonic, sleep
from types import FrameType
from typing import Any

from gcrules.apps.main import main
from gcrules.core import interrupts

from ..case import Case
from ..corpus import corpus
from ..jail import Jail
from ..running import Outcome, last_frame, run_command
from .family import Family

__all__ = ["INTERRUPTS", "KILLS"]

_G, _R = {"g.yaml": corpus("platforms")[0]}, {"r.yaml": corpus("robots")[4]}
_S = {"s.gca": "claim ab /\\ cd == [abcd]\nshow ab /\\ cde\nclaim [abcd] == [abce]\n"}

# Weights: each command is met thousands of times in a campaign, those that take long less often than the others.
COMMANDS: tuple[tuple[float, tuple[str, ...], dict[str, str], str], ...] = (
    (4, ("expand", "(ab /\\ cde) (fg /\\ hij)", "-o", "out.txt"), {}, ""),
    (4, ("straighten", "[aefg][bcdh]", "--steps"), {}, ""),
    (4, ("straighten", "[adf][bce][acf]", "--rank", "3", "--json", "-o", "out.txt"), {}, ""),
    (4, ("prove", "[abc] d == [dbc] a - [dac] b + [dab] c", "--rank", "3"), {}, ""),
    (4, ("prove", "[bcd] == 0", "--rank", "3", "--given", "collinear(a, b, c), collinear(a, b, d)"), {}, ""),
    (3, ("shorten", "[abc][def] - [abd][cef] + [abe][cdf]", "--rank", "3", "-o", "out.txt"), {}, ""),
    (0.03, ("factor", "[abfc][acde][bdef] + [abfd][acbe][cdef]", "--json", "-o", "out.txt"), {}, ""),
    (3, ("rewrite", "ab /\\ cde", "--rules", "expansion"), {}, ""),
    (1, ("analyze", "ab af cb cd ed ef", "--json", "-o", "out.txt"), {}, ""),
    (0.1, ("analyze", "Aa Bb Cc Dd Ee Ff", "--search", "0.1"), {}, ""),
    (0.1, ("transversals", "Aa Ab Bc Cd De Ef", "-o", "out.txt"), {}, ""),
    (
        3,
        ("analyze", "ab af cb cd ed ef", "--session", "kept.yaml", "--propose", "plane abc", "--propose", "auto"),
        {},
        "",
    ),
    (3, ("analyze", "ab af cb cd ed ef", "--manual"), {}, "plane abc\nauto\nstatement\nsave kept.yaml\n"),
    (3, ("run", "s.gca", "-o", "out.txt"), _S, ""),
    (4, ("repl",), _S, "let p = ab /\\ cde\np f\n:load s.gca\n:save kept.gca\n[abcd] == [abdc]\n"),
    (0.3, ("pose", "g.yaml", "--no-nearest", "-o", "out.txt"), _G, ""),
    (0.01, ("pose", "g.yaml"), _G, ""),
    (
        0.3,
        (
            "path",
            "g.yaml",
            "--at",
            "0 0 0",
            "--at",
            "0 0 10",
            "--samples",
            "9",
            "--csv",
            "out.csv",
            "--plot",
            "out.svg",
        ),
        _G,
        "",
    ),
    (0.2, ("locus", "g.yaml", "--over", "x,y", "-o", "out.txt"), _G, ""),
    (0.01, ("map", "g.yaml", "--over", "x -1:1:4", "--over", "y -1:1:4", "-o", "out.svg", "-o", "out.json"), _G, ""),
    (0.01, ("map", "g.yaml", "--over", "x -1:1:4", "--over", "y -1:1:4", "--over", "z 0:1:3", "-o", "out.ply"), _G, ""),
    (0.1, ("report", "g.yaml", "-o", "out.html"), _G, ""),
    (0.2, ("analyze", "g.yaml", "--figure", "out.svg"), _G, ""),
    (0.03, ("analyze", "g.yaml", "--figure", "out.pdf"), _G, ""),
    (2, ("robot", "show", "r.yaml"), _R, ""),
    (0.1, ("robot", "analyze", "r.yaml", "--search", "0"), _R, ""),
    (0.1, ("robot", "pose", "r.yaml", "-o", "out.txt"), _R, ""),
    (0.1, ("modes", "r.yaml", "--operation", "-o", "out.txt"), _R, ""),
    (2, ("robot", "new", "my-robot"), {}, ""),
    (0.3, ("catalog", "show", "6-3.2"), {}, ""),
    (1, ("rules", "list", "--json"), {}, ""),
)
_SPOILS = {".part": "map keeps what is done for the next time"}


def _drawn(rng: Random, family: str, signals: tuple[str, ...]) -> Case:
    _, argv, files, stdin = rng.choices(COMMANDS, [c[0] for c in COMMANDS])[0]
    data = {"signal": rng.choice(signals), "at": round(rng.random() * 1.02, 6)}
    mixed = argv[0] == "repl" or "--manual" in argv or "--propose" in argv
    return Case(family, argv, files, stdin, 30.0, mixed=mixed, data=data)


def interrupt(rng: Random) -> Case:
    return _drawn(rng, "interrupts", ("SIGINT", "SIGINT", "SIGTERM"))


def kill(rng: Random) -> Case:
    return _drawn(rng, "kills", ("SIGINT", "SIGTERM", "SIGKILL"))


# --- in this process -----------------------------------------------------------------------------------------------


class _Ended(BaseException):
    """What a process would have left that this signal ends at once."""


class _Moment:
    """Counts calls and returns of functions, and sends the signal at one of them."""

    def __init__(self, at: int | None, number: int, jail: Jail) -> None:
        self.at, self.number, self.jail = at, number, jail
        self.count = 0
        self.came = False
        self.left: tuple[str, ...] | None = None
        self.entry = interrupts.run.__code__

    @contextmanager
    def __call__(self) -> Iterator[None]:
        sys.setprofile(self.seen)
        try:
            yield
        finally:
            sys.setprofile(None)

    def seen(self, frame: FrameType, event: str, value: Any) -> None:
        if not self.count and (event != "call" or frame.f_code is not self.entry):
            return  # the entry point has not begun
        self.count += 1
        if frame.f_code is self.entry and event == "return":
            self.at = None  # it is over
        if self.at is None or self.count <= self.at or frame.f_code.co_name in ("__del__", "<lambda>", "_remove"):
            return
        sys.setprofile(None)
        self.at, self.came = None, not interrupts._heard.settled  # the answer stands: it comes too late
        handler = signal.getsignal(self.number)
        if callable(handler):
            handler(self.number, frame)
        else:
            self.left = tuple(self.jail.changes())
            raise _Ended


_CALLS: dict[tuple[str, ...], int] = {}
"""How many calls each command makes, in this process, when everything is loaded."""


def _calls(case: Case, jail: Jail) -> int:
    if case.argv not in _CALLS:
        run_command(case, jail)
        counted = _Moment(None, 0, jail)
        run_command(case, jail, around=counted)
        _CALLS[case.argv] = counted.count
    return _CALLS[case.argv]


def run_interrupt(case: Case, jail: Jail) -> Outcome:
    number = signal.Signals[case.data["signal"]]
    before = signal.getsignal(signal.SIGINT)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        moment = _Moment(1 + int(case.data["at"] * _calls(case, jail)), number, jail)
        found = run_command(case, jail, around=moment)
    finally:
        signal.signal(signal.SIGINT, before)
    if moment.left is not None:
        kept = tuple(n for n in moment.left if not any(p in n for p in _SPOILS))
        wrong = ("a signal ends it at once, and it leaves files",) if any(_temporary(n) for n in kept) else ()
        return Outcome(wrong=wrong)
    return _interrupted(found, moment.came, 130 if number == signal.SIGINT else 143)


def _temporary(name: str) -> bool:
    return os.path.basename(name).startswith(".") or name.endswith((".tmp", ".part"))


def _interrupted(found: Outcome, came: bool, code: int) -> Outcome:
    """Exit code and files of a command that a signal has come to: the code of the signal, or that of its end."""
    if found.frame or not came:
        return found
    if found.code != code:
        return replace(found, wrong=(*found.wrong, f"exit code {found.code} after the signal, expected {code}"))
    left = tuple(n for n in found.left if not any(p in n for p in _SPOILS) and _temporary(n))
    shown = ("traceback after a signal",) if "Traceback" in found.stderr or "Exception ignored" in found.stderr else ()
    return replace(found, code=None, left=left, wrong=(*found.wrong, *shown))


# --- in a process of its own ---------------------------------------------------------------------------------------

_SECONDS: dict[tuple[str, ...], float] = {}


def run_kill(case: Case, jail: Jail) -> Outcome:
    if case.argv not in _SECONDS:
        run_command(case, jail)  # what is made once is made before the process divides
        _SECONDS[case.argv] = max(_forked(case, jail, None, 0.0)[0], _forked(case, jail, None, 0.0)[0])
    number = signal.Signals[case.data["signal"]]
    seconds, status, err = _forked(case, jail, number, case.data["at"] * _SECONDS[case.argv])
    ended = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
    wrong: list[str] = []
    usual = {signal.SIGINT: (130, -2), signal.SIGTERM: (143, -15), signal.SIGKILL: (-9,)}[number]
    if ended not in (0, 1, 3, *usual):
        wrong.append(f"exit code {ended} after {number.name}: {case.argv[0]}")
    if "Traceback" in err or "Exception ignored" in err:
        wrong.append(f"traceback after {number.name}: {case.argv[0]}")
    left = [n for n in jail.changes() if _temporary(n) and not any(p in n for p in _SPOILS)]
    if left and number != signal.SIGKILL:
        wrong.append(f"files left after {number.name}: {case.argv[0]}")
    wrong += [
        f"a file that is not complete after {number.name}"
        for n in jail.changes()
        if n.startswith("out") and _empty(jail, n)
    ]
    return Outcome(None, wrong=tuple(wrong), seconds=seconds, trace=err)


def _empty(jail: Jail, name: str) -> bool:
    path = os.path.join(jail.here, name)
    return os.path.isfile(path) and not os.path.getsize(path)


def _forked(case: Case, jail: Jail, number: int | None, after: float) -> tuple[float, int, str]:
    """Run a command in a child that gets the signal after this time; its seconds, status and errors."""
    jail.fill(case.files)
    streams = {n: os.path.join(jail.home, n) for n in ("in", "out", "err")}
    with open(streams["in"], "w", encoding="utf-8") as file:
        file.write(case.stdin)
    sys.stdout.flush()
    ready, begun = os.pipe()
    child = os.fork()
    if not child:
        _child(case, streams, begun)
    os.close(begun)
    os.read(ready, 1)
    os.close(ready)
    began = monotonic()
    if number is not None:
        sleep(after)
        os.kill(child, number)
    _, status = os.waitpid(child, 0)
    with open(streams["err"], encoding="utf-8", errors="replace") as file:
        return monotonic() - began, status, file.read()


def _child(case: Case, streams: dict[str, str], begun: int) -> None:
    """The rest of a child's life."""
    code = 70
    atexit._clear()  # what is to be done at the end of the campaign
    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        for number, name in enumerate(("in", "out", "err")):
            os.dup2(os.open(streams[name], os.O_RDWR | os.O_CREAT | (os.O_TRUNC if number else 0), 0o600), number)
        sys.stdin, sys.stdout, sys.stderr = (os.fdopen(n, "w" if n else "r", encoding="utf-8") for n in range(3))
        sys.argv = ["gcrules", *case.argv]
        signal.alarm(120)
        os.write(begun, b".")
        main()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else 0
        sys.stdout.flush()
    except BaseException as fault:
        place = last_frame(fault)
        if isinstance(fault, KeyboardInterrupt) and ("gcrules" not in place or place.endswith("apps/main.py:main")):
            code = 130  # it came before the entry point had begun
        else:
            traceback.print_exc()
    finally:
        sys.stderr.flush()
        os._exit(code)


INTERRUPTS = Family(
    "interrupts",
    "SIGINT and SIGTERM at any call of a command, in this process",
    interrupt,
    run_interrupt,
    share=1.5,
    few=12,
)
KILLS = Family(
    "kills",
    "true signals, SIGKILL too, to a process of its own",
    kill,
    run_kill,
    share=1.5,
    few=5,
)
