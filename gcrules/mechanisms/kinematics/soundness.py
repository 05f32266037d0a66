r"""Whether joints that close the loops leave a robot in its family: checks that use nothing of how they were found.

Links that carry one name have to carry it to one place, all relations of the file have to hold, and the freedoms of
each joint have to be those that its links carry along; coordinates that have to stay at 0 do.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.attachments import Values, disagreement, moved, residual_of_relations
from gcrules.mechanisms.kinematics.chains import Chain, chain_of
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed, in_two_places, off_its_relation
from gcrules.mechanisms.kinematics.fixed import unfixed
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["sound", "stays_still"]

_SOUND = 1e-6  # in parts of the robot's size, or of a direction's length
_STILL = 1e-7  # rad


def sound(
    m: Linkage, values: Values, before: Sequence[Chain], links: Sequence[Floats], amounts: Sequence[Floats]
) -> tuple[Values, tuple[Chain, ...], float]:
    """The places of all names, the limbs and how far these are off, after the links of a configuration moved from
    `values` and the limbs `before`, the coordinates growing by `amounts`. All may have an axis for many configurations
    in front. Raises NotClosed where the robot has left its family.
    """
    there = moved(m.robot, m.attachments, values, links)
    apart, name, rides = _worst(disagreement(m.robot, m.attachments, values, links, m.size))
    if not apart <= _SOUND:
        own = m.attachments[name]
        raise in_two_places(m, name, (own[0], own[int(np.argmax(rides.reshape(len(own), -1).max(axis=1)))]))
    off, name, _ = _worst(residual_of_relations(m.robot, there, m.size))
    if not off <= _SOUND:
        raise off_its_relation(m, name)
    for place, coordinate, joint in m.locked:
        if not _still(amounts, place, coordinate).all():
            raise NotClosed(f"the bars of {joint} would not stay parallel")
    try:
        chains = tuple(chain_of(limb, there) for limb in m.robot.limbs)
    except InputError as fault:
        raise NotClosed(fault.message) from None
    loose, name, _ = _worst(unfixed(m, before, links, chains))
    if not loose <= _SOUND:
        raise NotClosed(f"{name} would not stay fixed in its links: other limbs move the points that define it")
    return there, chains, max(apart, off, loose)


def stays_still(m: Linkage, amounts: Sequence[Floats]) -> NDArray[np.bool_]:
    """Where (...,) the coordinates that have to stay at 0 do, when those of each limb (..., n) grow by amounts."""
    kept = np.ones(amounts[0].shape[:-1], dtype=bool)
    for place, coordinate, _ in m.locked:
        kept &= _still(amounts, place, coordinate)
    return kept


def _still(amounts: Sequence[Floats], place: int, coordinate: int) -> NDArray[np.bool_]:
    return np.asarray(np.abs(amounts[place][..., coordinate]) <= _STILL)


def _worst(pairs: Iterable[tuple[str, Floats]]) -> tuple[float, str, Floats]:
    """The largest number, its name, and all numbers of that name."""
    worst, named, there = 0.0, "", np.zeros(0)
    for name, off in pairs:
        largest = float(np.max(off))
        if not largest <= worst:
            worst, named, there = largest, name, off
    return worst, named, there
