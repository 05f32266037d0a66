r"""Bounds that prove where the solutions of loop equations are: derivatives of chains, and their tubes.

Several chains lead to one platform; chain 0 is the one that the others are compared with. Λ(X) ∈ R⁶ takes the axial
vector of the antisymmetric part and the shift of a motion X from the place where chain 0 has the platform. The
equations are F(q) = (Λ(X_i(q)) − Λ(X_0(q)))_i = 0; every configuration in which the loops close satisfies them. A
chain is a product of exponentials, so its derivatives are products of the twists' matrices in the order of the chain:

    ∂X/∂q_k = Ĵ_k X,   ∂²X/∂q_j∂q_k = Ĵ_j Ĵ_k X,   ∂³X/∂q_h∂q_j∂q_k = Ĵ_h Ĵ_j Ĵ_k X   for h ≤ j ≤ k,

and |Λ| of the last one is at most |ω_h||ω_j||ω_k| in the turn and |ω_h||ω_j||v_k| in the shift, v_k the velocity of the
platform's point. First and second derivatives are taken at the middle of a box of amounts, third ones are bounded.

`follows`: let the amounts go straight from q(0) to q(1), x(t) between them, B an inverse of the derivatives M at the
middle by the free amounts, K ≥ |1 − B M(q)| for all q in the box |q − x| ≤ ρ around the way, β ≥ |B F(x(t))|, all
elementwise. If β + Kρ ≤ ρ then for each t the equations have exactly one solution in the box around x(t) (Krawczyk's
operator maps it into itself and contracts), which depends continuously on t: a tube that holds one branch.

`keeps_rank`: if the non-negative K has K v < v for some v > 0, then B M(q) is invertible for all q of the box.

Amounts are angles, and lengths in parts of the robot's size. All bounds are computed in floats, with more room left
than they round off. Source: Neumaier, Interval methods for systems of equations, ch. 5, for Krawczyk's operator; the
bounds are derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.rigid_motions import Floats, carried, cross_matrix, exponential, inverse

__all__ = ["Arm", "Choice", "Spread", "follows", "keeps_rank", "spreads"]

Choice = NDArray[np.bool_]
"""Which coordinates of a chain are meant, (n,)."""

Places = NDArray[np.intp]

_CLOSED = 1e-9  # how far F may be from 0 at both ends of a way
_ROUNDING = 1e-9  # room that is left for rounding, in parts of what is compared
_DEPENDENT = 1e-7
_TRIALS = 8
_INFLATED = 1.1


@dataclass(frozen=True, eq=False)
class Arm:
    """A chain on its way: `screws` (K, 6) about the platform's centre with lengths in sizes, the coordinate that each
    motion `uses` with its sign, and the amounts (n,) that the coordinates grow by.
    """

    screws: Floats
    uses: tuple[int, ...]
    signs: Floats
    amounts: Floats

    @classmethod
    def of(cls, chain: Chain, amounts: Floats, centre: Floats, size: float) -> Arm:
        """The arm of a chain with amounts in its own units."""
        units = np.where(chain.turns, 1.0, size)
        return cls(_scaled(chain.screws, centre, size) * units[list(chain.uses), None], chain.uses, chain.signs,
                   amounts / units)  # fmt: skip


def _scaled(screws: Floats, centre: Floats, size: float) -> Floats:
    w, v = screws[:, :3], screws[:, 3:]
    return np.concatenate([w, (v - w @ cross_matrix(centre).T) / size], axis=1)


@dataclass(frozen=True, eq=False)
class Spread:
    """An arm in the middle of its way: derivatives of Λ by its coordinates, `first` (6, n) and `second` (6, n, n), and
    of its motions how much they turn (0 or 1), how fast they move the platform's point, and to which coordinate they
    belong, with its sign.
    """

    amounts: Floats
    first: Floats
    second: Floats
    turns: Floats
    speeds: Floats
    parts: Floats  # (K, n), the absolute values of the signs

    def third(self, reach: Floats) -> tuple[Floats, Floats]:
        """For each coordinate bounds of Σ |∂³Λ| reach reach in the turn and in the shift, over the box in which the
        coordinates differ by no more than `reach` from the middle.
        """
        d = self.parts @ reach
        speeds = self.speeds.copy()
        for k in range(len(speeds) - 2, -1, -1):  # motions after k carry the point away from its axis
            speeds[k] += self.turns[k] * float(d[k + 1 :] @ speeds[k + 1 :])
        low, middle, high = _sorted(len(speeds))
        pair = self.turns[low] * self.turns[middle]
        turned = np.einsum("hjk,h,j->k", pair * self.turns[high], d, d)
        moved = np.einsum("hjk,h,j->k", pair * speeds[high], d, d)
        return turned @ self.parts, moved @ self.parts


@cache
def _sorted(number: int) -> tuple[Floats, Floats, Floats]:
    """The least, middle and largest of all three places (number, number, number)."""
    low, middle, high = np.sort(np.indices((number,) * 3), axis=0)
    return low, middle, high


def spreads(arms: Sequence[Arm]) -> tuple[Spread, ...]:
    """The arms in the middle of their ways, seen from the place where the first one has the platform."""
    links = [_links(arm) for arm in arms]
    back = inverse(links[0][-1])
    return tuple(_spread(arm, own, own[-1] @ back) for arm, own in zip(arms, links, strict=True))


def _links(arm: Arm) -> Floats:
    steps = exponential(arm.screws, arm.signs * arm.amounts[list(arm.uses)] / 2)
    found = np.empty((len(steps) + 1, 4, 4))
    found[0] = np.eye(4)
    for k, step in enumerate(steps):
        found[k + 1] = found[k] @ step
    return found


def _spread(arm: Arm, links: Floats, motion: Floats) -> Spread:
    count = len(arm.screws)
    twists = carried(links[:-1], arm.screws)
    w = twists[:, :3]
    hats = cross_matrix(w)
    v = twists[:, 3:] + hats @ motion[:3, 3]
    turned = hats @ motion[:3, :3]
    first = np.concatenate([_axial(turned), v], axis=1)
    bent = np.concatenate([_axial(hats[:, None] @ turned[None]), (hats[:, None] @ v[None, :, :, None])[..., 0]], axis=2)
    j, k = np.indices((count, count))
    bent = np.where((j <= k)[..., None], bent, np.swapaxes(bent, 0, 1))
    parts = np.zeros((count, len(arm.amounts)))
    parts[np.arange(count), list(arm.uses)] = arm.signs
    return Spread(
        arm.amounts,
        first.T @ parts,
        np.einsum("hkr,hi,kj->rij", bent, parts, parts),
        np.linalg.norm(w, axis=1),
        np.linalg.norm(v, axis=1),
        np.abs(parts),
    )


def _axial(matrices: Floats) -> Floats:
    """The axial vectors of antisymmetric parts."""
    a = matrices
    return np.stack([a[..., 2, 1] - a[..., 1, 2], a[..., 0, 2] - a[..., 2, 0], a[..., 1, 0] - a[..., 0, 1]], -1) / 2


@dataclass(frozen=True, eq=False)
class _Equations:
    """The loops of several chains linearised in the middle: `back` (r, 6 loops) is an inverse of the derivatives by the
    r chosen coordinates; `columns` are those of each chain.
    """

    chains: tuple[Spread, ...]
    columns: tuple[Places, ...]
    back: Floats
    rest: Floats  # (r, r), |1 − B M| in the middle

    def block(self, place: int) -> Floats:
        """What Λ of one chain counts in B F: (r, 6)."""
        blocks = self.back.reshape(len(self.back), -1, 6)
        return np.asarray(-blocks.sum(axis=1) if place == 0 else blocks[:, place - 1])

    def bent(self, reach: Sequence[Floats]) -> Floats:
        """K (r, r) ≥ |1 − B M(q)| over the box of this reach."""
        found = []
        for place, (chain, own) in enumerate(zip(self.chains, self.columns, strict=True)):
            b = self.block(place)
            slope = np.einsum("jrk,j->rk", np.abs(np.tensordot(b, chain.second, 1)).transpose(1, 0, 2), reach[place])
            found.append((slope + _sized(b, chain.third(reach[place])) / 2)[:, own])
        return np.asarray(np.concatenate(found, axis=1) + self.rest)

    def gap(self, reach: Sequence[Floats]) -> Floats:
        """β (r,) ≥ |B F| along the straight way: its curvature by 8, and what is open at its ends."""
        curved = np.zeros(len(self.back))
        more = np.zeros(len(self.back))
        for place, chain in enumerate(self.chains):
            b, a = self.block(place), chain.amounts
            curved += b @ (chain.second @ a @ a)
            far = np.maximum(reach[place], np.abs(a) / 2)
            more += 4 * _sized(b, chain.third(far)) @ far  # |a| ≤ 2 far
        return np.asarray((np.abs(curved) + more) / 8 + _CLOSED * np.abs(self.back).sum(axis=1))


def _sized(block: Floats, bounds: tuple[Floats, Floats]) -> Floats:
    turned, moved = bounds
    lengths = np.linalg.norm(block.reshape(-1, 2, 3), axis=2)
    return np.asarray(np.outer(lengths[:, 0], turned) + np.outer(lengths[:, 1], moved))


def _equations(chains: Sequence[Spread], free: Sequence[Choice], idle: int) -> _Equations | None:
    """The loops by the free coordinates, of which `idle` may be held at what they are; None where more would have to
    be. `free` (n,) tells of each chain's coordinates whether they are free.
    """
    loops = len(chains) - 1
    whole = []
    for place, chain in enumerate(chains):
        own = np.zeros((6 * loops, chain.first.shape[1]))
        for n in range(loops):
            own[6 * n : 6 * n + 6] = -chain.first if place == 0 else chain.first if place == n + 1 else 0.0
        whole.append(own)
    starts = np.cumsum([0, *(len(c.amounts) for c in chains)])
    matrix = np.concatenate(whole, axis=1)
    chosen = np.flatnonzero(np.concatenate(free))
    _, sizes, right = np.linalg.svd(matrix[:, chosen])
    kernel = right[int((sizes > _DEPENDENT * max([1.0, *sizes])).sum()) :]
    if len(kernel) > idle:
        return None
    chosen = np.delete(chosen, _pivots(kernel))
    if not len(chosen):
        return None
    back = np.linalg.pinv(matrix[:, chosen])
    rest = np.abs(np.eye(len(chosen)) - back @ matrix[:, chosen])
    columns = tuple(chosen[(chosen >= a) & (chosen < b)] - a for a, b in pairwise(starts))
    return _Equations(tuple(chains), columns, np.asarray(back), np.asarray(rest + _ROUNDING))


def _pivots(kernel: Floats) -> list[int]:
    """As many coordinates as the kernel (d, n) has rows, by which it is told: they are held."""
    left, found = kernel.copy(), []
    for _ in range(len(kernel)):
        best = int(np.argmax((left**2).sum(axis=0)))
        found.append(best)
        unit = left[:, best] / np.linalg.norm(left[:, best])
        left -= np.outer(unit, unit @ left)
    return found


def follows(chains: Sequence[Spread], free: Sequence[Choice], idle: int) -> tuple[Floats, ...] | None:
    """How far (n,) each chain's coordinates may be from the straight way in a tube that holds one branch of solutions,
    from one end to the other; None where that is not proved.
    """
    if not any(f.any() for f in free):  # nothing is unknown
        return tuple(np.zeros(len(c.amounts)) for c in chains)
    e = _equations(chains, free, idle)
    if e is None:
        return None
    halves = [np.abs(c.amounts) / 2 for c in chains]
    if e.bent(halves).sum(axis=1).min() >= 1.0:  # no tube, however thin
        return None
    radius = e.gap(halves) * _INFLATED
    for _ in range(_TRIALS):
        tube = _in_place(e, radius)
        reach = [h + r for h, r in zip(halves, tube, strict=True)]
        needed = e.gap(reach) + e.bent(reach) @ radius
        if (needed <= radius * (1 - _ROUNDING)).all():
            return tuple(tube)
        if not needed.max() < 1.0:
            return None
        radius = np.maximum(radius, needed) * _INFLATED
    return None


def _in_place(e: _Equations, radius: Floats) -> list[Floats]:
    starts = np.cumsum([0, *map(len, e.columns)])
    found = []
    for chain, own, a, b in zip(e.chains, e.columns, starts, starts[1:], strict=False):
        every = np.zeros(len(chain.amounts))
        every[own] = radius[a:b]
        found.append(every)
    return found


def keeps_rank(chains: Sequence[Spread], free: Sequence[Choice], idle: int, tube: Sequence[Floats]) -> bool:
    """Whether the loops have, everywhere in the tube, only the motions in which no free coordinate but `idle` ones
    takes part.
    """
    if not any(f.any() for f in free):
        return True
    e = _equations(chains, free, idle)
    if e is None:
        return False
    k = e.bent([np.abs(c.amounts) / 2 + r for c, r in zip(chains, tube, strict=True)])
    if not k.max() < 1e6:
        return False
    v = np.linalg.solve(np.eye(len(k)) - k, np.ones(len(k))) if abs(np.linalg.det(np.eye(len(k)) - k)) > 0 else None
    return v is not None and bool((v > 0).all() and (k @ v < v * (1 - _ROUNDING)).all())
