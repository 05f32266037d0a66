"""The command modes: in how many ways a robot can be assembled."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import read_source, warn
from gcrules.poses.modes.modes import assembly_modes
from gcrules.poses.modes.working import working_modes
from gcrules.poses.operation_modes.operation_modes import operation_modes
from gcrules.views.drawing.drawing_files import save

__all__ = ["modes"]

_CLOSE = "0.5 deg"


@click.command(cls=ExpressionCommand)
@mechanism_argument
@click.option(
    "--working", "inverse", is_flag=True, help="The ways in which the limbs hold the platform in one place instead."
)
@click.option(
    "--operation", is_flag=True, help="The irreducible sets of poses that its limbs allow, actuators free, instead."
)
@click.option("--at", metavar="POSE", help="The pose in question; by default that of the file.")
@click.option(
    "--actuators",
    metavar="VALUES",
    help='Hold them at these values: "q1=0.1, q2=5deg", or lengths of legs, "ab=1.2" or all six "1 1 1 1 1 1".',
)
@about_option
@click.option(
    "--threshold",
    default=_CLOSE,
    show_default=True,
    metavar="ANGLE|LENGTH",
    help="Closer than this is close: turn of a leg (deg, rad), or translation.",
)
@click.option(
    "--picture",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the robot in each assembly mode, eight in a row.",
)
@time_limit()
@output_options()
def modes(
    file: str,
    inverse: bool,
    operation: bool,
    at: str | None,
    actuators: str | None,
    about: str,
    threshold: str,
    picture: str | None,
    out: Output,
) -> None:
    """Find all poses that a robot can take with its actuators held, and say whether they are all: its assembly modes.

    \b
    gcrules modes robot.yaml
    gcrules modes robot.yaml --at "x=10, z=-5, yaw=30deg" --json
    gcrules modes examples/dietmaier.yaml --actuators "1 0.645275 1.086284 1.503439 1.281933 0.771071"
    gcrules modes 3-rps --actuators "q1=0.1, q2=0, q3=-0.1" --picture modes.svg

    Each pose comes with what is proved of it (that there is exactly one solution in a box around it), its margin and
    verdict, and the signs of the condition's factors. Six legs have at most 40 complex solutions, and all are followed
    from a system that is solved; so are those of most robots of joints. Where no count is known configurations are
    sought from random joints, and the answer says so. Curves of solutions (self-motions) are listed as such. "-" reads
    the file from standard input.

    \b
    gcrules modes delta --working
    gcrules modes 3-rrr --working --at "x=0.5, y=0, yaw=10deg"

    With --working the platform is held and the limbs are solved for: a working mode is named by a sign for each limb,
    + as at home; where a limb has more than two ways, by their numbers, "1.3.1". With --at each mode is followed from
    home to that pose.

    \b
    gcrules modes 3-upu --operation

    With --operation the poses of a robot with fewer than six freedoms are taken apart into irreducible sets, by
    polynomials in Study parameters of the platform, home being x0 = 1, and it is said where they meet.

    Commands about robots take a mode by --mode: "+-+", "assembly 3", "operation 2". Then home is in that mode.
    """
    given = (at, actuators, picture, None if about == "centroid" else about, None if threshold == _CLOSE else threshold)
    if operation and (inverse or any(one is not None for one in given)):
        raise click.UsageError(
            "--operation is about all poses: it takes no pose, no actuators, --about or --threshold."
        )
    if inverse and (actuators is not None or picture is not None):
        raise click.UsageError("--working holds the platform: it goes with --at, not with --actuators or --picture.")
    loaded = warn(read_source(file))
    with working("computing"):
        if inverse:
            out.show(working_modes(loaded, at, about=about, threshold=threshold))
            return
        if operation:
            out.show(operation_modes(loaded))
            return
        found = assembly_modes(loaded, at, actuators=actuators, about=about, threshold=threshold)
    if picture is not None:
        save(found.picture(), picture)
    out.show(found)
