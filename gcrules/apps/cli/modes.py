"""The command modes: all poses that a robot can take with its actuators held."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand, Output, about_option, output_options
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.sources import read_source, warn
from gcrules.poses.modes.modes import assembly_modes
from gcrules.views.drawing.drawing_files import save

__all__ = ["modes"]


@click.command(cls=ExpressionCommand)
@click.argument("file", metavar="FILE.yaml|ID")
@click.option(
    "--at", metavar="POSE", help="Hold the actuators where they are at this pose; by default that of the file."
)
@click.option(
    "--actuators",
    metavar="VALUES",
    help='Hold them at these values: "q1=0.1, q2=5deg", or lengths of legs, "ab=1.2" or all six "1 1 1 1 1 1".',
)
@about_option
@click.option(
    "--threshold",
    default="0.5 deg",
    show_default=True,
    metavar="ANGLE|LENGTH",
    help="Closer than this is close: turn of a leg (deg, rad), or translation.",
)
@click.option(
    "--picture",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the robot in each mode, eight in a row.",
)
@time_limit()
@output_options()
def modes(
    file: str,
    at: str | None,
    actuators: str | None,
    about: str,
    threshold: str,
    picture: str | None,
    out: Output,
) -> None:
    """Find all poses that a robot can take with its actuators held, and say whether they are all.

    \b
    gcrules modes robot.yaml
    gcrules modes robot.yaml --at "x=10, z=-5, yaw=30deg" --json
    gcrules modes examples/dietmaier.yaml --actuators "1 0.645275 1.086284 1.503439 1.281933 0.771071"
    gcrules modes 3-rps --actuators "q1=0.1, q2=0, q3=-0.1" --picture modes.svg

    Each pose comes with what is proved of it (that there is exactly one solution in a box around it), its margin and
    verdict, and the signs of the condition's factors. Six legs have at most 40 complex solutions, and all are followed
    from a system that is solved; so are those of most robots of joints. Where no count is known configurations are
    sought from random joints, and the answer says so. Curves of solutions (self-motions) are told as such. "-" reads
    the file from standard input.
    """
    loaded = warn(read_source(file))
    with working("computing"):
        found = assembly_modes(loaded, at, actuators=actuators, about=about, threshold=threshold)
    if picture is not None:
        save(found.picture(), picture)
    out.show(found)
