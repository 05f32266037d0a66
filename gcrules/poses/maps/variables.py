"""The arrays of a map and their coordinates as files have them: dimensions, units, and what they mean (CF)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.version import __version__
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.maps.task import MapTask

__all__ = ["Variable", "about", "coordinates", "unit_of", "variables"]

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


def about(task: MapTask, sentence: str) -> dict[str, str]:
    """What a map is, for the attributes of files; no dates, so that equal maps are equal files."""
    title = task.grid.title or "a robot"
    found = {
        "Conventions": "CF-1.11",
        "title": f"Singular poses of {title} over {', '.join(a.name for a in task.grid.axes)}",
        "source": f"gcrules {__version__}",
        **task.about(sentence),
        "axes": "; ".join(a.text for a in task.grid.axes),
        "limits": task.limits.text if task.limits else "none",
    }
    return {k: v for k, v in found.items() if v}


def coordinates(task: MapTask) -> dict[str, Variable]:
    """The nodes of the axes, the middles of cells, and the names of legs or actuators."""
    found = {}
    for a in task.grid.axes:
        words = {"long_name": a.meaning, **unit_of(a.unit)}
        found[a.name] = Variable((a.name,), words, a.nodes)
        middles = a.at(np.arange(0.5, a.number - 1))
        found[f"{a.name}_cell"] = Variable(
            (f"{a.name}_cell",), {"long_name": f"{a.name} in the middle of cells", **unit_of(a.unit)}, middles
        )
    for name, (dimension, meaning) in _DIMENSIONS.items():
        if name in task.names:
            found[dimension] = Variable((dimension,), {"long_name": meaning}, np.array(task.grid.actuators))
    return found


def unit_of(unit: str) -> dict[str, str]:
    """The attribute of a unit, where there is one."""
    return {"units": _UNITS.get(unit, unit)} if unit else {}


def variables(task: MapTask) -> dict[str, Variable]:
    """The arrays, without their values."""
    names = tuple(a.name for a in task.grid.axes)
    unit = task.grid.unit
    words: dict[str, dict[str, Any]] = {
        "superbracket": {
            "long_name": "superbracket of the six legs, 0 in singular poses",
            **({"units": f"{unit}9"} if unit else {}),
        },
        "margin": {
            "long_name": "margin sigma, 0 in singular poses, at most 1",
            "units": "1",
            "comment": task.guard,
        },
        "sign": {
            "long_name": "sign of the determinant of all wrenches, 0 where it is not known",
            "comment": "that of the first node is 1; singular poses separate the signs",
        },
        "leg_length": {"long_name": "lengths of the legs", **unit_of(unit)},
        "actuator": {"long_name": "amounts of the actuators from home, angles in radians"},
        "allowed": {
            "long_name": f"whether the pose was reached: 0 where it is {task.beyond}",
            "flag_values": np.array([0, 1], dtype=np.uint8),
            "flag_meanings": "outside within",
            "limits": task.limits.text if task.limits else "none",
        },
        "cell_status": {
            "long_name": "whether the cell is proved free of singular poses",
            "flag_values": np.arange(len(MEANINGS), dtype=np.uint8),
            "flag_meanings": " ".join(MEANINGS),
        },
    }
    for name in set(INDICES) & set(task.names):
        own = INDICES[name].unit(unit, task.grid.angles_driven)
        words[name] = {"long_name": INDICES[name].meaning, "units": own or "1"}
    dims = {name: (*names, dimension) for name, (dimension, _) in _DIMENSIONS.items()}
    dims["cell_status"] = tuple(f"{n}_cell" for n in names)
    return {name: Variable(dims.get(name, names), words[name]) for name in task.names}
