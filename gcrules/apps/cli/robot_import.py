"""`gcrules robot import`: a robot file from a model of links and joints."""

from __future__ import annotations

import json

import click

from gcrules.apps.cli.files import OutputCommand, OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.output import Output
from gcrules.core.deferred import deferred
from gcrules.core.files import write_file

__all__ = ["import_"]

_import_file = deferred("gcrules.mechanisms.models.importing:import_file")  # loads numpy


@click.command("import", cls=OutputCommand, short_help="Write a robot file from a model: URDF, SDF, MJCF.")
@click.argument("model", metavar="MODEL")
@click.option("--closures", metavar="FILE", help="Beside a model in URDF: how its loops are closed, what is driven.")
@click.option(
    "--platform", metavar="LINK", help="The link that is the platform; by default the one with the most limbs."
)
@click.option("--base", metavar="LINK", help="The link that the limbs start from; by default the model's base.")
@click.option(
    "--actuators", metavar="a,b,…", default="", help="The joints that are driven; by default as in the model."
)
@click.option(
    "--tolerance",
    type=float,
    default=1e-4,
    show_default=True,
    metavar="T",
    help="How far axes and centres are moved to make them exact: parts of the model's size, and radians.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.option("-o", "--output", "path", type=OutputFile(), metavar="FILE", help="Write to a file.")
@time_limit()
def import_(
    model: str,
    closures: str | None,
    platform: str | None,
    base: str | None,
    actuators: str,
    tolerance: float,
    as_json: bool,
    path: str | None,
) -> None:
    """Read a robot as its maker ships it, and write it as a robot file.

    \b
    gcrules robot import robot.xml -o robot.yaml
    gcrules robot import robot.urdf --closures loops.yaml --platform plate -o robot.yaml

    What was read, merged and moved is told beside it; without -o the file is printed.
    """
    with working("importing"):
        found = _import_file(
            model,
            closures,
            base=base,
            platform=platform,
            actuators=[name for word in actuators.split(",") if (name := word.strip())],
            tolerance=tolerance,
        )
    if path is not None or not as_json:
        write_file(path or "-", found.yaml)
    if as_json:
        click.echo(json.dumps(found.to_json(), indent=2))
        return
    printed = path in (None, "-")
    click.echo(found.text(unicode=Output().unicode), err=printed)
    if not printed:
        click.echo(f"{path} is written; check it with: gcrules robot check {path}")
