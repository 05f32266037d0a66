r"""Lines that meet all passive axes of a limb: directions and points of theirs that the file does not name.

A force through a point P is reciprocal to a twist if it is perpendicular to the velocity of P, and to a turn where its
line meets the turn's axis. So one line through P meets two axes: the meet of the planes of P with each of them. Two
axes that meet, or are parallel, lie in a plane; a line in it meets both. So lines in two such planes are the planes'
meet, and those in one plane that meet a further axis go through the point in which this axis meets the plane. Two
parallel bars with ball ends pass on a force in their plane, along them, and a couple normal to it; what is joined to
them by a further hinge passes on the force that goes through the point in which the hinge meets the plane. Geometry:
Pottmann and Wallner, Computational Line Geometry, chapter 2; what is taken is tested (see `wrenches`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations

from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import JointSpec, LimbSpec
from gcrules.mechanisms.description.relations import AXES, Term, Vector, combined
from gcrules.mechanisms.lines.derived import Derived
from gcrules.mechanisms.lines.names import Key, Named, Sample, key
from gcrules.screws import JOINTS, RESIDUES

__all__ = ["meets"]

_TURNS: Mapping[str, Mapping[int, str]] = {"R": {0: "axis"}, "C": {0: "axis"}, "U": {0: "first", 1: "second"}}
"""The axes of joints with a point: which part is the direction of which freedom."""

_SLIDES: Mapping[str, Mapping[int, str]] = {"P": {0: "direction"}, "C": {1: "axis"}}

_COST = 3.5  # as of what is derived from joints, and a little more

_Axis = tuple[str, Term]
_Plane = tuple[str, Term]  # a point of it, and its normal


def meets(family: Family, limb: LimbSpec, at: Sequence[Sample], one: Mapping[Key, str]) -> list[Named]:
    """Names of such directions and points, each after those that it is made from; none in the plane."""
    if family.plane:
        return []
    made = _Made(at, one)
    turns, slides = list(_freedoms(limb, _TURNS, made)), [w for _, w in _freedoms(limb, _SLIDES, made)]
    free = [j for j in _uncoupled(limb) if not j.actuated]
    slides += [t for j in free if j.kind == "Pa" for t in made.cross(*j.directions)]
    centres = {p for j in limb.joints if j.kind == "S" for p in j.points}
    screws = [[(j, Fraction(1))] for j in free if j.kind == "H"] + list(_geared(limb))
    for p in dict.fromkeys((*(p for j in limb.joints for p in j.points), *limb.through)):
        if centres <= {p}:
            across = [n for q, w in turns if q != p for n in made.cross(w, _difference(p, q))]
            _through([*slides, *across, *(v for pair in screws if (v := _velocity(p, pair, made)))], made)
    pairs = [(j.points[0], n) for j in limb.joints if j.kind == "4S" for n in made.cross(j.directions[0], _side(j))]
    planes = [*_planes(turns, made), *pairs]
    for (_, m), (_, n) in combinations(planes, 2):
        for both in made.cross(m, n):
            for _, w in turns if pairs else ():
                made.cross(both, w)
    for plane in planes:
        for axis in turns:
            made.meet(axis, plane)
        for (p, _), (q, _) in combinations(turns, 2):
            if p != q:
                made.meet((p, _difference(p, q)), plane)
    return made.named


def _freedoms(limb: LimbSpec, parts: Mapping[str, Mapping[int, str]], made: _Made) -> Iterator[_Axis]:
    """The passive ones of a kind: a point of the joint ("" where it has none) and the direction."""
    for j in _uncoupled(limb):
        for place, part in parts.get(j.kind, {}).items():
            if place not in j.actuated:
                yield next(iter(j.points), ""), _part(j, part)


def _part(j: JointSpec, name: str) -> Term:
    found = j.args[list(JOINTS[j.kind].parts).index(name)]
    assert isinstance(found, tuple)
    return found


def _difference(p: str, q: str) -> Term:
    return ((Fraction(1), q), (Fraction(-1), p))


def _side(j: JointSpec) -> Term:
    """From one of two parallel bars to the other: with these it spans the plane in which both lie."""
    first, second = j.points
    return _difference(first, second)


def _uncoupled(limb: LimbSpec) -> Iterator[JointSpec]:
    """The joints that neither follow others nor lead them."""
    coupled = {k for c in limb.couplings for k in (c.joint, c.leader)}
    yield from (j for k, j in enumerate(limb.joints) if k not in coupled)


def _geared(limb: LimbSpec) -> Iterator[list[tuple[JointSpec, Fraction]]]:
    """Joints that move as one and are not driven, with their rates."""
    for leader in dict.fromkeys(c.leader for c in limb.couplings if not limb.joints[c.leader].actuated):
        led = [(limb.joints[c.joint], c.ratio) for c in limb.couplings if c.leader == leader]
        yield [(limb.joints[leader], Fraction(1)), *led]


def _velocity(p: str, rates: Sequence[tuple[JointSpec, Fraction]], made: _Made) -> Term:
    """How P moves with joints at some rates, backwards: with a hinge or screw u × PQ − h u, the axis going through Q
    along u and h the pitch, with a slide −u, with bars b × u.
    """
    turning: list[tuple[Fraction, str]] = []
    sliding: list[tuple[Fraction, str]] = []
    for j, rate in rates:
        turned: list[Term] = []
        if j.points:
            turned = made.cross(_part(j, "axis"), _difference(p, j.points[0]), multiples=False)
        elif j.kind == "Pa":
            turned = made.cross(*j.directions, multiples=False)
        turning += [(rate * c, n) for term in turned for c, n in term]
        along = j.args[-1] if j.kind == "H" else Fraction(j.kind == "P")
        assert isinstance(along, Fraction)
        sliding += [(-rate * along * c, n) for c, n in j.directions[0] if along]
    found = (*turning, *sliding)
    return tuple((c / found[0][0], n) for c, n in found)


def _through(velocities: Sequence[Term], made: _Made) -> None:
    """The line through a point perpendicular to all its velocities by passive twists; of a pencil several lines."""
    normals: list[Term] = []
    for normal in velocities:
        if made.rank([*normals, normal]) > len(normals):
            normals.append(normal)
    if len(normals) == 2:
        made.cross(*normals)
    elif len(normals) == 1:
        for axis in AXES:
            made.cross(normals[0], ((Fraction(1), axis),))


def _planes(turns: Sequence[_Axis], made: _Made) -> Iterator[_Plane]:
    """Those of two axes that meet or are parallel."""
    for (p, u), (q, v) in combinations(turns, 2):
        across = [] if p == q else [_difference(p, q)]
        if made.rank([u, v, *across]) == 2:
            pair = (u, v) if made.rank([u, v]) == 2 else (u, *across)
            for normal in made.cross(*pair):
                yield p, normal


class _Made:
    """What was made so far, with its values at the samples."""

    def __init__(self, at: Sequence[Sample], one: Mapping[Key, str]) -> None:
        self.named: list[Named] = []
        self.known: list[dict[str, Vector]] = [
            {**s.values, **{n: (p[0], p[1], p[2]) for n, p in s.points.items() if n.startswith(":")}} for s in at
        ]
        self.seen = dict(one) | {key(k[n] for k in self.known): n for n in self.known[0] if n.startswith(":")}
        self.places: set[object] = {key(s.points[n] for s in at) for n in at[0].points}

    def rank(self, terms: Sequence[Term]) -> int:
        """That of these directions at all samples, the least one."""
        return min(RESIDUES.rank([combined(t, k, RESIDUES) for t in terms]) for k in self.known)

    def cross(self, u: Term, v: Term, *, multiples: bool = True) -> list[Term]:
        """The direction u × v, new or, with `multiples`, a known one that is a multiple of it; none where it is 0."""
        made = Derived(f":{len(self.named)}n", (u, v))
        rows = [made.row(k, RESIDUES) for k in self.known]
        if not all(map(any, rows)):
            return []
        own = key(row[:3] for row in rows)
        if multiples and own in self.seen:
            return [((Fraction(1), self.seen[own]),)]
        self.seen.setdefault(own, made.name)
        self.named.append((made.name, _COST, made))
        for k, (x, y, z, _) in zip(self.known, rows, strict=True):
            k[made.name] = x, y, z
        return [((Fraction(1), made.name),)]

    def meet(self, axis: _Axis, plane: _Plane) -> None:
        """The point of an axis in a plane, if that is one point."""
        (p, u), (q, normal) = axis, plane
        made = Derived(f":{len(self.named)}p", (((Fraction(1), p),), u, ((Fraction(1), q),), normal))
        rows = [made.row(k, RESIDUES) for k in self.known]
        if all(row[3] for row in rows) and key(rows) not in self.places:
            self.places.add(key(rows))
            self.named.append((made.name, _COST, made))
