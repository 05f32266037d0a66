"""The session: where inputs end, completion, colours."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from apps.repl_session import MEET, TEXTS, said
from hypothesis import example, given

from gcrules.apps.repl import reading
from gcrules.apps.repl.completion import candidates
from gcrules.apps.repl.highlight import KINDS, tokens
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import Source, pieces, statements, unfinished
from gcrules.apps.repl.state import PromptState
from gcrules.apps.repl.tables import COMMANDS, STATEMENTS

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


def test_many_unfinished_lines_are_not_read_again_with_each(monkeypatch: pytest.MonkeyPatch) -> None:
    """20,000 lines, each read with all before it, would be billions of characters."""
    read: list[int] = []
    looked = reading.unfinished
    monkeypatch.setattr(reading, "unfinished", lambda text: read.append(len(text)) or looked(text))
    for line in ("a +", "[", "a,"):
        assert len(list(pieces([line] * 20_000))) == 1
    assert sum(read) < 1_000_000


def test_statements_stand_in_their_place() -> None:
    source = Source.of("let p = % let q = a\nshow p + q", "x.gca", line=3)
    parts = statements(source)
    assert [p.line for p in parts] == [3, 3, 4]
    assert [len(p.used()) for p in parts] == [1, 0, 0]


# --- completion and colours ----------------------------------------------------------------------------------------


@pytest.fixture
def declared(repl: Interpreter) -> PromptState:
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
def test_completion(declared: PromptState, before: str, expected: list[str]) -> None:
    assert [c.text for c in candidates(before, declared)] == expected


def test_completion_of_nothing_offers_everything() -> None:
    assert {c.text for c in candidates("", PromptState())} == {*STATEMENTS, *(f":{n}" for n in COMMANDS)}


def test_completion_of_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    for name in ("plane.gca", "robot.yaml", ".hidden.gca", "folder/two words.gca"):
        (tmp_path / name).write_text("", encoding="utf-8")
    offered: Callable[[str], list[str]] = lambda text: [c.text for c in candidates(text, PromptState())]  # noqa: E731
    assert offered(":load ") == ["folder/", "plane.gca"]
    assert offered(":load pl") == ["plane.gca"]
    assert offered(":save folder/t") == ["two words.gca"]
    assert offered(f":load {tmp_path}/.h") == [".hidden.gca"]
    assert offered(":analyze ro") == ["robot.yaml"]
    assert offered(":load nosuch/") == []


@given(TEXTS)
@example("\ud800")
@example("a\x00b")
def test_any_text_has_colours_and_completions(text: str) -> None:
    runs = list(tokens(text, ("p",)))
    assert "".join(t for _, t in runs) == text
    assert {k for k, _ in runs} <= {"", *KINDS}
    candidates(text, PromptState())
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
