"""The options with which commands choose rules."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any

import click

from gcrules.apps.cli.naming import completing
from gcrules.apps.cli.output import decorated
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.rules.library import Library
from gcrules.rules.plugins import load_rules
from gcrules.rules.rule import Rule
from gcrules.rules.strategy import Strategy

__all__ = ["Choice", "plugins_option", "rules_options"]

_rules = completing("rule", several=True)

plugins_option = click.option(
    "--plugins", "folders", multiple=True, metavar="DIR", help="Add a folder of plugins (its rules.py files are run)."
)


@dataclass(frozen=True)
class Choice:
    """Which rules the user wants: files and ids of --rules, ids of --without, folders of --plugins."""

    words: tuple[str, ...] = ()
    without: tuple[str, ...] = ()
    folders: tuple[str, ...] = ()

    @property
    def files(self) -> tuple[str, ...]:
        return tuple(w for w in self._pieces if _is_file(w))

    @property
    def ids(self) -> tuple[str, ...]:
        return tuple(w for w in self._pieces if not _is_file(w))

    @property
    def _pieces(self) -> tuple[str, ...]:
        return tuple(p for w in self.words for p in ([w] if os.path.isfile(w) else w.replace(",", " ").split()))

    @property
    def library(self) -> Library:
        return load_rules(self.files, self.folders)

    def strategy(self) -> Strategy | None:
        """None where nothing was said. Files add their identities to the rules named, or to the default ones."""
        if not (self.words or self.without or self.folders):
            return None
        library = load_rules(self.files, self.folders, identities=bool(self.ids or self.folders))
        strategy = library.strategy(self.ids or None, self.without)
        return Strategy((*(r for r in _of_files(library, self.files) if r not in strategy.rules), *strategy.rules))

    def rewriting(self) -> tuple[Any, ...]:
        """The rewriting rules named, and those of files."""
        library = self.library
        chosen = [library[i] for i in self.ids]
        for rule in chosen:
            if rule.family != "rewriting":
                raise InputError(f"the rule {rule.id} recognises entities; it rewrites no expressions")
        for name in self.without:
            library[name]  # an id that is not there is a fault
        found = (*(r for r in _of_files(library, self.files) if r not in chosen), *chosen)
        return tuple(r for r in found if r.id not in self.without)


def _is_file(word: str) -> bool:
    return word.endswith(".gca") or os.sep in word or os.path.isfile(word)


def _of_files(library: Library, files: Iterable[str]) -> tuple[Rule, ...]:
    starts = tuple(f"{f}:" for f in files)
    return tuple(r for r in library if r.owner.startswith(starts)) if starts else ()


def rules_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """--rules, --without, --plugins; the command receives them as `choice`."""

    @wraps(command)
    def with_choice(**options: Any) -> Any:
        choice = Choice(options.pop("words"), options.pop("without"), options.pop("folders"))
        return command(choice=choice, **options)

    named = "Add the rules of a .gca file; or run just the rules named, in this order: planes,four-planes."
    left_out = "Leave rules out: four-planes."
    decorators = [
        click.option("--rules", "words", multiple=True, metavar="FILE|IDS", help=named, shell_complete=_rules),
        click.option("--without", multiple=True, metavar="IDS", callback=_ids, help=left_out, shell_complete=_rules),
        plugins_option,
    ]
    return decorated(with_choice, decorators)


def _ids(ctx: click.Context, option: click.Parameter, words: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(i for w in words for i in w.replace(",", " ").split())
