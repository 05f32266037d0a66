r"""Which states can be reached from which: a graph that grows by straight ways to poses at random.

To each new pose the nearest states of each part of the graph are led; where several of them come to one state, they are
joined. A way that ends early adds the last good state on it. Source: rapidly exploring random graphs of Karaman and
Frazzoli (International Journal of Robotics Research 30, 2011), with many poses at once.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import combinations, pairwise

import networkx as nx
import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.plans.space import Space

__all__ = ["SPREADS", "Roadmap", "shortened"]

SPREADS = (0.1, 0.25, 0.5, 1.0)
"""How far around straight ways poses are drawn, one after the other: sizes, and rad."""

Places = NDArray[np.intp]

_ROOTS = 8  # nearest roots to which ways are tried at first
_NEAR = 3  # states of each part that are led to a new pose
_LONGEST = 1.5  # rad, or sizes: no way is longer
_SHORTEST = 0.05  # ways that end before that add no state
_DEAR = 1e9  # of a way that is there but was not found good again
_EACH = 0.05  # rad, or sizes: by so much longer a way counts for each straight piece


def _cost(length: Floats) -> Floats:
    """How dear straight ways are (K,): their lengths, and a little for each."""
    return length + _EACH


class Roadmap:
    """States `rows` (N, width), the first ones the `roots`, and the ways between them as the edges of a `graph`."""

    def __init__(self, space: Space, roots: Floats) -> None:
        self.space = space
        self.rows = roots.copy()
        self.roots = len(roots)
        self.graph: nx.Graph[int] = nx.Graph()
        self.graph.add_nodes_from(range(len(roots)))
        if pairs := self._near_roots():
            self._lead(*(np.array(ends) for ends in zip(*pairs, strict=True)))

    def _near_roots(self) -> list[tuple[int, int]]:
        """Pairs of roots: each with those that are nearest to it."""
        order = np.argsort(self.space.apart(self.rows, self.rows), axis=1, kind="stable")[:, : _ROOTS + 1].tolist()
        return sorted({(min(a, b), max(a, b)) for a, near in enumerate(order) for b in near if a != b})

    def parts(self) -> list[list[int]]:
        """The roots that are joined with each other, each part in order."""
        found = (sorted(n for n in part if n < self.roots) for part in nx.connected_components(self.graph))
        return sorted(part for part in found if part)

    def joined(self, one: int, other: int) -> bool:
        """Whether ways lead from one state to the other."""
        return nx.has_path(self.graph, one, other)

    def _lead(self, first: Places, last: Places) -> None:
        """Try straight ways from states to others."""
        ways = self.space.gone(self.rows[first], self.rows[last])
        good = ways.whole & self.space.alike(ways.ends, self.rows[last])
        self._join(first[good], last[good])

    def grow(self, goals: Floats, among: Collection[int] | None = None) -> None:
        """Lead states to new poses (K, width): those that are joined with some root, or with one `among` the roots."""
        checkpoint()
        source, goal = self._sources(goals, range(self.roots) if among is None else among)
        if not len(source):
            return
        ways = self.space.gone(self.rows[source], goals[goal])
        length = self.space.lengths(self.rows[source], goals[goal]) * ways.parts
        known: dict[int, list[int]] = {}  # the states found at each goal
        order = np.argsort(length, kind="stable")
        for k in order[ways.whole[order]].tolist():
            here = known.setdefault(int(goal[k]), [])
            same = next((n for n in here if self.space.alike(self.rows[n][None], ways.ends[k][None])[0]), None)
            if same is None:
                same = self._add(ways.ends[k])
                here.append(same)
            self._join([int(source[k])], [same])
        short: dict[int, int] = {}
        for k in order[~ways.whole[order] & (length[order] >= _SHORTEST)].tolist():
            if int(goal[k]) not in known:
                short.setdefault(int(goal[k]), k)
        for k in short.values():
            self._join([int(source[k])], [self._add(ways.ends[k])])

    def way(self, one: int, other: int) -> list[int]:
        """The cheapest sequence of states between two that are joined."""
        return list(nx.shortest_path(self.graph, one, other, weight="cost"))

    def costs(self, one: int) -> dict[int, float]:
        """How dear the cheapest ways are from one state to the roots that are joined with it."""
        every = nx.single_source_dijkstra_path_length(self.graph, one, weight="cost")
        return {n: cost for n, cost in every.items() if n < self.roots}

    def forget(self, edges: Iterable[tuple[int, int]]) -> None:
        """Leave out ways that turned out to be none."""
        self.graph.remove_edges_from(list(edges))

    def _sources(self, goals: Floats, among: Collection[int]) -> tuple[Places, Places]:
        """The states that are led to goals: of each part with one of the roots the nearest ones, not too far away."""
        far = self.space.apart(goals, self.rows)
        source, goal = [], []
        for part in nx.connected_components(self.graph):
            members = np.fromiter(part, dtype=np.intp, count=len(part))
            if part.isdisjoint(among):
                continue
            near = far[:, members]
            count = min(_NEAR, len(members))
            best = np.argpartition(near, count - 1, axis=1)[:, :count]
            rows, columns = np.nonzero(np.take_along_axis(near, best, axis=1) <= _LONGEST)
            goal.append(rows)
            source.append(members[best[rows, columns]])
        return np.concatenate(source), np.concatenate(goal)

    def _add(self, row: Floats) -> int:
        self.rows = np.concatenate([self.rows, row[None]])
        self.graph.add_node(len(self.rows) - 1)
        return len(self.rows) - 1

    def _join(self, first: Sequence[int] | Places, last: Sequence[int] | Places) -> None:
        one, other = np.asarray(first, dtype=np.intp), np.asarray(last, dtype=np.intp)
        price = _cost(self.space.lengths(self.rows[one], self.rows[other]))
        for a, b, c in zip(one.tolist(), other.tolist(), price.tolist(), strict=True):
            self.graph.add_edge(a, b, cost=c)


def shortened(space: Space, rows: Floats, most: int = 24) -> Floats:
    """A cheaper way through some of the states on a way (N, width), and of the poses between them, with the same ends:
    the cheapest one over all straight ways between any two of up to so many of them.
    """
    best = rows
    for _ in range(3):
        checkpoint()
        best = _with_middles(space, best, most)
        pairs = list(combinations(range(len(best)), 2))
        first, last = (np.array(p) for p in zip(*pairs, strict=True))
        ways = space.gone(best[first], best[last])
        good = ways.whole & space.alike(ways.ends, best[last])
        graph: nx.Graph[int] = nx.Graph()
        graph.add_edges_from((a, a + 1, {"cost": _DEAR}) for a, _ in pairwise(range(len(best))))
        prices = _cost(space.lengths(best[first], best[last]))
        for a, b, price in zip(first[good].tolist(), last[good].tolist(), prices[good].tolist(), strict=True):
            graph.add_edge(a, b, cost=price)
        kept = nx.shortest_path(graph, 0, len(best) - 1, weight="cost")
        best = best[kept]
    return best


def _with_middles(space: Space, rows: Floats, most: int) -> Floats:
    """The states, and between neighbours others that ways lead to, as many as there is room for, longest ways first."""
    room = most - len(rows)
    if room <= 0 or len(rows) < 2:
        return rows
    lengths = space.lengths(rows[:-1], rows[1:])
    counts = np.zeros(len(lengths), dtype=int)
    for _ in range(room):
        k = int(np.argmax(lengths / (counts + 1)))
        counts[k] += 1
    found = [rows[:1]]
    for k, count in enumerate(counts.tolist()):
        if count:
            parts = np.arange(1, count + 1) / (count + 1)
            pairs = [np.repeat(r[None], count, axis=0) for r in (rows[k], rows[k + 1])]
            ways = space.gone(pairs[0], space.between(pairs[0], pairs[1], parts))
            found.append(ways.ends[ways.whole])
        found.append(rows[k + 1 : k + 2])
    return np.concatenate(found)
