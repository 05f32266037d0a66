"""The unit of length of a file, which stands once in it: `units: mm`."""

from __future__ import annotations

from collections.abc import Mapping

from gcrules.core.yaml_file import Node
from gcrules.screws.pose import UNITS

__all__ = ["UNIT_ONCE", "read_units"]

UNIT_ONCE = "the unit is given once in the file, as  units: {}"
"""The advice for a number that bears a unit."""


def read_units(top: Mapping[str, Node]) -> str:
    """The unit that the key `units` names, one of `gcrules.screws.pose.UNITS`; "" where there is none."""
    return top["units"].choice(UNITS) or "" if "units" in top else ""
