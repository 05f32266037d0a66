"""One pose, one verdict: what every road says of the same octahedral platform, at heights that make it less regular.

Six legs between two triangles; as the platform sinks into the plane of the base σ goes to 0 with its height.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from commands import invoke
from mechanisms.shipped_robots import analysis
from places import ROOT

import gcrules as gc
from gcrules.apps.studio.numbers import numbers
from gcrules.apps.studio.subject import read_subject
from gcrules.mechanisms.description.platform_file import Platform, parse_platform
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.screws.threshold import DEFAULT, margin_of, safe, turn_of
from gcrules.screws.verdict import CLOSE, VERDICTS, decide, rank
from gcrules.views.report.scene_json import Scenery

LEGS = "A1B1 A1B3 A2B1 A2B2 A3B2 A3B3"
BASE = {"A1": (3, 0), "A2": (-2, 3), "A3": (-2, -3)}
BODY = {"B1": (1, 2), "B2": (-2, 0), "B3": (1, -2)}
HOME: Any = {"translation": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}


def geometry(height: str) -> str:
    places = [f"{n}: [{x}, {y}, 0]" for n, (x, y) in BASE.items()]
    places += [f"{n}: [{x}, {y}, {height}]" for n, (x, y) in BODY.items()]
    return f"legs: {LEGS}\npoints: {{{', '.join(places)}}}\n"


def platform(height: str) -> Platform:
    return parse_platform(geometry(height))


def by_joints(height: str) -> gc.Robot:
    file = ROOT / "plugins" / "octahedral" / "robot.yaml"
    return parse_robot(file.read_text(encoding="utf-8").replace(", 4]", f", {height}]"))


def command(height: str, name: str, *options: str) -> Any:
    """What a command says in JSON; the geometry comes on standard input."""
    done = invoke(name, "-", *options, "--json", input=geometry(height))
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


def widget(height: str) -> Any:
    pytest.importorskip("anywidget")
    return gc.view(platform(height)).verdict


ROADS: dict[str, Callable[[str], Any]] = {
    "pose": lambda h: gc.pose(platform(h), "0 0 0", nearest=False).verdict,
    "poses": lambda h: gc.pose(platform(h), [[0, 0, 0]] * 2).verdict.tolist()[1],
    "the analysis of a file": lambda h: gc.analyze(platform(h)).pose.verdict,
    "path": lambda h: gc.path(platform(h), ["0 0 0", "0 0 0"], samples=1).verdict,
    "samples of a path": lambda h: gc.path(platform(h), ["0 0 0", "0 0 0"], samples=1).numbers.verdict.tolist()[0],
    "studio": lambda h: numbers(read_subject({"kind": "file", "text": geometry(h), "name": "x.yaml"}), HOME)["verdict"],
    "widget": widget,
    "joints": lambda h: gc.pose(by_joints(h)).verdict,
    "gcrules pose": lambda h: command(h, "pose", "--at", "0 0 0", "--no-nearest")["verdict"],
    "gcrules analyze": lambda h: command(h, "analyze")["pose"]["verdict"],
    "gcrules path": lambda h: command(h, "path", "--at", "0 0 0", "--at", "0 0 0", "--samples", "1")["verdict"],
}


# The height, its margin, and the verdict. A length of 1e-14 is 0 within the rounding of the coordinates. The joints
# of a robot are solved for to 1e-9 of its size, so that less is 0 there (`screws.verdict.SOLVED`).
HEIGHTS = {
    "above half a degree": ("0.0271", 0.0087993, "regular", "regular"),
    "below half a degree": ("0.026825674752419055", 0.00871, "close", "close"),
    "far below": ("3.0797344929663504e-8", 1e-8, "close", "close"),
    "hardly anything": ("9.239203476831473e-10", 3e-10, "close", "singular"),
    "rounding": ("1e-14", 3.25e-15, "singular", "singular"),
    "flat": ("0", 0.0, "singular", "singular"),
}


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize(("height", "sigma", "verdict", "of_joints"), HEIGHTS.values(), ids=HEIGHTS.keys())
def test_every_road_says_the_same(road: str, height: str, sigma: float, verdict: str, of_joints: str) -> None:
    assert gc.pose(platform(height), [[0, 0, 0]], nearest=False).margin[0] == pytest.approx(sigma, rel=1e-4, abs=1e-15)
    assert ROADS[road](height) == (of_joints if road == "joints" else verdict)


@pytest.mark.parametrize("height", ["0.0271", "0.026825674752419055"])
def test_the_page_without_a_server_has_its_bound_from_here(height: str) -> None:
    """It draws the softest motion unless the pose is regular, and compares with the bound in the recipe."""
    scene = Scenery.of(gc.analyze(platform(height)))
    assert scene.recipe["thresholds"]["close"] == CLOSE
    assert (scene.at()["motion"] is None) == (height == "0.0271")


def test_the_default_threshold_is_the_bound() -> None:
    assert DEFAULT.angle is not None
    assert margin_of(DEFAULT.angle) == CLOSE
    assert math.asin(CLOSE) == pytest.approx(math.radians(0.5))


@pytest.mark.parametrize(
    ("sigma", "floor", "spread", "close", "word"),
    [
        (0.0, 0.0, 0.0, 0.1, "singular"),
        (0.1, 0.0, 0.0, 0.1, "regular"),
        (0.1, 0.1, 0.0, 0.1, "singular"),
        (0.15, 0.01, 0.1, 0.1, "close"),
        (0.21, 0.01, 0.1, 0.1, "regular"),
        (0.05, 0.01, 0.1, 0.1, "close"),
        (math.nan, 0.01, 0.1, 0.1, "singular"),
    ],
)
def test_the_decision(sigma: float, floor: float, spread: float, close: float, word: str) -> None:
    assert decide(sigma, floor, spread, close) == word
    assert np.array(VERDICTS)[rank(np.array([sigma, sigma]), floor, spread, close)].tolist() == [word, word]


@pytest.mark.parametrize("degrees", [0.1, 1.0, 23.5, 23.9, 24.1, 60.0, 90.0])
def test_a_threshold_means_the_same_for_legs_and_limbs(degrees: float) -> None:
    """The octahedral platform at home has σ = 0.4064 and asin σ = 23.98°: as limbs, and as six legs."""
    threshold = f"{degrees} deg"
    a = analysis("octahedral")
    limbs = gc.pose(a, threshold=threshold, nearest=False)
    legs = gc.pose(a, threshold=threshold, accuracy="0", nearest=False)
    assert limbs.margin == pytest.approx(legs.margin)
    assert limbs.verdict == legs.verdict == ("regular" if degrees < 23.98 else "close")


@pytest.mark.parametrize("turn", [0.0, 1e-9, 0.01, 0.5, math.pi / 2])
def test_a_margin_guarantees_its_turn(turn: float) -> None:
    assert turn_of(margin_of(turn)) == pytest.approx(turn)
    assert margin_of(math.pi / 2 + turn + 1e-6) > 1  # which no margin reaches


@pytest.mark.parametrize("margin", [0.27527, 0.1901, 0.4064, 1e-7, 0.0, 1.0])
def test_no_guarantee_is_rounded_up(margin: float) -> None:
    assert float(safe(turn_of(margin)).removesuffix("°")) <= math.degrees(turn_of(margin))
    assert float(safe(margin, "mm", 4).removesuffix(" mm")) <= margin


@pytest.mark.parametrize("robot", ["delta", "3-uru", "3-rps"])
def test_what_is_printed_of_a_turn_is_below_it(robot: str) -> None:
    found = gc.pose(robot, nearest=False)
    for words in (found.reason, repr(found)):
        (told,) = re.findall(r"([\d.]+)°", words)
        assert float(told) <= math.degrees(found.turn) < float(told) + 0.1
