"""Which link of which limb each point and direction of a robot rides on, so that motions carry it along.

A limb's links are counted by elementary motions: link n of a joint comes after n of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS, RATIONALS, JointKind
from gcrules.screws.fields import Row

__all__ = ["Attachment", "Riding", "attachments", "carrier", "in_two_places", "riding", "sample_of", "starts"]


@dataclass(frozen=True)
class Riding:
    """Of a kind of joint, how many elementary motions it has, and from which of its links to which each part rides.
    `loose` parts fix only a line, so that another joint that names the same point has precedence.
    """

    motions: int
    links: Mapping[str, tuple[int, int]]
    loose: tuple[str, ...] = ()


_OWN: Mapping[str, Riding] = FrozenMap(
    {
        "Pa": Riding(2, {"bars": (1, 1), "axis": (0, 2)}),
        "4S": Riding(6, {"first": (0, 0), "second": (0, 0), "bars": (2, 3)}),
    }
)
"""Kinds whose bars swing, in more motions than they have freedoms."""


@cache
def riding(symbol: str) -> Riding:
    """Where the parts of a kind of joint ride: it moves by the twists of its row in `JOINTS`, one after the other from
    the base, unless its bars swing.
    """
    if symbol in _OWN:
        return _OWN[symbol]
    kind = JOINTS[symbol]
    sample = sample_of(kind)
    twists = kind.twists(sample, RATIONALS)
    vectors = {part: form for part, form in kind.parts.items() if form != "number"}
    links = {part: _longest([_fixes(row, sample[part], form) for row in twists]) for part, form in vectors.items()}
    loose = (part for part, form in vectors.items() if form == "point" and links[part] != (0, len(twists)))
    return Riding(len(twists), FrozenMap(links), tuple(loose))


def sample_of(kind: JointKind) -> dict[str, Any]:
    """Parts of a joint in general position, on which it is seen what each motion leaves where it is."""
    return {part: _SAMPLES[form][n] for n, (part, form) in enumerate(kind.parts.items())}


_SAMPLES: Mapping[str, tuple[Any, ...]] = FrozenMap(
    {
        "point": ((2, 3, 5), (7, 1, 4), (3, 8, 2), (1, 6, 9)),
        "direction": ((1, 4, 2), (5, 1, 3), (2, 7, 1), (3, 2, 8)),
        "number": (2, 3, 5, 7),
    }
)


def _fixes(twist: Row, part: tuple[int, int, int], form: str) -> bool:
    """Whether a motion leaves a point (ω × p + v = 0) or a direction (ω × d = 0) where it is."""
    velocity = RATIONALS.cross(twist[:3], part)
    return not any(a + b if form == "point" else a for a, b in zip(velocity, twist[3:], strict=True))


def _longest(fixed: Sequence[bool]) -> tuple[int, int]:
    """The first and last link of the longest run of links between which a part stays; of equal ones the first."""
    ends = [k for k, stays in enumerate(fixed) if not stays]
    runs = list(zip([0, *(k + 1 for k in ends)], [*ends, len(fixed)], strict=True))
    return max(runs, key=lambda run: run[1] - run[0])


@dataclass(frozen=True)
class Attachment:
    """A link that carries a name: the places of the limb and, from the base at 0, of the link. A `loose` one counts
    only where there is no other.
    """

    limb: int
    link: int
    loose: bool = False


def attachments(robot: Robot) -> dict[str, tuple[Attachment, ...]]:
    """All links that carry each name. Names of the platform that no joint has ride on it; names without a ride are
    made from others or stay where they are.
    """
    found: dict[str, dict[Attachment, None]] = {}
    for place, limb in enumerate(robot.limbs):
        for start, joint in starts(limb):
            for name, link, loose in _of_joint(joint):
                found.setdefault(name, {})[Attachment(place, start + link, loose)] = None
    for name in robot.platform:
        found.setdefault(name, {Attachment(0, -1): None})
    return {name: _firm(tuple(own)) for name, own in found.items()}


def starts(limb: LimbSpec) -> Iterator[tuple[int, JointSpec]]:
    """The link on which each joint begins, as `Chain.links` counts them, with the joint."""
    start = 0
    for _, joints in limb.parts:
        for joint in joints:
            yield start, joint
            start += riding(joint.kind).motions
        start += 1  # the next chain begins on a link of its own


def carrier(robot: Robot, own: Attachment) -> str:
    """The link in words: the base, the platform, or what lies behind a joint of a limb."""
    limb = robot.limbs[own.limb]
    if own.link == -1:
        return "the platform"
    for chain, joints in limb.parts:
        for start, joint in starts(limb):
            end = start + riding(joint.kind).motions
            if joint in joints and start <= own.link <= end:
                if own.link == start and joint is joints[0]:
                    return _body(chain.start)
                if own.link == start:
                    continue
                last = joint is joints[-1] and own.link == end
                return _body(chain.end) if last else f"what {joint.text} of {limb.name} moves"
    raise AssertionError(f"{limb.name} has no link {own.link}")


def _body(name: str) -> str:
    return f"the {name}" if name in (BASE, PLATFORM) else name


def _firm(own: tuple[Attachment, ...]) -> tuple[Attachment, ...]:
    firm = tuple(r for r in own if not r.loose)
    return firm or own[:1]


def _of_joint(joint: JointSpec) -> Iterator[tuple[str, int, bool]]:
    """(name, link within the joint, loose) for all names of a joint."""
    own = riding(joint.kind)
    end = own.motions
    for part, arg in zip(JOINTS[joint.kind].parts, joint.args, strict=True):
        if not isinstance(arg, tuple):
            continue
        first, last = own.links[part]
        if len(arg) == 1:
            yield from ((arg[0][1], link, part in own.loose) for link in range(first, last + 1))
            continue
        far, near = (name for _, name in arg)  # a pair A B is the vector B - A
        if joint.kind == "P" or part == "bars":
            firm = part == "bars"  # the ends of bars are their hinges
            yield near, 0, not firm
            yield far, end, not firm
        else:
            yield from ((name, link, True) for name in (near, far) for link in range(first, last + 1))


def in_two_places(robot: Robot, name: str, two: Sequence[Attachment]) -> tuple[str, str]:
    """What is said of a name that two links carry apart, and a hint."""
    one, other = (carrier(robot, a) for a in two)
    said = "be in two places" if robot.family.sorts[name] == "point" else "have two directions"
    return (
        f"{name} would {said}: it is carried by {one} and by {other}",
        f"give a name of its own to one of them, with the coordinates of {name} at home",
    )
