"""Aspects: ways are looked at in samples of their own, signs and lengths by the points of the legs alone."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.aspects.report import Aspects
from gcrules.poses.plans.domain import Proved
from gcrules.poses.plans.limb_domain import LimbDomain
from gcrules.poses.plans.report import Waypoint
from gcrules.screws.pose import Pose
from gcrules.views.drawing.drawing import Circle, Text

FOUR_DOF = EXAMPLES / "four-dof.yaml"
OCTAHEDRAL = EXAMPLES / "octahedral.yaml"
TURN = "x -1..1, y -1..1, yaw -180..180 deg"


@pytest.fixture(scope="module")
def octahedral() -> Aspects:
    return gc.aspects(OCTAHEDRAL, poses=12)


def ends(pose: Pose) -> np.ndarray:
    """The points of the legs on the platform, (6, 3), by a rotation of our own."""
    rig = mechanism(OCTAHEDRAL).six_legs().rig
    w, *v = pose.unit_quaternion
    x, y, z = v
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(3) + 2 * w * cross + 2 * cross @ cross
    return np.asarray(rig.arms @ turn.T + rig.centre_of_turns + np.array([float(c) for c in pose.translation]))


def determinant(pose: Pose) -> float:
    rig = mechanism(OCTAHEDRAL).six_legs().rig
    along = ends(pose) - rig.base
    return float(np.linalg.det(np.hstack([along, np.cross(rig.base, along)])))


def test_an_octahedral_platform_has_two(octahedral: Aspects) -> None:
    assert (octahedral.least, octahedral.most, octahedral.decided) == (2, 2, True)
    assert [s.modes for s in octahedral.sets] == [(1, 4, 5, 8), (2, 3, 6, 7)]
    assert sorted(n for s in octahedral.sets for n in s.poses) == list(range(len(octahedral.poses)))


def test_signs_are_those_of_the_determinant(octahedral: Aspects) -> None:
    signs = [{np.sign(determinant(octahedral.poses[n])) for n in s.poses} for s in octahedral.sets]
    assert sorted(map(len, signs)) == [1, 1]
    assert signs[0] != signs[1]


def test_assembly_modes_are_joined_by_a_way_without_a_singularity(octahedral: Aspects) -> None:
    assert octahedral.modes is not None
    rig = mechanism(OCTAHEDRAL).six_legs().rig
    poses = [p for p in octahedral.poses if isinstance(p, Pose)]
    own = octahedral.sets[0]
    home, *others = (n for n in own.poses if octahedral.modes[0].pose == poses[n] or _mode(octahedral, n))
    assert len(others) == 3
    for other in others:
        lengths = [np.linalg.norm(ends(poses[n]) - rig.base, axis=1) for n in (home, other)]
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-9)
        way = [p for p in octahedral.way(home, other) if isinstance(p, Pose)]
        assert (way[0], way[-1]) == (poses[home], poses[other])
        path = gc.path(OCTAHEDRAL, way, samples=20 * len(way))
        assert not path.zeros
        assert path.least.bound >= octahedral.asked
        signs = {np.sign(determinant(p)) for p in way}
        assert len(signs) == 1


def _mode(found: Aspects, n: int) -> bool:
    assert found.modes is not None
    return any(found.poses[n] == m.pose for m in found.modes.modes)


def test_ways_lead_from_each_pose_of_a_set_to_each(octahedral: Aspects) -> None:
    for own in octahedral.sets:
        first = own.poses[0]
        assert all(octahedral.way(first, n) for n in own.poses)
    one, other = (s.poses[0] for s in octahedral.sets)
    assert octahedral.way(one, other) == ()


def test_joins_are_chained(octahedral: Aspects) -> None:
    for join in octahedral.joins:
        assert join.poses[0] == octahedral.poses[join.one]
        assert join.poses[-1] == octahedral.poses[join.other]
        assert join.least >= octahedral.asked
        assert all(a != b for a, b in pairwise(join.poses))


def test_three_brackets_have_eight_patterns() -> None:
    found = gc.aspects(FOUR_DOF, poses=10)
    assert found.least == 8
    assert found.decided
    assert [s.modes for s in found.sets if s.modes] == [(n,) for n in range(1, 9)]


def test_a_planar_robot_has_two() -> None:
    found = gc.aspects("3-rpr", within=TURN, poses=12)
    assert (found.least, found.most) == (2, 2)
    assert [s.modes for s in found.sets] == [(1,), (2,)]
    assert not found.changes
    assert found.cuspidal is None


def test_ways_of_a_robot_of_joints_keep_their_branch() -> None:
    found = gc.aspects("3-rps", poses=6, modes=False, within="z -1..0.5, roll -60..60 deg, pitch -60..60 deg")
    for join in found.joins[:4]:
        path = gc.path("3-rps", list(join.poses), samples=20)
        assert path.verdict != "singular"
        assert not path.crossings
        assert path.branch_doubt is None


def test_angles_go_on_beyond_half_a_turn() -> None:
    """Poses on both sides of yaw = 180° are joined on the short way."""
    found = gc.aspects("3-rpr", within=TURN, poses=30, modes=False)
    yaws = [np.array([dict(p)["yaw"] for p in join.poses]) for join in found.joins]
    assert max(np.abs(np.diff(y)).max() for y in yaws) <= np.pi + 1e-9


@pytest.mark.parametrize("doubted", [True, False], ids=["all", "those of one piece"])
def test_ways_whose_margin_is_not_proved_join_what_nothing_else_does(
    monkeypatch: pytest.MonkeyPatch, *, doubted: bool
) -> None:
    """All ways, or the straight ones, are taken for ways of which no margin is proved."""
    whole = LimbDomain.prove

    def doubting(self: LimbDomain, way: Sequence[Waypoint], samples: int | None = None) -> Proved:
        found = whole(self, way, samples)
        doubts = tuple(range(len(way) - 1)) if doubted or len(way) == 2 else ()
        return replace(found, doubts=doubts, margin_proved=False) if doubts else found

    plain = gc.aspects("3-rpr", within=TURN, poses=3, modes=False)
    monkeypatch.setattr(LimbDomain, "prove", doubting)
    monkeypatch.setattr("gcrules.poses.aspects.joining._ROUNDS", 2)
    found = gc.aspects("3-rpr", within=TURN, poses=3, modes=False)
    assert [s.poses for s in found.sets] == [s.poses for s in plain.sets]
    assert len(found.joins) == len(found.poses) - len(found.sets)
    assert plain.proved
    assert {j.proved for j in found.joins} == {False} if doubted else any(j.proved for j in found.joins)


def test_limits_leave_modes_out() -> None:
    found = gc.aspects(OCTAHEDRAL, poses=2, within="z -100..100")
    assert {one.reason for one in found.left_out} == {"outside the region or the limits"}


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"poses": 0}, "whole number"),
        ({"poses": 9, "states": 3}, "9 poses"),
        ({"poses": 1, "states": 1}, "2 poses are more"),
        ({"margin": 2.0}, "between 0 and 1"),
        ({"seed": -1}, "negative"),
        ({"within": "q 0..1"}, "not a coordinate"),
        ({"limits": "leg lengths 1..2"}, "no pose was found that"),
    ],
)
def test_wrong_questions(options: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        gc.aspects(OCTAHEDRAL, modes=False, **options)


def test_the_picture_has_each_pose_in_the_colour_of_its_set(octahedral: Aspects) -> None:
    """And each assembly mode with its number, at one of the poses of its set."""
    drawn = octahedral.picture()
    assert octahedral._repr_svg_() == drawn.svg()
    circles = [s for s in drawn.shapes if isinstance(s, Circle)]
    for n, one in enumerate(octahedral.sets):
        own = [s.center for s in circles if s.fill == f"entity{n + 1}"]
        assert len(own) == len(one.poses) + 1  # one in the key
        rings = [s.center for s in circles if s.stroke == f"entity{n + 1}"]
        assert len(rings) == len(one.modes)
        assert set(rings) <= set(own)
    said = ["".join(run.text for run in s.runs) for s in drawn.shapes if isinstance(s, Text)]
    assert set("12345678") <= set(said)
    assert f"set A, signs −: {len(octahedral.sets[0].poses)} poses, assembly modes 1, 4, 5 and 8" in said


def test_the_command_writes_the_picture(tmp_path: Path) -> None:
    file = tmp_path / "aspects.svg"
    options = ["--within", TURN, "--poses", "6"]
    assert invoke("aspects", "3-rpr", *options, "--picture", str(file)).exit_code in (0, 3)
    same = gc.aspects("3-rpr", within=TURN, poses=6)
    assert file.read_text(encoding="utf-8") == same.picture().svg()
    with pytest.raises(InputError, match="fewer than two coordinates"):
        replace(same, poses=same.poses[:1] * len(same.poses)).picture()


def test_the_command() -> None:
    shown = invoke("aspects", str(OCTAHEDRAL), "--poses", "12", "--no-modes", "--json")
    assert shown.exit_code == 0
    assert json.loads(shown.stdout)["least"] == 2
    words = invoke("aspects", "3-rpr", "--poses", "3", "--within", TURN)
    assert words.exit_code == 0
    assert "aspect" in words.stdout


def test_a_singular_home_is_left_out() -> None:
    found = gc.aspects(EXAMPLES / "octahedral-singular.yaml", poses=2, modes=False)
    assert [one.pose for one in found.left_out] == ["home"]
    assert "left out  home: singular, or too close to it" in found.text()
