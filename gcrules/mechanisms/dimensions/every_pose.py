"""Is a robot of joints singular in every pose of its own dimensions? Asked at home exactly, then in random poses.

A factor of the condition that rides on one body keeps its value: where it is 0 at home, it is so everywhere. Else a
robot whose wrenches have full rank at home, in exact numbers, is regular somewhere. One that is singular at home is
moved on to random poses near by, and measured there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from random import Random
from typing import TYPE_CHECKING, Any

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.language.text import text
from gcrules.conditions.dimensions.dimensions import architecture_at
from gcrules.conditions.dimensions.facts import Architecture
from gcrules.core.budget import checkpoint
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.platform_analysis import legs_of
from gcrules.mechanisms.robot import Robot
from gcrules.screws import RATIONALS

if TYPE_CHECKING:
    from gcrules.mechanisms.conditions.factor_causes import FactorCause

__all__ = ["architecture_of_robot"]

_linkage = deferred("gcrules.mechanisms.kinematics.linkage:linkage")
_margin = deferred("gcrules.mechanisms.kinematics.margin:margin")
_solve = deferred("gcrules.mechanisms.kinematics.solve:solve")
_free = deferred("gcrules.mechanisms.kinematics.solve:free_coordinates")
_target = deferred("gcrules.mechanisms.kinematics.targets:coordinates_target")

_POSES = 8
_ENOUGH = 4
_FAR = 0.05  # of the robot's size, or rad
_AT_HOME = "proved: at home, in exact numbers, the wrenches of the limbs have full rank"
_ROUNDING = 1e-7  # a margin that is 0 but for rounding and for how well loops are closed


def architecture_of_robot(
    robot: Robot, parts: Sequence[FactorCause], values: Mapping[str, Any], tolerance: float, *, nearly: bool
) -> Architecture:
    """The verdict for the robot with these exact places at home; `nearly` where facts hold within the tolerance only,
    so that it may be nearly singular everywhere.
    """
    try:
        platform = as_platform(robot)
        found = architecture_at(legs_of(platform), platform.points, tolerance)
    except InputError:  # other limbs than six legs
        found = None
    return found or _of_joints(robot, parts, values, tolerance, nearly)


def _of_joints(
    robot: Robot, parts: Sequence[FactorCause], values: Mapping[str, Any], tolerance: float, nearly: bool
) -> Architecture:
    closed = _exact(robot, values)
    try:
        held = closed and _held(robot, values)
    except InputError as lost:
        return Architecture("open", f"at home {lost.message}")
    if held and not nearly:
        return Architecture("regular", _AT_HOME)
    limit, seen = max(tolerance, _ROUNDING), []
    for margin in _margins(robot):
        seen.append(margin)
        if margin > limit:
            sure = _AT_HOME if held else f"seen: home or a pose nearby has the margin {margin:.2g}"
            return Architecture("regular", sure)
    if held and len(seen) < _ENOUGH:
        return Architecture("regular", _AT_HOME)
    worst = max(seen, default=0.0)
    near = f" and in {len(seen) - 1} random poses nearby" if len(seen) > 1 else ""
    size = "0 up to rounding" if worst <= _ROUNDING else f"at most {worst:.2g}"
    where = f"at home{near} the margin is {size}" if seen else "no margin was measured"
    zero = next((p for p in parts if p.of_design and _vanishes(robot, p, values)), None) if closed else None
    if zero is not None and not held:
        factor = text(zero.expression, names=tuple(robot.family.sorts))
        sure = f"the factor {factor} of the condition of its lines moves with one body, and is exactly 0; {where}"
        return Architecture("singular", sure, zero.statement)
    if len(seen) < _ENOUGH:
        return Architecture("open", f"{where}; too few other poses were reached to say more")
    if closed and not held and worst <= _ROUNDING:
        return Architecture(
            "seems singular", f"{where}, and at home it is singular in exact numbers; that is not a proof"
        )
    return Architecture("nearly singular", where)


def _exact(robot: Robot, values: Mapping[str, Any]) -> bool:
    """Whether home satisfies all relations without any tolerance."""
    return not any(
        any(d.relation.residual(d.sort, RATIONALS, values, values[d.name])) for d in robot.family.definitions
    )


def _held(robot: Robot, values: Mapping[str, Any]) -> bool:
    """Whether the wrenches at home have the rank that they have in the family, which is full."""
    general = ranks(robot.family, robot.limbs, robot.family.member("kinematics"))
    return ranks(robot.family, robot.limbs, values, RATIONALS).wrenches >= general.wrenches


def _vanishes(robot: Robot, part: FactorCause, values: Mapping[str, Any]) -> bool:
    return (
        part.kind in ("actuation", "constraint")
        and not part.chosen
        and not evaluate(part.expression, robot.family.homogeneous(values))
    )


def _margins(robot: Robot) -> Iterator[float]:
    """The margin at home, then those in random poses near by, so far as the loops close there."""
    try:
        m = _linkage(robot)
        yield _margin(m, m.home).sigma
        names = _free(m)
    except InputError:
        return
    draw = Random("poses of a robot that may be singular in all")
    for _ in range(_POSES):
        checkpoint()
        far = {n: draw.uniform(-_FAR, _FAR) * (m.size if n in "xyz" else 1.0) for n in names}
        try:
            yield _margin(m, _solve(m, _target(m, far)).configuration).sigma
        except InputError:
            continue
