"""The options of what the numbers of a file say beyond the names of its joints: --no-facts, --tolerance."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from gcrules.conditions.dimensions.facts import TOLERANCE

__all__ = ["facts_options"]

_Command = Callable[..., Any]


def facts_options(command: _Command) -> _Command:
    """A command with both options, which it gets as `facts` and `tolerance`."""
    off = click.option("--no-facts", "facts", flag_value=False, default=True, help="Leave out what the dimensions say.")
    tolerance = click.option(
        "--tolerance",
        type=click.FloatRange(0, 0.1),
        default=TOLERANCE,
        show_default=True,
        metavar="PART",
        help="Also list facts of the dimensions that are missed by up to this fraction of the size, as nearly true.",
    )
    return off(tolerance(command))
