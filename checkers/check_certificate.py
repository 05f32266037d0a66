#!/usr/bin/env python3
r"""Check a certificate of `gcrules certify` again: python checkers/check_certificate.py FILE.json[.gz] [--jobs N]

It needs Python alone and shares no code with gcrules. From the file it takes the geometry, the range, the limits, the
claim, and the tree of boxes as a hint how to cut; of every box it proves anew that no pose in it is reached within the
limits, or that the margin in it is at least the one claimed, cutting it further where its own bounds need that.

In a box with middle m and half widths h a value is c + sum a_j t_j + r with t_j = (x_j - m_j) / h_j in -1..1, |r| <= e;
e takes in what products, roots and quotients have of second order, and U times all sizes, which is more than rounding.
sin, cos, asin and atan2 are taken to be right to U, and dimensions that follow from those of the file (rods' lengths,
axes of length 1) are floats.

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

from certificate_bounds import NAMES, Box, Refused, U, all_inside, least_value, leaves_of, once, sign_of
from certificate_joints import Joints
from certificate_rods import Rods

CUTS = 16  # of a box of the certificate, so often further
SHARES = {"f": "free", "g": "free with the other sign", "o": "outside", "x": "crossed", "u": "undecided"}


def robot_of(data):
    """The robot of a certificate: six rods, or joints."""
    geometry = data["geometry"]
    if geometry is None:
        raise Refused("no independent checker yet for this robot")
    return Rods(data) if "rods" in geometry else Joints(data)


def proved(robot, box, margin, only_outside, cuts, whole, most=math.inf):
    """How many boxes it takes to prove of a box that none of its poses is reached within the limits, or that all (not
    `only_outside`) have the margin; 0 where it is not proved, or takes many more than `most`.
    """
    outside, _, forces = robot.look(box)
    if outside:
        return 1
    wide = [h / w for h, w in zip(box.half, whole)]
    if forces is not None and not only_outside:
        fine, parts, _ = robot.holds(forces, margin)
        if fine:
            return 1
        wide = parts or wide
    if not cuts:
        return 0
    count = 1
    for part in box.cut(wide.index(max(wide))):
        found = proved(robot, part, margin, only_outside, cuts - 1, whole, most)
        if not found or count > most:
            return 0
        count += found
    return count


def sign(robot, place):
    """The sign of the determinant of W at a place, proved; 0 where it is not."""
    outside, _, forces = robot.look(Box(list(place), list(place)))
    if outside or forces is None:
        return 0
    fine, _, rows = robot.holds(forces, 0.0)
    if not fine or len(rows) != len(rows[0]):
        return 0
    return sign_of(rows)


def asked(robot, q):
    """Of what something is proved, as it was read: the robot, the range, the limits; in rad, or the file's unit."""
    free = {r["coordinate"] for r in q["over"]}
    ranges = [f"{r['coordinate']} {Fraction(r['low'])}..{Fraction(r['high'])} {r['unit']}".strip() for r in q["over"]]
    rest = [f"{n} {float(v)}" for n, v in q["rest"].items() if n in NAMES and n not in free]
    limits = [f"{n!r} {low}..{high}" for n, (low, high) in (q["limits"] or {}).items()]
    limits += [f"{c['end']} cone of {c['rod']!r} {c['angle']}" for c in q["cones"]]
    limits += [f"tilt {q['tilt']}"] if q["tilt"] is not None else []
    lines = [
        robot.words,
        f"turned about {robot.centre}",
        f"over {', '.join(ranges)}",
        f"at {', '.join(rest)}",
        f"limits: {', '.join(limits) or 'none'}",
    ]
    return "\n".join(f"  {line}" for line in lines if line != "at ")


def checked(data, jobs=1, say=None):
    """What is proved, in words, by so many processes; `say` takes words on the way. Raises Refused."""
    if data.get("format") != "gcrules certificate 1":
        raise Refused("no certificate of a known format")
    robot, claim, over = robot_of(data), data["claim"], data["question"]["over"]
    length = data["question"]["robot"].get("units") or ""
    if length in ("deg", "rad") or any(
        r["unit"] not in (("deg", "rad") if NAMES.index(r["coordinate"]) > 2 else (length, "")) for r in over
    ):
        raise Refused("a range in another unit")
    units = [math.pi / 180 if r["unit"] == "deg" else 1.0 for r in over]
    low, high = ([float(Fraction(r[end])) * u for r, u in zip(over, units)] for end in ("low", "high"))
    if not all(a < b for a, b in zip(low, high)):
        raise Refused("a range that is none")
    whole = Box(low, high)
    about = asked(robot, data["question"])
    if claim["verdict"] == "singular":
        bad = data["singular pose"]
        box = Box(*([float(e[k]) for e in bad["box"]] for k in (0, 1)))
        near = [U * 4 * max(abs(a), abs(b), 1) for a, b in zip(low, high)]
        if len(box.low) != len(low) or any(
            a < x - n or b > y + n for a, b, x, y, n in zip(box.low, box.high, low, high, near)
        ):
            raise Refused("the singular pose is beyond the range")
        ends = bad["opposite signs at"]
        if any(len(end) != len(low) for end in ends) or any(
            not a <= c <= b for end in ends for a, b, c in zip(box.low, box.high, end)
        ):
            raise Refused("the ends are not in the box")
        least, most = [a + n for a, n in zip(low, near)], [b - n for b, n in zip(high, near)]
        box = Box(list(map(max, box.low, least)), list(map(min, box.high, most)))  # in the range, whatever is rounded
        ends = [list(map(min, map(max, end, least), most)) for end in ends]
        place = [c * u for c, u in zip(bad["place"], units)]
        if len(place) != len(low) or any(not a - n <= c <= b + n for a, b, c, n in zip(box.low, box.high, place, near)):
            raise Refused("the pose is not in the box")
        if len(ends) != 2 or sign(robot, ends[0]) * sign(robot, ends[1]) != -1:
            raise Refused("the determinant has no opposite signs at the ends")
        if not all_inside(robot, box, 18):
            raise Refused("the box is not proved to be within the limits")
        return f"proved: there is a singular pose in range, within the limits\n{about}"
    if claim["verdict"] == "below":
        wanted, place = (
            float(data["question"]["margin"]),
            [c * u for c, u in zip(data["singular pose"]["place"], units)],
        )
        if len(place) != len(low) or not all(a <= c <= b for a, b, c in zip(low, high, place)):
            raise Refused("the pose is beyond the range")
        _, inside, forces = robot.look(Box(place, place))
        if not inside or forces is None:
            raise Refused("the pose is not proved to be within the limits")
        if not least_value(robot.holds(forces, 0.0)[2]) + 1e-9 < wanted:
            raise Refused("the margin there is not seen to be below the one asked for")
        return f"proved: there is a pose in range, within the limits, with a margin below {wanted}\n{about}"
    if claim["verdict"] not in ("free", "outside", "undecided"):
        raise Refused(f"an unknown verdict {claim['verdict']!r}")
    return f"{_tree(data, robot, whole, claim, jobs, say)}\n{about}"


_FOR: dict[str, object] = {}  # what a process knows: the robot, the margin, the half widths of the range


def _start(data, margin, whole):
    _FOR.update(robot=robot_of(data), margin=margin, whole=whole)


def _look(leaf):
    _, letter, low, high = leaf
    return leaf, proved(_FOR["robot"], Box(low, high), _FOR["margin"], letter == "o", CUTS, _FOR["whole"])


def _tree(data, robot, whole, claim, jobs, say):
    margin, asked = float(claim["margin at least"] or 0.0), data["question"]["margin"]
    share = dict.fromkeys("fgoxu", Fraction(0))
    if any(not margin <= b <= 1 for b in data["bounds"]) or (
        claim["verdict"] == "free" and margin < max(asked, 1e-300)
    ):
        raise Refused("the margin claimed is above that of a box, or below the one asked for")
    leaves = [leaf for leaf in leaves_of(data["tree"], whole, share) if leaf[1] in "fgo"]
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
    part = 100 * (share["f"] + share["g"] + share["o"])
    done = f"{int(part)}.{int(part * 10**6) % 10**6:06}".rstrip("0").rstrip(".")  # rounded down
    least = f", and the margin there is at least {margin}" if share["f"] + share["g"] else ""
    word = "undecided, but proved" if claim["verdict"] == "undecided" else "proved"
    return f"{word}: no singular pose within the limits in {done} % of the range{least} ({count:,} boxes looked at)"


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
