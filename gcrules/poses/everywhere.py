"""Robots that are singular in every pose: what is asked of single poses, of ways and of ranges is answered by that."""

from __future__ import annotations

from gcrules.conditions.dimensions.dimensions import architecture_at
from gcrules.core.errors import SingularEverywhere
from gcrules.mechanisms.six_legs import SixLegs

__all__ = ["check_architecture"]


def check_architecture(m: SixLegs) -> None:
    """Raises SingularEverywhere where the dimensions make the platform singular in every pose."""
    found = architecture_at(m.rig.structure, m.rig.points)
    if found is not None and found.singular:
        raise SingularEverywhere(
            found.sentence.rstrip("."), hint="gcrules analyze says how this is known, and of which dimensions"
        )
