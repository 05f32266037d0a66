"""What the command line or Python names, as a source that a page opens."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping

from gcrules.algebra.language.legs_text import Structure
from gcrules.apps.studio.protocol.requests import LONGEST_FILE, SourceJson
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import FileError, InputError
from gcrules.core.yaml_file import read_text as read_file
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.editing.platform_text import platform_text
from gcrules.mechanisms.load import LOADED, Folders, Loaded, Source, is_data, kind_of, load, read_text
from gcrules.mechanisms.robot import Robot

__all__ = ["source_of", "source_of_word"]


def source_of(source: Source, mode: str | None = None, plugins: Folders = ()) -> SourceJson:
    """The source of anything that `load` takes, in a working or an assembly mode. Raises GcrulesError."""
    if isinstance(source, os.PathLike):
        source = os.fspath(source)
    if isinstance(source, str) and not plugins:
        return source_of_word(source, mode)
    return _checked(_of_loaded(source if isinstance(source, LOADED) else load(source, plugins=plugins)), mode)


def source_of_word(word: str, mode: str | None = None, stdin: Callable[[], str] | None = None) -> SourceJson:
    """The source that a word means: a file, an id, or legs; "-" is standard input where there is one. Raises
    GcrulesError.
    """
    if word == "-" and stdin is not None:
        text = stdin()
        return _checked(_file(text, "<stdin>") if is_data(text) else {"kind": "legs", "legs": text}, mode)
    kind = kind_of(word)
    if kind == "text":
        return _checked(_file(word, "<input>"), mode)
    if kind == "file":
        return _checked(_file(read_file(word), os.path.basename(word)), mode)
    return _checked(_NAMED[kind](word), mode)


_NAMED: Mapping[str, Callable[[str], SourceJson]] = {
    "class": lambda word: {"kind": "class", "id": word},
    "robot": lambda word: {"kind": "robot", "id": word},
    "example": lambda word: {"kind": "example", "name": word},
    "legs": lambda word: {"kind": "legs", "legs": word},
}
"""How a page names a source of each kind."""


def _checked(source: SourceJson, mode: str | None) -> SourceJson:
    if mode is not None:
        if source["kind"] != "robot" and source["kind"] != "file":
            raise InputError(
                "modes are for robots, and for platforms with coordinates",
                hint="give the id of one, such as delta, or a robot file",
            )
        source["mode"] = mode
    if source["kind"] == "file" and len(source["text"]) > LONGEST_FILE:
        raise FileError(f"the file has more than {LONGEST_FILE:,} characters", filename=source["name"])
    return source


def _file(text: str, name: str) -> SourceJson:
    return {"kind": "file", "text": text, "name": name}


def _of_loaded(loaded: Loaded) -> SourceJson:
    if isinstance(loaded, (Robot, RobotAnalysis)):
        return _of_robot(loaded.robot if isinstance(loaded, RobotAnalysis) else loaded)
    given = loaded.platform or loaded.structure if isinstance(loaded, Analysis) else loaded
    if isinstance(given, Platform):
        text = platform_text(given.title, given.note, given.units, given.legs, given.points, given.limits)
        return _file(text, "platform.yaml")
    assert isinstance(given, Structure)
    if given.ideal or given.given or given.rank != 4:
        raise InputError("the studio opens legs without assumptions", hint="give the legs alone")
    return {"kind": "legs", "legs": given.text()}


def _of_robot(robot: Robot) -> SourceJson:
    """The file of a robot. Raises InputError for one whose home is another one than there."""
    name = os.path.basename(robot.filename) if not robot.filename.startswith("<") else "robot.yaml"
    again = read_text(robot.text, name) if robot.text else None
    if not isinstance(again, Robot) or again.home != robot.home:
        raise InputError(
            f"{robot.title} is not as in a file of its own", hint="give the name of its file, and the mode beside it"
        )
    return _file(robot.text, name)
