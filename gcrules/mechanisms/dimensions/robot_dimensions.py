"""What the numbers of a robot at home say of its bodies beyond the relations of its family.

Facts are looked for at home, and at exact random members of the family; what holds at those too follows from the
relations, and is left out. So a fact is one of the design: of one body, and true in every pose.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING, Any

from gcrules.algebra.language.legs_text import leg_text
from gcrules.conditions.dimensions.bodies import body_facts
from gcrules.conditions.dimensions.facts import TOLERANCE, Dimensions, Fact, check_tolerance
from gcrules.conditions.dimensions.measures import classes, distance, size_of, square, unequal
from gcrules.conditions.dimensions.related import relations
from gcrules.conditions.dimensions.symmetries import Hold, symmetries
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.design import rigid_bodies
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.carriers import attachments, carrier
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.dimensions.axes import Line, axis_facts
from gcrules.mechanisms.dimensions.directions import direction_facts
from gcrules.mechanisms.dimensions.every_pose import architecture_of_robot
from gcrules.mechanisms.platform_analysis import legs_of
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS, RATIONALS

if TYPE_CHECKING:
    from gcrules.mechanisms.conditions.factor_causes import FactorCause

__all__ = ["Parts", "dimensions_of_robot", "facts_of_design"]

_BODIES = ("base", "platform")
_MEMBERS = 3
_AXIS = {"R": (0, 1), "H": (0, 1), "C": (0, 1), "U": (0, 1)}  # the places of a point and of a direction through it

Values = Mapping[str, Any]


def dimensions_of_robot(
    robot: Robot, parts: Sequence[FactorCause] = (), tolerance: float = TOLERANCE
) -> Dimensions | None:
    """The facts of a robot at home, and whether it is singular in every pose; None without limbs or a home. `parts` are
    the factors of its condition. Raises InputError for a tolerance that is none.
    """
    check_tolerance(tolerance)
    if robot.home is None or not robot.limbs:
        return None
    facts, values = facts_of_design(robot, tolerance), robot.values_at()
    nearly = any(not fact.exact for fact in facts)
    return Dimensions(tolerance, facts, architecture_of_robot(robot, parts, values, tolerance, nearly=nearly))


def facts_of_design(robot: Robot, tolerance: float = TOLERANCE) -> tuple[Fact, ...]:
    """The facts of the bodies at home that the relations of the family do not imply."""
    parts = Parts.of(robot)
    members = [robot.family.member(("dimensions", k), RATIONALS) for k in range(_MEMBERS)]
    general = [[f for f in _facts(parts, values, _EXACTLY) if f.exact] for values in members]
    known = [f for f in general[0] if all(_implied(f, others) for others in general[1:])]
    found = [f for f in _facts(parts, robot.values_at(), tolerance) if not _implied(f, known)]
    return tuple(_gathered(found))


_EXACTLY = 1e-12  # so near, in floats, that it is worth asking exactly


def _implied(fact: Fact, known: Sequence[Fact]) -> bool:
    alike = ((f.kind, f.body, f.order) == (fact.kind, fact.body, fact.order) for f in known)
    return any(a and set(fact.members) <= set(f.members) for a, f in zip(alike, known, strict=True))


def _gathered(facts: Sequence[Fact]) -> Iterator[Fact]:
    """Perpendicular pairs gathered: one pair for directions that are parallel, if all such pairs are news, and three
    for one fact. Points on a circle are in its plane.
    """
    pairs = {(f.body, frozenset(f.members)): f for f in facts if f.kind == "perpendicular"}
    alike = {(f.body, n): f.members for f in facts if f.kind == "parallel" for n in f.members}
    kept: dict[tuple[str, frozenset[str]], Fact] = {}
    for (body, _), fact in pairs.items():
        first, second = (alike.get((body, n), (n,)) for n in fact.members)
        if all((body, frozenset((p, q))) in pairs for p in first for q in second):
            kept[body, frozenset((first[0], second[0]))] = replace(fact, members=(first[0], second[0]))
    done: set[tuple[str, frozenset[str]]] = set()
    circles = {(f.body, f.members) for f in facts if f.kind == "circle"}
    for fact in facts:
        if fact.kind != "perpendicular" and (fact.kind != "coplanar" or (fact.body, fact.members) not in circles):
            yield fact
    for body in _BODIES:
        names = list(dict.fromkeys(n for (b, _), f in kept.items() if b == body for n in f.members))
        for three in combinations(names, 3):
            sides = [(body, frozenset(pair)) for pair in combinations(three, 2)]
            if all(side in kept and side not in done for side in sides):
                done.update(sides)
                yield Fact("perpendicular", three, body, max(kept[side].deviation for side in sides))
    yield from (fact for side, fact in kept.items() if side not in done)


# --- what there is to look at ---


@dataclass(frozen=True)
class Parts:
    """Of base and platform the points, the directions and the axes (a point, a direction); of all links the pairs of
    points that keep their distance; of the limbs what they have on each body, and legs that are all there is, if any.
    """

    robot: Robot
    points: tuple[tuple[str, ...], ...]
    directions: tuple[tuple[str, ...], ...]
    axes: tuple[tuple[tuple[str, str], ...], ...]
    lengths: tuple[tuple[str, str], ...]
    holds: tuple[tuple[Hold, ...], ...]
    legs: tuple[tuple[str, str], ...]

    @classmethod
    def of(cls, robot: Robot) -> Parts:
        sorts = robot.family.sorts
        used = {n for limb in robot.limbs for joint in limb.joints for n in joint.names}
        used |= {n for d in robot.family.definitions for n in d.relation.names}
        bodies = rigid_bodies(robot)
        names = [n for n in sorts if n in used or n in robot.platform]
        points, directions = (
            tuple(tuple(n for n in names if n in body and sorts[n] == sort) for body in bodies)
            for sort in ("point", "direction")
        )
        axes = tuple(
            tuple(dict.fromkeys(a for limb in robot.limbs for a in _axes(limb) if body.issuperset(a)))
            for body in bodies
        )
        holds = tuple(tuple(_hold(limb, body, sorts) for limb in robot.limbs) for body in bodies)
        legs = _legs(robot)
        if legs:  # nothing else of their joints counts
            points = tuple(tuple(dict.fromkeys(leg[end] for leg in legs)) for end in (0, 1))
            holds = tuple(tuple(((leg[end],), ()) for leg in legs) for end in (0, 1))
            directions, axes = ((), ()), ((), ())
        return cls(robot, points, directions, axes, tuple(_lengths(robot)), holds, legs)


def _axes(limb: LimbSpec) -> Iterator[tuple[str, str]]:
    """The axes of joints with a point and a direction that bear names."""
    for joint in limb.joints:
        args = joint.args[:2] if joint.kind in _AXIS else ()
        if len(args) == 2 and all(isinstance(arg, tuple) and len(arg) == 1 for arg in args):
            yield joint.points[0], joint.directions[0][0][1]
            if joint.kind == "U" and len(joint.directions[1]) == 1:
                yield joint.points[0], joint.directions[1][0][1]


def _hold(limb: LimbSpec, body: frozenset[str], sorts: Mapping[str, str]) -> Hold:
    names = dict.fromkeys(n for joint in limb.joints for n in joint.names if n in body)
    points, directions = (tuple(n for n in names if sorts[n] == sort) for sort in ("point", "direction"))
    return points, directions


def _lengths(robot: Robot) -> Iterator[tuple[str, str]]:
    """Pairs of points on one link that is neither base nor platform, and the ends of bars."""
    links: dict[tuple[int, int], list[str]] = {}
    for name, own in attachments(robot).items():
        if robot.family.sorts.get(name) == "point":
            for a in own:
                if carrier(robot, a) not in ("the base", "the platform"):
                    links.setdefault((a.limb, a.link), []).append(name)
    pairs = [pair for names in links.values() for pair in combinations(names, 2)]
    for joint in (j for limb in robot.limbs for j in limb.joints):
        for part, arg in zip(JOINTS[joint.kind].parts, joint.args, strict=True):
            if part == "bars" and isinstance(arg, tuple) and len(arg) == 2:
                pairs.append((arg[1][1], arg[0][1]))  # a pair A B is the vector B - A
    yield from {frozenset(pair): pair for pair in pairs}.values()


def _legs(robot: Robot) -> tuple[tuple[str, str], ...]:
    try:
        return legs_of(as_platform(robot)).oriented
    except InputError:
        return ()


# --- facts at one member ---


def _facts(parts: Parts, values: Values, tolerance: float) -> Iterator[Fact]:
    robot = parts.robot
    whole = size_of([values[d.name] for d in robot.family.definitions if d.sort == "point"])
    for body, points, directions, axes in zip(_BODIES, parts.points, parts.directions, parts.axes, strict=True):
        places = {n: values[n] for n in points}
        size = size_of(places.values()) if len(set(map(tuple, places.values()))) > 1 else whole
        if len(points) > 1:
            yield from body_facts(places, body, tolerance)
        lines: dict[str, Line] = {leg_text((p, u)): (values[p], values[u]) for p, u in axes if any(values[u])}
        of_axes = axis_facts(lines, body, tolerance, size)
        yield from of_axes
        along = {leg_text((p, u)): u for p, u in axes}
        flat = [{along[n] for n in fact.members} for fact in of_axes if fact.kind == "flat axes"]
        for fact in direction_facts({n: values[n] for n in directions if any(values[n])}, body, tolerance):
            if fact.kind != "level" or not any(names.issuperset(fact.members) for names in flat):
                yield fact
    yield from _equal(parts.lengths, values, tolerance)
    if parts.legs:
        words = tuple(map(leg_text, parts.legs))
        yield from relations([values[p] for p, _ in parts.legs], [values[q] for _, q in parts.legs], words, tolerance)
    limbs = [limb.name for limb in robot.limbs]
    sorts = [limb.chain for limb in robot.limbs]
    yield from symmetries(limbs, sorts, parts.holds, values, tolerance)


def _equal(pairs: Sequence[tuple[str, str]], values: Values, tolerance: float) -> Iterator[Fact]:
    """Which lengths within links are equal, in the largest sets of them."""
    squares = {(p, q): square(values[p], values[q]) for p, q in pairs}
    sizes = {(p, q): distance(values[p], values[q]) for p, q in pairs}

    def off(first: tuple[str, str], other: tuple[str, str]) -> float:
        return unequal(squares[first], squares[other], sizes[first])

    for same in classes([pair for pair in pairs if squares[pair]], off, tolerance):
        if len(same) > 1:
            yield Fact("lengths", tuple(map(leg_text, same)), "links", max(off(same[0], pair) for pair in same))
