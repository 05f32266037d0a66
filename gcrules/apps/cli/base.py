"""What the commands share: groups that load commands when used, arguments that begin with a minus sign, options."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from difflib import get_close_matches
from functools import wraps
from importlib import import_module
from typing import Any

import click
from click.shell_completion import CompletionItem

from gcrules.apps.cli.files import ANSWERED, OutputCommand, OutputFile, printed
from gcrules.apps.cli.limits import Seconds
from gcrules.core import interrupts, streams
from gcrules.core.budget import waiting
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError
from gcrules.core.files import write_file
from gcrules.core.seeds import repeated

__all__ = [
    "ExpressionCommand",
    "LazyGroup",
    "Output",
    "SpaceOptions",
    "about_option",
    "catalog_option",
    "colour_choice",
    "decorated",
    "given_option",
    "json_option",
    "latex_option",
    "length_option",
    "limit_option",
    "mathematics_option",
    "nearest_option",
    "output_options",
    "search_option",
    "space_options",
]

_Command = Callable[..., Any]

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
            package = (fault.name or "gcrules").partition(".")[0]
            if package == "gcrules":
                raise
            click.echo(f"error: this answer needs {package}, which is not installed here", err=True)
            click.echo("hint: pip install gcrules brings it", err=True)
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
    *("analyze", "check", "export", "factor", "locus", "map", "modes", "path", "pose", "prove", "repl", "report"),
    *("rewrite", "run", "shorten", "transversals"),
)
"""Names of the commands in which checks at random points decide."""


def seeded(command: click.Command) -> click.Command:
    """The command with --seed N, which repeats the points of its checks."""

    def chosen(ctx: click.Context, _: click.Parameter, value: int | None) -> None:
        ctx.with_resource(repeated(value))

    if not any(p.name == "seed" for p in command.params):
        words = "Repeat the points of exact random checks; by default nobody can foresee them."
        command.params.append(
            click.Option(["--seed"], type=int, metavar="N", expose_value=False, callback=chosen, help=words)
        )
    return command


# --- options -------------------------------------------------------------------------------------------------------

catalog_option = click.option("--catalog", "catalogs", multiple=True, metavar="FILE", help="Add a catalog of your own.")


given_option = click.option(
    "--given",
    "assumptions",
    multiple=True,
    metavar="ASSUMPTIONS",
    help='Assume them: "collinear(a, b, c), incident(p, X)", coplanar, concurrent, "LHS == RHS", "ideal i j".',
)


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
    texts: list[str] = field(default_factory=list, repr=False, compare=False)
    """What is written to the file when the command has ended with an answer."""

    def __post_init__(self) -> None:
        if self.json and self.latex:
            raise click.UsageError("--json and --latex exclude each other.")

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

    def show(self, answer: Any, text: str | None = None) -> None:
        """Print an answer that has `to_json()`, `text(unicode=…)` and `latex()`; `text` replaces the plain text."""
        if self.json:
            self.write(json.dumps(answer.to_json(), indent=2))
        elif self.latex:
            self.write(answer.latex())
        else:
            self.write(answer.text(unicode=self.unicode) if text is None else text)

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
                click.echo(f"note: {self.path} is not written, for nothing is decided", err=True)


def output_options(*, latex: bool = True) -> Callable[[_Command], _Command]:
    """--json, --latex, --unicode/--ascii, --output; the command receives them as `out`."""

    def decorate(command: _Command) -> _Command:
        @wraps(command)
        def with_output(**options: Any) -> Any:
            out = Output(
                options.pop("as_json"), options.pop("as_latex", False), options.pop("mathematics"), options.pop("path")
            )
            try:
                result = command(out=out, **options)
            except click.exceptions.Exit as end:
                out.deliver(end.exit_code)
                raise
            out.deliver(0)
            return result

        decorators = [
            json_option,
            *([latex_option] if latex else []),
            mathematics_option,
            click.option(
                "-o",
                "--output",
                "path",
                type=OutputFile(),
                metavar="FILE",
                help="Write to a file, if the exit code is 0 or 1.",
            ),
        ]
        return decorated(with_output, decorators)

    return decorate


@dataclass(frozen=True)
class SpaceOptions:
    """The rank, the declared points and the points at infinity."""

    rank: int
    points: tuple[str, ...]
    ideal: tuple[str, ...]


def space_options(*, rank: bool = True) -> Callable[[_Command], _Command]:
    """--rank, --points, --ideal; the command receives them as `space`."""

    def decorate(command: _Command) -> _Command:
        @wraps(command)
        def with_space(**options: Any) -> Any:
            points, ideal = (_names(options.pop(key)) for key in ("points", "ideal"))
            return command(space=SpaceOptions(options.pop("rank", 4), points, ideal), **options)

        decorators = [
            *(
                [click.option("--rank", type=int, default=4, show_default=True, metavar="N", help="The rank, 2 to 8.")]
                if rank
                else []
            ),
            click.option(
                "--points",
                default="",
                metavar="NAMES",
                help='Names of points in tableau order; declares names of several letters: "left right top base".',
            ),
            click.option("--ideal", default="", metavar="NAMES", help='Points at infinity: "i j k".'),
        ]
        return decorated(with_space, decorators)

    return decorate


def _names(text: str) -> tuple[str, ...]:
    names = tuple(re.findall(r"[^\s,]+", text))
    twice = next((n for i, n in enumerate(names) if n in names[:i]), None)
    if twice is not None:
        raise InputError(f"the point {twice} is declared twice")
    return names


def decorated(command: _Command, decorators: Sequence[Callable[[_Command], _Command]]) -> _Command:
    """A command with decorators as if they were written above it."""
    for decorator in reversed(decorators):
        command = decorator(command)
    return command


def limit_option(default: int, words: str) -> Callable[[_Command], _Command]:
    """--limit N."""
    return click.option(
        "--limit", type=click.IntRange(min=1), default=default, show_default=True, metavar="N", help=words
    )


def search_option(default: float) -> Callable[[_Command], _Command]:
    """--search S."""
    return click.option(
        "--search",
        type=Seconds(),
        default=default,
        show_default=True,
        metavar="S",
        help="Seek a factorization for so many seconds where no rule finds a condition.",
    )


nearest_option = click.option(
    "--nearest/--no-nearest",
    default=True,
    show_default=True,
    help="Seek the nearest singular poses, for a second or two.",
)
length_option = click.option(
    "--length",
    metavar="LENGTH",
    help="Characteristic length of the actuators' condition number; the robot's size by default.",
)
about_option = click.option(
    "--about",
    default="centroid",
    show_default=True,
    metavar="CENTRE",
    help="What the platform turns about: centroid (of its joints), origin (of the file), or x,y,z.",
)
