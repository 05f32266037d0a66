"""What gcrules map does beside maps over nodes: boxes, refine, and with stores of tiles status, verify, merge."""

from __future__ import annotations

from typing import Any

import click

from gcrules.apps.cli.base import ExpressionCommand, seeded
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.map_boxes import boxes_, refine
from gcrules.apps.cli.output import Output, json_option, output_options
from gcrules.core.errors import InputError
from gcrules.poses.stored_maps.verifying import ALL, verify_map
from gcrules.poses.tiles.merging import merge_maps
from gcrules.poses.tiles.status import map_status

__all__ = ["MAP_COMMANDS", "MapCommand"]

_NOT_COMPLETE = 3


class _Tiles(click.ParamType):  # type: ignore[type-arg, unused-ignore]
    """A number of tiles, or all."""

    name = "tiles"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int | str:
        if value == ALL or isinstance(value, int):
            return str(value) if value == ALL else int(value)
        if not (value.isascii() and value.isdecimal()):
            self.fail(f"{value!r} is not a number of tiles; 0 or more, or all.", param, ctx)
        return int(value)


@click.command("status", cls=ExpressionCommand)
@click.argument("store", metavar="STORE")
@output_options(latex=False)
def status(store: str, out: Output) -> None:
    """How many tiles of a map are done, at what rate, and the time left; also while others compute them.

    \b
    gcrules map status map.zarr
    gcrules map status map.nc.part
    """
    out.show(map_status(store))


@click.command("verify", cls=ExpressionCommand)
@click.argument("store", metavar="STORE")
@click.option(
    "--tiles",
    type=_Tiles(),
    default=3,
    show_default=True,
    metavar="N|all",
    help="Compute this many tiles again, chosen unpredictably.",
)
@time_limit(None)
@output_options(latex=False)
@click.pass_context
def verify(ctx: click.Context, store: str, tiles: int | str, out: Output) -> None:
    """Look at the digests of all tiles of a store, and compute some of them again. Exit code 1 where a tile is bad.

    \b
    gcrules map verify map.zarr
    gcrules map verify map.zarr --tiles all
    """
    with working("verifying"):
        found = verify_map(store, tiles)
    out.show(found)
    if not found.sound:
        ctx.exit(1)
    if not found.complete:
        ctx.exit(_NOT_COMPLETE)


@click.command("merge", cls=ExpressionCommand)
@click.argument("stores", nargs=-1, required=True, metavar="STORE...")
@click.option("-o", "--output", "merged", type=OutputFile(), required=True, metavar="FILE.zarr", help="The new store.")
@time_limit(None)
@json_option
def merge(stores: tuple[str, ...], merged: str, as_json: bool) -> None:
    """Put the tiles of several stores of one map, which were computed on disks of their own, into a new store.

    \b
    gcrules map merge a.zarr b.zarr -o map.zarr
    """
    if not merged.lower().endswith(".zarr"):
        raise InputError(f"{merged}: not a name for a store", hint="stores end in .zarr")
    with working("merging"):
        found = merge_maps(stores, merged)
    Output(json=as_json).show(found)


MAP_COMMANDS = {"boxes": boxes_, "refine": refine, "status": status, "verify": seeded(verify), "merge": merge}
"""Commands of gcrules map, by the word that follows it."""


class MapCommand(ExpressionCommand):
    """A command that is another one where its first word is the name of one of `MAP_COMMANDS`."""

    def make_context(
        self, info_name: str | None, args: list[str], parent: click.Context | None = None, **extra: Any
    ) -> click.Context:
        other = MAP_COMMANDS.get(args[0]) if args else None
        if other is not None:
            return other.make_context(f"{info_name} {args[0]}", args[1:], parent, **extra)
        return super().make_context(info_name, args, parent, **extra)
