"""A map over a grid as a task in tiles: each is some whole layers along the first axis; and the task made anew."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap, HoldsArrays
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.maps.planned import Plan, planned
from gcrules.poses.maps.task import KINDS, MapTask, width_of
from gcrules.poses.maps.variables import Variable, about, coordinates, variables
from gcrules.poses.recipe import robot_of
from gcrules.poses.tiles.task import Coordinate, Stage, Tile, TiledArray
from gcrules.screws.threshold import DEFAULT

__all__ = ["GridTiles", "plan_again", "task_again"]


@dataclass(frozen=True, eq=False)
class GridTiles(HoldsArrays):
    """A `TileTask` of a map whose condition is the `sentence`; `recipe` tells how it is planned."""

    task: MapTask
    sentence: str
    recipe: Mapping[str, Any]

    @property
    def manifest(self) -> dict[str, Any]:
        return self.task.manifest

    @property
    def grid(self) -> tuple[int, ...]:
        return (self.task.number,)

    @property
    def arrays(self) -> tuple[TiledArray, ...]:
        shape, layers = self.task.grid.shape, self.task.layers
        found = []
        for name, v in variables(self.task).items():
            size = tuple(n - 1 for n in shape) if name == "cell_status" else shape
            wide = (width_of(self.task, name),) if len(v.dims) > len(size) else ()
            kind = np.dtype(KINDS[name]).name
            found.append(TiledArray(name, v.dims, (*size, *wide), (layers, *size[1:], *wide), kind, _attributes(v)))
        return tuple(found)

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        return tuple(
            Coordinate(name, v.dims, v.values, _attributes(v))
            for name, v in coordinates(self.task).items()
            if v.values is not None
        )

    @property
    def attrs(self) -> dict[str, Any]:
        return about(self.task, self.sentence)

    @property
    def stage(self) -> Stage | None:
        return self.task.stage

    def compute(self, tile: int) -> Tile:
        """All arrays of a tile."""
        return self.task.compute(tile)


def _attributes(v: Variable) -> FrozenMap[str, Any]:
    """As JSON has them."""
    return FrozenMap({k: a.tolist() if isinstance(a, np.ndarray) else a for k, a in v.attributes.items()})


def plan_again(recipe: Mapping[str, Any]) -> Plan:
    """The plan of a recipe. Raises GcrulesError and KeyError for what is none."""
    given = {name: recipe[name] for name in ("over", "at", "limits", "measure")}
    return planned(mechanism(robot_of(recipe["robot"]), about=recipe["about"]), threshold=DEFAULT.text, **given)


def task_again(recipe: Mapping[str, Any]) -> GridTiles:
    """The task of a recipe; raises as `plan_again`."""
    plan = plan_again(recipe)
    return GridTiles(plan.task, plan.sentence, recipe)
