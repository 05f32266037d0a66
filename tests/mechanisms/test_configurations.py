"""Robots in configurations: margin and its guarantee, singular places, faults, Python and shell."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanisms.bodies import chains
from mechanisms.moved_robots import analysed, machine, robot, there
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import FileError
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage, linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.margin import LimbMargin, _locked, limb_margins, margin
from gcrules.mechanisms.kinematics.rigid_motions import cross_matrix
from gcrules.mechanisms.kinematics.solve import Solution, goal, solve
from gcrules.mechanisms.kinematics.targets import (
    coordinates_target,
    pose_target,
    read_actuators,
    read_pose,
)
from gcrules.mechanisms.kinematics.wrench_jacobian import wrench_jacobian
from gcrules.mechanisms.load import read_robot
from gcrules.rules.plugin import shipped_folder
from gcrules.screws import FLOATS
from gcrules.screws.pose_text import parse_pose

IDS = tuple(one.id for one in robots())


# --- margin -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["gough-stewart", "gough-stewart-63", "octahedral"])
def test_margin_is_that_of_platforms(name: str) -> None:
    m = machine(name)
    names = [(limb.joints[0].points[0], limb.joints[-1].points[0]) for limb in m.robot.limbs]
    points = {n: [float(c) for c in m.home.values[n]] for pair in names for n in pair}
    legs = [list(pair) for pair in names]
    platform = gc.load({"legs": legs, "points": points})
    for text in ("0 0 0", "0.5 0.2 -0.7; euler zyx 20 10 -15 deg"):
        about = tuple(float(c) for c in m.centre)
        expected = gc.pose(platform, text, about=about, nearest=False)
        s = solve(m, pose_target(m, parse_pose(text)))
        assert margin(m, s.configuration).sigma == pytest.approx(expected.margin, abs=1e-9)
        j = wrench_jacobian(m, s.configuration, margin(m, s.configuration))
        assert j.smallest_singular_value == pytest.approx(expected.jacobian.smallest_singular_value, abs=1e-9)


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


NO_LENGTH = ("3-rrr-spherical", "agile-eye")
"""All their axes go through one point."""
FREE = [n for n in IDS if not names_the_frame(read_robot(n))]
"""Robots that do not name directions of the frame."""


@pytest.mark.parametrize("name", FREE)
def test_margin_knows_neither_frame_nor_unit(name: str) -> None:
    m = machine(name)
    other = elsewhere(m, Fraction(1000))
    assert other.size == pytest.approx(1000 * m.size) or name in NO_LENGTH
    assert margin(other, other.home).sigma == pytest.approx(margin(m, m.home).sigma, abs=1e-9)
    if name not in NO_LENGTH:
        here, there = (limb_margins(one, Configurations.of([one.home])) for one in (m, other))
        assert here == pytest.approx(there, abs=1e-9)


@pytest.mark.parametrize("name", IDS)
def test_margin_is_at_most_one_and_takes_its_motion(name: str) -> None:
    m, c = machine(name), there(name, 0.6).configuration
    found = margin(m, c)
    assert 0 <= found.sigma <= 1
    assert found.singular_values[0] <= 1 + 1e-12  # of no motion more is noticed than there is
    if m.looped:  # a body of a limb may move more easily than the platform
        assert found.sigma == pytest.approx(min(least(m, c, found), least_of_all_bodies(m, c)), abs=1e-9)
    else:
        assert power(m, c, found, -1) == pytest.approx(found.sigma, abs=1e-9)


def power(m: Linkage, c: Configuration, found: LimbMargin, place: int) -> float:
    """√(Σ |P ξ|² / Σ (|v|² + ε ρ²|ω|²)) from the limbs, one by one."""
    v, w = found.motions[place][:3], found.motions[place][3:]
    above = below = 0.0
    for k, chain in enumerate(c.chains):
        end = c.platform[:3, :3] @ m.ends[k] + c.platform[:3, 3]
        velocity = v + np.cross(w, end - found.centre)
        wrenches = _locked(m, k, chain, end)
        above += float(((wrenches[:, :3] @ velocity + wrenches[:, 3:] @ (m.size * w)) ** 2).sum())
        below += float(velocity @ velocity) + (0 if m.ball_ended[k] else m.size**2 * float(w @ w))
    return (above / below) ** 0.5


def least(m: Linkage, c: Configuration, found: LimbMargin) -> float:
    """The least power of all twists of the platform, by its extremes in 6 dimensions."""
    above = np.zeros((6, 6))
    below = np.zeros((6, 6))
    for k, chain in enumerate(c.chains):
        end = c.platform[:3, :3] @ m.ends[k] + c.platform[:3, 3]
        moved = at_end(end - found.centre, m.size)
        wrenches = _locked(m, k, chain, end) @ moved
        above += wrenches.T @ wrenches
        weights = np.diag([1.0, 1, 1, *3 * [0.0 if m.ball_ended[k] else 1.0]])
        below += moved.T @ weights @ moved
    return smallest(above, below)


def least_of_all_bodies(m: Linkage, c: Configuration) -> float:
    """The same over the twists of all bodies, from the joint screws of each chain between two of them."""
    places = {"platform": 0}
    terms = []
    for k, limb in enumerate(m.robot.limbs):
        end = c.platform[:3, :3] @ m.ends[k] + c.platform[:3, 3]
        for start, stop, chain in chains(m.robot, {n: tuple(v) for n, v in c.values.items()}, FLOATS, [limb]):
            wrenches = np.asarray(chain.locked(FLOATS), dtype=float).reshape(-1, 6)
            f, moment = wrenches[:, :3], wrenches[:, 3:] - np.cross(end, wrenches[:, :3])
            unit = np.linalg.qr(np.concatenate([f, moment / m.size], axis=1).T)[0].T
            signs = {b: s for b, s in ((start, -1), (stop, 1)) if b != "base"}
            for b in signs:
                places.setdefault(b, len(places))
            terms.append((unit, at_end(end - m.centre, m.size), signs))
    above = np.zeros((6 * len(places), 6 * len(places)))
    below = above.copy()
    for unit, moved, signs in terms:
        difference = np.zeros((6, len(above)))
        for b, sign in signs.items():
            difference[:, 6 * places[b] : 6 * places[b] + 6] = sign * moved
        above += difference.T @ unit.T @ unit @ difference
        below += difference.T @ difference
    return smallest(above, below)


def at_end(arm: np.ndarray, size: float) -> np.ndarray:
    """From twists (v; ρω) about a centre to those at an arm from there."""
    return np.block([[np.eye(3), -cross_matrix(arm) / size], [np.zeros((3, 3)), np.eye(3)]])


def smallest(above: np.ndarray, below: np.ndarray) -> float:
    """The least √(x'Ax / x'Bx)."""
    inverse = np.linalg.inv(np.linalg.cholesky(below))
    return float(max(0.0, np.linalg.eigvalsh(inverse @ above @ inverse.T)[0]) ** 0.5)


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
def singular(name: str) -> Any:
    found = gc.singular(analysed(name), SINGULAR[name])
    assert found is not None
    return found


@pytest.mark.parametrize("name", SINGULAR)
def test_singular_configurations_are_found_and_true(name: str) -> None:
    found = singular(name)
    assert found.verdict == "singular"
    assert found.margin < 1e-9
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
    part = float(found.target.partition("%")[0]) / 100
    way = Course(m, read_pose(m, SINGULAR[name]))
    s = goal(way, Solution(m.home, way.target), 0.0, part)
    assert largest_turn(m, m.home, s.configuration) >= np.arcsin(margin(m, m.home).sigma) - 1e-6


def test_determinants_change_their_sign_where_it_is_singular() -> None:
    """The lines of a 3-RPS robot written down by hand: force along the leg, force through S along the hinge."""
    found = singular("3-rps")
    roll = found.coordinates["roll"]
    signs = []
    for angle in (roll - 1e-4, roll + 1e-4):
        at = gc.pose(analysed("3-rps"), {"z": 0, "roll": angle, "pitch": 0}, nearest=False).points
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


RAILS = """
title: planar robot on rails
copies: 3
space: plane
points: {A%: free, B%: A% + e%, C%: free}
directions: {e%: free}
limbs: [{name: leg %, joints: "P*(A% B%) R(B%, z) R(C%, z)"}]
platform: C%
mobility: 3
home: {A1: [0, 0, 0], A2: [5, 0, 0], A3: [2, 5, 0], e1: [1, 0, 0], e2: [0, 1, 0], e3: [0, -1, 0], C1: [2, 1, 0],
  C2: [3, 2, 0], C3: [2.5, 2, 0]}
"""

SHARED_RAIL = """
title: a carriage with the name of a hinge of the base
space: plane
points: {A1: free, A3: free, C1: free, C2: free, C3: free}
directions: {e: free}
limbs:
  - {name: one, joints: "P*(e) R(A1, z) R(C1, z)"}
  - {name: two, joints: "R(A1, z) P*(A1 C2) R(C2, z)"}
  - {name: three, joints: "R(A3, z) P*(A3 C3) R(C3, z)"}
platform: C1 C2 C3
mobility: 3
home: {A1: [0, 0, 0], A3: [2, 5, 0], e: [1, 0, 0], C1: [2, 1, 0], C2: [3, 1, 0], C3: [2.5, 2, 0]}
"""

TWO_BODIES = {
    "a point": (
        SHARED_RAIL,
        "R(A1, z) P*(A1 C2)",
        "A1 would be in two places: it is carried by what P*(e) of one moves and by the base",
    ),
    "a direction": (
        """
title: rails of which one turns
space: plane
points: {A1: free, A2: free, C1: free, C2: free}
directions: {e: free}
limbs:
  - {name: one, joints: "P*(e) R(A1, z) R*(C1, z)"}
  - {name: two, joints: "R*(A2, z) P(e) R(C2, z)"}
platform: C1 C2
mobility: 3
""",
        "R*(A2, z) P(e)",
        "e would have two directions: it is carried by the base and by what R*(A2, z) of two moves",
    ),
    "a direction of the frame": (
        """
title: wrist with an axis of the frame on the platform
points: {O: free, A%: free, B%: free}
copies: 3
limbs: [{name: leg %, joints: "S(A%) P*(A% B%) U(B%, x, y)"}, {name: centre, joints: "S(O)"}]
platform: O B%
mobility: 3
""",
        "S(A%)",
        "x would have two directions: it is carried by the base and by what P*(A1 B1) of leg 1 moves",
    ),
}


def test_what_its_relation_holds_needs_a_name_of_its_own() -> None:
    with pytest.raises(
        gc.InputError, match=r"B2 would violate its relation, A2 [+] e2: it is carried by what P"
    ) as caught:
        gc.pose(parse_robot(RAILS), "x=0.1, y=0, yaw=0deg")
    assert "a name of its own" in str(caught.value.hint)


@pytest.mark.parametrize(("text", "where", "said"), TWO_BODIES.values(), ids=TWO_BODIES)
def test_what_two_bodies_carry_apart_is_refused_where_it_stands(text: str, where: str, said: str) -> None:
    with pytest.raises(FileError) as caught:
        parse_robot(text)
    assert caught.value.message == said
    line, column = map(int, str(caught.value.place).split(":")[-2:])
    assert text.splitlines()[line - 1][column - 1 :].lstrip('"').startswith(where)
    assert "give a name of its own to one of them" in str(caught.value.hint)


def test_a_robot_that_is_singular_at_home() -> None:
    """Its three legs meet in a point."""
    r = robot("3-rpr")
    assert r.home is not None
    r = replace(r, home={**r.home, **{n: tuple(map(Fraction, v)) for n, v in CONCURRENT.items()}})
    here = gc.pose(r)
    assert (here.verdict, here.margin, len(here.motions)) == ("singular", pytest.approx(0, abs=1e-12), 1)
    assert here.motions[0].point == pytest.approx((3, 1.5, 0))  # where the legs meet
    with pytest.raises(gc.InputError, match="singular at home"):
        gc.pose(r, actuators=[0.1, 0, 0])


def test_ways_that_cross_a_singular_configuration_are_told() -> None:
    assert "crosses a singular" in gc.pose(analysed("3-rps"), "z=0, roll=60deg, pitch=0deg", nearest=False).mode
    assert gc.pose(analysed("3-rps"), "z=0, roll=40deg, pitch=0deg", nearest=False).mode.startswith("that of home")


def test_none_is_found_where_none_is() -> None:
    assert gc.singular(analysed("3-rps"), "z=0.1, roll=1deg, pitch=0deg") is None


# --- from Python and from the shell ----------------------------------------------------------------------------------


def test_ways_to_ask() -> None:
    r = analysed("3-rps")
    here = gc.pose(r, {"z": 0.2, "roll": 5, "pitch": 0}, degrees=True, nearest=False)
    for same in (
        gc.pose(r, "z=0.2, roll=5deg, pitch=0deg", nearest=False),
        gc.pose(r, {"z": 0.2, "roll": np.pi / 36, "pitch": 0}, nearest=False),
        gc.pose(r, actuators=list(here.actuator_values.values()), nearest=False),
        gc.pose(r, actuators=here.actuator_values, nearest=False),
    ):
        assert same.margin == pytest.approx(here.margin, abs=1e-9)
        assert same.coordinates == pytest.approx(here.coordinates, abs=1e-9)
    assert gc.pose(r, (0, 0, 0.2), nearest=False).margin == pytest.approx(gc.pose(r, "0 0 0.2", nearest=False).margin)
    assert gc.pose(r, nearest=False).target == "home"
    assert [
        one.margin for one in gc.pose(r, ["0 0 0.2", {"z": 0.2, "roll": 0, "pitch": 0}], nearest=False)
    ] == pytest.approx([0.609] * 2, abs=1e-3)
    assert repr(here) == "<RobotPose 3-rps: regular, margin 0.5913, 36.2°>"


def test_json_is_complete() -> None:
    found = gc.pose(analysed("delta"), "x=0.1, y=0, z=0.3").to_json()
    assert json.loads(json.dumps(found, allow_nan=False))["points"] == found["points"]
    assert [len(found["jacobian"]["rows"]), len(found["actuators"]), len(found["limbs"])] == [6, 3, 3]
    assert found["guarantees"]["turn"] == pytest.approx(np.arcsin(found["margin"]))
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
    "unknown actuator": (["3-rps", "--actuators", "p1=0"], "is not an actuator"),
    "pose and actuators": (["3-rps", "--at", "0 0 0", "--actuators", "q1=0"], "at once"),
    "out of reach": (["delta", "--at", "x=0, y=0, z=-5"], "near its reach"),
    "whole pose out of reach": (["delta", "--at", "0 0 -5"], "48.1% of the way"),
    "flipped out of the plane": (["3-rpr", "--at", "0 0 0; euler zyx 0 0 180 deg"], "plane z = 0"),
    "pitch": (["3-rps", "--at", "z=0, roll=0deg, pitch=90deg"], "between -90deg and 90deg"),
    "rotation vector": (["3-rps", "--at", "z=0, rx=0deg, ry=200deg"], "shorter than half a turn"),
    "far out of reach": (["6-rus", "--at", "0 0 1e3"], "of the way"),
    "absurdly far": (["3-rps", "--actuators", "q1=1e9"], "more than 10,000 times the robot's size"),
    "threshold": (["3-rps", "--threshold", "5mm"], "the threshold is an angle, not 5mm"),
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


def test_the_accuracy_of_a_platform_is_refused_for_robots() -> None:
    result = CliRunner().invoke(cli, ["pose", "3-rps", "--accuracy=1"])
    assert (result.exit_code, "is for platforms on six legs" in result.stderr) == (2, True)


def test_any_mechanism_turns_about_any_centre() -> None:
    at = "x=0.1, yaw=10deg, roll=5deg"
    for source in ("gough-stewart", gc.analyze(as_platform(read_robot("gough-stewart")))):
        ends = [gc.pose(source, at, about=about, nearest=False) for about in ((1, 2, 3), "1, 2, 3", "origin")]
        assert ends[0].margin == ends[1].margin != ends[2].margin
    one, two = (
        gc.pose(source, at, about="1,2,3", nearest=n) for source, n in (("gough-stewart", False), (source, False))
    )
    assert one.margin == pytest.approx(two.margin, rel=1e-9)


@pytest.mark.parametrize("source", ["3-rps", "gough-stewart", str(EXAMPLES / "octahedral.yaml")])
def test_home_is_a_pose(source: str) -> None:
    """By its name, for every kind of robot."""
    expected: Any = gc.pose(source, nearest=False)
    found: Any = gc.pose(source, " Home ", nearest=False)
    assert found.margin == pytest.approx(expected.margin, abs=1e-12)


def test_pose_reads_robots_and_platforms() -> None:
    folder = shipped_folder()
    assert folder is not None
    path = str(folder / "3-rps" / "robot.yaml")
    answers = [CliRunner().invoke(cli, ["pose", name, "--json", "--no-nearest"]).stdout for name in ("3-rps", path)]
    answers.append(CliRunner().invoke(cli, ["robot", "pose", "3-rps", "--json", "--no-nearest"]).stdout)
    with open(path, encoding="utf-8") as file:
        answers.append(CliRunner().invoke(cli, ["pose", "-", "--json", "--no-nearest"], input=file.read()).stdout)
    found = [json.loads(a)["margin"] for a in answers]
    assert found == [found[0]] * 4
    refused = CliRunner().invoke(cli, ["pose", "examples/octahedral.yaml", "--actuators", "q1=0"])
    assert (refused.exit_code, "actuators are for robots" in refused.stderr) == (2, True)


def test_a_way_without_singular_configurations_is_a_definite_no() -> None:
    at = ["--at", "z=0.1, roll=1deg, pitch=0deg", "--search"]
    result = CliRunner().invoke(cli, ["robot", "pose", "3-rps", *at])
    assert (result.exit_code, "is singular, proved" in result.stdout) == (1, True)


def test_ways_that_are_not_decided_say_so() -> None:
    """The way passes a place so near to a singular one that neither a change of sign nor a proof is had there."""
    with pytest.raises(gc.LimitReached, match="not decided"):
        gc.singular("gantry-tau", "x=0, y=-0.613, z=0")


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
    s = solve(m, coordinates_target(m, {"z": z, "roll": roll, "pitch": pitch}))
    assert s.configuration.residual < 1e-9
    assert s.configuration.disagreement < 1e-9


def test_cross_matrices() -> None:
    a, b = np.array([1.0, 2, 3]), np.array([-2.0, 0, 5])
    assert cross_matrix(a) @ b == pytest.approx(np.cross(a, b))
