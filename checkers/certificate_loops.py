r"""Loops of limbs that carry one platform, closed by Newton's method, for `certificate_joints.py`."""

from __future__ import annotations

import math

from certificate_bounds import NAMES, Refused, cross, dot, inverse, minus, times

ROUNDED = 1e-9
LARGEST = 1e3  # number of turns, or of lengths, to one of an amount


class Loops:
    """Limbs with the screws (w; v) of their motions at home; `size` is the robot's, poses turn about `centre`."""

    def __init__(self, limbs, size, centre):
        self.limbs, self.size, self.centre = limbs, size, centre
        self.counts = [1 + max(limb["coordinates"]) for limb in limbs]
        self.units = [self._units(k, n) for k, n in enumerate(self.counts)]
        self._check()

    def _check(self):
        """Raises Refused for a size that is none of the robot's lengths, beside which all motions would look small."""
        ends = [limb["end"] for limb in self.limbs]
        axes = [cross(s[:3], s[3:]) for limb in self.limbs for s in limb["screws"] if any(s[:3])]
        span = max(math.dist(p, self.centre) for p in (*ends, *axes))
        if not 1e-3 * span <= self.size <= 1e3 * (span or 1.0):
            raise Refused("a size that is not the robot's")

    def freedoms(self, amounts, platform, names):
        """In how many ways the platform can move, as far as these coordinates of its pose change, from amounts that
        close the loops: by the twists that all limbs allow without the joints that are held.
        """
        about = moved(platform, self.centre)
        moves = [self.twists(k, own, about) for k, own in enumerate(amounts)]
        free = [[t for c, t in enumerate(own) if c not in limb["held"]] for own, limb in zip(moves, self.limbs)]
        changes = [rates(self.pose(platform), t) for t in complement([w for own in free for w in complement(own)])]
        return rank([[found[n] for n in names] for found in changes])

    def motions(self, k, amounts):
        """The motions of the links of a limb, from the first joint's to the platform's."""
        limb, found, now = self.limbs[k], [], None
        for screw, c, s in zip(limb["screws"], limb["coordinates"], limb["signs"]):
            step = exponential(screw, s * amounts[c])
            now = step if now is None else after(now, step)
            found.append(now)
        return found

    def twists(self, k, amounts, about):
        """For each coordinate the twist (w; v / size) of the platform, v at a point."""
        limb, motions = self.limbs[k], self.motions(k, amounts)
        found = [[0.0] * 6 for _ in range(1 + max(limb["coordinates"]))]
        before = (((1, 0, 0), (0, 1, 0), (0, 0, 1)), (0.0, 0.0, 0.0))
        for screw, c, s, motion in zip(limb["screws"], limb["coordinates"], limb["signs"], motions):
            rotation, shift = before
            w, v = ([dot(row, part) for row in rotation] for part in (screw[:3], screw[3:]))
            v = [a + b for a, b in zip(v, cross(shift, w))]
            there = [(a + b) / self.size for a, b in zip(v, cross(w, about))]
            found[c] = [x + s * y for x, y in zip(found[c], (*w, *there))]
            before = motion
        return found

    def around(self, rng, far):
        """Amounts at random around home, at which loops need not be closed."""
        return [
            [0.0 if c in limb["held"] else rng.uniform(-far, far) * u for c, u in enumerate(own)]
            for limb, own in zip(self.limbs, self.units)
        ]

    def closed(self, amounts, pose=()):
        """Amounts near these in which all platforms are in one place, and that place, with these values (name, value)
        of its pose; None where it was not found.
        """
        amounts = [list(own) for own in amounts]
        unknown = [(k, c) for k, n in enumerate(self.counts) for c in range(n) if c not in self.limbs[k]["held"]]
        for _ in range(30):
            places = [self.motions(k, own)[-1] for k, own in enumerate(amounts)]
            rest = [x for place in places[1:] for x in apart(places[0], place, self.centre, self.size)]
            here = self.pose(places[0])
            rest += [(here[n] - value) / (self.size if n in "xyz" else 1.0) for n, value in pose]
            if max(map(abs, rest)) < 1e-13:
                return amounts, places[0]
            about = moved(places[0], self.centre)
            moves = [self.twists(k, own, about) for k, own in enumerate(amounts)]
            rows = []
            for k, c in unknown:
                t = [x * self.units[k][c] for x in moves[k][c]]
                row = [((k == n) - (k == 0)) * x for n in range(1, len(places)) for x in t]
                changes = rates(here, t) if k == 0 else dict.fromkeys(NAMES, 0.0)
                rows.append(row + [changes[n] for n, _ in pose])
            normal = times(rows, list(zip(*rows)))
            for i in range(len(normal)):
                normal[i][i] += 1e-9  # the robot can move: of all steps a short one
            back = inverse(normal)
            if back is None:
                return None
            step = [sum(b * sum(r * x for r, x in zip(row, rest)) for b, row in zip(line, rows)) for line in back]
            if not max(map(abs, step)) < 1:
                return None
            for (k, c), x in zip(unknown, step):
                amounts[k][c] -= x * self.units[k][c]
        return None

    def _units(self, k, n):
        """What an amount of each coordinate is measured in: rad, or the size."""
        found = [self.size] * n
        for screw, c in zip(self.limbs[k]["screws"], self.limbs[k]["coordinates"]):
            if any(screw[:3]):
                found[c] = 1.0
        return found

    def pose(self, platform):
        """The coordinates of a motion of the platform by their names."""
        r, _ = platform
        shift = minus(moved(platform, self.centre), self.centre)
        turn = (math.atan2(r[2][1], r[2][2]), -math.asin(max(-1.0, min(1.0, r[2][0]))), math.atan2(r[1][0], r[0][0]))
        return dict(zip(NAMES, (*shift, *turn)))


def check_joints(limbs, plane):
    """Raises Refused for joints that do not move by their amounts as `exponential` has it, about axes of length 1, or
    so little that it would not be seen; in the plane z = 0 for those that leave it.
    """
    for limb in limbs:
        screws, coordinates, signs = limb["screws"], limb["coordinates"], limb["signs"]
        if not len(screws) == len(coordinates) == len(signs) or {*coordinates} != {*range(1 + max(coordinates))}:
            raise Refused("joints whose amounts are missing, or amounts without a joint")
        for screw, sign in zip(screws, signs):
            turns = any(screw[:3])
            if not abs(length(screw[:3] if turns else screw[3:]) - 1) <= ROUNDED:
                raise Refused("a joint whose axis does not have length 1")
            if not 1 / LARGEST <= abs(sign) <= LARGEST:
                raise Refused("a joint that hardly moves with its amount, or far too much")
            if plane and any((*screw[:2], screw[5])):
                raise Refused("a joint that leaves the plane z = 0, to which the robot is said to keep")


def length(v):
    return math.sqrt(sum(x * x for x in v))


def rank(rows, least=1e-6):
    """The rank of rows of numbers, those that have less than this length beside the others being none."""
    return len(basis(lengthened(rows), least=least))


def lengthened(rows):
    """The rows with length 1."""
    return [[x / max(length(r), 1e-300) for x in r] for r in rows]


def basis(rows, known=(), least=1e-6):
    """Rows of length 1 at right angles to each other and to those that are known, which span all that is left."""
    found = list(known)
    rows = [without(r, found) for r in rows]
    while rows:
        best = max(rows, key=length)
        if length(best) < least:
            break
        unit = [x / length(best) for x in best]
        rows = [without(r, [unit]) for r in rows if r is not best]
        found.append(unit)
    return found[len(known) :]


def without(row, units):
    for u in units:
        along = sum(p * q for p, q in zip(row, u))
        row = [x - along * y for x, y in zip(row, u)]
    return row


def complement(twists):
    """What has no product with any of the twists."""
    own = basis(lengthened(twists))
    return basis([[float(i == j) for j in range(6)] for i in range(6)], own)


def rates(pose, twist):
    """How fast the coordinates of a pose change with a twist (w; v / size), shifts in parts of the size."""
    (a, b, c), shifts = twist[:3], twist[3:]
    sine, cosine, slope = math.sin(pose["yaw"]), math.cos(pose["yaw"]), math.cos(pose["pitch"]) or 1e-300
    roll = (cosine * a + sine * b) / slope
    return dict(zip(NAMES, (*shifts, roll, cosine * b - sine * a, c + math.sin(pose["pitch"]) * roll)))


def exponential(screw, amount):
    """The motion (rotation, shift) by an amount of a screw (w; v) with w of length 1, or 0 for a slide."""
    w, v = screw[:3], screw[3:]
    if not any(w):
        return ((1, 0, 0), (0, 1, 0), (0, 0, 1)), [amount * c for c in v]
    s, c = math.sin(amount), 1 - math.cos(amount)
    rows = []
    for i in range(3):
        unit = [float(i == j) for j in range(3)]
        turned, twice = cross(w, unit), cross(w, cross(w, unit))
        rows.append([u + s * a + c * b for u, a, b in zip(unit, turned, twice)])  # columns of the rotation
    along = dot(w, v)
    around = cross(w, v)
    shift = [amount * along * a + s * (x - along * a) + c * y for a, x, y in zip(w, v, around)]
    return list(zip(*rows)), shift


def after(first, second):
    """The motion of `second`, and then of `first`."""
    (r, t), (s, u) = first, second
    return times(r, s), [dot(row, u) + c for row, c in zip(r, t)]


def moved(motion, point):
    rotation, shift = motion
    return [dot(row, point) + c for row, c in zip(rotation, shift)]


def apart(one, other, centre, size):
    """The small turn, and the shift of the centre in parts of the size, that lead from one motion to another."""
    (r, _), (s, _) = one, other
    turn = times(s, list(zip(*r)))
    w = [(turn[2][1] - turn[1][2]) / 2, (turn[0][2] - turn[2][0]) / 2, (turn[1][0] - turn[0][1]) / 2]
    return [*w, *((a - b) / size for a, b in zip(moved(other, centre), moved(one, centre)))]
