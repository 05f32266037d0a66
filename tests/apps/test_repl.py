"""The session: inputs and answers, faults, undo, save and load; whatever is typed is answered."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from apps.repl_session import MEET, TEXTS, said
from click.testing import CliRunner
from hypothesis import example, given
from hypothesis import strategies as st

from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli import cli
from gcrules.apps.repl.answers import Answer
from gcrules.apps.repl.commands import HANDLERS
from gcrules.apps.repl.help import TOPICS, help_text
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.state import PromptState, Settings
from gcrules.apps.repl.tables import COMMANDS, KEYS, RELATIONS, RULE_WORDS, SHELL, STATEMENTS, SYMBOLS
from gcrules.core.errors import GcrulesError
from gcrules.rules.script import run_script

OCTAHEDRON = "ab af cb cd ed ef"


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
        (r"rule no: ab /\ cde => [acde] b", "refuted", "refuted: rule no\n    the rule no is not an identity"),
        (r"rewrite ab /\ cde", "shown", "no rule fires"),
        (r":expand ab /\ cde", "shown", "[acde] · b − [bcde] · a"),
        (r":prove ab /\ cd == [abcd]", "proved", "proved"),
        (":straighten [adef][bcgh]", "shown", "−[abcd][efgh] + "),
        (":steps [aefg][bcdh]", "shown", "[aefg][bcdh] = "),
        (":factor [abfc][acde][bdef] + [abfd][acbe][cdef]", "shown", "abc ∧ aef ∧ bdf ∧ cde"),
        (":shorten [abcd][efgh] - [abcd][efhg]", "shown", "2[abcd][efgh]"),
        (":discover", "shown", "nothing new among"),
        (":transversals Aa Ab Bc Cd De Ef", "shown", "the robot is singular exactly when the two ratios agree"),
        (r":latex ab /\ cde", "shown", r"ab \wedge cde"),
        (f":analyze {OCTAHEDRON}", "shown", "the four planes abc, aef, bdf and cde meet in a point"),
        (":analyze examples/octahedral.yaml", "shown", "margin       0.4307"),
        (":context", "done", "rank        4"),
        (":rules", "done", "no rules yet"),
        (":unicode", "done", "Unicode on"),
        (":limit", "done", "limit 200,000 terms"),
        (":limit 5000", "done", "limit 5,000 terms"),
        (":seconds", "done", "no limit of time"),
        (":seconds 2.5", "done", "limit 2.5 seconds"),
        (":seconds inf", "done", "no limit of time"),
        (":memory 2.5", "done", "limit 2.5 GB of memory"),
        (":memory inf", "done", "no limit of memory"),
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
    relations = re.search(r"RELATION\.1: /\(([a-z_|]+)\)", grammar)
    assert relations is not None
    letters = re.search(r"LETTERS\.1: /\(([a-z|]+)\)", grammar)
    assert letters is not None
    words.update(letters[1].split("|"))
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
        (":s", "several commands begin like this: :straighten, :steps, :shorten, :seconds, :save", "1:1", ""),
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
        (":memory -1", "a number of gigabytes", "1:9", ""),
        (":rules nosuch", "there is no rule nosuch", "1:8", ":rules"),
        (":load", "a file name is missing", "1:1", ":load FILE.gca"),
        (":save", "a file name is missing", "1:1", ":save FILE.gca"),
        (":save x.gca", "there are no statements to save", "1:7", ""),
        (":help savee", "no help on savee", "", "did you mean save?"),
        (":load nosuch.gca", "there is no such file", "nosuch.gca", ""),
        ("pose delta", "`pose` is a command of the shell", "1:1", "in a shell: gcrules pose delta"),
        ('analyze "ab af cb cd ed"', "5 legs, expected six", "1:10", ""),
        ('prove "ab == ac == ad"', "", "1:17", ""),
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
    assert repl.state == PromptState()


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
        patch.setattr(gcrules.rules.script, "decide", interrupted)
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
    if repl.state.settled != state.settled:
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
    assert repl.state.settled == PromptState().settled
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
    assert again.state.settled[0] == repl.state.context
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
    assert other.state.settled == repl.state.settled
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
    repl.state = PromptState(statements=(f"show {'[abcd]' * 9_000}",) * 2)
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
    assert repl.state == PromptState()


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


def test_the_commands_of_the_shell_are_known() -> None:
    assert set(cli.commands) <= {*SHELL, *COMMANDS, *STATEMENTS}


@pytest.mark.parametrize(
    ("command", "argument"),
    [
        ("analyze", OCTAHEDRON),
        ("prove", r"ab /\ cd == [abcd]"),
        ("factor", "[abcd][efgh]"),
        ("expand", r"(ab /\ cde) \/ f"),
    ],
)
@pytest.mark.parametrize("quote", ['"', "'"])
def test_what_a_command_takes_may_stand_in_quotes_as_in_the_shell(
    repl: Interpreter, command: str, argument: str, quote: str
) -> None:
    (quoted,) = repl.feed(f"{command} {quote}{argument}{quote}")
    (plain,) = repl.feed(f":{command} {argument}")
    assert quoted.fault is None
    assert quoted.text == plain.text
