"""Robots with limbs on the move: their actuators as sliders, and the numbers where these take them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from math import degrees, isfinite, log10, radians

import numpy as np

from gcrules.apps.studio.actuators_view import actuator_views, jacobian_facts
from gcrules.apps.studio.parts import give
from gcrules.apps.studio.protocol.answer_views import Headline, Numbers
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.protocol.study_views import Axis
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.thresholds import close_margin
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, rotation_vector
from gcrules.mechanisms.kinematics.solve import Solution, free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.factors import superbracket_value
from gcrules.poses.limbs.many import Solved
from gcrules.poses.limbs.pose_report import points_at, report_at, report_of_limbs, solution_at, standing_at
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.motion import Twist
from gcrules.poses.signs.of_limbs import DETERMINANT, signs_of_limbs
from gcrules.screws.pose_text import ANGLES, SHIFTS, TURNS
from gcrules.screws.threshold import DEFAULT, angle_threshold
from gcrules.views.results.actuators import reaches
from gcrules.views.results.amplification import actuator_notes
from gcrules.views.results.singularity_types import in_words
from gcrules.views.robots.limb_views import derived_points, limb_views, unit_directions
from gcrules.views.robots.skeleton import skeleton
from gcrules.views.scene_data import MotionView

__all__ = [
    "actuator_axes",
    "amounts_at",
    "configuration",
    "coordinate_axes",
    "displaced",
    "displacement",
    "freedom_axes",
    "motion_view",
    "numbers_of_limbs",
    "posed",
    "solved",
    "values_at",
]

_TURN, _SHIFT = 30.0, 0.35
"""How far the sliders of actuators reach: degrees, and parts of the robot's size."""


def actuator_axes(limbs: Limbs, size: float) -> list[Axis]:
    """One slider for each actuator that leads, from home; none where the joints cannot be moved."""
    try:
        actuators = leading(limbs.linkage)
    except InputError:
        return []
    known = reaches(limbs)
    return [
        _within(_axis(f"{a.name}, {a.limb}", a.angle, limbs.unit, size), *known.get(a.name, (None, None)))
        for a in actuators
    ]


def _within(axis: Axis, low: float | None, high: float | None) -> Axis:
    """A slider that ends where the actuator does."""
    return {**axis, "low": axis["low"] if low is None else low, "high": axis["high"] if high is None else high}


def coordinate_axes(limbs: Limbs, size: float) -> list[Axis]:
    """Coordinates over which the robot can be mapped, those that are independent at home first; then its actuators."""
    try:
        m = limbs.linkage
        free = free_coordinates(m)
    except InputError:
        return []
    others = () if m.robot.family.plane else (*SHIFTS, *TURNS)
    names = dict.fromkeys((*free, *others))
    return [
        *(_axis(n, n in ANGLES, limbs.unit, size) for n in names),
        *(_axis(a.name, a.angle, limbs.unit, size) for a in leading(m)),
    ]


def _axis(name: str, angle: bool, unit: str, size: float) -> Axis:
    if angle:
        return {"name": name, "unit": "deg", "low": -_TURN, "high": _TURN, "step": 0.1}
    return {
        "name": name,
        "unit": unit,
        "low": -_SHIFT * size,
        "high": _SHIFT * size,
        "step": 10.0 ** round(log10(size) - 2.7),
    }


def configuration(limbs: Limbs, pose: PoseJson, threshold: str | None = None) -> RobotPose:
    """The robot where its actuators have these amounts from home (lengths, degrees); at home where none are given.

    Raises InputError where the robot does not assemble.
    """
    amounts = amounts_at(limbs, pose)
    return report_of_limbs(limbs, actuators=amounts or None, threshold=threshold or DEFAULT)


def amounts_at(limbs: Limbs, pose: PoseJson) -> list[float]:
    """The amounts of the actuators from home, angles in radians; none at home. Raises InputError for another number."""
    actuators, given = leading(limbs.linkage), pose.get("coordinates")
    if given is not None and len(given) != len(actuators):
        raise InputError(f"{len(given)} coordinates, and the robot has {len(actuators)} actuators")
    if not given or not any(given):
        return []
    return [radians(v) if a.angle else float(v) for a, v in zip(actuators, given, strict=True)]


@lru_cache(maxsize=8)
def solved(m: Linkage, amounts: tuple[float, ...]) -> Solution:
    """The solution for amounts of the actuators, at home for none; a page asks for the same pose several times. Raises
    InputError where the robot does not assemble.
    """
    last = _last(m)
    found = solution_at(m, actuators=list(amounts) or None, near=last[0] if last else None)
    last[:] = [found]
    return found


@lru_cache(maxsize=8)
def _last(m: Linkage) -> list[Solution]:
    """The solution that was asked for last, if any was: the next one is near it as a rule."""
    return []


def freedom_axes(limbs: Limbs, size: float) -> list[Axis]:
    """The coordinates of the platform that are independent at home; none where the joints cannot be moved."""
    try:
        return [_axis(n, n in ANGLES, limbs.unit, size) for n in free_coordinates(limbs.linkage)]
    except InputError:
        return []


@lru_cache(maxsize=8)
def _freedoms(m: Linkage) -> tuple[str, ...]:
    return free_coordinates(m)


def freedoms_at(m: Linkage, c: Configuration) -> list[float]:
    """What these coordinates are there, from home: lengths and degrees."""
    names = _freedoms(m)
    found = without_rounding(names, coordinates(names, c.platform, m.centre), m.size)
    return [degrees(v) if n in ANGLES else float(v) for n, v in zip(names, found, strict=True)]


def displacement(m: Linkage, motion: Floats, about: Sequence[float]) -> PoseJson:
    """Where a motion (4, 4) from home leads the platform: turned about this point of the file, then shifted."""
    arm = np.asarray(about) - np.array([float(v) for v in m.origin])
    turn, shift = motion[:3, :3], motion[:3, 3]
    vector = rotation_vector(turn)
    half = float(np.linalg.norm(vector)) / 2
    part = vector * (np.sinc(half / np.pi) / 2)
    return {"translation": (turn @ arm + shift - arm).tolist(), "quaternion": [float(np.cos(half)), *part.tolist()]}


def displaced(m: Linkage, pose: PoseJson, about: Sequence[float]) -> Floats:
    """The motion (4, 4) from home to such a pose."""
    arm = np.asarray(about) - np.array([float(v) for v in m.origin])
    found = np.eye(4)
    found[:3, :3] = turn = matrices(np.array([pose["quaternion"]], dtype=np.float64))[0]
    found[:3, 3] = arm + pose["translation"] - turn @ arm
    return found


def posed(limbs: Limbs, amounts: Sequence[float]) -> PoseJson:
    """The pose of the page in which the actuators have these amounts, angles in radians."""
    given = [degrees(v) if a.angle else float(v) for a, v in zip(leading(limbs.linkage), amounts, strict=True)]
    return {"translation": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0], "coordinates": given}


def values_at(subject: Subject, pose: PoseJson) -> dict[str, list[float]]:
    """Coordinates of all points and directions, for which nothing is solved at home. Raises InputError likewise."""
    if subject.limbs is None or not any(pose.get("coordinates", ())):
        return subject.home
    m = subject.limbs.linkage
    return values_of(subject, points_at(m, solved(m, tuple(amounts_at(subject.limbs, pose))).configuration))


def values_of(subject: Subject, points: Mapping[str, Sequence[float]]) -> dict[str, list[float]]:
    """Coordinates of all points and directions there, those of the frame among them."""
    return {**subject.home, **{n: list(p) for n, p in points.items()}}


def numbers_of_limbs(limbs: Limbs, subject: Subject, pose: PoseJson, threshold: str | None) -> Numbers:
    """The numbers in a configuration, the headline given first. Raises InputError where the robot does not assemble."""
    robot = limbs.analysis
    limit = angle_threshold(threshold or DEFAULT, "for robots of joints")
    solution = solved(limbs.linkage, tuple(amounts_at(limbs, pose)))
    stands = standing_at(limbs.linkage, solution.configuration, limit)
    values = values_of(subject, points_at(limbs.linkage, solution.configuration))
    value = superbracket_value(robot, {n: np.asarray(v) for n, v in values.items()})
    headline: Headline = {
        "pose": pose,
        "value": stands.margin.sigma if value is None else value,
        "margin": stands.margin.sigma,
        "close": close_margin(limit),
        "verdict": stands.verdict,
    }
    give(headline)
    found = report_at(limbs.linkage, robot, solution, limit, stands)
    there = Solved.at(limbs, solution.configuration)
    names = subject.points
    near = found.verdict != "regular"
    return {
        **headline,
        "freedoms": freedoms_at(limbs.linkage, solution.configuration),
        "platform": displacement(limbs.linkage, solution.configuration.platform, subject.about),
        "points": {n: values[n] for n in names} | derived_points(robot, values),
        "reason": found.reason,
        "causes": list(found.causes),
        "readings": [
            {
                "part": f.expression,
                "name": "normalised value",
                "meaning": f.statement or f"a factor of the condition ({f.kind})",
                "value": f.value,
                "unit": "",
                "why": "",
            }
            for f in found.factors
            if isfinite(f.value)
        ],
        "constructed": [],
        "motion": motion_view(found.softest, found.centre, subject.unit) if near else None,
        "stress": [limb.share for limb in found.limbs] if near else [],
        "limbs": limb_views(robot, values),
        "skeleton": skeleton(robot.robot, values),
        "directions": unit_directions(robot, values),
        "notes": [
            *(f"{t.symbol}, {in_words(t)}." for t in found.types),
            *actuator_notes(found.jacobian.amplification, subject.unit),
            *found.notes,
            f"Assembly mode: {found.mode}.",
            *([] if found.assembly.doubt is None else [f"Branch: {found.assembly.branch}."]),
        ],
        "actuators": actuator_views(limbs, found.actuator_values, found.jacobian),
        "jacobian": jacobian_facts(found.jacobian, subject.unit),
        "signs": [
            {"expression": e, "sign": s.sign, "statement": "" if e == DETERMINANT else s.statement}
            for s in signs_of_limbs(limbs, there, found.factors)
            for e in [s.expression]
        ],
    }


def motion_view(twist: Twist, centre: tuple[float, ...], unit: str) -> MotionView:
    """What the platform can do, to first order, although its actuators are locked; a shift is drawn at the centre."""
    through = twist.point or centre
    words = f"the platform can {twist.text(unit)}"
    return {"axis": list(twist.axis), "through": list(through), "pitch": twist.pitch, "text": words}
