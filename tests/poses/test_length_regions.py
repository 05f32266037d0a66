"""Regions of leg lengths: the exact curve beside modes counted in floats by other equations, and by following paths."""

from __future__ import annotations

import csv
import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.length_regions.integer_polynomials import (
    interpolated,
    reach_of,
    resultant,
    roots_between,
    subresultants,
)
from gcrules.poses.length_regions.sections import Section
from gcrules.poses.length_regions.three_legs import three_legs

GENERIC = EXAMPLES / "robots" / "generic-3-rpr.yaml"
BASE = np.array([[0, 0], [1.6, 0], [0.9, 0.6]])
PLATFORM = np.array([[0, 0], [1.4, 0], [0.7, 1]])


@pytest.fixture(scope="module")
def section() -> Section:
    """The generic robot with its first leg at length 1, all that the others reach."""
    legs = three_legs(mechanism(GENERIC))
    one = Fraction(1)
    ranges = [(Fraction(0), legs.reach(k, 0, one)) for k in (1, 2)]
    return Section.of(legs, (1, 2), 0, one, ranges)


@pytest.fixture(scope="module")
def found() -> Any:
    return gc.length_regions(GENERIC)


def modes(lengths: np.ndarray) -> int:
    """How many poses have these lengths: in z = exp(iφ), the place solved from two circles' differences."""

    def closed(z: np.ndarray) -> np.ndarray:
        turned = z[:, None] * (PLATFORM @ np.array([1, 1j])) - BASE @ np.array([1, 1j])
        other = (PLATFORM @ np.array([1, -1j])) / z[:, None] - BASE @ np.array([1, -1j])
        v = lengths[1:] ** 2 - lengths[0] ** 2 - (turned * other)[:, 1:]
        # p ū + p̄ u = v for both legs; |p|² = p p̄
        det = other[:, 1] * turned[:, 2] - other[:, 2] * turned[:, 1]
        p = v[:, 0] * turned[:, 2] - v[:, 1] * turned[:, 1]
        q = other[:, 1] * v[:, 1] - other[:, 2] * v[:, 0]
        return np.asarray(p * q - lengths[0] ** 2 * det**2)

    n = 16
    z = np.exp(2j * np.pi * np.arange(n) / n)
    laurent = np.fft.fft(closed(z)) / n  # powers −3 to 3
    powers = np.concatenate([laurent[-3:], laurent[:4]])
    roots = np.roots(powers[::-1])
    return int((np.abs(np.abs(roots) - 1) < 1e-6).sum())


def test_published_dimensions(found: Any) -> None:
    assert found.decided
    assert found.least == found.most == len(found) == 16
    assert found.counts == {0: 4, 2: 4, 4: 7, 6: 1}
    assert len(found.cusps) == 6
    assert found.region(found.home).modes == len(gc.assembly_modes(GENERIC))


def test_as_many_modes_as_other_equations_have(section: Section) -> None:
    """At random lengths, in floats."""
    number = {cell: part.modes for part in section.parts for cell in part.cells}
    random = np.random.default_rng(5)
    seen = set()
    for one, other in random.integers(1, 350, size=(80, 2)).tolist():
        x, y = Fraction(one, 100), Fraction(other, 100)
        cell = section.plane.cell_at(x * x * section.scale, y * y * section.scale)
        if cell is not None:
            expected = modes(np.array([1, float(x), float(y)]))
            assert number[cell] == expected, (x, y)
            seen.add(expected)
    assert seen == {0, 2, 4, 6}


def test_as_many_modes_as_paths_lead_to(found: Any) -> None:
    for region in found.regions:
        assert len(gc.assembly_modes(GENERIC, actuators=list(region.actuators))) == region.modes


def test_cells_of_a_region_have_the_same_modes(section: Section) -> None:
    for part in section.parts:
        for cell in part.cells:
            one, other = section.witness(cell)
            counted = section.legs.modes([Fraction(1), one**2, other**2])
            assert counted in (part.modes, None)


def test_euler(found: Any, section: Section) -> None:
    """A connected curve that meets itself and the border so often bounds one region more."""
    touching = sum(line.order == 0 for line in section.plane.lines)  # the axis of the second length
    second = Section.of(section.legs, (2, 1), 0, Fraction(1), [(Fraction(0), Fraction(4)), (Fraction(0), Fraction(5))])
    touching += sum(line.order == 0 for line in second.plane.lines)
    assert touching == 4
    assert len(found) == len(found.crossings) + touching + 1
    assert len(second.parts) == len(found)


def test_beside_each_other_are_two_modes_more_or_less(found: Any) -> None:
    for region in found.regions:
        assert region.neighbours
        for name in region.neighbours:
            other = found.region(name)
            assert abs(other.modes - region.modes) == 2
            assert region.name in other.neighbours


def test_a_smaller_box_and_another_leg() -> None:
    inside = gc.length_regions(GENERIC, over="q2 1..1.1, q3 0.9..1.1")
    assert (inside.counts, inside.home) == ({6: 1}, "")
    other = gc.length_regions(GENERIC, held="q3=1", over="q1 0.9..1.1, q2 1..1.1")
    assert other.held == (("q3", 1.0),)
    assert other.decided
    for region in other.regions:
        assert region.modes == modes(np.array(region.lengths))


def test_three_lengths() -> None:
    found = gc.length_regions(GENERIC, over="q1 0.9..1.1, q2 1..1.2, q3 0.9..1.1", slices=2)
    assert not found.decided
    assert found.slices == (0.95, 1.05)
    assert found.counts.get(6) == 1  # joined by a drive
    assert found.least == len(found.counts)
    assert found._repr_svg_() is None
    with pytest.raises(gc.InputError, match="of two lengths"):
        found.picture()


def test_other_dimensions(tmp_path: Path) -> None:
    """Whatever is said to be one region has one number of modes."""
    data = yaml.safe_load(GENERIC.read_text("utf-8"))
    data["home"] |= {"A2": [2, 0], "A3": [1, 2], "B2": [1, 1], "B3": ["1/2", "3/2"]}
    file = tmp_path / "robot.yaml"
    file.write_text(yaml.safe_dump(data), "utf-8")
    found = gc.length_regions(file)
    assert 1 < found.least <= found.most
    for region in found.regions:
        assert len(gc.assembly_modes(file, actuators=list(region.actuators))) == region.modes


def test_a_small_robot_has_as_narrow_ranges(tmp_path: Path) -> None:
    """In other units regions, and ranges that no length goes beyond, are those of a robot a thousand times as large."""
    data = yaml.safe_load(gc.load("3-rpr").text)
    data["home"] = {n: [str(Fraction(str(c)) / 1000) for c in place] for n, place in data["home"].items()}
    file = tmp_path / "robot.yaml"
    file.write_text(yaml.safe_dump(data), "utf-8")
    small, large = gc.length_regions(file), gc.length_regions("3-rpr")
    assert (small.decided, small.counts) == (large.decided, large.counts)
    for one, other in zip(small.over, large.over, strict=True):
        assert one.high * 1000 == pytest.approx(other.high, rel=0.06)


REFUSED = {
    "four legs": ({"source": "4-rpr"}, "it has 4 limbs"),
    "knees": ({"source": "3-rrr"}, r"leg 1 \(R\*RR\) is not a leg"),
    "space": ({"source": "delta"}, "it moves in space"),
    "six legs": ({"source": EXAMPLES / "octahedral.yaml"}, "a platform on six legs"),
    "unknown": ({"over": "q4 0..1"}, "'q4' is not a leg"),
    "held and free": ({"held": "q2=1", "over": "q2 0..1"}, "q2 is held, and has a range"),
    "two held": ({"held": "q1=1, q2=1"}, "two legs are held"),
    "negative": ({"held": "q1=-1"}, "is not positive"),
    "out of reach": ({"over": "q2 90..99"}, "q2 cannot be as long as 90"),
    "no end": ({"over": "q1 1.., q2 1..2, q3 1..2"}, "without an upper end"),
    "slices": ({"over": "q1 1..2, q2 1..2, q3 1..2", "slices": 1}, "1 slices, expected 2"),
}


@pytest.mark.parametrize(("asked", "message"), REFUSED.values(), ids=REFUSED)
def test_refused(asked: dict[str, Any], message: str) -> None:
    with pytest.raises(gc.InputError, match=message):
        gc.length_regions(**{"source": "3-rpr", **asked})


def test_similar_base_and_platform_are_refused(tmp_path: Path) -> None:
    data = yaml.safe_load(GENERIC.read_text("utf-8"))
    data["home"] |= {"A2": [2, 0], "A3": [1, 2], "B2": [1, 1], "B3": ["1/2", 2]}
    file = tmp_path / "robot.yaml"
    file.write_text(yaml.safe_dump(data), "utf-8")
    with pytest.raises(gc.InputError, match="the dimensions are special"):
        gc.length_regions(file)


def test_command(tmp_path: Path) -> None:
    picture, table = tmp_path / "regions.svg", tmp_path / "regions.csv"
    words = ["regions", "3-rpr", "--over", "q2 1..3, q3 1..3"]
    answer = invoke(*words, "--picture", str(picture), "--csv", str(table))
    assert answer.exit_code == 0
    assert "Proved: exactly" in answer.stdout
    assert picture.read_text("utf-8").startswith("<svg")
    data = json.loads(invoke(*words, "--json").stdout)
    rows = list(csv.DictReader(table.read_text("utf-8").splitlines()))
    assert [r["region"] for r in rows] == [r["name"] for r in data["regions"]]
    assert data["decided"]
    assert "modes" in invoke(*words, "--latex").stdout
    three = ["regions", "3-rpr", "--over", "q1 2.4..2.5, q2 2..2.2, q3 2..2.1", "--slices", "2"]
    assert invoke(*three).exit_code == 3
    assert invoke(*three, "--picture", str(picture)).exit_code == 2


def test_polynomials() -> None:
    p, q = [-6, 11, -6, 1], [2, -3, 1]  # (x − 1)(x − 2)(x − 3) and (x − 1)(x − 2)
    assert resultant(p, q) == 0
    assert resultant([-2, 0, 1], [-3, 1]) == 7
    found = subresultants([-1, 0, 0, 1], [0, 0, 3])
    assert found is None  # degrees drop by two
    found = subresultants([1, -3, 0, 1], [-3, 0, 3])
    assert found is not None
    line, last = found
    assert abs(last) == abs(resultant([1, -3, 0, 1], [-3, 0, 3]))
    assert len(line) == 2
    assert interpolated([0, 1, 2, 3], [1, 2, 5, 10]) == [1, 0, 1]
    assert all(abs(r.middle) < reach_of(p) for r in roots_between(p, Fraction(-9), Fraction(9)))
    assert len(roots_between(p, Fraction(0), Fraction(5, 2))) == 2
