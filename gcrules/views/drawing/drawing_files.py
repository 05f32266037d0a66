"""Figures as files; the suffix says of what kind."""

from __future__ import annotations

from collections.abc import Callable
from os import PathLike, fspath
from pathlib import Path

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.files import write_file
from gcrules.views.drawing.drawing import Drawing

__all__ = ["pdf_bytes", "save"]

pdf = deferred("gcrules.views.drawing.pdf:pdf")  # matplotlib


def save(drawing: Drawing, path: str | PathLike[str]) -> None:
    """Write a figure; the suffix .svg or .pdf decides the format. The file appears complete or not at all.

    Raises InputError for another suffix, and for PDF where matplotlib is missing; FileError if it cannot be written.
    """
    target = Path(fspath(path))
    writer = _WRITERS.get(target.suffix.lower())
    if writer is None:
        found = f"the suffix {target.suffix!r}" if target.suffix else "a name without suffix"
        raise InputError(f"{target}: {found} is not a figure format", hint="figures are written as .svg or .pdf")
    write_file(fspath(path), writer(drawing))


def _svg_bytes(drawing: Drawing) -> bytes:
    return drawing.svg().encode()


def pdf_bytes(drawing: Drawing) -> bytes:
    """Raises InputError where matplotlib is missing."""
    try:
        import matplotlib  # noqa: F401  # an extra of the installation
    except ImportError:
        raise InputError("PDF figures need matplotlib", hint='pip install "gcrules[figures]"') from None
    data: bytes = pdf(drawing)
    return data


_WRITERS: dict[str, Callable[[Drawing], bytes]] = {".svg": _svg_bytes, ".pdf": pdf_bytes}
