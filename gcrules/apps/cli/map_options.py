"""The options that maps over nodes and maps of whole boxes share: what is reached, and where tiles are computed."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import click

from gcrules.apps.cli.files import files_option
from gcrules.apps.cli.output import Output, decorated, output_options
from gcrules.core.errors import InputError
from gcrules.poses.tiles.how import MAX_WORKERS, Running

__all__ = [
    "at_option",
    "check_whole",
    "limits_option",
    "scheduler_option",
    "show",
    "telling_what_is_kept",
    "tile_options",
    "workers_option",
]

_Command = Callable[..., Any]

at_option = click.option(
    "--at", metavar="POSE", help="The pose of the other coordinates, as in gcrules pose; by default the file's own."
)
limits_option = click.option(
    "--limits",
    metavar="RANGES",
    help='What legs or actuators reach: "leg lengths 1..3", "ab 1..3, cd 2..", or for joints "q1 -30..30 deg"; "none"'
    " ignores those of the file.",
)
workers_option = click.option(
    "--workers",
    type=click.IntRange(0, MAX_WORKERS),
    default=0,
    show_default="in this process",
    metavar="N",
    help="Compute tiles in this many processes on this machine.",
)
scheduler_option = click.option(
    "--scheduler",
    metavar="ADDRESS",
    help='Compute tiles on a Dask cluster that shares the disk; "local" starts one on this machine.',
)


def tile_options(formats: Iterable[str]) -> Callable[[_Command], _Command]:
    """What becomes of tiles, and of the answer, which is written in these formats."""
    options = (
        click.option("--restart", is_flag=True, help="Throw away finished tiles of an earlier run and start over."),
        workers_option,
        click.option("--part", metavar="K/N", help="Compute only the K-th of N parts, as a job of an array."),
        scheduler_option,
        output_options(latex=False, file=False),
        files_option(f"Write a file, once or more often; its suffix says which kind: {' '.join(formats)}."),
    )
    return lambda command: decorated(command, options)


def check_whole(how: Running) -> None:
    """Raises InputError where a certificate is asked for, and only a part is computed."""
    if how.part is not None:
        raise InputError("--certificate is of a whole map", hint="leave --part out, when all parts are there")


@contextmanager
def telling_what_is_kept(work: str | None) -> Iterator[None]:
    """Where it is interrupted, say that what is done is kept in the store `work`."""
    try:
        yield
    except KeyboardInterrupt:
        if work is not None:
            click.echo(f"\ninterrupted; finished tiles are kept in {work}: run the same command again", err=True)
        raise


def show(found: Any, out: Output, **options: Any) -> None:
    """Print a map: on one line where it is a JSON object; the `options` are those of its text."""
    if out.json:
        click.echo(json.dumps(found.to_json()))
    else:
        out.show(found, found.text(unicode=out.unicode, **options))
