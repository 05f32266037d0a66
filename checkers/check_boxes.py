#!/usr/bin/env python3
r"""Prove the boxes of `gcrules map boxes` again: python checkers/check_boxes.py FILE.json[.gz]

It needs Python alone and shares no code with gcrules. From the file of `gcrules map boxes ... --certificate FILE.json`
it takes a robot, ranges of its coordinates, limits, and a tree of boxes for each tile. Each range is cut into
equal tiles, a tile into halves as its tree says, so that the boxes fill the ranges. Of every box that is not called
undecided it proves anew what it is called, by the means of `check_certificate.py`, which says how, and cuts it further
where its own bounds need that:

* f, g free: no pose of it that is reached within the limits is singular, or has a margin below the one asked for. That
  the determinant has home's sign in f, and the other one in g, is not looked at.
* o outside: none of its poses is reached within the limits.
* x crossed: all its poses are reached within the limits, no limb is singular in it, and the determinant has opposite
  signs at two places of it, so that it is 0 between; or a pose has less than the margin asked for. That poses are
  reached is seen of six rods, and of other robots by the roots that the file has for that (`map_joints.py`).

Exit codes: 0 all boxes are as the file says, and none is undecided; 1 one is not; 2 the file is no certificate of boxes
that is known here, or names another digest; 3 boxes are undecided, by the file or here, and the others are as it says.
All this is recomputed, not proved in Coq.
"""

from __future__ import annotations

import math
import sys
from fractions import Fraction
from itertools import product

from certificate_bounds import Box, Refused, all_inside, least_value, leaves_of
from certificate_joints import Joints
from certificate_rods import Rods
from check_certificate import CUTS, SHARES, asked, proved, robot_of, sign
from map_files import answered, check_digest
from map_joints import check_sizes
from map_slice import Axis, expect, whole

FORMAT = "gcrules boxes certificate 1"
KEYS = {"format", "made by", "title", "question", "geometry", "trees", "shares", "digest"}
ASKED = {"robot", "about", "over", "rest", "limits", "cones", "tilt", "margin"}
INSIDE = 10  # halvings of a box that is to be within the limits
PARTS = 4_000  # of a box, about
MOST = 4_000_000


class Tiles:
    """The tiles of a file, each a box in rad and the file's unit, in the order of their trees."""

    def __init__(self, q):
        over = q["over"]
        expect(isinstance(over, list) and 1 <= len(over) <= 6, "one to six coordinates are expected")
        expect(all(isinstance(r, dict) and "tiles" in r for r in over), "a coordinate without tiles")
        self.counts = [whole(r["tiles"], 1, MOST) for r in over]
        axes = [Axis.of_range({k: v for k, v in r.items() if k != "tiles"}) for r in over]
        length = q["robot"].get("units") or ""
        expect(isinstance(length, str) and length not in ("deg", "rad"), "lengths in another unit")
        expect(all(a.turn or a.unit == length for a in axes), "lengths in another unit")
        self.ends = []
        for axis, count in zip(axes, self.counts):
            unit = math.pi / 180 if axis.unit == "deg" else 1.0
            self.ends.append([float(axis.start + k * axis.step / count) * unit for k in range(count + 1)])
            expect(all(a < b for a, b in zip(self.ends[-1], self.ends[-1][1:])), "tiles that are too small")

    @property
    def number(self):
        return math.prod(self.counts)

    def __iter__(self):
        for place in product(*map(range, self.counts)):
            yield Box(*([ends[k + side] for ends, k in zip(self.ends, place)] for side in (0, 1)))


def crossed(robot, box, margin):
    """Whether a box is seen to be crossed."""
    middle = box.middle
    faces = ([*middle[:k], e[k], *middle[k + 1 :]] for k in range(len(middle)) for e in (box.low, box.high))
    signs = {sign(robot, p) for p in [middle, *faces, *map(list, product(*zip(box.low, box.high)))]}
    if {1, -1} <= signs and all_inside(robot, box, INSIDE):
        return True
    if not margin:
        return False
    _, inside, forces = robot.look(Box(middle, middle))
    return inside and forces is not None and least_value(robot.holds(forces, 0.0)[2]) + 1e-9 < margin


def checked(data, say=None):
    """What is proved, in words, and how many boxes are left undecided, by the file or here. Raises Refused."""
    expect(data.get("format") == FORMAT and set(data) == KEYS, "no certificate of boxes")
    q, trees = data["question"], data["trees"]
    expect(isinstance(q, dict) and set(q) == ASKED and isinstance(q["robot"], dict), "no question")
    expect(isinstance(data["geometry"], dict), "no geometry")
    expect(q["cones"] == [] and q["tilt"] is None, "cones, or a tilt, which maps of boxes do not have")
    margin = q["margin"]
    expect(type(margin) in (int, float) and 0 <= margin < 1, "a margin from 0 to 1 is expected")
    check_digest(data)
    tiles = Tiles(q)
    expect(isinstance(trees, list) and len(trees) == tiles.number, "trees are missing, or too many")
    expect(all(isinstance(tree, str) for tree in trees) and sum(map(len, trees)) <= MOST, "trees, or too many boxes")
    if "rods" not in data["geometry"]:
        check_sizes(data["geometry"])
    robot = robot_of(data)
    seen = robot if isinstance(robot, Rods) else Joints(data, roots=True) if "roots" in data["geometry"] else None
    share, counts, unseen = dict.fromkeys("fgoxu", Fraction(0)), dict.fromkeys("fgoxu", 0), dict.fromkeys("fgox", 0)
    for n, (tree, tile) in enumerate(zip(trees, tiles), 1):
        for _, letter, low, high in leaves_of(tree, tile, share):
            box = Box(low, high)
            counts[letter] += 1
            if letter == "u":
                continue
            if letter == "x":
                unseen["x"] += seen is None or not crossed(seen, box, margin)
            elif not proved(robot, box, margin, letter == "o", CUTS, tile.half, PARTS):
                unseen[letter] += 1
        if say and n % 100 == 0:
            say(f"{n:,} of {tiles.number:,} tiles")
    shares = {SHARES[k]: part / tiles.number for k, part in share.items()}
    expect(isinstance(data["shares"], dict) and set(data["shares"]) == set(shares), "no shares")
    if any(abs(float(part) - data["shares"][name]) > 1e-9 for name, part in shares.items()):
        raise Refused("the shares claimed are not those of the boxes")
    left = counts["u"] + sum(unseen.values())
    return words(robot, q, counts, unseen, share, tiles.number, data["digest"]), left


def words(robot, q, counts, unseen, share, number, digest):
    def part(letters):
        boxes = sum(counts[k] - unseen.get(k, 0) for k in letters)
        return f"{boxes:,} boxes"

    undecided = f"{counts['u']:,} boxes, {float(share['u'] / number):.4%} of the ranges" if counts["u"] else "none"
    below = f", or has a margin below {q['margin']}" if q["margin"] else ""
    lines = [
        f"proved again: {part('fg')} free, {part('o')} outside, {part('x')} crossed, undecided: {undecided}",
        *(
            f"NOT decided here: {n:,} boxes that are called {SHARES[k]}; nothing speaks against it, and nothing for it"
            for k, n in unseen.items()
            if n
        ),
        f"  free: no pose reached within the limits is singular{below}; outside: no pose is reached within them",
        f"  crossed: some pose is singular{below}; the boxes fill the ranges",
        "  in floats, with bounds of all that they leave out; recomputed, not proved in Coq",
        asked(robot, q),
        f"digest {digest}",
    ]
    return "\n".join(lines)


def main():
    return answered("Prove the boxes of gcrules map boxes again.", checked, (FORMAT,))


if __name__ == "__main__":
    sys.exit(main())
