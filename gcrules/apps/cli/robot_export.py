"""`gcrules robot export`: write a robot as a model file."""

from __future__ import annotations

import os

import click

from gcrules.apps.cli.files import OutputCommand, OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import completing
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.files import write_file
from gcrules.screws.pose import UNITS

__all__ = ["export"]

_model_text = deferred("gcrules.views.models.model_text:model_text")  # loads numpy

_ENDINGS = {".xml": "mjcf", ".mjcf": "mjcf", ".urdf": "urdf"}


@click.command(cls=OutputCommand, short_help="Write a robot as a model file: MJCF, or URDF.")
@click.argument("source", metavar="ID|FILE", shell_complete=completing("robot"))
@click.option(
    "--format", "form", type=click.Choice(["mjcf", "urdf"]), help="By default that of the FILE's name, or mjcf."
)
@mode_option
@click.option(
    "--unit",
    type=click.Choice(UNITS),
    help="Of the file's lengths; by default m, where it names none.",
)
@click.option("-o", "--output", "path", type=OutputFile(), metavar="FILE", help="Write to a file.")
@time_limit()
def export(source: str, form: str | None, mode: str | None, unit: str | None, path: str | None) -> None:
    """Write a robot with dimensions as a model of links and joints, for MuJoCo (MJCF) or as URDF.

    \b
    gcrules robot export delta -o delta.xml
    gcrules robot export robot.yaml --unit mm --format urdf -o robot.urdf

    A model in URDF is a tree: a second file, robot-closures.yaml beside robot.urdf, closes its loops.
    """
    stem, suffix = os.path.splitext(path or "")
    named = _ENDINGS.get(suffix.lower())
    if form and named and named != form:
        raise click.UsageError(f"{path} is a name for {named}, and --format is {form}.")
    if path not in (None, "-") and (form or named) is None:
        raise InputError(
            f"{path}: not a name for a model file", hint=f"names of model files end in {', '.join(_ENDINGS)}"
        )
    form = form or named or "mjcf"
    if form == "urdf" and path in (None, "-"):
        raise click.UsageError("A model in URDF takes two files: give -o FILE.urdf.")
    loaded = warn(read_source(source, mode=mode))
    with working("computing"):
        text = _model_text(loaded, form, unit=unit or "")
        closures = _model_text(loaded, "closures", unit=unit or "") if form == "urdf" else ""
    if path is None:
        click.echo(text, nl=False)
        return
    write_file(path, text)
    if closures:
        write_file(f"{stem}-closures.yaml", closures)
        click.echo(f"{path} and {stem}-closures.yaml are written")
    elif path != "-":
        click.echo(f"{path} is written")
