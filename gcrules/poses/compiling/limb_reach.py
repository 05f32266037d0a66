"""Whether a limb reaches a pose, as far as the closed forms show: the roots by which its links are placed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction

from gcrules.mechanisms.description.limb_file import JointSpec, LimbSpec
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.roots import NoForm
from gcrules.poses.compiling.scalars import Ring, Scalar

__all__ = ["placing_roots", "reach_is_seen"]

_ENDS = ("R", "U", "S")


def placing_roots(m: Limbs, places: LimbPlaces) -> tuple[Ring, ...]:
    """All roots by which names of the robot are placed: where one does not exist, a limb does not reach the pose.

    To be asked for before anything else is made of the places.
    """
    for name in m.linkage.attachments:
        with suppress(NoForm):
            places.at(name)
    return tuple(Scalar(places.graph, 1, node) for node in places.solved_for)


def reach_is_seen(m: Limbs, places: LimbPlaces) -> bool:
    """Whether every limb reaches each pose in which all these roots exist: it has a slide between two hinges or balls,
    a single joint, or a link that is placed by a root.
    """
    seen = set(_carriers(m, places))
    return all(k in seen or _stretches(limb) for k, limb in enumerate(m.robot.limbs))


def _carriers(m: Limbs, places: LimbPlaces) -> Iterator[int]:
    """The limbs, by their numbers, whose first link carries a name that is placed by a root."""
    for name in places.solved_for.values():
        for a in m.linkage.attachments.get(name, ()):
            if a.link == 1:
                yield a.limb


def _stretches(limb: LimbSpec) -> bool:
    """Whether a limb is a joint, or a slide along the line between two joints."""
    if limb.subchains or limb.couplings:
        return False
    kinds = [j.kind for j in limb.joints]
    if len(kinds) == 1:
        return kinds[0] in _ENDS
    if len(kinds) != len(_ENDS) or kinds[1] != "P" or not {kinds[0], kinds[2]} <= set(_ENDS):
        return False
    first, along, last = (_names(joint) for joint in limb.joints)
    return len(first) == len(last) == 1 and len(along) == 2 and along == first | last


def _names(joint: JointSpec) -> set[str]:
    """The names in the first argument of a joint: of a hinge its point, of a slide that along a difference both."""
    first = joint.args[0]
    return set() if isinstance(first, Fraction) else {name for _, name in first}
