"""Dimensions made exact: relations between the joints of a body, equal bars, equal lengths, symmetry.

What nearly holds is made to hold all at once, joints being moved as little as possible. Where that contradicts itself,
or would move a joint farther than the tolerance, relations are left out until the rest fits.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.models.chains_between import pairs_of_bars
from gcrules.mechanisms.models.motions import Motion
from gcrules.mechanisms.models.projecting import Relation, Shape, projected
from gcrules.mechanisms.models.rigid_relations import EXACT, Layout, layout_of, lengths_of, relations_of
from gcrules.mechanisms.models.symmetry import symmetries_of

__all__ = ["Wish", "exact", "fitted"]

_TURNED = 100  # how many times the tolerance the angle may be by which a short distance turns


@dataclass(frozen=True, eq=False)
class Wish:
    """Relations that are made to hold together or not at all."""

    sort: str
    relations: tuple[Relation, ...]
    text: str = ""


_SORTS = {
    "relation": ("relation between the joints of a body", "relations between the joints of a body"),
    "bars": ("pair of equal bars", "pairs of equal bars"),
    "length": ("length equal to another", "lengths equal to others"),
}


def exact(
    motions: Sequence[Motion], ends: tuple[str, str], size: float, tolerance: float
) -> tuple[tuple[Motion, ...], tuple[str, ...]]:
    """The motions with exact dimensions, and what was made exact, in words; what could not be is there too."""
    own = layout_of(motions, ends, size)
    wishes = list(_wishes(own, tolerance))
    held = [r for w in wishes if _off(w, own.shape) < EXACT for r in w.relations]
    open_ = [w for w in wishes if _off(w, own.shape) >= EXACT]
    if not open_:
        return tuple(motions), ()
    taken, shape = fitted(own.shape, held, open_, tolerance)
    return tuple(_moved(own, shape)), tuple(_words(open_, taken))


def _off(wish: Wish, shape: Shape) -> float:
    return max(r.off(shape) for r in wish.relations)


def _wishes(own: Layout, tolerance: float) -> Iterator[Wish]:
    """What holds within the tolerance."""
    relations = [r for r in _distinct(relations_of(own)) if _nearly(r, own.shape, tolerance)]
    yield from (Wish("relation", (r,)) for r in relations)
    numbers = {(m.joint, m.place): k for k, m in enumerate(own.motions)}
    for bars in pairs_of_bars(own.motions, *own.ends):
        near, second, far, last = (own.place[numbers[m.joint, m.place]] for m in (*bars.near, *bars.far))
        axes = () if bars.kind == "4S" else (own.direction[numbers[bars.near[0].joint, bars.near[0].place]],)
        equal = Relation("vectors", (near, far, second, last), axes)
        if equal.off(own.shape) < tolerance:
            yield Wish("bars", (equal,))
    yield from _equal(own, tolerance)
    for s in symmetries_of(own, tolerance):
        yield Wish("symmetry", s.relations, s.text)


def _equal(own: Layout, tolerance: float) -> Iterator[Wish]:
    """Lengths that are nearly equal to the least of them."""
    for across in (False, True):
        lengths = []
        for p, q, a in lengths_of(own):
            if (a >= 0) == across:
                away = own.shape.places[q] - own.shape.places[p]
                lengths.append((float(np.linalg.norm(np.cross(away, own.axis(a)) if across else away)), p, q, a))
        first = None
        for length, p, q, a in sorted(lengths):
            if first is not None and length - first[0] < tolerance:
                yield Wish("length", (Relation("lengths", (*first[1:3], p, q), (first[3], a) if across else ()),))
            elif length > 10 * tolerance:
                first = (length, p, q, a)


def _distinct(relations: Iterator[Relation]) -> Iterator[Relation]:
    seen = set()
    for r in relations:
        key = (r.kind, frozenset(r.places), r.directions)
        if key not in seen:
            seen.add(key)
            yield r


def _nearly(r: Relation, shape: Shape, tolerance: float) -> bool:
    if r.kind == "right":
        return True
    p, q = r.places
    distance = float(np.linalg.norm(shape.places[q] - shape.places[p]))
    off = r.off(shape)
    return off < EXACT or (off < tolerance and off < _TURNED * tolerance * distance)


def fitted(start: Shape, held: Sequence[Relation], wishes: Sequence[Wish], most: float) -> tuple[list[Wish], Shape]:
    """As many of the wishes as there can be with what is held, and the shape in which they are fulfilled."""
    taken: list[Wish] = []
    best = start

    def add(some: Sequence[Wish]) -> None:
        nonlocal best
        shape = projected(start, [*held, *(r for w in (*taken, *some) for r in w.relations)], most)
        if shape is not None:
            taken.extend(some)
            best = shape
        elif len(some) > 1:
            middle = len(some) // 2
            add(some[:middle])
            add(some[middle:])

    add(wishes)
    return taken, best


def _moved(own: Layout, shape: Shape) -> Iterator[Motion]:
    for k, m in enumerate(own.motions):
        at = m.at if own.place[k] < 0 else shape.places[own.place[k]] * own.size
        axis = m.axis
        if own.direction[k] > 2:
            axis = shape.directions[own.direction[k]] * own.sense[k]
            axis = axis / np.linalg.norm(axis)
        yield replace(m, at=at, axis=axis)


def _words(wishes: Sequence[Wish], taken: Sequence[Wish]) -> Iterator[str]:
    for sort, (one, several) in _SORTS.items():
        count = sum(w.sort == sort for w in taken)
        if count:
            yield f"{count} {one if count == 1 else several}"
    for w in taken:
        if w.sort == "symmetry":
            yield f"symmetry: {w.text}"
    left = sum(w not in taken for w in wishes)
    if left:
        yield (
            f"{left} more hold nearly, and were left out: together with the others they contradict each other, or would"
            " move a joint by more than the tolerance"
        )
