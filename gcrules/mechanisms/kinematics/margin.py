r"""How close a configuration is to a singular one: the measure σ for any limbs, and each limb's own margin.

Limb i meets the platform at the point p_i; W_i are its wrenches with the actuators locked, in the inner product
|f|² + |m|²/ρ² with moments m about p_i and ρ the robot's size. |P_i ξ|² is the power of W_i on the twist ξ of the
platform, summed over an orthonormal basis of W_i. It is at most |v_i|² + ε_i ρ²|ω|², v_i the velocity of p_i and
ε_i = 0 where the limb ends in a ball joint at p_i (no moments about p_i), else 1. So

    σ² = the least value over all twists of Σ |P_i ξ|² / Σ (|v_i|² + ε_i ρ²|ω|²)

lies in [0, 1], and is 0 exactly where all wrenches together do not hold the platform. It is the same in every
frame, unit and basis. For six legs with ball joints it is the σ of `gcrules.screws.margin`.

In a singular configuration some ξ has P′_i ξ = 0 for all i, all seen from the platform; so Σ |P_i ξ|² =
Σ |(P_i − P′_i) ξ|² ≤ sin² θ Σ (…), θ the largest angle between W_i and W′_i, also where a singular limb has more
wrenches there: no such configuration before the wrenches of some limb have turned by asin σ relative to the
platform. A limb may be singular by itself sooner: then the platform is held, but an actuator is not felt. Derived here.

A limb that has loops of its own may lose wrenches, and then it has fewer than near by. So where limbs have such loops σ
is the least of this and of the same value over the twists of all bodies, each chain between two bodies taken for a limb
and ξ for the difference of its bodies' twists. It is 0 exactly where a body can move with the actuators locked; how
far such a configuration is it does not tell.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage, Span
from gcrules.mechanisms.kinematics.rigid_motions import Floats, cross_matrix, crossed

__all__ = [
    "LimbMargin",
    "LimbMargins",
    "all_bodies_balance",
    "balance",
    "balanced",
    "free_coordinates_of",
    "kept_axes",
    "limb_margins",
    "limb_twists",
    "margin",
    "margins",
    "on_bodies",
    "on_platform",
    "platform_ends",
    "span_twists",
]

_PLANE = (0, 1, 5)  # of (v; ω): a planar robot's twists
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class LimbMargins:
    """Of N configurations all that a `LimbMargin` has of one, with the axis of the configurations first."""

    rows: Floats
    singular_values: Floats
    motions: Floats
    shares: Floats
    owners: tuple[int, ...]
    centre: Floats

    @property
    def sigma(self) -> Floats:
        """The measure in each configuration."""
        return np.minimum(self.singular_values[:, -1], 1.0)

    def one(self, place: int) -> LimbMargin:
        """That of one configuration."""
        parts = (self.rows, self.singular_values, self.motions, self.shares)
        rows, sizes, motions, shares = (p[place] for p in parts)
        return LimbMargin(rows, sizes, motions, shares, self.owners, self.centre[place])


@dataclass(frozen=True, eq=False)
class LimbMargin:
    """`sigma` with all singular values of the balanced wrenches, least last; `motions` the twists (v; ω) at the
    `centre` of the limbs' ends that take them, in that order, with ω in rad for each unit of v; `shares` (wrenches,) of
    the balance that the softest motion leaves, `owners` the limb of each wrench.

    `rows` are the wrenches (f; m/ρ) themselves, moments about the centre, of each limb an orthonormal basis at its own
    end: a force through the end has length 1. In the plane they have three columns.
    """

    rows: Floats
    singular_values: Floats
    motions: Floats
    shares: Floats
    owners: tuple[int, ...]
    centre: Floats

    @property
    def sigma(self) -> float:
        return float(min(self.singular_values[-1], 1.0))

    @property
    def smallest_singular_value(self) -> float:
        """That of `rows`, whose characteristic length is the robot's size ρ."""
        return float(self._sizes[-1])

    @property
    def condition_number(self) -> float:
        """The largest singular value of `rows` by the smallest; infinite where that is 0 within rounding."""
        sizes = self._sizes
        return float(sizes[0] / sizes[-1]) if sizes[-1] > _ROUNDING * sizes[0] else float("inf")

    @cached_property
    def _sizes(self) -> Floats:
        return np.asarray(np.linalg.svd(self.rows, compute_uv=False))


def margin(m: Linkage, here: Configuration) -> LimbMargin:
    """The measure at a configuration."""
    return margins(m, Configurations.of([here])).one(0)


def margins(m: Linkage, here: Configurations) -> LimbMargins:
    """The measure at many configurations."""
    ends = platform_ends(m, here)
    centre = ends.mean(axis=1)
    rows: list[Floats] = []
    owners: list[int] = []
    arms = (ends - centre[:, None]) / m.size
    for place, chain in enumerate(here.chains):
        wrenches = _locked(m, place, chain, ends[:, place])
        f, moment = wrenches[..., :3], wrenches[..., 3:]
        rows.append(np.concatenate([f, moment + crossed(arms[:, None, place], f)], axis=2))
        owners += [place] * wrenches.shape[1]
    every = np.concatenate(rows, axis=1)
    keep = kept_axes(m)
    scale = balance(arms, m.ball_ended, keep)
    left, sizes, right = np.linalg.svd(every[..., keep] @ scale)
    motions = np.zeros((len(here), len(keep), 6))
    motions[..., keep] = np.swapaxes(scale @ np.swapaxes(right, 1, 2), 1, 2)
    sizes = sizes[:, : len(keep)]
    if m.looped:
        held, motion = _of_all_bodies(m, here, ends, arms, keep)
        softer = held < sizes[:, -1]
        sizes[softer, -1] = held[softer]
        moves = softer & (np.linalg.norm(motion, axis=1) > _ROUNDING)
        motions[np.ix_(moves, [len(keep) - 1], keep)] = motion[moves][:, None]
    largest = np.take_along_axis(motions, np.abs(motions).argmax(axis=2)[..., None], axis=2)
    motions *= np.where(largest < 0, -1.0, 1.0)  # the sign of a motion is free
    motions[..., 3:] /= m.size
    return LimbMargins(every[..., keep], sizes, motions, left[..., len(keep) - 1], tuple(owners), centre)


def _of_all_bodies(
    m: Linkage, here: Configurations, ends: Floats, arms: Floats, keep: Sequence[int]
) -> tuple[Floats, Floats]:
    """The least singular value for the twists of all bodies, (N,), and the platform's part (N, k) of those that take
    it.
    """
    number, width = len(here), m.bodies * len(keep)
    rows = []
    for span in m.spans:
        arm, chain = arms[:, span.limb], here.chains[span.limb]
        twists = _rows(chain.twists(), chain, ends[:, span.limb], m.size)
        wrenches = balanced(twists[:, list(span.free)], span.passive_rank)[..., [3, 4, 5, 0, 1, 2]]
        f, moment = wrenches[..., :3], wrenches[..., 3:]
        own = np.concatenate([f, moment + crossed(arm[:, None], f)], axis=2)[..., keep]
        rows.append(on_bodies(m, span, own))
    scale = all_bodies_balance(m, arms, keep)
    _, sizes, right = np.linalg.svd(np.concatenate(rows, axis=1) @ scale)
    motion = (scale @ right[:, width - 1, :, None])[:, : len(keep), 0]
    least = sizes[:, width - 1] if sizes.shape[1] >= width else np.zeros(number)
    return least, motion


def on_bodies(m: Linkage, span: Span, wrenches: Floats) -> Floats:
    """What wrenches (N, w, k) of a chain between two bodies do to the twists of all bodies, (N, w, bodies × k)."""
    width = wrenches.shape[2]
    found = np.zeros((*wrenches.shape[:2], m.bodies * width))
    for b, s in span.signs:
        found[..., b * width : (b + 1) * width] += s * wrenches
    return found


def all_bodies_balance(m: Linkage, arms: Floats, keep: Sequence[int]) -> Floats:
    """The `balance` (N, bodies × k, bodies × k) for the twists of all bodies, those of the platform first, each chain
    between two of them taken for a limb.
    """
    width = len(keep)
    metric = np.zeros((len(arms), m.bodies * width, m.bodies * width))
    for span in m.spans:
        power = _metric(arms[:, span.limb], ball=False)[:, keep][:, :, keep]
        for b, s in span.signs:
            for c, t in span.signs:
                metric[:, b * width : (b + 1) * width, c * width : (c + 1) * width] += s * t * power
    return _unit_scale(metric)


def kept_axes(m: Linkage) -> list[int]:
    """The columns of a wrench (f; m), and of a twist (v; ω), in which the robot lives: of planar ones three."""
    return list(_PLANE) if m.robot.family.plane else list(range(6))


def balance(arms: Floats, ball_ended: Sequence[bool], keep: Sequence[int] = range(6)) -> Floats:
    """Columns (N, k, k) of twists with Σ (|v_i|² + ε_i ρ²|ω|²) = 1, orthogonal in that sense, of the axes to `keep`.
    The `arms` (N, limbs, 3) lead from the centre of the ends to each of them, in parts of the robot's size.
    """
    metric = np.zeros((len(arms), 6, 6))
    for place, loose in enumerate(ball_ended):
        metric += _metric(arms[:, place], ball=loose)
    return _unit_scale(metric[:, list(keep)][:, :, list(keep)])


def _metric(arm: Floats, *, ball: bool) -> Floats:
    """|v_i|² + ε_i ρ²|ω|² of twists at the end of an arm (N, 3), as matrices (N, 6, 6)."""
    velocity = np.concatenate([np.broadcast_to(np.eye(3), (len(arm), 3, 3)), -cross_matrix(arm)], axis=2)
    found = np.swapaxes(velocity, 1, 2) @ velocity
    if not ball:
        found[:, 3:, 3:] += np.eye(3)
    return np.asarray(found)


def _unit_scale(metric: Floats) -> Floats:
    """Columns that are orthonormal in a metric M (N, k, k): M^(−1/2), unique where eigenvectors are not."""
    values, vectors = np.linalg.eigh(metric)
    # a turn about a line through all ends, ball joints each, moves none of them; no limb's wrench notices it either
    found: Floats = vectors / np.sqrt(np.where(values > _ROUNDING * values[:, -1:], values, 1.0))[:, None]
    return np.asarray(found @ np.swapaxes(vectors, 1, 2))


def platform_ends(m: Linkage, here: Configurations) -> Floats:
    """Where the limbs' ends are, (N, limbs, 3)."""
    return np.asarray(m.ends @ np.swapaxes(here.platform[:, :3, :3], 1, 2) + here.platform[:, None, :3, 3])


def _locked(m: Linkage, place: int, chain: Chain, end: Floats) -> Floats:
    """Orthonormal bases of a limb's wrenches with its actuators locked: rows (f; m/ρ), about the ends (..., 3)."""
    twists = _at(chain, end, m.size)[..., free_coordinates_of(m, place), :]
    count = m.elsewhere.applied[place][1]
    return on_platform(balanced(twists, m.passive_ranks[place]), count)[..., [3, 4, 5, 0, 1, 2]]


def balanced(twists: Floats, rank: int) -> Floats:
    """An orthonormal basis (..., n − rank, n) of what is orthogonal to a limb's twists (..., k, n) of this rank."""
    if not twists.shape[-2]:
        n = twists.shape[-1]
        return np.broadcast_to(np.eye(n), (*twists.shape[:-2], n, n))
    return np.asarray(np.linalg.svd(twists)[2][..., rank:, :])


def on_platform(wrenches: Floats, dimension: int, width: int = 6) -> Floats:
    """Of wrenches on the platform and in a limb's loops together an orthonormal basis of those on the platform, which
    are the first `width` columns and have this dimension; without loops nothing changes.
    """
    if wrenches.shape[-1] == width:
        return wrenches
    return np.asarray(np.linalg.svd(wrenches[..., :width])[2][..., :dimension, :])


def free_coordinates_of(m: Linkage, place: int) -> list[int]:
    """The coordinates of a limb that are not driven."""
    driven = {a.coordinate for a in m.actuators if a.place == place}
    return [k for k in range(len(m.home.chains[place].turns)) if k not in driven]


def limb_twists(m: Linkage, place: int, here: Configurations, centre: Floats) -> tuple[Floats, list[int]]:
    """A limb's twists (ω; v/ρ) in each configuration, (N, coordinates, 6), v at a centre, for a turn by 1 rad and a
    slide by ρ in each coordinate, and which of them are not driven. What they add to the gaps of the limb's own loops
    follows in further sixes.
    """
    return _at(here.chains[place], centre, m.size), free_coordinates_of(m, place)


def _at(chain: Chain, end: Floats, size: float) -> Floats:
    """Rows (ω; v/ρ), v at the ends (..., 3), for a turn by 1 rad and a slide by ρ in each coordinate; one after the
    other for the platform and for each loop.
    """
    shared = chain.shared_twists
    return np.concatenate([_rows(shared[..., k, :, :], chain, end, size) for k in range(shared.shape[-3])], axis=-1)


def _rows(twists: Floats, chain: Chain, end: Floats, size: float) -> Floats:
    """Twists (..., 6, coordinates) as such rows."""
    rows = np.swapaxes(twists, -1, -2)
    w = rows[..., :3]
    moved = np.concatenate([w, (rows[..., 3:] + crossed(w, end[..., None, :])) / size], axis=-1)
    return np.asarray(moved * np.where(chain.turns, 1.0, size)[:, None])


def span_twists(m: Linkage, span: Span, here: Configurations, centre: Floats) -> Floats:
    """The twists of a chain's coordinates in each configuration, (N, coordinates, 6), as those of a limb."""
    chain = here.chains[span.limb]
    return _rows(chain.twists(), chain, centre, m.size)[:, list(span.every)]


def limb_margins(m: Linkage, here: Configurations) -> Floats:
    """For each configuration and limb (N, limbs) the least singular value of the limb's twists that is not 0 in all
    configurations: turns by 1 rad, slides by ρ, measured in |ω|² + |v|²/ρ², v at the limb's end on the platform. It is
    0 where the limb itself is singular, or its passive joints are.
    """
    found = np.ones((len(here), len(here.chains)))
    ends = platform_ends(m, here)
    for place, chain in enumerate(here.chains):
        twists, free = _at(chain, ends[:, place], m.size), free_coordinates_of(m, place)
        every = np.linalg.svd(twists, compute_uv=False)[:, m.ranks[place] - 1]
        passive = np.linalg.svd(twists[:, free], compute_uv=False)[:, m.passive_ranks[place] - 1] if free else 1.0
        found[:, place] = np.minimum(every, passive)
    return found
