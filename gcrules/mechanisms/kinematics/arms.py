r"""Chains on their way, and their derivatives in the middle of it: what `tubes` proves bounds from.

Λ(X) ∈ R⁶ takes the axial vector of the antisymmetric part and the shift of a motion X from the place where the arm that
a chain is compared with has the body. A chain is a product of exponentials, so its derivatives are products of the
twists' matrices in the order of the chain:

    ∂X/∂q_k = Ĵ_k X,   ∂²X/∂q_j∂q_k = Ĵ_j Ĵ_k X,   ∂³X/∂q_h∂q_j∂q_k = Ĵ_h Ĵ_j Ĵ_k X   for h ≤ j ≤ k,

and |Λ| of the last one is at most |ω_h||ω_j||ω_k| in the turn and |ω_h||ω_j||v_k| in the shift, v_k the velocity of the
platform's point. First and second derivatives are taken at the middle of a box of amounts, third ones are bounded.
Chains with as many motions are worked out at once, since few numbers take NumPy as long as many.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.chains import Chain, products
from gcrules.mechanisms.kinematics.rigid_motions import (
    Floats,
    carried,
    cross_matrix,
    crossed,
    exponential,
    inverse,
    lengths,
)

__all__ = ["Alike", "Arm", "Spread", "spreads"]


@dataclass(frozen=True, eq=False)
class Arm:
    """A chain to a body on its way, or several at once: `screws` (..., K, 6) about the platform's centre with lengths
    in sizes, the coordinate that each motion `uses` with its sign, and the amounts (..., n) that the coordinates grow
    by. They are those of one limb, its `block`; `reference` is the place of the arm that is compared with this one.
    """

    screws: Floats
    uses: tuple[int, ...]
    signs: Floats
    amounts: Floats
    block: int = 0
    reference: int = 0

    @classmethod
    def several(cls, chains: Sequence[Chain], amounts: Sequence[Floats], centre: Floats, size: float) -> list[Arm]:
        """The arms of chains with amounts in their own units, about a centre (..., 3): first those to the platform, in
        the order of the chains, then two for each loop that a limb has of its own.
        """
        found = [
            cls._of(c, a, centre, size, k, c.way(), 0) for k, (c, a) in enumerate(zip(chains, amounts, strict=True))
        ]
        for k, (chain, own) in enumerate(zip(chains, amounts, strict=True)):
            for ends in chain.loops:
                reference = len(found) + 1
                found += [cls._of(chain, own, centre, size, k, chain.way(end), reference) for end in ends]
        return found

    @classmethod
    def _of(
        cls, chain: Chain, amounts: Floats, centre: Floats, size: float, block: int, way: Sequence[int], reference: int
    ) -> Arm:
        units = np.where(chain.turns, 1.0, size)
        places, uses = list(way), tuple(chain.uses[k] for k in way)
        w, v = chain.screws[..., places, :3], chain.screws[..., places, 3:]
        moved = np.concatenate([w, (v + crossed(w, centre[..., None, :])) / size], axis=-1)
        return cls(moved * units[list(uses), None], uses, chain.signs[places], amounts / units, block, reference)


@dataclass(frozen=True, eq=False)
class Spread:
    """An arm in the middle of its way: derivatives of Λ by its coordinates, `first` (..., 6, n) and `second`
    (..., 6, n, n), and of its motions how much they turn (0 or 1), how fast they move the platform's point, and to
    which coordinate they belong, with its sign.
    """

    amounts: Floats
    first: Floats
    second: Floats
    turns: Floats
    speeds: Floats
    parts: Floats  # (K, n), the absolute values of the signs
    block: int = 0
    reference: int = 0


@dataclass(frozen=True, eq=False)
class Alike:
    """Spreads of arms with as many motions and coordinates, at these `places` among all: what bounds third derivatives,
    (arms, ..., K) each, and their parts (arms, K, n).
    """

    places: tuple[int, ...]
    turns: Floats
    speeds: Floats
    parts: Floats

    @classmethod
    def among(cls, chains: Sequence[Spread]) -> tuple[Alike, ...]:
        """Those of all chains."""
        groups = _groups([(c.turns.shape, c.parts.shape) for c in chains])
        return tuple(cls._of([chains[k] for k in places], places) for places in groups)

    @classmethod
    def _of(cls, own: Sequence[Spread], places: tuple[int, ...]) -> Alike:
        turns, speeds, parts = (np.stack(x) for x in zip(*((c.turns, c.speeds, c.parts) for c in own), strict=True))
        return cls(places, turns, speeds, parts)

    def third(self, reach: Floats) -> Floats:
        """For each coordinate bounds of Σ |∂³Λ| reach reach in the turn and in the shift, (arms, ..., 2, n), over the
        box in which the coordinates differ by no more than `reach` (arms, ..., n) from the middle.
        """
        d = _times(reach, np.swapaxes(self.parts, 1, 2))
        speeds = self.speeds.copy()
        after = np.zeros(d.shape[:-1])
        for k in range(speeds.shape[-1] - 1, -1, -1):  # motions after k carry the point away from its axis
            speeds[..., k] += self.turns[..., k] * after
            after = after + d[..., k] * speeds[..., k]
        far = d * self.turns
        up_to = np.cumsum(far, axis=-1)  # sums over all pairs of motions, sorted by which of three is the last one
        pairs = d * speeds * (2 * up_to - far)
        later = np.zeros(pairs.shape)
        later[..., :-1] = np.cumsum(pairs[..., :0:-1], axis=-1)[..., ::-1]
        moved = speeds * up_to**2 + self.turns * later
        return np.stack([_times(self.turns * up_to[..., -1:] ** 2, self.parts), _times(moved, self.parts)], axis=-2)


def _times(rows: Floats, matrices: Floats) -> Floats:
    """Rows (arms, ..., n) times the matrix (n, m) of each arm."""
    found = rows.reshape(len(rows), -1, rows.shape[-1]) @ matrices
    return np.asarray(found.reshape(*rows.shape[:-1], matrices.shape[-1]))


def spreads(arms: Sequence[Arm]) -> tuple[Spread, ...]:
    """The arms in the middle of their ways, seen from the place where their reference has the body."""
    groups = _groups([(a.screws.shape, a.amounts.shape) for a in arms])
    links: list[Floats] = [np.empty(0)] * len(arms)
    for places in groups:
        screws = np.stack([arms[k].screws for k in places])
        far = np.stack([arms[k].signs * arms[k].amounts[..., list(arms[k].uses)] / 2 for k in places])
        for k, own in zip(places, products(exponential(screws, far)), strict=True):
            links[k] = own
    back = {n: inverse(links[n][..., -1, :, :]) for n in {a.reference for a in arms}}
    motions = [own[..., -1, :, :] @ back[arm.reference] for arm, own in zip(arms, links, strict=True)]
    found: dict[int, Spread] = {}
    for places in groups:
        several = _spread([arms[k] for k in places], *(np.stack([x[k] for k in places]) for x in (links, motions)))
        found |= zip(places, several, strict=True)
    return tuple(found[k] for k in range(len(arms)))


def _groups(shapes: Sequence[tuple[tuple[int, ...], ...]]) -> list[tuple[int, ...]]:
    """The places of what has the same shapes, which is worked out at once."""
    found: dict[tuple[tuple[int, ...], ...], list[int]] = {}
    for k, shape in enumerate(shapes):
        found.setdefault(shape, []).append(k)
    return [tuple(places) for places in found.values()]


def _spread(arms: Sequence[Arm], links: Floats, motions: Floats) -> Iterator[Spread]:
    """Those of arms that are alike, with their `links` (arms, ..., K + 1, 4, 4) and `motions` (arms, ..., 4, 4)."""
    count = links.shape[-3] - 1
    twists = carried(links[..., :-1, :, :], np.stack([a.screws for a in arms]))
    w = twists[..., :3]
    hats = cross_matrix(w)
    v = twists[..., 3:] + crossed(w, motions[..., None, :3, 3])
    turned = hats @ motions[..., None, :3, :3]
    first = np.concatenate([_axial(turned), v], axis=-1)
    twice = hats[..., :, None, :, :] @ turned[..., None, :, :, :]
    bent = np.concatenate([_axial(twice), crossed(w[..., :, None, :], v[..., None, :, :])], axis=-1)
    j, k = np.indices((count, count))
    bent = np.where((j <= k)[..., None], bent, np.swapaxes(bent, -3, -2))
    first, bent = np.swapaxes(first, -1, -2), np.moveaxis(bent, -1, -3)
    turns, speeds = lengths(w), lengths(v)
    for n, arm in enumerate(arms):
        parts = np.zeros((count, arm.amounts.shape[-1]))
        parts[np.arange(count), list(arm.uses)] = arm.signs
        yield Spread(
            arm.amounts,
            first[n] @ parts,
            parts.T @ bent[n] @ parts,
            turns[n],
            speeds[n],
            np.abs(parts),
            arm.block,
            arm.reference,
        )


def _axial(matrices: Floats) -> Floats:
    """The axial vectors of antisymmetric parts."""
    a = matrices
    return np.stack([a[..., 2, 1] - a[..., 1, 2], a[..., 0, 2] - a[..., 2, 0], a[..., 1, 0] - a[..., 0, 1]], -1) / 2
