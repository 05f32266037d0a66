r"""A robot along a path: every singular place on it, proved complete; numbers at samples; the least margin.

>>> from gcrules.mechanisms.description.platform_file import parse_platform
>>> robot = parse_platform('''
... legs: [ab, af, cb, cd, ed, ef]
... points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}
... ''')
>>> path(robot, ["0 0 0", "0 0 -6"])
<PathReport singular: 1 zeros, margin at least 0, 0°>
>>> [(str(z.lower), z.kind, z.multiplicity) for z in path(robot, ["0 0 0", "0 0 -6"]).zeros]
[('2/3', 'crosses', 3)]
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from os import PathLike, fspath
from typing import Any

import numpy as np

from gcrules.core.budget import report as report_progress
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.path import path_of_limbs
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.methods import Methods, method
from gcrules.poses.numbers.arrays import from_poses, matrices
from gcrules.poses.numbers.many import PoseNumbers, numbers
from gcrules.poses.numbers.pose_arguments import one_pose
from gcrules.poses.paths.least import Least, least
from gcrules.poses.paths.polynomials import polynomials
from gcrules.poses.paths.report import PathReport, Zero
from gcrules.poses.paths.sampling import SAMPLES, per_segment
from gcrules.poses.paths.segments import Segments, segments
from gcrules.poses.paths.table import load_poses, load_targets
from gcrules.poses.paths.zeros import SingularPlace, Stretch, places, stretches
from gcrules.poses.pose_report import report_of_legs
from gcrules.screws.guarantees import ROUNDING
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import DEFAULT, Threshold, angle_threshold, margin_of, safe, turn_of
from gcrules.screws.verdict import decide

__all__ = ["MAX_SAMPLES", "path", "path_of", "path_of_legs"]

MAX_SAMPLES = 200_000


def path(
    source: Source,
    poses: str | PathLike[str] | Sequence[Any],
    *,
    samples: int = SAMPLES,
    about: str | Sequence[Any] = "centroid",
    threshold: str | Threshold = DEFAULT.text,
) -> PathReport | RobotPath:
    """Every singular pose on a path through given poses, proved complete, and numbers along it (a `PathReport`, for a
    robot of joints a `RobotPath`).

    `source` and `about` are those of `pose`. `poses` is the name of a table as for `gcrules path --poses`, or two poses
    or more, each as for `pose`. Between two of them the centre moves on a straight line and the platform turns about
    one axis, the shorter way. `samples` is the number of places at which values are given; singular poses are found
    between them, too. `threshold` is an angle.

    A pose may be "home". For a robot of joints all others name the same coordinates, which grow evenly between two
    of them; stretches in which nothing is proved are listed. Raises InputError for what is no path and for degenerate
    robots.
    """
    return path_of(mechanism(source, about=about), poses, samples, threshold)


def path_of(
    found: Mechanism,
    poses: str | PathLike[str] | Sequence[Any],
    samples: int = SAMPLES,
    threshold: str | Threshold = DEFAULT.text,
) -> PathReport | RobotPath:
    """The path of a mechanism; arguments and errors as for `path`."""
    return method(_PATH, found, "a path")(poses, samples, threshold)


def _of_limbs(
    m: Limbs, poses: str | PathLike[str] | Sequence[Any], samples: int, threshold: str | Threshold
) -> PathReport | RobotPath:
    """By the exact polynomial where the limbs are six legs."""
    try:
        legs = m.six_legs()
    except InputError:
        listed = load_targets(fspath(poses), m.unit) if isinstance(poses, (str, PathLike)) else poses
        if not hasattr(listed, "__iter__"):
            raise _no_path(poses) from None
        limit = angle_threshold(threshold, "along a path")
        return path_of_limbs(m, list(listed), samples=samples, threshold=limit)
    return path_of_legs(legs, poses, samples, threshold)


def _no_path(given: Any) -> InputError:
    return InputError(f"{str(given)[:40]} is not a path", hint="give two poses or more, or the name of a table")


def path_of_legs(
    m: SixLegs,
    poses: str | PathLike[str] | Sequence[Any],
    samples: int = SAMPLES,
    threshold: str | Threshold = DEFAULT,
    asked: float = 0.0,
) -> PathReport:
    """The path of a platform on six legs: all zeros of the exact polynomial. The bound of the margin is driven up to
    what is `asked` for, where that is near the least one.
    """
    moving = m.rig
    limit = angle_threshold(threshold, "along a path")
    found, notes = _poses(poses, moving.unit)
    each = per_segment(samples, len(found) - 1, MAX_SAMPLES)
    way = segments(moving, found)
    shift, quaternion = way.rows
    moving.ends(shift, matrices(quaternion))  # refuses poses that are too far away, and legs of no length
    parts, each_degree = polynomials(way)
    zeros = tuple(_zero(m, way, p, limit) for p in places(parts))
    still = tuple(_explained(m, way, s, limit) for s in stretches(parts))
    report_progress("sampling")
    lowest = _least(way, each, zeros, still, asked)
    verdict, reason = _verdict(zeros, still, lowest, limit)
    return PathReport(
        rig=moving,
        condition=m.analysis.condition,
        poses=found,
        verdict=verdict,
        reason=reason,
        zeros=zeros,
        stretches=still,
        least=lowest,
        degrees=each_degree,
        threshold=limit,
        notes=notes,
        **_samples(m, way, each, zeros, still, lowest, limit),
    )


def _poses(given: str | PathLike[str] | Sequence[Any], unit: str) -> tuple[tuple[Pose, ...], tuple[str, ...]]:
    if isinstance(given, (str, PathLike)):
        found, notes = load_poses(fspath(given), unit)
    else:
        if not hasattr(given, "__iter__"):
            raise _no_path(given)
        listed = [_pose(k, p, unit) for k, p in enumerate(given)]
        found, notes = tuple(listed), tuple(dict.fromkeys(n for p in listed for n in p.notes))
    if len(found) < 2:
        raise InputError(f"a path needs two poses or more, found {len(found)}", hint="for one pose: gcrules pose")
    return found, notes


def _pose(number: int, given: Any, unit: str) -> Pose:
    """A `Pose`, its text, "home", or a translation of three numbers. Raises InputError that names the pose."""
    try:
        found = one_pose(given, {}, False, unit)
    except GcrulesError as fault:
        if fault.source is None:
            fault.args = (f"pose {number}: {fault.message}",)
            fault.message = f"pose {number}: {fault.message}"
        raise
    if found is None:
        raise InputError(f"pose {number} is not a pose", hint='write text such as "0 0 5; euler zyx 10 0 0 deg"')
    return found


def _zero(m: SixLegs, way: Segments, p: SingularPlace, limit: Threshold) -> Zero:
    pose = _at(way, p.middle)
    causes, dependence = _why(m, pose, limit)
    return Zero(p.lower, p.upper, p.kind, p.multiplicity, pose, causes, dependence)


def _explained(m: SixLegs, way: Segments, s: Stretch, limit: Threshold) -> Stretch:
    causes, dependence = _why(m, _at(way, Fraction(s.start + s.end, 2)), limit)
    return replace(s, causes=causes, dependence=dependence)


def _at(way: Segments, parameter: Fraction) -> Pose:
    k = min(int(parameter), len(way) - 1)
    return way[k].pose(parameter - k)


def _why(m: SixLegs, pose: Pose, limit: Threshold) -> tuple[tuple[str, ...], Any]:
    """Causes, and what the legs have in common; where a leg has no length that is the cause."""
    moving = m.rig
    lengths = np.linalg.norm(_ends(moving, *from_poses([pose]))[0] - moving.base, axis=1)
    short = [name for name, length in zip(moving.names, lengths, strict=True) if length <= ROUNDING * moving.size]
    if short:
        return tuple(f"The leg {name} has no length." for name in short), None
    found = report_of_legs(m, pose, threshold=limit, nearest=False)
    return found.causes, found.dependence


def _ends(moving: MovingPlatform, translations: Any, rotations: Any) -> Any:
    """As `MovingPlatform.ends`, where legs may have no length."""
    return np.einsum("nij,kj->nki", rotations, moving.arms) + (moving.centre_of_turns + translations)[:, None, :]


def _least(way: Segments, per_segment: int, zeros: Sequence[Zero], still: Sequence[Stretch], asked: float) -> Least:
    if zeros or still:
        return Least(0.0, min([z.parameter for z in zeros[:1]] + [float(s.start) for s in still[:1]]), 0.0)
    return least(way, per_segment, asked=asked)


def _verdict(zeros: Sequence[Zero], still: Sequence[Stretch], lowest: Least, limit: Threshold) -> tuple[str, str]:
    if zeros or still:
        found = [f"at {len(zeros)} place{'s' * (len(zeros) > 1)}"] if zeros else []
        found += [f"along {len(still)} whole stretch{'es' * (len(still) > 1)}"] if still else []
        return "singular", f"The path is singular {' and '.join(found)}, and nowhere else."
    assert limit.angle is not None
    if decide(lowest.margin, lowest.rounding) == "singular":
        return "singular", f"σ = {lowest.margin:.2g} is 0 within rounding (to 1e-12 of the robot's size)."
    turn = turn_of(lowest.bound)
    words = f"some leg has to turn by {safe(turn)} relative to the platform before one is (threshold {limit.text})."
    word = decide(lowest.bound, close=margin_of(limit.angle))
    if word == "regular":
        return word, f"No pose of the path is singular, and from each of them {words}"
    return "close", f"No pose of the path is singular, but it is only certain that {words}"


def _samples(
    m: SixLegs,
    way: Segments,
    per_segment: int,
    zeros: Sequence[Zero],
    still: Sequence[Stretch],
    lowest: Least,
    limit: Threshold,
) -> dict[str, Any]:
    """The arrays of the report. A place where a leg has no length is left out: there are no numbers."""
    moving = m.rig
    regular = np.linspace(0, len(way), per_segment * len(way) + 1)
    special = np.array([lowest.parameter, *(z.parameter for z in zeros)])
    where = np.union1d(regular[~_among(regular, special)], special)  # no sample that is a zero but for rounding
    first = np.minimum(where.astype(int), len(way) - 1)
    shift, turn = way.motions.arrays(first, where - first)
    turn /= np.linalg.norm(turn, axis=1, keepdims=True)
    rotations = matrices(turn)
    lengths = np.linalg.norm(_ends(moving, shift, rotations) - moving.base, axis=2)
    whole = lengths.min(axis=1) > ROUNDING * moving.size
    conditions = (m.analysis.condition, *m.analysis.readings)
    known = ROUNDING * moving.size
    found = numbers(moving, conditions, (shift[whole], rotations[whole]), limit, known)
    where = where[whole]
    singular = np.isin(where, [z.parameter for z in zeros])
    for s in still:
        singular |= (where >= s.start) & (where <= s.end)
    return {
        "parameters": where,
        "translations": shift[whole],
        "quaternions": turn[whole],
        "numbers": _settled(found, singular),
    }


def _among(values: Any, others: Any) -> Any:
    """Which values are within 1e-9 of one of the others."""
    listed = np.sort(others)
    after = np.searchsorted(listed, values)
    near = [np.abs(values - listed[np.clip(after - k, 0, len(listed) - 1)]) for k in (0, 1)]
    return np.minimum(*near) <= 1e-9


def _settled(n: PoseNumbers, singular: Any) -> PoseNumbers:
    """Where it is proved that a pose is singular, 0 stands in place of what rounding has left."""

    def zero(values: Any) -> Any:
        return np.where(singular, 0.0, values)

    return replace(
        n,
        value=zero(n.value),
        margin=zero(n.margin),
        turn=zero(n.turn),
        shift=zero(n.shift),
        rotation=zero(n.rotation),
        combined=zero(n.combined),
        smallest_singular_value=zero(n.smallest_singular_value),
        condition_number=np.where(singular, np.inf, n.condition_number),
        verdict=np.where(singular, "singular", n.verdict),
    )


_PATH: Methods[PathReport | RobotPath] = {SixLegs: path_of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
