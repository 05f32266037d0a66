r"""Where the points and directions of a robot of joints are, in closed form on the tape, from coordinates of its pose.

The platform: coordinates that are not named are 0, or follow from planes in which points of it stay, as the spherical
joints of a 3-RPS do. Then what rides on it is known. A point that a limb's first joint carries, a turn or a slide, is
the one of a circle or a line that keeps its distance from a point of the platform; a direction that it turns keeps its
angle with one. A bar between two such points is their difference, and what stays perpendicular to two of all these is
along their cross product. Of two roots that of home is taken, throughout.

What stays, rides and keeps a distance is seen in configurations that were solved by Newton's method; what is made of
it is compared with others (`limb_programs`). Derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import combinations
from typing import Any

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.compiling.roots import NoForm, Roots, cosine_and_sine, inverse, root
from gcrules.poses.compiling.scalars import Graph, Ring
from gcrules.poses.compiling.turns import about, back, level, product
from gcrules.poses.compiling.vectors import (
    Turn,
    Vector,
    add,
    cross,
    dot,
    exact,
    fractions,
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
_APART = 1e-3  # the sine of the angle between two directions that have a normal


class LimbPlaces:
    """The places of names from coordinates `names` of a pose, angles from −π to π; `solved` are configurations in
    general position. Asking for what has no closed form raises NoForm.
    """

    def __init__(self, names: Sequence[str], solved: Solved) -> None:
        self.names, self.solved, self.m = names, solved, solved.m.linkage
        self.size = self.m.size
        self.graph = Graph(len(names))
        self.roots = Roots(self.graph)
        self.centre = exact(self.m.centre)
        self.sorts = self.m.robot.family.sorts
        self.shift, self.turn = self._pose()
        self.known: dict[str, Vector] = {}
        self.open: set[str] = set()  # names that are being made from others

    def at(self, name: str) -> Vector:
        """Where a point or direction of the robot is."""
        if name not in self.known:
            self.known[name] = self._place(name)
        return self.known[name]

    def seen(self, name: str) -> Vector:
        """The same, as the platform sees it: where it would be with the platform at home."""
        if self._rides(name) and not self._stays(name):
            return exact(self.m.home.values[name])
        if self.sorts[name] != "point":
            return turned(back(self.turn), self.at(name))
        return add(turned(back(self.turn), sub(self.at(name), add(self.centre, self.shift))), self.centre)

    # --- the platform ---

    def _pose(self) -> tuple[Vector, Turn]:
        """The shift of its centre, and its rotation."""
        if not set(self.names) <= {*SHIFTS, *TURNS}:
            raise NoForm("the turn is named by a vector")
        found = self.solved.coordinates  # in the order of SHIFTS and TURNS
        given: dict[str, tuple[Ring, ...]] = {}
        for n, angle in zip(self.names, self.graph.inputs, strict=True):
            given[n] = (angle,) if n in SHIFTS else cosine_and_sine(angle)
        still = [n for k, n in enumerate((*SHIFTS, *TURNS)) if np.abs(found[:, k]).max() <= self._zero(n)]
        given |= {n: (0,) if n in SHIFTS else (1, 0) for n in still if n not in given}
        open_ = [n for n in (*SHIFTS, *TURNS) if n not in given]
        pivot = next(
            (n for n, sort in self.sorts.items() if sort == "point" and self._rides(n) and self._stays(n)), None
        )
        if pivot is not None and set(open_) <= set(SHIFTS):
            turn = product(about(2, *given["yaw"]), level(given["roll"], given["pitch"]))
            arm = sub(exact(self.m.home.values[pivot]), self.centre)
            return sub(arm, turned(turn, arm)), turn
        if open_:
            given |= self._from_planes(open_, given)
        x, y, z = (given[n][0] for n in SHIFTS)
        return (x, y, z), product(about(2, *given["yaw"]), level(given["roll"], given["pitch"]))

    def _zero(self, name: str) -> float:
        return _STAYS * (self.size if name in SHIFTS else 1.0)

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
        for normal, arm in planes:
            u, v, w = (dot(row, arm) for row in flat)
            n = exact(normal)
            fixed = dot(n, sub(vector(shift), arm)) + n[2] * w
            rows.append((n[0] * u + n[1] * v, n[1] * u - n[0] * v, fixed))
        for chosen in combinations(range(len(planes)), len(unknown) + 1):
            matrix = np.array([[planes[k][0][c] for c in unknown] for k in chosen])
            sizes = np.linalg.svd(matrix, compute_uv=False)
            if not unknown or sizes[-1] > 1e-3 * max(sizes[0], 1e-9):
                break
        else:
            raise NoForm("planes that depend on each other")
        weights = np.linalg.svd(matrix.T)[2][-1] if unknown else np.ones(1)  # Σ weight · normal = 0 in the unknowns
        factors = fractions(weights)
        a, b, c = (total(f * rows[k][place] for f, k in zip(factors, chosen, strict=True)) for place in range(3))
        cosine, sine = self.roots.turned(a, b, c)
        solve = np.linalg.pinv(matrix)
        sides = [-(rows[k][0] * cosine + rows[k][1] * sine + rows[k][2]) for k in chosen]
        found: dict[str, tuple[Ring, ...]] = {"yaw": (cosine, sine)}
        for place, row in zip(unknown, solve, strict=True):
            found[SHIFTS[place]] = (total(f * side for f, side in zip(fractions(row), sides, strict=True)),)
        return found

    def _planes(self) -> Iterator[tuple[Floats, Vector]]:
        """Constant directions of length 1, and the arms (from the centre, at home) of ends that stay normal to them."""
        platform = self.solved.links[0][:, -1]
        for k, end in enumerate(self.m.ends):
            if not self.m.ball_ended[k]:
                continue
            moved = (platform[:, :3, :3] @ end) + platform[:, :3, 3] - end
            for name, sort in self.sorts.items():
                if sort == "direction" and self._stays(name):
                    normal = self.m.home.values[name] / np.linalg.norm(self.m.home.values[name])
                    if np.abs(moved @ normal).max() <= _STAYS * self.size:
                        yield normal, sub(exact(end), self.centre)
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

    def _rides(self, name: str) -> bool:
        point = self.sorts[name] == "point"
        off = self.solved.values[name] - self._moved(self.m.home.values[name], point)
        return bool(np.abs(off).max() <= _STAYS * (self.size if point else 1.0))

    def _carried(self, value: Floats, point: bool) -> Vector:
        """A place at home where the platform carries it, on the tape."""
        v = exact(value)
        if not point:
            return turned(self.turn, v)
        return add(turned(self.turn, sub(v, self.centre)), add(self.centre, self.shift))

    def _place(self, name: str) -> Vector:
        home, point = self.m.home.values[name], self.sorts[name] == "point"
        if self._stays(name):
            return exact(home)
        if self._rides(name):
            return self._carried(home, point)
        limb = next((a.limb for a in self.m.attachments.get(name, ()) if a.link == 1), None)
        roads: list[Callable[[], Vector]] = [lambda: self._first(name, limb)] if limb is not None else []
        if not point:
            roads += [lambda: self._bar(name), lambda: self._normal(name)]
        for road in roads:
            with suppress(NoForm):
                return road()
        raise NoForm(f"{name} is carried by several joints")

    def _bar(self, name: str) -> Vector:
        """A direction from a point that a first joint carries to one of the platform."""
        along = self.m.home.values[name]
        for near, values in self.solved.values.items():
            if self.sorts.get(near) == "point":
                far = self.m.home.values[near] + along
                off = values + self.solved.values[name] - self._moved(far, point=True)
                if np.abs(off).max() <= _STAYS * self.size:
                    return sub(self._carried(far, point=True), self.at(near))
        raise NoForm(f"{name} is carried by several joints")

    def _normal(self, name: str) -> Vector:
        """A direction that stays perpendicular to two others, or to bars between points."""
        here, home = self.solved.values[name], self.m.home.values[name]
        level: list[tuple[tuple[str, ...], Floats]] = []
        for one in self._ends():
            if name not in one:
                along = self._along(one, self.solved.values)
                size = np.linalg.norm(along, axis=-1) * np.linalg.norm(home)
                if np.abs((along * here).sum(axis=-1)).max() <= _STAYS * size.min(initial=np.inf):
                    level.append((one, self._along(one, self.m.home.values)))
        self.open.add(name)
        try:
            for (one, u), (other, v) in combinations(level, 2):
                normal = np.cross(u, v)
                if np.linalg.norm(normal) <= _APART * np.linalg.norm(u) * np.linalg.norm(v):
                    continue
                with suppress(NoForm):
                    found = cross(self._between(one), self._between(other))
                    sign = 1 if normal @ home > 0 else -1
                    length = Fraction(float(np.linalg.norm(home))) * sign
                    return scaled(found, inverse(root(dot(found, found))) * length)
        finally:
            self.open.discard(name)
        raise NoForm(f"{name} is perpendicular to no two others")

    def _ends(self) -> Iterator[tuple[str, ...]]:
        """Directions, and pairs of points."""
        yield from ((n,) for n, sort in self.sorts.items() if sort == "direction")
        yield from combinations((n for n, sort in self.sorts.items() if sort == "point"), 2)

    @staticmethod
    def _along(ends: Sequence[str], values: Mapping[str, Floats]) -> Floats:
        return values[ends[0]] if len(ends) == 1 else values[ends[1]] - values[ends[0]]

    def _between(self, ends: Sequence[str]) -> Vector:
        if self.open & set(ends):
            raise NoForm("a circle")
        return self.at(ends[0]) if len(ends) == 1 else sub(self.at(ends[1]), self.at(ends[0]))

    def _first(self, name: str, limb: int) -> Vector:
        """What a limb's first joint carries, held at its distance from, or angle with, what rides on the platform."""
        point = self.sorts[name] == "point"
        chain = self.m.home.chains[limb]
        screw, home = chain.screws[0], self.m.home.values[name]
        axis = screw[:3]
        if point:
            held = next(self._held(name), None)
            if held is None:
                return self._slid(name, screw)
            far, length = self._carried(held, point=True), np.linalg.norm(held - home)
            if not axis.any():
                along, off = exact(screw[3:]), sub(exact(home), far)
                c = dot(off, off) - _fraction(length**2)
                step = self.roots.slid(dot(along, off), c, float(length))
                return add(exact(home), scaled(along, step))
            foot = np.cross(axis, screw[3:])
            middle = foot + axis * (axis @ (home - foot))
            radius = home - middle
            across = np.cross(axis, radius)
            c_, u, v = exact(middle), exact(radius), exact(across)
            e = sub(far, c_)
            rest = dot(e, e) + _fraction(radius @ radius - length**2)
            cosine, sine = self.roots.turned(dot(e, u) * -2, dot(e, v) * -2, rest)
            return add(c_, add(scaled(u, cosine), scaled(v, sine)))
        if not axis.any():
            raise NoForm(f"{name} does not turn")
        other = next((n for n in self._angled(name)), None)
        if other is None:
            raise NoForm(f"{name} keeps no angle with the platform")
        w, middle = self.at(other), axis * (axis @ home)
        u, v = exact(home - middle), exact(np.cross(axis, home))
        rest = dot(exact(middle), w) - _fraction(home @ self.m.home.values[other])
        cosine, sine = self.roots.turned(dot(u, w), dot(v, w), rest)
        return add(exact(middle), add(scaled(u, cosine), scaled(v, sine)))

    def _slid(self, name: str, screw: Floats) -> Vector:
        """A point on a slide that stays with one of the platform in a plane of constant direction."""
        home = self.m.home.values[name]
        for normal in (n for n, sort in self.sorts.items() if sort == "direction" and self._stays(n)):
            n = self.m.home.values[normal] / np.linalg.norm(self.m.home.values[normal])
            for other in (o for o, sort in self.sorts.items() if sort == "point" and self._rides(o)):
                depth = (self.solved.values[other] - self.solved.values[name]) @ n
                if abs(n @ screw[3:]) > _APART and np.abs(depth - depth[0]).max() <= _STAYS * self.size:
                    far = self._carried(self.m.home.values[other], point=True)
                    step = dot(exact(n / (n @ screw[3:])), sub(far, exact(self.m.home.values[other])))
                    return add(exact(home), scaled(exact(screw[3:]), step))
        raise NoForm(f"{name} keeps no distance from the platform")

    def _held(self, name: str) -> Iterator[Floats]:
        """Places at home, on the platform, from which a point keeps its distance; where that is not 0."""
        here, home = self.solved.values[name], self.m.home.values[name]
        for other, sort in self.sorts.items():
            value = self.m.home.values[other]
            if sort == "direction":
                place = home + value  # a bar may lead there
            elif self._rides(other) and not self._stays(other):
                place = value
            else:
                continue
            far = np.linalg.norm(self._moved(place, point=True) - here, axis=1)
            length = np.linalg.norm(place - home)
            if length > _STAYS * self.size and np.abs(far - length).max() <= _STAYS * self.size:
                yield place

    def _angled(self, name: str) -> Iterator[str]:
        """Directions of the platform with which one keeps its angle."""
        here, home = self.solved.values[name], self.m.home.values
        for other, sort in self.sorts.items():
            if sort == "direction" and self._rides(other) and not self._stays(other):
                angle = (here * self.solved.values[other]).sum(axis=1)
                if np.abs(angle - home[name] @ home[other]).max() <= _STAYS:
                    yield other


def _fraction(x: Any) -> Fraction:
    return Fraction(float(x))
