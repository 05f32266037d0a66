"""The command `discover`."""

from __future__ import annotations

import click

from gcrules.algebra.discovery.discover import discover as discovered
from gcrules.algebra.discovery.limits import MAX_CANDIDATES, RELATIONS, SECONDS
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.language.statements import parse_script
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import read_stdin, working
from gcrules.apps.cli.limits import Seconds, time_limit
from gcrules.apps.cli.options import limit_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.verdicts import EXIT_CODES
from gcrules.core.yaml_file import read_text

__all__ = ["discover"]


@click.command(cls=ExpressionCommand)
@click.argument("file", metavar="FILE.gca")
@click.option(
    "--relation",
    "relations",
    multiple=True,
    type=click.Choice(RELATIONS),
    metavar="RELATION",
    help=f"Show only these: {', '.join(RELATIONS)}; may be repeated.",
)
@click.option(
    "--candidates",
    type=click.IntRange(min=1),
    default=MAX_CANDIDATES,
    show_default=True,
    metavar="N",
    help="Give up where there are more sets of points and lines to look at.",
)
@click.option(
    "--exceptions",
    type=Seconds(),
    default=SECONDS,
    show_default=True,
    metavar="S",
    help="Look no longer than this for positions at which a discovery fails.",
)
@limit_option(MAX_TERMS, "Leave undecided what takes more terms than this to prove.")
@time_limit(plus="exceptions")
@output_options()
@click.pass_context
def discover(
    ctx: click.Context,
    file: str,
    relations: tuple[str, ...],
    candidates: int,
    exceptions: float,
    limit: int,
    out: Output,
) -> None:
    """Find the incidences of a construction that hold and are not trivial, and prove them.

    \b
    gcrules discover examples/theorems/pappus.gca
    A file holds points and what is assumed of them; names for meets and joins are looked at too:
        rank 3
        given collinear(a, b, c), collinear(a', b', c')
        let x = bc' /\\ b'c

    "-" reads standard input. Claims of the file are not looked at. docs/discover.md says what is looked for, and what
    counts as trivial.

    Exit code 0: what was found is proved. 3: something holds at random positions, but is not proved within the limit;
    or there are more candidates than the limit allows.
    """
    script = parse_script(read_stdin(), "<stdin>") if file == "-" else parse_script(read_text(file), file)
    with working("discovering"):
        found = discovered(
            script.context, relations=relations or RELATIONS, limit=limit, most=candidates, seconds=exceptions
        )
    out.show(found)
    ctx.exit(EXIT_CODES[found.verdict])
