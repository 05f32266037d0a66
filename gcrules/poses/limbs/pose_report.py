r"""A robot described by its joints, in one configuration: solve, then all numbers there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import floor, isfinite
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.english import agreeing, listed
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.floats import without_noise
from gcrules.mechanisms.conditions.checks import STILL
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage, begun_at
from gcrules.mechanisms.kinematics.margin import LimbMargin, limb_margins, margin
from gcrules.mechanisms.kinematics.solve import Solution, check_target, solve
from gcrules.mechanisms.kinematics.targets import (
    Target,
    actuators_target,
    coordinates_target,
    pose_target,
    read_actuators,
    read_pose,
)
from gcrules.mechanisms.kinematics.wrench_jacobian import wrench_jacobian
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.balance import limb_numbers
from gcrules.poses.limbs.factors import ConditionFactor, factors
from gcrules.poses.limbs.first_singular import FirstSingular, first_singular
from gcrules.poses.limbs.nearest import nearest_singular
from gcrules.poses.limbs.report import NearestConfiguration, RobotPose
from gcrules.poses.limbs.singularity_types import singularity_types
from gcrules.poses.limbs.way_from_home import way_from_home
from gcrules.poses.numbers.motion import Twist, twist_of
from gcrules.screws.guarantees import DIGITS
from gcrules.screws.pose import Pose, exact
from gcrules.screws.pose_text import ANGLES, COORDINATES, Amount
from gcrules.screws.threshold import DEFAULT, Threshold, angle_threshold, margin_of, safe, turn_of
from gcrules.screws.verdict import SOLVED, decide

__all__ = [
    "Standing",
    "cause_of",
    "first_singular_pose",
    "points_at",
    "report_at",
    "report_of_limbs",
    "solution_at",
    "standing_at",
    "target_of",
]

_BLURRED = 1e-10
"""What rounding may do to σ without being told: a tenth of `SINGULAR`."""

_NEAR_ZERO = 1e-6  # of a factor, where the robot is singular


def report_of_limbs(
    m: Limbs,
    at: Any = None,
    actuators: Any = None,
    *,
    degrees: bool = False,
    threshold: str | Threshold = DEFAULT,
    nearest: bool = False,
) -> RobotPose:
    """The numbers at a wanted pose, or at wanted actuators; at home where neither is given; with the `nearest` singular
    configuration if that is asked for. Raises InputError.
    """
    limit = angle_threshold(threshold, "for robots described by joints")
    solution = solution_at(m.linkage, at, actuators, degrees)
    found = report_at(m.linkage, m.analysis, solution, limit)
    if not nearest or found.verdict == "singular":
        return found
    return replace(found, nearest=_nearest(m, solution.configuration))


def _nearest(m: Limbs, here: Configuration) -> NearestConfiguration | None:
    """The nearest singular configuration in words and numbers, all from home but the changes; None where no coordinates
    tell the pose near the configuration.
    """
    at = begun_at(m.linkage, here)
    found = nearest_singular(at)
    if found is None:
        return None
    size = at.size
    known: dict[str, Any] = {"coordinates": {}, "actuators": {}, "margin": None, "causes": (), "branch_proved": False}
    if found.solution is not None:
        there = found.solution.configuration
        pose = coordinates(COORDINATES, there.platform @ here.platform, m.linkage.centre)
        known = {
            "coordinates": _numbers(COORDINATES, pose, size),
            "actuators": {
                a.name: (there.joint_values[a.place] + here.joint_values[a.place])[a.coordinate]
                for a in m.linkage.actuators
            },
            "margin": margin(at, there).sigma,
            "causes": _causes(factors(m.analysis, there.values), "singular"),
            "branch_proved": found.solution.doubt is None,
        }
    return NearestConfiguration(
        changes={} if found.changes is None else _numbers(found.names, found.changes, size),
        distance=found.distance,
        reach=found.reach,
        size=size,
        free={n: found.free * (1.0 if n in ANGLES else size) for n in found.names},
        directions=found.directions,
        stopped=found.stopped,
        **known,
    )


def _numbers(names: Sequence[str], values: Any, size: float) -> dict[str, float]:
    """Coordinates by name, without what is rounding only."""
    return {n: without_noise(v, 1.0 if n in ANGLES else size) for n, v in zip(names, values, strict=True)}


def first_singular_pose(
    m: Limbs, at: Any, actuators: Any, *, degrees: bool = False, threshold: str | Threshold = DEFAULT
) -> RobotPose | None:
    """The numbers at the first singular configuration on the way to what is wanted; None where it is proved that none
    is. Raises InputError, and LimitReached where none is known and some stretches are not decided.
    """
    limit = angle_threshold(threshold, "for robots described by joints")
    wanted = target_of(m.linkage, at, actuators, degrees)
    if wanted is None or not wanted.values.any():
        raise InputError("no direction is given in which to look", hint="give the end of the way: z=1, roll=0deg, …")
    check_target(m.linkage, wanted)
    found = first_singular(m.linkage, wanted)
    if found.solution is None:
        if found.proved:
            return None
        raise LimitReached(
            f"no singular configuration is known on the way to {wanted.text}, but {_open(found)}",
            hint="a way beside it may be decided; `gcrules path` lists the stretches",
        )
    text = f"{100 * found.part:.6g}% of the way to {wanted.text}"
    first = report_at(m.linkage, m.analysis, replace(found.solution, target=replace(wanted, text=text)), limit)
    clear = f"proved: no configuration before {floor(1e6 * found.clear) / 1e4:g}% of the way is singular"
    before = clear if found.proved else f"of the way before it {_open(found)}"
    return replace(first, notes=(*first.notes, before))


def _open(found: FirstSingular) -> str:
    """What is not decided, in words."""
    words = [f"{100 * a:.4g}% to {100 * b:.4g}%" for a, b in found.undecided]
    if found.doubt is not None and not words:
        return f"beyond {100 * found.doubt:.4g}% its branch is not proved"
    return f"at {listed(words)} of the way it is not decided"


def solution_at(
    m: Linkage, at: Any = None, actuators: Any = None, degrees: bool = False, near: Solution | None = None
) -> Solution:
    """The configuration in which the loops are closed at what is wanted, as for `target_of`; home where nothing is.
    Quicker where the solution for values `near` by is known.
    """
    wanted = target_of(m, at, actuators, degrees)
    return solve(m, wanted, near) if wanted is not None else Solution(m.home, Target((), np.zeros(0), text="home"))


def target_of(m: Linkage, at: Any, actuators: Any, degrees: bool = False) -> Target | None:
    """What is asked for, or None for home; angles of mappings and of rows of actuators are in radians unless `degrees`.
    Raises InputError for both kinds at once and for what is no request."""
    if at is not None and actuators is not None:
        raise InputError("a pose and actuators at once", hint="give one of them; the other one follows")
    if actuators is not None:
        return read_actuators(m, actuators) if isinstance(actuators, str) else _driven(m, actuators, degrees)
    match at:
        case None:
            return None
        case str():
            return read_pose(m, at)
        case Pose():
            return pose_target(m, at)
        case Mapping():
            return coordinates_target(m, {n: _amount(v, n, degrees and n in ANGLES) for n, v in at.items()})
        case Sequence() if len(at) == 3:
            x, y, z = (exact(c, "the translation") for c in at)
            return pose_target(m, Pose((x, y, z)))
    raise InputError(
        f"{str(at)[:60]!r} is not a pose", hint='write "z=0.2, roll=5deg", or "x y z; euler zyx a b c deg"'
    )


def _driven(m: Linkage, given: Any, degrees: bool) -> Target:
    leads = leading(m)
    angles = {a.name for a in leads if a.angle}
    if isinstance(given, Mapping):
        return actuators_target(m, {n: _amount(v, n, degrees and n in angles) for n, v in given.items()})
    values = list(given)
    if len(values) == len(leads):  # else whoever reads them says what is missing
        values = [_amount(v, a.name, degrees and a.angle) for a, v in zip(leads, values, strict=True)]
    return actuators_target(m, values)


def _amount(value: Any, name: str, in_degrees: bool) -> Any:
    return Amount(exact(value, name), degrees=True) if in_degrees else value


@dataclass(frozen=True, eq=False)
class Standing:
    """How a configuration stands: its margin, those of the limbs by themselves, and what is said of them."""

    margin: LimbMargin
    own: tuple[float, ...]
    verdict: str
    reason: str


def standing_at(m: Linkage, c: Configuration, limit: Threshold) -> Standing:
    """The verdict at a configuration, which takes a small part of the time that all numbers take."""
    near = margin(m, c)
    own = tuple(limb_margins(m, Configurations.of([c]))[0].tolist())
    return Standing(near, own, *_verdict(m, near, own, limit))


def points_at(m: Linkage, c: Configuration) -> dict[str, tuple[float, ...]]:
    """Coordinates of all points and directions in a configuration."""
    return {
        d.name: tuple(without_noise(x, m.size if d.sort == "point" else 1.0) for x in c.values[d.name])
        for d in m.robot.family.definitions
    }


def report_at(
    m: Linkage, analysis: RobotAnalysis, solution: Solution, limit: Threshold, known: Standing | None = None
) -> RobotPose:
    """All numbers at a solution, of which it may be known already how it stands."""
    c = solution.configuration
    stands = known or standing_at(m, c, limit)
    near, own, verdict = stands.margin, stands.own, stands.verdict
    values = factors(analysis, c.values)
    motions = _twists(m, near)
    gained = tuple(t for t, s in zip(motions, near.singular_values, strict=True) if s <= SOLVED)
    jacobian = wrench_jacobian(m, c, near)
    return RobotPose(
        robot=m.robot.id,
        title=m.robot.title,
        target=solution.target.text,
        verdict=verdict,
        reason=stands.reason,
        causes=_causes(values, verdict),
        coordinates=_numbers(COORDINATES, coordinates(COORDINATES, c.platform, m.centre), m.size),
        centre=tuple(without_noise(float(x), m.size) for x in m.centre),
        actuators=tuple(
            (a, without_noise(c.joint_values[a.place][a.coordinate], 1.0 if a.angle else m.size)) for a in m.actuators
        ),
        residual=c.residual,
        disagreement=c.disagreement,
        steps=solution.steps,
        iterations=solution.iterations,
        assembly=way_from_home(m, solution),
        margin=near.sigma,
        turn=turn_of(near.sigma),
        threshold=limit,
        jacobian=jacobian,
        factors=values,
        statement=analysis.statement,
        limbs=limb_numbers(m, near, own),
        unit=m.robot.units,
        softest=motions[-1],
        motions=gained,
        types=singularity_types(m, c, gained) if verdict == "singular" else (),
        points=points_at(m, c),
        notes=(
            *solution.target.notes,
            *m.notes,
            *([] if m.robot.mobility else [STILL]),
            *_far(m),
            *_notes(m, own),
            *_closure(jacobian),
        ),
    )


def _verdict(m: Linkage, near: LimbMargin, own: Sequence[float], limit: Threshold) -> tuple[str, str]:
    sigma, turn = near.sigma, turn_of(near.sigma)
    assert limit.angle is not None
    word = decide(sigma, SOLVED, close=margin_of(limit.angle))
    if word == "singular":
        return word, "σ is 0 within rounding: the wrenches of all limbs do not hold the platform."
    lost = [limb.name for limb, c in zip(m.robot.limbs, own, strict=True) if c <= SOLVED]
    if lost:
        verbs = "is singular by itself: its own twists", "are singular by themselves: the twists of each"
        return "singular", f"{agreeing(lost, *verbs)} depend on each other."
    if m.looped:
        certain = "It is only certain that"
        words = "no body of the robot can move with the actuators locked; as its limbs have loops of their own, σ does"
        words += " not bound how far a singular configuration is"
    else:
        certain = "It is only certain that,"
        words = "apart from the limbs' own singularities, no configuration is singular while the wrenches of every limb"
        words += f" turn by less than {safe(turn)} relative to the platform"
    if word == "regular":
        return word, f"{_capital(words)} (threshold {limit.text})."
    return word, f"{certain} {words}; the threshold is {limit.text}."


def _causes(values: Sequence[ConditionFactor], verdict: str) -> tuple[str, ...]:
    live = [f for f in values if f.live and isfinite(f.value)]
    if verdict == "singular":
        zero = [f for f in live if abs(f.value) <= _NEAR_ZERO]
        return tuple(f"{_capital(cause_of(f))} ({f.kind} singularity)." for f in zero)
    if verdict == "close" and live:
        least = min(live, key=lambda f: abs(f.value))
        return (f"Nearly: {cause_of(least)}.",)
    return ()


def cause_of(f: ConditionFactor) -> str:
    """When a factor vanishes, in words."""
    return f.statement or f"{f.expression} = 0{f', divided by the cofactor {f.cofactor}' if f.cofactor else ''}"


def _capital(words: str) -> str:
    return words[0].upper() + words[1:]


def _twists(m: Linkage, near: LimbMargin) -> tuple[Twist, ...]:
    return tuple(twist_of(row[:3], row[3:], near.centre, m.size) for row in near.motions)


def _far(m: Linkage) -> tuple[str, ...]:
    """That the robot is so far from the origin that coordinates as floats do not give σ to the accuracy of verdicts."""
    points = [m.home.values[d.name] for d in m.robot.family.definitions if d.sort == "point"]
    away = float(np.abs(points).max(initial=0.0)) / m.size
    blur = DIGITS * away
    if blur <= _BLURRED:
        return ()
    return (
        f"the robot is {away:.1g} times its size away from the origin: rounding may change σ by about {blur:.1g}; take"
        " an origin near it",
    )


def _closure(j: WrenchJacobian) -> tuple[str, ...]:
    cables = j.amplification.cables
    if cables is None or cables.held:
        return ()
    return ("wrench closure is lost: the cables only pull, and do not hold the platform against every wrench",)


def _notes(m: Linkage, own: Sequence[float]) -> tuple[str, ...]:
    return tuple(
        f"{limb.name} is nearly singular by itself (least singular value of its twists {c:.2g}), so what is said"
        " about the platform holds only near here"
        for limb, c in zip(m.robot.limbs, own, strict=True)
        if SOLVED < c <= 0.01
    )
