r"""What the actuators do, in closed form on the tape: how far each has turned or slid from home.

A turn is seen on what a limb's first joint carries, a slide on the distance of two points, or on a point that it
carries along a fixed direction. Which of them move so is seen in configurations that were solved by Newton's method,
and what is made of it is compared with others (`limb_programs`).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

import numpy as np

from gcrules.mechanisms.kinematics.linkage import Actuator
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.roots import NoForm, inverse, root
from gcrules.poses.compiling.scalars import Ring
from gcrules.poses.compiling.vectors import Vector, dot, exact, scaled, sub

__all__ = ["amounts"]

_EQUAL = 1e-9  # of slides in parts of the robot's size
_SHORT = 1e-3  # what turns has at least this part of a name's own length


def amounts(places: LimbPlaces) -> tuple[Ring, ...]:
    """For each actuator the cosine and the sine of its turn from home, or the length of its slide, one after the other,
    as in `ClosedForms`. Raises NoForm where one of them has no closed form that is known here.
    """
    return tuple(value for a in places.m.actuators for value in (_turn(places, a) if a.angle else (_slide(places, a),)))


def _turn(places: LimbPlaces, a: Actuator) -> tuple[Ring, Ring]:
    if a.coordinate:
        raise NoForm(f"{a.name} is not the first joint of its limb")
    screw = places.m.home.chains[a.place].screws[0]
    axis, foot = screw[:3], np.cross(screw[:3], screw[3:])
    for name in _carried(places, a):
        home, point = places.m.home.values[name], places.sorts[name] == "point"
        arm = home - foot if point else home
        across = np.cross(axis, arm)
        square = float(across @ across)
        if square <= _SHORT**2 * max(float(arm @ arm), places.size**2 if point else 0.0):
            continue
        try:
            here = places.at(name)
        except NoForm:
            continue
        if name in places.other_length:
            here = scaled(here, inverse(root(dot(here, here))) * exact([np.linalg.norm(home), 0, 0])[0])
        here = sub(here, exact(foot)) if point else here
        along = arm - axis * (axis @ arm)
        return dot(exact(along / square), here), dot(exact(across / square), here)
    raise NoForm(f"nothing shows the turn of {a.name}")


def _slide(places: LimbPlaces, a: Actuator) -> Ring:
    screw, home = places.m.home.chains[a.place].screws, places.m.home.values
    wanted = places.solved.amounts[a.place][:, a.coordinate]
    way = screw[a.coordinate][3:]
    if not np.cross(screw[: a.coordinate, :3], way).any():  # only turns about its own direction come before it
        for name in _carried(places, a):
            if places.sorts[name] == "point":
                along = way / (way @ way)
                return dot(exact(along), sub(places.at(name), exact(home[name])))
    for one, other in permutations((n for n, sort in places.sorts.items() if sort == "point"), 2):
        length = np.linalg.norm(home[other] - home[one])
        now = np.linalg.norm(places.solved.values[other] - places.solved.values[one], axis=-1)
        if np.abs(now - length - wanted).max() <= _EQUAL * places.size:
            try:
                bar: Vector = sub(places.at(other), places.at(one))
            except NoForm:
                continue
            return root(dot(bar, bar)) - exact([length, 0, 0])[0]
    raise NoForm(f"no two points show the slide of {a.name}")


def _carried(places: LimbPlaces, a: Actuator) -> Iterator[str]:
    """Names that the link behind the actuator carries."""
    for name, rides in places.m.attachments.items():
        if any(r.limb == a.place and r.link == a.coordinate + 1 for r in rides):
            yield name
