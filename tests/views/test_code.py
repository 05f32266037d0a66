"""Exported code, compiled and run: beside the numbers in its own test, and beside gcrules at many poses."""

from __future__ import annotations

import ctypes
import math
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from commands import assert_refused
from places import ROOT

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError
from gcrules.poses.compiling.compiled_limbs import CompiledLimbs
from gcrules.poses.compiling.controller import Controller, controller
from gcrules.poses.numbers.arrays import from_poses
from gcrules.screws.margin import jacobian
from gcrules.views.code.languages import LANGUAGES
from gcrules.views.code.source_code import source_code

PLATFORM = str(ROOT / "examples" / "octahedral.yaml")
ROBOTS = ("3-prs", "3-rrr", "3-rrr-spherical", "4-ruu", "6-rus", "delta", "orthoglide")
FEW = (PLATFORM, "3-rps", "delta", "3-rpr")

COMPILERS = {
    "c": ("gcc", "-std=c99 -O1 -Wall -Wextra -Wpedantic -Werror -DGCRULES_TEST robot.c -lm -o robot"),
    "cpp": ("g++", "-std=c++17 -O1 -Wall -Wextra -Wpedantic -Werror -DGCRULES_TEST robot.cpp -o robot"),
    "rust": ("rustc", "--edition 2021 -D warnings --test robot.rs -o robot"),
}


@cache
def model(source: str) -> Controller:
    return controller(source)


def compiler(language: str) -> list[str]:
    name, options = COMPILERS[language]
    if not shutil.which(name):
        pytest.skip(f"{name} is not installed")
    return [name, *options.split()]


def ran(command: list[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


# --- its own test --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("source", FEW)
def test_its_own_test_passes(source: str, language: str, tmp_path: Path) -> None:
    name = f"robot{LANGUAGES[language].suffix}"
    (tmp_path / name).write_text(source_code(model(source), language), encoding="utf-8")
    if language == "python":
        assert "poses, largest difference" in ran([sys.executable, "-W", "error", name], tmp_path)
    else:
        ran(compiler(language), tmp_path)
        assert ran(["./robot"], tmp_path)


@pytest.mark.parametrize("language", LANGUAGES)
def test_its_own_test_notices_a_wrong_number(language: str, tmp_path: Path) -> None:
    good = model("3-rpr")
    first, *others = good.tests
    wrong = replace(good, tests=(replace(first, margin=first.margin + 1e-6), *others))
    name = f"robot{LANGUAGES[language].suffix}"
    (tmp_path / name).write_text(source_code(wrong, language), encoding="utf-8")
    command = [sys.executable, name]
    if language != "python":
        ran(compiler(language), tmp_path)
        command = ["./robot"]
    assert subprocess.run(command, cwd=tmp_path, capture_output=True, check=False).returncode != 0


# --- beside gcrules ------------------------------------------------------------------------------------------------


def functions(robot: Controller, language: str, folder: Path) -> Any:
    """actuators, factors and margin of a pose, by the code."""
    text = source_code(robot, language)
    if language == "python":
        space: dict[str, Any] = {"__name__": "robot"}
        exec(compile(text, "robot.py", "exec"), space)  # what is under test
        return space["actuators"], space["factors"], space["margin"]
    (folder / "robot.c").write_text(text, encoding="utf-8")
    if not shutil.which("gcc"):
        pytest.skip("gcc is not installed")
    ran(["gcc", "-std=c99", "-O1", "-shared", "-fPIC", "robot.c", "-lm", "-o", "robot.so"], folder)
    library = ctypes.CDLL(str(folder / "robot.so"))
    name = re.findall(r"^double (\w+)_margin\(.*;$", text, re.MULTILINE)[0]

    def array(what: str, number: int) -> Any:
        call = getattr(library, f"{name}_{what}")

        def values(pose: Any) -> list[float]:
            found = (ctypes.c_double * number)()
            call((ctypes.c_double * len(pose))(*pose), found)
            return list(found)

        return values

    margin = getattr(library, f"{name}_margin")
    margin.restype = ctypes.c_double
    return (
        array("actuators", len(robot.actuators)),
        array("factors", len(robot.factors)),
        lambda pose: margin((ctypes.c_double * len(pose))(*pose)),
    )


@pytest.mark.parametrize("source", ROBOTS)
def test_robots_of_joints(source: str, tmp_path: Path) -> None:
    """Two roads: the code in C, and the loops closed by Newton's method, at poses that are proved."""
    robot = model(source)
    value = gc.compiled(source, coordinates=robot.coordinates)
    assert isinstance(value, CompiledLimbs)
    rng, size = np.random.default_rng(3), value.mechanism.linkage.size
    units = np.where(robot.angles, 1.0, size)
    poses = rng.uniform(-0.08, 0.08, (12, len(units))) * units
    solved = value.numbers(poses, "factors, margins, actuators, proved")
    actuators, factors, margin = functions(robot, "c", tmp_path)
    seen = 0
    for pose, proved, *expected in zip(
        poses, solved["proved"], solved["actuators"], solved["factors"], solved["margins"], strict=True
    ):
        if proved:
            seen += 1
            assert actuators(pose) == pytest.approx(expected[0], abs=1e-9 * size)
            assert factors(pose) == pytest.approx(expected[1], abs=1e-9)
            assert margin(pose) == pytest.approx(expected[2], abs=1e-9)
    assert seen > 3


@pytest.mark.parametrize("language", ["c", "python"])
def test_platforms_on_six_legs(language: str, tmp_path: Path) -> None:
    """The margin is that of gc.pose; the factor vanishes and changes its sign where gc.path has its crossings."""
    robot = model(PLATFORM)
    actuators, factors, margin = functions(robot, language, tmp_path)
    at = {"x": 30.0, "y": -20.0, "z": 50.0, "roll": 0.3, "pitch": -0.2, "yaw": 0.4}
    expected: Any = gc.pose(PLATFORM, at, nearest=False)
    assert margin(list(at.values())) == pytest.approx(expected.margin, abs=1e-12)
    lengths = jacobian(expected.rig.base, expected.rig.ends(*from_poses([expected.pose]))).lengths[0]
    assert actuators(list(at.values())) == pytest.approx(lengths, rel=1e-12)
    path: Any = gc.path(PLATFORM, ["home", "z=-600, yaw=20deg"], samples=2)
    assert path.zeros
    for zero in path.zeros:
        sides = []
        for part in (zero.parameter - 1e-4, zero.parameter, zero.parameter + 1e-4):
            pose = [0, 0, -600 * part, 0, 0, math.radians(20) * part]
            sides.append(factors(pose)[0])
            assert margin(pose) < 1e-3
        assert sides[0] * sides[2] < 0
        assert abs(sides[1]) < 0.05 * abs(sides[0])


@pytest.mark.parametrize("language", ["c", "python"])
def test_where_it_does_not_assemble(language: str, tmp_path: Path) -> None:
    actuators, factors, margin = functions(model("delta"), language, tmp_path)
    for pose in ([0.0, 0.0, -99.0], [math.nan, 0.0, 0.0]):
        for number in (*actuators(pose), *factors(pose), margin(pose)):
            assert math.isnan(number)


@pytest.mark.parametrize("language", ["c", "python"])
def test_angles_of_any_size(language: str, tmp_path: Path) -> None:
    _, factors, margin = functions(model("3-rpr"), language, tmp_path)
    turned = [0.1, 0.2, 0.3 - 6 * math.pi]
    assert factors(turned) == pytest.approx(factors([0.1, 0.2, 0.3]), abs=1e-12)
    assert margin(turned) == pytest.approx(margin([0.1, 0.2, 0.3]), abs=1e-12)


# --- names and comments --------------------------------------------------------------------------------------------

HOSTILE = [
    "*/ int x = 1; /*",
    "ends in a backslash \\",
    "??/",
    "a\nb\r#error",
    '"""',
    "\u2028 return",
    "x" * 500,
    "日本語",
    "",
]


@pytest.mark.parametrize("language", LANGUAGES)
def test_titles_stay_in_comments(language: str, tmp_path: Path) -> None:
    name = f"robot{LANGUAGES[language].suffix}"
    for title in HOSTILE:
        robot = replace(model("3-rpr"), name=title, title=f"{title} {title}")
        text = source_code(robot, language)
        mark = LANGUAGES[language].comment.format(line="").strip()
        head = text.split("\n\n")[0].splitlines()
        assert all(line.startswith(mark) for line in head)
        (tmp_path / name).write_text(text, encoding="utf-8")
        if language == "python":
            ran([sys.executable, name], tmp_path)
    if language != "python":
        ran(compiler(language), tmp_path)


def test_files_say_what_they_are() -> None:
    text = gc.export("3-rps", "c")
    head = " ".join(line.removeprefix("//").strip() for line in text.splitlines() if line.startswith("//"))
    for words in (
        "3-rps: when is it singular?",
        "A pose is z (in the unit of the file) and roll, pitch (in rad), in this order",
        "meet in a point (possibly at infinity)",
        "a check by sampling, no proof",
        "The platform's other coordinates",
    ):
        assert words in head
    assert "(in mm)" in gc.export(PLATFORM, "rust")


# --- the command ---------------------------------------------------------------------------------------------------


def test_the_language_of_a_name(tmp_path: Path) -> None:
    for name, mark in {
        "a.rs": "pub fn margin",
        "a.py": "def margin",
        "a.cpp": "namespace robot_3_rpr",
        "a": "void ",
    }.items():
        done = CliRunner().invoke(cli, ["export", "3-rpr", "-o", str(tmp_path / name)])
        assert (done.exit_code, done.stdout) == (0, "")
        assert mark in (tmp_path / name).read_text(encoding="utf-8")
    assert CliRunner().invoke(cli, ["export", "3-rpr", "--language", "rust"]).stdout == gc.export("3-rpr", "rust")


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["tricept"], "no closed form is known for the factors, the margin and the actuators of tricept"),
        (["delta", "--coordinates", "q1, q2, q3"], "code takes coordinates of the platform"),
        (["delta", "--coordinates", "x, y"], "too few coordinates"),
        (["delta", "--language", "ada"], "'ada' is not one of"),
        (["delta", "--language", "c", "-o", "x.rs"], "x.rs is a name for Rust 2021"),
        ([PLATFORM, "--coordinates", "x, y, z"], "has all six coordinates"),
        (["ab af cb cd ed ef"], "coordinates"),
    ],
)
def test_what_is_refused(arguments: list[str], says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert_refused(CliRunner().invoke(cli, ["export", *arguments]), 2, says)
    assert not list(tmp_path.iterdir())


def test_other_languages() -> None:
    with pytest.raises(InputError, match="code is not written in 'ada'"):
        gc.export("delta", "ada")
