r"""Many configurations led straight to what is wanted, each in steps of its own: predictions, of which nothing is
proved unless whoever accepts the steps does so.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.loops import Course, Joints, close_loops
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Accept", "after", "led", "number_of_steps"]

Truths = NDArray[np.bool_]
Places = NDArray[np.intp]

_STEP = 0.2  # rad, or parts of the robot's size: the longest step

Accept = Callable[[Configurations, Joints, Places, Floats], Truths]
"""accept(here, joints, places, grown): which of the steps that joints make from configurations are good; the places of
these among all, and by how much the wanted values grow.
"""


def number_of_steps(course: Course, change: Floats) -> Floats:
    """How many steps lead along changes (N, names) of the wanted values, (N,), one at least."""
    return np.asarray(np.maximum(np.ceil(np.abs(change / course.weights).max(axis=1, initial=0.0) / _STEP), 1))


def after(start: Configurations, amounts: Floats) -> Configurations:
    """The configurations after amounts (N, all) from a single one."""
    parts = np.split(amounts, np.cumsum([len(c.turns) for c in start.chains])[:-1], axis=1)
    return start.moved(parts)[1]


def led(
    course: Course,
    start: Configurations,
    amounts: Floats,
    goals: Callable[[Places, Any], Floats],
    change: Floats,
    steps: Floats,
    accept: Accept | None = None,
    halvings: int = 0,
    growth: float = 2.0,
) -> tuple[Floats, Truths]:
    """The amounts (N, all) from a single configuration `start` that reach what is wanted, and which do (N,).

    Each is led from its own `amounts` in so many `steps` (N,), none where that is 0, while its wanted values grow by
    `change` (N, names); `goals` gives, for places (K,) among all and parts (K, 1) of the way, what is wanted there.
    A step that fails is halved, so many times at most; with none left the configuration stays at the last good step.
    After a good one the next may be longer by the `growth`.
    """
    found = amounts.copy()
    done = np.where(steps > 0, 0.0, np.inf)  # in steps, of which `left` are those that are not
    left, step = np.where(steps > 0, steps, 0.0), np.ones(len(steps))
    while len(on := np.flatnonzero(left > 0)):
        checkpoint()
        part = np.minimum(done[on] + step[on], steps[on])
        now = after(start, found[on])
        joints = close_loops(course, now, goals(on, (part / steps[on])[:, None]))
        good = joints.closed
        if accept is not None:
            good = good & accept(now, joints, on, change[on] * ((part - done[on]) / steps[on])[:, None])
        ahead, behind = on[good], on[~good]
        found[ahead] += np.concatenate(joints.amounts, axis=1)[good]
        done[ahead] = part[good]
        left[ahead] = steps[ahead] - done[ahead]
        step[ahead] = np.minimum(growth * step[ahead], 1.0)
        step[behind] /= 2
        left[behind[step[behind] < 0.5**halvings]] = 0.0
    return found, (steps > 0) & (done >= steps)
