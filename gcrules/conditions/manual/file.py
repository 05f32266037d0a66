"""Session files: YAML with the legs, the form at the start and every proposal with its answer.

    gcrules: session
    version: 1
    legs: [[a, b], [a, f], [c, b], [c, d], [e, d], [e, f]]
    order: [1, 2, 3, 4, 5, 6]
    form: 24
    history:
      - {do: 'plane abc', answer: confirmed, reason: together}
      - {do: 'plane abd', answer: refused, reason: apart}
    undone: []

`points` (declared names) and `ideal` (points at infinity) may stand there too. The order counts legs from 1. A file is
replayed when it is read, so that an answer that no longer holds is noticed at its place.
"""

from __future__ import annotations

from os import PathLike, fspath

from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.conditions.manual.outcome import REASONS
from gcrules.conditions.manual.session import PROPOSALS, ManualSession, Record
from gcrules.core.errors import GcrulesError, LimitReached
from gcrules.core.files import write_file
from gcrules.core.yaml_file import Document, Node

__all__ = ["load_session", "parse_session", "save_session", "session_yaml"]

_VERSION = 1
_REQUIRED = {"gcrules", "version", "legs", "history"}
_OPTIONAL = {"order", "form", "points", "ideal", "undone"}


def save_session(session: ManualSession, path: str | PathLike[str]) -> None:
    """Write a session file by way of a temporary one. Raises FileError."""
    write_file(fspath(path), session_yaml(session), at_once=True)


def load_session(path: str | PathLike[str]) -> ManualSession:
    """Read and replay a session file. Raises FileError with the place of every fault."""
    return _read(Document.load(path))


def parse_session(source: str, filename: str = "<input>") -> ManualSession:
    """The same for text."""
    return _read(Document.parse(source, filename))


# --- writing -------------------------------------------------------------------------------------------------------


def session_yaml(session: ManualSession) -> str:
    """The text of the session's file."""
    s, first = session.structure, session.first
    lines = ["# A session of gcrules analyze --manual; --session FILE resumes it.", "gcrules: session"]
    lines += [f"version: {_VERSION}", f"legs: [{', '.join(_names(leg) for leg in s.legs)}]"]
    lines += [f"{key}: {_names(names)}" for key, names in (("points", s.points), ("ideal", s.ideal)) if names]
    lines += [f"order: [{', '.join(str(i + 1) for i in first.form.order)}]", f"form: {first.form.form}"]
    lines += _records("history", session.history)
    lines += _records("undone", tuple(r for chunk in session.undone for r in chunk))
    return "\n".join(lines) + "\n"


def _records(key: str, records: tuple[Record, ...]) -> list[str]:
    if not records:
        return [f"{key}: []"]
    return [f"{key}:", *(_record(r) for r in records)]


def _record(r: Record) -> str:
    return f"  - {{do: {_quoted(r.command)}, answer: {r.outcome.answer}, reason: {r.outcome.reason}}}"


def _names(names: tuple[str, ...]) -> str:
    return f"[{', '.join(map(_quoted_name, names))}]"


def _quoted_name(name: str) -> str:
    return name if SHORT_NAME.fullmatch(name) and "'" not in name else _quoted(name)


def _quoted(text: str) -> str:
    """In YAML's single quotes, where only the quote itself is doubled."""
    return "'" + text.replace("'", "''") + "'"


# --- reading -------------------------------------------------------------------------------------------------------


def _read(document: Document) -> ManualSession:
    top = document.root.mapping(required=_REQUIRED, optional=_OPTIONAL)
    if "gcrules" in top:
        top["gcrules"].choice({"session"})
    if "version" in top and top["version"].integer() not in (None, _VERSION):
        top["version"].fault(f"this is version {top['version'].text} of the format, expected {_VERSION}")
    legs = tuple(_strings(leg, 2) for leg in top["legs"].sequence()) if "legs" in top else ()
    names = {key: _strings(top[key]) if key in top else () for key in ("points", "ideal")}
    order = [n for item in top["order"].sequence(6) if (n := item.integer()) is not None] if "order" in top else None
    form = top["form"].integer() if "form" in top else 24
    steps = {key: _steps(top[key]) for key in ("history", "undone") if key in top}
    document.check()
    try:
        structure = read_legs(legs, points=names["points"], ideal=names["ideal"])
    except GcrulesError as fault:
        raise document.error(top["legs"].span, fault.message, fault.hint) from None
    if order is not None and sorted(order) != [1, 2, 3, 4, 5, 6]:
        raise document.error(top["order"].span, "an order names each of the six legs once, counted from 1")
    if form not in (24, 16):
        raise document.error(top["form"].span, f"there is no {form}-term form", "24 or 16")
    numbers = [n - 1 for n in order] if order is not None else None
    plain = numbers is None or numbers == list(range(6))
    session = ManualSession.start(structure, order=None if plain else numbers, form=form or 24)
    session = _replayed(session, steps["history"])
    undone = steps.get("undone", [])
    again = _replayed(session, undone)
    for _ in range(sum(not r.outcome.refused for r in again.history[len(session.history) :])):
        again = again.undo()
    if again.history != session.history:
        raise document.error(undone[0][0].span, "what was undone begins with a confirmed or possible proposal")
    return again


def _strings(node: Node, length: int | None = None) -> tuple[str, ...]:
    return tuple(s for item in node.sequence(length) if (s := item.string()) is not None)


_Step = tuple[Node, str, Node, str, Node, str]


def _steps(node: Node) -> list[_Step]:
    """Commands with their answers and reasons, each with its node."""
    found = []
    for item in node.sequence():
        step = item.mapping(required={"do", "answer", "reason"})
        if len(step) < 3:
            continue
        command = step["do"].string()
        if command is not None and command.split()[0] not in (*PROPOSALS, "auto"):
            step["do"].fault(f"{command.split()[0]} is not recorded in sessions", f"there are {', '.join(PROPOSALS)}")
        answer, reason = step["answer"].choice({"confirmed", "possible", "refused"}), step["reason"].choice(REASONS)
        if command is not None and answer is not None and reason is not None:
            found.append((step["do"], command, step["answer"], answer, step["reason"], reason))
    return found


def _replayed(session: ManualSession, steps: list[_Step]) -> ManualSession:
    """The session after the steps. Raises FileError at the first one that is answered otherwise now."""
    for node, command, answer_node, answer, reason_node, reason in steps:
        document, before = node.document, session
        try:
            session = session.do(command)
        except LimitReached:
            raise
        except GcrulesError as fault:
            raise document.error(node.span, f"{command!r} makes no sense here: {fault.message}", fault.hint) from None
        hint = "the file was changed, or another version of gcrules wrote it"
        if len(session.history) != len(before.history) + 1 or session.outcome is None:
            raise document.error(node.span, f"{command!r} is answered by other commands", hint)
        if session.outcome.answer != answer:
            what = f"{command!r} is {session.outcome.answer} now: {session.outcome.words[0]}"
            raise document.error(answer_node.span, what, hint)
        if session.outcome.reason != reason:
            raise document.error(reason_node.span, f"the reason for {command!r} is {session.outcome.reason} now", hint)
    return session
