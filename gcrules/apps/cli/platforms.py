"""Reading the platform or the robot that a command is given: a file, an id, or standard input."""

from __future__ import annotations

import re
from pathlib import Path

import click

from gcrules.apps.cli.files import read_stdin
from gcrules.core.errors import FileError, InputError
from gcrules.core.yaml_file import Document
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.platform_file import Platform, load_platform, parse_platform
from gcrules.mechanisms.description.robot_file import describes_joints
from gcrules.mechanisms.robot import Robot

__all__ = ["centre", "read_either", "read_platform"]


def read_platform(file: str, about: str | None) -> tuple[Platform, str]:
    """What `read_either` finds as a platform, and what it turns about unless `about` says it (see `centre`).

    Raises InputError for robots whose limbs are no six legs.
    """
    read = read_either(file)
    if isinstance(read, Robot):
        return as_platform(read), centre(read, about)
    return read, centre(read, about)


def centre(read: Platform | Robot, about: str | None) -> str:
    """What is turned about: `about`, else the origin of geometry files, the centroid of robots described by joints."""
    return about or ("centroid" if isinstance(read, Robot) else "origin")


def read_either(file: str) -> Platform | Robot:
    """A platform with its dimensions, or a robot described by its joints (told by its keys, or by its id); "-" is
    standard input. Warnings of geometry files go to standard error.
    """
    if file == "-":
        text = read_stdin()
        if describes_joints(Document.parse(text, "<stdin>")):
            return Robot.parse(text, "<stdin>")
        return _warned(parse_platform(text, "<stdin>"))
    path = Path(file)
    if re.search(r"[\s,]", file) and not path.exists():
        raise _without_coordinates(file)
    if not path.suffix and len(path.parts) == 1 and not path.exists():
        return Robot.load(file)
    try:
        robot = describes_joints(Document.load(file))
    except FileError:  # said again, and better, by the reader of platforms
        robot = False
    return Robot.load(file) if robot else _warned(load_platform(file))


def _without_coordinates(legs: str) -> InputError:
    """The fault of legs, or other words, where joints need places."""
    return InputError(
        f"{legs[:60]!r} names no file and no robot; legs alone have no coordinates",
        hint='give a geometry file, legs and coordinates as in examples/octahedral.yaml; `gcrules studio "LEGS"` writes'
        ' one under "Take away". Without coordinates `gcrules analyze "LEGS"` gives the condition',
    )


def _warned(platform: Platform) -> Platform:
    for warning in platform.warnings:
        click.echo(f"warning: {warning}", err=True)
    return platform
