"""Making a task anew from what its store says of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from gcrules.core.errors import FileError, GcrulesError
from gcrules.core.frozen import FrozenMap
from gcrules.poses.boxes import task as boxes
from gcrules.poses.maps import planned, tiled
from gcrules.poses.tiles.layout import layout_of
from gcrules.poses.tiles.store import TileStore, differing
from gcrules.poses.tiles.task import TileTask

__all__ = ["KINDS", "task_of"]

_AGAIN: dict[str, Callable[[Mapping[str, Any]], TileTask]] = {
    planned.KIND: tiled.task_again,
    boxes.KIND: boxes.task_again,
}
KINDS: Mapping[str, Callable[[Mapping[str, Any]], TileTask]] = FrozenMap(_AGAIN)
"""For each `kind` of a recipe the function that makes the task of it."""


def task_of(store: TileStore) -> TileTask:
    """The task whose tiles a store holds. Raises FileError where this is not the task: it says in what they differ."""
    recipe = store.recipe
    kind = str(recipe.get("kind"))
    if kind not in KINDS:
        raise FileError(f"its tiles are of another kind: {kind[:40]}", filename=str(store.path))
    try:
        task = KINDS[kind](recipe)
    except (GcrulesError, KeyError, TypeError, ValueError) as fault:
        raise FileError(f"what it is of is not read: {fault}", filename=str(store.path)) from None
    if layout_of(task) != store.layout:
        changed = differing(store.manifest, task.manifest)
        raise FileError(
            f"its task is another one now: {', '.join(changed) or 'its arrays'} differ",
            filename=str(store.path),
            hint="tiles are computed again by the version that made them",
        )
    return task
