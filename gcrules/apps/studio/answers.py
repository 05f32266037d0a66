"""What answers each method: a function of the subject, the arguments, and of what hears how far it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from gcrules.apps.studio.bench import bench
from gcrules.apps.studio.composing import composed
from gcrules.apps.studio.export import saved
from gcrules.apps.studio.gallery import gallery
from gcrules.apps.studio.manual_replay import replayed
from gcrules.apps.studio.nearest_view import nearest
from gcrules.apps.studio.numbers import along, numbers
from gcrules.apps.studio.study import study
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.wire import Tell

__all__ = ["ANSWERS", "answer"]

Args = Mapping[str, Any]

ANSWERS: Mapping[str, Callable[[Any, Args, Tell], Any]] = {
    "gallery": lambda subject, args, tell: gallery(),
    "open": lambda subject, args, tell: study(subject, tell),
    "pose": lambda subject, args, tell: numbers(subject, args["pose"], args.get("threshold")),
    "along": lambda subject, args, tell: along(subject, args["poses"], args.get("threshold")),
    "nearest": lambda subject, args, tell: nearest(subject, args["pose"], args.get("threshold"), tell),
    "manual": lambda subject, args, tell: replayed(subject, args["commands"], tell),
    "bench": lambda subject, args, tell: bench(args["text"], subject, args.get("pose")),
    "compose": lambda subject, args, tell: composed(args["drawing"]),
    "save": lambda subject, args, tell: saved(subject, args["pose"], args["what"], args.get("threshold")),
}


def answer(name: str, subject: Subject | None, args: Args, tell: Tell) -> Any:
    """The result of a method whose arguments were checked; `subject` is that of their source, if they have one."""
    return ANSWERS[name](subject, args, tell)
