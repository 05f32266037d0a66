"""What is open in a pose of the page: its analysis, its file, its drawing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from gcrules.apps.studio.limbs import robot_drawing
from gcrules.apps.studio.moving import values_at
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject, Vector
from gcrules.apps.studio.whereabouts import at_home
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import pose_value
from gcrules.core.errors import InputError
from gcrules.core.yaml_file import read_text
from gcrules.mechanisms.description.discovery import examples
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.editing.platform_text import platform_text
from gcrules.views.drawing.drawing import Drawing
from gcrules.views.drawing.figures import robot_figure

__all__ = ["analysis_of", "analysis_there", "drawing_there", "file_there", "platform_there"]


def analysis_of(subject: Subject) -> Analysis:
    """That of its six lines. Raises InputError where it has none."""
    if subject.analysis is None:
        raise InputError("this robot's wrenches are not lines through its points: there is no analysis to take away")
    return subject.analysis


def analysis_there(subject: Subject, pose: PoseJson) -> Analysis:
    """The analysis with the platform where the pose has it; a sample shape that was not moved stays one."""
    a = analysis_of(subject)
    if subject.moving is None or (subject.invented and at_home(pose)):
        return a
    platform = platform_there(subject, pose)
    value = pose_value(a.structure, a.condition, platform.homogeneous(), unit=platform.units)
    return replace(a, platform=platform, pose=value)


def platform_there(subject: Subject, pose: PoseJson) -> Platform:
    """The platform as its file would have it. Raises InputError for robots that are no platforms on six legs."""
    moving, structure = subject.moving, analysis_of(subject).structure
    if moving is None:
        places: Mapping[str, Vector] = subject.points
    else:
        places = {n: _rounded(p) for n, p in moving.exact(exact_pose(pose)).items()}
    note = subject.note if not subject.invented else "a sample shape: the dimensions are invented"
    if not at_home(pose):
        note = " ".join(filter(None, [note, "In a pose of the studio."]))
    limits = subject.legs.limits if subject.legs else ""
    return Platform(structure.legs, places, subject.title, note, subject.unit, limits=limits)


def _rounded(p: tuple[Fraction, ...]) -> Vector:
    """Exact coordinates of a pose typed in decimals are long: twelve digits of them are kept."""
    x, y, z = (Fraction(f"{float(c):.12g}") for c in p[:3])
    return x, y, z


def drawing_there(subject: Subject, pose: PoseJson) -> Drawing:
    """The robot with the entities of its condition, or with its wrenches. Raises InputError."""
    if subject.limbs:
        return robot_drawing(subject.limbs.analysis, values_at(subject, pose))
    return robot_figure(analysis_there(subject, pose))


def file_there(subject: Subject, pose: PoseJson) -> str:
    """The file that was opened, as it is; else, and where the platform was moved, a platform file in the pose."""
    source = subject.source
    if at_home(pose) or subject.limbs:
        if subject.robot is not None and source["kind"] == "robot":
            return read_text(subject.robot.robot.filename)
        if source["kind"] == "file":
            return source["text"]
        if source["kind"] == "example":
            return examples()[source["name"]].read_text(encoding="utf-8")
    p = platform_there(subject, pose)
    return platform_text(p.title, p.note, p.units, p.legs, p.points, p.limits)
