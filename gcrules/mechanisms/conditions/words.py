r"""Conditions in the robot's own words: planes of legs, the platform plane, directions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import combinations

from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Superbracket, points_of
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.conditions.at_infinity import INFINITY
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.lines.wrenches import WrenchLine
from gcrules.rules.statement import NOTHING, Part, Statement, listing, of_kind, say

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

    def clause(self, e: Expr) -> Statement:
        """When a factor vanishes; nothing for what has no words here."""
        match e:
            case Bracket(args=args):
                return self._bracket(args)
            case Meet(args=args):
                return self._meet(args)
            case Superbracket(lines=lines) if len(lines) == 6 and all(map(_plain, lines)):
                return say("the lines {} belong to one linear complex", listing(lines))
        return NOTHING

    def _bracket(self, args: Sequence[Expr]) -> Statement:
        if not all(isinstance(a, Point) for a in args):
            return self._couples(args)
        far = [a for a in args if str(a) in self.ideal]
        near = [a for a in args if str(a) not in self.ideal]
        match len(far):
            case 0 if len(args) == 3:
                return say("the points {} are on a line", listing(args))
            case 1 if len(args) == 3:
                return say("the line {} has the direction {}", _side_by_side(near), *far)
            case 2 if len(args) == 3:
                return say("the directions {} are parallel", listing(far))
            case 0:
                return self._flat(near)
            case 1 if self.family.level(list(map(str, near)), str(far[0])):
                return say("the points {} are on a line", listing(near))
            case 1:
                return say("the plane {} contains the direction {}", _side_by_side(near), *far)
            case 2:
                words = "the line {} is parallel to the plane of the directions {}"
                return say(words, _side_by_side(near), listing(far))
        return say("the directions {} are parallel to one plane", listing(far))

    def _flat(self, points: Sequence[Expr]) -> Statement:
        names = set(map(str, points))
        for limb, own in self._limbs():
            apart = [p for p in points if str(p) not in own]
            if len(apart) == 1 and own.issuperset(names - {str(apart[0])}):
                plane = _side_by_side([p for p in points if str(p) in own])
                return say("the point {} lies in the plane {} of {}", *apart, plane, limb)
        return say("the points {} lie in one plane", listing(points))

    def _couples(self, args: Sequence[Expr]) -> Statement:
        """[u1v1A ∧ u2v2, u3, v3, A]: three lines at infinity with a common point."""
        meets = [a for a in args if isinstance(a, Meet)]
        rest = [str(a) for a in args if isinstance(a, Point) and str(a) in self.ideal]
        near = [str(a) for a in args if isinstance(a, Point) and str(a) not in self.ideal]
        if len(meets) != 1 or len(rest) != 2 or len(near) != 1 or len(meets[0].args) != 2:
            return NOTHING
        return self._moments([*([n for n in points_of(a) if n in self.ideal] for a in meets[0].args), rest])

    @staticmethod
    def _moments(pairs: Sequence[Sequence[str]]) -> Statement:
        if any(len(p) != 2 for p in pairs):
            return NOTHING
        ordered = sorted(map(sorted, pairs), key=lambda pair: [_number(n) for n in pair])
        shown = listing(say("{} × {}", Point(a), Point(b)) for a, b in ordered)
        return say("the moments {} of the couples are parallel to one plane", shown)

    def _meet(self, args: Sequence[Expr]) -> Statement:
        far = [a for a in args if a == INFINITY]
        near = [a for a in args if a != INFINITY]
        if all(a.step == 3 and _plain(a) for a in near) and len(near) + len(far) == 4:
            how = "are parallel to one line" if far else "meet in a point (possibly at infinity)"
            return say("{} {}", self._planes(near), how)
        three = self._three_parallel(far, near)
        if three:
            return say("the lines {} are parallel to one plane", listing(three))
        steps = sorted(a.step for a in near)
        if not far and all(map(_plain, near)):
            if steps == [2, 2]:
                return say("the lines {} meet (possibly at infinity)", listing(near))
            if steps == [2, 2, 2]:
                finite = [a for a in near if not set(points_of(a)) <= self.ideal]
                if len(finite) == 2:
                    return say("the lines {} are parallel", listing(finite))
                return say("the lines {} meet in a point or are parallel", listing(near))
            if steps == [2, 3, 3]:
                return self._line_and_planes(near)
        return NOTHING

    def _line_and_planes(self, args: Sequence[Expr]) -> Statement:
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
                shown = listing(
                    _side_by_side([*(Point(n) for n in names if n != o), Point(o)])
                    for names in (*map(points_of, planes), third)
                )
                if o in self.ideal:
                    how = say("are parallel to the direction {}, have a common line (possibly at infinity)", Point(o))
                else:
                    how = say("pass through {}, have a common line", Point(o))
                return say("the planes {}, which {}", shown, how)
        return say("the planes {} and the line {} meet in a point (possibly at infinity)", listing(planes), line)

    @staticmethod
    def _three_parallel(far: Sequence[Expr], near: Sequence[Expr]) -> list[Expr]:
        """The lines f, g and h of π ∧ ((π ∧ f) ∨ g) ∧ h; none for anything else."""
        if len(far) != 1 or len(near) != 2:
            return []
        for plane, h in (near, near[::-1]):
            if isinstance(plane, Join) and plane.step == 3 and isinstance(plane.args[0], Meet):
                inner = [a for a in plane.args[0].args if a != INFINITY]
                if len(inner) == 1 and _plain(inner[0]) and _plain(h):
                    return [inner[0], _side_by_side(plane.args[1:]), h]
        return []

    def _planes(self, planes: Sequence[Expr]) -> Statement:
        """ "the planes of leg 1 (A1S1r1), leg 2 (A2S2r2) and leg 3 (A3S3r3) and the platform plane S1S2S3"."""
        legs: list[tuple[list[int | str], Statement]] = []
        others: list[Part] = []
        bodies: list[Part] = []
        for plane in planes:
            names = set(points_of(plane))
            limbs = self._limbs_of(names)
            if names <= set(self.platform):
                bodies.append(say("the platform plane {}", plane))
            elif names <= set(self.base):
                bodies.append(say("the base plane {}", plane))
            elif limbs:
                legs.append((_number(limbs[0]), say("{} ({})", _together(limbs), plane)))
            else:
                others.append(plane)
        found: list[Part] = []
        if legs:
            ordered = sorted(legs, key=lambda leg: (leg[0], str(leg[1])))
            found.append(say("the plane{} of {}", "s" * (len(legs) > 1), listing(words for _, words in ordered)))
        if others:
            found.append(of_kind("plane", others))
        return listing([*found, *bodies])

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


def _together(limbs: Sequence[str]) -> Statement:
    """ "leg 1", "legs 1 and 2"."""
    if len(limbs) == 1:
        return say("{}", limbs[0])
    heads = {limb.rpartition(" ")[0] for limb in limbs}
    tails = [limb.rpartition(" ")[2] for limb in limbs]
    return say("{}s {}", *heads, listing(tails)) if len(heads) == 1 and "" not in heads else listing(limbs)


def _side_by_side(points: Iterable[Expr]) -> Expr:
    """The flat through points, written in this sequence."""
    return Join(tuple(points))


def _number(name: str) -> list[int | str]:
    """A key that sorts by the number in a name: leg 2 before leg 10."""
    digits = re.sub(r"\D", "", name)
    return [int(digits or 0), name]


def _plain(e: Expr) -> bool:
    return isinstance(e, Point) or (isinstance(e, Join) and all(isinstance(a, Point) for a in e.args))
