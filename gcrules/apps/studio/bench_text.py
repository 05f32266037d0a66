r"""The text of the bench: what may stand at a place of it, and how it is saved as a script.

>>> print(scripted("let p = ab /\\ cde\np \\/ cdf\n[abcd] == -[bacd]\n:expand p", None)["text"])
let p = ab /\ cde
show p \/ cdf
claim [abcd] == -[bacd]
# :expand p
"""

from __future__ import annotations

from contextlib import suppress

from gcrules.algebra.language.statements import parse_script
from gcrules.apps.repl.completion import candidates
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import first_word, is_blank, pieces, split_command
from gcrules.apps.repl.state import PromptState
from gcrules.apps.repl.tables import COMMANDS, STATEMENTS, meant
from gcrules.apps.studio.bench import context_of
from gcrules.apps.studio.protocol.answer_views import Completed, Scripted
from gcrules.apps.studio.protocol.bench_words import BENCH_COMMANDS
from gcrules.apps.studio.subject import Subject
from gcrules.core.errors import GcrulesError

__all__ = ["completed", "scripted"]

_DECLARE = ("rank", "points", "ideal", "let")
_MOST = 60


def completed(text: str, subject: Subject | None) -> Completed:
    """What may stand at the end of a text, as the prompt offers it, but no files and nothing about a session."""
    before = pieces(text.split("\n"))
    given = [p.text for p in before]
    line = given.pop() if given and not text.endswith("\n") else ""
    called = split_command(line)
    argued = called is not None and (len(line) > called[1] or line[-1:].isspace())
    takes = next((COMMANDS[n].takes for n in meant(called[0])), "") if called and argued else ""
    if takes in ("file", "legs", "topic"):
        return {"options": []}
    interpreter = Interpreter(PromptState(context_of(subject)))
    for one in given:
        _declare(interpreter, one)
    found = candidates(line, interpreter.state)
    here = [c for c in found if not c.text.startswith(":") or c.text[1:] in BENCH_COMMANDS]
    return {"options": [{"text": c.text, "length": c.length, "help": c.help} for c in here[:_MOST]]}


def _declare(interpreter: Interpreter, text: str) -> None:
    """Take in what a statement declares; what is at fault declares nothing."""
    if first_word(text) in _DECLARE:
        with suppress(GcrulesError):
            for _ in interpreter.feed(text):
                pass


def scripted(text: str, subject: Subject | None) -> Scripted:
    """The text as a script that `gcrules run` takes: expressions are shown, equations are claims, questions stand as
    comments; the points of the subject are declared. Raises GcrulesError where it has a fault.
    """
    lines = text.split("\n")
    known = context_of(subject)
    interpreter = Interpreter(PromptState(known))
    found = [f"{word} {' '.join(names)}" for word, names in (("points", known.points), ("ideal", known.ideal)) if names]
    last = 0
    for piece in pieces(lines):
        found += [line for line in lines[last : piece.line - 1] if is_blank(line)]
        last = piece.line - 1 + piece.text.count("\n") + 1
        found.append(_statement(piece.text, called=interpreter.called(piece) is not None))
        _declare(interpreter, piece.text)
    script = "\n".join([*found, *lines[last:]]).rstrip("\n") + "\n"
    parse_script(script, "bench.gca")
    return {"text": script}


def _statement(text: str, *, called: bool) -> str:
    if called:
        return "\n".join(f"# {line}" for line in text.split("\n"))
    if is_blank(text) or first_word(text) in STATEMENTS:
        return text
    comments, body = [], text.split("\n")
    while body and is_blank(body[0]):
        comments.append(body.pop(0))
    return "\n".join([*comments, f"{'claim' if '==' in text else 'show'} {body[0].lstrip()}", *body[1:]])
