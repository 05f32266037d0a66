"""Manual mode: undone, redone, saved, loaded; files that were tampered with."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conditions.by_hand import played
from hypothesis import given, settings
from hypothesis import strategies as st

from gcrules.conditions.manual import MOVES, ManualSession, load_session, save_session
from gcrules.conditions.manual.file import parse_session, session_yaml
from gcrules.core.errors import FileError, InputError

OCTAHEDRON = "ab af cb cd ed ef"


# --- undo, redo, files ---------------------------------------------------------------------------------------------

COMMANDS = [
    "plane abc", "plane abd", "plane bdf", "plane cde", "plane aef", "plane ace", "line ab", "line cd", "pair a e",
    "pair a c",
    "tetrahedron abce", "condition", r"condition abc /\ aef /\ bdf /\ cde", "condition [abcd][abef][cdef]", "shortest",
    "form 16", "order 6 5 4 3 2 1", "undo", "undo", "redo", "auto", "nonsense", "plane xyz",
]  # fmt: skip


def tried(session: ManualSession, command: str) -> ManualSession:
    try:
        return session.do(command)
    except InputError:
        return session


@settings(max_examples=60)
@given(st.lists(st.sampled_from(COMMANDS), max_size=12))
def test_undo_redo_and_files(commands: list[str]) -> None:
    session = ManualSession.start(OCTAHEDRON)
    for command in commands:
        before, session = session, tried(session, command)
        if command not in MOVES and session != before:
            assert session.history[:-1] == before.history
            assert (session.board == before.board) or session.outcome is None or not session.outcome.refused
    steps = sum(not r.outcome.refused for r in session.history)
    back = session
    for _ in range(steps):
        assert back.undo().redo() == back
        back = back.undo()
    assert back.board == ManualSession.start(OCTAHEDRON).board
    with pytest.raises(InputError, match="nothing to undo"):
        back.undo()
    for _ in range(steps):
        back = back.redo()
    assert back == session
    assert parse_session(session_yaml(session)) == session
    json.dumps(session.to_json())


def test_a_refusal_keeps_what_can_be_redone_and_a_proposal_ends_it() -> None:
    session = played(OCTAHEDRON, "plane abc", "plane bdf", "undo")
    assert session.plane("abd").redo().board == played(OCTAHEDRON, "plane abc", "plane bdf").board
    with pytest.raises(InputError, match="nothing to redo"):
        session.plane("cde").redo()


def test_save_and_load(tmp_path: Path) -> None:
    path = tmp_path / "session.yaml"
    session = played(OCTAHEDRON, "plane abc", "plane abd", "plane bdf")
    save_session(session, path)
    assert load_session(path) == session
    assert [p.name for p in tmp_path.iterdir()] == ["session.yaml"]
    assert load_session(path).auto().confirmed == ManualSession.start(OCTAHEDRON).auto().confirmed
    with pytest.raises(FileError, match="there is no such file"):
        load_session(tmp_path / "missing.yaml")
    with pytest.raises(FileError, match="no such directory"):
        save_session(session, tmp_path / "missing" / "x.yaml")


def test_sessions_with_order_form_and_points_at_infinity(tmp_path: Path) -> None:
    for session in (
        ManualSession.start("ij ik ab cd ef gh", ideal="i", order="6 5 4 3 2 1"),
        ManualSession.start(OCTAHEDRON, form=16).plane("abc"),
        ManualSession.start("A'a A'b B'c B'd Ce Cf").auto(),
    ):
        assert parse_session(session_yaml(session)) == session


TAMPERED = [
    ("answer", "answer: confirmed, reason: together", "answer: refused, reason: together", 8, "is confirmed now"),
    ("reason", "reason: together", "reason: common", 8, "the reason for 'plane abc' is together now"),
    ("command", "'plane abc'", "'plane abd'", 8, "is refused now: term 2"),
    ("nonsense", "'plane abc'", "'plane xyz'", 8, "makes no sense here: x is not a point"),
    ("legs", "[a, b]", "[a, d]", 8, "is refused now"),
    ("five legs", "[a, b], ", "", 4, "5 legs, expected six"),
    ("no name", "[a, b]", "[a, '!']", 4, "cannot name a point"),
    ("order", "order: [1, 2", "order: [2, 2", 5, "an order names each of the six legs once"),
    ("form", "form: 24", "form: 8", 6, "there is no 8-term form"),
    ("version", "version: 1", "version: 2", 3, "this is version 2 of the format"),
    ("another file", "gcrules: session", "gcrules: catalog", 2, "'catalog' is not one of session"),
    ("key", "form: 24", "from: 24", 6, "unknown key 'from'"),
    ("unknown reason", "reason: together", "reason: magic", 8, "'magic' is not one of"),
    ("a view", "'plane abc'", "'show'", 8, "show is not recorded in sessions"),
    ("tag", "'plane abc'", "!!python/name:os.system 'plane abc'", 8, "tags"),
    (
        "undone",
        "undone: []",
        "undone:\n  - {do: 'plane ade', answer: refused, reason: apart}",
        12,
        "begins with a confirmed",
    ),
]


@pytest.mark.parametrize(("old", "new", "line", "message"), [t[1:] for t in TAMPERED], ids=[t[0] for t in TAMPERED])
def test_tampered_files(tmp_path: Path, old: str, new: str, line: int, message: str) -> None:
    path = tmp_path / "session.yaml"
    source = session_yaml(played(OCTAHEDRON, "plane abc", "plane abd", "plane bdf"))
    assert old in source
    path.write_text(source.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(FileError) as caught:
        load_session(path)
    assert f"session.yaml:{line}:" in str(caught.value)
    assert message in str(caught.value)


def test_all_faults_of_a_file_at_once(tmp_path: Path) -> None:
    source = session_yaml(played(OCTAHEDRON, "plane abc"))
    source = (
        source.replace("form: 24", "form: many").replace("confirmed", "perhaps").replace("version: 1", "version: x")
    )
    with pytest.raises(FileError) as caught:
        parse_session(source)
    assert caught.value.render().count("error: ") == 3
