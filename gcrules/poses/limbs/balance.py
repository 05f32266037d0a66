"""Limbs by themselves: how close each is to its own singularities, and what it adds to the balance of wrenches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.floats import without_noise
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.margin import LimbMargin
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["LimbNumbers", "limb_numbers"]

XYZ = tuple[float, float, float]

_NONE = 1e-9


@dataclass(frozen=True)
class LimbNumbers:
    """A limb by itself: `margin` to its own singularities (0 there), and its part in the balance of wrenches that
    resists the softest motion least: the wrenches of all limbs sum up to 0 where the robot is singular, and nearly so
    close to that. `share` is the size of its wrench (largest 1), `force` and `moment` (about the Jacobian's centre) are
    the wrench itself.
    """

    name: str
    margin: float
    share: float
    force: XYZ
    moment: XYZ

    def to_json(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "margin": self.margin,
            "share": self.share,
            "force": [without_noise(c) for c in self.force],
            "moment": [without_noise(c) for c in self.moment],
        }

    def wrench(self, centre: Floats, size: float) -> str:
        """The wrench in words: where it acts, for lengths about `size`."""
        if not self.share:
            return "none"
        f, m = np.array(self.force), np.array(self.moment)
        strength = float(np.linalg.norm(f))
        if strength <= 1e-9 * float(np.linalg.norm(m)) / size:
            return f"a couple about {_shown(m / np.linalg.norm(m))}"
        point = centre + np.cross(f, m) / strength**2
        pitch = float(f @ m) / strength**2
        what = "a force" if abs(pitch) <= 1e-9 * size else f"a wrench of pitch {pitch:.4g}"
        return f"{what} along {_shown(f / strength)} through {_shown(point)}"


def _shown(v: Floats) -> str:
    return "(" + ", ".join(f"{c:.4g}" for c in np.round(v, 9) + 0.0) + ")"


def limb_numbers(m: Linkage, near: LimbMargin, own: Sequence[float]) -> tuple[LimbNumbers, ...]:
    """The numbers of all limbs from the margin of the robot and of each limb."""
    owners = np.array(near.owners)
    places = [0, 1, 5] if m.robot.family.plane else list(range(6))
    wrenches = np.zeros((len(own), 6))
    for place in range(len(own)):
        wrenches[place, places] = near.shares[owners == place] @ near.rows[owners == place]
    first = next((w for w in wrenches if np.abs(w).max() > _NONE), wrenches[0])
    if first[int(np.argmax(np.abs(first)))] < 0:  # the sign of a balance is free
        wrenches = -wrenches
    shares = [float(np.linalg.norm(near.shares[owners == place])) for place in range(len(own))]
    largest = max(shares) or 1.0
    found = []
    for limb, c, share, wrench in zip(m.robot.limbs, own, shares, wrenches / largest, strict=True):
        part = share / largest if share > _NONE * largest else 0.0
        force, moment = wrench[:3], m.size * wrench[3:]
        found.append(LimbNumbers(limb.name, float(c), part, _xyz(force), _xyz(moment)))
    return tuple(found)


def _xyz(v: Floats) -> XYZ:
    x, y, z = (float(c) for c in v)
    return x, y, z
