r"""What Tab offers: commands, statements, relations, names, rules, files, and signs for their names.

>>> from gcrules.apps.repl.state import PromptState
>>> [c.text for c in candidates(":st", PromptState())], [c.text for c in candidates("ab \\we", PromptState())]
([':straighten', ':steps'], ['∧'])
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping

from gcrules.algebra.language.letter_words import CONSTRUCTION_NAMES
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import letter_name
from gcrules.apps.repl.help import TOPICS
from gcrules.apps.repl.reading import first_word, split_command
from gcrules.apps.repl.state import PromptState
from gcrules.apps.repl.tables import COMMANDS, RELATIONS, RULE_WORDS, STATEMENTS, SYMBOLS, WORDS, meant
from gcrules.core.dataclass import dataclass

__all__ = ["Completion", "candidates"]

_SYMBOL = re.compile(r"(?<!/)\\[a-z]+\Z")
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_']*\Z")
_SCRIPTS = (".gca",)
_ROBOTS = (".yaml", ".yml")
_COMMANDS = {f":{c.name}": c.help for c in COMMANDS.values()}
MAX_FILES = 200


@dataclass(frozen=True, slots=True)
class Completion:
    """`text` takes the place of the last `length` characters; `shown` stands in the menu with its `help`."""

    text: str
    length: int
    help: str = ""
    shown: str = ""


def candidates(before: str, state: PromptState) -> list[Completion]:
    """What may stand at the cursor, given the text before it."""
    symbol = _SYMBOL.search(before)
    if symbol:
        return [Completion(SYMBOLS[n], len(symbol[0]), SYMBOLS[n], n) for n in meant(symbol[0], SYMBOLS)]
    called = split_command(before)
    if called is None:
        return list(_words(before, state))
    name, at = called
    if at == len(before) and not before[-1:].isspace():
        begun = before.lstrip()
        return list(_starting(begun, _COMMANDS))
    names = meant(name)
    return list(_arguments(COMMANDS[names[0]].takes, COMMANDS[names[0]].words, before[at:], state)) if names else []


def _arguments(takes: str, words: tuple[str, ...], argument: str, state: PromptState) -> Iterator[Completion]:
    if takes == "file":
        yield from _files(argument, _SCRIPTS)
    elif takes == "topic":
        yield from _starting(argument.lstrip(":"), dict.fromkeys(TOPICS, ""))
    elif takes == "rule":
        yield from _starting(argument, {r.id: r.sentence for r in state.rules})
    elif takes in ("switch", "words"):
        yield from _starting(argument, dict.fromkeys(words, ""))
    elif takes in ("expression", "equation", "legs", "latex"):
        yield from _starting(argument, dict.fromkeys(words, ""))
        yield from _names(argument, state)
        if takes == "legs" and argument:
            yield from _files(argument, _ROBOTS)


def _words(before: str, state: PromptState) -> Iterator[Completion]:
    """Words of an expression or a statement."""
    found = _WORD.search(before)
    word = found[0] if found else ""
    start = first_word(before)
    if start == word and before.strip() == word:  # the first word of all
        yield from _starting(word, {n: line for n, (_, line) in STATEMENTS.items()})
        if not word:
            yield from _starting("", _COMMANDS)
    elif start == "rule":
        yield from _starting(word, {w: "" for w in RULE_WORDS if word})
    if word and (start in ("given", "claim") or re.search(r"\bif\b", before)) and start != word:
        yield from _starting(word, dict.fromkeys(RELATIONS, ""))
    elif len(word) > 1:
        yield from _starting(word, {f"{n}(": WORDS[n][1] for n in CONSTRUCTION_NAMES})
    yield from _names(before, state)


def _names(before: str, state: PromptState) -> Iterator[Completion]:
    """Declared names that go on from the end of the last word, from as far to the left in it as possible."""
    found = _WORD.search(before)
    word = found[0] if found else ""
    at = state.context
    known = (
        dict.fromkeys(at.points, "a point")
        | dict.fromkeys(at.ideal, "at infinity")
        | {n: letter_name(n, step, at.screws, at.rank) for n, step in at.letters.items()}
        | dict.fromkeys(at.conics, f"a {FORMS[at.rank].word}")
        | {n: f"= {e}" for n, e in _bound(state)}
    )
    for begin in range(max(1, len(word) - 1)):
        offered = [c for c in _starting(word[begin:], known) if c.text != word[begin:]]
        if offered:
            yield from offered
            return


def _bound(state: PromptState) -> Iterator[tuple[str, str]]:
    for name, e in state.context.bound.items():
        shown = str(e)
        yield name, shown if len(shown) <= 40 else f"{shown[:40]}…"


def _starting(begun: str, words: Mapping[str, str]) -> Iterable[Completion]:
    return (Completion(w, len(begun), line) for w, line in words.items() if w.startswith(begun))


def _files(begun: str, endings: tuple[str, ...]) -> Iterator[Completion]:
    """Folders, and the files that end so."""
    folder, _, name = begun.rpartition("/")
    try:
        where = os.path.expanduser(folder) if folder else "/" if begun.startswith("/") else "."
        found = sorted(os.scandir(where), key=lambda e: e.name)
    except (OSError, ValueError):
        return
    inside = [e for e in found if e.name.startswith(name) and (name.startswith(".") or not e.name.startswith("."))]
    for entry in inside[:MAX_FILES]:
        if entry.is_dir():
            yield Completion(f"{entry.name}/", len(name))
        elif entry.name.lower().endswith(endings):
            yield Completion(entry.name, len(name))
