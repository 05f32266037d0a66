"""The robots that are shipped and those of tests/data, analysed once."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Sequence
from functools import cache

from places import DATA

import gcrules as gc
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.family import Path as MemberPath
from gcrules.mechanisms.description.relations import Values
from gcrules.mechanisms.lines.singular import interpolated, roots
from gcrules.mechanisms.load import read_robot

__all__ = ["AS_MANY", "GIVEN_BY_LINES", "GOOD", "OTHERS", "REDUNDANT", "analysis", "robot", "singular_members"]
FILES = DATA / "robots"
REDUNDANT = ("4-rpr", "8-cables")
"""Shipped robots with more actuators than freedoms."""
AS_MANY = tuple(one.id for one in robots() if one.id not in REDUNDANT)
"""The others."""
OTHERS = {  # robots from the literature's families, and what is said of them
    "2-prr-ppr": "the lines A1B1, A2B2 and n3C meet in a point or are parallel",
    "2-ups-u": "the planes A1B1O, A2B2O and uvO, which pass through O, have a common line",
    "3-cru": "the lines B1C1, B2C2 and B3C3 are parallel to one plane (actuation singularity)",
    "3-prrr": "the directions u1, u2 and u3 are parallel to one plane",
    "3-psp": "the planes of leg 1 (n1n1'S1), leg 2 (n2n2'S2) and leg 3 (n3n3'S3) and the plane S1S2S3 meet in a point",
    "3-rrr-space": "the planes B1C1z, B2C2z and B3C3z, which are parallel to the direction z, have a common line",
    "3-rrs": "the planes of leg 1 (r1B1S1), leg 2 (r2B2S2) and leg 3 (r3B3S3) and the platform plane S1S2S3 meet",
    "3-ruu": "the moments u1 × v1, u2 × v2 and u3 × v3 of the couples are parallel to one plane (constraint",
    "3-upu-wrist": "the planes A1B1O, A2B2O and A3B3O, which pass through O, have a common line (constraint",
    "4-upu-pairs": "Without the wrenches along A3B3 and A4B4 the platform can turn",
    "5-ups-prpu": "the lines A1B1, A2B2, A3B3, A4B4, A5B5 and rs belong to one linear complex",
    "6-pss": "the lines A1B1, A2B2, A3B3, A4B4, A5B5 and A6B6 belong to one linear complex",
}


@cache
def robot(name: str) -> gc.Robot:
    return read_robot(FILES / f"{name}.yaml" if name in OTHERS else name)


@cache
def analysis(name: str) -> RobotAnalysis:
    return analyze_robot(robot(name))


def singular_members(
    name: str, value: Callable[[Values], int], number: int, seed: object, among: Sequence[str] = ()
) -> Iterator[Values]:
    """Members at which a polynomial in the parameters vanishes, on `number` paths that each move one name."""
    family = robot(name).family
    names = [n for n in family.parametrized if n in among or not among]
    random.Random(f"{name} {seed}").shuffle(names)
    for n in range(number):
        path: MemberPath = family.path((seed, n), names[n % len(names)])

        def along(t: int, path: MemberPath = path) -> int:
            return value(path.member(t))

        polynomial = interpolated(along)
        for t in roots(polynomial or []):
            yield path.member(t)


GIVEN_BY_LINES = """
title: lines of the paper
points: {S1: free, S2: free, S3: free, A1: free, B1: free, C1: free, A2: free, A3: free, B3: free}
lines: S1A1 S1B1 S1C1 S2A2 S3A3 S3B3
mobility: 4
"""


GOOD = """\
title: three legs
copies: 3
points:
  A%: free
  S%: in plane A% perpendicular to r%
directions:
  r%: free
limbs:
  - name: leg %
    joints: R(A%, r%) P*(A% S%) S(S%)
mobility: 3
"""
