r"""Cones that ball and universal joints keep to, and the cone of tilts: programs of values that are at least 0 in them.

A joint at the end of a rod keeps to a cone where the angle between the rod and its direction at home, as the body there
carries it, is at most the one given: the base or the platform, or a link that a first joint turns or slides. With a
unit direction w on that body and the rod v it is w · v / |v| − cos(angle). Of robots of joints these programs are
compared with the joints, whose loops are closed by Newton's method, at poses at random.

>>> cones("40 deg").text, cones("base 30 deg, C1 0.5 rad").text
('all joints 40 deg', 'base 30 deg, C1 28.6479 deg')
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.core.seeds import drawn
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.closed_forms import run
from gcrules.poses.compiling.leg_programs import leg_bars
from gcrules.poses.compiling.limb_amounts import amounts
from gcrules.poses.compiling.limb_places import LimbPlaces
from gcrules.poses.compiling.limb_programs import limb_places, solved_near_home
from gcrules.poses.compiling.roots import NoForm, inverse
from gcrules.poses.compiling.scalars import Graph, Ring
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.turns import back, by_angles, turned_by
from gcrules.poses.compiling.vectors import Vector, add, cross, dot, exact, scaled, sub, turned
from gcrules.poses.methods import Methods, method
from gcrules.screws.pose import read_number

__all__ = ["Cone", "Cones", "cones", "kept_program", "tilt_of"]

Floats = NDArray[np.float64]

_ANGLE = re.compile(r"(?P<number>\S+?)\s*(?P<unit>deg|rad|°)")
_FORM = 'write "40 deg" for all joints of rods, "base 30 deg, platform 40 deg", or for single points "C1 40 deg"'
_EQUAL = 1e-9  # of cosines
_THROUGH = 1e-9  # in parts of the robot's size: an axis passes through a point


@dataclass(frozen=True)
class Cone:
    """A joint at the end of a rod: the `rod` by the names of its ends on the base's and on the platform's side, which
    `end` (base | platform), and the half `angle` of the cone in rad.
    """

    rod: tuple[str, str]
    end: str
    angle: float

    @property
    def point(self) -> str:
        """The joint's name."""
        return self.rod[0] if self.end == "base" else self.rod[1]


@dataclass(frozen=True)
class Cones:
    """Half angles (rad) of cones by the words in front of them: "", "base", "platform" or the name of a point."""

    given: tuple[tuple[str, float], ...]

    @property
    def text(self) -> str:
        """As it is written."""
        return ", ".join(f"{who or 'all joints'} {math.degrees(angle):.6g} deg" for who, angle in self.given)

    def angle(self, point: str, end: str) -> float | None:
        """That of a joint; later words count. None where there is none."""
        return next((a for who, a in reversed(self.given) if who in ("", end, point)), None)


def cones(text: str, option: str = "--cone") -> Cones:
    """Read "40 deg", "base 30 deg, C1 40 deg". Raises InputError for what is none."""
    found = []
    try:
        for part in map(str.strip, text.split(",")):
            match = re.fullmatch(rf"(?:(all joints|all|\S+)\s+)?({_ANGLE.pattern})", part)
            if match is None:
                raise InputError(f"{part[:60]!r} is not a cone", hint=_FORM)
            who = match[1]
            found.append(("" if who in (None, "all", "all joints") else who, _half_angle(match[2], "cone")))
    except GcrulesError as fault:
        raise fault.located(text, option, Span(0, max(len(text), 1))) from None
    return Cones(tuple(found))


def tilt_of(text: str, option: str = "--tilt") -> float:
    """Read "40 deg" or "0.7 rad", in rad. Raises InputError for what is none."""
    try:
        return _half_angle(text.strip(), "tilt")
    except GcrulesError as fault:
        raise fault.located(text, option, Span(0, max(len(text), 1))) from None


def _half_angle(text: str, what: str) -> float:
    match = _ANGLE.fullmatch(text)
    if match is None:
        raise InputError(f"{text[:40]!r} is not an angle with its unit", hint='as in "40 deg"')
    found = float(read_number(match["number"])) * (1.0 if match["unit"] == "rad" else math.radians(1.0))
    if not 0 < found < math.pi:
        raise InputError(f"a {what} of {text}", hint="it is between 0 and 180 deg")
    return found


def kept_program(
    m: Mechanism, names: tuple[str, ...], given: Cones | None, tilt: float | None
) -> tuple[Program | None, tuple[Cone, ...]]:
    """A program of values that are at least 0 where all joints keep to their cones and the platform's third axis to
    `tilt` (rad), and the cones in its order; None where nothing is asked for. Raises InputError for points that are no
    joints of rods, and where they have no closed form.
    """
    if given is None and tilt is None:
        return None, ()
    return method(_KEPT, m, "a certificate with cones")(names, given, tilt)


def _chosen(rods: list[tuple[tuple[str, str], tuple[bool, bool]]], given: Cones | None) -> tuple[Cone, ...]:
    """The cones of rods, whose ends are ball or universal joints or not."""
    if given is None:
        return ()
    found = []
    for rod, kinds in rods:
        for end, point, fine in zip(("base", "platform"), rod, kinds, strict=True):
            angle = given.angle(point, end) if fine else None
            if angle is not None:
                found.append(Cone(rod, end, angle))
    points = {p for rod, kinds in rods for p, fine in zip(rod, kinds, strict=True) if fine}
    wrong = next((who for who, _ in given.given if who not in ("", "base", "platform", *points)), None)
    if wrong is not None:
        known = f"they are {', '.join(sorted(points))}" if points else "this robot has none"
        raise InputError(
            f"{wrong!r} is not a ball or universal joint of a rod", hint=near(wrong, tuple(points)) or known
        )
    if not found:
        raise InputError("this robot has no ball or universal joints of rods between two points")
    return tuple(found)


def _tilted(tilt: float | None, along: Ring) -> list[Ring]:
    return [] if tilt is None else [along - Fraction(math.cos(tilt))]


def _leans(w: Vector, v: Vector, by: Ring | Fraction, angle: float) -> Ring:
    """w · v times `by`, less the cosine of the cone."""
    return dot(w, v) * by - Fraction(math.cos(angle))


def _unit(v: Floats) -> Vector:
    return exact(v / np.linalg.norm(v))


def _of_legs(
    m: SixLegs, names: tuple[str, ...], given: Cones | None, tilt: float | None
) -> tuple[Program, tuple[Cone, ...]]:
    chosen = _chosen([((a, b), (True, True)) for a, b in m.rig.legs], given)
    graph = Graph(6)
    turn = by_angles(graph.inputs[3:], turned_by)
    values: list[Ring] = []
    home = {(a, b): _at(m, b) - _at(m, a) for a, b in m.rig.legs}
    bars = dict(zip(m.rig.legs, leg_bars(m, graph, turned_by), strict=True)) if chosen else {}
    for cone in chosen:
        (bar, length), w = bars[cone.rod], _unit(home[cone.rod])
        values.append(_leans(turned(back(turn), w) if cone.end == "base" else w, bar, inverse(length), cone.angle))
    return lower(graph, *values, *_tilted(tilt, turn[2][2])), chosen


def _at(m: SixLegs, name: str) -> Floats:
    return np.array([float(c) for c in m.rig.points[name]])


def _of_limbs(
    m: Limbs, names: tuple[str, ...], given: Cones | None, tilt: float | None
) -> tuple[Program, tuple[Cone, ...]]:
    target = Target(names, np.zeros(len(names)), text="home")
    places = limb_places(m, target, turned_by)
    if places is None:
        raise InputError(f"where {m.robot.id} is has no closed form that is known here: no cones")
    rods = list(_rods(m, places))
    chosen = _chosen([(rod, kinds) for rod, kinds, _ in rods], given)
    limbs = {rod: k for rod, _, k in rods}
    try:
        values = [_cone_value(m, places, cone, limbs[cone.rod]) for cone in chosen]
        program = lower(places.graph, *values, *_tilted(tilt, places.turn[2][2]))
    except NoForm as fault:
        raise InputError(f"the cones of {m.robot.id} have no closed form that is known here: {fault}") from None
    _check(m, target, program, chosen, limbs)
    return program, chosen


def _rods(m: Limbs, places: LimbPlaces) -> Iterator[tuple[tuple[str, str], tuple[bool, bool], int]]:
    """Rods from a point to one of the platform by the lines of limbs: whether several passive turns pass through their
    ends, and the limb.
    """
    k = m.linkage
    driven = {(a.place, a.coordinate) for a in k.actuators}
    for limb, structure in enumerate(m.analysis.structure.limbs):
        for line in structure.lines or ():
            if any(places.sorts[n] != "point" for n in line.ends):
                continue
            p, q = line.ends if places.rides(line.ends[1]) else reversed(line.ends)
            if not places.rides(q) or places.rides(p):
                continue
            kinds = []
            for name in (p, q):
                at, count = k.home.values[name], 0
                for n, screw in enumerate(k.home.chains[limb].screws):
                    off = np.abs(np.cross(at, screw[:3]) - screw[3:]).max()
                    count += bool(screw[:3].any() and off <= _THROUGH * k.size and (limb, n) not in driven)
                kinds.append(count >= 2)
            yield (p, q), (kinds[0], kinds[1]), limb


def _link_of(m: Limbs, limb: int, point: str) -> int:
    """The link of a limb that carries a point, 0 for the base."""
    return next((a.link for a in m.linkage.attachments.get(point, ()) if a.limb == limb), 0)


def _cone_value(m: Limbs, places: LimbPlaces, cone: Cone, limb: int) -> Ring:
    p, q = cone.rod
    home = m.linkage.home.values
    rod = home[q] - home[p]
    w, by = _unit(rod), Fraction(float(1 / np.linalg.norm(rod)))
    if cone.end == "platform":
        return _leans(w, sub(places.seen(q), places.seen(p)), by, cone.angle)
    v = sub(places.at(q), places.at(p))
    link = _link_of(m, limb, p)
    actuator = next((a for a in m.linkage.actuators if (a.place, a.coordinate) == (limb, 0)), None)
    if link > 1 or (link == 1 and actuator is None):
        raise NoForm(f"{p} is carried by several joints")
    if link == 1 and actuator is not None and actuator.angle:
        cosine, sine = _turn_of(m, places, actuator.name)
        axis = m.linkage.home.chains[limb].screws[0][:3]
        along = axis * float(axis @ (rod / np.linalg.norm(rod)))
        across = rod / np.linalg.norm(rod) - along
        w = add(exact(along), add(scaled(exact(across), cosine), scaled(cross(exact(axis), exact(across)), sine)))
    return _leans(w, v, by, cone.angle)


def _turn_of(m: Limbs, places: LimbPlaces, name: str) -> tuple[Ring, Ring]:
    values, at = amounts(places), 0
    for a in m.linkage.actuators:
        if a.name == name:
            return values[at], values[at + 1]
        at += 1 + a.angle
    raise NoForm(f"{name} has no turn")


def _check(
    m: Limbs, target: Target, program: Program, chosen: tuple[Cone, ...], limbs: dict[tuple[str, str], int]
) -> None:
    """Compare with the joints at poses that had no part in it. Raises InputError where they differ."""
    seed = drawn("cones", m.robot.id, *target.names).getrandbits(64)
    found = solved_near_home(m, target, np.random.default_rng(seed))
    if found is None:
        raise InputError(f"no pose near home of {m.robot.id} is proved to be reached: no cones")
    poses, there = found
    values = run(program, "numpy", poses)
    home = m.linkage.home.values
    for cone, value in zip(chosen, values, strict=False):
        p, q = cone.rod
        rod = home[q] - home[p]
        limb = limbs[cone.rod]
        body = there.links[limb][:, -1 if cone.end == "platform" else _link_of(m, limb, p), :3, :3]
        now = there.values[q] - there.values[p]
        cosine = ((body @ rod) * now).sum(axis=1) / (np.linalg.norm(rod) * np.linalg.norm(now, axis=1))
        if np.abs(value + math.cos(cone.angle) - cosine).max() > _EQUAL:
            raise InputError(f"the cone of {cone.point} has no closed form that agrees with the joints")


_KEPT: Methods[tuple[Program, tuple[Cone, ...]]] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
