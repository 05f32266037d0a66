"""The command `repl`: a session at the prompt, or one that is read from standard input."""

from __future__ import annotations

import sys

import click

from gcrules.algebra.expand import MAX_TERMS
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.limits import SECONDS, time_limit
from gcrules.apps.cli.options import catalog_option
from gcrules.apps.cli.output import Output, mathematics_option
from gcrules.apps.cli.rule_options import Choice, plugins_option
from gcrules.apps.repl.answers import worst
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.lines import run_pieces, stdin_pieces, tell_all
from gcrules.apps.repl.reading import pieces
from gcrules.apps.repl.state import PromptState, Settings
from gcrules.core.deferred import deferred
from gcrules.rules.catalog.file import load as load_catalog

__all__ = ["repl"]

_RULES = "Let the rules of a .gca file, or rules named, hold from the start."

run_terminal = deferred("gcrules.apps.repl.terminal:run_terminal")


@click.command(cls=ExpressionCommand)
@click.argument("file", required=False, metavar="[FILE.gca]")
@click.option("-e", "--eval", "texts", multiple=True, metavar="TEXT", help="Answer this input, then leave; repeatable.")
@click.option("--echo", is_flag=True, help="Show every input before its answer (not at the prompt).")
@click.option(
    "--limit",
    type=click.IntRange(min=1),
    default=MAX_TERMS,
    show_default=True,
    metavar="N",
    help="Give up beyond this many terms.",
)
@time_limit(SECONDS, "Give up on an input after this time.", itself=True)
@mathematics_option
@click.option("--rules", "words", multiple=True, metavar="FILE|IDS", help=_RULES)
@plugins_option
@catalog_option
@click.pass_context
def repl(
    ctx: click.Context,
    file: str | None,
    texts: tuple[str, ...],
    echo: bool,
    limit: int,
    seconds: float,
    mathematics: bool | None,
    words: tuple[str, ...],
    folders: tuple[str, ...],
    catalogs: tuple[str, ...],
) -> None:
    """Type expressions, equations and statements, and get an answer to each; :help says what there is.

    \b
    gcrules repl
    gcrules repl plane.gca              with all that the script declares
    gcrules repl < session.txt          inputs from a file or a pipe
    gcrules repl -e "ab /\\ cde" -e ":latex"
    gcrules repl --rules mine.gca       rules that hold from the start

    Without a terminal the exit code is 2 where any input was at fault, else 1 where anything was refuted, else 3 where
    anything was not decided. GCRULES_HISTORY names the file of the history; none is written where it is empty.
    """
    settings = Settings(
        Output(mathematics=mathematics).unicode,
        limit=limit,
        seconds=seconds,
        short=sys.stdout.isatty(),
        plugins=folders,
        catalogs=catalogs,
    )
    if catalogs:
        load_catalog(catalogs)  # one that is wrong is told at once
    session = Interpreter(PromptState(rules=Choice(words, folders=folders).rewriting() if words else ()), settings)
    codes = [tell_all(session.load(file))] if file is not None else []
    if not texts and sys.stdin.isatty() and sys.stdout.isatty():
        run_terminal(session)
        return
    for text in texts:
        codes.append(run_pieces(session, pieces(text.split("\n")), "<input>", echo=echo))
    if not texts:
        codes.append(run_pieces(session, stdin_pieces(), "<stdin>", echo=echo))
    ctx.exit(worst(codes))
