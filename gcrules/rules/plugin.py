r"""What comes from outside: rules, robots and catalogs, in one value, and where such values are found.

Plugins come with gcrules, stand in a folder of the user's, or are installed as a package. A folder of plugins holds one
folder for each: `*.gca` files with identities, `rules.py` whose `RULES` is a tuple of rules, for recognisers, a
`robot.yaml` and a `catalog.yaml`, any of them. An installed package names one `Plugin` value under the entry point
group `gcrules.plugins`.

Python code runs only from the folder that comes with gcrules, from folders that the user names, and from installed
packages; that of a folder only where its rules are asked for.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from importlib import util
from os import PathLike
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, TypeVar

from gcrules.core.arguments import ANYTHING, FILE, TEXT, listed, read
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import FileError, InputError
from gcrules.core.frozen import FrozenMap
from gcrules.rules.foreign import foreign
from gcrules.rules.identity import Identity
from gcrules.rules.rule import ConditionRule, Rule

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

__all__ = [
    "CATALOG_FILE",
    "GROUP",
    "ROBOT_FILE",
    "Plugin",
    "installed",
    "packs",
    "plugins_in",
    "shipped",
    "shipped_folder",
]

load_rule_file = deferred("gcrules.rules.rule_file:load_rule_file")  # takes the parser, which few runs need
entry_points = deferred("importlib.metadata:entry_points")  # loads what reads e-mail

GROUP = "gcrules.plugins"
"""The entry point group of installed packages: the value is a `Plugin`."""

ROBOT_FILE = "robot.yaml"
CATALOG_FILE = "catalog.yaml"
CODE_FILE = "rules.py"

_R = TypeVar("_R", bound=Rule)
_RULES = listed("a sequence of rules", ANYTHING)  # what is none is told with the place of the plugin
_FILES = listed("a sequence of names of files", FILE)


@dataclass(frozen=True)
class Plugin:
    """What one plugin brings: `rules` as values, `rule_files` with identities (`.gca`), `robots` and `catalogs`.

    Robots are robot files, or folders that hold a `robot.yaml` or a folder with one for each robot; catalogs are files.
    Nothing of it is believed: identities and entries of catalogs are proved before they become an answer, claims of
    rules too. `owner` names the plugin in messages; an entry point or folder fills it in.
    """

    rules: tuple[Rule, ...] = ()
    rule_files: tuple[str | PathLike[str], ...] = ()
    robots: tuple[str | PathLike[str], ...] = ()
    catalogs: tuple[str | PathLike[str], ...] = ()
    owner: str = ""

    def __post_init__(self) -> None:
        for name, kind in _FIELDS.items():
            object.__setattr__(self, name, read(kind, getattr(self, name), f"gc.Plugin: `{name}`"))

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of conditions that its rules bring; entries of its catalogs may be of these too."""
        return tuple(r.id for r in self.rules if isinstance(r, ConditionRule))

    def identities(self, *, proved: bool = True) -> Iterator[Identity]:
        """The rules of the files, each proved unless `proved` is False. Raises InputError with place."""
        for path in self.rule_files:
            try:
                found = load_rule_file(path, proved=proved)
            except InputError as fault:
                raise fault.of(self.owner) from None
            for rule in found:
                yield replace(rule, owner=f"{self.owner}, {Path(rule.owner).name}") if self.owner else rule


_FIELDS = FrozenMap({"rules": _RULES, **dict.fromkeys(("rule_files", "robots", "catalogs"), _FILES), "owner": TEXT})

_RUN: Mapping[str, Callable[[Plugin], bool]] = FrozenMap(
    {"rules": lambda _: True, "catalogs": lambda p: bool(p.catalogs), "robots": lambda _: False}
)
"""Whether the `rules.py` of a folder is run, by what is wanted: its catalog may hold kinds that its rules bring."""


def packs(folders: Iterable[str | PathLike[str]] = (), bringing: str = "rules") -> tuple[Plugin, ...]:
    """All plugins: those that come with gcrules, those of installed packages, those of the folders.

    `bringing` says what is wanted of them: rules, catalogs or robots; a plugin of a folder may come without its other
    parts. Raises FileError where one is broken.
    """
    named = (p for folder in folders for p in plugins_in(Path(folder), bringing))
    return (*shipped(bringing), *installed(), *named)


@cache
def shipped(bringing: str = "rules") -> tuple[Plugin, ...]:
    """The plugins that come with gcrules."""
    folder = shipped_folder()
    return tuple(plugins_in(folder, bringing, outside=False)) if folder else ()


def shipped_folder() -> Path | None:
    """The folder of plugins inside an installed package, or beside the package in a checkout."""
    package = Path(__file__).parent.parent
    for folder in (package / "_plugins", package.parent / "plugins"):
        if (folder / "README.md").is_file():
            return folder
    return None


def plugins_in(folder: Path, bringing: str = "rules", *, outside: bool = True) -> Iterator[Plugin]:
    """The plugins of a folder, by name, or the folder itself where it is one; those that come with gcrules are not from
    `outside`. Raises FileError if unreadable.
    """
    try:
        with os.scandir(folder) as entries:
            inside = sorted(folder / e.name for e in entries if e.is_dir() and not e.name.startswith((".", "_")))
    except (OSError, ValueError) as fault:
        why = getattr(fault, "strerror", None) or fault
        raise FileError(f"cannot be read as a folder of plugins: {why}", filename=str(folder)) from None
    if _is_plugin(folder):
        inside.insert(0, folder.resolve())
    for path in inside:
        owner, names = f"plugin {path.name}", _names_in(path)
        identities = tuple(sorted(str(path / n) for n in names if n.endswith(".gca")))
        robot, catalog = ((str(path / n),) if names.get(n) else () for n in (ROBOT_FILE, CATALOG_FILE))
        found = Plugin((), identities, robot, catalog, owner)
        if names.get(CODE_FILE) and _RUN[bringing](found):
            code = path / CODE_FILE
            found = _owned(replace(found, rules=_rules_of(code, owner)), owner, str(code), outside=outside)
        if found.rules or identities or robot or catalog:
            yield found


def _is_plugin(folder: Path) -> bool:
    """Whether a folder holds files of a plugin itself."""
    files = (name for name, is_file in _names_in(folder).items() if is_file)
    return any(name in (CODE_FILE, ROBOT_FILE, CATALOG_FILE) or name.endswith(".gca") for name in files)


def _names_in(folder: Path) -> dict[str, bool]:
    """What a folder holds, and whether it is a file; nothing where it cannot be read."""
    try:
        with os.scandir(folder) as entries:
            return {e.name: e.is_file() for e in entries}
    except OSError:
        return {}


@cache
def installed() -> tuple[Plugin, ...]:
    """The plugins of installed packages. Raises FileError where one is broken."""
    if not any(map(_may_name_plugins, sys.path)):
        return ()
    return tuple(_of_entry(entry) for entry in sorted(entry_points(group=GROUP), key=lambda e: e.name))


def _may_name_plugins(folder: str) -> bool:
    """Whether a package that is installed in a folder of the path names the group; True where it is no folder."""
    try:
        with os.scandir(folder or ".") as entries:
            about = [e.path for e in entries if e.name.endswith((".dist-info", ".egg-info", ".egg"))]
    except FileNotFoundError:
        return False
    except OSError:
        return True
    return any(map(_mentions, about))


def _mentions(package: str) -> bool:
    folder = os.path.join(package, "EGG-INFO") if package.endswith(".egg") else package
    try:
        with open(os.path.join(folder, "entry_points.txt"), "rb") as file:
            return GROUP.encode() in file.read()
    except OSError:  # most packages have none
        return package.endswith(".egg") and os.path.isfile(package)


def _of_entry(entry: EntryPoint) -> Plugin:
    package = entry.dist.name if entry.dist else entry.value
    owner = f"package {package}"
    with foreign(f"{owner} cannot be loaded", f"{owner} (entry point {entry.name} = {entry.value})"):
        plugin = entry.load()
    if not isinstance(plugin, Plugin):
        raise FileError(f"{entry.value} is not a gcrules.Plugin but {type(plugin).__name__}", filename=owner)
    return _owned(plugin, owner, owner, outside=True)


def _owned(plugin: Plugin, owner: str, place: str, *, outside: bool) -> Plugin:
    """A plugin with its owner's name. Raises FileError where its rules are something else."""
    for rule in plugin.rules:
        if not isinstance(rule, Rule):
            raise FileError(f"{owner}: rules holds {rule!r:.100}, which is not a rule", filename=place)
    with foreign(f"{owner} cannot be loaded", place):
        return replace(plugin, rules=tuple(_of(owner, r, outside) for r in plugin.rules), owner=owner)


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
