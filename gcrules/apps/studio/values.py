"""What the panels of the page answer as values of the library, which reports show too."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from gcrules.apps.studio.subject import Subject
from gcrules.core.deferred import resolved

__all__ = ["VALUES", "value"]

Args = Mapping[str, Any]


def _of_boxes(args: Args) -> tuple[Any, ...]:
    return args["over"], args["pose"], args.get("margin", 0.0), args.get("limits"), args["boxes"]


VALUES: Mapping[str, tuple[str, Callable[[Any, Subject, Args], Any]]] = {
    "path": (
        "gcrules.apps.studio.path_view:way_of",
        lambda compute, subject, args: compute(
            subject,
            args.get("start"),
            args["goal"],
            args.get("to"),
            args.get("threshold"),
            around=args.get("way") == "around",
            through=args.get("through", ()),
        ),
    ),
    "map": (
        "gcrules.apps.studio.map_view:map_of",
        lambda compute, subject, args: compute(
            subject, args["over"], args["pose"], args.get("threshold"), args.get("measure")
        ),
    ),
    "surface": (
        "gcrules.apps.studio.surface_view:surface_of",
        lambda compute, subject, args: compute(subject, args["over"], args["pose"]),
    ),
    "locus": (
        "gcrules.apps.studio.locus_view:locus_at",
        lambda compute, subject, args: compute(subject, args["pose"], args.get("over")),
    ),
    "assemblies": (
        "gcrules.apps.studio.where_view:assemblies_from",
        lambda compute, subject, args: compute(subject, args["pose"], args.get("threshold")),
    ),
    "aspects": (
        "gcrules.apps.studio.where_view:aspects_from",
        lambda compute, subject, args: compute(subject),
    ),
    "free": (
        "gcrules.apps.studio.where_view:free_around",
        lambda compute, subject, args: compute(subject, args["pose"], args["shape"]),
    ),
    "boxes": (
        "gcrules.apps.studio.boxes_view:boxes_of",
        lambda compute, subject, args: compute(subject, *_of_boxes(args)),
    ),
    "certify": (
        "gcrules.apps.studio.certificate_view:certificate_of",
        lambda compute, subject, args: compute(subject, *_of_boxes(args), cone=args.get("cone"), tilt=args.get("tilt")),
    ),
}
"""Of each such method the function that computes it, loaded with the first such request, and how it is called."""


def value(name: str, subject: Subject, args: Args) -> Any:
    """What a method whose arguments were checked finds out. Raises GcrulesError as that function does."""
    where, call = VALUES[name]
    return call(resolved(where), subject, args)
