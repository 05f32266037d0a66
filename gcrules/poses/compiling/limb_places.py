r"""Where the points and directions of a robot of joints are, in closed form on the tape, from coordinates of its pose.

The platform: coordinates that are not named are 0, or follow from planes in which points of it stay, as the spherical
joints of a 3-RPS do. Then what rides on it is known. A point that a limb's first joint carries, a turn or a slide, is
the one of a circle or a line that keeps its distance from a point of the platform; a direction that it turns keeps its
angle with one. A bar between two such points is their difference, and what stays perpendicular to two of all these is
along their cross product. Of two roots that of home is taken, throughout.

What stays, rides and keeps a distance is seen in configurations that were solved by Newton's method; what is made of
it is compared with others (`limb_programs`). All numbers are those of the home configuration as the file gives it,
exact, and no root is taken but on the tape; so it can be run in exact arithmetic, too. Derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import combinations

import numpy as np

from gcrules.core.linear_algebra import kernel
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.compiling.exact_places import at_home, combined_at, floats, left_inverse, near
from gcrules.poses.compiling.roots import NoForm, Roots, cosine_and_sine
from gcrules.poses.compiling.scalars import Graph, Ring
from gcrules.poses.compiling.turns import TurnedBy, about, back, level, product
from gcrules.poses.compiling.vectors import (
    Turn,
    Vector,
    add,
    cross,
    dot,
    exact,
    scaled,
    sub,
    total,
    turned,
    vector,
)
from gcrules.poses.limbs.many import Solved
from gcrules.screws.pose_text import SHIFTS, TURNS

__all__ = ["LimbPlaces"]

_STAYS = 1e-10  # in parts of the robot's size, or rad
_ROUNDED = 1e-14  # in parts of the robot's size
_APART = 1e-3  # the sine of the angle between two directions that have a normal


class LimbPlaces:
    """The places of names from coordinates `names` of a pose; `solved` are configurations in general position. Asking
    for what has no closed form raises NoForm. Directions of `other_length` have not the one that they have at home.

    Inputs of angles are what `turned_by` makes a cosine and a sine of: the angles themselves, from −π to π, or what
    else is 0 at home.
    """

    def __init__(
        self,
        names: Sequence[str],
        solved: Solved,
        turned_by: TurnedBy = cosine_and_sine,
    ) -> None:
        self.names, self.solved, self.m = names, solved, solved.m.linkage
        self.turned_by = turned_by
        self.size = self.m.size
        self.graph = Graph(len(names))
        self.roots = Roots(self.graph)
        self.home = at_home(self.m)
        self.centre = near(self.m.centre, _ROUNDED * self.size)
        self.sorts = self.m.robot.family.sorts
        self.solved_for: dict[int, str] = {}
        """What each root places, by its node."""
        self.shift, self.turn = self._pose()
        self._note_roots("yaw")
        self.known: dict[str, Vector] = {}
        self.other_length: set[str] = set()
        self._open: set[str] = set()  # names that are being made from others

    def at(self, name: str) -> Vector:
        """Where a point or direction of the robot is."""
        if name not in self.known:
            self.known[name] = self._place(name)
            self._note_roots(name)
        return self.known[name]

    def seen(self, name: str) -> Vector:
        """The same, as the platform sees it: where it would be with the platform at home."""
        if self.rides(name) and not self._stays(name):
            return self.home[name]
        if self.sorts[name] != "point":
            return turned(back(self.turn), self.at(name))
        return add(turned(back(self.turn), sub(self.at(name), add(self.centre, self.shift))), self.centre)

    def _note_roots(self, name: str) -> None:
        """Roots that have been made since are of the equation that places this name."""
        for n, (op, _, _) in enumerate(self.graph.nodes):
            if op == "sqrt":
                self.solved_for.setdefault(n, name)

    # --- the platform ---

    def _pose(self) -> tuple[Vector, Turn]:
        """The shift of its centre, and its rotation."""
        if not set(self.names) <= {*SHIFTS, *TURNS}:
            raise NoForm("the turn is named by a vector")
        found = self.solved.coordinates  # in the order of SHIFTS and TURNS
        given: dict[str, tuple[Ring, ...]] = {}
        for n, angle in zip(self.names, self.graph.inputs, strict=True):
            given[n] = (angle,) if n in SHIFTS else self.turned_by(angle)
        still = [n for k, n in enumerate((*SHIFTS, *TURNS)) if np.abs(found[:, k]).max() <= self._zero(n)]
        given |= {n: (0,) if n in SHIFTS else (1, 0) for n in still if n not in given}
        open_ = [n for n in (*SHIFTS, *TURNS) if n not in given]
        if open_:
            given |= self._from_pivot(open_, given) or self._from_planes(open_, given)
        x, y, z = (given[n][0] for n in SHIFTS)
        return (x, y, z), product(about(2, *given["yaw"]), level(given["roll"], given["pitch"]))

    def _zero(self, name: str) -> float:
        return _STAYS * (self.size if name in SHIFTS else 1.0)

    def _from_pivot(self, open_: list[str], given: dict[str, tuple[Ring, ...]]) -> dict[str, tuple[Ring, ...]]:
        """Unnamed shifts, from a point of the platform that stays where it is; nothing where there is none."""
        still = (n for n, sort in self.sorts.items() if sort == "point" and self._stays(n) and self.rides(n))
        pivot = next(still, None)
        if pivot is None or not set(open_) <= set(SHIFTS):
            return {}
        arm = sub(self.home[pivot], self.centre)
        shift = sub(arm, turned(product(about(2, *given["yaw"]), level(given["roll"], given["pitch"])), arm))
        return {n: (shift[SHIFTS.index(n)],) for n in open_}

    def _from_planes(self, open_: list[str], given: dict[str, tuple[Ring, ...]]) -> dict[str, tuple[Ring, ...]]:
        """Unnamed shifts, and yaw, from planes in which ends of limbs stay."""
        unknown = [SHIFTS.index(n) for n in open_ if n in SHIFTS]
        if not set(open_) <= {*SHIFTS, "yaw"}:
            raise NoForm("roll or pitch follows from other coordinates")
        planes = list(self._planes())
        shift = tuple(given[n][0] if n in given else 0 for n in SHIFTS)
        if "yaw" not in open_ or len(unknown) + 1 > len(planes):
            raise NoForm("too few planes")
        flat = level(given["roll"], given["pitch"])
        rows = []  # a cos + b sin + c + Σ normal · unknown shifts = 0
        for n, arm in planes:
            u, v, w = (dot(row, arm) for row in flat)
            fixed = dot(n, sub(vector(shift), arm)) + n[2] * w
            rows.append((n[0] * u + n[1] * v, n[1] * u - n[0] * v, fixed))
        for chosen in combinations(range(len(planes)), len(unknown) + 1):
            matrix = [[planes[k][0][c] for c in unknown] for k in chosen]
            sizes = np.linalg.svd(np.array(matrix, dtype=float), compute_uv=False)
            if not unknown or sizes[-1] > 1e-3 * max(sizes[0], 1e-9):
                break
        else:
            raise NoForm("planes that depend on each other")
        factors = kernel(zip(*matrix, strict=True), len(chosen))[0]  # Σ factor · normal = 0 in the unknowns
        a, b, c = (total(f * rows[k][place] for f, k in zip(factors, chosen, strict=True)) for place in range(3))
        cosine, sine = self.roots.turned(a, b, c)
        sides = [-(rows[k][0] * cosine + rows[k][1] * sine + rows[k][2]) for k in chosen]
        found: dict[str, tuple[Ring, ...]] = {"yaw": (cosine, sine)}
        for place, row in zip(unknown, left_inverse(matrix), strict=True):
            found[SHIFTS[place]] = (total(f * side for f, side in zip(row, sides, strict=True)),)
        return found

    def _planes(self) -> Iterator[tuple[Vector, Vector]]:
        """Constant directions, and the arms (from the centre, at home) of ends that stay normal to them."""
        platform = self.solved.links[0][:, -1]
        for k, end in enumerate(self.m.ends):
            if not self.m.ball_ended[k]:
                continue
            moved = (platform[:, :3, :3] @ end) + platform[:, :3, 3] - end
            at = next((n for n, v in self.m.home.values.items() if np.array_equal(v, end)), None)
            for name, sort in self.sorts.items():
                if sort == "direction" and self._stays(name):
                    normal = self.m.home.values[name] / np.linalg.norm(self.m.home.values[name])
                    if np.abs(moved @ normal).max() <= _STAYS * self.size:
                        yield self.home[name], sub(exact(end) if at is None else self.home[at], self.centre)
                        break

    # --- names ---

    def _stays(self, name: str) -> bool:
        off = np.abs(self.solved.values[name] - self.m.home.values[name]).max()
        return bool(off <= _STAYS * (self.size if self.sorts[name] == "point" else 1.0))

    def _moved(self, value: Floats, point: bool) -> Floats:
        """Where the platform carries a place at home to, in the configurations."""
        platform = self.solved.links[0][:, -1]
        found = platform[:, :3, :3] @ value
        return found + platform[:, :3, 3] if point else found

    def rides(self, name: str) -> bool:
        point = self.sorts[name] == "point"
        off = self.solved.values[name] - self._moved(self.m.home.values[name], point)
        return bool(np.abs(off).max() <= _STAYS * (self.size if point else 1.0))

    def _carried(self, v: Vector, point: bool) -> Vector:
        """A place at home where the platform carries it, on the tape."""
        if not point:
            return turned(self.turn, v)
        return add(turned(self.turn, sub(v, self.centre)), add(self.centre, self.shift))

    def _place(self, name: str) -> Vector:
        home, point = self.home[name], self.sorts[name] == "point"
        if self._stays(name):
            return home
        if self.rides(name):
            return self._carried(home, point)
        limb = next((a.limb for a in self.m.attachments.get(name, ()) if a.link == 1), None)
        roads: list[Callable[[], Vector]] = [] if point else [lambda: self._perpendicular(name)]
        if limb is not None:
            roads.append(lambda: self._first(name, limb))
        if not point:
            roads += [lambda: self._bar(name), lambda: self._normal(name)]
        for road in roads:
            with suppress(NoForm):
                return road()
        raise NoForm(f"{name} is carried by several joints")

    def _perpendicular(self, name: str) -> Vector:
        """A direction that the file makes perpendicular to two others."""
        made = next((d.relation for d in self.m.robot.family.definitions if d.name == name), None)
        if made is None or made.kind != "perpendicular to both" or self._open & set(made.names):
            raise NoForm(f"{name} is perpendicular to no two others")
        self._open.add(name)
        try:
            u, v = (combined_at(term, {n: self.at(n) for n in made.names}) for term in made.args)
        finally:
            self._open.discard(name)
        before, after = (combined_at(term, self.home) for term in made.args)
        return self._along(name, cross(u, v), np.cross(floats(before), floats(after)))

    def _along(self, name: str, v: Vector, home: Floats) -> Vector:
        """A direction as another one that is parallel to it, which is `home` at home; it may have another length."""
        sign = float(home @ self.m.home.values[name])
        if not sign:
            raise NoForm(f"{name} is perpendicular to parallel directions at home")
        self.other_length.add(name)
        return scaled(v, 1 if sign > 0 else -1)

    def _bar(self, name: str) -> Vector:
        """A direction from a point that a first joint carries to one of the platform."""
        along = self.m.home.values[name]
        for start, values in self.solved.values.items():
            if self.sorts.get(start) == "point":
                far = self.m.home.values[start] + along
                off = values + self.solved.values[name] - self._moved(far, point=True)
                if np.abs(off).max() <= _STAYS * self.size:
                    return sub(self._carried(add(self.home[start], self.home[name]), point=True), self.at(start))
        raise NoForm(f"{name} is carried by several joints")

    def _normal(self, name: str) -> Vector:
        """A direction that stays perpendicular to two others, or to bars between points."""
        here, home = self.solved.values[name], self.m.home.values[name]
        across: list[tuple[tuple[str, ...], Floats]] = []
        for one in self._ends():
            if name not in one:
                bar = self._bar_of(one, self.solved.values)
                size = np.linalg.norm(bar, axis=-1) * np.linalg.norm(home)
                if np.abs((bar * here).sum(axis=-1)).max() <= _STAYS * size.min(initial=np.inf):
                    across.append((one, self._bar_of(one, self.m.home.values)))
        self._open.add(name)
        try:
            for (one, u), (other, v) in combinations(across, 2):
                normal = np.cross(u, v)
                if np.linalg.norm(normal) <= _APART * np.linalg.norm(u) * np.linalg.norm(v):
                    continue
                with suppress(NoForm):
                    return self._along(name, cross(self._between(one), self._between(other)), normal)
        finally:
            self._open.discard(name)
        raise NoForm(f"{name} is perpendicular to no two others")

    def _ends(self) -> Iterator[tuple[str, ...]]:
        """Directions, and pairs of points."""
        yield from ((n,) for n, sort in self.sorts.items() if sort == "direction")
        yield from combinations((n for n, sort in self.sorts.items() if sort == "point"), 2)

    @staticmethod
    def _bar_of(ends: Sequence[str], values: Mapping[str, Floats]) -> Floats:
        return values[ends[0]] if len(ends) == 1 else values[ends[1]] - values[ends[0]]

    def _between(self, ends: Sequence[str]) -> Vector:
        if self._open & set(ends):
            raise NoForm("a circle")
        return self.at(ends[0]) if len(ends) == 1 else sub(self.at(ends[1]), self.at(ends[0]))

    def _first(self, name: str, limb: int) -> Vector:
        """What a limb's first joint carries, held at its distance from, or angle with, what rides on the platform."""
        home = self.home[name]
        turns, axis, foot = self._axis(limb)
        square = dot(axis, axis)
        if self.sorts[name] == "point":
            held = next(self._held(name), None)
            if held is None:
                return self._slid(name, None if turns else axis)
            far, rod = self._carried(held, point=True), sub(held, home)
            length = dot(rod, rod)
            if not turns:
                off = sub(home, far)
                size = float(np.linalg.norm(floats(rod)) * np.linalg.norm(floats(axis)))
                return add(home, scaled(axis, self.roots.slid(dot(axis, off), dot(off, off) - length, size, square)))
            arm = sub(home, foot)
            middle = add(foot, scaled(axis, dot(axis, arm) / Fraction(square)))  # type: ignore[operator,arg-type]
            radius = sub(home, middle)
            across = cross(axis, radius)
            e = sub(far, middle)
            rest = dot(e, e) + dot(radius, radius) - length
            cosine, sine = self.roots.turned(dot(e, radius) * -2, dot(e, across) * -2, rest, square)
            return add(middle, add(scaled(radius, cosine), scaled(across, sine)))
        if not turns:
            raise NoForm(f"{name} does not turn")
        other = next((n for n in self._angled(name)), None)
        if other is None:
            raise NoForm(f"{name} keeps no angle with the platform")
        middle = scaled(axis, dot(axis, home) / Fraction(square))  # type: ignore[operator,arg-type]
        u, v = sub(home, middle), cross(axis, home)
        w = self.at(other)
        rest = dot(middle, w) - dot(home, self.home[other])
        cosine, sine = self.roots.turned(dot(u, w), dot(v, w), rest, square)
        return add(middle, add(scaled(u, cosine), scaled(v, sine)))

    def _slid(self, name: str, axis: Vector | None) -> Vector:
        """A point on a slide that stays with one of the platform in a plane of constant direction."""
        size = np.linalg.norm(floats(axis)) if axis is not None else 0.0
        for normal in (n for n, sort in self.sorts.items() if sort == "direction" and self._stays(n) and size):
            assert axis is not None
            n, v = self.home[normal], self.m.home.values[normal]
            for other in (o for o, sort in self.sorts.items() if sort == "point" and self.rides(o)):
                depth = (self.solved.values[other] - self.solved.values[name]) @ (v / np.linalg.norm(v))
                if (
                    abs(v @ floats(axis)) > _APART * np.linalg.norm(v) * size
                    and np.abs(depth - depth[0]).max() <= _STAYS * self.size
                ):
                    moved = sub(self._carried(self.home[other], point=True), self.home[other])
                    return add(self.home[name], scaled(axis, dot(n, moved) * (1 / Fraction(dot(n, axis)))))  # type: ignore[arg-type, operator]
        raise NoForm(f"{name} keeps no distance from the platform")

    def _axis(self, limb: int) -> tuple[bool, Vector, Vector]:
        """Of a limb's first motion at home: whether it turns, along what, and a point of its axis (the origin for a
        slide). Raises NoForm for a screw, and where the joint's first direction is not that of its first motion.
        """
        joint = self.m.robot.limbs[limb].joints[0]
        screw = self.m.home.chains[limb].screws[0]
        turns = bool(screw[:3].any())
        if not joint.directions:
            raise NoForm("a first joint without a direction")
        axis = combined_at(joint.directions[0], self.home)
        foot = self.home[joint.points[0]] if turns and joint.points else (0, 0, 0)
        along = floats(axis) / np.linalg.norm(floats(axis))
        expected = np.concatenate([along, np.cross(floats(foot), along)] if turns else [np.zeros(3), along])
        scale = np.array([1.0] * 3 + [self.size if turns else 1.0] * 3)
        if np.abs((screw - expected) / scale).max() > _STAYS:
            raise NoForm("a first joint of another kind")
        return turns, axis, foot

    def _held(self, name: str) -> Iterator[Vector]:
        """Places at home, on the platform, from which a point keeps its distance; where that is not 0."""
        here, home = self.solved.values[name], self.m.home.values[name]
        for other, sort in self.sorts.items():
            if sort == "direction":
                place = add(self.home[name], self.home[other])  # a bar may lead there
            elif self.rides(other) and not self._stays(other):
                place = self.home[other]
            else:
                continue
            far = np.linalg.norm(self._moved(floats(place), point=True) - here, axis=1)
            length = np.linalg.norm(floats(place) - home)
            if length > _STAYS * self.size and np.abs(far - length).max() <= _STAYS * self.size:
                yield place

    def _angled(self, name: str) -> Iterator[str]:
        """Directions of the platform with which one keeps its angle."""
        here, home = self.solved.values[name], self.m.home.values
        for other, sort in self.sorts.items():
            if sort == "direction" and self.rides(other) and not self._stays(other):
                angle = (here * self.solved.values[other]).sum(axis=1)
                if np.abs(angle - home[name] @ home[other]).max() <= _STAYS:
                    yield other
