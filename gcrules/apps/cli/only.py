"""`--only ID`: commands that write a page for each of many things, for some of them."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Collection
from typing import Any

import click

from gcrules.apps.cli.naming import completing
from gcrules.core.errors import InputError
from gcrules.core.hints import near

__all__ = ["check_known", "only_option", "only_words"]

_Command = Callable[..., Any]


def only_option(thing: str) -> Callable[[_Command], _Command]:
    """The option, given to the command as the tuple `only`; `thing` is what bears the ids."""
    words = f"Only the pages of this {thing}, and not the index; may be repeated."
    return click.option("--only", multiple=True, metavar="ID", help=words, shell_complete=completing(thing))


def only_words(only: Collection[str]) -> str:
    """The option as it is typed, with a space before it; nothing for all."""
    return "".join(f" --only {shlex.quote(one)}" for one in dict.fromkeys(only))


def check_known(only: Collection[str], known: Collection[str], thing: str, listing: str) -> None:
    """Raises InputError for an id that is none of those known; `listing` is the command that lists them."""
    for one in only:
        if one not in known:
            hint = near(one, known) or f"`{listing}` lists them"
            raise InputError(f"there is no {thing} {one[:40]!r}", hint=hint)
