r"""Files of a map; the suffix says of what kind. Each appears complete or not at all."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence

from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.files import check_target, replacing
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.store import written
from gcrules.views.plots.map_data import netcdf
from gcrules.views.plots.map_meshes import glb, ply

__all__ = ["PICTURES", "SUFFIXES", "check_outputs", "save"]

picture = deferred("gcrules.views.plots.map_plot:picture")

PICTURES = (".svg", ".pdf", ".png")
_MESHES = {".ply": ply, ".glb": glb}
SUFFIXES = (".nc", *PICTURES, *_MESHES, ".json")


def check_outputs(paths: Sequence[str], axes: int) -> None:
    """Raises InputError for suffixes that are none of these or that do not suit the map, and for missing libraries;
    FileError for folders that are not there. Best called before anything is computed.
    """
    for path in paths:
        suffix = _suffix(path)
        if suffix not in SUFFIXES:
            raise InputError(f"{path}: no kind of output", hint=f"outputs end in {', '.join(SUFFIXES)}")
        if suffix in _MESHES and axes != 3:
            raise InputError(f"{path}: a surface needs three coordinates", hint="give --over three times")
        if suffix in _MESHES or (suffix in PICTURES and axes == 3):
            _need("skimage", "surfaces need scikit-image")
        if suffix == ".glb":
            _need("trimesh", "GLB files need trimesh")
        if suffix in PICTURES:
            _need("matplotlib", "pictures need matplotlib")
        if suffix == ".nc":
            _need("h5netcdf", "NetCDF files need h5netcdf")
            _need("h5py", "NetCDF files need h5py")
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
        try:
            with replacing(path) as temporary:
                _write(m, temporary, _suffix(path))
        except OSError as fault:
            raise written(fault, path) from None


def _write(m: SingularMap, path: str, suffix: str) -> None:
    if suffix == ".nc":
        netcdf(m, path)
        return
    if suffix in PICTURES:
        data = picture(m, suffix[1:])
    elif suffix in _MESHES:
        data = _MESHES[suffix](m.mesh)
    else:
        data = (json.dumps(m.to_json(), indent=2) + "\n").encode()
    with open(path, "xb") as file:
        file.write(data)
