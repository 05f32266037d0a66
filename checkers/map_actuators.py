r"""The cells of a map of a robot of joints over amounts of its actuators, for `check_map.py`.

The file has the robot at home: six rods between points, or the screws of its joints. Where the actuators take it is
not told by closed forms: its loops are closed by Newton's method, and `certificate_driven.py` proves that in a box of
amounts there is one solution near by, and a continuous one, with no singular configuration among them.

* Home is solved by definition, all amounts being 0. A node is reached where such boxes lead to it: straight from home
  to the node nearest to it, and on through free cells and along edges, each box having a solution in common with the
  one before.
* A cell is free where boxes fill it, all those that are neighbours have solutions in common where they meet, and one of
  them has that of a corner that is reached.
* A cell is crossed where along an edge of it, from a corner that is reached, home's branch comes to a singular
  configuration: the curve of solutions over the edge goes on, and beyond it the determinant has the other sign.
* Nothing else is proved. That home's branch does not reach a cell is told by nobody. Of a cell that is called free and
  is not seen to be so, nothing is said, since the branch may have several sheets.
"""

from __future__ import annotations

from collections import deque
from itertools import product

from certificate_driven import DrivenJoints, DrivenRods
from certificate_ends import turns_back
from map_cells import counted, listed_cells
from map_files import check_digest
from map_joints import JointSlice, check_sizes, compared
from map_slice import expect

DRIVEN = "gcrules map certificate of actuators 1"
WORDS = {"f": "free", "x": "crossed", "u": "undecided"}
MEANS = (
    "free: for all amounts home's branch has a configuration, and none of these is singular",
    "crossed: home's branch ends in the cell, at a singular configuration",
    "the cells cover the slice; other configurations for the same amounts are not considered",
    "in floats, with bounds of all that they leave out; recomputed, not proved in Coq; limits are not considered",
)
PARTS = {"f": (1, 2, 4, 8), "x": (1, 2, 4, 8), "u": (1, 2)}  # along each side of a cell
CUTS = {"home": 12, "edge": 4}  # halvings of ways


class ActuatorSlice(JointSlice):
    """The robot and the grid of a map over actuators."""

    def _known(self, geometry):
        listed = geometry.get("rods") or geometry.get("actuators")
        expect(isinstance(listed, list) and all(isinstance(a, dict) for a in listed), "no actuators")
        if "rods" in geometry:
            turning = {a.get("actuator"): a.get("drive") == "turn" for a in listed}
        else:
            turning = {a.get("name"): a.get("turns") for a in listed}
        expect(len(turning) == len(listed) and all(isinstance(n, str) for n in turning), "an actuator twice, or none")
        expect(all(type(t) is bool for t in turning.values()), "actuators of which it is not told whether they turn")
        return list(turning), turning

    def _robot(self, data, every):
        if "rods" in data["geometry"]:
            return DrivenRods(data, every)
        check_sizes(data["geometry"], ())
        return DrivenJoints(data["geometry"], every)

    def amounts(self, place):
        """All amounts at a place counted in cells."""
        known = self.pose([self.at(k, n) for k, n in enumerate(place)])
        return [known[n] for n in self.robot.names]


class DrivenCells:
    """What is seen of the nodes and cells of a slice; `letters` are those of the file, by cells."""

    def __init__(self, s, letters, say=None):
        self.s, self.robot, self.letters, self.say = s, s.robot, letters, say
        self.free, self.tried, self.nodes, self.ends = set(), set(), {}, {}
        start = tuple(max(0, min(round(-a.start / a.step), a.cells)) for a in s.axes)
        home = self.robot.place([0.0] * len(self.robot.names), [0.0] * len(self.robot.unknown))
        there = None if home is None else self.robot.way(home, s.amounts(start), CUTS["home"])
        if there is not None:
            self._spread(start, there)

    def _spread(self, start, there):
        """Notes free cells and nodes that are reached: through free cells first, then along edges."""
        waiting, later = deque([start]), deque()
        self.nodes[start] = there
        while waiting or later:
            if not waiting:
                one, other = later.popleft()
                if other not in self.nodes:
                    found = self.robot.way(self.nodes[one], self.s.amounts(other), CUTS["edge"])
                    if found is not None:
                        self.nodes[other] = found
                        waiting.append(other)
                continue
            node = waiting.popleft()
            for back in product((0, 1), repeat=len(node)):
                cell = tuple(a - b for a, b in zip(node, back))
                if cell in self.letters and cell not in self.free and (cell, node) not in self.tried:
                    self.tried.add((cell, node))
                    for other, place in (self._filled(cell, node) or {}).items():
                        if other not in self.nodes:
                            self.nodes[other] = place
                            waiting.append(other)
            for k, step in product(range(len(node)), (-1, 1)):
                other = (*node[:k], node[k] + step, *node[k + 1 :])
                if other not in self.nodes and 0 <= other[k] <= self.s.shape[k]:
                    later.append((node, other))

    def _filled(self, cell, node):
        """The places of the corners of a cell that boxes fill, beginning with those of a corner that is reached; None
        where that is not proved.
        """
        for number in PARTS[self.letters[cell]]:
            boxes = self._parts(cell, node, number)
            if boxes is None:
                continue
            corners = {}
            for side in product((0, 1), repeat=len(cell)):
                other = tuple(a + b for a, b in zip(cell, side))
                box = boxes[tuple(b * (number - 1) for b in side)]
                q = self.s.amounts(other)
                near = box.at(q)
                place = None if near is None else self.robot.place(q, near)
                if place is None or not box.holds(place):
                    break
                corners[other] = place
            else:
                self.free.add(cell)
                if self.say and len(self.free) % 100 == 0:
                    self.say(f"{len(self.free):,} cells are free")
                return corners
        return None

    def _parts(self, cell, node, number):
        """Boxes of equal parts of a cell whose solutions all go on from that of a node; None where they do not."""
        first = tuple((a - b) * (number - 1) for a, b in zip(node, cell))
        boxes, waiting = {}, deque([(first, self.nodes[node])])
        while waiting:
            part, place = waiting.popleft()
            box = boxes.get(part)
            if box is None:
                ends = [[c + (k + d) / number for c, k in zip(cell, part)] for d in (0, 1)]
                box = boxes[part] = self._box(*ends, place)
                if box is None:
                    return None
                new = True
            else:
                new = False
            if not box.holds(place):
                return None
            if not new:
                continue
            for k, step in product(range(len(part)), (0, 1)):
                other = (*part[:k], part[k] + 2 * step - 1, *part[k + 1 :])
                if not 0 <= other[k] < number:
                    continue
                middle = [c + (n + 0.5) / number for c, n in zip(cell, part)]
                middle[k] = cell[k] + (part[k] + step) / number
                q = self.s.amounts(middle)
                near = box.at(q)
                shared = None if near is None else self.robot.place(q, near)
                if shared is None or not box.holds(shared):
                    return None
                waiting.append((other, shared))
        return boxes

    def _box(self, low, high, place):
        """The box between two places counted in cells, near another place's solution."""
        a, b = self.s.amounts(low), self.s.amounts(high)
        middle = [(c + d) / 2 for c, d in zip(a, b)]
        ways = []
        for k, (c, d) in enumerate(zip(a, b)):
            if c != d:
                ways.append([(d - c) / 2 if j == k else 0.0 for j in range(len(a))])
        return self.robot.known(middle, ways, place.x)

    def seen(self, cell, letter):
        """f where a cell is free, x where it is crossed, u where neither is seen."""
        if cell in self.free:
            return "f"
        return "x" if letter != "f" and self._crossed(cell) else "u"

    def _crossed(self, cell):
        """Whether home's branch ends on an edge of a cell."""
        for side in product((0, 1), repeat=len(cell)):
            one = tuple(a + b for a, b in zip(cell, side))
            for k in range(len(cell)) if one in self.nodes else ():
                other = (*one[:k], 2 * cell[k] + 1 - one[k], *one[k + 1 :])
                if other not in self.nodes and self._ends(one, other):
                    return True
        return False

    def _ends(self, one, other):
        if (one, other) not in self.ends:
            self.ends[one, other] = turns_back(self.robot, self.nodes[one], self.s.amounts(other))
        return self.ends[one, other]


def checked_driven(data, say=None):
    """What is proved, in words, and how many cells are left undecided, by the file or here. Raises Refused."""
    s = ActuatorSlice(data)
    check_digest(data)
    letters = list(listed_cells(data["cells"], s.shape, WORDS))
    claim = counted(letters, data["claim"], WORDS)
    return compared(s, DrivenCells(s, dict(letters), say), letters, claim, WORDS, WORDS, MEANS, say)
