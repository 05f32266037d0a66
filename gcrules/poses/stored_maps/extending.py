"""A map over nodes that begins with what another one has computed, and goes on along its first coordinate."""

from __future__ import annotations

from dataclasses import replace

from gcrules.core.budget import checkpoint, report
from gcrules.core.errors import InputError
from gcrules.poses.maps.axes import GridAxis, parse_axis
from gcrules.poses.maps.maps import done
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.task import MapTask
from gcrules.poses.maps.tiled import GridTiles, plan_again
from gcrules.poses.tiles.how import Running
from gcrules.poses.tiles.store import TileStore

__all__ = ["extended"]


def extended(old: TileStore, known: GridTiles, output: str, over: str, how: Running) -> SingularMap:
    """The map of a store `over` another range of its first coordinate, "x -300:600", with nodes as far apart, in the
    new store `output`: exactly what a run of its own would give. Tiles that both maps have are taken over.

    Raises InputError for another coordinate, for a range that parts tiles, and for robots that are led from home over
    the whole grid, whose tiles are not the same in another one.
    """
    if known.task.stage is not None:
        raise InputError(
            "a robot described by its joints is led from home over the whole grid: a wider map has different tiles",
            hint="compute the wider map from scratch; maps of whole boxes are extended for all robots",
        )
    first, *others = known.task.grid.axes
    axis, shift = _moved(first, over, known.task)
    plan = plan_again({**known.recipe, "over": [axis.text, *(a.text for a in others)]})
    fresh = TileStore.open(output, GridTiles(plan.task, plan.sentence, plan.recipe))
    for tile in range(plan.task.number):
        checkpoint()
        report(f"{tile + 1:,} of {plan.task.number:,} tiles looked at")
        if not fresh.there(tile) and _same(known.task, tile + shift, plan.task, tile):
            there = old.get(tile + shift)
            if there is not None:
                fresh.put(tile, there)
    return done(plan, how, work=output)


def _moved(first: GridAxis, over: str, task: MapTask) -> tuple[GridAxis, int]:
    """The coordinate over its other range, and how many tiles of the old map lie before it."""
    new = parse_axis(over, task.grid.unit, number=2)
    if new.name != first.name or new.unit != first.unit:
        raise InputError(
            f"tiles are whole layers along {first.name}: only it can be extended",
            hint=f'as in --over "{first.name} start:stop{f" {first.unit}" if first.unit else ""}"',
        )
    before, nodes = (new.start - first.start) / first.step, (new.stop - new.start) / first.step
    if before.denominator != 1 or nodes.denominator != 1 or int(before) % task.layers:
        raise InputError(
            f"the range of {first.name} is not of whole tiles of the store",
            hint=f"nodes are {float(first.step):g} apart, a tile has {task.layers} of them, one begins at "
            f"{float(first.start):g}",
        )
    return replace(new, number=int(nodes) + 1), int(before) // task.layers


def _same(old: MapTask, there: int, new: MapTask, here: int) -> bool:
    """Whether two tiles, of layers that begin at the same node, have the same nodes and the same cells."""
    if not 0 <= there < old.number or old.layers != new.layers:
        return False
    (start, stop), (low, high) = old.span(there), new.span(here)
    return stop - start == high - low and (stop == old.grid.shape[0]) == (high == new.grid.shape[0])
