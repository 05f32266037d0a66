r"""What a source is, decided here and nowhere else: legs, a file, an id, data, or a value that was loaded before.

>>> load("ab af cb cd ed ef").base
('a', 'c', 'e')
>>> load("3-rps")
<Robot 3-rps: 3-RP*S, mobility 3>
>>> kind_of("platform.yaml"), kind_of("3-rps"), kind_of("3-3.3"), kind_of("octahedral-singular"), kind_of("ab cd")
('file', 'robot', 'class', 'example', 'legs')
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from os import PathLike, fspath
from typing import Any

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure, legs_text, read_legs
from gcrules.algebra.language.text import SHORT_NAME, Names
from gcrules.conditions.analysis import Analysis
from gcrules.core.arguments import described
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.core.yaml_file import Document
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import examples, find_robot, robots
from gcrules.mechanisms.description.platform_file import Platform, load_platform, parse_platform
from gcrules.mechanisms.robot import Robot, read_models_by
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load as load_catalog
from gcrules.rules.plugin import packs

__all__ = [
    "LOADED",
    "Folders",
    "Loaded",
    "Source",
    "is_data",
    "is_model",
    "is_path",
    "is_xml",
    "kind_of",
    "known_ids",
    "load",
    "read_class",
    "read_example",
    "read_robot",
    "read_text",
]

Folders = Iterable[str | PathLike[str]]
Loaded = Structure | Platform | Robot | Analysis | RobotAnalysis
Source = Loaded | str | PathLike[str] | Mapping[str, Any] | Iterable[str | Sequence[str] | Expr]
LOADED = (Structure, Platform, Robot, Analysis, RobotAnalysis)

_load_robot = deferred("gcrules.mechanisms.description.robot_file:load_robot")
_parse_robot = deferred("gcrules.mechanisms.description.robot_file:parse_robot")
_robot_of_model = deferred("gcrules.mechanisms.models.importing:robot_of_file")
read_models_by("gcrules.mechanisms.models.importing:robot_of_file")
_robot_of_text = deferred("gcrules.mechanisms.models.importing:robot_of_text")

MODELS = (".urdf", ".sdf", ".mjcf", ".xml")
"""Endings of files with models of links and joints: URDF, SDF, MJCF."""

_OF_JOINTS = {"limbs", "lines", "mobility", "copies"}  # keys that geometry files do not have
_KEY = re.compile(r"^\s*(?:\{|[\"']?[A-Za-z_]+[\"']?\s*:(?:\s|$))", re.MULTILINE)
_MEETS = re.compile(r"/\\|\\/")
_LEG = re.compile(rf"(?:{SHORT_NAME.pattern})\s*[-–]?\s*(?:{SHORT_NAME.pattern})")

_IDS: Mapping[str, Callable[[Folders], list[str]]] = {
    "robot": lambda plugins: [one.id for one in robots(plugins)],
    "class": lambda plugins: [e.id for e in _catalog(plugins).entries],
    "example": lambda _: list(examples()),
}
"""The ids of each kind, in the sequence in which they are looked up."""


def load(
    source: Source,
    *,
    plugins: Folders = (),
    points: Names = (),
    ideal: Names = (),
    given: str | Iterable[str] = (),
    letters: str = "",
    rank: int = 4,
    filename: str = "<input>",
    stdin: Callable[[], str] | None = None,
) -> Loaded:
    """What a source says: a `Structure` of legs, a `Platform` with coordinates, or a `Robot` of joints.

    A text is, in this sequence, the text of a geometry file or robot file; the name of such a file (with its ending, a
    folder, or there on the disk), or of a model of links and joints (URDF, SDF, MJCF, also as text); the id of a robot
    or of a class of a catalog (shipped, or of `plugins`, folders of the user's own), or of an example; else legs. Legs
    may be a sequence of pairs, too, and are read with `points`, `ideal`, `given`, `letters` and `rank` as for
    `gcrules.analyze`. A mapping holds the data of a file. What was loaded or analysed before is given back as it is.
    `filename` names texts and data in messages; "-" is standard input where there is one.

    Raises InputError for what is none of these, FileError with all faults of a file.
    """
    if isinstance(source, LOADED):
        return source
    if isinstance(source, PathLike):
        return _read_file(fspath(source))
    if isinstance(source, Mapping):
        return read_text(_as_text(source), "<data>" if filename == "<input>" else filename)
    if source == "-" and stdin is not None:
        source, filename = stdin(), "<stdin>"
        kind = "text" if is_data(source) else "legs"
    else:
        kind = kind_of(source, plugins) if isinstance(source, str) else "legs"
    if kind == "class":
        source, kind = legs_text(read_class(str(source), plugins).legs), "legs"
    if kind == "legs":
        if not isinstance(source, Iterable):
            raise InputError(f"{described(source)} is not a source", hint="give legs, a file, an id, or data")
        return read_legs(source, points=points, ideal=ideal, given=given, letters=letters, rank=rank, built=True)
    assert isinstance(source, str)
    if kind == "text":
        return read_text(source, filename)
    if kind == "robot":
        return read_robot(source, plugins)
    return read_example(source) if kind == "example" else _read_file(source)


def kind_of(word: str, plugins: Folders = ()) -> str:
    """What a text means: text | file | robot | class | example | legs. Raises InputError for a single word that is none
    of these, with the names like it.
    """
    if ("\n" in word or word.lstrip().startswith(("{", "<"))) and is_data(word):
        return "text"
    if is_path(word):
        return "file"
    if re.search(r"[\s,/\\]", word.strip()) or not word.strip():  # no id: nothing of robots needs to be looked up
        return "legs"
    if kind := kind_of_id(word, plugins):
        return kind
    if _LEG.fullmatch(word):
        return "legs"
    raise InputError(
        f"{word[:60]!r} is neither a file, nor the id of a robot, a class or an example, nor legs",
        hint=near(word, [known for ids in _IDS.values() for known in ids(plugins)])
        or '`gcrules robot list` and `gcrules catalog list` name ids; legs are written "ab af cb cd ed ef"',
    )


def kind_of_id(word: str, plugins: Folders = ()) -> str:
    """Whose id a word is: robot | class | example, or nothing."""
    return next((kind for kind, ids in _IDS.items() if word in ids(plugins)), "")


def known_ids(kind: str, plugins: Folders = ()) -> list[str]:
    """The ids of a kind: robot | class | example."""
    return _IDS[kind](plugins)


def read_text(text: str, filename: str = "<input>") -> Platform | Robot:
    """What the text of a geometry file or of a robot file says; its keys tell which it is; or that of a model. Raises
    FileError.
    """
    if is_xml(text):
        return _robot(_robot_of_text(text, filename))
    if _describes_joints(Document.parse(text, filename)):
        return _robot(_parse_robot(text, filename))
    return parse_platform(text, filename)


def read_robot(name: str | PathLike[str], plugins: Folders = ()) -> Robot:
    """The robot of this id, or of a robot file. Raises InputError for an unknown id or one that two plugins bring,
    FileError with all faults of the file.
    """
    found = find_robot(name, plugins)
    if is_model(found.path):
        return _robot(_robot_of_model(found.path))
    return _robot(_load_robot(found.path, found.owner))


def read_class(class_id: str, plugins: Folders = ()) -> Entry:
    """The class of the catalog, or of one that a plugin brings. Raises InputError for an id that is not there."""
    entries = {e.id: e for e in _catalog(plugins).entries}
    if class_id not in entries:
        raise InputError(f"there is no class {class_id[:40]!r}", hint=near(class_id, entries))
    return entries[class_id]


def _catalog(plugins: Folders) -> Catalog:
    return load_catalog(plugins=packs(plugins, "catalogs"))


def read_example(name: str) -> Platform:
    """The example of this name. Raises InputError for a name that is not there."""
    paths = examples()
    if name not in paths:
        raise InputError(f"there is no example {name[:40]!r}", hint=near(name, paths))
    return load_platform(paths[name])


def _read_file(path: str) -> Platform | Robot:
    if is_model(path):
        return _robot(_robot_of_model(path))
    return _robot(_load_robot(path)) if _describes_joints(Document.load(path)) else load_platform(path)


def _robot(found: Any) -> Robot:
    assert isinstance(found, Robot)
    return found


def _describes_joints(document: Document) -> bool:
    """Whether a robot file is meant and not a geometry file: no legs, and a key that only robot files have."""
    root = document.root
    keys = {key.text for key, _ in root.entries()} if root.kind == "mapping" else set()
    return "legs" not in keys and not _OF_JOINTS.isdisjoint(keys)


def is_path(word: str) -> bool:
    """Whether a word names a file: by its ending, by a folder, or as it is there on the disk."""
    return word.lower().endswith((".yaml", ".yml", *MODELS)) or os.sep in _MEETS.sub("", word) or os.path.isfile(word)


def is_model(path: str) -> bool:
    """Whether a file is that of a model of links and joints, by its ending."""
    return path.lower().endswith(MODELS)


def is_data(text: str) -> bool:
    """Whether a text is that of a file: legs have neither keys nor braces."""
    return is_xml(text) or _KEY.search(text) is not None


def is_xml(text: str) -> bool:
    """Whether a text is that of a model of links and joints."""
    return text.lstrip("\ufeff \t\r\n").startswith("<")


def _as_text(data: Mapping[str, Any]) -> str:
    """Data as the text of a file, in which faults have their places."""

    def plain(value: Any) -> Any:
        if isinstance(value, Fraction):
            return str(value)
        if isinstance(value, Mapping):
            return dict(value)
        if hasattr(value, "tolist"):  # arrays
            return value.tolist()
        if isinstance(value, Iterable):
            return list(value)
        raise InputError(f"data cannot hold {described(value)}", hint="texts, numbers, sequences and mappings")

    try:
        return json.dumps(plain(data), indent=1, ensure_ascii=False, default=plain)
    except (TypeError, ValueError) as fault:
        raise InputError(
            f"these are not the data of a file: {fault}", hint="texts, numbers, sequences, mappings"
        ) from None
