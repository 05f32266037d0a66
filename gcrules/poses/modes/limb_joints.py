r"""The joints of a limb for a place of the platform: all real amounts that lead there, and configurations of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice, product

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.assembled import configuration_at
from gcrules.mechanisms.kinematics.chains import shape_of
from gcrules.mechanisms.kinematics.coordinates import principal
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed, inverse, logarithm

__all__ = ["Held", "configurations", "same_spans", "spans_of", "with_turned_balls"]

_STARTS = 32
_ITERATIONS = 60
_CLOSED = 1e-9  # of the gap, in sizes or rad
_LONGEST = 0.7  # step of an amount
_NONE = 1e-9  # singular values of twists
_SAME = 1e-6  # of projections on the twists of undriven joints
_MOST = 64  # configurations of one pose
_WAYS = 3  # amounts with the same spans: turns of pins about the other side, idle turns


@dataclass(frozen=True, eq=False)
class Held:
    """For each limb the amounts of all its coordinates from home (rad, the file's unit of length), and the places of
    those that are `free`: they may take any amount.
    """

    amounts: tuple[Floats, ...]
    free: tuple[tuple[int, ...], ...]

    @classmethod
    def of(cls, m: Linkage, amounts: Sequence[Floats]) -> Held:
        """Those with driven coordinates at these amounts, and those that have to stay at 0 there."""
        held, free = [], []
        for place, own in enumerate(amounts):
            driven = {a.coordinate for a in m.actuators if a.place == place}
            locked = {k for p, k, _ in m.locked if p == place}
            held.append(np.array([a if k in driven else 0.0 for k, a in enumerate(own)]))
            free.append(tuple(k for k in range(len(own)) if k not in driven | locked))
        return cls(tuple(held), tuple(free))


def with_turned_balls(m: Linkage) -> Linkage:
    """The same linkage with the three turns of each ball joint about other axes: with those of the frame amounts are
    lost where the second turn is a right angle, which symmetric robots are fond of.
    """
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    chains = []
    for limb, chain in zip(m.robot.limbs, m.home.chains, strict=True):
        screws, start = chain.screws.copy(), 0
        for joint in limb.joints:
            count = len(shape_of(joint.kind).motions)
            if joint.kind == "S" and not joint.actuated:  # turns about a point: any axes through it will do
                screws[start : start + count] = turn @ screws[start : start + count]
            start += count
        chains.append(replace(chain, screws=screws))
    return replace(m, home=replace(m.home, chains=tuple(chains)))


def configurations(m: Linkage, held: Held, motion: Floats) -> list[Configuration]:
    """The configurations in which the platform has made a motion (4, 4) from home; several where a limb reaches it in
    several ways. Raises NotClosed where a limb does not reach it, or the robot has left its family there.
    """
    ways = []
    for place, limb in enumerate(m.robot.limbs):
        own = _limb_amounts(m, place, held, motion)
        if not own:
            raise NotClosed(f"{limb.name} does not reach it with real joints")
        ways.append(own)
    found: list[Configuration] = []
    fault: NotClosed | None = None
    for chosen in islice(product(*ways), _MOST):
        for amounts in _tries(chosen):
            try:
                found.append(configuration_at(m, amounts))
                break
            except NotClosed as other:
                fault = other
    if not found and fault is not None:
        raise fault
    return found


def _tries(chosen: Sequence[list[Floats]]) -> Iterator[tuple[Floats, ...]]:
    """The first amounts of each limb, then one limb's others at a time."""
    first = tuple(own[0] for own in chosen)
    yield first
    for place, own in enumerate(chosen):
        yield from ((*first[:place], other, *first[place + 1 :]) for other in own[1:])


def _limb_amounts(m: Linkage, place: int, held: Held, motion: Floats) -> list[list[Floats]]:
    """Amounts of a limb's coordinates that bring the platform there, for each span of the undriven twists several,
    those first that are reached from home.
    """
    chain, free = m.home.chains[place], list(held.free[place])
    rng = np.random.default_rng(place)
    amounts = np.tile(held.amounts[place], (_STARTS, 1))
    units = np.where(np.array(chain.turns), 1.0, m.size)[free]
    amounts[1:, free] += rng.uniform(-np.pi, np.pi, (_STARTS - 1, len(free))) * units
    centre = motion[:3, :3] @ m.centre + motion[:3, 3]
    size = np.full(_STARTS, np.inf)
    for _ in range(_ITERATIONS):
        checkpoint()
        links = chain.links(amounts)
        gap = _at(logarithm(motion @ inverse(links[:, -1])), centre, m.size)
        size = np.abs(gap).max(axis=1)
        if not free:
            break
        twists = _at(np.swapaxes(chain.twists(links)[..., free], -1, -2), centre, m.size) * units[:, None]
        step = _damped(np.swapaxes(twists, -1, -2), gap)
        amounts[:, free] += step * units
    turns = [k for k in free if chain.turns[k]]
    amounts[:, turns] = principal(amounts[:, turns])
    found: list[list[Floats]] = []
    spans: list[Floats] = []
    for own in amounts[size <= _CLOSED]:
        span = _projection(chain.twists(chain.links(own)), free, centre, m.size)
        same = next((k for k, other in enumerate(spans) if np.abs(span - other).max() <= _SAME), None)
        if same is None:
            found.append([own])
            spans.append(span)
        elif len(found[same]) < _WAYS and all(np.abs(own - other).max() > _SAME for other in found[same]):
            found[same].append(own)
    return found


def _damped(rows: Floats, gap: Floats) -> Floats:
    """Steps (N, n) of Levenberg and Marquardt's method with the damping |gap|², of bounded length."""
    size = (gap * gap).sum(axis=1)
    normal = np.swapaxes(rows, -1, -2) @ rows
    normal = normal + (np.minimum(size, 1.0) + 1e-14)[:, None, None] * np.eye(rows.shape[-1])
    step = np.linalg.solve(normal, np.swapaxes(rows, -1, -2) @ gap[..., None])[..., 0]
    longest = np.abs(step).max(axis=1, keepdims=True)
    return np.asarray(step * (_LONGEST / np.maximum(longest, _LONGEST)))


def _at(twists: Floats, centre: Floats, size: float) -> Floats:
    """Twists (..., 6), (ω; v), with the velocity of a centre in sizes."""
    w, v = twists[..., :3], twists[..., 3:]
    return np.concatenate([w, (v + crossed(w, np.broadcast_to(centre, w.shape))) / size], axis=-1)


def _projection(twists: Floats, free: Sequence[int], centre: Floats, size: float) -> Floats:
    """The projection (6, 6) on those of the twists (6, n) that are free."""
    if not free:
        return np.zeros((6, 6))
    rows = _at(twists[:, list(free)].T, centre, size)
    _, s, v = np.linalg.svd(rows, full_matrices=False)
    own = v[s > _NONE * max(s[0], 1.0)]
    return np.asarray(own.T @ own)


def spans_of(m: Linkage, held: Held, c: Configuration) -> Floats:
    """The pose (12 numbers, lengths in sizes) and all limbs' projections, by which configurations are told apart."""
    centre = c.platform[:3, :3] @ m.centre + c.platform[:3, 3]
    spans = [
        _projection(chain.twists(), free, centre, m.size).ravel()
        for chain, free in zip(c.chains, held.free, strict=True)
    ]
    return np.concatenate([c.platform[:3, :3].ravel(), (centre - m.centre) / m.size, *spans])


def same_spans(a: Floats, b: Floats) -> bool:
    """Whether two configurations are one."""
    return bool(np.abs(a - b).max() <= _SAME)
