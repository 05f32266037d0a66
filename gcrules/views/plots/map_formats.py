"""Kinds of files of a map, by their suffixes: what writes them and what they need."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.files import check_target, replacing
from gcrules.poses.tiles.store import written

__all__ = ["MapFormat", "bytes_written", "check_files", "json_file", "need", "suffix", "write_files"]

Need = tuple[str, str]
"""A library, and what needs it, in words."""


@dataclass(frozen=True)
class MapFormat:
    """A kind of file: `write` makes a new file of this name. `needs` are libraries with what needs them, `in_space`
    those that maps over three coordinates need too; a `surface` is of such maps only. A `folder` is kept as it grows,
    and `write` takes its own name.
    """

    write: Callable[[Any, str], None]
    needs: tuple[Need, ...] = ()
    in_space: tuple[Need, ...] = ()
    surface: bool = False
    folder: bool = False


def bytes_written(made: Callable[[Any], bytes]) -> Callable[[Any, str], None]:
    """A file of the bytes that a function makes."""

    def write(m: Any, path: str) -> None:
        data = made(m)
        with open(path, "xb") as file:
            file.write(data)

    return write


def json_file() -> MapFormat:
    """The JSON object of a map."""
    return MapFormat(bytes_written(lambda m: (json.dumps(m.to_json(), indent=2) + "\n").encode()))


def check_files(paths: Sequence[str], formats: Mapping[str, MapFormat]) -> None:
    """Raises InputError for suffixes that are none of these and for missing libraries, FileError for folders that are
    not there. Best called before anything is computed.
    """
    for path in paths:
        form = formats.get(suffix(path))
        if form is None:
            raise InputError(f"{path}: not a kind of output", hint=f"outputs end in {', '.join(formats)}")
        for library, words in form.needs:
            need(library, words)
        check_target(path)
    twice = next((p for i, p in enumerate(paths) if p in paths[:i]), None)
    if twice is not None:
        raise InputError(f"{twice}: given twice as an output")


def write_files(m: Any, paths: Sequence[str], formats: Mapping[str, MapFormat]) -> None:
    """Write all files; each appears complete or not at all. Raises FileError for those that cannot be written."""
    for path in paths:
        form = formats[suffix(path)]
        try:
            with nullcontext(path) if form.folder else replacing(path) as name:
                form.write(m, name)
        except OSError as fault:
            raise written(fault, path) from None


def suffix(path: str) -> str:
    """The end of its name that says of what kind a file is."""
    return os.path.splitext(path)[1].lower()


def need(module: str, words: str) -> None:
    """Raises InputError, in these words, where a library is missing."""
    try:
        __import__(module)
    except ImportError:
        raise InputError(words, hint='pip install "gcrules[maps]"') from None
