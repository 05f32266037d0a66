r"""Turns and mirrors that take the base to itself, and others the platform, with one permutation of the legs or limbs.

Bodies are as they are made, wherever the platform is. A motion of a body is known from its points (they must not be on
one line): it must take all points and directions that a limb has on the body to those of another limb of the same
joints.

>>> base = [(("A",), ()), (("B",), ()), (("C",), ())]
>>> at = {"A": (0, 2, 0), "B": (-1, 0, 0), "C": (1, 0, 0)}
>>> [(f.kind, f.members, f.exact) for f in symmetries(("1", "2", "3"), "RRR", (base, base), at, 0.0)]
[('mirror', ('2→3',), True)]
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.conditions.dimensions.facts import Fact
from gcrules.conditions.dimensions.measures import (
    Vector,
    distance,
    inner,
    minus,
    off_parallel,
    part,
    size_of,
    square,
    unequal,
)
from gcrules.conditions.dimensions.related import hand_of
from gcrules.core.budget import checkpoint
from gcrules.core.linear_algebra import cross, rank

__all__ = ["Hold", "symmetries"]

Hold = tuple[tuple[str, ...], tuple[str, ...]]
"""The points and the directions that a limb has on a body, in the order of its joints."""

Places = Sequence[Vector]
Vectors = Mapping[str, Vector]


def symmetries(
    limbs: Sequence[str], sorts: Sequence[object], holds: Sequence[Sequence[Hold]], at: Vectors, tolerance: float
) -> tuple[Fact, ...]:
    """The turn of largest order, and the mirrors. Limbs may take each other's place if they are of one of the `sorts`;
    `holds` are those of all limbs on the base, and on the platform. Limbs whose first points on both bodies are those
    of another one are told apart by nothing, and then none is named.
    """
    number = len(limbs)
    if number < 2 or any(not points for body in holds for points, _ in body):
        return ()
    first = [[at[points[0]] for points, _ in body] for body in holds]
    if any(rank([minus(p, body[0]) for p in body]) < 2 for body in first):
        return ()
    if len(set(zip(map(tuple, first[0]), map(tuple, first[1]), strict=True))) < number:
        return ()
    turns: list[Fact] = []
    mirrors: list[Fact] = []
    for images in _matching(first, tolerance):
        checkpoint()
        if images == tuple(range(number)) or any(sorts[i] != sorts[j] for i, j in enumerate(images)):
            continue
        hands = {hand_of(body, images, tolerance) for body in first} - {0}
        order = math.lcm(*map(len, _cycles(images)))
        if len(hands) != 1 or (hands == {-1} and order != 2):
            continue
        off = max(_missed(body, images, at, hand) for body in holds for hand in hands)
        if off <= tolerance:
            members = tuple("→".join(limbs[i] for i in cycle) for cycle in _cycles(images) if len(cycle) > 1)
            kind = "rotation" if hands == {1} else "mirror"
            (turns if kind == "rotation" else mirrors).append(Fact(kind, members, deviation=off, order=order))
    return (*sorted(turns, key=lambda fact: -fact.order)[:1], *mirrors)


def _matching(bodies: Sequence[Places], tolerance: float) -> Iterator[tuple[int, ...]]:
    """The permutations that keep all distances within all bodies."""
    number = len(bodies[0])
    tables = [([[square(p, q) for q in body] for p in body], size_of(body)) for body in bodies]

    def grown(images: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
        i = len(images)
        if i == number:
            yield images
            return
        for j in range(number):
            if j not in images and all(
                unequal(table[i][k], table[j][images[k]], size) <= tolerance for table, size in tables for k in range(i)
            ):
                yield from grown((*images, j))

    yield from grown(())


def _cycles(images: Sequence[int]) -> list[tuple[int, ...]]:
    left, found = list(range(len(images))), []
    while left:
        cycle = [left[0]]
        while (after := images[cycle[-1]]) != cycle[0]:
            cycle.append(after)
        found.append(tuple(cycle))
        left = [i for i in left if i not in cycle]
    return found


def _missed(body: Sequence[Hold], images: Sequence[int], at: Vectors, hand: int) -> float:
    """How far the motion misses the points and directions, as a part of the body's size or the sine of an angle."""
    points = [at[n] for own, _ in body for n in own]
    size, worst = size_of(points), 0.0
    here, there = _frames(body, images, at, hand)
    for hold, image in ((body[i], body[j]) for i, j in enumerate(images)):
        if tuple(map(len, hold)) != tuple(map(len, image)):
            return math.inf
        for n, m in zip(hold[0], image[0], strict=True):
            gone = _carried(minus(at[n], here[0]), here[1:], there[1:])
            wanted = minus(at[m], there[0])
            worst = max(worst, part(distance(gone, wanted), size))
        for n, m in zip(hold[1], image[1], strict=True):
            worst = max(worst, off_parallel(_carried(at[n], here[1:], there[1:]), at[m]))
    return worst


def _frames(body: Sequence[Hold], images: Sequence[int], at: Vectors, hand: int) -> tuple[Any, Any]:
    """A point, two differences and their product, of a body and of its image; those first that span most."""
    points = [at[own[0]] for own, _ in body]
    spans = [
        (inner(normal, normal), (i, j, k))
        for i in range(len(points))
        for j in range(i)
        for k in range(j)
        for normal in [cross(minus(points[j], points[i]), minus(points[k], points[i]))]
    ]
    _, chosen = max(spans)
    found = []
    for places, sign in ((chosen, 1), ([images[i] for i in chosen], hand)):
        p, q, r = (points[i] for i in places)
        u, v = minus(q, p), minus(r, p)
        found.append((p, u, v, tuple(sign * c for c in cross(u, v))))
    return found[0], found[1]


def _carried(w: Vector, here: Sequence[Vector], there: Sequence[Vector]) -> tuple[Any, ...]:
    """Where the linear map from one frame to another takes a vector: by Cramer's rule."""
    u, v, n = here
    whole = Fraction(inner(cross(u, v), n))
    shares = [inner(cross(v, n), w), inner(cross(n, u), w), inner(cross(u, v), w)]
    return tuple(sum(s * c for s, c in zip(shares, column, strict=True)) / whole for column in zip(*there, strict=True))
