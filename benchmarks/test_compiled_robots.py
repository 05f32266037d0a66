"""Robots of joints at 10⁶ poses, beside the condition of six legs, and beside plain loops over the poses.

"six legs" is the compiled superbracket of the octahedral platform at as many poses by the same engine. The loops are
what one writes for one pose after the other: the arms of Delta in closed form, and the factors, by NumPy; `gc.pose`
gives the same values. Margins by programs stand beside the same by closing the loops. All on one core.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gcrules as gc
from gcrules.poses.numbers.arrays import matrices

MANY = 1_000_000
EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
RNG = np.random.default_rng(7)
POSES = RNG.uniform(-0.1, 0.1, (MANY, 3))
TURNS = np.ascontiguousarray(matrices(RNG.normal(size=(MANY, 4))))
OUT = np.empty(MANY)
AGREE = 1e-9


@pytest.mark.parametrize("engine", ["numba", "numpy"])
@pytest.mark.parametrize("name", ["delta", "3-rps"])
def test_factors(ratio: Callable[..., Any], name: str, engine: str) -> None:
    if not find_spec(engine):
        pytest.skip(f"{engine} is not installed")
    value: Any = gc.compiled(name, engine=engine)
    legs: Any = gc.compiled(str(EXAMPLES / "octahedral.yaml"), engine=engine)
    ratio(
        lambda: value(POSES),
        {"six legs": lambda: legs(POSES, TURNS, out=OUT)},
        at_least={"six legs": 1 / 5},
        rounds=7,
    )


def arms_of_delta(robot: Any) -> Callable[[Any], tuple[float, float]]:
    """The two factors of one pose of Delta, the arms in closed form."""
    home = {n: np.array([float(c) for c in v]) for n, v in robot.home.items()}

    def unit(v: Any) -> Any:
        return v / np.linalg.norm(v)

    def at(pose: Any) -> tuple[float, float]:
        place: dict[str, Any] = {}
        for k in "123":
            base, axis, elbow, bar = (home[n + k] for n in "OrAd")
            axis = unit(axis)
            radius = (elbow - base) - axis * (axis @ (elbow - base))
            across = np.cross(axis, radius)
            middle = elbow - radius
            e = elbow + bar + pose - middle
            a, b, c = -2 * e @ radius, -2 * e @ across, e @ e + radius @ radius - bar @ bar
            square = a * a + b * b
            rest = np.sqrt(square - c * c) * -np.sign((elbow + bar - middle) @ across * -2)
            cosine, sine = -(a * c + b * rest) / square, (a * rest - b * c) / square
            place["A" + k] = middle + radius * cosine + across * sine
            place["d" + k], place["r" + k] = elbow + bar + pose - place["A" + k], home["r" + k]
        points = np.array([place["A" + k] for k in "123"])
        centre = points.mean(axis=0)
        scale = np.sqrt(((points - centre) ** 2).sum() / 3)
        near = {k: (place["A" + k] - centre) / scale for k in "123"}
        d = {k: unit(place["d" + k]) for k in "123"}
        first = np.linalg.det(np.array([[*d["1"], 0], [*d["2"], 0], [*d["3"], 0], [*near["1"], 1]]).T)
        first /= np.sqrt(1 + near["1"] @ near["1"])
        planes = []
        for k in "23":
            n = unit(np.cross(place["r" + k], d[k]))
            planes.append(np.array([*n, -n @ near[k]]) / np.sqrt(1 + (n @ near[k]) ** 2))
        line = np.cross(unit(place["r1"]), d["1"])
        second = line @ np.cross(planes[0][:3], planes[1][:3]) / np.linalg.norm(line)
        return first, second

    return at


def test_beside_a_loop(ratio: Callable[..., Any]) -> None:
    """Delta at 1,000 poses."""
    value: Any = gc.compiled("delta")
    one = arms_of_delta(value.mechanism.robot)
    poses = POSES[:1000]

    def agree(mine: Any, other: Any) -> bool:
        return bool(np.abs(np.abs(mine[: len(other)]) - np.abs(other)).max() <= AGREE)

    def by_pose() -> Any:
        at: Any = gc.pose
        found = [at(value.mechanism.analysis, dict(zip("xyz", map(float, p), strict=True))) for p in poses[:10]]
        return np.array([[f.value for f in q.factors if f.live] for q in found])

    ratio(
        lambda: value(poses),
        {"one by one": lambda: np.array([one(p) for p in poses])},
        agree=agree,
        at_least={"one by one": 20},
        rounds=3,
    )
    assert agree(value(poses), by_pose())


@pytest.mark.parametrize("name", ["delta", "3-rps"])
def test_margins(ratio: Callable[..., Any], name: str) -> None:
    """By programs; beside the loops closed by stacked Newton steps, which know nothing of closed forms."""
    value: Any = gc.compiled(name)
    poses = POSES[:256]
    ratio(
        lambda: value.margins(poses),
        {"loops closed": lambda: value.numbers(poses, "margins")["margins"]},
        agree=lambda a, b: bool(np.allclose(a, b, atol=AGREE)),
        at_least={"loops closed": 10},
        rounds=3,
        others_rounds=1,
    )
