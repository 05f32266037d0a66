r"""What is said of a free region, with all that another program needs to prove it again: `check_free.py` reads this.

>>> from gcrules.poses.regions.free_region import free_region
>>> found = region_certificate(free_region("3-rpr", over="x", boxes=50))
>>> found["shape"], [r["coordinate"] for r in found["question"]["over"]], found["question"]["rest"]
('box', ['x'], {'y': 0.0, 'yaw': 0.0})
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from typing import Any, Protocol

from gcrules.core.floats import rounded_down
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.certificate_files import platform_parts, pose_parts, signed
from gcrules.poses.compiling.checking import checkable
from gcrules.poses.methods import Methods, method
from gcrules.poses.recipe import described
from gcrules.screws.pose import Pose

__all__ = ["FORMAT", "JOINTS", "region_certificate"]

FORMAT = "gcrules free region 1"
JOINTS = "gcrules free region of joints 1"
_DIGITS = 6
_ROOM = 1 - 1e-9  # of half a range, for the rounding of its middle


class _Region(Protocol):
    """A `FreeRegion`, as far as it is needed here."""

    @property
    def title(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def shape(self) -> str: ...
    @property
    def names(self) -> tuple[str, ...]: ...
    @property
    def angles(self) -> tuple[bool, ...]: ...
    @property
    def driven(self) -> bool: ...
    @property
    def centre(self) -> tuple[float, ...]: ...
    @property
    def half_widths(self) -> tuple[float, ...]: ...
    @property
    def mechanism(self) -> Mechanism: ...
    @property
    def at(self) -> Pose | None: ...


def region_certificate(r: _Region) -> dict[str, Any]:
    """The robot and the region, whose half widths are rounded down. Raises LimitReached for a region of actuators, and
    for robots of joints whose limbs have no closed forms.
    """
    kind, parts = method(_PARTS, r.mechanism, "a free region")(r)
    return signed(kind, r.title, shape=r.shape, **parts)


def _of_legs(m: SixLegs, r: _Region) -> tuple[str, dict[str, Any]]:
    assert r.at is not None
    return FORMAT, {**platform_parts(m.rig), "pose": pose_parts(r.at), "over": list(_over(r))}


def _of_limbs(m: Limbs, r: _Region) -> tuple[str, dict[str, Any]]:
    found, _ = checkable(m, r.names, "free region", driven=r.driven)
    question = {
        **described(m),
        "over": list(_over(r)),
        "rest": {n: c for n, c, half in zip(r.names, r.centre, r.half_widths, strict=True) if not half},
        "limits": None,
        "cones": [],
        "tilt": None,
    }
    return JOINTS, {"question": question, "geometry": found}


def _over(r: _Region) -> Iterator[dict[str, str]]:
    """The coordinates that change, with their ends; angles in degrees."""
    for name, angle, middle, half in zip(r.names, r.angles, r.centre, r.half_widths, strict=True):
        if half:
            there, far = (math.degrees(c) if angle else c for c in (middle, half))
            ends = Fraction(f"{there:.15g}"), Fraction(rounded_down(far * _ROOM, _DIGITS))
            low, high = ends[0] - ends[1], ends[0] + ends[1]
            yield {"coordinate": name, "low": str(low), "high": str(high), "unit": "deg" if angle else r.unit}


_PARTS: Methods[tuple[str, dict[str, Any]]] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
