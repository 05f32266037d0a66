"""What a report also shows: a path, a map, a certificate, modes, aspects, a plan, a free region; the options that ask
for it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import decorated
from gcrules.poses.questions import SHAPES, Questions
from gcrules.screws.threshold import DEFAULT

__all__ = ["cone_option", "question_options", "tilt_option"]

cone_option = click.option(
    "--cone", metavar="ANGLES", help='Cones of joints of rods: "40 deg", "base 30 deg, C1 40 deg".'
)
tilt_option = click.option("--tilt", metavar="ANGLE", help='The platform tilts this far in any direction: "40 deg".')

_ASKED = ("over", "certify", "modes", "aspects", "plan", "free")
_NAMES = (*_ASKED, "at", "limits", "within", "cone", "tilt", "margin", "resume", "about", "threshold")


def question_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """The options of a path, a map, a certificate, modes, aspects, a plan and a free region; the command receives
    `questions`.
    """

    @wraps(command)
    def with_questions(**options: Any) -> Any:
        poses, table = options.pop("poses"), options.pop("table")
        if poses and table is not None:
            raise click.UsageError("Give the poses of the path either by --poses POSES.csv or by --path.")
        path = list(poses) if table is None else table
        asked = Questions(path=path or None, **{n: one for n in _NAMES if (one := options.pop(n)) != ()})
        asked.check()
        return command(questions=asked, **options)

    decorators = [
        click.option(
            "--path",
            "poses",
            multiple=True,
            metavar="POSE",
            help="Add a path through two poses or more, home among them.",
        ),
        click.option("--poses", "table", metavar="POSES.csv", help="Add the path of a table of poses."),
        click.option(
            "--over",
            multiple=True,
            metavar="RANGE",
            help='Add a map over two or three coordinates, "x -200:200:81"; without numbers, "x -200:200", of whole '
            "boxes over one to six.",
        ),
        click.option(
            "--certify",
            multiple=True,
            metavar="RANGE",
            help='Add a certificate over one to six ranges, "roll -40..40 deg".',
        ),
        click.option("--modes", is_flag=True, help="Add the assembly modes, of joints working and operation modes."),
        click.option("--aspects", is_flag=True, help="Add how the poses are connected without a singularity."),
        click.option(
            "--plan", multiple=True, metavar="POSE", help="Add a way from one pose to another; of one the way out."
        ),
        click.option(
            "--free",
            type=click.Choice(SHAPES),
            metavar="SHAPE",
            help=f"Add the largest region that is free of singularities, a {' or a '.join(SHAPES)}.",
        ),
        click.option(
            "--at",
            metavar="POSE",
            help="The pose of modes and free region, by default home; the rest of map and certificate.",
        ),
        click.option(
            "--limits",
            metavar="RANGES",
            help='What legs or actuators reach in map, certificate, aspects and plan: "legs 1..3".',
        ),
        click.option("--within", metavar="RANGES", help="Of coordinates in aspects and plan, from home."),
        click.option(
            "--margin",
            type=float,
            default=0.0,
            metavar="M",
            help="In whole boxes and the certificate free poses have at least this margin σ.",
        ),
        cone_option,
        tilt_option,
        click.option("--resume", metavar="FILE", help="The certificate goes on from its file."),
        about_option,
        click.option(
            "--threshold",
            default=DEFAULT.text,
            show_default=True,
            metavar="ANGLE",
            help="Closer than this is close, on the path, in a map over nodes and among the modes (deg, rad).",
        ),
    ]
    return decorated(with_questions, decorators)
