"""The command regions: how singular lengths part the lengths of a robot's legs."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import read_source, warn
from gcrules.core.errors import InputError
from gcrules.core.files import write_file
from gcrules.core.streams import is_stdout
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.length_regions.asked import Asked
from gcrules.poses.length_regions.length_regions import SLICES, length_regions
from gcrules.poses.length_regions.three_legs import three_legs
from gcrules.views.drawing.drawing_files import save

__all__ = ["regions"]


@click.command(cls=ExpressionCommand)
@mechanism_argument
@click.option("--over", metavar="RANGES", help='The lengths that are looked at: "q2 0.1..4, q3 ..4".')
@click.option("--held", metavar="LENGTH", help='The leg that is held, and at which length: "q1=1"; by default home\'s.')
@click.option(
    "--slices", default=SLICES, show_default=True, metavar="N", help="With ranges of all legs: this many slices."
)
@click.option(
    "--picture",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the plane of two lengths, coloured by the number of assembly modes.",
)
@click.option("--csv", "table", type=OutputFile(alone=True), metavar="FILE.csv", help="Write a table of the regions.")
@time_limit()
@output_options()
def regions(
    file: str,
    over: str | None,
    held: str | None,
    slices: int,
    picture: str | None,
    table: str | None,
    out: Output,
) -> None:
    """Find into how many regions singular lengths part the lengths of a robot's legs, and the assembly modes in each.

    \b
    gcrules regions 3-rpr
    gcrules regions robot.yaml --over "q2 0..4, q3 0..4" --held "q1=1" --picture regions.svg
    gcrules regions robot.yaml --over "q1 0..3, q2 0..4, q3 0..4"

    For planar robots on three legs of variable length. Legs are named by their actuators; numbers are lengths, not
    amounts from home. Over two lengths the answer is exact; over three the regions are those that slices meet. Exit
    code 0: the number of regions is known, 3: not decided. "-" reads the file from standard input.
    """
    loaded = warn(read_source(file))
    if picture is not None and Asked.of(three_legs(mechanism(loaded)), over, held).held is None:
        raise InputError("a picture is of two lengths", hint="give two ranges, and hold the third leg")
    with working("computing"):
        found = length_regions(loaded, over=over, held=held, slices=slices)
    if picture is not None:
        save(found.picture(), picture)
    if table is not None:
        write_file(table, found.csv())
    if table is None or out.path is not None or not is_stdout(table):
        out.show(found)
    click.get_current_context().exit(0 if found.decided else 3)
