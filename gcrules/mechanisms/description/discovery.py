"""Where robots are found: with gcrules, in folders of plugins, in installed packages. No code of theirs is run."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib import metadata, util
from os import PathLike, fspath
from pathlib import Path

from gcrules.core.errors import FileError, InputError
from gcrules.core.hints import near
from gcrules.rules.plugins import shipped_folder

__all__ = ["FILE", "GROUP", "RobotFile", "examples", "find_robot", "robots"]

FILE = "robot.yaml"
GROUP = "gcrules.robots"
"""The entry point group of installed packages: the value is a package, whose folders hold robot files."""

Folders = Iterable[str | PathLike[str]]


@dataclass(frozen=True)
class RobotFile:
    """A robot file with its id (the name of its folder) and its owner in messages."""

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
                f"two plugins bring a robot {one.id}: {other.owner} ({other.path}) and {one.owner} ({one.path})",
                hint="rename the folder of one of them",
            )
    return tuple(found[name] for name in sorted(found))


def find_robot(name: str | PathLike[str], folders: Folders = ()) -> RobotFile:
    """The robot of this id, or the file of this path. Raises InputError for neither."""
    word = fspath(name)
    path = Path(word)
    if path.suffix in (".yaml", ".yml") or len(path.parts) > 1 or path.is_file():
        return RobotFile(path.parent.name if path.name == FILE else path.stem, word, "")
    known = {one.id: one for one in robots(folders)}
    if word not in known:
        hint = near(word, known) or f"there are {', '.join(known)}."
        raise InputError(f"there is no robot {word!r}", hint=f"{hint} A file is named with its ending .yaml")
    return known[word]


def examples() -> dict[str, Path]:
    """The platform files that come with gcrules, by name without ending."""
    shipped = shipped_folder()
    folder = shipped.parent / ("_examples" if shipped.name == "_plugins" else "examples") if shipped else None
    found = sorted(folder.glob("*.yaml")) if folder and folder.is_dir() else []
    return {path.stem: path for path in found}


def _all(folders: Folders) -> Iterator[RobotFile]:
    shipped = shipped_folder()
    if shipped:
        yield from _in(shipped, "gcrules")
    for entry in sorted(metadata.entry_points(group=GROUP), key=lambda e: e.name):
        package = entry.dist.name if entry.dist else entry.value
        spec = util.find_spec(entry.value.partition(".")[0])
        if spec is None or not spec.submodule_search_locations:
            raise FileError(f"{entry.value} is no package with folders of robots", filename=f"package {package}")
        for root in spec.submodule_search_locations:
            yield from _in(Path(root, *entry.value.split(".")[1:]), f"package {package}")
    for folder in folders:
        yield from _in(Path(folder), f"folder {fspath(folder)}")


def _in(folder: Path, owner: str) -> Iterator[RobotFile]:
    try:
        inside = sorted(p for p in folder.iterdir() if (p / FILE).is_file())
    except (OSError, ValueError) as fault:
        why = getattr(fault, "strerror", None) or fault
        raise FileError(f"cannot be read as a folder of plugins: {why}", filename=str(folder)) from None
    for path in inside:
        yield RobotFile(path.name, str(path / FILE), owner)
