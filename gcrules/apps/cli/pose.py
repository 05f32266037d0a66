"""The command pose: a robot in one pose."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option, length_option, nearest_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.pose import pose as computed

__all__ = ["pose"]


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option(
    "--at",
    metavar="POSE",
    help='"z=5, roll=10deg", or "x y z; euler zyx 10 0 0 deg"; by default the pose of the file.',
)
@click.option("--actuators", metavar="VALUES", help='Instead of a pose, for a robot of joints: "q1=0.1, q2=5deg".')
@about_option
@click.option(
    "--threshold",
    default="0.5 deg",
    show_default=True,
    metavar="ANGLE|LENGTH",
    help="Closer than this is close: turn of a leg (deg, rad), or translation.",
)
@click.option("--accuracy", metavar="LENGTH", help="How well the joints' places are known; by default exactly.")
@length_option
@nearest_option
@time_limit()
@output_options()
def pose(
    file: str,
    mode: str | None,
    at: str | None,
    actuators: str | None,
    about: str,
    threshold: str,
    accuracy: str | None,
    nearest: bool,
    length: str | None,
    out: Output,
) -> None:
    """Tell how close a robot is to a singularity in a pose, what is nearest, and why.

    \b
    gcrules pose robot.yaml
    gcrules pose robot.yaml --at "x=10, z=-5, yaw=30deg"
    gcrules pose robot.yaml --at "10 0 -5; euler zyx 30 0 0 deg" --about origin
    gcrules pose robot.yaml --at "0 0 5 mm; quaternion 1 0 0 0" --threshold 20mm --json
    gcrules pose 3-rps --at "z=0.2, roll=5deg, pitch=0deg"

    A pose is said by coordinates: x, y, z of the platform's centre, and roll, pitch, yaw about the fixed axes or rx,
    ry, rz, the rotation vector. Or it is a translation x y z and, after a semicolon, a turn: quaternion w x y z,
    rotation-vector x y z deg, or euler SEQUENCE a b c deg (xyz about the fixed axes, XYZ about the axes that turn
    along). It moves the platform from where the file has it. "-" reads the file from standard input. A robot that is
    described by its joints, a file or an id, is answered as by "gcrules robot pose"; with --accuracy as the platform
    that its six legs make.
    """
    loaded = warn(read_source(file, mode=mode))
    with working("computing"):
        found = computed(
            loaded,
            at,
            actuators=actuators,
            about=about,
            threshold=threshold,
            accuracy=accuracy,
            nearest=nearest,
            length=length,
        )
    out.show(found)
