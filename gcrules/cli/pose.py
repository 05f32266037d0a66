"""The command pose: a robot in one pose."""

from __future__ import annotations

import click

from gcrules.cli.base import ExpressionCommand, Output, about_option, output_options
from gcrules.cli.files import working
from gcrules.cli.platforms import read_platform
from gcrules.posed import pose as posed

__all__ = ["pose"]


@click.command(cls=ExpressionCommand)
@click.argument("file", metavar="FILE.yaml")
@click.option(
    "--at", default="0 0 0", metavar="POSE", help='"x y z; euler zyx 10 0 0 deg"; by default the file\'s pose.'
)
@about_option
@click.option(
    "--threshold",
    default="0.5 deg",
    show_default=True,
    metavar="ANGLE|LENGTH",
    help="Closer than this is close: turn of a leg (deg, rad), or translation.",
)
@click.option("--accuracy", metavar="LENGTH", help="How well the joints' places are known; by default exactly.")
@click.option("--nearest/--no-nearest", default=True, help="Seek the nearest singular poses (about a second).")
@output_options()
def pose(file: str, at: str, about: str, threshold: str, accuracy: str | None, nearest: bool, out: Output) -> None:
    """Tell how close a robot is to a singularity in a pose, what is nearest, and why.

    \b
    gcrules pose robot.yaml
    gcrules pose robot.yaml --at "10 0 -5; euler zyx 30 0 0 deg" --about centroid
    gcrules pose robot.yaml --at "0 0 5 mm; quaternion 1 0 0 0" --threshold 20mm --json

    A pose is a translation x y z and, after a semicolon, a turn: quaternion w x y z, rotation-vector x y z deg, or
    euler SEQUENCE a b c deg (xyz about the fixed axes, XYZ about the axes that turn along). It moves the platform from
    where the file has it. "-" reads the file from standard input.
    """
    platform = read_platform(file)
    with working("computing"):
        found = posed(platform, at, about=about, threshold=threshold, accuracy=accuracy, nearest=nearest)
    out.show(found)
