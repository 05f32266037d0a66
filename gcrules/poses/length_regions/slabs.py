r"""The plane of two lengths cut into cells by the singular curve, and the cells joined into regions; exact.

Between two critical lines x = const the curve consists of the same number of branches, one above the other, and the
cells between them are numbered from below; the edges of the box count as branches. Across a critical line two cells
are connected where an open part of the line lies in both. Gates show these parts: heights y at which the curve is not
met from one side of the line to the other. Between two gates in a row some branches end on the left and some on the
right:

* one and one: a branch passes through the line;
* two and none: they meet, and no part of the line lies between, for an even number of branches ends in a point;
* two and two: they meet in one point if the only double point of the line lies between these gates, or if one of them
  is an edge, the line is one on which the curve meets this edge, and no double point lies on it.

Gates are sought ever nearer to the line until all between them is of this kind. If that fails, what may be connected
there is kept apart from what does: the number of regions is then an interval. Derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

import networkx as nx

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.core.dataclass import dataclass
from gcrules.poses.length_regions.curve import CriticalLine, SingularCurve
from gcrules.poses.length_regions.integer_polynomials import roots_between
from gcrules.poses.paths.roots import integers

__all__ = ["Cell", "Double", "Plane", "plane"]

_ROUNDS = 14
_NEARER = 8  # times in each round
_SHARES = (Fraction(1, 2), Fraction(1, 3), Fraction(3, 4))  # of the height between branches at which a gate is tried
_ROOM = Fraction(1, 5)

Cell = tuple[int, int]
"""The number of the strip between critical lines, and that of the cell in it from below, both from 0."""

Interval = tuple[Fraction, Fraction]
Numbers = tuple[int, int]
Gate = tuple[Fraction | None, Numbers]


@dataclass(frozen=True)
class Double:
    """A double point on the critical line of this `number`: an interval of its heights, and the branches that end in it
    on the left and on the right.
    """

    number: int
    height: Interval
    left: range
    right: range

    @property
    def middle(self) -> Fraction:
        return (self.height[0] + self.height[1]) / 2

    @property
    def ends(self) -> Numbers:
        """How many branches end in it on the left and on the right."""
        return len(self.left), len(self.right)


@dataclass(frozen=True)
class Plane:
    """The box of squares of lengths, its critical `lines`, and the cells between them that are in the box.

    `joined` are pairs of cells that are connected, proved; `unsure` those that may. No other two cells of different
    strips that are next to each other do. `double` are the double points in the box.
    """

    curve: SingularCurve
    box: tuple[Interval, Interval]
    lines: tuple[CriticalLine, ...]
    cells: tuple[Cell, ...]
    joined: tuple[tuple[Cell, Cell], ...]
    unsure: tuple[tuple[Cell, Cell], ...]
    double: tuple[Double, ...] = ()

    def strip(self, number: int) -> Interval:
        """The x of a strip that are surely between its critical lines."""
        ends = [self.box[0][0], *(c for line in self.lines for c in (line.low, line.high)), self.box[0][1]]
        return ends[2 * number], ends[2 * number + 1]

    def branches(self, x: Fraction) -> list[Interval]:
        """The branches and edges at x, from below."""
        return _branches(self.curve, self.box[1], x)

    def cell_at(self, x: Fraction, y: Fraction) -> Cell | None:
        """The cell of a place in the box; None on the curve, or so near a critical line that it is not told."""
        k = sum(line.low < x for line in self.lines)
        low, high = self.strip(k)
        found = self.branches(x)
        if not low <= x <= high or any(one <= y <= other for one, other in found):
            return None
        return k, sum(other < y for _, other in found)

    def parts(self, *, unsure: bool) -> list[list[Cell]]:
        """The cells that are connected, in order; with those that may as one."""
        graph: nx.Graph[Cell] = nx.Graph()
        graph.add_nodes_from(self.cells)
        graph.add_edges_from(self.joined)
        if unsure:
            graph.add_edges_from(self.unsure)
        return sorted(map(sorted, nx.connected_components(graph)))


def plane(curve: SingularCurve, box: tuple[Interval, Interval]) -> Plane | None:
    """The cells of a box; None where the critical lines cannot be had."""
    lines = curve.critical_lines(*box[0], box[1])
    if lines is None:
        return None
    first = Plane(curve, box, tuple(lines), (), (), ())
    cells: list[Cell] = []
    inside: list[range] = []
    for k in range(len(lines) + 1):
        low, high = first.strip(k)
        found = first.branches(_simple(low, high))
        bottom, top = (found.index((e, e)) for e in box[1])
        inside.append(range(bottom + 1, top + 1))
        cells += [(k, n) for n in inside[-1]]
    joined: list[tuple[Cell, Cell]] = []
    unsure: list[tuple[Cell, Cell]] = []
    double: list[Double] = []
    for k, line in enumerate(lines):
        report_progress(f"critical line {k + 1} of {len(lines)}")
        gates, done = _across(first, k, line)
        sure, open_ = [numbers for _, numbers in gates], [] if done else _unsure(line, box[1], gates)
        double += _double(line, k, box[1], gates) if done else []
        for pairs, kept in ((sure, joined), (open_, unsure)):
            kept += [((k, a), (k + 1, b)) for a, b in pairs if a in inside[k] and b in inside[k + 1]]
    return Plane(curve, box, first.lines, tuple(cells), tuple(joined), tuple(unsure), tuple(double))


def _branches(curve: SingularCurve, edges: Interval, x: Fraction) -> list[Interval]:
    found = [(r.lower, r.upper) for r in curve.heights(x)]
    return sorted([*found, *((e, e) for e in edges)])


def _simple(low: Fraction, high: Fraction) -> Fraction:
    """A number near the middle with few digits."""
    middle, bits = (low + high) / 2, 0
    while abs(Fraction(round(middle * (1 << bits)), 1 << bits) - middle) * 4 > high - low:
        bits += 1
    return Fraction(round(middle * (1 << bits)), 1 << bits)


def _across(found: Plane, k: int, line: CriticalLine) -> tuple[list[Gate], bool]:
    """Gates through the line, and whether all is clear between them."""
    left, right = found.strip(k)[0], found.strip(k + 1)[1]
    gates: list[Gate] = []
    for n in range(_ROUNDS):
        checkpoint()
        one = _simple(*_beside(line.low, left, n))
        other = _simple(*_beside(line.high, right, n))
        gates = _gates(found, one, other, _SHARES[n % len(_SHARES)])
        if all(_clear(line, found.box[1], *pair) for pair in pairwise(gates)):
            return gates, True
    return gates, False


def _unsure(line: CriticalLine, edges: Interval, gates: Sequence[Gate]) -> list[Numbers]:
    """The cells that may be connected between gates where all is not clear."""
    found: list[Numbers] = []
    for lower, upper in pairwise(gates):
        if not _clear(line, edges, lower, upper):
            (a, b), (c, d) = lower[1], upper[1]
            found += [(i, j) for i in range(a, c + 1) for j in range(b, d + 1)]
    return found


def _double(line: CriticalLine, number: int, edges: Interval, gates: Sequence[Gate]) -> list[Double]:
    """The double point of the line, if it is in the box."""
    if line.height is None or not edges[0] < line.height[0] <= line.height[1] < edges[1]:
        return []
    for (low, (a, b)), (high, (c, d)) in pairwise(gates):
        if _between(low, *line.height, high):
            return [Double(number, line.height, range(a, c), range(b, d))]
    return []


def _beside(end: Fraction, far: Fraction, n: int) -> Interval:
    """Where to look at the branches, in round n."""
    near = (far - end) / (2 * _NEARER**n)
    return min(end + near / 2, end + near), max(end + near / 2, end + near)


def _gates(found: Plane, one: Fraction, other: Fraction, share: Fraction) -> list[Gate]:
    """Heights that the curve does not have from `one` to `other`, None for far below and above, from below; with
    the numbers of the cells there.
    """
    sides = found.branches(one), found.branches(other)
    every = sorted([*sides[0], *sides[1]])
    gates: list[Gate] = [(None, (0, 0))]
    for (_, below), (above, _) in pairwise(every):
        if below < above:
            height = above - below
            y = _simple(below + height * (share - _ROOM), below + height * (share + _ROOM))
            if not roots_between(integers(found.curve.along_x(y)), one, other):
                numbers = [sum(high < y for _, high in side) for side in sides]
                gates.append((y, (numbers[0], numbers[1])))
    gates.append((None, (len(sides[0]), len(sides[1]))))
    return gates


def _clear(line: CriticalLine, edges: Interval, lower: Gate, upper: Gate) -> bool:
    """Whether no part of the line lies between two gates in a row but what they show."""
    (low, (a, b)), (high, (c, d)) = lower, upper
    ends = (c - a, d - b)
    if ends in ((0, 0), (1, 1), (2, 0), (0, 2)):
        return True
    if ends != (2, 2):
        return False
    met = [k for k, e in enumerate(edges) if _between(low, e, e, high)]
    if met:
        return line.order == 0 and len(met) == 1 and met[0] in line.edges
    return line.height is not None and _between(low, *line.height, high)


def _between(low: Fraction | None, one: Fraction, other: Fraction, high: Fraction | None) -> bool:
    """Whether what lies from the one to the other lies between two gates."""
    return (low is None or low < one) and (high is None or other < high)
