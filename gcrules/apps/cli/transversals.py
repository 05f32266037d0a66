"""The command `transversals`."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import read_stdin, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.options import SpaceOptions, given_option, space_options
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options
from gcrules.conditions.transversals import transversals as compared

__all__ = ["transversals"]

NOT_DECIDED = 3


@click.command(cls=ExpressionCommand)
@click.argument("legs", nargs=-1, required=True, metavar="LEGS")
@given_option
@time_limit()
@space_options(rank=False)
@proof_options
@output_options(full="Show every reading, not only the simplest.")
@click.pass_context
def transversals(
    ctx: click.Context,
    legs: tuple[str, ...],
    assumptions: tuple[str, ...],
    space: SpaceOptions,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Compare the turns about two lines: the lines that meet four legs, found from the common joints of the legs.

    \b
    gcrules transversals "Aa Ab Bc Cd De Ef"
    gcrules transversals "ab bc ca de fg hi" --full
    gcrules transversals "Aa Ab Ba Cc Dd Ee" --json

    Without two of the legs the platform can turn about each of two lines. Each of the two legs allows these turns in
    one ratio only; the robot is singular where the ratios agree. "-" reads the legs from standard input.

    Exit code 0: found. 1: there is no such condition. 3: none was found, though there may be one.
    """
    source = read_stdin() if legs == ("-",) else " ".join(legs)
    with working("looking for transversals"):
        found = compared(
            source,
            every=out.full,
            points=space.points,
            ideal=space.ideal,
            given=assumptions,
            letters=space.letters,
        )
    out.show(found)
    if found.exists:
        proofs.write(found)
    ctx.exit(0 if found.exists else 1 if found.definite else NOT_DECIDED)
