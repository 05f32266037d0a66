"""A robot as a linkage in floats: its chains at home, what they carry, its size; and configurations of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.description.carriers import Attachment, attachments
from gcrules.mechanisms.description.driven import driven_freedoms
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM
from gcrules.mechanisms.description.relations import Values
from gcrules.mechanisms.kinematics.chains import Chain, chain_of, geometry_of, shape_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.lines.ranks import Ranks, ranks
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS, RESIDUES, Limb
from gcrules.screws.pose import FAR, too_far
from gcrules.screws.pose_text import read_centre
from gcrules.screws.rotations import Vector

__all__ = ["Actuator", "Configuration", "Linkage", "Span", "begun_at", "linkage"]


_ORIGIN: Vector = (Fraction(0), Fraction(0), Fraction(0))
_NEAR = 1000  # sizes of the robot: nearer to the origin coordinates are taken as they are


@dataclass(frozen=True)
class Actuator:
    """A driven freedom: its `name` (q1, q2 … in the order of the file), the limb and the joint as written, what it
    does in words, the place of the limb and of the coordinate in it, and whether it is an angle.
    """

    name: str
    limb: str
    joint: str
    freedom: str
    place: int
    coordinate: int
    angle: bool

    def __str__(self) -> str:
        return f"{self.name} ({self.limb}: {self.joint})"


@dataclass(frozen=True, eq=False)
class Configuration:
    """Where the robot is: the places of all names, and from home the motions of all links of each limb, (K + 1, 4, 4)
    each, and the amounts of their coordinates (rad and the file's unit of length).

    `residual` is how far the loops are open, `disagreement` how far links that carry one name disagree and names are
    from their relations; all divided by the robot's size (angles in rad). `chains` are the limbs from here.
    """

    values: Mapping[str, Floats]
    links: tuple[Floats, ...]
    joint_values: tuple[Floats, ...]
    chains: tuple[Chain, ...] = field(repr=False)
    residual: float = 0.0
    disagreement: float = 0.0

    @property
    def platform(self) -> Floats:
        """The motion of the platform from home, (4, 4)."""
        return np.asarray(self.links[0][-1])


@dataclass(frozen=True)
class Span:
    """A chain between two bodies: a limb, or a part of one that has bodies of its own. The place of the limb, the
    chain's coordinates there and which of them are not driven, the ranks in the family of all its twists and of these,
    and the places of the bodies among all that move, the platform first; −1 is the base.
    """

    limb: int
    every: tuple[int, ...]
    free: tuple[int, ...]
    rank: int
    passive_rank: int
    start: int
    end: int

    @property
    def signs(self) -> tuple[tuple[int, int], ...]:
        """The bodies that move, with the sign with which their twists count in the chain's."""
        return tuple((b, s) for b, s in ((self.end, 1), (self.start, -1)) if b >= 0)


@dataclass(frozen=True, eq=False)
class Linkage:
    """`ends` (limbs, 3) are the limbs' joint points on the platform at home, `ball_ended` tells of each whether the
    limb is a chain that ends in a passive ball joint there (a hinge, in the plane), so that it passes on forces through
    that point alone. `centre` is what poses turn about, the centroid of the places of the ends if nothing else is
    chosen; `size` is the root mean square of the ends' distances from their mean (of all points, where it is 0).
    `elsewhere` are the ranks at a member of the family in general position. `locked` are coordinates that have to stay
    at 0: the places of limb and coordinate, and the joint as written. All places are measured from `origin`, which is
    near the robot where its file's own is far away, so that floats keep their digits. `spans` are all chains between
    bodies; `generic` are the limbs at that member of the family, modulo a prime.
    """

    robot: Robot
    attachments: Mapping[str, tuple[Attachment, ...]]
    home: Configuration
    actuators: tuple[Actuator, ...]
    ends: Floats
    ball_ended: tuple[bool, ...]
    centre: Floats
    size: float
    elsewhere: Ranks
    locked: tuple[tuple[int, int, str], ...]
    origin: Vector = _ORIGIN
    spans: tuple[Span, ...] = ()
    generic: tuple[Limb, ...] = ()

    @property
    def looped(self) -> bool:
        """Whether a limb has loops of its own."""
        return any(limb.subchains for limb in self.robot.limbs)

    @property
    def bodies(self) -> int:
        """How many of them move, the platform among them; links within chains do not count."""
        return 1 + max(b for span in self.spans for b in (span.start, span.end))

    @property
    def body_freedoms(self) -> int:
        """The dimension of the twists of all bodies together, in the family."""
        idle = sum(len(c.turns) - rank for c, rank in zip(self.home.chains, self.ranks, strict=True))
        return self.robot.mobility + idle - sum(len(span.every) - span.rank for span in self.spans)

    @property
    def pulls(self) -> tuple[bool, ...]:
        """Of each actuator whether it is a cable, which only pulls."""
        return tuple(self.robot.limbs[a.place].cable for a in self.actuators)

    @property
    def ranks(self) -> tuple[int, ...]:
        """Those of each limb's twists in the family."""
        return tuple(every for every, _ in self.elsewhere.limbs)

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be said of all its places."""
        if not any(self.origin):
            return ()
        return (f"all places are measured from ({', '.join(map(str, self.origin))}), near the robot",)

    @property
    def applied(self) -> tuple[tuple[int, int], ...]:
        """The dimensions of each limb's constraints and of its wrenches with locked actuators, in the plane of those
        in the plane.
        """
        known = 3 if self.robot.family.plane else 0
        return tuple((own - known, every - known) for own, every in self.elsewhere.applied)

    @property
    def passive_ranks(self) -> tuple[int, ...]:
        """Those of the undriven ones."""
        return tuple(passive for _, passive in self.elsewhere.limbs)


def linkage(robot: Robot, about: str | Sequence[Any] = "centroid") -> Linkage:
    """The linkage of a robot, whose poses turn `about` a centre (see `read_centre`). Raises InputError where it has no
    joints, no home, or joints that are lost there.
    """
    if not robot.limbs:
        raise InputError(
            f"{robot.id} is given by its lines: there are no joints that could move it",
            hint="describe its limbs by joints",
        )
    if robot.home is None:
        raise InputError(
            f"{robot.id} has no home configuration, from which numbers could start",
            hint="add the key home to its file: coordinates of the points and directions that the relations leave free",
        )
    given = home_values(robot)
    origin = _origin(robot, given)
    sorts = robot.family.sorts
    values = {n: _floats(_less(v, origin) if sorts.get(n) == "point" else v) for n, v in given.items()}
    chains = tuple(chain_of(limb, values) for limb in robot.limbs)
    links = tuple(np.broadcast_to(np.eye(4), (c.count, 4, 4)) for c in chains)
    home = Configuration(values, links, tuple(np.zeros(len(c.turns)) for c in chains), chains)
    ends = np.array([_end(robot, place, values) for place in range(len(chains))])
    centre = ends.mean(axis=0)
    joints = np.array(sorted(set(map(tuple, ends.tolist())))).mean(axis=0)  # limbs may share one
    x, y, z = (Fraction(c) + o for c, o in zip(joints.tolist(), origin, strict=True))
    turning = _floats(_less(read_centre(about, (x, y, z)), origin))
    size = float(np.sqrt(((ends - centre) ** 2).sum(axis=1).mean()))
    if size <= 1e-9 * float(np.abs(ends).max(initial=0.0)) or not size:
        points = np.array([values[d.name] for d in robot.family.definitions if d.sort == "point"])
        size = float(np.sqrt(((points - points.mean(axis=0)) ** 2).sum(axis=1).mean())) or 1.0
    if np.abs(turning - centre).max() > FAR * size:
        raise too_far("the centre is")
    ball = "R" if robot.family.plane else "S"
    firm = tuple(not one.subchains and one.joints[-1].symbol == ball for one in robot.limbs)
    generic = robot.family.member("kinematics")
    return Linkage(
        robot,
        attachments(robot),
        home,
        tuple(_actuators(robot)),
        ends,
        firm,
        turning,
        size,
        ranks(robot.family, robot.limbs, generic),
        tuple(_still(robot)),
        origin,
        tuple(_spans(robot, generic)),
        tuple(limb.at(generic, RESIDUES) for limb in robot.limbs),
    )


def begun_at(m: Linkage, c: Configuration) -> Linkage:
    """The same linkage, with this configuration for its home: all amounts and coordinates count from there."""
    turn, shift = c.platform[:3, :3], c.platform[:3, 3]
    home = replace(
        c,
        links=tuple(np.broadcast_to(np.eye(4), k.shape) for k in c.links),
        joint_values=tuple(np.zeros_like(a) for a in c.joint_values),
    )
    return replace(m, home=home, centre=turn @ m.centre + shift, ends=m.ends @ turn.T + shift)


def _origin(robot: Robot, values: Mapping[str, Any]) -> Vector:
    """A place near the robot, in whole numbers, if its points are far from the origin and its relations hold there too;
    else the origin.
    """
    points = [values[d.name] for d in robot.family.definitions if d.sort == "point"]
    if not points:
        return _ORIGIN
    x, y, z = (Fraction(round(sum(c) / len(points))) for c in zip(*points, strict=True))
    size = max(abs(c - o) for p in points for c, o in zip(p, (x, y, z), strict=True))
    if max(map(abs, (x, y, z))) <= _NEAR * size:
        return _ORIGIN
    sorts = robot.family.sorts
    moved = {n: _less(v, (x, y, z)) if sorts.get(n) == "point" else v for n, v in values.items()}
    return _ORIGIN if any(robot.violates(d, moved) for d in robot.family.definitions) else (x, y, z)


def _less(p: Sequence[Any], origin: Vector) -> Vector:
    x, y, z = (Fraction(c) - o for c, o in zip(p, origin, strict=True))
    return x, y, z


def _floats(p: Sequence[Any]) -> Floats:
    return np.array([float(c) for c in p])


def _end(robot: Robot, place: int, values: Mapping[str, Floats]) -> Floats:
    """The limb's joint point on the platform: the last one that its joints name, or the middle of a pair of bars."""
    joints = robot.limbs[place].joints
    for joint in reversed(joints):
        geometry = geometry_of(joint, values)
        if joint.kind == "4S":
            return np.asarray((geometry["first"] + geometry["second"]) / 2 + geometry["bars"])
        if "point" in geometry:
            return np.asarray(geometry["point"])
        pair = next((arg for arg in joint.args if isinstance(arg, tuple) and len(arg) == 2), None)
        if pair is not None:
            return np.asarray(values[pair[0][1]])
    named = [values[n] for n in robot.platform]
    return np.asarray(np.mean(named, axis=0)) if named else np.zeros(3)


def _still(robot: Robot) -> Iterator[tuple[int, int, str]]:
    for place, limb in enumerate(robot.limbs):
        for joint, own in zip(limb.joints, limb.coordinates, strict=True):
            yield from ((place, own[n], joint.text) for n in shape_of(joint.kind).locked)


def _spans(robot: Robot, values: Values) -> Iterator[Span]:
    """All chains between bodies, with their ranks at a member of the family."""
    bodies = {PLATFORM: 0, BASE: -1}
    for place, limb in enumerate(robot.limbs):
        first = 0
        for (part, _), one in zip(limb.parts, limb.chains_at(values, RESIDUES), strict=True):
            names = (n if n in bodies else f"{place}:{n}" for n in (part.start, part.end))
            start, end = (bodies.setdefault(n, len(bodies) - 1) for n in names)
            every, free = (tuple(first + k for k in own) for own in (range(one.freedoms), one.passive))
            yield Span(place, every, free, one.rank(RESIDUES), one.passive_rank(RESIDUES), start, end)
            first += one.freedoms


def _actuators(robot: Robot) -> Iterator[Actuator]:
    for d in driven_freedoms(robot.limbs):
        limb = robot.limbs[d.limb]
        joint, own = limb.joints[d.place], limb.coordinates[d.place]
        freedom = JOINTS[joint.kind].freedoms[d.freedom]
        yield Actuator(d.name, limb.name, joint.text, freedom, d.limb, own[d.freedom], d.angle)
