r"""Conditions in the robot's own words: planes of legs, the platform plane, directions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Superbracket, points_of
from gcrules.core.english import listed
from gcrules.mechanisms.conditions.at_infinity import INFINITY
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.wrenches import WrenchLine

__all__ = ["RobotWords"]


@dataclass(frozen=True)
class RobotWords:
    """`family` is the robot's, `lines` are those of the equivalent structure, `platform` the points that move, `base`
    the points of the limbs' first joints, `ideal` the directions.
    """

    family: Family
    lines: tuple[WrenchLine, ...]
    platform: tuple[str, ...]
    base: tuple[str, ...]
    ideal: frozenset[str]

    def clause(self, e: Expr) -> str | None:
        """When a factor vanishes, or None for what has no words here."""
        match e:
            case Bracket(args=args):
                return self._bracket(args)
            case Meet(args=args):
                return self._meet(args)
            case Superbracket(lines=lines) if len(lines) == 6 and all(map(_plain, lines)):
                return f"the lines {listed([str(line) for line in lines])} belong to one linear complex"
        return None

    def _bracket(self, args: Sequence[Expr]) -> str | None:
        if not all(isinstance(a, Point) for a in args):
            return self._couples(args)
        names = [str(a) for a in args]
        far = [n for n in names if n in self.ideal]
        near = [n for n in names if n not in self.ideal]
        match len(far):
            case 0 if len(names) == 3:
                return f"the points {listed(names)} are on a line"
            case 1 if len(names) == 3:
                return f"the line {''.join(near)} has the direction {far[0]}"
            case 2 if len(names) == 3:
                return f"the directions {listed(far)} are parallel"
            case 0:
                return self._flat(near)
            case 1 if self.family.level(near, far[0]):
                return f"the points {listed(near)} are on a line"
            case 1:
                return f"the plane {''.join(near)} contains the direction {far[0]}"
            case 2:
                return f"the line {''.join(near)} is parallel to the plane of the directions {listed(far)}"
        return f"the directions {listed(far)} are parallel to one plane"

    def _flat(self, names: Sequence[str]) -> str:
        limbs = [limb for limb, own in self._limbs() if any(own.issuperset(set(names) - {n}) for n in names)]
        for limb in limbs:
            own = dict(self._limbs())[limb]
            apart = [n for n in names if n not in own]
            if len(apart) == 1:
                plane = "".join(n for n in names if n in own)
                return f"the point {apart[0]} lies in the plane {plane} of {limb}"
        return f"the points {listed(names)} lie in one plane"

    def _couples(self, args: Sequence[Expr]) -> str | None:
        """[u1v1A ∧ u2v2, u3, v3, A]: three lines at infinity with a common point."""
        meets = [a for a in args if isinstance(a, Meet)]
        rest = [str(a) for a in args if isinstance(a, Point) and str(a) in self.ideal]
        near = [str(a) for a in args if isinstance(a, Point) and str(a) not in self.ideal]
        if len(meets) != 1 or len(rest) != 2 or len(near) != 1 or len(meets[0].args) != 2:
            return None
        return self._moments([*([n for n in points_of(a) if n in self.ideal] for a in meets[0].args), rest])

    @staticmethod
    def _moments(pairs: Sequence[Sequence[str]]) -> str | None:
        if any(len(p) != 2 for p in pairs):
            return None
        shown = [f"{a} × {b}" for a, b in sorted(map(sorted, pairs), key=lambda pair: [_number(n) for n in pair])]
        return f"the moments {listed(shown)} of the couples are parallel to one plane"

    def _meet(self, args: Sequence[Expr]) -> str | None:
        far = [a for a in args if a == INFINITY]
        near = [a for a in args if a != INFINITY]
        if all(a.step == 3 and _plain(a) for a in near) and len(near) + len(far) == 4:
            how = "are parallel to one line" if far else "meet in a point (possibly at infinity)"
            return f"{self._planes(near)} {how}"
        three = self._three_parallel(far, near)
        if three:
            return f"the lines {listed(three)} are parallel to one plane"
        steps = sorted(a.step for a in near)
        if not far and all(map(_plain, near)):
            if steps == [2, 2]:
                return f"the lines {listed([str(a) for a in near])} meet (possibly at infinity)"
            if steps == [2, 2, 2]:
                finite = [a for a in near if not set(points_of(a)) <= self.ideal]
                if len(finite) == 2:
                    return f"the lines {listed([str(a) for a in finite])} are parallel"
                return f"the lines {listed([str(a) for a in near])} meet in a point or are parallel"
            if steps == [2, 3, 3]:
                return self._line_and_planes(near)
        return None

    def _line_and_planes(self, args: Sequence[Expr]) -> str:
        planes = [a for a in args if a.step == 3]
        (line,) = (a for a in args if a.step == 2)
        if set(points_of(line)) <= self.ideal:
            couples = self._moments([[n for n in points_of(a) if n in self.ideal] for a in args])
            if couples:
                return couples
        common = set(points_of(planes[0])) & set(points_of(planes[1]))
        if len(common) == 1:
            (o,) = common
            third = [*points_of(line)]
            if o not in third and all(len(points_of(p)) == 3 for p in planes):
                shown = [f"{''.join(n for n in names if n != o)}{o}" for names in (*map(points_of, planes), third)]
                if o in self.ideal:
                    how = f"are parallel to the direction {o}, have a common line (possibly at infinity)"
                    return f"the planes {listed(shown)}, which {how}"
                return f"the planes {listed(shown)}, which pass through {o}, have a common line"
        return (
            f"the planes {listed([str(p) for p in planes])} and the line {line} meet in a point (possibly at infinity)"
        )

    @staticmethod
    def _three_parallel(far: Sequence[Expr], near: Sequence[Expr]) -> list[str] | None:
        """π ∧ ((π ∧ f) ∨ g) ∧ h."""
        if len(far) != 1 or len(near) != 2:
            return None
        for plane, h in (near, near[::-1]):
            if isinstance(plane, Join) and plane.step == 3 and isinstance(plane.args[0], Meet):
                inner = [a for a in plane.args[0].args if a != INFINITY]
                g = "".join(map(str, plane.args[1:]))
                if len(inner) == 1 and _plain(inner[0]) and _plain(h):
                    return [str(inner[0]), g, str(h)]
        return None

    def _planes(self, planes: Sequence[Expr]) -> str:
        """ "the planes of leg 1 (A1S1r1), leg 2 (A2S2r2) and leg 3 (A3S3r3) and the platform plane S1S2S3"."""
        legs: list[tuple[list[int | str], str]] = []
        others: list[str] = []
        bodies: list[str] = []
        for plane in planes:
            names = set(points_of(plane))
            limbs = self._limbs_of(names)
            if names <= set(self.platform):
                bodies.append(f"the platform plane {plane}")
            elif names <= set(self.base):
                bodies.append(f"the base plane {plane}")
            elif limbs:
                legs.append((_number(limbs[0]), f"{_together(limbs)} ({plane})"))
            else:
                others.append(str(plane))
        found = []
        if legs:
            found.append(f"the plane{'s' * (len(legs) > 1)} of {listed([text for _, text in sorted(legs)])}")
        if others:
            found.append(f"the plane{'s' * (len(others) > 1)} {listed(others)}")
        return listed([*found, *bodies])

    def _limbs_of(self, names: set[str]) -> list[str]:
        """The limb whose points these are, or two limbs whose lines meet and span the plane."""
        limbs = list(self._limbs())
        for limb, own in limbs:
            if names <= own:
                return [limb]
        for (one, own), (two, other) in combinations(limbs, 2):
            if names == own | other and own & other:
                return [one, two]
        return []

    def _limbs(self) -> Iterable[tuple[str, set[str]]]:
        """Each limb with all points of its lines."""
        found: dict[str, set[str]] = {}
        for line in self.lines:
            found.setdefault(line.limb, set()).update(line.ends)
        return found.items()


def _together(limbs: Sequence[str]) -> str:
    """ "leg 1", "legs 1 and 2"."""
    if len(limbs) == 1:
        return limbs[0]
    heads = {limb.rpartition(" ")[0] for limb in limbs}
    tails = [limb.rpartition(" ")[2] for limb in limbs]
    return f"{heads.pop()}s {listed(tails)}" if len(heads) == 1 and "" not in heads else listed(limbs)


def _number(name: str) -> list[int | str]:
    """A key that sorts by the number in a name: leg 2 before leg 10."""
    digits = re.sub(r"\D", "", name)
    return [int(digits or 0), name]


def _plain(e: Expr) -> bool:
    return isinstance(e, Point) or (isinstance(e, Join) and all(isinstance(a, Point) for a in e.args))
