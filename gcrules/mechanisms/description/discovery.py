"""Where robots are found: with gcrules, in folders of plugins, whose code is not run, and in installed packages."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from os import PathLike, fspath
from pathlib import Path

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, InputError
from gcrules.core.hints import near
from gcrules.rules.plugin import ROBOT_FILE, Plugin, installed, plugins_in, shipped, shipped_folder

__all__ = ["RobotFile", "examples", "find_robot", "robots", "theorems"]

Folders = Iterable[str | PathLike[str]]


@dataclass(frozen=True)
class RobotFile:
    """A robot file with its id (the name of its folder, or its own) and its owner in messages."""

    id: str
    path: str
    owner: str


def robots(folders: Folders = ()) -> tuple[RobotFile, ...]:
    """All robots that are known, by id. Raises InputError where two plugins bring one id, and names both."""
    found: dict[str, RobotFile] = {}
    for one in _all(folders):
        other = found.setdefault(one.id, one)
        if Path(other.path).resolve() != Path(one.path).resolve():
            raise InputError(
                f"two plugins provide a robot {one.id}: {other.owner} ({other.path}) and {one.owner} ({one.path})",
                hint="rename the folder of one of them",
            )
    return tuple(found[name] for name in sorted(found))


def find_robot(name: str | PathLike[str], folders: Folders = ()) -> RobotFile:
    """The robot of this id, or the file of this path. Raises InputError for neither."""
    word = fspath(name)
    path = Path(word)
    if (
        path.suffix.lower() in (".yaml", ".yml", ".urdf", ".sdf", ".mjcf", ".xml")
        or len(path.parts) > 1
        or path.is_file()
    ):
        return RobotFile(_id_of(path), word, "")
    known = {one.id: one for one in robots(folders)}
    if word not in known:
        hint = near(word, known) or f"there are {', '.join(known)}."
        raise InputError(f"there is no robot {word!r}", hint=f"{hint} A file is named with its suffix .yaml")
    return known[word]


def examples() -> dict[str, Path]:
    """The platform files that come with gcrules, by name without ending."""
    return _shipped_files("*.yaml")


def theorems() -> dict[str, Path]:
    """The scripts of theorems that come with gcrules, by name without ending."""
    return _shipped_files("theorems/*.gca")


def _shipped_files(pattern: str) -> dict[str, Path]:
    shipped = shipped_folder()
    folder = shipped.parent / ("_examples" if shipped.name == "_plugins" else "examples") if shipped else None
    found = sorted(folder.glob(pattern)) if folder and folder.is_dir() else []
    return {path.stem: path for path in found}


def _id_of(path: Path) -> str:
    return path.parent.name if path.name == ROBOT_FILE else path.stem


def _all(folders: Folders) -> Iterator[RobotFile]:
    for plugin in shipped("robots"):
        yield from _of(plugin, "gcrules")
    for plugin in installed():
        yield from _of(plugin, plugin.owner)
    for folder in folders:
        for plugin in plugins_in(Path(folder), "robots"):
            yield from _of(plugin, f"folder {fspath(folder)}")


def _of(plugin: Plugin, owner: str) -> Iterator[RobotFile]:
    for named in map(Path, plugin.robots):
        yield from (RobotFile(_id_of(path), str(path), owner) for path in _files(named, plugin))


def _files(named: Path, plugin: Plugin) -> list[Path]:
    """The robot files that a plugin names: the file itself, or those of a folder. Raises FileError where none is."""
    if named.is_file():
        return [named]
    try:
        found = [path for folder in (named, *sorted(named.iterdir())) if (path := folder / ROBOT_FILE).is_file()]
    except (OSError, ValueError) as fault:
        why = getattr(fault, "strerror", None) or fault
        raise FileError(f"{plugin.owner}: cannot be read as robots: {why}", filename=str(named)) from None
    if not found:
        hint = f"name files, or folders that hold a {ROBOT_FILE} or folders with one"
        raise FileError(f"{plugin.owner}: there are no robots here", filename=str(named), hint=hint)
    return found
