r"""A map as an xarray Dataset, and as NetCDF written chunk by chunk, both with units and metadata (CF conventions)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.task import KINDS

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["Variable", "dataset", "netcdf"]

_DIMENSIONS = {
    "leg_length": ("leg", "legs of the robot"),
    "actuator": ("driven", "actuators of the robot"),
}
"""The further dimension of arrays that have one."""
_UNITS = {"deg": "degree", "rad": "radian"}


@dataclass(frozen=True, eq=False)
class Variable:
    """The dimensions and attributes of a variable, and its values unless they come chunk by chunk."""

    dims: tuple[str, ...]
    attributes: Mapping[str, Any]
    values: NDArray[Any] | None = None


def dataset(m: SingularMap) -> Dataset:
    """All arrays and curves in memory."""
    try:
        import xarray  # an extra of the installation
    except ImportError:
        raise InputError("datasets need xarray", hint='pip install "gcrules[maps]"') from None
    coords, data = {}, {}
    for name, v in _coordinates(m).items():
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
    small = _coordinates(m) | _curves(m)
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


def _coordinates(m: SingularMap) -> dict[str, Variable]:
    found = {}
    for a in m.grid.axes:
        about = {"long_name": a.meaning, **_unit(a.unit)}
        found[a.name] = Variable((a.name,), about, a.nodes)
        middles = a.at(np.arange(0.5, a.number - 1))
        found[f"{a.name}_cell"] = Variable(
            (f"{a.name}_cell",), {"long_name": f"{a.name} in the middle of cells", **_unit(a.unit)}, middles
        )
    for name, (dimension, words) in _DIMENSIONS.items():
        if name in m.arrays:
            found[dimension] = Variable((dimension,), {"long_name": words}, np.array(m.grid.actuators))
    return found


def _unit(unit: str) -> dict[str, str]:
    return {"units": _UNITS.get(unit, unit)} if unit else {}


def _variables(m: SingularMap) -> dict[str, Variable]:
    names = tuple(a.name for a in m.grid.axes)
    unit = m.grid.unit
    about: dict[str, dict[str, Any]] = {
        "superbracket": {
            "long_name": "superbracket of the six legs, 0 in singular poses",
            **({"units": f"{unit}9"} if unit else {}),
        },
        "margin": {
            "long_name": "margin sigma, 0 in singular poses, at most 1",
            "units": "1",
            "comment": m.task.guard,
            "threshold": m.sigma,
        },
        "sign": {
            "long_name": "sign of the determinant of all wrenches, 0 where it is not known",
            "comment": "that of the first node is 1; singular poses part the signs",
        },
        "leg_length": {"long_name": "lengths of the legs", **_unit(unit)},
        "actuator": {"long_name": "amounts of the actuators from home, angles in radians"},
        "allowed": {
            "long_name": "whether the pose is reached within the limits of legs or actuators",
            "flag_values": np.array([0, 1], dtype=np.uint8),
            "flag_meanings": "outside within",
            "limits": m.limits.text if m.limits else "none",
        },
        "cell_status": {
            "long_name": "whether the cell is proved free of singular poses",
            "flag_values": np.arange(len(MEANINGS), dtype=np.uint8),
            "flag_meanings": " ".join(MEANINGS),
            "comment": m.guarantee,
        },
    }
    for name in set(INDICES) & set(m.arrays):
        own = INDICES[name].unit(unit, m.grid.angles_driven)
        about[name] = {"long_name": INDICES[name].meaning, "units": own or "1"}
    dims = {name: (*names, dimension) for name, (dimension, _) in _DIMENSIONS.items()}
    dims["cell_status"] = tuple(f"{n}_cell" for n in names)
    return {name: Variable(dims.get(name, names), about[name]) for name in m.arrays}


def _curves(m: SingularMap) -> dict[str, Variable]:
    if len(m.grid.axes) != 2:
        return {}
    points = np.concatenate([np.zeros((0, 2)), *(c.points for c in m.curves)])
    number = np.repeat(np.arange(len(m.curves)), [len(c.points) for c in m.curves]).astype(np.int32)
    allowed = np.concatenate([np.zeros(0, dtype=bool), *(c.allowed for c in m.curves)]).astype(np.uint8)
    dims = ("curve_point",)
    found = {
        f"curve_{a.name}": Variable(dims, {"long_name": f"singular curves: {a.meaning}", **_unit(a.unit)}, points[:, k])
        for k, a in enumerate(m.grid.axes)
    }
    found["curve_number"] = Variable(dims, {"long_name": "singular curves: number of the curve"}, number)
    found["curve_allowed"] = Variable(dims, {"long_name": "singular curves: 1 within the limits of lengths"}, allowed)
    return found
