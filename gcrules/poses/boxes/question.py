"""What is asked of a map of whole boxes: over which coordinates, what the others are, and within which limits."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.solve import check_target
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism, limits_of
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.everywhere import check_architecture
from gcrules.poses.maps.axes import ACTUATOR, TRANSLATION, TURNS, GridAxis, check_turns, read_ranges
from gcrules.poses.maps.limb_grid import coordinates_of
from gcrules.poses.maps.nodes import in_words, others
from gcrules.poses.methods import Methods, method
from gcrules.poses.numbers.pose_arguments import one_pose
from gcrules.screws.pose import FAR, too_far

__all__ = ["Question", "question"]


@dataclass(frozen=True)
class Question:
    """Poses over the `axes`, whose nodes are the borders of tiles; `names` are all coordinates that determine a pose,
    `values` what they are where no axis stands for them (in radians and the file's `unit`), `size` is the robot's,
    `chosen` says that of several configurations home's is meant, `sentence` is the condition.
    """

    axes: tuple[GridAxis, ...]
    names: tuple[str, ...]
    values: tuple[float, ...]
    limits: LengthLimits | None
    size: float
    unit: str
    chosen: bool
    sentence: str

    @property
    def always_reached(self) -> bool:
        """Whether each pose is reached: that of six legs without limits."""
        return not self.chosen and self.limits is None

    @property
    def free(self) -> tuple[int, ...]:
        """The places of the axes' coordinates among all."""
        return tuple(self.names.index(a.name) for a in self.axes)

    @property
    def weights(self) -> tuple[float, ...]:
        """By how much coordinates change that are worth the same: the robot's size, or 1 rad."""
        return tuple(self.size if a.name in TRANSLATION else 1.0 for a in self.axes)

    @property
    def rest(self) -> str:
        """What the other coordinates are, in words."""
        return in_words(self.others, self.unit)

    @property
    def others(self) -> dict[str, float]:
        """The other coordinates, in radians and the file's unit."""
        return others(self.axes, self.names, self.values)


def question(m: Mechanism, over: Sequence[str | GridAxis], at: Any, limits: str | None, tiles: int | None) -> Question:
    """What is asked for. Raises InputError for what makes no sense."""
    drives = {a.name: a.angle for a in leading(m.linkage)} if isinstance(m, Limbs) else {}
    axes = read_ranges(over, m.unit, tiles, drives)
    foreign = next((a for a in axes if a.name not in (*TRANSLATION, *TURNS)), None)
    if foreign is not None:
        more = "; gcrules free --over actuators proves ranges of actuators" if foreign.kind == ACTUATOR else ""
        raise InputError(
            f"whole boxes cannot range over {foreign.name}", hint=f"take x, y, z, roll, pitch or yaw{more}"
        )
    check_turns(axes)
    found = method(_QUESTION, m, "a map of whole boxes")(axes, at, limits)
    far = next((a for a in axes if a.name in TRANSLATION and max(-a.start, a.stop) > FAR * found.size), None)
    if far is not None:
        raise too_far(f"{far.name} goes")
    return found


def _of_legs(m: SixLegs, axes: tuple[GridAxis, ...], at: Any, limits: str | None) -> Question:
    pose = one_pose(at, {}, False, m.unit)
    if pose is None:
        raise InputError("a map is around one pose", hint='at="0 0 5; euler zyx 10 0 0 deg"')
    check_architecture(m)
    r = np.array(pose.rotation, dtype=np.float64)
    turns = (np.arctan2(r[2, 1], r[2, 2]), -np.arcsin(np.clip(r[2, 0], -1, 1)), np.arctan2(r[1, 0], r[0, 0]))
    values = tuple(float(c) + 0.0 for c in (*pose.translation, *turns))
    if max(map(abs, values)) > FAR * m.rig.size:
        raise too_far("a pose is")
    reach = limits_of(m, limits)
    return Question(
        axes, (*TRANSLATION, *reversed(TURNS)), values, reach, m.rig.size, m.unit, False, m.analysis.condition.sentence
    )


def _of_limbs(m: Limbs, axes: tuple[GridAxis, ...], at: Any, limits: str | None) -> Question:
    k: Linkage = m.linkage
    names, values = coordinates_of(k, axes, at, driven=False)
    check_target(k, Target(names, np.zeros(len(names)), text="home"))
    reach = limits_of(m, limits)
    if reach is not None:
        _check_whole_turns(reach)
    return Question(axes, names, values, reach, k.size, m.unit, True, m.analysis.statement)


def _check_whole_turns(reach: LengthLimits) -> None:
    """Raises InputError for limits more than a turn away: a pose does not tell how often a drive has turned round."""
    for name, low, high, angle in zip(reach.names, reach.low, reach.high, reach.angles, strict=True):
        if angle and max((abs(c) for c in (low, high) if math.isfinite(c)), default=0.0) > math.tau + 1e-9:
            raise InputError(
                f"the limits of {name} are more than a turn from home",
                hint=(
                    "turns that differ by whole revolutions are not distinguished here: write them between"
                    " -360 and 360 deg"
                ),
            )


_QUESTION: Methods[Question] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
