"""What is studied: a source that a page names, read and analysed, with coordinates and what moves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any

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
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.mechanisms.analyze import analyze_legs, analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import is_xml, read_class, read_example, read_robot, read_text
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.mechanisms.robot import Robot
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.screws import RATIONALS
from gcrules.views.drawing.sample import sample_coordinates
from gcrules.views.report.scene_json import Scenery

if TYPE_CHECKING:
    from gcrules.mechanisms.models.imported import Imported

__all__ = ["Subject", "read_subject", "robot_of"]

in_mode = deferred("gcrules.poses.modes.choose:in_mode")
import_text = deferred("gcrules.mechanisms.models.importing:import_text")

Vector = tuple[Fraction, Fraction, Fraction]

SEARCH = 10.0
"""Seconds for which a factorization is sought where no rule finds a condition."""


@dataclass(frozen=True)
class Subject:
    """What a source says as a mechanism, with its analysis; legs alone have a shape that was `invented` for them.

    `robot` is the analysis of what its joints describe, though it may move as a platform on six legs; `model` says how
    it was read from a model of links and joints.
    """

    source: SourceJson
    mechanism: SixLegs | Limbs
    note: str = ""
    invented: bool = False
    robot: RobotAnalysis | None = None
    model: Imported | None = None

    @property
    def legs(self) -> SixLegs | None:
        return self.mechanism if isinstance(self.mechanism, SixLegs) else None

    @property
    def limbs(self) -> Limbs | None:
        """A robot of which the page shows limbs, and moves their joints."""
        return self.mechanism if isinstance(self.mechanism, Limbs) else None

    @property
    def title(self) -> str:
        return self.mechanism.title

    @property
    def unit(self) -> str:
        return self.mechanism.unit

    @cached_property
    def analysis(self) -> Analysis | None:
        """That of its six lines, if there are any."""
        found = self.mechanism.analysis
        return found.lines if isinstance(found, RobotAnalysis) else found

    @cached_property
    def structure(self) -> Structure | None:
        return self.analysis.structure if self.analysis else None

    @cached_property
    def scenery(self) -> Scenery | None:
        return None if self.limbs or self.analysis is None else Scenery.of(self.analysis)

    @cached_property
    def points(self) -> Mapping[str, Vector]:
        """The finite places of all joints in the pose of the file; of all named points of a robot at home."""
        if self.legs:
            return FrozenMap({n: self.legs.platform.points[n] for n in self.legs.analysis.structure.names})
        assert self.robot is not None
        sorts = self.robot.robot.family.sorts
        return FrozenMap({n: _vector(v) for n, v in _values(self.robot.robot).items() if sorts.get(n) == "point"})

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
        with suppress(InputError):  # of a robot that cannot be moved
            if self.limbs:
                m = self.limbs.linkage
                return [float(c) + float(o) for c, o in zip(m.centre, m.origin, strict=True)]
        return self._middle(list(self.mechanism.bodies["platform"]) or list(self.points))

    @cached_property
    def home(self) -> dict[str, list[float]]:
        """Coordinates of all points and directions of a robot at home."""
        assert self.robot is not None
        return {n: [float(c) for c in v] for n, v in _values(self.robot.robot).items()}

    @cached_property
    def _rig(self) -> MovingPlatform | str:
        try:
            return self.legs.rig if self.legs else ""
        except InputError as fault:
            return fault.message

    @property
    def moving(self) -> MovingPlatform | None:
        """The platform as it moves; None where its numbers cannot be told, `why_not` then says why."""
        return None if isinstance(self._rig, str) else self._rig

    @property
    def why_not(self) -> str:
        return self._rig if isinstance(self._rig, str) else ""

    def _middle(self, names: list[str]) -> list[float]:
        return [sum(float(self.points[n][i]) for n in names) / len(names) for i in range(3)]


def read_subject(source: SourceJson) -> Subject:
    """Read and analyse a source. Raises GcrulesError for what cannot be read."""
    return _READERS[source["kind"]](source)


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
    return _of_loaded(source, _known(source["id"]), source.get("mode"))


def _known(name: str) -> Robot:
    known = {one.id: one for one in robots()}  # a path is no id: the page opens no files
    if name not in known:
        raise InputError(f"there is no robot {name[:40]!r}", hint=near(name, known))
    return read_robot(known[name].path)


def _of_file(source: FileSource) -> Subject:
    text, name = source["text"], source["name"]
    try:
        if is_xml(text):
            found = import_text(text, name)
            return replace(_of_loaded(source, found.robot, source.get("mode")), model=found)
        return _of_loaded(source, read_text(text, name), source.get("mode"))
    except GcrulesError as fault:
        raise fault.located(text, name, Span(0, 1)) if fault.source is None else fault from None


def robot_of(source: SourceJson) -> Robot:
    """The robot of joints that a source names, with the home of its file whatever mode is open. Raises InputError for
    other sources.
    """
    found: Platform | Robot | None = _known(source["id"]) if source["kind"] == "robot" else None
    if source["kind"] == "file":
        found = read_text(source["text"], source["name"])
    if not isinstance(found, Robot):
        raise InputError("this is not a robot of joints")
    return found


_READERS: Mapping[str, Callable[[Any], Subject]] = {
    "class": _of_class,
    "legs": _of_legs,
    "example": _of_example,
    "robot": _of_robot,
    "file": _of_file,
}

# --- reading -------------------------------------------------------------------------------------------------------


def _of_loaded(source: SourceJson, loaded: Platform | Robot, mode: str | None = None) -> Subject:
    if mode is not None:
        loaded = in_mode(loaded, mode)
    if isinstance(loaded, Robot):
        return _of_limbs(source, loaded)
    note = " ".join(filter(None, [loaded.note, *loaded.warnings]))
    return Subject(source, SixLegs(loaded, analysed=analyze_legs(loaded, search=SEARCH)), note)


def _of_legs_alone(source: SourceJson, structure: Structure, title: str, note: str = "") -> Subject:
    analysis = analyze_legs(structure, search=SEARCH)
    shape = sample_coordinates(structure.oriented, structure.base, structure.platform)
    platform = Platform(structure.legs, {n: _exact(p) for n, p in shape.items()}, title, filename="sample.yaml")
    return Subject(source, SixLegs(platform, analysed=analysis), note, invented=True)


def _of_limbs(source: SourceJson, robot: Robot) -> Subject:
    """A robot; one whose limbs are six legs between joints that stay and joints of the platform moves as a platform."""
    found = Limbs.of(analyze_robot(robot, search=SEARCH, facts=True))
    told = (robot.note, robot.source and f"Source: {robot.source}")
    note = " ".join(f"{words.rstrip('.')}." for words in told if words)
    try:
        return Subject(source, found.six_legs(), note, robot=found.analysis)
    except InputError:  # its limbs are others
        return Subject(source, found, note, robot=found.analysis)


def _values(robot: Robot) -> Mapping[str, tuple[Fraction, ...]]:
    """Coordinates at home; of some member of the family where the file gives no home."""
    return robot.values_at() if robot.home is not None else robot.family.member(1, RATIONALS)


def _exact(p: tuple[float, float, float]) -> Vector:
    x, y, z = (Fraction(repr(c)) for c in p)
    return x, y, z


def _vector(v: tuple[Fraction, ...]) -> Vector:
    x, y, z = map(Fraction, v)
    return x, y, z
