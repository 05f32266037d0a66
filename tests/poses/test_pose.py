"""Numbers at a pose: verdicts, many poses at once, faults, the command."""

from __future__ import annotations

import json
import math
import pickle
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from places import EXAMPLES
from poses.platforms import PLATFORMS
from poses.structures import ANALYSES, OCTAHEDRON, STRUCTURES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform, parse_platform
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose
from gcrules.screws.threshold import parse_threshold

F = Fraction


# --- verdicts ------------------------------------------------------------------------------------------------------


def test_a_length_takes_the_places_as_exact(robots: dict[str, Analysis]) -> None:
    """A shift that is free of singular poses says nothing of joints that are elsewhere."""
    robot = next(iter(robots.values()))
    with pytest.raises(InputError, match="takes the joints' places as exact"):
        gc.pose(robot, threshold="1 mm", accuracy="1 mm", nearest=False)
    assert "for the joints' places as given" in gc.pose(robot, accuracy="1 mm", nearest=False).text()


@pytest.mark.parametrize(
    ("name", "threshold", "accuracy", "verdict"),
    [
        ("octahedral", "0.5 deg", None, "regular"),
        ("octahedral", "30deg", None, "close"),
        ("octahedral", "0.6 rad", None, "close"),
        ("octahedral", "349 mm", None, "regular"),
        ("octahedral", "351 mm", None, "close"),
        ("octahedral", "0.5 deg", "40 mm", "close"),
        ("octahedral", "0.5 deg", "1", "regular"),
        ("octahedral-singular", "0.5 deg", None, "singular"),
        ("platform-6-4", "0.5 deg", None, "regular"),
        ("platform-6-4", "1 deg", None, "close"),
    ],
)
def test_verdicts(robots: dict[str, Analysis], name: str, threshold: str, accuracy: str | None, verdict: str) -> None:
    found = gc.pose(robots[name], threshold=threshold, accuracy=accuracy, nearest=False)
    assert found.verdict == verdict
    assert found.reason.endswith(".")


@pytest.mark.parametrize(
    "text", ["", "5", "0 deg", "-1 deg", "nan deg", "inf mm", "5 cm", "5 bananas", "deg", "90.1 deg", "1.6 rad"]
)
def test_thresholds_at_fault(text: str) -> None:
    with pytest.raises(InputError):
        parse_threshold(text, "mm")


# --- many poses ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", PLATFORMS)
def test_many_poses_have_the_numbers_of_each(
    robots: dict[str, Analysis], name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    a = robots[name]
    size = 50.0 if name == "octahedral" else 0.1
    shifts = np.random.default_rng(4).normal(size=(5, 3)) * size
    turns = np.random.default_rng(5).normal(size=(5, 3)) * 0.2
    many = gc.pose(a, shifts, rotation_vector=turns, about="centroid")
    assert len(many) == 5
    for i in range(5):
        one = gc.pose(a, shifts[i], rotation_vector=turns[i], about="centroid", nearest=False)
        assert many.value[i] == pytest.approx(one.value, rel=1e-9)
        for field in ("margin", "turn", "shift", "rotation", "combined", "noise"):
            assert getattr(many, field)[i] == pytest.approx(getattr(one, field), rel=1e-9)
        assert many.condition_number[i] == pytest.approx(one.jacobian.condition_number, rel=1e-9)
        assert many.verdict[i] == one.verdict
        readings: list[tuple[Any, Any]] = list(zip(many.readings, one.readings, strict=True))
        for r, s in readings:
            assert (r.part, r.name) == (s.part, s.name)
            assert (s.value is None and not r.valid[i]) or r.values[i] == pytest.approx(s.value, rel=1e-9)
    assert json.loads(json.dumps(many.to_json()))["verdict"] == many.verdict.tolist()
    monkeypatch.setattr("gcrules.poses.numbers.many.CHUNK", 2)
    parts = gc.pose(a, shifts, rotation_vector=turns, about="centroid")
    assert parts.verdict.tolist() == many.verdict.tolist()
    assert np.allclose(parts.margin, many.margin, rtol=1e-12)
    assert np.allclose(
        parts.readings[0].values if parts.readings else [], many.readings[0].values if many.readings else []
    )
    listed = gc.pose(a, [Pose(), parse_pose("0 0 0; euler XYZ 3 4 5 deg")])
    assert listed.margin[0] == pytest.approx(gc.pose(a, nearest=False).margin)


def test_a_centre_moves_the_same_robot(robots: dict[str, Analysis]) -> None:
    a = robots["octahedral"]
    c = np.array([10.0, -20.0, 300.0])
    r = np.array(parse_pose("euler ZYX 10 20 30 deg").rotation, float)
    about = gc.pose(a, "1 2 3; euler ZYX 10 20 30 deg", about="10, -20, 300", nearest=False)
    shift, turn = np.array([1, 2, 3]) + c - r @ c, ("ZYX", (10, 20, 30))
    origin = gc.pose(a, shift, euler=turn, degrees=True, about="origin", nearest=False)
    assert about.value == pytest.approx(origin.value)
    assert about.rig.centre == (10, -20, 300)


@pytest.mark.parametrize(
    "arguments",
    [
        pytest.param({"at": [1, 2]}, id="two numbers"),
        pytest.param({"at": 5}, id="one number"),
        pytest.param({"at": [[1, 2], [3, 4]]}, id="shape (2, 2)"),
        pytest.param({"at": [[1, 2, 3], [4, 5]]}, id="ragged"),
        pytest.param({"at": np.zeros((0, 3))}, id="no poses"),
        pytest.param({"at": np.zeros((2, 2, 3))}, id="three axes"),
        pytest.param({"at": [0, 0, math.nan]}, id="NaN"),
        pytest.param({"at": [[0, 0, 0], [0, math.inf, 0]]}, id="infinity in a row"),
        pytest.param({"at": ["0 0 0", "0 0"]}, id="text at fault in a list"),
        pytest.param({"at": "0 0 0", "quaternion": (1, 0, 0, 0)}, id="turn beside text"),
        pytest.param({"at": [Pose()], "quaternion": [(1, 0, 0, 0)]}, id="turn beside poses"),
        pytest.param({"quaternion": (1, 1, 0, 0)}, id="long quaternion"),
        pytest.param({"quaternion": [(1, 0, 0, 0), (0.5, 0, 0, 0)]}, id="short quaternion in a row"),
        pytest.param({"quaternion": (1, 0, 0)}, id="three components"),
        pytest.param({"quaternion": (1, 0, 0, 0), "rotation_vector": (0, 0, 0)}, id="two turns"),
        pytest.param({"at": np.zeros((3, 3)), "quaternion": np.ones((2, 4)) / 2}, id="3 and 2"),
        pytest.param({"euler": ("zyz", (1, 2))}, id="two angles"),
        pytest.param({"euler": ("abc", (1, 2, 3))}, id="no sequence"),
        pytest.param({"euler": ("abc", [(1, 2, 3)])}, id="no sequence of rows"),
        pytest.param({"at": (-1, -2, -4)}, id="leg of no length"),
        pytest.param({"at": [(0, 0, 0), (-1, -2, -4)]}, id="leg of no length in a row"),
        pytest.param({"about": "middle"}, id="no centre"),
        pytest.param({"about": (1, 2)}, id="short centre"),
        pytest.param({"about": "0 0 0 m"}, id="centre in another unit"),
        pytest.param({"threshold": "3"}, id="threshold without unit"),
        pytest.param({"accuracy": -1}, id="negative accuracy"),
        pytest.param({"accuracy": "1 m"}, id="accuracy in another unit"),
        pytest.param({"at": np.zeros((2, 3)), "threshold": "5 mm"}, id="length for many poses"),
        pytest.param({"at": [0, 0, "x"]}, id="text among numbers"),
        pytest.param({"euler": "zyx"}, id="sequence without angles"),
        pytest.param({"euler": (1, 2, 3)}, id="angles without sequence"),
        pytest.param({"quaternion": 1}, id="a number for a quaternion"),
        pytest.param({"about": 5}, id="a number for a centre"),
        pytest.param({"threshold": 2}, id="threshold that is a number"),
        pytest.param({"at": "1e200 0 0"}, id="far"),
        pytest.param({"at": [(1e300, 0, 0), (0, 0, 0)]}, id="far in a row"),
        pytest.param({"at": "0 0 0", "about": "1e300 0 0", "euler": None, "accuracy": "nan"}, id="accuracy NaN"),
    ],
)
def test_python_tells_faults(arguments: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        gc.pose(OCTAHEDRON, **arguments)


BASE_ON_A_LINE = """
legs: [Aa, Ab, Ba, Bb, Cc, Cd]
points: {A: [0, 0, 0], B: [1, 0, 0], C: [2, 0, 0], a: [0, 0, 1], b: [1, 0, 1], c: [0, 1, 2], d: [2, 1, 1]}
"""
PLATFORM_ON_A_LINE = """
legs: [Aa, Ab, Ba, Bb, Ca, Cb]
points: {A: [0, 0, 0], B: [1, 0, 0], C: [0, 1, 0], a: [0, 0, 1], b: [1, 0, 1]}
"""
NO_BODIES = """
legs: [ab, bc, ca, ad, bd, cd]
points: {a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0], d: [0, 0, 1]}
"""


@pytest.mark.parametrize(
    ("robot", "says"),
    [
        pytest.param(BASE_ON_A_LINE, "A, B, C of the base lie on one line", id="base"),
        pytest.param(PLATFORM_ON_A_LINE, "a, b of the platform lie on one line", id="platform"),
        pytest.param(NO_BODIES, "do not tell", id="no bodies"),
    ],
)
def test_degenerate_robots(robot: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        gc.pose(parse_platform(robot))


@pytest.fixture(scope="module")
def here() -> Any:
    return gc.pose(OCTAHEDRON)


@pytest.mark.parametrize("power", [-70, -40, 40, 70])
def test_sizes_of_robots(here: Any, power: int) -> None:
    """Beyond floats they are refused, else nothing but the unit changes."""
    size = F(10) ** power
    scaled = replace(OCTAHEDRON, points={n: tuple(c * size for c in p) for n, p in OCTAHEDRON.points.items()})
    if abs(power) > 60:
        with pytest.raises(InputError, match="for floats"):
            gc.pose(scaled)
        return
    found = gc.pose(scaled)
    assert found.margin == pytest.approx(here.margin)
    for there, same, unit in zip(found.nearest, here.nearest, (size, 1, size), strict=True):
        assert there.distance == pytest.approx(float(unit) * same.distance, rel=1e-6, abs=0)
    json.dumps(found.to_json(), allow_nan=False)


def test_an_analysis_without_coordinates() -> None:
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        gc.pose(ANALYSES[STRUCTURES[0]])


# --- the command line ----------------------------------------------------------------------------------------------


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, ["pose", *arguments], input=text)


def test_json_of_the_command(root: Any) -> None:
    done = run(str(root / "examples" / "octahedral.yaml"), "--at", "1 2 3; euler zyx 5 0 0 deg", "--json")
    assert done.exit_code == 0
    found = json.loads(done.stdout)
    assert {"schema", "value", "margin", "verdict", "reason", "pose", "readings", "nearest"} <= set(found)
    assert found["verdict"] == "regular"
    assert 0 < found["margin"] < 1
    assert found["pose"]["translation"] == [1, 2, 3]
    assert found["nearest"]["translation"]["certified"]
    assert all(r["valid"] for r in found["readings"])


@pytest.mark.parametrize(
    "arguments", [(), ("--ascii", "--no-nearest"), ("--latex", "--no-nearest"), ("--threshold", "5 mm", "--no-nearest")]
)
@pytest.mark.parametrize("name", ["octahedral", "octahedral-singular"])
def test_forms_of_the_answer(root: Any, name: str, arguments: tuple[str, ...]) -> None:
    done = run(str(root / "examples" / f"{name}.yaml"), *arguments)
    assert done.exit_code == 0, done.output
    if "--ascii" in arguments:
        assert done.stdout.isascii()
    if "--latex" in arguments:
        assert done.stdout.count("{") == done.stdout.count("}")
    elif not arguments:
        assert done.stdout.startswith("regular: " if name == "octahedral" else "singular: ")
        assert max(map(len, done.stdout.splitlines())) <= 100


@pytest.mark.parametrize(
    "arguments",
    [
        ("--at", "0 0 nan"),
        ("--at", "0 0 1 cm"),
        ("--at", "quaternion 1 1 1 1"),
        ("--at", "-1 -2 -4"),
        ("--at", ""),
        ("--about", "here"),
        ("--threshold", "5"),
        ("--accuracy", "x"),
        ("--accuracy", "-1"),
        ("--bananas",),
    ],
)
def test_the_command_tells_faults(arguments: tuple[str, ...]) -> None:
    robot = (
        "legs: [ab, af, cb, cd, ed, ef]\nunits: mm\n"
        "points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}"
    )
    done = run("-", *arguments, text=robot)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert "rror" in done.stderr


def test_a_file_that_is_missing() -> None:
    assert run("no-such-robot.yaml").exit_code == 2


def test_a_platform_is_a_value() -> None:
    assert isinstance(OCTAHEDRON, Platform)
    found = gc.pose(OCTAHEDRON, nearest=False)
    assert "<PoseReport" in repr(found)
    assert pickle.loads(pickle.dumps(found)) == found
    assert hash(found) == hash(gc.pose(OCTAHEDRON, nearest=False))
    assert str(found).startswith(found.verdict)
    assert found._repr_html_().startswith("<pre>")


def test_the_legs_are_as_long_as_their_ends_are_apart() -> None:
    robot = gc.load(EXAMPLES / "octahedral.yaml")
    here = gc.pose(robot, "10 0 -30; euler zyx 20 0 5 deg", nearest=False)
    places = {n: [float(c) for c in p] for n, p in here.rig.exact(here.pose).items()}
    apart = {f"{a}{b}": math.dist(places[a][:3], places[b][:3]) for a, b in robot.legs}
    assert here.actuator_values == pytest.approx(apart)
    told = here.to_json()["actuators"]
    assert {one["name"]: one["value"] for one in told} == here.actuator_values
    assert {one["unit"] for one in told} == {"mm"}
