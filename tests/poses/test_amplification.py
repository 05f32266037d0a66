"""What actuators make of their rates: against finite motions, the statics of forces, and known robots."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from commands import assert_refused
from mechanisms.shipped_robots import AS_MANY, analysis
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.kinematics.actuations import amplified
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.report import RobotPose

IDS = [one.id for one in robots()]
STEP = 1e-5


@cache
def at_home(name: str) -> RobotPose:
    found = gc.pose(analysis(name), nearest=False)
    assert isinstance(found, RobotPose)
    return found


@pytest.mark.parametrize("name", AS_MANY)
def test_each_actuator_moves_the_platform_so_fast(name: str) -> None:
    """The loops are closed a little to both sides, with one actuator after the other moved."""
    home = at_home(name)
    if home.verdict == "singular":
        return
    found = home.jacobian.amplification
    for place, actuator in enumerate(found.actuators):
        ends: list[Any] = [
            gc.pose(analysis(name), actuators={actuator: s * STEP}, nearest=False).coordinates for s in (-1, 1)
        ]
        moved = {n: (ends[1][n] - ends[0][n]) / (2 * STEP) for n in ends[0]}
        speed, turn = (math.hypot(*(moved[n] for n in names)) for names in (("x", "y", "z"), ("rx", "ry", "rz")))
        assert speed == pytest.approx(found.speeds[place], rel=1e-4, abs=1e-6)
        assert turn == pytest.approx(found.turns[place], rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("name", AS_MANY)
def test_efforts_balance_forces_through_the_centre(name: str) -> None:
    """Statics: no unit force, and no unit couple, needs more effort than it is said, and one needs as much."""
    j = at_home(name).jacobian
    found, n = j.amplification, len(j.actuators)
    for columns, worst in (((0, 1, 2), found.speeds), ((3, 4, 5), found.turns)):
        efforts = np.linalg.pinv(j.rows.T)[:n, columns]
        # among the wrenches of an over-constrained robot, and in the plane, constraints bear what they can
        allowed = np.linalg.svd(j.rows[n:])[2][np.linalg.matrix_rank(j.rows[n:]) :] if len(j.rows) > n else np.eye(6)
        twists = np.linalg.solve(j.rows[:n] @ allowed.T, np.eye(n)).T @ allowed
        assert np.linalg.norm(twists[:, columns], axis=1) == pytest.approx(worst, rel=1e-9, abs=1e-12)
        if len(j.rows) == 6:
            assert np.linalg.norm(efforts, axis=1) == pytest.approx(worst, rel=1e-9, abs=1e-9)


def test_the_orthoglide_is_isotropic_at_home() -> None:
    found = at_home("orthoglide").jacobian.amplification
    assert (found.condition_number, found.isotropy) == (pytest.approx(1), pytest.approx(1))
    assert found.speeds == pytest.approx((1, 1, 1))


@pytest.mark.parametrize("length", [0.5, 2.0, "3"])
def test_the_characteristic_length_is_chosen(length: Any) -> None:
    """Six legs: the condition number of the legs' coordinates, moments divided by the length."""
    found = gc.pose("gough-stewart", length=length, nearest=False)
    j = found.jacobian
    rows = j.rows / np.array([1, 1, 1, *[float(length)] * 3])
    assert j.amplification.condition_number == pytest.approx(np.linalg.cond(rows))
    assert j.amplification.length == float(length)
    assert j.length == pytest.approx(at_home("gough-stewart").jacobian.length)
    shifts = gc.pose("delta", length=length, nearest=False).jacobian.amplification
    assert shifts.condition_number == pytest.approx(at_home("delta").jacobian.amplification.condition_number)


def test_singular_robots_have_no_bounds() -> None:
    here = gc.pose("examples/octahedral-singular.yaml", nearest=False)
    found = here.jacobian.amplification
    assert (found.condition_number, found.isotropy) == (math.inf, 0)
    assert any(map(math.isinf, found.speeds))
    assert here.to_json()["jacobian"]["amplification"]["condition_number"] is None
    assert "condition number infinite, isotropy 0" in here.text()


@pytest.mark.parametrize(
    ("length", "said"), [("0", "is not positive"), ("-1", "is negative"), ("long", "expected a number")]
)
def test_faulty_lengths(length: str, said: str) -> None:
    result = CliRunner().invoke(cli, ["pose", "delta", "--length", length])
    assert (result.exit_code, said in result.stderr) == (2, True), result.stderr


def test_many_poses_of_a_platform_have_no_condition_number() -> None:
    with pytest.raises(gc.InputError, match="many poses of a platform"):
        gc.pose("examples/octahedral.yaml", [[0, 0, 0], [0, 0, 1]], length=1)
    one, other = gc.pose("delta", [{"z": 0.1, "x": 0.0, "y": 0.0}, {"z": 0.2, "x": 0.0, "y": 0.0}], length=2)
    assert one.jacobian.amplification.length == other.jacobian.amplification.length == 2


# --- at many poses ---------------------------------------------------------------------------------------------------


def expected(a: Any) -> dict[str, float]:
    """The indices by their definitions, from what is said of one pose."""
    speed, turn = max(a.speeds), max(a.turns)
    rest = {
        "speed": speed,
        "turn": turn,
        "shift_error": sum(a.speeds),
        "turn_error": sum(a.turns),
        "force": 1 / speed if speed else math.inf,
        "couple": 1 / turn if turn else math.inf,
    }
    cables = {"closure": a.cables.least} if a.cables else {}
    own = {"isotropy": a.isotropy, **cables, **({} if len(set(a.angles)) > 1 or math.isnan(speed) else rest)}
    return own if a.transmission is None else own | passed(a.transmission)


def passed(t: Any) -> dict[str, float]:
    """The indices of the limbs; there are no outputs where no actuator moves alone."""
    found = {"input_transmission": min(t.inputs), "clearance_shift": t.clearance_shift}
    found |= {"clearance_turn": t.clearance_turn}
    if not math.isnan(t.outputs[0]):
        found |= {"output_transmission": min(t.outputs), "transmission": min(*t.inputs, *t.outputs)}
    return found | ({"constraint_transmission": min(t.constraints)} if t.constraints else {})


@pytest.mark.parametrize("name", IDS)
def test_arrays_are_what_single_poses_have(name: str) -> None:
    """Two roads: joints as values of screws at one configuration, and stacks of screws that links carry."""
    home, m = at_home(name), linkage(read_robot(name))
    stack = amplified(m, Configurations.of([m.home] * 3))
    for one in range(3):
        found = {n: float(v[one]) for n, v in stack.indices.items()}
        assert found == pytest.approx(expected(home.jacobian.amplification), rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("name", ["delta", "3-rps", "exechon"])
def test_indices_along_a_path(name: str) -> None:
    names = gc.compiled(name).coordinates
    end = ", ".join(f"{n}=0.1rad" if n in ("roll", "pitch", "yaw") else f"{n}=0.1" for n in names)
    r = gc.path(name, ["home", end], samples=3)
    assert isinstance(r, RobotPath)
    header, *rows = [line.split(",") for line in r.csv().splitlines()]
    for k in (0, len(r) // 2, len(r) - 1):
        there = dict(zip(r.names, map(float, r.coordinates[k]), strict=True))
        one = gc.pose(name, there, nearest=False).jacobian.amplification
        for index, value in expected(one).items():
            assert float(r.amplifications.indices[index][k]) == pytest.approx(value, rel=1e-6, abs=1e-9)
            column = next(c for c, head in enumerate(header) if head.partition(" [")[0] == index.replace("_", " "))
            assert float(rows[k][column]) == pytest.approx(value, rel=1e-6, abs=1e-9)
    assert r.to_json()["samples"]["isotropy"] == pytest.approx(r.amplifications.isotropy)
    assert "isotropy" in r.text()


def test_indices_of_a_platform_at_many_poses_and_along_a_path() -> None:
    source = str(EXAMPLES / "octahedral.yaml")
    shifts = [[0.0, 0.0, 0.0], [10.0, -5.0, 20.0], [0.0, 40.0, -30.0]]
    many = gc.pose(source, np.array(shifts))
    path = gc.path(source, shifts, samples=5)
    for k, shift in enumerate(shifts):
        one = expected(gc.pose(source, shift, nearest=False).jacobian.amplification)
        for index, value in one.items():
            assert many.amplifications.indices[index][k] == pytest.approx(value)
            sample = int(np.flatnonzero(path.parameters == k)[0])
            assert path.numbers.amplifications.indices[index][sample] == pytest.approx(value)
    assert "speed,turn [rad/mm],shift error" in path.csv()
    assert "isotropy" in path.text()


HAVE = {"closure": "8-cables", "constraint_transmission": "delta"}
OF_MAPS = [(HAVE.get(measure, "3-rpr"), "xy", measure) for measure in INDICES]
OF_MAPS += [(s, o, m) for s, o in (("delta", "xy"), ("octahedral.yaml", "xz")) for m in ("isotropy", "shift_error")]


@pytest.mark.parametrize(("name", "over", "measure"), OF_MAPS)
def test_maps_of_indices(name: str, over: str, measure: str) -> None:
    source, size = (str(EXAMPLES / name), 40.0) if name.endswith("yaml") else (name, 0.2)
    found = gc.singular_map(source, [f"{n} {-size}:{size}:3" for n in over], measure=measure)
    values = found.values(measure)
    pose = dict(zip(over, (size, 0.0), strict=True))
    if not source.endswith("yaml"):
        pose |= dict.fromkeys(set(gc.compiled(source).coordinates) - set(pose), 0.0)
    value = expected(gc.pose(source, pose, nearest=False).jacobian.amplification)[measure]
    assert values[2, 1] == pytest.approx(value, rel=1e-5, abs=1e-6)
    least, most = found.summary.index
    assert (least[0], most[0]) == (float(values.min()), float(values.max()))
    assert found.to_json()["summary"]["index"][0]["at"] == list(least[1])
    assert found.to_json()["measure"] == measure
    assert INDICES[measure].meaning in " ".join(found.text().split())
    plain = gc.singular_map(source, [f"{n} {-size}:{size}:3" for n in over])
    assert np.array_equal(plain.values("margin"), found.values("margin"))


def test_a_map_of_an_index_is_drawn_and_saved(tmp_path: Path) -> None:
    over = ["x -0.4:0.4:9", "y -0.4:0.4:9"]
    found = gc.singular_map("delta", over, measure="shift_error")
    found.save(str(tmp_path / "map.svg"), str(tmp_path / "map.nc"))
    assert (tmp_path / "map.svg").stat().st_size > 10_000
    data = found.to_xarray()
    assert data["shift_error"].attrs["units"] == "length/rad"
    assert np.array_equal(data["shift_error"].values, found.values("shift_error"))


MIXED = """
title: two sliding legs and one that turns
space: plane
points: {A1: free, A2: free, A3: free, B1: free, B2: free, B3: free, C3: free}
limbs:
- {name: leg 1, joints: "R(A1, z) P*(A1 B1) R(B1, z)"}
- {name: leg 2, joints: "R(A2, z) P*(A2 B2) R(B2, z)"}
- {name: leg 3, joints: "R*(A3, z) R(C3, z) R(B3, z)"}
platform: B1 B2 B3
mobility: 3
home: {A1: [0, 0, 0], A2: [10, 0, 0], A3: [5, 9, 0], B1: [4, 2, 0], B2: [7, 3, 0], B3: [5, 5, 0], C3: [8, 7, 0]}
"""


def test_actuators_of_two_kinds_have_no_unit_in_common(tmp_path: Path) -> None:
    file = tmp_path / "robot.yaml"
    file.write_text(MIXED, encoding="utf-8")
    asked = ["map", str(file), "--over", "x -0.1:0.1:3", "--over", "y -0.1:0.1:3", "--measure"]
    done = CliRunner().invoke(cli, [*asked, "speed"])
    assert_refused(done, 2, "some actuators turn and others slide: there is no speed")
    assert CliRunner().invoke(cli, [*asked, "isotropy"]).exit_code == 0
    header = gc.path(str(file), ["home", "x=0.1, y=0, yaw=0rad"]).csv().splitlines()[0]
    assert "speed" not in header
    assert ",isotropy,input transmission," in header


def test_what_moves_the_platform_not_at_all_is_0() -> None:
    """A Delta's platform does not turn: rounding errors are no turns, and its constraints bear all couples."""
    found = gc.compiled("delta").numbers([[0.1, 0.2, 0.0]], "turns, speeds")
    assert not found["turns"].any()
    assert found["speeds"].all()
    assert np.isinf(gc.path("delta", ["home", "z=0.1, x=0, y=0"], samples=3).amplifications.indices["couple"]).all()


def test_actuators_that_do_no_work_at_all_have_no_isotropy() -> None:
    """The platform of 3-RPS in the plane of its base: all six forces lie in it."""
    found = gc.pose(analysis("3-rps"), {"z": -2.0, "roll": 0.0, "pitch": 0.0}, nearest=False)
    a = found.jacobian.amplification
    assert (found.verdict, a.isotropy) == ("singular", 0)
    assert all(math.isinf(v) for v in a.speeds)
