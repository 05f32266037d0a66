"""What answers each method: a function of the subject and the arguments. How far it is it reports to its budget."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from gcrules.apps.studio.bench import bench
from gcrules.apps.studio.bench_text import completed, scripted
from gcrules.apps.studio.boxes_view import boxes_view
from gcrules.apps.studio.certificate_view import certificate_view
from gcrules.apps.studio.composing import composed
from gcrules.apps.studio.export import saved
from gcrules.apps.studio.gallery import gallery
from gcrules.apps.studio.limb_editor import limbs_answer
from gcrules.apps.studio.locus_view import locus_view
from gcrules.apps.studio.manual_replay import replayed
from gcrules.apps.studio.map_view import map_view, place_view
from gcrules.apps.studio.modes_view import modes_view
from gcrules.apps.studio.nearest_view import nearest
from gcrules.apps.studio.numbers import margins, numbers
from gcrules.apps.studio.path_view import path_view
from gcrules.apps.studio.plugins_view import plugins_view
from gcrules.apps.studio.repeating import repeated
from gcrules.apps.studio.resizing import resized
from gcrules.apps.studio.rule_files import checked_view
from gcrules.apps.studio.study import study
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.surface_view import surface_view
from gcrules.apps.studio.waypoints_view import waypoints_view
from gcrules.apps.studio.where_view import aspects_view, assemblies_view, free_view
from gcrules.apps.studio.whereabouts import moved_view

__all__ = ["ANSWERS", "answer"]

Args = Mapping[str, Any]

ANSWERS: Mapping[str, Callable[[Any, Args], Any]] = {
    "gallery": lambda subject, args: gallery(),
    "open": lambda subject, args: study(subject),
    "pose": lambda subject, args: numbers(subject, args["pose"], args.get("threshold")),
    "move": lambda subject, args: moved_view(subject, args["pose"], args.get("at"), args.get("to")),
    "along": lambda subject, args: margins(subject, args["poses"], args.get("threshold")),
    "nearest": lambda subject, args: nearest(subject, args["pose"], args.get("threshold")),
    "modes": lambda subject, args: modes_view(subject, args.get("threshold")),
    "path": lambda subject, args: path_view(
        subject,
        args.get("start"),
        args["goal"],
        args.get("to"),
        args.get("threshold"),
        around=args.get("way") == "around",
        through=args.get("through", ()),
    ),
    "waypoints": lambda subject, args: waypoints_view(subject, args.get("poses"), args.get("table")),
    "map": lambda subject, args: map_view(
        subject, args["over"], args["pose"], args.get("threshold"), args.get("measure")
    ),
    "surface": lambda subject, args: surface_view(subject, args["over"], args["pose"]),
    "place": lambda subject, args: place_view(subject, args["over"], args["pose"], args["place"]),
    "locus": lambda subject, args: locus_view(subject, args["pose"], args.get("over")),
    "assemblies": lambda subject, args: assemblies_view(subject, args["pose"], args.get("threshold")),
    "aspects": lambda subject, args: aspects_view(subject),
    "free": lambda subject, args: free_view(subject, args["pose"], args["shape"]),
    "boxes": lambda subject, args: boxes_view(
        subject, args["over"], args["pose"], args.get("margin", 0.0), args.get("limits"), args["boxes"]
    ),
    "certify": lambda subject, args: certificate_view(
        subject,
        args["over"],
        args["pose"],
        args.get("margin", 0.0),
        args.get("limits"),
        args["boxes"],
        cone=args.get("cone"),
        tilt=args.get("tilt"),
    ),
    "manual": lambda subject, args: replayed(subject, args["commands"]),
    "bench": lambda subject, args: bench(
        args["text"], subject, args.get("pose"), args.get("rules", ()), args.get("folders", ())
    ),
    "rules": lambda subject, args: checked_view(args["files"]),
    "plugins": lambda subject, args: plugins_view(args["folders"]),
    "complete": lambda subject, args: completed(args["text"], subject),
    "script": lambda subject, args: scripted(args["text"], subject),
    "compose": lambda subject, args: composed(args["drawing"]),
    "limbs": lambda subject, args: limbs_answer(
        args.get("text"), args.get("start"), args.get("edit"), plane=args.get("plane", False)
    ),
    "repeat": lambda subject, args: repeated(subject, args["what"], args["args"], args.get("folders", ())),
    "resize": lambda subject, args: resized(subject, args["points"], args.get("limits")),
    "save": lambda subject, args: saved(
        subject, args["pose"], args["what"], args.get("threshold"), args.get("state"), args.get("folders", ())
    ),
}


def answer(name: str, subject: Subject | None, args: Args) -> Any:
    """The result of a method whose arguments were checked; `subject` is that of their source, if they have one."""
    return ANSWERS[name](subject, args)
