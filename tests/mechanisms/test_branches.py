"""Ways from home keep to one branch and say whether they cross a singular configuration: against other roads."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import pairwise, product

import numpy as np
import pytest
from click.testing import CliRunner
from places import DATA

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics import solve as solving
from gcrules.mechanisms.kinematics.arms import Alike, Arm, Spread, spreads
from gcrules.mechanisms.kinematics.branch import Cells
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage, linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.rigid_motions import exponential, rotations
from gcrules.mechanisms.kinematics.solve import Solution, closed_near, free_coordinates, goal, solve
from gcrules.mechanisms.kinematics.targets import Target, actuators_target, coordinates_target, pose_target
from gcrules.mechanisms.kinematics.tubes import follows, keeps_rank
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.remark import home_remark
from gcrules.poses.limbs.way_from_home import WayFromHome, way_from_home
from gcrules.rules.plugin import shipped_folder
from gcrules.screws.pose_text import parse_pose

IDS = tuple(one.id for one in robots())
MOVED = DATA / "moved"
FINE = 48  # steps of the second road


@cache
def machine(name: str) -> Linkage:
    return linkage(read_robot(name if name in IDS else MOVED / f"{name}.yaml"))


@cache
def analysis(name: str) -> RobotAnalysis:
    return analyze_robot(machine(name).robot)


# --- working modes against closed forms ------------------------------------------------------------------------------


def eye_angles(m: Linkage, turn: np.ndarray) -> np.ndarray:
    """The actuators of the Agile Eye by its closed form: v = ±u × w, its sign that of home all along the way, for the
    elbow is at right angles to u and w; the angle followed in 4000 steps.
    """
    motions = rotations(np.linspace(0, 1, 4001)[:, None] * turn)
    found = []
    for k in "123":
        u, v, w = (m.home.values[f"{letter}{k}"] for letter in "uvw")
        elbow = np.cross(u, motions @ w)
        elbow *= np.sign(elbow[0] @ v)
        found.append(np.unwrap(np.arctan2(elbow @ np.cross(u, v), elbow @ v))[-1])
    return np.array(found)


def test_a_limb_close_to_its_singularity_does_not_jump() -> None:
    m = machine("agile-eye")
    here = gc.pose(analysis("agile-eye"), "rx=6.209deg, ry=171.201deg, rz=-10.544deg")
    assert np.degrees(here.actuator_values["q3"]) == pytest.approx(-183.64, abs=0.005)
    assert list(here.actuator_values.values()) == pytest.approx(
        eye_angles(m, np.radians([6.209, 171.201, -10.544])), abs=1e-8
    )
    assert here.assembly.doubt is None
    assert here.to_json()["assembly"]["branch_proved"] is True
    assert "proved: one continuous solution" in here.text()


@pytest.mark.parametrize("seed", range(3))
def test_random_orientations_keep_their_working_mode(seed: int) -> None:
    m = machine("agile-eye")
    rng = np.random.default_rng(seed)
    for axis in rng.normal(size=(6, 3)):
        turn = axis / np.linalg.norm(axis) * rng.uniform(1, 3.1)
        s = solve(m, coordinates_target(m, dict(zip(("rx", "ry", "rz"), turn, strict=True))))
        assert s.doubt is None
        reached = [s.configuration.joint_values[a.place][a.coordinate] for a in m.actuators]
        assert reached == pytest.approx(eye_angles(m, turn), abs=1e-7)


CRANKS = ("3-rrr", "6-rus", "4-ruu")


@pytest.mark.parametrize("name", CRANKS)
def test_cranks_stay_on_their_side(name: str) -> None:
    """A crank from A to B and a rod from B to C: the side of the rod on which the crank turns is that of home, by the
    sign of the discriminant's root, wherever the branch is proved."""
    m = machine(name)
    rng = np.random.default_rng(11)
    met = 0
    for _ in range(5):
        wanted = coordinates_target(
            m, {n: 0.2 * rng.normal() * (m.size if n in "xyz" else 1) for n in free_coordinates(m)}
        )
        try:
            s = solve(m, wanted)
        except gc.InputError:
            continue
        assert s.doubt is None
        met += 1
        for limb in m.robot.limbs:
            names = [n for j in limb.joints for n in j.names if j.args and m.robot.family.sorts.get(n) == "point"]
            A, B, C = dict.fromkeys(names)
            axis = np.array([0, 0, 1.0]) if "z" in limb.joints[0].names else m.home.values[limb.joints[0].names[-1]]
            sides = []
            for values in (m.home.values, s.configuration.values):
                a, b, c = (np.asarray(values[n]) for n in (A, B, C))
                sides.append(np.sign(np.cross(b - a, c - b) @ axis))
            assert sides[0] == sides[1] != 0, limb.name
    assert met >= 2


# --- every robot against steps so fine that they need no proof -------------------------------------------------------


def finely(m: Linkage, wanted: Target) -> list[Configuration]:
    course, here = Course(m, wanted), [m.home]
    for k in range(1, FINE + 1):
        here.append(closed_near(course, here[-1], k / FINE))
    return here


def passive_determinant(m: Linkage, here: Configuration) -> float | None:
    """That of the loops by the amounts of all passive joints, None where it is not square: another matrix than that of
    the wrenches, which vanishes with it and where the passive joints of a limb are singular."""
    keep = [2, 3, 4] if m.robot.family.plane else list(range(6))
    twists = []
    for place, chain in enumerate(here.chains):
        driven = {a.coordinate for a in m.actuators if a.place == place}
        driven |= {k for p, k, _ in m.locked if p == place}
        passive = [k for k in range(len(chain.turns)) if k not in driven]
        twists.append(chain.shared_twists[:, keep][..., passive])
    loops = [{n: own} for n, every in enumerate(twists) for own in every[1:]]  # a limb's own
    loops += [{0: -twists[0][0], n: every[0]} for n, every in enumerate(twists) if n]
    blocks = [
        np.concatenate([loop.get(n, np.zeros_like(every[0])) for n, every in enumerate(twists)], axis=1)
        for loop in loops
    ]
    whole = np.concatenate(blocks)
    return float(np.linalg.det(whole)) if whole.shape[0] == whole.shape[1] else None


def random_targets(m: Linkage, seed: int) -> list[Target]:
    rng = np.random.default_rng(seed)
    amounts = {n: 0.3 * rng.normal() * (m.size if n in "xyz" else 1) for n in free_coordinates(m)}
    driven = [0.15 * rng.normal() * (1 if a.angle else m.size) for a in leading(m)]
    return [coordinates_target(m, amounts), actuators_target(m, driven)]


@pytest.mark.parametrize("name", [*IDS, "4-ruu-opposite"])
def test_ways_against_fine_steps(name: str) -> None:
    m = machine(name)
    for wanted in random_targets(m, 3):
        try:
            s = solve(m, wanted)
        except gc.InputError:
            continue
        fine = finely(m, wanted)
        if s.doubt is not None:  # no way of this family is left without a proof, but at a zero of the constraints
            assert margin(m, fine[round(s.doubt * FINE)]).sigma < 1e-3
            assert way_from_home(m, s).same is None
            continue
        for n, place in s.configuration.values.items():
            assert place == pytest.approx(fine[-1].values[n], abs=1e-6 * max(1.0, m.size)), n
        mode = way_from_home(m, s)
        determinants = [passive_determinant(m, c) for c in fine]
        if None not in determinants:
            changes = sum(a * b < 0 for a, b in pairwise(determinants) if a is not None and b is not None)
            assert changes % 2 == len(mode.crossings) % 2
        if mode.same:
            assert min(margin(m, c).sigma for c in fine) > 1e-6
        for part in mode.crossings:
            there = goal(Course(m, wanted), Solution(m.home, wanted), 0.0, part)
            assert margin(m, there.configuration).sigma < 1e-3


@pytest.mark.parametrize("name", IDS)
def test_steps_gone_at_once_are_those_gone_one_by_one(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    m = machine(name)
    for wanted in random_targets(m, 5):
        try:
            at_once = solve(m, wanted)
        except gc.InputError:
            continue
        with monkeypatch.context() as patch:
            patch.setattr(solving, "gone_at_once", lambda *_: None)
            stepped = solve(m, wanted)
        assert at_once.doubt == stepped.doubt
        assert at_once.parts[-1] == stepped.parts[-1] == 1
        for n, place in at_once.configuration.values.items():
            assert place == pytest.approx(stepped.configuration.values[n], abs=1e-7 * max(1.0, m.size)), n
        for before, after, part in zip((m.home, *at_once.way), at_once.way, at_once.parts, strict=False):
            there = closed_near(Course(m, wanted), before, part)
            for a, b in zip(after.joint_values, there.joint_values, strict=True):
                assert a == pytest.approx(b, abs=1e-7 * max(1.0, m.size)), "the amounts of each step by its own limbs"


@pytest.mark.parametrize("name", IDS)
def test_what_is_sought_near_a_solution_is_what_is_found_from_home(name: str) -> None:
    m = machine(name)
    rng = np.random.default_rng(7)
    for wanted in random_targets(m, 3):
        near = None
        for share in (0.5, 0.52, 0.54, 0.53, 0.2):
            beside = 0.01 * rng.normal(size=len(wanted.names)) * Course(m, wanted).weights
            target = Target(wanted.names, share * wanted.values + beside, wanted.driven)
            try:
                alone = solve(m, target)
            except gc.InputError:
                continue
            found = solve(m, target, near)
            assert found.doubt == alone.doubt
            assert max(c.residual for c in found.way) < 1e-9
            for n, place in alone.configuration.values.items():
                assert place == pytest.approx(found.configuration.values[n], abs=1e-7 * max(1.0, m.size)), n
            for before, after, part in zip((m.home, *found.way), found.way, found.parts, strict=False):
                there = closed_near(Course(m, target), before, part)
                for a, b in zip(after.joint_values, there.joint_values, strict=True):
                    assert a == pytest.approx(b, abs=1e-7 * max(1.0, m.size)), (
                        "the amounts of each step by its own limbs"
                    )
            near = found


def test_nothing_is_sought_anew_near_a_solution(monkeypatch: pytest.MonkeyPatch) -> None:
    """Up to where the 3-RPS robot is nearly singular, parts are halved where the proof needs it."""
    m = machine("3-rps")
    near = solve(m, actuators_target(m, [-0.4, 0.0, 0.0]))
    monkeypatch.setattr(solving, "goal", None)
    for amount in (-0.44, -0.48, -0.5, -0.51, -0.52, -0.53):
        near = solve(m, actuators_target(m, [amount, 0.0, 0.0]), near)
        assert near.doubt is None
        assert near.parts == tuple(sorted(near.parts))


def test_what_is_known_of_another_kind_of_values_is_not_used() -> None:
    m = machine("delta")
    driven = solve(m, actuators_target(m, [0.1, 0.1, 0.1]))
    wanted = coordinates_target(m, {"x": 0.01, "y": 0.0, "z": 0.0})
    assert solve(m, wanted, driven).iterations == solve(m, wanted).iterations
    far = actuators_target(m, [0.3, 0.1, 0.1])
    assert solve(m, far, driven).iterations == solve(m, far).iterations


def test_what_ends_on_its_way_is_no_solution_near_by() -> None:
    m = machine("delta")
    wanted = actuators_target(m, [0.3, 0.3, 0.25])
    half = goal(Course(m, wanted), Solution(m.home, wanted), 0.0, 0.5)
    found, alone = solve(m, wanted, half), solve(m, wanted)
    assert found.parts == alone.parts
    assert found.configuration.platform == pytest.approx(alone.configuration.platform)


def test_rods_that_spin_are_no_branches() -> None:
    """A rod between two ball joints spins idly: the same actuators and proofs as with a universal joint at its end."""
    spinning, plain = machine("6-pss"), machine("6-pus")
    rng = np.random.default_rng(1)
    for _ in range(3):
        given = {n: 0.2 * rng.normal() * (plain.size if n in "xyz" else 1) for n in free_coordinates(plain)}
        found = []
        for m in (spinning, plain):
            s = solve(m, coordinates_target(m, given))
            assert way_from_home(m, s).same is True
            found.append([s.configuration.joint_values[a.place][a.coordinate] for a in m.actuators])
        assert found[0] == pytest.approx(found[1], abs=1e-9)


def test_most_ways_are_told() -> None:
    """The proofs are not vacuous: of short ways most are proved to stay on home's mode."""
    same = []
    for name in IDS:
        m = machine(name)
        for wanted in random_targets(m, 8):
            short = Target(wanted.names, 0.2 * wanted.values, wanted.driven, None, wanted.text)
            if wanted.whole is not None:
                short = pose_target(m, parse_pose("0.01 0.02 0.01; euler zyx 1 2 -1 deg"))
            try:
                same.append(way_from_home(m, solve(m, short)).same)
            except gc.InputError:
                continue
    assert len(same) > 30
    assert sum(s is True for s in same) >= 0.9 * len(same)


# --- robots without a condition, and cofactors ----------------------------------------------------------------------


def test_a_crossing_is_told_without_a_condition() -> None:
    here = gc.pose(analysis("3-5r"), "x=-0.06, y=0.055, roll=-2.1deg", nearest=False)
    assert not here.factors
    assert here.mode.startswith("the way from home crosses a singular configuration")
    assert here.assembly.same is False


def test_where_a_crossing_lies() -> None:
    m = machine("5-rpur")
    here = gc.pose(analysis("5-rpur"), "x=0, y=0, z=0, roll=0deg, yaw=35deg", nearest=False)
    assert len(here.factors) == 1
    assert here.mode.startswith("the way from home crosses a singular configuration")
    (part,) = here.assembly.crossings
    wanted = coordinates_target(m, {"x": 0, "y": 0, "z": 0, "roll": 0, "yaw": np.radians(35)})
    sigma = [margin(m, c).sigma for c in finely(m, wanted)]
    assert abs(int(np.argmin(sigma)) / FINE - part) <= 1 / FINE
    at = goal(Course(m, wanted), Solution(m.home, wanted), 0.0, part).configuration
    assert margin(m, at).sigma < 1e-4 * max(sigma)
    assert here.assembly.same is False
    said = gc.pose(analysis("5-rpur"), "x=0, y=0, z=0, roll=0deg, yaw=-35deg", nearest=False)
    assert said.mode == "that of home, proved: no configuration on the way from there is singular"


def test_a_cofactor_is_no_crossing() -> None:
    a = analysis("4-ruu-opposite")
    home = gc.pose(a, nearest=False)
    there = gc.pose(a, "x=0, y=0.25, z=0, yaw=0deg", nearest=False)
    assert home.verdict == there.verdict == "regular"
    assert there.assembly.same is True
    (f,), (g,) = home.factors, there.factors
    assert f.cofactor
    assert abs(f.cofactor_value) > 0.9  # legs 1 and 2 are parallel at home: their pairing would have 0
    assert f.value * g.value > 0
    assert "divided by the cofactor" in home.text(unicode=True)
    assert home.to_json()["factors"][0]["cofactor"]["value"] == f.cofactor_value


@pytest.mark.parametrize("name", ["4-ruu", "4-ruu-opposite", "tricept"])
def test_factors_by_cofactors_vanish_with_the_wrenches_alone(name: str) -> None:
    """The quotient and σ vanish together: on random ways one changes its sign where the other comes to 0."""
    m, a = machine(name), analysis(name)
    rng = np.random.default_rng(4)
    for _ in range(3):
        wanted = coordinates_target(
            m, {n: 0.2 * rng.normal() * (m.size if n in "xyz" else 1) for n in free_coordinates(m)}
        )
        try:
            mode = way_from_home(m, solve(m, wanted))
        except gc.InputError:
            continue
        home = gc.pose(a, nearest=False).factors
        there = gc.pose(a, dict(zip(wanted.names, wanted.values, strict=True)), nearest=False).factors
        for f, g in zip(home, there, strict=True):
            assert (f.value * g.value < 0) == (len(mode.crossings) % 2 == 1)


# --- homes that are singular ------------------------------------------------------------------------------------------

SINGULAR_HOMES = {
    "3-prr-singular": "the lines B1C1, B2C2 and B3C3 meet",
    "4-upu-singular": "actuation",
    "3-upu-snu": "parallel to one",
}


@pytest.mark.parametrize("name", SINGULAR_HOMES)
def test_singular_homes_are_told(name: str) -> None:
    remark = home_remark(analysis(name))
    assert remark.startswith("home is singular")
    assert SINGULAR_HOMES[name] in remark
    path = str(MOVED / f"{name}.yaml")
    assert f"warning: {remark}" in CliRunner().invoke(cli, ["robot", "check", path]).stdout
    done = CliRunner().invoke(cli, ["robot", "analyze", path, "--json"])
    assert done.stderr == f"warning: {remark}\n"
    json.loads(done.stdout)


@pytest.mark.parametrize("power", [0, 4, 8, 20])
def test_robots_far_from_the_origin_are_measured_from_near_them(power: int) -> None:
    r = machine("3-rps").robot
    assert r.home is not None
    sorts = r.family.sorts
    shift = 10**power * (power > 0)
    home = {n: tuple(c + (shift if sorts[n] == "point" else 0) for c in v) for n, v in r.home.items()}
    far = replace(r, home=home)
    centre = [Fraction(1, n) for n in (2, 3, 5)]
    for asked in (
        {},
        {"at": "z=0.2, pitch=0.1rad, roll=0.1rad"},
        {"at": "z=0.2, pitch=0.1rad, roll=0.1rad", "about": [c + shift for c in centre]},
    ):
        here = gc.pose(far, **asked, nearest=False)
        near = gc.pose(r, **({**asked, "about": centre} if "about" in asked else asked), nearest=False)
        assert any("measured from" in n for n in here.notes) == (power > 3)
        assert not any("away from the origin" in n for n in here.notes)
        assert abs(here.margin - near.margin) <= 1e-12


# --- the bounds themselves --------------------------------------------------------------------------------------------


def random_arm(rng: np.random.Generator, count: int) -> Arm:
    axes = rng.normal(size=(count, 3))
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    turns = rng.random(count) < 0.7
    screws = np.where(
        turns[:, None],
        np.concatenate([axes, np.cross(rng.normal(size=(count, 3)), axes)], axis=1),
        np.concatenate([np.zeros_like(axes), axes], axis=1),
    )
    chain = Chain(screws, tuple(range(count)), np.ones(count), tuple(map(bool, turns)))
    return Arm.several([chain], [0.2 * rng.normal(size=count)], np.zeros(3), 1.0)[0]


def motion(arm: Arm, amounts: np.ndarray) -> np.ndarray:
    found = np.eye(4)
    for screw, amount in zip(arm.screws, amounts, strict=True):
        found = found @ exponential(screw, float(amount))
    return found


def reading(x: np.ndarray) -> np.ndarray:
    odd = (x[:3, :3] - x[:3, :3].T) / 2
    return np.array([odd[2, 1], odd[0, 2], odd[1, 0], *x[:3, 3]])


@pytest.mark.parametrize("seed", range(6))
def test_bounds_of_derivatives_hold(seed: int) -> None:
    """First and second derivatives against differences, the third ones' bound against second ones nearby."""
    rng = np.random.default_rng(seed)
    arm = random_arm(rng, 5)
    (spread,) = spreads([arm])
    middle = arm.amounts / 2
    back = np.linalg.inv(motion(arm, middle))
    step = 1e-4

    def slope(q: np.ndarray) -> np.ndarray:
        ends = [[reading(motion(arm, q + s * step * e) @ back) for s in (1, -1)] for e in np.eye(5)]
        return np.array([(a - b) / (2 * step) for a, b in ends]).T

    assert slope(middle) == pytest.approx(spread.first, abs=1e-7)
    for k, e in enumerate(np.eye(5)):
        bent = (slope(middle + step * e) - slope(middle - step * e)) / (2 * step)
        assert bent == pytest.approx(spread.second[:, k], abs=1e-5)
    reach = np.full(5, 0.15)
    turned, moved = third(spread, reach)
    for _ in range(40):
        d = rng.uniform(-1, 1, size=5) * reach
        rest = slope(middle + d) - spread.first - spread.second @ d
        assert (np.linalg.norm(rest[:3], axis=0) <= turned / 2 + 1e-6).all()
        assert (np.linalg.norm(rest[3:], axis=0) <= moved / 2 + 1e-6).all()


def third(spread: Spread, reach: np.ndarray) -> np.ndarray:
    """The bounds of third derivatives in the turn and in the shift."""
    (alike,) = Alike.among([spread])
    (found,) = alike.third(reach[None])
    return found


@pytest.mark.parametrize("seed", range(6))
def test_bounds_of_third_derivatives_are_sums_over_all_triples(seed: int) -> None:
    """Beside the triples one by one: the two first motions turn, the last one of the three moves the point."""
    rng = np.random.default_rng(seed)
    (spread,) = spreads([random_arm(rng, 6)])
    far = rng.random(6)
    speeds = spread.speeds.copy()
    for k in reversed(range(6)):
        speeds[k] += spread.turns[k] * (far[k + 1 :] * speeds[k + 1 :]).sum()
    turned, moved = np.zeros(6), np.zeros(6)
    for triple in product(range(6), repeat=3):
        first, second, last = sorted(triple)
        both = spread.turns[first] * spread.turns[second] * far[triple[0]] * far[triple[1]]
        turned[triple[2]] += both * spread.turns[last]
        moved[triple[2]] += both * speeds[last]
    for found, wanted in zip(third(spread, far), (turned, moved), strict=True):
        assert found == pytest.approx(wanted, rel=1e-12)


def four_bar(open_by: float) -> list[Arm]:
    """Two arms in the plane that meet, the first one driven: nearly stretched where `open_by` is small."""
    crank = np.array([[0, 0, 1, 0, 0, 0]], dtype=float)
    elbow = np.array([1.0, open_by, 0])
    rows = [[0, 0, 1, *np.cross(p, [0, 0, 1])] for p in ([2, 0, 0], elbow, [0.0, 0, 0])]
    first = Arm(crank, (0,), np.ones(1), np.array([0.02]))
    second = Arm(np.array(rows), (0, 1, 2), np.ones(3), np.zeros(3), block=1)
    return [first, second]


def test_what_is_stretched_is_not_proved() -> None:
    free = [np.array([False]), np.array([True, True, True])]
    assert all(np.isinf(t).all() for t in follows(spreads(four_bar(0.0)), free, 0))
    tube = [np.zeros(1), np.zeros(3)]
    assert not keeps_rank(spreads(four_bar(0.0)), free, 0, tube)
    assert keeps_rank(spreads(four_bar(0.8)), free, 0, tube)


def test_freedoms_that_stay_at_rest_count() -> None:
    """A pair of rods may turn about itself at once, though it has to stay parallel: here the platform can turn, and
    nowhere near is a proof that it cannot."""
    text = (shipped_folder() / "delta" / "robot.yaml").read_text(encoding="utf-8")
    home = {"d1": "[0, 1, -5]", "d2": "[3/2, 1, -5]", "d3": "[3/2, -1, -5]"}  # each in the plane of its hinge and z
    lines = [f"  {n}: {home[n]}" if (n := line.split(":")[0].strip()) in home else line for line in text.splitlines()]
    m = linkage(parse_robot("\n".join(lines)))
    here = Configurations.of([m.home])
    assert margin(m, m.home).sigma < 1e-12
    for width in (1e-6, 1e-3, 0.05):
        cells = Cells.around(m, Target(("x", "y", "z"), np.zeros(3)), here, np.full((1, 3), width))
        assert not cells.regular[0]
    plain = linkage(read_robot("delta"))
    cells = Cells.around(
        plain, Target(("x", "y", "z"), np.zeros(3)), Configurations.of([plain.home]), np.full((1, 3), 1e-3)
    )
    assert cells.regular[0]


def test_words_of_modes() -> None:
    assert WayFromHome(at_home=True).text == "that of home"
    assert WayFromHome(doubt=0.25).text.startswith("not known: its branch is not proved beyond 25% of the way")
    assert WayFromHome(doubt=0.25).same is None
    assert WayFromHome(regular=0.4).same is None
    assert "is not proved at 40% of the way" in WayFromHome(regular=0.4).text
    assert WayFromHome(unknown=0.5, regular=0.4).text.startswith("not known: the sign")
    assert WayFromHome(crossings=(0.25, 0.5)).text.endswith("at 25% and 50% of it")
    assert WayFromHome(regular=0.9999).text.startswith("not known")
    near = WayFromHome(regular=0.99995, unknown=1.0, ends_singular=True)
    assert near.text == "that of home, proved up to 99.99% of the way from there; its end is singular"
    assert (near.same, WayFromHome().same, WayFromHome(crossings=(0.5,)).same) == (None, True, False)
    assert "may be another solution" in WayFromHome(doubt=0.1).branch


def test_parts_of_rotation_vectors_are_not_proved() -> None:
    """One or two components of the rotation vector: solved, but the branch is said to be open."""
    here = gc.pose("3-rps", {"z": 0.1, "rx": 0.1, "ry": 0.05}, nearest=False)
    assert here.assembly.doubt == 0
    assert here.mode.startswith("not known")
