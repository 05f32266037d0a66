r"""A robot of joints driven along a way, many places at once: configurations that are proved to lie on one branch.

From a configuration the loops are closed at many places ahead, each led there straight: a prediction, of which nothing
is believed. Then it is proved for all steps from one place to the next at once that they follow the branch, and that
they meet no singular configuration; steps that are too long for a proof are halved. Up to the first step that is not
proved to follow the branch the prediction holds. That step is gone as `solve.goal` goes, with steps that halve until
they are proved, and from its end it is predicted anew.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.branch import Steps, follow_and_are_regular
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.itinerary import Itinerary
from gcrules.mechanisms.kinematics.linkage import Configuration
from gcrules.mechanisms.kinematics.loops import close_loops
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import Solution, goal
from gcrules.mechanisms.kinematics.soundness import sound
from gcrules.poses.limbs.nodes import Nodes
from gcrules.poses.limbs.straight import led, number_of_steps

__all__ = ["Driven", "drive"]

Truths = NDArray[np.bool_]

_AT_ONCE = 256  # configurations: their arrays fit into a cache
_FARTHEST = 32  # steps, at each of which the loops may be open by a hundredth of what the proofs leave room for
_HALVINGS = 5  # of a step, for its proofs
_FEWEST = 4  # that are predicted after a step that was not proved


@dataclass(frozen=True, eq=False)
class Driven:
    """The configurations along a way, and which of the steps between them are proved to meet no singular one,
    `regular` (N − 1,). That they lie on one branch is proved but from the parameter `doubt` on, if there is one.
    """

    nodes: Nodes
    regular: Truths
    doubt: float | None


def drive(way: Itinerary, start: Configuration, parameters: Floats) -> Driven:
    """From a configuration at the first parameter through all others; no step leads over a pose of the way. Raises
    InputError where the robot does not assemble.
    """
    found, regular = [Nodes.of(parameters[:1], [start])], [np.zeros(0, dtype=bool)]  # of stretches one after the other
    here, done, size = start, 0, _AT_ONCE
    doubt: float | None = None
    while done < len(parameters) - 1:
        checkpoint()
        report(f"{done:,} of {len(parameters) - 1:,} steps")
        ahead = parameters[done : done + size + 1]
        proved = _predicted(way, here, ahead) if doubt is None else None
        if proved is None:
            here, doubt = _gone(way, here, ahead[:2], doubt)
            proved = Driven(Nodes.of(ahead[1:2], [here]), np.zeros(1, dtype=bool), doubt)
        number = len(proved.nodes)
        size = min(2 * size, _AT_ONCE) if number == len(ahead) - 1 else max(number // 2, _FEWEST)
        found.append(proved.nodes)
        regular.append(proved.regular)
        here = proved.nodes.one(-1)
        done += number
    return Driven(Nodes.together(found), np.concatenate(regular), doubt)


def _gone(way: Itinerary, here: Configuration, ends: Floats, doubt: float | None) -> tuple[Configuration, float | None]:
    """Step by step from one parameter to another one, and from where on the branch is not proved."""
    k = int(way.segments(ends)[0])
    course = way.courses[k]
    start = Solution(here, course.target, doubt=None if doubt is None else 0.0)
    try:
        found = goal(course, start, float(ends[0] - k), float(ends[1] - k))
    except InputError as fault:
        raise InputError(f"between pose {k} and pose {k + 1}: {fault.message}", hint=fault.hint) from None
    return found.configuration, k + found.doubt if doubt is None and found.doubt is not None else doubt


def _predicted(way: Itinerary, here: Configuration, parameters: Floats) -> Driven | None:
    """As far as it is proved, from the first parameter, which is left out; None for nothing. In the proofs the screws
    are carried along with their links, so that amounts from one place to another are differences.
    """
    amounts, reached = _led(way, here, way.goals(parameters))
    number = len(reached) if reached.all() else int(np.argmin(reached))
    while number:
        checkpoint()
        parts, links = _moved(here, amounts[: number + 1])
        try:
            values, chains, _ = sound(way.m, here.values, here.chains, links, parts)
            break
        except NotClosed:
            number //= 2
    if not number:
        return None
    every = Configurations.of([here])[np.zeros(number + 1, dtype=int)].after(parts, links)
    follow, regular = _proofs(way, every, parameters[: number + 1])
    number = len(follow) if follow.all() else int(np.argmin(follow))
    if not number:
        return None
    screws = [np.broadcast_to(c.screws, e.screws.shape) for c, e in zip(chains, every.chains, strict=True)]
    named = tuple(replace(c, screws=s) for c, s in zip(chains, screws, strict=True))
    nodes = Nodes(
        parameters[: len(every)],
        replace(every, chains=named),
        {n: np.broadcast_to(v, (len(every), 3)) for n, v in values.items()},
        tuple(k @ before for k, before in zip(links, here.links, strict=True)),
    )
    return Driven(nodes[1 : number + 1], regular[:number], None)


def _moved(here: Configuration, amounts: Floats) -> tuple[list[Floats], list[Floats]]:
    """Amounts (N, all) by limbs, and how these move the links."""
    parts = np.split(amounts, np.cumsum([len(c.turns) for c in here.chains])[:-1], axis=1)
    return parts, [c.links(a) for c, a in zip(here.chains, parts, strict=True)]


def _led(way: Itinerary, here: Configuration, goals: Floats) -> tuple[Floats, Truths]:
    """The amounts (N + 1, all) of all joints from a configuration, of which the first goal is that, to those at all
    goals, and where a solution was found (N,); each is led there straight.
    """
    change = way.changes(goals[:1], goals[1:])
    steps = number_of_steps(way.course, change)
    amounts = np.zeros((len(goals), sum(len(c.turns) for c in here.chains)))
    amounts[1:], reached = led(
        way.course,
        Configurations.of([here]),
        amounts[1:],
        lambda on, part: way.further(goals[:1], part * change[on]),
        change,
        np.where(steps <= _FARTHEST, steps, 0),
    )
    return amounts, reached


def _proofs(way: Itinerary, every: Configurations, parameters: Floats) -> tuple[Truths, Truths]:
    """Which of the steps from each to the next are proved to follow the branch, and which to be regular."""
    follow, regular = np.ones(len(every) - 1, dtype=bool), np.ones(len(every) - 1, dtype=bool)
    owners, ends = np.arange(len(follow)), np.stack([parameters[:-1], parameters[1:]])
    here, there = every[:-1], every[1:]
    followed = np.zeros(len(follow), dtype=bool)  # of pieces: they, or what they are pieces of
    for halving in range(_HALVINGS + 1):
        checkpoint()
        steps = Steps.between(here, there, way.grown(*ends))
        own, done = follow_and_are_regular(way.m, way.course.target, steps)
        followed |= own
        left = ~done
        most = 0 if halving == _HALVINGS else _AT_ONCE // 2
        if left.sum() > most:  # those ahead of the others are given up
            left &= owners < np.sort(owners[left])[most]
        closed = np.zeros(0, dtype=bool)
        if left.any():
            middles = ends[:, left].mean(axis=0)
            joints = close_loops(way.course, here[left], way.goals(middles))
            left[left] = closed = joints.closed
        lost = ~(done | left)
        follow[owners[lost & ~followed]] = False
        regular[owners[lost]] = False
        if not left.any():
            break
        moved = [[x[closed] for x in several] for several in (joints.amounts, joints.links)]
        between, middles = here[left].after(*moved), middles[closed]
        ends = np.concatenate([np.stack([ends[0, left], middles]), np.stack([middles, ends[1, left]])], axis=1)
        here = Configurations.together([here[left], between])
        there = Configurations.together([between, there[left]])
        owners, followed = np.tile(owners[left], 2), np.tile(followed[left], 2)
    return follow, regular
