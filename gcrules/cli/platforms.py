"""Reading the platform that a command is given."""

from __future__ import annotations

import click

from gcrules.cli.files import read_stdin
from gcrules.robots.geometry import Platform, load_platform, parse_platform

__all__ = ["read_platform"]


def read_platform(file: str) -> Platform:
    """The platform of a geometry file, or of standard input for "-"; its warnings go to standard error."""
    platform = parse_platform(read_stdin(), "<stdin>") if file == "-" else load_platform(file)
    for warning in platform.warnings:
        click.echo(f"warning: {warning}", err=True)
    return platform
