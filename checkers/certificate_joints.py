r"""Robots given by joints, for `check_certificate.py`: closed forms of wrenches in a box, compared with the joints.

The file has the screws (w; v) of each limb's joints at home, from the base to the platform; the platform moves by the
product of their exponentials. It has programs of the coordinates too: of each limb's wrenches (f; m / size) about its
end, seen from the platform, and of the amounts of the actuators. That these are what the joints make of them is seen
where all loops are closed, by Newton's method (`certificate_loops`), at random places around home and on ways from
there to places of the range: the wrenches have no power on the twists of the limb's undriven joints there, and are as
many as these leave. Axes have length 1, and in a robot of the plane z = 0 no joint leaves this plane. It is no proof,
but both sides are analytic: what agrees around home agrees in all boxes that boxes in which all roots exist join to it.
That a pose is reached nowhere is told by a root that is negative, or by limits.

In a box the entries are Values (`certificate_bounds`). With G the products of a limb's wrenches with each other, and C
the inverse of a lower factor of it in the middle, C G C^T has no eigenvalue above g there: the margin, measured with
wrenches that are orthonormal in each limb, is at least 1 / sqrt(g) times the least singular value of all C W K, where K
is the balance, of the velocities of all ends, and of turns as well at ends that are no balls. Entries of these wrenches
may all be other ones by `SLACK`, which is more than closed forms and joints are seen to agree to.
"""

from __future__ import annotations

import copy
import math
import random
from fractions import Fraction
from operator import mul

from certificate_bounds import (
    INF,
    NAMES,
    Beyond,
    Refused,
    U,
    Undefined,
    Value,
    balance_of,
    cholesky,
    cosine_of,
    dot,
    holds_matrix,
    inverse,
    minus,
    mix,
    turns,
)
from certificate_loops import Loops, basis, check_joints, length, lengthened, moved, rank

PLACES = 12  # where the programs are compared with the joints
EQUAL = 1e-8  # parts of a wrench, and of a twist, in what is compared
SLACK = 10 * EQUAL  # in entries of wrenches that are orthonormal: regular is what closed forms so near to them are
DEPENDENT = 1e-12  # joints that are not independent, and whose part beyond the others is larger, cannot be told apart
NOWHERE = "the closed forms end around home"
OPERATIONS = {"add": 2, "sub": 2, "mul": 2, "shift": 1, "scale": 1, "inv": 1, "sqrt": 1, "cos": 1, "sin": 1}


class Tape:
    """A program: lines of an operation on earlier lines, and of its results the numbers of lines, or constants."""

    def __init__(self, data, inputs):
        self.lines = []
        for n, (op, *args) in enumerate(data["lines"]):
            count = 0 if op == "input" else OPERATIONS.get(op)
            constant = float(Fraction(args.pop())) if op in ("shift", "scale") else 0.0
            if count is None or len(args) != max(count, 1):
                raise Refused(f"an unknown line {op!r} of a program")
            if any(type(k) is not int or not 0 <= k < (n if count else inputs) for k in args):
                raise Refused("a line of a program that reads what is not there")
            self.lines.append((op, args, constant))
        self.results = [r if type(r) is int else float(Fraction(r)) for r in data["results"]]
        if any(type(r) is int and not 0 <= r < len(self.lines) for r in self.results):
            raise Refused("a result of a program that is not there")
        needed = {r for r in self.results if type(r) is int}
        for n in reversed(range(len(self.lines))):  # a root that nothing needs would tell where poses are not reached
            if n not in needed:
                raise Refused("a line of a program that no result needs")
            needed.update(self.lines[n][1] if self.lines[n][0] != "input" else ())

    def values(self, inputs):
        """Its results for inputs that are Values. Raises Undefined and Beyond."""
        none, done = Value(0.0, [0.0] * len(inputs[0].a), 0.0), []
        for op, args, constant in self.lines:
            if op == "input":
                done.append(inputs[args[0]])
                continue
            a = done[args[0]]
            if op == "add":
                done.append(a + done[args[1]])
            elif op == "sub":
                done.append(a + done[args[1]] * -1.0)
            elif op == "mul":
                done.append(a * done[args[1]])
            elif op == "shift":
                done.append(a + constant)
            elif op == "scale":
                done.append(a * constant)
            elif op == "inv":
                done.append(a.inverse() if a.c > 0 else (a * -1.0).inverse() * -1.0)
            elif op == "sqrt":
                done.append(a.root())
            else:
                done.append(wave(a, op == "sin"))
        return [done[r] if type(r) is int else none + r for r in self.results]


def wave(a, sine):
    """The sine or the cosine of a Value."""
    s, c = math.sin(a.c), math.cos(a.c)
    value, slope = (s, c) if sine else (c, -s)
    far = a.reach
    e = far * far / 2 * min(1.0, abs(value) + far) + abs(slope) * a.e + U * (1 + abs(slope) * far)
    return Value(value, [slope * x for x in a.a], e)


class Joints:
    """A robot of joints from a certificate, with `roots` one that reaches a pose only where the roots of its geometry
    exist.
    """

    def __init__(self, data, roots=False):
        q, g = data["question"], data["geometry"]
        self.names = g["names"]
        over = [r["coordinate"] for r in q["over"]]
        if len(set(over)) != len(over) or any(n not in self.names for n in over) or not set(self.names) <= set(NAMES):
            raise Refused("coordinates that are none")
        self.free = [NAMES.index(n) for n in over]
        self.at = {n: k for k, n in enumerate(over)}
        self.rest = {n: float(q["rest"].get(n, 0.0)) for n in self.names if n not in self.at}
        if any(n not in q["rest"] for n in self.rest):
            raise Refused("the rest of the pose is missing")
        if q["cones"]:
            raise Refused("no independent checker yet for cones of this robot")
        self.tilt = None if q["tilt"] is None else cosine_of(q["tilt"])
        self.limbs, self.size, self.centre = g["limbs"], float(g["size"]), [float(c) for c in g["centre"]]
        if type(g["plane"]) is not bool:
            raise Refused("neither a robot of the plane z = 0 nor one of space")
        self.keep = (0, 1, 5) if g["plane"] else tuple(range(6))
        self.wrenches = Tape(g["wrenches"], len(self.names))
        if len(self.wrenches.results) != 6 * sum(limb["wrenches"] for limb in self.limbs):
            raise Refused("wrenches that are not six numbers each")
        self.amounts = None if g["amounts"] is None else Tape(g["amounts"], len(self.names))
        self.roots = Tape(g["roots"], len(self.names)) if roots else None
        self.actuators, self.limits = g["actuators"], []
        names = [a["name"] for a in self.actuators]
        if q["limits"]:
            if len(set(names)) != len(names) or set(names) != set(q["limits"]) or self.amounts is None:
                raise Refused("the limits are not those of the actuators")
            for name in names:
                low, high = (s if v is None else v for v, s in zip(q["limits"][name], (-INF, INF)))
                if not low < high:
                    raise Refused(f"limits of {name!r} that are none")
                self.limits.append((low, high))
        check_joints(self.limbs, g["plane"])
        ends = [limb["end"] for limb in self.limbs]
        mean = [sum(e[j] for e in ends) / len(ends) for j in range(3)]
        self.arms = [[c / self.size for c in minus(e, mean)] for e in ends]
        rows = []
        for limb, (x, y, z) in zip(self.limbs, self.arms):
            rows += [[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]]
            rows += [] if limb["ball"] else [[0] * (3 + k) + [1] + [0] * (2 - k) for k in range(3)]
        self.scale = balance_of([[row[k] for k in self.keep] for row in rows])
        self.loops = Loops(self.limbs, self.size, self.centre)
        units = [math.pi / 180 if r["unit"] == "deg" else 1.0 for r in q["over"]]
        self.seen = 0
        self._compare(*([float(Fraction(r[end])) * u for r, u in zip(q["over"], units)] for end in ("low", "high")))
        self.words = f"of closed forms that agree with the joints at {self.seen} poses, which does not prove them"
        self.words = f"in the plane z = 0, {self.words}" if g["plane"] else self.words

    # --- in boxes -----------------------------------------------------------------------------------------------------

    def over(self):
        """The same robot over all its coordinates, and their names."""
        found = copy.copy(self)
        found.free, found.rest = [NAMES.index(n) for n in self.names], {}
        found.at = {n: k for k, n in enumerate(self.names)}
        return found, self.names

    def inputs(self, box):
        none = [0.0] * len(self.free)
        found = []
        for n in self.names:
            k = self.at.get(n)
            slope = [box.half[j] if j == k else 0.0 for j in range(len(none))]
            found.append(Value(self.rest[n] if k is None else box.middle[k], slope, 0.0))
        return found

    def look(self, box):
        """Whether all poses of a box are outside, whether all are inside, and the limbs' wrenches there."""
        inputs, inside = self.inputs(box), True
        if self.tilt is not None:
            tilted = [wave(v, False) for n, v in zip(self.names, inputs) if n in ("roll", "pitch")]
            low, high = (tilted[0] * tilted[1] + -self.tilt).ends()
            if high < -U:
                return True, False, None
            inside = low > U
        try:
            if self.limits:
                values = iter(self.amounts.values(inputs))
                for a, (least, most) in zip(self.actuators, self.limits):
                    away, within = True, False
                    for low, high in turns(next(values), next(values)) if a["turns"] else [next(values).ends()]:
                        away &= high < least - U * 8 or low > most + U * 8
                        within |= low > least + U * 8 and high < most - U * 8
                    if away:
                        return True, False, None
                    inside &= within
            if self.roots is not None:
                self.roots.values(inputs)
            flat = self.wrenches.values(inputs)
        except Beyond:
            return True, False, None
        except Undefined:
            return False, False, None
        return False, inside, [flat[k : k + 6] for k in range(0, len(flat), 6)]

    def steady(self, lines):
        """Whether no limb's wrenches depend on each other anywhere in a box, so that the determinant of all changes its
        sign only where it is 0: their products are near those in the middle, which are brought to 1.
        """
        return all(
            back is not None
            and all(2 * row[i].ends()[0] > sum(max(map(abs, v.ends())) for v in row) for i, row in enumerate(changed))
            for _, back, changed in self._bases(lines)
        )

    def _bases(self, lines):
        """Of each limb its wrenches, what makes them orthonormal in the middle (None where nothing does), and their
        products after that.
        """
        at = 0
        for limb in self.limbs:
            own = lines[at : at + limb["wrenches"]]
            at += limb["wrenches"]
            products = [[total(a, b) for b in own] for a in own]
            low = cholesky([[p.c for p in row] for row in products], 0.0)
            back = None if low is None else inverse(low)
            flat = [p for row in products for p in row]
            yield own, back, [] if back is None else [[mix(flat, outer(a, b)) for b in back] for a in back]

    def holds(self, lines, margin):
        """Whether the margin is at least this one in a box (0: it is regular); what keeps from it by coordinates."""
        matrix, longest = [], 1.0
        for arm, (own, back, changed) in zip(self.arms, self._bases(lines)):
            if back is None:
                return False, None, None
            large = [sum(abs(v.c) + v.reach for v in row) for row in changed]
            if not all(x < INF for x in large):
                return False, None, None
            longest = max(longest, *large)
            for row in back:
                whole = [mix([line[k] for line in own], row) for k in range(6)]
                turned = [whole[3 + k] + mix(whole[:3], cross_row(arm, k)) for k in range(3)]
                wrench = [*whole[:3], *turned]
                kept = [Value(v.c, v.a, v.e + SLACK) for v in (wrench[k] for k in self.keep)]
                matrix.append([mix(kept, column) for column in zip(*self.scale)])
        return holds_matrix(matrix, margin * math.sqrt(longest) * (1 + 1e-9))

    # --- compared with the joints -------------------------------------------------------------------------------------

    def _compare(self, low, high):
        """Raises Refused where the programs are not what the joints make: around home, and on ways from home to places
        of the range, as far as the loops and the programs go along.
        """
        rng, seen = random.Random(7), 0
        for trial in range(4 * PLACES):
            there = self.loops.closed(self.loops.around(rng, (0.1, 0.03, 0.01)[trial % 3]))
            if there is not None:
                seen, self.seen = seen + 1, self.seen + 1
                if self.loops.freedoms(*there, self.names) < len(self.names):
                    raise Refused("the joints that are not held do not move the platform along all its coordinates")
                if words := self._fault(*there):
                    raise Refused(words)
            if seen == PLACES:
                break
        else:
            raise Refused("the loops could not be closed around home")
        for _ in range(PLACES):
            place = [rng.uniform(a, b) for a, b in zip(low, high)]
            self.reaches({n: self.rest[n] if n in self.rest else place[self.at[n]] for n in self.names})

    def reaches(self, pose):
        """Whether steps from home lead to a pose; where one does not agree it is taken again in smaller ones. Raises
        Refused where the programs are not what the joints make on the way.
        """
        amounts, done, step = [[0.0] * n for n in self.loops.counts], 0.0, 1 / 8
        while done < 1:
            part = min(done + step, 1.0)
            there = self.loops.closed(amounts, [(n, part * v) for n, v in pose.items()])
            words = NOWHERE if there is None else self._fault(*there)
            if not words:
                amounts, done, self.seen = there[0], part, self.seen + 1
            elif step > 1 / 64:
                step /= 2
            elif words is NOWHERE:
                return False
            else:
                raise Refused(words)
        return True

    def _fault(self, amounts, platform):
        """What the programs are not that the joints make of these amounts, in words; "" where they agree."""
        pose = self.loops.pose(platform)
        inputs = [Value(pose[n], [0.0] * len(self.free), 0.0) for n in self.names]
        try:
            if self.roots is not None:
                self.roots.values(inputs)
            flat = [v.c for v in self.wrenches.values(inputs)]
            driven = None if self.amounts is None else [v.c for v in self.amounts.values(inputs)]
        except Undefined:  # a root of 0, to rounding
            return NOWHERE
        except Beyond:
            return "a closed form does not exist where the joints are closed"
        rotation, _ = platform
        if driven is not None:
            values = iter(driven)
            for a in self.actuators:
                amount = amounts[a["limb"]][a["coordinate"]]
                if a["turns"]:
                    c, s = next(values), next(values)
                    off = abs(c * math.sin(amount) - s * math.cos(amount)) / math.hypot(c, s)
                    off += c * math.cos(amount) + s * math.sin(amount) <= 0
                else:
                    off = abs(next(values) - amount) / self.size
                if not off <= EQUAL:
                    return f"the closed form of {a['name']!r} is not what its joint does"
        for k, limb in enumerate(self.limbs):
            count = limb["wrenches"]
            rows, flat = [flat[6 * n : 6 * n + 6] for n in range(count)], flat[6 * count :]
            driven_ones = {a["coordinate"] for a in self.actuators if a["limb"] == k}
            end = moved(platform, limb["end"])
            twists = [t for c, t in enumerate(self.loops.twists(k, amounts[k], end)) if c not in driven_ones]
            passive = [[dot(column, part) for part in (t[:3], t[3:]) for column in zip(*rotation)] for t in twists]
            kept = [(j + 3) % 6 for j in self.keep]  # the places of what is kept of (f; m) in (m; f), and in (w; v)
            own, moves = ([[r[j] for j in kept] for r in rows] for rows in ([x[3:] + x[:3] for x in rows], passive))
            if not all(length(r) < INF for r in own):
                return "a wrench that is endless"
            units = basis(lengthened(own))
            if not all(abs(sum(map(mul, u, t))) <= EQUAL * length(t) for u in units for t in moves):
                return "a wrench is none of its limb: it has power on the undriven joints"
            if len(units) != count:
                return "the wrenches of a limb depend on each other"
            freedoms = rank(moves)
            if freedoms != rank(moves, DEPENDENT):
                return "undriven joints of a limb nearly depend on each other"
            if freedoms + count != len(self.keep):
                return "a limb has not as many wrenches as its undriven joints leave"
        return ""


def total(a, b):
    """The product of two rows of Values."""
    found = a[0] * b[0]
    for x, y in zip(a[1:], b[1:]):
        found = found + x * y
    return found


def outer(a, b):
    return [x * y for x in a for y in b]


def cross_row(arm, k):
    """What the moment's component k of arm x f is in the components of f."""
    x, y, z = arm
    return ((0, -z, y), (z, 0, -x), (-y, x, 0))[k]
