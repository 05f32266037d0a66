r"""Faults of plugins: what went wrong in code that is not gcrules' own, with that code's file and line."""

from __future__ import annotations

import os
import traceback
from pathlib import Path

from gcrules.errors import FileError

__all__ = ["plugin_fault"]

_PACKAGE = f"{Path(__file__).parent.parent}{os.sep}"


def plugin_fault(fault: Exception, place: str, what: str) -> FileError:
    """The fault with the last line of the plugin's own that it passed through; `place` where there is none."""
    if isinstance(fault, SyntaxError) and fault.filename:
        return FileError(f"{what}: {fault.msg}", filename=f"{fault.filename}:{fault.lineno}")
    frames = [f for f in traceback.extract_tb(fault.__traceback__) if _outside(f.filename)]
    where = f"{frames[-1].filename}:{frames[-1].lineno}" if frames else place
    return FileError(f"{what}: {type(fault).__name__}: {fault}", filename=where)


def _outside(filename: str) -> bool:
    """Whether a file is no part of the package; plugins that are shipped inside it are not."""
    return not filename.startswith((_PACKAGE, "<")) or filename.startswith(f"{_PACKAGE}_plugins")
