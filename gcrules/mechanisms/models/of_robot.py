"""A robot with dimensions as a model of links and joints with one freedom each, and balls: what model files can say.

Joints with several freedoms become several, one after the other, with links between them; a screw is a turn and a slide
that follows it, a parallelogram two turns of which the second follows backwards; parallel bars with ball ends are two
bars. The first way to a body carries it; each further one closes a loop, by its last joint if that is a ball, else by a
link of its own that is fixed to the body.

>>> from gcrules.mechanisms.load import load
>>> model = model_of(load("3-rps"))
>>> [f"{j.name}: {j.kind}" for j in model.joints if j.closing]
['leg_2_S: ball', 'leg_3_S: ball']
>>> model.actuated
('leg_1_P', 'leg_2_P', 'leg_3_P')
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec, read_joints
from gcrules.mechanisms.description.limits import limits_of_legs, limits_of_limbs
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.kinematics.chains import Geometry, geometry_of, shape_of
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.model import Model, ModelCoupling, ModelJoint
from gcrules.mechanisms.models.places import vector
from gcrules.mechanisms.robot import Robot
from gcrules.screws.pose import METRES

__all__ = ["model_of"]

_SAME = 1e-9


def model_of(source: Robot | Platform, unit: str = "") -> Model:
    """The model of a robot of joints at home, or of a platform on six legs with coordinates, which stand for slides
    between balls. Lengths are in `unit`, one of `gcrules.screws.pose.UNITS`; else in that of the file, else metres.

    Raises InputError where there are no joints or no home, for cables, which are no joints, and for unknown units.
    """
    if unit and source.units and unit != source.units:
        raise InputError(f"the file's unit is {source.units}, not {unit}", hint="leave out the unit")
    scale = METRES[_known(unit or source.units or "m")]
    if isinstance(source, Platform):
        limbs = [
            LimbSpec(f"leg {k}", read_joints(f"S({a}) P*({a} {b}) S({b})"))
            for k, (a, b) in enumerate(source.legs, start=1)
        ]
        name, places = _word(source.title or PurePath(source.filename).stem), source.points
    else:
        _check(source)
        limbs, name, places = list(source.limbs), source.id, home_values(source)
    making = _Making({name: np.array([float(c) for c in v]) for name, v in places.items()})
    for limb in limbs:
        making.limb(limb)
    if source.limits:
        making.limit(_amounts(source, limbs))
    model = Model(
        name,
        "robot",
        source.filename,
        tuple(making.links),
        tuple(making.joints),
        tuple(making.driven),
        tuple(making.couplings),
    )
    return model if scale == 1 else _scaled(model, scale)


def _amounts(source: Robot | Platform, limbs: Sequence[LimbSpec]) -> Iterator[tuple[float, float]]:
    """From home, what the limits of a file say of each actuator."""
    if isinstance(source, Robot):
        found = limits_of_limbs(source.limits, limbs, source.units)
        yield from zip(found.low, found.high, strict=True)
        return
    reach = limits_of_legs(source.limits, source.legs, source.units)
    for leg, low, high in zip(source.legs, reach.low, reach.high, strict=True):
        home = math.dist(*([float(c) for c in source.points[end]] for end in leg))
        yield low - home, high - home


def _known(unit: str) -> str:
    if unit not in METRES:
        raise InputError(f"{unit[:20]!r} is not a unit of length", hint=f"one of {', '.join(METRES)}")
    return unit


def _check(robot: Robot) -> None:
    """Raises InputError for a robot that no model can hold."""
    if not robot.limbs:
        raise InputError(
            f"{robot.id} is given by its lines: there are no joints that a model could hold",
            hint="describe its limbs by joints",
        )
    if robot.home is None:
        raise InputError(f"{robot.id} has no home configuration", hint="add the key home to its file")
    for limb in robot.limbs:
        if limb.cable:
            raise InputError(
                f"{limb.name} of {robot.id} is a cable, which only pulls: models of links and joints have none",
                hint="for rods in place of cables write joints: S(A) P*(A B) S(B)",
            )


def _scaled(model: Model, scale: float) -> Model:
    """The same with all lengths times a number."""
    kinds = {j.name: j.kind for j in model.joints}

    def length_of(name: str) -> float:
        return scale if kinds[name] == "prismatic" else 1.0

    def limits_of(j: ModelJoint) -> tuple[float, float] | None:
        return (j.limits[0] * length_of(j.name), j.limits[1] * length_of(j.name)) if j.limits else None

    joints = tuple(replace(j, at=vector([c * scale for c in j.at]), limits=limits_of(j)) for j in model.joints)
    couplings = tuple(replace(c, ratio=c.ratio * length_of(c.joint) / length_of(c.leader)) for c in model.couplings)
    return replace(model, joints=joints, couplings=couplings)


@dataclass(frozen=True)
class _Motion:
    """A joint with one freedom: its kind, point and axis, and the freedom of a joint that it takes, with the ratio."""

    kind: str
    at: Floats
    axis: Floats
    freedom: int
    ratio: float


class _Making:
    """What has been made so far; `reached` holds the links that bodies are."""

    def __init__(self, values: Mapping[str, Floats]) -> None:
        self.values = values
        self.links: dict[str, None] = {BASE: None}
        self.joints: list[ModelJoint] = []
        self.names: set[str] = set()
        self.driven: dict[str, float] = {}  # what is actuated, and its value for a unit of the actuator
        self.couplings: list[ModelCoupling] = []
        self.reached = {BASE}

    def limb(self, limb: LimbSpec) -> None:
        name = _word(limb.name)
        leaders: dict[int, tuple[str, float]] = {}  # by the coordinate of the limb, the first joint that moves with it
        place = 0
        for part, joints in limb.parts:
            own = range(place, place + len(joints))
            place += len(joints)
            start, end = (b if b in (BASE, PLATFORM) else f"{name}_{_word(b)}" for b in (part.start, part.end))
            chain = _Chain(self, limb, name, start, end, leaders)
            chain.add([(limb.joints[k], k) for k in own])

    def limit(self, amounts: Iterable[tuple[float, float]]) -> None:
        """Give the joints that are driven, in their order, the limits of amounts of actuators; models have none with
        one end only.
        """
        places = {j.name: k for k, j in enumerate(self.joints)}
        for (name, ratio), (low, high) in zip(self.driven.items(), amounts, strict=True):
            if math.isfinite(low) and math.isfinite(high):
                least, most = sorted((low * ratio, high * ratio))
                self.joints[places[name]] = replace(self.joints[places[name]], limits=(least, most))

    def link(self, name: str) -> str:
        self.links.setdefault(name)
        return name

    def unused(self, name: str) -> str:
        """A name for a joint: this one, or with a number behind it."""
        found, number = name, 2
        while found in self.names or found in self.links:
            found, number = f"{name}_{number}", number + 1
        self.names.add(found)
        return found


class _Chain:
    """The joints between two bodies, put one behind the other."""

    def __init__(
        self, making: _Making, limb: LimbSpec, name: str, start: str, end: str, leaders: dict[int, tuple[str, float]]
    ) -> None:
        self.making = making
        self.owner = limb
        self.name = name
        self.link = start
        self.end = end
        self.leaders = leaders
        self.closes = end in making.reached
        self.at: Floats | None = None  # where the joint before is

    def add(self, joints: Sequence[tuple[JointSpec, int]]) -> None:
        for n, (spec, k) in enumerate(joints):
            geometry = geometry_of(spec, self.making.values)
            base = self.making.unused(f"{self.name}_{spec.name or spec.kind}")
            last = n == len(joints) - 1
            if spec.kind == "S":
                self._joint(base, "ball", geometry["point"], (), last=last)
            elif spec.kind == "4S":
                self._bars(base, geometry, last=last)
            else:
                self._motions(base, spec, k, geometry, self._point(joints[n:]), last=last)
        self.making.reached.add(self.end)

    def _point(self, joints: Sequence[tuple[JointSpec, int]]) -> Floats:
        """A place for what slides: that of the joint before it, or of the next one that has a place."""
        if self.at is not None:
            return self.at
        for spec, _ in joints:
            for name in spec.names if not spec.points else spec.points:
                return self.making.values[name]
        return np.zeros(3)

    def _motions(self, base: str, spec: JointSpec, k: int, geometry: Geometry, near: Floats, *, last: bool) -> None:
        motions = list(_motions(spec, geometry, near))
        coordinates = self.owner.coordinates[k]
        outer = float(self.owner.ratios.get(k, 1))
        for n, m in enumerate(motions):
            name = base if len(motions) == 1 else self.making.unused(f"{base}_{n + 1}")
            self._joint(name, m.kind, m.at, (m.axis,), last=last and n == len(motions) - 1)
            coordinate, ratio = coordinates[m.freedom], m.ratio * outer
            if coordinate in self.leaders:
                leader, unit = self.leaders[coordinate]
                self.making.couplings.append(ModelCoupling(name, leader, ratio / unit))
            else:
                self.leaders[coordinate] = name, ratio
            if m.freedom in spec.actuated and all(m.freedom != before.freedom for before in motions[:n]):
                self.making.driven[name] = ratio

    def _joint(self, name: str, kind: str, at: Floats, axes: Sequence[Floats], *, last: bool) -> None:
        """A joint from the link where the chain is to the next one; the last one leads to the body at its end."""
        self.at = at
        lines = tuple(vector(a / np.linalg.norm(a)) for a in axes)
        closing = last and self.closes and kind == "ball"
        whole = last and (closing or not self.closes)
        child = self.making.link(self.end if whole else f"{name}_link")
        self.making.joints.append(ModelJoint(name, kind, self.link, child, vector(at), lines, closing=closing))
        if last and not whole:
            self._fix(child)
        self.link = child

    def _fix(self, link: str) -> None:
        """Fix the last link of a chain to the body that it leads to."""
        assert self.at is not None
        name = self.making.unused(f"{link}_fixed")
        self.making.joints.append(ModelJoint(name, "fixed", link, self.end, vector(self.at), closing=True))

    def _bars(self, base: str, geometry: Geometry, *, last: bool) -> None:
        """Two bars with ball ends: the first one carries what follows, the second one closes a loop with it."""
        near, bars = self.link, geometry["bars"]
        far = self.end if last else f"{base}_link"
        ends = []
        for n, foot in enumerate((geometry["first"], geometry["second"]), start=1):
            bar = self.making.link(f"{base}_bar_{n}")
            names = [self.making.unused(f"{base}_{n}{letter}") for letter in "ab"]
            self.making.joints.append(ModelJoint(names[0], "ball", near, bar, vector(foot)))
            closing = n == 2 or (last and self.closes)
            ends.append(ModelJoint(names[1], "ball", bar, self.making.link(far), vector(foot + bars), closing=closing))
        self.making.joints += ends
        self.link = far
        self.at = geometry["first"] + bars


def _motions(spec: JointSpec, geometry: Geometry, near: Floats) -> Iterator[_Motion]:
    """The turns and slides of a joint, one after the other."""
    for m in shape_of(spec.kind).motions:
        screw = np.asarray(m.screw(geometry), dtype=float)
        turn, slide = screw[:3], screw[3:]
        size = float(np.linalg.norm(turn))
        if size < _SAME:
            yield _Motion("prismatic", near, slide, m.freedom, m.sign * float(np.linalg.norm(slide)))
            continue
        foot = np.cross(turn, slide) / size**2
        points = [geometry[p] for p in ("point", "near", "far", "first", "second") if p in geometry]
        at = next((p for p in points if _on(p, foot, turn / size)), None)
        if at is None:
            at = near if _on(near, foot, turn / size) else foot
        yield _Motion("revolute", at, turn, m.freedom, m.sign * size)
        pitch = float(turn @ slide) / size**2
        if abs(pitch) > _SAME:
            yield _Motion("prismatic", at, turn, m.freedom, m.sign * size * pitch)


def _on(point: Floats, foot: Floats, axis: Floats) -> bool:
    away = point - foot
    size = max(1.0, float(np.abs(point).max()))
    return bool(np.linalg.norm(away - axis * (away @ axis)) < _SAME * size)


def _word(text: Any) -> str:
    """A name for a file: letters, digits and _."""
    found = re.sub(r"[^0-9A-Za-z]+", "_", str(text)).strip("_")
    return found or "limb"
