r"""Screw theory for limbs of parallel robots: twists of joints, wrenches reciprocal to them, mobility, Jacobians.

Exact on fractions and modulo a prime, and in floats for many configurations at once; numpy is loaded when there are
floats.

    >>> from gcrules.screws import joint, limb
    >>> leg = limb(joint("R", point=(1, 0, 0), axis=(0, 1, 0)), joint("P", direction=(0, 0, 1), actuated=True),
    ...            joint("S", point=(1, 0, 2)))
    >>> print(leg.locked_system().classify())
    planar pencil at (1, 0, 2) in the plane x = 1
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gcrules.core.deferred import resolved
from gcrules.screws.fields import RATIONALS, RESIDUES, Field, Rationals, Residues
from gcrules.screws.jacobians import LimbJacobian, RowLabel, jacobian
from gcrules.screws.joints import JOINTS, Joint, JointKind, joint
from gcrules.screws.kinds import KINDS, Classification
from gcrules.screws.limbs import Limb, limb
from gcrules.screws.lines import LineFamily
from gcrules.screws.platforms import Mobility, mobility
from gcrules.screws.screw import (
    ScrewAxis,
    axis,
    from_plucker,
    helical,
    line_through,
    moved,
    pitch,
    plucker,
    prismatic,
    product,
    revolute,
)
from gcrules.screws.systems import ScrewSystem, reciprocal

if TYPE_CHECKING:
    from gcrules.screws.floats import FLOATS, Floats

__all__ = [
    "FLOATS",
    "JOINTS",
    "KINDS",
    "RATIONALS",
    "RESIDUES",
    "Classification",
    "Field",
    "Floats",
    "Joint",
    "JointKind",
    "Limb",
    "LimbJacobian",
    "LineFamily",
    "Mobility",
    "Rationals",
    "Residues",
    "RowLabel",
    "ScrewAxis",
    "ScrewSystem",
    "axis",
    "from_plucker",
    "helical",
    "jacobian",
    "joint",
    "limb",
    "line_through",
    "mobility",
    "moved",
    "pitch",
    "plucker",
    "prismatic",
    "product",
    "reciprocal",
    "revolute",
]


def __getattr__(name: str) -> Any:
    if name in ("FLOATS", "Floats"):
        return resolved(f"gcrules.screws.floats:{name}")  # numpy is loaded when there are floats
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
