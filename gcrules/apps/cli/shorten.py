"""The command `shorten`."""

from __future__ import annotations

import click

from gcrules.algebra.shortening.limits import MAX_MONOMIALS, SECONDS
from gcrules.algebra.shortening.shorten import shorten as shortened
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.expressions import searched
from gcrules.apps.cli.limits import AROUND, limited, time_limit
from gcrules.apps.cli.options import SpaceOptions, limit_option, space_options
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options

__all__ = ["shorten"]


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@limit_option(MAX_MONOMIALS, "Give up beyond this many bracket monomials.")
@time_limit(SECONDS, "Search for no longer than this; what was found is the answer.", itself=True)
@space_options(metric=True)
@proof_options
@output_options()
@click.pass_context
def shorten(
    ctx: click.Context,
    expression: str,
    limit: int,
    seconds: float,
    space: SpaceOptions,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Find the bracket polynomial with the fewest terms that equals a scalar.

    \b
    gcrules shorten "[[Aa,Bb,Cc,Dd,Ee,Ff]]"
    gcrules shorten "[abc][def] - [abd][cef] + [abe][cdf]" --rank 3 --json

    "-" reads standard input. What is found is proved by normal forms. The answer says whether it is proved that no
    bracket polynomial has fewer terms, or how many are needed at least. docs/shorten.md says how.

    Exit code 0: an answer was given. 3: there are more bracket monomials than the limit allows, so that the form that
    is shown may not be the shortest; or there is no normal form in the time.
    """
    with limited(seconds, AROUND):
        found = searched("shortening", shortened, expression, space, limit, seconds)
        out.show(found, found.text(unicode=out.unicode, short=True) if out.terminal else None)
        proofs.write(found)
    ctx.exit(3 if found.undecided else 0)
