#!/usr/bin/env python3
r"""Prove a region of `gcrules free` again: python checkers/check_free.py FILE.json[.gz] [--most N]

It needs Python alone and shares no code with gcrules. From the file that `gcrules free ... --certificate FILE.json`
wrote it takes a robot and a region of poses, a box or a ball of coordinates, and proves anew that none of these poses
is singular. It covers the region with boxes of its own, and halves those that it does not prove. Halves share the face
along which a box is cut, and of a ball only boxes are left out that lie beyond it, which is seen exactly: no gap is
left.

* The platform on six legs is shifted by x, y, z from a pose and turned further by the vector v = (rx, ry, rz): a point
  p of it goes to V R (p - c) + c + t, R the turn of the pose, t its shift plus (x, y, z), V the turn about v by |v|. In
  a box all matrices of the six rows (f, m) are regular, f along a leg and m its moment: `map_turns.py` says how. So no
  leg has length 0 there either.
* Of a robot of joints a box is proved where all roots in its closed forms exist and the matrix of its wrenches is
  regular, and the straight way from home to the middle of the region exists: then home's working mode reaches all poses
  of the region, and holds the platform at each. `map_joints.py` says what closed forms are taken for; the loops of the
  joints are closed at places of the region, too.

A ball is the set of poses whose distances from the middle of the ranges, in parts of half the ranges, have squares that
add up to 1 at most. Lengths of legs, amounts of actuators and their limits do not matter.

Exit codes: 0 no pose of the region is singular; 1 one is, or is not reached; 2 the file is no certificate of a region
that is known here, or names another digest; 3 it is not decided: with N boxes the region is not filled, or one is too
small. All this is recomputed, not proved in Coq.
"""

from __future__ import annotations

import random
import sys
from decimal import Decimal
from fractions import Fraction
from itertools import product

from certificate_bounds import Refused
from certificate_joints import PLACES
from certificate_rods import Rods
from map_files import answered, check_digest
from map_joints import JointRanges, way_exists
from map_slice import Axis, Platform, expect, rotation, vector
from map_turns import Turned

FORMAT, JOINTS = "gcrules free region 1", "gcrules free region of joints 1"
KEYS = {"format", "made by", "title", "shape", "digest"}
LEGS = KEYS | {"unit", "legs", "points", "centre", "pose", "over"}
MOST = 500_000
SMALLEST = Fraction(1, 2**30)  # part of a range
HALF = Fraction(1, 2)


class Legs(Platform):
    """A platform on six legs around a pose, over one to six coordinates."""

    joined, how = True, "no leg has length 0 in it either"

    def __init__(self, data):
        expect(set(data) == LEGS, "names are missing, or there are too many")
        super().__init__(data)
        pose, over = data["pose"], data["over"]
        expect(isinstance(pose, dict) and set(pose) == {"translation", "quaternion"}, "no pose")
        self.around, self.quaternion = vector(pose["translation"]), vector(pose["quaternion"], 4)
        self.shift = [Fraction(0)] * 3  # from there
        self.bases = [[c - t for c, t in zip(base, self.around)] for base in self.bases]
        turn = rotation(self.quaternion)
        self.arms = [[sum(r * c for r, c in zip(row, arm)) for row in turn] for arm in self.arms]
        expect(isinstance(over, list) and 1 <= len(over) <= 6, "one to six coordinates are expected")
        self.axes = [Axis.of_range(r) for r in over]
        self.check(self.axes)
        self.kind, self.angles = "vector", [Fraction(0)] * 3
        turning = {a.unit for a in self.axes if a.turn}
        expect(all(a.turn is None or a.turn[0] == "vector" for a in self.axes), "other turns than by a vector")
        self.unit = turning.pop() if turning else "rad"
        self.turned = Turned(self)

    def look(self, low, width):
        """Whether all poses of a box, in parts of the ranges, are regular; what keeps from it by coordinates."""
        return self.turned.regular(low, width)

    def refuse(self, places):
        """Raises Refused where the determinant has both signs at places of the region."""
        if {1, -1} <= {self.turned.corner(0, place) for place in places}:
            raise Refused("a pose of the region is singular: the determinant has both signs in it")

    def compare(self, ball):
        """Nothing is left to see."""

    def words(self):
        at = f"around {' '.join(map(str, self.around))}, turned by the quaternion {' '.join(map(str, self.quaternion))}"
        return [*super().words(), at]


class Joints(JointRanges):
    """A robot of joints over one to six coordinates from home."""

    how = "home's working mode reaches all poses in it, and the wrenches hold the platform at each"

    def __init__(self, data):
        super().__init__(data, KEYS | {"question", "geometry"}, 1, 6)
        self.joined = way_exists(self.robot, self.pose([self.at(k, HALF) for k in range(len(self.axes))]))

    def look(self, low, width):
        outside, _, forces = self.robot.look(self.box(low, [a + w for a, w in zip(low, width)]))
        if outside:
            raise Refused("home's working mode does not reach a part of the region")
        return self.robot.holds(forces, 0.0)[:2] if forces is not None else (False, None)

    def refuse(self, places):
        """Nothing is known."""

    def compare(self, ball):
        """Raises Refused where the loops of the joints do not close at places of the region, as far as ways lead."""
        rng, n = random.Random(13), len(self.axes)
        for _ in range(0 if isinstance(self.robot, Rods) else PLACES):
            place = [Fraction(rng.randrange(2**20 + 1), 2**20) for _ in range(n)]
            if ball and beyond(place, [0] * n):
                continue
            there = self.pose([self.at(k, c) for k, c in enumerate(place)])
            if way_exists(self.robot, there) and not self.robot.reaches(there):
                raise Refused("the loops do not close at a place of the region")


def beyond(low, width):
    """Whether a box, in parts of the ranges, lies beyond the ball."""
    gaps = [max(a - HALF, HALF - a - w, 0) for a, w in zip(low, width)]
    return sum(c * c for c in gaps) > HALF * HALF


def covered(region, ball, most, say):
    """How many boxes it takes to prove all of a region, and the middle of one that is not proved, if there is one."""
    n = len(region.axes)
    waiting, count = [((Fraction(0),) * n, (Fraction(1),) * n)], 0
    while waiting:
        low, width = waiting.pop()
        if ball and beyond(low, width):
            continue
        count += 1
        if say and count % 2000 == 0:
            say(f"{count:,} boxes looked at, {float(1 - sum_of(waiting)):.4%} of the ranges")
        fine, parts = region.look(low, width)
        if fine:
            continue
        wide = parts if parts and any(c > 0 for c in parts) else width
        k = max(range(n), key=wide.__getitem__)
        if count >= most or width[k] < SMALLEST:
            return count, [a + w / 2 for a, w in zip(low, width)]
        half = (*width[:k], width[k] / 2, *width[k + 1 :])
        waiting += [(low, half), ((*low[:k], low[k] + half[k], *low[k + 1 :]), half)]
    return count, None


def sum_of(boxes):
    """The part of the ranges that boxes fill."""
    found = Fraction(0)
    for _, width in boxes:
        part = Fraction(1)
        for w in width:
            part *= w
        found += part
    return found


def corners(ball, n):
    """Places on the border of a region, and its middle."""
    middle = (HALF,) * n
    if not ball:
        return [middle, *product((Fraction(0), Fraction(1)), repeat=n)]
    return [middle, *((*middle[:k], Fraction(c), *middle[k + 1 :]) for k in range(n) for c in (0, 1))]


def checked(data, say=None, most=MOST):
    """What is proved, in words, and whether a part is left undecided. Raises Refused."""
    expect(data.get("format") in (FORMAT, JOINTS), "no certificate of a region")
    region = (Legs if data["format"] == FORMAT else Joints)(data)
    check_digest(data)
    expect(data["shape"] in ("box", "ball"), "neither a box nor a ball")
    ball = data["shape"] == "ball"
    ranges = ", ".join(f"{a.name} {shown(a.start)}..{shown(a.start + a.step)} {a.unit}".strip() for a in region.axes)
    count, place = covered(region, ball, most, say) if region.joined else (0, None)
    first = f"proved: no pose of this {data['shape']} is singular ({count:,} boxes)"
    if not region.joined:
        first = "NOT decided here: no way from home to the middle is proved"
    elif place is not None:
        region.refuse(corners(ball, len(region.axes)))
        ends = ((a, float(a.start + c * a.step)) for a, c in zip(region.axes, place))
        where = ", ".join(f"{a.name} {c:.6g} {a.unit}".strip() for a, c in ends)
        first = f"NOT decided here: {count:,} boxes do not prove it, one of them around {where}"
    else:
        region.compare(ball)
    lines = [
        "in floats, with bounds of all that they leave out; recomputed, not proved in Coq; limits are not considered",
        f"{data['shape']} over {ranges}",
        *region.words(),
    ]
    lines = [first, *(f"  {line}" for line in ([] if "NOT" in first else [region.how]) + lines)]
    return "\n".join([*lines, f"digest {data['digest']}"]), first.startswith("NOT")


def shown(c):
    """An exact number, with decimals where it has a few of them."""
    return str(c) if 10**15 % c.denominator else f"{Decimal(c.numerator) / c.denominator:f}"


def main():
    return answered("Prove a region of gcrules free again.", checked, (JOINTS,), MOST)


if __name__ == "__main__":
    sys.exit(main())
