"""What actuators make of their rates: against finite motions, the statics of forces, and known robots."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.report import RobotPose

IDS = [one.id for one in robots()]
STEP = 1e-5


@cache
def at_home(name: str) -> RobotPose:
    found = gc.pose(read_robot(name), nearest=False)
    assert isinstance(found, RobotPose)
    return found


@pytest.mark.parametrize("name", IDS)
def test_each_actuator_moves_the_platform_so_fast(name: str) -> None:
    """The loops are closed a little to both sides, with one actuator after the other moved."""
    home = at_home(name)
    if home.verdict == "singular":
        return
    found = home.jacobian.amplification
    for place, actuator in enumerate(found.actuators):
        ends: list[Any] = [
            gc.pose(read_robot(name), actuators={actuator: s * STEP}, nearest=False).coordinates for s in (-1, 1)
        ]
        moved = {n: (ends[1][n] - ends[0][n]) / (2 * STEP) for n in ends[0]}
        speed, turn = (math.hypot(*(moved[n] for n in names)) for names in (("x", "y", "z"), ("rx", "ry", "rz")))
        assert speed == pytest.approx(found.speeds[place], rel=1e-4, abs=1e-6)
        assert turn == pytest.approx(found.turns[place], rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("name", IDS)
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
