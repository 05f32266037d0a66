"""Along a path: no zero is missed, kinds and causes are right, bounds hold in between, faults are told with place."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner
from commands import assert_refused
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from poses.platforms import PLATFORMS

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.apps.cli import path as path_command
from gcrules.conditions.analysis import Analysis
from gcrules.core.budget import report
from gcrules.core.errors import GcrulesError, InputError, LimitReached
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.mechanisms.moving_platform import MovingPlatform, rig
from gcrules.poses.numbers.cubic import superbracket_at, translation_polynomial
from gcrules.poses.paths import table as path_file
from gcrules.poses.paths.report import PathReport
from gcrules.poses.paths.segment import Segment
from gcrules.poses.paths.segments import segments
from gcrules.poses.paths.table import read_poses
from gcrules.poses.paths.zeros import Stretch, places, stretches
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose
from gcrules.screws.rotations import product as turn_product
from gcrules.views.plots.path_plot import _determinant

F = Fraction
ALWAYS = """
legs: [Aa, Ab, Ac, Ad, Be, Ce]
points:
  {A: [0, 0, 0], B: [4, 0, 0], C: [0, 5, 0], a: [1, 0, 3], b: [0, 1, 3], c: [-1, 0, 3], d: [0, -1, 4], e: [2, 2, 3]}
"""


def rig_of(a: Analysis, about: Any = "centroid") -> MovingPlatform:
    assert a.platform is not None
    return rig(a.structure, a.platform, about)


def zeros(r: PathReport) -> list[tuple[Any, ...]]:
    return [(z.lower if z.exact else round(z.parameter, 6), z.kind, z.multiplicity) for z in r.zeros]


# --- between two poses ----------------------------------------------------------------------------------------------

translations = st.tuples(*[st.integers(-3, 3).map(lambda c: F(c, 7))] * 3)
quaternions = st.tuples(*[st.integers(-4, 4).map(F)] * 4).filter(any)
free_poses = st.builds(Pose, translations, quaternions)


def segment(moving: MovingPlatform, a: Pose, b: Pose) -> Segment:
    assume(sum(c * d for c, d in zip(a.quaternion, b.quaternion, strict=True)))
    (found,) = segments(moving, [a, b])
    return found


@settings(max_examples=30, deadline=None)
@given(a=free_poses, b=free_poses, s=st.fractions(0, 1, max_denominator=20))
def test_the_interpolation(robots: dict[str, Analysis], a: Pose, b: Pose, s: F) -> None:
    found = segment(rig_of(robots["platform-6-6"]), a, b)
    for place, end in ((F(0), a), (F(1), b)):
        assert found.pose(place).translation == end.translation
        assert np.allclose(np.array(found.pose(place).rotation, float), np.array(end.rotation, float), atol=1e-14)
    assert 0 <= found.motion.angles[0] < math.pi
    back = (a.quaternion[0], *(-c for c in a.quaternion[1:]))
    assert float(found.motion.angles[0]) == pytest.approx(
        Pose(quaternion=turn_product(b.quaternion, back)).angle, abs=1e-7
    )
    here = Pose(quaternion=turn_product(found.pose(s).quaternion, back))
    assert float(found.motion.turned(0, np.array([float(s)]))[0]) == pytest.approx(here.angle, abs=1e-7)


@settings(max_examples=30, deadline=None)
@given(
    name=st.sampled_from(PLATFORMS),
    a=free_poses,
    b=free_poses,
    about=st.sampled_from(["origin", "centroid", "1,-2,1/3"]),
)
def test_the_superbracket_is_a_polynomial_along_a_segment(
    robots: dict[str, Analysis], name: str, a: Pose, b: Pose, about: str
) -> None:
    moving = rig_of(robots[name], about)
    found = segment(moving, a, b)
    p = found.polynomial
    ratios = set()
    for s in (F(1, 3), F(2, 7), F(-5, 4), F(9, 11)):
        pose = found.pose(s)
        right = sum((c * s**n for n, c in enumerate(p)), F(0))
        try:
            left = superbracket_at(moving.structure.legs, moving.exact(pose)) * sum(c * c for c in pose.quaternion) ** 3
        except InputError:  # a leg of no length
            left = F(0)
        assert (left == 0) == (right == 0)
        ratios |= {left / right} if right else set()
    assert len(ratios) <= 1
    assert all(r > 0 for r in ratios)
    assert len(p) - 1 <= found.degree


def test_the_degree_is_reached(robots: dict[str, Analysis]) -> None:
    moving = rig_of(robots["platform-6-6"])
    poses = ["0.1 0.2 0.3; quaternion 4/5 0 3/5 0", "1 0 0.5; quaternion 2/3 2/3 1/3 0", "1 0 0.5", "1 2 3"]
    found = segments(moving, [parse_pose(p) for p in poses])
    assert [(len(s.polynomial) - 1, s.degree) for s in found] == [(9, 9), (6, 6), (3, 3)]


def test_a_half_turn_is_refused(robots: dict[str, Analysis]) -> None:
    with pytest.raises(InputError, match="from pose 1 to pose 2 the platform turns by exactly 180°"):
        gc.path(robots["octahedral"], ["0 0 0", "0 0 1", "0 0 1; euler zyx 180 0 0 deg"])


def test_the_sign_of_a_quaternion_does_not_matter(robots: dict[str, Analysis]) -> None:
    one, other = (
        gc.path(robots["octahedral"], ["0 0 0", f"0 0 -400; quaternion {q}"], samples=5)
        for q in ("0.6 0 0 0.8", "-0.6 0 0 -0.8")
    )
    assert zeros(one) == zeros(other)


# --- singular places ------------------------------------------------------------------------------------------------


def test_a_path_through_a_singular_pose(robots: dict[str, Analysis]) -> None:
    a = robots["octahedral-singular"]
    found = gc.path(a, ["-10 0 -20", "10 0 20"], samples=20)
    (zero,) = [z for z in found.zeros if z.lower == F(1, 2)]
    assert (zero.kind, zero.multiplicity, zero.exact) == ("crosses", 1, True)
    there = gc.pose(a, nearest=False)
    assert zero.causes == there.causes != ()
    assert zero.dependence == there.dependence
    assert found.verdict == "singular"
    at = found.parameters.tolist().index(0.5)
    assert found.numbers.value[at] == found.numbers.margin[at] == 0
    assert found.numbers.verdict[at] == "singular"


def tangent(a: Analysis) -> list[str]:
    """Two poses with the file's pose half way, along a tangent of the singular surface."""
    moving = rig_of(a)
    f = translation_polynomial(a.structure.legs, moving.exact(Pose()), a.structure.platform, F(100))
    x, y = (f.coefficients.get(e, F(0)) for e in ((1, 0, 0), (0, 1, 0)))
    size = max(abs(x), abs(y))
    along = [10 * y / size, -10 * x / size]
    return [f"{sign * along[0]} {sign * along[1]} 0" for sign in (-1, 1)]


def test_a_path_that_touches_the_singular_surface(robots: dict[str, Analysis]) -> None:
    a = robots["octahedral-singular"]
    poses = [Pose((F(x), F(y), F(z))) for x, y, z in (p.split() for p in tangent(a))]
    found = gc.path(a, poses, samples=7)
    assert zeros(found) == [(F(1, 2), "touches", 2)]
    assert (found.numbers.value[found.numbers.margin > 0] > 0).all() or (found.numbers.value <= 0).all()
    assert "touches: the superbracket keeps its sign, a zero of multiplicity 2" in found.text()


LOW = "0 0 -350"


@pytest.mark.parametrize(
    ("poses", "expected", "whole"),
    [
        (["0 0 0", LOW, "0 0 0"], [(F(1), "touches", 1)], []),
        (["0 0 0", LOW, "0 0 -352"], [(F(1), "crosses", 1)], []),
        (["0 0 0", "0 0 -700"], [(F(1, 2), "crosses", 1), (0.505368, "crosses", 1), (0.584269, "crosses", 1)], []),
        (["0 0 0", LOW], [(F(1), "ends", 1)], []),
        ([LOW, "0 0 0"], [(F(0), "starts", 1)], []),
        (["0 0 0", "0 0 -100", "0 0 0"], [], []),
        ([LOW, "50 20 -350"], [], [(0, 1)]),
        (["0 0 0", LOW, "50 20 -350", LOW, "0 0 0"], [], [(1, 3)]),
        (["0 0 0", LOW, LOW, "0 0 -352"], [], [(1, 2)]),
        (["0 0 0", "0 0 0", "10 0 0"], [], []),
    ],
    ids=lambda v: " → ".join(v) if isinstance(v, list) and v and isinstance(v[0], str) else "",
)
def test_kinds_of_places(robots: dict[str, Analysis], poses: list[str], expected: Any, whole: Any) -> None:
    found = gc.path(robots["octahedral"], poses, samples=4 * len(poses))
    assert zeros(found) == expected
    assert [(s.start, s.end) for s in found.stretches] == whole
    assert (found.verdict == "singular") == bool(expected or whole)
    assert all(s.causes for s in found.stretches)
    assert json.loads(json.dumps(found.to_json()))["verdict"] == found.verdict
    ElementTree.fromstring(found.plot().svg())


def test_places_where_segments_meet() -> None:
    up, down = [-1, 1], [1, -1]  # zero at 1
    assert [(p.kind, p.multiplicity) for p in places([up, [0, 1]])] == [("crosses", 1)]
    assert [(p.kind, p.multiplicity) for p in places([up, [0, -1]])] == [("touches", 1)]
    assert [(p.kind, p.multiplicity) for p in places([down, [0, 0, 1]])] == [("touches", 1)]
    assert [p.kind for p in places([up, [], [0, 1], [-1, 0, 1]])] == ["ends"]
    assert stretches([[], [], [1], []]) == (Stretch(0, 2), Stretch(3, 4))


def test_a_robot_that_is_always_singular() -> None:
    found = gc.path(parse_platform(ALWAYS), ["0 0 0", "1 2 3; euler zyx 10 0 0 deg"], samples=5)
    (stretch,) = found.stretches
    assert stretch == Stretch(0, 1, stretch.causes, stretch.dependence)
    assert stretch.dependence is not None
    assert "Gained motion" in found.text()
    assert found.degrees == (-1,)
    assert found.verdict == "singular"
    assert "zero polynomial" in found.text()


def test_the_lower_curve_has_the_sign_of_the_superbracket(robots: dict[str, Analysis]) -> None:
    platform: Any = robots["octahedral"].platform
    turned = replace(platform, legs=(platform.legs[0][::-1], *platform.legs[1:]))
    for robot in (platform, turned):
        found = gc.path(robot, ["0 0 0", "5 5 -500; euler zyx 40 0 0 deg"], samples=50)
        assert (np.sign(_determinant(found)) == np.sign(found.numbers.value)).all()


def test_two_zeros_between_samples(robots: dict[str, Analysis]) -> None:
    found = gc.path(robots["octahedral"], ["0 0 0", "0 0 -500; euler zyx 40 0 0 deg"], samples=1, about="origin")
    assert [round(z.parameter, 4) for z in found.zeros] == [0.6998, 0.7, 0.826]
    assert all(z.causes and z.dependence is not None for z in found.zeros)


def test_a_leg_may_lose_its_length_on_the_way(robots: dict[str, Analysis]) -> None:
    found = gc.path(robots["octahedral"], ["0 0 0", "-300 -400 -700"], samples=8)  # b goes through a half way
    half = [z for z in found.zeros if z.lower == F(1, 2)]
    assert [(z.causes, z.dependence) for z in half] == [(("The leg ab has no length.",), None)]
    assert 0.5 not in found.parameters
    assert "The leg ab has no length." in found.text()


@settings(max_examples=25, deadline=None)
@given(name=st.sampled_from(PLATFORMS), a=free_poses, b=free_poses)
def test_no_change_of_sign_is_missed(robots: dict[str, Analysis], name: str, a: Pose, b: Pose) -> None:
    """The number of zeros, with multiplicity, between two exact samples is even exactly when their signs agree."""
    moving = rig_of(robots[name], "centroid")
    size = F(str(round(moving.size, 3)))
    a, b = (Pose(tuple(c * size for c in p.translation), p.quaternion) for p in (a, b))
    found = segment(moving, a, b)
    assume(found.polynomial)
    listed = places([found.polynomial])
    signs = []
    for s in (F(k, 40) for k in range(41)):
        try:
            value = superbracket_at(moving.structure.legs, moving.exact(found.pose(s)))
        except InputError:
            value = F(0)
        assert (value == 0) == any(p.lower == s == p.upper for p in listed)
        if value:
            signs.append((s, value > 0))
    for (s, before), (t, after) in pairwise(signs):
        assert sum(p.multiplicity for p in listed if s < p.middle < t) % 2 == (before != after)


# --- the least margin --------------------------------------------------------------------------------------------


near_poses = st.builds(lambda t, q: Pose(t, (F(20), *q)), translations, st.tuples(*[st.integers(-4, 4).map(F)] * 3))


@settings(max_examples=20, deadline=None)
@given(name=st.sampled_from(PLATFORMS), a=near_poses, b=near_poses, samples=st.sampled_from([1, 10]))
def test_the_margin_is_nowhere_below_its_bound(
    robots: dict[str, Analysis], name: str, a: Pose, b: Pose, samples: int
) -> None:
    moving = rig_of(robots[name])
    size = F(str(round(moving.size, 3))) / 3
    a, b = (Pose(tuple(c * size for c in p.translation), p.quaternion) for p in (a, b))
    report = gc.path(robots[name], [a, b], samples=samples)
    if report.zeros or report.stretches:
        assert report.least.margin == report.least.bound == 0
        return
    shift, turn = segment(moving, a, b).motion.arrays(0, np.linspace(0, 1, 500))
    sigma = gc.pose(robots[name], shift, quaternion=turn / np.linalg.norm(turn, axis=1, keepdims=True)).margin
    assert report.least.bound <= sigma.min() + 1e-12
    assert report.least.margin <= sigma.min() * 1.02 + 1e-9
    if report.least.margin > 1e-3:
        assert report.least.bound >= 0.98 * report.least.margin


@pytest.mark.parametrize("power", [-36, 36])
def test_sizes_of_robots(robots: dict[str, Analysis], power: int) -> None:
    """The superbracket overflows floats, or underflows; the zeros, the table and the picture are the same."""
    small: Any = robots["octahedral"].platform
    size = F(10) ** power
    points = {n: tuple(c * size for c in p) for n, p in small.points.items()}
    ways = [[Pose((F(0), F(0), z * unit)) for z in (0, -300, -700)] for unit in (1, size)]
    one, other = (
        gc.path(robot, way, samples=10) for robot, way in zip((small, replace(small, points=points)), ways, strict=True)
    )
    assert zeros(other) == zeros(one)
    assert np.allclose(other.numbers.margin, one.numbers.margin, atol=1e-9)
    json.dumps(other.to_json(), allow_nan=False)
    assert other.plot().svg() == one.plot().svg()
    assert len(other.csv()) > 0


@pytest.mark.parametrize(
    ("poses", "threshold", "verdict"),
    [
        (["0 0 0", "0 0 -300"], "0.5 deg", "regular"),
        (["0 0 0", "0 0 -300"], "20 deg", "close"),
        (["0 0 0", "0 0 -349.9"], "0.5 deg", "close"),
        (["0 0 0", "0 0 -350"], "0.5 deg", "singular"),
        (["0 0 0", "0 0 -349.9999999999999"], "0.5 deg", "singular"),  # within rounding
    ],
    ids=str,
)
def test_verdicts(robots: dict[str, Analysis], poses: list[str], threshold: str, verdict: str) -> None:
    found = gc.path(robots["octahedral"], poses, threshold=threshold, samples=20)
    assert found.verdict == verdict
    assert repr(found).startswith(f"<PathReport {verdict}")


# --- tables ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x,y,z\n1,2,1/3\n", "1 2 1/3"),
        ("z [mm]; x ;y\n3;1;2\n", "1 2 3"),
        ("x\ty\tz\n1\t2\t3\n", "1 2 3"),
        ("\ufeff# a comment\n\nx,y,z\n\n1,2,3\n".lstrip("\ufeff"), "1 2 3"),
        ("x,y,z,qw,qx,qy,qz\n1,2,3,0.6,0,0,0.8\r\n", "1 2 3; quaternion 0.6 0 0 0.8"),
        ("qx,qy,qz,qw\n0,0,.8,.6", "0 0 0; quaternion 0.6 0 0 0.8"),
        ("x,y,z,rx [deg],ry [deg],rz [deg]\n0,0,1,0,90,0", "0 0 1; rotvec 0 90 0 deg"),
        ("x,y,z,rx [rad],ry [rad],rz [rad]\n0,0,1,0,0.5,0.1", "0 0 1; rotvec 0 0.5 0.1 rad"),
        ("x,y,z,ZXZ1 [deg],ZXZ2 [deg],ZXZ3 [deg]\n0,0,1,10,20,30", "0 0 1; euler ZXZ 10 20 30 deg"),
        ('"x","y","z"\n"1","2","3"\n', "1 2 3"),
    ],
    ids=repr,
)
def test_tables(text: str, expected: str) -> None:
    poses, notes = read_poses(text, "mm")
    assert (poses, notes) == ((parse_pose(expected, "mm"),), ())


@pytest.mark.parametrize(
    ("text", "place", "says"),
    [
        ("", "", "the file is empty"),
        ("# nothing\n\n", "", "the file is empty"),
        ("x,y,z\n", "", "no poses below"),
        ("1,2,3\n4,5,6\n", ":1:1", "names no columns"),
        ("x,y\n1,2\n", ":1:1", "the column z missing"),
        ("x,y,z,qw,qx\n1,2,3,1,0\n", ":1:1", "the columns qy, qz missing"),
        ("x,y,z,x\n1,2,3,4\n", ":1:7", "a second column x"),
        ("x,y,z\n1,2\n", ":2:1", "2 values in this line, but 3 columns"),
        ("x,y,z\n1,2,3\n1,2,3,4\n", ":3:1", "4 values in this line, but 3 columns"),
        ("x,y,z\n1,2,nan\n", ":2:5", "expected a finite number"),
        ("x,y,z\n1, inf,0\n", ":2:4", "expected a finite number"),
        ("x,y,z\n1,,0\n", ":2:3", "a value is missing"),
        ("# c\nx,y,z\n1,two,0\n", ":3:3", "expected a number"),
        ("x [m],y,z\n1,2,3\n", ":1:1", "mixed units: m here"),
        ("x [mile],y,z\n1,2,3\n", ":1:1", "not a unit of length"),
        ("x,y,z,rx,ry,rz\n1,2,3,0,0,0\n", ":1:7", "angles without a unit"),
        ("x,y,z,rx [deg],ry [rad],rz [deg]\n1,2,3,0,0,0\n", ":1:7", "deg and rad"),
        ("x,y,z,zzx1 [deg],zzx2 [deg],zzx3 [deg]\n1,2,3,0,0,0\n", ":1:7", "not a sequence"),
        ("x,y,z,qw,qx,qy,qz,rx [deg]\n1,2,3,1,0,0,0,0\n", ":1:19", "several kinds of turns"),
        ("x,y,z,qw,qx,qy,qz\n1,2,3,1,1,0,0\n", ":2:7", "has length 1.41421"),
        ("x,y,z,qw,qx,qy,qz\n1,2,3,0,0,0,0\n", ":2:7", "has length 0"),
    ],
    ids=repr,
)
def test_tables_at_fault(text: str, place: str, says: str) -> None:
    with pytest.raises(GcrulesError, match=says.replace("(", r"\(")) as fault:
        read_poses(text, "mm", "way.csv")
    assert str(fault.value).startswith(f"way.csv{place}: ")


def test_notes_of_tables() -> None:
    text = "time,x,y,z,qw,qx,qy,qz\n" + "0,0,0,0,1.0001,0,0,0\n" * 2
    assert read_poses(text)[1] == ("columns left out: time", "quaternions normalised: 2")


@pytest.mark.parametrize(
    ("column", "meant"), [("Yaw [deg]", "yaw [deg]"), ("rx_deg", "rx [deg]"), ("Zyx1", "zyx1 [deg]"), ("QW", "qw")]
)
def test_a_column_that_resembles_one_of_a_pose_is_no_other_column(column: str, meant: str) -> None:
    with pytest.raises(InputError, match="is not recognised, and a pose would lack") as fault:
        read_poses(f"x,y,z,{column}\n0,0,0,0\n0,0,0,90\n")
    assert f"did you mean {meant}?" in fault.value.render()


@pytest.mark.parametrize("poses", [None, 5, 2.5])
def test_what_is_no_path(robots: dict[str, Analysis], poses: Any) -> None:
    with pytest.raises(InputError, match="`poses` must be the name of a table, or a sequence of poses"):
        gc.path(robots["octahedral"], poses)


def test_sizes_of_tables(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(path_file, "MAX_POSES", 3)
    with pytest.raises(LimitReached, match="4 poses are more than 3"):
        read_poses("x,y,z\n" + "0,0,0\n" * 4)
    monkeypatch.setattr(path_file, "MAX_BYTES", 10)
    (tmp_path / "long.csv").write_text("x,y,z\n1,2,3\n")
    with pytest.raises(GcrulesError, match="larger than 10 bytes"):
        path_file.load_poses(str(tmp_path / "long.csv"))
    (tmp_path / "bytes.csv").write_bytes(b"\xff\xfe\n")
    with pytest.raises(GcrulesError, match="UTF-8"):
        path_file.load_poses(str(tmp_path / "bytes.csv"))


@pytest.mark.parametrize("name", ["octahedral", "platform-6-6"])
def test_values_are_read_back(robots: dict[str, Analysis], name: str, tmp_path: Path) -> None:
    first = gc.path(robots[name], ["0 0 0", "0 0 -0.3; euler zyx 40 10 0 deg"], samples=10)
    (tmp_path / "values.csv").write_text(first.csv())
    again = gc.path(robots[name], tmp_path / "values.csv", samples=1)
    assert len(again.poses) == len(first)
    given_poses = np.isin(again.parameters, np.arange(len(first)))
    assert np.allclose(again.numbers.margin[given_poses], first.numbers.margin, atol=1e-9)
    table = [line.split(",") for line in first.csv().splitlines()]
    assert len({len(row) for row in table}) == 1
    assert [float(row[table[0].index("margin")]) for row in table[1:]] == first.numbers.margin.tolist()


# --- the command ----------------------------------------------------------------------------------------------------


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, ["path", *arguments], input=text)


WAY = ("--at", "0 0 0", "--at", "0 0 -400; euler zyx 20 0 0 deg", "--samples", "20")


def test_the_command_writes_values_and_a_picture(robot: str, tmp_path: Path) -> None:
    values, svg, pdf = (str(tmp_path / n) for n in ("v.csv", "p.svg", "p.pdf"))
    done = run(robot, *WAY, "--csv", values, "--plot", svg, "--json")
    assert done.exit_code == 0, done.output
    answer = json.loads(done.stdout)
    assert answer["verdict"] == "singular"
    assert len(answer["samples"]["margin"]) == len(Path(values).read_text().splitlines()) - 1
    picture = Path(svg).read_text()
    assert "margin" in picture
    assert "crosses" in picture
    ElementTree.fromstring(picture)
    pytest.importorskip("matplotlib")
    assert run(robot, *WAY, "--plot", pdf).exit_code == 0
    assert Path(pdf).read_bytes().startswith(b"%PDF")
    assert {p.name for p in tmp_path.iterdir()} == {"v.csv", "p.svg", "p.pdf"}


def test_an_interrupt_leaves_nothing_behind(robot: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any, **__: Any) -> None:
        report("segment 3 of 7")
        raise KeyboardInterrupt

    monkeypatch.setattr(path_command, "along", interrupted)
    done = run(robot, *WAY, "--csv", str(tmp_path / "v.csv"), "--plot", str(tmp_path / "p.svg"))
    assert (done.exit_code, done.stdout) == (130, "")
    assert done.stderr == "interrupted while computing: segment 3 of 7; nothing was written\n"
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["--csv", "--plot", "-o"])
def test_a_missing_directory_is_told_before_the_work(robot: str, option: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(path_command, "along", None)
    done = run(robot, *WAY, option, "/nowhere/at/all.svg")
    assert done.exit_code == 2
    assert "/nowhere/at/all.svg: cannot be written: there is no such directory" in done.stderr


def test_forms_of_the_answer(robot: str) -> None:
    done = run(robot, *WAY, "--ascii")
    assert done.stdout.isascii()
    assert run(robot, *WAY, "--csv", "-").stdout.startswith("parameter,x [mm],")
    with open(robot, encoding="utf-8") as file:
        assert run("-", *WAY, "--ascii", text=file.read()).stdout == done.stdout


def test_the_example_of_a_table(robot: str, root: Any) -> None:
    done = run(robot, "--poses", str(root / "examples" / "path.csv"), "--samples", "30", "--json")
    answer = json.loads(done.stdout)
    assert [z["kind"] for z in answer["zeros"]] == ["crosses"] * 4
    assert answer["polynomial_degrees"] == [9, 9, 9]


@pytest.mark.parametrize(
    ("arguments", "code", "says"),
    [
        ((), 2, "either by --poses"),
        (("--at", "0 0 0"), 2, "two poses or more, found 1"),
        (("--at", "0 0 0", "--poses", "x.csv"), 2, "either by --poses"),
        (("--poses", "no-such.csv"), 2, "no-such.csv: there is no such file"),
        (("--at", "0 0 0", "--at", "0 0 nan"), 2, "--at:1:1"),
        (("--at", "0 0 0", "--at", "0 0 1; euler zyx 1 2 3"), 2, "angles without a unit"),
        (("--at", "0 0 0", "--at", "0 0 1 m"), 2, "mixed units"),
        (("--at", "0 0 0", "--at", "0 0 1e30"), 2, "times the robot's size away"),
        (("--at", "0 0 0", "--at", "-150 -200 -350"), 2, "has no length in pose 1"),
        ((*WAY, "--samples", "0"), 2, "number of samples"),
        ((*WAY, "--samples", "10000000"), 3, "samples are more than"),
        ((*WAY, "--threshold", "2"), 2, "without a unit"),
        ((*WAY, "--threshold", "2 mm"), 2, "the threshold is an angle"),
        ((*WAY, "--about", "middle"), 2, "not a centre"),
        ((*WAY, "--plot", "way.png"), 2, "is not a figure format"),
        ((*WAY, "--plot", "no/such/dir/way.svg"), 2, "cannot be written"),
        ((*WAY, "--csv", "no/such/dir/way.csv"), 2, "no such directory"),
    ],
    ids=str,
)
def test_the_command_tells_faults(robot: str, arguments: tuple[str, ...], code: int, says: str) -> None:
    assert_refused(run(robot, *arguments), code, says)


@pytest.mark.parametrize(
    ("poses", "options", "says"),
    [
        ([], {}, "found 0"),
        ([(0, 0, 0), (0, 0)], {}, "pose 1: the translation has 3 numbers"),
        ([(0, 0, 0), (0, 0, math.nan)], {}, "pose 1: the translation is nan"),
        ([(0, 0, 0), [[1, 2, 3]]], {}, "pose 1 is not a pose"),
        ([(0, 0, 0), (0, 0, 1)], {"samples": 2.5}, "`samples` must be a whole number"),
        ([(0, 0, 0), (0, 0, 1)], {"threshold": 2}, "has no unit"),
        ([(0, 0, 0), (0, 0, 1)], {"about": (1, 2)}, "the centre has 3 numbers"),
    ],
    ids=str,
)
def test_python_tells_faults(robots: dict[str, Analysis], poses: Any, options: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        gc.path(robots["octahedral"], poses, **options)


def test_an_analysis_without_coordinates() -> None:
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        gc.path(gc.analyze("ab af cb cd ed ef"), ["0 0 0", "0 0 1"])
