"""How the platform is like the base: similar, a mirror image, an affine or a projective image, joint by joint.

>>> base = [(0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (1, 5, 0), (2, 2, 0)]
>>> [f.kind for f in relations(base, [(2 * x + 1, 2 * y, 5) for x, y, _ in base], ("Aa",) * 6, 1e-6)]
['similar']
>>> [f.kind for f in relations(base, [(x + y, y - 2 * x, 5) for x, y, _ in base], ("Aa",) * 6, 1e-6)]
['affine']
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

from gcrules.conditions.dimensions.bodies import deviation
from gcrules.conditions.dimensions.facts import Fact
from gcrules.conditions.dimensions.measures import LEAST, Vector, inner, length, minus, part, size_of, square
from gcrules.core.linear_algebra import cross, kernel, rank

__all__ = ["hand_of", "relations"]

Places = Sequence[Vector]


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
    return rank([minus(p, places[0]) for p in places[1:]]) if len(places) > 1 else 0


def _unlike(first: Places, second: Places) -> float:
    """By how much distances are in no one ratio, as a part of the size of the second body; 0 if exactly in one."""
    pairs = list(combinations(range(len(first)), 2))
    squares = [(square(first[i], first[j]), square(second[i], second[j])) for i, j in pairs]
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
        off = max(off, length([c / weights[-1] for c in made]))
    return part(off, size)


def _volume(places: Places) -> Any:
    """The square of the volume that places span, up to a factor: the determinant of Gram. Exact: rounded, places near
    each other would span none beside one far away.
    """
    rows = [minus(p, places[0]) for p in places[1:]]
    gram = [[inner(u, v) for v in rows] for u in rows]
    if len(gram) == 2:
        return gram[0][0] * gram[1][1] - gram[0][1] ** 2
    return inner(cross(rows[0], rows[1]), rows[2]) ** 2


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
    moved = [minus(p, places[0]) for p in places]
    u, v = next((u, v) for u, v in ((0, 1), (0, 2), (1, 2)) if rank([(p[u], p[v]) for p in moved]) == 2)
    return [(Fraction(p[u]), Fraction(p[v]), Fraction(1)) for p in moved]


def _general(places: Places) -> bool:
    """Whether four of the places of a plane have no three on a line."""
    return any(all(rank(three) == 3 for three in combinations(four, 3)) for four in combinations(places, 4))


# --- which hand ---


def hand_of(body: Places, images: Sequence[int], tolerance: float = 0.0) -> int:
    """1 where a body comes back by a motion (of a plane within itself), −1 where by a mirror, 0 where by both. A body
    that is plane within the tolerance counts as plane.
    """
    there = [body[i] for i in images]
    if _flat_within(body, tolerance):
        p, q, r = max(combinations(range(len(body)), 3), key=lambda some: _volume([body[i] for i in some]))
        first, second = (cross(minus(at[q], at[p]), minus(at[r], at[p])) for at in (body, there))
        return _sign(inner(first, second))
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
    u, v, w = (minus(p, places[0]) for p in places[1:])
    return inner(cross(u, v), w)


def _sign(value: Any) -> int:
    return int(value > 0) - int(value < 0)
