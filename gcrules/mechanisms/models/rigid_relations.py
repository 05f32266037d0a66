"""What the joints on one body have to do with each other: relations that the motions of a model do not change.

Bodies that slides join count as one, for what does not change along the slides. On base and platform there are the
joints of all limbs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

import networkx as nx
import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.motions import Motion
from gcrules.mechanisms.models.projecting import Relation, Shape

__all__ = ["EXACT", "Layout", "layout_of", "lengths_of", "relations_of"]

EXACT = 1e-9  # of the size, and radians
_ONE = 1e-12  # places and directions are one
_APART = 1e-3  # sine of the angle of axes that are taken as two


@dataclass(frozen=True, eq=False)
class Layout:
    """Motions as places and directions that are counted once: `place` and `direction` of each motion by its number
    (-1 where it has none), `sense` that of its axis; `points` are the places that are more than points on an axis.
    """

    motions: tuple[Motion, ...]
    ends: tuple[str, str]
    size: float
    shape: Shape
    place: tuple[int, ...]
    direction: tuple[int, ...]
    sense: tuple[float, ...]
    points: frozenset[int]

    def is_line(self, k: int) -> bool:
        """Whether a motion has an axis, and no place on it that is more than another."""
        return self.motions[k].has_line and self.place[k] not in self.points

    def at(self, k: int) -> Floats:
        found: Floats = self.shape.places[self.place[k]]
        return found

    def axis(self, k: int) -> Floats:
        found: Floats = self.shape.directions[k]
        return found

    def right(self, a: int, b: int) -> bool:
        return abs(float(self.axis(a) @ self.axis(b))) < EXACT


def layout_of(motions: Sequence[Motion], ends: tuple[str, str], size: float) -> Layout:
    places: list[Floats] = []
    directions: list[Floats] = [*np.eye(3)]
    place, direction, sense = [], [], []
    for m in motions:
        at = m.at / size
        place.append(-1 if m.kind in "PE" else _number(at, places, [np.abs(p - at).max() for p in places]))
        off = np.linalg.norm(np.cross(directions, m.axis), axis=1)
        direction.append(_number(m.axis, directions, off) if m.axis.any() else -1)
        sense.append(float(np.sign(directions[direction[-1]] @ m.axis)) if m.axis.any() else 1.0)
    axes: dict[int, set[int]] = {}
    for m, k, d in zip(motions, place, direction, strict=True):
        axes.setdefault(k, set()).update(range(-2, 0) if m.kind == "S" else (d,))
    points = frozenset(k for k, own in axes.items() if k >= 0 and len(own) > 1)
    shape = Shape(np.array(places).reshape(-1, 3), np.array(directions))
    return Layout(tuple(motions), ends, size, shape, tuple(place), tuple(direction), tuple(sense), points)


def _number(own: Floats, known: list[Floats], off: Sequence[float] | Floats) -> int:
    """That of what is known already, else a new one."""
    for k, distance in enumerate(off):
        if distance < _ONE:
            return k
    known.append(own)
    return len(known) - 1


def relations_of(own: Layout) -> Iterator[Relation]:
    """All relations that could hold, whether they do or not; right angles are those that there are."""
    products = np.abs(own.shape.directions @ own.shape.directions.T)
    yield from (Relation("right", (), (int(a), int(b))) for a, b in np.argwhere(products < EXACT) if a < b > 2)
    for cluster in _clusters(own):
        yield from _in_cluster(own, cluster)
    for end in own.ends:
        yield from _on_end(own, end)


def _clusters(own: Layout) -> Iterator[nx.Graph[str]]:
    """Bodies between base and platform that slides join, with their slides."""
    joined: nx.Graph[str] = nx.Graph()
    joined.add_nodes_from({b for m in own.motions for b in (m.start, m.end)} - {*own.ends})
    for k, m in enumerate(own.motions):
        if m.kind == "P" and m.start in joined and m.end in joined:
            joined.add_edge(m.start, m.end, slide=own.direction[k])
    for bodies in sorted(nx.connected_components(joined), key=min):
        yield joined.subgraph(bodies)


def _in_cluster(own: Layout, cluster: nx.Graph[str]) -> Iterator[Relation]:
    touching = [k for k, m in enumerate(own.motions) if m.start in cluster or m.end in cluster]
    directions = sorted({own.direction[k] for k in touching} - {-1})
    for i, j in combinations([k for k in touching if own.place[k] >= 0], 2):
        p, q = own.place[i], own.place[j]
        if p == q:
            continue
        slides = _slides(cluster, own.motions[i], own.motions[j])
        lines = [own.direction[k] for k in (i, j) if own.is_line(k)]
        for a in directions:
            if all(own.right(a, s) for s in slides) and all(a == b or own.right(a, b) for b in lines):
                yield Relation("dot", (p, q), (a,))
            if slides <= {a} and (lines == [a] or not lines):
                yield Relation("cross", (p, q), (a,))
        if lines:
            for a, b in combinations(sorted({*lines, *slides}), 2):
                normal = np.cross(own.axis(a), own.axis(b))
                flat = all(abs(float(own.axis(c) @ normal)) < EXACT for c in (*lines, *slides))
                if flat and np.linalg.norm(normal) > _APART:
                    yield Relation("coplanar", (p, q), (a, b))


def _slides(cluster: nx.Graph[str], one: Motion, other: Motion) -> set[int]:
    """The directions of the slides between the bodies on which two motions are, by the shortest way."""
    ends = [[b for b in (m.start, m.end) if b in cluster] for m in (one, other)]
    ways: list[list[str]] = [[*nx.shortest_path(cluster, a, b)] for a in ends[0] for b in ends[1]]
    least = min(len(way) for way in ways)
    return {cluster.edges[edge]["slide"] for edge in pairwise(next(way for way in ways if len(way) == least))}


def _on_end(own: Layout, end: str) -> Iterator[Relation]:
    touching = [k for k, m in enumerate(own.motions) if end in (m.start, m.end)]
    here = [k for k in touching if own.place[k] >= 0]
    for i, j in combinations(here, 2):
        p, q = own.place[i], own.place[j]
        lines = [own.direction[k] for k in (i, j) if own.is_line(k)]
        if p == q:
            continue
        if len({*lines}) == 1:
            yield Relation("cross", (p, q), (lines[0],))
        elif lines:
            yield Relation("coplanar", (p, q), (lines[0], lines[1]))
    for a in sorted({0, 1, 2, *(own.direction[k] for k in touching)} - {-1}):
        level = [k for k in here if not own.is_line(k) or own.right(a, own.direction[k])]
        values = {own.place[k]: float(own.at(k) @ own.axis(a)) for k in level}
        for p, q in pairwise(sorted(values, key=lambda place: values[place])):
            yield Relation("dot", (p, q), (a,))


def lengths_of(own: Layout) -> Iterator[tuple[int, int, int]]:
    """Pairs of places whose distance is a length of a link; of a point on an axis that across it, whose number is the
    third one, else -1.
    """
    bodies = dict.fromkeys(b for m in own.motions for b in (m.start, m.end) if b not in own.ends)
    seen: set[frozenset[int]] = set()
    for body in bodies:
        touching = [k for k, m in enumerate(own.motions) if body in (m.start, m.end) and own.place[k] >= 0]
        for i, j in combinations(touching, 2):
            pair = frozenset((own.place[i], own.place[j]))
            axes = {own.direction[k] for k in (i, j) if own.is_line(k)}
            if len(pair) == 2 and pair not in seen and len(axes) < 2:
                seen.add(pair)
                yield own.place[i], own.place[j], min(axes, default=-1)
