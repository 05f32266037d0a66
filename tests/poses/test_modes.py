"""All solutions of direct kinematics: counts that are known, certificates, curves; against roads of their own."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from mpmath import matrix, mp
from places import EXAMPLES, ROOT
from poses.other_roads import circle_points, lengths_of, planar_roots, sphere_points, three_on_circles

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.modes.certificates import boxes
from gcrules.poses.modes.conditions import forms_of_pairs, image, motions, quadrics
from gcrules.poses.modes.curves import curve_through, values_of
from gcrules.poses.modes.report import AssemblyModes
from gcrules.poses.modes.zeros import rank_of, zeros_of
from gcrules.rules.catalog.file import load as load_catalog
from gcrules.screws.study import study

DIETMAIER = str(EXAMPLES / "dietmaier.yaml")
LENGTHS = (1, 0.645275, 1.086284, 1.503439, 1.281933, 0.771071)
OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")


def ring(shift: int, height: str = "3") -> dict[str, Any]:
    """A platform of Griffis and Duffy's type: corners of a triangle and middles of its sides, joined to each other."""
    corners = [(0, 4), (-3, -2), (3, -2)]
    middles = [tuple(Fraction(a + b, 2) for a, b in zip(corners[i], corners[i - 2], strict=True)) for i in range(3)]
    around = [p for pair in zip(corners, middles, strict=True) for p in pair]
    points = {f"A{i}": [*map(str, around[i]), "0"] for i in range(6)}
    points |= {f"B{i}": [*map(str, around[(i + shift) % 6]), height] for i in range(6)}
    return {"legs": [f"A{i}B{i}" for i in range(6)], "points": points}


def check_lengths(found: AssemblyModes, wanted: Any = None) -> None:
    """In every mode the legs have the lengths that are held."""
    rig = found.mechanism.six_legs().rig
    body = rig.arms + rig.centre_of_turns
    held = np.array([v for _, v in found.actuators])
    if wanted is not None:
        assert np.allclose(held, wanted, rtol=1e-12)
    for mode in found.modes:
        own = lengths_of(rig.base, body, rig.centre_of_turns, mode.pose.translation, mode.pose.quaternion)
        assert np.abs(own - held).max() <= 1e-8 * rig.size


# --- the start system ----------------------------------------------------------------------------------------------


def test_the_start_system_has_forty_zeros_and_no_more() -> None:
    done = subprocess.run(
        [sys.executable, str(ROOT / "tools" / "modes_start.py"), "--check"],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
        cwd=ROOT,
        env={"PYTHONPATH": str(ROOT), "PATH": ""},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.startswith("40 zeros")


def test_motions_and_parameters_are_each_others_inverse() -> None:
    rng = np.random.default_rng(4)
    for _ in range(20):
        x = rng.normal(size=8)
        x[4:] -= x[:4] * (x[4:] @ x[:4]) / (x[:4] @ x[:4])
        motion = motions(x[None])[0]
        assert np.allclose(motion[:3, :3] @ motion[:3, :3].T, np.eye(3))
        assert np.allclose(motions(study(motion)[None])[0], motion)
        base, arms = rng.normal(size=(2, 6, 3))
        ends = arms @ motion[:3, :3].T + motion[:3, 3]
        forms, _ = forms_of_pairs(base, arms, np.linalg.norm(ends - base, axis=1))
        assert np.abs(forms @ image(motion[None])[0]).max() < 1e-9


# --- platforms on six legs -----------------------------------------------------------------------------------------


def test_forty_real_postures() -> None:
    """Dietmaier's platform, 1998."""
    found = gc.assembly_modes(DIETMAIER, actuators=LENGTHS)
    assert len(found) == 40
    assert found.certified
    assert found.completeness.proved
    assert found.completeness.complete
    check_lengths(found, LENGTHS)
    rig = found.mechanism.six_legs().rig
    places = np.array(
        [[float(c) for n in rig.structure.platform for c in rig.exact(m.pose)[n][:3]] for m in found.modes]
    )
    distances = np.abs(places[:, None] - places[None]).max(axis=2) + np.eye(40)
    bounds = [m.certificate.shift + 3 * m.certificate.turn for m in found.modes]
    assert distances.min() > 2 * max(bounds)
    assert {m.signs for m in found.modes} == {"+", "-"}


def test_lengths_are_given_in_three_ways() -> None:
    text = " ".join(map(str, LENGTHS))
    names = {f"A{n}B{n}": length for n, length in enumerate(LENGTHS, 1)}
    ways = [text, names, ", ".join(f"{n}={v}" for n, v in names.items())]
    margins = [sorted(m.margin for m in gc.assembly_modes(DIETMAIER, actuators=way).modes) for way in ways]
    assert np.allclose(margins[0], margins[1])
    assert np.allclose(margins[0], margins[2])


@pytest.mark.parametrize("at", [None, "x=20, z=-30, roll=8deg, yaw=5deg"])
def test_the_octahedral_platform_by_three_circles(at: str | None) -> None:
    """Each joint of the platform turns about a line of the base: 16 complex solutions, the real ones by bisection."""
    found = gc.assembly_modes(OCTAHEDRAL, at)
    assert found.modes[0].given
    check_lengths(found)
    assert (found.completeness.real + found.completeness.unreal, found.completeness.at_infinity) == (16, 24)
    rig = found.mechanism.six_legs().rig
    home = {n: np.array([float(c) for c in p[:3]]) for n, p in rig.exact(found.modes[0].pose).items()}
    circles = [circle_points(home[a], home[c], home[p]) for a, c, p in ("acb", "ced", "aef")]
    sides = [float(np.linalg.norm(home[p] - home[q])) for p, q in ("bd", "df", "fb")]
    other = np.array(three_on_circles(circles, sides))
    places = np.array([[[float(c) for c in rig.exact(m.pose)[n][:3]] for n in "bdf"] for m in found.modes])
    # Three points tell the pose but for the side on which the platform lies, which no point of it says.
    assert len(other) == len(places)
    for place in places:
        assert np.abs(other - place).max(axis=(1, 2)).min() < 1e-6 * rig.size


def test_a_singular_pose_is_a_double_solution() -> None:
    found = gc.assembly_modes("octahedral-singular")
    first = found.modes[0]
    assert first.given
    assert (first.verdict, first.multiplicity, first.signs) == ("singular", 2, "0")
    assert not first.certificate.proved
    assert found.completeness.complete
    assert found.completeness.singular == 4  # the mirrored pose, too
    assert [m.multiplicity for m in found.modes].count(2) == 2


@pytest.mark.parametrize(("example", "finite"), [("platform-6-6", 40), ("platform-6-4", 32), ("platform-6-3", 16)])
def test_counts_of_finite_solutions(example: str, finite: int) -> None:
    """Six joints of the base and six, four or three of the platform: 40, 32 and 16 complex solutions."""
    found = gc.assembly_modes(example)
    counts = found.completeness
    assert counts.real + counts.unreal == finite
    assert counts.certified == finite
    assert counts.proved == (finite == 40)
    assert counts.unreal % 2 == 0
    check_lengths(found)


CLASSES = {
    "6-5": 40, "6-4.1": 16, "6-4.2": 32, "5-5.1": 40, "5-5.2": 24, "5-4.1": 16, "5-4.2": 8, "5-4.3": 32, "5-4.4": 24,
    "4-4.1": 8, "4-4.2": 16, "4-4.5": 24,
}  # fmt: skip


@pytest.mark.parametrize("name", CLASSES)
def test_counts_of_classes(name: str) -> None:
    """With joints shared by legs: each solution certified, and as many of two members with random joints."""
    entry = next(e for e in load_catalog().entries if e.id == name)
    rng = random.Random(name)
    for _ in range(2):
        points = {str(n): [rng.randint(-9, 9) for _ in range(3)] for leg in entry.legs for n in leg}
        found = gc.assembly_modes({"legs": [[*map(str, leg)] for leg in entry.legs], "points": points})
        counts = found.completeness
        assert counts.real + counts.unreal == counts.certified == CLASSES[name]
        assert counts.at_infinity == 40 - CLASSES[name]
        check_lengths(found)


# --- certificates --------------------------------------------------------------------------------------------------


def test_the_box_holds_the_solution_to_forty_digits() -> None:
    rig = mechanism(OCTAHEDRAL).six_legs().rig
    lengths = np.linalg.norm(rig.arms + rig.centre_of_turns - rig.base, axis=1) / rig.size
    forms, sizes = forms_of_pairs((rig.base - rig.centre_of_turns) / rig.size, rig.arms / rig.size, lengths)
    found = zeros_of(forms, sizes).boxes
    system = quadrics(forms / np.linalg.norm(forms, axis=1, keepdims=True)).real
    with mp.workdps(40):
        for k in range(len(found.y)):
            y = matrix([mp.mpc(c) for c in found.y[k]])
            q = [matrix(one.tolist()) for one in system]
            chart = matrix([found.chart.tolist()])
            for _ in range(4):
                rows = matrix(8, 8)
                values = matrix(8, 1)
                for n, one in enumerate(q):
                    slope = one * y
                    values[n] = (y.T * slope)[0]
                    for j in range(8):
                        rows[n, j] = 2 * slope[j]
                values[7] = (chart * y)[0] - 1
                rows[7, :] = chart
                y -= mp.lu_solve(rows, values)
            off = max(abs(y[j] - mp.mpc(found.y[k][j])) for j in range(8))
            assert off <= found.radius[k] < 1e-8
            real = max(abs(mp.im(c)) for c in y) < mp.mpf(10) ** -30
            assert real == bool(found.real[k])
            assert real != bool(found.unreal[k])


def test_nothing_is_proved_of_a_double_solution_or_beside_one() -> None:
    rig = mechanism("octahedral-singular").six_legs().rig
    lengths = np.linalg.norm(rig.arms + rig.centre_of_turns - rig.base, axis=1) / rig.size
    forms, sizes = forms_of_pairs((rig.base - rig.centre_of_turns) / rig.size, rig.arms / rig.size, lengths)
    rng = np.random.default_rng(1)
    x = np.array([study(np.eye(4)) + 1e-7 * rng.normal(size=8) for _ in range(5)], dtype=complex)
    known = np.concatenate([np.tensordot(sizes, np.abs(np.ones((17, 8, 8))), axes=1) * 1e-15, np.zeros((1, 8, 8))])
    assert not boxes(quadrics(forms).real, known, x).proved.any()


def test_two_boxes_around_one_solution_are_not_apart() -> None:
    rig = mechanism(OCTAHEDRAL).six_legs().rig
    lengths = np.linalg.norm(rig.arms + rig.centre_of_turns - rig.base, axis=1) / rig.size
    forms, _ = forms_of_pairs((rig.base - rig.centre_of_turns) / rig.size, rig.arms / rig.size, lengths)
    twice = np.array([study(np.eye(4))] * 2, dtype=complex)
    found = boxes(quadrics(forms).real, np.full((7, 8, 8), 1e-14), twice)
    assert np.isfinite(found.radius).all()
    assert not found.proved.any()


@pytest.mark.parametrize("seed", range(12))
def test_random_platforms_have_forty_solutions(seed: int) -> None:
    """General, flat and small ones: none at infinity, and the pose that they are made from is among them."""
    rng = np.random.default_rng(seed)
    base, arms = rng.normal(size=(2, 6, 3))
    if seed % 3:
        base[:, 2] = arms[:, 2] = 0
        arms *= 0.05 if seed % 3 == 2 else 1
    x = rng.normal(size=8)
    x[4:] -= x[:4] * (x[4:] @ x[:4]) / (x[:4] @ x[:4])
    motion = motions(x[None])[0]
    lengths = np.linalg.norm(arms @ motion[:3, :3].T + motion[:3, 3] - base, axis=1)
    found = zeros_of(*forms_of_pairs(base, arms, lengths))
    assert (len(found.boxes.y), found.at_infinity, found.lost) == (40, 0, 0)
    real = found.boxes.y[found.boxes.real].real
    near = np.abs(real @ study(motion)) / np.linalg.norm(real, axis=1) / np.linalg.norm(study(motion))
    assert (near > 1 - 1e-9).sum() == 1


# --- self-motions --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("shift", [1, 3, 5])
@pytest.mark.parametrize("at", [None, "z=1/2, roll=10deg"])
def test_platforms_of_griffis_and_duffy_move_on_curves(shift: int, at: str | None) -> None:
    """Their forms depend on each other, for any lengths that they can have: all solutions lie on curves."""
    found = gc.assembly_modes(ring(shift), at)
    assert not found.modes
    assert found.completeness.dependent
    assert found.completeness.complete is None
    curve = next(c for c in found.curves if c.through_given)
    assert len(curve.poses) > 20
    rig = found.mechanism.six_legs().rig
    held = np.array([v for _, v in found.actuators])
    body = rig.arms + rig.centre_of_turns
    for pose in curve.poses:
        own = lengths_of(rig.base, body, rig.centre_of_turns, pose.translation, pose.quaternion)
        assert np.abs(own - held).max() < 1e-8 * rig.size
    places = np.array([[float(c) for c in p.translation] + list(p.unit_quaternion) for p in curve.poses])
    assert np.ptp(places, axis=0).max() > 0.5  # they are not one point


@pytest.mark.parametrize("shift", [2, 4])
def test_other_ways_to_join_the_same_triangles_have_isolated_solutions(shift: int) -> None:
    found = gc.assembly_modes(ring(shift), "x=1/10, z=1/2, roll=10deg")
    assert not found.completeness.dependent
    assert not found.curves
    assert found.modes[0].given
    assert found.completeness.complete


def test_two_alike_bodies_slide_on_circles() -> None:
    """Platform and base alike, rolled: the legs tell two numbers of the shift only, though forms are independent."""
    found = gc.assembly_modes(ring(0), "x=1/10, z=1/2, roll=10deg")
    assert not found.completeness.dependent
    assert found.completeness.singular
    curve = next(c for c in found.curves if c.through_given)
    assert curve.closed
    assert all(abs(p.angle - np.radians(10)) < 1e-6 for p in curve.poses)
    shifts = np.array([[float(c) for c in p.translation] for p in curve.poses]) + np.array([0, 0, 3])
    assert np.ptp(np.linalg.norm(shifts, axis=1)) < 1e-6


def test_lengths_that_an_architecture_does_not_have() -> None:
    found = gc.assembly_modes(ring(1), actuators="3 3 3 3 3 7/2")
    assert (len(found), len(found.curves)) == (0, 0)
    assert found.completeness.complete
    assert found.completeness.at_infinity == 40
    assert found.verdict == "no real solutions"


def test_an_isolated_solution_is_no_curve() -> None:
    for name in ("octahedral", "octahedral-singular"):
        rig = mechanism(str(EXAMPLES / f"{name}.yaml")).six_legs().rig
        lengths = np.linalg.norm(rig.arms + rig.centre_of_turns - rig.base, axis=1) / rig.size
        forms, _ = forms_of_pairs((rig.base - rig.centre_of_turns) / rig.size, rig.arms / rig.size, lengths)
        assert rank_of(forms) == 6
        assert np.abs(values_of(forms, study(np.eye(4)))).max() < 1e-12
        assert curve_through(forms, study(np.eye(4))) is None


# --- robots of joints ----------------------------------------------------------------------------------------------


def test_planar_robots_by_a_sextic() -> None:
    found = gc.assembly_modes("3-rpr", actuators="q1=0.1, q2=-0.2, q3=0.3")
    home = {n: np.array([float(c) for c in v[:2]]) for n, v in gc.load("3-rpr").values_at().items()}
    base, body = (np.array([home[f"{letter}{n}"] for n in (1, 2, 3)]) for letter in "AB")
    lengths = np.linalg.norm(body - base, axis=1) + np.array([0.1, -0.2, 0.3])
    roots = planar_roots(base, body, lengths)
    assert len(roots) == found.completeness.real + found.completeness.unreal == 6
    real = sorted(float(np.angle(z)) for z in roots if abs(abs(z) - 1) < 1e-9)
    assert np.allclose(sorted(m.coordinates["yaw"] for m in found.modes), real, atol=1e-8)
    assert found.certified


def test_delta_by_three_spheres() -> None:
    found = gc.assembly_modes("delta", actuators="q1=0.1rad, q2=-0.15rad, q3=0.05rad")
    assert len(found) == 2
    assert found.completeness.complete
    assert all(m.certificate.unique for m in found.modes)
    home = {n: np.array([float(c) for c in v]) for n, v in gc.load("delta").values_at().items()}
    points = found.modes[0].report.points
    bars = [home[f"d{n}"] for n in (1, 2, 3)]
    ends = np.array([home[f"A{n}"] for n in (1, 2, 3)]) + bars
    elbows = np.array([points[f"A{n}"] for n in (1, 2, 3)])
    two = sphere_points(elbows - ends, np.linalg.norm(bars, axis=1))
    shifts = [[m.coordinates[n] for n in "xyz"] for m in found.modes]
    assert np.allclose(sorted(map(tuple, two)), sorted(map(tuple, shifts)), atol=1e-8)


def test_3_rps_by_three_circles() -> None:
    found = gc.assembly_modes("3-rps", actuators="q1=0.1, q2=0.05, q3=-0.1")
    counts = found.completeness
    assert (counts.real + counts.unreal, counts.at_infinity) == (16, 24)
    robot = gc.load("3-rps")
    home = {n: np.array([float(c) for c in v]) for n, v in robot.values_at().items()}
    circles = []
    for n, more in zip((1, 2, 3), (0.1, 0.05, -0.1), strict=True):
        a, s, r = (home[f"{letter}{n}"] for letter in "ASr")
        circles.append(circle_points(a, a + r, a + (s - a) * (1 + more / np.linalg.norm(s - a))))
    sides = [float(np.linalg.norm(home[p] - home[q])) for p, q in (("S1", "S2"), ("S2", "S3"), ("S3", "S1"))]
    other = np.array(three_on_circles(circles, sides))
    places = np.array([[m.report.points[f"S{n}"] for n in (1, 2, 3)] for m in found.modes])
    assert len(other) == len(places)
    for place in places:
        assert np.abs(other - place).max(axis=(1, 2)).min() < 1e-6
    assert found.certified


@pytest.mark.parametrize(
    ("robot", "finite"), [("3-ups-s", 8), ("3-rrr-spherical", 8), ("tricept", 24), ("5r", 2), ("8-cables", 1)]
)
def test_counts_that_are_known(robot: str, finite: int) -> None:
    found = gc.assembly_modes(robot)
    assert found.completeness.real + found.completeness.unreal == finite
    assert found.completeness.complete
    assert found.modes[0].given
    assert all(m.certificate.unique for m in found.modes)


def test_modes_are_configurations_of_the_robot() -> None:
    """The robot itself, closed and measured there, with the actuators held."""
    found = gc.assembly_modes("3-prs", actuators="q1=0.2, q2=0, q3=-0.1")
    assert found.modes
    for m in found.modes:
        assert np.allclose([v for _, v in m.actuators], [0.2, 0, -0.1], atol=1e-9)
        assert m.report.residual < 1e-8
        assert m.margin == m.report.margin
        assert m.factors
        assert m.report.assembly.same is None  # whether a way leads there is another question


def test_double_solutions_of_a_robot_of_joints_are_singular() -> None:
    found = gc.assembly_modes("octahedral")
    assert len(found) == 14
    assert [m.verdict for m in found.modes if m.multiplicity == 2] == ["singular", "singular"]


def test_where_no_count_is_known_that_is_said() -> None:
    found = gc.assembly_modes("3-upu")
    assert found.completeness.complete is None
    assert found.completeness.text.startswith("not known: a search from")
    assert [round(m.coordinates["z"], 6) for m in found.modes] == [0, -8]
    assert any("led out of the robot's family" in note for note in found.notes)


# --- the command ---------------------------------------------------------------------------------------------------


def run(*arguments: str) -> Any:
    return CliRunner().invoke(cli, ["modes", *arguments])


def test_the_command_shows_and_draws(tmp_path: Path) -> None:
    drawn = tmp_path / "modes.svg"
    done = run(OCTAHEDRAL, "--picture", str(drawn))
    assert done.exit_code == 0, done.stderr
    assert done.stdout.startswith("8 real solutions; 8 regular, ")
    assert drawn.read_text().startswith("<svg")
    said = json.loads(run(OCTAHEDRAL, "--json").stdout)
    assert said["completeness"]["complete"] is True
    assert len(said["modes"]) == 8
    assert said["modes"][0]["given"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((OCTAHEDRAL, "--actuators", "1 2 3"), "3 lengths, and the platform has six legs"),
        ((OCTAHEDRAL, "--actuators", "ax=3"), "ax"),
        ((OCTAHEDRAL, "--actuators", "ab=-3"), "is not positive"),
        ((OCTAHEDRAL, "--actuators", "1e9 1e9 1e9 1e9 1e9 1e9"), "more than 1,000 times as long"),
        ((OCTAHEDRAL, "--at", "z=2e6"), "more than 1,000 times as long"),
        ((OCTAHEDRAL, "--actuators", "1 2 3 4 5 long"), "'long' is not a length"),
        ((OCTAHEDRAL, "--at", "z=1", "--actuators", "ab=3"), "a pose and actuators at once"),
        (("3-rps", "--actuators", "q7=1"), "q7"),
        (("ab af cb cd ed ef",), "legs alone have no coordinates"),
        (("3-rps", "--threshold", "2mm"), "2mm"),
    ],
)
def test_bad_input(arguments: tuple[str, ...], said: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2
    assert said in done.stderr


def test_the_centre_of_poses_changes_no_mode() -> None:
    """Poses about another centre are the same places of the platform."""
    places = []
    for about in ("centroid", "origin", (500, -200, 1000)):
        found = gc.assembly_modes(OCTAHEDRAL, about=about)
        check_lengths(found)
        rig = found.mechanism.six_legs().rig
        places.append(sorted(tuple(round(float(c), 5) for c in rig.exact(m.pose)["b"]) for m in found.modes))
    assert np.allclose(places[0], places[1], atol=1e-4)
    assert np.allclose(places[0], places[2], atol=1e-4)


# --- solutions that are near to each other ---------------------------------------------------------------------------

NEAR = {
    "regular": (1.5, 4, 7),
    "singular": (2.0, 4, 4),
}


def nearly_similar(ratio: float, digits: int, digits_of_platform: int) -> dict[str, Any]:
    """Two hexagons, similar but for rounding, one above the other."""
    angles = np.radians([10, 50, 130, 170, 250, 290])
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    base, body = np.round(ratio * ring, digits), np.round(ring, digits_of_platform)
    points = {f"A{k}": [*map(str, p), "0"] for k, p in enumerate(base.tolist())}
    points |= {f"B{k}": [*map(str, p), "2"] for k, p in enumerate(body.tolist())}
    return {"legs": [f"A{k}B{k}" for k in range(6)], "points": points}


@pytest.mark.parametrize("name", NEAR)
def test_only_the_given_pose_is_the_given_pose(name: str) -> None:
    """Solutions near home have poses, margins and signs of their own; each pose satisfies the lengths."""
    data = nearly_similar(*NEAR[name])
    found = gc.assembly_modes(data)
    assert sum(mode.given for mode in found.modes) <= 1
    poses = [(tuple(map(float, mode.pose.translation)), mode.pose.unit_quaternion) for mode in found.modes]
    assert len(set(poses)) == len(poses)
    for mode in found.modes:
        again = gc.pose(data, mode.pose, nearest=False)
        assert again.margin == pytest.approx(mode.margin, abs=1e-9)
        if mode.verdict == "singular":
            assert "0" in mode.signs
