"""Files of a map of whole boxes; the suffix says of what kind. And the map as an xarray Dataset."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.files import check_target, replacing
from gcrules.core.frozen import FrozenMap
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.tiles.store import TileStore, written

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["BOX_FORMATS", "check_box_outputs", "dataset", "save"]

picture = deferred("gcrules.views.plots.box_plot:picture")


def _picture(kind: str) -> Callable[[BoxMap], bytes]:
    return lambda m: picture(m, kind)


def _json(m: BoxMap) -> bytes:
    return (json.dumps(m.to_json(), indent=2) + "\n").encode()


BOX_FORMATS: Mapping[str, Callable[[BoxMap], bytes] | None] = FrozenMap(
    {".zarr": None, ".svg": _picture("svg"), ".pdf": _picture("pdf"), ".png": _picture("png"), ".json": _json}
)
"""What makes each kind of file, by its suffix; a store is kept as it grows."""


def check_box_outputs(paths: Sequence[str]) -> None:
    """Raises InputError for suffixes that are none of these and for missing libraries, FileError for folders that are
    not there. Best called before anything is computed.
    """
    for path in paths:
        kind = _suffix(path)
        if kind not in BOX_FORMATS:
            raise InputError(f"{path}: no kind of output", hint=f"outputs end in {', '.join(BOX_FORMATS)}")
        for library in {".zarr": ("zarr",), ".json": ()}.get(kind, ("matplotlib",)):
            try:
                __import__(library)
            except ImportError:
                raise InputError(f"{kind} needs {library}", hint='pip install "gcrules[maps]"') from None
        check_target(path)
    twice = next((p for i, p in enumerate(paths) if p in paths[:i]), None)
    if twice is not None:
        raise InputError(f"{twice}: given twice as an output")


def save(m: BoxMap, paths: Sequence[str]) -> None:
    """Write all files; each appears complete or not at all. Raises as `check_box_outputs`, and FileError."""
    check_box_outputs(paths)
    for path in paths:
        make = BOX_FORMATS[_suffix(path)]
        try:
            if make is None:
                _kept(m, path)
                continue
            data = make(m)
            with replacing(path) as name, open(name, "xb") as file:
                file.write(data)
        except OSError as fault:
            raise written(fault, path) from None


def _kept(m: BoxMap, path: str) -> None:
    """The tiles as a store, which this may be already."""
    if isinstance(m.store, TileStore) and os.path.abspath(path) == str(m.store.path):
        return
    kept = TileStore.open(path, m.task)
    for tile in range(m.task.number):
        found = m.store.get(tile)
        if found is not None and not kept.there(tile):
            kept.put(tile, found)
    kept.settle_all()


def _suffix(path: str) -> str:
    return os.path.splitext(path)[1].lower()


def dataset(m: BoxMap) -> Dataset:
    """The arrays of all tiles, with the coordinates of their middles, in memory; not the trees of their boxes."""
    try:
        import xarray  # an extra of the installation
    except ImportError:
        raise InputError("datasets need xarray", hint='pip install "gcrules[maps]"') from None
    coords = {c.name: (c.dims, c.values, dict(c.attrs)) for c in m.task.coordinates}
    data = {}
    for a in m.task.arrays:
        if a.name == "tree":
            continue
        whole = np.zeros(a.shape, a.dtype)
        for tile in range(m.task.number):
            whole[a.region(m.task.grid, tile)] = m.tile(tile)[a.name]
        data[a.name] = (a.dims, whole, dict(a.attrs))
    return xarray.Dataset(data, coords, m.task.attrs)
