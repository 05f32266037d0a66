r"""What the margin σ is at least along steps of ways, between their ends too: by how much wrenches turn in a tube.

Seen from the platform the balance in which σ is measured is fixed, and σ is the least length of (P_i ξ)_i over twists ξ
of length 1 in it, P_i the projection to the wrenches of limb i (`margin`). So σ changes by no more than the largest
|P_i − P′_i|. The wrenches are what is orthogonal to the passive twists T (6, k) of the limb, of a rank that does not
grow beyond that of the family. With P = T T⁺ and the twists T + E elsewhere, let e ≥ |E T⁺|, e < 1: then T + E has the
same rank, and for x = T T⁺ x of length 1 the combination (T + E)(T⁺ x − T⁺ E T⁺ x) is x but for

    −(1 − P) E T⁺ x + (E T⁺)² x,

so that |P − P′| ≤ |(1 − P) E T⁺| + e².

From the platform a motion has the twist J_k, which the motions after it carry: ∂J_k/∂y_j = [J_k, J_j] for j > k, else
0, up to one sign for all, and ∂²J_k/∂y_i∂y_j = [[J_k, J_j], J_i] for k < j ≤ i. First derivatives are taken in the
middle of a step, along the straight way and across it; second ones are bounded in its tube. The middle of the straight
way closes no loop; each limb is seen from where it has the platform itself. Derived here.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.branch import Steps, tubes
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.loops import units_of
from gcrules.mechanisms.kinematics.margin import balance, free_coordinates_of, kept_axes, platform_ends
from gcrules.mechanisms.kinematics.rigid_motions import Floats, carried, crossed, inverse
from gcrules.mechanisms.kinematics.targets import Target

__all__ = ["StepBounds", "bounds_of"]

_ROUNDING = 1e-9  # of what is bounded
_WRONG = 1e-11  # of a projection, for each unit of |T⁺|


@dataclass(frozen=True, eq=False)
class StepBounds:
    """Of N steps: what σ is `least` (N,) everywhere on them, 0 where nothing is proved, and between which values (N,
    all) the amounts of all joints are, in their own units: infinite where that is not proved.
    """

    least: Floats
    low: Floats
    high: Floats

    @property
    def followed(self) -> NDArray[np.bool_]:
        """Where (N,) it is proved that the step follows one branch of solutions."""
        return np.asarray(np.isfinite(self.low).all(axis=1))


def bounds_of(m: Linkage, wanted: Target, steps: Steps) -> StepBounds:
    """The bounds of steps. Where limbs have loops of their own nothing is told of σ."""
    around = tubes(m, wanted, steps)
    values = np.concatenate(steps.here.joint_values, axis=1)
    grown, far = np.concatenate(steps.amounts, axis=1), np.concatenate(around, axis=1) * units_of(m)
    low, high = np.minimum(values, values + grown) - far, np.maximum(values, values + grown) + far
    least = np.zeros(len(values))
    known = np.isfinite(far).all(axis=1)
    if known.any() and not m.looped:
        least[known] = _least(m, steps[known], [t[known] for t in around])
    return StepBounds(least, low, high)


def _least(m: Linkage, steps: Steps, around: list[Floats]) -> Floats:
    ends = platform_ends(m, steps.here)
    arms = (ends - ends.mean(axis=1, keepdims=True)) / m.size
    rows, turned = [], np.zeros(len(ends))
    for place, chain in enumerate(steps.here.chains):
        twists = _Twists(chain, steps.amounts[place], ends[:, place], m.size)
        wrenches, most = twists.turned(free_coordinates_of(m, place), m.passive_ranks[place], around[place])
        f, moment = wrenches[..., 3:], wrenches[..., :3]
        rows.append(np.concatenate([f, moment + crossed(arms[:, None, place], f)], axis=2))
        turned = np.maximum(turned, most)
    keep = kept_axes(m)
    every = np.concatenate(rows, axis=1)[..., keep] @ balance(arms, m.ball_ended, keep)
    if every.shape[1] < len(keep):
        return np.zeros(len(ends))
    sigma = np.minimum(np.linalg.svd(every, compute_uv=False)[:, len(keep) - 1], 1.0)
    return np.asarray(np.maximum(np.nan_to_num(sigma - turned - _ROUNDING, nan=0.0), 0.0))


class _Twists:
    """The twists (ω; v/ρ) of a limb's motions in the middle of N steps, (N, K, 6), v at its end, seen from there."""

    def __init__(self, chain: Chain, amounts: Floats, end: Floats, size: float) -> None:
        links = chain.links(amounts / 2)
        moved = carried(inverse(links[..., -1, :, :])[..., None, :, :], chain.after(links).screws)
        w, v = moved[..., :3], (moved[..., 3:] + crossed(moved[..., :3], end[:, None])) / size
        units = np.where(chain.turns, 1.0, size)
        self.rows = np.concatenate([w, v], axis=-1)
        self.parts = chain.parts * units  # (K, n): amounts are angles, and lengths in parts of the size
        self.amounts = amounts / units

    def turned(self, free: list[int], rank: int, around: Floats) -> tuple[Floats, Floats]:
        """An orthonormal basis of the wrenches in the middle, (N, 6 − rank, 6) as (moment; force), and a bound (N,) of
        |P − P′| in the tube.
        """
        number = len(self.rows)
        if not free:
            return np.broadcast_to(np.eye(6), (number, 6, 6)), np.zeros(number)
        own = self.parts[:, free]
        twists = np.swapaxes(self.rows, 1, 2) @ own
        left, sizes, right = np.linalg.svd(twists)
        found = np.swapaxes(left[..., rank:], 1, 2)
        if not rank:
            return found, np.zeros(number)
        back = np.swapaxes(right[:, :rank], 1, 2) / sizes[:, None, :rank]  # T⁺ in the basis of T's columns
        lengths = np.linalg.norm(back, axis=2)
        bent = self._bent() @ own  # (N, n, 6, k): what each coordinate changes
        changed = bent @ back[:, None]
        along = np.einsum("nc,ncij->nij", self.amounts, changed)
        outside = found[:, None] @ changed
        across = np.linalg.norm(found @ along, axis=(1, 2)) / 2
        across += (np.linalg.norm(outside, axis=(2, 3)) * around).sum(axis=1)
        whole = np.linalg.norm(along, axis=(1, 2)) / 2 + (np.linalg.norm(changed, axis=(2, 3)) * around).sum(axis=1)
        more = ((self._rest(np.abs(self.amounts) / 2 + around) @ np.abs(own)) * lengths).sum(axis=1)
        more = more + _WRONG / sizes[:, rank - 1]
        whole = whole + more
        most = (across + more + whole**2) * (1 + _ROUNDING)
        return found, np.where(whole < 1 - _ROUNDING, most, np.inf)

    def _bent(self) -> Floats:
        """∂J_k by each coordinate, (N, n, 6, K)."""
        w, v = self.rows[..., :3], self.rows[..., 3:]
        one, other = (w[:, :, None], v[:, :, None]), (w[:, None], v[:, None])
        turn = crossed(one[0], other[0])
        shift = crossed(one[0], other[1]) + crossed(one[1], other[0])
        both = np.concatenate([turn, shift], axis=-1)  # (N, k, j, 6)
        later = np.triu(np.ones(both.shape[1:3]), 1)
        return np.asarray(np.einsum("nkji,jc->ncik", both * later[None, ..., None], self.parts))

    def _rest(self, reach: Floats) -> Floats:
        """How far (N, K) twists of motions are from what first derivatives say, where coordinates are within `reach`
        (N, n) of the middle.
        """
        far = reach @ np.abs(self.parts).T
        turns = np.linalg.norm(self.rows[..., :3], axis=-1)
        speeds = np.linalg.norm(self.rows[..., 3:], axis=-1)
        for k in range(speeds.shape[1] - 2, -1, -1):
            speeds[:, k] += turns[:, k] * (far[:, k + 1 :] * speeds[:, k + 1 :]).sum(axis=1)
        turning, moving = (_later(far * c) for c in (turns, speeds))
        bent = turns * turning**2 / 2
        moved = turns * turning * moving + speeds * turning**2 / 2
        return np.asarray(np.hypot(bent, moved))


def _later(c: Floats) -> Floats:
    """Sums (N, K) of what comes after each."""
    return np.asarray(c.sum(axis=1, keepdims=True) - np.cumsum(c, axis=1))
