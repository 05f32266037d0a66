"""Robots in configurations: loops close, on an independent road; closeness, its guarantee; singular places; faults."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.limb_file import LimbText, read_joints
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.chains import SHAPES, chain_of
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage, linkage
from gcrules.mechanisms.kinematics.margin import Closeness, _locked, closeness, limb_closeness
from gcrules.mechanisms.kinematics.rigid_motions import cross_matrix, exponential, inverse, logarithm, rotations
from gcrules.mechanisms.kinematics.solve import Course, Solution, free_coordinates, goal, solve
from gcrules.mechanisms.kinematics.targets import (
    read_actuators,
    read_pose,
    wanted_actuators,
    wanted_coordinates,
    wanted_pose,
)
from gcrules.mechanisms.kinematics.wrenches import wrench_jacobian
from gcrules.mechanisms.load import read_robot
from gcrules.rules.plugins import shipped_folder
from gcrules.screws import FLOATS, JOINTS, RATIONALS
from gcrules.screws.pose_text import parse_pose

IDS = tuple(one.id for one in robots())
PARTS = (0.6,)

STEPS = {"x": 0.1, "y": -0.15, "z": 0.2, "roll": 0.1, "pitch": -0.15, "yaw": 0.2}
"""How far coordinates go: lengths in parts of the robot's size, rad."""


@cache
def machine(name: str) -> Linkage:
    return linkage(read_robot(name))


def moves(m: Linkage, part: float, more: Mapping[str, float] | None = None) -> dict[str, float]:
    found = {n: STEPS[n] for n in free_coordinates(m)}
    for n, step in (more or {}).items():
        found[n] += step
    return {n: part * v * (m.size if n in "xyz" else 1) for n, v in found.items()}


@cache
def there(name: str, part: float) -> Solution:
    m = machine(name)
    return solve(m, wanted_coordinates(m, moves(m, part)))


# --- loops close: from the places of points and directions alone -----------------------------------------------------

# What each kind of joint has on the link before it and on that after it.
SIDES: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "R": (("point", "axis"), ("point", "axis")),
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
        near, far = (values[joint.args[0][k][1]] for k in (1, 0))
        found |= {"near": ("point", near), "far": ("point", far)}
    return found


def bodies(m: Linkage, values: Mapping[str, Any]) -> Iterator[tuple[str, list[tuple[str, Any]]]]:
    """Every rigid body with the points and directions on it."""
    base: list[tuple[str, Any]] = [("direction", axis) for axis in np.eye(3)] + [("point", np.zeros(3))]
    platform: list[tuple[str, Any]] = []
    for limb in m.robot.limbs:
        parts = [geometry(j, values) for j in limb.joints]
        base += [parts[0][p] for p in SIDES[limb.joints[0].kind][0]]
        platform += [parts[-1][p] for p in SIDES[limb.joints[-1].kind][1]]
        for k, (a, b) in enumerate(zip(limb.joints, limb.joints[1:], strict=False)):
            own = [parts[k][p] for p in SIDES[a.kind][1]] + [parts[k + 1][p] for p in SIDES[b.kind][0]]
            yield f"{limb.name}, link {k + 1}", own
        for k, j in enumerate(limb.joints):
            if j.kind == "U":
                yield f"{limb.name}, cross {k}", [parts[k]["first"], parts[k]["second"]]
            if j.kind in ("Pa", "4S"):
                yield f"{limb.name}, bar {k}", [("point", np.zeros(3)), ("point", parts[k]["bars"][1])]
    yield "base", base
    yield "platform", platform


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
    amounts = {a.name: s.configuration.amounts[a.place][a.coordinate] for a in m.actuators}
    back = solve(m, wanted_actuators(m, amounts))
    assert back.configuration.platform == pytest.approx(s.configuration.platform, abs=1e-8 * m.size)


@pytest.mark.parametrize("name", IDS)
def test_rates_are_those_of_the_jacobian(name: str) -> None:
    """Finite differences of solutions: constraints do no work, actuations have the rates of their actuators."""
    m, s = machine(name), there(name, 0.6)
    j = wrench_jacobian(m, s.configuration, closeness(m, s.configuration))
    step = 1e-5
    for n in free_coordinates(m):
        ends = [
            solve(m, wanted_coordinates(m, moves(m, 0.6, {n: sign * step / 0.6}))).configuration for sign in (1, -1)
        ]
        twist = logarithm(ends[0].platform @ inverse(ends[1].platform)) / (2 * step)
        w, v = twist[:3], twist[3:] + np.cross(twist[:3], j.centre)
        rates = [
            (ends[0].amounts[a.place][a.coordinate] - ends[1].amounts[a.place][a.coordinate]) / (2 * step)
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
    s = solve(m, wanted_pose(m, pose))
    rotation = np.array([[float(c) for c in row] for row in pose.rotation])
    shift = np.array([float(c) for c in pose.translation])
    for a, limb in zip(m.actuators, m.robot.limbs, strict=True):
        (start,), (end,) = limb.joints[0].points, limb.joints[-1].points
        A, B = m.home.values[start], m.home.values[end]
        moved = rotation @ (B - m.centre) + m.centre + shift
        length = np.linalg.norm(moved - A) - np.linalg.norm(B - A)
        assert s.configuration.amounts[a.place][a.coordinate] == pytest.approx(length, abs=1e-9)


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
    assert set(SHAPES) == set(SAMPLES) == set(JOINTS)


@pytest.mark.parametrize("kind", SAMPLES)
def test_motions_have_the_twists_of_the_joint(kind: str) -> None:
    limb = LimbText("limb", read_joints(SAMPLES[kind]))
    chain = chain_of(limb, VALUES)
    twists = chain.twists(chain.links(np.zeros(len(chain.turns)))).T
    own = np.array(limb.at({n: tuple(v) for n, v in VALUES.items()}, FLOATS).twists(FLOATS))
    rank = np.linalg.matrix_rank(own)
    assert rank == len(JOINTS[kind].freedoms) == np.linalg.matrix_rank(twists)
    assert np.linalg.matrix_rank(np.concatenate([own, twists]), tol=1e-9) == rank


@pytest.mark.parametrize("kind", SAMPLES)
def test_twists_are_the_derivatives_of_motions(kind: str) -> None:
    chain = chain_of(LimbText("limb", read_joints(SAMPLES[kind] + " R(B, x)")), VALUES)
    amounts = np.linspace(0.3, -0.4, len(chain.turns))
    links = chain.links(amounts)
    for k, twist in enumerate(chain.twists(links).T):
        step = 1e-6 * np.eye(len(amounts))[k]
        ahead, behind = chain.links(amounts + step)[-1], chain.links(amounts - step)[-1]
        assert logarithm(ahead @ inverse(behind)) / 2e-6 == pytest.approx(twist, abs=1e-7)


def test_bars_swing_on_circles() -> None:
    """A parallelogram keeps the orientation; its far hinge stays at the same distance from the near one."""
    for text, amounts in (("Pa(A B, w)", [1.2]), ("4S(A, B, v)", [0.9, -0.7, 0, 0])):
        chain = chain_of(LimbText("limb", read_joints(text)), VALUES)
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


# --- closeness -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["gough-stewart", "gough-stewart-63", "octahedral"])
def test_closeness_is_that_of_platforms(name: str) -> None:
    m = machine(name)
    names = [(limb.joints[0].points[0], limb.joints[-1].points[0]) for limb in m.robot.limbs]
    points = {n: [float(c) for c in m.home.values[n]] for pair in names for n in pair}
    legs = [list(pair) for pair in names]
    platform = gc.load({"legs": legs, "points": points})
    for text in ("0 0 0", "0.5 0.2 -0.7; euler zyx 20 10 -15 deg"):
        about = tuple(float(c) for c in m.centre)
        expected = gc.pose(platform, text, about=about, nearest=False)
        s = solve(m, wanted_pose(m, parse_pose(text)))
        assert closeness(m, s.configuration).sigma == pytest.approx(expected.closeness, abs=1e-9)
        j = wrench_jacobian(m, s.configuration, closeness(m, s.configuration))
        assert j.smallest_singular_value == pytest.approx(expected.smallest_singular_value, abs=1e-9)


def elsewhere(m: Linkage, scale: Fraction) -> Linkage:
    """The same robot in another frame and unit."""
    third = Fraction(1, 3)
    turn = [[third * c for c in row] for row in ((1, 2, 2), (2, 1, -2), (-2, 2, -1))]
    assert m.robot.home is not None
    home = {}
    for n, v in m.robot.home.items():
        x, y, z = (sum(c * d for c, d in zip(row, v, strict=True)) for row in turn)
        shift = (5, -7, 2) if m.robot.family.sorts[n] == "point" else (0, 0, 0)
        home[n] = tuple(scale * (c + s) for c, s in zip((x, y, z), shift, strict=True))
    return linkage(replace(m.robot, home=home))


def names_the_frame(r: gc.Robot) -> bool:
    used = {n for limb in r.limbs for j in limb.joints for n in j.names}
    return bool(used & {"x", "y", "z"}) or any(d.relation.kind == "sum" for d in r.family.definitions)


FREE = [n for n in IDS if not names_the_frame(read_robot(n))]
"""Robots that do not name directions of the frame."""


@pytest.mark.parametrize("name", FREE)
def test_closeness_knows_neither_frame_nor_unit(name: str) -> None:
    m = machine(name)
    other = elsewhere(m, Fraction(1000))
    assert other.size == pytest.approx(1000 * m.size) or name == "3-rrr-spherical"
    assert closeness(other, other.home).sigma == pytest.approx(closeness(m, m.home).sigma, abs=1e-9)
    if name != "3-rrr-spherical":  # has no length of its own
        assert limb_closeness(other, other.home) == pytest.approx(limb_closeness(m, m.home), abs=1e-9)


@pytest.mark.parametrize("name", IDS)
def test_closeness_is_at_most_one_and_takes_its_motion(name: str) -> None:
    m, c = machine(name), there(name, 0.6).configuration
    found = closeness(m, c)
    assert 0 <= found.sigma <= 1
    assert found.singular_values[0] <= 1 + 1e-12  # of no motion more is noticed than there is
    assert power(m, c, found, -1) == pytest.approx(found.sigma, abs=1e-9)


def power(m: Linkage, c: Configuration, found: Closeness, place: int) -> float:
    """√(Σ |P ξ|² / Σ (|v|² + ε ρ²|ω|²)) from the limbs, one by one."""
    v, w = found.motions[place][:3], found.motions[place][3:]
    above = below = 0.0
    for k, chain in enumerate(c.chains):
        end = c.platform[:3, :3] @ m.ends[k] + c.platform[:3, 3]
        velocity = v + np.cross(w, end - found.centre)
        wrenches = _locked(m, k, chain, end)
        above += float(((wrenches[:, :3] @ velocity + wrenches[:, 3:] @ (m.size * w)) ** 2).sum())
        below += float(velocity @ velocity) + (0 if m.firm[k] else m.size**2 * float(w @ w))
    return (above / below) ** 0.5


def largest_turn(m: Linkage, a: Configuration, b: Configuration) -> float:
    """The largest angle between the wrenches of a limb in two configurations, seen from the platform."""
    worst = 0.0
    for k in range(len(m.ends)):
        systems = []
        for c in (a, b):
            end = c.platform[:3, :3] @ m.ends[k] + c.platform[:3, 3]
            rows = _locked(m, k, c.chains[k], end)
            back = c.platform[:3, :3]
            systems.append(np.concatenate([rows[:, :3] @ back, rows[:, 3:] @ back], axis=1))
        cosines = np.linalg.svd(systems[0] @ systems[1].T, compute_uv=False)
        worst = max(worst, float(np.arccos(min(1.0, cosines.min()))))
    return worst


# --- singular configurations -----------------------------------------------------------------------------------------

SINGULAR = {
    "3-rps": "z=0, roll=60deg, pitch=0deg",
    "3-prs": "z=0, roll=60deg, pitch=0deg",
    "octahedral": "0 0 0; euler zyx 120 0 0 deg",
}


@cache
def robot(name: str) -> gc.Robot:
    return read_robot(name)


@cache
def analysed(name: str) -> Any:
    return analyze_robot(robot(name))


@cache
def singular(name: str) -> Any:
    found = gc.singular(analysed(name), SINGULAR[name])
    assert found is not None
    return found


@pytest.mark.parametrize("name", SINGULAR)
def test_singular_configurations_are_found_and_true(name: str) -> None:
    found = singular(name)
    assert found.verdict == "singular"
    assert found.closeness < 1e-9
    assert found.causes
    assert len(found.motions) == 1
    assert any(abs(f.value) < 1e-9 for f in found.factors if f.live)
    assert found.mode.startswith("that of home")
    # the wrenches from the joint screws, not from the lines of the condition
    rows = found.jacobian.rows.copy()
    rows[:, 3:] /= found.jacobian.length
    assert np.linalg.svd(rows, compute_uv=False)[-1] < 1e-8
    # the guarantee of home held on the way
    m = machine(name)
    part = float(found.wanted.partition("%")[0]) / 100
    way = Course(m, read_pose(m, SINGULAR[name]))
    s = goal(way, Solution(m.home, way.wanted), 0.0, part)
    assert largest_turn(m, m.home, s.configuration) >= np.arcsin(closeness(m, m.home).sigma) - 1e-6


def test_determinants_change_their_sign_where_it_is_singular() -> None:
    """The lines of a 3-RPS robot written down by hand: force along the leg, force through S along the hinge."""
    found = singular("3-rps")
    roll = found.coordinates["roll"]
    signs = []
    for angle in (roll - 1e-4, roll + 1e-4):
        at = gc.pose(analysed("3-rps"), {"z": 0, "roll": angle, "pitch": 0}).points
        rows = []
        for n in "123":
            A, S, r = (np.array(at[f"{letter}{n}"]) for letter in "ASr")
            rows += [[*(S - A), *np.cross(A, S - A)], [*r, *np.cross(S, r)]]
        signs.append(np.sign(np.linalg.det(np.array(rows))))
    assert sorted(signs) == [-1, 1]


def test_gained_motions_are_noticed_by_no_limb() -> None:
    found = singular("3-rps")
    (motion,) = found.motions
    assert motion.point is not None
    assert motion.pitch is not None
    w = np.array(motion.axis)
    v = np.cross(np.array(motion.point) - found.jacobian.centre, w) + motion.pitch * w
    rows = found.jacobian.rows
    assert rows[:, :3] @ v + rows[:, 3:] @ w == pytest.approx(0, abs=1e-9)


CONCURRENT = {"A1": (0, 0, 0), "A2": (6, 0, 0), "A3": (3, 5, 0), "B1": (2, 1, 0), "B2": (4, 1, 0), "B3": (3, 3, 0)}


@pytest.mark.parametrize("name", ["3-rps", "octahedral"])
def test_dependent_wrenches_balance(name: str) -> None:
    found = singular(name)
    assert np.sum([limb.force for limb in found.limbs], axis=0) == pytest.approx(0, abs=1e-9)
    assert np.sum([limb.moment for limb in found.limbs], axis=0) == pytest.approx(0, abs=1e-9)
    assert max(limb.share for limb in found.limbs) == 1
    assert "Dependent wrenches" in found.text()


BARS = """
title: pairs of bars on driven universal joints
copies: 3
points: {O%: free, A%: free, B%: free}
directions: {d%: free, p%: free, q%: free}
limbs: [{name: arm %, joints: "U*(O%, p%, q%) 4S(A%, B%, d%)"}]
mobility: 6
home: {O1: [5, 0, 3], A1: [5, 0, 0], B1: [5, 1, 0], d1: [-3, 0, 2], O2: [-3, 4, 3], A2: [-3, 4, 0], B2: [-4, 4, 0],
  d2: [1, -3, 2], O3: [-3, -4, 3], A3: [-3, -4, 0], B3: [-4, -4, 0], d3: [2, 3, 1], p1: [1, 0, 0], q1: [0, 1, 0],
  p2: [1, 0, 0], q2: [0, 1, 0], p3: [1, 0, 0], q3: [0, 1, 0]}
"""


def test_bars_that_would_not_stay_parallel_are_refused() -> None:
    r = parse_robot(BARS)
    assert gc.pose(r, "0.1 0.2 0.3; euler xyz 5 0 0 deg").residual < 1e-9  # turns about the first driven axes
    with pytest.raises(gc.InputError, match="would not stay parallel"):
        gc.pose(r, "0 0 0; euler xyz 0 0 5 deg")


def test_a_robot_that_is_singular_at_home() -> None:
    """Its three legs meet in a point."""
    r = robot("3-rpr")
    assert r.home is not None
    r = replace(r, home={**r.home, **{n: tuple(map(Fraction, v)) for n, v in CONCURRENT.items()}})
    here = gc.pose(r)
    assert (here.verdict, here.closeness, len(here.motions)) == ("singular", pytest.approx(0, abs=1e-12), 1)
    assert here.motions[0].point == pytest.approx((3, 1.5, 0))  # where the legs meet
    with pytest.raises(gc.InputError, match="singular at home"):
        gc.pose(r, actuators=[0.1, 0, 0])


def test_ways_that_cross_a_singular_configuration_are_told() -> None:
    assert "crosses a singular" in gc.pose(analysed("3-rps"), "z=0, roll=60deg, pitch=0deg").mode
    assert gc.pose(analysed("3-rps"), "z=0, roll=40deg, pitch=0deg").mode.startswith("that of home")


def test_none_is_found_where_none_is() -> None:
    assert gc.singular(analysed("3-rps"), "z=0.1, roll=1deg, pitch=0deg") is None


# --- from Python and from the shell ----------------------------------------------------------------------------------


def test_ways_to_ask() -> None:
    r = analysed("3-rps")
    here = gc.pose(r, {"z": 0.2, "roll": 5, "pitch": 0}, degrees=True)
    for same in (
        gc.pose(r, "z=0.2, roll=5deg, pitch=0deg"),
        gc.pose(r, {"z": 0.2, "roll": np.pi / 36, "pitch": 0}),
        gc.pose(r, actuators=list(here.actuator_values.values())),
        gc.pose(r, actuators=here.actuator_values),
    ):
        assert same.closeness == pytest.approx(here.closeness, abs=1e-9)
        assert same.coordinates == pytest.approx(here.coordinates, abs=1e-9)
    assert gc.pose(r, (0, 0, 0.2)).closeness == pytest.approx(gc.pose(r, "0 0 0.2").closeness)
    assert gc.pose(r).wanted == "home"
    assert [one.closeness for one in gc.pose(r, ["0 0 0.2", {"z": 0.2, "roll": 0, "pitch": 0}])] == pytest.approx(
        [0.609] * 2, abs=1e-3
    )
    assert repr(here) == "<RobotPose 3-rps: regular, closeness 0.5913, 36.3°>"


def test_json_is_complete() -> None:
    found = gc.pose(analysed("delta"), "x=0.1, y=0, z=0.3").to_json()
    assert json.loads(json.dumps(found, allow_nan=False))["points"] == found["points"]
    assert [len(found["jacobian"]["rows"]), len(found["actuators"]), len(found["limbs"])] == [6, 3, 3]
    assert found["guarantees"]["turn"] == pytest.approx(np.arcsin(found["closeness"]))
    assert {f["kind"] for f in found["factors"]} == {"actuation", "constraint"}


def test_text_in_ascii_is_ascii() -> None:
    assert gc.pose(analysed("3-rps")).text().isascii()
    assert "tabular" in gc.pose(analysed("3-rps")).latex()


HOMELESS = "copies: 3\ntitle: t\npoints: {A%: free, S%: 'in plane A% perpendicular to r%'}\ndirections: {r%: free}\n"
HOMELESS += "limbs: [{name: leg %, joints: 'R(A%, r%) P*(A% S%) S(S%)'}]\nmobility: 3\n"
LINES = "title: t\npoints: {A%: free, B%: free}\ncopies: 6\nlines: A1B1 A2B2 A3B3 A4B4 A5B5 A6B6\nmobility: 6\n"

FAULTS = {
    # name: (arguments, what is said)
    "unknown coordinate": (["3-rps", "--at", "z=1, rol=5deg"], "did you mean roll?"),
    "not a number": (["3-rps", "--at", "z=nan, roll=0deg, pitch=0deg"], "finite number"),
    "infinite": (["3-rps", "--at", "z=inf, roll=0deg, pitch=0deg"], "finite number"),
    "no unit": (["3-rps", "--at", "z=1, roll=5, pitch=0deg"], "angle without a unit"),
    "angle for a length": (["3-rps", "--at", "z=1deg, roll=5deg, pitch=0deg"], "z is a length"),
    "unit of length": (["3-rps", "--at", "z=1mm, roll=5deg, pitch=0deg"], "names no unit"),
    "too few": (["3-rps", "--at", "z=1"], "too few coordinates: 1"),
    "too many": (["3-rps", "--at", "x=0, y=0, z=1, yaw=0deg"], "too many coordinates: 4"),
    "dependent": (["3-rps", "--at", "x=0, y=0, z=1"], "do not determine the pose of 3-rps near home"),
    "two kinds of turn": (["3-rps", "--at", "z=0, roll=5deg, rx=0deg"], "two ways"),
    "out of the plane": (["3-rpr", "--at", "x=0, y=0, z=1"], "plane z = 0"),
    "twice": (["3-rps", "--at", "z=1, z=2, roll=0deg"], "given twice"),
    "no value": (["3-rps", "--at", "z=1, roll"], "gives no value"),
    "empty": (["3-rps", "--at", "=,"], "gives no value"),
    "a whole pose that it cannot take": (["3-rps", "--at", "0 0 0; euler xyz 5 0 0 deg"], "mobility 3"),
    "unknown actuator": (["3-rps", "--actuators", "p1=0"], "is no actuator"),
    "pose and actuators": (["3-rps", "--at", "0 0 0", "--actuators", "q1=0"], "at once"),
    "out of reach": (["delta", "--at", "x=0, y=0, z=-5"], "near its reach"),
    "whole pose out of reach": (["delta", "--at", "0 0 -5"], "48.1% of the way"),
    "flipped out of the plane": (["3-rpr", "--at", "0 0 0; euler zyx 0 0 180 deg"], "plane z = 0"),
    "pitch": (["3-rps", "--at", "z=0, roll=0deg, pitch=90deg"], "between -90deg and 90deg"),
    "rotation vector": (["3-rps", "--at", "z=0, rx=0deg, ry=200deg"], "shorter than half a turn"),
    "far out of reach": (["6-rus", "--at", "0 0 1e6"], "of the way"),
    "threshold": (["3-rps", "--threshold", "5mm"], "names no unit"),
    "unknown robot": (["3-rp"], "did you mean 3-rps"),
}


SHARED = ("unknown coordinate", "pose and actuators", "out of reach", "unknown robot")


@pytest.mark.parametrize(
    ("command", "name"),
    [*((("robot", "pose"), name) for name in FAULTS), *((("pose",), name) for name in SHARED)],
    ids=lambda x: x if isinstance(x, str) else " ".join(x),
)
def test_faults(command: tuple[str, ...], name: str) -> None:
    arguments, said = FAULTS[name]
    result = CliRunner().invoke(cli, [*command, *arguments])
    assert result.exit_code == 2, result.output
    assert said in result.stderr
    assert "Traceback" not in result.output


@pytest.mark.parametrize("text", [HOMELESS, LINES], ids=["no home", "given by lines"])
def test_robots_without_configurations(text: str) -> None:
    with pytest.raises(gc.InputError, match=r"no home|given by its lines"):
        gc.pose(parse_robot(text))


@pytest.mark.parametrize("option", ["--nearest", "--accuracy=1"])
def test_options_of_platforms_are_refused_for_robots(option: str) -> None:
    result = CliRunner().invoke(cli, ["pose", "3-rps", option])
    assert (result.exit_code, "is for platforms on six legs" in result.stderr) == (2, True)


def test_any_mechanism_turns_about_any_centre() -> None:
    at = "x=0.1, yaw=10deg, roll=5deg"
    for source in ("gough-stewart", gc.analyze(as_platform(read_robot("gough-stewart")))):
        ends = [gc.pose(source, at, about=about, nearest=False) for about in ((1, 2, 3), "1, 2, 3", "origin")]
        assert ends[0].closeness == ends[1].closeness != ends[2].closeness
    one, two = (
        gc.pose(source, at, about="1,2,3", nearest=n) for source, n in (("gough-stewart", False), (source, False))
    )
    assert one.closeness == pytest.approx(two.closeness, rel=1e-9)


def test_pose_reads_robots_and_platforms() -> None:
    folder = shipped_folder()
    assert folder is not None
    path = str(folder / "3-rps" / "robot.yaml")
    answers = [CliRunner().invoke(cli, ["pose", name, "--json"]).stdout for name in ("3-rps", path)]
    answers.append(CliRunner().invoke(cli, ["robot", "pose", "3-rps", "--json"]).stdout)
    with open(path, encoding="utf-8") as file:
        answers.append(CliRunner().invoke(cli, ["pose", "-", "--json"], input=file.read()).stdout)
    found = [json.loads(a)["closeness"] for a in answers]
    assert found == [found[0]] * 4
    refused = CliRunner().invoke(cli, ["pose", "examples/octahedral.yaml", "--actuators", "q1=0"])
    assert (refused.exit_code, "actuators are for robots" in refused.stderr) == (2, True)


def test_searches_that_find_nothing_are_undecided() -> None:
    at = ["--at", "z=0.1, roll=1deg, pitch=0deg", "--search"]
    result = CliRunner().invoke(cli, ["robot", "pose", "3-rps", *at])
    assert (result.exit_code, "no singular configuration was found" in result.stderr) == (3, True)


@settings(max_examples=60, deadline=None)
@given(st.text(alphabet="zxrqolpitchyaw=0123456789.,;- degradnainf°/", max_size=40))
def test_texts_are_read_or_refused(text: str) -> None:
    """No text brings out anything but an answer or a fault of the input."""
    for read in (read_pose, read_actuators):
        try:
            found = read(machine("3-rps"), text)
        except gc.InputError:
            continue
        assert np.isfinite(found.values).all()


@settings(max_examples=20, deadline=None)
@given(st.tuples(*[st.floats(-0.4, 0.4)] * 3))
def test_loops_close_from_any_small_pose(numbers: tuple[float, float, float]) -> None:
    m = machine("3-rps")
    z, roll, pitch = numbers
    s = solve(m, wanted_coordinates(m, {"z": z, "roll": roll, "pitch": pitch}))
    assert s.configuration.residual < 1e-9
    assert s.configuration.off < 1e-9


def test_cross_matrices() -> None:
    a, b = np.array([1.0, 2, 3]), np.array([-2.0, 0, 5])
    assert cross_matrix(a) @ b == pytest.approx(np.cross(a, b))


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
    one, two = gc.pose(analysed(name), at), gc.pose(analysed(name), whole)
    assert list(one.actuator_values.values()) == pytest.approx(list(two.actuator_values.values()), abs=1e-8)


def test_ends_on_a_line() -> None:
    """The platform can turn about the line through the three ball joints."""
    r = robot("3-rps")
    points = {"A1": (2, 0, 0), "A2": (0, 2, 0), "A3": (-2, 0, 0), "S1": (1, 0, 2), "S2": (0, 0, 2), "S3": (-1, 0, 2)}
    axes = {"r1": (0, 1, 0), "r2": (1, 0, 0), "r3": (0, 1, 0)}
    here = gc.pose(replace(r, home={n: tuple(map(Fraction, v)) for n, v in {**points, **axes}.items()}))
    assert (here.verdict, here.closeness) == ("singular", pytest.approx(0, abs=1e-12))
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
    assert m.firm == (False, False, False)
    assert closeness(m, m.home).singular_values[0] <= 1


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
    here = gc.pose(r, "x=0.1, y=0.05, z=-0.04")
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
    here = gc.pose(r, "z=0.05, roll=1deg, pitch=-1deg")
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
    here = gc.pose(r, "0.1 0.2 0.3; euler zyx 5 6 7 deg")
    driven = list(here.actuator_values.values())[::2]
    for k, q in zip("123", driven, strict=True):
        n = home[f"n{k}"] / np.linalg.norm(home[f"n{k}"])
        assert (np.array(here.points[f"A{k}"]) - home[f"A{k}"]) @ n == pytest.approx(q, abs=1e-9)


def test_limbs_by_themselves_are_left_out_of_the_guarantee() -> None:
    """Close to the reach of an arm of a Delta robot it is singular by itself long before asin σ is used up."""
    here = gc.pose(analysed("delta"), "x=0, y=0, z=-2.4")
    assert here.limbs[0].closeness < 0.1
    assert here.turn > 0.15
    assert here.reason.startswith("The limbs' own singularities apart, there is no singular configuration before")


def test_degrees_of_text() -> None:
    here = gc.pose("3-rpr", {"x": "0.1", "y": 0, "yaw": "5"}, degrees=True)
    assert here.coordinates["yaw"] == pytest.approx(np.deg2rad(5))
