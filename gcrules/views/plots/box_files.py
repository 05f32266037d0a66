"""Files of a map of whole boxes; the suffix says of what kind. And the map as an xarray Dataset."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.tiles.keeping import copy_tiles
from gcrules.views.plots.map_formats import MapFormat, bytes_written, check_files, json_file, write_files

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["BOX_FORMATS", "dataset", "save"]

picture = deferred("gcrules.views.plots.box_plot:picture")


def _picture(kind: str) -> MapFormat:
    return MapFormat(bytes_written(lambda m: picture(m, kind)), (("matplotlib", "pictures need matplotlib"),))


def _tiles(m: BoxMap, path: str) -> None:
    copy_tiles(m.task, m.store, path)


BOX_FORMATS: Mapping[str, MapFormat] = FrozenMap(
    {
        ".zarr": MapFormat(_tiles, (("zarr", "stores of tiles need zarr"),), folder=True),
        ".svg": _picture("svg"),
        ".pdf": _picture("pdf"),
        ".png": _picture("png"),
        ".json": json_file(),
    }
)
"""Every kind of file, by its suffix."""


def save(m: BoxMap, paths: Sequence[str]) -> None:
    """Write all files. Raises as `check_files`, and FileError for files that cannot be written."""
    check_files(paths, BOX_FORMATS)
    write_files(m, paths, BOX_FORMATS)


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
