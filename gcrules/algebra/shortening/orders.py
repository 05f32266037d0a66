"""Normal forms in other orders of the points: a quick way to shorter forms, and to starts for other searches."""

from __future__ import annotations

import random

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.straightening.straighten import straighten
from gcrules.core.budget import checkpoint, seconds_left
from gcrules.core.errors import LimitReached

__all__ = ["shorter_order"]

_TRIES = 150


def shorter_order(normal: BracketPolynomial, most: int) -> BracketPolynomial | None:
    """The shortest of the normal forms met on a walk through the orders, if it has fewer than `most` terms.

    Each step exchanges two points, both finite or both at infinity, and is taken back where the form gets longer.
    """
    rng = random.Random(1)
    order, ideal = list(normal.points), normal.ideal
    sides = [side for side in (range(ideal), range(ideal, len(order))) if len(side) > 1]
    best, found = len(normal), None
    for _ in range(_TRIES if sides else 0):
        checkpoint()
        i, j = rng.sample(rng.choice(sides), 2)
        order[i], order[j] = order[j], order[i]
        try:
            form = straighten(normal.over(tuple(order), ideal), limit=10 * len(normal) + 1_000)
        except LimitReached:
            if seconds_left() <= 0:
                break
            form = None
        if isinstance(form, BracketPolynomial) and len(form) <= best:
            best, found = len(form), form
        else:
            order[i], order[j] = order[j], order[i]
    return found.over(normal.points, ideal) if found is not None and best < most else None
