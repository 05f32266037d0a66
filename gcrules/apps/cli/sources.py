"""What a command is given: words that `gcrules.load` reads, or standard input."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import click

from gcrules.apps.cli.files import read_stdin
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.load import Loaded, is_path, load

__all__ = ["read_source", "warn"]


def read_source(words: str | Sequence[str], **options: Any) -> Loaded:
    """What the words say, several of them being legs; "-" is standard input. `options` are those of `load`. Raises
    InputError for a file among legs.
    """
    if isinstance(words, str):
        words = (words,)
    if len(words) > 1 and any(word == "-" or is_path(word) for word in words):
        raise InputError("expected one geometry file, or legs", hint="give one file at a time")
    return load(" ".join(words), stdin=read_stdin, **options)


def warn(loaded: Loaded) -> Loaded:
    """Warnings of a geometry file go to standard error."""
    for warning in loaded.warnings if isinstance(loaded, Platform) else ():
        click.echo(f"warning: {warning}", err=True)
    return loaded
