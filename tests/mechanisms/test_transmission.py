"""What limbs pass on, and clearances: against angles that one draws, finite motions, and bodies that shift."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from mechanisms.bodies import chains, equations
from mechanisms.moved_robots import machine
from mechanisms.shipped_robots import analysis

import gcrules as gc
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.transmission import Transmission, transmitted
from gcrules.screws import FLOATS

STEP = 1e-5


def passing(source: Any, pose: Any = None) -> Transmission:
    found = gc.pose(source, pose, nearest=False).jacobian.transmission
    assert found is not None
    return found


def unit(v: Any) -> np.ndarray:
    return np.asarray(v) / np.linalg.norm(v)


def places(name: str) -> Mapping[str, np.ndarray]:
    return machine(name).home.values


# --- inputs: the angles that one draws -------------------------------------------------------------------------------


def test_a_crank_and_a_rod() -> None:
    """The sine of the angle between them."""
    p = places("3-rrr")
    for k, found in enumerate(passing(analysis("3-rrr")).inputs, start=1):
        crank, rod = unit(p[f"B{k}"] - p[f"A{k}"]), unit(p[f"C{k}"] - p[f"B{k}"])
        assert found == pytest.approx(np.linalg.norm(np.cross(crank, rod)))


def test_a_crank_and_a_rod_in_space() -> None:
    """The cosine of the angle between the rod and the way that the crank's end takes."""
    p = places("6-rus")
    for k, found in enumerate(passing(analysis("6-rus")).inputs, start=1):
        way = unit(np.cross(p[f"r{k}"], p[f"B{k}"] - p[f"A{k}"]))
        assert found == pytest.approx(abs(way @ unit(p[f"C{k}"] - p[f"B{k}"])))


def test_a_carriage_and_a_rod() -> None:
    for name, end in (("3-prs", "S"), ("6-pus", "C")):
        p = places(name)
        for k, found in enumerate(passing(analysis(name)).inputs, start=1):
            assert found == pytest.approx(abs(unit(p[f"d{k}"]) @ unit(p[f"{end}{k}"] - p[f"B{k}"])))


def test_what_slides_along_its_leg_passes_on_all() -> None:
    for name in ("gough-stewart", "3-rps", "tricept", "8-cables"):
        assert passing(analysis(name)).inputs == pytest.approx([1.0] * len(passing(analysis(name)).inputs))


# --- outputs: finite motions -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "start", "end"),
    [
        ("gough-stewart", "A", "B"),
        ("3-rps", "A", "S"),
        ("3-prs", "B", "S"),
        ("6-rus", "B", "C"),
        ("6-pus", "B", "C"),
        ("3-rrr", "B", "C"),
        ("3-rpr", "A", "B"),
    ],
)
def test_the_angle_between_a_rod_and_the_way_of_its_end(name: str, start: str, end: str) -> None:
    """The loops are closed a little to both sides, with one actuator after the other moved."""
    p, found = places(name), passing(analysis(name)).outputs
    for k, expected in enumerate(found, start=1):
        ends = [
            np.array(gc.pose(analysis(name), actuators={f"q{k}": s * STEP}, nearest=False).points[f"{end}{k}"])
            for s in (-1, 1)
        ]
        way = unit(ends[1] - ends[0])
        assert expected == pytest.approx(abs(way @ unit(p[f"{end}{k}"] - p[f"{start}{k}"])), abs=1e-6)


def test_six_legs_by_the_axis_of_the_screw() -> None:
    """The index as Chen and Angeles write it: pitch, distance and angle of the output's axis."""
    found = gc.pose("gough-stewart", nearest=False).jacobian
    p = places("gough-stewart")
    for k, row in enumerate(np.linalg.inv(found.rows).T):
        v, turn = row[:3], row[3:]
        size = np.linalg.norm(turn)
        pitch = v @ turn / size**2
        axis = found.centre + np.cross(turn, v) / size**2
        end, along = p[f"B{k + 1}"], unit(p[f"B{k + 1}"] - p[f"A{k + 1}"])
        reach = np.linalg.norm(np.cross(end - axis, unit(turn)))
        cosine = along @ unit(turn)
        moment = np.cross(end - axis, along) @ unit(turn)
        expected = abs(pitch * cosine + moment) / np.hypot(pitch, reach)
        assert found.transmission.outputs[k] == pytest.approx(expected)


def test_power_by_its_most() -> None:
    rng = np.random.default_rng(4)
    wrenches, twists, arms = rng.normal(size=(50, 6)), rng.normal(size=(50, 6)), rng.normal(size=(50, 3))
    found = transmitted(wrenches, twists, arms)
    assert ((found > 0) & (found <= 1)).all()
    for centre in rng.normal(size=(3, 3)):  # all about another centre: nothing changes
        w, t = wrenches.copy(), twists.copy()
        w[:, 3:] -= np.cross(centre, w[:, :3])
        t[:, :3] += np.cross(t[:, 3:], centre)
        assert transmitted(w, t, arms - centre) == pytest.approx(found)
    assert transmitted(np.zeros((1, 6)), twists[:1], arms[:1]).tolist() == [0.0]
    assert transmitted(np.full((1, 6), np.nan), twists[:1], arms[:1]).tolist() == [0.0]


# --- constraints ---------------------------------------------------------------------------------------------------


def test_a_constraint_is_taken_away() -> None:
    """3-RPS: forces through the S joints along the hinges; each leg's length is held."""
    p, found = places("3-rps"), passing(analysis("3-rps")).constraints
    ends = [p[f"S{k}"] for k in (1, 2, 3)]
    forces = [(unit(p[f"S{k}"] - p[f"A{k}"]), p[f"S{k}"]) for k in (1, 2, 3)]
    held = [(unit(p[f"r{k}"]), p[f"S{k}"]) for k in (1, 2, 3)]
    for k in range(3):
        rows = [[*f, *np.cross(e, f)] for f, e in (*forces, *(h for n, h in enumerate(held) if n != k))]
        twist = np.linalg.svd(np.array(rows))[2][5]
        way = unit(twist[:3] + np.cross(twist[3:], ends[k]))
        assert found[k] == pytest.approx(abs(way @ held[k][0]))


def test_couples_that_are_taken_away() -> None:
    """3-UPU: a couple along the normal of each U joint."""
    a = analysis("3-upu")
    p, found = places("3-upu"), passing(a).constraints
    held = [np.cross(p[f"u{k}"], p[f"v{k}"]) for k in (1, 2, 3)]
    for k in range(3):
        others = [h for n, h in enumerate(held) if n != k]
        turn = unit(np.cross(others[0], others[1]))
        assert found[k] == pytest.approx(abs(turn @ unit(held[k])))


def test_constraints_that_depend_on_each_other_have_none() -> None:
    assert passing(analysis("exechon")).constraints == ()
    with pytest.raises(gc.InputError, match="some depend on the others: there is no constraint transmission"):
        gc.singular_map("exechon", ["z -0.1:0.1:3", "roll -5:5:3 deg"], measure="constraint_transmission")


# --- clearances ------------------------------------------------------------------------------------------------------


def shifted(r: gc.Robot, values: Any, centre: np.ndarray, *, plane: bool = False) -> tuple[float, float]:
    """The sum, over all joints, of the largest shift and turn for a unit shift in this one; from the twists of all
    bodies and the rates of all joints.
    """
    rows, driven, _ = (np.array(part) for part in equations(r, values, FLOATS))
    rows = np.delete(rows.astype(float), driven, axis=1)
    inverse = np.linalg.pinv(rows)[:6]
    still = np.linalg.svd(rows)[2][np.linalg.matrix_rank(rows, 1e-9) :]
    assert np.abs(still[:, :6]).max(initial=0.0) < 1e-9  # the platform is held
    shift = turn = 0.0
    for place, (_, _, chain) in enumerate(chains(r, values, FLOATS)):
        for _ in chain.joints:
            moved = inverse[:, 6 * place + 3 : 6 * place + (5 if plane else 6)]
            turns = moved[:3]
            shifts = moved[3:] + np.cross(turns.T, centre).T
            shift += float(np.linalg.norm(shifts, 2))
            turn += float(np.linalg.norm(turns, 2))
    return shift, turn


CLEAR = ("gough-stewart", "3-rps", "3-prs", "3-upu", "6-rus", "tricept", "3-rrr", "3-rpr")


@pytest.mark.parametrize("name", CLEAR)
def test_bodies_shift_in_their_joints(name: str) -> None:
    m = machine(name)
    values = {n: tuple(map(float, v)) for n, v in m.home.values.items()}
    shift, turn = shifted(m.robot, values, m.centre, plane=m.robot.family.plane)
    found = passing(analysis(name))
    assert (found.clearance_shift, found.clearance_turn) == pytest.approx((shift, turn), abs=1e-9)


@pytest.mark.parametrize("name", ["exechon", "4-rpr", "3-crr"])
def test_no_shifts_that_joints_allow_are_larger(name: str) -> None:
    """Where constraints depend on each other, or there are more actuators than it takes, not all shifts can be."""
    m = machine(name)
    values = {n: tuple(map(float, v)) for n, v in m.home.values.items()}
    rows, driven, _ = (np.array(part) for part in equations(m.robot, values, FLOATS))
    rows = np.delete(rows.astype(float), driven, axis=1)
    every = [(place, chain) for place, (_, _, chain) in enumerate(chains(m.robot, values, FLOATS))]
    joints = [place for place, chain in every for _ in chain.joints]
    width = 2 if m.robot.family.plane else 3
    loose = np.zeros((len(rows), width * len(joints)))
    for n, place in enumerate(joints):
        for axis in range(width):
            loose[6 * place + 3 + axis, width * n + axis] = -1.0
    both = np.concatenate([rows, loose], axis=1)
    still = np.linalg.svd(both)[2][np.linalg.matrix_rank(both, 1e-9) :]
    found = passing(analysis(name))
    rng = np.random.default_rng(8)
    largest = np.zeros(2)
    for motion in rng.normal(size=(2000, len(still))) @ still:
        size = np.linalg.norm(motion[rows.shape[1] :].reshape(-1, width), axis=1).max()
        turn = motion[:3] / size
        shift = motion[3:6] / size + np.cross(turn, m.centre)
        largest = np.maximum(largest, [np.linalg.norm(shift), np.linalg.norm(turn)])
    assert 0.05 * found.clearance_shift < largest[0] <= found.clearance_shift
    assert largest[1] <= found.clearance_turn + 1e-12


RODS = """
title: Delta robot, each of its rods with two ball joints
copies: 3
points:
  O%: free
  A%: in plane O% perpendicular to r%
  B%: on line A% along r%
  C%: A% + d%
  D%: B% + d%
directions: {r%: free, d%: free}
limbs:
  - name: arm %
    joints:
      - base to elbow: R*(O%, r%)
      - elbow to platform: S(A%) S(C%)
      - elbow to platform: S(B%) S(D%)
mobility: 3
"""


def test_rods_with_clearances_tilt_the_platform() -> None:
    """The Delta's bars are two rods each, whose ball joints shift one by one."""
    m = machine("delta")
    values = {n: tuple(map(float, v)) for n, v in m.home.values.items()}
    for k in (1, 2, 3):
        for start, end in (("A", "C"), ("B", "D")):
            values[f"{end}{k}"] = tuple(a + b for a, b in zip(values[f"{start}{k}"], values[f"d{k}"], strict=True))
    shift, turn = shifted(parse_robot(RODS), values, m.centre)
    found = passing(analysis("delta"))
    assert (found.clearance_shift, found.clearance_turn) == pytest.approx((shift, turn))


def test_far_from_singular_and_near() -> None:
    """At a singular configuration nothing is passed on, and clearances have no bound."""
    here = gc.pose("examples/octahedral-singular.yaml", nearest=False)
    found = here.jacobian.transmission
    assert found is not None
    assert min(found.outputs) == 0
    assert np.isinf(found.clearance_shift)
    assert found.to_json()["clearance_shift"] is None
    assert "Clearances of the joints, however small, have no bound here." in here.text()


def test_limbs_with_loops_have_none() -> None:
    assert gc.pose("h4", nearest=False).jacobian.transmission is None
    with pytest.raises(gc.InputError, match="a limb has loops of its own: there is no transmission"):
        gc.singular_map("h4", ["x -0.1:0.1:3", "y -0.1:0.1:3"], measure="transmission")
