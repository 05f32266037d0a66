"""The report of a robot as it stands in the studio: its pose, the answers that its panels show, what repeats them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import groupby
from typing import Any

from gcrules.apps.studio.bench import bench
from gcrules.apps.studio.moving import amounts_at, configuration
from gcrules.apps.studio.numbers import exact_pose
from gcrules.apps.studio.path_view import Way
from gcrules.apps.studio.posed import analysis_of, drawing_there, platform_there
from gcrules.apps.studio.protocol.answer_views import Bench
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.protocol.report_requests import ReportedJson, StateJson
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.repeating import repeated
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import threshold_of
from gcrules.apps.studio.values import VALUES, value
from gcrules.apps.studio.whereabouts import pose_json
from gcrules.conditions.pose_value import PoseValue, pose_value
from gcrules.core.budget import report as tell
from gcrules.core.budget import within
from gcrules.core.errors import InputError
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.paths.report import PathReport
from gcrules.poses.pose_report import report_of_legs
from gcrules.views.report.report import report
from gcrules.views.report.standing import Answered, Repetition, Standing, Titled

__all__ = ["report_there"]

Args = Mapping[str, Any]


def report_there(
    subject: Subject,
    pose: PoseJson,
    threshold: str | None,
    state: StateJson | None = None,
    folders: Sequence[str] = (),
) -> str:
    """The page; without a `state` that of the robot in its pose alone. Raises GcrulesError where an answer that is to
    stand in it cannot be had any more.
    """
    analysis = subject.robot or analysis_of(subject)
    asked: Sequence[ReportedJson] = state["answers"] if state else ()
    answers = [_answered(subject, one) for one in asked if one["what"] in VALUES]
    tell("writing the report")
    return report(analysis, answers=answers, standing=_standing(subject, pose, threshold, state, folders))


def _standing(
    subject: Subject, pose: PoseJson, threshold: str | None, state: StateJson | None, folders: Sequence[str]
) -> Standing:
    drawing = ""
    with suppress(InputError):  # it has no points to draw
        drawing = drawing_there(subject, pose).svg()
    unset = ""
    numbers: PoseReport | RobotPose | PoseValue | None = None
    try:
        numbers = _numbers(subject, pose, threshold)
    except InputError as fault:  # its joints cannot be moved there
        unset = fault.message
    return Standing(
        mechanism=subject.mechanism,
        numbers=numbers,
        unset=unset,
        drawing=drawing,
        start=_start(subject, pose),
        picture=state["picture"] if state else "",
        notes=tuple((one["title"], one["text"]) for one in state["notes"]) if state else (),
        bench=_on_the_bench(subject, pose, state, folders) if state else (),
        link=state["link"] if state else "",
        repetitions=tuple(
            found for one in (state["answers"] if state else ()) if (found := _repetition(subject, one, folders))
        ),
    )


def _numbers(subject: Subject, pose: PoseJson, threshold: str | None) -> PoseReport | RobotPose | PoseValue:
    """Those of the mechanism; of six lines alone their value. Raises InputError where a robot of joints cannot be set
    there.
    """
    legs, limbs = subject.legs, subject.limbs
    if limbs is not None:
        return configuration(limbs, pose, threshold)
    assert legs is not None
    if subject.moving is not None:
        return report_of_legs(legs, exact_pose(pose), threshold=threshold_of(threshold, legs.unit), nearest=False)
    a, platform = analysis_of(subject), platform_there(subject, pose)
    return pose_value(a.structure, a.condition, platform.homogeneous(), unit=platform.units)


def _start(subject: Subject, pose: PoseJson) -> dict[str, Any]:
    """What takes the 3D view of the page to the pose."""
    if subject.limbs is None:
        return {"pose": pose_json(exact_pose(pose))}
    with suppress(InputError):  # its joints cannot be moved
        amounts = amounts_at(subject.limbs, pose)
        return {"drive": amounts} if amounts else {}
    return {}


# --- answers ---------------------------------------------------------------------------------------------------------


def _answered(subject: Subject, asked: ReportedJson) -> Any:
    """The answer as a value of the library. Raises InputError for arguments that are none."""
    what = asked["what"]
    args = METHODS[what].check(_args(subject, asked), f"args of {what}")
    tell(asked["title"])
    found = value(what, subject, args)
    if isinstance(found, Way):  # a plan has its path with it
        found = found.path if found.plan is None else found.plan
    return Titled(found, asked["title"]) if isinstance(found, _TITLED) else found


def _args(subject: Subject, asked: ReportedJson) -> Args:
    return asked["args"] if asked["what"] == "bench" else {**asked["args"], "source": subject.source}


def _on_the_bench(subject: Subject, pose: PoseJson, state: StateJson, folders: Sequence[str]) -> tuple[Answered, ...]:
    """The texts of the bench with their answers; what takes longer there is not answered here either."""
    found: list[Answered] = []
    for one in state["answers"]:
        if one["what"] != "bench":
            continue
        args = METHODS["bench"].check(_args(subject, one), "args of bench")
        tell(one["title"])
        with within(METHODS["bench"].seconds):
            answered = bench(args["text"], subject, pose, args.get("rules", ()), folders)
        found += _answered_parts(args["text"], answered)
    return tuple(found)


def _answered_parts(text: str, answered: Bench) -> Iterator[Answered]:
    """Where a fault ends the answers, it stands behind the rest of the text."""
    last, whole = 0, text.encode("utf-16-le")

    def until(end: int) -> str:
        nonlocal last
        part, last = whole[2 * last : 2 * end].decode("utf-16-le"), end
        return part.strip("\n")

    for end, results in groupby(answered["results"], lambda result: result["end"]):
        yield Answered(until(end), tuple((_SURE.get(r["verdict"], ""), r["text"]) for r in results))
    rest, fault = until(len(whole) // 2), answered["fault"]
    if fault:
        place = fault.get("place")
        words = f"line {place['line']}: {fault['message']}" if place else fault["message"]
        yield Answered(rest, (("Limit reached" if fault["kind"] == "limit" else "At fault", words),))
    elif rest.strip():
        yield Answered(rest)


_SURE = {"proved": "Proved", "refuted": "Refuted", "undecided": "Not decided"}

_TITLED = (PathReport, RobotPath)
"""There may be several of them."""


def _repetition(subject: Subject, asked: ReportedJson, folders: Sequence[str]) -> Repetition | None:
    """The lines that repeat it; None where none do."""
    with suppress(InputError):
        found = repeated(subject, asked["what"], _args(subject, asked), folders)
        files = tuple((file["name"], file["text"]) for file in found["files"])
        return Repetition(asked["title"], found["shell"], found["python"], files)
    return None
