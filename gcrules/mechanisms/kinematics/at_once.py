r"""All steps of a course at once: steps that are too long to be proved are halved together, and all ends are looked at
together. Most solutions are found so; `solve.goal` goes the others step by step. Where a way to a target near by is
known, its steps are sought and proved again beside it, all together.

The screws of each limb are carried along with its links here, not made anew of the names of the file, so that the
proofs become harder far from the start: what is not proved within some halvings is left to others.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.attachments import Values, moved
from gcrules.mechanisms.kinematics.branch import Steps, follow_branch
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.loops import Course, close_loops, loop_gaps
from gcrules.mechanisms.kinematics.rigid_motions import Floats, lengths
from gcrules.mechanisms.kinematics.soundness import sound

__all__ = ["Steady", "gone_at_once", "gone_beside"]

_MOST = 8  # steps of equal length, at first
_HALVINGS = 5
_MOST_KEPT = 64  # steps that are tried again beside a course
_CLOSED = 1e-9  # how far loops may be open, in parts of the robot's size
_SAME = 1e-6  # of the robot's size, or of a direction's length


@dataclass(frozen=True, eq=False)
class Steady:
    """Configurations at parts of a course, each proved to follow the branch of the one before, and the number of
    iterations.
    """

    parts: tuple[float, ...]
    way: tuple[Configuration, ...]
    iterations: int


def gone_at_once(course: Course, start: Configuration, parts: Sequence[float]) -> Steady | None:
    """From a configuration, at the first of the parts, through the others; None where that is not proved."""
    if not 1 < len(parts) <= _MOST + 1:
        return None
    nodes, iterations = [Configurations.of([start])], 0
    for part in parts[1:]:
        joints = close_loops(course, nodes[-1], course.goal(np.array([part])))
        if not joints.closed[0]:
            return None
        nodes.append(nodes[-1].after(joints.amounts, joints.links))
        iterations += joints.iterations
    return _proved(course, start, Configurations.together(nodes[1:]), np.array(parts), iterations)


def gone_beside(
    course: Course, start: Configuration, parts: Sequence[float], way: Sequence[Configuration]
) -> Steady | None:
    """From a configuration at the beginning of a course through parts of it, at which the `way` along another course
    from there, to a target near by, is known: all are sought there together. None where that is not proved, and for a
    single step, which takes no longer by itself.
    """
    if not 1 < len(way) <= _MOST_KEPT:
        return None
    home = Configurations.of([start] * len(way))
    amounts = zip(*(c.joint_values for c in way), start.joint_values, strict=True)
    guess = [np.stack(several) - before for *several, before in amounts]
    joints = close_loops(course, home, course.goal(np.array(parts)), guess)
    if not joints.closed.all():
        return None
    there = home.after(joints.amounts, joints.links)
    return _proved(course, start, there, np.array([0.0, *parts]), joints.iterations)


def _proved(
    course: Course, start: Configuration, there: Configurations, parts: Floats, iterations: int
) -> Steady | None:
    """Steps from a configuration, at the first of the parts, to those at the others, halved until they are proved; None
    where some are not after some halvings, or where the robot has left its family.
    """
    m, target = course.m, course.target
    here = Configurations.together([Configurations.of([start]), there[:-1]])
    ends = np.stack([parts[:-1], parts[1:]])
    reached, places = [there], [ends[1]]
    for halving in range(_HALVINGS + 1):
        checkpoint()
        left = ~follow_branch(
            m, target, Steps.between(here, there, np.multiply.outer(ends[1] - ends[0], target.values))
        )
        if not left.any():
            break
        if halving == _HALVINGS:
            return None
        here, there, ends = here[left], there[left], ends[:, left]
        middle = ends.mean(axis=0)
        joints = close_loops(course, here, course.goal(middle))
        if not joints.closed.all():
            return None
        iterations += joints.iterations
        between = here.after(joints.amounts, joints.links)
        reached.append(between)
        places.append(middle)
        here, there = Configurations.together([here, between]), Configurations.together([between, there])
        ends = np.concatenate([np.stack([ends[0], middle]), np.stack([middle, ends[1]])], axis=1)
    found = np.concatenate(places)
    order = np.argsort(found if parts[-1] > parts[0] else -found)
    every = Configurations.together(reached)[order]
    try:
        way = _settled(course, start, every, found[order])
    except NotClosed:
        return None
    return Steady(tuple(found[order].tolist()), way, iterations)


def _settled(course: Course, start: Configuration, every: Configurations, parts: Floats) -> tuple[Configuration, ...]:
    """The configurations, with all names at their places and the limbs that these make. Raises NotClosed where the
    robot has left its family.
    """
    m, number = course.m, len(every)
    amounts = [a - before for a, before in zip(every.joint_values, start.joint_values, strict=True)]
    links = [c.links(a) for c, a in zip(start.chains, amounts, strict=True)]
    values, chains, off = sound(m, start.values, start.chains, links, amounts)
    residual = np.abs(loop_gaps(start.chains, links, np.broadcast_to(start.platform, (number, 4, 4)), m))
    if not residual.max(initial=0.0) <= _CLOSED:
        raise NotClosed("the loops do not close")
    named = Configurations(
        tuple(c.placed(np.broadcast_to(c.screws, e.screws.shape)) for c, e in zip(chains, every.chains, strict=True)),
        every.joint_values,
        every.platform,
    )
    joint_values = every.joint_values
    if number > 1:
        before = Configurations.together([Configurations.of([start]), named[:-1]])
        first = {n: np.broadcast_to(v, (number, 3)) for n, v in values.items()}
        first = {n: np.concatenate([start.values[n][None], v[:-1]]) for n, v in first.items()}
        grown = [b - a for a, b in zip(before.joint_values, every.joint_values, strict=True)]
        joint_values = _amounts(course, before, grown, first, values, parts)
    return tuple(
        Configuration(
            {name: v if v.ndim == 1 else v[k] for name, v in values.items()},
            tuple(own[k] @ before for own, before in zip(links, start.links, strict=True)),
            tuple(own[k] for own in joint_values),
            tuple(c.placed(c.screws[k]) for c in named.chains),
            float(residual[k].max(initial=0.0)),
            off,
        )
        for k in range(number)
    )


def _amounts(
    course: Course, here: Configurations, grown: Sequence[Floats], before: Values, after: Values, parts: Floats
) -> tuple[Floats, ...]:
    """The amounts from home after steps to parts of a course, by the limbs where each begins, `here`, as these are made
    of the names, whose places are those `before` and `after` it. They are about those by which the screws that are
    carried along have `grown`; what spins idly, by the least amounts. Raises NotClosed where the steps lead elsewhere.
    """
    m = course.m
    spins = any(len(c.turns) > rank for c, rank in zip(m.home.chains, m.ranks, strict=True))
    joints = close_loops(course, here, course.goal(parts), None if spins else grown)
    places = moved(m.robot, m.attachments, before, joints.links)
    off = [
        lengths(places[n] - v) / (m.size if m.robot.family.sorts.get(n) == "point" else lengths(v))
        for n, v in after.items()
    ]
    if not (joints.closed.all() and max(float(np.max(o)) for o in off) <= _SAME):
        raise NotClosed("the steps lead elsewhere")
    return tuple(v[0] + np.cumsum(a, axis=0) for v, a in zip(here.joint_values, joints.amounts, strict=True))
