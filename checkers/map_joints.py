r"""The cells of a map of a robot of joints, for `check_map.py`: from closed forms of its limbs, in boxes.

The file has the robot as certificates of ranges have it: six rods (`certificate_rods`), or the screws of its joints
with closed forms, as programs, of each limb's wrenches, and with the roots that exist just where home's solutions of
all limbs do (`certificate_joints`; these are compared with the joints at samples, which does not prove them).

* A pose is reached where all roots exist. That it is on home's branch is proved by a way: straight from home to the
  node nearest to it, and from there from node to node, along edges in whose boxes all roots exist and no limb is
  singular. What closed forms that are analytic there say near home they say at the end of such a way, too.
* A cell is free where this way leads to its corners, and in boxes that fill it all roots exist and the matrix of the
  wrenches is regular. A box in which a root does not exist is a hole, and the cell is not free.
* A cell is crossed where its corners are reached so, and the determinant has both signs at the ends of such an edge of
  it: between them a pose is singular.
* A cell is outside where a root does not exist at a corner of it.
"""

from __future__ import annotations

import math
import random
from collections import deque
from itertools import product

from certificate_bounds import NAMES, Box, Refused, sign_of
from certificate_joints import OPERATIONS, PLACES, Joints
from certificate_rods import Rods
from map_cells import counted, listed_cells, named
from map_files import check_digest
from map_slice import MOST_CELLS, Axis, Malformed, exact, expect

FORMAT = "gcrules map certificate of joints 1"
WORDS = {"f": "free", "x": "crossed", "u": "undecided", "o": "outside"}
MEANS = (
    "free: home's working mode reaches all poses, and none is singular; crossed: some pose of it is singular",
    "outside: a corner is not reached in home's working mode; the cells cover the slice",
    "in floats, with bounds of all that they leave out; recomputed, not proved in Coq; limits are not considered",
)
FOUND = {**WORDS, "o": "not reached in a part of it", "r": "reached at all its corners"}
KEYS = {"format", "made by", "title", "question", "geometry", "cells", "claim", "digest"}
ASKED = {"robot", "about", "over", "rest", "limits", "cones", "tilt"}
CUTS, PARTS, WAY = 10, 300, 10  # halvings of a cell, parts of it at once, halvings of the way from home
EDGE = 5  # halvings of an edge
MOST = 64  # limbs, and joints of each


class JointRanges:
    """The robot and the coordinates of a file with these names, from `least` to `most` of them."""

    over = ()

    def __init__(self, data, names, least, most, numbered=False):
        expect(set(data) == names, "names are missing, or there are too many")
        q, geometry = data["question"], data["geometry"]
        expect(isinstance(q, dict) and set(q) == ASKED and isinstance(geometry, dict), "no question, or no geometry")
        expect(q["limits"] is None and q["cones"] == [] and q["tilt"] is None, "limits, which are not considered here")
        expect(isinstance(q["robot"], dict) and isinstance(q["rest"], dict), "no robot, or no rest of the pose")
        over = q["over"]
        expect(isinstance(over, list) and least <= len(over) <= most, f"{least} to {most} axes are expected")
        every, turning = self._known(geometry)
        self.axes = [Axis.of_range(r, numbered, turning) for r in over]
        length = q["robot"].get("units") or ""
        expect(isinstance(length, str) and len(length) < 13 and (length.isalnum() or not length), "no unit")
        expect(length not in ("deg", "rad"), "lengths in another unit")
        names = [a.name for a in self.axes]
        expect(len(set(names)) == len(names) and (turning or set(names) <= set(NAMES)), "a coordinate twice, or none")
        expect(all(a.turn or a.unit == length for a in self.axes), "lengths in another unit")
        self.rest = q["rest"]
        expect(all(type(v) is float and math.isfinite(v) for v in self.rest.values()), "no rest of the pose")
        expect(isinstance(every, list) and sorted([*names, *self.rest]) == sorted(every), "other coordinates")
        try:
            self.robot = self._robot(data, every)
        except (KeyError, TypeError, IndexError, AttributeError, ValueError, ArithmeticError) as fault:
            raise Malformed(f"no robot of joints that is known here ({type(fault).__name__})") from None
        self.units = [math.pi / 180 if a.unit == "deg" else 1.0 for a in self.axes]

    def _known(self, geometry):
        """The names of all coordinates, and of actuators which of them turn."""
        return (list(NAMES) if "rods" in geometry else geometry.get("names")), None

    def _robot(self, data, every):
        if "rods" in data["geometry"]:
            return Rods(data)
        check_sizes(data["geometry"])
        return Joints(data, roots=True)

    def at(self, k, node):
        """A coordinate at a node, in rad or the file's unit."""
        return float(self.axes[k].start + node * self.axes[k].step) * self.units[k]

    def box(self, low, high):
        """The poses between two nodes."""
        return Box(*([self.at(k, n) for k, n in enumerate(ends)] for ends in (low, high)))

    def pose(self, place):
        """All coordinates at a place of those of the axes, by name."""
        return {**self.rest, **{a.name: c for a, c in zip(self.axes, place)}}

    def words(self):
        turns = f"turned about {' '.join(map(str, self.robot.centre))}"
        rest = ", ".join(f"{n} {v}" for n, v in self.rest.items())
        limbs = joint_words(self.robot) if hasattr(self.robot, "limbs") else []
        at = [f"at {rest} (rad, or the file's unit)"] if rest else []
        return [self.robot.words, *limbs, turns, *self.over, *at]


class JointSlice(JointRanges):
    """The robot and the grid of a map."""

    def __init__(self, data):
        super().__init__(data, KEYS, 2, 3, numbered=True)
        self.digest = data["digest"]
        self.over = [f"over {', '.join(a.words for a in self.axes)}"]
        self.shape = tuple(a.cells for a in self.axes)
        expect(math.prod(self.shape) <= MOST_CELLS, f"more than {MOST_CELLS:,} cells")


def joint_words(robot):
    """The joints of each limb at home with what moves them, and its end."""
    for k, limb in enumerate(robot.limbs):
        driven = {a["coordinate"]: f"driven: {a['name']!r}" for a in robot.actuators if a["limb"] == k}
        known = dict.fromkeys(limb["held"], "held") | driven
        first, joints = {}, []
        for n, (s, c, sign) in enumerate(zip(limb["screws"], limb["coordinates"], limb["signs"]), 1):
            word = f"turn or screw {numbers(s[:3])}; {numbers(s[3:])}" if any(s[:3]) else f"slide {numbers(s[3:])}"
            as_joint = f" as joint {first[c]}" if c in first else ""
            notes = [known[c]] if c in known else []
            notes += [f"moves {sign:g} times{as_joint}"] if as_joint or sign != 1 else []
            first.setdefault(c, n)
            joints.append(f"{word} ({', '.join(notes)})" if notes else word)
        yield f"limb to {numbers(limb['end'])} by {', '.join(joints)}"
    yield f"lengths in parts of {robot.size:.6g}"


def numbers(values):
    return " ".join(f"{v:.6g}" for v in values)


def check_sizes(geometry, programs=("wrenches", "amounts", "roots")):
    """Joints, limbs and constants that are not endless."""
    limbs = geometry.get("limbs")
    expect(isinstance(limbs, list) and 0 < len(limbs) <= MOST, "no limbs, or too many")
    for limb in limbs:
        known = isinstance(limb, dict) and all(isinstance(limb.get(n), list) for n in ("screws", "coordinates", "end"))
        expect(known and 0 < len(limb["screws"]) <= MOST, "no joints, or too many")
        expect(
            all(isinstance(v, list) and len(v) == n for v, n in ((limb["end"], 3), *((s, 6) for s in limb["screws"]))),
            "a screw or a point",
        )
        expect(all(type(c) is int and 0 <= c < MOST for c in limb["coordinates"]), "a coordinate of a joint")
    for name in programs:
        program = geometry.get(name)
        for line in [] if program is None else [*program["lines"], program["results"]]:
            for part in line:
                expect(
                    part in OPERATIONS or part == "input" or type(part) is int or exact(part) is not None, "a program"
                )


class Cells:
    """What is seen of the nodes, edges and cells of a slice."""

    def __init__(self, s, say=None):
        self.s, self.robot, self.say = s, s.robot, say
        self.free, self.nodes, self.edges = set(), {}, {}
        self._blocks()
        self.joined = self._joined()

    def _blocks(self):
        """Notes free cells, and nodes that are not reached: large blocks first."""
        waiting, count = [((0,) * len(self.s.shape), self.s.shape)], 0
        while waiting:
            low, width = waiting.pop()
            count += 1
            if self.say and count % 1000 == 0:
                self.say(f"{count:,} blocks of cells looked at")
            outside, _, forces = self.robot.look(self.s.box(low, [a + b for a, b in zip(low, width)]))
            if outside:
                self.nodes.update(dict.fromkeys(product(*(range(a, a + b + 1) for a, b in zip(low, width))), "o"))
            elif forces is not None and self.robot.holds(forces, 0.0)[0]:
                self.free.update(product(*(range(a, a + b) for a, b in zip(low, width))))
            elif max(width) > 1:
                k = width.index(max(width))
                half = width[k] // 2
                for start, size in ((0, half), (half, width[k] - half)):
                    waiting.append(((*low[:k], low[k] + start, *low[k + 1 :]), (*width[:k], size, *width[k + 1 :])))

    def corners(self, cell):
        return [tuple(a + b for a, b in zip(cell, d)) for d in product((0, 1), repeat=len(cell))]

    def node(self, place):
        """o where home's solutions do not exist at a node, d where they do, u where neither is seen."""
        if place not in self.nodes:
            outside, _, forces = self.robot.look(self.s.box(place, place))
            self.nodes[place] = "o" if outside else "u" if forces is None else "d"
        return self.nodes[place]

    def sign(self, place):
        """Of the determinant at a node; 0 where it is not known, or there is none."""
        outside, _, forces = self.robot.look(self.s.box(place, place))
        if outside or forces is None:
            return 0
        fine, _, rows = self.robot.holds(forces, 0.0)
        return sign_of(rows) if fine and len(rows) == len(rows[0]) else 0

    def edge(self, low, high):
        """Whether home's solutions exist along an edge, and no limb is singular there."""
        if (low, high) not in self.edges:
            self.edges[low, high] = exists(self.robot, self.s.box(low, high), EDGE)
        return self.edges[low, high]

    def _joined(self):
        """The nodes to which a way leads from home."""
        s = self.s
        start = tuple(max(0, min(round(-a.start / a.step), a.cells)) for a in s.axes)
        there = s.pose([s.at(k, n) for k, n in enumerate(start)])
        if not way_exists(self.robot, there):
            return set()
        found, waiting = {start}, deque([start])
        while waiting:
            one = waiting.popleft()
            for k in range(len(one)):
                for step in (-1, 1):
                    other = (*one[:k], one[k] + step, *one[k + 1 :])
                    if other in found or not 0 <= other[k] <= s.shape[k]:
                        continue
                    low, high = sorted((one, other))
                    if self._beside_free(low, k) or (self.node(other) == "d" and self.edge(low, high)):
                        found.add(other)
                        waiting.append(other)
        return found

    def _beside_free(self, low, k):
        """Whether an edge, from a node along the axis k, belongs to a free cell."""
        sides = [(0,) if j == k else (0, -1) for j in range(len(low))]
        return any(tuple(a + b for a, b in zip(low, d)) in self.free for d in product(*sides))

    def crossed(self, cell):
        """Whether the determinant has both signs at the ends of an edge of a cell."""
        for one in self.corners(cell):
            for k in range(len(cell)):
                other = (*one[:k], one[k] + 1, *one[k + 1 :])
                if one[k] == cell[k] and self.edge(one, other) and self.sign(one) * self.sign(other) < 0:
                    return True
        return False

    def filled(self, cell):
        """f where a cell is filled with boxes in which the wrenches are regular, o where a part of it is not reached, u
        where neither is seen.
        """
        boxes = [self.s.box(cell, [k + 1 for k in cell])]
        widths = boxes[0].half
        for _ in range(CUTS * len(cell)):
            left = []
            for box in boxes:
                outside, _, forces = self.robot.look(box)
                if outside:
                    return "o"
                fine, parts = False, None
                if forces is not None:
                    fine, parts, _ = self.robot.holds(forces, 0.0)
                if not fine:
                    wide = parts or [h / w for h, w in zip(box.half, widths)]
                    left += box.cut(wide.index(max(wide)))
            if not left:
                return "f"
            boxes = left
            if len(boxes) > PARTS:
                break
        return "u"

    def seen(self, cell, letter):
        """What a cell is that a file gives this letter: one of `FOUND`, u where it is not seen."""
        corners = self.corners(cell)
        if cell not in self.free and any(self.node(c) == "o" for c in corners):
            return "o"
        if any(c not in self.joined for c in corners):
            return "u"
        if letter == "o":
            return "r"
        if cell in self.free:
            return "f"
        if self.crossed(cell):
            return "x"
        found = self.filled(cell) if letter in "fx" else "u"
        return "u" if found == "o" and letter == "x" else found  # beside a hole it may be crossed all the same


def exists(robot, box, cuts):
    """Whether home's solutions exist in all of a box, and no limb is singular there."""
    outside, _, forces = robot.look(box)
    if outside:
        return False
    if forces is not None and robot.steady(forces):
        return True
    return cuts > 0 and all(exists(robot, part, cuts - 1) for part in box.cut(box.half.index(max(box.half))))


def way_exists(robot, pose):
    """Whether home's solutions exist on the straight way from home to a pose, in boxes around its parts."""
    whole, names = robot.over()
    waiting = [(0.0, 1.0, WAY)]
    while waiting:
        first, last, cuts = waiting.pop()
        ends = [[t * pose[n] for n in names] for t in (first, last)]
        outside, _, forces = whole.look(Box(list(map(min, *ends)), list(map(max, *ends))))
        if outside or not (forces is not None and whole.steady(forces)):
            if outside or not cuts:
                return False
            middle = (first + last) / 2
            waiting += [(first, middle, cuts - 1), (middle, last, cuts - 1)]
    return True


def samples(cells, letters):
    """Raises Refused where the loops of the joints say something else at places of free cells, and at corners that are
    not reached: there they are closed by Newton's method, as far as ways from home lead.
    """
    s, rng = cells.s, random.Random(11)
    if isinstance(s.robot, Rods):  # made from points and axes, without closed forms of the file
        return
    free = [place for place, letter in letters if letter == "f"]
    beyond = [place for place, what in sorted(cells.nodes.items()) if what == "o"]
    for cell in rng.sample(free, min(PLACES, len(free))):
        there = s.pose(s.box(cell, [k + 1 for k in cell]).middle)
        if way_exists(s.robot, there) and not s.robot.reaches(there):
            raise Refused(f"the loops do not close in the cell {named(s.axes, cell)}, which is called free")
    for node in rng.sample(beyond, min(PLACES, len(beyond))):
        s.robot.reaches(s.pose([s.at(k, n) for k, n in enumerate(node)]))


def compared(s, cells, letters, claim, words, found, means, say=None):
    """What is proved of the letters of a file, in words, and how many cells are left undecided, by the file or here;
    `claim` counts them, `words` are those of letters, `found` those of what is seen, `means` what they mean. Raises
    Refused.
    """
    more, unseen = dict.fromkeys(found, 0), dict.fromkeys(words.values(), 0)
    for n, (place, letter) in enumerate(letters, 1):
        if say and n % 1000 == 0:
            say(f"{n:,} of {len(letters):,} cells compared")
        what = cells.seen(place, letter)
        if letter == "u":
            more[what] += 1
        elif what == "u":
            unseen[words[letter]] += 1
        elif what != letter:
            raise Refused(f"the cell {named(s.axes, place)} is called {words[letter]}, and it is {found[what]}")
    left, sure = claim["undecided"], {word: claim[word] - n for word, n in unseen.items() if word != "undecided"}
    known = [f"{more[letter]:,} {word}" for letter, word in words.items() if letter != "u"]
    known[0] = known[0].replace(" free", " are free")
    seen = f" (of which {', '.join(known[:-1])} and {known[-1]}, as is seen here)"
    lines = [
        f"recomputed: {', '.join(f'{n:,} cells {w}' if w == 'free' else f'{n:,} {w}' for w, n in sure.items())}, "
        + f"undecided: {f'{left:,}{seen}' if left else 'none'}",
        *(
            f"NOT decided here: {n:,} cells that are called {word}; nothing speaks against it, and nothing for it"
            for word, n in unseen.items()
            if n
        ),
        *(f"  {line}" for line in (*means, *s.words())),
        f"digest {s.digest}",
    ]
    return "\n".join(lines), left + sum(unseen.values())


def checked_joints(data, say=None):
    """What is proved, in words, and how many cells are left undecided, by the file or here. Raises Refused."""
    s = JointSlice(data)
    check_digest(data)
    letters = list(listed_cells(data["cells"], s.shape, WORDS))
    claim, cells = counted(letters, data["claim"], WORDS), Cells(s, say)
    answer = compared(s, cells, letters, claim, WORDS, FOUND, MEANS, say)
    samples(cells, letters)
    return answer
