"""Words of a command that name what has an id, and their completion in a shell."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import click
from click.shell_completion import CompletionItem

from gcrules.core.deferred import deferred
from gcrules.core.errors import GcrulesError

__all__ = ["complete_source", "completing", "mechanism_argument", "offering"]

_known_ids = deferred("gcrules.mechanisms.load:known_ids")
_load_rules = deferred("gcrules.rules.plugins:load_rules")

_Completes = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def completing(*kinds: str, several: bool = False) -> _Completes:
    """How a shell completes ids of these kinds: robot, class, example, rule; or names of files, where no id fits. Data
    in the folders of --plugins count. With `several` a word is a list with commas, and its last id is completed.
    """

    def completed(ctx: click.Context, _: click.Parameter, incomplete: str) -> list[CompletionItem]:
        before, comma, last = incomplete.rpartition(",") if several else ("", "", incomplete)
        folders = tuple(ctx.params.get("folders") or ())
        try:
            known = sorted({name for kind in kinds for name in _ids(kind, folders)})
        except GcrulesError:  # a plugin at fault says so when the command runs
            known = []
        fitting = [CompletionItem(before + comma + name) for name in known if name.startswith(last)]
        return fitting or [CompletionItem(incomplete, type="file")]

    return completed


complete_source = completing("robot", "class", "example")
"""What `gcrules.load` reads."""


def offering(*words: str, several: bool = False) -> _Completes:
    """How a shell completes one of these words; with `several` the last one of a list with commas."""

    def completed(_: click.Context, __: click.Parameter, incomplete: str) -> list[CompletionItem]:
        before, comma, last = incomplete.rpartition(",") if several else ("", "", incomplete)
        return [CompletionItem(before + comma + word) for word in words if word.startswith(last)]

    return completed


def _ids(kind: str, folders: tuple[str, ...]) -> Iterable[str]:
    if kind == "rule":
        return (rule.id for rule in _load_rules())  # code of --plugins is not run for it
    found: Iterable[str] = _known_ids(kind, folders)
    return found


def mechanism_argument(command: Callable[..., Any]) -> Callable[..., Any]:
    """The robot or platform that a command is about, as `file`: a file, or an id."""
    complete = completing("robot", "example")
    return click.argument("file", metavar="FILE.yaml|ID", shell_complete=complete)(command)
