"""A platform with other dimensions, as a file that the page opens in its place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.apps.studio.export import saved
from gcrules.apps.studio.protocol.answer_views import Resized
from gcrules.apps.studio.protocol.requests import HOME
from gcrules.apps.studio.subject import Subject
from gcrules.core.errors import InputError
from gcrules.mechanisms.editing.platform_text import with_dimensions

__all__ = ["resized"]


def resized(subject: Subject, points: Mapping[str, Sequence[str]], limits: str | None) -> Resized:
    """The file with these coordinates of points, and with these limits of legs. Raises InputError for a robot that is
    described by its joints, and GcrulesError with the faults of what comes of it.
    """
    if subject.robot is not None or subject.legs is None:
        raise InputError("the dimensions of a robot described by its joints are those of its points at home")
    given = saved(subject, HOME, "yaml", None)
    source = subject.source
    mode = source.get("mode") if source["kind"] == "file" else None
    if mode is not None:
        raise InputError("the platform stands in an assembly mode", hint="open its file without one")
    return {
        "source": {
            "kind": "file",
            "text": with_dimensions(given["data"], given["name"], points, limits),
            "name": given["name"],
        }
    }
