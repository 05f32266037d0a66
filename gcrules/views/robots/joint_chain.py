r"""Where the joints and links of a robot are drawn in space: each limb as a chain of places, in the robot's size.

A prismatic joint between two joints whose line it follows is a sleeve on the link; one that comes first, or goes
another way, is a carriage on a rail; a limb whose axes all pass through one point is drawn on spheres around it, each
link on a smaller one than the link before.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import combinations, pairwise, product
from math import atan2, cos, dist, sin
from typing import SupportsFloat

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec, Subchain
from gcrules.mechanisms.description.relations import Term, Values
from gcrules.mechanisms.robot import Robot
from gcrules.views.drawing.bsp import XYZ, cross, dot, minus
from gcrules.views.drawing.frame import Unit
from gcrules.views.drawing.solids import center
from gcrules.views.robots.drawn_limb import DrawnJoint, DrawnLimb, Rail, Rod, plus, unit_vector

__all__ = ["bodies", "chains", "upright"]

_SHELL = 0.22  # from the sphere of one link to that of the next
_FOOT, _HEAD = 0.14, 0.16  # from the first and the last sphere to base and platform
_RAIL = 0.3
_BAR = 0.075  # half the distance of the bars of a parallelogram
_SLEEVE = 0.42  # where on a link its sleeve is
_TUBE = 0.62  # how much of a limb that only guides is a tube

Rails = Mapping[tuple[str, str, str], tuple[Rail, ...]]
"""Those of each chain, by its limb and the bodies between which it is."""


def chains(robot: Robot, values: Values, own: Unit | None = None) -> tuple[Unit, list[DrawnLimb]]:
    """All limbs in a configuration (Cartesian coordinates of all names), in a unit of its `own` or in that of the ball
    around it. Rails lie as they do at home, where the robot has one: they do not change sides while it moves. Other
    members of the family, whose bodies are others, are drawn by themselves.
    """
    home = _at_home(robot)
    known = home is not None and home[0] != values and _one_robot(robot, values, home[0])
    return _made(robot, values, own, home[1] if home and known else {})


@lru_cache(maxsize=16)
def _at_home(robot: Robot) -> tuple[Values, Rails] | None:
    """Of robots with slides the coordinates of all names at home, and how the rails lie there; None where it is not
    known.
    """
    if robot.home is None or not any(j.kind in ("P", "C") for limb in robot.limbs for j in limb.joints):
        return None
    try:
        values = robot.values_at()
    except InputError:
        return None
    drawn = _made(robot, values, None, {})[1]
    return values, {(c.limb.name, c.start, c.end): tuple(c.rails) for c in drawn if c.rails}


def _one_robot(robot: Robot, values: Values, home: Values) -> bool:
    """Whether the platform has the shape of home, and the first joints slide and turn in the directions of home."""
    terms = [limb.joints[0].directions[-1] for limb in robot.limbs if limb.joints[0].kind in ("P", "C", "R", "Pa")]
    pairs = [(unit_vector(_sum(t, values)), unit_vector(_sum(t, home))) for t in terms]
    heads = [limb.joints[-1].points[0] for limb in robot.limbs if limb.joints[-1].points]
    here, there = ([dist(_xyz(at[p]), _xyz(at[q])) for p, q in combinations(heads, 2)] for at in (values, home))
    same = all(abs(x - y) <= 1e-6 * max(there) for x, y in zip(here, there, strict=True))
    return same and all(dist(*pair) < 1e-6 for pair in pairs)


def _made(robot: Robot, values: Values, own: Unit | None, rails: Rails) -> tuple[Unit, list[DrawnLimb]]:
    family, limbs = robot.family, robot.limbs
    unit = own or _ball_around(family, limbs, values)
    firsts = [limb.joints[0].points for limb in limbs if len(limb.joints) > 1]
    ground = [unit.place(values[names[0]]) for names in firsts if names]
    opposite = _base_opposite(limbs, values)
    found: list[DrawnLimb] = []
    for limb in limbs:
        parts = [
            _Builder(
                unit,
                values,
                limb,
                part,
                joints,
                center(ground) if ground else None,
                opposite,
                rails.get((limb.name, part.start, part.end), ()),
            ).chain()
            for part, joints in limb.parts
        ]
        _join_bodies(parts)
        found += parts
    return unit, found


def _ball_around(family: Family, limbs: Sequence[LimbSpec], values: Values) -> Unit:
    named = dict.fromkeys(n for limb in limbs for j in limb.joints for n in j.names)
    points = [_xyz(values[n]) for n in named if family.sorts[n] == "point"]
    for limb in limbs:
        for j in (j for j in limb.joints if j.kind == "4S"):
            first, second, bars = (_xyz(_sum(arg, values)) for arg in j.args if isinstance(arg, tuple))
            points += [plus(first, bars), plus(second, bars)]
    if len(set(points)) < 2:
        return Unit(points[0] if points else (0.0, 0.0, 0.0), 1.0)
    return Unit.of(points)


def _is_round(joints: Sequence[JointSpec]) -> bool:
    """Whether a chain consists of revolute joints whose axes pass through one point."""
    return len(joints) > 1 and all(j.kind == "R" for j in joints) and len({j.points for j in joints}) == 1


def _base_opposite(limbs: Sequence[LimbSpec], values: Values) -> bool:
    """Whether the first joints of limbs around a point are drawn on the other side of it than the last ones, so that
    the platform stands over the base.
    """
    ends = [(joints[0], joints[-1]) for limb in limbs for _, joints in limb.parts if _is_round(joints)]
    if len(ends) < 2:
        return False
    first, last = ([unit_vector(_sum(pair[k].directions[0], values)) for pair in ends] for k in (0, 1))
    return dot(center(first), center(last)) > 0.1


def upright(made: Sequence[DrawnLimb]) -> XYZ:
    """What is upright in a picture: the z axis, for a robot around a point rather the way from it to the platform."""
    heads = [unit_vector(minus(c.head, c.around)) for c in made if c.around]
    middle = center(heads)
    if len(heads) < 2 or len(heads) < len(made) or dot(middle, middle) < 0.1 or abs(unit_vector(middle)[2]) > 0.9:
        return 0.0, 0.0, 1.0
    x, y, z = unit_vector(middle)
    return round(x, 12), round(y, 12), round(z, 12)


def bodies(made: Sequence[DrawnLimb]) -> tuple[tuple[XYZ, ...], tuple[XYZ, ...]]:
    """The corners of the platform and those of the base: where limbs end and begin, each place once."""
    several = [c for c in made if len(c.limb.joints) > 1] or made
    return _corners(c.head for c in several if c.end == PLATFORM), _corners(c.foot for c in several if c.start == BASE)


def _corners(places: Iterable[XYZ]) -> tuple[XYZ, ...]:
    return tuple({tuple(round(c, 9) for c in p): p for p in places}.values())


def _join_bodies(parts: Sequence[DrawnLimb]) -> None:
    """The bodies of a limb between its chains: bars between their joints, drawn with the last one."""
    for body in dict.fromkeys(c.start for c in parts if c.start != BASE):
        last = [c for c in parts if body in (c.start, c.end)][-1]
        last.strokes += [
            Rod(a, b)
            for a, b in bars_of_body(
                [c.head for c in parts if c.end == body] + [c.foot for c in parts if c.start == body]
            )
        ]


def bars_of_body(places: Sequence[XYZ]) -> list[tuple[XYZ, XYZ]]:
    """What joins places of one body in a picture: one bar, or of more than two bars from the middle to each."""
    if len(places) == 2:
        return [(places[0], places[1])]
    middle = center(places)
    return [(middle, p) for p in places if dist(middle, p) > 1e-9]


def _xyz(v: Sequence[SupportsFloat]) -> XYZ:
    x, y, z = map(float, v)
    return x, y, z


def _sum(term: Term, values: Values) -> XYZ:
    x, y, z = (sum(float(c) * float(values[n][i]) for c, n in term) for i in range(3))
    return x, y, z


@dataclass
class _Builder:
    """Makes the chain of one limb, joint by joint."""

    unit: Unit
    values: Values
    limb: LimbSpec
    part: Subchain
    joints: tuple[JointSpec, ...]
    ground: XYZ | None  # the middle of the first joints of other limbs
    opposite: bool  # whether limbs around a point begin on the other side of it
    rails: tuple[Rail, ...]  # those at home, the first one drawn first

    def chain(self) -> DrawnLimb:
        joints = self.joints
        made = DrawnLimb(self.limb, joints, self.part.start, self.part.end)
        if _is_round(joints):
            return self._on_sphere(made)
        at: XYZ | None = None
        waiting: list[JointSpec] = []
        for j in joints:
            anchor = self._anchor(j)
            if anchor is None:
                waiting.append(j)
                continue
            if at is None:
                made.foot = self._rails(made, waiting, anchor, self._away(j, anchor))
            else:
                self._between(made, waiting, at, anchor)
            waiting = []
            at = self._joint(made, j, anchor)
        carried = [own for part, own in self.limb.parts if part.start == self.part.end]
        following = [j for own in carried for j in own[:1] if j.points]
        if at is None and following:  # slides that carry what holds other chains
            at = center([self._point(n) for j in following for n in j.points])
            made.foot = self._rails(made, waiting, at, self._away(following[0], at))
            waiting = []
        elif at is None:
            at = made.foot = self._rails(made, waiting[:-1], (0.0, 0.0, 0.0), None)
        if waiting:
            at = self._beyond(made, waiting, at)
        made.head = at
        return made

    def _point(self, name: str) -> XYZ:
        return self.unit.place(self.values[name])

    def _direction(self, term: Term) -> XYZ:
        return unit_vector(_sum(term, self.values))

    def _anchor(self, j: JointSpec) -> XYZ | None:
        return self._point(j.points[0]) if j.points else None

    def _away(self, j: JointSpec, anchor: XYZ) -> XYZ | None:
        """The direction from a joint to the next one that has a place."""
        if j.kind == "4S":
            return self._direction(j.directions[0])
        rest = self.joints[self.joints.index(j) + 1 :] if j in self.joints else ()
        following = next((p for k in rest if (p := self._anchor(k)) and dist(p, anchor) > 1e-9), None)
        return unit_vector(minus(following, anchor)) if following else None

    def _joint(self, made: DrawnLimb, j: JointSpec, at: XYZ) -> XYZ:
        """Draw a joint that has a place; where the chain goes on."""
        axes = tuple(self._direction(d) for d in j.directions)
        if j.kind != "4S":
            made.places.append(DrawnJoint(j.kind, at, axes, bool(j.actuated)))
            for term in (d for d in j.directions if len(d) == 2):
                made.strokes.append(Rod(at, self._point(next(n for _, n in term if self._point(n) != at)), "axis"))
            return at
        second = self._point(j.points[1])
        x, y, z = (c / self.unit.radius for c in _sum(j.directions[0], self.values))
        ends = plus(at, (x, y, z)), plus(second, (x, y, z))
        made.strokes += [Rod(at, second), Rod(*ends)]
        made.strokes += [Rod(a, b, "bar") for a, b in zip((at, second), ends, strict=True)]
        made.places += [DrawnJoint("pin", p) for p in (at, second, *ends)]
        made.normals.append(unit_vector(cross(minus(second, at), (x, y, z))))
        return center(ends)

    def _rails(self, made: DrawnLimb, slides: Sequence[JointSpec], at: XYZ, away: XYZ | None) -> XYZ:
        """Carriages on rails under the first joint that has a place; where the first of them stands on the base."""
        if len(slides) == 1 and away is None:
            return self._column(made, slides[0], at)
        for k, j in enumerate(reversed(slides)):
            axis = self._direction(j.directions[0])
            rail = self._rail(made, at, axis, away, last=k == len(slides) - 1)
            ends = plus(at, axis, -rail.low), plus(at, axis, rail.high)
            made.strokes.append(Rod(*ends, "rail"))
            made.places.append(DrawnJoint("carriage", at, (axis,), bool(j.actuated)))
            at = ends[rail.grounded]
        return at

    def _rail(self, made: DrawnLimb, at: XYZ, axis: XYZ, away: XYZ | None, *, last: bool) -> Rail:
        """The rail at home, or one that lies as is best here: short before the link that goes on along it, long to the
        side on which the next one stands.
        """
        if len(made.rails) < len(self.rails):
            made.rails.append(self.rails[len(made.rails)])
            return made.rails[-1]
        low, high = _RAIL, _RAIL
        if away is not None and abs(dot(axis, away)) > 0.8:
            low, high = (0.08, 1.5 * _RAIL) if dot(axis, away) < 0 else (1.5 * _RAIL, 0.08)
        if not last:
            low, high = (_RAIL, 0.1) if not self._outwards(at, axis) else (0.1, _RAIL)
        ends = plus(at, axis, -low), plus(at, axis, high)
        made.rails.append(Rail(low, high, ends.index(self._grounded(ends))))
        return made.rails[-1]

    def _column(self, made: DrawnLimb, j: JointSpec, at: XYZ) -> XYZ:
        """A slide right under the only joint that has a place."""
        axis = self._direction(j.directions[0])
        ends = plus(at, axis, -0.75), plus(at, axis, 0.75)
        made.rails.append(self.rails[0] if self.rails else Rail(0.75, 0.75, ends.index(self._grounded(ends))))
        foot = ends[made.rails[0].grounded]
        self._slide(made, j, foot, at)
        return foot

    def _grounded(self, ends: tuple[XYZ, XYZ]) -> XYZ:
        """The end that is nearer to the base: to the middle of the other limbs' feet, else farther from the robot."""
        ground = self.ground
        if ground is not None:
            return min(ends, key=lambda p: round(dist(p, ground), 6))
        return max(ends, key=lambda p: (round(dist(p, (0.0, 0.0, 0.0)), 6), round(-p[2], 6)))

    def _outwards(self, at: XYZ, axis: XYZ) -> bool:
        return round(dist(plus(at, axis, _RAIL), (0, 0, 0)), 6) > round(dist(plus(at, axis, -_RAIL), (0, 0, 0)), 6)

    def _between(self, made: DrawnLimb, slides: Sequence[JointSpec], start: XYZ, end: XYZ) -> None:
        """The link between two joints, with the sleeves or parallelograms that it carries."""
        for j in slides:
            term = j.directions[0]
            if len(term) == 2:  # written with two points: it stands on their line
                first, second = (self._point(n) for _, n in reversed(term))
                if dist(start, first) > 1e-9:
                    made.strokes.append(Rod(start, first))
                start, goal = first, second
            else:
                goal = end
            axis = self._direction(term)
            length = dist(start, goal)
            if length < 1e-9 or abs(dot(axis, minus(goal, start))) < 0.999 * length:
                goal = plus(end, axis, -_RAIL)
                made.strokes += [Rod(start, goal)] if dist(start, goal) > 1e-9 else []
                start, goal = goal, end
            self._slide(made, j, start, goal)
            start = goal
        if dist(start, end) > 1e-9:
            made.strokes.append(Rod(start, end))

    def _slide(self, made: DrawnLimb, j: JointSpec, start: XYZ, end: XYZ) -> None:
        if j.kind != "Pa":
            made.strokes.append(Rod(start, end))
            if not any(one.actuated for one in self.limb.joints):
                made.strokes.append(Rod(start, plus(start, minus(end, start), _TUBE), "tube"))
            middle = plus(start, minus(end, start), _SLEEVE)
            made.places.append(DrawnJoint(j.kind, middle, (unit_vector(minus(end, start)),), bool(j.actuated)))
            return
        across = unit_vector(cross(self._direction(j.directions[1]), minus(end, start)))
        made.normals.append(unit_vector(self._direction(j.directions[1])))
        corners = [(plus(p, across, _BAR), plus(p, across, -_BAR)) for p in (start, end)]
        made.strokes += [Rod(*pair) for pair in corners]
        made.strokes += [Rod(a, b, "bar") for a, b in zip(*corners, strict=True)]
        made.places += [DrawnJoint("pin", p, driven=bool(j.actuated)) for pair in corners for p in pair]

    def _beyond(self, made: DrawnLimb, slides: Sequence[JointSpec], at: XYZ) -> XYZ:
        """Slides after the last joint that has a place."""
        for j in slides:
            term = j.directions[0]
            named = self._point(term[0][1]) if len(term) == 2 else None
            goal = named or plus(at, self._direction(term), 2 * _RAIL)
            self._between(made, [j], at, goal)
            at = goal
        return at

    def _on_sphere(self, made: DrawnLimb) -> DrawnLimb:
        made.around = o = self._anchor(self.joints[0]) or (0.0, 0.0, 0.0)
        axes = self._outward([self._direction(j.directions[0]) for j in self.joints])
        for k, (j, axis) in enumerate(zip(self.joints, axes, strict=True)):
            outer, inner = 1.0 - _SHELL * max(k - 1, 0), 1.0 - _SHELL * min(k, len(axes) - 2)
            at = plus(o, axis, (outer + inner) / 2)
            made.strokes.append(Rod(o, at, "axis"))
            if outer > inner:
                made.strokes.append(Rod(plus(o, axis, outer), plus(o, axis, inner)))
            made.places.append(DrawnJoint("R", at, (axis,), bool(j.actuated)))
            if k < len(axes) - 1:
                made.normals += [unit_vector(n)] if dot(n := cross(axis, axes[k + 1]), n) > 1e-9 else []
                made.strokes += [
                    Rod(plus(o, u, inner), plus(o, v, inner)) for u, v in pairwise(_arc(axis, axes[k + 1]))
                ]
        made.spheres = tuple(1.0 - _SHELL * k for k in range(len(axes) - 1))
        made.foot = plus(o, axes[0], 1.0 + _FOOT)
        made.head = plus(o, axes[-1], 1.0 - _SHELL * (len(axes) - 2) - _HEAD)
        return made

    def _outward(self, axes: Sequence[XYZ]) -> list[XYZ]:
        """On which side of the point each joint is drawn: so that the longest link is as short as can be."""
        first = (-1,) if self.opposite else (1,)
        last = (1,) if self.opposite else (1, -1)
        sides = product(first, *([(1, -1)] * (len(axes) - 2)), last)
        turned = [[(s * u[0], s * u[1], s * u[2]) for s, u in zip(one, axes, strict=True)] for one in sides]
        return max(turned, key=lambda one: round(min(dot(u, v) for u, v in pairwise(one)), 9))


def _arc(a: XYZ, b: XYZ) -> Iterator[XYZ]:
    """Unit vectors along the great circle from one to another that is less than a half turn away."""
    across = minus(b, (a[0] * dot(a, b), a[1] * dot(a, b), a[2] * dot(a, b)))
    if dot(across, across) < 1e-12:
        yield from (a, b)
        return
    side = unit_vector(across)
    sine, cosine = dot(b, side), dot(a, b)
    steps = 12
    for k in range(steps + 1):
        angle = atan2(sine, cosine) * k / steps
        yield plus((a[0] * cos(angle), a[1] * cos(angle), a[2] * cos(angle)), side, sin(angle))
