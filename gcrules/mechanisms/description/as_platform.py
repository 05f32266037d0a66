r"""Robots described by their joints whose six limbs are legs of variable length: read as platforms with dimensions.

Such a leg is UPS, SPU or SPS: it turns about a point of the base and a point of the platform, and what is driven
between them changes their distance. With its actuator locked the link between the two joints is one body, so that all
it resists with is the force along the line through both points, whatever the direction of its slide.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from gcrules.algebra.language.legs_text import leg_text
from gcrules.algebra.structure import Structure
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.limits import limits_of_limbs
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.description.relations import pair_or_name
from gcrules.mechanisms.robot import Robot

__all__ = ["as_platform"]

_ENDS = (("U", "S"), ("S", "U"), ("S", "S"))  # with two joints U it would resist a couple, too


def as_platform(robot: Robot) -> Platform:
    """The platform that the robot is at home, with a leg from the base to the platform for each limb; for each line
    where six lines between its points are all that holds the platform.

    Raises InputError, which says why, for robots with other limbs, and for those without a home configuration.
    """
    legs = [_leg(robot, limb) for limb in robot.limbs]
    other = next((limb for limb, leg in zip(robot.limbs, legs, strict=True) if leg is None), None)
    lines = _lines(robot)
    found = lines or tuple(leg for leg in legs if leg is not None)
    reason = ""
    if len(robot.limbs) != 6 and not lines:
        reason = f"it has {len(robot.limbs) or 'no'} limbs, not six"
    elif other is not None:
        reason = f"{other.name or 'a limb'} ({other.chain}) is not a leg UP*S between two points"
    elif robot.home is None:
        reason = "it has no home configuration"
    elif (name := _tied(robot, found)) is not None:
        reason = f"the place of {name} depends on the other body"
    if reason:
        raise InputError(
            f"{robot.id} is described by its joints and cannot be read as a platform: {reason}",
            hint=f'numbers in single configurations: gcrules pose {robot.id} --at "…" (gc.pose); the first singular one'
            f' on a way: gcrules robot pose {robot.id} --at "…" --search (gc.singular)',
        )
    values = robot.values_at()
    points = {name: values[name] for leg in found for name in leg}
    return Platform(
        legs=found,
        points={n: (x, y, z) for n, (x, y, z) in points.items()},
        title=robot.title,
        note=robot.note,
        units=robot.units,
        source=robot.source,
        filename=robot.filename,
        limits="" if lines else _lengths(robot, found, points),
    )


def _lines(robot: Robot) -> tuple[tuple[str, str], ...]:
    """The lines that a robot is given by, the base joint first, if they are six legs; else none."""
    if robot.mobility != 6 or any(robot.family.sorts.get(n) != "point" for line in robot.lines for n in line):
        return ()
    return Structure(robot.lines).oriented if robot.lines else ()


def _leg(robot: Robot, limb: LimbSpec) -> tuple[str, str] | None:
    """The ends of the leg that a limb is, if it is one."""
    if len(limb.joints) != 3:
        return None
    first, slide, last = limb.joints
    if (first.kind, last.kind) not in _ENDS or slide.kind != "P" or not slide.actuated:
        return None
    if first.actuated or last.actuated:
        return None
    (start,), (end,), (along,) = first.points, last.points, slide.directions
    return (start, end) if start != end and _carried(robot, [n for _, n in along], {start, end}) else None


def _lengths(robot: Robot, legs: Sequence[tuple[str, str]], points: Mapping[str, Sequence[Fraction]]) -> str:
    """The limits of the file as those of the legs' lengths; none where a slide does not go along its leg."""
    if not robot.limits:
        return ""
    reach, found = limits_of_limbs(robot.limits, robot.limbs, robot.units), []
    for limb, leg, low, high in zip(robot.limbs, legs, reach.low, reach.high, strict=True):
        (along,) = limb.joints[1].directions
        if low == -math.inf and high == math.inf:
            continue
        if along == pair_or_name(" ".join(reversed(leg))):
            low, high = -high, -low
        elif along != pair_or_name(" ".join(leg)):
            return ""
        home = math.dist(*([float(c) for c in points[end]] for end in leg))
        if home + high <= max(home + low, 0.0):
            return ""
        least = f"{home + low:.15g}" if home + low > 0 else ""
        most = f"{home + high:.15g}" if high < math.inf else ""
        if least or most:
            found.append(f"{leg_text(leg)} {least}..{most}")
    return ", ".join(found)


def _carried(robot: Robot, names: Iterable[str], ends: set[str]) -> bool:
    """Whether a direction is named by the ends of the leg at most, so that no other limb holds it."""
    uses = {d.name: d.relation.names for d in robot.family.definitions}
    return all(
        n in ends if robot.family.sorts.get(n) == "point" else _carried(robot, uses.get(n, ()), ends) for n in names
    )


def _tied(robot: Robot, legs: tuple[tuple[str, str], ...]) -> str | None:
    """A point whose relation uses points of the other body, so that motion does not keep it."""
    uses = {d.name: d.relation.names for d in robot.family.definitions}

    def roots(name: str) -> set[str]:
        return {name}.union(*(roots(other) for other in uses.get(name, ())))

    base, platform = ({leg[end] for leg in legs} for end in (0, 1))
    for name in (*base, *platform):
        if roots(name) & (platform if name in base else base):
            return name
    return None
