"""The 3D viewer that the report, the notebook widget and the page of the studio share: a script of JavaScript."""

from __future__ import annotations

from pathlib import Path

__all__ = ["FOLDER", "viewer_script"]

FOLDER = Path(__file__).parent / "static"
"""Where `make studio` builds it."""


def viewer_script() -> str:
    """Its text; it defines `GcrulesViewer`. Raises FileNotFoundError where it was not built."""
    return (FOLDER / "viewer.js").read_text(encoding="utf-8")
