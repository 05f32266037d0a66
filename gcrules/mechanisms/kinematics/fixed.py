"""Whether every joint stays fixed in its links, also where names that make its axis are carried by other limbs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gcrules.mechanisms.kinematics.chains import Chain, shape_of
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed, lengths

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
    names: list[str] = []
    spans: dict[int, list[tuple[int, Floats, Floats]]] = {}  # by how many twists span them
    for place, limb in enumerate(m.robot.limbs):
        old, new = (_scaled(c.screws, m) for c in (before[place].after(links[place]), after[place]))
        start = 0
        for joint, coordinates in zip(limb.joints, limb.coordinates, strict=True):
            stop = start + len(shape_of(joint.kind).motions)
            own = [k for k in coordinates if (place, k) not in still]
            parts = after[place].parts[start:stop, own]
            twists = [np.swapaxes(rows[..., start:stop, :], -1, -2) @ parts for rows in (old, new)]
            spans.setdefault(len(own), []).append((len(names), twists[0], twists[1]))
            names.append(joint.text)
            start = stop
    found: list[Floats] = [np.zeros(())] * len(names)
    for several in spans.values():
        places, was, now = zip(*several, strict=True)
        for k, off in zip(places, _apart(np.stack(was), np.stack(now)), strict=True):
            found[k] = off
    yield from zip(names, found, strict=True)


def _apart(old: Floats, new: Floats) -> Floats:
    """How far the columns of `new` (..., 6, n) are from the span of those of `old`, in parts of their lengths."""
    basis, _ = np.linalg.qr(old)
    rest = new - basis @ (np.swapaxes(basis, -1, -2) @ new)
    return np.asarray((lengths(rest, -2) / lengths(new, -2)).max(axis=-1))


def _scaled(screws: Floats, m: Linkage) -> Floats:
    """Rows (ω; v/size), v at the centre."""
    w = screws[..., :3]
    return np.concatenate([w, (screws[..., 3:] - crossed(m.centre, w)) / m.size], axis=-1)
