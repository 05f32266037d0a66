"""The shell and the Python lines that repeat what the page shows."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from math import degrees
from typing import Any

from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import InputPiece, first_word, is_blank, is_claim
from gcrules.apps.repl.state import PromptState
from gcrules.apps.repl.tables import STATEMENTS, meant
from gcrules.apps.studio.bench import context_of
from gcrules.apps.studio.bench_repeating import Rules, pasted, prompt_lines
from gcrules.apps.studio.boxes_view import rest_at
from gcrules.apps.studio.calls import Call, Option
from gcrules.apps.studio.locus_view import asked_locus
from gcrules.apps.studio.map_view import rest_of_map
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.path_view import ends
from gcrules.apps.studio.posed import file_there
from gcrules.apps.studio.protocol.answer_views import Repeated, RepeatedFile
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.protocol.requests import HOME, THRESHOLD, PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.whereabouts import at_home, coordinates_at
from gcrules.core.errors import InputError
from gcrules.core.files import file_name
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import is_xml, kind_of_id
from gcrules.poses.loci.variables import ROTATIONS
from gcrules.poses.maps.axes import ACTUATOR, read_axes
from gcrules.poses.plans.report import Waypoint
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import ANGLES, SHIFTS
from gcrules.views.results.plan import waypoint_text

__all__ = ["repeated"]

Args = Mapping[str, Any]


def repeated(subject: Subject | None, what: str, args: Args, folders: Sequence[str] = ()) -> Repeated:
    """The lines for a method with these arguments, in a studio with these folders of plugins. Raises
    InputError for what is no such argument, and where nothing repeats it.
    """
    asked = METHODS[_OF.get(what, what)].check(args, "args")
    if what == "bench":
        return _bench(subject, asked["text"], Rules.of(asked.get("rules", ()), folders))
    if subject is None:
        raise InputError("this is about no robot")
    call = _CALLS[what](subject, asked)
    word, mode, file = _named(subject, alone=what in ("open", "manual"))
    if what == "assemblies" and subject.limbs:
        mode = None  # they are those of the home that the file gives
    return {"shell": call.shell(word, mode), "python": call.python(word, mode), "files": [file] if file else []}


_PLAIN = re.compile(r"[^\W_][\w .+()-]*\.\w+")
"""Names of files that mean themselves, in a shell and on a disk."""


# --- what the robot is called ----------------------------------------------------------------------------------------


def _named(subject: Subject, *, alone: bool) -> tuple[str, str | None, RepeatedFile | None]:
    """A word that means it, its mode, and the file that has to be there. `alone`: the legs do without a shape."""
    source = subject.source
    if source["kind"] == "robot":
        return source["id"], source.get("mode"), None
    if source["kind"] == "example" and kind_of_id(source["name"]) == "example":
        return source["name"], None, None
    if source["kind"] == "class" and alone and kind_of_id(source["id"]) == "class":
        return source["id"], None, None
    if source["kind"] == "legs" and alone:
        return " ".join(source["legs"].split()), None, None
    if source["kind"] == "file":
        name, text = source["name"], source["text"]
        if not _PLAIN.fullmatch(name):  # it may come from a link, and stands in lines to paste
            name = file_name(subject.title, "xml" if is_xml(text) else "yaml")
        return name, source.get("mode"), {"name": name, "text": text}
    name = file_name(subject.title, "yaml")
    return name, None, {"name": name, "text": file_there(subject, HOME)}


# --- poses in words --------------------------------------------------------------------------------------------------


def _number(value: float) -> str:
    return f"{value + 0.0:.12g}"  # 0 has no sign


def _values(values: Mapping[str, float], angles: frozenset[str] = ANGLES) -> str:
    """Coordinates, or actuators, with as many digits as count; of degrees at most twelve after the point."""
    turned = {n: round(degrees(v), 12) if n in angles else v for n, v in values.items()}
    return ", ".join(f"{n}={_number(v)}{'deg' if n in angles else ''}" for n, v in turned.items())


def _words(at: Any) -> str:
    """A pose as commands take it."""
    if isinstance(at, str):
        return at
    if not isinstance(at, Pose):
        return _values(at)
    shift = " ".join(_number(float(c)) for c in at.translation)
    w, *turn = at.unit_quaternion
    return shift if not any(turn) else f"{shift}; quaternion {' '.join(map(_number, (w, *turn)))}"


def _at(words: str) -> list[Option]:
    return [Option("--at", "at", words)] if words else []


def _actuated(limbs: Limbs, pose: PoseJson) -> str:
    """The amounts of the actuators; nothing at home."""
    if at_home(pose):
        return ""
    amounts = zip(leading(limbs.linkage), pose.get("coordinates", ()), strict=True)
    return ", ".join(f"{a.name}={_number(v)}{'deg' if a.angle else ''}" for a, v in amounts)


def _limit(args: Args) -> list[Option]:
    given = args.get("threshold") or THRESHOLD
    return [] if given == THRESHOLD else [Option("--threshold", "threshold", given)]


# --- calls -----------------------------------------------------------------------------------------------------------


def _pose(subject: Subject, args: Args) -> Call:
    if subject.limbs:
        amounts = _actuated(subject.limbs, args["pose"])
        options = [Option("--actuators", "actuators", amounts)] if amounts else []
    else:
        options = [] if at_home(args["pose"]) else _at(_words(exact_pose(args["pose"])))
    return Call("pose", "pose", (*options, *_limit(args)))


def _actuators(subject: Subject, args: Args) -> Call:
    """The numbers of the pose as one object, in which the legs or actuators stand one by one."""
    posed = _pose(subject, args)
    of_legs = [Option("--accuracy", "accuracy", "0")] if subject.legs and subject.robot else []  # not of its slides
    options = (*posed.options, *of_legs, Option("--no-nearest", "nearest", False), Option("--json", "", True))
    return Call(posed.command, posed.function, options, ("actuator_values", "jacobian.amplification"))


def _locus(subject: Subject, args: Args) -> Call:
    asked = asked_locus(subject.mechanism, args["pose"], args.get("over"))
    given = dict(asked.fix or {}) if asked.at is None else _exactly(asked.at, asked.free)
    fixed = [Option("--fix", "fix", ", ".join(f"{n}={c}" for n, c in given.items()))] if given else []
    return Call("locus", "locus", (Option("--over", "over", ", ".join(asked.free)), *fixed))


def _exactly(at: Pose, free: Sequence[str]) -> dict[str, Any]:
    """The other variables of a pose with all their digits; a quaternion there may have any length."""
    shift = {n: c for n, c in zip(SHIFTS, at.translation, strict=True) if n not in free}
    turn = dict(zip(ROTATIONS["quaternion"], at.quaternion, strict=True))
    return shift | turn if any(at.quaternion[1:]) or any(shift.values()) else {}


def _path(subject: Subject, args: Args) -> Call:
    poses = ends(subject.mechanism, args.get("start"), args["goal"], args.get("to"), args.get("through", ()))
    words = tuple(map(_words, poses))
    if args.get("way") == "around":
        return Call("plan", "plan", (Option("--from", "start", words[0]), Option("--to", "goal", words[-1])))
    return Call("path", "path", (Option("--at", "poses", words), *_limit(args)))


def _map(subject: Subject, args: Args) -> Call:
    measure = args.get("measure", "margin")
    bands = [] if measure == "margin" else [Option("--measure", "measure", measure)]
    at = _rest(subject, rest_of_map(subject.mechanism, args["over"], args["pose"]), args["over"])
    return Call("map", "singular_map", (Option("--over", "over", tuple(args["over"])), *at, *bands, *_limit(args)))


def _rest(subject: Subject, rest: Any, over: Sequence[str]) -> list[Option]:
    """What the pose says of the coordinates that are not gone through."""
    if isinstance(rest, Pose):
        return [] if rest == Pose() else _at(_words(rest))
    assert subject.limbs is not None
    actuators = {a.name: a.angle for a in leading(subject.limbs.linkage)}
    driven = read_axes(over, subject.unit, actuators)[0].kind == ACTUATOR
    return _at(_values(rest, frozenset(n for n, angle in actuators.items() if angle) if driven else ANGLES))


def _boxes(subject: Subject, args: Args) -> list[Option]:
    rest = rest_at(subject.mechanism, args["over"], args["pose"])
    whole = [] if rest == Pose() else _at(_words(rest))
    named = [("--limits", "limits"), ("--margin", "margin"), ("--cone", "cone"), ("--tilt", "tilt")]
    options = [Option(flag, name, args[name]) for flag, name in named if args.get(name)]
    return [Option("--over", "over", tuple(args["over"])), *whole, *options]


def _free(subject: Subject, args: Args) -> Call:
    pose = args["pose"]
    m = subject.mechanism
    at: Waypoint = coordinates_at(m, pose, free_coordinates(m.linkage)) if isinstance(m, Limbs) else exact_pose(pose)
    ball = [Option("--ball", "ball", True)] if args["shape"] == "ball" else []
    return Call("free", "free_region", (*([] if at_home(pose) else _at(waypoint_text(at))), *ball))


def _assemblies(subject: Subject, args: Args) -> Call:
    here = [] if subject.limbs or at_home(args["pose"]) else _at(_words(exact_pose(args["pose"])))
    return Call("modes", "assembly_modes", (*here, *_limit(args)))


def _boxed(command: str, function: str) -> Callable[[Subject, Args], Call]:
    def call(subject: Subject, args: Args) -> Call:
        return Call(command, function, (*_boxes(subject, args), Option("--boxes", "boxes", args["boxes"])))

    return call


_CALLS: Mapping[str, Callable[[Subject, Args], Call]] = {
    "open": lambda subject, args: Call("analyze", "analyze"),
    "pose": _pose,
    "actuators": _actuators,
    "path": _path,
    "map": _map,
    "surface": _map,
    "locus": _locus,
    "assemblies": _assemblies,
    "aspects": lambda subject, args: Call("aspects", "aspects"),
    "free": _free,
    "boxes": _boxed("map boxes", "box_map"),
    "certify": _boxed("certify", "certify"),
    "manual": lambda subject, args: Call("analyze", "", (Option("--propose", "", tuple(args["commands"])),)),
}


_OF = {"actuators": "pose"}
"""The method whose arguments it has, where that is another one."""


def _bench(subject: Subject | None, text: str, rules: Rules) -> Repeated:
    """The prompt takes what the bench takes; an expression or a claim alone is a call of Python too."""
    s = subject.structure if subject else None
    declared = {"points": [n for n in s.names if not SHORT_NAME.fullmatch(n)], "ideal": list(s.ideal)} if s else {}
    text = pasted(re.sub(r"\r\n?", "\n", text))
    if not text.strip():
        raise InputError("the bench is empty")
    ranks = [f"rank {s.rank}"] if s and s.rank != Context().rank else []
    start = [*ranks, *(f"{word} {' '.join(names)}" for word, names in declared.items() if names)]
    shell = prompt_lines([*start, *text.strip().split("\n")], rules)
    alone = "\n" not in text.strip() and not ranks and first_word(text.strip()) not in STATEMENTS
    python = _evaluated(text.strip(), declared, context_of(subject)) if alone else ""
    return {"shell": shell, "python": python, "files": [*rules.files, *rules.catalogs]}


_FUNCTIONS = ("expand", "straighten", "factor", "factors", "shorten", "transversals", "prove")
"""The questions of the prompt that are functions of Python by the same name, whatever rules hold."""


def _evaluated(text: str, declared: Mapping[str, Sequence[str]], context: Context) -> str:
    """The call of an expression, an equation or a question alone; nothing where no function answers it."""
    called = Interpreter(PromptState(context)).called(InputPiece(text))
    function = "prove" if is_claim(text) else "expand"
    if called is not None:
        function = next(iter(meant(called[0])), "")
        text = text[called[1] :].strip()
        if function not in _FUNCTIONS or is_blank(text) or "%" in text:
            return ""
    names = tuple(Option("", word, " ".join(names)) for word, names in declared.items() if names)
    return Call("", function, names).direct(text)
