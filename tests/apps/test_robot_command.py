"""Robots by name, by folder and by package, and the commands about them."""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner
from commands import invoke
from mechanisms.shipped_robots import GOOD
from places import EXAMPLES

from gcrules.apps.cli import cli
from gcrules.core.errors import FileError, InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.load import read_robot
from gcrules.rules.plugin import Plugin, shipped_folder

IDS = tuple(one.id for one in robots())


# --- discovery and commands ------------------------------------------------------------------------------------------


def run(*words: str) -> Any:
    return CliRunner().invoke(cli, ["robot", *words])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "robot.yaml").write_text(GOOD, "utf-8")
    return tmp_path


def test_robots_are_found_by_id_and_by_path(folder: Path) -> None:
    assert read_robot("mine", plugins=[folder]).id == "mine"
    assert read_robot(folder / "mine" / "robot.yaml").title == "three legs"
    with pytest.raises(InputError, match="there is no robot '3-rsp'") as caught:
        read_robot("3-rsp")
    assert "3-rps" in (caught.value.hint or "")


def test_a_clash_names_both_owners(folder: Path) -> None:
    (folder / "mine").rename(folder / "delta")
    with pytest.raises(InputError) as caught:
        read_robot("delta", plugins=[folder])
    assert "gcrules" in caught.value.message
    assert f"folder {folder}" in caught.value.message


def test_a_folder_that_is_known_is_no_clash() -> None:
    folder = shipped_folder()
    assert folder is not None
    assert read_robot("delta", plugins=[os.path.relpath(folder)]).owner == "gcrules"


def test_a_file_of_code_beside_a_robot_is_not_run(folder: Path) -> None:
    (folder / "mine" / "rules.py").write_text("raise SystemExit(7)", "utf-8")
    assert analyze_robot(read_robot("mine", plugins=[folder])).structure.mobility == 3


NAMED = {
    "a folder of folders": (".", "mine"),
    "a folder": ("mine", "mine"),
    "a file": ("mine/robot.yaml", "mine"),
    "a file with a name of its own": ("other.yaml", "other"),
}


@pytest.mark.parametrize("name", NAMED)
def test_robots_of_installed_packages(folder: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    path, robot_id = NAMED[name]
    (folder / "other.yaml").write_text(GOOD, "utf-8")
    brought = Plugin(robots=(folder / path,), owner="package others")
    monkeypatch.setattr("gcrules.mechanisms.description.discovery.installed", lambda: (brought,))
    assert read_robot(robot_id).owner == "package others"


@pytest.mark.parametrize(("path", "words"), [("none", "cannot be read as robots"), (".", "there are no robots here")])
def test_robots_that_are_not_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, path: str, words: str) -> None:
    brought = Plugin(robots=(tmp_path / path,), owner="package others")
    monkeypatch.setattr("gcrules.mechanisms.description.discovery.installed", lambda: (brought,))
    with pytest.raises(FileError, match=f"package others: {words}") as caught:
        read_robot("mine")
    assert caught.value.filename == str(tmp_path / path)


def test_commands(folder: Path) -> None:
    listed = run("list", "--plugins", str(folder))
    assert listed.exit_code == 0
    assert "3-rps" in listed.output
    assert f"(folder {folder})" in listed.output
    assert {r["id"] for r in json.loads(run("list", "--json").output)["robots"]} == set(IDS)
    shown = run("show", "3-rps")
    assert "S1: in plane A1 perpendicular to r1" in shown.output
    assert json.loads(run("analyze", "3-rps", "--json").output)["class"] == "6-3.2"
    assert run("analyze", "3-rps", "--latex").output.count("\\documentclass") == 1
    assert "mobility 3" in run("check", "mine", "--plugins", str(folder)).output
    assert run("analyze", "nothing").exit_code == 2


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["3-rps"], 0, "3-RPS robot (3-rps)"),
        (["mine/robot.yaml"], 0, "three legs"),
        (["mine", "--plugins", "."], 0, "three legs"),
        (["3-rps", "--json"], 0, '"class": "6-3.2"'),
        (["3rps"], 2, "did you mean 3-rps"),
        (["3-rps", "--recheck"], 2, "A robot of joints takes"),
        (["3-rps", "--rank", "3"], 2, "A robot of joints takes"),
        (["ab,af,cb,cd,ed,ef"], 0, "four planes abc, aef, bdf and cde"),
        (["abaf"], 2, "nor the id of a robot, a class or an example, nor legs"),
    ],
    ids=["id", "file", "of a folder", "JSON", "typing error", "option", "rank", "legs in one word", "no legs"],
)
def test_analyze_takes_robots(
    words: list[str], code: int, said: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    result = CliRunner().invoke(cli, ["analyze", *words])
    assert result.exit_code == code
    assert said in (result.stderr if code else result.stdout)


@pytest.mark.parametrize("words", [["analyze", "3-rps"], ["robot", "analyze", "3-rps"], ["analyze", "4-rpr"]])
def test_a_robot_is_drawn(words: list[str], tmp_path: Path) -> None:
    path = tmp_path / "robot.svg"
    assert CliRunner().invoke(cli, [*words, "--figure", str(path)]).exit_code == 0
    drawing = ElementTree.parse(path).getroot()
    assert "equivalent structure" in "".join(drawing.itertext())


def test_a_robot_without_a_home_is_not_drawn(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    result = CliRunner().invoke(cli, ["analyze", "mine/robot.yaml", "--figure", "robot.svg"])
    assert (result.exit_code, "no home configuration to be drawn in" in result.stderr) == (2, True)
    assert not Path("robot.svg").exists()


def test_a_refuted_condition_is_a_definite_no(folder: Path) -> None:
    path = folder / "mine" / "robot.yaml"
    path.write_text(f'{GOOD}condition: "[A1A2A3S1]"\n', "utf-8")
    found = run("check", str(path))
    assert found.exit_code == 1
    assert "refuted" in found.output
    for wrong in ("A1A2A3", "[A1A2A3Q9]", "[A1A2"):
        path.write_text(f'{GOOD}condition: "{wrong}"\n', "utf-8")
        assert run("check", str(path)).exit_code == 2


def test_a_new_robot_passes_its_check(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("new", "my-robot").exit_code == 0
    assert run("check", "my-robot/robot.yaml").exit_code == 0
    again = run("new", "my-robot")
    assert again.exit_code == 2
    assert "already" in again.output
    assert run("new", "../up").exit_code == 2


@pytest.mark.parametrize("taken", ["octahedral", "6-6", "gough-stewart"])
def test_a_new_robot_needs_an_id_of_its_own(taken: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    found = run("new", taken)
    assert (found.exit_code, f"{taken} is already the id of" in found.output) == (2, True)
    assert not list(tmp_path.iterdir())
    (shows,) = re.findall(r"`gcrules (.+)` shows what has it", found.output)
    assert invoke(*shows.split()).exit_code == 0


@pytest.mark.parametrize("command", ["check", "analyze", "show", "pose"])
def test_a_robot_file_comes_from_standard_input(command: str) -> None:
    text = (EXAMPLES / "tutorial" / "tripod.yaml").read_text(encoding="utf-8")
    done = CliRunner().invoke(cli, ["robot", command, "-"], input=text)
    assert done.exit_code == 0, done.stderr
    wrong = CliRunner().invoke(cli, ["robot", command, "-"], input=text.replace("S(S%)", "S(T%)"))
    assert wrong.exit_code == 2
    assert "<stdin>:11:33: T1 is not defined" in wrong.stderr
    legs = CliRunner().invoke(cli, ["robot", command, "-"], input="legs: [ab]\npoints: {a: [0, 0, 0], b: [1, 0, 0]}\n")
    assert legs.exit_code == 2
