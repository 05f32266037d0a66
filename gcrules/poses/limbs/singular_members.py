r"""A singular configuration for each factor of a robot's condition: exact, near home, a member of the family.

From home one name moves along a line, or all free points of the platform together. Every coordinate is a polynomial in
the parameter, and so is the factor; its rational roots are exact members at which it vanishes. There the ranks of the
wrenches are taken from the joint screws, not from the lines, and the motion that the platform gains with them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import combinations
from math import dist
from typing import Any

from gcrules.algebra.expr import points_of
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError
from gcrules.core.linear_algebra import echelon
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.conditions.factor_causes import FactorCause, upstream
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.lines.ranks import Ranks, ranks
from gcrules.mechanisms.robot import Robot
from gcrules.poses.limbs.exact_values import Values, Vector, gained, value_at
from gcrules.poses.limbs.meeting import meeting
from gcrules.poses.paths.rational_roots import polynomial, rational_roots
from gcrules.screws import RATIONALS

__all__ = ["SingularPose", "home_parameters", "live_parts", "singular_pose"]

Parameters = dict[str, tuple[Fraction, ...]]

_STEPS: Mapping[int, tuple[tuple[int, ...], ...]] = {
    1: ((1,),),
    2: ((1, 0), (0, 1), (1, 1), (1, -1)),
    3: ((1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)),
}
_REACH = Fraction(8, 5)  # how far a name may move, in sizes of the robot
_UNLIKE_A_POSE = 0.8  # what it costs to move something else than what the last joints of the limbs are made of
_NEAR = 0.12  # sizes: points that come nearer than this are hard to tell apart


@dataclass(frozen=True)
class SingularPose:
    """A configuration in which `part` vanishes: the names `moved` go along `step` by `t`, the rest follows or stays.

    `ranks` are those of the joint screws there, `before` those of the family. `motion` is the twist (ω; v) that the
    locked limbs leave to the platform, None where they leave more than one.
    """

    part: FactorCause
    values: Values
    moved: tuple[str, ...]
    ranks: Ranks
    before: Ranks
    motion: tuple[Fraction, ...] | None


def live_parts(a: RobotAnalysis) -> tuple[FactorCause, ...]:
    """The factors at which the robot, not only a limb or the chosen lines, is singular."""
    return tuple(p for p in a.parts if p.kind in ("actuation", "constraint", "mixed") and p.same is None)


def singular_pose(a: RobotAnalysis, part: FactorCause) -> SingularPose | None:
    """The most telling of the exact singular configurations that are found near home; None where there is none."""
    robot = a.robot
    if robot.home is None or not robot.limbs:
        return None
    home = home_values(robot)
    parameters = home_parameters(robot, home)
    if parameters is None:
        return None
    generic = ranks(robot.family, robot.limbs, robot.family.member("generic"))
    best: tuple[float, SingularPose] | None = None
    for cost, values, moved in sorted(_candidates(a, part, home, parameters), key=lambda c: (c[0], c[2])):
        if best is not None and cost >= best[0]:
            break
        found = _checked(robot, part, values, moved, generic)
        if found is None:
            continue
        total = round(cost + _hidden(a, found), 6)
        if best is None or total < best[0]:
            best = total, found
    return best[1] if best else None


def _hidden(a: RobotAnalysis, pose: SingularPose) -> float:
    """What speaks against a pose because the reason is not to be seen in it."""
    cost = 0.0 if pose.motion else 4.0
    points = [leg for leg in a.structure.legs if not set(leg).intersection(a.structure.ideal)]
    cost += 3.0 * any(_one_line(pose.values, one, other) for one, other in combinations(points, 2))
    met = meeting(a, pose.part, pose.values)
    if met is None:
        return cost
    apart = min(
        (dist(met[0], tuple(map(float, pose.values[d.name]))) for d in a.robot.family.definitions if d.sort == "point"),
        default=1.0,
    )
    cost += 1.5 * (apart < _NEAR * _size(a.robot.family, pose.values))
    far = dist(met[0], _middle(a.robot, pose.values)) / _size(a.robot.family, pose.values)
    return cost + (2.0 if met[1] else 1.5 * max(0.0, far - 0.7))


def _one_line(values: Values, one: tuple[str, str], other: tuple[str, str]) -> bool:
    """Whether two lines of points are one."""
    a, b, c, d = (values[n] for n in (*one, *other))
    u = RATIONALS.vector([y - x for x, y in zip(a, b, strict=True)])
    return not any(
        any(RATIONALS.cross(u, RATIONALS.vector([y - x for x, y in zip(a, p, strict=True)]))) for p in (c, d)
    )


def _middle(robot: Robot, values: Values) -> tuple[float, ...]:
    points = [values[d.name] for d in robot.family.definitions if d.sort == "point"]
    return tuple(float(sum(p[i] for p in points)) / len(points) for i in range(3))


def home_parameters(robot: Robot, home: Values) -> Parameters | None:
    """The parameters of the family's member at home (directions up to their lengths); None where home has none."""
    found: Parameters = {}
    values: dict[str, Any] = {n: RATIONALS.vector(axis) for n, axis in AXES.items()}
    for d in robot.family.definitions:
        count = d.parameters
        zero = d.relation.value(d.sort, RATIONALS, values, (Fraction(0),) * count)
        columns = [
            [x - z for x, z in zip(d.relation.value(d.sort, RATIONALS, values, _unit(count, i)), zero, strict=True)]
            for i in range(count)
        ]
        solved, pivots = echelon([[*(c[k] for c in columns), home[d.name][k] - zero[k]] for k in range(3)])
        numbers = [Fraction(0)] * count
        for row, column in zip(solved, pivots, strict=True):
            if column < count:
                numbers[column] = Fraction(row[count])
        found[d.name] = tuple(numbers)
        values[d.name] = d.relation.value(d.sort, RATIONALS, values, numbers)
        if d.sort == "point" and values[d.name] != home[d.name]:
            return None  # home satisfies the relation only up to rounding
    return found


def _unit(count: int, place: int) -> tuple[Fraction, ...]:
    return tuple(Fraction(int(i == place)) for i in range(count))


def _checked(
    robot: Robot, part: FactorCause, values: Values, moved: tuple[str, ...], generic: Ranks
) -> SingularPose | None:
    """The pose, if the joint screws say that the robot, and no limb by itself, is singular there."""
    try:
        here = ranks(robot.family, robot.limbs, values, RATIONALS)
        motions = gained(robot, values)
    except GcrulesError:  # a joint is none at this member
        return None
    if here.limbs != generic.limbs or here.wrenches >= generic.wrenches:
        return None
    if part.kind != "mixed" and (here.constraints < generic.constraints) != (part.kind == "constraint"):
        return None
    return SingularPose(part, values, moved, here, generic, motions[0] if len(motions) == 1 else None)


# --- candidates ----------------------------------------------------------------------------------------------------


def _candidates(
    a: RobotAnalysis, part: FactorCause, home: Values, parameters: Parameters
) -> Iterator[tuple[float, Values, tuple[str, ...]]]:
    """Members with their costs: how far they are from home, and how easily they are read."""
    family, structure = a.robot.family, a.structure
    size = _size(family, home)
    others = [p.expression for p in live_parts(a) if p is not part]
    moving = {*a.robot.platform, *(n for limb in a.robot.limbs for n in limb.joints[-1].names)}
    moving -= {n for limb in a.robot.limbs for n in limb.joints[0].names}
    wanted = [*points_of(part.expression), *(n for d in structure.derived for n in d.names)]
    needed = upstream(family, wanted)
    for names, step in _moves(a.robot):
        if needed.isdisjoint(names):
            continue
        counts = {n: len(parameters[n]) for n in names}

        def at(t: Fraction, names: tuple[str, ...] = names, step: tuple[int, ...] = step) -> dict[str, Vector]:
            new = {n: tuple(p + t * s for p, s in zip(parameters[n], step, strict=True)) for n in names}
            return family.at({**parameters, **new}, RATIONALS)

        if any(c != len(step) for c in counts.values()):
            continue
        f = polynomial(lambda t, at=at: value_at(family, structure, at(t), part.expression))  # type: ignore[misc]
        for t in rational_roots(f, _REACH * _scale(family, home, names[0], size)) if f else ():
            values = at(t)
            cost = _cost(a.robot, home, values, size)
            if cost is not None:
                cost += 3 * sum(value_at(family, structure, values, e) == 0 for e in others)
                cost += 0.3 * (sum(map(abs, step)) - 1) + _UNLIKE_A_POSE * (not moving.issuperset(names))
                yield round(cost, 6), values, names


def _moves(robot: Robot) -> Iterator[tuple[tuple[str, ...], tuple[int, ...]]]:
    """Which names move, and in which direction of their parameters."""
    plane = robot.family.plane
    sets: list[tuple[str, ...]] = [(n,) for n in robot.family.parametrized]
    free = {d.name for d in robot.family.definitions if d.relation.kind == "free" and d.sort == "point"}
    if len(robot.platform) > 2 and free.issuperset(robot.platform):
        sets.append(robot.platform)
    definitions = {d.name: d for d in robot.family.definitions}
    for names in sets:
        for step in _STEPS[definitions[names[0]].parameters]:
            if not (plane and len(step) == 3 and step[2]):
                yield names, step


def _size(family: Family, values: Values) -> float:
    """The largest distance of two points; 1 for fewer than two."""
    points = [tuple(map(float, values[d.name])) for d in family.definitions if d.sort == "point"]
    return max((dist(p, q) for p in points for q in points), default=0.0) or 1.0


def _scale(family: Family, home: Values, name: str, size: float) -> Fraction:
    """How far a name may go: points by the size of the robot, directions by their length."""
    length = sum(c * c for c in home[name]) ** 0.5 if family.sorts[name] == "direction" else size
    return Fraction(round(float(length) * 16), 16) or Fraction(1)


def _cost(robot: Robot, home: Values, values: Values, size: float) -> float | None:
    """How far from home a member is and how long its numbers are; None where it is no good to be shown."""
    family = robot.family
    shift = 0.0
    for d in family.definitions:
        here, there = (tuple(map(float, v[d.name])) for v in (values, home))
        if d.sort == "direction":
            if not any(here):
                return None
            continue
        shift = max(shift, dist(here, there) / size)
    turned = max((_turn(values[d.name], home[d.name]) for d in family.definitions if d.sort == "direction"), default=0)
    points = [tuple(map(float, values[d.name])) for d in family.definitions if d.sort == "point"]
    near = min((dist(p, q) / size for i, p in enumerate(points) for q in points[:i]), default=1.0)
    if near < _NEAR / 4 or shift > 1.2:
        return None
    digits = max(len(str(c)) for d in family.definitions for c in values[d.name])
    return (
        2.5 * shift + 2.0 * turned + 0.15 * max(0, digits - 2) + 4 * max(0.0, 1 - near / _NEAR) + _flat(robot, values)
    )


def _turn(a: Sequence[Fraction], b: Sequence[Fraction]) -> float:
    """The sine of the angle between two directions, 2 where they are more than a right angle apart."""
    u, v = (tuple(map(float, w)) for w in (a, b))
    product = sum(x * y for x, y in zip(u, v, strict=True))
    squares = sum(x * x for x in u) * sum(x * x for x in v)
    return 2.0 if product < 0 else max(0.0, 1 - product * product / squares) ** 0.5


def _flat(robot: Robot, values: Values) -> float:
    """What speaks against a platform whose points are nearly on a line."""
    points = [tuple(map(float, values[n])) for n in robot.platform]
    if len(points) < 3:
        return 0.0
    a, b = max(((p, q) for p in points for q in points), key=lambda pair: round(dist(*pair), 9))
    long = dist(a, b) or 1.0
    high = 0.0
    for p in points:
        u = [x - y for x, y in zip(p, a, strict=True)]
        v = [x - y for x, y in zip(b, a, strict=True)]
        along = sum(x * y for x, y in zip(u, v, strict=True)) / long
        high = max(high, max(sum(x * x for x in u) - along * along, 0.0) ** 0.5 / long)
    return 5 * max(0.0, 1 - high / 0.3)
