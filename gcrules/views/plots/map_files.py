r"""Files of a map; the suffix says of what kind. Each appears complete or not at all."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.files import check_target, replacing
from gcrules.core.frozen import FrozenMap
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.tiles.store import written
from gcrules.views.plots.map_data import netcdf, tiles
from gcrules.views.plots.map_meshes import glb, ply

__all__ = ["MAP_FORMATS", "MapFormat", "check_outputs", "save"]

picture = deferred("gcrules.views.plots.map_plot:picture")

_Write = Callable[[SingularMap, str], None]


@dataclass(frozen=True)
class MapFormat:
    """A kind of file: `write` makes a new file of this name. `needs` are libraries with what needs them, `in_space`
    those that maps over three coordinates need too; a `surface` is of such maps only. A `folder` is kept as it grows,
    and `write` takes its own name.
    """

    write: _Write
    needs: tuple[tuple[str, str], ...] = ()
    in_space: tuple[tuple[str, str], ...] = ()
    surface: bool = False
    folder: bool = False


def _data(made: Callable[[SingularMap], bytes]) -> _Write:
    """A file of the bytes that a function makes."""

    def write(m: SingularMap, path: str) -> None:
        data = made(m)
        with open(path, "xb") as file:
            file.write(data)

    return write


def _picture(form: str) -> MapFormat:
    needs = (("matplotlib", "pictures need matplotlib"),)
    return MapFormat(_data(lambda m: picture(m, form)), needs, (_SURFACES,))


def _mesh(made: Callable[[Any], bytes], *needs: tuple[str, str]) -> MapFormat:
    return MapFormat(_data(lambda m: made(m.mesh)), needs, (_SURFACES,), surface=True)


def _json(m: SingularMap) -> bytes:
    return (json.dumps(m.to_json(), indent=2) + "\n").encode()


_SURFACES = ("skimage", "surfaces need scikit-image")
_HDF = (("h5netcdf", "NetCDF files need h5netcdf"), ("h5py", "NetCDF files need h5py"))

MAP_FORMATS: Mapping[str, MapFormat] = FrozenMap(
    {
        ".nc": MapFormat(netcdf, _HDF),
        ".zarr": MapFormat(tiles, (("zarr", "stores of tiles need zarr"),), folder=True),
        ".svg": _picture("svg"),
        ".pdf": _picture("pdf"),
        ".png": _picture("png"),
        ".ply": _mesh(ply),
        ".glb": _mesh(glb, ("trimesh", "GLB files need trimesh")),
        ".json": MapFormat(_data(_json)),
    }
)
"""Every kind of file, by its suffix."""


def check_outputs(paths: Sequence[str], axes: int) -> None:
    """Raises InputError for suffixes that are none of these or that do not suit the map, and for missing libraries;
    FileError for folders that are not there. Best called before anything is computed.
    """
    for path in paths:
        form = MAP_FORMATS.get(_suffix(path))
        if form is None:
            raise InputError(f"{path}: no kind of output", hint=f"outputs end in {', '.join(MAP_FORMATS)}")
        if form.surface and axes != 3:
            raise InputError(f"{path}: a surface needs three coordinates", hint="give --over three times")
        for library, words in (*(form.in_space if axes == 3 else ()), *form.needs):
            _need(library, words)
        check_target(path)
    twice = next((p for i, p in enumerate(paths) if p in paths[:i]), None)
    if twice is not None:
        raise InputError(f"{twice}: given twice as an output")


def _suffix(path: str) -> str:
    return os.path.splitext(path)[1].lower()


def _need(module: str, words: str) -> None:
    try:
        __import__(module)
    except ImportError:
        raise InputError(words, hint='pip install "gcrules[maps]"') from None


def save(m: SingularMap, paths: Sequence[str]) -> None:
    """Write all files. Raises as `check_outputs`, and FileError for files that cannot be written."""
    check_outputs(paths, len(m.grid.axes))
    for path in paths:
        form = MAP_FORMATS[_suffix(path)]
        try:
            with nullcontext(path) if form.folder else replacing(path) as name:
                form.write(m, name)
        except OSError as fault:
            raise written(fault, path) from None
