"""A surface as triangles."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import HoldsArrays

__all__ = ["Mesh"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class Mesh(HoldsArrays):
    """`vertices` and unit `normals` (V, 3), `faces` (F, 3); `sheet` (V,) is the factor that is 0 there; `allowed` (V,)
    says which vertices keep to the limits of leg lengths; `accurate` which were brought onto the zero set.

    Normals point to where the sheet's factor (or the superbracket) is positive, and so do the faces.
    """

    vertices: Floats
    normals: Floats
    faces: Integers
    sheet: NDArray[np.uint8]
    allowed: NDArray[np.bool_]
    accurate: NDArray[np.bool_]
    names: tuple[str, ...]
    units: tuple[str, ...]
    about: Mapping[str, Any]

    @property
    def sheets(self) -> int:
        return int(self.sheet.max()) + 1 if len(self.sheet) else 0

    def __repr__(self) -> str:
        return f"<Mesh of {len(self.faces):,} triangles in {self.sheets} sheets>"
