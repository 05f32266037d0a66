r"""Files of a map; the suffix says of what kind. Each appears complete or not at all."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.poses.maps.report import SingularMap
from gcrules.views.plots.map_data import netcdf, tiles
from gcrules.views.plots.map_formats import MapFormat, bytes_written, check_files, json_file, need, suffix, write_files
from gcrules.views.plots.map_meshes import glb, ply

__all__ = ["MAP_FORMATS", "check_outputs", "save"]

picture = deferred("gcrules.views.plots.map_plot:picture")


def _picture(form: str) -> MapFormat:
    needs = (("matplotlib", "pictures need matplotlib"),)
    return MapFormat(bytes_written(lambda m: picture(m, form)), needs, (_SURFACES,))


def _mesh(made: Callable[[Any], bytes], *needs: tuple[str, str]) -> MapFormat:
    return MapFormat(bytes_written(lambda m: made(m.mesh)), needs, (_SURFACES,), surface=True)


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
        ".json": json_file(),
    }
)
"""Every kind of file, by its suffix."""


def check_outputs(paths: Sequence[str], axes: int) -> None:
    """Raises as `check_files`, and InputError for files that do not suit a map over so many coordinates."""
    check_files(paths, MAP_FORMATS)
    for path in paths:
        form = MAP_FORMATS[suffix(path)]
        if form.surface and axes != 3:
            raise InputError(f"{path}: a surface needs three coordinates", hint="give --over three times")
        for library, words in form.in_space if axes == 3 else ():
            need(library, words)


def save(m: SingularMap, paths: Sequence[str]) -> None:
    """Write all files. Raises as `check_outputs`, and FileError for files that cannot be written."""
    check_outputs(paths, len(m.grid.axes))
    write_files(m, paths, MAP_FORMATS)
