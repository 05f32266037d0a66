"""The command modes: in how many ways a robot can be assembled."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand, Output, about_option, output_options
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.sources import read_source, warn
from gcrules.poses.modes.working import working_modes

__all__ = ["modes"]


@click.command(cls=ExpressionCommand)
@click.argument("file", metavar="FILE.yaml|ID")
@click.option("--at", metavar="POSE", help="The pose in which the numbers are wanted; home by default.")
@about_option
@click.option(
    "--threshold", default="0.5 deg", show_default=True, metavar="ANGLE", help="Closer than this is close (deg, rad)."
)
@time_limit()
@output_options()
def modes(file: str, at: str | None, about: str, threshold: str, out: Output) -> None:
    """List the working modes of a robot: all ways in which its limbs hold the platform where it is at home.

    \b
    gcrules modes delta
    gcrules modes 3-rrr --at "x=0.5, y=0, yaw=10deg"
    gcrules pose delta --mode +-+ --at "z=0.1"

    A mode is named by a sign for each limb, + as at home; where a limb has more than two ways, by their numbers,
    "1.3.1". With --at each mode is followed from home to that pose. Commands about robots take a mode by --mode:
    then the robot's home is in that mode.
    """
    loaded = warn(read_source(file))
    with working("computing"):
        found = working_modes(loaded, at, about=about, threshold=threshold)
    out.show(found)
