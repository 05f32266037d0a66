"""The front end for terminals: history, input of several lines, completion, colours, signs while typing."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Iterable
from contextlib import closing
from dataclasses import replace
from typing import Any

import click
from prompt_toolkit import PromptSession
from prompt_toolkit.auto_suggest import AutoSuggestFromHistory
from prompt_toolkit.completion import CompleteEvent, Completer, Completion
from prompt_toolkit.document import Document
from prompt_toolkit.filters import Condition, has_completions, is_searching
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.formatted_text.utils import split_lines
from prompt_toolkit.history import FileHistory, History, InMemoryHistory
from prompt_toolkit.input import Input
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.layout.processors import HighlightMatchingBracketProcessor
from prompt_toolkit.lexers import Lexer
from prompt_toolkit.output import Output
from prompt_toolkit.styles import Style

from gcrules.apps.cli.files import working
from gcrules.apps.repl.answers import wrapped
from gcrules.apps.repl.completion import candidates
from gcrules.apps.repl.highlight import tokens
from gcrules.apps.repl.history import history_path, private_file
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.lines import CONTINUED, PROMPT, tell
from gcrules.apps.repl.reading import unfinished
from gcrules.core import interrupts
from gcrules.core.version import __version__

__all__ = ["make_session", "respond", "run_terminal", "toolbar"]

STYLE = Style.from_dict(
    {
        "prompt": "bold",
        "command": "ansimagenta bold",
        "keyword": "ansiblue bold",
        "relation": "ansiblue",
        "name": "ansicyan",
        "point": "",
        "number": "ansiyellow",
        "string": "ansigreen",
        "comment": "ansibrightblack",
        "operator": "bold",
        "result": "ansimagenta",
        "fault": "ansired underline",
        "matching-bracket.cursor": "bold reverse",
        "matching-bracket.other": "bold reverse",
        "bottom-toolbar": "noreverse ansibrightblack",
    }
)
WELCOME = f"gcrules {__version__}.  :help says what can be typed, :quit or Ctrl-D leaves."


def run_terminal(repl: Interpreter, session: PromptSession[str] | None = None) -> None:
    """Read and answer until the session is left."""
    session = session or make_session(repl)
    click.echo(WELCOME)
    while not repl.over:
        try:
            respond(repl, session.prompt())
        except KeyboardInterrupt:  # clears the line
            interrupts.go_on()
        except EOFError:
            break


def respond(repl: Interpreter, text: str) -> None:
    """Print the answers to an input. An interrupt ends the computation and leaves the state as it was before it."""
    try:
        with interrupts.interruptible(), closing(repl.feed(text)) as answers:
            while True:
                with working("computing"):
                    answer = next(answers, None)
                if answer is None:
                    return
                plain = answer.wraps and answer.fault is None and not repl.settings.latex
                tell(replace(answer, text=wrapped(answer.text, _width())) if plain else answer)
    except KeyboardInterrupt:
        interrupts.go_on()
        click.echo("interrupted; what is declared stays", err=True)
    except MemoryError:
        click.echo("error: there is not enough memory for this", err=True)
    except Exception as fault:
        kind, words = type(fault).__name__, " ".join(str(fault).split())
        click.echo(f"This is a fault of gcrules, not of your input; please report it: {kind}: {words}", err=True)


def _width() -> int:
    return max(40, shutil.get_terminal_size().columns)


# --- the prompt ----------------------------------------------------------------------------------------------------


def make_session(
    repl: Interpreter, *, input: Input | None = None, output: Output | None = None, history: History | None = None
) -> PromptSession[str]:
    """The prompt of an interpreter; `input` and `output` are those of the terminal if left out."""
    return PromptSession(
        [("class:prompt", PROMPT)],
        multiline=True,
        prompt_continuation=CONTINUED,
        lexer=_Colours(repl),
        style=STYLE,
        completer=_Completions(repl),
        complete_while_typing=False,
        auto_suggest=AutoSuggestFromHistory(),
        history=_history() if history is None else history,
        input_processors=[HighlightMatchingBracketProcessor(chars="[]()")],
        key_bindings=_keys(repl),
        bottom_toolbar=lambda: toolbar(repl),
        enable_open_in_editor=True,
        tempfile_suffix=".gca",
        include_default_pygments_style=False,
        input=input,
        output=output,
    )


def toolbar(repl: Interpreter) -> str:
    """The rank, the number of points, and what is assumed."""
    at = repl.state.context
    facts = [
        f"rank {at.rank}",
        f"{len(at.points)} point{'s' * (len(at.points) != 1)}" if at.points else "",
        f"at infinity {' '.join(at.ideal)}" if at.ideal else "",
        str(at.infinity or ""),
        f"given {', '.join(dict.fromkeys(map(str, at.given)))}" if at.given else "",
        f"let {' '.join(at.bound)}" if at.bound else "",
        f"{len(repl.state.rules)} rule{'s' * (len(repl.state.rules) != 1)}" if repl.state.rules else "",
        "LaTeX" if repl.settings.latex else "",
    ]
    separator = " · " if repl.settings.unicode else " | "
    line = " " + separator.join(f for f in facts if f)
    width = _width() - 1
    return line if len(line) <= width else f"{line[: width - 3]}..."


def _history() -> History:
    path = history_path(os.environ, sys.platform)
    return _PrivateHistory(str(path)) if path is not None and private_file(path) else InMemoryHistory()


class _PrivateHistory(FileHistory):
    """Goes on in memory where the file cannot be read or written any more."""

    def load_history_strings(self) -> Iterable[str]:
        try:
            return list(super().load_history_strings())
        except OSError:
            return []

    def store_string(self, string: str) -> None:
        try:
            super().store_string(string)
        except OSError:
            return


class _Colours(Lexer):
    def __init__(self, repl: Interpreter) -> None:
        self.repl = repl

    def lex_document(self, document: Document) -> Callable[[int], StyleAndTextTuples]:
        runs = tokens(document.text, self.repl.state.context.bound)
        lines = list(split_lines([(f"class:{kind}" if kind else "", text) for kind, text in runs]))
        return lambda number: lines[number] if number < len(lines) else []


class _Completions(Completer):
    def __init__(self, repl: Interpreter) -> None:
        self.repl = repl

    def get_completions(self, document: Document, complete_event: CompleteEvent) -> Iterable[Completion]:
        for found in candidates(document.text_before_cursor, self.repl.state):
            yield Completion(found.text, -found.length, display=found.shown or found.text, display_meta=found.help)


def _keys(repl: Interpreter) -> KeyBindings:
    keys = KeyBindings()
    typing = ~is_searching
    signs = typing & Condition(lambda: repl.settings.unicode)

    @keys.add("enter", filter=typing)
    def _(event: KeyPressEvent) -> None:
        buffer = event.current_buffer
        last = buffer.document.is_cursor_at_the_end and not buffer.document.current_line.strip()
        if last or not unfinished(buffer.text):
            buffer.text = buffer.text.rstrip("\n")
            buffer.validate_and_handle()
        else:
            buffer.newline(copy_margin=False)

    @keys.add("escape", "enter", filter=typing)
    def _(event: KeyPressEvent) -> None:
        event.current_buffer.newline(copy_margin=False)

    @keys.add("tab", filter=typing & ~has_completions)
    def _(event: KeyPressEvent) -> None:
        """What is certain at once, so that nothing typed after it is lost; the menu where there is a choice."""
        buffer = event.current_buffer
        found = candidates(buffer.document.text_before_cursor, repl.state)
        if len({(c.text, c.length) for c in found}) == 1:
            buffer.delete_before_cursor(found[0].length)
            buffer.insert_text(found[0].text)
        elif found:
            buffer.start_completion(insert_common_part=True)

    def sign(key: str, before: str, made: str) -> None:
        @keys.add(key, filter=signs)
        def _(event: KeyPressEvent) -> Any:
            buffer = event.current_buffer
            if buffer.document.char_before_cursor == before:
                buffer.delete_before_cursor()
                buffer.insert_text(made)
            else:
                buffer.insert_text(key)

    sign("\\", "/", "∧")
    sign("/", "\\", "∨")
    return keys
