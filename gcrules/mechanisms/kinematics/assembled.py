"""A configuration from the amounts of all joints, measured and checked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import loop_gaps
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.soundness import sound

__all__ = ["configuration_at"]


def configuration_at(m: Linkage, amounts: Sequence[Floats]) -> Configuration:
    """The configuration with these amounts from home of each limb's coordinates (rad, the file's unit of length), which
    close the loops. Raises NotClosed where the robot has left its family there.
    """
    links = tuple(c.links(a) for c, a in zip(m.home.chains, amounts, strict=True))
    gaps = loop_gaps(m.home.chains, [own[None] for own in links], np.eye(4)[None], m)
    with np.errstate(invalid="ignore", divide="ignore"):  # names that lose their places are refused
        values, chains, off = sound(m, m.home.values, m.home.chains, links, amounts)
    return Configuration(values, links, tuple(amounts), chains, float(np.abs(gaps).max(initial=0.0)), off)
