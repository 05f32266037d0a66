"""What can be taken away: the report, the derivation, figures, data, the file of the robot."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Mapping
from dataclasses import replace
from fractions import Fraction

from gcrules.apps.studio.limbs import robot_drawing
from gcrules.apps.studio.moving import values_at
from gcrules.apps.studio.numbers import exact_pose, numbers
from gcrules.apps.studio.protocol.answer_views import Saved
from gcrules.apps.studio.protocol.requests import Format, PoseJson
from gcrules.apps.studio.subject import Subject, Vector
from gcrules.apps.studio.whereabouts import at_home
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import pose_value
from gcrules.core.errors import InputError
from gcrules.core.files import file_name
from gcrules.core.yaml_file import read_text
from gcrules.mechanisms.description.discovery import examples
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.editing.platform_text import platform_text
from gcrules.poses.compiling.controller import controller_of
from gcrules.views.code.source_code import source_code
from gcrules.views.drawing.drawing import Drawing
from gcrules.views.drawing.drawing_files import pdf_bytes
from gcrules.views.drawing.figures import robot_figure
from gcrules.views.report.report import report

__all__ = ["saved"]

Bytes = Callable[[Subject, PoseJson, str | None], str | bytes]


def saved(subject: Subject, pose: PoseJson, what: Format, threshold: str | None) -> Saved:
    """A file in this format. Raises InputError where the subject has none."""
    mime, make = _MAKERS[what]
    found = make(subject, pose, threshold)
    binary = isinstance(found, bytes)
    data = base64.b64encode(found).decode() if isinstance(found, bytes) else found
    ending = "tex" if what == "latex" else what
    return {"name": file_name(subject.title, ending), "mime": mime, "data": data, "binary": binary}


# --- the analysis at the pose --------------------------------------------------------------------------------------


def _analysis(subject: Subject) -> Analysis:
    if subject.analysis is None:
        raise InputError("this robot's wrenches are no lines of its points: there is no analysis to take away")
    return subject.analysis


def _posed(subject: Subject, pose: PoseJson) -> Analysis:
    """The analysis with the platform where the pose has it; a sample shape that was not moved stays one."""
    a = _analysis(subject)
    if subject.moving is None or (subject.invented and at_home(pose)):
        return a
    platform = _platform(subject, pose)
    value = pose_value(a.structure, a.condition, platform.homogeneous(), unit=platform.units)
    return replace(a, platform=platform, pose=value)


def _platform(subject: Subject, pose: PoseJson) -> Platform:
    moving, structure = subject.moving, _analysis(subject).structure
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


# --- formats -------------------------------------------------------------------------------------------------------


def _html(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return report(subject.limbs.analysis if subject.limbs else _posed(subject, pose))


def _latex(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return subject.robot.latex() if subject.robot else _posed(subject, pose).latex()


def _drawing(subject: Subject, pose: PoseJson) -> Drawing:
    if subject.limbs:
        return robot_drawing(subject.limbs.analysis, values_at(subject, pose))
    return robot_figure(_posed(subject, pose))


def _svg(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return _drawing(subject, pose).svg()


def _pdf(subject: Subject, pose: PoseJson, threshold: str | None) -> bytes:
    return pdf_bytes(_drawing(subject, pose))


def _png(subject: Subject, pose: PoseJson, threshold: str | None) -> bytes:
    raise InputError("a PNG picture is taken of the view itself", hint="the page makes it; or take SVG, PDF")


def _json(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    found = (subject.robot or _analysis(subject)).to_json()
    here = numbers(subject, pose, threshold)
    return json.dumps({**found, "studio_pose": here}, indent=2, ensure_ascii=False) + "\n"


def _yaml(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    """The file that was opened, as it is; else, and where the platform was moved, a platform file in the pose."""
    source = subject.source
    if at_home(pose) or subject.limbs:
        if subject.robot is not None and source["kind"] == "robot":
            return read_text(subject.robot.robot.filename)
        if source["kind"] == "file":
            return source["text"]
        if source["kind"] == "example":
            return examples()[source["name"]].read_text(encoding="utf-8")
    p = _platform(subject, pose)
    return platform_text(p.title, p.note, p.units, p.legs, p.points, p.limits)


def _code(language: str) -> Bytes:
    """Factors, margin and inverse kinematics for a controller, from home; they are the same for every pose."""

    def make(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
        return source_code(controller_of(subject.mechanism), language)

    return make


_MAKERS: Mapping[Format, tuple[str, Bytes]] = {
    "html": ("text/html", _html),
    "latex": ("application/x-tex", _latex),
    "svg": ("image/svg+xml", _svg),
    "pdf": ("application/pdf", _pdf),
    "png": ("image/png", _png),
    "json": ("application/json", _json),
    "yaml": ("application/yaml", _yaml),
    "c": ("text/plain", _code("c")),
    "cpp": ("text/plain", _code("cpp")),
    "py": ("text/plain", _code("python")),
    "rs": ("text/plain", _code("rust")),
}
