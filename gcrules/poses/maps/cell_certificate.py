r"""What a map says of its cells, with all that another program needs to recompute it: `check_map.py` reads this file.

>>> from gcrules.poses.maps.maps import singular_map
>>> points = {"a": (0, 0, 0), "b": (4, 0, 0), "c": (2, 3, 0), "d": (1, 1, 2), "e": (3, 1, 2), "f": (2, 2, 2)}
>>> robot = {"legs": "ad ae be bf cf cd", "points": points}
>>> found = cell_certificate(singular_map(robot, ["x -1:1:3", "z -1:1:3"]))
>>> found["cells"], found["claim"]
(['ff', 'ff'], {'free': 4, 'crossed': 0, 'undecided': 0})
"""

from __future__ import annotations

import gzip
import hashlib
import json
import math
from collections.abc import Mapping
from typing import Any, Protocol

from gcrules.core.errors import FileError, InputError, LimitReached
from gcrules.core.version import __version__
from gcrules.poses.compiling.tape import Program
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.maps.grid import Grid
from gcrules.poses.maps.limb_certificate import limb_forms, limb_question, stated_cells
from gcrules.poses.maps.limb_task import LimbsTask
from gcrules.poses.maps.slices import SliceFactor
from gcrules.poses.maps.task import MapTask, Slice

__all__ = [
    "FORMAT",
    "JOINTS",
    "LETTERS",
    "MAX_CELLS",
    "cell_certificate",
    "cells_bytes",
    "check_cells",
    "is_certificate",
]

FORMAT = "gcrules map certificate 1"
JOINTS = "gcrules map certificate of joints 1"
LETTERS = "fxuo"
"""Of the statuses, in their order; o is for robots of joints."""
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


def is_certificate(path: str) -> bool:
    """Whether a name is one for a certificate."""
    return path.lower().endswith((".json", ".json.gz"))


def check_cells(task: MapTask) -> tuple[dict[str, Any], Program] | None:
    """The geometry and the roots of a robot of joints, None for six legs. Raises LimitReached for more than `MAX_CELLS`
    cells, and for robots of joints whose limbs have no closed forms.
    """
    if math.prod(n - 1 for n in task.grid.shape) > MAX_CELLS:
        raise LimitReached(f"a certificate has at most {MAX_CELLS:,} cells", hint="use a coarser grid, or several maps")
    return limb_forms(task.mechanism, task.grid) if isinstance(task, LimbsTask) else None


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
        parts = {"title": grid.title, "question": limb_question(grid, m.recipe), "geometry": geometry}
    else:
        parts = _of_legs(m)
    meanings = MEANINGS if forms else MEANINGS[:3]
    found = {
        "format": JOINTS if forms else FORMAT,
        "made by": f"gcrules {__version__}",
        **parts,
        "cells": _rows(status),
        "claim": {word: int((status == k).sum()) for k, word in enumerate(meanings)},
    }
    return {**found, "digest": _digest(found)}


def _of_legs(m: _Map) -> dict[str, Any]:
    """The platform, the slice and the factors."""
    g = m.grid
    assert isinstance(g, Grid)
    if m.everywhere and m.factors is None:
        raise InputError(
            "this map has no certificate: that every pose is singular was seen at random poses",
            hint="over coordinates that do not turn the platform it is proved",
        )
    return {
        "title": g.rig.title,
        "unit": g.rig.unit,
        "legs": [list(leg) for leg in g.rig.legs],
        "points": {n: _texts(g.rig.points[n]) for leg in g.rig.legs for n in leg},
        "centre": _texts(g.rig.centre),
        "pose": {
            "translation": _texts(g.at.translation),
            "quaternion": _texts(g.at.quaternion) if g.rotation_axis is None else None,
            "angles": None if g.rotation_axis is None else _texts(g.angles),
        },
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


def cells_bytes(m: _Map, path: str) -> bytes:
    """The file, packed where its name ends in .gz. Raises FileError for a name of something else."""
    if not is_certificate(path):
        raise FileError("not a name for a certificate", filename=path, hint="certificates end in .json or .json.gz")
    text = json.dumps(cell_certificate(m), separators=(",", ":")).encode() + b"\n"
    return gzip.compress(text, mtime=0) if path.lower().endswith(".gz") else text


def _texts(numbers: Any) -> list[str]:
    return [str(c) for c in numbers]


def _rows(status: Any) -> Any:
    if status.ndim > 1:
        return [_rows(part) for part in status]
    return "".join(LETTERS[k] for k in status.tolist())


def _digest(found: dict[str, Any]) -> str:
    return hashlib.sha256(json.dumps(found, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
