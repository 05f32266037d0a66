"""The command `factor`."""

from __future__ import annotations

import click

from gcrules.algebra.factoring.factorize import factor as factored
from gcrules.algebra.factoring.limits import MAX_EXTENSORS, SECONDS
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.expressions import searched
from gcrules.apps.cli.limits import AROUND, limited, memory_option, time_limit
from gcrules.apps.cli.options import SpaceOptions, limit_option, space_options
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options

__all__ = ["factor"]


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@click.option("--cofactor", is_flag=True, help="Where there is none, look for one that equals a cofactor times EXPR.")
@limit_option(MAX_EXTENSORS, "Give up beyond this many extensors.")
@time_limit(SECONDS, "Give up after this time.", itself=True)
@memory_option
@space_options(metric=True)
@proof_options
@output_options(full="Show every expression, not only the simplest.")
@click.pass_context
def factor(
    ctx: click.Context,
    expression: str,
    cofactor: bool,
    limit: int,
    seconds: float,
    gigabytes: float | None,
    space: SpaceOptions,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Decide whether a scalar is a product of brackets and one expression of joins and meets.

    \b
    gcrules factor "[abfc][acde][bdef] + [abfd][acbe][cdef]"
    gcrules factor "[[Aa,Ab,Bc,Bd,Ca,Dc]]" --cofactor --json
    gcrules factor "[abd][ace] - [abe][acd]" --rank 3 --full

    "-" reads standard input. What is found is proved by normal forms; "none exists" is the result of testing every
    expression of the family that is named. docs/factor.md says what it covers.

    Exit code 0: found and proved. 1: none exists in the family, whether one with a cofactor was found or not. 3: not
    decided within the limits, and what is known is shown; or found, and shown, but tested at random points only, as the
    proof took too long.
    """
    with limited(seconds, AROUND, gigabytes):
        found = searched("factoring", factored, expression, space, limit, seconds, every=out.full, cofactor=cofactor)
        out.show(found)
        proofs.write(found, "proved" if found.proved else "undecided")
    ctx.exit(3 if not found.proved else 0 if found.exists else 1)
