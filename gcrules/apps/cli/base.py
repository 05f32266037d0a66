"""What commands are: groups that load a command when it is used, arguments that begin with a minus sign, seeds."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from difflib import get_close_matches
from importlib import import_module
from typing import Any

import click
from click.shell_completion import CompletionItem

from gcrules.apps.cli.files import OutputCommand, printed
from gcrules.core import interrupts, streams
from gcrules.core.errors import GcrulesError, absent
from gcrules.core.seeds import repeated

__all__ = ["COMPLETING", "ExpressionCommand", "LazyGroup", "colour_choice"]

COMPLETING = "_GCRULES_COMPLETE"
"""Set by a shell that asks what a command line may go on with."""
INTERRUPTED = 130  # where it is Ctrl-C that ends a command; `interrupts.run` knows other signals
BROKEN_PIPE = 141


def colour_choice() -> bool | None:
    """False where NO_COLOR is set to anything (see no-color.org), else None: colour on a terminal only."""
    return False if os.environ.get("NO_COLOR") else None


class LazyGroup(click.Group):
    """A group that imports the module of a command when the command is used, and turns faults into exit codes.

    `table` maps each name to "module:attribute" and the line of help in the list of commands.
    """

    def __init__(self, *args: Any, table: Mapping[str, tuple[str, str]], **options: Any) -> None:
        super().__init__(*args, **options)
        self.table = table

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.table)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in self.table:
            return None
        module, attribute = self.table[cmd_name][0].split(":")
        command: click.Command = getattr(import_module(module), attribute)
        return seeded(command) if cmd_name in SEEDED else command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, line) for name, (_, line) in self.table.items()])

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        names = [CompletionItem(n, help=line) for n, (_, line) in self.table.items() if n.startswith(incomplete)]
        return names + click.Command.shell_complete(self, ctx, incomplete)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name = args[0]
        if name not in self.table and not name.startswith("-"):
            near = get_close_matches(name, self.table, n=2, cutoff=0.5)
            hint = f" Did you mean {' or '.join(near)}?" if near else f" There are {', '.join(self.table)}."
            raise click.UsageError(f"No such command {name!r}.{hint}", ctx)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            with printed():
                return super().invoke(ctx)
        except GcrulesError as fault:
            if interrupts.pending() is not None:  # what a library made of an interrupt is no fault of the input
                ctx.exit(INTERRUPTED)
            first, _, rest = fault.render().partition(":")
            click.echo(f"{click.style(first, fg='red', bold=True)}:{rest}", err=True)
            ctx.exit(fault.exit_code)
        except ModuleNotFoundError as fault:
            click.echo(absent(fault).render(), err=True)
            ctx.exit(GcrulesError.exit_code)
        except MemoryError:
            click.echo("error: there is not enough memory for this", err=True)
            ctx.exit(3)
        except KeyboardInterrupt:
            ctx.exit(INTERRUPTED)
        except OSError as fault:  # of standard output: files report their own faults
            streams.silence()
            if isinstance(fault, BrokenPipeError):
                ctx.exit(BROKEN_PIPE)
            click.echo(f"error: the output cannot be written: {fault.strerror or fault}", err=True)
            ctx.exit(GcrulesError.exit_code)


class ExpressionCommand(OutputCommand):
    """A command whose arguments may begin with a minus sign: only declared options, and words that look like a long
    option (--json), are options; everything else is an argument. An option's value is a word of its own or follows =.
    """

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        declared = {
            name: not p.is_flag and not p.count
            for p in self.get_params(ctx)
            if isinstance(p, click.Option)
            for name in (*p.opts, *p.secondary_opts)
        }
        options: list[str] = []
        rest: list[str] = []
        words = iter(args)
        for word in words:
            if word == "--":
                rest += words
            elif word in declared or _LONG_OPTION.fullmatch(word):
                options.append(word)
                if declared.get(word):
                    value = next(words, None)
                    if value is None:
                        if ctx.resilient_parsing:  # a shell is about to complete it
                            break
                        raise click.BadOptionUsage(word, f"Option {word!r} requires an argument.", ctx)
                    options.append(value)
            else:
                rest.append(word)
        try:
            return super().parse_args(ctx, [*options, "--", *rest])
        except click.NoSuchOption as fault:
            others = _having(ctx, fault.option_name)
            if not others:
                raise
            where = f"{fault.option_name} is an option of {', '.join(others)}, not of {ctx.info_name}."
            raise click.UsageError(where, ctx) from None


def _having(ctx: click.Context, option: str) -> list[str]:
    """The other commands that have an option of this name."""
    group = ctx.parent.command if ctx.parent else None
    names = list(group.table) if isinstance(group, LazyGroup) else []
    found = ((n, group.get_command(ctx, n)) for n in names if n != ctx.info_name) if group else ()  # type: ignore[attr-defined]
    return [n for n, c in found if c and any(option in p.opts for p in c.params)]


_LONG_OPTION = re.compile(r"--[a-z][a-z-]+(=.*)?", re.DOTALL)


SEEDED = (
    *(
        "analyze",
        "check",
        "export",
        "factor",
        "factors",
        "locus",
        "map",
        "modes",
        "path",
        "pose",
        "prove",
        "repl",
        "report",
    ),
    *("rewrite", "run", "shorten", "transversals"),
)
"""Names of the commands in which checks at random points decide."""


def seeded(command: click.Command) -> click.Command:
    """The command with --seed N, which repeats the points of its checks."""

    def chosen(ctx: click.Context, _: click.Parameter, value: int | None) -> None:
        ctx.with_resource(repeated(value))

    if not any(p.name == "seed" for p in command.params):
        words = "Repeat the points of exact random checks; by default they are unpredictable."
        command.params.append(
            click.Option(["--seed"], type=int, metavar="N", expose_value=False, callback=chosen, help=words)
        )
    return command
