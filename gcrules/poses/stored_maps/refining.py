"""A map that begins with what another one has: of boxes finer where it is undecided, and all over wider ranges."""

from __future__ import annotations

import os
from collections.abc import Sequence
from fractions import Fraction
from os import PathLike, fspath

from gcrules.core.budget import checkpoint, report
from gcrules.core.errors import FileError, InputError
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.box_map import boxes_done
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.boxes.task import MOST_BOXES, BoxTask, box_task
from gcrules.poses.maps.axes import GridAxis, parse_axis
from gcrules.poses.maps.cells import CROSSED, UNDECIDED
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.tiled import GridTiles
from gcrules.poses.recipe import robot_of
from gcrules.poses.stored_maps.extending import extended
from gcrules.poses.stored_maps.kinds import task_of
from gcrules.poses.tiles.how import running
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import tile_at

__all__ = ["refine_map"]

_FINER = 4

Ends = tuple[tuple[Fraction, Fraction], ...]


def refine_map(
    store: str | PathLike[str],
    output: str | PathLike[str],
    boxes: int | None = None,
    over: Sequence[str] | None = None,
    *,
    workers: int = 0,
    scheduler: str | None = None,
) -> BoxMap | SingularMap:
    """The map of a `store` once more, in the new store `output`: exactly what a run of its own would give.

    One of whole boxes (a `BoxMap`) with more `boxes` in each tile (four times as many), or `over` other ranges that are
    whole tiles of it. Tiles that are decided, and those that would not be halved further, are taken over; the others
    are computed. One over nodes of a platform on six legs (a `SingularMap`) `over` another range of its first
    coordinate. `workers` and `scheduler` are those of `singular_map`. Raises FileError for a store of something else,
    InputError for ranges that cut its tiles.
    """
    how = running(workers, None, scheduler)
    if os.path.abspath(store) == os.path.abspath(output):
        raise FileError(
            "a store cannot be refined into itself", filename=fspath(output), hint="give the new one a name"
        )
    old = TileStore.existing(store)
    known = task_of(old)
    if isinstance(known, GridTiles):
        if boxes is not None or over is None or len(over) != 1:
            raise InputError(
                "a map over nodes is extended along its first coordinate, and not refined",
                hint='as in --over "x -200:400"; gcrules map boxes refines where it is undecided',
            )
        return extended(old, known, fspath(output), over[0], how)
    if not isinstance(known, BoxTask):
        raise FileError("neither a map over nodes nor one of whole boxes", filename=fspath(store))
    most = boxes or (known.boxes if over else min(_FINER * known.boxes, MOST_BOXES))
    if most < known.boxes:
        raise InputError(f"{most:,} boxes are fewer than the {known.boxes:,} of the store")
    given = known.recipe
    axes = _axes(over, known) if over else known.question.axes
    robot = mechanism(robot_of(given["robot"]), about=given["about"])
    task = box_task(robot, axes, given["at"], given["limits"], given["margin"], None, most)
    task.check()
    fresh = TileStore.open(output, task)
    _take_over(old, known, fresh, task)
    return boxes_done(task, how, work=output)


def _axes(over: Sequence[str], known: BoxTask) -> tuple[GridAxis, ...]:
    """The ranges, cut as the tiles of the store are. Raises InputError where that is not possible."""
    before = {a.name: a for a in known.question.axes}
    axes = {a.name: a for a in (parse_axis(text, known.mechanism.unit, number=2) for text in over)}
    foreign = next((n for n in axes if n not in before), None)
    if foreign is not None:
        raise InputError(f"the store is not over {foreign}", hint=f"it is over {', '.join(before)}")
    found = []
    for name, old in before.items():
        new = axes.get(name, old)
        if new is old:
            found.append(old)
            continue
        first, count = (new.start - old.start) / old.step, (new.stop - new.start) / old.step
        if new.unit != old.unit or first.denominator != 1 or count.denominator != 1:
            raise InputError(
                f"the range of {name} is not of whole tiles of the store",
                hint=f"they are {f'{float(old.step):g} {old.unit}'.rstrip()} wide, one begins at {float(old.start):g}",
            )
        found.append(GridAxis(name, new.start, new.stop, int(count) + 1, old.unit))
    return tuple(found)


def _take_over(old: TileStore, known: BoxTask, fresh: TileStore, task: BoxTask) -> None:
    """Copy the tiles that would be computed alike."""
    places = {_ends(known, tile): tile for tile in range(known.number)}
    for tile in range(task.number):
        checkpoint()
        report(f"{tile + 1:,} of {task.number:,} tiles looked at")
        source = places.get(_ends(task, tile))
        found = None if source is None or fresh.there(tile) else old.get(source)
        if found is None:
            continue
        codes = found["tree"].ravel()
        status = known.leaves(codes, source or 0).status
        if task.boxes > known.boxes and ((status == UNDECIDED) | (status == CROSSED)).any():
            continue
        tree = task.padded(codes)
        fresh.put(tile, {**found, "tree": tree})


def _ends(task: BoxTask, tile: int) -> Ends:
    """The exact ends of a tile."""
    at = tile_at(task.grid, tile)
    return tuple(
        (a.start + k * a.step, a.start + (k + 1) * a.step) for a, k in zip(task.question.axes, at, strict=True)
    )
