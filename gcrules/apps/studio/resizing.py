"""A robot with other dimensions, as a file that the page opens in its place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.apps.studio.export import saved
from gcrules.apps.studio.protocol.answer_views import Resized
from gcrules.apps.studio.protocol.requests import HOME
from gcrules.apps.studio.subject import Subject, robot_of
from gcrules.core.errors import InputError
from gcrules.core.files import file_name
from gcrules.mechanisms.editing.platform_text import with_dimensions
from gcrules.mechanisms.editing.robot_text import home_changed

__all__ = ["resized"]


def resized(subject: Subject, points: Mapping[str, Sequence[str]], limits: str | None) -> Resized:
    """The file with these coordinates of points and directions at home, and with these limits of legs or actuators.
    Raises GcrulesError with the faults of what comes of it.
    """
    source = subject.source
    mode = source.get("mode") if source["kind"] in ("file", "robot") else None
    if mode is not None:
        raise InputError("the robot stands in an assembly mode", hint="open its file without one")
    if subject.robot is not None:
        name = file_name(subject.title, "yaml")
        text = home_changed(robot_of(source).text, name, points, limits)
    else:
        given = saved(subject, HOME, "yaml", None)
        name, text = given["name"], with_dimensions(given["data"], given["name"], points, limits)
    return {"source": {"kind": "file", "text": text, "name": name}}
