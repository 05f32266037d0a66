r"""Closing the loops near configurations, many at once: the equations and the steps of their solution.

The unknowns are the amounts of all joints; the equations say that all limbs bring the platform to one place and that
the wanted coordinates have their values. They are solved by Newton's method; where a step would go far, and where there
are more equations than unknowns or fewer, by Levenberg and Marquardt's with the damping μ = |r|², which converges
quadratically also where equations depend on each other, as in over-constrained robots.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates, slopes, wrapped
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import (
    Floats,
    changed_about,
    cross_matrix,
    crossed,
    inverse,
    logarithm,
    rotation_vector,
)
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.screws.pose_text import SHIFTS

__all__ = ["Course", "Joints", "close_loops", "loop_gaps", "loop_rows", "units_of"]

_ACCURACY = 1e-9  # how far loops may be open, in parts of the robot's size
_ENOUGH = 1e-13
_ITERATIONS = 14
_FARTHEST = 0.5  # of a joint in one step: rad, or parts of the robot's size
_NOTHING = 1e-12  # of the largest singular value

Truths = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Course:
    """Wanted values as a function of the part of the way from home, 0 to 1, or beyond."""

    m: Linkage
    target: Target

    def goal(self, parts: Floats) -> Floats:
        """What is wanted after parts (N,) of the way: values (N, names), or motions (N, 4, 4) for a whole pose."""
        w = self.target
        if w.whole is None or w.driven:
            return np.asarray(np.multiply.outer(parts, w.values) + (0.0 if w.start is None else w.start))
        start = np.eye(4) if w.start is None else w.start
        return changed_about(self.m.centre, start, np.multiply.outer(parts, w.values))

    def error(self, goal: Floats, platform: Floats, joint_values: Sequence[Floats]) -> Floats:
        """What is reached less what is wanted, (N, wanted); lengths divided by the robot's size."""
        w, m = self.target, self.m
        if w.driven:
            reached = np.stack([joint_values[a.place][:, a.coordinate] for a in leading(m)], axis=1)
            return np.asarray((reached - goal) / self.weights)
        if w.whole is None:
            return wrapped(w.names, coordinates(w.names, platform, m.centre) - goal) / self.weights
        off = platform - goal
        shift = off[:, :3, :3] @ m.centre + off[:, :3, 3]
        turn = rotation_vector(platform[:, :3, :3] @ np.swapaxes(goal[:, :3, :3], -1, -2))
        return np.concatenate([shift / m.size, turn], axis=1)

    def rows(self, platform: Floats, twists: Sequence[Floats]) -> Floats:
        """Its derivatives by all amounts, (N, wanted, amounts), of the limbs' `shared_twists`."""
        w, m = self.target, self.m
        starts = np.cumsum([0, *(t.shape[-1] for t in twists)])
        found = np.zeros((len(platform), len(self.weights), starts[-1]))
        if w.driven:
            for row, a in enumerate(leading(m)):
                found[:, row, starts[a.place] + a.coordinate] = 1
        elif w.whole is None:
            found[..., : starts[1]] = slopes(w.names, platform, m.centre) @ twists[0][:, 0]
        else:
            centre = platform[:, :3, :3] @ m.centre + platform[:, :3, 3]
            own = twists[0][:, 0]
            found[:, :3, : starts[1]] = own[:, 3:] - cross_matrix(centre) @ own[:, :3]
            found[:, 3:, : starts[1]] = own[:, :3]
        return found / self.weights[:, None]

    @cached_property
    def weights(self) -> Floats:
        """What counts as much of each wanted value: 1 rad, and the robot's size."""
        w = self.target
        if w.driven:
            return np.array([1.0 if a.angle else self.m.size for a in leading(self.m)])
        return np.array([self.m.size if n in SHIFTS else 1.0 for n in w.names])

    @property
    def length(self) -> float:
        """How far it goes: the largest of its values, lengths divided by the robot's size."""
        with np.errstate(over="ignore"):
            return float(np.abs(self.target.values / self.weights).max(initial=0.0))


def units_of(m: Linkage) -> Floats:
    """What counts as much of each amount: 1 rad, and the robot's size."""
    return np.concatenate([np.where(c.turns, 1.0, m.size) for c in m.home.chains])


@dataclass(frozen=True, eq=False)
class Joints:
    """Amounts of all joints from N configurations, (N, n) for each limb, with the motions of all links. Where `closed`
    (N,) they close the loops but for the `residual`; else the solution went `far`, or there was none.
    """

    amounts: tuple[Floats, ...]
    links: tuple[Floats, ...]
    residual: Floats
    closed: Truths
    far: Truths
    iterations: int


def close_loops(course: Course, start: Configurations, goal: Floats, guess: Sequence[Floats] | None = None) -> Joints:
    """The joints near each configuration, in which the loops are closed, that close them and give what is wanted of it,
    as `Course.goal`; near a `guess` of the amounts (N, n) of each limb, if there is one.
    """
    m, number = course.m, len(start)
    cuts = np.cumsum([len(c.turns) for c in start.chains])[:-1]
    units = units_of(m)
    begun = np.zeros((number, len(units))) if guess is None else np.concatenate(guess, axis=1)
    whole = begun.copy()
    best, residual = np.full(number, np.inf), np.zeros(number)
    closed, far = np.zeros(number, dtype=bool), np.zeros(number, dtype=bool)
    ends = [np.broadcast_to(np.eye(4), (number, c.count, 4, 4)).copy() for c in start.chains]
    active, iterations = np.arange(number), -1
    closing = 6 * (len(start.chains) - 1 + sum(len(c.loops) for c in start.chains))
    while len(active) and iterations < _ITERATIONS:
        checkpoint()
        iterations += 1
        here = start if len(active) == number else start[active]
        links, there, gaps = ends, start, np.zeros((number, closing))  # at first nothing has moved
        if iterations or guess is not None:
            links, there = here.moved(np.split(whole[active], cuts, axis=1))
            gaps = loop_gaps(here.chains, links, here.platform, m)
        r = np.concatenate([gaps, course.error(goal[active], there.platform, there.joint_values)], axis=1)
        size = np.sqrt((r * r).sum(axis=1))
        done = (size <= _ENOUGH) | ((size <= _ACCURACY / 100) & (size >= best[active] / 4))
        closed[active[done]] = True
        residual[active[done]] = np.abs(gaps[done]).max(axis=1, initial=0.0)
        for all_, own in zip(ends, links, strict=True):
            all_[active[done]] = own[done]
        on = ~done & (size <= 4 * best[active])
        best[active] = np.minimum(best[active], size)
        if not on.any():
            break
        there, active, r, size = there[on], active[on], r[on], size[on]
        twists = [c.shared_twists for c in there.chains]
        rows = np.concatenate([loop_rows(twists, here.platform[on], m), course.rows(there.platform, twists)], axis=1)
        sound = np.isfinite(rows).all(axis=(1, 2))
        change = _steps(rows[sound] * units, r[sound], size[sound])
        active = active[sound]
        reach = np.abs(change).max(axis=1, initial=0.0, keepdims=True)
        whole[active] += change * units * np.minimum(1.0, _FARTHEST / 2 / np.where(reach > 0, reach, 1.0))
        far[active] = np.abs((whole[active] - begun[active]) / units).max(axis=1) > _FARTHEST
        active = active[~far[active]]
    return Joints(tuple(np.split(whole, cuts, axis=1)), tuple(ends), residual, closed, far, max(iterations, 0))


def _steps(rows: Floats, r: Floats, size: Floats) -> Floats:
    """The steps towards r = 0."""
    found = np.full((len(rows), rows.shape[2]), np.inf)
    if rows.shape[1] == rows.shape[2]:
        with suppress(np.linalg.LinAlgError):
            found = np.linalg.solve(rows, -r[..., None])[..., 0]
    wild = ~(np.abs(found).max(axis=1, initial=0.0) <= _FARTHEST / 2)
    if wild.any():
        u, s, v = np.linalg.svd(rows[wild], full_matrices=False)
        damped = np.where(s > _NOTHING * s[:, :1], s / (s**2 + size[wild, None] ** 2), 0.0)
        parts = (np.swapaxes(u, -1, -2) @ r[wild, :, None])[..., 0] * damped
        found[wild] = -(np.swapaxes(v, -1, -2) @ parts[..., None])[..., 0]
    return np.asarray(found)


def loop_gaps(chains: Sequence[Chain], links: Sequence[Floats], platform: Floats, m: Linkage) -> Floats:
    """How the other limbs' platforms lie off that of the first one, and then a limb's bodies off themselves where its
    own loops close: the twists that would bring them there.
    """
    centre = (platform[:, :3, :3] @ m.centre + platform[:, :3, 3])[:, None]
    back = inverse(links[0][:, -1])
    motions = [own[:, -1] @ back for own in links[1:]]
    motions += [own[:, a] @ inverse(own[:, b]) for c, own in zip(chains, links, strict=True) for a, b in c.loops]
    if not motions:
        return np.zeros((len(platform), 0))
    every = np.stack(motions, axis=1)
    every[..., :3, 3] += (every[..., :3, :3] @ centre[..., None])[..., 0] - centre
    found = logarithm(every)
    found[..., 3:] /= m.size
    return found.reshape(len(platform), -1)


def loop_rows(twists: Sequence[Floats], platform: Floats, m: Linkage) -> Floats:
    """The derivatives of the gaps by all amounts, of the limbs' `shared_twists`: (N, 6 × gaps, amounts)."""
    centre = platform[:, :3, :3] @ m.centre + platform[:, :3, 3]
    starts = np.cumsum([0, *(t.shape[-1] for t in twists)])
    inner = np.cumsum([len(twists) - 1, *(t.shape[1] - 1 for t in twists)])
    found = np.zeros((len(platform), inner[-1], 6, starts[-1]))
    whole = _about(np.concatenate([own[:, 0] for own in twists], axis=-1), centre, m.size)
    found[:, : len(twists) - 1, :, : starts[1]] = -whole[:, None, :, : starts[1]]
    for k, own in enumerate(twists):
        columns = slice(starts[k], starts[k + 1])
        if k:
            found[:, k - 1, :, columns] = whole[..., columns]
        if own.shape[1] > 1:
            found[:, inner[k] : inner[k + 1], :, columns] = _about(own[:, 1:], centre[:, None], m.size)
    return found.reshape(len(platform), 6 * inner[-1], starts[-1])


def _about(twists: Floats, centre: Floats, size: float) -> Floats:
    """Twists (..., 6, n) with the velocity of a point (..., 3), lengths in parts of the size."""
    w, v = np.swapaxes(twists[..., :3, :], -1, -2), np.swapaxes(twists[..., 3:, :], -1, -2)
    moved = np.concatenate([w, (v + crossed(w, centre[..., None, :])) / size], axis=-1)
    return np.asarray(np.swapaxes(moved, -1, -2))
