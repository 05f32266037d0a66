"""What answers each method: a function of the subject and the arguments. How far it is it reports to its budget."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.values import VALUES, value
from gcrules.core.deferred import resolved
from gcrules.views.detail import without_options

__all__ = ["ANSWERS", "answer", "loading"]

Args = Mapping[str, Any]

ANSWERS: Mapping[str, tuple[str, Callable[[Any, Any, Args], Any]]] = {
    "gallery": (
        "gcrules.apps.studio.gallery:gallery",
        lambda show, subject, args: show(),
    ),
    "open": (
        "gcrules.apps.studio.study:study",
        lambda show, subject, args: show(subject),
    ),
    "pose": (
        "gcrules.apps.studio.numbers:numbers",
        lambda show, subject, args: show(subject, args["pose"], args.get("threshold")),
    ),
    "move": (
        "gcrules.apps.studio.whereabouts:moved_view",
        lambda show, subject, args: show(subject, args["pose"], args.get("at"), args.get("to")),
    ),
    "along": (
        "gcrules.apps.studio.numbers:margins",
        lambda show, subject, args: show(subject, args["poses"], args.get("threshold")),
    ),
    "nearest": (
        "gcrules.apps.studio.nearest_view:nearest",
        lambda show, subject, args: show(subject, args["pose"], args.get("threshold")),
    ),
    "modes": (
        "gcrules.apps.studio.modes_view:modes_view",
        lambda show, subject, args: show(subject, args.get("threshold")),
    ),
    "path": (
        "gcrules.apps.studio.path_view:path_view",
        lambda show, subject, args: show(subject, value("path", subject, args)),
    ),
    "waypoints": (
        "gcrules.apps.studio.waypoints_view:waypoints_view",
        lambda show, subject, args: show(subject, args.get("poses"), args.get("table")),
    ),
    "map": (
        "gcrules.apps.studio.map_view:map_view",
        lambda show, subject, args: show(value("map", subject, args)),
    ),
    "surface": (
        "gcrules.apps.studio.surface_view:surface_view",
        lambda show, subject, args: show(value("surface", subject, args)),
    ),
    "place": (
        "gcrules.apps.studio.map_view:place_view",
        lambda show, subject, args: show(subject, args["over"], args["pose"], args["place"]),
    ),
    "here": (
        "gcrules.apps.studio.map_view:here_view",
        lambda show, subject, args: show(subject, args["over"], args["pose"]),
    ),
    "locus": (
        "gcrules.apps.studio.locus_view:locus_view",
        lambda show, subject, args: show(subject, value("locus", subject, args), args["pose"], args.get("over")),
    ),
    "assemblies": (
        "gcrules.apps.studio.where_view:assemblies_view",
        lambda show, subject, args: show(subject, value("assemblies", subject, args)),
    ),
    "aspects": (
        "gcrules.apps.studio.where_view:aspects_view",
        lambda show, subject, args: show(subject, value("aspects", subject, args)),
    ),
    "free": (
        "gcrules.apps.studio.where_view:free_view",
        lambda show, subject, args: show(value("free", subject, args)),
    ),
    "boxes": (
        "gcrules.apps.studio.boxes_view:boxes_view",
        lambda show, subject, args: show(value("boxes", subject, args)),
    ),
    "certify": (
        "gcrules.apps.studio.certificate_view:certificate_view",
        lambda show, subject, args: show(subject, value("certify", subject, args)),
    ),
    "certificate": (
        "gcrules.apps.studio.certificate_file:certificate_file",
        lambda show, subject, args: show(subject, args["what"], args["args"]),
    ),
    "manual": (
        "gcrules.apps.studio.manual_replay:replayed",
        lambda show, subject, args: show(subject, args["commands"]),
    ),
    "bench": (
        "gcrules.apps.studio.bench:bench",
        lambda show, subject, args: show(
            args["text"], subject, args.get("pose"), args.get("rules", ()), args.get("folders", ())
        ),
    ),
    "rules": (
        "gcrules.apps.studio.rule_files:checked_view",
        lambda show, subject, args: show(args["files"]),
    ),
    "plugins": (
        "gcrules.apps.studio.plugins_view:plugins_view",
        lambda show, subject, args: show(args["folders"]),
    ),
    "complete": (
        "gcrules.apps.studio.bench_text:completed",
        lambda show, subject, args: show(args["text"], subject),
    ),
    "script": (
        "gcrules.apps.studio.bench_text:scripted",
        lambda show, subject, args: show(args["text"], subject),
    ),
    "compose": (
        "gcrules.apps.studio.composing:composed",
        lambda show, subject, args: show(args["drawing"]),
    ),
    "limbs": (
        "gcrules.apps.studio.limb_editor:limbs_answer",
        lambda show, subject, args: show(
            args.get("text"), args.get("start"), args.get("edit"), plane=args.get("plane", False)
        ),
    ),
    "repeat": (
        "gcrules.apps.studio.repeating:repeated",
        lambda show, subject, args: show(subject, args["what"], args["args"], args.get("folders", ())),
    ),
    "resize": (
        "gcrules.apps.studio.resizing:resized",
        lambda show, subject, args: show(subject, args["points"], args.get("limits")),
    ),
    "save": (
        "gcrules.apps.studio.export:saved",
        lambda show, subject, args: show(
            subject, args["pose"], args["what"], args.get("threshold"), args.get("state"), args.get("folders", ())
        ),
    ),
}
"""Of each method the function that answers it, which is loaded with the first such request unless `loading` was
quicker, and how it is called with a subject and the arguments.
"""


def answer(name: str, subject: Subject | None, args: Args) -> Any:
    """The result of a method whose arguments were checked; `subject` is that of their source, if they have one."""
    where, call = ANSWERS[name]
    with without_options():
        return call(resolved(where), subject, args)


def loading() -> Iterator[None]:
    """Load all that answers, before it is asked, one function after the other."""
    for where, _ in (*ANSWERS.values(), *VALUES.values()):
        resolved(where)
        yield
