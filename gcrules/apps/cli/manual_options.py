"""`gcrules analyze --manual`: the options; the session itself (`manual`) is loaded only where one of them is given."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from gcrules.apps.cli.output import decorated
from gcrules.core.dataclass import dataclass

__all__ = ["ManualOptions", "manual_options"]


@dataclass(frozen=True)
class ManualOptions:
    """What --manual, --propose and --session say."""

    flag: bool = False
    proposals: tuple[str, ...] = ()
    path: str | None = None

    @property
    def requested(self) -> bool:
        return self.flag or bool(self.proposals) or self.path is not None


def manual_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """--manual, --propose, --session; the command receives them as `manual`."""

    @wraps(command)
    def with_manual(**options: Any) -> Any:
        asked, proposals, path = (options.pop(key) for key in ("manual", "proposals", "session_path"))
        return command(manual=ManualOptions(asked, proposals, path), **options)

    decorators = [
        click.option("--manual", is_flag=True, help="Propose entities and the condition yourself, at a prompt."),
        click.option(
            "--propose",
            "proposals",
            multiple=True,
            metavar="COMMAND",
            help='Manual mode with these commands: --propose "plane abc"; "help" lists them.',
        ),
        click.option(
            "--session", "session_path", metavar="FILE", help="Manual mode: resume from this file and save to it."
        ),
    ]
    return decorated(with_manual, decorators)
