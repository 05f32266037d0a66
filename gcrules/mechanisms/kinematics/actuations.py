r"""What actuators do in many configurations at once: their wrenches, and the constraints of all limbs.

Of a limb with locked actuators let S be an orthonormal basis of the wrenches, and P the products of its rows with the
unit twists of the actuators. The rows of P⁺ S are wrenches of the limb with product 1 with the twist of one actuator
each, and 0 with those of the others: what they are beside that lies in the limb's constraints, and does not count. In a
limb with loops of its own they are the wrenches on the platform and in its loops together.
"""

from __future__ import annotations

import numpy as np

from gcrules.mechanisms.kinematics.amplification import Amplifications, amplifications
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.margin import balanced, limb_twists, on_platform
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["actuations", "amplified", "amplified_by_legs"]

_RANK = 1e-9
_SWAPPED = [3, 4, 5, 0, 1, 2]  # what is orthogonal to twists (ω; v/ρ) are wrenches (m/ρ; f)


def amplified(m: Linkage, here: Configurations) -> Amplifications:
    """What the actuators make of their rates, about the moved centre, with the robot's size as characteristic
    length.
    """
    return amplifications(*actuations(m, here), [a.angle for a in m.actuators], m.robot.mobility, m.size, m.pulls)


def amplified_by_legs(base: Floats, ends: Floats, centres: Floats) -> Amplifications:
    """The same of legs from base points (6, 3) to ends (N, 6, 3), about centres (N, 3). Legs of no length apply no
    wrench.
    """
    along = ends - base
    lengths = np.linalg.norm(along, axis=2, keepdims=True)
    forces = along / np.where(lengths > 0, lengths, np.nan)
    rows = np.concatenate([forces, np.cross(ends - centres[:, None], forces)], axis=2)
    arms = ends - ends.mean(axis=1, keepdims=True)
    size = float(np.sqrt((arms[0] ** 2).sum(axis=1).mean()))
    return amplifications(rows, np.zeros((len(rows), 0, 6)), (False,) * 6, 6, size)


def actuations(m: Linkage, here: Configurations) -> tuple[Floats, Floats]:
    """The wrenches (f; m about the moved centre) of the actuators, (N, actuators, 6), in their order, for rates of 1
    rad or a unit of length, not numbers where an actuator applies none; and of all limbs' constraints, (N, k, 6).
    """
    centre = m.centre @ np.swapaxes(here.platform[:, :3, :3], 1, 2) + here.platform[:, :3, 3]
    driven: list[Floats] = [np.zeros(0)] * len(m.actuators)
    held = []
    for place, chain in enumerate(here.chains):
        twists, free = limb_twists(m, place, here, centre)
        own_wrenches = on_platform(balanced(twists, m.ranks[place]), m.elsewhere.applied[place][0])
        held.append(own_wrenches[..., _SWAPPED])
        own = [k for k, a in enumerate(m.actuators) if a.place == place]
        if not own:
            continue
        locked = balanced(twists[:, free], m.passive_ranks[place])
        coordinates = [m.actuators[k].coordinate for k in own]
        units = np.where(np.array(chain.turns)[coordinates], m.size, 1.0)
        rates = units[:, None] * twists[:, coordinates]  # (ρ ω; v) for unit rates
        products = rates @ np.swapaxes(locked, 1, 2)
        none = np.linalg.svd(products, compute_uv=False)[:, -1] <= _RANK * m.size
        rows = (np.swapaxes(np.linalg.pinv(products), 1, 2) @ locked)[..., _SWAPPED]
        rows[none] = np.nan
        for k, row in zip(own, np.moveaxis(rows, 1, 0), strict=True):
            driven[k] = row
    scale = np.array([1.0, 1.0, 1.0, m.size, m.size, m.size])
    return np.stack(driven, axis=1) * scale, np.concatenate(held, axis=1) * scale
