#!/usr/bin/env python3
r"""Check a certificate of `gcrules certify` again: python tools/check_certificate.py FILE.json[.gz] [--jobs N]

It needs Python alone and shares no code with gcrules. From the file it takes the geometry, the range, the limits, the
claim, and the tree of boxes as a hint how to cut; of every box it proves anew that no pose in it is reached within the
limits, or that the margin in it is at least the one claimed, cutting it further where its own bounds need that.

In a box with middle m and half widths h a value is c + sum a_j t_j + r with t_j = (x_j - m_j) / h_j in -1..1, |r| <= e;
e takes in what products, roots and quotients have of second order, and U times all sizes, which is more than rounding.
sin, cos, asin and atan2 are taken to be right to U, and dimensions that follow from those of the file (rods' lengths,
axes of length 1) are floats.

The wrench of rod i on the platform is the unit force f_i along it through its end p_i: W_i = (f_i; p_i x f_i), moments
about the mean of the ends. The margin is the s with s^2 = the least value over twists t of |W t|^2 / sum |v_i(t)|^2,
v_i the velocity of p_i; with the columns of K orthonormal in the second form it is the least singular value of W K.
In a box W K = M + D. Let B be near the inverse of M, |1 - B M| <= A_0, |1 - B (M + D)| <= A and |D| <= F in all
entries, alpha_0, alpha and phi the norms of these bounds. If alpha < 1, then W K is regular, and its margin is at least
(1 - alpha) / |B|, and at least (1 - alpha_0) / |B| - phi. |B| <= b is proved by b^2 - B^T B being positive definite.

Exit codes: 0 what is claimed is proved, 1 it is not, 2 the file is no certificate of a robot that is known here, 3 the
file leaves a part undecided, and what it claims of the rest is proved.
"""

from __future__ import annotations

import argparse
import gzip
import json
import math
import multiprocessing
import sys
import time
from fractions import Fraction

from certificate_bounds import (
    INF,
    SIX,
    Beyond,
    Box,
    Refused,
    U,
    Undefined,
    Value,
    all_inside,
    balance,
    branch,
    cosine_of,
    cross,
    dot,
    holds,
    leaves_of,
    minus,
    mix,
    once,
    sign_of,
    turns,
)

CUTS = 16  # of a box of the certificate, so often further
SHARES = {"f": "free", "g": "free with the other sign", "o": "outside", "x": "crossed", "u": "undecided"}
NAMES = ("x", "y", "z", "roll", "pitch", "yaw")


class Robot:
    """Six rods from the geometry of a certificate."""

    def __init__(self, data):
        q, geometry = data["question"], data["geometry"]
        if geometry is None or len(geometry["rods"]) != 6:
            raise Refused("no independent checker yet for this robot")
        self.free = [NAMES.index(r["coordinate"]) for r in q["over"]]
        if len(set(self.free)) != len(self.free):
            raise Refused("a coordinate occurs twice")
        self.rest = [float(q["rest"].get(n, 0.0)) for n in NAMES]
        missing = [n for k, n in enumerate(NAMES) if k not in self.free and n not in q["rest"]]
        if missing or not all(map(math.isfinite, self.rest)):
            raise Refused("the rest of the pose is missing")
        self.centre, self.rods = geometry["centre"], geometry["rods"]
        points = q["robot"].get("points")
        if points and any(
            [float(Fraction(c)) for c in points[n]] != e
            for r in self.rods
            for n, e in zip(*map(r.get, ("names", "ends")))
        ):
            raise Refused("the geometry is not that of the robot's points")
        for rod in self.rods:
            if rod["drive"] not in ("leg", "turn", "slide"):
                raise Refused(f"no independent checker yet for a drive that is a {rod['drive']}")
        names = [rod.get("actuator") or "".join(rod["names"]) for rod in self.rods]
        ends = {tuple(rod["ends"][1]) for rod in self.rods}
        middle = [sum(e[j] for e in ends) / len(ends) for j in range(3)]
        about = {"origin": [0.0] * 3, "centroid": middle}.get(str(q["about"]), self.centre)
        if any(abs(a - b) > 1e-9 * (1 + abs(a)) for a, b in zip(about, self.centre)):
            raise Refused("the centre of turns is another one than it is said to be")
        self.limits = [(-INF, INF)] * 6
        if q["limits"]:
            if len(set(names)) != 6 or set(names) != set(q["limits"]):
                raise Refused("the limits are not those of six drives")
            for name, (low, high) in q["limits"].items():
                ends = (-INF if low is None else low, INF if high is None else high)
                if not ends[0] < ends[1]:
                    raise Refused(f"limits of {name} that are none")
                self.limits[names.index(name)] = ends
        self.cones = [[] for _ in SIX]
        for c in q["cones"]:
            k = next((k for k, rod in enumerate(self.rods) if rod["names"] == c["rod"]), None)
            if k is None or c["end"] not in ("base", "platform"):
                raise Refused("a cone of an unknown rod")
            self.cones[k].append((c["end"], cosine_of(c["angle"])))
        self.tilt = None if q["tilt"] is None else cosine_of(q["tilt"])
        self.parts = [self._parts(rod) for rod in self.rods]
        ends = [rod["ends"][1] for rod in self.rods]
        mean = [sum(e[j] for e in ends) / 6 for j in range(3)]
        arms = [minus(e, mean) for e in ends]
        k = balance(arms)
        moments = [[[0, -z, y], [z, 0, -x], [-y, x, 0]] for x, y, z in arms]
        # a row of W K is that of the force times such three rows
        self.wrenches = [
            [[k[j][c] + sum(m[i][j] * k[3 + i][c] for i in range(3)) for c in SIX] for j in range(3)] for m in moments
        ]

    @staticmethod
    def _parts(rod):
        """Numbers for a drive: the rod at home and its length, the axis, what else `look` needs of it."""
        start, end = rod["ends"]
        home = minus(end, start)
        size = math.sqrt(dot(home, home))
        if rod["drive"] == "leg":
            return home, size, None, None
        along = math.sqrt(dot(rod["axis"], rod["axis"]))
        if not 1e-6 < along < 1e6:
            raise Refused("an axis of no length, or of an endless one")
        axis = [c / along for c in rod["axis"]]
        if rod["drive"] == "slide":
            return home, size, axis, branch(dot(home, axis), size)
        height = dot(minus(start, rod["through"]), axis)
        foot = [t + height * a for t, a in zip(rod["through"], axis)]
        radius = minus(start, foot)
        h = math.sqrt(dot(radius, radius))
        one = [c / h for c in radius]
        other = cross(axis, one)
        return home, size, axis, (foot, h, one, other, branch(dot(minus(end, foot), other), size))

    def pose(self, box):
        """The shift of the centre, a number where it does not change, and the rotation."""
        at, none = {k: n for n, k in enumerate(self.free)}, [0.0] * len(self.free)

        def slope(n, by):
            return [by * box.half[j] if j == n else 0.0 for j in range(len(none))]

        shift = [Value(box.middle[at[k]], slope(at[k], 1.0), 0.0) if k in at else self.rest[k] for k in range(3)]
        waves = []
        for k in (3, 4, 5):
            n = at.get(k)
            angle, h = (self.rest[k], 0.0) if n is None else (box.middle[n], box.half[n])
            s, c = math.sin(angle), math.cos(angle)
            waves.append(Value(s, slope(n, c), h * h / 2 * min(1.0, abs(s) + h) + U))
            waves.append(Value(c, slope(n, -s), h * h / 2 * min(1.0, abs(c) + h) + U))
        sr, cr, sp, cp, sy, cy = waves
        a, b = sp * sr, sp * cr
        turn = [
            [cy * cp, cy * a + sy * cr * -1.0, cy * b + sy * sr],
            [sy * cp, sy * a + cy * cr, sy * b + cy * sr * -1.0],
            [sp * -1.0, cp * sr, cp * cr],
        ]
        return shift, turn

    def look(self, box):
        """Whether all poses of a box are outside, whether all are inside, and the rods' forces, None where unknown."""
        shift, turn = self.pose(box)
        inside, forces = True, []
        if self.tilt is not None:
            low, high = (turn[2][2] + -self.tilt).ends()
            if high < -U:
                return True, False, None
            inside = low > U
        for k in SIX:
            try:
                force, leans, amount = self.rod(k, shift, turn)
            except Beyond:
                return True, False, None
            except Undefined:
                forces.append(None)
                continue
            least, most = self.limits[k]
            away, within = True, False
            for low, high in amount:
                away &= high < least - U * 8 or low > most + U * 8
                within |= low > least + U * 8 and high < most - U * 8
            inside &= within
            for value in leans:
                low, high = value.ends()
                away |= high < -U * 8
                inside &= low > U * 8
            if away:
                return True, False, None
            forces.append(force)
        known = None not in forces
        return False, inside and known, forces if known else None

    def rod(self, k, shift, turn):
        """The unit force in the platform's frame, the cosines of the cones' angles less those allowed, what the
        amount of the drive is between. Raises Undefined where it may not exist; `Beyond` where it does not.
        """
        rod, (home, size, axis, more) = self.rods[k], self.parts[k]
        arm = minus(rod["ends"][1], self.centre)
        carried = [mix(turn[j], arm) for j in range(3)]
        from_ = more[0] if rod["drive"] == "turn" else rod["ends"][0]
        way = [shift[j] + (self.centre[j] - from_[j]) for j in range(3)]  # the end is at way + carried, from there
        square = dot(way, way) + dot(arm, arm) + 2.0 * dot(way, carried)
        free = [c if isinstance(c, Value) else mix(turn[0], (0, 0, 0), c) for c in way]
        far = [carried[j] + way[j] for j in range(3)]
        if rod["drive"] == "leg":
            length = square.root()
            by, rest, amount = length.inverse(), way, [length.ends()]
        elif rod["drive"] == "slide":  # |D - q d| = L, D from the start at home
            along = mix(far, axis)
            under = along * along + square * -1.0 + size * size
            q = along + under.root() * more
            by, amount = 1 / size, [q.ends()]
            rest = [free[j] + q * -axis[j] for j in range(3)]
        else:
            _, h, one, other, sign = more
            u, w = mix(far, one), mix(far, other)
            reach = (square + (h * h - size * size)) * (0.5 / h)
            both = u * u + w * w
            s, over = (both + reach * reach * -1.0).root() * sign, both.inverse()
            cosine, sine = (u * reach + w * s * -1.0) * over, (w * reach + u * s) * over
            by, amount = 1 / size, turns(cosine, sine)
            rest = [mix((free[j], cosine, sine), (1.0, -h * one[j], -h * other[j])) for j in range(3)]
        force = [(turn[0][i] * rest[0] + turn[1][i] * rest[1] + turn[2][i] * rest[2] + arm[i]) * by for i in range(3)]
        leans, unit = [], [c / size for c in home]
        for end, least in self.cones[k]:
            if end == "platform":
                value = mix(force, unit)
            elif rod["drive"] == "turn":  # the direction at home turns with the horn
                a = dot(unit, axis)
                across = [c - a * d for c, d in zip(unit, axis)]
                value = mix(far, across) * cosine + mix(far, cross(axis, across)) * sine
                value = (value + mix(far, [a * c for c in axis], -h * dot(one, unit))) * by
            else:
                value = mix([far[j] + q * -axis[j] for j in range(3)] if axis else far, unit) * by
            leans.append(value + -least)
        return force, leans, amount


def proved(robot, box, margin, only_outside, cuts, whole):
    """How many boxes it takes to prove of a box that none of its poses is reached within the limits, or that all (not
    `only_outside`) have the margin; 0 where it is not proved.
    """
    outside, _, forces = robot.look(box)
    if outside:
        return 1
    wide = [h / w for h, w in zip(box.half, whole)]
    if forces is not None and not only_outside:
        fine, parts, _ = holds(robot.wrenches, forces, margin)
        if fine:
            return 1
        wide = parts or wide
    if not cuts:
        return 0
    count = 1
    for part in box.cut(wide.index(max(wide))):
        found = proved(robot, part, margin, only_outside, cuts - 1, whole)
        if not found:
            return 0
        count += found
    return count


def sign(robot, place):
    """The sign of the determinant of W at a place, proved; 0 where it is not."""
    outside, _, forces = robot.look(Box(list(place), list(place)))
    if outside or forces is None:
        return 0
    fine, _, rows = holds(robot.wrenches, forces, 0.0)
    if not fine:
        return 0
    return sign_of(rows)


def checked(data, jobs=1, say=None):
    """What is proved, in words, by so many processes; `say` takes words on the way. Raises Refused."""
    if data.get("format") != "gcrules certificate 1":
        raise Refused("no certificate of a known format")
    robot, claim, over = Robot(data), data["claim"], data["question"]["over"]
    length = data["question"]["robot"].get("units") or ""
    if any(r["unit"] not in (("deg", "rad") if NAMES.index(r["coordinate"]) > 2 else (length, "")) for r in over):
        raise Refused("a range in another unit")
    units = [math.pi / 180 if r["unit"] == "deg" else 1.0 for r in over]
    low, high = ([float(Fraction(r[end])) * u for r, u in zip(over, units)] for end in ("low", "high"))
    if not all(a < b for a, b in zip(low, high)):
        raise Refused("a range that is none")
    whole = Box(low, high)
    if claim["verdict"] == "singular":
        bad = data["singular pose"]
        box = Box(*([float(e[k]) for e in bad["box"]] for k in (0, 1)))
        near = [U * 4 * max(abs(a), abs(b), 1) for a, b in zip(low, high)]
        if len(box.low) != len(low) or any(
            a < x - n or b > y + n for a, b, x, y, n in zip(box.low, box.high, low, high, near)
        ):
            raise Refused("the singular pose is beyond the range")
        ends = bad["opposite signs at"]
        if any(not a <= c <= b for end in ends for a, b, c in zip(box.low, box.high, end)):
            raise Refused("the ends are not in the box")
        place = [c * u for c, u in zip(bad["place"], units)]
        if len(place) != len(low) or any(not a - n <= c <= b + n for a, b, c, n in zip(box.low, box.high, place, near)):
            raise Refused("the pose is not in the box")
        if len(ends) != 2 or sign(robot, ends[0]) * sign(robot, ends[1]) != -1:
            raise Refused("the determinant has no opposite signs at the ends")
        if not all_inside(robot, box, 18):
            raise Refused("the box is not proved to be within the limits")
        return "proved: there is a singular pose in range"
    if claim["verdict"] not in ("free", "outside", "undecided"):
        raise Refused(f"no independent checker yet for {claim['verdict']!r}")
    return _tree(data, robot, whole, claim, jobs, say)


_FOR: dict[str, object] = {}  # what a process knows: the robot, the margin, the half widths of the range


def _start(data, margin, whole):
    _FOR.update(robot=Robot(data), margin=margin, whole=whole)


def _look(leaf):
    _, outside, low, high = leaf
    return leaf, proved(_FOR["robot"], Box(low, high), _FOR["margin"], outside, CUTS, _FOR["whole"])


def _tree(data, robot, whole, claim, jobs, say):
    margin, asked = claim["margin at least"] or 0.0, data["question"]["margin"]
    share = dict.fromkeys("fgoxu", Fraction(0))
    if any(not margin <= b <= 1 for b in data["bounds"]) or (
        claim["verdict"] == "free" and margin < max(asked, 1e-300)
    ):
        raise Refused("the margin claimed is above that of a box, or below the one asked for")
    leaves = list(leaves_of(data["tree"], whole, share))
    if any(abs(float(share[k]) - claim["shares"][name]) > 1e-9 for k, name in SHARES.items()):
        raise Refused("the shares claimed are not those of the boxes")
    if claim["verdict"] != "undecided" and (share["x"] or share["u"]):
        raise Refused("boxes are not decided")
    if len(data["bounds"]) != sum(letter in "fg" for letter in data["tree"]):
        raise Refused("not every free box has a bound")
    if not 0 < claim["target"] <= 1:
        raise Refused("a target that is none")
    seen = claim["smallest margin seen"]
    if seen is not None and not margin <= seen <= 1:
        raise Refused("a margin was seen that is below what is claimed")
    if claim["verdict"] == "outside" and share["f"] + share["g"]:
        raise Refused("not all boxes are outside")
    start, count, begun = (data, margin, whole.half), 0, time.monotonic()
    _start(*start)
    pool = multiprocessing.Pool(jobs, _start, start) if jobs > 1 else None
    try:
        for done, (leaf, boxes) in enumerate(pool.imap_unordered(_look, leaves, 16) if pool else map(_look, leaves), 1):
            count += boxes
            if not boxes:
                ranges = ", ".join(f"{NAMES[k]} {a:.6g}..{b:.6g}" for k, a, b in zip(robot.free, *leaf[2:]))
                raise Refused(f"not proved: box {leaf[0]} of the tree, {ranges} (rad, or the file's unit)")
            if say and time.monotonic() > begun + 2:
                begun = time.monotonic()
                say(f"{done:,} of {len(leaves):,} boxes are proved")
    finally:
        if pool:
            pool.terminate()
    done = 100 * float(share["f"] + share["g"] + share["o"])
    least = f", and the margin there is at least {margin:.6g}" if share["f"] + share["g"] else ""
    word = "undecided, but proved" if claim["verdict"] == "undecided" else "proved"
    return f"{word}: no singular pose within the limits in {done:.6g} % of the range{least} ({count:,} boxes looked at)"


def main():
    parser = argparse.ArgumentParser(description="Check a certificate of gcrules certify again.")
    parser.add_argument("file", metavar="FILE.json[.gz]")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="processes (default 1)")
    arguments = parser.parse_args()
    try:
        with open(arguments.file, "rb") as file:
            data = file.read()
        data = json.loads(
            gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data,
            object_pairs_hook=once,
            parse_constant=once,
        )
        found = checked(data, arguments.jobs, lambda words: print(words, file=sys.stderr))
        print(found)
    except Refused as fault:
        print(f"refused: {fault}")
        return 2 if "no independent checker" in str(fault) else 1
    except (OSError, ValueError, KeyError, TypeError, IndexError, AttributeError, ArithmeticError) as fault:
        print(f"refused: no certificate ({type(fault).__name__}: {fault})")
        return 1
    return 3 if found.startswith("undecided") else 0


if __name__ == "__main__":
    sys.exit(main())
