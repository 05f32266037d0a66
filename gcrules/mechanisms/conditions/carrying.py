"""Whether the links that carry one name carry it alike, to first order, at an exact random member of the family.

A name that two bodies carry apart would take the robot out of its family with the first motion: no number of a pose
could be told of it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gcrules.core.yaml_file import Node
from gcrules.mechanisms.description.carriers import Attachment, attachments, in_two_places, riding
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM
from gcrules.mechanisms.description.relations import AXES, Values
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS, RESIDUES, Limb
from gcrules.screws.fields import Row

__all__ = ["carried_apart", "check_carriers"]

Twist = Mapping[int, Row]
"""The twist of a link: what each coordinate of all limbs adds to it, for each unit of its rate."""

_AT_REST: Row = (0, 0, 0, 0, 0, 0)


def check_carriers(robot: Robot, limbs: Sequence[Limb], member: Values, nodes: Sequence[Node]) -> None:
    """Record a fault for a name that two links carry apart, at the limb of the second one; of the limbs that stand at
    one node only for the first.
    """
    told: list[Node] = []
    for name, two in carried_apart(robot, limbs, member):
        node = nodes[two[1].limb]
        if node not in told:
            told.append(node)
            node.fault(*in_two_places(robot, name, two))


def carried_apart(
    robot: Robot, limbs: Sequence[Limb], member: Values
) -> Iterator[tuple[str, tuple[Attachment, Attachment]]]:
    """Names with two links that carry them apart in some motion of the robot, at a member where its limbs are these."""
    links, closed, width = _links(robot, limbs)
    rows = [
        tuple(RESIDUES.reduced(one.get(c, _AT_REST)[i] - other.get(c, _AT_REST)[i]) for c in range(width))
        for one, other in closed
        for i in range(6)
    ]
    motions = RESIDUES.rows(RESIDUES.kernel(RESIDUES.matrix(rows), width))
    for name, own in attachments(robot).items():
        known = [a for a in own if (a.limb, a.link) in links]
        if not known:
            continue
        one = Attachment(0, 0) if name in AXES else known[0]  # those of the frame rest, as the base does
        first = links[one.limb, one.link]
        point = robot.family.sorts[name] == "point"
        for other in known:
            twist = links[other.limb, other.link]
            if any(_moves(member[name], _less(twist, first, rates), point) for rates in motions):
                yield name, (one, other)
                break


def _links(robot: Robot, limbs: Sequence[Limb]) -> tuple[dict[tuple[int, int], Twist], list[tuple[Twist, Twist]], int]:
    """The twists of the links by limb and number (-1 is the platform), pairs of twists that have to be the same, as
    all loops are closed, and the number of coordinates.
    """
    links: dict[tuple[int, int], Twist] = {}
    closed: list[tuple[Twist, Twist]] = []
    width = 0
    for place, (limb, at) in enumerate(zip(robot.limbs, limbs, strict=True)):
        reached: dict[str, Twist] = {BASE: {}}
        link = number = 0
        for part, joints in limb.parts:
            here = links[place, link] = reached[part.start]
            for joint in joints:
                ratio = RESIDUES.number(limb.ratios.get(number, 1), "a ratio")
                for own, row in zip(limb.coordinates[number], at.joints[number].twists(RESIDUES), strict=True):
                    here = _added(here, width + own, row, ratio)
                    if not JOINTS[joint.kind].has_bars:
                        link += 1
                        links[place, link] = here
                if JOINTS[joint.kind].has_bars:
                    link += riding(joint.kind).motions
                    links[place, link] = here
                number += 1
            link += 1
            if part.end in reached:
                closed.append((here, reached[part.end]))
            else:
                reached[part.end] = here
        links[place, -1] = reached[PLATFORM]
        closed.append((reached[PLATFORM], links[0, -1]))
        width += limb.freedoms
    return links, closed, width


def _added(twist: Twist, coordinate: int, row: Row, ratio: Any) -> Twist:
    before = twist.get(coordinate, _AT_REST)
    return {**twist, coordinate: tuple(RESIDUES.reduced(a + ratio * b) for a, b in zip(before, row, strict=True))}


def _less(twist: Twist, other: Twist, rates: Row) -> Row:
    """The relative motion of two links."""
    each = [tuple(r * rates[c] for r in row) for c, row in twist.items()]
    each += [tuple(-r * rates[c] for r in row) for c, row in other.items()]
    return tuple(RESIDUES.reduced(sum(column)) for column in zip(_AT_REST, *each, strict=True))


def _moves(place: Row, twist: Row, point: bool) -> bool:
    """Whether a motion takes a point, or a direction, from where it is."""
    velocity = RESIDUES.cross((twist[0], twist[1], twist[2]), (place[0], place[1], place[2]))
    return any(RESIDUES.reduced(a + b * point) for a, b in zip(velocity, twist[3:], strict=True))
