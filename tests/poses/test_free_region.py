"""Free regions: no singular pose in them by determinants of our own, none larger than the nearest one that is known."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.numbers.arrays import from_vectors
from gcrules.poses.regions.extent import parse_extents
from gcrules.poses.regions.report import FreeRegion
from gcrules.screws.pose import Pose
from gcrules.views.drawing.drawing import Polygon, Text

OCTAHEDRAL = EXAMPLES / "octahedral.yaml"


def determinants(found: FreeRegion, number: int = 4000) -> np.ndarray:
    """Of the octahedral platform, at poses of the region at random, many of them at its corners."""
    rig = mechanism(OCTAHEDRAL).six_legs().rig
    random = np.random.default_rng(2)
    parts = np.clip(random.uniform(-1.6, 1.6, (number, len(found.names))), -1, 1)
    if found.shape == "ball":
        parts /= np.maximum(np.linalg.norm(parts, axis=1, keepdims=True), 1.0)
    whole = np.zeros((number, 6))
    places = [("x", "y", "z", "rx", "ry", "rz").index(n) for n in found.names]
    whole[:, places] = parts * found.scale * np.array(found.weights)
    w, *v = from_vectors(whole[:, 3:]).T
    x, y, z = v
    zero = np.zeros(number)
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    turn = np.eye(3) + 2 * w[:, None, None] * cross + 2 * cross @ cross
    ends = np.einsum("nij,kj->nki", turn, rig.arms) + rig.centre_of_turns + whole[:, None, :3]
    along = ends - rig.base
    return np.asarray(np.linalg.det(np.concatenate([along, np.cross(rig.base, along)], axis=2)))


@pytest.mark.parametrize("over", ["x, y, z", "rx, ry, rz", "rz", "x 3, rz 60 deg", None])
@pytest.mark.parametrize("ball", [False, True], ids=["box", "ball"])
def test_the_determinant_keeps_its_sign(over: str | None, ball: bool) -> None:
    found = gc.free_region(OCTAHEDRAL, over=over, ball=ball)
    assert found.scale > 0.05
    assert len(set(np.sign(determinants(found)))) == 1


def test_no_ball_is_larger_than_the_nearest_singular_pose() -> None:
    found = gc.free_region(OCTAHEDRAL, over="x, y, z", ball=True)
    nearest = gc.pose(OCTAHEDRAL).nearest[0]
    assert 0.95 * nearest.distance <= found.half_widths[0] <= nearest.distance


def test_one_coordinate_ends_at_its_first_singular_pose() -> None:
    found = gc.free_region(OCTAHEDRAL, over="z")
    low, high = found.ranges["z"]
    assert -350 < low < -340
    assert high == -low
    assert found.tried is not None
    assert not gc.path(OCTAHEDRAL, [f"0 0 {low}", f"0 0 {high}"]).zeros
    assert gc.path(OCTAHEDRAL, ["home", f"0 0 {low * found.tried / found.scale * 1.01}"]).zeros


@pytest.mark.parametrize("robot", ["3-rpr", "3-rps", "delta"])
def test_corners_of_a_robot_of_joints_are_regular(robot: str) -> None:
    found = gc.free_region(robot, boxes=400)
    for corner in np.stack(np.meshgrid(*[(-1, 1)] * len(found.names)), axis=-1).reshape(-1, len(found.names)):
        pose = dict(zip(found.names, (corner * found.half_widths).tolist(), strict=True))
        path = gc.path(robot, ["home", pose], samples=10)
        assert not path.crossings
        assert path.margins.min() > 0


@pytest.mark.parametrize("robot", ["3-rpr", "delta", "3-rps"])
def test_actuators_within_their_ranges_keep_it_regular(robot: str) -> None:
    found = gc.free_region(robot, over="actuators", boxes=400)
    assert found.driven
    random = np.random.default_rng(4)
    for parts in random.choice([-1.0, 1.0], (6, len(found.names))):
        amounts = dict(zip(found.names, (parts * found.half_widths).tolist(), strict=True))
        there = gc.pose(robot, actuators=amounts, nearest=False)
        assert there.verdict == "regular"
        assert there.assembly.same is True


def test_around_another_pose() -> None:
    found = gc.free_region(OCTAHEDRAL, "0 0 -300", over="z")
    assert 45 < found.half_widths[0] < 50
    of_joints = gc.free_region("3-rps", "z=0.1, roll=10deg, pitch=0deg", over="z", boxes=200)
    low, high = of_joints.ranges["z"]
    assert (low + high) / 2 == pytest.approx(0.1)
    assert of_joints.ranges["roll"] == pytest.approx((np.radians(10), np.radians(10)))


def test_more_boxes_prove_more() -> None:
    few, many = (gc.free_region("3-rpr", boxes=n).scale for n in (50, 800))
    assert few < many


def test_ranges_are_rounded_to_the_inside() -> None:
    found = gc.free_region(OCTAHEDRAL, over="x, rz")
    shown = [line.split() for line in found.text().splitlines() if "<=" in line]
    for (name, (low, high)), line in zip(found.ranges.items(), shown, strict=True):
        scale = np.degrees(1) if name == "rz" else 1.0
        assert low * scale <= float(line[0]) < float(line[4]) <= high * scale


def test_extents() -> None:
    kinds = {"x": False, "rz": True}
    assert [e.width for e in parse_extents("x, rz", kinds, 3.0, "mm")] == [3.0, 1.0]
    assert [e.width for e in parse_extents("x 2 mm, rz 0.5 rad", kinds, 3.0, "mm")] == [2.0, 0.5]


@pytest.mark.parametrize(
    ("source", "options", "words"),
    [
        (OCTAHEDRAL, {"over": "w"}, "'w' is not a coordinate"),
        (OCTAHEDRAL, {"over": "x, x"}, "x is named twice"),
        (OCTAHEDRAL, {"over": "rz 30"}, "an angle without a unit"),
        (OCTAHEDRAL, {"over": "x -1"}, "expected one above 0"),
        (OCTAHEDRAL, {"over": ","}, "no coordinate is named"),
        (OCTAHEDRAL, {"over": "x 1 inch"}, "inch"),
        (OCTAHEDRAL, {"over": "actuators"}, "described by their joints"),
        (OCTAHEDRAL, {"boxes": 10**9}, "boxes"),
        (EXAMPLES / "octahedral-singular.yaml", {}, "nothing is proved"),
        ("3-rps", {"over": "x"}, "x follows from the other coordinates"),
    ],
)
def test_wrong_questions(source: object, options: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        gc.free_region(source, **options)


def test_the_command() -> None:
    shown = invoke("free", str(OCTAHEDRAL), "--over", "x, rz 30 deg", "--at", "0 0 10")
    assert shown.exit_code == 0
    assert "Proved: no pose of this box around 0 0 10 is singular" in shown.stdout


def test_poses_of_legs_are_given_in_all_forms() -> None:
    by_text, by_value = (gc.free_region(OCTAHEDRAL, at, over="x") for at in ("0 0 5", Pose((0, 0, 5))))
    assert by_text.scale == by_value.scale


def test_the_picture_has_the_ranges_and_where_the_proof_ended(tmp_path: Path) -> None:
    """Bars on the axes of lengths and of angles; the marks are at the pose, each just outside its bar or at its end."""
    file = tmp_path / "free.svg"
    run = invoke("free", str(OCTAHEDRAL), "--over", "x 100, z 150, rz 30 deg", "--picture", str(file))
    assert run.exit_code == 0, run.output
    found = gc.free_region(OCTAHEDRAL, over="x 100, z 150, rz 30 deg")
    drawn = found.picture()
    assert file.read_text(encoding="utf-8") == drawn.svg() == found._repr_svg_()
    said = ["".join(run.text for run in s.runs) for s in drawn.shapes if isinstance(s, Text)]
    assert {"x", "z", "rz", "−200", "200", "mm", "deg"} <= set(said)
    assert f"free, proved for all values together, by {found.boxes} boxes" in said
    bars = [s for s in drawn.shapes if isinstance(s, Polygon) and s.fill == "entity1"][:3]
    marks = [s for s in drawn.shapes if isinstance(s, Polygon) and s.fill == "mark"][:3]
    widths = [bar.points[1][0] - bar.points[0][0] for bar in bars]
    assert widths[0] / widths[1] == pytest.approx(100 / 150)
    for bar, sign, name in zip(bars, marks, found.names, strict=False):
        left, right = bar.points[0][0], bar.points[1][0]
        middle = sum(x for x, _ in sign.points) / 4
        low, high = found.ranges[name]
        assert middle == pytest.approx(left + (found.worst[name] - low) / (high - low) * (right - left))


def test_the_picture_of_a_ball_says_so_and_leaves_out_what_is_fixed() -> None:
    found = gc.free_region("3-rps", over="roll, pitch", ball=True)
    said = ["".join(run.text for run in s.runs) for s in found.picture().shapes if isinstance(s, Text)]
    assert any(one.startswith("axes of the ball that is free, proved") for one in said)
    assert any("fixed: z = 0" in one for one in said)
    assert "z" not in said
