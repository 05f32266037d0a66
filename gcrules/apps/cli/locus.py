"""The command locus: the singular poses of a robot as the zeros of a polynomial."""

from __future__ import annotations

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument, offering
from gcrules.apps.cli.options import about_option, digits_option, limit_option
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.loci.factors import MAX_TERMS
from gcrules.poses.loci.form import FORMATS
from gcrules.poses.loci.locus import locus as computed
from gcrules.poses.loci.variables import ROTATIONS, TANGENTS, TRANSLATION
from gcrules.views.drawing.drawing_files import save

__all__ = ["locus"]

_VARIABLES = (
    "translation",
    "rotation",
    "all",
    *TRANSLATION,
    *(n for names in ROTATIONS.values() for n in names),
    *TANGENTS,
)


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option(
    "--over",
    metavar="VARIABLES",
    shell_complete=offering(*_VARIABLES, several=True),
    help="The free variables: x,y,e3, or translation, rotation, all.",
)
@click.option("--fix", metavar="VALUES", help='Values of variables, "x=0, e1=1/2"; without --over the others are free.')
@click.option("--at", metavar="POSE", help="Where the variables that are neither free nor fixed come from.")
@click.option(
    "--rotation",
    default="quaternion",
    show_default=True,
    metavar="KIND",
    shell_complete=offering(*ROTATIONS, "zyx", "xyz"),
    help="quaternion (e0 to e3), rodrigues (c1 to c3), or a sequence zyx: tangents of half the angles (t1 to t3).",
)
@click.option(
    "--product/--roots",
    default=None,
    help="Multiply over all working modes of a robot of joints, or keep the roots that distinguish them; by default"
    " products that may be long are left out.",
)
@about_option
@click.option(
    "--export",
    metavar="|".join(FORMATS),
    shell_complete=offering(*FORMATS),
    help="Print the polynomial alone, for that program.",
)
@digits_option
@click.option(
    "--picture",
    type=OutputFile(".svg", ".pdf"),
    metavar="FILE.svg|FILE.pdf",
    help="Draw the zeros over one variable, or the curves over two.",
)
@limit_option(MAX_TERMS, "Search for factors of polynomials with up to this many terms, where no proof decides.")
@time_limit()
@output_options()
def locus(
    file: str,
    mode: str | None,
    over: str | None,
    fix: str | None,
    at: str | None,
    rotation: str,
    product: bool | None,
    about: str,
    export: str | None,
    digits: int | None,
    picture: str | None,
    limit: int,
    out: Output,
) -> None:
    """Compute the polynomial whose zeros are the singular poses, exactly, with its degrees and factors.

    \b
    gcrules locus robot.yaml
    gcrules locus 3-rpr --over x,y --at "yaw=90deg"
    gcrules locus robot.yaml --over translation --at "0 0 0; euler zyx 90 0 0 deg"
    gcrules locus robot.yaml --fix "e1=0, e2=0" --json
    gcrules locus robot.yaml --over x,z --picture locus.svg
    gcrules locus robot.yaml --rotation rodrigues --export maple -o locus.mpl

    The variables are x, y, z (the translation in the file's unit) and those of the rotation. "-" reads the file from
    standard input; the id of a robot, as of "gcrules robot list", does as well. For robots of joints that are not six
    legs there is a polynomial for each factor of the condition; their variables are x, y, z and t_roll, t_pitch, t_yaw,
    tangents of half the angles, and --at names coordinates, "z=1/2, yaw=30deg". It is multiplied over all working
    modes, or the roots that tell these apart are variables too.
    """
    if export is not None and (out.json or out.latex):
        raise click.UsageError("--export excludes --json and --latex.")
    if digits is not None and (export is not None or out.json or out.latex):
        raise click.UsageError("--digits is for the summary; --export, --json and --latex are exact.")
    loaded = warn(read_source(file, mode=mode))
    with working("computing"):
        found = computed(loaded, over, fix=fix, at=at, rotation=rotation, about=about, limit=limit, product=product)
        text = found.text(unicode=out.unicode, digits=digits) if export is None else found.written(export)
    if picture is not None:
        save(found.picture(), picture)
    out.show(found, text)
