r"""Whether joints that close the loops leave a robot in its family: checks that use nothing of how they were found.

Links that carry one name have to carry it to one place, all relations of the file have to hold, and the freedoms of
each joint have to be those that its links carry along; coordinates that have to stay at 0 do.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.attachments import Values, disagreement, moved, residual_of_relations
from gcrules.mechanisms.kinematics.chains import Chain, chain_of
from gcrules.mechanisms.kinematics.fixed import unfixed
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Strayed", "sound"]

_SOUND = 1e-6  # in parts of the robot's size, or of a direction's length
_STILL = 1e-7  # rad


class Strayed(Exception):
    """The robot has left its family."""


def sound(
    m: Linkage, values: Values, before: Sequence[Chain], links: Sequence[Floats], amounts: Sequence[Floats]
) -> tuple[Values, tuple[Chain, ...], float]:
    """The places of all names, the limbs and how far these are off, after the links of a configuration moved from
    `values` and the limbs `before`, the coordinates growing by `amounts`. All may have an axis for many configurations
    in front. Raises Strayed.
    """
    there = moved(m.robot, m.attachments, values, links)
    off, name = _worst(disagreement(m.robot, m.attachments, values, links, m.size))
    more, other = _worst(residual_of_relations(m.robot, there, m.size))
    if not max(off, more) <= _SOUND:
        raise Strayed(f"{name if off > more else other} would leave what its relations and its joints say of it")
    for place, coordinate, joint in m.locked:
        if np.abs(amounts[place][..., coordinate]).max() > _STILL:
            raise Strayed(f"the bars of {joint} would not stay parallel")
    try:
        chains = tuple(chain_of(limb, there) for limb in m.robot.limbs)
    except InputError as fault:
        raise Strayed(fault.message) from None
    loose, name = _worst(unfixed(m, before, links, chains))
    if not loose <= _SOUND:
        raise Strayed(f"{name} would not stay fixed in its links: other limbs move what it is named by")
    return there, chains, max(off, more, loose)


def _worst(pairs: Iterable[tuple[str, Floats]]) -> tuple[float, str]:
    worst, named = 0.0, ""
    for name, off in pairs:
        largest = float(np.max(off))
        if not largest <= worst:
            worst, named = largest, name
    return worst, named
