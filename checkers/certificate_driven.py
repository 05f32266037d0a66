r"""Robots of joints led by their actuators, for `map_actuators.py`: which solutions of the loops belong to one branch.

The file has the screws of the joints of each limb at home. With the amounts q of the actuators given, those of all
other joints, x, are unknown. With R the turn of the platform as a limb makes it, and p where it takes the centre, the
loops are closed where for each limb but the first the turn E = R R_0^T is symmetric, with a trace that is not -1, and
all p are one. These are as many equations f as there are unknown amounts: of other robots nothing is proved here.

For a box q = q_0 + sum d_j t_j + h with |t_j| <= 1 and |h| <= k, near which x = x_0 + sum s_j t_j + y with |y| <= r,
and a matrix B, near the inverse of the derivative J by x in the middle, let for all entries that occur there
|B f_0| + sum |B (J s_j + df/dq d_j)| + |B df/dq| k + |1 - B J| r < r (Krawczyk's operator; along the way from the
middle what is linear in t counts half). Then for each q of the box there is one such x, continuous in q, inside of its
bounds, and J is regular at all of them: with the actuators locked no joint can move, so that no such configuration is
singular. Entries are Values (`certificate_bounds`), whose coordinates are the t_j.

Two such boxes have the same solutions where they meet, if they have one in common there: at a place of both it is
enclosed in a box so small that it lies in both.
"""

from __future__ import annotations

import math
from operator import mul

from certificate_bounds import NAMES, Refused, U, Value, cross, dot, inverse, minus, mix, sizes, times
from certificate_loops import Loops, check_joints
from certificate_rods import Rods
from map_turns import about, waves

TRIES = 4  # of bounds for a box
STEPS = 12  # of Newton's method
MORE = 1 + 1e-9  # for what is rounded where bounds are added up
ROUND = 4 * U  # what axes of length 1 are off in floats, and more
PAIRS = ((1, 2), (2, 0), (0, 1))


class Branch:
    """Amounts of the actuators around `q`, along `ways`, within `thick`, and the one solution x near each of them:
    `slopes` along these ways, within `reach`.
    """

    def __init__(self, q, ways, thick, x, slopes, reach):
        self.q, self.ways, self.thick, self.x, self.slopes, self.reach = q, ways, thick, x, slopes, reach

    def at(self, q):
        """The middle of the bounds of x for amounts q; None for those that are not in the box."""
        rest, found = [a - b for a, b in zip(q, self.q)], list(self.x)
        for way, slope in zip(self.ways, self.slopes):
            k = max(range(len(way)), key=lambda j: abs(way[j]))
            t = max(-1.0, min(1.0, rest[k] / way[k]))
            rest = [a - t * b for a, b in zip(rest, way)]
            found = [a + t * b for a, b in zip(found, slope)]
        return found if all(abs(a) <= b / 2 for a, b in zip(rest, self.thick)) else None

    def holds(self, place):
        """Whether the solution of a place, a box without ways, is that of this box."""
        near = self.at(place.q)
        return near is not None and all(
            abs(a - b) * MORE + k + U * (abs(a) + abs(b)) < r
            for a, b, k, r in zip(place.x, near, place.reach, self.reach)
        )


class Driven:
    """What the kinds of robots have in common: `look` has the equations of a box, and their derivatives by the unknown
    and by the driven amounts, as rows of Values; None where these do not tell all.
    """

    def solved(self, q, x):
        """Amounts near x that close the loops, and a matrix near the inverse of the derivative; None without them."""
        none, still = [0.0] * len(q), [0.0] * len(x)
        for _ in range(STEPS):
            found = self.look(q, [], none, x, [], still)
            back = None if found is None else inverse([[v.c for v in row] for row in found[1][0]])
            if back is None:
                return None
            steps = [total(row, [v.c for v in found[0]]) for row in back]
            x = [a - b for a, b in zip(x, steps)]
            far = max([abs(b) / (1 + abs(a)) for a, b in zip(x, steps)])
            if not far < 10:
                return None
            if far < 1e-11:
                return x, back
        return None

    def known(self, q, ways, x, room=None):
        """A box with one solution for each of its amounts, the one in the middle near x, or None where that is not
        proved; `ways` are along other actuators each, or it is one. Around it there is some `room`.
        """
        there = self.solved(q, x)
        if there is None:
            return None
        (x, back), none = there, [0.0] * len(q)
        point = self.look(q, [], none, x, [], [0.0] * len(x))
        if point is None:
            return None
        size, thick = sizes(back), [16 * U * (abs(c) + sum([abs(w[k]) for w in ways])) for k, c in enumerate(q)]
        thick = [a + b for a, b in zip(thick, room or none)]
        off = _parted(back, size, [[v] for v in point[0]])
        moved = times(back, [[v.c for v in row] for row in point[1][1]])
        slopes = [[-total(row, way) for row in moved] for way in ways]
        along = self.look(q, ways, thick, x, slopes, [0.0] * len(x))
        if along is None:
            return None
        start = [row[0] for row in off]
        for slope, way in zip(slopes, ways):
            change = [[mix((*a, *b), (*slope, *way))] for a, b in zip(*along[1])]
            start = [a + row[0] for a, row in zip(start, _parted(back, size, change, 0.5))]
        start = [a + total(row, thick) for a, row in zip(start, _parted(back, size, along[1][1]))]
        least = [(4 * row[0] + 1e-9 * (1 + abs(c))) if ways else 1e-12 * (1 + abs(c)) for row, c in zip(off, x)]
        reach, beside = [1.2 * a + b for a, b in zip(start, least)], [none] * len(x)
        for _ in range(TRIES):
            each = [[r if i == j else 0.0 for j in range(len(x))] for i, r in enumerate(reach)]
            found = self.look(q, ways + beside, thick, x, slopes + each, [0.0] * len(x))
            if found is None:
                return None
            rest = _parted(back, size, found[1][0], less=True)
            needed = [(a + total(row, reach)) * MORE for a, row in zip(start, rest)]
            if all(a < b for a, b in zip(needed, reach)):
                return Branch(q, ways, thick, x, slopes, reach)
            for _ in range(20):  # what the bounds would be if those of the derivative did not grow with them
                needed = [a + total(row, needed) for a, row in zip(start, rest)]
            if not max(needed) < 10 * (1 + max(map(abs, x))):
                return None
            reach = [1.2 * a + b for a, b in zip(needed, least)]
        return None

    def place(self, q, x):
        """The box of one q alone."""
        return self.known(q, [], x)

    def way(self, place, q, cuts):
        """The place at q of the branch of another place, along the straight way between them; None where that is not
        proved. Parts of the way are cut in halves so often.
        """
        waiting = [(q, cuts)] if q != place.q else []
        while waiting:
            end, left = waiting.pop()
            middle = [(a + b) / 2 for a, b in zip(place.q, end)]
            way = [(b - a) / 2 for a, b in zip(place.q, end)]
            box = self.known(middle, [way], place.x)
            there = None
            if box is not None and box.holds(place):
                there = self.place(end, box.at(end) or box.x)
            if there is not None and box.holds(there):
                place = there
            elif left:
                waiting += [(end, left - 1), (middle, left - 1)]
            else:
                return None
        return place


class DrivenJoints(Driven):
    """A robot by its joints at home; `names` are the actuators that lead it."""

    def __init__(self, geometry, names):
        self.limbs, self.size = geometry["limbs"], float(geometry["size"])
        self.centre = [float(c) for c in geometry["centre"]]
        plane = geometry["plane"]
        if type(plane) is not bool:
            raise Refused("neither a robot of the plane z = 0 nor one of space")
        check_joints(self.limbs, plane)
        self.counts = Loops(self.limbs, self.size, self.centre).counts
        known = {a["name"]: a for a in geometry["actuators"]}
        if len(known) != len(geometry["actuators"]) or not set(names) <= set(known):
            raise Refused("actuators that are none")
        self.names, self.actuators = names, [known[n] for n in names]
        self.driven = [(a["limb"], a["coordinate"]) for a in self.actuators]
        every = [(k, c) for k, n in enumerate(self.counts) for c in range(n)]
        held = {(k, c) for k, limb in enumerate(self.limbs) for c in limb["held"]}
        if len({*self.driven}) != len(self.driven) or not {*self.driven} <= {*every} - held:
            raise Refused("actuators without a joint")
        for a, (k, c) in zip(self.actuators, self.driven):
            own = {any(s[:3]) for s, at in zip(self.limbs[k]["screws"], self.limbs[k]["coordinates"]) if at == c}
            if own != {a["turns"]}:
                raise Refused("an actuator that turns is said to slide, or one that slides to turn")
        self.unknown = [at for at in every if at not in held and at not in self.driven]
        self.rows = (2, 3, 4) if plane else tuple(range(6))
        if len(self.unknown) != len(self.rows) * (len(self.limbs) - 1):
            raise Refused("not as many unknown amounts as equations of the loops")
        self.joints = [[_parts(s) for s in limb["screws"]] for limb in self.limbs]
        self.words = "of its joints at home, from which the loops are closed"
        self.words = f"in the plane z = 0, {self.words}" if plane else self.words

    def look(self, q, ways, thick, x, slopes, reach):
        """The equations in a box, and their derivatives by the unknown and by the driven amounts, as rows of Values.
        None where they may be fulfilled by half a turn as well.
        """
        driven, unknown = values(q, ways, thick), values(x, slopes, reach)
        at = {**dict(zip(self.driven, driven)), **dict(zip(self.unknown, unknown))}
        still = Value(0.0, [0.0] * len(ways), 0.0)
        limbs = [self._limb(k, [at.get((k, c), still) for c in range(n)], still) for k, n in enumerate(self.counts)]
        back = list(zip(*limbs[0][0]))  # rows of the first turn's inverse
        gaps, columns = [], {p: [] for p in at}
        for n, (turn, place, _) in enumerate(limbs[1:], 1):
            e = [[_product(row, column) for column in zip(*back)] for row in turn]
            trace = e[0][0] + e[1][1] + e[2][2]
            if not trace.ends()[0] > 0:
                return None
            skew = [(e[b][a] + e[a][b] * -1.0) * 0.5 for a, b in PAIRS]
            apart = [(a + b * -1.0) * (1 / self.size) for a, b in zip(place, limbs[0][1])]
            gaps += [(skew + apart)[j] for j in self.rows]
            # of [w] E the skew part is that of the vector (tr E - E) w / 2; with w behind E it is (tr E - E^T) w / 2
            for k, sign, rows in ((n, 0.5, e), (0, -0.5, list(zip(*e)))):
                rows = [
                    [((trace if i == j else still) + c * -1.0) * sign for j, c in enumerate(row)]
                    for i, row in enumerate(rows)
                ]
                for c, (spin, ahead) in enumerate(limbs[k][2]):
                    if (k, c) in columns:
                        rates = [_product(row, spin) for row in rows] + [v * (2 * sign / self.size) for v in ahead]
                        columns[k, c] += [rates[j] for j in self.rows]
            for column in columns.values():
                column += [still] * (len(gaps) - len(column))
        return gaps, [list(zip(*(columns[p] for p in some))) for some in (self.unknown, self.driven)]

    def _limb(self, k, values, zero):
        """The turn and the centre's place as a limb makes them, and for each amount the platform's twist there."""
        limb = self.limbs[k]
        turn, shift = [[zero + float(i == j) for j in range(3)] for i in range(3)], [zero] * 3
        axes = []
        for (w, v, along, around, one, two), c, sign in zip(self.joints[k], limb["coordinates"], limb["signs"]):
            amount = values[c] * sign
            ahead = [mix(row, v) for row in turn]
            axis = [mix(row, w) for row in turn] if w else None
            axes.append((c, sign, axis, ahead, shift))
            if not w:
                shift = [a + b * amount for a, b in zip(shift, ahead)]
                continue
            cosine, sine = waves(amount)
            parts = (amount, sine, cosine * -1.0 + 1.0)
            step = [mix(parts, (along * w[j], v[j] - along * w[j], around[j])) for j in range(3)]
            step = [Value(s.c, s.a, s.e + ROUND * self.size) for s in step]
            shift = [a + _product(row, step) for a, row in zip(shift, turn)]
            by = [[mix(parts[1:], (one[i][j], two[i][j]), float(i == j)) for j in range(3)] for i in range(3)]
            by = [[Value(s.c, s.a, s.e + ROUND) for s in row] for row in by]
            turn = [[_product(row, column) for column in zip(*by)] for row in turn]
        place = [a + mix(row, self.centre) for a, row in zip(shift, turn)]
        moves = [([zero] * 3, [zero] * 3) for _ in values]
        for c, sign, axis, ahead, before in axes:
            spin, move = moves[c]
            if axis:
                arm = [a + b * -1.0 for a, b in zip(place, before)]
                ahead = [a + axis[i] * arm[j] + axis[j] * arm[i] * -1.0 for a, (i, j) in zip(ahead, PAIRS)]
                spin = [a + b * sign for a, b in zip(spin, axis)]
            moves[c] = spin, [a + b * sign for a, b in zip(move, ahead)]
        return turn, place, moves


class DrivenRods(Driven):
    """Six rods of one length each, from points on drives that turn or slide to points of the platform. Unknown are the
    coordinates of its pose; the equations are those of the lengths, whose derivatives are the wrenches of the rods.
    """

    def __init__(self, data, names):
        plain = {"over": [], "rest": dict.fromkeys(NAMES, 0.0), "limits": None, "cones": [], "tilt": None}
        one = Rods({**data, "question": {**data["question"], **plain}})
        known = [rod.get("actuator") for rod in one.rods]
        if any(rod["drive"] == "leg" for rod in one.rods) or sorted(map(str, known)) != sorted(names):
            raise Refused("the actuators are not those of six rods")
        self.names, self.order, self.unknown = names, [names.index(n) for n in known], NAMES
        self.rods, self.parts, self.centre, self.words = one.rods, one.parts, one.centre, one.words

    def look(self, q, ways, thick, x, slopes, reach):
        driven, unknown = values(q, ways, thick), values(x, slopes, reach)
        still = Value(0.0, [0.0] * len(ways), 0.0)
        (cr, sr), (cp, sp), (cy, sy) = (waves(v) for v in unknown[3:])
        turn = [[still + float(i == j) for j in range(3)] for i in range(3)]
        spins = []
        for letter, cosine, sine in (("z", cy, sy), ("y", cp, sp), ("x", cr, sr)):
            spins.append([row["xyz".index(letter)] for row in turn])
            step = about(letter, cosine, sine, still, still + 1.0)
            turn = [[_product(row, column) for column in zip(*step)] for row in turn]
        gaps, by_x, by_q = [], [], []
        for rod, (home, size, axis, more), k in zip(self.rods, self.parts, self.order):
            start, end = rod["ends"]
            arm = [mix(row, minus(end, self.centre)) for row in turn]
            far = [a + b + c for a, b, c in zip(arm, unknown[:3], self.centre)]
            if rod["drive"] == "slide":
                point, speed = [driven[k] * a + b for a, b in zip(axis, start)], [still + a for a in axis]
            else:
                foot, h, one, other, _ = more
                wave = waves(driven[k])
                point = [mix(wave, (h * a, h * b), c) for a, b, c in zip(one, other, foot)]
                speed = [mix(wave, (h * b, -h * a)) for a, b in zip(one, other)]
            rod_ = [Value(v.c, v.a, v.e + ROUND * size) for v in (a + b * -1.0 for a, b in zip(far, point))]
            square = sum([c * c for c in home])
            gaps.append((_product(rod_, rod_) + Value(-square, still.a, ROUND * square)) * (0.5 / size))
            moment = [arm[i] * rod_[j] + arm[j] * rod_[i] * -1.0 for i, j in PAIRS]
            yaw, pitch, roll = (_product(spin, moment) for spin in spins)
            by_x.append([v * (1 / size) for v in (*rod_, roll, pitch, yaw)])
            by_q.append([still] * len(q))
            by_q[-1][k] = _product(rod_, speed) * (-1 / size)
        return gaps, [by_x, by_q]


def values(middle, ways, far):
    """Amounts in a box, each within `far` of what it is along the ways."""
    across = [list(c) for c in zip(*ways)] or [[]] * len(middle)
    return [
        Value(c, [b * (1 + U) for b in a], e * (1 + U) + U * (abs(c) + sum(map(abs, a))))
        for c, a, e in zip(middle, across, far)
    ]


def _parts(screw):
    """Of a joint its axis with length 1, None for a slide, and what its motion is made of."""
    w, v = [float(c) for c in screw[:3]], [float(c) for c in screw[3:]]
    if not any(w):
        return None, v, 0.0, None, None, None
    size = math.sqrt(dot(w, w))
    w = [c / size for c in w]
    one = [[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]]
    return w, v, dot(w, v), cross(w, v), one, times(one, one)


def _product(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def total(a, b):
    return sum(map(mul, a, b))


def _parted(back, size, rows, share=1.0, less=False):
    """Bounds of the sizes of all B M for rows M of Values, of 1 - B M where `less`; of what is linear in the
    coordinates only this share.
    """
    middle = times(back, [[v.c for v in row] for row in rows])
    found = [[abs((less and i == j) - c) for j, c in enumerate(row)] for i, row in enumerate(middle)]
    # the share of U is for what the products leave out in floats
    rest = times(size, [[v.e + U * (abs(v.c) + v.reach) for v in row] for row in rows])
    found = [[a + b for a, b in zip(*both)] for both in zip(found, rest)]
    for t in range(len(rows[0][0].a)):
        part = times(back, [[v.a[t] for v in row] for row in rows])
        found = [[a + abs(b) * share for a, b in zip(*both)] for both in zip(found, part)]
    return found
