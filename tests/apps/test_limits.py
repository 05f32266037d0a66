"""Limits limit: every long loop looks at one budget, and every command ends within the time that it is given."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
import pytest
from algebra.polynomials import polynomial
from click.testing import CliRunner

import gcrules as gc
from gcrules.algebra.assumptions.assumed import holds, resolve
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.expand import expand
from gcrules.algebra.language.parse_tree import MAX_TEXT
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.prove import prove
from gcrules.algebra.straightening.diagonal import normal_form
from gcrules.algebra.straightening.straighten import is_zero, next_syzygy, straighten, straighten_steps
from gcrules.apps.cli import cli
from gcrules.apps.cli import factor as factor_command
from gcrules.apps.cli import shorten as shorten_command
from gcrules.apps.cli.limits import AROUND, SECONDS
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.state import Settings
from gcrules.apps.studio import worker
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.core.budget import within
from gcrules.core.errors import LimitReached
from gcrules.mechanisms.conditions.analyze_robot import analyze_robot
from gcrules.mechanisms.load import read_robot
from gcrules.rules import rule_file
from gcrules.rules.elementary import ELEMENTARY
from gcrules.rules.rewriting import rewrite

POWERS = "[abcd]**64 " * 9_000
BRACKETS = "[abcd]" * 16_000
MEETS = "[(ab /\\ cde), f, gh]" * 4_900
DIFFERENT = "[afgl][behk][cdij]" * 5_000
TERMS = " + ".join(f"[p{i} p{i + 1} p{i + 2} p{i + 3}]" for i in range(3_000))
HOSTILE = {"powers": POWERS, "brackets": BRACKETS, "meets": MEETS, "many rows": DIFFERENT, "terms": TERMS}


SHORT, LINES = parse("[afgl][behk][cdij]"), parse("abc /\\ def /\\ gh")
MEET, SIX = parse("abc /\\ def /\\ ghi /\\ jkl"), parse("[[ab, cd, ef, gh, ij, kl]]")
TEN = parse(f"[[{', '.join(f'p{2 * i}p{2 * i + 1}' for i in range(10))}]]", rank=5)
POLYNOMIAL, NORMAL = polynomial("[afgl][behk][cdij]"), polynomial("[abcd][efgh]")
POINTS = random_rational_points("abcdefghijkl")
GIVEN = parse_assumption("collinear(a, b, c), incident(a, de)", Context(3))
POSE = "examples/octahedral.yaml"

STAGES: dict[str, Callable[[], object]] = {
    "parse": lambda: parse("[afgl][behk][cdij]"),
    "parse an equation": lambda: parse_equation("[abcd] == [abce]"),
    "parse a script": lambda: parse_script("show [abcd]"),
    "expand": lambda: expand(SHORT),
    "expand meets": lambda: expand(MEET),
    "expand a superbracket": lambda: expand(SIX),
    "expand a determinant": lambda: expand(TEN),
    "straighten": lambda: straighten(POLYNOMIAL),
    "straighten what is standard": lambda: straighten(NORMAL),
    "is zero": lambda: is_zero(POLYNOMIAL),
    "syzygies": lambda: straighten_steps(POLYNOMIAL),
    "next syzygy": lambda: next_syzygy(POLYNOMIAL),
    "by diagonals": lambda: normal_form(polynomial_of_new_points()),
    "evaluate": lambda: evaluate(SHORT, POINTS),
    "text": lambda: str(SHORT),
    "text of a polynomial": lambda: str(POLYNOMIAL),
    "LaTeX": lambda: POLYNOMIAL.latex(),
    "resolve assumptions": lambda: resolve(GIVEN),
    "a proof under assumptions": lambda: holds(GIVEN.given[0], GIVEN),
    "rewrite": lambda: rewrite(LINES, ELEMENTARY),
    "prove": lambda: prove(SHORT, SHORT * 2),
    "shortest form": lambda: gc.shortest("Aa Bb Cc Dd Ee Ff"),
    "transversals": lambda: gc.transversals("Aa Ab Bc Cd De Ef"),
    "analyze": lambda: gc.analyze("ab af cb cd ed ef"),
    "a robot": lambda: analyze_robot(read_robot("3-rps")),  # not what is remembered of it
    "factor": lambda: gc.factor(SHORT),
    "shorten": lambda: gc.shorten(SHORT),
    "discover": lambda: gc.discover("rank 3 given collinear(a, b, c), collinear(d, e, f)"),
}


def polynomial_of_new_points() -> BracketPolynomial:
    """Points for which no basis is kept yet."""
    return BracketPolynomial(4, tuple(f"q{i}" for i in range(12)), {((0, 5, 6, 11), (1, 4, 7, 10), (2, 3, 8, 9)): 1})


@pytest.mark.parametrize("stage", STAGES.values(), ids=STAGES)
def test_each_stage_looks_at_the_budget(stage: Callable[[], object]) -> None:
    with within(seconds=0), pytest.raises(LimitReached, match="more than 0 seconds"):
        stage()


@pytest.mark.parametrize("stage", STAGES.values(), ids=STAGES)
def test_each_stage_can_be_cancelled(stage: Callable[[], object]) -> None:
    with within() as one:
        one.cancel()
        with pytest.raises(LimitReached, match="cancelled"):
            stage()


# --- the command line ------------------------------------------------------------------------------------------------

COMMANDS = {
    "expand": (),
    "straighten": (),
    "straighten --steps": (),
    "rewrite": ("--rules", "expansion"),
    "shorten": (),
    "factor": (),
}


def run(*args: str, text: str = "") -> Any:
    return CliRunner().invoke(cli, args, input=text)


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("seconds", ["0", "0.3"])
def test_hostile_text_ends_at_the_limit(command: str, name: str, seconds: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """From standard input, with no time at all or with so little that the limit is met somewhere on the way."""
    for module in (factor_command, shorten_command):
        monkeypatch.setattr(module, "AROUND", 0)
    done = run(*command.split(), "-", *COMMANDS[command], "--seconds", seconds, text=HOSTILE[name])
    if seconds != "0" and done.exit_code in (0, 1):  # a fast machine
        return
    assert (done.exit_code, done.stdout) == (3, ""), done.output
    assert re.match(r"error: (<\w+>:\d+:\d+: )?(this|the search) takes more than", done.stderr), done.stderr
    assert "\nhint: " in done.stderr


@pytest.mark.parametrize("command", ["factor", "shorten"])
def test_a_search_without_time_ends_with_an_answer_or_the_limit(command: str) -> None:
    done = run(command, "--seconds", "0", POWERS)
    assert done.exit_code in (0, 3), done.output


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_proofs_end(name: str) -> None:
    done = run("prove", "-", "--seconds", "0", text=f"{HOSTILE[name]} == 0"[:MAX_TEXT])
    assert (done.exit_code, done.stdout) == (3, "")


OTHERS = {
    "analyze": ("Aa Bb Cc Dd Ee Ff",),
    "analyze a robot": ("3-rps",),
    "analyze --full": ("Aa Bb Cc Dd Ee Ff", "--given", "incident(a, bc)"),
    "analyze --manual": ("ab af cb cd ed ef", "--propose", "plane abf"),
    "report": ("ab af cb cd ed ef",),
    "transversals": ("Aa Ab Bc Cd De Ef",),
    "pose": (POSE,),
    "locus": (POSE,),
    "path": (POSE, "--at", "0 0 0", "--at", "0 0 1"),
    "map": (POSE, "--over", "x -1:1:11", "--over", "y -1:1:11"),
    "run": ("examples/plane.gca",),
    "rules list": (),
    "rules check": (),
    "robot analyze": ("3-rps",),
    "modes": ("3-rps",),
    "modes --operation": ("3-rps",),
    "modes --working": ("delta",),
    "robot pose": ("3-rps",),
    "robot check": ("3-rps",),
    "robot docs": ("--check",),
    "catalog show": ("6-3.2",),
    "catalog check": (),
    "catalog enumerate": (),
    "catalog docs": ("--check",),
}


@pytest.mark.parametrize("command", OTHERS)
def test_every_command_ends_at_its_limit(command: str, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    rule_file._unproved.cache_clear()  # rules that were read before in this process would take no time
    words = [w for w in command.split() if not w.startswith("-")][: 2 if command.split()[0] in GROUPS else 1]
    flags = [w for w in command.split() if w.startswith("-")]
    done = run(*words, *OTHERS[command], *flags, "--seconds", "0")
    assert done.exit_code == 3, done.output
    assert "more than 0 seconds" in done.output


@pytest.mark.parametrize("wrong", ["nan", "-1", "soon", ""], ids=repr)
def test_seconds_are_a_number(wrong: str) -> None:
    done = run("expand", "[abcd]", "--seconds", wrong)
    assert done.exit_code == 2
    assert "number of seconds" in done.stderr


@pytest.mark.parametrize("command", ["factor", "factors"])
def test_a_factorization_stops_at_its_memory(command: str) -> None:
    expression = "[[Aa, Ab, Ba, Bb, Cc, Dd]]"
    done = run(command, expression, "--memory", "0.001")
    assert done.exit_code == 3, done.output
    assert done.stderr.startswith("error: this takes more than 0.001 GB of memory\nhint: ")
    assert "--memory" in done.stderr
    assert not done.stdout
    free = run(command, expression, "--memory", "inf")
    without = run(command, expression)
    assert (free.exit_code, free.stdout) == (without.exit_code, without.stdout)


@pytest.mark.parametrize("wrong", ["nan", "-1", "much", ""], ids=repr)
def test_memory_is_a_number(wrong: str) -> None:
    done = run("factors", "[abcd]", "--memory", wrong)
    assert done.exit_code == 2
    assert "number of gigabytes" in done.stderr


def test_memory_goes_before_the_variable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GCRULES_MEMORY", "0.001")
    assert run("factors", "[abcd]").exit_code == 3
    assert run("factors", "[abcd]", "--memory", "1000").exit_code == 0


def test_no_limit() -> None:
    assert run("expand", "[abcd]", "--seconds", "inf").stdout == "[abcd]\n"


def test_the_default_can_be_set(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GCRULES_SECONDS", "0")
    assert run("expand", "[abcd]").exit_code == 3
    assert run("expand", "[abcd]", "--seconds", "1000").exit_code == 0
    monkeypatch.setenv("GCRULES_MEMORY", "little")
    assert run("expand", "[abcd]").exit_code == 2


def test_a_search_has_its_seconds_beside_the_default_only(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GCRULES_SECONDS", "0")
    assert run("analyze", "ab af cb cd ed ef", "--search", "1000").exit_code == 0
    assert run("analyze", "ab af cb cd ed ef", "--search", "1000", "--seconds", "0").exit_code == 3


GROUPS = ("rules", "robot", "catalog")
QUICK = {"studio", "completion", "checkers", "cite", "robot list", "robot show", "robot new"}  # they compute nothing


def leaves(group: click.Group, path: tuple[str, ...] = ()) -> Iterator[tuple[str, click.Command]]:
    context = click.Context(group)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        if isinstance(command, click.Group):
            yield from leaves(command, (*path, name))
        else:
            yield " ".join((*path, name)), command


def test_every_command_that_computes_has_the_option() -> None:
    without = {name for name, command in leaves(cli) if all("--seconds" not in p.opts for p in command.params)}
    assert without == QUICK | {"certify"}  # which has --time, and answers with what it has by then


def test_the_page_lists_the_limits(root: Path) -> None:
    page = (root / "docs" / "limits.md").read_text(encoding="utf-8")
    assert f"| most commands | {SECONDS:g} seconds |" in page
    assert f"and {AROUND:g} seconds around it" in page


# --- the prompt ------------------------------------------------------------------------------------------------------


def test_each_input_of_the_prompt_has_its_memory() -> None:
    repl = Interpreter(settings=Settings(unicode=False))
    *limited, last = [a.text for a in repl.feed(":memory 0.001\n:factors [abcd]\n:memory inf\n:factors [abcd]")][1:]
    assert limited[0] == "error: this takes more than 0.001 GB of memory\nhint: give it more memory with :memory G"
    assert "[abcd]" in last


def test_each_input_of_the_prompt_has_its_time() -> None:
    repl = Interpreter(settings=Settings(unicode=False))
    text = ":seconds 0\nlet p = ab\n[abcd]\n[abcd] == [abce]\n:straighten [abcd]\n:seconds 1000\n[abcd]"
    answers = [a.text for a in repl.feed(text)]
    assert sum("more than 0 seconds" in a for a in answers) == 4
    assert all(":seconds S" in a for a in answers if "more than 0 seconds" in a)
    assert answers[-1] == "[abcd]"
    assert "p" not in repl.state.context.bound


def test_the_prompt_shows_many_brackets_in_short() -> None:
    for short, shown in ((True, "[abcd]**4096"), (False, "[abcd]" * 4_096)):
        repl = Interpreter(settings=Settings(unicode=False, short=short))
        assert [a.text for a in repl.feed("([abcd]**64)**64")] == [shown]


# --- interrupts ------------------------------------------------------------------------------------------------------

INTERRUPTED = """
import signal, sys
import gcrules as gc
signal.setitimer(signal.ITIMER_REAL, 0.5)
signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
try:
    gc.straighten("[afgl][behk][cdij]" * 30)
except KeyboardInterrupt:
    sys.exit(42)
"""


def test_one_normal_form_can_be_interrupted() -> None:
    assert subprocess.run([sys.executable, "-c", INTERRUPTED], timeout=300, check=False).returncode == 42


# --- the studio ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["open", "bench", "save"])
def test_a_request_of_the_studio_has_its_time(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The worker notices it by itself and lives on; the hint is one for the page."""
    monkeypatch.setattr(worker, "METHODS", {n: replace(m, seconds=0) for n, m in METHODS.items()})
    source = {"kind": "legs", "legs": "ab af cb cd ed ef"}
    args = {"open": {"source": source}, "bench": {"text": "[abcd]"}, "save": {"source": source, "what": "tex"}}[name]
    kind, found, _ = worker.done((name, args, None), {}, lambda words: None)
    fault = found.get("fault", found)
    assert kind == ("done" if fault is not found else "fault")
    assert (fault["kind"], "more than 0 seconds" in fault["message"]) == ("limit", True)
    assert fault is not found or "the command line" in fault["hint"]
