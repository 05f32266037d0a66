r"""Where a robot of joints cannot be led on, for `map_actuators.py`: singular configurations at the end of a branch.

Along q + t d the boxes of `certificate_driven.py` end where the derivative J by the unknown amounts x is singular. So t
is taken to be unknown too, and what is given is how far along a direction of (x, t) a solution is: a curve of solutions
is proved around the place where t turns back. It begins on the branch, and bounds on t show that it lies over the way.
The determinant of J has different signs at its ends: between them it is 0.
"""

from __future__ import annotations

import math

from certificate_bounds import U, mix
from certificate_driven import MORE, Driven, total, values
from map_turns import sign_in

FINEST = 1 / 500  # steps towards a singular configuration
WITHIN = 1e-9  # parts of the way, which is between floats
REACHES = (1, 2, 4, 8, 16)  # of such steps, along the curve on which it lies


class Along(Driven):
    """A robot whose actuators' amounts are q + t d, t unknown as well: solutions along a curve, which can go on where t
    turns back. What is given is the place along a direction of (x, t).
    """

    def __init__(self, robot, q, d, x, t, direction):
        self.robot, self.q, self.d, self.names = robot, q, d, ("along",)
        self.unknown, self.begin, self.direction = (*robot.unknown, "t"), (*x, t), direction

    def look(self, q, ways, thick, x, slopes, reach):
        found = self.robot.look(
            [a + x[-1] * b for a, b in zip(self.q, self.d)],
            [[s[-1] * b for b in self.d] for s in slopes],
            [abs(b) * reach[-1] + 8 * U * (abs(a) + abs(x[-1] * b)) for a, b in zip(self.q, self.d)],
            x[:-1],
            [s[:-1] for s in slopes],
            reach[:-1],
        )
        if found is None:
            return None
        gaps, (by_x, by_q) = found
        still = gaps[0] * 0.0
        there = values([a - b for a, b in zip(x, self.begin)], slopes, reach)
        last = mix(there, self.direction) + values(q, ways, thick)[0] * -1.0
        by_x = [[*row, mix(rates, self.d)] for row, rates in zip(by_x, by_q)]
        by_x.append([still + c for c in self.direction])
        return [*gaps, last], [by_x, [*([still] for _ in gaps), [still + -1.0]]]

    def sign(self, place):
        """That of the determinant of the robot's equations at a place; 0 where it is not known."""
        t, far = place.x[-1], place.reach[-1]
        found = self.robot.look(
            [a + t * b for a, b in zip(self.q, self.d)],
            [],
            [abs(b) * far + 8 * U * (abs(a) + abs(t * b)) for a, b in zip(self.q, self.d)],
            place.x[:-1],
            [],
            place.reach[:-1],
        )
        return 0 if found is None else sign_in(found[1][0])


def turns_back(robot, place, q):
    """Whether it is proved that on the straight way to q the branch of a place comes to a singular configuration, where
    the curve of solutions goes on, and beyond which the determinant has the other sign.
    """
    start, d = place.q, [b - a for a, b in zip(place.q, q)]
    t, step = 0.0, 0.5
    while step > FINEST and t < 1:
        there = robot.way(place, [a + (t + step) * b for a, b in zip(start, d)], 0)
        if there is None:
            step /= 2
        else:
            place, t, step = there, t + step, min(step, 1 - t - step)
    room = [8 * U * (abs(a) + abs(b)) for a, b in zip(start, d)]
    short = FINEST / 1000
    before = robot.known(place.q, [[short * c for c in d]], place.x, room) if t < 1 else None
    if before is None or not before.holds(place):
        return False
    rates = [c / short for c in before.slopes[0]]
    size = math.sqrt(total(rates, rates) + 1)
    curve = Along(robot, start, d, place.x, t, [*(c / size for c in rates), 1 / size])
    for far in REACHES:
        half = far * step * size
        box = curve.known([half], [[half]], [a + half * b for a, b in zip(curve.begin, curve.direction)])
        if box is None:
            continue
        ends = [curve.place([c], box.at([c])) for c in (0.0, 2 * half)]
        if None in ends or not all(map(box.holds, ends)):
            continue
        wide = (abs(box.slopes[0][-1]) + box.reach[-1]) * MORE
        off = (abs(ends[0].x[-1] - t) + ends[0].reach[-1] + U) / short
        joined = off < 0.5 and all(
            abs(a - b) * MORE + e + off * abs(c) * MORE + U * (abs(a) + abs(b)) < r
            for a, b, c, e, r in zip(ends[0].x, before.x, before.slopes[0], ends[0].reach, before.reach)
        )
        over = box.x[-1] - wide >= WITHIN and box.x[-1] + wide <= 1 - WITHIN
        if joined and over and curve.sign(ends[0]) * curve.sign(ends[1]) < 0:
            return True
    return False
