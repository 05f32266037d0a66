"""The command path: a robot along a path."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.core.files import write_file
from gcrules.core.streams import is_stdout
from gcrules.poses.path_report import path as along
from gcrules.poses.paths.sampling import SAMPLES
from gcrules.views.drawing.drawing_files import save

__all__ = ["path"]


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option("--poses", "table", metavar="POSES.csv", help="A table of poses, two or more.")
@click.option("--at", multiple=True, metavar="POSE", help="A pose, as in gcrules pose; give two or more.")
@about_option
@click.option("--samples", default=SAMPLES, show_default=True, metavar="N", help="Places at which values are given.")
@click.option(
    "--threshold", default="0.5 deg", show_default=True, metavar="ANGLE", help="Closer than this is close (deg, rad)."
)
@click.option(
    "--csv",
    "values",
    type=OutputFile(alone=True),
    metavar="FILE.csv",
    help="Write the values along the path; - prints them instead of the answer.",
)
@click.option(
    "--plot",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the margin along the path, and the superbracket (of joints: the limbs' own margins).",
)
@time_limit(None)
@output_options(latex=False)
def path(
    file: str,
    mode: str | None,
    table: str | None,
    at: tuple[str, ...],
    about: str,
    samples: int,
    threshold: str,
    values: str | None,
    plot: str | None,
    out: Output,
) -> None:
    """Find every singular pose on a path through given poses, and say why it is singular.

    \b
    gcrules path robot.yaml --at "0 0 0" --at "0 0 -300; euler zyx 40 0 0 deg"
    gcrules path robot.yaml --poses poses.csv --csv values.csv --plot path.svg
    gcrules path 3-rps --at home --at "z=0.2, roll=20deg, pitch=10deg"

    Between two poses the centre moves on a straight line and the platform turns about one axis, the shorter way. None
    is missed, however few samples there are: the superbracket is an exact polynomial there. For a robot of joints a
    pose is "home" or names as many coordinates as it has freedoms; what lies between the steps is proved, or listed as
    not decided. The first line of a table
    names its columns: x, y, z, and qw, qx, qy, qz, or rx [deg], ry [deg], rz [deg], or zyx1 [deg], zyx2 [deg],
    zyx3 [deg]. "-" reads the robot's file from standard input; the id of a robot
    of "gcrules robot list" does as well.
    """
    if (table is None) == (not at):
        raise click.UsageError("Give the poses either by --poses POSES.csv or by --at, twice or more.")
    loaded = warn(read_source(file, mode=mode))
    try:
        with working("computing") as status:
            found = along(
                loaded,
                list(at) if table is None else table,
                samples=samples,
                about=about,
                threshold=threshold,
            )
    except KeyboardInterrupt:
        click.echo(f"interrupted while {status.text}; nothing was written", err=True)
        raise
    if plot is not None:
        save(found.plot(), plot)
    if values is not None:
        write_file(values, found.csv())
    if values is None or out.path is not None or not is_stdout(values):
        out.show(found)
