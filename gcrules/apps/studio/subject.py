"""What is studied: a source that a page names, read and analysed, with coordinates and what moves."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from gcrules.algebra.language.legs_text import Structure, legs_text, read_legs
from gcrules.apps.studio.protocol.requests import (
    ClassSource,
    ExampleSource,
    FileSource,
    LegsSource,
    RobotSource,
    SourceJson,
)
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.core.yaml_file import read_text as read_file
from gcrules.mechanisms.analyze import analyze_legs, analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.kinematics.linkage import Linkage, linkage
from gcrules.mechanisms.limbs import feet_of
from gcrules.mechanisms.load import is_data, kind_of, read_class, read_example, read_robot, read_text
from gcrules.mechanisms.moving_platform import MovingPlatform, rig
from gcrules.mechanisms.robot import Robot
from gcrules.screws import RATIONALS
from gcrules.views.drawing.sample import sample_coordinates
from gcrules.views.report.scene_json import Scenery, drawable

__all__ = ["Subject", "read_subject", "source_of"]

Vector = tuple[Fraction, Fraction, Fraction]

SEARCH = 10.0
"""Seconds for which a factorization is sought where no rule finds a condition."""


@dataclass(frozen=True)
class Subject:
    """A structure with its analysis and coordinates.

    `points` are the finite places of all joints in the pose of the file (`invented` where none were given); `moving` is
    None where the platform's numbers cannot be told, `why_not` then says why. A robot of limbs has `robot`, with
    `points` for all its named points at home; `analysis` is that of its equivalent lines, None where there are none.
    """

    source: SourceJson
    title: str
    analysis: Analysis | None
    points: Mapping[str, Vector]
    note: str = ""
    unit: str = ""
    invented: bool = False
    scenery: Scenery | None = None
    moving: MovingPlatform | None = None
    why_not: str = ""
    robot: RobotAnalysis | None = None

    @property
    def limbed(self) -> bool:
        """Whether the page shows limbs, and moves their joints."""
        return self.robot is not None and self.scenery is None

    @cached_property
    def structure(self) -> Structure | None:
        return self.analysis.structure if self.analysis else None

    @cached_property
    def size(self) -> float:
        """The root-mean-square distance of the points from their centroid."""
        middle = self._middle(list(self.points))
        square = [sum((float(c) - m) ** 2 for c, m in zip(p, middle, strict=True)) for p in self.points.values()]
        return (sum(square) / len(square)) ** 0.5 or 1.0

    @cached_property
    def about(self) -> list[float]:
        """The point that the platform turns about."""
        if self.scenery:
            return [float(c) for c in self.scenery.about]
        return self._middle(list(self.body) or list(self.points))

    @cached_property
    def home(self) -> dict[str, list[float]]:
        """Coordinates of all points and directions of a robot at home."""
        assert self.robot is not None
        return {n: [float(c) for c in v] for n, v in _values(self.robot.robot).items()}

    @cached_property
    def linkage(self) -> Linkage:
        """The joints that move a robot with limbs. Raises InputError where they do not."""
        assert self.robot is not None
        return linkage(self.robot.robot)

    @property
    def feet(self) -> tuple[str, ...]:
        """The points of the base."""
        if self.limbed and self.robot is not None:
            return tuple(n for n in feet_of(self.robot.robot) if n in self.points)
        return self.structure.base if self.structure else ()

    @property
    def body(self) -> tuple[str, ...]:
        """The points that move with the platform."""
        if self.limbed and self.robot is not None:
            return tuple(n for n in self.robot.robot.platform if n in self.points)
        return self.structure.platform if self.structure else ()

    def _middle(self, names: list[str]) -> list[float]:
        return [sum(float(self.points[n][i]) for n in names) / len(names) for i in range(3)]


def read_subject(source: SourceJson) -> Subject:
    """Read and analyse a source. Raises GcrulesError for what cannot be read."""
    return _READERS[source["kind"]](source)


def source_of(word: str, stdin: Callable[[], str]) -> SourceJson:
    """The source that a word on the command line means, as a page names it. Raises GcrulesError."""
    if word == "-":
        text = stdin()
        return {"kind": "file", "text": text, "name": "<stdin>"} if is_data(text) else {"kind": "legs", "legs": text}
    kind = kind_of(word)
    if kind in ("file", "text"):
        text = word if kind == "text" else read_file(word)
        return {"kind": "file", "text": text, "name": "<input>" if kind == "text" else os.path.basename(word)}
    return _NAMED[kind](word)


# --- kinds of sources ----------------------------------------------------------------------------------------------


def _of_class(source: ClassSource) -> Subject:
    entry = read_class(source["id"])
    title = f"Class {entry.id}" + (f", {entry.name}" if entry.name else "")
    return _of_legs_alone(source, read_legs(legs_text(entry.legs)), title, entry.note or "")


def _of_legs(source: LegsSource) -> Subject:
    structure = read_legs(source["legs"])
    return _of_legs_alone(source, structure, f"Legs {structure.text()}")


def _of_example(source: ExampleSource) -> Subject:
    return _of_loaded(source, read_example(source["name"]))


def _of_robot(source: RobotSource) -> Subject:
    known = {one.id: one for one in robots()}  # a path is no id: the page opens no files
    if source["id"] not in known:
        raise InputError(f"there is no robot {source['id'][:40]!r}", hint=near(source["id"], known))
    return _of_loaded(source, read_robot(known[source["id"]].path))


def _of_file(source: FileSource) -> Subject:
    text, name = source["text"], source["name"]
    try:
        return _of_loaded(source, read_text(text, name))
    except GcrulesError as fault:
        raise fault.located(text, name, Span(0, 1)) if fault.source is None else fault from None


_READERS: Mapping[str, Callable[[Any], Subject]] = {
    "class": _of_class,
    "legs": _of_legs,
    "example": _of_example,
    "robot": _of_robot,
    "file": _of_file,
}
_NAMED: Mapping[str, Callable[[str], SourceJson]] = {
    "class": lambda word: {"kind": "class", "id": word},
    "robot": lambda word: {"kind": "robot", "id": word},
    "example": lambda word: {"kind": "example", "name": word},
    "legs": lambda word: {"kind": "legs", "legs": word},
}
"""How a page names a source of each kind."""


# --- reading -------------------------------------------------------------------------------------------------------


def _of_loaded(source: SourceJson, loaded: Platform | Robot) -> Subject:
    return _of_limbs(source, loaded) if isinstance(loaded, Robot) else _of_platform(source, loaded)


def _of_platform(source: SourceJson, given: Platform, robot: RobotAnalysis | None = None) -> Subject:
    analysis = analyze_legs(given, search=SEARCH)
    note = " ".join(filter(None, [given.note, *given.warnings]))
    points = {n: given.points[n] for n in analysis.structure.names}
    found = Subject(source, given.title, analysis, FrozenMap(points), note, given.units, robot=robot)
    return _with_rig(found, analysis.structure, given)


def _of_legs_alone(source: SourceJson, structure: Structure, title: str, note: str = "") -> Subject:
    analysis = analyze_legs(structure, search=SEARCH)
    shape = sample_coordinates(structure.oriented, structure.base, structure.platform)
    points = {n: _exact(p) for n, p in shape.items()}
    given = Platform(structure.legs, points, title, filename="sample.yaml")
    found = Subject(source, title, analysis, FrozenMap(points), note, invented=True)
    return _with_rig(found, structure, given)


def _with_rig(subject: Subject, structure: Structure, given: Platform) -> Subject:
    assert subject.analysis is not None
    if drawable(subject.analysis):
        subject = replace(subject, scenery=Scenery.of(subject.analysis))
    try:
        return replace(subject, moving=rig(structure, given, "centroid"))
    except InputError as fault:
        return replace(subject, why_not=fault.message)


def _of_limbs(source: SourceJson, robot: Robot) -> Subject:
    """A robot; one whose limbs are six legs between joints that stay and joints of the platform moves as a platform."""
    found = analyze_robot(robot, search=SEARCH)
    told = (robot.note, robot.source and f"Source: {robot.source}")
    note = " ".join(f"{words.rstrip('.')}." for words in told if words)
    try:
        platform = replace(as_platform(robot), note=note)
    except InputError:  # its limbs are others
        home = {n: _vector(v) for n, v in _values(robot).items() if robot.family.sorts.get(n) == "point"}
        return Subject(source, robot.title, found.lines, FrozenMap(home), note, robot=found)
    return _of_platform(source, platform, found)


def _values(robot: Robot) -> Mapping[str, tuple[Fraction, ...]]:
    """Coordinates at home; of some member of the family where the file gives no home."""
    return robot.values_at() if robot.home is not None else robot.family.member(1, RATIONALS)


def _exact(p: tuple[float, float, float]) -> Vector:
    x, y, z = (Fraction(repr(c)) for c in p)
    return x, y, z


def _vector(v: tuple[Fraction, ...]) -> Vector:
    x, y, z = map(Fraction, v)
    return x, y, z
