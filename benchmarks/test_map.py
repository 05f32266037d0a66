"""Maps beside what one writes without them.

The superbracket over a grid: a loop over the poses that takes `numpy.linalg.det` of each Jacobian, and the stack of all
Jacobians at once. Proving cells free: marching over signs only is no proof, so the peer is the margin at the middle
of each cell, which proves it too. A robot of joints: closing its loops at each pose by itself, from home.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.maps.limb_task import limbs_task
from gcrules.poses.maps.planned import planned
from gcrules.screws.threshold import DEFAULT

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
OVER = ["x -300:300:160", "z -500:100:250"]


def task(robot: str, over: list[str], measure: str) -> Any:
    legs = SixLegs(load_platform(EXAMPLES / f"{robot}.yaml"), "origin")
    return planned(legs, over, None, None, DEFAULT, measure).task


OF_RPR = ["x -0.4:0.4:81", "yaw -20:60:81 deg"]
OF_RPS = ["roll -60:60:25 deg", "pitch -60:60:25 deg"]


def nodes(t: Any) -> Any:
    return np.stack(np.unravel_index(np.arange(t.grid.size), t.grid.shape), axis=1)


def stacked(t: Any) -> Any:
    ends, base = t.grid.ends(t.grid.coordinates(nodes(t))), t.grid.rig.base
    legs = zip(t.grid.rig.legs, t.grid.rig.structure.legs, strict=True)
    sign = -((-1) ** sum(leg != typed for leg, typed in legs))
    rows = np.concatenate([ends - base, np.cross(base, ends)], axis=2)
    return sign * np.linalg.det(rows)


def looped(t: Any) -> Any:
    base, places = t.grid.rig.base, t.grid.coordinates(nodes(t))
    legs = zip(t.grid.rig.legs, t.grid.rig.structure.legs, strict=True)
    sign = -((-1) ** sum(leg != typed for leg, typed in legs))
    found = np.empty(len(places))
    for n in range(len(places)):
        ends = t.grid.ends(places[n : n + 1])[0]
        found[n] = sign * np.linalg.det(np.concatenate([ends - base, np.cross(base, ends)], axis=1))
    return found


def test_values_of_a_map(ratio: Callable[..., Any]) -> None:
    """40,000 poses, and with them the proof for 39,591 cells, which the others do not have."""
    t = task("octahedral", OVER, "value")

    def chunks() -> Any:
        return np.concatenate([t.compute(n)["superbracket"] for n in range(t.number)]).ravel()

    def agree(one: Any, other: Any) -> bool:
        return bool(np.abs(one - other).max() <= 1e-10 * np.abs(one).max())

    ratio(
        chunks,
        {"stacked determinants": lambda: stacked(t), "one by one": lambda: looped(t)},
        agree=agree,
        at_least={"stacked determinants": 1, "one by one": 20},
        others_rounds=1,
    )


def test_a_robot_of_joints(ratio: Callable[..., Any]) -> None:
    """Delta over 31 × 31 poses, its cells proved, beside each pose solved from home, which proves no cell."""
    found = Limbs.of(read_robot("delta"))
    over = ["x -0.6:0.6:31", "y -0.6:0.6:31"]

    def swept() -> Any:
        return margins_of(limbs_task(found, over)).ravel()

    def alone() -> Any:
        grid, m = limbs_task(found, over).grid, found.linkage
        origin, steps = grid.linear
        goals = origin + np.stack(np.unravel_index(np.arange(grid.size), grid.shape), axis=1) @ steps
        return np.array([margin(m, solve(m, Target(grid.names, g)).configuration).sigma for g in goals])

    def agree(one: Any, other: Any) -> bool:
        return bool(np.abs(one - other).max() <= 1e-6)

    ratio(swept, {"each from home": alone}, agree=agree, at_least={"each from home": 4}, rounds=2, others_rounds=1)


def test_a_surface_of_a_robot_of_joints(ratio: Callable[..., Any]) -> None:
    """Orthoglide over 7 × 7 × 7 poses of which many are out of reach, its cells proved, beside those in reach solved
    from home one by one.
    """
    found = Limbs.of(read_robot("orthoglide"))
    over = [f"{name} -3:3:7" for name in "xyz"]

    def swept() -> int:
        return int((~np.isnan(margins_of(limbs_task(found, over)))).sum())

    def alone() -> int:
        t, m = limbs_task(found, over), found.linkage
        origin, steps = t.grid.linear
        nodes = np.flatnonzero(t._branch.owner >= 0)
        goals = origin + np.stack(np.unravel_index(nodes, t.grid.shape), axis=1) @ steps
        return int(np.isfinite([margin(m, solve(m, Target(t.grid.names, g)).configuration).sigma for g in goals]).sum())

    ratio(swept, {"those in reach, from home": alone}, agree=int.__eq__, within=10, rounds=1, others_rounds=1)


def margins_of(t: Any) -> Any:
    return np.concatenate([t.compute(k)["margin"] for k in range(t.number)])


@pytest.mark.parametrize(("robot", "over", "times"), [("3-rpr", OF_RPR, 5), ("3-rps", OF_RPS, 2)])
def test_the_stage_of_a_robot_of_joints(ratio: Callable[..., Any], robot: str, over: list[str], times: float) -> None:
    """Home's branch, which comes before all tiles and cannot be shared among workers, beside the whole map with it:
    the goal is how many times as long that takes, less where much of the grid is out of reach.
    """
    found = Limbs.of(read_robot(robot))

    def stage() -> int:
        t = limbs_task(found, over)
        t.staged()
        return int((t._branch.owner >= 0).sum())

    def whole() -> int:
        return int((~np.isnan(margins_of(limbs_task(found, over)))).sum())

    ratio(stage, {"whole map": whole}, agree=int.__eq__, at_least={"whole map": times}, rounds=2, others_rounds=1)


@pytest.mark.parametrize("robot", ["octahedral", "platform-6-6"])
def test_proofs_of_cells(ratio: Callable[..., Any], robot: str) -> None:
    """Bernstein coefficients beside bounds around the middles of cells: both prove, the latter less."""
    over = OVER if robot == "octahedral" else ["x -2:2:160", "z -2:2:250"]
    exact = task(robot, over, "value")
    by_bounds = replace(exact, factors=None, measure="margin")

    def cells(t: Any) -> Any:
        return np.concatenate([t._cells(t.span(n)[0], t._superbracket(*reached(t, n))) for n in range(t.number)])

    def reached(t: Any, n: int) -> tuple[int, int]:
        first, last = t.span(n)
        return first, min(last + 1, t.grid.shape[0])

    def agree(one: Any, other: Any) -> bool:
        return bool((one[other == 0] == 0).all())  # what bounds prove free is free

    ratio(lambda: cells(exact), {"bounds": lambda: cells(by_bounds)}, agree=agree, rounds=3, others_rounds=1)
