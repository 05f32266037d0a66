"""Where axes meet, and where on its axis the point of a turn stands: at the foot of the slide beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.chains_between import Item
from gcrules.mechanisms.models.motions import Motion

__all__ = ["SAME", "meet", "off", "with_feet"]

SAME = 1e-7  # of lengths near 1, and radians


def with_feet(items: Sequence[Item]) -> list[Item]:
    """With the point of a turn's axis moved along it to where a slide beside it leads to the next centre."""
    found = list(items)
    for k, item in enumerate(items):
        if not isinstance(item, Motion) or item.kind != "P":
            continue
        for near, far in ((k - 1, k + 1), (k + 1, k - 1)):
            if min(near, far) >= 0 and max(near, far) < len(items):
                turn, centre = found[near], found[far]
                if isinstance(turn, Motion) and isinstance(centre, Motion) and turn.kind == "R" and centre.kind != "P":
                    found[near] = _foot(turn, centre, item, alone=_is_alone(found, near, k))
    return found


def _is_alone(items: Sequence[Item], turn: int, slide: int) -> bool:
    """Whether the axis of a turn meets no other turn beside it."""
    other = turn + (turn - slide)
    beside = items[other] if 0 <= other < len(items) else None
    own = items[turn]
    return not (isinstance(beside, Motion) and isinstance(own, Motion) and beside.kind in "RS" and _meets(own, beside))


def _meets(one: Motion, other: Motion) -> bool:
    return off(one, other.at) < SAME or (other.kind == "R" and meet(one, other, 1.0) is not None)


def _foot(turn: Motion, centre: Motion, slide: Motion, *, alone: bool) -> Motion:
    line = replace(centre, axis=slide.axis, kind="R")
    foot = meet(turn, line, float(np.linalg.norm(centre.at - turn.at)) or 1.0)
    return replace(turn, at=foot) if alone and foot is not None else turn


def meet(one: Motion, two: Motion, size: float) -> Floats | None:
    """Where two axes meet, if they do and are not parallel."""
    normal = np.cross(one.axis, two.axis)
    square = float(normal @ normal)
    away = two.at - one.at
    if square < 1e-6 or abs(away @ normal) > SAME * size * square**0.5:
        return None
    along = float(np.cross(away, two.axis) @ normal) / square
    found: Floats = one.at + along * one.axis
    return found


def off(m: Motion, place: Floats) -> float:
    away = place - m.at
    return float(np.linalg.norm(away - m.axis * (m.axis @ away)))
