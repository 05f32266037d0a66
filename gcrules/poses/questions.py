"""What a report is asked for beside the analysis (path, map, certificate, modes, aspects, plan, free region) and the
answers.

Each answer is that of the function of its own, with the same arguments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import GcrulesError, InputError, SingularEverywhere
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.screws.threshold import DEFAULT

__all__ = ["SHAPES", "Questions", "Unanswered"]

# each loads numpy, and is needed where it is asked for only
path_of = deferred("gcrules.poses.path_report:path")
map_of = deferred("gcrules.poses.maps.maps:singular_map")
are_ranges = deferred("gcrules.poses.maps.axes:are_ranges")
within_boxes = deferred("gcrules.poses.boxes.task:within_boxes")
certificate_of = deferred("gcrules.poses.certificates.certify:certify")
box_map = deferred("gcrules.poses.boxes.box_map:box_map")
assembly_modes = deferred("gcrules.poses.modes.modes:assembly_modes")
working_modes = deferred("gcrules.poses.modes.working:working_modes")
operation_modes = deferred("gcrules.poses.operation_modes.operation_modes:operation_modes")
aspects_of = deferred("gcrules.poses.aspects.aspects:aspects")
plan_of = deferred("gcrules.poses.plans.plan:plan")
free_region = deferred("gcrules.poses.regions.free_region:free_region")

SHAPES = ("box", "ball")
"""Those that a free region can have."""

_BOXES = 131_072
"""Boxes of whole ranges in a report, in all: as a rule half a minute at most."""
_CERTIFIED = 32_768
"""Those of a certificate, which are looked at closer."""


@dataclass(frozen=True)
class Unanswered:
    """A question, "Working modes", that has no answer for a robot, and why."""

    question: str
    reason: str


@dataclass(frozen=True)
class Questions:
    """`path` are poses, or the name of a table; `over` the coordinates of a map over nodes, or of one of whole boxes
    where they are ranges without a number, whose free poses have the `margin`; `certify` the ranges of a certificate,
    with the `margin`, a `cone` and a `tilt`, which goes on from the file `resume`; `modes` and `aspects` whether they
    are asked for; `plan` the start and the goal, or the start of a way out; `free` the shape of a free region, one of
    `SHAPES`. `at` is a pose: that of the modes and of the free region, and the rest of map and certificate; `limits`
    are those of map, certificate, aspects and plan, `within` those of the last two.
    """

    path: Any = None
    over: Sequence[Any] | None = None
    certify: Sequence[Any] | None = None
    cone: str | None = None
    tilt: str | None = None
    resume: Any = None
    at: Any = None
    limits: str | None = None
    within: str | None = None
    margin: float = 0.0
    about: Any = "centroid"
    threshold: Any = DEFAULT.text
    modes: bool = False
    aspects: bool = False
    plan: Sequence[Any] | None = None
    free: str | None = None

    def check(self) -> None:
        """Raises InputError for what goes with questions that are not asked, and for an unknown shape."""
        mapped, planned, certified = bool(self.over), bool(self.plan), bool(self.certify)
        if self.at is not None and not (mapped or certified or self.modes or self.free):
            raise InputError(
                f"a pose is that of a map, of a certificate, of modes or of a free region, {_NOT_ASKED}",
                hint=_ask("over", "certify", "modes", "free"),
            )
        if self.limits is not None and not (mapped or certified or self.aspects or planned):
            raise InputError(
                f"limits are those of a map, of a certificate, of aspects or of a plan, {_NOT_ASKED}",
                hint=_ask("over", "certify", "aspects", "plan"),
            )
        if self.within is not None and not (self.aspects or planned):
            raise InputError(
                f"ranges of coordinates are those of aspects or of a plan, {_NOT_ASKED}", hint=_ask("aspects", "plan")
            )
        if self.margin and not (certified or (mapped and are_ranges(self.over))):
            raise InputError(
                "a margin is that of a map of whole boxes or of a certificate",
                hint='give ranges without a number: "x -1:1"',
            )
        for name in ("cone", "tilt", "resume"):
            if getattr(self, name) is not None and not certified:
                raise InputError(f"{_OWN[name]} of a certificate, which is not asked for", hint=_ask("certify"))
        nodes = mapped and not are_ranges(self.over)
        default = isinstance(self.threshold, str) and self.threshold == DEFAULT.text
        if not (default or nodes or self.modes or self.path is not None):
            raise InputError(
                f"a threshold is that of a path, of a map over nodes or of modes, {_NOT_ASKED}",
                hint=_ask("path", "over", "modes"),
            )
        if self.plan is not None and not 1 <= len(self.plan) <= 2:
            raise InputError(
                f"a plan of {len(self.plan)} poses", hint="name its start and its goal, or the start alone"
            )
        if self.free is not None and self.free not in SHAPES:
            raise InputError(f"{self.free!r} is not a shape of a free region", hint=" or ".join(SHAPES))

    def answers(self, a: Analysis | RobotAnalysis) -> tuple[Any, ...]:
        """The answers for a robot, in the sequence of the sections of its report. Raises InputError for questions that
        make no sense for it, such as poses that it does not reach.
        """
        self.check()
        return tuple(self._answers(a))

    def _answers(self, a: Analysis | RobotAnalysis) -> Iterator[Any]:
        about, threshold, limits = self.about, self.threshold, self.limits
        if self.path is not None:
            yield path_of(a, self.path, about=about, threshold=threshold)
        if self.over is not None:
            yield self._map(a)
        if self.certify:
            yield self._certificate(a)
        if self.modes:
            yield assembly_modes(a, self.at, about=about, threshold=threshold)
            if isinstance(a, RobotAnalysis):  # legs between two points have one working and one operation mode
                yield from self._further_modes(a)
        if self.aspects:
            ask = partial(aspects_of, a, about=about, limits=limits, within=self.within)
            yield _answer("Aspects", ask, SingularEverywhere)
        if self.plan is not None:
            ask = partial(plan_of, a, *self.plan, about=about, limits=limits, within=self.within)
            yield _answer("A way without a singularity", ask, SingularEverywhere)
        if self.free:
            ask = partial(free_region, a, self.at, about=about, ball=self.free == "ball")
            yield _answer("A free region", ask, SingularEverywhere)

    def _map(self, a: Analysis | RobotAnalysis) -> Any:
        """Over nodes, or of whole boxes: what the coordinates are."""
        if not are_ranges(self.over):
            return map_of(a, self.over, self.at, about=self.about, limits=self.limits, threshold=self.threshold)
        over = _listed(self.over)
        tiles, boxes = within_boxes(len(over), _BOXES)
        given = {"about": self.about, "limits": self.limits, "margin": self.margin, "tiles": tiles, "boxes": boxes}
        return _answer("Whole ranges", partial(box_map, a, over, self.at, **given), SingularEverywhere)

    def _certificate(self, a: Analysis | RobotAnalysis) -> Any:
        given = {"about": self.about, "limits": self.limits, "margin": self.margin, "cone": self.cone}
        given |= {"tilt": self.tilt, "resume": self.resume, "boxes": _CERTIFIED}
        ask = partial(certificate_of, a, _listed(self.certify), self.at, **given)
        try:
            return _answer("A certificate", ask, SingularEverywhere)
        except GcrulesError as fault:  # ranges are read as those of --over are
            if fault.filename == "--over":
                fault.filename = "--certify"
            raise

    def _further_modes(self, a: RobotAnalysis) -> Iterator[Any]:
        """Those that not every robot of joints has."""
        ask = partial(working_modes, a, self.at, about=self.about, threshold=self.threshold)
        yield _answer("Working modes", ask, GcrulesError)
        yield _answer("Operation modes", partial(operation_modes, a.robot), GcrulesError)


def _answer(question: str, ask: Callable[[], Any], no_answer: type[GcrulesError]) -> Any:
    """What a function answers, or that such a fault of it leaves no answer; other faults are raised."""
    try:
        return ask()
    except no_answer as fault:
        return Unanswered(question, fault.message)


def _listed(over: Any) -> list[Any]:
    """Ranges, of which one may stand alone."""
    return [over] if isinstance(over, str) else list(over or ())


_OWN = {"cone": "cones of joints are those", "tilt": "a tilt is that", "resume": "a file to go on from is that"}
_NOT_ASKED = "none of which is asked for"


def _ask(*names: str) -> str:
    """How to ask for one of several things."""
    options, arguments = (
        " or ".join(filter(None, (", ".join(n[:-1]), n[-1]))) for n in ([f"--{n}" for n in names], names)
    )
    return f"add {options} (in Python {arguments})"
