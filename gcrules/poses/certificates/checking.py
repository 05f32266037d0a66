"""What a checker of certificates needs of a robot's geometry, without the means that made them: points and axes."""

from __future__ import annotations

from typing import Any

import numpy as np

from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.certificates.asked import Asked
from gcrules.poses.methods import Methods, method

__all__ = ["geometry"]


def geometry(asked: Asked) -> dict[str, Any] | None:
    """Six legs or rods at home: of each its two `ends`, the point on the platform last, and its drive, a leg that
    stretches, a turn about an axis or a slide along a direction; the `centre` about which the platform turns. None for
    robots of which the checker knows nothing.
    """
    found: dict[str, Any] | None = method(_GEOMETRY, asked.mechanism, "a certificate")()
    return found


def _of_legs(m: SixLegs) -> dict[str, Any]:
    points = {n: [float(c) for c in p] for n, p in m.rig.points.items()}
    rods = [{"names": [a, b], "ends": [points[a], points[b]], "drive": "leg"} for a, b in m.rig.legs]
    return {"centre": _plain(m.rig.centre), "rods": rods}


def _of_limbs(m: Limbs) -> dict[str, Any] | None:
    k, rods = m.linkage, []
    driven = {a.place: a for a in k.actuators if a.coordinate == 0}
    for limb, structure in enumerate(m.analysis.structure.limbs):
        if structure.lines is None or len(structure.lines) != 1 or limb not in driven or not k.ball_ended[limb]:
            return None
        names = tuple(structure.lines[0].ends)
        if any(n not in k.home.values or m.robot.family.sorts.get(n) != "point" for n in names):
            return None
        far = [n for n in names if np.array_equal(k.home.values[n], k.ends[limb])]
        if len(far) != 1:
            return None
        start = names[0] if far[0] == names[1] else names[1]
        links = {a.link for a in k.attachments.get(start, ()) if a.limb == limb}
        screw = k.home.chains[limb].screws[0]
        if 1 not in links:
            return None
        found = {"names": [start, far[0]], "ends": [_plain(k.home.values[start]), _plain(k.ends[limb])]}
        if driven[limb].angle:
            axis = screw[:3]
            rods.append({**found, "drive": "turn", "axis": _plain(axis), "through": _plain(np.cross(axis, screw[3:]))})
        else:
            rods.append({**found, "drive": "slide", "axis": _plain(screw[3:])})
        rods[-1]["actuator"] = driven[limb].name
    return {"centre": _plain(k.centre), "rods": rods} if len(rods) == 6 else None


def _plain(v: Any) -> list[float]:
    return [float(c) for c in v]


_GEOMETRY: Methods[dict[str, Any] | None] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
