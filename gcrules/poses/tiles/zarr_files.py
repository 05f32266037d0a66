"""The files of a store as Zarr v3 has them: made empty at once, read tile by tile, written shard by shard."""

from __future__ import annotations

import json
import os
import shutil
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.poses.tiles.layout import DIGEST, Layout
from gcrules.poses.tiles.task import TiledArray, TileTask, tile_at

__all__ = ["ATTRIBUTES", "arrays_in", "attributes", "digests_file", "has_zarr", "make", "opened", "written_shard"]

ATTRIBUTES = ("problem", "manifest", "recipe")
"""Attributes of a store that say of what its tiles are: the hash of the manifest, and the two others as JSON text."""
_LEVEL = 3  # of the compression


def has_zarr() -> bool:
    """Whether the extra is installed."""
    try:
        import zarr  # noqa: F401
    except ImportError:
        return False
    return True


def _zarr() -> Any:
    try:
        import zarr  # an extra of the installation
    except ImportError:
        raise InputError("maps in tiles need zarr", hint='pip install "gcrules[maps]"') from None
    return zarr


def make(path: Path, layout: Layout, task: TileTask) -> None:
    """Make the folder `path`, which is not there yet: a store whose tiles are all missing."""
    zarr = _zarr()
    about = {"problem": layout.problem, "manifest": _text(task.manifest), "recipe": _text(dict(task.recipe))}
    group = zarr.create_group(path, zarr_format=3, attributes={**task.attrs, **about})
    for a in layout.arrays:
        kind = np.dtype(a.dtype)
        group.create_array(
            a.name,
            shape=a.shape,
            chunks=a.chunk,
            shards=layout.shard_chunk(a),
            dtype=kind.newbyteorder("<"),
            fill_value=_missing(kind),
            compressors=[zarr.codecs.ZstdCodec(level=_LEVEL)],
            dimension_names=a.dims,
            attributes=dict(a.attrs),
        )
    names = task.arrays[0].dims[: len(layout.grid)]
    group.create_array(
        "digest",
        shape=(*layout.grid, DIGEST),
        chunks=(*layout.shard, DIGEST),
        dtype="u1",
        fill_value=0,
        compressors=None,
        dimension_names=(*(f"{n}_tile" for n in names), "byte"),
        attributes={"long_name": "SHA-256 of each tile, 0 where it is not done"},
    )
    for c in task.coordinates:
        text = c.values.dtype.kind == "U"
        made = group.create_array(
            c.name,
            shape=c.values.shape,
            chunks=c.values.shape,
            dtype="str" if text else c.values.dtype.newbyteorder("<"),
            compressors=None,
            dimension_names=c.dims,
            attributes=dict(c.attrs),
        )
        made[...] = c.values
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that this is no part of the specification yet; xarray asks for it
        zarr.consolidate_metadata(path)
    note = path / "zarr.json"
    note.write_text(_text(json.loads(note.read_text(encoding="utf-8"))), encoding="utf-8")


def _text(value: Any) -> str:
    return json.dumps(value, sort_keys=True)


def _missing(kind: np.dtype[Any]) -> Any:
    """What stands where nothing is known: not a number, or a number that means nothing, unlike 0."""
    if kind.kind == "f":
        return np.nan
    limits = np.iinfo(kind)
    return limits.max if kind.kind == "u" else limits.min


def attributes(path: Path) -> Mapping[str, Any] | None:
    """The metadata of a store of ours; None where there is none."""
    try:
        found = json.loads((path / "zarr.json").read_text(encoding="utf-8"))
        return found if set(ATTRIBUTES) <= set(found["attributes"]) else None
    except (OSError, ValueError, KeyError, TypeError):
        return None


def arrays_in(found: Mapping[str, Any]) -> Layout:
    """How tiles lie in the store with this metadata."""
    known = found["consolidated_metadata"]["metadata"]
    arrays = []
    for name, one in known.items():
        codec = one["codecs"][0] if one.get("codecs") else {}
        if codec.get("name") == "sharding_indexed":
            chunk = tuple(codec["configuration"]["chunk_shape"])
            dims, shape = tuple(one["dimension_names"]), tuple(one["shape"])
            arrays.append(TiledArray(name, dims, shape, chunk, one["data_type"], FrozenMap(one["attributes"])))
    return Layout(found["attributes"]["problem"], tuple(known["digest"]["shape"][:-1]), tuple(arrays))


def opened(path: Path) -> Any:
    """The group, to be read."""
    return _zarr().open_group(path, mode="r")


def digests_file(path: Path, layout: Layout, shard: int) -> Path:
    """The digests of the tiles of a shard: a chunk without compression, which is there when the shard is."""
    return path.joinpath("digest", "c", *map(str, tile_at(layout.shards, shard)), "0")


def written_shard(
    path: Path, scratch: Path, layout: Layout, shard: int, tiles: Mapping[int, Mapping[str, NDArray[Any]]]
) -> None:
    """Write all arrays of a shard in the folder `scratch`, each file then renamed into the store."""
    zarr = _zarr()
    with zarr.config.set({"array.write_empty_chunks": True}):
        for a in layout.arrays:
            region = layout.region(a, shard)
            shape = tuple(s.stop - s.start for s in region)
            if not all(shape):
                continue  # the array ends before
            values = np.empty(shape, a.dtype)
            for tile, arrays in tiles.items():
                there = a.region(layout.grid, tile)
                values[_shifted(there, region)] = arrays[a.name]
            folder = scratch / a.name
            folder.mkdir(parents=True)
            shutil.copyfile(path / a.name / "zarr.json", folder / "zarr.json")
            zarr.open_array(folder, mode="r+")[region] = values
            key = Path("c", *map(str, (*tile_at(layout.shards, shard), *(0,) * (len(a.shape) - len(layout.grid)))))
            target = path / a.name / key
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(folder / key, target)


def _shifted(region: tuple[slice, ...], within: tuple[slice, ...]) -> tuple[slice, ...]:
    return tuple(slice(r.start - w.start, r.stop - w.start) for r, w in zip(region, within, strict=True))
