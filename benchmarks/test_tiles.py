"""Maps in tiles beside a plain loop over the same tiles in one process: what it costs to keep them in a store."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from pathlib import Path
from typing import Any

import pytest

from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.maps.planned import planned
from gcrules.poses.maps.tiled import GridTiles
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.store import TileStore
from gcrules.screws.threshold import DEFAULT

pytest.importorskip("zarr")

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
OVER = ["rx -60:60:400 deg", "z -500:100:400"]


def tiles(measure: str) -> GridTiles:
    plan = planned(SixLegs(load_platform(EXAMPLES / "octahedral.yaml")), OVER, None, None, DEFAULT, measure)
    return GridTiles(plan.task, plan.sentence, plan.recipe)


@pytest.mark.parametrize("measure", ["margin", "value"])
@pytest.mark.parametrize("road", ["loop", "store"])
def test_tiles(benchmark: Any, tmp_path: Path, measure: str, road: str) -> None:
    benchmark.group = f"a map of 400 by 400 poses, {measure}"
    task = tiles(measure)
    task.compute(0)
    runs = iter(range(1000))

    def loop() -> None:
        for tile in range(task.task.number):
            task.compute(tile)

    def store() -> None:
        run(task, TileStore.open(tmp_path / f"map-{next(runs)}.zarr", task))

    benchmark.pedantic(loop if road == "loop" else store, rounds=3)
