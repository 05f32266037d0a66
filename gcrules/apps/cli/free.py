"""The command free: the largest region around a pose that is proved free of singular poses."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.regions.free_region import free_region

__all__ = ["free"]


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option("--at", metavar="POSE", help="The pose in the middle, as in gcrules pose; by default home.")
@click.option("--over", metavar="NAMES", help='Coordinates with proportions: "x, y, z", "x 2, rz 9 deg"; "actuators".')
@click.option("--ball", is_flag=True, help="A ball instead of a box.")
@about_option
@click.option("--boxes", type=int, metavar="N", help="Give up a size that this many boxes do not prove.")
@time_limit()
@output_options()
def free(
    file: str,
    mode: str | None,
    at: str | None,
    over: str | None,
    ball: bool,
    about: str,
    boxes: int | None,
    out: Output,
) -> None:
    """Find the largest box, or ball, around a pose that is proved free of singular poses.

    \b
    gcrules free robot.yaml --over "x, y, z"
    gcrules free robot.yaml --over "rx, ry, rz" --ball --at "0 0 20"
    gcrules free delta --over actuators

    Boxes that are not proved are halved, until all are or there are too many. With "actuators" the ranges of a robot's
    joints around home, or around the pose, that keep it regular. "-" reads the file from standard input.
    """
    loaded = warn(read_source(file, mode=mode))
    with working("proving"):
        found = free_region(loaded, at, over=over, ball=ball, boxes=boxes, about=about)
    out.show(found)
