"""Parts of a map that were computed on disks of their own, as one store."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath

from gcrules.core.budget import checkpoint, report
from gcrules.core.errors import FileError, InputError
from gcrules.poses.tiles.status import MapStatus, status_of
from gcrules.poses.tiles.store import TileStore, differing

__all__ = ["merge_maps"]


def merge_maps(stores: Sequence[str | PathLike[str]], output: str | PathLike[str]) -> MapStatus:
    """Put the tiles of several stores of one map into the new store `output` (a `MapStatus` of it).

    Damaged tiles are left out. Raises FileError where the stores are of different maps, where a tile is not the same in
    two of them, and where `output` is there already or cannot be written.
    """
    if not stores:
        raise InputError("no store is given", hint="name the stores of the parts")
    found = [TileStore.existing(s) for s in stores]
    first = found[0]
    for store, name in zip(found, stores, strict=True):
        if store.layout != first.layout:
            changed = differing(first.manifest, store.manifest)
            raise FileError(
                f"it is of another map than {fspath(stores[0])}: {', '.join(changed) or 'something'} differs",
                filename=fspath(name),
            )
    merged = first.copied(output)
    try:
        for tile in range(first.number):
            checkpoint()
            _merge(tile, found, merged)
            report(f"{tile + 1:,} of {first.number:,} tiles")
    except BaseException:
        merged.remove()
        raise
    merged.settle_all()
    return status_of(merged, fspath(output))


def _merge(tile: int, stores: Sequence[TileStore], merged: TileStore) -> None:
    held: dict[bytes, TileStore] = {}
    for store in stores:
        if store.there(tile) and (arrays := store.get(tile)) is not None:
            held.setdefault(merged.layout.packed(tile, arrays), store)
    if len(held) > 1:
        names = " and ".join(str(s.path) for s in held.values())
        raise FileError(
            f"tile {tile} is not the same in {names}",
            filename=str(merged.path),
            hint="gcrules map verify --tiles all tells which one is wrong; machines may differ by rounding",
        )
    if held:
        data = next(iter(held))
        arrays = merged.layout.unpacked(tile, data)
        assert arrays is not None
        merged.put(tile, arrays)
