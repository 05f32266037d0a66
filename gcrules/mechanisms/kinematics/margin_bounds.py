r"""What the margin σ is at least along steps of ways, between their ends too: by how much wrenches turn in a tube.

Seen from the platform the balance in which σ is measured is fixed, and σ is the least length of (P_i ξ)_i over twists ξ
of length 1 in it, P_i the projection to the wrenches of limb i (`margin`). So σ changes by no more than the largest
|P_i − P′_i|. The wrenches are what is orthogonal to the passive twists T (6, k) of the limb, of a rank that does not
grow beyond that of the family. With P = T T⁺ and the twists T + E elsewhere, let e ≥ |E T⁺|, e < 1: then T + E has the
same rank, and for x = T T⁺ x of length 1 the combination (T + E)(T⁺ x − T⁺ E T⁺ x) is x but for

    −(1 − P) E T⁺ x + (E T⁺)² x,

so that |P − P′| ≤ |(1 − P) E T⁺| + e².

From the platform a motion has the twist J_k, which the motions between it and the platform carry: ∂J_k/∂y_j = [J_k,
J_j] for those j, else 0, up to one sign for all, and ∂²J_k/∂y_i∂y_j = [[J_k, J_j], J_i] where i = j or i is nearer to
the platform. A motion that does not lead to the platform has others before it on its way back to a link that does;
their sign is the opposite one. First derivatives are taken in the middle of a step, along the straight way and across
it; second ones are bounded in its tube. The middle of the straight way closes no loop; each limb is seen from where it
has the platform itself.

Where limbs have loops of their own σ is the least of two values (`margin`). The one for the twists of all bodies
changes as above, each chain between two bodies taken for a limb. In the other one P_i projects to what is orthogonal to
U = T ker L, L (6 loops, k) what the twists add to the gaps of the limb's loops. With an orthonormal K of ker L,
L + F has the rank of L and (1 − (L + F)⁺ F) K spans its kernel, if that still has this dimension, which |F K| small
against the least singular value s of L grants: |(L + F)⁺| ≤ 1/(s − |F|). So (T + E) ker(L + F) is spanned by
B + E K − (T + E)(L + F)⁺ F K, B = T K, and as for limbs above

    |P − P′| ≤ |E K B⁺| + (|T| + |E|) |F K B⁺| / (s − |F|),

as long as this is less than 1. Derived here.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.branch import Steps, tubes
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import units_of
from gcrules.mechanisms.kinematics.margin import (
    all_bodies_balance,
    balance,
    free_coordinates_of,
    kept_axes,
    on_bodies,
    platform_ends,
)
from gcrules.mechanisms.kinematics.rigid_motions import Floats, carried, crossed, inverse
from gcrules.mechanisms.kinematics.targets import Target

__all__ = ["StepBounds", "bounds_of"]

_ROUNDING = 1e-9  # of what is bounded
_WRONG = 1e-11  # of a projection, for each unit of |T⁺|


@dataclass(frozen=True, eq=False)
class StepBounds:
    """Of N steps: what σ is `least` (N,) everywhere on them, 0 where nothing is proved, and between which values (N,
    all) the amounts of all joints are, in their own units, up to motions that leave the platform at rest: infinite
    where that is not proved.
    """

    least: Floats
    low: Floats
    high: Floats

    @property
    def followed(self) -> NDArray[np.bool_]:
        """Where (N,) it is proved that the step follows one branch of solutions."""
        return np.asarray(np.isfinite(self.low).all(axis=1))


def bounds_of(m: Linkage, wanted: Target, steps: Steps) -> StepBounds:
    """The bounds of steps."""
    around = tubes(m, wanted, steps)
    values = np.concatenate(steps.here.joint_values, axis=1)
    grown, far = np.concatenate(steps.amounts, axis=1), np.concatenate(around, axis=1) * units_of(m)
    low, high = np.minimum(values, values + grown) - far, np.maximum(values, values + grown) + far
    least = np.zeros(len(values))
    known = np.isfinite(far).all(axis=1)
    if known.any():
        least[known] = _least(m, steps[known], [t[known] for t in around])
    return StepBounds(least, low, high)


def _least(m: Linkage, steps: Steps, around: list[Floats]) -> Floats:
    ends = platform_ends(m, steps.here)
    arms = (ends - ends.mean(axis=1, keepdims=True)) / m.size
    keep = kept_axes(m)
    limbs = [
        _Twists(chain, steps.amounts[place], around[place], ends[:, place], m.size)
        for place, chain in enumerate(steps.here.chains)
    ]
    rows, turned = [], np.zeros(len(ends))
    for place, limb in enumerate(limbs):
        free, rank = free_coordinates_of(m, place), m.passive_ranks[place]
        wrenches, most = limb.through_loops(free, rank, 6 - m.elsewhere.applied[place][1])
        rows.append(_seen(wrenches, arms[:, place], keep))
        turned = np.maximum(turned, most)
    least = _bound(rows, balance(arms, m.ball_ended, keep), turned)
    if not m.looped:
        return least
    rows, turned = [], np.zeros(len(ends))
    for span in m.spans:
        wrenches, most = limbs[span.limb].turned(list(span.free), span.passive_rank)
        rows.append(on_bodies(m, span, _seen(wrenches, arms[:, span.limb], keep)))
        turned = np.maximum(turned, most)
    return np.minimum(least, _bound(rows, all_bodies_balance(m, arms, keep), turned))


def _seen(wrenches: Floats, arm: Floats, keep: list[int]) -> Floats:
    """Wrenches (N, w, 6) as (moment; force) at the end of an arm (N, 3): as (force; moment), the axes to `keep`."""
    f, moment = wrenches[..., 3:], wrenches[..., :3]
    return np.asarray(np.concatenate([f, moment + crossed(arm[:, None], f)], axis=2)[..., keep])


def _bound(rows: list[Floats], scale: Floats, turned: Floats) -> Floats:
    """A bound (N,) of σ where the projections to these wrenches change by no more than `turned` (N,)."""
    every = np.concatenate(rows, axis=1) @ scale
    width = every.shape[2]
    if every.shape[1] < width:
        return np.zeros(len(turned))
    sigma = np.minimum(np.linalg.svd(every, compute_uv=False)[:, width - 1], 1.0)
    return np.asarray(np.maximum(np.nan_to_num(sigma - turned - _ROUNDING, nan=0.0), 0.0))


class _Twists:
    """The twists (ω; v/ρ) of a limb's motions in the middle of N steps, (N, K, 6), v at its end, seen from there; its
    coordinates are no farther than `around` (N, n) from the straight way.
    """

    def __init__(self, chain: Chain, amounts: Floats, around: Floats, end: Floats, size: float) -> None:
        links = chain.links(amounts / 2)
        moved = carried(inverse(links[..., -1, :, :])[..., None, :, :], chain.after(links).screws)
        w, v = moved[..., :3], (moved[..., 3:] + crossed(moved[..., :3], end[:, None])) / size
        units = np.where(chain.turns, 1.0, size)
        self.rows = np.concatenate([w, v], axis=-1)
        self.parts = chain.parts * units  # (K, n): amounts are angles, and lengths in parts of the size
        self.amounts = amounts / units
        self.around = around
        self.shares = chain.shares
        self.ways = _ways(chain)

    def turned(self, free: list[int], rank: int) -> tuple[Floats, Floats]:
        """An orthonormal basis of the wrenches in the middle, (N, 6 − rank, 6) as (moment; force), and a bound (N,) of
        |P − P′| in the tube.
        """
        number = len(self.rows)
        if not free:
            return np.broadcast_to(np.eye(6), (number, 6, 6)), np.zeros(number)
        left, sizes, right = np.linalg.svd(np.swapaxes(self.rows, 1, 2) @ self.parts[:, free])
        found = np.swapaxes(left[..., rank:], 1, 2)
        if not rank:
            return found, np.zeros(number)
        back = np.swapaxes(right[:, :rank], 1, 2) / sizes[:, None, :rank]  # T⁺ in the basis of T's columns
        changes = self._changes(free)
        wrong = _WRONG / sizes[:, rank - 1]
        whole = changes.most(back) + wrong
        most = changes.most(back, against=found) + wrong + whole**2
        return found, np.where(whole < 1 - _ROUNDING, most * (1 + _ROUNDING), np.inf)

    def through_loops(self, free: list[int], rank: int, moving: int) -> tuple[Floats, Floats]:
        """The same of a limb that may have loops of its own: the rank is that of its twists on the platform and in the
        loops together, those with closed loops have `moving` dimensions.
        """
        if self.shares is None or self.shares.shape[1] == 1:
            return self.turned(free, rank)
        own = np.swapaxes(self.rows, 1, 2) @ self.parts[:, free]
        platform, loops = np.split(self.shares[free].T, [1])
        gaps = np.concatenate([own * s for s in loops], axis=1)
        closing = rank - moving
        _, sizes, right = np.linalg.svd(gaps)
        kernel = np.swapaxes(right[:, closing:], 1, 2)
        left, lengths, turn = np.linalg.svd(own * platform @ kernel)
        found = np.swapaxes(left[..., moving:], 1, 2)
        if not moving:
            return found, np.zeros(len(own))
        changes = self._changes(free)
        every = np.broadcast_to(np.eye(len(free)), (len(own), len(free), len(free)))
        with np.errstate(divide="ignore", invalid="ignore"):
            back = kernel @ (np.swapaxes(turn[:, :moving], 1, 2) / lengths[:, None, :moving])
            room = sizes[:, closing - 1] - changes.most(every, loops) - _WRONG
            opened, lost = (_norm(gaps @ x) + changes.most(x, loops) + _WRONG * _norm(x) for x in (back, kernel))
            strength = np.linalg.norm(own * platform, ord=2, axis=(1, 2)) + changes.most(every, platform)
            most = changes.most(back, platform) + strength * opened / room + _WRONG / lengths[:, moving - 1]
        whole = (room > 0) & (lost < room * (1 - _ROUNDING)) & (most < 1 - _ROUNDING)
        return found, np.where(whole, most * (1 + _ROUNDING), np.inf)

    def _changes(self, free: list[int]) -> _Changes:
        own = self.parts[:, free]
        rest = self._rest(np.abs(self.amounts) / 2 + self.around) @ np.abs(own)
        return _Changes(self._bent() @ own, rest, self.amounts, self.around)

    def _bent(self) -> Floats:
        """∂J_k by each coordinate, (N, n, 6, K)."""
        w, v = self.rows[..., :3], self.rows[..., 3:]
        one, other = (w[:, :, None], v[:, :, None]), (w[:, None], v[:, None])
        turn = crossed(one[0], other[0])
        shift = crossed(one[0], other[1]) + crossed(one[1], other[0])
        both = np.concatenate([turn, shift], axis=-1)  # (N, k, j, 6)
        return np.asarray(np.einsum("nkji,jc->ncik", both * self.ways[None, ..., None], self.parts))

    def _rest(self, reach: Floats) -> Floats:
        """How far (N, K) twists of motions are from what first derivatives say, where coordinates are within `reach`
        (N, n) of the middle.
        """
        between = np.abs(self.ways).T
        far = reach @ np.abs(self.parts).T
        turns = np.linalg.norm(self.rows[..., :3], axis=-1)
        speeds = np.linalg.norm(self.rows[..., 3:], axis=-1)
        for k in np.argsort(between.sum(axis=0), kind="stable"):  # those of which fewer motions make the way
            speeds[:, k] += turns[:, k] * ((far * speeds) @ between[:, k])
        turning, moving = ((far * c) @ between for c in (turns, speeds))
        bent = turns * turning**2 / 2
        moved = turns * turning * moving + speeds * turning**2 / 2
        return np.asarray(np.hypot(bent, moved))


@dataclass(frozen=True, eq=False)
class _Changes:
    """By how much the twists T (6, k) of some coordinates change in the tubes of N steps: what each coordinate changes
    in the middle, `bent` (N, n, 6, k), with their amounts on the step and their distances from it (N, n), and a bound
    of the `rest` (N, k).
    """

    bent: Floats
    rest: Floats
    amounts: Floats
    around: Floats

    def most(self, x: Floats, shares: Floats | None = None, against: Floats | None = None) -> Floats:
        """A bound (N,) of |E x| for changes E and matrices x (N, k, c); where rows of shares (s, k) are given of those
        of the twists with the first, the second … of them, one below the other; of that part of E that has power
        `against` wrenches (N, w, 6), but for the rest.
        """
        rows = np.ones((1, self.bent.shape[3])) if shares is None else shares
        changed = np.concatenate([self.bent @ (x * s[:, None])[:, None] for s in rows], axis=2)
        if against is not None:
            changed = against[:, None] @ changed
        along = _norm(np.einsum("nc,ncij->nij", self.amounts, changed)) / 2
        across = (np.linalg.norm(changed, axis=(2, 3)) * self.around).sum(axis=1)
        rest = (self.rest * np.linalg.norm(rows, axis=0) * np.linalg.norm(x, axis=2)).sum(axis=1)
        return np.asarray(along + across + rest)


def _norm(x: Floats) -> Floats:
    return np.asarray(np.linalg.norm(x, axis=(1, 2)))


def _ways(chain: Chain) -> Floats:
    """Which motions carry each motion (K, K), seen from the platform: 1 those after it, up to the platform; −1 those
    that lead to it and not to the platform.
    """
    number = len(chain.uses)
    found = np.zeros((number, number))
    found[:, list(chain.way())] += 1
    for k, link in enumerate(chain.before):
        found[k, list(chain.way(link)) if link else []] -= 1
        found[k, k] = 0
    return found
