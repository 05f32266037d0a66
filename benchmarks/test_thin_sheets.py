"""Ranges with two singular sheets so near each other that a grid steps over both: proved by boxes, and sampled with
NumPy for the same time.

A grid that is sure of the sheets has nodes nearer to each other than they are, along each coordinate as long as nobody
knows how they lie: what that takes, at the rate of this run, is what the table compares with. What a grid saw in equal
time is in `extra_info`: its nodes along each coordinate, the signs of the determinant, the least margin, and whether it
missed the change of sign.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import gcrules as gc

PLATFORM: Any = gc.load(Path(__file__).resolve().parent.parent / "examples" / "two-tripods.yaml")
CENTRE = PLATFORM.points["A"]
OVER = {"x": 100.0, "y": 100.0, "z": 500.0, "roll": 20.0, "yaw": 20.0}
"""How far each coordinate goes both ways, in millimetres and degrees; of angles a grid has nodes one degree apart."""
ANGLES = ("roll", "yaw")
CHUNK = 20_000
BOXES = 20_000

Floats = NDArray[np.float64]


def apart(gap: Fraction) -> Any:
    """The platform with its sheets so many millimetres apart."""
    moved = {name: (*PLATFORM.points[name][:2], gap) for name in "de"}
    return replace(PLATFORM, points={**PLATFORM.points, **moved})


def nodes(number: int, names: tuple[str, ...], start: int, stop: int) -> Floats:
    """Poses (N, 5) of a grid with so many nodes along each coordinate, those of a stretch; angles in rad."""
    places = np.stack(np.unravel_index(np.arange(start, stop), (number,) * len(names)), axis=1)
    found = np.zeros((stop - start, len(OVER)))
    for k, name in enumerate(names):
        far = math.radians(OVER[name]) if name in ANGLES else OVER[name]
        found[:, list(OVER).index(name)] = np.linspace(-far, far, number)[places[:, k]]
    return found


def rows(platform: Any, poses: Floats) -> Floats:
    """The legs as lines (N, 6, 6), in coordinates of twists in which the margin is the least singular value."""
    base, ends = (np.array([[float(c) for c in platform.points[leg[k]]] for leg in platform.legs]) for k in (0, 1))
    centre = np.array([float(c) for c in CENTRE])
    (c, s), (cy, sy) = ((np.cos(a), np.sin(a)) for a in poses[:, 3:].T)
    turn = np.stack([cy, -sy * c, sy * s, sy, cy * c, -cy * s, 0 * c, s, c], axis=1).reshape(-1, 3, 3)
    placed = (ends - centre) @ np.swapaxes(turn, 1, 2) + centre + poses[:, None, :3]
    along = placed - base
    along /= np.linalg.norm(along, axis=2, keepdims=True)
    arms = placed - placed.mean(axis=1, keepdims=True)
    inertia = (arms**2).sum(axis=(1, 2))[:, None, None] * np.eye(3) - np.swapaxes(arms, 1, 2) @ arms
    values, vectors = np.linalg.eigh(inertia)
    scale = (vectors / np.sqrt(values)[:, None]) @ np.swapaxes(vectors, 1, 2)
    return np.concatenate([along / math.sqrt(6), np.cross(arms, along) @ scale], axis=2)


def sampled(platform: Any, names: tuple[str, ...], seconds: float, margins: bool) -> dict[str, Any]:
    """What the finest grid sees that takes no more than these seconds: signs of determinants, or margins."""

    def look(poses: Floats) -> tuple[set[float], float]:
        lines = rows(platform, poses)
        if margins:
            return set(), float(np.linalg.svd(lines, compute_uv=False)[:, -1].min())
        return set(np.sign(np.linalg.det(lines)).tolist()), math.inf

    some = nodes(8, names, 0, 8 ** len(names))[:CHUNK]
    look(some[:10])
    start = perf_counter()
    look(some)
    rate = len(some) / (perf_counter() - start)
    number = max(2, math.floor((rate * seconds) ** (1 / len(names))))
    signs: set[float] = set()
    least, total = math.inf, number ** len(names)
    start = perf_counter()
    for at in range(0, total, CHUNK):
        here, margin = look(nodes(number, names, at, min(at + CHUNK, total)))
        signs, least = signs | here, min(least, margin)
    rate = total / (perf_counter() - start)
    return {"nodes": number, "signs": sorted(signs), "least margin": least, "rate": rate}


@pytest.mark.parametrize("gap", [Fraction(100, 10**k) for k in range(5)], ids=lambda gap: f"{float(gap):g} mm apart")
@pytest.mark.parametrize("names", [("x", "y", "z"), tuple(OVER)], ids=["3 coordinates", "5 coordinates"])
def test_thin_sheets(benchmark: Any, timed: Callable[..., Any], names: tuple[str, ...], gap: Fraction) -> None:
    platform = apart(gap)
    over = [f"{n} -{OVER[n]:g}:{OVER[n]:g}{' deg' if n in ('roll', 'yaw') else ''}" for n in names]
    about = ",".join(str(float(c)) for c in CENTRE)

    def certified() -> Any:
        return gc.certify(platform, over, about=about, boxes=BOXES)

    certified()
    start = perf_counter()
    found = benchmark.pedantic(certified, rounds=1)
    seconds = perf_counter() - start
    assert found.verdict in ("singular", "undecided")
    signs, margins = (sampled(platform, names, seconds, margins=kind) for kind in (False, True))
    sure = math.prod(2 * OVER[n] / (1 if n in ANGLES else float(gap)) for n in names) / signs["rate"]
    benchmark.extra_info.update(
        verdict=found.verdict,
        boxes=found.boxes,
        undecided=found.shares[4],
        grid={k: v for k, v in signs.items() if k != "least margin"},
        margins={k: v for k, v in margins.items() if k != "signs"},
        missed=len(signs["signs"]) < 2,
        ratio=sure / seconds,
    )
    saw = "both signs" if len(signs["signs"]) > 1 else "one sign"
    label = f"a grid that is sure; in equal time {signs['nodes']} nodes along each saw {saw}, least margin "
    label += f"{margins['least margin']:.1g}; boxes: {found.verdict}"
    timed(seconds, {label: sure})
