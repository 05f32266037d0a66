"""Why a robot is singular in every pose, and whether it is nearly so."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from random import Random

from gcrules.conditions.dimensions.architecture import balance, singular_everywhere
from gcrules.conditions.dimensions.facts import Architecture, Fact
from gcrules.conditions.dimensions.measures import Vector, minus, size_of
from gcrules.core.deferred import deferred
from gcrules.core.english import listed
from gcrules.core.linear_algebra import content, rank
from gcrules.screws.rotations import rotation

__all__ = ["architecture_of"]

jacobian = deferred("gcrules.screws.margin:jacobian")

_NEAR = 16  # random poses in which a robot is tried that may be singular in all of them, but for its last digits
_LONG = 12  # signs of a force that is shown as a quotient

Places = Sequence[Vector]


def architecture_of(
    base: Places, platform: Places, words: tuple[str, ...], facts: Sequence[Fact], tolerance: float
) -> Architecture:
    """Whether six legs between these joints are dependent in every pose: proved, or in random poses within a tolerance.
    `facts` are those of the bodies, which may be the reason.
    """
    found = singular_everywhere(base, platform)
    if found.everywhere:
        relations = balance(base, platform)
        stress = _stress(relations[0], words) if len(relations) == 1 else ()
        sure = f"proved: the determinant of the legs vanishes at the {found.poses} exact poses of a lattice, at which "
        sure += "no polynomial of its degree vanishes without being 0; and at 3 random ones modulo 2^61 - 1"
        return Architecture("singular", sure, _reason(base, platform, words, facts, relations), stress)
    worst = _largest_margin(base, platform)
    if worst <= tolerance:
        sure = f"in {_NEAR} random poses the margin is at most {worst:.2g}; in general it is not 0"
        return Architecture("nearly singular", sure)
    return Architecture("regular", "proved: an exact pose is known in which the legs are independent")


def _reason(
    base: Places, platform: Places, words: Sequence[str], facts: Sequence[Fact], relations: Sequence[Sequence[Fraction]]
) -> str:
    """The first reason that is known; "" for none."""
    for name, body in (("base", base), ("platform", platform)):
        if rank([minus(p, body[0]) for p in body]) < 2:
            return f"all joints of the {name} are on one line, about which the platform can turn"
        for place in dict.fromkeys(map(tuple, body)):
            some = [word for word, p in zip(words, body, strict=True) if tuple(p) == place]
            if len(some) > 3:
                return f"the {len(some)} legs {listed(some)} meet in one joint of the {name}, where three would do"
    if relations:
        used = [w for i, w in enumerate(words) if any(r[i] for r in relations)]
        what = "six legs" if len(used) == 6 else f"legs {listed(used)}"
        same = ", per unit of leg length always in the same ratio" if len(relations) == 1 else ""
        return f"forces along the {what} balance in every pose{same}{_likeness(facts, used)}"
    return ""


def _likeness(facts: Sequence[Fact], used: Sequence[str]) -> str:
    """Which likeness of the bodies goes with it: of planes with joints on a conic six legs always depend so."""
    like = next((f for f in facts if f.kind in ("similar", "affine", "projective") and f.exact), None)
    curve = {f.body: f.kind for f in facts if f.kind in ("circle", "conic") and f.exact and len(f.members) > 5}
    if like is None or len(used) < 6 or not curve:
        return ""
    kind = {"similar": "similar", "affine": "affine images of each other", "projective": "projective images"}[like.kind]
    body, shape = next(iter(curve.items()))
    return f"; base and platform are plane and {kind}, with the joints of the {body} on a {shape}"


def _stress(relation: Sequence[Fraction], words: Sequence[str]) -> tuple[tuple[str, str], ...]:
    """The forces for each unit of length of the legs, as whole numbers where these are short."""
    unit = content([c for c in relation if c])
    sign = 1 if next(c for c in relation if c) > 0 else -1
    shares = [sign * c / unit for c in relation]
    largest = max(map(abs, shares))
    long = max(len(str(s)) for s in shares) > _LONG
    return tuple(
        (word, f"{float(share / largest):.6g}" if long else str(share))
        for word, share in zip(words, shares, strict=True)
        if share
    )


def _largest_margin(base: Places, platform: Places) -> float:
    """The largest margin σ in some random poses, as far away as the bodies are large."""
    import numpy as np

    draw = Random("poses of a robot that may be singular in all")
    first, second = (np.array([[float(c) for c in p] for p in body]) for body in (base, platform))
    first, second = first - first.mean(axis=0), second - second.mean(axis=0)
    size = max(size_of(base), size_of(platform))
    ends = []
    for _ in range(_NEAR):
        w, x, y, z = (Fraction(draw.randint(-9, 9)) for _ in range(4))
        turn = np.array(rotation((w or Fraction(1), x, y, z)), dtype=float)
        away = np.array([draw.gauss(0, 1) for _ in range(3)])
        ends.append(second @ turn.T + size * away / (math.hypot(*away) or 1.0))
    return float(jacobian(first, np.array(ends)).sigma.max())
