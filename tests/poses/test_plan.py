"""Plans: ways are checked at samples of their own, signs by the exact crossings of paths."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs.many import Solved
from gcrules.poses.limbs.pose_report import target_of
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.paths.lengths import keeps_to
from gcrules.poses.paths.segments import segments
from gcrules.poses.plans.limb_domain import limb_space
from gcrules.poses.signs.closing import closing_signs
from gcrules.poses.signs.sign import SEEN
from gcrules.screws.pose import Pose

FOUR_DOF = EXAMPLES / "four-dof.yaml"
OCTAHEDRAL = EXAMPLES / "octahedral.yaml"
AROUND = "-36.9 75 87.5; rotvec 85.27 -39.32 115.91 deg", "215.1 70.5 125.5; rotvec 2.3 -27.94 46.06 deg"


def test_a_straight_way() -> None:
    found = gc.plan(OCTAHEDRAL, "home", "0 0 -300")
    assert found.outcome == "way"
    assert len(found.poses) == 2
    assert found.path is not None
    assert found.path.verdict == "regular"
    assert found.length == pytest.approx(found.straight)


def test_a_way_around_a_singularity_keeps_its_margin() -> None:
    start, goal = AROUND
    straight = gc.path(OCTAHEDRAL, [start, goal])
    assert straight.zeros
    found = gc.plan(OCTAHEDRAL, start, goal, margin=0.02)
    assert found.outcome == "way"
    assert len(found.poses) > 2
    poses = [p for p in found.poses if isinstance(p, Pose)]
    samples = [
        gc.pose(OCTAHEDRAL, [_between(a, b, t) for t in np.linspace(0, 1, 25)]).margin.min() for a, b in pairwise(poses)
    ]
    assert min(samples) >= found.least >= 0.02


def _between(a: Pose, b: Pose, t: float) -> Pose:
    s = Fraction(t)
    p, q = np.array(a.unit_quaternion), np.array(b.unit_quaternion)
    q = q if p @ q > 0 else -q
    w, i, j, k = (Fraction(float(c)) for c in (1 - t) * p + t * q)
    x, y, z = (u + s * (v - u) for u, v in zip(a.translation, b.translation, strict=True))
    return Pose((x, y, z), (w, i, j, k))


def test_opposite_signs_exclude_a_way() -> None:
    found = gc.plan(OCTAHEDRAL, "home", "0 0 -490")
    assert found.outcome == "none"
    assert not found.poses
    assert [o.start * o.goal < 0 for o in found.opposed] == [True]
    assert len(gc.path(OCTAHEDRAL, ["home", "0 0 -490"]).zeros) % 2 == 1


def test_factors_exclude_a_way_where_the_superbracket_does_not() -> None:
    goal = "0.1 0.7 -0.4; rotvec 40 20 -60 deg"
    home, there = (gc.pose(FOUR_DOF, at, nearest=False) for at in ("home", goal))
    assert home.superbracket * there.superbracket > 0
    found = gc.plan(FOUR_DOF, "home", goal)
    assert found.outcome == "none"
    assert [o.expression for o in found.opposed] == ["[A2S1S2S3]", "[A3B3S1S3]"]
    assert "the tetrahedron A2 S1 S2 S3 is flat" in found.reason
    for over in ("0 0 0.5", "1 1 1; rotvec 0 50 0 deg", "-0.5 0.5 0.2; rotvec 30 0 90 deg"):
        assert len(gc.path(FOUR_DOF, ["home", over, goal]).zeros) >= 2


def test_start_and_goal_keep_to_the_limits() -> None:
    found = gc.plan(OCTAHEDRAL, "home", "100 0 0", limits="leg lengths 200..900")
    assert found.outcome == "way"
    assert found.search is not None
    assert found.search.limits
    with pytest.raises(InputError, match="the goal is not within the limits"):
        gc.plan(OCTAHEDRAL, "home", "0 0 -300", limits="leg lengths 300..900")


@pytest.mark.parametrize("seed", range(6))
def test_limits_hold_between_samples(seed: int) -> None:
    """Against lengths at many places: limits just outside of these are kept, others just inside of them are not."""
    random = np.random.default_rng(seed)
    m = mechanism(OCTAHEDRAL).six_legs()
    ends = [Pose(_three(random.uniform(-150, 150, 3)), _turn(random)) for _ in range(2)]
    (segment,) = segments(m.rig, ends)
    shift, quaternion = segment.motion.arrays(0, np.linspace(0, 1, 20_001))
    lengths = np.linalg.norm(m.rig.ends(shift, matrices(quaternion)) - m.rig.base, axis=2)
    low, high = lengths.min(axis=0), lengths.max(axis=0)
    assert keeps_to(LengthLimits(m.actuators, _six(low - 0.1), _six(high + 0.1)), segment)
    for leg in range(6):
        for limit, sign in ((low, 1), (high, -1)):
            inside = limit.copy()
            inside[leg] += 0.01 * sign
            bounds = (inside, high + 1) if sign > 0 else (low - 1, inside)
            assert not keeps_to(LengthLimits(m.actuators, *map(_six, bounds)), segment)


def _six(lengths: Any) -> tuple[float, ...]:
    return tuple(lengths.tolist())


def _three(numbers: Any) -> tuple[Fraction, Fraction, Fraction]:
    x, y, z = map(Fraction, numbers.tolist())
    return x, y, z


def _turn(random: np.random.Generator) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    return (Fraction(1), *_three(random.uniform(-0.5, 0.5, 3)))


@pytest.mark.parametrize("margin", [0.9, -1.0])
def test_margins_that_cannot_be(margin: float) -> None:
    with pytest.raises(InputError, match="margin"):
        gc.plan(OCTAHEDRAL, "home", "0 0 10", margin=margin)


def test_a_region_that_leaves_out_the_goal() -> None:
    with pytest.raises(InputError, match="the goal lies outside the region"):
        gc.plan(OCTAHEDRAL, "home", "0 0 100", within="z -50..50")
    with pytest.raises(InputError, match="'w' is not a coordinate"):
        gc.plan(OCTAHEDRAL, "home", "0 0 100", within="w -50..50")


def test_a_robot_of_joints() -> None:
    found = gc.plan("3-rps", "home", "z=0.2, roll=20deg, pitch=10deg", margin=0.2)
    assert found.outcome == "way"
    assert found.path is not None
    assert not found.path.crossings
    assert not found.path.undecided
    assert found.csv().splitlines()[0] == "z,roll [rad],pitch [rad]"


def test_nothing_is_decided_with_few_states() -> None:
    found = gc.plan(OCTAHEDRAL, *AROUND, margin=0.02, states=2)
    assert found.outcome == "undecided"
    assert found.path is None


def test_a_region_may_be_wider_than_that_of_itself() -> None:
    found = gc.plan(OCTAHEDRAL, *AROUND, margin=0.02, within="x -900..900, turn ..170 deg", states=2)
    assert found.search is not None
    assert "-900 ≤ x ≤ 900 mm" in found.search.region
    assert "turn ≤ 170 deg" in found.search.region


def test_a_table_is_read_as_a_path(tmp_path: Path) -> None:
    table = tmp_path / "way.csv"
    found = gc.plan(OCTAHEDRAL, *AROUND, margin=0.02)
    table.write_text(found.csv(), encoding="utf-8")
    again = gc.path(OCTAHEDRAL, table)
    assert len(again.poses) == len(found.poses)
    assert again.verdict == "regular"


def test_none_is_about_a_configuration_of_a_robot_of_joints() -> None:
    found = gc.plan("3-rps", "home", "z=-0.3, roll=0deg, pitch=60deg")
    assert found.outcome == "none"
    assert "the configuration at the goal to which the straight way from home leads" in found.reason


WAYS = [
    ("3-rpr", "x=0.2, y=-0.1, yaw=55deg", 1),
    ("3-rpr", "x=-0.2, y=0.3, yaw=-70deg", 0),
    ("3-rps", "z=-0.3, roll=0deg, pitch=60deg", 1),
    ("3-rps", "z=0.1, roll=30deg, pitch=-20deg", 0),
    ("3-prs", "z=0.1, roll=50deg, pitch=-30deg", 1),
    ("delta", "x=0.3, y=0.4, z=-1", 0),
    ("3-upu", "x=0.3, y=0.1, z=-0.2", 0),
    ("tricept", "x=0.2, y=0.1, z=0.1", 0),
    ("6-pus", "x=0.1, y=0.1, z=0.1, roll=10deg, pitch=20deg, yaw=40deg", 0),
]


@pytest.mark.parametrize(("robot", "pose", "crossings"), WAYS)
def test_closing_signs_change_at_each_crossing(robot: str, pose: str, crossings: int) -> None:
    m = mechanism(robot)
    assert isinstance(m, Limbs)
    path = gc.path(m.robot, ["home", pose], samples=8)
    assert not path.undecided
    assert path.branch_doubt is None
    wanted = target_of(m.linkage, pose, None)
    assert wanted is not None
    space = limb_space(m, wanted.names, (), 0.0, None, None)
    rows = [space.row_of(c) for c in (m.linkage.home, solve(m.linkage, wanted).configuration)]
    signs = closing_signs(space.at(np.stack(rows)))
    assert signs is not None
    a, b = signs.tolist()
    assert a * b == (-1) ** len(path.crossings)
    assert len(path.crossings) == crossings


@pytest.mark.parametrize("robot", ["3-rrr-spherical", "orthoglide", "4-rpr", "par4"])
def test_robots_without_a_closing_sign(robot: str) -> None:
    m = mechanism(robot)
    assert isinstance(m, Limbs)
    assert closing_signs(Solved.of(m, np.zeros((1, sum(map(len, m.linkage.home.joint_values)))))) is None


def test_the_way_out_ends_at_the_margin() -> None:
    found = gc.plan(OCTAHEDRAL, "0 0 -349", margin=0.1)
    assert found.outcome == "way"
    assert found.end_margin is not None
    assert found.end_margin >= 0.1
    assert gc.pose(OCTAHEDRAL, "0 0 -349", nearest=False).margin < 0.01
    assert gc.pose(OCTAHEDRAL, found.poses[-1], nearest=False).margin == pytest.approx(found.end_margin)
    assert found.path is not None
    assert not found.path.zeros
    straight_up = gc.pose(OCTAHEDRAL, [f"0 0 {z}" for z in range(-349, 0)])
    up = 349 - next(-z for z, sigma in zip(range(-349, 0), straight_up.margin, strict=True) if sigma >= 0.1)
    assert found.length < up / found.size


def test_the_way_out_of_a_robot_of_joints() -> None:
    found = gc.plan("3-rps", "z=-0.2, roll=52deg, pitch=10deg", margin=0.3)
    assert found.outcome == "way"
    assert gc.pose("3-rps", found.poses[-1], nearest=False).margin >= 0.3
    assert found.path is not None
    assert not found.path.crossings


def test_no_way_out_of_what_is_singular_or_safe() -> None:
    with pytest.raises(InputError, match="the start is singular"):
        gc.plan(EXAMPLES / "octahedral-singular.yaml", "home")
    with pytest.raises(InputError, match="not less than"):
        gc.plan("3-rps", "home")


def test_no_way_out_within_narrow_limits() -> None:
    found = gc.plan(OCTAHEDRAL, "0 0 -349", margin=0.4, within="z -350..-348")
    assert found.outcome == "undecided"
    assert found.goal is None
    assert "goal" not in found.text()


def test_factors_tell_where_there_is_no_determinant() -> None:
    """A spherical wrist, whose loops ask for less than six equations."""
    goal = "roll=79deg, pitch=30deg, yaw=-23deg"
    found = gc.plan("3-sps-s", "home", goal)
    assert found.outcome == "none"
    assert [o.expression for o in found.opposed] == [r"A1B1O /\ A2B2O /\ A3B3"]
    assert SEEN in found.notes
    assert len(gc.path("3-sps-s", ["home", goal]).crossings) % 2 == 1
    assert SEEN not in gc.plan("3-rpr", "home", "x=0, y=0, yaw=60deg").notes


def test_chosen_lines_that_depend_on_each_other_are_no_singularity() -> None:
    """CaPaMan: a bar becomes parallel to z, where the lines of its limb coincide and nothing is singular."""
    goal = "x=0.2768573887, y=0.5516656795, pitch=-0.22640089766rad"
    path = gc.path("capaman", ["home", goal], samples=8)
    assert not path.crossings
    assert gc.plan("capaman", "home", goal).outcome == "way"


@pytest.mark.parametrize(
    ("robot", "start", "goal"),
    [
        ("4-ups-sp", "z=-3.85, roll=36deg, pitch=-15deg, yaw=-6deg", "z=-4.15, roll=36deg, pitch=-15deg, yaw=-6deg"),
        ("tricept", "z=5.15, roll=26deg, pitch=-7deg", "z=4.85, roll=26deg, pitch=-7deg"),
    ],
)
def test_a_slide_may_pass_the_length_zero(robot: str, start: str, goal: str) -> None:
    """The direction from one end of a passive slide to the other turns round there, and nothing is singular."""
    path = gc.path(robot, [start, goal])
    assert not path.crossings
    assert not path.undecided
    found = gc.plan(robot, start, goal)
    assert found.outcome == "way"
    assert len(found.poses) == 2


def test_a_way_keeps_to_a_narrow_region() -> None:
    """Poses with few digits may lie outside; then the way is written with all of them."""
    start, goal = "0.03 122.5 -73.4; rotvec 14.3 -70.8 74.7 deg", "0.03 -105.8 -72.1; rotvec -58.8 1.8 2.3 deg"
    found = gc.plan(OCTAHEDRAL, start, goal, within="x 0.02..0.04", states=500)
    assert all(0.02 <= float(p.translation[0]) <= 0.04 for p in found.poses if isinstance(p, Pose))


def test_a_bound_is_not_rounded_up() -> None:
    found = gc.plan(OCTAHEDRAL, "7 0 0", "7 0 0")
    sigma = gc.pose(OCTAHEDRAL, "7 0 0", nearest=False).margin
    (shown,) = (
        float(line.split("≥")[1].split(",")[0]) for line in found.text(unicode=True).splitlines() if "≥" in line
    )
    assert shown <= sigma


@pytest.mark.parametrize(
    ("robot", "goal"),
    [
        ("6-rus", "x=0.1, y=0.1, yaw=10deg"),
        ("3-rps", "z=0.2, roll=20deg, pitch=10deg"),
        ("3-rpr", "x=0.1, y=0, yaw=9deg"),
    ],
)
def test_tables_of_robots_of_joints_are_read_again(tmp_path: Path, robot: str, goal: str) -> None:
    found = gc.plan(robot, "home", goal)
    assert found.path is not None
    table = tmp_path / "way.csv"
    table.write_text(found.csv(), encoding="utf-8")
    again, same = gc.path(robot, table, samples=50), gc.path(robot, list(found.poses), samples=50)
    assert again.margins.tolist() == pytest.approx(same.margins.tolist(), abs=1e-9)


@pytest.mark.parametrize("robot", [OCTAHEDRAL, "3-rps"])
def test_faults_of_poses_stand_where_they_were_typed(robot: str | Path) -> None:
    for words, option in ((("home", "z=1, roll=30"), "--to"), (("z=1, roll=30", "home"), "--from")):
        done = invoke("plan", str(robot), "--from", words[0], "--to", words[1])
        assert done.exit_code == 2
        assert f"{option}:1:6: " in done.stderr


# --- picture --------------------------------------------------------------------------------------------------------


def test_the_picture_of_a_way(tmp_path: Path) -> None:
    """It is that of its path, with the margin that was asked for where it is another than the threshold."""
    file = tmp_path / "way.svg"
    command = ("plan", "3-rps", "--from", "home", "--to", "z=0.2, roll=20deg, pitch=10deg")
    assert invoke(*command, "--margin", "0.2", "--plot", str(file)).exit_code == 0
    way = gc.plan("3-rps", "home", "z=0.2, roll=20deg, pitch=10deg", margin=0.2)
    assert file.read_text(encoding="utf-8") == way.plot().svg() == way._repr_svg_()
    assert "margin asked for, 0.2" in way.plot().svg()
    plain = gc.plan("3-rps", "home", "z=0.2, roll=20deg, pitch=10deg")
    assert plain.path is not None
    assert plain.plot().svg() == plain.path.plot().svg()


def test_where_there_is_no_way_nothing_is_drawn(tmp_path: Path) -> None:
    octahedral = EXAMPLES / "octahedral.yaml"
    found = gc.plan(octahedral, "home", "0 0 -490")
    with pytest.raises(gc.GcrulesError, match="no way to be drawn"):
        found.plot()
    assert found._repr_svg_() is None
    file = tmp_path / "none.svg"
    assert invoke("plan", str(octahedral), "--from", "home", "--to", "0 0 -490", "--plot", str(file)).exit_code == 1
    assert not file.exists()
