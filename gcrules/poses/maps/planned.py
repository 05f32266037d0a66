"""What a map is to be: its task by the kind of mechanism, all faults of the input told before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism, limits_of
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.compiled import compiled_motions
from gcrules.poses.compiling.engines import engine_for
from gcrules.poses.maps.axes import read_axes
from gcrules.poses.maps.grid import grid
from gcrules.poses.maps.limb_task import limbs_task
from gcrules.poses.maps.slices import factors, slice_polynomial, vanishes
from gcrules.poses.maps.task import KINDS, MEASURES, MapTask, width_of
from gcrules.poses.maps.values import LegsTask
from gcrules.poses.methods import Methods, legs_within, method
from gcrules.poses.recipe import recipe_of
from gcrules.screws.threshold import Threshold, angle_threshold

__all__ = ["KIND", "Plan", "bytes_of", "planned"]

KIND = "grid map"


@dataclass(frozen=True, eq=False)
class Plan:
    """What is to be computed, of which condition, and the threshold; from what it is planned anew."""

    task: MapTask
    sentence: str
    wording: Mapping[str, str | None]
    limit: Threshold
    recipe: Mapping[str, Any] = FrozenMap()


def planned(found: Mechanism, over: Any, at: Any, limits: str | None, threshold: Any, measure: str) -> Plan:
    """What is to be computed, all faults of the input told."""
    limit = angle_threshold(threshold, "in a map")
    if measure not in MEASURES:
        raise InputError(f"{str(measure)[:40]!r} is not a measure", hint=f"measures are {', '.join(MEASURES)}")
    plan = method(_PLANNED, found, "a map")(over, at, limits, limit, measure)
    if why := found.drives.missing(measure):
        there = ", ".join(found.drives.indices)
        raise InputError(f"{why}: there is no {measure.replace('_', ' ')}", hint=f"indices of this robot are {there}")
    return replace(plan, recipe=FrozenMap(recipe_of(KIND, found, over, at, limits, measure=measure)))


def _of_legs(m: SixLegs, over: Any, at: Any, limits: str | None, limit: Threshold, measure: str) -> Plan:
    axes = read_axes(over, m.unit)
    reached = limits_of(m, limits)
    g = grid(m.rig, axes, at)
    condition = compiled_motions(m, engine_for(g.size))
    moved = g.rotation_axis is not None
    everywhere = vanishes(g) if moved else not slice_polynomial(g)
    task = LegsTask(g, condition, measure, reached, None if moved else factors(g), everywhere)
    stated = m.analysis.condition
    return Plan(task, stated.sentence, stated.wording(), limit)


def _of_limbs(m: Limbs, over: Any, at: Any, limits: str | None, limit: Threshold, measure: str) -> Plan:
    """By the exact polynomial where the limbs are six legs."""
    legs = legs_within(m, limits)
    if legs is None:
        stated = m.analysis.statement
        task = limbs_task(m, over, at, limits, measure)
        return Plan(task, stated, {"statement": stated, "statement_source": None}, limit)
    return _of_legs(legs, over, at, limits, limit, measure)


_PLANNED: Methods[Plan] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""


def bytes_of(task: MapTask) -> int:
    """How many bytes the arrays of a map take on disk."""
    each: int = sum(np.dtype(KINDS[n]).itemsize * width_of(task, n) for n in task.names)
    return each * task.grid.size
