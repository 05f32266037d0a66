"""The command map: singular poses over two or three coordinates."""

from __future__ import annotations

import os
from typing import Any

import click

from gcrules.apps.cli.files import certificate_option, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.map_options import at_option, check_whole, limits_option, show, telling_what_is_kept, tile_options
from gcrules.apps.cli.map_tiles import MapCommand
from gcrules.apps.cli.naming import mechanism_argument, offering
from gcrules.apps.cli.options import about_option, digits_option
from gcrules.apps.cli.output import Output
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.core.budget import report
from gcrules.core.errors import InputError
from gcrules.core.files import after_writing, check_room
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.maps.cell_certificate import check_cells
from gcrules.poses.maps.maps import MAX_HELD, done, map_part
from gcrules.poses.maps.planned import Plan, bytes_of, planned
from gcrules.poses.maps.task import MEASURES
from gcrules.poses.tiles.how import HERE, Running, running
from gcrules.poses.tiles.zarr_files import has_zarr
from gcrules.screws.pose_text import COORDINATES
from gcrules.views.plots.map_files import MAP_FORMATS, check_outputs

__all__ = ["map_"]


@click.command("map", cls=MapCommand)
@mechanism_argument
@mode_option
@click.option(
    "--over",
    multiple=True,
    metavar="RANGE",
    shell_complete=offering(*COORDINATES),
    help='A coordinate with start:stop:number, "x -200:200:201" or "rz -90:90:181 deg"; give two or three.',
)
@at_option
@about_option
@limits_option
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
@certificate_option("Write what each cell is, which check_map.py of `gcrules checkers` recomputes without gcrules.")
@digits_option
@time_limit(None)
@tile_options(MAP_FORMATS)
def map_(
    file: str,
    mode: str | None,
    over: tuple[str, ...],
    at: str | None,
    about: str,
    limits: str | None,
    threshold: str,
    measure: str,
    certificate: str | None,
    digits: int | None,
    restart: bool,
    workers: int,
    part: str | None,
    scheduler: str | None,
    outputs: tuple[str, ...],
    out: Output,
) -> None:
    """Map the singular poses over two or three coordinates: curves or surfaces, with proof of what is free.

    \b
    gcrules map robot.yaml --over "x -200:200:201" --over "z -400:100:251" -o map.svg
    gcrules map robot.yaml --over "x -1:1:101" --over "y -1:1:101" --over "z 0:1:51" -o map.nc -o surface.glb
    gcrules map robot.yaml --over "rx -60:60:121 deg" --over "ry -60:60:121 deg" --at "0 0 50" --limits "legs 1..3"
    gcrules map delta --over "x -0.8:0.8:81" --over "y -0.8:0.8:81" --at "z=0.2" -o map.svg

    The coordinates are x, y, z (translation), roll, pitch, yaw, rx, ry, rz (rotation vector), zyx1, zyx2, zyx3 or
    another sequence of Euler angles, or azimuth, tilt, torsion; angles end with deg or rad. A robot of joints is mapped
    over x, y, z, roll, pitch, yaw or over its actuators q1, q2 …, from home; --at names what the others are. "-" reads
    the robot's file from standard input; the id of a robot, as of "gcrules robot list", does as well.

    A long run is computed in tiles and may be interrupted: with -o map.nc they are kept in map.nc.part, with -o
    map.zarr they are the answer, and the same command goes on from there. There are, too:

    \b
    gcrules map boxes ROBOT --over RANGE...     whole ranges of one to six coordinates, proved box by box
    gcrules map refine STORE -o FILE.zarr       such a map once more, finer or wider
    gcrules map status STORE                    how far they are, from another terminal
    gcrules map verify STORE [--tiles N|all]    all digests, and some tiles computed again
    gcrules map merge STORE... -o FILE.zarr     parts that were computed on disks of their own
    """
    if digits is not None and out.json:
        raise click.UsageError("--digits is for the summary; --json is exact.")
    check_outputs(outputs, len(over))
    how = running(workers, part, scheduler)
    if not outputs and (restart or how != HERE):
        option = "--restart" if restart else "--workers, --part or --scheduler"
        raise InputError(f"{option} without -o", hint="tiles are kept only where -o names a file")
    plan = planned(mechanism(warn(read_source(file, mode=mode)), about=about), over, at, limits, threshold, measure)
    if certificate is not None:
        check_cells(plan.task)
        check_whole(how)
    work = _work(plan, outputs, how)
    if work is not None:
        needed = bytes_of(plan.task) * (1 + any(o.lower().endswith(".nc") for o in outputs))
        check_room(work, needed, "use a coarser grid, or --measure value, which needs less")
    with telling_what_is_kept(work), working("computing"):
        if how.part is not None:
            out.show(map_part(plan, how, work=work, restart=restart))
            return
        found = done(plan, how, work=work, restart=restart)
        _save(found, outputs)
        if certificate is not None:
            found.save_certificate(certificate)
    show(found, out, digits=digits)
    if work not in outputs:
        after_writing(found.store.remove)


def _work(plan: Plan, outputs: tuple[str, ...], how: Running) -> str | None:
    """The store of the tiles: an output that is one, else beside an output, or none for a map of one tile."""
    kept = next((o for o in outputs if o.lower().endswith(".zarr")), None)
    if kept is not None or not outputs:
        return kept
    name = f"{next((o for o in outputs if o.lower().endswith('.nc')), outputs[0])}.part"
    small = plan.task.number == 1 or (not has_zarr() and plan.task.grid.size <= MAX_HELD)
    return None if small and how == HERE and not os.path.isdir(name) else name


def _save(found: Any, outputs: tuple[str, ...]) -> None:
    for path in outputs:
        report(f"writing {path}")
        found.save(path)
