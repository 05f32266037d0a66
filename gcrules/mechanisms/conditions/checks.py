"""Checks of a robot on exact random members, and of its home configuration; faults are recorded at their nodes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import combinations, pairwise
from typing import Any

from gcrules.core.english import counted
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.yaml_file import Node
from gcrules.mechanisms.conditions.carrying import check_carriers
from gcrules.mechanisms.description.family import Definition
from gcrules.mechanisms.description.limb_file import JointSpec, LimbSpec
from gcrules.mechanisms.description.relations import Values, combined
from gcrules.mechanisms.robot import Consequence, Robot
from gcrules.screws import RATIONALS, RESIDUES, Joint, Limb

__all__ = ["STILL", "check_configuration", "check_family", "check_limbs", "home_values", "notes", "stays_in_plane"]

_SEEDS = (11, 12)

STILL = (
    "mobility 0: but for special dimensions or poses the limbs hold the platform by themselves, and there is nothing to"
    " drive"
)
"""What is said of a robot whose platform cannot move."""


def check_family(robot: Robot, places: Mapping[str, Node], facts: Sequence[tuple[Node, Consequence]]) -> None:
    """Zero directions, points that are one, points outside the plane, facts that do not hold.

    Of copies, which stand at one node, only the first is reported, and nothing that only follows from another fault.
    """
    family = robot.family
    members = [family.member(seed) for seed in _SEEDS]
    bad: set[str] = set()
    for d in family.definitions:
        values = [m[d.name] for m in members]
        before = len(places[d.name].document.faults)
        if not bad.isdisjoint(d.relation.names) or any(places[n] == places[d.name] for n in bad):
            bad.add(d.name)
            continue
        if d.sort == "direction" and not any(map(any, values)):
            places[d.name].fault(
                f"the direction {d.name} is zero, whatever the coordinates are",
                "its relation needs directions that are not parallel, or points that are not in one place",
            )
        elif family.plane and any(v[2] for v in values):
            places[d.name].fault(f"{d.name} does not lie in the plane z = 0 of a planar robot")
        else:
            _check_arguments(d, members[0], places[d.name])
        if len(places[d.name].document.faults) > before:
            bad.add(d.name)
    points = [d.name for d in family.definitions if d.sort == "point" and d.name not in bad]
    told: list[Node] = []
    for a, b in combinations(points, 2):
        if all(m[a] == m[b] for m in members) and places[b] not in told:
            told.append(places[b])
            places[b].fault(
                f"{a} and {b} are in one place, whatever the coordinates are",
                "use one name for both, or move one of them",
            )
    for node, fact in facts:
        said = fact.relation
        if any(any(said.relation.residual(said.sort, RESIDUES, m, m[said.name])) for m in members):
            node.fault(
                f"{fact.text!r} does not follow from the relations: it fails at coordinates drawn at random",
                "put it among the relations that make the point or direction",
            )


_SPANS = {"on line": ("line", 1), "in plane": ("plane", 2), "in plane normal to": ("plane", 2)}


def _check_arguments(d: Definition, values: Values, node: Node) -> None:
    """A line needs two different points, a plane two independent directions."""
    if d.sort != "point" or d.relation.kind not in _SPANS:
        return
    what, wanted = _SPANS[d.relation.kind]
    size = d.parameters
    units = [[int(i == unit) for i in range(size)] for unit in range(size)]
    origin, *ends = (d.relation.value(d.sort, RESIDUES, values, t) for t in ([0] * size, *units))
    if RESIDUES.rank([tuple(a - b for a, b in zip(end, origin, strict=True)) for end in ends]) < wanted:
        node.fault(
            f"there is no {what} on which {d.name} could lie",
            "the points that it names are in one place, or its directions parallel, whatever the coordinates are",
        )


def check_limbs(robot: Robot, nodes: Sequence[Node], mobility: Node) -> None:
    """Joints that are none, actuators that do not fit the mobility, a platform that is never held.

    Of the copies of a limb, which stand at one node, only the first that is at fault is reported.
    """
    member = robot.family.member(_SEEDS[0])
    limbs: list[Limb] = []
    faulty: list[Node] = []
    for node, text in zip(nodes, robot.limbs, strict=True):
        if node in faulty:
            continue
        before = len(node.document.faults)
        try:
            limb = text.at(member, RESIDUES)
            limb.twists(RESIDUES)
            limbs.append(limb)
        except (InputError, LimitReached) as fault:
            node.fault(f"{text.name}: {fault.message}", fault.hint)
        else:
            _check_limb(robot, text, limb, node)
        if len(node.document.faults) > before:
            faulty.append(node)
    if not any(text.actuators for text in robot.limbs):
        nodes[0].fault("no joint is actuated", "a star marks what is driven: P*(A1 B1)")
    elif len(limbs) == len(robot.limbs):
        _check_platform(robot, limbs, mobility)
        if not faulty:
            check_carriers(robot, limbs, member, nodes)


def _check_limb(robot: Robot, text: LimbSpec, limb: Limb, node: Node) -> None:
    rank = limb.rank(RESIDUES)
    idle = len(limb.passive) - limb.passive_rank(RESIDUES)
    if text.subchains:
        spins = sum(pair == ("S", "S") for _, joints in text.parts for pair in _neighbours(joints))
        if idle > spins:
            node.fault(
                f"{text.name}: with its actuators and the platform locked its joints have {idle} freedoms left",
                "a body of the limb is not held; drive or leave out a joint, or write ball joints as U where a link"
                " would only spin",
            )
    elif text.freedoms > 6 and text.freedoms - rank > 1:
        node.fault(
            f"{text.name} has {text.freedoms} freedoms, of which only {rank} are independent",
            "a limb has at most six freedoms, and one more if a link spins between two ball joints",
        )
    elif text.freedoms > 6 and ("S", "S") not in _neighbours(text.joints):
        node.fault(
            f"{text.name} has mobility {text.freedoms}: its actuators do not determine it",
            "leave a joint out, or write ball joints as U where a link would only spin",
        )
    for led in text.couplings:
        joints = [text.joints[k] for k in (led.joint, led.leader)]
        axes = [_axis(limb.joints[k]) for k in (led.joint, led.leader)]
        if len({RESIDUES.dot(u, u) for u in axes}) > 1:
            node.fault(
                f"{text.name}: {joints[0]} and {joints[1]} are coupled, but their axes are not always of equal length",
                "a ratio relates rates about, or along, unit vectors: write both axes with one direction, or with"
                " x, y and z",
            )
    if len(limb.locked(RESIDUES)) - len(limb.constraints(RESIDUES)) < text.actuators:
        node.fault(
            f"an actuator of {text.name} holds nothing when it is locked: the other joints make the same motion",
            "drive another joint, or leave one out",
        )
    if robot.family.plane and _leaves_plane(limb):
        node.fault(f"{text.name} leaves the plane z = 0 of a planar robot", "its turns are about z")


def stays_in_plane(robot: Robot) -> bool:
    """Whether no limb of a planar robot leaves its plane; of other robots nothing is asked."""
    member = robot.family.member(_SEEDS[0]) if robot.family.plane else {}
    return not robot.family.plane or not any(_leaves_plane(text.at(member, RESIDUES)) for text in robot.limbs)


def _leaves_plane(limb: Limb) -> bool:
    return any(row[i] for row in limb.twists(RESIDUES) for i in (0, 1, 5))


def _axis(joint: Joint) -> Any:
    """The direction about or along which a joint with one freedom moves; of bars that of their hinges."""
    return joint.geometry[[part for part, form in joint.kind.parts.items() if form == "direction"][-1]]


def _check_platform(robot: Robot, limbs: Sequence[Limb], mobility: Node) -> None:
    held = [row for limb in limbs for row in limb.constraints(RESIDUES)]
    locked = [row for limb in limbs for row in limb.locked(RESIDUES)]
    freedom = 6 - RESIDUES.rank(held) if held else 6
    actuators = sum(text.actuators for text in robot.limbs)
    if robot.mobility != freedom:
        mobility.fault(
            f"the platform has mobility {freedom}, not {robot.mobility}",
            f"its limbs take {6 - freedom} of six freedoms together; check joints, parallel axes and this number",
        )
    if actuators < freedom:
        mobility.fault(
            f"too few actuators: {actuators} for a platform of mobility {freedom}",
            "mark more joints as driven, with a star",
        )
    elif RESIDUES.rank(locked) < 6:
        left = 6 - RESIDUES.rank(locked)
        mobility.fault(
            f"the actuators never hold the platform: with all of them locked it keeps {counted(left, 'freedom')},"
            " whatever the coordinates are",
            "drive other joints, or change how their axes lie",
        )


def notes(robot: Robot) -> tuple[str, ...]:
    """What is no fault, yet perhaps not meant: a platform that cannot move, more actuators than freedoms, and, which
    makes the family larger than the robot, bars of a parallelogram that are not perpendicular to its axes.
    """
    member = robot.family.member(_SEEDS[0])
    found = []
    if not robot.mobility:
        found.append(STILL)
    elif robot.redundant:
        driven = robot.mobility + robot.redundant
        found.append(f"{driven} actuators for {robot.mobility} freedoms: the robot is driven redundantly")
    for limb in robot.limbs:
        for j in limb.joints:
            if j.kind == "Pa" and RESIDUES.dot(*(combined(d, member, RESIDUES) for d in j.directions)):
                found.append(
                    f"{limb.name}: the bars of {j} are not perpendicular to its axis, as those of a plane one are"
                )
    return tuple(found)


def _neighbours(joints: Sequence[JointSpec]) -> list[tuple[str, str]]:
    """Kinds of neighbouring joints, prismatic and cylindrical ones between them left out."""
    return list(pairwise(j.kind for j in joints if j.kind not in ("P", "C")))


def home_values(robot: Robot) -> dict[str, Any]:
    """Coordinates of all points and directions at home, those that relations determine computed.

    Raises InputError, naming what has no coordinates.
    """
    return robot.values_at()


def check_configuration(robot: Robot, node: Node, *, drawing: bool = False) -> None:
    """Record a fault for a relation that home, or the configuration for drawings, violates by more than 1e-6 of its
    size.
    """
    at = "in the drawing" if drawing else "at home"
    try:
        values = robot.values_at(robot.drawing if drawing else None)
    except InputError as fault:
        node.fault(fault.message, fault.hint)
        return
    keys = {key.text: value for key, value in node.entries()}
    for d in robot.family.definitions:
        place = keys.get(d.name, node)
        if d.sort == "direction" and not any(values[d.name]):
            place.fault(f"the direction {d.name} is zero {at}", "let one coordinate be other than 0")
        elif robot.violates(d, values):
            place.fault(
                f"{at} {d.name} is not as its relation says: {d.text}",
                "change its coordinates"
                if d.parameters
                else "leave it out, and it is computed from the others, or change its coordinates",
            )
    twice = Counter(values[d.name] for d in robot.family.definitions if d.sort == "point")
    for d in robot.family.definitions:
        if d.sort == "point" and twice[values[d.name]] > 1:
            keys.get(d.name, node).fault(f"{d.name} is in the same place as another point {at}")
    for limb in robot.limbs:
        try:
            limb.at(values, RATIONALS).twists(RATIONALS)
        except InputError as fault:
            node.fault(f"{limb.name} {at}: {fault.message}", fault.hint)
