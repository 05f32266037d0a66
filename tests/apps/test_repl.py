"""The session: the interpreter, where inputs end, completion, transcripts from pipes, and the prompt itself."""

from __future__ import annotations

import os
import re
import select
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from hypothesis import example, given
from hypothesis import strategies as st

from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli import cli
from gcrules.apps.repl.answers import Answer, worst, wrapped
from gcrules.apps.repl.commands import HANDLERS
from gcrules.apps.repl.completion import candidates
from gcrules.apps.repl.help import TOPICS, help_text
from gcrules.apps.repl.highlight import KINDS, tokens
from gcrules.apps.repl.history import history_path, private_file
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import Source, pieces, statements, unfinished
from gcrules.apps.repl.state import Settings, State
from gcrules.apps.repl.tables import COMMANDS, KEYS, RELATIONS, RULE_WORDS, STATEMENTS, SYMBOLS
from gcrules.core.errors import GcrulesError
from gcrules.rules.script import run_script

OCTAHEDRON = "ab af cb cd ed ef"
MEET = r"rule meet: ab /\ cde => [acde] b - [bcde] a"


@pytest.fixture
def repl() -> Interpreter:
    return Interpreter()


def said(repl: Interpreter, text: str) -> list[str]:
    return [a.text for a in repl.feed(text)]


def verdicts(repl: Interpreter, text: str) -> list[str]:
    return [a.verdict for a in repl.feed(text)]


def fault(repl: Interpreter, text: str) -> GcrulesError:
    """The fault that is the last answer."""
    found = list(repl.feed(text))[-1].fault
    assert found is not None
    return found


# --- inputs and answers --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "verdict", "words"),
    [
        (r"ab /\ cde", "shown", "[acde] · b − [bcde] · a"),
        (r"ab /\ cd == [abcd]", "proved", "proved: ab ∧ cd == [abcd]\n  both sides"),
        ("[abcd] == [bacd]", "refuted", "refuted: [abcd] == [bacd]\n  the sides differ"),
        (r"show ab /\ cde", "shown", r"ab /\ cde = [acde] · b − [bcde] · a"),
        ('claim "swap": [abcd] == -[bacd]', "proved", "proved: swap"),
        ("claim [abcd] == 0", "refuted", "refuted: [abcd] == 0"),
        (r"let p = ab /\ cde", "done", "p = ab ∧ cde, a point (step 1)"),
        (MEET, "proved", "proved: rule meet"),
        (r"rule no: ab /\ cde => [acde] b", "refuted", "refuted: rule no\n    the rule no is no identity"),
        (r"rewrite ab /\ cde", "shown", "no rule fires"),
        (r":expand ab /\ cde", "shown", "[acde] · b − [bcde] · a"),
        (r":prove ab /\ cd == [abcd]", "proved", "proved"),
        (":straighten [adef][bcgh]", "shown", "−[abcd][efgh] + "),
        (":steps [aefg][bcdh]", "shown", "[aefg][bcdh] = "),
        (r":latex ab /\ cde", "shown", r"ab \wedge cde"),
        (f":analyze {OCTAHEDRON}", "shown", "the four planes abc, aef, bdf and cde meet in a point"),
        (":analyze examples/octahedral.yaml", "shown", "closeness    0.4307"),
        (":context", "done", "rank        4"),
        (":rules", "done", "no rules yet"),
        (":unicode", "done", "Unicode on"),
        (":limit", "done", "limit 200,000 terms"),
        (":limit 5000", "done", "limit 5,000 terms"),
        (":seconds", "done", "no limit of time"),
        (":seconds 2.5", "done", "limit 2.5 seconds"),
        (":seconds inf", "done", "no limit of time"),
        (":help", "done", "Commands"),
        (":?", "done", "Commands"),
        (":help save", "done", ":save FILE.gca"),
        (":ste [aefg][bcdh]", "shown", "[aefg][bcdh] = "),
    ],
    ids=lambda value: str(value)[:30],
)
def test_an_input_is_answered(
    repl: Interpreter, root: Path, monkeypatch: pytest.MonkeyPatch, text: str, verdict: str, words: str
) -> None:
    monkeypatch.chdir(root)
    (answer,) = repl.feed(text)
    assert answer.verdict == verdict
    assert words in answer.text


@pytest.mark.parametrize("text", ["", "   ", "# nothing", "rank 3", "points a left", "ideal i j", ":quit"])
def test_some_inputs_are_silent(repl: Interpreter, text: str) -> None:
    assert said(repl, text) == []


def test_assumptions_hold_from_then_on(repl: Interpreter) -> None:
    assert verdicts(repl, "[abcd] == 0\ngiven collinear(a, b, c)\n[abcd] == 0") == ["refuted", "proved"]


def test_rules_rewrite(repl: Interpreter) -> None:
    text = said(repl, f"{MEET}\nrewrite pq /\\ rst\n%")
    assert text[1].splitlines()[-1].strip() == r"by meet: ab /\ cde => [acde] b - [bcde] a"
    assert text[2] == "[prst] · q − [qrst] · p"


@pytest.mark.parametrize(("rank", "ranks"), [("", "2 3 4 5 6 7 8"), ("rank 4\n", "4"), ("rank 3\n", "3")])
def test_a_rule_in_a_stated_rank_stands_in_that_rank(repl: Interpreter, rank: str, ranks: str) -> None:
    rule = "rule two: [R... a d][R... b c] => [R... a c][R... b d] - [R... a b][R... c d] if a < b, b < c, c < d"
    *_, shown = said(repl, f"{rank}{rule}\n:rules two")
    assert f"ranks       {ranks}" in shown.splitlines()


def test_a_refuted_rule_is_not_kept_and_its_id_is_free(repl: Interpreter) -> None:
    assert verdicts(repl, f"rule meet: ab /\\ cde => [acde] b\n{MEET}") == ["refuted", "proved"]
    assert [r.id for r in repl.state.rules] == ["meet"]
    assert "there is a rule meet already" in fault(repl, MEET).message


def test_everything_the_tables_name_exists() -> None:
    assert set(HANDLERS) == set(COMMANDS)
    assert set(COMMANDS) | set(STATEMENTS) <= set(TOPICS)
    overview = help_text("")
    assert all(c.usage in overview for c in COMMANDS.values())
    assert all(usage in overview for usage, _ in STATEMENTS.values())
    assert all(key in help_text("keys") for key, _ in KEYS)


def test_the_words_are_those_of_the_grammar(root: Path) -> None:
    grammar = (root / "gcrules" / "grammar.lark").read_text(encoding="utf-8")
    words = set(re.findall(r'"([a-z]{2,})"', grammar))
    relations = re.search(r"RELATION\.1: /\(([a-z|]+)\)", grammar)
    assert relations is not None
    assert words | set(relations[1].split("|")) == {*STATEMENTS, *RULE_WORDS, *RELATIONS}


@pytest.mark.parametrize("sign", sorted(set(SYMBOLS.values()) - {"\u0307", "…"}))
def test_signs_are_read(sign: str) -> None:
    text = {"∧": f"ab {sign} cde", "∨": f"ab {sign} c"}.get(sign, f"2 {sign} a" if sign != "−" else f"{sign}a")
    parse(text)


# --- the last result -----------------------------------------------------------------------------------------------


def test_the_last_results(repl: Interpreter) -> None:
    assert said(repl, "2a\n3b\n% + %%\n%%%") == ["2 · a", "3 · b", "3 · b + 2 · a", "2 · a"]
    assert said(repl, ":straighten") == ["2 · a"]


def test_results_of_every_kind(repl: Interpreter) -> None:
    assert said(repl, f":analyze {OCTAHEDRON}\n:latex")[1] == r"abc \wedge aef \wedge bdf \wedge cde"
    assert said(repl, ":straighten [bacd]\n%") == ["−[abcd]"] * 2


def test_a_result_side_by_side_with_points(repl: Interpreter) -> None:
    assert said(repl, "a + b\nc%d") == ["b + a", "−bcd − acd"]


def test_percent_in_a_label_is_a_percent(repl: Interpreter) -> None:
    assert said(repl, '[abcd]\nclaim "100%": % == [abcd]')[1] == "proved: 100%"
    assert repl.state.statements == ('claim "100%": ([abcd]) == [abcd]',)


def test_messages_name_results_as_they_were_typed(repl: Interpreter) -> None:
    assert said(repl, "[abcd]\nclaim % == 0")[1].startswith("refuted: % == 0")
    assert "last__" not in fault(repl, "let % = a").render()


@pytest.mark.parametrize(
    ("before", "text", "place"),
    [
        ("", "a + %", "<input>:1:5"),
        ("a", "b + %%", "<input>:1:5"),
        ("[abcd]", r"% + % /\ a", "<input>:1:5"),
        ("[abcd]", "% + % + abc", "<input>:1:9"),
        ("a", "let q = % + %\nlet r = % + ab", "<input>:2:13"),
        ("[abcd]", "claim % == 0 claim % == a", "<input>:1:20"),
        ("p", "let p = ab\n%", "<input>:2:1"),
        ("[abcd]", "given % == 0", "<input>:1:7"),
        ("[abcd]", "rule x: % => 0", "<input>:1:9"),
    ],
)
def test_faults_stand_where_they_were_typed(repl: Interpreter, before: str, text: str, place: str) -> None:
    said(repl, before)
    assert fault(repl, text).place == place


def test_a_new_rank_forgets_results(repl: Interpreter) -> None:
    assert "there is no result yet" in fault(repl, "[abcd]\nrank 3\n%").message


# --- faults --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "message", "place", "hint"),
    [
        (r"ab /\ c", "are too small to meet in rank 4", "1:1", "did you mean a join"),
        (r"show ab /\ c", "are too small to meet", "1:6", ""),
        (r":straighten ab /\ c", "are too small to meet", "1:13", ""),
        ("claim [abcd] == 0 show [ab", "the input ends too early", "1:27", "a bracket is not closed"),
        ("let p = a\nlet p = b", "p is already declared", "2:5", "choose another name"),
        ("let p = a\nrank 3", "`rank` must come before", "2:1", ":reset"),
        ("rank 4\nrank 3", "`rank` must come before", "2:1", ":reset"),
        (":anlyze ab", "there is no command :anlyze", "1:1", "did you mean :analyze?"),
        (":s", "several commands begin so: :straighten, :steps, :seconds, :save", "1:1", ""),
        (":", "there is no command :", "1:1", ":help"),
        (":undo 3", ":undo stands alone", "1:7", ""),
        (":undo", "there is nothing to take back", "1:1", ""),
        (":analyze ab af cb cd ed", "5 legs, expected six", "1:10", ""),
        (":analyze ab af cb cd ed e(", "", "1:25", ""),
        (":analyze", "no legs", "1:1", ":analyze ab af"),
        (f"rank 3\n:analyze {OCTAHEDRON}", "in rank 4", "2:10", ":reset"),
        (":prove", "no equation to prove", "1:1", ":prove LHS == RHS"),
        (":prove ab", "", "1:10", ""),
        (":steps ab", "this is a line (step 2)", "1:8", ""),
        (":steps", "there is no result yet", "1:1", ""),
        (":unicode perhaps", "'perhaps' is neither on nor off", "1:10", ":unicode [on|off]"),
        (":limit none", "a number of terms", "1:8", ""),
        (":limit 0", "a number of terms", "1:8", ""),
        (":seconds none", "a number of seconds", "1:10", ""),
        (":seconds -1", "a number of seconds", "1:10", ""),
        (":seconds nan", "a number of seconds", "1:10", ""),
        (":rules nosuch", "there is no rule nosuch", "1:8", ":rules"),
        (":load", "no name of a file", "1:1", ":load FILE.gca"),
        (":save", "no name of a file", "1:1", ":save FILE.gca"),
        (":save x.gca", "there are no statements to save", "1:7", ""),
        (":help savee", "no help on savee", "", "did you mean save?"),
        (":load nosuch.gca", "there is no such file", "nosuch.gca", ""),
    ],
    ids=lambda value: str(value)[:30],
)
def test_faults_have_a_place(repl: Interpreter, text: str, message: str, place: str, hint: str) -> None:
    found = fault(repl, text)
    assert message in found.message
    assert (found.place or "").removeprefix("<input>:") == place
    assert hint in (found.hint or "")
    if place[:1].isdigit():
        line, column = map(int, place.split(":"))
        shown = found.render().splitlines()
        assert shown[1] == "  " + text.split("\n")[line - 1]
        assert shown[2].index("^") == 2 + column - 1


def test_a_fault_leaves_the_state_alone(repl: Interpreter) -> None:
    said(repl, "points left\nlet p = [left a b c]")
    before = repl.state
    for text in ("show [ab", "let p = a", "claim [ab", ":foo", "points 3", ":load nosuch.gca"):
        assert verdicts(repl, text) == ["fault"]
    assert repl.state == before


def test_what_stands_before_a_fault_holds(repl: Interpreter) -> None:
    assert verdicts(repl, r"let p = [abcd] show p let q = ab /\ c let r = p") == ["done", "shown", "fault"]
    assert list(repl.state.context.bound) == ["p"]
    said(repl, ":undo")
    assert repl.state == State()


def test_limits_are_answers(repl: Interpreter) -> None:
    (answer,) = list(repl.feed(":limit 3\nshow [[ab,cd,ef,gh,ij,kl]]"))[1:]
    assert (answer.verdict, answer.code) == ("undecided", 3)
    assert ":limit N" in answer.text
    assert repl.state.statements == ()
    (answer,) = repl.feed(":straighten [[ab,cd,ef,gh,ij,kl]]")
    assert (answer.verdict, answer.code) == ("undecided", 3)
    assert ":limit N" in answer.text
    assert "--limit" not in answer.text


def test_an_interrupt_keeps_the_state(repl: Interpreter, monkeypatch: pytest.MonkeyPatch) -> None:
    import gcrules.rules.script

    said(repl, "points left")
    before = repl.state

    def interrupted(*args: object, **options: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(gcrules.rules.script, "prove", interrupted)
        with pytest.raises(KeyboardInterrupt):
            said(repl, "claim [abcd] == 0")
        assert repl.state == before
        with pytest.raises(KeyboardInterrupt):
            said(repl, "let p = a claim [abcd] == 0 let q = b")
    assert list(repl.state.context.bound) == ["p"]
    said(repl, ":undo")
    assert repl.state == before


# --- undo, save and load -------------------------------------------------------------------------------------------

INPUTS = (
    "points left right",
    "ideal i j",
    "given collinear(a, b, c)",
    "let p = ab /\\ cde",
    "let q = [abcd]",
    "let r = %",
    "claim [abcd] == 0",
    "claim [abcd] == -[bacd]",
    "show ab /\\ cde",
    MEET,
    "rewrite pq /\\ rst",
    "[abce] b",
    "[abcd] == 0",
    "ab /\\ c",
    "rank 3",
    "[abc",
    ":reset",
    ":latex on",
    ":straighten [adef][bcgh]",
)
sessions = st.lists(st.sampled_from(INPUTS), max_size=8)


@given(sessions, st.sampled_from(INPUTS))
@example([], ":reset")
def test_undo_takes_back_one_input(before: list[str], text: str) -> None:
    repl = Interpreter()
    for line in before:
        said(repl, line)
    state, past = repl.state, repl.past
    said(repl, text)
    if repl.state.kept != state.kept:
        said(repl, ":undo")
        assert repl.state == state
    assert repl.past == past


@given(sessions)
def test_undo_leads_back_to_the_beginning(inputs: list[str]) -> None:
    repl = Interpreter()
    for line in inputs:
        said(repl, line)
    for _ in inputs:
        said(repl, ":undo")
    assert repl.state.kept == State().kept
    assert fault(repl, ":undo").message == "there is nothing to take back"


@given(sessions)
def test_what_is_saved_runs_and_leads_to_the_same(inputs: list[str]) -> None:
    repl = Interpreter()
    for line in inputs:
        said(repl, line)
    script = parse_script(repl.state.script(), "saved.gca")
    assert script.context == repl.state.context
    result = run_script(script)
    assert all(r.verdict in ("proved", "shown") for r in result.results)
    again = Interpreter()
    for line in repl.state.statements:
        said(again, line)
    assert again.state.kept[0] == repl.state.context
    assert again.state.statements == repl.state.statements


def test_save_and_load(repl: Interpreter, tmp_path: Path) -> None:
    path = tmp_path / "a file.gca"
    said(repl, f"rank 3\nlet p = ab /\\\n  cd\nclaim [abc] == 0\n{MEET.replace('e', '')}\nclaim p == [acd] b - [bcd] a")
    (answer,) = repl.feed(f':save "{path}"')
    assert answer.text == f"3 statements written to {path}"
    text = path.read_text(encoding="utf-8")
    assert text == "rank 3\nlet p = ab /\\\n  cd\nclaim p == [acd] b - [bcd] a\n"
    other = Interpreter()
    assert said(other, f":load {path}") == ["line 4: proved: p == [acd] b - [bcd] a"]
    assert other.state.kept == repl.state.kept
    done = CliRunner().invoke(cli, ["run", str(path)])
    assert (done.exit_code, done.stdout.splitlines()[-1]) == (0, "1 claim: 1 proved")


def test_save_to_standard_output(repl: Interpreter) -> None:
    assert said(repl, "let p = a # a point\n:save -")[1] == "let p = a"


def test_a_file_that_cannot_be_written(repl: Interpreter, tmp_path: Path) -> None:
    assert "is a directory" in fault(repl, f"let p = a\n:save {tmp_path}").message
    assert "no such directory" in fault(repl, f":save {tmp_path}/x/y.gca").message


def test_a_script_that_is_too_long_is_not_saved(repl: Interpreter, tmp_path: Path) -> None:
    path = tmp_path / "x.gca"
    path.write_text("as before", encoding="utf-8")
    repl.state = State(statements=(f"show {'[abcd]' * 9_000}",) * 2)
    assert "the limit is 100,000" in fault(repl, f":save {path}").message
    assert path.read_text(encoding="utf-8") == "as before"


def test_load_is_one_step_and_names_lines(repl: Interpreter, tmp_path: Path) -> None:
    path = tmp_path / "x.gca"
    path.write_text("# comment\nlet p = ab\n\nclaim p == -ba   claim p == cd\nshow p /\\ c\n", encoding="utf-8")
    *answers, last = repl.feed(f":load {path}")
    assert [a.text.splitlines()[0] for a in answers] == ["line 4: proved: p == -ba", "line 4: refuted: p == cd"]
    assert last.fault is not None
    assert last.fault.place == f"{path}:5:6"
    assert repl.state.statements == ("let p = ab", "claim p == -ba")
    assert said(repl, ":undo") == ["taken back: 2 statements"]
    assert repl.state == State()


def test_reset_and_back(repl: Interpreter) -> None:
    said(repl, "let p = a\nlet q = b")
    assert said(repl, ":reset\n:context\n:undo") == [
        "forgotten: 2 statements; :undo brings this back",
        "rank        4",
        "back again: 2 statements",
    ]
    assert list(repl.state.context.bound) == ["p", "q"]


def test_context_shows_what_is_declared(repl: Interpreter) -> None:
    said(repl, f"points a left\nideal i\ngiven collinear(a, b, c)\nlet p = [abcd]\n{MEET}\n2a")
    assert said(repl, ":context") == [
        "rank        4\npoints      a left\nideal       i\ngiven       collinear(a, b, c)\n"
        "let         p = [a b c d], a scalar (step 0)\nrules       meet\n%           2 · a"
    ]


def test_settings_change_how_answers_look(repl: Interpreter) -> None:
    assert said(repl, ":latex on\nab /\\ cde\n[abcd] == 0")[1:] == [
        r"[acde]\,b - [bcde]\,a",
        "[abcd] \\neq 0\n% refuted: the sides differ at these points (homogeneous coordinates)",
    ]
    assert said(repl, "rewrite ab /\\ cde")[0].startswith("\\begin{align*}")
    assert said(repl, ":latex off\n:unicode off\nab /\\ cde")[2] == "[acde] * b - [bcde] * a"
    assert repl.settings == Settings(unicode=False)


# --- where inputs end ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "[ab",
        "(ab /\\ cd",
        "[[ab, cd, ef",
        "ab +",
        "ab /\\",
        "ab ∧",
        "2 *",
        "ab ==",
        "% +",
        "let p =",
        "let",
        "points",
        "claim",
        'claim "x":',
        "claim ab ==",
        "given collinear(a, b",
        "given collinear(a, b, c),",
        "rule x: ab =>",
        "rule x: ab => ba if",
        "rule x: ab => ba if a < b,",
        "show",
        "let p = [ab # comment",
        ":expand [ab",
        ":prove ab ==",
        ":latex [ab",
        "rank",
    ],
)
def test_unfinished(text: str) -> None:
    assert unfinished(text)


@pytest.mark.parametrize(
    "text",
    [
        *("", "# x", "ab", "[ab)", "ab) +", "rank 3", "let p = a", "let 3", "(" * 200, '"', "points a", "claim a == b"),
        *(
            "ab /\\ c",
            "rule x: ab => ba",
            ":",
            ":help",
            ":expand",
            ":load [",
            ":undo",
            ":foo [",
            ":latex on",
            ":analyze ab",
        ),
    ],
)
def test_finished(text: str) -> None:
    assert not unfinished(text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a\nb", ["a", "b"]),
        ("[a\nb\ncd]\ne", ["[a\nb\ncd]", "e"]),
        ("a\n  + b\nc", ["a\n  + b", "c"]),
        ("# x\n\na # y\n# z\nb", ["a # y", "b"]),
        ("rule x: a b => b a\nif a < b\nfires cd\n\nif", ["rule x: a b => b a\nif a < b\nfires cd", "if"]),
        ("[ab\n\ncd", ["[ab", "cd"]),
        ("[ab\n:undo", ["[ab", ":undo"]),
        (":save -\ngiven collinear(a, b, c)", [":save -", "given collinear(a, b, c)"]),
        (":context\n  ab", [":context", "  ab"]),
        (":expand [ab\ncd]", [":expand [ab\ncd]"]),
        ("a +\nb\n+ c", ["a +\nb", "+ c"]),
    ],
)
def test_pieces(text: str, expected: list[str]) -> None:
    assert [p.text for p in pieces(text.split("\n"))] == expected


def test_pieces_know_their_line() -> None:
    assert [p.line for p in pieces(["", "a +", "b", "# x", "c"])] == [2, 5]


def test_at_the_keyboard_an_input_is_answered_at_once() -> None:
    """Only as many lines are read as are needed."""
    read = []

    def lines() -> Iterator[str]:
        for line in ("a", "[b", "cde]", "f"):
            read.append(line)
            yield line

    found = pieces(lines(), ahead=False)
    assert (next(found).text, read) == ("a", ["a"])
    assert (next(found).text, read) == ("[b\ncde]", ["a", "[b", "cde]"])


def test_many_unfinished_lines_take_no_long_time() -> None:
    start = time.monotonic()
    for line in ("a +", "[", "a,"):
        assert len(list(pieces([line] * 20_000))) == 1
    assert time.monotonic() - start < 20


def test_statements_stand_in_their_place() -> None:
    source = Source.of("let p = % let q = a\nshow p + q", "x.gca", line=3)
    parts = statements(source)
    assert [p.line for p in parts] == [3, 3, 4]
    assert [len(p.used()) for p in parts] == [1, 0, 0]


# --- completion and colours ----------------------------------------------------------------------------------------


@pytest.fixture
def declared(repl: Interpreter) -> State:
    said(repl, f"points left right\nideal infinity\nlet pencil = left right\n{MEET}")
    return repl.state


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        (":", [f":{n}" for n in COMMANDS]),
        (":st", [":straighten", ":steps"]),
        ("cl", ["claim"]),
        ("r", ["rank", "rule", "rewrite", "right"]),
        ("show r", ["right"]),
        ("show ab /\\ le", ["left"]),
        ("show aleft ri", ["right"]),
        ("[left ri", ["right"]),
        ("abri", ["right"]),
        ("inf", ["infinity"]),
        (":expand pen", ["pencil"]),
        (":analyze le", ["left"]),
        ("given col", ["collinear"]),
        ("given concurrent(pen", ["pencil"]),
        ("rule x: ab => ba i", ["if", "infinity"]),
        ("rule x: ab => ba if coll", ["collinear"]),
        (":rules m", ["meet"]),
        (":help st", ["straighten", "steps"]),
        (":unicode o", ["on", "off"]),
        (":latex o", ["on", "off"]),
        ("ab \\we", ["∧"]),
        ("ab \\v", ["∨"]),
        ("ab \\do", ["\u0307", "…"]),
        ("ab /\\", ["left", "right", "infinity", "pencil"]),
        (":foo x", []),
        ("left", []),
        ("xyz", []),
    ],
)
def test_completion(declared: State, before: str, expected: list[str]) -> None:
    assert [c.text for c in candidates(before, declared)] == expected


def test_completion_of_nothing_offers_everything() -> None:
    assert {c.text for c in candidates("", State())} == {*STATEMENTS, *(f":{n}" for n in COMMANDS)}


def test_completion_of_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    for name in ("plane.gca", "robot.yaml", ".hidden.gca", "folder/two words.gca"):
        (tmp_path / name).write_text("", encoding="utf-8")
    offered: Callable[[str], list[str]] = lambda text: [c.text for c in candidates(text, State())]  # noqa: E731
    assert offered(":load ") == ["folder/", "plane.gca"]
    assert offered(":load pl") == ["plane.gca"]
    assert offered(":save folder/t") == ["two words.gca"]
    assert offered(f":load {tmp_path}/.h") == [".hidden.gca"]
    assert offered(":analyze ro") == ["robot.yaml"]
    assert offered(":load nosuch/") == []


TEXTS = st.one_of(
    st.text(),
    st.text(alphabet='ab[]()/\\∧∨%:=+-*2"#., \nletclaimshowgivenrulerank'),
    st.lists(
        st.sampled_from(
            [
                *(*STATEMENTS, *RULE_WORDS, *RELATIONS),
                *(f":{c}" for c in COMMANDS if c not in ("save", "load")),
                *(
                    "%",
                    "%%",
                    "a",
                    "ab",
                    "[abcd]",
                    "/\\",
                    "+",
                    "==",
                    "=",
                    "=>",
                    "(",
                    ")",
                    "[",
                    ",",
                    "\n",
                    "3",
                    '"x"',
                    ":",
                    ".",
                ),
            ]
        ),
        max_size=12,
    ).map(" ".join),
)


@given(TEXTS)
@example("\ud800")
@example("a\x00b")
def test_any_text_has_colours_and_completions(text: str) -> None:
    runs = list(tokens(text, ("p",)))
    assert "".join(t for _, t in runs) == text
    assert {k for k, _ in runs} <= {"", *KINDS}
    candidates(text, State())
    unfinished(text)


def test_colours() -> None:
    kinds = {t: k for k, t in tokens('claim "x": collinear p [ab] /\\ %% 1/2 # y', ("p",)) if k}
    assert kinds == {
        "claim": "keyword",
        '"x"': "string",
        ":": "operator",
        "collinear": "relation",
        "p": "name",
        "ab": "point",
        "/\\": "operator",
        "%%": "result",
        "1/2": "number",
        "# y": "comment",
    }
    assert next(tokens(":expand ab")) == ("command", ":expand ")
    assert next(tokens(":nosuch ab")) == ("fault", ":nosuch ")


# --- whatever is typed ---------------------------------------------------------------------------------------------


@given(st.lists(TEXTS.filter(lambda t: not re.search(r":\s*(s|sa|sav|save|lo|loa|load)\b", t)), max_size=3))
@example(["\ud800"])
@example([":\x00", "% %", ":undo\r"])
@example(["let a = b\nlet a = b", "points % b", "[abcd]", "points %", "rule % : a => a"])
def test_whatever_is_typed_is_answered(texts: list[str]) -> None:
    repl = Interpreter(settings=Settings(limit=1_000))
    for text in texts:
        for answer in repl.feed(text):
            assert isinstance(answer, Answer)
            assert answer.verdict in ("proved", "refuted", "undecided", "shown", "done", "fault")
            assert "last__" not in answer.text
    parse_script(repl.state.script())


# --- without a terminal --------------------------------------------------------------------------------------------


@pytest.fixture
def run() -> Callable[..., Result]:
    def invoke(*arguments: str, input: str | bytes = "") -> Result:
        result = CliRunner().invoke(cli, ["repl", *arguments], input=input, prog_name="gcrules")
        if result.exception is not None and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result

    return invoke


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
def test_exit_codes(run: Callable[..., Result], text: str, code: int) -> None:
    assert run(input=text).exit_code == code
    assert worst([0, 3, 1, 2, 0]) == 2


def test_a_transcript(run: Callable[..., Result]) -> None:
    result = run("--ascii", "--echo", input="points left\n\n[left\n a b c]\n% == 0\n:quit\n[")
    assert result.stdout.splitlines()[:5] == [
        "> points left",
        "> [left",
        "   a b c]",
        "-[a b c left]" if "-[a b c left]" in result.stdout else "[left a b c]",
        "> % == 0",
    ]
    assert result.stdout.splitlines()[-1] == "> :quit"


def test_faults_of_a_pipe_name_the_line_and_go_to_stderr(run: Callable[..., Result]) -> None:
    result = run(input="ab\n\nlet p = a +\n  b + cd\nab")
    assert result.exit_code == 2
    assert result.stdout == "ab\nab\n"
    assert result.stderr.startswith("error: <stdin>:4:7: cannot add a line")


def test_a_file_comes_first(run: Callable[..., Result], root: Path, tmp_path: Path) -> None:
    result = run(str(root / "examples" / "plane.gca"), input="[x, y, z] == 0")
    assert (result.exit_code, result.stdout.splitlines()[0]) == (1, "line 4: proved: three-term relation")
    assert run(str(tmp_path / "nosuch.gca")).exit_code == 2


def test_inputs_as_options(run: Callable[..., Result]) -> None:
    assert run("--ascii", "-e", "-[abcd]", "-e", "% * 2", input="no [").stdout == "-[abcd]\n-2[abcd]\n"
    assert run("--limit", "3", "-e", "[[ab,cd,ef,gh,ij,kl]]").exit_code == 3


def test_a_pipe_that_is_no_text(run: Callable[..., Result]) -> None:
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
    assert repl.state == State()


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
