r"""A map as an xarray Dataset, and as NetCDF written chunk by chunk, both with units and metadata (CF conventions)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from gcrules.core.errors import InputError
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.task import KINDS
from gcrules.poses.maps.tiled import GridTiles
from gcrules.poses.maps.variables import Variable, coordinates, unit_of, variables
from gcrules.poses.tiles.keeping import copy_tiles

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["dataset", "netcdf", "tiles"]


def dataset(m: SingularMap) -> Dataset:
    """All arrays and curves in memory."""
    try:
        import xarray  # an extra of the installation
    except ImportError:
        raise InputError("datasets need xarray", hint='pip install "gcrules[maps]"') from None
    coords, data = {}, {}
    for name, v in coordinates(m.task).items():
        coords[name] = (v.dims, v.values, dict(v.attributes))
    for name, v in (_variables(m) | _curves(m)).items():
        data[name] = (v.dims, m.values(name) if v.values is None else v.values, dict(v.attributes))
    return xarray.Dataset(data, coords, dict(m.about))


def netcdf(m: SingularMap, path: str) -> None:
    """Write a NetCDF-4 file, a chunk at a time."""
    try:
        import h5netcdf  # an extra of the installation
    except ImportError:
        raise InputError("NetCDF files need h5netcdf", hint='pip install "gcrules[maps]"') from None
    small = coordinates(m.task) | _curves(m)
    large = _variables(m)
    with h5netcdf.File(path, "w") as file:
        file.dimensions = _sizes(small)
        for name, v in small.items():
            assert v.values is not None
            kind = _text_type() if v.values.dtype.kind == "U" else v.values.dtype
            made = file.create_variable(name, v.dims, kind)
            made[...] = v.values.astype(object) if v.values.dtype.kind == "U" else v.values
            made.attrs.update(v.attributes)
        for name, v in large.items():
            file.create_variable(name, v.dims, np.dtype(KINDS[name])).attrs.update(v.attributes)
        for first, chunk in m.chunks():
            for name in large:
                if len(chunk[name]):
                    file.variables[name][first : first + len(chunk[name])] = chunk[name]
        file.attrs.update(m.about)


def tiles(m: SingularMap, path: str) -> None:
    """Write a store of tiles, or see that it is there already."""
    copy_tiles(GridTiles(m.task, m.sentence, m.recipe), m.store, path)


def _text_type() -> Any:
    """The type of text of any length."""
    import h5py

    return h5py.string_dtype()


def _sizes(small: Mapping[str, Variable]) -> dict[str, int]:
    found: dict[str, int] = {}
    for v in small.values():
        assert v.values is not None
        found |= dict(zip(v.dims, v.values.shape, strict=True))
    return found


def _variables(m: SingularMap) -> dict[str, Variable]:
    """With what is known when all is computed."""
    more: dict[str, dict[str, Any]] = {"margin": {"threshold": m.sigma}, "cell_status": {"comment": m.guarantee}}
    found = variables(m.task)
    return {n: replace(v, attributes={**v.attributes, **more.get(n, {})}) for n, v in found.items()}


def _curves(m: SingularMap) -> dict[str, Variable]:
    if len(m.grid.axes) != 2:
        return {}
    points = np.concatenate([np.zeros((0, 2)), *(c.points for c in m.curves)])
    number = np.repeat(np.arange(len(m.curves)), [len(c.points) for c in m.curves]).astype(np.int32)
    allowed = np.concatenate([np.zeros(0, dtype=bool), *(c.allowed for c in m.curves)]).astype(np.uint8)
    dims = ("curve_point",)
    found = {
        f"curve_{a.name}": Variable(
            dims, {"long_name": f"singular curves: {a.meaning}", **unit_of(a.unit)}, points[:, k]
        )
        for k, a in enumerate(m.grid.axes)
    }
    found["curve_number"] = Variable(dims, {"long_name": "singular curves: number of the curve"}, number)
    found["curve_allowed"] = Variable(dims, {"long_name": "singular curves: 1 within the limits of lengths"}, allowed)
    return found
