r"""Poses with equal signs joined by ways, which are sought in one graph for all of them and proved one by one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import networkx as nx
import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.poses.aspects.report import Join
from gcrules.poses.plans.domain import Domain, Place
from gcrules.poses.plans.drafts import as_waypoints
from gcrules.poses.plans.roadmap import SPREADS, Roadmap

__all__ = ["Joiner"]

_ROUNDS = 4  # of search and proof
_NUMBER = 48  # poses that are drawn at once
_SAMPLES = 20  # of each piece of a way
_TRIES = 12  # poses that are drawn for each state


class Joiner:
    """The `joins` that are proved between places, of which only those with equal patterns can be joined."""

    def __init__(self, domain: Domain, places: Sequence[Place], patterns: Sequence[str]) -> None:
        self.domain, self.places, self.patterns = domain, places, patterns
        self.rows = np.stack([p.row for p in places])
        self.joins: list[Join] = []
        self.states = len(places)
        self._doubted: list[Join] = []
        self._proved: nx.Graph[int] = nx.Graph()
        self._proved.add_nodes_from(range(len(places)))

    def sets(self) -> list[list[int]]:
        """The places that proved ways join, each set in order."""
        return sorted(map(sorted, nx.connected_components(self._proved)))

    def join(self, random: Any, states: int) -> None:
        """Search and prove, until no two sets are left with equal signs or there are so many states. Ways of which all
        but the margin is proved join what nothing else does.
        """
        road = Roadmap(self.domain.space, self.rows)
        for _ in range(_ROUNDS):
            self._grow(road, random, states)
            self.states = len(road.rows)
            self._prove(road)
            if not self._left(self.sets()) or len(road.rows) >= states:
                break
        for j in self._doubted:
            if not nx.has_path(self._proved, j.one, j.other):
                self._add(j)

    def _add(self, join: Join) -> None:
        self.joins.append(join)
        self._proved.add_edge(join.one, join.other)

    def _left(self, parts: Sequence[Sequence[int]]) -> list[list[int]]:
        """The parts that are not alone with their signs."""
        patterns = [self.patterns[part[0]] for part in parts]
        return [list(part) for part, own in zip(parts, patterns, strict=True) if patterns.count(own) > 1]

    def _grow(self, road: Roadmap, random: Any, states: int) -> None:
        """Lead ways to poses between parts, until ways join all that have equal signs."""
        drawn = 0
        while (left := self._left(road.parts())) and len(road.rows) < states and drawn < _TRIES * states:
            checkpoint()
            report_progress(f"{len(road.rows):,} states, {len(left)} sets")
            one, other = self._pair(left, random)
            spread = SPREADS[min(drawn * 8 // states, len(SPREADS) - 1)]
            ends = self.rows[[one, other]]
            goals = self.domain.space.drawn(random, _NUMBER, ends, spread)
            same = [n for part in left for n in part if self.patterns[n] == self.patterns[one]]
            road.grow(np.concatenate([goals, ends]), same)
            drawn += _NUMBER

    def _pair(self, left: Sequence[Sequence[int]], random: Any) -> tuple[int, int]:
        """Two places of different parts with equal signs, at random."""
        part = left[random.integers(len(left))]
        own = self.patterns[part[0]]
        others = [p for p in left if p is not part and self.patterns[p[0]] == own]
        other = others[random.integers(len(others))]
        return part[random.integers(len(part))], other[random.integers(len(other))]

    def _prove(self, road: Roadmap) -> None:
        """Prove ways of the graph between places that no proved way joins yet, the cheapest first."""
        for one, other in self._by_cost(road):
            checkpoint()
            if nx.has_path(self._proved, one, other) or not road.joined(one, other):
                continue
            report_progress(f"{len(self.joins)} ways proved of {len(self.places) - 1} at most")
            self._prove_way(road, one, other)

    def _by_cost(self, road: Roadmap) -> list[tuple[int, int]]:
        costs = {(a, b): cost for a in range(len(self.places)) for b, cost in road.costs(a).items() if a < b}
        return sorted(costs, key=lambda pair: costs[pair])

    def _prove_way(self, road: Roadmap, one: int, other: int) -> None:
        nodes = road.way(one, other)
        first, last = self.places[one], self.places[other]
        for rounded in (True, False):
            way = as_waypoints(self.domain, first.pose, last.pose, road.rows[nodes], rounded=rounded)
            proved = self.domain.prove(way, _SAMPLES)
            if not proved.failures and self.domain.ends_at(proved.path, last):
                join = Join(one, other, tuple(way), proved.least, proved.margin_proved)
                if not proved.doubts:
                    return self._add(join)
                self._doubted.append(join)
            if len(nodes) == 2:
                break
        road.forget((nodes[k], nodes[k + 1]) for k in {*proved.failures, *proved.doubts} or range(len(nodes) - 1))
