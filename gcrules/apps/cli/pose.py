"""The command pose: a robot in one pose."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand, Output, output_options
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.platforms import centre, read_either
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.robot import Robot
from gcrules.poses.pose_report import pose as posed

__all__ = ["pose"]


@click.command(cls=ExpressionCommand)
@click.argument("file", metavar="FILE.yaml|ID")
@click.option(
    "--at",
    metavar="POSE",
    help='"x y z; euler zyx 10 0 0 deg"; by default the file\'s pose. Robots: "z=0.2, roll=5deg".',
)
@click.option("--actuators", metavar="VALUES", help='Instead of a pose, of a robot with joints: "q1=0.1, q2=5deg".')
@click.option(
    "--about",
    metavar="CENTRE",
    help="What the platform turns about: origin (the default of geometry files), centroid, or x,y,z.",
)
@click.option(
    "--threshold",
    default="0.5 deg",
    show_default=True,
    metavar="ANGLE|LENGTH",
    help="Closer than this is close: turn of a leg (deg, rad), or translation.",
)
@click.option("--accuracy", metavar="LENGTH", help="How well the joints' places are known; by default exactly.")
@click.option("--nearest/--no-nearest", default=None, help="Seek the nearest singular poses (about a second).")
@time_limit()
@output_options()
def pose(
    file: str,
    at: str | None,
    actuators: str | None,
    about: str | None,
    threshold: str,
    accuracy: str | None,
    nearest: bool | None,
    out: Output,
) -> None:
    """Tell how close a robot is to a singularity in a pose, what is nearest, and why.

    \b
    gcrules pose robot.yaml
    gcrules pose robot.yaml --at "10 0 -5; euler zyx 30 0 0 deg" --about centroid
    gcrules pose robot.yaml --at "0 0 5 mm; quaternion 1 0 0 0" --threshold 20mm --json
    gcrules pose 3-rps --at "z=0.2, roll=5deg, pitch=0deg"

    A pose is a translation x y z and, after a semicolon, a turn: quaternion w x y z, rotation-vector x y z deg, or
    euler SEQUENCE a b c deg (xyz about the fixed axes, XYZ about the axes that turn along). It moves the platform from
    where the file has it. "-" reads the file from standard input. A robot that is described by its joints, a file or
    an id, is answered as by "gcrules robot pose"; with --nearest, --accuracy or --about x,y,z as the platform that its
    six legs make.
    """
    read = read_either(file)
    if isinstance(read, Robot):
        about = centre(read, about)
        unfit = [option for option, value in (("--accuracy", accuracy), ("--nearest", nearest)) if value]
        unfit += ["--about"] if about != "centroid" else []
        if not unfit:
            with working("computing"):
                answer = read.pose(at, actuators=actuators, threshold=threshold)
            out.show(answer)
            return
        read = _as_platform(read, unfit[0])
    if actuators is not None:
        raise InputError("--actuators is for robots described by their joints", hint="give a pose by --at")
    with working("computing"):
        found = posed(
            read,
            "0 0 0" if at is None else at,
            about=about or "origin",
            threshold=threshold,
            accuracy=accuracy,
            nearest=nearest is not False,
        )
    out.show(found)


def _as_platform(robot: Robot, option: str) -> Platform:
    try:
        return as_platform(robot)
    except InputError as fault:
        raise InputError(
            f"{option} is for platforms with their dimensions; {fault.message}",
            hint="its platform turns about the centroid of the limbs' ends; see docs/robot-numbers.md",
        ) from None
