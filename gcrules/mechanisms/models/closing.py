"""Closing the loops of a model whose file places its links where they are open: its joints move until they are closed.

The places of a model are those at home. Where the state that its file gives has open loops, home is the nearest state
that was found in which they are closed: by Gauss and Newton's steps, damped, of the joints that are not driven, and of
all where these do not do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats, carried, exponential, rotation_vector
from gcrules.mechanisms.models.model import ModelCoupling, ModelJoint

__all__ = ["Loop", "Tree", "closed", "gaps"]

STEPS = 200
CLOSED = 1e-12  # of the size, where steps end
GOOD = 1e-9
_TURN_STEP = 0.5  # rad: no joint turns more in one step


@dataclass(frozen=True, eq=False)
class Loop:
    """What a joint of a kind asks of two frames (4, 4), one on each link, and of two axes (3,)."""

    name: str
    kind: str
    ends: tuple[str, str]
    frames: tuple[Floats, Floats]
    axes: tuple[Floats, Floats] | None = None

    def carried(self, motions: Mapping[str, Floats]) -> Loop:
        """Where the links have moved."""
        one, other = (motions[name] for name in self.ends)
        frames = (one @ self.frames[0], other @ self.frames[1])
        axes = None if self.axes is None else (one[:3, :3] @ self.axes[0], other[:3, :3] @ self.axes[1])
        return Loop(self.name, self.kind, self.ends, frames, axes)

    def residual(self) -> tuple[Floats, Floats]:
        """How far it is open: lengths, and angles (or what is one where it is small)."""
        one, other = self.frames
        away = other[:3, 3] - one[:3, 3]
        if self.axes is None:
            turn = rotation_vector(other[:3, :3] @ one[:3, :3].T) if self.kind == "fixed" else np.zeros(0)
            return away if self.kind != "free" else np.zeros(0), turn
        a, b = (axis / np.linalg.norm(axis) for axis in self.axes)
        if self.kind == "universal":
            return away, np.array([a @ b])
        if self.kind == "planar":
            away = a * (away @ a)
        elif self.kind != "revolute":
            away = away - a * (away @ a)
        turn = np.cross(a, b)
        return away, rotation_vector(other[:3, :3] @ one[:3, :3].T) if self.kind == "prismatic" else turn

    def rates(self, twists: tuple[Floats, Floats]) -> tuple[Floats, Floats]:
        """The same for the rates of coordinates whose twists (n, 6) move the two links."""
        one, other = self.frames
        velocities = [t[:, 3:] + np.cross(t[:, :3], f[:3, 3]) for t, f in zip(twists, self.frames, strict=True)]
        rate = velocities[1] - velocities[0]
        turning = twists[1][:, :3] - twists[0][:, :3]
        if self.axes is None:
            return rate if self.kind != "free" else rate[:, :0], turning if self.kind == "fixed" else rate[:, :0]
        a, b = (axis / np.linalg.norm(axis) for axis in self.axes)
        da, db = (np.cross(t[:, :3], axis) for t, axis in zip(twists, (a, b), strict=True))
        if self.kind == "universal":
            return rate, (da @ b + db @ a)[:, None]
        away = other[:3, 3] - one[:3, 3]
        along = (rate @ a + da @ away)[:, None] * a + (away @ a) * da
        if self.kind == "planar":
            rate = along
        elif self.kind != "revolute":
            rate = rate - along
        return rate, turning if self.kind == "prismatic" else np.cross(da, b) + np.cross(a, db)


def gaps(loop: Loop) -> tuple[float, float]:
    """How far a loop is open: a length and an angle."""
    away, turn = loop.residual()
    return float(np.linalg.norm(away)), float(np.linalg.norm(turn))


class Tree:
    """The joints of a tree of links as motions one after the other, each with the coordinate that it takes."""

    def __init__(self, base: str, joints: Sequence[ModelJoint], couplings: Sequence[ModelCoupling]) -> None:
        self.base = base
        self.steps: list[tuple[ModelJoint, slice]] = []
        screws: list[Floats] = []
        below: dict[str, list[ModelJoint]] = {}
        for j in joints:
            below.setdefault(j.parent, []).append(j)
        waiting = [base]
        while waiting:
            for j in below.get(waiting.pop(), ()):
                own = list(_screws(j))
                self.steps.append((j, slice(len(screws), len(screws) + len(own))))
                screws += own
                waiting.append(j.child)
        self.screws = np.array(screws).reshape(-1, 6)
        places = {j.name: own for j, own in self.steps}
        self.parts = np.eye(len(screws))  # of each motion in each coordinate
        for c in couplings:
            if c.joint in places and c.leader in places:
                self.parts[places[c.joint].start] = c.ratio * self.parts[places[c.leader].start]
        self.before = self._before()

    def _before(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {self.base: []}
        for j, own in self.steps:
            found[j.child] = [*found[j.parent], *range(own.start, own.stop)]
        return found

    def motions(self, amounts: Floats) -> tuple[dict[str, Floats], Floats]:
        """How links have moved for the values of the coordinates, and the twists of all motions there."""
        single = exponential(self.screws, self.parts @ amounts) if len(self.screws) else np.zeros((0, 4, 4))
        found = {self.base: np.eye(4)}
        held = np.zeros((len(self.screws), 4, 4))
        for j, own in self.steps:
            here = found[j.parent]
            for k in range(own.start, own.stop):
                held[k] = here
                here = here @ single[k]
            found[j.child] = here
        return found, carried(held, self.screws) if len(self.screws) else self.screws


def _screws(j: ModelJoint) -> Iterator[Floats]:
    at = np.array(j.at)
    axes = [np.array(a) for a in j.axes]
    x, y, z = np.eye(3)
    if j.kind == "planar":
        normal = axes[0]
        across = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        slides, turns = [across / np.linalg.norm(across), np.cross(normal, across / np.linalg.norm(across))], [normal]
    else:
        slides = {"prismatic": axes, "cylindrical": axes, "free": [x, y, z]}.get(j.kind, [])
        turns = {"ball": [x, y, z], "free": [x, y, z], "prismatic": [], "fixed": []}.get(j.kind, axes)
    yield from (np.concatenate([np.zeros(3), s]) for s in slides)
    for t in turns:
        yield np.concatenate([t, np.cross(at, t) + (j.pitch * t if j.kind == "screw" else 0.0)])


def closed(tree: Tree, loops: Sequence[Loop], size: float, still: Sequence[str]) -> Floats | None:
    """Values of the tree's coordinates that close all loops, None where none were found: joints in `still` stay where
    they are if that is possible.
    """
    kept = np.ones(len(tree.screws), dtype=bool)
    for j, own in tree.steps:
        if j.name in still:
            kept[own] = False
    for free in (kept, np.ones(len(tree.screws), dtype=bool)):
        if free.any() and (found := _solved(tree, loops, size or 1.0, free)) is not None:
            return found
    return None


def _solved(tree: Tree, loops: Sequence[Loop], size: float, free: np.ndarray) -> Floats | None:
    amounts = np.zeros(len(tree.screws))
    residual, rates = _system(tree, loops, size, amounts)
    damping = 1e-3
    for _ in range(STEPS):
        checkpoint()
        error = float(residual @ residual)
        if error <= CLOSED**2:
            break
        own = rates[:, free]
        normal = own.T @ own + damping * np.eye(own.shape[1])
        step = np.zeros(len(amounts))
        step[free] = -np.linalg.solve(normal, own.T @ residual)
        step *= min(1.0, _TURN_STEP / max(float(np.abs(step).max()), 1e-300))
        after, found = _system(tree, loops, size, amounts + step)
        if float(after @ after) < error:
            amounts, residual, rates = amounts + step, after, found
            damping = max(damping / 10, 1e-14)
        elif damping > 1e6:
            break
        else:
            damping *= 10
    return amounts if float(np.abs(residual).max(initial=0.0)) < GOOD else None


def _system(tree: Tree, loops: Sequence[Loop], size: float, amounts: Floats) -> tuple[Floats, Floats]:
    """How far all loops are open, lengths divided by the size, and how that changes with the coordinates."""
    motions, twists = tree.motions(amounts)
    residuals, rates = [], []
    for loop in loops:
        here = loop.carried(motions)
        moving = []
        for name in loop.ends:
            own = np.zeros_like(twists)
            own[tree.before[name]] = twists[tree.before[name]]
            moving.append(own)
        for part, rate, unit in zip(here.residual(), here.rates((moving[0], moving[1])), (size, 1.0), strict=True):
            residuals.append(part / unit)
            rates.append((rate.T @ tree.parts) / unit)
    return np.concatenate(residuals), np.concatenate(rates)
