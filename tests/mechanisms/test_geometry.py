"""Geometry files: what they hold, their faults, and the examples."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Point, join
from gcrules.algebra.scalars import superbracket
from gcrules.core.errors import FileError, GcrulesError
from gcrules.mechanisms.description.platform_file import Platform, load_platform, parse_platform

GOOD = """\
title: Stand
units: mm
legs: [ab, [left, b], S1 a]
points:
  a: [0, -1, 2.5]
  b: [1/2, "3/4", 1e-2]
  left: [1, 0, 0]
  S1: [0, 1, 0]
  spare: [9, 9, 9]
"""


def test_what_a_file_holds() -> None:
    platform = parse_platform(GOOD, "stand.yaml")
    assert platform.legs == (("a", "b"), ("left", "b"), ("S1", "a"))
    assert platform.points["b"] == (Fraction(1, 2), Fraction(3, 4), Fraction(1, 100))
    assert (platform.title, platform.note, platform.units) == ("Stand", "", "mm")
    assert platform.warnings == ("stand.yaml:9:3: point spare is in no leg",)
    assert platform.homogeneous()["a"] == (0, -1, Fraction(5, 2), 1)
    assert hash(platform) == hash(parse_platform(GOOD, "stand.yaml"))


def test_short_forms() -> None:
    platform = parse_platform(
        "legs: ab, S1A' cd\npoints: {a: [0,0,0], b: [1,0,0], S1: [2,0,0], A': [3,0,0], c: [4,0,0], d: [5,0,0]}\n",
        "x/two.yaml",
    )
    assert platform.legs == (("a", "b"), ("S1", "A'"), ("c", "d"))
    assert (platform.title, platform.units) == ("two", "")


POINTS = "points: {a: [0, 0, 0], b: [1, 0, 0], c: [0, 1, 0], S1: [0, 0, 1]}\n"
FAULTS = {
    "missing point": ("legs: [ab, as]\n" + POINTS, "1:12", "names s, which has no coordinates"),
    "near name": ("legs: [[a, S2]]\n" + POINTS, "1:8", "which has no coordinates"),
    "loop": ("legs: [ab, cc]\n" + POINTS, "1:12", "from a point to itself"),
    "coincident": ("legs: [ab]\npoints:\n  a: [1/2, 0, 0]\n  b: [0.5, 0, 0]\n", "1:8", "same place"),
    "three points": ("legs: [abc]\n" + POINTS, "1:8", "does not name two points"),
    "one point": ("legs: [S1]\n" + POINTS, "1:8", "does not name two points"),
    "pair of three": ("legs: [[a, b, c]]\n" + POINTS, "1:8", "a list of 3, expected 2"),
    "no legs": ("legs: []\n" + POINTS, "1:7", "there are no legs"),
    "empty legs": ("legs:\n" + POINTS, "1:6", "expected a list"),
    "no points": ("legs: [ab]\npoints: {}\n", "2:9", "there are no points"),
    "legs missing": (POINTS, "1:1", "the key 'legs' is missing"),
    "two coordinates": ("legs: [ab]\npoints:\n  a: [0, 0]\n  b: [1, 0, 0]\n", "3:6", "a list of 2, expected 3"),
    "not a number": ("legs: [ab]\npoints:\n  a: [0, 0, x]\n  b: [1, 0, 0]\n", "3:13", "expected a number"),
    "not finite": ("legs: [ab]\npoints:\n  a: [0, 0, .inf]\n  b: [1, 0, 0]\n", "3:13", "finite"),
    "name": ("legs: [ab]\npoints:\n  a: [0, 0, 0]\n  b: [1, 0, 0]\n  7: [1, 1, 1]\n", "5:3", "not a name for a point"),
    "point twice": ("legs: [ab]\npoints:\n  a: [0, 0, 0]\n  b: [1, 0, 0]\n  a: [1, 1, 1]\n", "5:3", "occurs twice"),
    "unit": ("legs: [ab]\nunits: mn\n" + POINTS, "2:8", "not one of"),
    "unknown key": ("leg: [ab]\nlegs: [ab]\n" + POINTS, "1:1", "unknown key 'leg'"),
    "limbs": ("limbs: []\nlegs: [ab]\n" + POINTS, "1:1", "reserved"),
    "a list": ("- ab\n", "1:3", "expected a mapping"),
    "tag": ("legs: [ab]\ntitle: !!python/name:os.system x\n" + POINTS, "2:8", "tags"),
}


@pytest.mark.parametrize(("text", "place", "words"), FAULTS.values(), ids=FAULTS)
def test_faults(text: str, place: str, words: str) -> None:
    with pytest.raises(FileError) as found:
        parse_platform(text, "f.yaml")
    matching = [line for line in found.value.render().splitlines() if words in line]
    assert matching
    assert matching[0].startswith(f"error: f.yaml:{place}: ")


def test_a_near_name_is_suggested() -> None:
    with pytest.raises(GcrulesError) as found:
        parse_platform("legs: [[a, S2]]\n" + POINTS)
    assert found.value.hint == "did you mean S1?"


def test_all_faults_at_once() -> None:
    with pytest.raises(GcrulesError) as found:
        parse_platform("units: miles\nlegs: [aa, xyz, ab]\npoints:\n  a: [0, 0, no]\n  b: [1, 2]\n", "f.yaml")
    assert found.value.render().count("error: f.yaml:") == 5


@pytest.mark.parametrize(("name", "words"), [("missing.yaml", "no such file"), (".", "directory")])
def test_no_file(tmp_path: Path, name: str, words: str) -> None:
    with pytest.raises(FileError, match=words):
        load_platform(tmp_path / name)


EXAMPLES = {
    "octahedral": "ab af cb cd ed ef",
    "octahedral-singular": "ab af cb cd ed ef",
    "two-tripods": "aA bA cA dB eB fC",
    "platform-6-3": "Aa Ba Cb Db Ec Fc",
    "platform-6-4": "Aa Ab Bc Bd Ce Df",
    "platform-6-6": "Aa Bb Cc Dd Ee Ff",
    "four-dof": "A1S1 B1S1 C1S1 A2S2 A3S3 B3S3",
}


def value(platform: Platform) -> Fraction:
    lines = [join(Point(a), Point(b)) for a, b in platform.legs]
    return Fraction(evaluate(superbracket(*lines), platform.homogeneous()))


def test_every_example_is_known_here(root: Path) -> None:
    files = {path.stem for path in (root / "examples").glob("*.yaml")}
    assert files >= set(EXAMPLES)


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples(root: Path, name: str) -> None:
    platform = load_platform(root / "examples" / f"{name}.yaml")
    assert [a + b for a, b in platform.legs] == EXAMPLES[name].split()
    assert "example, invented dimensions" in platform.note
    assert platform.units
    assert not platform.warnings
    assert (value(platform) == 0) is ("singular" in name)


def test_both_octahedral_poses_are_of_one_robot(root: Path) -> None:
    poses = [load_platform(root / "examples" / f"{name}.yaml").points for name in ("octahedral", "octahedral-singular")]
    for body in ("ace", "bdf"):
        sides = [
            [sum((x - y) ** 2 for x, y in zip(p[a], p[b], strict=True)) for a in body for b in body] for p in poses
        ]
        assert sides[0] == sides[1]
