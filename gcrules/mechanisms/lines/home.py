r"""Wrenches of limbs at home, as numbers: for limbs whose wrenches are no lines of the robot's points.

>>> one = HomeWrench("leg 1", "constraint", (0.0, 0.0, 2.0), (1.0, 0.0, 0.0), 0.5)
>>> print(one)
leg 1, constraint: screw of pitch 0.5 through (0, 0, 2) along (1, 0, 0)
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.screws import RATIONALS, axis
from gcrules.screws.field import Row
from gcrules.screws.lines import vector_text

__all__ = ["HomeWrench", "home_wrenches"]

Numbers = tuple[float, float, float]


@dataclass(frozen=True)
class HomeWrench:
    """A wrench that a limb applies with its actuators locked: `role` is constraint or actuation, the latter as the pure
    force that it is modulo a constraint where there is one.

    Its axis goes through `point`, the one nearest to the origin, along the unit vector `direction`; `pitch` is the
    moment along the force over the force, in the unit of length of the home configuration, positive for a right-handed
    screw, 0 for a force. A couple has no point and no pitch.
    """

    limb: str
    role: str
    point: Numbers | None
    direction: Numbers
    pitch: float | None

    @property
    def kind(self) -> str:
        """Force, couple or screw."""
        if self.pitch is None:
            return "couple"
        return "screw" if self.pitch else "force"

    def to_json(self) -> dict[str, object]:
        point = None if self.point is None else list(self.point)
        return {
            "limb": self.limb,
            "role": self.role,
            "kind": self.kind,
            "pitch": self.pitch,
            "point": point,
            "direction": list(self.direction),
        }

    def __str__(self) -> str:
        pitch = f" of pitch {self.pitch:.6g}" if self.kind == "screw" else ""
        through = f" through {vector_text(self.point)}" if self.point else ""
        return f"{self.limb}, {self.role}: {self.kind}{pitch}{through} along {vector_text(self.direction)}"


def home_wrenches(robot: Robot, structure: Equivalent) -> tuple[HomeWrench, ...]:
    """The wrenches at home of the limbs that have no lines; none without a home configuration."""
    if robot.home is None or not any(limb.lines is None for limb in structure.limbs):
        return ()
    return tuple(_of_limbs(robot, structure))


def _of_limbs(robot: Robot, structure: Equivalent) -> Iterator[HomeWrench]:
    for found, limb in zip(structure.limbs, robot.limbs_at(), strict=True):
        if found.lines is None:
            held = limb.constraints(RATIONALS)
            yield from (_wrench(limb.name, "constraint", row) for row in held)
            yield from (_wrench(limb.name, "actuation", _pure(row, held)) for row in limb.actuations(RATIONALS))


def _pure(row: Row, held: Sequence[Row]) -> Row:
    """The force that a wrench is modulo one of the constraints, where a force or a couple among these makes it one:
    (f + t g)·(m + t k) is linear in t where g·k is 0.
    """
    f, m = row[:3], row[3:]
    for g, k in ((c[:3], c[3:]) for c in held if not RATIONALS.dot(c[:3], c[3:])):
        below = RATIONALS.dot(f, k) + RATIONALS.dot(g, m)
        if below:
            t = -RATIONALS.dot(f, m) / below
            return RATIONALS.combination((1, t), (row, (*g, *k)))
    return row


def _wrench(limb: str, role: str, row: Row) -> HomeWrench:
    """Exact up to here, so that a pitch of zero is one."""
    found = axis(row, RATIONALS)
    x, y, z = map(float, found.direction)
    sign = -1 if next(c for c in (x, y, z) if c) < 0 else 1
    length = sign * math.hypot(x, y, z)
    direction = (x / length + 0.0, y / length + 0.0, z / length + 0.0)
    if found.point is None:
        return HomeWrench(limb, role, None, direction, None)
    a, b, c = map(float, found.point)
    return HomeWrench(limb, role, (a, b, c), direction, float(found.pitch))
