"""The command `shorten`."""

from __future__ import annotations

import click

from gcrules.algebra.syntax import Context, parse
from gcrules.cli.base import ExpressionCommand, Output, Space, output_options, space_options
from gcrules.cli.files import read_stdin, working
from gcrules.shortening.limits import MAX_MONOMIALS, SECONDS

__all__ = ["shorten"]


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@click.option(
    "--limit",
    type=click.IntRange(min=1),
    default=MAX_MONOMIALS,
    show_default=True,
    metavar="N",
    help="Give up beyond this many bracket monomials.",
)
@click.option(
    "--seconds",
    type=click.FloatRange(min=0),
    default=SECONDS,
    show_default=True,
    metavar="S",
    help="Search for no longer than this; what was found is the answer.",
)
@space_options()
@output_options()
def shorten(expression: str, limit: int, seconds: float, space: Space, out: Output) -> None:
    """Find the bracket polynomial with the fewest terms that equals a scalar.

    \b
    gcrules shorten "[[Aa,Bb,Cc,Dd,Ee,Ff]]"
    gcrules shorten "[abc][def] - [abd][cef] + [abe][cdf]" --rank 3 --json

    "-" reads standard input. What is found is proved by normal forms. The answer says whether it is proved that no
    bracket polynomial has fewer terms, or how many are needed at least. docs/shorten.md says how.

    Exit code 0: an answer was given. 3: there are more bracket monomials than the limit allows.
    """
    from gcrules.shortening.shorten import shorten as shortened  # numpy, for this command only

    source = read_stdin() if expression == "-" else expression
    e = parse(source, context=Context(space.rank, space.points, space.ideal))
    with working("shortening") as status:

        def progress(done: str) -> None:
            status.text = f"shortening: {done}"

        found = shortened(
            e,
            points=space.points,
            ideal=space.ideal,
            rank=space.rank,
            limit=limit,
            seconds=seconds,
            progress=progress,
        )
    out.show(found)
