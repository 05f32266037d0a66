"""The command `factors`."""

from __future__ import annotations

import click

from gcrules.algebra.factoring.factors import factors as factored
from gcrules.algebra.factoring.limits import MAX_EXTENSORS, SECONDS
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.expressions import searched
from gcrules.apps.cli.limits import AROUND, limited, memory_option, time_limit
from gcrules.apps.cli.options import SpaceOptions, limit_option, space_options
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options

__all__ = ["factors"]


@click.command(cls=ExpressionCommand)
@click.argument("expression", metavar="EXPR")
@limit_option(MAX_EXTENSORS, "Give up beyond this many extensors.")
@time_limit(SECONDS, "Search for no longer than this; the factors that were found are the answer.", itself=True)
@memory_option
@space_options(metric=True)
@proof_options
@output_options()
@click.pass_context
def factors(
    ctx: click.Context,
    expression: str,
    limit: int,
    seconds: float,
    gigabytes: float | None,
    space: SpaceOptions,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Find the irreducible factors of a scalar, each with its multiplicity, its degrees and a form.

    \b
    gcrules factors "[[Aa,Ab,Ba,Bb,Cc,Dd]]"
    gcrules factors "([abc][def] + 2 [abd][cef])**2 [abc]" --rank 3 --json

    "-" reads standard input. The form is one expression of joins and meets, else a comparison of the turns about two
    lines, else two bracket monomials, else one expression with a cofactor, else none, with what was excluded.
    docs/factor.md says how.

    Exit code 0: all factors are irreducible, and each has a form. 1: one of them has none of these forms. 3: not
    decided within the limits; what was found is shown.
    """
    with limited(seconds, AROUND, gigabytes):
        found = searched("factoring", factored, expression, space, limit, seconds)
        out.show(found)
        proofs.write(found, "proved" if found.decided else "undecided")
    ctx.exit(0 if found.complete else 1 if found.decided else 3)
