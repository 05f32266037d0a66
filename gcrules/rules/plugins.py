r"""Plugins: packs of rules that come with gcrules, stand in a folder of the user's, or are installed as a package.

This module is also what a plugin imports: the kinds of rules, the state they look at, and the operations.

A folder of plugins holds one folder for each: `*.gca` files with identities, and `rules.py` whose `RULES` is a tuple of
rules, for recognisers. An installed package names one `Plugin` value under the entry point group `gcrules.plugins`.
Python code runs only from the folder that comes with gcrules, from folders that the user names, and from installed
packages.
"""

from __future__ import annotations

import copyreg
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from importlib import metadata, util
from os import PathLike
from pathlib import Path
from types import ModuleType
from typing import Any, TypeVar

from gcrules.algebra.expr import Expr, Point, add, join, meet, mul, sub
from gcrules.algebra.language.legs_text import leg_text
from gcrules.algebra.scalars import bracket
from gcrules.core.arguments import ANYTHING, FILE, TEXT, listed, read
from gcrules.core.deferred import deferred
from gcrules.core.errors import FileError
from gcrules.rules.entities import LEFT_OVER_LINE, LEFT_OVER_LINES, LEFT_OVER_PLANE, LINES, PLANES, TETRAHEDRA
from gcrules.rules.foreign import foreign
from gcrules.rules.identity import Identity
from gcrules.rules.library import ENGINE, Library
from gcrules.rules.recognition_state import RecognitionState, extensor
from gcrules.rules.rule import ConditionRule, Elementary, EntityRule, Rule

__all__ = [
    "GROUP",
    "LEFT_OVER_LINE",
    "LEFT_OVER_LINES",
    "LEFT_OVER_PLANE",
    "LINES",
    "PLANES",
    "TETRAHEDRA",
    "ConditionRule",
    "EntityRule",
    "Expr",
    "Identity",
    "Plugin",
    "RecognitionState",
    "Rule",
    "add",
    "bracket",
    "extensor",
    "installed",
    "join",
    "leg_text",
    "load_rules",
    "meet",
    "mul",
    "packs",
    "plugins_in",
    "points",
    "shipped_folder",
    "sub",
]

load_rule_file = deferred("gcrules.rules.rule_file:load_rule_file")  # takes the parser, which few runs need

GROUP = "gcrules.plugins"
_R = TypeVar("_R", bound=Rule)


def points(names: Iterable[str]) -> list[Expr]:
    """Points by name."""
    return [Point(n) for n in names]


_RULES = listed("a sequence of rules", ANYTHING)  # what is none is told with the place of the plugin
_FILES = listed("a sequence of names of files", FILE)


@dataclass(frozen=True)
class Plugin:
    """One pack of rules: `rules` are rules as values, `files` are `.gca` files of identities.

    `owner` names the pack in messages; an entry point or folder fills it in.
    """

    rules: tuple[Rule, ...] = ()
    files: tuple[str | PathLike[str], ...] = ()
    owner: str = ""

    def __post_init__(self) -> None:
        for name, kind in (("rules", _RULES), ("files", _FILES), ("owner", TEXT)):
            object.__setattr__(self, name, read(kind, getattr(self, name), f"gc.Plugin: `{name}`"))

    def identities(self, *, proved: bool = True) -> Iterator[Identity]:
        """The rules of the files, each proved unless `proved` is False. Raises InputError with place."""
        for path in self.files:
            for rule in load_rule_file(path, proved=proved):
                yield replace(rule, owner=f"{self.owner}, {Path(rule.owner).name}") if self.owner else rule


def load_rules(
    files: Iterable[str | PathLike[str]] = (), folders: Iterable[str | PathLike[str]] = (), *, identities: bool = True
) -> Library:
    """All rules that are known: those of the engine, then plugins, then files of the user's own.

    Identities of plugins are read only with `identities`; those of shipped plugins are proved by `gcrules rules check`,
    all others when they are loaded. Raises InputError where a rule is wrong or ids clash (both owners are named),
    FileError where a plugin is broken.
    """
    found = packs(folders)
    library = ENGINE.plus(r for p in found for r in p.rules)
    if identities:
        library = library.plus(i for p in found for i in p.identities(proved=p not in _shipped()))
    return library.plus(Plugin(files=tuple(files)).identities())


def packs(folders: Iterable[str | PathLike[str]] = ()) -> tuple[Plugin, ...]:
    """All plugins: those that come with gcrules, those of installed packages, those of the folders.

    Raises FileError where one is broken.
    """
    return (*_shipped(), *_installed(), *(p for folder in folders for p in plugins_in(Path(folder))))


@cache
def _shipped() -> tuple[Plugin, ...]:
    folder = shipped_folder()
    return tuple(plugins_in(folder, shipped=True)) if folder else ()


@cache
def _installed() -> tuple[Plugin, ...]:
    return tuple(installed())


def shipped_folder() -> Path | None:
    """The folder of plugins inside an installed package, or beside the package in a checkout."""
    package = Path(__file__).parent.parent
    for folder in (package / "_plugins", package.parent / "plugins"):
        if (folder / "README.md").is_file():
            return folder
    return None


def plugins_in(folder: Path, *, shipped: bool = False) -> Iterator[Plugin]:
    """The plugins of a folder, by name; those that come with gcrules are `shipped`. Raises FileError if unreadable."""
    try:
        inside = sorted(p for p in folder.iterdir() if p.is_dir() and not p.name.startswith((".", "_")))
    except (OSError, ValueError) as fault:
        why = getattr(fault, "strerror", None) or fault
        raise FileError(f"cannot be read as a folder of plugins: {why}", filename=str(folder)) from None
    for path in inside:
        code = path / "rules.py"
        owner = f"plugin {path.name}"
        rules = _rules_of(code, owner) if code.is_file() else ()
        files = tuple(sorted(str(f) for f in path.glob("*.gca")))
        if rules or files:
            yield _owned(Plugin(rules, files), owner, str(code), outside=not shipped)


def installed() -> Iterator[Plugin]:
    """The plugins of installed packages. Raises FileError where one is broken."""
    for entry in sorted(metadata.entry_points(group=GROUP), key=lambda e: e.name):
        package = entry.dist.name if entry.dist else entry.value
        owner = f"package {package}"
        with foreign(f"{owner} cannot be loaded", f"{owner} (entry point {entry.name} = {entry.value})"):
            plugin = entry.load()
        if not isinstance(plugin, Plugin):
            raise FileError(f"{entry.value} is no gcrules.Plugin but {type(plugin).__name__}", filename=owner)
        yield _owned(plugin, owner, owner, outside=True)


def _owned(plugin: Plugin, owner: str, place: str, *, outside: bool) -> Plugin:
    """A pack with its owner's name. Raises FileError where it holds something else than rules."""
    for rule in plugin.rules:
        if not isinstance(rule, Rule):
            raise FileError(f"{owner}: rules holds {rule!r:.100}, which is no rule", filename=place)
    with foreign(f"{owner} cannot be loaded", place):
        return Plugin(tuple(_of(owner, r, outside) for r in plugin.rules), plugin.files, owner)


def _of(owner: str, rule: _R, outside: bool) -> _R:
    """A rule with its owner, which the entity rules that it brings along have too."""
    if not isinstance(rule, ConditionRule):
        return replace(rule, owner=owner, outside=outside)
    uses = tuple((_of(owner, u, outside) if u.foreign else u, n) for u, n in rule.uses)
    return replace(rule, owner=owner, outside=outside, uses=uses)


def _rules_of(path: Path, owner: str) -> tuple[Rule, ...]:
    """`RULES` of a plugin's Python file, which is run. Raises FileError with the plugin's own file and line."""
    name = f"gcrules_plugin_{path.parent.name}"
    spec = util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise FileError("cannot be loaded", filename=str(path))
    module: ModuleType = util.module_from_spec(spec)
    sys.modules[name] = module  # dataclasses and pickles look their module up
    try:
        with foreign(f"{owner} cannot be loaded", str(path)):
            spec.loader.exec_module(module)
            rules = getattr(module, "RULES", None)
    except BaseException:
        sys.modules.pop(name, None)
        raise
    if not isinstance(rules, tuple):
        raise FileError(f"{owner} defines no tuple RULES", filename=str(path), hint="RULES = (rule, …)")
    return rules


# --- copies --------------------------------------------------------------------------------------------------------


def _known(rule_id: str) -> Rule:
    return load_rules(identities=False)[rule_id]


def _by_name(rule: Rule) -> Any:
    """Rules hold functions, which may have no name; those that every process knows are pickled and copied by id."""
    if any(rule.id == known.id and rule == known for known in load_rules(identities=False)):
        return _known, (rule.id,)
    return object.__reduce_ex__(rule, 4)


for _kind in (Elementary, EntityRule, ConditionRule):
    copyreg.pickle(_kind, _by_name)
