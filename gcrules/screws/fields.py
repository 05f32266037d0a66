r"""The fields that screws are computed in, and the choice of one by the numbers that are given.

>>> field_of((1, 2, 3)), field_of((1, 2, 0.5))
(Rationals(), Floats(tolerance=1e-09, length=1.0))
"""

from __future__ import annotations

from typing import Any

from gcrules.core.deferred import resolved
from gcrules.screws.exact import RATIONALS, RESIDUES, Exact, Rationals, Residues
from gcrules.screws.field import Field, Matrix, Row, Vector

__all__ = [
    "RATIONALS",
    "RESIDUES",
    "Exact",
    "Field",
    "Matrix",
    "Rationals",
    "Residues",
    "Row",
    "Vector",
    "field_of",
]


FLOATS = "gcrules.screws.floats:FLOATS"


def field_of(*values: Any) -> Field:
    """The field that numbers belong to: `FLOATS` if a float or an array is among them, else `RATIONALS`."""
    if any(map(_floating, values)):
        floats: Field = resolved(FLOATS)  # numpy is loaded when there are floats
        return floats
    return RATIONALS


def _floating(value: Any) -> bool:
    if isinstance(value, float) or hasattr(value, "dtype"):
        return True
    return isinstance(value, list | tuple) and any(map(_floating, value))
