"""The command aspects: which poses of a robot are connected without a singularity."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.aspects.aspects import POSES, STATES
from gcrules.poses.aspects.aspects import aspects as found_aspects
from gcrules.views.drawing.drawing_files import save

__all__ = ["aspects"]


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option("--margin", type=float, metavar="SIGMA", help="The least margin on all ways; by default a regular one.")
@click.option(
    "--limits",
    metavar="RANGES",
    help='Of legs or actuators: "leg lengths 1..3", "q1 -30..30 deg"; "none" ignores those of the file.',
)
@click.option("--within", metavar="RANGES", help='Of coordinates from home: "z -100..50, turn ..40 deg".')
@click.option("--poses", default=POSES, show_default=True, metavar="N", help="Look at this many random poses.")
@click.option("--modes/--no-modes", default=True, show_default=True, help="Look at the assembly modes as well.")
@about_option
@click.option("--states", default=STATES, show_default=True, metavar="N", help="Give up after this many states.")
@click.option("--seed", default=0, show_default=True, metavar="N", help="Another seed draws other poses.")
@click.option(
    "--picture",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the poses over two coordinates, with the proved ways between them.",
)
@time_limit()
@output_options()
def aspects(
    file: str,
    mode: str | None,
    margin: float | None,
    limits: str | None,
    within: str | None,
    poses: int,
    modes: bool,
    about: str,
    states: int,
    seed: int,
    picture: str | None,
    out: Output,
) -> None:
    """Find in how many parts without singularities (aspects) a robot's poses lie, and which assembly modes share one.

    \b
    gcrules aspects robot.yaml --picture aspects.svg
    gcrules aspects 3-rpr --within "x -1..1, y -1..1, yaw -180..180 deg"
    gcrules aspects 3-rps --limits "actuators -0.5..0.5" --no-modes

    Poses with different signs of the condition's factors are in different aspects; poses with equal signs are joined by
    ways, each proved as by gcrules path. Exit code 0: it is known in how many aspects the poses lie, 3: not decided.
    "-" reads the file from standard input.
    """
    loaded = warn(read_source(file, mode=mode))
    with working("searching"):
        found = found_aspects(
            loaded,
            margin=margin,
            limits=limits,
            within=within,
            poses=poses,
            modes=modes,
            states=states,
            seed=seed,
            about=about,
        )
    if picture is not None:
        save(found.picture(), picture)
    out.show(found)
    click.get_current_context().exit(0 if found.decided else 3)
