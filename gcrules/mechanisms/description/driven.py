"""What is driven in the limbs of a robot: actuators by their names, in the order of the file."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.screws import JOINTS

__all__ = ["Driven", "driven_freedoms"]


@dataclass(frozen=True)
class Driven:
    """A driven freedom: its `name` (q1, q2 … in the order of the file); the places of its limb, of its joint there and
    of the freedom in that; whether its amount is an angle; and the name of the joint, if it has one.
    """

    name: str
    limb: int
    place: int
    freedom: int
    angle: bool
    joint: str = ""


def driven_freedoms(limbs: Sequence[LimbSpec]) -> tuple[Driven, ...]:
    """All that is driven in limbs."""
    found: list[Driven] = []
    for number, limb in enumerate(limbs):
        for place, joint in enumerate(limb.joints):
            for n in joint.actuated:
                kind = JOINTS[joint.kind]
                angle = kind.has_bars or "slide" not in kind.freedoms[n]  # of bars the angle by which they swing
                found.append(Driven(f"q{len(found) + 1}", number, place, n, angle, joint.name))
    return tuple(found)
