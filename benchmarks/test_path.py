"""Paths of a platform on six legs beside the same path by the exact polynomial of each segment."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gcrules.mechanisms.load import load
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.path_report import path_of
from gcrules.poses.paths.polynomials import polynomials
from gcrules.poses.paths.segments import segments
from gcrules.poses.paths.table import read_poses
from gcrules.poses.paths.zeros import places, stretches

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
NUMBER = 2_000


def table(number: int, low: float) -> str:
    """A smooth path of so many poses, in millimetres and degrees."""
    t = np.linspace(0, 60 * number / 100_000, number)
    rows = [60 * np.sin(t), 60 * np.cos(1.3 * t) - 60, low * np.sin(5 * t)]
    rows += [10 * np.sin(0.9 * t), 8 * np.sin(1.1 * t), 15 * np.sin(0.8 * t)]
    lines = [",".join(f"{c:.6f}" for c in row) for row in np.stack(rows, axis=1).tolist()]
    return "\n".join(["x,y,z,zyx1 [deg],zyx2 [deg],zyx3 [deg]", *lines])


@pytest.mark.parametrize("low", [-50.0, -600.0], ids=["regular", "singular"])
def test_segments_of_a_path(ratio: Callable[..., Any], low: float) -> None:
    """The singular places of the octahedral platform along 2,000 poses, and the degrees of the polynomials."""
    found: Any = mechanism(load(EXAMPLES / "octahedral.yaml"))
    poses, _ = read_poses(table(NUMBER, low))

    def at_once() -> Any:
        listed, degrees = polynomials(segments(found.rig, poses))
        return places(listed), stretches(listed), degrees

    def one_by_one() -> Any:
        listed = [s.polynomial for s in segments(found.rig, poses)]
        return places(listed), stretches(listed), tuple(len(p) - 1 for p in listed)

    assert bool(at_once()[0]) == (low < -300)
    ratio(at_once, {"exact": one_by_one}, agree=lambda a, b: a == b, at_least={"exact": 10}, rounds=3, others_rounds=1)


def test_path_of_a_table(benchmark: Any, tmp_path: Path) -> None:
    """10,000 poses from a table, with values at all of them and the least margin."""
    file = tmp_path / "poses.csv"
    file.write_text(table(10_000, -50.0), encoding="utf-8")
    found = mechanism(load(EXAMPLES / "octahedral.yaml"))
    report = benchmark.pedantic(path_of, args=(found, file), rounds=3)
    assert report.verdict == "regular"
