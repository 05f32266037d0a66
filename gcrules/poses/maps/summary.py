r"""What a map comes to in a few numbers, put together chunk by chunk."""

from __future__ import annotations

from collections.abc import Iterable
from math import isfinite
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.poses.maps.cells import MEANINGS

__all__ = ["MapSummary", "together"]


@dataclass(frozen=True)
class MapSummary:
    """Counts over the whole map: `cells` by status (free, crossed, undecided) and those `outside`, of which a corner is
    not reached; poses, those that are reached within the limits, and those of the latter below the threshold; the least
    margin among them, and where (None where it was not asked for or no pose keeps to the limits); the least and the
    largest value of an index of the actuators, and where (empty where none was asked for).
    """

    cells: tuple[int, int, int]
    poses: int
    allowed: int
    close: int
    margin: float | None = None
    place: tuple[float, ...] | None = None
    outside: int = 0
    index: tuple[tuple[float, tuple[float, ...]], ...] = ()

    def to_json(self) -> dict[str, Any]:
        return {
            "cells": dict(zip(MEANINGS, (*self.cells, self.outside), strict=True)),
            "poses": self.poses,
            "allowed": self.allowed,
            "close": self.close,
            "least_margin": self.margin,
            "at": list(self.place) if self.place else None,
            "index": [{"value": v if isfinite(v) else None, "at": list(place)} for v, place in self.index],
        }


def together(parts: Iterable[MapSummary]) -> MapSummary:
    """Summaries of chunks as one."""
    total = MapSummary((0, 0, 0), 0, 0, 0)
    for p in parts:
        least = min((s for s in (total, p) if s.margin is not None), key=lambda s: s.margin or 0.0, default=p)
        a, b, c = (x + y for x, y in zip(total.cells, p.cells, strict=True))
        total = MapSummary(
            (a, b, c),
            total.poses + p.poses,
            total.allowed + p.allowed,
            total.close + p.close,
            least.margin,
            least.place,
            total.outside + p.outside,
            (min(total.index[0], p.index[0]), max(total.index[1], p.index[1]))
            if total.index and p.index
            else total.index or p.index,
        )
    return total
