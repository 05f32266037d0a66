"""Limits in robot files and geometry files: what they say, faults with their places, and models that have them."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import FileError, InputError
from gcrules.mechanisms.description.driven import driven_freedoms
from gcrules.mechanisms.description.limb_file import LimbSpec, read_joints
from gcrules.mechanisms.description.platform_file import Platform, parse_platform
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.chains import shape_of
from gcrules.mechanisms.mechanism import limits_of, mechanism
from gcrules.mechanisms.models.importing import import_file
from gcrules.mechanisms.models.of_robot import model_of
from gcrules.mechanisms.robot import Robot
from gcrules.poses.methods import legs_within
from gcrules.poses.modes.choose import in_mode
from gcrules.screws import JOINTS

RPS = """title: RPS
copies: 3
points: {A%: free, S%: in plane A% perpendicular to r%}
directions: {r%: free}
limbs:
  - name: leg %
    joints: R(A%, r%) P*:slide(A% S%) S(S%)
mobility: 3
home: {A1: [2, 0, 0], A2: [-1, 2, 0], A3: [-1, -2, 0], S1: [1, 0, 3], S2: [-1/2, 1, 3], S3: [-1/2, -1, 3],
       r1: [0, 1, 0], r2: [2, 1, 0], r3: [-2, 1, 0]}
"""
OCTAHEDRAL = (EXAMPLES / "octahedral.yaml").read_text("utf-8")


def robot(limits: str) -> Robot:
    return parse_robot(f"{RPS}limits: {limits}\n", "rps.yaml")


def platform(limits: str) -> Platform:
    return parse_platform(f"{OCTAHEDRAL}limits: {limits}\n", "octahedral.yaml")


def six(limits: str) -> Robot:
    """A robot of joints whose limbs are six legs."""
    return shipped("gough-stewart", limits)


def shipped(name: str, limits: str) -> Robot:
    found = gc.load(name)
    assert isinstance(found, Robot)
    return replace(found, limits=limits)


# --- what they say ---------------------------------------------------------------------------------------------------


def test_limits_of_a_robot() -> None:
    found = robot("actuators -0.2..0.3, q2 ..0.25")
    assert found.limits == "actuators -0.2..0.3, q2 ..0.25"
    reach = limits_of(mechanism(found), None)
    assert reach is not None
    assert (reach.low, reach.high) == ((-0.2, -math.inf, -0.2), (0.3, 0.25, 0.3))
    assert reach.text == "-0.2 ≤ q1 ≤ 0.3, q2 ≤ 0.25, -0.2 ≤ q3 ≤ 0.3 (of the file)"


def test_limits_by_the_name_of_a_joint() -> None:
    reach = limits_of(mechanism(robot("slide -1..1, q3 0..1")), None)
    assert reach is not None
    assert reach.low == (-1, -1, 0)


def test_given_limits_replace_those_of_the_file() -> None:
    found = mechanism(robot("actuators -1..1"))
    given = limits_of(found, "q1 0..2")
    assert given is not None
    assert given.text == "0 ≤ q1 ≤ 2"
    assert limits_of(found, "none") is None
    assert limits_of(mechanism(gc.load("3-rps")), None) is None


def test_limits_of_a_platform() -> None:
    reach = limits_of(mechanism(platform("legs 120..560, fe 130..")), None)  # a leg is named from either end
    assert reach is not None
    assert reach.low == (120, 120, 120, 120, 120, 130)
    assert reach.text.endswith("mm (of the file)")
    points = {n: [k, k * k, k**3] for k, n in enumerate("abcdef")}
    data = gc.load({"legs": "ab af cb cd ed ef", "points": points, "limits": "ab 1..2"})
    assert isinstance(data, Platform)
    assert data.limits == "ab 1..2"


def test_limits_of_values() -> None:
    points = {n: (k, k * k, k**3) for k, n in enumerate("abcdef")}
    legs = (("a", "b"), ("a", "f"), ("c", "b"), ("c", "d"), ("e", "d"), ("e", "f"))
    assert Platform(legs, points, limits="ab 1..2").limits == "ab 1..2"
    with pytest.raises(InputError, match="is not a leg"):
        Platform(legs, points, limits="xy 1..2")


@pytest.mark.parametrize("symbol", [s for s, kind in JOINTS.items() if kind.drives])
def test_amounts_are_angles_as_joints_move(symbol: str) -> None:
    written = {"point": "A", "direction": "u", "number": "1"}
    joint = read_joints(f"{symbol}*({', '.join(written[form] for form in JOINTS[symbol].parts.values())})")
    turns = {m.freedom: m.turns for m in shape_of(symbol).motions}
    for d in driven_freedoms([LimbSpec("leg", joint)]):
        assert d.angle == turns[d.freedom]


# --- faults ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("limits", "column", "says"),
    [
        ("q1 -0.2..0.2, q5 0..1", 23, "'q5' is not an actuator"),
        ("q1 1..0", 9, "reversed"),
        ('"q1 -2..2, q2 -2..2 deg"', 20, "a length, deg a unit of angles"),
        ("q1 0", 9, "not a range"),
        ("[q1 0..1]", 9, "expected a single value"),
    ],
    ids=str,
)
def test_faults_of_robots_have_their_place(limits: str, column: int, says: str) -> None:
    with pytest.raises(FileError, match=says) as fault:
        robot(limits)
    assert fault.value.place == f"rps.yaml:11:{column}"


@pytest.mark.parametrize(
    ("limits", "column", "says"),
    [
        ("legs 120..560, fg 130..", 24, "'fg' is not a leg"),
        ("legs 1..2 m", 9, "mixed units"),
        ("legs -1..2", 9, "not negative"),
    ],
    ids=str,
)
def test_faults_of_platforms_have_their_place(limits: str, column: int, says: str) -> None:
    with pytest.raises(FileError, match=says) as fault:
        platform(limits)
    assert fault.value.place == f"octahedral.yaml:{OCTAHEDRAL.count(chr(10)) + 1}:{column}"


def test_lines_have_no_limits() -> None:
    lines = (
        "title: t\npoints: {a: free, b: free, c: free, d: free, e: free, f: free}\nlines: [ab, af, cb, cd, ed, ef]\n"
    )
    with pytest.raises(FileError, match="no joint is driven"):
        parse_robot(f"{lines}mobility: 6\nlimits: q1 0..1\n")


# --- six legs --------------------------------------------------------------------------------------------------------


def test_amounts_of_six_legs_are_lengths() -> None:
    """The limits of slides as those of the legs' lengths, against the robot driven to its limits."""
    source = six("actuators -0.1..0.2, q2 ..0.3")
    legs = mechanism(source).six_legs()
    reach = limits_of(legs, None)
    assert reach is not None
    home = np.linalg.norm(legs.rig.ends(np.zeros((1, 3)), np.eye(3)[None])[0] - legs.rig.base, axis=1)
    assert np.allclose(reach.high, home + np.array([0.2, 0.3, 0.2, 0.2, 0.2, 0.2]))
    assert np.allclose(reach.low, np.where(np.arange(6) == 1, 0, home - 0.1))
    driven = gc.pose(source, actuators="q1=0.2", nearest=False)
    assert math.isclose(math.dist(driven.points["A1"], driven.points["B1"]), reach.high[0])


def test_slides_that_go_back() -> None:
    """Written from the platform to the base, a slide shortens its leg, as the robot shows that is driven."""
    text = six("").text.replace("P*(A% B%)", "P*(B% A%)")
    source = parse_robot(f"{text}\nlimits: actuators -0.1..0.2\n")
    reach = limits_of(mechanism(source).six_legs(), None)
    assert reach is not None
    driven = gc.pose(source, actuators="q1=0.2", nearest=False)
    assert math.isclose(math.dist(driven.points["A1"], driven.points["B1"]), reach.low[0])


def test_slides_beside_their_legs() -> None:
    """Lengths of legs do not say their limits: the joints are moved."""
    text = six("").text.replace("P*(A% B%)", "P*(d%)").replace("limbs:", "  d%: free\nlimbs:", 1)
    home = "".join(f"  d{k}: [{k}, 1, 9]\n" for k in range(1, 7))
    found = mechanism(parse_robot(f"{text.rstrip()}\n{home}limits: actuators -0.1..0.2\n"))
    assert found.six_legs().limits == ""
    assert legs_within(found, None) is None
    assert legs_within(found, "A1B1 1..3") == legs_within(found, "none") == found.six_legs()


# --- modes -----------------------------------------------------------------------------------------------------------


def test_limits_count_from_the_home_of_the_file() -> None:
    found = shipped("3-rrr", "actuators -20..20 deg")
    other = in_mode(found, "+-+")
    assert isinstance(other, Robot)
    assert (other.limits, "another home" in other.note) == ("", True)


# --- models ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ending", ["xml", "urdf"])
@pytest.mark.parametrize("exchanged", [False, True], ids=["", "from the platform"])
def test_models_keep_limits(tmp_path: Path, ending: str, exchanged: bool) -> None:
    """Round trip; seen from the platform a slide still makes its leg as long, its limits are the same."""
    source = robot("actuators -0.2..0.3, q2 -0.1..0.25")
    path = tmp_path / f"rps.{ending}"
    path.write_text(gc.export_model(source, {"xml": "mjcf"}.get(ending, ending)), "utf-8")
    if ending == "urdf":
        (tmp_path / "rps-closures.yaml").write_text(gc.export_model(source, "closures"), "utf-8")
    base = {"xml": "world", "urdf": "base"}[ending]
    ends = {"base": "platform", "platform": base} if exchanged else {"base": base, "platform": "platform"}
    found = import_file(path, **ends).robot
    reach = limits_of(mechanism(found), None)
    assert reach is not None
    assert sorted(zip(reach.low, reach.high, strict=True)) == [(-0.2, 0.3), (-0.2, 0.3), (-0.1, 0.25)]
    assert "limits" not in found.note


def test_an_axis_that_points_the_other_way(tmp_path: Path) -> None:
    """The same motion with axis and range turned round gives the same limits."""
    text = gc.export_model(robot("q1 -0.2..0.3"))
    turned = text.replace('axis="-0.316227766017 0 0.948683298051" range="-0.2 0.3"',
                          'axis="0.316227766017 0 -0.948683298051" range="-0.3 0.2"')  # fmt: skip
    assert turned != text
    limits = []
    for one in (text, turned):
        (tmp_path / "rps.xml").write_text(one, "utf-8")
        found = import_file(tmp_path / "rps.xml").robot
        lengths = [math.dist(*(map(float, found.home[n]) for n in ("A1", "B1")))] if found.home else []
        limits.append((found.limits, lengths))
    assert limits[0] == limits[1]
    assert limits[0][0] == "q1 -0.2..0.3"


def test_angles_of_a_model(tmp_path: Path) -> None:
    """Driven to a limit, a hinge of the model and the actuator of the robot file take their horn to the same place."""
    source = shipped("6-rus", "actuators -20..35 deg, q3 -10..20 deg")
    model = model_of(source)
    ranges = [j.limits for j in model.joints if j.name in model.actuated]
    assert np.allclose(np.degrees([r or () for r in ranges]), [(-20, 35)] * 2 + [(-10, 20)] + [(-20, 35)] * 3)
    (tmp_path / "rus.xml").write_text(gc.export_model(source), "utf-8")
    found = import_file(tmp_path / "rus.xml").robot
    reach = limits_of(mechanism(found), None)
    assert reach is not None
    for k, name in enumerate(("leg_1", "leg_2", "leg_3")):
        hinge = next(j for j in model.joints if j.name.startswith(name) and j.kind == "revolute")
        own = found.values_at()[str(found.limbs[k].joints[0].directions[0][0][1])]
        way = np.sign(np.dot([float(c) for c in own], hinge.axes[0]))
        assert np.allclose(np.degrees(sorted((way * reach.low[k], way * reach.high[k]))),
                           np.degrees(hinge.limits or ()))  # fmt: skip


def test_models_in_other_units() -> None:
    model = model_of(platform("legs 120..560, ab 100.."))
    first, second = [j for j in model.joints if j.name in model.actuated][:2]
    assert first.limits is None  # limits with one end
    assert second.limits is not None
    assert math.isclose(second.limits[1] - second.limits[0], 0.44)
