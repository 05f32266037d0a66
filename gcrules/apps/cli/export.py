"""The command export: the condition as source code for a controller."""

from __future__ import annotations

import os

import click

from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import mechanism_argument
from gcrules.apps.cli.options import about_option
from gcrules.apps.cli.output import Output
from gcrules.apps.cli.sources import mode_option, read_source, warn
from gcrules.poses.compiling.controller import controller
from gcrules.views.code.languages import LANGUAGES
from gcrules.views.code.source_code import source_code

__all__ = ["export"]

_SUFFIXES = {language.suffix: name for name, language in LANGUAGES.items()}


@click.command(cls=ExpressionCommand)
@mechanism_argument
@mode_option
@click.option("--language", type=click.Choice(list(LANGUAGES)), help="By default that of the FILE's name, or c.")
@click.option(
    "--coordinates", metavar="NAMES", help='Those of the pose, "z, roll, pitch"; by default those that are free.'
)
@about_option
@click.option("-o", "--output", "path", type=OutputFile(), metavar="FILE", help="Write to a file.")
@time_limit()
def export(
    file: str, mode: str | None, language: str | None, coordinates: str | None, about: str, path: str | None
) -> None:
    """Write the condition's factors, the margin and the inverse kinematics as source code that needs nothing else.

    \b
    gcrules export delta -o delta.c
    gcrules export robot.yaml --language rust

    The file has functions of the coordinates of a pose, and a test: numbers at some poses that were computed without
    them. "-" reads the file from standard input.
    """
    suffix = os.path.splitext(path or "")[1].lower()
    named = _SUFFIXES.get(suffix)
    if language and named and named != language:
        raise click.UsageError(f"{path} is a name for {LANGUAGES[named].title}, and --language is {language}.")
    loaded = warn(read_source(file, mode=mode))
    with working("computing"):
        text = source_code(controller(loaded, coordinates=coordinates, about=about), language or named or "c")
    out = Output(path=path)
    out.write(text)
    out.deliver(0)
