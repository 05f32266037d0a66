"""Writing files: complete, or not at all."""

from __future__ import annotations

import os
import sys

from gcrules.core.budget import waiting
from gcrules.errors import FileError

__all__ = ["write_file"]


def write_file(path: str, text: str) -> None:
    """Write a file by way of a temporary one, so that it appears complete or not at all; "-" is standard output.

    Raises FileError where that is not possible.
    """
    if path == "-":
        with waiting():
            sys.stdout.write(text)
        return
    target = os.path.realpath(path)
    if os.path.isdir(target):
        raise FileError("this is a directory, expected the name of a file", filename=path)
    folder, name = os.path.split(target)
    if not os.path.isdir(folder):
        raise FileError("cannot be written: there is no such directory", filename=path)
    try:
        if os.path.exists(target) and not os.path.isfile(target):  # a device or pipe
            with waiting(), open(target, "w", encoding="utf-8") as file:
                file.write(text)
            return
        if os.path.exists(target) and not os.access(target, os.W_OK):
            raise FileError("cannot be written: the file is write-protected", filename=path)
        _replace(target, os.path.join(folder, f".{name}.{os.getpid()}"), text)
    except OSError as fault:
        raise FileError(f"cannot be written: {fault.strerror or fault}", filename=path) from None


def _replace(target: str, temporary: str, text: str) -> None:
    try:
        with open(temporary, "x", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.replace(temporary, target)
    except BaseException:
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise
