r"""Closing the loops: from home to a wanted pose or wanted actuators, step by step on the branch of home.

The equations of one step are those of `loops`. The wanted values grow from those at home in steps that halve where the
solution would go far or is not found, and start anew from each configuration reached. A step counts when it is proved
that it follows the branch (`branch`), and halves until it is; where even the shortest one is not proved, the solution
says from where on its branch is in doubt. Where a few halvings are enough all steps are gone `at_once`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.english import agreeing, listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.checks import STILL
from gcrules.mechanisms.kinematics.at_once import Steady, gone_at_once, gone_beside
from gcrules.mechanisms.kinematics.branch import Steps, can_be_followed, follow_branch
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed, stopped
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import Course, Joints, close_loops, loop_rows, units_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import sound
from gcrules.mechanisms.kinematics.targets import Target, check_count, written
from gcrules.screws.pose import FAR
from gcrules.screws.pose_text import SHIFTS, TURNS, VECTOR

__all__ = ["Solution", "beside", "check_moves", "check_target", "closed_near", "free_coordinates", "goal", "solve"]

_LONGEST = 0.25  # of a coordinate, at first: rad, or parts of the robot's size
_BESIDE = 0.1  # of a coordinate: rad, or parts of the robot's size
_SHORTEST = 1.0 / 4096
_SHORTEST_PROOF = 1.0 / 16384
_SLOWER = 1.2  # how fast steps grow again after one was too long to be proved
_DEPENDENT = 1e-7
_PREFERRED = 0.01  # of the largest rate: a coordinate that moves less is not proposed
_MOST_STEPS = 1000


@dataclass(frozen=True, eq=False)
class Solution:
    """The configuration, what was wanted, the number of iterations, and the configurations on the way from home with
    the parts of the course at which they lie. The branch is proved but from the part `doubt` on, if there is one.
    """

    configuration: Configuration
    target: Target
    iterations: int = 0
    way: tuple[Configuration, ...] = ()
    parts: tuple[float, ...] = ()
    doubt: float | None = None

    @property
    def steps(self) -> int:
        """How many steps lead there from home."""
        return len(self.way)


def solve(m: Linkage, wanted: Target, near: Solution | None = None) -> Solution:
    """The configuration in which the wanted values are reached, on the straight way from home; quicker where the
    solution for values `near` by is known. Raises InputError where it does not assemble.
    """
    check_target(m, wanted)
    course = Course(m, wanted)
    if near is not None and near.doubt is None and near.parts[-1:] == (1.0,) and _is_beside(course, near.target):
        steady = gone_beside(course, m.home, near.parts, near.way)
        if steady is not None:
            return _gone(course, Solution(m.home, wanted), steady)
    return goal(course, Solution(m.home, wanted), 0.0, 1.0)


def _is_beside(course: Course, other: Target) -> bool:
    """Whether a target is near that of a course, and of its kind."""
    w = course.target
    if w.start is not None or other.start is not None:
        return False
    if (w.names, w.driven, w.whole is None) != (other.names, other.driven, other.whole is None):
        return False
    return float(np.abs((w.values - other.values) / course.weights).max(initial=0.0)) <= _BESIDE


def _gone(course: Course, start: Solution, steady: Steady) -> Solution:
    """The solution where a way ends."""
    way, parts = (*start.way, *steady.way), (*start.parts, *steady.parts)
    return Solution(way[-1], course.target, start.iterations + steady.iterations, way, parts)


def beside(m: Linkage, wanted: Target, here: Configuration) -> Configuration:
    """The configuration near this one in which the wanted values are reached, by one step without proof; the one that
    `solve` finds where the step is too long. Raises InputError where it does not assemble.
    """
    check_target(m, wanted)
    course = Course(m, wanted)
    try:
        return closed_near(course, here, 1.0)
    except NotClosed:
        return goal(course, Solution(m.home, wanted), 0.0, 1.0).configuration


def goal(course: Course, start: Solution, at: float, end: float) -> Solution:
    """From the solution at one part of the course to that at another. Raises InputError where it does not assemble."""
    far = abs(end - at)
    if not far:
        return start
    steps = int(max(1.0, np.ceil(far * course.length / _LONGEST)))
    if steps <= _MOST_STEPS and start.doubt is None and can_be_followed(course.m, course.target):
        straight = gone_at_once(course, start.configuration, [*np.linspace(at, end, steps + 1)])
        if straight is not None:
            return _gone(course, start, straight)
    step = far / steps
    done, part, found, growth = 0.0, 0.0, start, 2.0
    while done < far:
        checkpoint()
        step = min(step, far - done)
        part = at + (done + step) * np.sign(end - at) if done + step < far else end
        before, doubt = at + done * float(np.sign(end - at)), found.doubt
        here = found.configuration
        try:
            joints = _solved(course, here, part)
            grown = (part - before) * course.target.values[None]
            step_there = Steps.of(Configurations.of([here]), joints, grown)
            if doubt is None and not follow_branch(course.m, course.target, step_there)[0]:
                if step > _SHORTEST_PROOF * max(far, 1e-3) and can_be_followed(course.m, course.target):
                    step, growth = step / 2, _SLOWER
                    continue
                doubt = before
            there = _configuration(course.m, here, joints)
        except NotClosed as fault:
            step /= 2
            if step < _SHORTEST * max(far, 1e-3):
                named = course.target.whole is None and not course.target.driven
                told = _told(course, here) / _told(course, course.m.home) if named else 1.0
                raise stopped(course.m, here, course.target, before, told, fault) from None
            continue
        done += step
        step *= growth
        if len(found.way) >= _MOST_STEPS:
            raise InputError(
                f"{course.m.robot.id} comes {100 * (at + done * float(np.sign(end - at))):.3g}% of the way to"
                f" {course.target.text} in {_MOST_STEPS:,} steps",
                hint="check the unit, and ask for less",
            )
        way, parts = (*found.way, there), (*found.parts, part)
        found = Solution(there, course.target, found.iterations + joints.iterations, way, parts, doubt)
    return found


def closed_near(course: Course, here: Configuration, part: float) -> Configuration:
    """The configuration near this one at a part of the course. Raises NotClosed."""
    return _configuration(course.m, here, _solved(course, here, part))


def _solved(course: Course, here: Configuration, part: float) -> Joints:
    """The joints near a configuration at a part of the course. Raises NotClosed."""
    joints = close_loops(course, Configurations.of([here]), course.goal(np.array([part])))
    if not joints.closed[0]:
        raise NotClosed("joints move far in a small step" if joints.far[0] else "the loops do not close")
    return joints


def _configuration(m: Linkage, here: Configuration, joints: Joints) -> Configuration:
    """The configuration after these amounts. Raises NotClosed where the robot has left its family there."""
    links, amounts = tuple(k[0] for k in joints.links), tuple(a[0] for a in joints.amounts)
    values, chains, off = sound(m, here.values, here.chains, links, amounts)
    return Configuration(
        values,
        tuple(k @ before for k, before in zip(links, here.links, strict=True)),
        tuple(a + before for a, before in zip(amounts, here.joint_values, strict=True)),
        chains,
        float(joints.residual[0]),
        off,
    )


def check_moves(m: Linkage) -> None:
    """Raises InputError for a robot of mobility 0, which has no other configuration near home to be asked about."""
    if not m.robot.mobility:
        raise InputError(
            f"{m.robot.id} cannot be asked about other poses: {STILL}",
            hint="give its limbs more joints, or take one of them away",
        )


def check_target(m: Linkage, wanted: Target) -> None:
    """Raises InputError where the wanted coordinates are too few or too many or do not determine the pose near home, or
    where home itself is singular for the actuators, or where it is too far to get there step by step.
    """
    check_moves(m)
    if not Course(m, wanted).length <= FAR:
        raise InputError(
            f"a configuration is more than {FAR:,.0f} times the robot's size, or as many radians, from home",
            hint="check the unit",
        )
    if wanted.whole is not None:
        return
    if not wanted.driven and len(wanted.names) != m.robot.mobility:
        told = dict(zip(wanted.names, map(float, wanted.values), strict=True))
        example = written({n: told.get(n, 0.0) for n in _independent(m, wanted.names)})
        check_count(told, m.robot.mobility, "coordinate", f"the others follow from them: {example}")
    if len(wanted.names) >= m.robot.mobility and _told(Course(m, wanted), m.home) > _DEPENDENT:
        return
    if wanted.driven:
        raise InputError(
            f"{m.robot.id} is singular at home: its actuators do not determine the pose there",
            hint="ask for coordinates of the pose instead, or give another home",
        )
    raise InputError(
        f"{agreeing(wanted.names, 'does', 'do')} not determine the pose of {m.robot.id} near home",
        hint=f"independent there are, for example, {listed(_independent(m))}",
    )


def _independent(m: Linkage, first: Sequence[str] = ()) -> tuple[str, ...]:
    """The free coordinates. Raises InputError where rounding leaves fewer of them than the platform has freedoms."""
    found = free_coordinates(m, first)
    if len(found) < m.robot.mobility:
        raise InputError(
            f"no {m.robot.mobility} coordinates determine the pose of {m.robot.id} near home, as far as numbers of 16"
            " digits tell",
            hint="is home singular, or are some lengths in another unit? Directions count where bars lie along them",
        )
    return found


def free_coordinates(m: Linkage, first: Sequence[str] = ()) -> tuple[str, ...]:
    """As many coordinates as the platform has freedoms, on which its pose depends near home; those named `first` are
    preferred where they tell something, then shifts.
    """
    turns = VECTOR if any(n in VECTOR for n in first) else TURNS
    order = ("x", "y", turns[-1]) if m.robot.family.plane else (*SHIFTS, *turns)
    names = [*first, *(n for n in order if n not in first)]
    rows = _rates(Course(m, Target(tuple(names), np.zeros(len(names)))), m.home)
    chosen: list[str] = []
    for _ in range(m.robot.mobility):
        sizes = np.linalg.norm(rows, axis=1)
        preferred = [k for k, n in enumerate(names) if n in first and sizes[k] > _PREFERRED * sizes.max()]
        best = next(k for k in (*preferred, *range(len(names))) if preferred or sizes[k] >= 0.5 * sizes.max())
        if sizes[best] <= _DEPENDENT:
            break
        chosen.append(names[best])
        unit = rows[best] / sizes[best]
        rows = rows - np.outer(rows @ unit, unit)
    return tuple(sorted(chosen, key=names.index))  # those named first in the order in which they were given


def _told(course: Course, here: Configuration) -> float:
    """How well the wanted values tell how the robot moves there: their least singular value on its ways to move."""
    rates = _rates(course, here)
    return float(np.linalg.svd(rates, compute_uv=False)[-1]) if rates.shape[1] >= len(rates) else 0.0


def _rates(course: Course, here: Configuration) -> Floats:
    """The derivatives of the wanted values by the ways to move in a configuration (in units of all amounts)."""
    m, only = course.m, Configurations.of([here])
    twists = [c.shared_twists for c in only.chains]
    rows = course.rows(only.platform, twists)[0] * units_of(m)
    closing = loop_rows(twists, only.platform, m)[0] * units_of(m)
    if not len(closing):
        return np.asarray(rows)
    _, s, v = np.linalg.svd(closing)
    return np.asarray(rows @ v[int((s > _DEPENDENT * max(s[0], 1.0)).sum()) :].T)
