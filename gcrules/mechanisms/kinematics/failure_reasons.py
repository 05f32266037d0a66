"""Why a robot was not followed to where it is wanted: how far it came, and what is wrong there."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.core.english import agreeing
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.carriers import Attachment, carrier
from gcrules.mechanisms.description.carriers import in_two_places as two_places
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates, without_rounding
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.margin import limb_margins, margin
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.screws.pose_text import SHIFTS

__all__ = ["NotClosed", "in_two_places", "off_its_relation", "stopped"]

_LOST = 0.3  # of what it was at home
_HINT = "ask for less, for other coordinates, or give a home on the other side"


class NotClosed(Exception):
    """No solution near by: why, and what helps."""

    def __init__(self, why: str, hint: str = _HINT) -> None:
        super().__init__(why)
        self.hint = hint


def in_two_places(m: Linkage, name: str, two: Sequence[Attachment]) -> NotClosed:
    """For a name that two links carry apart."""
    return NotClosed(*two_places(m.robot, name, two))


def off_its_relation(m: Linkage, name: str) -> NotClosed:
    """For a name that its link, or those it is made from, carry away from its relation."""
    text = next(d.text for d in m.robot.family.definitions if d.name == name)
    rides = f": it is carried by {carrier(m.robot, m.attachments[name][0])}" if name in m.attachments else ""
    return NotClosed(
        f"{name} would violate its relation, {text}{rides}",
        f"give a name of its own to what moves along with the joints, with the coordinates of {name} at home, or"
        " relations that hold in every pose",
    )


def stopped(m: Linkage, here: Configuration, wanted: Target, part: float, told: float, fault: NotClosed) -> InputError:
    """The error for a course that ends at a part of the way; `here` is the last configuration that was reached, `told`
    how well the wanted coordinates determine the pose there, compared with home.
    """
    if wanted.whole is not None and m.robot.mobility < 6 and part <= 0:
        return InputError(
            f"{m.robot.id} cannot take the whole pose {wanted.text}: its platform has mobility {m.robot.mobility}",
            hint=f"give {m.robot.mobility} coordinates, such as z=0.2, roll=5deg; the others follow",
        )
    small = _lost(m, here, wanted, told)
    reason = small or str(fault)
    names = ("x", "y", "yaw") if m.robot.family.plane else ("x", "y", "z", "rx", "ry", "rz")
    numbers = without_rounding(names, coordinates(names, here.platform, m.centre), m.size)
    place = ", ".join(_amount(n, v) for n, v in zip(names, numbers, strict=True))
    if part <= 0:
        message = f"{m.robot.id} cannot move from home towards {wanted.text}: {reason}"
    else:
        message = (
            f"{m.robot.id} was not followed from home to {wanted.text}: it gets {100 * part:.3g}% of the way"
            f" ({place}), where {reason}"
        )
    return InputError(message, hint=_HINT if small else fault.hint)


def _amount(name: str, value: float) -> str:
    return f"{name}={value:.3g}{'' if name in SHIFTS else ' rad'}"


def _lost(m: Linkage, here: Configuration, wanted: Target, told: float) -> str:
    """What has become small, compared with home; nothing if nothing has."""
    lost = {}
    pairs = zip(*limb_margins(m, Configurations.of([here, m.home])).tolist(), m.robot.limbs, strict=True)
    for now, then, limb in pairs:
        lost[f"{limb.name} is near its reach, or another singularity of its own"] = now / then if then else 1.0
    then = margin(m, m.home).sigma
    lost["the robot is near a singularity"] = margin(m, here).sigma / then if then else 1.0
    words, part = min(lost.items(), key=lambda item: item[1])
    if part <= _LOST:
        return f"{words}: margin {100 * part:.1g}% of that at home"
    if told <= _LOST:
        return f"{agreeing(wanted.names, 'hardly determines', 'hardly determine')} the pose any more"
    return ""
