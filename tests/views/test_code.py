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
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.compiling.closed_forms import ClosedForms
from gcrules.poses.compiling.compiled_limbs import CompiledLimbs
from gcrules.poses.compiling.controller import Controller, controller
from gcrules.poses.compiling.loop_tables import LoopTables, loop_tables
from gcrules.poses.limbs.many import Solved
from gcrules.poses.numbers.arrays import from_poses
from gcrules.screws.margin import jacobian
from gcrules.views.code.languages import LANGUAGES
from gcrules.views.code.source_code import source_code

PLATFORM = str(ROOT / "examples" / "octahedral.yaml")
ROBOTS = ("3-prs", "3-rrr", "3-rrr-spherical", "4-ruu", "6-rus", "delta", "orthoglide")
FEW = (PLATFORM, "3-rps", "delta", "3-rpr", "5r", "3-crr", "tricept", "h4")
EVERY = tuple(one.id for one in robots())
LOOPED = (
    *("2-upr-rpu", "3-cpu", "3-crr", "3-pprs", "3-uru", "4-ups-sp", "5-rpur", "5r", "capaman", "exechon"),
    *("gallardo-4dof", "gantry-tau", "h4", "omni-wrist-iii", "par4", "tricept", "trivariant"),
)
"""Robots whose loops are closed by Newton's method."""

COMPILERS = {
    "c": ("gcc", "-std=c99 -O1 -Wall -Wextra -pedantic -Werror -DGCRULES_TEST robot.c -lm -o robot"),
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


@pytest.mark.parametrize(
    ("source", "language"),
    [(s, n) for s in FEW for n in LANGUAGES if s not in EVERY or n not in ("c", "python")],  # these are tested below
)
def test_its_own_test_passes(source: str, language: str, tmp_path: Path) -> None:
    name = f"robot{LANGUAGES[language].suffix}"
    (tmp_path / name).write_text(source_code(model(source), language), encoding="utf-8")
    if language == "python":
        assert "poses, largest difference" in ran([sys.executable, "-W", "error", name], tmp_path)
    else:
        ran(compiler(language), tmp_path)
        assert ran(["./robot"], tmp_path)


@pytest.mark.parametrize("source", EVERY)
def test_of_every_robot_its_own_test_passes(source: str, tmp_path: Path) -> None:
    """In C, and in Python."""
    robot = model(source)
    assert len(robot.tests) > 3
    assert isinstance(robot.forms, LoopTables) == (source in LOOPED)
    (tmp_path / "robot.c").write_text(source_code(robot, "c"), encoding="utf-8")
    (tmp_path / "robot.py").write_text(source_code(robot, "python"), encoding="utf-8")
    assert "poses, largest difference" in ran([sys.executable, "-W", "error", "robot.py"], tmp_path)
    ran(compiler("c"), tmp_path)
    assert "poses, largest difference" in ran(["./robot"], tmp_path)


@pytest.mark.parametrize("source", ["3-rpr", "5r"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_its_own_test_notices_a_wrong_number(language: str, source: str, tmp_path: Path) -> None:
    good = model(source)
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
    ran(["gcc", "-std=c99", "-O0", "-shared", "-fPIC", "robot.c", "-lm", "-o", "robot.so"], folder)
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


def compared(robot: Controller, source: Any, code: Any, reach: float, number: int) -> int:
    """At how many poses, drawn as far, the `code` agrees with the loops that the engine closes; where these are proved
    the code has to give their numbers, and none where the engine has none.
    """
    value = gc.compiled(source, coordinates=robot.coordinates)
    assert isinstance(value, CompiledLimbs)
    rng, size = np.random.default_rng(3), value.mechanism.linkage.size
    units = np.where(robot.angles, 1.0, size)
    poses = rng.uniform(-reach, reach, (number, len(units))) * units
    solved = value.numbers(poses, "factors, margins, actuators, proved")
    actuators, factors, margin = code
    seen = 0
    for pose, proved, *expected in zip(
        poses, solved["proved"], solved["actuators"], solved["factors"], solved["margins"], strict=True
    ):
        if math.isnan(expected[2]) and isinstance(robot.forms, LoopTables):
            assert all(map(math.isnan, (*actuators(pose), *factors(pose), margin(pose))))
        if proved:
            seen += 1
            assert actuators(pose) == pytest.approx(expected[0], abs=1e-9 * size)
            assert factors(pose) == pytest.approx(expected[1], abs=1e-9)
            assert margin(pose) == pytest.approx(expected[2], abs=1e-9)
    return seen


@pytest.mark.parametrize("source", ROBOTS)
def test_robots_of_joints(source: str, tmp_path: Path) -> None:
    """Two roads: the code in C, and the loops closed by Newton's method, at poses that are proved."""
    assert compared(model(source), source, functions(model(source), "c", tmp_path), 0.08, 12) > 3


@pytest.mark.parametrize("source", LOOPED)
def test_loops_closed_step_by_step(source: str, tmp_path: Path) -> None:
    """Two roads, farther from home: the code that closes loops, in C and Python, and the engine."""
    robot = model(source)
    assert compared(robot, source, functions(robot, "python", tmp_path), 0.08, 2) == 2
    assert compared(robot, source, functions(robot, "c", tmp_path), 0.4, 5) > 0


@pytest.mark.parametrize("source", ["delta", "3-rps", "agile-eye", "3-rpr", "geared"])
def test_closed_forms_and_loops_agree(source: str, tmp_path: Path) -> None:
    """Robots whose closed forms are known are tested by code that closes their loops too; one of them has gears."""
    given = geared() if source == "geared" else source
    robot = controller(given)
    assert isinstance(robot.forms, ClosedForms)
    m = mechanism(given)
    assert isinstance(m, Limbs)
    home = Solved.of(m, np.zeros((1, sum(len(c.turns) for c in m.linkage.home.chains))))
    looped = replace(robot, forms=loop_tables(home, robot.coordinates))
    own, others = (functions(r, "python", tmp_path) for r in (robot, looped))
    for test in robot.tests:
        for one, other in zip(own, others, strict=True):
            assert one(test.pose) == pytest.approx(other(test.pose), abs=1e-9 * max(1.0, m.linkage.size))


def geared() -> Any:
    """An orthoglide with gears instead of parallelograms."""
    bars = "joints: P*(d%) R(A%, e%) Pa(A% B%, n%) R(B%, e%)"
    gears = "joints: P*(d%) R(A%, e%) R:near(A%, n%) R:far(B%, n%) R(B%, e%)\n    couplings: far = -near"
    text = (ROOT / "plugins" / "orthoglide" / "robot.yaml").read_text(encoding="utf-8")
    assert bars in text
    return gc.load(text.replace(bars, gears))


@pytest.mark.parametrize(
    ("source", "pose"), [("tricept", "x=0.1, y=-0.2, z=0.1"), ("omni-wrist-iii", "roll=0.2rad, pitch=-0.3rad")]
)
def test_the_margin_of_a_pose(source: str, pose: str, tmp_path: Path) -> None:
    _, factors, margin = functions(model(source), "python", tmp_path)
    at = [float(part.partition("=")[2].removesuffix("rad")) for part in pose.split(", ")]
    found: Any = gc.pose(source, pose, nearest=False)
    assert margin(at) == pytest.approx(found.margin, abs=1e-9)
    assert factors(at) == pytest.approx([f.value for f in found.factors if f.live], abs=1e-9)


@pytest.mark.parametrize("language", ["c", "python"])
def test_the_turn_of_a_platform_as_a_vector(language: str, tmp_path: Path) -> None:
    """Which has no closed form; the same pose in both ways of naming turns."""
    robot = controller("3-rrr-spherical", coordinates="rx, ry, rz")
    assert isinstance(robot.forms, LoopTables)
    assert compared(robot, "3-rrr-spherical", functions(robot, language, tmp_path), 0.2, 6) > 2


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


@pytest.mark.parametrize("source", ["delta", "3-uru"])
@pytest.mark.parametrize("language", ["c", "python"])
def test_where_it_does_not_assemble(language: str, source: str, tmp_path: Path) -> None:
    actuators, factors, margin = functions(model(source), language, tmp_path)
    for pose in ([0.0, 0.0, -99.0], [math.nan, 0.0, 0.0], [0.0, math.inf, 0.0], [0.0, 1e300, 0.0]):
        for number in (*actuators(pose), *factors(pose), margin(pose)):
            assert math.isnan(number)


@pytest.mark.parametrize("language", ["c", "python"])
def test_angles_of_any_size(language: str, tmp_path: Path) -> None:
    _, factors, margin = functions(model("3-rpr"), language, tmp_path)
    turned = [0.1, 0.2, 0.3 - 6 * math.pi]
    assert factors(turned) == pytest.approx(factors([0.1, 0.2, 0.3]), abs=1e-12)
    assert margin(turned) == pytest.approx(margin([0.1, 0.2, 0.3]), abs=1e-12)
    folder = tmp_path / "another"  # libraries are told apart by their names
    folder.mkdir()
    _, factors, margin = functions(model("omni-wrist-iii"), language, folder)
    assert factors([0.1 - 6 * math.pi, 0.2]) == pytest.approx(factors([0.1, 0.2]), abs=1e-12)
    assert margin([0.1 - 6 * math.pi, 0.2]) == pytest.approx(margin([0.1, 0.2]), abs=1e-12)


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
    for number, title in enumerate(HOSTILE):
        robot = replace(model(("3-rpr", "5r")[number % 2]), name=title, title=f"{title} {title}")
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
        "a check by sampling, not a proof",
        "The platform's other coordinates",
    ):
        assert words in head
    assert "(in mm)" in gc.export(PLATFORM, "rust")
    looped = " ".join(line.removeprefix("//").strip() for line in gc.export("5r", "c").splitlines()[:20])
    assert "The loops are closed by Newton's method, from home straight to the pose in steps of 0.1" in looped
    assert "Nothing proves that the steps stay on one branch" in looped
    assert "sampling" not in looped


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
        (["tricept", "--coordinates", "q1, q2, q3"], "code takes coordinates of the platform"),
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
