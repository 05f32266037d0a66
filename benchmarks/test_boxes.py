"""Whole ranges of six coordinates, proved box by box, beside a grid of nodes that is looked at and proves nothing."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np

import gcrules as gc
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.deciding import Boxes
from gcrules.poses.boxes.task import box_task

PLATFORM = Path(__file__).resolve().parent.parent / "examples" / "octahedral.yaml"
OVER = ["x -150:150", "y -150:150", "z -100:100", "roll -15:15 deg", "pitch -15:15 deg", "yaw -15:15 deg"]
NODES = 7  # along each coordinate


def test_six_coordinates_proved(benchmark: Any) -> None:
    benchmark.group = f"a range of six coordinates: proved, or {NODES} nodes along each"
    task = box_task(mechanism(PLATFORM), OVER, tiles=1)
    task.check()
    found = benchmark(lambda: task.compute(0))
    assert found["share"].ravel()[0] == 1


def test_six_coordinates_at_nodes(benchmark: Any) -> None:
    benchmark.group = f"a range of six coordinates: proved, or {NODES} nodes along each"
    ends = [(float(a.start), float(a.stop)) for a in box_task(mechanism(PLATFORM), OVER, tiles=1).question.axes]
    nodes = np.array(list(itertools.product(*(np.linspace(low, high, NODES) for low, high in ends))))
    options: dict[str, Any] = {"euler": ("xyz", nodes[:, 3:]), "degrees": True, "nearest": False}
    found = benchmark(lambda: np.asarray(getattr(gc.pose(PLATFORM, nodes[:, :3], **options), "margin")))  # noqa: B009
    assert len(found) == NODES**6


def test_a_box(benchmark: Any) -> None:
    """One of a 6-RUS robot, in a block of 512."""
    benchmark.group = "512 boxes of a robot of joints, and 512 poses"
    task = box_task(
        mechanism("6-rus"), ["x -1:1", "y -1:1", "z -1:1", "roll -1:1 rad", "pitch -1:1 rad", "yaw -1:1 rad"]
    )
    rng = np.random.default_rng(0)
    boxes = Boxes(rng.uniform(-0.1, 0.1, (512, 6)), np.full((512, 6), 0.02))
    decider = task.decider
    assert benchmark(lambda: decider.decided(boxes)).free.any()


def test_a_pose(benchmark: Any) -> None:
    benchmark.group = "512 boxes of a robot of joints, and 512 poses"
    value: Any = gc.compiled("6-rus", engine="numpy")
    poses = np.random.default_rng(0).uniform(-0.1, 0.1, (512, 6))
    benchmark(lambda: value.margins(poses))
