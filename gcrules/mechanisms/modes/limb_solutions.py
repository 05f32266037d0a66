r"""All ways in which one limb holds the platform where it is: its solutions of the inverse kinematics.

With the platform in its place the amounts of a limb's joints satisfy six equations, and six more for each loop of its
own. They are solved by Levenberg and Marquardt's method from random places of all joints, in one stack. Solutions in
which the limb's joints stand on the same lines, and its driven joints are turned alike, are one: a ball joint has two
triples of angles for each orientation, and a universal joint may be turned half round. It is a search: that no other
solution exists is not proved, but each that is listed closes the loops within rounding.
"""

from __future__ import annotations

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.chains import Chain, geometry_of, shape_of
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed, inverse, logarithm

__all__ = ["MOST", "STARTS", "LimbSolutions", "amounts_at", "limb_solutions"]

STARTS = 256  # random places of all joints of a limb
MOST = 64  # solutions of one limb: more are a limb that can move with the platform at rest
_ITERATIONS = 80
_FARTHEST = 0.6  # of a joint in one step: rad, or parts of the robot's size
_REACH = 2.5  # of slides at the start, in parts of the robot's size
_CLOSED = 1e-11  # rad, or parts of the robot's size
_ONE = 1e-6  # between the places of joints in two solutions that are one
_NOTHING = 1e-10  # amounts below are rounding
_LINELESS = ("S", "E")  # joints whose freedoms are about a point, or along a plane, whatever axes stand for them


@dataclass(frozen=True, eq=False)
class LimbSolutions:
    """The solutions of one limb: amounts (k, coordinates) of its joints from home, those of home first, and of how many
    random starts each was reached (home's at least once). `moving` if they are more than can be told apart: the limb
    can move with the platform at rest, or nearly.
    """

    amounts: Floats
    hits: tuple[int, ...]
    moving: bool = False

    def __len__(self) -> int:
        return len(self.amounts)


def limb_solutions(m: Linkage, place: int) -> LimbSolutions:
    """The solutions of a limb with the platform at home."""
    chain = m.home.chains[place]
    found = amounts_at(m, place, np.eye(4))
    signs = _signatures(m, place, np.concatenate([np.zeros((1, len(chain.turns))), found]))
    chosen, hits = [0], [1]
    for k in range(1, len(signs)):
        near = np.abs(signs[chosen] - signs[k]).max(axis=1) <= _ONE
        if near.any():
            hits[int(np.argmax(near))] += 1
        elif len(chosen) > MOST:
            return LimbSolutions(np.zeros((1, len(chain.turns))), (1,), moving=True)
        else:
            chosen.append(k)
            hits.append(1)
    every = np.concatenate([np.zeros((1, len(chain.turns))), found])[chosen]
    every[np.abs(every) <= _NOTHING * np.where(chain.turns, 1.0, m.size)] = 0.0
    every[(np.abs(every + np.pi) <= _NOTHING) & np.array(chain.turns)] = np.pi  # half a turn has one sign
    driven = [a.coordinate for a in m.actuators if a.place == place]
    order = [0, *sorted(range(1, len(chosen)), key=lambda k: (*every[k, driven].round(6), *every[k].round(6)))]
    return LimbSolutions(every[order], tuple(hits[k] for k in order))


def amounts_at(m: Linkage, place: int, platform: Floats) -> Floats:
    """Amounts with which a limb brings the platform to a motion (4, 4) from home, (N, coordinates), turns in (−π, π];
    of each solution as many as random starts led there.
    """
    chain = m.home.chains[place]
    free = [k for k in range(len(chain.turns)) if (place, k) not in {(p, c) for p, c, _ in m.locked}]
    turns = np.array(chain.turns)
    units = np.where(turns, 1.0, m.size)[free]
    rng = np.random.default_rng(0)  # so that modes have the same names in every run
    start = rng.uniform(-1.0, 1.0, (STARTS, len(free))) * np.where(turns[free], np.pi, _REACH)
    at = np.zeros((STARTS, len(turns)))
    at[:, free] = start * units
    gaps, back = np.full(STARTS, np.inf), inverse(platform)
    active = np.arange(STARTS)
    for _ in range(_ITERATIONS):
        checkpoint()
        r, rows = _equations(m, chain, at[active], back)
        gaps[active] = size = np.sqrt((r * r).sum(axis=1))
        on = size > _CLOSED / 10
        active, r, size = active[on], r[on], size[on]
        if not len(active):
            break
        u, s, v = np.linalg.svd(rows[on][..., free] * units, full_matrices=False)
        damped = s / (s**2 + np.minimum(size, 0.1)[:, None] ** 2 + 1e-30)
        step = -(np.swapaxes(v, 1, 2) @ ((np.swapaxes(u, 1, 2) @ r[..., None])[..., 0] * damped)[..., None])[..., 0]
        far = np.abs(step).max(axis=1, keepdims=True)
        step *= np.minimum(1.0, _FARTHEST / np.where(far > 0, far, 1.0))
        at[np.ix_(active, free)] += step * units
    found = at[gaps <= _CLOSED]
    return np.where(turns, np.pi - np.remainder(np.pi - found, 2 * np.pi), found)


def _equations(m: Linkage, chain: Chain, amounts: Floats, back: Floats) -> tuple[Floats, Floats]:
    """How far the platform, and each loop of the limb, is from closing, (N, 6 · (1 + loops)): shifts of what lies at
    the centre, in parts of the robot's size, and turns; and the derivatives by all amounts.
    """
    links = chain.links(amounts)
    motions = [links[:, -1] @ back, *(links[:, a] @ inverse(links[:, b]) for a, b in chain.loops)]
    gaps = []
    for motion in motions:
        about = motion.copy()
        about[:, :3, 3] += (about[:, :3, :3] @ m.centre[:, None])[..., 0] - m.centre
        gap = logarithm(about)
        gap[:, 3:] /= m.size
        gaps.append(gap)
    twists = np.swapaxes(chain.after(links).shared_twists, -1, -2)  # (N, 1 + loops, coordinates, 6)
    w, v = twists[..., :3], twists[..., 3:]
    local = np.concatenate([w, (v + crossed(w, np.broadcast_to(m.centre, w.shape))) / m.size], axis=-1)
    rows = np.swapaxes(local, -1, -2)
    return np.concatenate(gaps, axis=1), rows.reshape(len(amounts), -1, amounts.shape[1])


def _signatures(m: Linkage, place: int, amounts: Floats) -> Floats:
    """Numbers (N, …) that are the same where the limb's joints stand on the same lines and its driven turns agree."""
    chain, limb = m.home.chains[place], m.robot.limbs[place]
    links = chain.links(amounts)
    screws = chain.after(links).screws.copy()
    screws[..., 3:] = (screws[..., 3:] + crossed(screws[..., :3], np.broadcast_to(m.centre, screws[..., :3].shape))) / (
        m.size
    )
    slides = ~screws[..., :3].any(axis=-1)
    screws[slides] *= m.size
    found = []
    first = 0
    for joint in limb.joints:
        number = len(shape_of(joint.kind).motions)
        if joint.kind in _LINELESS:
            point = np.append(geometry_of(joint, m.home.values)["point"], 1.0)
            there = (links[:, chain.before[first]] @ point)[:, :3]
            found.append((there - m.centre) / m.size)
        else:
            for k in range(first, first + number):
                own = screws[:, k]
                found.append((own[:, :, None] * own[:, None, :]).reshape(len(own), -1))
        first += number
    for a in m.actuators:
        if a.place == place and a.angle:
            angle = amounts[:, a.coordinate]
            found.append(np.stack([np.cos(angle), np.sin(angle)], axis=1))
    return np.concatenate(found, axis=1)
