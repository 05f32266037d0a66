r"""A robot of joints along a path: the loops are closed step by step, and what lies between the steps is proved.

Each step follows one branch of solutions, proved by Krawczyk's operator; that nothing between two steps is singular is
proved likewise (`gcrules.mechanisms.kinematics.branch`), for many steps at once (`gcrules.poses.limbs.drive`). Segments
in which that is not proved are gone over again, one by one (`gcrules.poses.limbs.way`). So a singular configuration can
lie only where the determinant of all wrenches changes its sign, which is located, or in short stretches that are listed
as undecided: as a rule where the path touches a singular configuration, or where a limb is singular by itself. Of a
path without either a bound of the margin is proved (`gcrules.poses.limbs.way_bounds`).

>>> from gcrules.mechanisms.mechanism import mechanism
>>> from gcrules.screws.threshold import threshold_of
>>> found = path_of_limbs(mechanism("3-rpr"), ["x=0, y=0, yaw=0deg", "x=0, y=0, yaw=60deg"], samples=4,
...                       threshold=threshold_of("0.5 deg"))
>>> found.verdict, [round(c.parameter, 4) for c in found.crossings], found.undecided
('singular', [0.2952], ())
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.core.dataclass import dataclass
from gcrules.core.english import agreeing, listed
from gcrules.core.errors import GcrulesError, InputError
from gcrules.core.floats import rounded_down
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.kinematics.actuations import amplified
from gcrules.mechanisms.kinematics.amplification import Amplifications
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.itinerary import Itinerary
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.margin import limb_margins, margin, margins
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import Solution, check_target, free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.limbs.drive import drive
from gcrules.poses.limbs.factors import factor_values, factors
from gcrules.poses.limbs.nodes import Nodes
from gcrules.poses.limbs.path_report import Crossing, RobotPath
from gcrules.poses.limbs.pose_report import cause_of, target_of
from gcrules.poses.limbs.way import Stretch, Way
from gcrules.poses.limbs.way_bounds import WayBounds, no_bounds, way_bounds
from gcrules.poses.numbers.motion import twist_of
from gcrules.poses.paths.least import Least
from gcrules.poses.paths.sampling import SAMPLES, per_segment
from gcrules.screws.pose_text import HOME
from gcrules.screws.threshold import Threshold, margin_of, safe, turn_of
from gcrules.screws.verdict import SOLVED, decide

__all__ = ["path_of_limbs", "path_targets"]

Truths = NDArray[np.bool_]

MAX_SAMPLES = 20_000
_STEP = 0.125  # rad, or parts of the robot's size: what is proved at once, as a rule
_MOST_BOUNDED = 20_000  # steps of a path: of longer ones the margin is that of the samples
_MOST_STEPS = 2000  # between two poses: more are gone without being predicted


def path_of_limbs(
    found: Limbs, poses: Sequence[Any], *, samples: Any = SAMPLES, threshold: Threshold, asked: float = 0.0
) -> RobotPath:
    """The path through `poses`, each as for `target_of`, or "home"; all of the same coordinates. Numbers are given at
    `samples` places, beside the poses and the crossings. The bound of the margin is driven up to what is `asked` for,
    where that is near the least one.

    Raises InputError for what is no path, and where the robot does not assemble on it.
    """
    m = found.linkage
    targets = path_targets(m, poses)
    number = len(targets) - 1
    each = per_segment(samples, number, MAX_SAMPLES)
    check_target(m, targets[0])
    first = solve(m, targets[0]) if targets[0].values.any() else Solution(m.home, targets[0])
    way = Itinerary(m, tuple(targets))
    parameters, sampled = _places(way, each)
    driven = drive(way, first.configuration, parameters)
    doubt = driven.doubt if first.doubt is None else 0.0
    left = np.unique(way.segments(parameters[:-1][~driven.regular])).tolist()
    parts = []
    for n, k in enumerate(left):
        checkpoint()
        report_progress(f"segment {n + 1} of {len(left)} that are looked at more closely")
        start = driven.nodes.one(int(np.searchsorted(parameters, k)))
        parts.append(_segment(way.courses[k], found.analysis, k, start))
    crossed = [c for part in parts for c in part.crossed]
    nodes = driven.nodes[sampled]
    sure = doubt is None and len(parameters) <= _MOST_BOUNDED and not any(p.crossed or p.undecided for p in parts)
    bounds = way_bounds(way, driven.nodes, asked) if sure else no_bounds(way)
    if crossed:
        nodes = Nodes.together([nodes, Nodes.of(*zip(*crossed, strict=True))])
    return _report(found, threshold, targets, parts, nodes, doubt, bounds)


@dataclass(frozen=True, eq=False)
class _Segment:
    """What was found between two poses, its places as parameters of the path, and configurations at the crossings."""

    crossings: tuple[Crossing, ...]
    undecided: tuple[Stretch, ...]
    crossed: tuple[tuple[float, Configuration], ...]


def _places(way: Itinerary, each: int) -> tuple[Floats, Truths]:
    """The parameters at which configurations are sought: `each` samples of each segment, and places between them where
    these are further apart than a step; and which of them are samples.
    """
    parameters, sampled = [], []
    for k, course in enumerate(way.courses):
        more = -(-_steps(course) // each)
        parameters.append(k + np.linspace(0, 1, each * more + 1)[:-1])
        sampled.append(np.arange(each * more) % more == 0)
    return np.append(np.concatenate(parameters), len(way.courses)), np.append(np.concatenate(sampled), True)


def path_targets(m: Linkage, poses: Sequence[Any]) -> list[Target]:
    """What poses ask for, two or more, all by the same coordinates. Raises InputError."""
    given = list(poses)
    if len(given) < 2:
        raise InputError(f"a path needs two poses or more, found {len(given)}", hint="for one pose: gcrules pose")
    read = [_target(m, k, one) for k, one in enumerate(given)]
    known = next((t for t in read if t is not None), None)
    if known is None:  # all are home
        names = free_coordinates(m)
        known = Target(names, np.zeros(len(names)), text=HOME)
    return [_alike(known, k, t) for k, t in enumerate(read)]


def _target(m: Linkage, number: int, given: Any) -> Target | None:
    """What is given, None for home."""
    if isinstance(given, str) and given.strip().lower() == HOME:
        return None
    try:
        return target_of(m, given, None)
    except GcrulesError as fault:
        if fault.source is None:
            fault.args = (f"pose {number}: {fault.message}",)
            fault.message = f"pose {number}: {fault.message}"
        raise


def _alike(known: Target, number: int, one: Target | None) -> Target:
    """A pose in the coordinates of another one, home where there is none."""
    if one is None:
        whole = None if known.whole is None else np.eye(4)
        return Target(known.names, np.zeros(len(known.names)), whole=whole, text=HOME)
    if set(one.names) != set(known.names):
        raise InputError(
            f"pose {number} gives {listed(one.names)}, the others {listed(known.names)}",
            hint="all poses of a path name the same coordinates",
        )
    order = [one.names.index(n) for n in known.names]
    return Target(known.names, one.values[order], whole=one.whole, text=one.text, notes=one.notes)


def _steps(course: Course) -> int:
    """How many steps are taken between two poses; 1 where they are too far apart to be gone."""
    steps = np.ceil(course.length / _STEP)
    return int(steps) if 1 < steps <= _MOST_STEPS else 1


def _segment(course: Course, analysis: RobotAnalysis, k: int, start: Configuration) -> _Segment:
    """What lies between two poses that is not proved to be regular; gone step by step."""
    try:
        way, _ = Way.to(course.m, course.target, start)
    except InputError as fault:
        raise InputError(f"between pose {k} and pose {k + 1}: {fault.message}", hint=fault.hint) from None
    changes, unknown = way.signs()
    left = list(way.unproved())
    crossings = []
    for a, b in changes:
        around = next((s for s in left if s[0] <= b and a <= s[1]), (a, b))
        if around in left and sum(around[0] <= y and x <= around[1] for x, y in changes) == 1:
            left.remove(around)
        else:  # more may lie there: it stays undecided but for the change itself
            around = (a, b)
        crossings.append(_crossing(way, analysis, k, (a, b), around))
    if unknown is not None and not left and not changes:
        left = [(unknown, unknown)]
    crossed = tuple((c.parameter, way.at(c.parameter - k)) for c in crossings)
    return _Segment(tuple(crossings), tuple((float(k + a), float(k + b)) for a, b in left), crossed)


def _crossing(way: Way, analysis: RobotAnalysis, k: int, at: Stretch, around: Stretch) -> Crossing:
    m = way.m
    part = _secant(way, at)
    (before, after), middle = (factors(analysis, way.at(p).values) for p in at), way.at(part)
    changed = [cause_of(a) for a, b in zip(before, after, strict=True) if a.live and a.value * b.value < 0]
    near = margin(m, middle)
    motion = twist_of(near.motions[-1][:3], near.motions[-1][3:], near.centre, m.size)
    names = way.target.names
    place = without_rounding(names, coordinates(names, middle.platform, m.centre), m.size)
    a, b = (float(k + p) for p in at)
    first, last = (float(k + p) for p in around)
    return Crossing(k + part, a, b, first, last, tuple(map(float, place)), tuple(changed), motion)


def _secant(way: Way, at: Stretch) -> float:
    """Where the determinant is 0 if it is linear between two places so near to each other."""
    low, high = (abs(float(way.frames(way.at(p)).determinant[0])) for p in at)
    return float(at[0] + (at[1] - at[0]) * low / (low + high)) if low + high > 0 else sum(at) / 2


def _report(
    found: Limbs,
    limit: Threshold,
    targets: Sequence[Target],
    parts: Sequence[_Segment],
    nodes: Nodes,
    doubt: float | None,
    bounds: WayBounds,
) -> RobotPath:
    m = found.linkage
    parameters, order = np.unique(nodes.parameters[::-1], return_index=True)  # of two at one place that of a crossing
    nodes = nodes[len(nodes) - 1 - order]
    sigma = np.concatenate([margins(m, some.here).sigma for some in nodes.blocks()])
    own = np.concatenate([limb_margins(m, some.here).min(axis=1) for some in nodes.blocks()])
    values = np.concatenate([factor_values(found.analysis, some.values) for some in nodes.blocks()])
    crossings = tuple(c for part in parts for c in part.crossings)
    undecided = tuple(s for part in parts for s in part.undecided)
    at_crossing = np.isin(parameters, [c.parameter for c in crossings])
    sigma = np.where(at_crossing, 0.0, sigma)
    assert limit.angle is not None
    close = margin_of(limit.angle)
    verdicts = np.array([
        "singular" if c <= SOLVED else decide(s, SOLVED, close=close) for s, c in zip(sigma, own, strict=True)
    ])  # fmt: skip
    k = int(sigma.argmin())
    least = Least(float(sigma[k]), float(parameters[k]), bounds.least)
    if bounds.met < least.margin:
        least = Least(bounds.met, bounds.parameter, bounds.least)
    verdict, reason = _verdict(parameters, least, verdicts, crossings, undecided, limit, looped=m.looped)
    names = targets[0].names
    return RobotPath(
        robot=m.robot.id,
        title=m.robot.title,
        statement=found.analysis.statement,
        texts=tuple(t.text for t in targets),
        names=names,
        actuators=m.actuators,
        verdict=verdict,
        reason=reason,
        crossings=crossings,
        undecided=undecided,
        branch_doubt=doubt,
        threshold=limit,
        unit=m.robot.units,
        redundant=m.robot.redundant > 0,
        least=least,
        segment_bounds=bounds.segments,
        actuator_ranges=bounds.ranges,
        parameters=parameters,
        coordinates=coordinates(names, nodes.here.platform, m.centre),
        actuator_values=np.stack([nodes.here.joint_values[a.place][:, a.coordinate] for a in m.actuators], axis=1),
        margins=sigma,
        limb_margins=own,
        factors=tuple(f.expression for f in factors(found.analysis, m.home.values)),
        factor_values=values,
        verdicts=verdicts,
        amplifications=Amplifications.together([amplified(m, some.here) for some in nodes.blocks()]),
        notes=tuple(dict.fromkeys((*m.notes, *(n for t in targets for n in t.notes)))),
    )


def _verdict(
    parameters: Any,
    least: Least,
    verdicts: Any,
    crossings: Sequence[Crossing],
    undecided: Sequence[Stretch],
    limit: Threshold,
    *,
    looped: bool,
) -> tuple[str, str]:
    places = [f"{a:.5g} to {b:.5g}" if b > a else f"{a:.5g}" for a, b in undecided]
    open_ = f"; at parameter {listed(places)} it is not decided" if places else ""
    if crossings:
        some = agreeing([f"{c.parameter:.5g}" for c in crossings], "", "").strip()
        elsewhere = f"{open_}, and elsewhere nothing is singular, proved" if places else ", and nowhere else, proved"
        words = f"The path crosses a singular configuration at parameter {some}{elsewhere}."
        return "singular", words
    if "singular" in verdicts:
        first = float(parameters[verdicts == "singular"][0])
        return "singular", f"The path is singular at parameter {first:.5g}{open_}."
    where = f"σ = {least.margin:.4g} at parameter {least.parameter:.4g} is the least of all samples"
    if least.bound > 0:
        met = f"{least.margin:.4g} at parameter {least.parameter:.4g}"
        where = f"σ ≥ {rounded_down(least.bound)} everywhere, proved, and {met}"
    angle = safe(turn_of(least.margin))
    turn = f"from there the wrenches of some limb have to turn by {angle} (threshold {limit.text})"
    if looped:
        turn = (
            f"as its limbs have loops of their own, σ does not tell how far a singular one is (threshold {limit.text})"
        )
    if places:
        return "close", f"No singular configuration was found{open_}. {where}."
    word = "close" if "close" in verdicts else "regular"
    return word, f"No configuration of the path is singular, proved. {where}; {turn}."
