"""Whether every joint stays fixed in its links, also where names that make its axis are carried by other limbs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gcrules.mechanisms.kinematics.chains import Chain, shape_of
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, cross_matrix, lengths

__all__ = ["unfixed"]


def unfixed(
    m: Linkage, before: Sequence[Chain], links: Sequence[Floats], after: Sequence[Chain]
) -> Iterator[tuple[str, Floats]]:
    """For each joint how far (...,) its freedoms are from those that its links carry.

    `links` are the motions of all links from the chains `before` to those `after`, which are made from the names at
    their new places. What is compared are spans of twists: 0 where they agree, at most 1, with moments about the
    platform's centre at home and lengths divided by the robot's size. Freedoms that stay at 0 are left out.
    """
    still = {(place, coordinate) for place, coordinate, _ in m.locked}
    for place, limb in enumerate(m.robot.limbs):
        start = 0
        for joint, coordinates in zip(limb.joints, limb.coordinates, strict=True):
            motions = slice(start, start + len(shape_of(joint.kind).motions))
            own = [k for k in coordinates if (place, k) not in still]
            old = _scaled(before[place].twists(links[place], motions)[..., own], m)
            new = _scaled(after[place].twists(motions=motions)[..., own], m)
            basis, _ = np.linalg.qr(old)
            rest = new - basis @ (np.swapaxes(basis, -1, -2) @ new)
            sizes = lengths(rest, -2) / lengths(new, -2)
            yield joint.text, sizes.max(axis=-1)
            start = motions.stop


def _scaled(twists: Floats, m: Linkage) -> Floats:
    """Columns (ω; v/size), v at the centre."""
    moved = twists[..., 3:, :] - cross_matrix(m.centre) @ twists[..., :3, :]
    return np.concatenate([twists[..., :3, :], moved / m.size], axis=-2)
