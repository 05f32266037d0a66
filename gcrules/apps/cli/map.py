"""The command map: singular poses over two or three coordinates."""

from __future__ import annotations

import json
import os
from typing import Any

import click

from gcrules.apps.cli.base import ExpressionCommand, Output, about_option
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.core.budget import report
from gcrules.core.errors import InputError
from gcrules.core.files import after_writing
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.maps.maps import bytes_of, done, planned
from gcrules.poses.maps.store import check_room
from gcrules.poses.maps.task import MEASURES
from gcrules.views.plots.map_files import MAP_FORMATS, check_outputs

__all__ = ["map_"]


@click.command("map", cls=ExpressionCommand)
@click.argument("file", metavar="FILE.yaml|ID")
@mode_option
@click.option(
    "--over",
    multiple=True,
    metavar="RANGE",
    help='A coordinate with start:stop:number, "x -200:200:201" or "rz -90:90:181 deg"; give two or three.',
)
@click.option("--at", metavar="POSE", help="The pose of the other coordinates, as in gcrules pose; the file's own.")
@about_option
@click.option(
    "--limits",
    metavar="RANGES",
    help='What legs or actuators reach: "leg lengths 1..3", "ab 1..3, cd 2..", of joints "q1 -30..30 deg".',
)
@click.option(
    "--threshold", default="0.5 deg", show_default=True, metavar="ANGLE", help="Closer than this is close (deg, rad)."
)
@click.option(
    "--measure",
    default="margin",
    show_default=True,
    type=click.Choice(MEASURES),
    help="margin σ and leg lengths too; the superbracket only, which is quick; or the margin and what actuators do.",
)
@time_limit(None)
@click.option("--restart", is_flag=True, help="Throw away finished chunks of an earlier run and begin anew.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.option(
    "--unicode/--ascii", " /--plain", "mathematics", default=None, help="Unicode or plain ASCII; by default what fits."
)
@click.option(
    "-o",
    "--output",
    "outputs",
    type=OutputFile(),
    multiple=True,
    metavar="FILE",
    help=f"Write a file, as often as you like; its suffix says what: {' '.join(MAP_FORMATS)}.",
)
def map_(
    file: str,
    mode: str | None,
    over: tuple[str, ...],
    at: str | None,
    about: str,
    limits: str | None,
    threshold: str,
    measure: str,
    restart: bool,
    as_json: bool,
    mathematics: bool | None,
    outputs: tuple[str, ...],
) -> None:
    """Map the singular poses over two or three coordinates: curves or surfaces, with proof of what is free.

    \b
    gcrules map robot.yaml --over "x -200:200:201" --over "z -400:100:251" -o map.svg
    gcrules map robot.yaml --over "x -1:1:101" --over "y -1:1:101" --over "z 0:1:51" -o map.nc -o surface.glb
    gcrules map robot.yaml --over "rx -60:60:121 deg" --over "ry -60:60:121 deg" --at "0 0 50" --limits "legs 1..3"
    gcrules map delta --over "x -0.8:0.8:81" --over "y -0.8:0.8:81" --at "z=0.2" -o map.svg

    The coordinates are x, y, z (translation), roll, pitch, yaw, rx, ry, rz (rotation vector), zyx1, zyx2, zyx3 or
    another sequence of Euler angles, or azimuth, tilt, torsion; angles end with deg or rad. A robot of joints is mapped
    over x, y, z, roll, pitch, yaw or over its actuators q1, q2 …, from home; --at names what the others are. A long run
    may be interrupted: with -o the finished chunks are kept in a folder FILE.part, and the same command goes on from
    there. "-" reads the robot's file from standard input; the id of a robot, as of "gcrules robot list", does as well.
    """
    check_outputs(outputs, len(over))
    work = _folder(outputs)
    if work is None and restart:
        raise InputError("--restart without -o", hint="chunks are kept only where -o names a file")
    plan = planned(mechanism(warn(read_source(file, mode=mode)), about=about), over, at, limits, threshold, measure)
    task = plan.task
    if work is not None:
        if task.number == 1 and not os.path.isdir(work):
            work = None
        check_room(outputs[0], bytes_of(task) * ((work is not None) + any(o.lower().endswith(".nc") for o in outputs)))
    with working("computing"):
        try:
            found = done(plan, work=work, restart=restart)
            _save(found, outputs)
        except KeyboardInterrupt:
            if work is not None:
                click.echo(f"\ninterrupted; finished chunks are kept in {work}: run the same command again", err=True)
            raise
    out = Output(json=as_json, mathematics=mathematics)
    if as_json:
        click.echo(json.dumps(found.to_json()))
    else:
        out.show(found)
    after_writing(found.store.close)


def _folder(outputs: tuple[str, ...]) -> str | None:
    data = [o for o in outputs if o.lower().endswith(".nc")] or list(outputs)
    return f"{data[0]}.part" if data else None


def _save(found: Any, outputs: tuple[str, ...]) -> None:
    for path in outputs:
        report(f"writing {path}")
        found.save(path)
