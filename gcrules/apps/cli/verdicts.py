"""How a verdict ends a command, and its colour."""

from __future__ import annotations

import click

__all__ = ["EXIT_CODES", "coloured"]

EXIT_CODES = {"proved": 0, "refuted": 1, "undecided": 3}
_COLOURS = {"proved": "green", "refuted": "red", "undecided": "yellow"}


def coloured(verdict: str, shown: str) -> str:
    """A text with the first mention of its verdict in colour."""
    colour = _COLOURS.get(verdict)
    return shown.replace(verdict, click.style(verdict, fg=colour, bold=True), 1) if colour else shown
