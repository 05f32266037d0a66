r"""The skeleton of a robot as its links carry it, for pages that move the robot without a server.

A drawing makes a skeleton anew in each configuration, from all names. Most of its places ride on one link all the same,
and those within a telescope divide the way between two such places in one ratio. Which
link it is, is found by comparing the drawings of a few configurations near home, in the unit of home.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.kinematics.solve import beside
from gcrules.mechanisms.kinematics.targets import actuators_target
from gcrules.views.robots.skeleton import skeleton, unit_at
from gcrules.views.scene_data import CarriedPlace, CarriedSkeleton, CarriedStroke, SkeletonView, Vec3

__all__ = ["carried_skeleton"]

_MOVES = ((0.031, 0.053, 0.041, 0.029, 0.047, 0.037), (-0.043, 0.037, -0.029, 0.051, -0.033, 0.045))
"""What the actuators are moved by: rad, or parts of the robot's size. Wrong links show at once."""
_ACCURACY = 1e-7  # of the size of the drawing

Link = tuple[int, int]
"""A limb and one of its links."""


def carried_skeleton(m: Linkage) -> CarriedSkeleton | None:
    """The links that carry each place of the skeleton; None where some place rides on none, or the robot cannot be
    moved a little by its actuators.
    """
    seen = _near_home(m)
    if seen is None:
        return None
    places = [{n: v.tolist() for n, v in c.values.items()} for c in seen]
    unit = unit_at(m.robot, places[0])
    drawn = [skeleton(m.robot, one, unit) for one in places]
    if len({_form(one) for one in drawn}) > 1:
        return None
    links = [(i, k) for i, own in enumerate(m.home.links) for k in range(len(own))]
    motions = {(i, k): np.array([c.links[i][k] for c in seen]) for i, k in links}
    strokes = [np.array(ends) for ends in zip(*([s["ends"] for s in one["strokes"]] for one in drawn), strict=True)]
    try:
        return _Carriers(motions, strokes, _ACCURACY * unit.radius).skeleton(drawn)
    except LookupError:
        return None


def _near_home(m: Linkage) -> list[Configuration] | None:
    """Home and configurations beside it; None where the robot stops before it is there."""
    drives = leading(m)
    seen = [m.home]
    for move in _MOVES:
        amounts = [move[i % len(move)] * (1.0 if a.angle else m.size) for i, a in enumerate(drives)]
        try:
            seen.append(beside(m, actuators_target(m, amounts), m.home))
        except InputError:
            return None
    return seen


def _form(one: SkeletonView) -> tuple[int, ...]:
    """How many there are of everything."""
    axes = (len(s["axes"]) for s in one["signs"])
    return (len(one["strokes"]), len(one["platform"]), len(one["base"]), *axes)


@dataclass(frozen=True, eq=False)
class _Carriers:
    """Finds links by what they do in several configurations, the first of which is home: `motions` from home
    (configurations, 4, 4), and `strokes` (configurations, 2, 3).
    """

    motions: Mapping[Link, Floats]
    strokes: Sequence[Floats]
    accuracy: float

    def skeleton(self, drawn: Sequence[SkeletonView]) -> CarriedSkeleton:
        """Of what is drawn in all configurations. Raises LookupError where no link carries a part of it."""
        home = drawn[0]
        signs = [np.array(at) for at in zip(*([s["at"] for s in one["signs"]] for one in drawn), strict=True)]
        carriages = [at for at, sign in zip(signs, home["signs"], strict=True) if sign["kind"] == "carriage"]
        strokes: list[CarriedStroke] = [
            {"ends": self._ends(ends, carriages if s["look"] == "rail" else ()), "look": s["look"]}
            for ends, s in zip(self.strokes, home["strokes"], strict=True)
        ]
        ends = [end for stroke in strokes for end in stroke["ends"]]
        return {
            "strokes": strokes,
            "signs": [
                {
                    "kind": sign["kind"],
                    "actuated": sign["actuated"],
                    "at": self._place(signs[k]),
                    "axes": [
                        self._axis(np.array([one["signs"][k]["axes"][i] for one in drawn]), signs[k])
                        for i in range(len(sign["axes"]))
                    ],
                }
                for k, sign in enumerate(home["signs"])
            ],
            "platform": [self._corner(np.array(p), ends) for p in zip(*(d["platform"] for d in drawn), strict=True)],
            "base": [self._corner(np.array(p), ends) for p in zip(*(d["base"] for d in drawn), strict=True)],
        }

    def _ends(self, stroke: Floats, carriages: Sequence[Floats]) -> list[CarriedPlace]:
        """Of a stroke; of bars that turn and are drawn as a rail, those of the carriage on it."""
        try:
            return [self._place(stroke[:, 0]), self._place(stroke[:, 1])]
        except LookupError:
            for at in carriages:
                if _share(stroke[0], at[0]) is not None and (link := self._link(at)):
                    return [_carried([link], [1.0], [end]) for end in stroke[0]]
            raise

    def _corner(self, corner: Floats, ends: Sequence[CarriedPlace]) -> CarriedPlace:
        """Of a corner of a body: the end of a stroke that is there at home, else what carries it."""
        for end in ends:
            if len(end["links"]) == 1 and np.abs(end["at"][0] - corner[0]).max() <= self.accuracy:
                return end
        return self._place(corner)

    def _place(self, place: Floats) -> CarriedPlace:
        """What carries a place (configurations, 3): a link, or two that carry the ends of a stroke."""
        link = self._link(place)
        if link is not None:
            return _carried([link], [1.0], [place[0]])
        for ends in self.strokes:
            shares = [_share(*both) for both in zip(ends, place, strict=True)]
            links = [link for k in (0, 1) if (link := self._link(ends[:, k]))]
            if None not in shares and np.ptp(shares) <= _ACCURACY and len(links) == 2:  # type: ignore[arg-type]
                share = float(shares[0] or 0.0)
                return _carried(links, [1.0 - share, share], ends[0])
        raise LookupError

    def _axis(self, axis: Floats, place: Floats) -> CarriedPlace:
        """What turns a unit vector (configurations, 3): a link, or two that carry the ends of the stroke along it that
        goes through the place of its joint.
        """
        for one, motion in self.motions.items():
            if np.abs(motion[:, :3, :3] @ axis[0] - axis).max() <= _ACCURACY:
                return _carried([one, one], [-1.0, 1.0], [np.zeros(3), axis[0]])
        for ends in self.strokes:
            links = [link for k in (0, 1) if (link := self._link(ends[:, k]))]
            along = np.cross(ends[:, 1] - ends[:, 0], axis)
            if len(links) == 2 and np.abs(along).max() <= self.accuracy and _share(ends[0], place[0]) is not None:
                return _carried(links, [-1.0, 1.0], ends[0])
        raise LookupError

    def _link(self, place: Floats) -> Link | None:
        """The first link that carries a place (configurations, 3)."""
        for link, motion in self.motions.items():
            if np.abs(motion[:, :3, :3] @ place[0] + motion[:, :3, 3] - place).max() <= self.accuracy:
                return link
        return None


def _share(ends: Floats, place: Floats) -> float | None:
    """In which part of a stroke (2, 3) a place is; None where it is not on it."""
    way = ends[1] - ends[0]
    far = float(np.linalg.norm(way))
    if not far:
        return None
    share = float(way @ (place - ends[0])) / far**2
    off = float(np.linalg.norm(ends[0] + share * way - place))
    return share if off <= _ACCURACY * far and -_ACCURACY <= share <= 1.0 + _ACCURACY else None


def _carried(links: Sequence[Link], shares: Sequence[float], at: Sequence[Floats] | Floats) -> CarriedPlace:
    found: list[Vec3] = [[float(c) for c in p] for p in at]
    return {"links": [list(link) for link in links], "shares": list(shares), "at": found}
