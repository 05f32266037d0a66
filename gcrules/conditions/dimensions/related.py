"""How the platform is like the base: similar, a mirror image, an affine or a projective image, joint by joint; and
which motions take both bodies to themselves.

>>> base = [(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (1, 5, 0), (2, 2, 0)]
>>> [f.kind for f in relations(base, [(2 * x + 1, 2 * y, 5) for x, y, _ in base], ("Aa",) * 6, 1e-6)]
['similar']
>>> [f.kind for f in relations(base, [(x + y, y - 2 * x, 5) for x, y, _ in base], ("Aa",) * 6, 1e-6)]
['affine']
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.conditions.dimensions.bodies import Place, deviation, size_of
from gcrules.conditions.dimensions.facts import LEAST, Fact
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import cross, kernel, rank

__all__ = ["cycles", "hand_of", "matching", "relations", "symmetries"]

Places = Sequence[Place]


def relations(base: Places, platform: Places, words: tuple[str, ...], tolerance: float) -> tuple[Fact, ...]:
    """The closest likeness of the bodies, at most one: similar, mirrored, affine, or projective (between planes).
    `words` name the pairs of corresponding joints. Joints in fewer places than such a map can bring anywhere are left
    out: it then says nothing.
    """
    pairs = list(dict.fromkeys(zip(map(tuple, base), map(tuple, platform), strict=True)))
    first, second = [p for p, _ in pairs], [q for _, q in pairs]
    height = _dimension(first)
    if len(pairs) < 4 or height < 2 or _dimension(second) < 2:
        return ()
    off = _unlike(first, second)
    if off <= tolerance:
        flat = any(_flat_within(body, tolerance) for body in (first, second))
        kind = "similar" if flat or _same_hand(first, second) > 0 else "mirrored"
        return (Fact(kind, words, deviation=off),)
    off = _not_affine(first, second, height)
    if len(pairs) > height + 1 and off <= tolerance:
        return (Fact("affine", words, deviation=off),)
    if len(pairs) > 4 and _projective(first, second):
        return (Fact("projective", words),)
    return ()


def _dimension(places: Places) -> int:
    return rank([_minus(p, places[0]) for p in places[1:]]) if len(places) > 1 else 0


def _minus(p: Place, q: Place) -> tuple[Any, ...]:
    return tuple(a - b for a, b in zip(p, q, strict=True))


def _square(p: Place, q: Place) -> Any:
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def _unlike(first: Places, second: Places) -> float:
    """By how much distances are in no one ratio, as a part of the size of the second body; 0 if exactly in one."""
    pairs = list(combinations(range(len(first)), 2))
    squares = [(_square(first[i], first[j]), _square(second[i], second[j])) for i, j in pairs]
    whole, other = max(squares)
    if all(a * other == b * whole for a, b in squares):
        return 0.0
    ratio = math.sqrt(other / whole)
    size = size_of(second)
    return max(max(abs(math.sqrt(b) - ratio * math.sqrt(a)) for a, b in squares) / size, LEAST)


def _not_affine(first: Places, second: Places, height: int) -> float:
    """The largest distance from where the affine map by the first body's widest joints takes a joint, as a part of the
    second body's size.
    """
    chosen = max(combinations(range(len(first)), height + 1), key=lambda some: _volume([first[i] for i in some]))
    size, off = size_of(second), 0.0
    for i in range(len(first)):
        # one relation of height + 2 places, if weights of sum 0 bring the first to 0, must bring the second to 0
        some = (*chosen, i)
        if i in chosen:
            continue
        (weights,) = kernel(zip(*[(*first[k], 1) for k in some], strict=True), len(some))
        made = [
            sum(w * c for w, c in zip(weights, column, strict=True))
            for column in zip(*[second[k] for k in some], strict=True)
        ]
        off = max(off, math.hypot(*(float(c / weights[-1]) for c in made)) or (LEAST if any(made) else 0.0))
    return max(off / size, LEAST) if off else 0.0


def _volume(places: Places) -> float:
    """The square of the volume that places span, up to a factor: the determinant of Gram."""
    rows = [tuple(map(float, _minus(p, places[0]))) for p in places[1:]]
    gram = [[sum(a * b for a, b in zip(u, v, strict=True)) for v in rows] for u in rows]
    if len(gram) == 2:
        return gram[0][0] * gram[1][1] - gram[0][1] ** 2
    return float(sum(a * b for a, b in zip(cross(rows[0], rows[1]), rows[2], strict=True))) ** 2


def _projective(first: Places, second: Places) -> bool:
    """Whether a collineation of planes, of which no point of either body is lost, takes one body to the other."""
    if _dimension(first) != 2 or _dimension(second) != 2:
        return False
    at, to = _flat(first), _flat(second)
    if not _general(at) or not _general(to):
        return False  # a map is not told by so few joints
    rows = []
    for p, (x, y, w) in zip(at, to, strict=True):
        zero = (0, 0, 0)
        rows += [(*(w * c for c in p), *zero, *(-x * c for c in p)), (*zero, *(w * c for c in p), *(-y * c for c in p))]
    found = kernel(rows, 9)
    if len(found) != 1:
        return False
    h = found[0]
    return rank([h[:3], h[3:6], h[6:]]) == 3


def _flat(places: Places) -> list[tuple[Any, Any, Any]]:
    """Homogeneous coordinates within a plane, seen along an axis: an affine map."""
    moved = [_minus(p, places[0]) for p in places]
    u, v = next((u, v) for u, v in ((0, 1), (0, 2), (1, 2)) if rank([(p[u], p[v]) for p in moved]) == 2)
    return [(Fraction(p[u]), Fraction(p[v]), Fraction(1)) for p in moved]


def _general(places: Places) -> bool:
    """Whether four of the places of a plane have no three on a line."""
    return any(all(rank(three) == 3 for three in combinations(four, 3)) for four in combinations(places, 4))


# --- symmetry ---


def symmetries(base: Places, platform: Places, words: tuple[str, ...], tolerance: float) -> tuple[Fact, ...]:
    """The turn of largest order, and the mirrors, that take base and platform each to itself with one permutation of
    the legs; bodies as they are made, wherever the platform is. Legs with both ends in common with another are told
    apart by nothing, and then none is named.
    """
    number = len(words)
    if len(set(zip(map(tuple, base), map(tuple, platform), strict=True))) < number:
        return ()
    if min(_dimension(list(base)), _dimension(list(platform))) < 2:
        return ()
    near = [tolerance * size_of(body) for body in (base, platform)]
    tables = [[[_square(p, q) for q in body] for p in body] for body in (base, platform)]
    roots = [[[math.sqrt(c) for c in row] for row in table] for table in tables]
    turn: tuple[int, tuple[int, ...]] | None = None
    mirrors = []
    for images in matching(roots, near, number):
        checkpoint()
        if images == tuple(range(number)):
            continue
        order = math.lcm(*map(len, cycles(images)))
        hands = {hand_of(body, images, tolerance) for body in (base, platform)} - {0}
        if hands == {1} and (turn is None or order > turn[0]):
            turn = order, images
        elif hands == {-1} and order == 2:
            mirrors.append(images)
    found = []
    if turn is not None:
        found.append(_symmetry("rotation", turn[1], words, tables, roots, turn[0]))
    return (*found, *(_symmetry("mirror", images, words, tables, roots, 2) for images in mirrors))


def matching(roots: Sequence[Any], near: Sequence[float], number: int) -> Iterator[tuple[int, ...]]:
    """The permutations of the legs that keep all distances within both bodies."""

    def grown(images: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
        i = len(images)
        if i == number:
            yield images
            return
        for j in range(number):
            if j not in images and all(
                abs(table[i][k] - table[j][images[k]]) <= off
                for table, off in zip(roots, near, strict=True)
                for k in range(i)
            ):
                yield from grown((*images, j))

    yield from grown(())


def cycles(images: Sequence[int]) -> list[tuple[int, ...]]:
    left, found = list(range(len(images))), []
    while left:
        cycle = [left[0]]
        while (after := images[cycle[-1]]) != cycle[0]:
            cycle.append(after)
        found.append(tuple(cycle))
        left = [i for i in left if i not in cycle]
    return found


def hand_of(body: Places, images: Sequence[int], tolerance: float = 0.0) -> int:
    """1 where a body comes back by a motion (of a plane within itself), −1 where by a mirror, 0 where by both. A body
    that is plane within the tolerance counts as plane.
    """
    there = [body[i] for i in images]
    if _flat_within(body, tolerance):
        p, q, r = max(combinations(range(len(body)), 3), key=lambda some: _volume([body[i] for i in some]))
        first, second = (cross(_minus(at[q], at[p]), _minus(at[r], at[p])) for at in (body, there))
        return _sign(sum(a * b for a, b in zip(first, second, strict=True)))
    return _same_hand(body, there)


def _flat_within(places: Places, tolerance: float) -> bool:
    """Whether the places are in one plane, and no other: exactly, or nearly."""
    return _dimension(list(places)) == 2 or deviation(places, 3, size_of(places)) <= tolerance


def _same_hand(first: Places, second: Places) -> int:
    """1 where corresponding joints of two bodies in space are of one hand, −1 of the other: by those that are farthest
    from being in one plane.
    """
    chosen = max(combinations(range(len(first)), 4), key=lambda some: _volume([first[i] for i in some]))
    return _sign(_signed_volume([first[i] for i in chosen]) * _signed_volume([second[i] for i in chosen]))


def _signed_volume(places: Places) -> Any:
    u, v, w = (_minus(p, places[0]) for p in places[1:])
    return sum(a * b for a, b in zip(cross(u, v), w, strict=True))


def _sign(value: Any) -> int:
    return int(value > 0) - int(value < 0)


def _symmetry(
    kind: str, images: Sequence[int], words: tuple[str, ...], tables: Sequence[Any], roots: Sequence[Any], order: int
) -> Fact:
    legs = range(len(words))
    pairs = [(i, j) for i in legs for j in legs]
    exact = all(table[i][j] == table[images[i]][images[j]] for table in tables for i, j in pairs)
    off = 0.0
    if not exact:
        off = max(
            abs(table[i][j] - table[images[i]][images[j]]) / max(map(max, table)) for table in roots for i, j in pairs
        )
    members = tuple("→".join(words[i] for i in cycle) for cycle in cycles(images) if len(cycle) > 1)
    return Fact(kind, members, deviation=0.0 if exact else max(off, LEAST), order=order)
