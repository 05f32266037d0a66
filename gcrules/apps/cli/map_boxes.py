"""The commands map boxes and map refine: whole boxes of poses over up to six coordinates."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, certificate_option, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.map_options import (
    at_option,
    check_whole,
    limits_option,
    scheduler_option,
    show,
    telling_what_is_kept,
    tile_options,
    workers_option,
)
from gcrules.apps.cli.naming import mechanism_argument, offering
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.core.errors import InputError
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.box_map import box_part, boxes_done
from gcrules.poses.boxes.certificate import check_boxes
from gcrules.poses.boxes.task import box_task
from gcrules.poses.stored_maps.refining import refine_map
from gcrules.poses.tiles.how import HERE, running
from gcrules.screws.pose_text import COORDINATES
from gcrules.views.plots.box_files import BOX_FORMATS
from gcrules.views.plots.map_formats import check_files

__all__ = ["boxes_", "refine"]


@click.command("boxes", cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option(
    "--over",
    multiple=True,
    required=True,
    metavar="RANGE",
    shell_complete=offering(*COORDINATES),
    help='A coordinate with start:stop, "x -200:200" or "roll -20:20 deg"; give one to six.',
)
@at_option
@about_option
@limits_option
@click.option("--margin", type=float, default=0.0, metavar="M", help="Free poses have at least this margin σ.")
@click.option(
    "--tiles",
    type=int,
    metavar="N",
    help="Cut each range into this many tiles; by default 64, 16, 8, 5, 3 or 3, by the number of ranges.",
)
@click.option("--boxes", type=int, metavar="N", help="Cut each tile into at most this many boxes; 4095 by default.")
@certificate_option("Write all boxes, which check_boxes.py of `gcrules checkers` proves again without gcrules.")
@time_limit(None)
@tile_options(BOX_FORMATS)
def boxes_(
    file: str,
    mode: str | None,
    over: tuple[str, ...],
    at: str | None,
    about: str,
    limits: str | None,
    margin: float,
    tiles: int | None,
    boxes: int | None,
    certificate: str | None,
    restart: bool,
    workers: int,
    part: str | None,
    scheduler: str | None,
    outputs: tuple[str, ...],
    out: Output,
) -> None:
    """Prove which poses over whole ranges of one to six coordinates are free of singular ones, box by box.

    \b
    gcrules map boxes robot.yaml --over "x -100:100" --over "y -100:100" --over "z -50:50" --limits "legs 200..500"
    gcrules map boxes 6-rus --over "x -0.2:0.2" --over "roll -20:20 deg" --over "pitch -20:20 deg" -o boxes.svg

    The coordinates are x, y, z, roll, pitch, yaw, of a robot of joints from home. Boxes that are not decided are
    halved. With -o FILE.zarr the tiles are kept as they are done, and the same command goes on from there; --workers,
    --part, --scheduler and "gcrules map status", verify and merge are as for maps over nodes. The exit code is 0
    whatever is decided.
    """
    check_files(outputs, BOX_FORMATS)
    how = running(workers, part, scheduler)
    work = next((o for o in outputs if o.lower().endswith(".zarr")), None)
    if work is None and (restart or how != HERE):
        raise InputError("tiles are kept only where -o names a store", hint="-o range.zarr")
    robot = mechanism(warn(read_source(file, mode=mode)), about=about)
    task = box_task(robot, over, at, limits, margin, tiles, boxes)
    if certificate is not None:
        task.check()
        check_boxes(task)
        check_whole(how)
    with telling_what_is_kept(work), working("computing"):
        if how.part is not None:
            out.show(box_part(task, how, work=work, restart=restart))
            return
        found = boxes_done(task, how, work=work, restart=restart)
        for path in outputs:
            found.save(path)
        if certificate is not None:
            found.save_certificate(certificate)
    show(found, out)


@click.command("refine", cls=ExpressionCommand)
@click.argument("store", metavar="STORE")
@click.option("-o", "--output", "refined", type=OutputFile(), required=True, metavar="FILE.zarr", help="The new store.")
@click.option(
    "--boxes",
    type=int,
    metavar="N",
    help="At most this many boxes in each tile; by default four times as many as before.",
)
@click.option(
    "--over", multiple=True, metavar="RANGE", help="Another range, of whole tiles of the store, without a number."
)
@time_limit(None)
@workers_option
@scheduler_option
@output_options(latex=False, file=False)
def refine(
    store: str,
    refined: str,
    boxes: int | None,
    over: tuple[str, ...],
    workers: int,
    scheduler: str | None,
    out: Output,
) -> None:
    """A map once more: finer where it is undecided, or over wider ranges. What is done is taken over.

    \b
    gcrules map refine range.zarr -o finer.zarr
    gcrules map refine range.zarr -o wider.zarr --over "x -200:200"

    Maps of whole boxes are made finer, and wider in each coordinate. Maps over nodes of platforms on six legs are made
    wider in their first coordinate, with nodes as far apart as before.
    """
    if not refined.lower().endswith(".zarr"):
        raise InputError(f"{refined}: not a name for a store", hint="stores end in .zarr")
    check_files([refined], BOX_FORMATS)
    with working("computing"):
        found = refine_map(store, refined, boxes, over or None, workers=workers, scheduler=scheduler)
    out.show(found)
