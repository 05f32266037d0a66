"""What a command is given: words that `gcrules.load` reads, or standard input; and the mode of a robot."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import click

from gcrules.apps.cli.files import read_stdin
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.load import Loaded, is_path, load, read_robot, read_text
from gcrules.mechanisms.robot import Robot

__all__ = ["in_mode", "mode_option", "read_source", "robot_named", "warn"]

_in_mode = deferred("gcrules.poses.modes.choose:in_mode")  # numpy

mode_option = click.option(
    "--mode",
    metavar="MODE",
    help='Use the robot in this mode: "+-+" (gcrules modes --working), "assembly 3" (gcrules modes) or "operation 2"'
    " (gcrules modes --operation).",
)


def read_source(words: str | Sequence[str], *, mode: str | None = None, **options: Any) -> Loaded:
    """What the words say, several of them being legs; "-" is standard input. `mode` is that of a robot or platform,
    `options` are those of `load`. Raises InputError for a file among legs, and for modes that there are not.
    """
    if isinstance(words, str):
        words = (words,)
    if len(words) > 1 and any(word == "-" or is_path(word) for word in words):
        raise InputError("expected one geometry file, or legs", hint="give one file at a time")
    return in_mode(load(" ".join(words), stdin=read_stdin, **options), mode)


def robot_named(name: str, folders: Sequence[str] = ()) -> Robot:
    """The robot of this id or file; "-" is standard input. Raises InputError for a geometry file there."""
    if name != "-":
        return read_robot(name, folders)
    found = read_text(read_stdin(), "<stdin>")
    if isinstance(found, Robot):
        return found
    raise InputError("<stdin> is a geometry file, and describes no joints", hint="`gcrules analyze -` takes it")


def in_mode(loaded: Loaded, mode: str | None) -> Loaded:
    """What was loaded, with its home in the mode that --mode names. Raises InputError for modes that there are not."""
    found: Loaded = loaded if mode is None else _in_mode(loaded, mode)
    return found


def warn(loaded: Loaded) -> Loaded:
    """Warnings of a geometry file go to standard error."""
    for warning in loaded.warnings if isinstance(loaded, Platform) else ():
        click.echo(f"warning: {warning}", err=True)
    return loaded
