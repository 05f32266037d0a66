r"""What a map comes to in a few numbers, put together chunk by chunk."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from gcrules.poses.maps.cells import CROSSED, FREE, MEANINGS, OUTSIDE, UNDECIDED
from gcrules.poses.maps.task import Chunk, MapTask

__all__ = ["MapSummary", "summed", "together"]


@dataclass(frozen=True)
class MapSummary:
    """Counts over the whole map: `cells` by status (free, crossed, undecided) and those `outside`, of which a corner is
    not reached; poses, those that are reached within the limits, and those of the latter below the threshold; the least
    margin among them, and where (None where it was not asked for or no pose keeps to the limits).
    """

    cells: tuple[int, int, int]
    poses: int
    allowed: int
    close: int
    margin: float | None = None
    place: tuple[float, ...] | None = None
    outside: int = 0

    def to_json(self) -> dict[str, Any]:
        return {
            "cells": dict(zip(MEANINGS, (*self.cells, self.outside), strict=True)),
            "poses": self.poses,
            "allowed": self.allowed,
            "close": self.close,
            "least_margin": self.margin,
            "at": list(self.place) if self.place else None,
        }


def summed(chunk: Chunk, task: MapTask, number: int, sigma: float) -> MapSummary:
    """The summary of one chunk; poses are close below the margin `sigma`."""
    first, _ = task.span(number)
    counts = np.bincount(chunk["cell_status"].ravel(), minlength=len(MEANINGS))
    level = task.level(chunk)
    poses = level.size
    inside = chunk["allowed"].astype(bool) if "allowed" in chunk else np.ones(level.shape, bool)
    cells, outside = (int(counts[FREE]), int(counts[CROSSED]), int(counts[UNDECIDED])), int(counts[OUTSIDE])
    if "margin" not in chunk or not inside.any():
        return MapSummary(cells, poses, int(inside.sum()), 0, outside=outside)
    values = np.where(inside, chunk["margin"], np.inf)
    k = np.unravel_index(int(values.argmin()), values.shape)
    place = task.grid.coordinates(np.array([[k[0] + first, *k[1:]]], dtype=np.float64))[0]
    close = int((values < sigma).sum())
    return MapSummary(cells, poses, int(inside.sum()), close, float(values[k]), tuple(map(float, place)), outside)


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
        )
    return total
