"""Robots in configurations: loops close, on an independent road; every joint moves as its twists say."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mechanisms.moved_robots import analysed, machine, moves, robot, there

import gcrules as gc
from gcrules.mechanisms.description.carriers import riding
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.limb_file import LimbSpec, read_joints
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.chains import chain_of, shape_of
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage, linkage
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.rigid_motions import exponential, inverse, logarithm, rotations
from gcrules.mechanisms.kinematics.solve import free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import (
    actuators_target,
    coordinates_target,
    pose_target,
)
from gcrules.mechanisms.kinematics.wrench_jacobian import wrench_jacobian
from gcrules.screws import FLOATS, JOINTS, RATIONALS
from gcrules.screws.pose_text import parse_pose

IDS = tuple(one.id for one in robots())
PARTS = (0.6,)


# --- loops close: from the places of points and directions alone -----------------------------------------------------

# What each kind of joint has on the link before it and on that after it.
SIDES: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "R": (("point", "axis"), ("point", "axis")),
    "C": (("axis",), ("axis",)),
    "P": (("direction",), ("direction",)),
    "U": (("point", "first"), ("point", "second")),
    "S": (("point",), ("point",)),
    "Pa": (("near", "axis"), ("far", "axis")),
    "4S": (("first", "second"), ("first far", "second far")),
}
POINTS = ("point", "near", "far", "first far", "second far")


def geometry(joint: Any, values: Mapping[str, Any]) -> dict[str, tuple[str, Any]]:
    """Its parts as (point | direction, vector); bars make further points."""
    found: dict[str, tuple[str, Any]] = {}
    for (part, form), arg in zip(JOINTS[joint.kind].parts.items(), joint.args, strict=True):
        v = sum(float(c) * np.array(values[n]) for c, n in arg)
        found[part] = (form, v if form == "point" or part == "bars" else v / np.linalg.norm(v))
    if joint.kind == "4S":
        for end in ("first", "second"):
            found[f"{end} far"] = ("point", found[end][1] + found["bars"][1])
    if joint.kind == "Pa":
        bars = joint.args[0]  # two points, or a direction, which is on no other link
        ends = (values[bars[k][1]] for k in (1, 0)) if len(bars) > 1 else ()
        found |= {end: ("point", v) for end, v in zip(("near", "far"), ends, strict=len(bars) > 1)}
    return found


def bodies(m: Linkage, values: Mapping[str, Any]) -> Iterator[tuple[str, list[tuple[str, Any]]]]:
    """Every rigid body with the points and directions on it."""
    ends: dict[str, list[tuple[str, Any]]] = {"base": [("direction", axis) for axis in np.eye(3)]}
    ends["base"].append(("point", np.zeros(3)))
    for limb, (chain, joints) in ((one, part) for one in m.robot.limbs for part in one.parts):
        start, end = (n if n in ("base", "platform") else f"{limb.name}, {n}" for n in (chain.start, chain.end))
        parts = [geometry(j, values) for j in joints]
        ends.setdefault(start, []).extend(parts[0][p] for p in SIDES[joints[0].kind][0] if p in parts[0])
        ends.setdefault(end, []).extend(parts[-1][p] for p in SIDES[joints[-1].kind][1] if p in parts[-1])
        for k, (a, b) in enumerate(pairwise(joints)):
            own = [parts[k][p] for p in SIDES[a.kind][1] if p in parts[k]] + [parts[k + 1][p] for p in SIDES[b.kind][0]]
            yield f"{limb.name}, link behind {a.text}", own
        for k, j in enumerate(joints):
            if j.kind == "U":
                yield f"{limb.name}, cross {j.text}", [parts[k]["first"], parts[k]["second"]]
            if j.kind in ("Pa", "4S"):
                yield f"{limb.name}, bar {j.text}", [("point", np.zeros(3)), ("point", parts[k]["bars"][1])]
    yield from ends.items()


def shape(body: list[tuple[str, Any]]) -> np.ndarray:
    """What a rigid motion does not change: scalar products of directions and of differences of points."""
    points = [v for kind, v in body if kind == "point"]
    rows = [v for kind, v in body if kind == "direction"] + [p - points[0] for p in points[1:]]
    return np.array([[a @ b for b in rows] for a in rows])


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("name", IDS)
def test_bodies_keep_their_shape(name: str, part: float) -> None:
    m, s = machine(name), there(name, part)
    before, after = dict(bodies(m, m.home.values)), dict(bodies(m, s.configuration.values))
    assert before.keys() == after.keys()
    for body in before:
        assert shape(after[body]) == pytest.approx(shape(before[body]), abs=1e-9 * m.size**2), body
    moved = max(float(np.abs(s.configuration.values[n] - v).max()) for n, v in m.home.values.items())
    assert moved > 0.01 * part * m.size


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("name", IDS)
def test_what_was_wanted_is_reached_and_relations_hold(name: str, part: float) -> None:
    m, s = machine(name), there(name, part)
    wanted = moves(m, part)
    reached = coordinates(list(wanted), s.configuration.platform, m.centre)
    assert reached == pytest.approx(list(wanted.values()), abs=1e-9 * m.size)
    values = {n: tuple(Fraction(float(c)) for c in v) for n, v in s.configuration.values.items()}
    for d in m.robot.family.definitions:
        residual = d.relation.residual(d.sort, RATIONALS, values, values[d.name])
        assert all(abs(float(r)) <= 1e-8 * max(1.0, m.size) ** 3 for r in residual), d.name
    for place, own in enumerate(s.configuration.links):
        assert own[-1] == pytest.approx(s.configuration.platform, abs=1e-9 * m.size), m.robot.limbs[place].name


@pytest.mark.parametrize("name", IDS)
def test_actuators_lead_back_to_the_pose(name: str) -> None:
    m, s = machine(name), there(name, 0.6)
    amounts = {a.name: s.configuration.joint_values[a.place][a.coordinate] for a in leading(m)}
    back = solve(m, actuators_target(m, amounts))
    assert back.configuration.platform == pytest.approx(s.configuration.platform, abs=1e-8 * m.size)


@pytest.mark.parametrize("name", IDS)
def test_rates_are_those_of_the_jacobian(name: str) -> None:
    """Finite differences of solutions: constraints do no work, actuations have the rates of their actuators."""
    m, s = machine(name), there(name, 0.6)
    j = wrench_jacobian(m, s.configuration, margin(m, s.configuration))
    step = 1e-5
    for n in free_coordinates(m):
        ends = [
            solve(m, coordinates_target(m, moves(m, 0.6, {n: sign * step / 0.6}))).configuration for sign in (1, -1)
        ]
        twist = logarithm(ends[0].platform @ inverse(ends[1].platform)) / (2 * step)
        w, v = twist[:3], twist[3:] + np.cross(twist[:3], j.centre)
        rates = [
            (ends[0].joint_values[a.place][a.coordinate] - ends[1].joint_values[a.place][a.coordinate]) / (2 * step)
            for a in m.actuators
        ]
        power = j.rows[:, :3] @ v + j.rows[:, 3:] @ w
        assert power[: len(rates)] == pytest.approx(rates, rel=1e-4, abs=1e-5 * m.size)
        assert power[len(rates) :] == pytest.approx(0, abs=1e-5 * m.size)


@pytest.mark.parametrize("name", ["gough-stewart", "gough-stewart-63", "octahedral"])
def test_legs_of_platforms_far_from_home(name: str) -> None:
    """Against the closed form of the leg lengths."""
    m = machine(name)
    pose = parse_pose("0.6 -0.9 1.5; euler zyx 50 -20 15 deg")
    s = solve(m, pose_target(m, pose))
    rotation = np.array([[float(c) for c in row] for row in pose.rotation])
    shift = np.array([float(c) for c in pose.translation])
    for a, limb in zip(m.actuators, m.robot.limbs, strict=True):
        (start,), (end,) = limb.joints[0].points, limb.joints[-1].points
        A, B = m.home.values[start], m.home.values[end]
        moved = rotation @ (B - m.centre) + m.centre + shift
        length = np.linalg.norm(moved - A) - np.linalg.norm(B - A)
        assert s.configuration.joint_values[a.place][a.coordinate] == pytest.approx(length, abs=1e-9)


# --- single joints ---------------------------------------------------------------------------------------------------

SAMPLES = {
    "R": "R(A, u)", "P": "P(u)", "H": "H(A, u, 1/3)", "C": "C(A, u)", "U": "U(A, u, v)", "S": "S(A)", "E": "E(A, u)",
    "Pa": "Pa(A B, w)", "4S": "4S(A, B, v)",
}  # fmt: skip
PLACES = {
    "A": [1, 2, 3], "B": [2, 4, 2], "u": [1, 2, -1], "v": [2, -1, 1], "w": [2, -1, 0], "x": [1, 0, 0],
}  # fmt: skip
VALUES = {n: np.array(v, dtype=float) for n, v in PLACES.items()}


def test_every_kind_of_joint_has_motions() -> None:
    assert set(SAMPLES) == set(JOINTS)


# Links on which the parts of a joint ride, written out: of R both sides, of U each axis on the cross and on its side.
ATTACHMENTS = {
    "R": ({"point": (0, 1), "axis": (0, 1)}, ()),
    "P": ({"direction": (0, 1)}, ()),
    "H": ({"point": (0, 0), "axis": (0, 1)}, ("point",)),
    "C": ({"point": (0, 1), "axis": (0, 2)}, ("point",)),
    "U": ({"point": (0, 2), "first": (0, 1), "second": (1, 2)}, ()),
    "S": ({"point": (0, 3)}, ()),
    "E": ({"point": (2, 3), "normal": (0, 3)}, ("point",)),
}


@pytest.mark.parametrize("kind", ATTACHMENTS)
def test_parts_ride_on_the_links_that_leave_them_in_place(kind: str) -> None:
    found = riding(kind)
    assert (found.links, found.loose) == ATTACHMENTS[kind]
    assert found.motions == len(shape_of(kind).motions)


@pytest.mark.parametrize("kind", SAMPLES)
def test_motions_have_the_twists_of_the_joint(kind: str) -> None:
    limb = LimbSpec("limb", read_joints(SAMPLES[kind]))
    chain = chain_of(limb, VALUES)
    twists = chain.twists(chain.links(np.zeros(len(chain.turns)))).T
    own = np.array(limb.at({n: tuple(v) for n, v in VALUES.items()}, FLOATS).twists(FLOATS))
    rank = np.linalg.matrix_rank(own)
    assert rank == len(JOINTS[kind].freedoms) == np.linalg.matrix_rank(twists)
    assert np.linalg.matrix_rank(np.concatenate([own, twists]), tol=1e-9) == rank


@pytest.mark.parametrize("kind", SAMPLES)
def test_twists_are_the_derivatives_of_motions(kind: str) -> None:
    chain = chain_of(LimbSpec("limb", read_joints(SAMPLES[kind] + " R(B, x)")), VALUES)
    amounts = np.linspace(0.3, -0.4, len(chain.turns))
    links = chain.links(amounts)
    for k, twist in enumerate(chain.twists(links).T):
        step = 1e-6 * np.eye(len(amounts))[k]
        ahead, behind = chain.links(amounts + step)[-1], chain.links(amounts - step)[-1]
        assert logarithm(ahead @ inverse(behind)) / 2e-6 == pytest.approx(twist, abs=1e-7)


def test_bars_swing_on_circles() -> None:
    """A parallelogram keeps the orientation; its far hinge stays at the same distance from the near one."""
    for text, amounts in (("Pa(A B, w)", [1.2]), ("4S(A, B, v)", [0.9, -0.7, 0, 0])):
        chain = chain_of(LimbSpec("limb", read_joints(text)), VALUES)
        end = chain.links(np.array(amounts))[-1]
        assert end[:3, :3] == pytest.approx(np.eye(3), abs=1e-14)
        start, far = (VALUES["A"], VALUES["B"]) if text[0] == "P" else (VALUES["A"], VALUES["A"] + VALUES["v"])
        moved = end[:3, :3] @ far + end[:3, 3]
        assert np.linalg.norm(moved - start) == pytest.approx(np.linalg.norm(far - start))
        assert np.linalg.norm(moved - far) > 0.5


numbers = st.floats(-2, 2)


@given(st.lists(numbers, min_size=6, max_size=6))
def test_logarithms_undo_exponentials(screw: list[float]) -> None:
    twist = np.array(screw)
    twist[:3] *= 3.1 / max(3.1, float(np.linalg.norm(twist[:3])))
    assert logarithm(exponential(twist, 1.0)) == pytest.approx(twist, abs=1e-6)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, -1, 0), (0.6, 0, 0.8), (-0.6, -0.64, 0.48)])
def test_half_turns_have_logarithms(axis: tuple[float, ...]) -> None:
    twist = np.array([*(np.pi * np.array(axis)), 1, 2, 3])
    motion = exponential(twist, 1.0)
    assert exponential(logarithm(motion), 1.0) == pytest.approx(motion, abs=1e-9)


# --- angles beyond half a turn, ends on a line, joints named by other limbs -------------------------------------------


@pytest.mark.parametrize(
    ("name", "at", "whole"),
    [
        ("gough-stewart", "x=0, y=0, z=0, roll=0deg, pitch=0deg, yaw=200deg", "0 0 0; euler zyx 200 0 0 deg"),
        ("gough-stewart", "x=0, y=0, z=0, roll=-190deg, pitch=0deg, yaw=0deg", "0 0 0; euler zyx 0 0 -190 deg"),
        ("3-rpr", "x=0, y=0, yaw=200deg", "0 0 0; euler zyx 200 0 0 deg"),
    ],
    ids=["yaw", "roll", "in the plane"],
)
def test_more_than_half_a_turn(name: str, at: str, whole: str) -> None:
    one, two = gc.pose(analysed(name), at, nearest=False), gc.pose(analysed(name), whole, nearest=False)
    assert list(one.actuator_values.values()) == pytest.approx(list(two.actuator_values.values()), abs=1e-8)


def test_ends_on_a_line() -> None:
    """The platform can turn about the line through the three ball joints."""
    r = robot("3-rps")
    points = {"A1": (2, 0, 0), "A2": (0, 2, 0), "A3": (-2, 0, 0), "S1": (1, 0, 2), "S2": (0, 0, 2), "S3": (-1, 0, 2)}
    axes = {"r1": (0, 1, 0), "r2": (1, 0, 0), "r3": (0, 1, 0)}
    here = gc.pose(replace(r, home={n: tuple(map(Fraction, v)) for n, v in {**points, **axes}.items()}), nearest=False)
    assert (here.verdict, here.margin) == ("singular", pytest.approx(0, abs=1e-12))
    assert any(abs(abs(t.axis[0]) - 1) < 1e-9 and t.pitch == pytest.approx(0, abs=1e-9) for t in here.motions)


DRIVEN_AT_THE_PLATFORM = """
title: planar 3-RRR, driven at the platform
space: plane
copies: 3
points: {A%: free, B%: free, C%: free}
limbs: [{name: leg %, joints: "R(A%, z) R(B%, z) R*(C%, z)"}]
platform: C%
mobility: 3
home: {A1: [0, 0, 0], A2: [10, 0, 0], A3: [5, 9, 0], B1: [1, 4, 0], B2: [9, 1, 0], B3: [7, 8, 0], C1: [4, 3, 0],
  C2: [6, 3, 0], C3: [5, 5, 0]}
"""


def test_driven_ends_pass_on_moments() -> None:
    m = linkage(parse_robot(DRIVEN_AT_THE_PLATFORM))
    assert m.ball_ended == (False, False, False)
    assert margin(m, m.home).singular_values[0] <= 1


ELBOWS = """
title: a slider along the elbows of two other limbs
space: plane
points: {A1: free, B1: free, C1: free, A2: free, B2: free, C2: free, A3: free, C3: free}
limbs:
  - {name: one, joints: "R*(A1, z) R(B1, z) R(C1, z)"}
  - {name: two, joints: "R*(A2, z) R(B2, z) R(C2, z)"}
  - {name: three, joints: "R*(A3, z) P(B1 B2) R(C3, z)"}
platform: C1 C2 C3
mobility: 3
home: {A1: [0, 0, 0], A2: [10, 0, 0], A3: [5, 9, 0], B1: [1, 4, 0], B2: [9, 1, 0], C1: [4, 3, 0], C2: [6, 3, 0],
  C3: [5, 5, 0]}
"""


def test_joints_that_other_limbs_would_turn_are_refused() -> None:
    with pytest.raises(gc.InputError, match=r"P\(B1 B2\) would not stay fixed in its links"):
        gc.pose(parse_robot(ELBOWS), "x=0.2, y=0.1, yaw=5deg")


def test_helical_joints_advance_by_their_pitch() -> None:
    """Places of the hinge and of the ball joint after the turns that are given back: -3/2 for each radian."""
    text = """
title: 3-HRS
copies: 3
points: {A%: free, D%: free, B%: in plane D% perpendicular to r%}
directions: {u%: free, r%: free}
limbs: [{name: leg %, joints: "H*(A%, u%, -3/2) R(D%, r%) S(B%)"}]
platform: B%
mobility: 3
home: {A1: [3, 0, 0], A2: [-2, 3, 0], A3: [-2, -3, 0], D1: [3, 1, 0], D2: [-3, 3, 0], D3: [-2, -4, 0], u1: [0, 0, 2],
  u2: [0, 1, 2], u3: [1, 0, 3], r1: [0, 1, 0], r2: [1, 1, 0], r3: [1, -1, 0], B1: [1, 1, 2], B2: [-2, 2, 2],
  B3: [-1, -3, 3]}
"""
    r = parse_robot(text)
    assert r.home is not None
    home = {n: np.array([float(c) for c in v]) for n, v in r.home.items()}
    here = gc.pose(r, "x=0.1, y=0.05, z=-0.04", nearest=False)
    for k, q in zip("123", here.actuator_values.values(), strict=True):
        u = home[f"u{k}"] / np.linalg.norm(home[f"u{k}"])
        turn = rotations(q * u)
        hinge = home[f"A{k}"] + turn @ (home[f"D{k}"] - home[f"A{k}"]) - 1.5 * q * u
        arm = np.array(here.points[f"B{k}"]) - hinge
        assert np.array(here.points[f"D{k}"]) == pytest.approx(hinge, abs=1e-9)
        assert arm @ (turn @ home[f"r{k}"]) == pytest.approx(0, abs=1e-9)
        assert np.linalg.norm(arm) == pytest.approx(float(np.linalg.norm(home[f"B{k}"] - home[f"D{k}"])), abs=1e-9)


SLEEVES = """
title: 3-CS
copies: 3
points: {A%: free, B%: free}
directions: {u%: free}
limbs: [{name: leg %, joints: "C*2(A%, u%) S(B%)"}]
platform: B%
mobility: 3
home: {A1: [3, 0, 0], A2: [-2, 3, 0], A3: [-2, -3, 0], u1: [0, 0, 2], u2: [0, 1, 2], u3: [1, 0, 3], B1: [1, 0, 2],
  B2: [-1, 1, 2], B3: [-1, -1, 3]}
"""


def test_cylindrical_joints_slide_by_what_is_given_back() -> None:
    r = parse_robot(SLEEVES)
    assert r.home is not None
    home = {n: np.array([float(c) for c in v]) for n, v in r.home.items()}
    here = gc.pose(r, "z=0.05, roll=1deg, pitch=-1deg", nearest=False)
    for k, q in zip("123", here.actuator_values.values(), strict=True):
        u = home[f"u{k}"] / np.linalg.norm(home[f"u{k}"])
        then, now = (p - home[f"A{k}"] for p in (home[f"B{k}"], np.array(here.points[f"B{k}"])))
        assert (now - then) @ u == pytest.approx(q, abs=1e-9)
        assert np.linalg.norm(np.cross(now, u)) == pytest.approx(float(np.linalg.norm(np.cross(then, u))), abs=1e-9)


def test_coordinates_that_turn_back_are_named() -> None:
    """At 24.4% of this way z, roll and pitch stop to determine the pose; no factor of the condition vanishes there."""
    with pytest.raises(gc.InputError, match=r"24\.4% .* z, roll and pitch hardly determine the pose"):
        gc.pose(parse_robot(SLEEVES), "z=0.3, roll=5deg, pitch=-4deg")


PLANES = """
title: 3-PEU
copies: 3
points: {A%: free}
directions: {n%: free, u%: free, v%: free}
limbs: [{name: leg %, joints: "P*(n%) E(A%, n%) U*1(A%, u%, v%)"}]
platform: A%
mobility: 6
home: {A1: [3, 0, 0], A2: [-2, 3, 0], A3: [-2, -3, 1], n1: [0, 0, 2], n2: [0, 1, 2], n3: [1, 0, 3], u1: [1, 1, 0],
  u2: [1, 0, 0], u3: [0, 1, 0], v1: [1, -1, 1], v2: [0, 1, 2], v3: [1, 0, 1]}
"""


def test_planar_joints_keep_their_distance() -> None:
    r = parse_robot(PLANES)
    assert r.home is not None
    home = {n: np.array([float(c) for c in v]) for n, v in r.home.items()}
    here = gc.pose(r, "0.1 0.2 0.3; euler zyx 5 6 7 deg", nearest=False)
    driven = list(here.actuator_values.values())[::2]
    for k, q in zip("123", driven, strict=True):
        n = home[f"n{k}"] / np.linalg.norm(home[f"n{k}"])
        assert (np.array(here.points[f"A{k}"]) - home[f"A{k}"]) @ n == pytest.approx(q, abs=1e-9)


def test_limbs_by_themselves_are_left_out_of_the_guarantee() -> None:
    """Close to the reach of an arm of a Delta robot it is singular by itself long before asin σ is used up."""
    here = gc.pose(analysed("delta"), "x=0, y=0, z=-2.4", nearest=False)
    assert here.limbs[0].margin < 0.1
    assert here.turn > 0.15
    assert here.reason.startswith("Apart from the limbs' own singularities, no configuration is singular while")


def test_degrees_of_text() -> None:
    here = gc.pose("3-rpr", {"x": "0.1", "y": 0, "yaw": "5"}, degrees=True, nearest=False)
    assert here.coordinates["yaw"] == pytest.approx(np.deg2rad(5))


# --- many at once -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["delta", "tricept", "capaman", "reachy-mini-head", "h4", "5-rpur"])
def test_limbs_move_together_as_each_by_itself(name: str) -> None:
    start = Configurations.of([machine(name).home])
    rng = np.random.default_rng(7)
    amounts = [rng.uniform(-0.3, 0.3, (5, len(c.turns))) for c in start.chains]
    links, there = start.moved(amounts)
    alone = [c.links(a) for c, a in zip(start.chains, amounts, strict=True)]
    expected = start.after(amounts, alone)
    for one, other in zip(links, alone, strict=True):
        assert one == pytest.approx(other, abs=1e-14)
    for chain, known in zip(there.chains, expected.chains, strict=True):
        assert chain.screws == pytest.approx(known.screws, abs=1e-14 * machine(name).size)
    assert there.platform == pytest.approx(expected.platform, abs=1e-14 * machine(name).size)
