"""Maps: files read back, runs resume, faults are told."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner
from commands import assert_refused
from poses.small_maps import HUNT
from poses.tile_tasks import contents

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import GcrulesError, InputError, LimitReached
from gcrules.core.files import check_room
from gcrules.poses.maps import report, values
from gcrules.poses.maps.cells import FREE
from gcrules.poses.maps.maps import singular_map
from gcrules.poses.tiles.store import TileStore
from gcrules.views.plots import map_files as outputs
from gcrules.views.plots.map_formats import MapFormat

# --- files ----------------------------------------------------------------------------------------------------------

SMALL = ["x -300:300:15", "z -500:100:16"]


def test_data_are_read_back(robots: dict[str, Analysis], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    xarray = pytest.importorskip("xarray")
    monkeypatch.setattr(values, "_POSES", 40)
    m = singular_map(robots["octahedral"], SMALL, limits="leg lengths 100..500")
    assert m.task.number > 3
    path = tmp_path / "map.nc"
    m.save(str(path))
    with xarray.open_dataset(path, engine="h5netcdf", decode_timedelta=False) as found:
        assert found.identical(m.to_xarray())
        assert found.x.units == "mm"
        assert found.superbracket.units == "mm9"
        assert found.margin.dims == ("x", "z")
        assert found.leg_length.sel(leg="af").shape == (15, 16)
        assert found.cell_status.attrs["flag_meanings"] == "free crossed undecided outside"
        assert found.attrs["Conventions"].startswith("CF")
        assert set(found.data_vars) >= set(m.arrays)
        assert float(found.margin.sel(x=0, z=-20, method="nearest")) == m.values("margin")[7, 12]
        assert len(found.curve_x) == sum(len(c.points) for c in m.curves)
    turned = singular_map(robots["octahedral"], ["rx -9:9:3 deg", "ry -9:9:4 deg", "z 0:1:2"]).to_xarray()
    assert turned.rx.units == "degree"


@pytest.mark.parametrize(
    ("over", "options"),
    [
        (SMALL, {"limits": "leg lengths 100..500"}),
        (SMALL, {"measure": "value"}),
        (["rx -60:60:9 deg", "rz -100:100:9 deg"], {}),
        (["x -3:3:5", "y -3:3:4"], {"at": "0 0 -350"}),
        (["x -300:300:7", "y -300:300:7", "z -500:100:7"], {"limits": "leg lengths 100..500"}),
    ],
    ids=str,
)
def test_pictures(
    robots: dict[str, Analysis], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, over: list[str], options: Any
) -> None:
    map_surface = pytest.importorskip("gcrules.views.plots.map_surface")
    pytest.importorskip("skimage")
    monkeypatch.setattr(map_surface, "_PIXELS", 150)
    names = [str(tmp_path / f"map.{kind}") for kind in ("svg", "png")]
    m = singular_map(robots["octahedral"], over, **options)
    m.save(*names)
    ElementTree.parse(names[0])
    assert Path(names[1]).read_bytes().startswith(b"\x89PNG")
    again = str(tmp_path / "again.svg")
    m.save(again)
    assert Path(again).read_bytes() == Path(names[0]).read_bytes()
    assert {p.name for p in tmp_path.iterdir()} == {"map.svg", "map.png", "again.svg"}


def test_the_json_object(robots: dict[str, Analysis]) -> None:
    m = singular_map(robots["octahedral"], SMALL, limits="ab 100..500")
    found = json.loads(json.dumps(m.to_json(), allow_nan=False))
    assert found["factors"][0] == {
        "degree": 1,
        "multiplicity": 1,
        "polynomial": "z + 350",
        "zero_set": "line",
        "normal": ["0", "1"],
    }
    assert found["axes"][1] == {"name": "z", "unit": "mm", "start": -500, "stop": 100, "number": 16}
    assert found["summary"]["cells"]["free"] == int((m.values("cell_status") == FREE).sum())
    assert len(found["curves"]) == len(m.curves)
    assert "σ" in m.text(unicode=True)
    assert m.text().isascii()
    assert m._repr_html_().startswith("<pre>")
    pytest.importorskip("matplotlib")
    ElementTree.fromstring(m._repr_svg_() or "")


# --- long runs ------------------------------------------------------------------------------------------------------


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The chunks that are computed; they are small."""
    monkeypatch.setattr(values, "_POSES", 40)
    found: list[int] = []
    compute = values.LegsTask.compute

    def count(self: values.LegsTask, chunk: int) -> Any:
        if -1 in found and len(found) > 3:
            found.remove(-1)
            raise KeyboardInterrupt
        found.append(chunk)
        return compute(self, chunk)

    monkeypatch.setattr(values.LegsTask, "compute", count)
    return found


def test_an_interrupted_run_goes_on(robots: dict[str, Analysis], tmp_path: Path, counted: list[int]) -> None:
    work = tmp_path / "map.zarr"
    counted.append(-1)
    with pytest.raises(KeyboardInterrupt):
        singular_map(robots["octahedral"], SMALL, work=work)
    assert TileStore.existing(work).done() == {0, 1, 2}
    counted.clear()
    m = singular_map(robots["octahedral"], SMALL, work=work)
    assert counted.pop() in (0, 1, 2)  # one of those that were kept, looked at again
    assert counted == [*range(3, m.task.number)]
    direct = singular_map(robots["octahedral"], SMALL)
    for name in m.arrays:
        assert np.array_equal(m.values(name), direct.values(name))
    assert m.summary == direct.summary
    m.store.remove()
    assert not list(tmp_path.iterdir())


def test_a_chunk_without_cells(robots: dict[str, Analysis], tmp_path: Path, counted: list[int]) -> None:
    """The last chunk may hold poses, and no cells: they lie between it and the one before."""
    m = singular_map(robots["octahedral"], SMALL, work=tmp_path / "map.zarr")
    last = m.task.compute(m.task.number - 1)
    assert any(a.size == 0 for a in last.values())
    assert gc.verify_map(tmp_path / "map.zarr", "all").sound
    m.save(str(tmp_path / "map.zarr"))
    direct = singular_map(robots["octahedral"], SMALL)
    direct.save(str(tmp_path / "other.zarr"))
    assert contents(tmp_path / "other.zarr").keys() == contents(tmp_path / "map.zarr").keys()


@pytest.mark.parametrize(
    "change", [{"at": "1 0 0"}, {"measure": "value"}, {"limits": "legs 1.."}, {"about": "origin"}], ids=str
)
def test_a_changed_map_is_noticed(robots: dict[str, Analysis], tmp_path: Path, counted: list[int], change: Any) -> None:
    work = tmp_path / "map.zarr"
    singular_map(robots["octahedral"], SMALL, work=work)
    with pytest.raises(InputError, match="of another map") as fault:
        singular_map(robots["octahedral"], SMALL, work=work, **change)
    assert "--restart" in fault.value.render()
    singular_map(robots["octahedral"], SMALL, work=work, restart=True, **change).store.remove()
    assert not work.exists()


def test_workers_and_parts_of_a_map(robots: dict[str, Analysis], tmp_path: Path) -> None:
    over = ["x -300:300:401", "z -500:100:400"]
    whole = singular_map(robots["octahedral"], over, work=tmp_path / "whole.zarr", workers=2)
    assert whole.task.number > 3
    for k in (1, 2):
        status = singular_map(robots["octahedral"], over, work=tmp_path / "parts.zarr", part=(k, 2))
    assert status.complete
    assert contents(tmp_path / "parts.zarr") == contents(tmp_path / "whole.zarr")
    again = singular_map(robots["octahedral"], over, work=tmp_path / "parts.zarr")
    assert again.summary == whole.summary
    for options in ({"part": "1/2"}, {"workers": 2}, {"work": tmp_path / "a.zarr", "part": "1/2", "restart": True}):
        with pytest.raises(InputError, match=r"store|start over"):
            singular_map(robots["octahedral"], over, **options)


@pytest.mark.parametrize("source", ["3-rpr", "octahedral"])
def test_a_map_is_made_anew_from_its_store(tmp_path: Path, source: str) -> None:
    over = ["x -0.1:0.1:5", "yaw 10:60:5 deg"] if source == "3-rpr" else ["x -0.1:0.1:5", "rz 10:60:5 deg"]
    singular_map(source, over, work=tmp_path / "map.zarr")
    found = gc.verify_map(tmp_path / "map.zarr", "all")
    assert found.sound
    assert found.again == (0,)


def test_other_files_are_left_alone(robots: dict[str, Analysis], tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(InputError, match="holds other files"):
        singular_map(robots["octahedral"], SMALL, work=tmp_path, restart=True)
    with pytest.raises(InputError, match="a file is in the way"):
        singular_map(robots["octahedral"], SMALL, work=tmp_path / "thesis.tex")
    assert [p.name for p in tmp_path.iterdir()] == ["thesis.tex"]


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, ["map", *arguments], input=text)


OVER = ("--over", SMALL[0], "--over", SMALL[1])
SOLID = ("--over", "x 0:9:5", "--over", "y 0:9:5", "--over", "z -400:-300:6")


def test_an_interrupted_command(robot: str, tmp_path: Path, counted: list[int]) -> None:
    pytest.importorskip("h5netcdf")
    out = tmp_path / "map.nc"
    counted.append(-1)
    done = run(robot, *OVER, "-o", str(out))
    assert done.exit_code == 130
    assert "map.nc.part: run the same command again" in done.stderr
    assert {p.name for p in tmp_path.iterdir()} == {"map.nc.part", "map.nc.part.tiles"}
    done = run(robot, *OVER, "-o", str(out), "--limits", "legs 1..")
    assert done.exit_code == 2
    assert "--restart" in done.stderr
    counted.clear()
    assert run(robot, *OVER, "-o", str(out)).exit_code == 0
    assert counted[0] == 3
    assert [p.name for p in tmp_path.iterdir()] == ["map.nc"]


def full(*_: Any, **__: Any) -> Any:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize("where", ["chunk", "file", "replace"])
def test_a_full_disk(
    robot: str, tmp_path: Path, counted: list[int], monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    pytest.importorskip("h5netcdf")
    if where == "chunk":
        monkeypatch.setattr("gcrules.poses.tiles.store.written_shard", full)
    elif where == "file":
        broken = {**outputs.MAP_FORMATS, ".nc": MapFormat(full)}
        monkeypatch.setattr(outputs, "MAP_FORMATS", broken)
    else:
        full_at = "gcrules.core.files.os.replace"
        monkeypatch.setattr(full_at, lambda a, b: full() if str(b).endswith(".nc") else os.rename(a, b))
    done = run(robot, *OVER, "-o", str(tmp_path / "map.nc"))
    assert done.exit_code == 2
    assert "No space left on device" in done.stderr
    assert "free some space" in done.stderr
    assert {p.name for p in tmp_path.iterdir()} <= {"map.nc.part", "map.nc.part.tiles"}
    assert not list(tmp_path.rglob(".new-*"))
    monkeypatch.undo()
    monkeypatch.setattr(values, "_POSES", 40)
    assert run(robot, *OVER, "-o", str(tmp_path / "map.nc")).exit_code == 0
    assert {p.name for p in tmp_path.iterdir()} == {"map.nc"}


def test_room_is_looked_for_first(tmp_path: Path) -> None:
    class Left:
        free = 1000

    with pytest.raises(InputError, match="are needed"):
        check_room(str(tmp_path / "map.nc"), 10**9, "take less", free=lambda _: Left)


LARGE = """
import sys
from click.testing import CliRunner
from gcrules.apps.cli import cli
done = CliRunner().invoke(cli, ["map", *sys.argv[1:]])
status = open("/proc/self/status").read()  # unlike getrusage, it knows nothing of the process that started this one
print(done.exit_code, status.split("VmHWM:")[1].split()[0])
"""


def test_memory_stays_small(root: Path, tmp_path: Path) -> None:
    """Two million poses, in seventeen chunks."""
    if not Path("/proc/self/status").exists():
        pytest.skip("needs /proc")
    pytest.importorskip("h5netcdf")
    out = tmp_path / "map.nc"
    over = ("--over", "x -2:2:200", "--over", "y -2:2:200", "--over", "z -0.2:0.3:50")
    words = [sys.executable, "-c", LARGE, str(root / "examples" / "platform-6-6.yaml"), *over, "--measure", "value"]
    done = subprocess.run([*words, "-o", str(out)], capture_output=True, text=True, check=True)
    code, most = map(int, done.stdout.split())
    assert code == 0
    assert out.stat().st_size > 16_000_000
    assert most < 600_000  # kilobytes, most of them libraries


# --- the command ----------------------------------------------------------------------------------------------------


def test_the_command(robot: str, tmp_path: Path) -> None:
    done = run(robot, *OVER, "--ascii")
    assert done.exit_code == 0, done.output
    assert done.stdout.isascii()
    assert "1. z + 350: a line with the normal (0, 1)" in done.stdout
    with open(robot, encoding="utf-8") as file:
        assert run("-", *OVER, "--ascii", text=file.read()).stdout == done.stdout
    answer = json.loads(run(robot, *OVER, "--json", "-o", str(tmp_path / "map.json")).stdout)
    assert answer == json.loads((tmp_path / "map.json").read_text())


@pytest.mark.parametrize(
    ("arguments", "code", "says"),
    [
        ((), 2, "two or three coordinates"),
        (OVER[:2], 2, "found 1"),
        ((*OVER, "--over", SMALL[0]), 2, "given twice"),
        ((*OVER, "-o", "map.xyz"), 2, "outputs end in .nc"),
        ((*OVER, "-o", "map"), 2, "outputs end in .nc"),
        ((*OVER, "-o", "map.ply"), 2, "three coordinates"),
        ((*OVER, "-o", "no/such/dir/map.json"), 2, "no such directory"),
        ((*OVER, "-o", "map.json", "-o", "map.json"), 2, "are one file"),
        ((*OVER, "--restart"), 2, "--restart without -o"),
        ((*OVER, "--at", "0 0 1 m"), 2, "mixed units"),
        ((*OVER, "--at", "0 0 nan"), 2, "--at:1:1"),
        ((*OVER, "--about", "middle"), 2, "not a centre"),
        ((*OVER, "--limits", "legs 3..1"), 2, "--limits:1"),
        ((*OVER, "--threshold", "2 mm"), 2, "the threshold is an angle"),
        ((*OVER, "--measure", "beauty"), 2, "not one of"),
        (("--over", "x 0:1:2", "--over", "y 0:0:2"), 2, "--over:1:1"),
        (("--over", "x 0:1e30:2", "--over", "y 0:1:2"), 2, "times the robot's size away"),
        (("--over", "x 0:1:90000", "--over", "y 0:1:90000"), 3, "coarser grid"),
    ],
    ids=str,
)
def test_the_command_tells_faults(robot: str, arguments: tuple[str, ...], code: int, says: str) -> None:
    assert_refused(run(robot, *arguments), code, says)


@pytest.mark.parametrize(
    ("module", "suffix", "over"),
    [
        ("skimage", ".ply", SOLID),
        ("trimesh", ".glb", SOLID),
        ("skimage", ".png", SOLID),
        ("matplotlib", ".svg", OVER),
        ("h5netcdf", ".nc", OVER),
    ],
    ids=str,
)
def test_missing_libraries(
    robot: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, module: str, suffix: str, over: tuple[str, ...]
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    done = run(robot, *over, "-o", str(tmp_path / f"map{suffix}"))
    assert done.exit_code == 2
    assert 'pip install "gcrules[maps]"' in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("limbs: []\n", "there are no limbs"),
        (
            HUNT.replace("[0.25, 0.4330127018922193, 1]", "[-0.5, 1, 1]").replace(
                "[0.25, -0.4330127018922193, 1]", "[-0.5, 2, 1]"
            ),
            "so the robot is singular in every pose",
        ),
    ],
    ids=["limbs", "on one line"],
)
def test_robots_that_are_refused(text: str, says: str) -> None:
    done = run("-", *OVER, text=text)
    assert done.exit_code == 2
    assert says in done.stderr


def test_python_tells_faults(robots: dict[str, Analysis], monkeypatch: pytest.MonkeyPatch) -> None:
    a = robots["octahedral"]
    for options, says in (
        ({"measure": "beauty"}, "not a measure"),
        ({"threshold": 2}, "has no unit"),
        ({"at": [[0, 0, 0], [1, 1, 1]]}, "around one pose"),
        ({"about": (1, 2)}, "the centre has 3 numbers, found 2"),
    ):
        with pytest.raises(InputError, match=says):
            gc.singular_map(a, SMALL, **options)
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        gc.singular_map(gc.analyze("ab af cb cd ed ef"), SMALL)
    m = gc.singular_map(a, SMALL)
    with pytest.raises(InputError, match="has no 'beauty'"):
        m.values("beauty")
    with pytest.raises(GcrulesError, match="no surface"):
        _ = m.mesh
    monkeypatch.setattr(report, "MAX_IN_MEMORY", 10)
    with pytest.raises(LimitReached, match="too large to be in memory"):
        m.values("margin")
