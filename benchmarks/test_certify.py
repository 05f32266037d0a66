"""Whole ranges: the certificate of the Reachy Mini's head within its motors, and the workspace of a planar robot;
each in a process of its own, with the memory that it takes.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

MOTORS = "actuators -83.898..44.102 deg, q2 -105.898..44.102 deg, q5 -105.898..44.102 deg"
HEAD = ["roll -40:40 deg", "pitch -40:40 deg", "yaw -65:65 deg"]
PLANAR = ["x -1.5:1.5", "y -1.5:1.5", "yaw -180:180 deg"]
MEGABYTES = 1024
WORKER = """
import json, resource, sys, time
import gcrules as gc
question, robot, over, options = json.load(sys.stdin)
start = time.perf_counter()
found = getattr(gc, question)(robot, over, **options)
seconds = time.perf_counter() - start
megabytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
counts = getattr(found, "summary", found)
print(json.dumps([seconds, megabytes, str(found).splitlines()[0], counts.shares[-1], counts.boxes]))
"""


@pytest.mark.parametrize(
    ("question", "robot", "over", "options", "answer", "undecided", "within"),
    [
        pytest.param(
            "certify",
            "reachy-mini-head",
            HEAD,
            {"limits": MOTORS, "cone": "40 deg", "boxes": 100_000},
            "No singular pose in range",
            0,
            600,
            id="head",
        ),
        pytest.param(
            "box_map",
            "3-rpr",
            PLANAR,
            {"limits": "actuators -0.9..0.9", "boxes": 1023},
            "This range is not free",
            0.01,
            5,
            id="planar workspace",
        ),
    ],
)
def test_whole_range(
    benchmark: Any,
    timed: Callable[..., Any],
    question: str,
    robot: str,
    over: list[str],
    options: dict[str, Any],
    answer: str,
    undecided: float,
    within: float,
) -> None:
    def run() -> list[Any]:
        asked = json.dumps([question, robot, over, options])
        done = subprocess.run([sys.executable, "-c", WORKER], input=asked, capture_output=True, text=True, check=True)
        found: list[Any] = json.loads(done.stdout)
        return found

    seconds, megabytes, sentence, left, boxes = benchmark.pedantic(run, rounds=1)
    assert sentence.startswith(answer)
    assert left <= undecided
    assert megabytes < MEGABYTES
    benchmark.extra_info.update(megabytes=megabytes, undecided=left, boxes=boxes)
    timed(seconds, {}, within=within)
