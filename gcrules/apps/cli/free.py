"""The command free: the largest region around a pose that is proved free of singular poses."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, certificate_option, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument, offering
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.regions.free_region import free_region
from gcrules.screws.pose_text import COORDINATES
from gcrules.views.drawing.drawing_files import save

__all__ = ["free"]


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option("--at", metavar="POSE", help="The pose in the middle, as in gcrules pose; by default home.")
@click.option(
    "--over",
    metavar="NAMES",
    shell_complete=offering(*COORDINATES, "actuators", several=True),
    help='Coordinates with proportions: "x, y, z", "x 2, rz 9 deg"; "actuators".',
)
@click.option("--ball", is_flag=True, help="A ball instead of a box.")
@about_option
@click.option("--boxes", type=int, metavar="N", help="Give up a size that this many boxes do not prove.")
@click.option(
    "--picture",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the range of each coordinate, and the pose at which the proof ended.",
)
@certificate_option("Write the region, which check_free.py of `gcrules checkers` proves again without gcrules.")
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
    picture: str | None,
    certificate: str | None,
    out: Output,
) -> None:
    """Find the largest box, or ball, around a pose that is proved free of singular poses.

    \b
    gcrules free robot.yaml --over "x, y, z"
    gcrules free robot.yaml --over "rx, ry, rz" --ball --at "0 0 20"
    gcrules free delta --over actuators --picture free.svg

    Boxes that are not proved are halved, until all are or there are too many. With "actuators" the ranges of a robot's
    joints around home, or around the pose, that keep it regular. "-" reads the file from standard input.
    """
    loaded = warn(read_source(file, mode=mode))
    with working("proving"):
        found = free_region(loaded, at, over=over, ball=ball, boxes=boxes, about=about)
    if picture is not None:
        save(found.picture(), picture)
    out.show(found)
    if certificate is not None:
        found.save_certificate(certificate)
