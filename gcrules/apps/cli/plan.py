"""The command plan: a way from one pose to another without a singularity."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, certificate_option, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.core.files import write_file
from gcrules.core.streams import is_stdout
from gcrules.poses.plans.plan import STATES
from gcrules.poses.plans.plan import plan as planned
from gcrules.views.drawing.drawing_files import save

__all__ = ["plan"]

_CODES = {"way": 0, "none": 1, "undecided": 3}


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option("--from", "start", required=True, metavar="POSE", help="The pose to start from, as in gcrules path.")
@click.option("--to", "goal", metavar="POSE", help="The pose to go to; without one the way out, to a larger margin.")
@click.option("--margin", type=float, metavar="SIGMA", help="The least margin on the way; by default a regular one.")
@click.option(
    "--limits",
    metavar="RANGES",
    help='Of legs or actuators: "leg lengths 1..3", "q1 -30..30 deg"; "none" ignores those of the file.',
)
@click.option("--within", metavar="RANGES", help='Of coordinates from home: "z -100..50, turn ..40 deg".')
@about_option
@click.option("--states", default=STATES, show_default=True, metavar="N", help="Give up after this many states.")
@click.option("--seed", default=0, show_default=True, metavar="N", help="Another seed draws other poses.")
@click.option("--csv", "table", type=OutputFile(alone=True), metavar="FILE.csv", help="Write the poses of the way.")
@click.option(
    "--plot",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the margin along the way, if there is one.",
)
@certificate_option(
    "Where there is no way, write the poses and the signs, which check_plan.py of `gcrules checkers` computes again"
    " without gcrules."
)
@time_limit()
@output_options()
def plan(
    file: str,
    mode: str | None,
    start: str,
    goal: str | None,
    margin: float | None,
    limits: str | None,
    within: str | None,
    about: str,
    states: int,
    seed: int,
    table: str | None,
    plot: str | None,
    certificate: str | None,
    out: Output,
) -> None:
    """Find a way from one pose to another without a singularity, or prove that there is none.

    \b
    gcrules plan robot.yaml --from home --to "0 0 -300; rotvec 0 0 60 deg"
    gcrules plan 3-rps --from home --to "z=0.2, roll=20deg, pitch=10deg" --margin 0.2 --plot way.svg
    gcrules plan robot.yaml --from home --to "50 0 10" --limits "leg lengths 300..700" --csv way.csv
    gcrules plan robot.yaml --from "0 0 -349" --margin 0.1

    Poses are drawn at random and joined by straight ways; the way that is found is made shorter and is proved as by
    gcrules path. There is none, proved, where a factor of the condition has opposite signs in both poses. Without --to
    the way leads to the nearest pose with the margin that is found. Exit code 0: a way, 1: there is none, 3: not
    decided. "-" reads the file from standard input.
    """
    loaded = warn(read_source(file, mode=mode))
    with working("searching"):
        found = planned(
            loaded,
            start,
            goal,
            margin=margin,
            limits=limits,
            within=within,
            states=states,
            seed=seed,
            about=about,
        )
    code = _CODES[found.outcome]
    if table is not None and code == 0:
        write_file(table, found.csv())
    if plot is not None and found.path is not None:
        save(found.plot(), plot)
    if table is None or out.path is not None or not is_stdout(table) or code:
        out.show(found)
    if certificate is not None and found.outcome == "none":
        found.save_certificate(certificate)
    elif certificate is not None:
        click.echo(f"note: {certificate} is not written, since it is not proved that there is no way", err=True)
    click.get_current_context().exit(code)
