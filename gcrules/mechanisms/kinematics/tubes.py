r"""Bounds that prove where the solutions of loop equations are: derivatives of chains, and their tubes.

Several chains lead to one platform; chain 0 is the one that the others are compared with. The equations are
F(q) = (Λ(X_i(q)) − Λ(X_0(q)))_i = 0, with Λ and its derivatives as in `arms`; every configuration in which the loops
close satisfies them. Where a limb has loops of its own, they are compared likewise: two ways to one of its bodies,
which may share coordinates.

`follows`: let the amounts go straight from q(0) to q(1), x(t) between them, B an inverse of the derivatives M at the
middle by the free amounts, K ≥ |1 − B M(q)| for all q in the box |q − x| ≤ ρ around the way, β ≥ |B F(x(t))|, all
elementwise. If β + Kρ ≤ ρ then for each t the equations have exactly one solution in the box around x(t) (Krawczyk's
operator maps it into itself and contracts), which depends continuously on t: a tube that holds one branch.

`holds`: the same with the free coordinates at rest and the others anywhere within their reach: then the equations have
exactly one solution in the box for all values of these, which depends continuously on them.

`keeps_rank`: if the non-negative K has K v < v for some v > 0, then B M(q) is invertible for all q of the box.

Amounts are angles, and lengths in parts of the robot's size. All bounds are computed in floats, with more room left
than they round off. Source: Neumaier, Interval methods for systems of equations, ch. 5, for Krawczyk's operator; the
bounds are derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.arms import Alike, Spread
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Choice", "follows", "holds", "keeps_rank"]

Choice = NDArray[np.bool_]
"""Which coordinates of a chain are meant, (n,)."""

Places = NDArray[np.intp]

_CLOSED = 1e-9  # how far F may be from 0 at both ends of a way
_ROUNDING = 1e-9  # room that is left for rounding, in parts of what is compared
_DEPENDENT = 1e-7
_TRIALS = 12
_INFLATED = 1.1


@dataclass(frozen=True, eq=False)
class _Equations:
    """The loops of several chains linearised in the middle: `back` (..., r, 6 loops) is an inverse of the derivatives
    by the r chosen coordinates; `columns` are those of each block.
    """

    chains: tuple[Spread, ...]
    columns: tuple[Places, ...]
    back: Floats
    rest: Floats  # (..., r, r), |1 − B M| in the middle

    @cached_property
    def blocks(self) -> tuple[Floats, ...]:
        """What Λ of each chain counts in B F: (..., r, 6)."""
        parts = self.back.reshape(*self.back.shape[:-1], self.back.shape[-1] // 6, 6)
        found = [np.zeros((*self.back.shape[:-1], 6)) for _ in self.chains]
        for n, (k, other) in enumerate(_loops(self.chains)):
            found[k] += parts[..., n, :]
            found[other] -= parts[..., n, :]
        return tuple(found)

    @cached_property
    def curvatures(self) -> tuple[Floats, ...]:
        """B ∂²Λ of each chain, (..., r, n, n)."""
        return tuple(
            (b @ c.second.reshape(*c.second.shape[:-2], -1)).reshape(*b.shape[:-1], *c.second.shape[-2:])
            for b, c in zip(self.blocks, self.chains, strict=True)
        )

    @cached_property
    def _sizes(self) -> tuple[Floats, ...]:
        """How much the turn and the shift of each chain count in B F at most, (..., r, 2)."""
        return tuple(np.sqrt((b.reshape(*b.shape[:-1], 2, 3) ** 2).sum(axis=-1)) for b in self.blocks)

    @cached_property
    def _slopes(self) -> tuple[Floats, ...]:
        """|B ∂²Λ| of each chain by all of its coordinates and the chosen ones, (..., n, r · chosen)."""
        found = []
        for k, chain in enumerate(self.chains):
            sizes = np.swapaxes(np.abs(self.curvatures[k][..., self.columns[chain.block]]), -2, -3)
            found.append(sizes.reshape(*sizes.shape[:-2], -1))
        return tuple(found)

    def third(self, reach: Sequence[Floats]) -> list[Floats]:
        """Of each chain bounds of its third derivatives over the box of this reach, (..., 2, n)."""
        found = [np.empty(0)] * len(self.chains)
        for alike in self._alike:
            bounds = alike.third(np.stack([reach[self.chains[k].block] for k in alike.places]))
            for k, own in zip(alike.places, bounds, strict=True):
                found[k] = own
        return found

    @cached_property
    def _alike(self) -> tuple[Alike, ...]:
        return Alike.among(self.chains)

    def bent(self, reach: Sequence[Floats], third: Sequence[Floats]) -> Floats:
        """K (..., r, r) ≥ |1 − B M(q)| over the box of this reach."""
        found = [np.zeros((*self.back.shape[:-1], len(own))) for own in self.columns]
        for k, chain in enumerate(self.chains):
            own = self.columns[chain.block]
            slope = (reach[chain.block][..., None, :] @ self._slopes[k]).reshape(found[chain.block].shape)
            found[chain.block] = found[chain.block] + slope + self._sizes[k] @ third[k][..., own] / 2
        return np.asarray(np.concatenate(found, axis=-1) + self.rest)

    @cached_property
    def _curved(self) -> Floats:
        """How far |B F| is bent along the straight way but for third derivatives, times 8, (..., r)."""
        found = np.zeros(self.back.shape[:-1])
        for k, chain in enumerate(self.chains):
            found += _applied(_applied(self.curvatures[k], chain.amounts[..., None, :]), chain.amounts)
        return np.abs(found)

    @cached_property
    def _open(self) -> Floats:
        """What counts of loops that are as little open as a step may leave them, (..., r)."""
        return np.asarray(_CLOSED * np.abs(self.back).sum(axis=-1))

    def gap(self, reach: Sequence[Floats], third: Sequence[Floats]) -> Floats:
        """β (..., r) ≥ |B F| along the straight way, which no coordinate leaves by more than its reach: its curvature
        by 8, and what is open at its ends.
        """
        more = np.zeros(self.back.shape[:-1])
        for k, chain in enumerate(self.chains):
            more += _applied(self._sizes[k], _applied(third[k], reach[chain.block]))
        return np.asarray((self._curved + 4 * more) / 8 + self._open)  # amounts are no more than twice the reach

    def drift(self, reach: Sequence[Floats], third: Sequence[Floats]) -> Floats:
        """β (..., r) ≥ |B F| where the coordinates differ from the middle by no more than `reach`, which is 0 for the
        chosen ones.
        """
        found = self._open
        for k, chain in enumerate(self.chains):
            far = reach[chain.block]
            curved = (np.abs(self.curvatures[k]) * far[..., None, :, None]).sum(axis=-2) / 2
            slope = np.abs(self.blocks[k] @ chain.first) + curved
            found = found + _applied(slope, far) + _applied(self._sizes[k], _applied(third[k], far)) / 6
        return np.asarray(found)


def _applied(matrices: Floats, vectors: Floats) -> Floats:
    return (matrices @ vectors[..., None])[..., 0]


def _equations(chains: Sequence[Spread], free: Sequence[Choice], idle: int) -> _Equations | None:
    """The loops by the free coordinates, of which `idle` may be held at what they are; None where more would have to
    be. `free` (n,) tells of each block's coordinates whether they are free. Of several at once those are held that are
    right for the first one: nothing is proved where others would have to be.
    """
    loops = _loops(chains)
    starts = np.cumsum([0, *map(len, free)])
    matrix = np.zeros((*chains[0].first.shape[:-2], 6 * len(loops), starts[-1]))
    for n, pair in enumerate(loops):
        for k, sign in zip(pair, (1, -1), strict=True):
            block = chains[k].block
            matrix[..., 6 * n : 6 * n + 6, starts[block] : starts[block + 1]] += sign * chains[k].first
    if not matrix.size:
        return None
    chosen = np.flatnonzero(np.concatenate(free))
    one = matrix[(0,) * (matrix.ndim - 2)][:, chosen]
    if idle or one.shape[0] != one.shape[1]:
        _, sizes, right = np.linalg.svd(one)
        kernel = right[int((sizes > _DEPENDENT * max([1.0, *sizes])).sum()) :]
        if len(kernel) > idle:
            return None
        chosen = np.delete(chosen, _pivots(kernel))
    if not len(chosen):
        return None
    own = matrix[..., chosen]
    back = _inverted(own)
    rest = np.abs(np.eye(len(chosen)) - back @ own)
    columns = tuple(chosen[(chosen >= a) & (chosen < b)] - a for a, b in pairwise(starts))
    return _Equations(tuple(chains), columns, back, np.asarray(rest + _ROUNDING))


def _loops(chains: Sequence[Spread]) -> list[tuple[int, int]]:
    """Each chain that is compared, with its reference."""
    return [(k, c.reference) for k, c in enumerate(chains) if c.reference != k]


def _inverted(matrices: Floats) -> Floats:
    """Left inverses, of matrices that have one; what tall ones lose in normal equations is bounded with the rest."""
    turned = np.swapaxes(matrices, -1, -2)
    with suppress(np.linalg.LinAlgError):
        if matrices.shape[-1] == matrices.shape[-2]:
            return np.asarray(np.linalg.inv(matrices))
        if matrices.shape[-1] < matrices.shape[-2]:
            return np.asarray(np.linalg.inv(turned @ matrices) @ turned)
    return np.asarray(np.linalg.pinv(matrices))


def _pivots(kernel: Floats) -> list[int]:
    """As many coordinates as the kernel (d, n) has rows, by which it is told: they are held."""
    left, found = kernel.copy(), []
    for _ in range(len(kernel)):
        best = int(np.argmax((left**2).sum(axis=0)))
        found.append(best)
        unit = left[:, best] / np.linalg.norm(left[:, best])
        left -= np.outer(unit, unit @ left)
    return found


def follows(chains: Sequence[Spread], free: Sequence[Choice], idle: int) -> tuple[Floats, ...]:
    """How far (..., n) each block's coordinates may be from the straight way in a tube that holds one branch of
    solutions, from one end to the other; infinite where that is not proved.
    """
    return _tubes(chains, free, idle, [np.abs(c.amounts) / 2 for c in chains[: len(free)]], _Equations.gap)


def holds(chains: Sequence[Spread], free: Sequence[Choice], idle: int, reach: Sequence[Floats]) -> tuple[Floats, ...]:
    """How far (..., n) the free coordinates may be from the middle in a box that holds, for all values of the other
    ones within their `reach`, exactly one solution, a continuous one; infinite where that is not proved.
    """
    return _tubes(chains, free, idle, reach, _Equations.drift)


def _tubes(
    chains: Sequence[Spread],
    free: Sequence[Choice],
    idle: int,
    known: Sequence[Floats],
    off: Callable[[_Equations, Sequence[Floats], Sequence[Floats]], Floats],
) -> tuple[Floats, ...]:
    """The tube around coordinates that go as far as `known` by themselves; `off` bounds how far B F is from 0 there."""
    if not any(f.any() for f in free):  # nothing is unknown
        return tuple(np.zeros(a.shape) for a in known)
    nowhere = tuple(np.full(a.shape, np.inf) for a in known)
    e = _equations(chains, free, idle)
    if e is None:
        return nowhere
    along = off is _Equations.gap
    third = e.third(known)
    proved = e.bent(known, third).sum(axis=-1).min(axis=-1) < 1.0  # else no tube, however thin
    start = off(e, known, third)
    radius = start * _INFLATED
    done = np.zeros_like(proved)
    for _ in range(_TRIALS):
        radius = np.where(proved[..., None], radius, 0.0)
        tube = _in_place(e, radius, known)
        reach = [h + r for h, r in zip(known, tube, strict=True)]
        third = e.third(reach)
        needed = (off(e, reach, third) if along else start) + _applied(e.bent(reach, third), radius)
        done = proved & (needed <= radius * (1 - _ROUNDING)).all(axis=-1)
        proved &= needed.max(axis=-1) < 1.0
        if (done | ~proved).all():
            break
        radius = np.where(done[..., None], radius, needed * _INFLATED)
    return tuple(np.where(done[..., None], t, np.inf) for t in _in_place(e, radius, known))


def _in_place(e: _Equations, radius: Floats, known: Sequence[Floats]) -> list[Floats]:
    starts = np.cumsum([0, *map(len, e.columns)])
    found = []
    for amounts, own, a, b in zip(known, e.columns, starts, starts[1:], strict=False):
        every = np.zeros(amounts.shape)
        every[..., own] = radius[..., a:b]
        found.append(every)
    return found


def keeps_rank(
    chains: Sequence[Spread], free: Sequence[Choice], idle: int, reach: Sequence[Floats]
) -> NDArray[np.bool_]:
    """Whether (...,) the loops have, wherever the coordinates differ from the middle by no more than `reach`, only the
    motions in which no free coordinate but `idle` ones takes part.
    """
    shape = chains[0].amounts.shape[:-1]
    if not any(f.any() for f in free):
        return np.ones(shape, dtype=bool)
    e = _equations(chains, free, idle)
    if e is None:
        return np.zeros(shape, dtype=bool)
    far = [np.where(np.isfinite(r), r, 1e9) for r in reach]
    k = e.bent(far, e.third(far))
    small = k.max(axis=(-1, -2)) < 1e6
    left = np.eye(k.shape[-1]) - np.where(small[..., None, None], k, 0.0)
    v = _applied(_inverted(left), np.ones((*shape, k.shape[-1])))
    return np.asarray(small & (v > 0).all(axis=-1) & (_applied(k, v) < v * (1 - _ROUNDING)).all(axis=-1))
