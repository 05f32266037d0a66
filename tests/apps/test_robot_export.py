"""gcrules robot export: which files are written, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from commands import assert_refused, invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.mechanisms.models.reading import read_model


def test_a_model_is_printed() -> None:
    done = invoke("robot", "export", "3-rps")
    assert done.exit_code == 0
    assert done.stdout == gc.export_model("3-rps")
    assert invoke("robot", "export", "3-rps", "-o", "-").stdout == done.stdout


@pytest.mark.parametrize("words", [("-o", "{}/r.xml"), ("-o", "{}/r.txt", "--format", "mjcf"), ("-o", "{}/r.mjcf")])
def test_mjcf_is_one_file(tmp_path: Path, words: tuple[str, ...]) -> None:
    done = invoke("robot", "export", "delta", *(word.format(tmp_path) for word in words))
    (file,) = tmp_path.iterdir()
    assert done.stdout == f"{file} is written\n"
    assert file.read_text() == gc.export_model("delta")


def test_urdf_is_two_files(tmp_path: Path) -> None:
    file, beside = tmp_path / "d.urdf", tmp_path / "d-closures.yaml"
    done = invoke("robot", "export", "delta", "-o", str(file))
    assert done.stdout == f"{file} and {beside} are written\n"
    assert sorted(tmp_path.iterdir()) == [beside, file]
    assert len([j for j in read_model(file, beside).joints if j.closing]) == 5


def test_units_and_modes(tmp_path: Path) -> None:
    assert invoke("robot", "export", "3-rps", "--unit", "mm").stdout == gc.export_model("3-rps", unit="mm")
    mode = invoke("robot", "export", "3-rpr", "--mode", "assembly 2")
    assert mode.exit_code == 0
    assert mode.stdout != gc.export_model("3-rpr")
    platform = str(EXAMPLES / "octahedral.yaml")
    assert invoke("robot", "export", platform).stdout.count('type="slide"') == 6


REFUSED = {
    "cables": (("8-cables",), "is a cable, which only pulls"),
    "legs": (("ab af cb cd ed ef",), "have no dimensions"),
    "no such robot": (("nobody.yaml",), "there is no such file"),
    "URDF without a name": (("3-rps", "--format", "urdf"), "takes two files"),
    "URDF on standard output": (("3-rps", "--format", "urdf", "-o", "-"), "takes two files"),
    "a name for another": (("3-rps", "--format", "urdf", "-o", "r.xml"), "r.xml is a name for mjcf"),
    "an ending": (("3-rps", "-o", ".xml"), "this is an ending without a name"),
    "a folder that is not there": (("3-rps", "-o", "no/r.xml"), "there is no such directory"),
    "a unit": (("3-rps", "--unit", "furlong"), "is not one of"),
}


@pytest.mark.parametrize(("words", "says"), REFUSED.values(), ids=REFUSED)
def test_what_is_refused(words: tuple[str, ...], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert_refused(invoke("robot", "export", *words), 2, says)
    assert not list(tmp_path.iterdir())


def test_a_name_that_says_no_format(tmp_path: Path) -> None:
    done = invoke("robot", "export", "delta", "-o", str(tmp_path / "delta.sdf"))
    assert done.exit_code == 2
    assert "end in .xml, .mjcf, .urdf" in done.stderr
    assert not list(tmp_path.iterdir())
