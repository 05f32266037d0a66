#!/usr/bin/env python3
r"""Check a certificate of `gcrules certify` again: python tools/check_certificate.py FILE.json[.gz]

It needs Python alone and shares no code with gcrules. From the file it takes the geometry, the range, the limits, the
claim, and the tree of boxes as a hint how to cut; of every box it proves anew that no pose in it is reached within the
limits, or that the margin in it is at least the one claimed, cutting it further where its own bounds need that.

Numbers are intervals, rounded outwards by `math.nextafter`; sin, cos, asin and atan2 are taken to be right to 2^-48,
and dimensions that follow from those of the file (rods' lengths, axes of length 1) are floats. A value f of the
coordinates x in a box has its interval in the middle m, an interval over the box, and one for each derivative there;
f(x) lies in f(m) + sum f'_j(box) (x_j - m_j), which narrows the second one after each operation.

The wrench of rod i on the platform is the unit force f_i along it through its end p_i: W_i = (f_i; p_i x f_i), moments
about the mean of the ends. The margin is the s with s^2 = the least value over twists t of |W t|^2 / sum |v_i(t)|^2,
v_i the velocity of p_i; with the columns of K orthonormal in the second form it is the least singular value of W K.
Let B be near the inverse of W K in the middle, |1 - B W K| <= A in all entries, l the lengths of B's rows, v > 0 with
v >= A v + l. If (W K + D) x = 0 with |x| = 1, |D| = d, then |x| <= A |x| + d l, so that |x| <= d v: all margins in the
box are at least 1/|v|. They are also at least (1 - |A|) / |B|, in spectral norms, and the least singular value in the
middle less the size of what W K changes.

Exit codes: 0 what is claimed is proved, 1 it is not, 2 the file is no certificate of a robot that is known here.
"""

from __future__ import annotations

import gzip
import json
import math
import sys
from fractions import Fraction

from certificate_intervals import (
    EPS,
    INF,
    Beyond,
    Box,
    Undefined,
    Value,
    check,
    cross,
    dot,
    down,
    flat,
    least_margin,
    point,
    span,
    up,
    wave,
)

CUTS = 14  # of a box of the certificate, so often further
SHARES = {"f": "free", "g": "free with the other sign", "o": "outside", "x": "crossed", "u": "undecided"}
NAMES = ("x", "y", "z", "roll", "pitch", "yaw")


class Refused(Exception):
    """The certificate does not hold, or is none."""


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
        for rod in self.rods:
            if rod["drive"] not in ("leg", "turn", "slide"):
                raise Refused(f"no independent checker yet for a drive that is a {rod['drive']}")
        names = [rod.get("actuator") for rod in self.rods]
        order = range(6) if names[0] is None else [names.index(n) for n in q["limits"] or () if n in names]
        self.limits = [(-INF, INF)] * 6
        if q["limits"]:
            if len(q["limits"]) != 6 or (names[0] and set(names) != set(q["limits"])):
                raise Refused("the limits are not those of six drives")
            for k, (low, high) in zip(order, q["limits"].values()):
                self.limits[k] = (-INF if low is None else low, INF if high is None else high)
        self.cones = []
        for c in q["cones"]:
            k = next((k for k, rod in enumerate(self.rods) if rod["names"] == c["rod"]), None)
            if k is None or c["end"] not in ("base", "platform"):
                raise Refused("a cone of an unknown rod")
            self.cones.append((k, c["end"], math.cos(c["angle"])))
        self.tilt = None if q["tilt"] is None else math.cos(q["tilt"])
        ends = [rod["ends"][1] for rod in self.rods]
        self.mean = [sum(e[j] for e in ends) / 6 for j in range(3)]
        self.arms = [[e[j] - self.mean[j] for j in range(3)] for e in ends]
        self.scale = self._scale()

    def _scale(self):
        """K: columns orthonormal in sum |v_i|^2, v_i = v + w x arm, by Cholesky, and then compared exactly."""
        rows = []
        for x, y, z in self.arms:
            rows += [[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]]
        exact = [[sum(Fraction(r[i]) * Fraction(r[j]) for r in rows) for j in range(6)] for i in range(6)]
        low = [[0.0] * 6 for _ in range(6)]
        for i in range(6):
            for j in range(i + 1):
                rest = float(exact[i][j]) - sum(low[i][k] * low[j][k] for k in range(j))
                if i == j and rest <= 0:
                    raise Refused("the ends of the rods lie on one line")
                low[i][j] = math.sqrt(rest) if i == j else rest / low[j][j]
        scale = [[0.0] * 6 for _ in range(6)]  # the transposed inverse of low
        for c in range(6):
            for i in range(c, 6):
                scale[c][i] = ((i == c) - sum(low[i][k] * scale[c][k] for k in range(c, i))) / low[i][i]
        k = [[Fraction(x) for x in row] for row in scale]
        for i in range(6):
            for j in range(6):
                value = sum(k[a][i] * exact[a][b] * k[b][j] for a in range(6) for b in range(6))
                if abs(value - (i == j)) > Fraction(1, 10**10):
                    raise Refused("the balance of the margin is not computed well enough")
        return scale

    def poses(self, box):
        """The shift of the centre and the rotation."""
        at = {k: n for n, k in enumerate(self.free)}
        none = (0.0, 0.0)

        def coordinate(k):
            n = at.get(k)
            if n is None:
                return Value(point(self.rest[k]), point(self.rest[k]), None, box.half)
            m, h = box.middle[n], box.half[n]
            g = [(1.0, 1.0) if j == n else none for j in range(len(box.half))]
            return Value(point(m), (down(m - h), up(m + h)), g, box.half)

        angles = [box.middle[at[k]] if k in at else self.rest[k] for k in (3, 4, 5)]
        (sr, cr), (sp, cp), (sy, cy) = (
            (wave(box, at.get(k), a, 0), wave(box, at.get(k), a, 1)) for k, a in zip((3, 4, 5), angles)
        )
        turn = [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
        return [coordinate(k) for k in range(3)], turn

    def rod(self, k, shift, turn):
        """The rod's vector in the base, what it is divided by to have length 1, cosine and sine of its drive's turn or
        its amount. Raises Undefined where it may not exist; `Beyond` where it does not.
        """
        rod = self.rods[k]
        start, end = rod["ends"]
        arm = [e - c for e, c in zip(end, self.centre)]
        tip = [
            flat(turn[j], arm) + shift[j] + self.centre[j] if any(arm) else shift[j] + self.centre[j] for j in range(3)
        ]
        if rod["drive"] == "leg":
            v = [tip[j] + (-start[j]) for j in range(3)]
            length = dot(v, v).root()
            return v, length.inverse(), length
        home = [e - s for e, s in zip(end, start)]
        square = sum(c * c for c in home)
        size = sum(c * c for c in rod["axis"]) ** 0.5
        axis = [c / size for c in rod["axis"]]
        by = 1 / math.sqrt(square)
        if rod["drive"] == "slide":  # |D - q d| = L, D from the start at home
            far = [tip[j] + (-start[j]) for j in range(3)]
            along = flat(far, axis)
            under = along * along - dot(far, far) + square
            check(under)
            sign = -branch(sum(h * a for h, a in zip(home, axis)), square)
            amount = along + under.root() * sign
            return [far[j] - amount * axis[j] for j in range(3)], by, amount
        off = [s - t for s, t in zip(start, rod["through"])]
        height = sum(o * a for o, a in zip(off, axis))
        foot = [t + height * a for t, a in zip(rod["through"], axis)]
        radius = [s - f for s, f in zip(start, foot)]
        h = math.sqrt(sum(c * c for c in radius))
        one = [c / h for c in radius]
        other = cross(axis, one)
        far = [tip[j] + (-foot[j]) for j in range(3)]
        u, w = flat(far, one), flat(far, other)
        reach = (dot(far, far) + (h * h - square)) * (0.5 / h)
        both = u * u + w * w
        under = both - reach * reach
        check(under)
        at_home = sum((e - f) * o for e, f, o in zip(end, foot, other))
        s, over = under.root() * -branch(at_home, square), both.inverse()
        cosine, sine = (u * reach - w * s) * over, (w * reach + u * s) * over
        v = [far[j] - (cosine * (h * one[j]) + sine * (h * other[j])) for j in range(3)]
        return v, by, (cosine, sine)

    def look(self, box):
        """(outside, inside, rows): that no pose of the box is reached within the limits, that all are, and W."""
        shift, turn = self.poses(box)
        inside, rows, rods = True, [], []
        if self.tilt is not None:
            value = turn[2][2] + (-self.tilt)
            if value.r[1] < -EPS:
                return True, False, None
            inside &= value.r[0] > EPS
        unknown = False
        for k in range(6):
            try:
                v, by, amount = self.rod(k, shift, turn)
            except Beyond:
                return True, False, None
            except Undefined:
                unknown = True
                rods.append(None)
                continue
            low, high = span(amount)
            least, most = self.limits[k]
            away, within = True, False
            for round_ in (-1, 0, 1) if isinstance(amount, tuple) else (0,):
                a, b = (c + round_ * 2 * math.pi for c in (low, high))
                away &= b < least - EPS * 8 or a > most + EPS * 8
                within |= a > least + EPS * 8 and b < most - EPS * 8
            if away:
                return True, False, None
            inside &= within
            rods.append((v, by, amount))
            seen = [turn[0][j] * v[0] + turn[1][j] * v[1] + turn[2][j] * v[2] for j in range(3)]
            force = [c * by for c in seen]
            x, y, z = self.arms[k]
            rows.append([*force, force[2] * y - force[1] * z, force[0] * z - force[2] * x, force[1] * x - force[0] * y])
        for k, end, cosine in self.cones:
            if rods[k] is None:
                continue
            v, by, amount = rods[k]
            value = self.lean(k, end, v, by, amount, turn) + (-cosine)
            if value.r[1] < -EPS * 8:
                return True, False, None
            inside &= value.r[0] > EPS * 8
        return False, inside and not unknown, None if unknown else rows

    def lean(self, k, end, v, by, amount, turn):
        """The cosine of the angle between a rod and its direction at home on the body at its end."""
        rod = self.rods[k]
        home = [e - s for e, s in zip(*reversed(rod["ends"]))]
        size = math.sqrt(sum(c * c for c in home))
        home = [c / size for c in home]
        if end == "platform":
            carried = [flat(turn[j], home) for j in range(3)]
        elif rod["drive"] == "turn":
            size = math.sqrt(sum(c * c for c in rod["axis"]))
            a = [c / size for c in rod["axis"]]
            along = sum(x * y for x, y in zip(home, a))
            across = [home[j] - along * a[j] for j in range(3)]
            more = cross(a, across)
            carried = [amount[0] * across[j] + amount[1] * more[j] + along * a[j] for j in range(3)]
        else:
            return flat(v, home) * by
        return dot(carried, v) * by


def branch(at_home, square):
    """Of two solutions of a drive the one at home. Raises Refused where they are not apart there."""
    if abs(at_home) < 1e-6 * math.sqrt(square):
        raise Refused("home is a dead point of a drive")
    return 1.0 if at_home > 0 else -1.0


def proved(robot, box, margin, only_outside, cuts, count):
    """Whether every pose of a box is not reached within the limits, or (not `only_outside`) has the margin."""
    count[0] += 1
    outside, _, rows = robot.look(box)
    if outside:
        return True
    wide = [h / w for h, w in zip(box.half, count[1])]
    k = wide.index(max(wide))
    if rows is not None and not only_outside:
        found, parts = least_margin(robot.scale, rows, box.half)
        if found >= margin and found > 0:
            return True
        k = parts.index(max(parts))
    if not cuts:
        return False
    return all(proved(robot, part, margin, only_outside, cuts - 1, count) for part in box.cut(k))


def all_inside(robot, box, cuts):
    _, inside, rows = robot.look(box)
    if inside and rows is not None:
        return True
    k = box.half.index(max(box.half))
    return cuts > 0 and all(all_inside(robot, part, cuts - 1) for part in box.cut(k))


def sign(robot, place):
    """The sign of the determinant of W at a place, proved; 0 where it is not."""
    box = Box(list(place), list(place))
    outside, _, rows = robot.look(box)
    if outside or rows is None or not least_margin(robot.scale, rows, box.half)[0]:
        return 0
    rows = [[Fraction((c.m[0] + c.m[1]) / 2) for c in row] for row in rows]
    value = Fraction(1)
    for i in range(6):
        p = next((k for k in range(i, 6) if rows[k][i]), None)
        if p is None:
            return 0
        if p != i:
            rows[i], rows[p], value = rows[p], rows[i], -value
        value *= rows[i][i]
        for k in range(i + 1, 6):
            c = rows[k][i] / rows[i][i]
            rows[k] = [a - c * b for a, b in zip(rows[k], rows[i])]
    return 1 if value > 0 else -1


def checked(data):
    """What is proved, in words; raises Refused."""
    if data.get("format") != "gcrules certificate 1":
        raise Refused("no certificate of a known format")
    robot, claim, over = Robot(data), data["claim"], data["question"]["over"]
    units = [math.pi / 180 if r["unit"] == "deg" else 1.0 for r in over]
    low, high = ([float(Fraction(r[end])) * u for r, u in zip(over, units)] for end in ("low", "high"))
    if any(r["unit"] == "deg" and NAMES.index(r["coordinate"]) < 3 for r in over) or not all(
        a < b for a, b in zip(low, high)
    ):
        raise Refused("a range that is none")
    whole = Box(low, high)
    if claim["verdict"] == "singular":
        bad = data["singular pose"]
        box = Box(*([float(e[k]) for e in bad["box"]] for k in (0, 1)))
        near = [EPS * 16 * max(abs(a), abs(b), 1) for a, b in zip(low, high)]
        if len(box.low) != len(low) or any(
            a < x - n or b > y + n for a, b, x, y, n in zip(box.low, box.high, low, high, near)
        ):
            raise Refused("the singular pose is beyond the range")
        ends = bad["opposite signs at"]
        if any(not a <= c <= b for end in ends for a, b, c in zip(box.low, box.high, end)):
            raise Refused("the ends are not in the box")
        if len(ends) != 2 or sign(robot, ends[0]) * sign(robot, ends[1]) != -1:
            raise Refused("the determinant has no opposite signs at the ends")
        if not all_inside(robot, box, 18):
            raise Refused("the box is not proved to be within the limits")
        return "proved: there is a singular pose in range"
    if claim["verdict"] not in ("free", "outside", "undecided"):
        raise Refused(f"no independent checker yet for {claim['verdict']!r}")
    return _tree(data, robot, whole, claim)


def _tree(data, robot, whole, claim):
    margin, asked = claim["margin at least"] or 0.0, data["question"]["margin"]
    waiting, share, count = [(whole, Fraction(1))], dict.fromkeys("fgoxu", Fraction(0)), [0, whole.half]
    if any(b < margin for b in data["bounds"]) or (claim["verdict"] == "free" and margin < max(asked, 1e-300)):
        raise Refused("the margin claimed is above that of a box, or below the one asked for")
    for place, letter in enumerate(data["tree"]):
        if not waiting:
            raise Refused("the tree goes on after its end")
        box, part = waiting.pop()
        if letter.isdigit() and int(letter) < len(whole.low):
            first, second = box.cut(int(letter))
            waiting += [(second, part / 2), (first, part / 2)]
            continue
        if letter not in share:
            raise Refused(f"{letter!r} in the tree")
        share[letter] += part
        if letter in "fgo" and not proved(robot, box, max(margin, 1e-300), letter == "o", CUTS, count):
            ranges = ", ".join(f"{NAMES[k]} {a:.6g}..{b:.6g}" for k, a, b in zip(robot.free, box.low, box.high))
            raise Refused(f"not proved: box {place} of the tree, {ranges} (rad, or the file's unit)")
    if waiting:
        raise Refused("the tree ends too soon: boxes are missing")
    if any(abs(float(share[k]) - claim["shares"][name]) > 1e-9 for k, name in SHARES.items()):
        raise Refused("the shares claimed are not those of the boxes")
    if claim["verdict"] != "undecided" and (share["x"] or share["u"]):
        raise Refused("boxes are not decided")
    if claim["verdict"] == "outside" and share["f"] + share["g"]:
        raise Refused("not all boxes are outside")
    done = 100 * float(share["f"] + share["g"] + share["o"])
    least = f", and the margin there is at least {margin:.6g}" if share["f"] + share["g"] else ""
    return (
        f"proved: no singular pose within the limits in {done:.6g} % of the range{least} ({count[0]:,} boxes looked at)"
    )


def main(arguments):
    if len(arguments) != 1:
        print("usage: check_certificate.py FILE.json[.gz]", file=sys.stderr)
        return 2
    try:
        with open(arguments[0], "rb") as file:
            data = file.read()
        data = json.loads(gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data)
        print(checked(data))
    except Refused as fault:
        print(f"refused: {fault}")
        return 2 if "no independent checker" in str(fault) else 1
    except (OSError, ValueError, KeyError, TypeError, IndexError, AttributeError, ArithmeticError) as fault:
        print(f"refused: no certificate ({type(fault).__name__}: {fault})")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
