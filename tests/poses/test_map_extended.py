"""Maps over nodes that are extended: the bytes of a run of its own, and what is not computed again."""

from __future__ import annotations

from pathlib import Path

import pytest
from commands import invoke
from places import EXAMPLES
from poses.tile_tasks import contents

import gcrules as gc
from gcrules.poses.maps.values import LegsTask

pytest.importorskip("zarr")

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
Z = "z -100:100:201 mm"


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A map of two tiles, of 149 layers and of the 52 that are left."""
    path = tmp_path_factory.mktemp("map") / "old.zarr"
    gc.singular_map(OCTAHEDRAL, ["x -100:100:201", Z], work=path)
    return path


@pytest.mark.parametrize(
    ("wider", "number", "fresh"),
    [("x -100:250", 351, 2), ("x -249:100", 350, 1), ("x -249:51", 301, 2), ("x -100:49", 150, 2)],
    ids=["after", "before", "shifted", "less"],
)
def test_the_bytes_are_those_of_a_run_of_its_own(
    store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, wider: str, number: int, fresh: int
) -> None:
    gc.singular_map(OCTAHEDRAL, [f"{wider}:{number} mm", Z], work=tmp_path / "direct.zarr")
    computed: list[int] = []
    compute = LegsTask.compute
    monkeypatch.setattr(LegsTask, "compute", lambda task, tile: (computed.append(tile), compute(task, tile))[1])
    found = gc.refine_map(store, tmp_path / "wide.zarr", over=[wider])
    assert found.grid.shape == (number, 201)
    assert contents(tmp_path / "wide.zarr") == contents(tmp_path / "direct.zarr")
    assert len(set(computed)) <= fresh + 1  # one that is there is computed again, as a check


@pytest.mark.parametrize(
    ("over", "words"),
    [
        (["z -100:200"], "along x: only it"),
        (["x -99:100"], "not of whole tiles"),
        (["x -100:100.5"], "not of whole tiles"),
        (["x -100:200", "z -100:200"], "extended along its first coordinate"),
        (None, "extended along its first coordinate"),
    ],
)
def test_what_is_no_extension(store: Path, tmp_path: Path, over: list[str] | None, words: str) -> None:
    with pytest.raises(gc.InputError, match=words):
        gc.refine_map(store, tmp_path / "no.zarr", over=over)
    assert not (tmp_path / "no.zarr").exists()


def test_robots_that_are_led_from_home_are_not_extended(tmp_path: Path) -> None:
    gc.singular_map("3-rpr", ["x -0.1:0.1:3", "y -0.1:0.1:3"], work=tmp_path / "robot.zarr")
    with pytest.raises(gc.InputError, match="led from home"):
        gc.refine_map(tmp_path / "robot.zarr", tmp_path / "no.zarr", over=["x -0.1:0.3"])


def test_the_command(store: Path, tmp_path: Path) -> None:
    done = invoke("map", "refine", str(store), "-o", str(tmp_path / "wide.zarr"), "--over", "x -100:110")
    assert done.exit_code == 0, done.output
    assert "x from -100 to 110" in done.stdout
