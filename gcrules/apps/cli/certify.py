"""The command certify: whether a robot is free of singularities in its whole range."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import files_option, working
from gcrules.apps.cli.limits import Seconds
from gcrules.apps.cli.map_options import at_option, limits_option
from gcrules.apps.cli.naming import mechanism_argument, offering
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.question_options import cone_option, tilt_option
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.certificates.certificate import PICTURES, check_suffix
from gcrules.poses.certificates.certify import certify as certified
from gcrules.screws.pose_text import COORDINATES
from gcrules.views.plots.map_formats import need

__all__ = ["certify"]

_CODES = {True: 0, False: 1, None: 3}


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option(
    "--over",
    multiple=True,
    required=True,
    metavar="RANGE",
    shell_complete=offering(*COORDINATES),
    help='A coordinate and its range, "x -20..20" or "roll -40..40 deg"; one to six times.',
)
@at_option
@about_option
@limits_option
@cone_option
@tilt_option
@click.option("--margin", type=float, default=0.0, metavar="M", help="Poses have at least this margin σ.")
@click.option("--time", type=Seconds(), metavar="S", help="Seconds to search for; 60 if no boxes are given.")
@click.option("--boxes", type=int, metavar="N", help="Cut the range into at most this many boxes.")
@click.option(
    "--target", default="100%", show_default=True, metavar="SHARE", help='Stop when this much is decided: "99.9%".'
)
@click.option("--resume", metavar="FILE", help="Go on from the file of an earlier certificate of the same question.")
@output_options(file=False)
@files_option(
    "Write the certificate, whatever is decided: .json or .json.gz, which check_certificate.py of `gcrules checkers`"
    " checks; or a picture of it: .svg, .pdf, .png."
)
@click.pass_context
def certify(
    ctx: click.Context,
    file: str,
    mode: str | None,
    over: tuple[str, ...],
    at: str | None,
    about: str,
    limits: str | None,
    cone: str | None,
    tilt: str | None,
    margin: float,
    time: float | None,
    boxes: int | None,
    target: str,
    resume: str | None,
    outputs: tuple[str, ...],
    out: Output,
) -> None:
    """Prove that a robot has no singular pose in its whole range, or find one.

    \b
    gcrules certify robot.yaml --over "x -100..100" --over "y -100..100" --limits "leg lengths 200..500"
    gcrules certify reachy-mini-head --over "roll -40..40 deg" --over "pitch -40..40 deg" --over "yaw -65..65 deg" \\
      --limits "actuators -84..44 deg" --cone "40 deg" -o head.json

    The range is continuous: boxes of poses are proved or cut. The exit code is 0 where no pose in range is singular, 1
    where one is, 3 where it is not decided; with --target also 0 where so much is.
    """
    for path in outputs:
        if check_suffix(path) in PICTURES:
            need("matplotlib", "pictures need matplotlib")
    source = warn(read_source(file, mode=mode))
    with working("proving"):
        found = certified(
            source,
            list(over),
            at,
            about=about,
            limits=limits,
            cone=cone,
            tilt=tilt,
            margin=margin,
            time=time,
            boxes=boxes,
            target=target,
            resume=resume,
        )
    for path in outputs:
        found.save(path)
    out.show(found)
    ctx.exit(_CODES[found.holds])
