#!/usr/bin/env python3
r"""See again that there is no way without a singular pose: python checkers/check_plan.py FILE.json[.gz]

It needs Python alone and shares no code with gcrules. From the file that `gcrules plan ... --certificate FILE.json`
wrote it takes a platform on six legs and two poses, all numbers exact, and computes in both the determinant of the six
rows (f, m), f from one end of a leg to the other and m its moment. A pose moves each point p of the platform to
R (p - c) + c + t.

The determinant is a polynomial in the entries of R and t, and so it changes continuously along every way on which R
and t do. Where it has opposite signs in two poses it is 0 in between, on every way that joins them (the intermediate
value theorem), whatever the legs' limits are, and however the platform turns. Where it is 0 the six rows depend on each
other: either a leg has no length there, its row being 0, or the six lines of the legs belong to one linear complex.
Both count as singular: a leg of no length has no line, and so no direction in which it could hold the platform.

Nothing is rounded. Exit codes: 0 the signs are opposite, and as the file says; 1 they are not; 2 the file is not a
certificate that is known here, or names another digest. All this is recomputed, not proved in Coq.
"""

from __future__ import annotations

import sys

from certificate_bounds import Refused
from map_files import answered, check_digest
from map_slice import Platform, expect, rotation, vector
from map_turns import exact_sign

FORMAT = "gcrules plan certificate 1"
KEYS = {"format", "made by", "title", "unit", "legs", "points", "centre", "poses", "signs", "digest"}
ENDS = ("start", "goal")


def checked(data, say=None):
    """What is seen, in words. Raises Refused."""
    expect(data.get("format") == FORMAT and set(data) == KEYS, "no certificate that there is no way")
    platform = Platform(data)
    check_digest(data)
    poses, signs = data["poses"], data["signs"]
    expect(all(isinstance(d, dict) and set(d) == set(ENDS) for d in (poses, signs)), "no start, or no goal")
    lines, found = [], []
    for end in ENDS:
        pose = poses[end]
        expect(isinstance(pose, dict) and set(pose) == {"translation", "quaternion"}, "no pose")
        expect(type(signs[end]) is int and signs[end] in (-1, 1), "a sign is 1 or -1")
        shift, quaternion = vector(pose["translation"]), vector(pose["quaternion"], 4)
        found.append(exact_sign(platform, rotation(quaternion), shift))
        if found[-1] != signs[end]:
            words = {0: "is 0", 1: "is positive", -1: "is negative"}[found[-1]]
            raise Refused(f"the determinant {words} at the {end}, which is not what the file says")
        sign = "positive" if found[-1] > 0 else "negative"
        turn = f"turned by the quaternion {' '.join(map(str, quaternion))}"
        lines.append(f"{sign} at the {end}: shifted by {' '.join(map(str, shift))}, {turn}")
    if found[0] != -found[1]:
        raise Refused("the determinant has the same sign at the start and at the goal")
    lines = [
        "proved: every way from the start to the goal passes a singular pose, since the determinant of the legs is",
        *lines,
    ]
    rest = ["nothing rounded; recomputed, not proved in Coq; limits of legs are not considered", *platform.words()]
    return "\n".join([lines[0], *(f"  {line}" for line in lines[1:] + rest), f"digest {data['digest']}"]), 0


def main():
    return answered("See again that there is no way without a singular pose.", checked)


if __name__ == "__main__":
    sys.exit(main())
