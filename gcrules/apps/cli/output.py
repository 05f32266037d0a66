"""Where the answer of a command goes, and in which form: --brief, --full, --json, --latex, --unicode, --output."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Sequence
from dataclasses import field
from functools import wraps
from typing import Any

import click

from gcrules.apps.cli.files import ANSWERED, OutputFile
from gcrules.core import streams
from gcrules.core.budget import waiting
from gcrules.core.dataclass import dataclass
from gcrules.core.files import write_file
from gcrules.views.detail import everything, opening

__all__ = ["IDS", "Output", "decorated", "json_option", "latex_option", "mathematics_option", "output_options"]

_Command = Callable[..., Any]

json_option = click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
latex_option = click.option("--latex", "as_latex", is_flag=True, help="Print LaTeX.")
mathematics_option = click.option(
    "--unicode/--ascii",
    " /--plain",
    "mathematics",
    default=None,
    help="Unicode mathematics or plain ASCII; by default what the output can show.",
)


@dataclass(frozen=True)
class Output:
    """Where an answer goes and in which form."""

    json: bool = False
    latex: bool = False
    mathematics: bool | None = None
    path: str | None = None
    brief: bool = False
    full: bool = False
    texts: list[str] = field(default_factory=list, repr=False, compare=False)
    """What is written to the file when the command has ended with an answer."""

    def __post_init__(self) -> None:
        if self.json and self.latex:
            raise click.UsageError("--json and --latex exclude each other.")
        if self.brief and (self.json or self.latex or self.full):
            raise click.UsageError("--brief is for text, and excludes --json, --latex and --full.")

    @property
    def unicode(self) -> bool:
        """Unicode mathematics unless the user says otherwise or the output cannot show it."""
        if self.mathematics is not None:
            return self.mathematics
        try:
            "∧∨−·→".encode("utf-8" if self.path else getattr(sys.stdout, "encoding", None) or "ascii")
        except (UnicodeEncodeError, LookupError):
            return False
        return True

    @property
    def terminal(self) -> bool:
        """Whether someone reads it at once, and not a program or from a file."""
        return not (self.json or self.latex or self.path) and sys.stdout.isatty()

    def show(self, answer: Any, text: str | None = None, *, brief: str | None = None) -> None:
        """Print an answer that has `to_json()`, `text(unicode=…)` and `latex()`; `text` replaces the plain text. With
        --brief only `brief`, or else how the text opens.
        """
        if self.json:
            self.write(json.dumps(answer.to_json(), indent=2))
        elif self.latex:
            self.write(answer.latex())
        else:
            whole = answer.text(unicode=self.unicode) if text is None else text
            if self.brief:
                self.write(opening(whole) if brief is None else brief)
            else:
                self.write(whole)

    def write(self, text: str) -> None:
        """Print, or write to the file of --output once the command has ended."""
        if self.path:
            self.texts.append(text)
        else:
            with waiting():
                click.echo(text.rstrip("\n"))

    def deliver(self, code: int) -> None:
        """Write the file if the command has ended with an answer; what is not decided is printed."""
        if self.path is None or not self.texts:
            return
        text = "\n".join(t.rstrip("\n") for t in self.texts)
        if code in ANSWERED:
            write_file(self.path, click.unstyle(text) + "\n")
        else:
            click.echo(text)
            if not streams.is_stdout(self.path):
                click.echo(f"note: {self.path} is not written, since nothing is decided", err=True)


_BRIEF = "Print the answer alone, without what it rests on."
IDS = "Print the ids alone, one in a line."
"""What --brief leaves of a list."""

_FULL = "Leave nothing out, however long it gets."


def output_options(
    *, latex: bool = True, brief: str = _BRIEF, full: str = _FULL, file: bool = True
) -> Callable[[_Command], _Command]:
    """--brief, --full, --json, --unicode/--ascii; with `latex` --latex; with `file` --output. The command receives them
    as `out`; `brief` and `full` say in the help what --brief leaves and what --full adds.
    """

    def decorate(command: _Command) -> _Command:
        @wraps(command)
        def with_output(**options: Any) -> Any:
            out = Output(
                json=options.pop("as_json"),
                latex=options.pop("as_latex", False),
                mathematics=options.pop("mathematics"),
                path=options.pop("path") if file else None,
                brief=options.pop("brief"),
                full=options.pop("full"),
            )
            try:
                with everything(out.full):
                    result = command(out=out, **options)
            except click.exceptions.Exit as end:
                out.deliver(end.exit_code)
                raise
            out.deliver(0)
            return result

        decorators = [
            click.option("--brief", is_flag=True, help=brief),
            click.option("--full", is_flag=True, help=full),
            json_option,
            *([latex_option] if latex else []),
            mathematics_option,
            *([_output_file] if file else []),
        ]
        return decorated(with_output, decorators)

    return decorate


_output_file = click.option(
    "-o", "--output", "path", type=OutputFile(), metavar="FILE", help="Write to a file, if the exit code is 0 or 1."
)


def decorated(command: _Command, decorators: Sequence[Callable[[_Command], _Command]]) -> _Command:
    """A command with decorators as if they were written above it."""
    for decorator in reversed(decorators):
        command = decorator(command)
    return command
