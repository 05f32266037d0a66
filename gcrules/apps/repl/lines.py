"""The front end where there is no terminal: lines in, answers out, and an exit code."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator

import click

from gcrules.apps.cli.files import MAX_STDIN
from gcrules.apps.repl.answers import Answer, worst
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import InputPiece, pieces
from gcrules.core.errors import FileError

__all__ = ["PROMPT", "coloured", "run_pieces", "stdin_pieces", "tell", "tell_all"]

PROMPT = "> "
CONTINUED = "  "

_COLOURS = {"proved": "green", "refuted": "red", "undecided": "yellow"}


def coloured(answer: Answer) -> str:
    """The answer with its verdict in colour."""
    if answer.fault is not None:
        return answer.text.replace("error", click.style("error", fg="red", bold=True), 1)
    colour = _COLOURS.get(answer.verdict)
    return answer.text.replace(answer.verdict, click.style(answer.verdict, fg=colour, bold=True), 1 if colour else 0)


def tell(answer: Answer) -> None:
    """Print an answer, faults on standard error."""
    if answer.text:
        click.echo(coloured(answer), err=answer.fault is not None)


def stdin_pieces() -> Iterator[InputPiece]:
    """The inputs on standard input; from a keyboard each is answered as soon as it is complete.

    Raises FileError where it is too long or no text.
    """
    yield from pieces(_lines(), ahead=not sys.stdin.isatty())


def _lines() -> Iterator[str]:
    left = MAX_STDIN
    for number in range(1, left):
        data: bytes = sys.stdin.buffer.readline(left + 1)
        left -= len(data)
        if left < 0:
            raise FileError(f"the input is larger than {MAX_STDIN:,} bytes", filename="<stdin>")
        if not data:
            return
        try:
            yield data.decode("utf-8-sig" if number == 1 else "utf-8").rstrip("\r\n")
        except UnicodeDecodeError as fault:
            what = f"this is not text in UTF-8 (byte {fault.start + 1}, line {number})"
            raise FileError(what, filename="<stdin>") from None


def run_pieces(repl: Interpreter, found: Iterable[InputPiece], filename: str, *, echo: bool = False) -> int:
    """Answer one input after the other; the exit code says what was worst among the answers."""
    codes = []
    for piece in found:
        if echo:
            click.echo(PROMPT + piece.text.replace("\n", f"\n{CONTINUED}"))
        codes.append(tell_all(repl.answer(piece, filename)))
        if repl.over:
            break
    return worst(codes)


def tell_all(answers: Iterable[Answer]) -> int:
    """Print answers as they come; the exit code says what was worst among them."""
    codes = []
    for answer in answers:
        tell(answer)
        codes.append(answer.code)
    return worst(codes)
