"""Limits limit: every long loop looks at one budget, and every command ends within the time that it is given."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import repeat
from math import inf, nan
from pathlib import Path
from typing import Any

import click
import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.assumptions.assumed import holds, resolve
from gcrules.algebra.bracket import MANY_EQUAL, BracketPolynomial
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.expand import MAX_BRACKETS, expand
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import MAX_TEXT, Context, parse, parse_equation
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
from gcrules.core import alarm, budget, memory
from gcrules.core.budget import Count, checkpoint, seconds_left, waiting, watched, within
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.analyze import analyze_robot
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

# --- budgets ---------------------------------------------------------------------------------------------------------


def test_without_a_budget_there_is_no_limit() -> None:
    checkpoint()
    assert seconds_left() == inf


def test_a_budget_inside_another_ends_no_later() -> None:
    with within(seconds=100), within(seconds=1_000) as inner:
        assert inner.left <= 100
        with within(seconds=1):
            assert seconds_left() <= 1
        assert seconds_left() > 1
    assert seconds_left() == inf


@pytest.mark.parametrize("outer", [True, False], ids=["outer", "inner"])
def test_the_budget_that_is_used_up_is_named(outer: bool) -> None:
    seconds = (0, 1_000) if outer else (1_000, 0)
    with within(seconds[0]), within(seconds[1]), pytest.raises(LimitReached, match="more than 0 seconds") as limited:
        checkpoint()
    assert limited.value.exit_code == 3
    assert "--seconds" in (limited.value.hint or "")


def test_grace_is_not_said() -> None:
    with within(0, grace=1_000) as lenient:
        checkpoint()
        assert lenient.left > 0
    with within(1, grace=-1), pytest.raises(LimitReached, match=r"more than 1 second$"):
        checkpoint()


@pytest.mark.parametrize("wrong", [nan, "five", [1]], ids=str)
def test_what_is_no_number_is_refused(wrong: Any) -> None:
    with pytest.raises(InputError, match="is no number of seconds"), within(wrong):
        pass


SECONDS_OF_ANY_KIND = {"a fraction": Fraction(1, 10**30), "numpy": np.float32(0), "no time": -(10**400)}


@pytest.mark.parametrize("seconds", SECONDS_OF_ANY_KIND.values(), ids=SECONDS_OF_ANY_KIND)
def test_seconds_are_numbers_of_any_kind(seconds: Any) -> None:
    with pytest.raises(LimitReached, match=r"more than \S+ seconds"), within(seconds):
        checkpoint()
    with within(10**400) as budget:
        assert budget.left == inf


def test_a_budget_can_be_cancelled_from_elsewhere() -> None:
    with within() as outer, within():
        thread = threading.Thread(target=outer.cancel)
        thread.start()
        thread.join()
        with pytest.raises(LimitReached, match="cancelled"):  # the inner budget looks at the outer one now and then
            deque(watched(repeat(None), every=1), maxlen=0)


def test_waiting_does_not_count(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr(budget, "monotonic", lambda: now[0])
    with within(10), within(20) as inner:
        now[0] += 5
        with waiting(), waiting():
            now[0] += 100
            checkpoint()
        assert inner.left == 5
        checkpoint()
        now[0] += 6
        with pytest.raises(LimitReached, match="more than 10 seconds"):
            checkpoint()


def test_progress_goes_to_the_nearest_that_listens() -> None:
    heard: list[str] = []
    with within(progress=heard.append), within() as inner:
        inner.report("half")
    assert heard == ["half"]


def test_memory_is_limited(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "memory_in_use", lambda: 3 * memory.GIGABYTE)
    with within(memory=4 * memory.GIGABYTE):
        checkpoint()
    with within(memory=2 * memory.GIGABYTE), pytest.raises(LimitReached, match="more than 2 GB of memory") as limited:
        gc.expand("[abcd]")
    assert "GCRULES_MEMORY" in (limited.value.hint or "")


@pytest.mark.parametrize(("asked", "limit"), [("2", 2 * 2**30), ("0.5", 2**29), ("0", None)])
def test_memory_is_asked_for(monkeypatch: pytest.MonkeyPatch, asked: str, limit: int | None) -> None:
    monkeypatch.setenv("GCRULES_MEMORY", asked)
    assert memory.memory_limit() == limit


@pytest.mark.parametrize("asked", ["much", "-1", "nan", "inf"])
def test_memory_that_is_no_number(monkeypatch: pytest.MonkeyPatch, asked: str) -> None:
    monkeypatch.setenv("GCRULES_MEMORY", asked)
    with pytest.raises(InputError, match="expected a number of gigabytes"):
        memory.memory_limit()


def test_memory_has_a_limit_of_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("GCRULES_MEMORY", raising=False)
    found = memory.memory_limit()
    assert found is None or found > memory.memory_in_use() / 2


def test_a_count_says_what_there_is_too_much_of() -> None:
    count = Count(10, "this takes", "trials", "try less")
    count.spend(10)
    with pytest.raises(LimitReached, match="this takes more than 10 trials") as limited:
        count.spend()
    assert limited.value.hint == "try less"


def test_watched_items_are_the_items() -> None:
    with within(seconds=1_000):
        assert list(watched(range(200))) == list(range(200))
    with within(seconds=0), pytest.raises(LimitReached):
        next(watched([1]))


# --- the net ---------------------------------------------------------------------------------------------------------


@pytest.fixture
def quick_net(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(alarm, "GRACE", 0.0)
    monkeypatch.setattr(alarm, "_EVERY", 0.01)


def endless() -> None:
    while True:
        pass


@pytest.mark.usefixtures("quick_net")
def test_the_net_catches_what_meets_no_checkpoint() -> None:
    before = signal.getsignal(signal.SIGALRM)
    with pytest.raises(LimitReached, match="more than 0 seconds"), alarm.limited(0):
        endless()
    assert signal.getsignal(signal.SIGALRM) is before
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


@pytest.mark.usefixtures("quick_net")
def test_the_net_is_gone_behind_the_budget() -> None:
    with alarm.limited(1_000):
        pass
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


@pytest.mark.usefixtures("quick_net")
def test_a_net_inside_another_gives_the_timer_back() -> None:
    """The prompt runs scripts within the time of one input; a plugin is timed within that of a command."""

    def work() -> None:
        with alarm.limited(1_000):
            pass
        with alarm.ringing(lambda frame: None, 1_000, 1_000):
            pass
        endless()

    with pytest.raises(LimitReached, match=r"more than 0\.05 seconds"), alarm.limited(0.05):
        work()
    assert signal.getitimer(signal.ITIMER_REAL) == (0, 0)


def test_in_other_threads_there_are_checkpoints_only() -> None:
    found: list[object] = []

    def work() -> None:
        try:
            with alarm.limited(0):
                gc.straighten("[abcd]")
        except LimitReached as limited:
            found.append(limited)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert found


@pytest.mark.parametrize("each", [True, False])
def test_paced_items(each: bool) -> None:
    assert list(alarm.paced(iter(range(5)), 1_000, each=each)) == list(range(5))
    assert list(alarm.paced(iter(range(5)), None)) == list(range(5))


def test_pacing_counts_what_was_done_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """The clock jumps by 10 s in each item: together they take more than 25, alone none does."""
    now = [0.0]
    monkeypatch.setattr(alarm, "monotonic", lambda: now[0])
    monkeypatch.setattr(budget, "monotonic", lambda: now[0])

    def items() -> Iterator[int]:
        for n in range(5):
            now[0] += 10
            checkpoint()
            yield n

    assert list(alarm.paced(items(), 25, each=True)) == list(range(5))
    found = alarm.paced(items(), 25)
    assert [next(found), next(found)] == [0, 1]
    with pytest.raises(LimitReached):
        next(found)


# --- every stage meets checkpoints -----------------------------------------------------------------------------------


def polynomial(text: str) -> BracketPolynomial:
    found = expand(parse(text))
    assert isinstance(found, BracketPolynomial)
    return found


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
    "a robot": lambda: analyze_robot(read_robot("3-rps")),
    "factor": lambda: gc.factor(SHORT),
    "shorten": lambda: gc.shorten(SHORT),
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


# --- equal factors ---------------------------------------------------------------------------------------------------

FACTORS = (
    "[abcd]",
    "2[abce]",
    "([abcd] - [acde])",
    "(ab /\\ cd)",
    "[abcd]**2",
    "3",
    "1/2",
    "-1",
    "[(ab /\\ cde), a, bc]",
)


@given(st.lists(st.sampled_from(FACTORS), min_size=1, max_size=8))
def test_products_with_equal_factors(factors: list[str]) -> None:
    """The product of equal factors is what one gets by one multiplication after the other, and at exact points."""
    e = parse(" * ".join(factors))
    one_by_one = polynomial("1")
    for f in factors:
        one_by_one = one_by_one * polynomial(f)
    found = expand(e)
    assert isinstance(found, BracketPolynomial)
    there = random_rational_points("abcde", seed=len(factors))
    value = 1
    for f in factors:
        value = value * evaluate(parse(f), there)
    assert evaluate(e, there) == value
    assert evaluate(found.to_expr(), there) == value
    assert (found - one_by_one).terms == {}


@given(st.integers(1, 40), st.integers(2, 64))
def test_powers_at_exact_points(value: int, exponent: int) -> None:
    there = {**random_rational_points("abd", seed=value), "c": (value, 0, 0, 1)}
    e = parse(f"[abcd]**{exponent}")
    assert evaluate(e, there) == evaluate(parse("[abcd]"), there) ** exponent
    assert evaluate(e, there, modulus=10_007) == pow(evaluate(parse("[abcd]"), there), exponent, 10_007)


def test_thousands_of_equal_factors() -> None:
    found = gc.straighten(POWERS)
    assert isinstance(found, BracketPolynomial)
    ((monomial, c),) = found.terms.items()
    assert (len(monomial), set(monomial), c) == (64 * 9_000, {(0, 1, 2, 3)}, 1)
    assert found.text(short=True) == "[abcd]**576000"
    half = "[abcd]**64 " * 4_000
    assert gc.prove(f"{half} == {half}").verdict == "proved"


NESTED = [
    ("[abcd]", f"monomials of more than {MAX_BRACKETS:,} brackets"),
    ("(2[abcd])", "a coefficient has more than"),
    ("([abcd] + [abce])", "products of terms"),
]


@pytest.mark.parametrize(("base", "words"), NESTED, ids=[n[0] for n in NESTED])
def test_powers_of_powers_are_bounded(base: str, words: str) -> None:
    text = base
    for _ in range(20):
        text = f"({text}**64)"
    with pytest.raises(gc.GcrulesError, match=words):
        gc.expand(text, limit=2_000)
    with pytest.raises(LimitReached, match="a value has more than"):
        evaluate(parse(text), random_rational_points("abcde", seed=2))


SHOWN = [
    ("[abcd]**9", "[abcd]" * 9),
    ("[abcd]**10", "[abcd]**10"),
    ("2[abcd]**12[abce]", "2 * [abcd]**12 * [abce]"),
    ("[abcd]**64[abcd] + [abcd]", "[abcd] + [abcd]**65"),
]


@pytest.mark.parametrize(("text", "short"), SHOWN, ids=[s[0] for s in SHOWN])
def test_many_equal_brackets_are_shown_in_short_where_asked(text: str, short: str) -> None:
    found = polynomial(text)
    assert set(found.text(short=True).split(" + ")) == set(short.split(" + "))
    assert "**" not in found.text()
    assert "**" not in found.to_json()["polynomial"]
    assert MANY_EQUAL == 10
    if "65" not in short:
        assert expand(parse(found.text(short=True))) == found


def test_a_line_times_many_brackets_is_shown_in_short() -> None:
    found = gc.expand("[abcd]**20 ab")
    assert found.text(short=True) == "[abcd]**20 * ab"


def test_a_shortening_of_many_brackets_is_shown_in_short() -> None:
    found = gc.shorten("[abcd]**20 [abce]")
    assert found.text(short=True).startswith("[abcd]**20 * [abce]\n")
    assert "**" not in found.text().splitlines()[0]


def test_a_shortening_names_the_seconds_that_were_given(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gcrules.algebra.shortening.shorten._PREPARATION", 0.3)
    with pytest.raises(LimitReached, match=r"more than 0\.25 seconds"):
        gc.shorten("[[ab, cd, ef, gh, ij, kl]]**12", seconds=0.25)


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
QUICK = {"studio", "completion", "robot list", "robot show", "robot new"}  # they compute nothing


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
    assert without == QUICK


def test_the_page_lists_the_limits(root: Path) -> None:
    page = (root / "docs" / "limits.md").read_text(encoding="utf-8")
    assert f"| most commands | {SECONDS:g} seconds |" in page
    assert f"and {AROUND:g} seconds around it" in page


# --- the prompt ------------------------------------------------------------------------------------------------------


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
    fault = found["fault"] if name == "bench" else found
    assert kind == ("done" if name == "bench" else "fault")
    assert (fault["kind"], "more than 0 seconds" in fault["message"]) == ("limit", True)
    assert name == "bench" or "the command line" in fault["hint"]
