"""One kind of thing that can be moved: a platform that limbs hold against a base, whatever the limbs are.

What computes or shows numbers asks this protocol. `SixLegs` and `Limbs` satisfy it: platforms with coordinates, and
robots that are described by their joints.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Protocol

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.kinematics.amplification import Drives
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source, load
from gcrules.mechanisms.robot import Robot
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.screws.pose import Pose

__all__ = ["NO_LIMITS", "Mechanism", "limits_of", "mechanism"]

NO_LIMITS = "none"
"""The word for limits with which not even those of the file hold."""


class Mechanism(Protocol):
    """A platform, a base, and what joins them. Lengths are in `unit`, which is "" where the file names none."""

    @property
    def title(self) -> str: ...

    @property
    def unit(self) -> str: ...

    @property
    def bodies(self) -> Mapping[str, tuple[str, ...]]:
        """The points of the "base" and of the "platform"."""

    @property
    def mobility(self) -> int:
        """The freedoms of the platform."""

    @property
    def actuators(self) -> tuple[str, ...]:
        """What is driven, by name."""

    @property
    def limits(self) -> str:
        """What its file says that legs or actuators reach, as written; "" where it says nothing."""

    def read_limits(self, text: str) -> LengthLimits:
        """Limits of its legs or actuators as they are written. Raises InputError."""

    @property
    def drives(self) -> Drives:
        """What its actuators drive, which tells what numbers they have."""

    @property
    def analysis(self) -> Analysis | RobotAnalysis:
        """When and why it is singular."""

    def wrenches(self, at: Pose | str | Mapping[str, Any] | None = None) -> WrenchJacobian:
        """What the limbs resist with at a pose, with the actuators locked; at home without one. Raises InputError for
        poses that it does not reach.
        """

    def six_legs(self) -> SixLegs:
        """The same as a platform on six legs. Raises InputError, which says why it is none and what it has instead."""


def limits_of(m: Mechanism, given: str | None) -> LengthLimits | None:
    """The limits that hold: those that are given, "none" for no limits; where none are given those of the file, if it
    has any. Raises InputError.
    """
    if given is None:
        return replace(m.read_limits(m.limits), of_file=True) if m.limits else None
    return None if given.strip().lower() == NO_LIMITS else m.read_limits(given)


def mechanism(source: Source, *, about: str | Sequence[Any] = "centroid", plugins: Folders = ()) -> Mechanism:
    """The mechanism of what `load` reads, with poses that turn `about` the "centroid" of the platform's joints, the
    "origin" of its file, or a point in the file's unit and frame.

    Raises InputError for legs without coordinates.
    """
    loaded = load(source, plugins=plugins)
    centre = about if isinstance(about, str) else tuple(about)  # so that the mechanism is a value
    if isinstance(loaded, (Robot, RobotAnalysis)):
        return Limbs.of(loaded, centre)
    platform = loaded.platform if isinstance(loaded, Analysis) else loaded
    if not isinstance(platform, Platform):
        raise InputError(
            "legs alone have no coordinates, which numbers need",
            hint='give a geometry file, legs and coordinates as in examples/octahedral.yaml; `gcrules studio "LEGS"`'
            ' writes one under "Take away". Without coordinates `gcrules analyze "LEGS"` gives the condition',
        )
    return SixLegs(platform, centre, loaded if isinstance(loaded, Analysis) else None)
