r"""What a map says of its cells, with all that another program needs to recompute it: `check_map.py` reads this file.

>>> from gcrules.poses.maps.maps import singular_map
>>> points = {"a": (0, 0, 0), "b": (4, 0, 0), "c": (2, 3, 0), "d": (1, 1, 2), "e": (3, 1, 2), "f": (2, 2, 2)}
>>> robot = {"legs": "ad ae be bf cf cd", "points": points}
>>> found = cell_certificate(singular_map(robot, ["x -1:1:3", "z -1:1:3"]))
>>> found["cells"], found["claim"]
(['ff', 'ff'], {'free': 4, 'crossed': 0, 'undecided': 0})
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, Protocol

from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.certificate_files import platform_parts, pose_parts, signed, texts
from gcrules.poses.compiling.checking import checkable, led
from gcrules.poses.compiling.tape import Program
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.maps.grid import Grid
from gcrules.poses.maps.limb_certificate import limb_question, stated_cells
from gcrules.poses.maps.limb_task import LimbsTask
from gcrules.poses.maps.slices import SliceFactor
from gcrules.poses.maps.task import MapTask, Slice

__all__ = [
    "DRIVEN",
    "FORMAT",
    "JOINTS",
    "LETTERS",
    "MAX_CELLS",
    "cell_certificate",
    "check_cells",
]

FORMAT = "gcrules map certificate 1"
JOINTS = "gcrules map certificate of joints 1"
DRIVEN = "gcrules map certificate of actuators 1"
LETTERS = "fxuo"
"""Of the statuses, in their order; o is for robots of joints over coordinates of their pose."""
MAX_CELLS = 4_000_000
"""Cells that a certificate may have."""


class _Map(Protocol):
    """A `SingularMap`, as far as it is needed here."""

    @property
    def task(self) -> MapTask: ...
    @property
    def grid(self) -> Slice: ...
    @property
    def factors(self) -> tuple[SliceFactor, ...] | None: ...
    @property
    def everywhere(self) -> bool: ...
    @property
    def recipe(self) -> Mapping[str, Any]: ...

    def values(self, name: str) -> Any: ...


def check_cells(task: MapTask) -> tuple[dict[str, Any], Program | None] | None:
    """The geometry and the roots of a robot of joints, without roots over actuators; None for six legs. Raises
    LimitReached for more than `MAX_CELLS` cells, for robots of joints whose limbs have no closed forms, and over
    actuators where no checker closes the loops.
    """
    if math.prod(n - 1 for n in task.grid.shape) > MAX_CELLS:
        raise LimitReached(f"a certificate has at most {MAX_CELLS:,} cells", hint="use a coarser grid, or several maps")
    if not isinstance(task, LimbsTask):
        return None
    if task.grid.driven:
        return led(task.mechanism, "map"), None
    return checkable(task.mechanism, task.grid.names, "map")


def cell_certificate(m: _Map) -> dict[str, Any]:
    """The robot, the slice and the status of each cell, as JSON. Cells are listed by the axes, the last of which is a
    text: f free, x crossed, u undecided, o outside. `digest` is the SHA-256 of all else. Numbers are exact, and texts,
    but for the geometry of joints, which has floats as certificates of ranges have.

    Raises LimitReached as `check_cells`, and InputError where every pose is singular on a slice that is no polynomial,
    which is seen at random poses.
    """
    forms, status = check_cells(m.task), m.values("cell_status")
    if forms and isinstance(m.task, LimbsTask):
        grid, (geometry, roots) = m.task.grid, forms
        status = stated_cells(grid, status, roots)
        title, parts = grid.title, {"question": limb_question(grid, m.recipe), "geometry": geometry}
    else:
        title, parts = _of_legs(m)
    kind = FORMAT if not forms else JOINTS if forms[1] else DRIVEN
    meanings = MEANINGS if kind == JOINTS else MEANINGS[:3]
    claim = {word: int((status == k).sum()) for k, word in enumerate(meanings)}
    return signed(kind, title, **parts, cells=_rows(status), claim=claim)


def _of_legs(m: _Map) -> tuple[str, dict[str, Any]]:
    """The title; the platform, the slice and the factors."""
    g = m.grid
    assert isinstance(g, Grid)
    if m.everywhere and m.factors is None:
        raise InputError(
            "this map has no certificate: that every pose is singular was seen at random poses",
            hint="over coordinates that do not turn the platform it is proved",
        )
    turned = g.rotation_axis is not None
    pose = pose_parts(g.at)
    return g.rig.title, {
        **platform_parts(g.rig),
        "pose": {**pose, "quaternion": None, "angles": texts(g.angles)} if turned else {**pose, "angles": None},
        "axes": [
            {"name": a.name, "start": str(a.start), "stop": str(a.stop), "number": a.number, "unit": a.unit}
            for a in g.axes
        ],
        "factors": None
        if m.factors is None
        else [
            {"multiplicity": f.multiplicity, "terms": [[list(e), str(c)] for e, c in f.form.terms]} for f in m.factors
        ],
    }


def _rows(status: Any) -> Any:
    if status.ndim > 1:
        return [_rows(part) for part in status]
    return "".join(LETTERS[k] for k in status.tolist())
