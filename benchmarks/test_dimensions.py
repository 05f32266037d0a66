"""What the dimensions of a platform and of robots say, beside every subset, permutation and pose tried one by one."""

from __future__ import annotations

import operator
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations, permutations
from pathlib import Path
from random import Random
from typing import Any

import pytest

import gcrules as gc
from gcrules.conditions.dimensions import architecture, dimensions
from gcrules.core.linear_algebra import rank
from gcrules.mechanisms.dimensions.robot_dimensions import dimensions_of_robot
from gcrules.mechanisms.load import read_robot
from gcrules.screws.rotations import rotation

PLATFORM: Any = gc.load(Path(__file__).resolve().parent.parent / "examples" / "platform-6-6.yaml")
STRUCTURE: Any = gc.analyze(PLATFORM, facts=False).structure
SIDES: list[list[Any]] = [[PLATFORM.points[leg[end]] for leg in STRUCTURE.oriented] for end in (0, 1)]
POSES = 3


def facts() -> tuple[set[int], bool, bool]:
    """How many joints of a body are in a plane, whether a motion keeps both bodies, whether all poses are singular."""
    dimensions._found.cache_clear()
    architecture._decided.cache_clear()
    found = dimensions.dimensions_of(STRUCTURE, PLATFORM.points, 1e-9)
    assert found is not None
    planes = {len(f.members) for f in found.facts if f.kind == "coplanar"}
    return planes, any(f.kind in ("rotation", "mirror") for f in found.facts), found.architecture.singular


def one_by_one() -> tuple[set[int], bool, bool]:
    """The ranks of all subsets of a body's joints, all permutations of the legs, and exact ranks in random poses."""
    planes: set[int] = set()
    for body in SIDES:
        flat = [some for size in (3, 4, 5, 6) for some in combinations(body, size) if _spanned(some) < 3 < size]
        planes |= {max(map(len, flat))} if flat else set()
        for size in (3, 4, 5, 6):
            for some in combinations(body, size):
                rank([(1, *p, sum(c * c for c in p)) for p in some])  # circles
    tables = [[[_square(p, q) for q in body] for p in body] for body in SIDES]
    kept = [
        images
        for images in permutations(range(6))
        if all(t[i][j] == t[images[i]][images[j]] for t in tables for i in range(6) for j in range(i))
    ]
    return planes, len(kept) > 1, all(_singular(Random(seed)) for seed in range(POSES))


def _spanned(places: Any) -> int:
    return rank([[a - b for a, b in zip(p, places[0], strict=True)] for p in places[1:]])


def _square(p: Any, q: Any) -> Fraction:
    return sum(((a - b) ** 2 for a, b in zip(p, q, strict=True)), Fraction(0))


def _singular(draw: Random) -> bool:
    w, x, y, z = (Fraction(draw.randint(1, 99)) for _ in range(4))
    turn = rotation((w, x, y, z))
    shift = [Fraction(draw.randint(-99, 99)) for _ in range(3)]
    rows = []
    for (a, b, c), p in zip(*SIDES, strict=True):
        u, v, n = (sum((r * e for r, e in zip(row, p, strict=True)), s) for row, s in zip(turn, shift, strict=True))
        rows.append((u - a, v - b, n - c, b * n - c * v, c * u - a * n, a * v - b * u))
    return rank(rows) < 6


def test_dimensions_of_a_platform(ratio: Callable[..., Any]) -> None:
    ratio(facts, {"one by one": one_by_one}, agree=operator.eq, within=0.1, at_least={"one by one": 2})


@pytest.mark.parametrize("name", ["3-rps", "4-ruu", "8-cables"])
def test_dimensions_of_a_robot(ratio: Callable[..., Any], name: str) -> None:
    robot = read_robot(name)
    ratio(lambda: dimensions_of_robot(robot), {}, within=0.3)
